"""The closed-form means of the Bingham rule, (2.26) and (2.27), against quadrature and the paper's own letters."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from softcat_sym.physics.laws import bingham_means, bingham_rate, maxwell_means, maxwell_rate
from softcat_sym.physics.sections import RECTANGLE, SECTIONS
from softcat_sym.physics.symbols import E, eta, sigma, sigma_0, sigma_1, sigma_Y, zeta

from .means import MODULUS, VISCOSITY, YIELD, Means, closed_form, flow_rule, paper, quadrature, sign_cases

CASES = sign_cases()
SHAPES = sorted(SECTIONS)
few = settings(max_examples=40, deadline=None)
stresses = st.floats(-6 * YIELD, 6 * YIELD)


def agree(one: Means, two: Means, mean: float, slope: float, rel: float = 2e-14) -> None:
    scale = (abs(mean) + abs(slope)) / VISCOSITY
    assert one.rate == pytest.approx(two.rate, abs=rel * scale, rel=0)
    assert one.moment == pytest.approx(two.moment, abs=rel * scale, rel=0)
    assert one.yielded == pytest.approx(two.yielded, abs=1e-6)


def test_every_sign_case_against_quadrature() -> None:
    for section in SHAPES:
        for case in CASES:
            mean, slope = (YIELD * value for value in CASES[case])
            found, wanted = closed_form(section, mean, slope), quadrature(section, mean, slope)
            agree(found, wanted, mean, slope)
            assert found.largest == pytest.approx(wanted.largest, rel=1e-12, abs=1e-12 * YIELD / VISCOSITY)


@pytest.mark.parametrize("section", SHAPES)
def test_many_random_stresses_against_quadrature(section: str) -> None:
    for mean, slope in np.random.default_rng(7).normal(0, 2 * YIELD, (300, 2)):
        agree(closed_form(section, mean, slope), quadrature(section, mean, slope), mean, slope)


def test_the_paper_letter_by_letter() -> None:
    """Through the thickness of a section that has shrunk, whose size must not matter to the means."""
    for case in CASES:
        mean, slope = (YIELD * value for value in CASES[case])
        wanted = paper(mean, slope, thickness=0.0055, width=0.004)
        found = closed_form("rectangle", mean, slope)
        scale = (abs(mean) + abs(slope)) / VISCOSITY
        # The paper subtracts cubes of z_H and z_L: where the section is nearly uniform that costs it digits.
        assert found.rate == pytest.approx(wanted.rate, abs=1e-12 * scale, rel=0)
        assert found.moment == pytest.approx(wanted.moment, abs=1e-12 * scale, rel=0)


def test_the_paper_at_random_stresses() -> None:
    for mean, slope in np.random.default_rng(8).normal(0, 2 * YIELD, (300, 2)):
        wanted = paper(mean, slope, thickness=0.006, width=0.01)
        agree(closed_form("rectangle", mean, slope), wanted, mean, slope, 1e-13)


@pytest.mark.parametrize("section", SHAPES)
@few
@given(mean=stresses, slope=stresses)
def test_odd_in_the_stress(section: str, mean: float, slope: float) -> None:
    one, two = closed_form(section, mean, slope), closed_form(section, -mean, -slope)
    scale = 1e-14 * (abs(mean) + abs(slope)) / VISCOSITY
    assert one.rate == pytest.approx(-two.rate, abs=scale, rel=0)
    assert one.moment == pytest.approx(-two.moment, abs=scale, rel=0)
    assert one.yielded == pytest.approx(two.yielded, abs=1e-6)
    assert one.largest == two.largest


@pytest.mark.parametrize("section", SHAPES)
@few
@given(mean=stresses, slope=stresses)
def test_a_section_upside_down_bends_the_other_way(section: str, mean: float, slope: float) -> None:
    one, two = closed_form(section, mean, slope), closed_form(section, mean, -slope)
    scale = 1e-14 * (abs(mean) + abs(slope)) / VISCOSITY
    assert one.rate == pytest.approx(two.rate, abs=scale, rel=0)
    assert one.moment == pytest.approx(-two.moment, abs=scale, rel=0)


@pytest.mark.parametrize("section", SHAPES)
@few
@given(mean=stresses, slope=stresses)
def test_flow_never_gives_work_back(section: str, mean: float, slope: float) -> None:
    found = closed_form(section, mean, slope)
    rounding = 1e-16 * (abs(mean) + abs(slope)) ** 2 / VISCOSITY
    assert mean * found.rate >= -rounding
    assert slope * found.moment >= -rounding


@pytest.mark.parametrize("section", SHAPES)
@few
@given(share=st.floats(-1, 1), size=st.floats(0, 0.999))
def test_below_yield_nothing_flows_at_all(section: str, share: float, size: float) -> None:
    """Exactly nothing: `no-yield` is the run in which no fibre ever does."""
    mean = size * share * YIELD
    slope = size * (1 - abs(share)) * YIELD
    assert closed_form(section, mean, slope) == Means(0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize("section", SHAPES)
@few
@given(mean=stresses, slope=stresses, step=st.floats(0, YIELD))
def test_monotone_in_either_stress(section: str, mean: float, slope: float, step: float) -> None:
    found = closed_form(section, mean, slope)
    rounding = 1e-14 * (abs(mean) + abs(slope) + step) / VISCOSITY
    assert closed_form(section, mean + step, slope).rate >= found.rate - rounding
    assert closed_form(section, mean, slope + step).moment >= found.moment - rounding


@pytest.mark.parametrize("section", SHAPES)
@few
@given(mean=stresses, slope=stresses, ahead=st.floats(-1, 1), aside=st.floats(-1, 1))
def test_continuous_with_the_slope_of_the_flow_rule(
    section: str, mean: float, slope: float, ahead: float, aside: float
) -> None:
    """Neither mean can change faster than the stress over eta, also across the yield point and through zero moment."""
    step = 1e-6 * YIELD
    one, two = closed_form(section, mean, slope), closed_form(section, mean + ahead * step, slope + aside * step)
    bound = (abs(ahead) + abs(aside)) * step / VISCOSITY + 1e-14 * (abs(mean) + abs(slope)) / VISCOSITY
    assert abs(one.rate - two.rate) <= bound
    assert abs(one.moment - two.moment) <= bound


@pytest.mark.parametrize("section", SHAPES)
@few
@given(mean=stresses, slope=stresses)
def test_without_a_threshold_it_is_maxwell(section: str, mean: float, slope: float) -> None:
    found = closed_form(section, mean, slope, threshold=1e-12 * YIELD)
    rounding = (1e-14 * (abs(mean) + abs(slope)) + 2e-12 * YIELD) / VISCOSITY
    assert abs(found.rate - mean / VISCOSITY) <= rounding
    assert abs(found.moment - slope / VISCOSITY * float(SECTIONS[section].zeta_squared)) <= rounding


@pytest.mark.parametrize("section", SHAPES)
def test_the_derivative_at_zero_moment_is_the_one_from_either_side(section: str) -> None:
    """A uniform section that flows resists bending like the fluid it is: d<phi zeta>/d sigma_1 = <zeta^2>/eta."""
    step = 1e-4 * YIELD
    for slope in (step, -step):
        found = closed_form(section, 3 * YIELD, slope).moment / slope
        assert found * VISCOSITY == pytest.approx(float(SECTIONS[section].zeta_squared), rel=1e-9)
    moment = bingham_means(SECTIONS[section]).bending_rate
    at = {sigma_0: 3 * YIELD, sigma_1: 0, sigma_Y: YIELD, eta: VISCOSITY, E: MODULUS}
    assert float(moment.subs(at)) == 0


def test_the_flow_rules_themselves() -> None:
    rule = sp.lambdify((sigma, sigma_Y, eta), bingham_rate(), modules="math")
    for stress in (-3.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 3.0):
        assert rule(stress * YIELD, YIELD, VISCOSITY) == flow_rule(np.array(stress * YIELD))
    assert maxwell_rate() == sigma / eta


@pytest.mark.parametrize("section", SHAPES)
def test_means_of_a_maxwell_fluid_are_integrals_of_its_rule(section: str) -> None:
    means = maxwell_means(SECTIONS[section])
    # With <1> = 1 and <zeta> = 0 the mean of a line is its height, its first moment over <zeta^2> its slope.
    bending, mean = sp.Poly(maxwell_rate().subs(sigma, sigma_0 + sigma_1 * zeta), zeta).all_coeffs()
    assert sp.simplify(means.rate - mean) == 0
    assert sp.simplify(means.bending_rate - bending) == 0
    assert means.yielded_fraction == 1


def test_a_uniform_section_at_yield_does_not_divide_by_zero() -> None:
    for mean in (YIELD, -YIELD, 0.0):
        found = closed_form("rectangle", mean, 0.0)
        assert (found.rate, found.moment, found.largest) == (0.0, 0.0, 0.0)


def test_no_mean_depends_on_the_modulus() -> None:
    """E stands in the closed form only to keep a quotient finite."""
    means = bingham_means(RECTANGLE)
    for mean, slope in ((0.0, 0.0), (2.0, 0.0), (2.0, 1e-12), (0.5, 3.0)):
        at = {sigma_0: mean * YIELD, sigma_1: slope * YIELD, sigma_Y: YIELD, eta: VISCOSITY}
        one, two = (float(means.rate.subs({**at, E: modulus})) for modulus in (1e3, 1e12))
        assert one == two
