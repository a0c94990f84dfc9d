"""A section sampled through its thickness: quadrature is exact, and states and points say the same thing."""

from __future__ import annotations

import math

import numpy as np
import pytest

from softcat_sym.discretization.section_rule import SectionRule, fibre_rule, order_rule
from softcat_sym.physics.sections import SECTIONS

SHAPES = ("rectangle", "circle")
SIZES = (1, 2, 3, 6, 24)


def moments(section: str, degree: int) -> list[float]:
    """<zeta^n>: 1/(n + 1) for even n; of the semicircle Catalan's numbers over 4^(n/2)."""
    halves = [n // 2 for n in range(degree + 1)]
    even = {
        "rectangle": [1 / (2 * m + 1) for m in halves],
        "circle": [math.comb(2 * m, m) / (m + 1) / 4**m for m in halves],
    }
    return [value if n % 2 == 0 else 0.0 for n, value in enumerate(even[section])]


def rules(section: str) -> list[SectionRule]:
    shape = SECTIONS[section]
    orders = [order_rule(shape, k, points) for k, points in ((0, 1), (1, 2), (1, 24), (3, 9), (8, 9), (8, 64))]
    return [*(fibre_rule(shape, m) for m in SIZES), *orders]


@pytest.mark.parametrize("section", SHAPES)
def test_weights_are_shares_of_the_section(section: str) -> None:
    for rule in rules(section):
        assert np.all(rule.weight > 0)
        assert rule.weight.sum() == pytest.approx(1.0, abs=1e-14)
        assert np.all(np.diff(rule.zeta) > 0)
        assert np.all(np.abs(rule.zeta) < 1)
        np.testing.assert_allclose(rule.zeta, -rule.zeta[::-1], atol=1e-15)


def test_moments_are_exact_up_to_twice_the_points() -> None:
    for section in SHAPES:
        for points in [2, 3, 6, 12]:
            rule = fibre_rule(SECTIONS[section], points)
            exact = moments(section, 2 * points)
            for n in range(2 * points):
                assert rule.weight @ rule.zeta**n == pytest.approx(exact[n], abs=1e-14), n
            # and no further: a rule of this many points cannot
            assert abs(rule.weight @ rule.zeta ** (2 * points) - exact[2 * points]) > 1e-9


def test_rules_in_the_halves_have_the_plastic_moment() -> None:
    """<|zeta|>, of a section that yields from its faces to its middle; one rule through all of it has 0.75/n^2 more."""
    for section in SHAPES:
        for points in [6, 8, 16, 64]:
            exact = {"rectangle": 1 / 2, "circle": 4 / (3 * math.pi)}[section]
            rule, whole = (fibre_rule(SECTIONS[section], points, halves=halves) for halves in (True, False))
            assert rule.weight @ np.abs(rule.zeta) == pytest.approx(exact, rel=1e-13)
            assert whole.weight @ np.abs(whole.zeta) / exact - 1 == pytest.approx(0.75 / points**2, rel=0.6)
            for n, moment in enumerate(moments(section, points - 1)):
                assert rule.weight @ rule.zeta**n == pytest.approx(moment, abs=1e-14), n


@pytest.mark.parametrize("section", SHAPES)
def test_second_moment_of_area_is_that_of_the_section(section: str) -> None:
    exact = {"rectangle": 1 / 3, "circle": 1 / 4}[section]
    for rule in rules(section):
        if rule.points > 1:
            assert rule.weight @ rule.zeta**2 == pytest.approx(exact, abs=1e-14)


@pytest.mark.parametrize("section", SHAPES)
def test_states_and_points_say_the_same(section: str) -> None:
    for rule in rules(section):
        assert rule.recall.shape == (rule.points, rule.states)
        assert rule.project.shape == (rule.states, rule.points)
        np.testing.assert_allclose(rule.project @ rule.recall, np.eye(rule.states), atol=1e-12)


def test_projection_is_the_best_polynomial() -> None:
    """Against a weighted least-squares fit of monomials, which knows no orthogonal polynomial."""
    for section in SHAPES:
        for order, points in [(1, 2), (3, 4), (3, 24), (8, 9), (8, 24)]:
            rule = order_rule(SECTIONS[section], order, points)
            profile = np.exp(rule.zeta) + np.maximum(rule.zeta - 0.3, 0)
            root = np.sqrt(rule.weight)
            powers = rule.zeta[:, None] ** np.arange(order + 1)
            fit, *_ = np.linalg.lstsq(root[:, None] * powers, root * profile, rcond=None)
            np.testing.assert_allclose(rule.recall @ (rule.project @ profile), powers @ fit, atol=1e-10)
            assert rule.states == order + 1


def test_as_many_points_as_amplitudes_are_fibres() -> None:
    """Then recall after project changes nothing: the amplitudes only rename the strains of the fibres."""
    for section in SHAPES:
        for order in [1, 3, 8]:
            rule, fibres = order_rule(SECTIONS[section], order, order + 1), fibre_rule(SECTIONS[section], order + 1)
            np.testing.assert_array_equal(rule.zeta, fibres.zeta)
            np.testing.assert_array_equal(rule.weight, fibres.weight)
            np.testing.assert_allclose(rule.recall @ rule.project, np.eye(order + 1), atol=1e-12)


def test_too_few_points_for_an_order_are_not_used() -> None:
    """Projection by fewer points than amplitudes would not tell the amplitudes apart."""
    assert order_rule(SECTIONS["rectangle"], 8, 2).points == 9


def test_polynomials_are_those_of_the_section() -> None:
    legendre = order_rule(SECTIONS["rectangle"], 2, 5)
    np.testing.assert_allclose(legendre.recall[:, 2], (3 * legendre.zeta**2 - 1) / 2, atol=1e-14)
    chebyshev = order_rule(SECTIONS["circle"], 2, 5)
    np.testing.assert_allclose(chebyshev.recall[:, 2], (4 * chebyshev.zeta**2 - 1) / 3, atol=1e-14)
