"""Grids, their unknowns, and sections sampled through their thickness."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.grid import (
    HINGE_CELL,
    LEAST,
    MOST,
    SMOOTH_KIRCHHOFF,
    choose_grading,
    half_span,
    whole_span,
)
from softcat_sym.discretization.section_rule import SectionRule, fibre_rule, order_rule
from softcat_sym.discretization.symbolic import gathered
from softcat_sym.discretization.unknowns import Block, Layout
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.ends import CLAMPED
from softcat_sym.scene.reading import load_scene
from tests.common.assembled import place

SHAPES = ("rectangle", "circle")


def test_cells_lie_on_a_smooth_map() -> None:
    """Neighbours grow alike as cells are added, first order in 1/N, which is what second order of the theory needs."""
    for middle in (False, True):
        grids = [half_span(n, CLAMPED, 10.0, middle=middle) for n in (40, 80, 160)]
        jumps = [np.max(np.abs(np.diff(np.log(grid.cell_length)))) for grid in grids]
        assert np.divide(jumps[:-1], jumps[1:]) == pytest.approx(2, rel=0.03)
    lengths = half_span(40, CLAMPED, 10.0, middle=True).cell_length
    np.testing.assert_allclose(lengths, lengths[::-1], rtol=1e-12)
    assert lengths.max() / lengths.min() == pytest.approx(10.0, rel=0.02)
    assert np.argmax(lengths) in (19, 20)


def test_what_is_no_grid_is_refused() -> None:
    for cells, grading, word in [(0, 1.0, "cells"), *((8, g, "grading") for g in (0.0, -1.0, np.inf, np.nan))]:
        with pytest.raises(SoftcatError, match=word):
            half_span(cells, CLAMPED, grading)
        with pytest.raises(SoftcatError, match=word):
            whole_span(cells, CLAMPED, CLAMPED, grading)


def test_grading_follows_ends_and_physics() -> None:
    scene = load_scene("arrested-overdamped")
    for cells in (40, 60, 80):  # the hinge sets the shortest cell, whatever the number of cells
        shortest = half_span(cells, CLAMPED, choose_grading(scene, cells)).cell_length[-1]
        assert shortest / 0.03 == pytest.approx(HINGE_CELL, rel=0.05)
    assert choose_grading(scene, 10) == pytest.approx(MOST)
    assert choose_grading(scene, 1000) == pytest.approx(LEAST)
    for name, changes, expected in [
        ("no-yield", {}, LEAST),
        ("no-yield", {"run.effects": "paper"}, SMOOTH_KIRCHHOFF),
        ("continual-descent", {"run.effects": "paper"}, MOST),
        ("silicone-thread", {}, LEAST),
        ("maxwell-slow", {"model": "small-deflection"}, LEAST),
        ("glass-rod", {}, 1.0),
        ("no-yield", {"ends.left": "pinned"}, LEAST),
        ("no-yield", {"ends.left": "pinned", "ends.right": "pinned"}, 1.0),
        ("no-yield", {"run.effects": ["inertia", "finite-stretch", "thinning", "large-rotation"]}, 1.0),
    ]:
        assert choose_grading(load_scene(name).replace(changes), 40) == expected, (name, changes)


def test_unknowns_are_sorted_along_the_filament_and_gathering_undoes_laying_out() -> None:
    grid = half_span(5, CLAMPED)
    heights = np.linspace(1.0, 2.0, 6)
    free = [0, 2, 3]
    nodes = Block("y", tuple(free), grid.nodes[free], heights[free])
    layout = Layout([nodes, Block("a", tuple(range(5)), grid.centres, np.zeros(5))])
    positions = [float(name.rsplit("= ", 1)[1]) for name in layout.names]
    assert positions == sorted(positions)
    assert len(layout.names) == len(layout) == len(layout.start) == 8
    for name, start in zip(layout.names, layout.start, strict=True):
        kind, number = place(name)
        assert start == (1.0 + 0.2 * number if kind == "y" else 0.0)
    vector = ca.SX.sym("q", len(layout))
    back = ca.Function("back", [vector], [gathered(layout, layout.split(vector))])
    state = np.arange(8.0) ** 2
    np.testing.assert_array_equal(np.asarray(back(state)).ravel(), state)
    assert layout.split(layout.start)["y"].tolist() == heights[free].tolist()
    empty = Layout([])
    assert (empty.names, len(empty), gathered(empty, {}).numel()) == ((), 0, 0)


def moments(section: str, degree: int) -> list[float]:
    """<zeta^n>: 1/(n + 1) for even n; of the semicircle Catalan's numbers over 4^(n/2)."""
    even = {"rectangle": lambda m: 1 / (2 * m + 1), "circle": lambda m: math.comb(2 * m, m) / (m + 1) / 4**m}[section]
    return [even(n // 2) if n % 2 == 0 else 0.0 for n in range(degree + 1)]


def rules(section: str) -> list[SectionRule]:
    orders = [order_rule(section, k, points) for k, points in ((0, 1), (1, 2), (1, 24), (3, 9), (8, 9), (8, 64))]
    return [*(fibre_rule(section, m) for m in (1, 2, 3, 6, 24)), *orders]


def test_section_rules_are_quadratures_of_the_section() -> None:
    for section, second in (("rectangle", 1 / 3), ("circle", 1 / 4)):
        for rule in rules(section):
            assert np.all(rule.weight > 0) and np.all(np.diff(rule.zeta) > 0) and np.all(np.abs(rule.zeta) < 1)
            assert rule.weight.sum() == pytest.approx(1.0, abs=1e-14)
            np.testing.assert_allclose(rule.zeta, -rule.zeta[::-1], atol=1e-15)
            assert rule.points == 1 or rule.weight @ rule.zeta**2 == pytest.approx(second, abs=1e-14)
            assert (rule.recall.shape, rule.project.shape) == ((rule.points, rule.states), (rule.states, rule.points))
            np.testing.assert_allclose(rule.project @ rule.recall, np.eye(rule.states), atol=1e-12)


def test_moments_are_exact_up_to_twice_the_points() -> None:
    for section in SHAPES:
        for points in [2, 3, 6, 12]:
            rule, exact = fibre_rule(section, points), moments(section, 2 * points)
            for n in range(2 * points):
                assert rule.weight @ rule.zeta**n == pytest.approx(exact[n], abs=1e-14), n
            # and no further: a rule of this many points cannot
            assert abs(rule.weight @ rule.zeta ** (2 * points) - exact[2 * points]) > 1e-9


def test_rules_in_the_halves_have_the_plastic_moment() -> None:
    """<|zeta|>, of a section that yields from its faces to its middle; one rule through all of it has 0.75/n^2 more."""
    for section, exact in (("rectangle", 1 / 2), ("circle", 4 / (3 * math.pi))):
        for points in [6, 8, 16, 64]:
            rule, whole = (fibre_rule(section, points, halves=halves) for halves in (True, False))
            assert rule.weight @ np.abs(rule.zeta) == pytest.approx(exact, rel=1e-13)
            assert whole.weight @ np.abs(whole.zeta) / exact - 1 == pytest.approx(0.75 / points**2, rel=0.6)
            for n, moment in enumerate(moments(section, points - 1)):
                assert rule.weight @ rule.zeta**n == pytest.approx(moment, abs=1e-14), n


def test_projection_is_the_best_polynomial() -> None:
    """Against a weighted least-squares fit of monomials, which knows no orthogonal polynomial."""
    for section in SHAPES:
        for order, points in [(1, 2), (3, 4), (3, 24), (8, 9), (8, 24)]:
            rule = order_rule(section, order, points)
            profile = np.exp(rule.zeta) + np.maximum(rule.zeta - 0.3, 0)
            root, powers = np.sqrt(rule.weight), rule.zeta[:, None] ** np.arange(order + 1)
            fit, *_ = np.linalg.lstsq(root[:, None] * powers, root * profile, rcond=None)
            np.testing.assert_allclose(rule.recall @ (rule.project @ profile), powers @ fit, atol=1e-10)
            assert rule.states == order + 1
        for order in [1, 3, 8]:  # as many points as amplitudes are fibres: the amplitudes only rename their strains
            rule, fibres = order_rule(section, order, order + 1), fibre_rule(section, order + 1)
            np.testing.assert_array_equal([rule.zeta, rule.weight], [fibres.zeta, fibres.weight])
            np.testing.assert_allclose(rule.recall @ rule.project, np.eye(order + 1), atol=1e-12)
    assert order_rule("rectangle", 8, 2).points == 9, "fewer could not tell the amplitudes apart"
    legendre, chebyshev = (order_rule(section, 2, 5) for section in SHAPES)
    np.testing.assert_allclose(legendre.recall[:, 2], (3 * legendre.zeta**2 - 1) / 2, atol=1e-14)
    np.testing.assert_allclose(chebyshev.recall[:, 2], (4 * chebyshev.zeta**2 - 1) / 3, atol=1e-14)
