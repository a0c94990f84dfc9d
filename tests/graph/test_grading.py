"""Graded cells: the lengths asked for, a smooth map, and nothing lost by being unequal."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.assembly import assemble, choose_grid, choose_theory, energy_scale
from softcat_sym.discretization.graph import Graph, parameter_values
from softcat_sym.discretization.grid import (
    HINGE_CELL,
    LEAST,
    MOST,
    SMOOTH_KIRCHHOFF,
    End,
    Grid,
    choose_grading,
    half_span,
    whole_span,
)
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

from .filaments import build, energy_of, parameters, random_state, scene_of, value

REISSNER = ("shear", "fibres", "rotary-inertia")
"""With rotary inertia every unknown has a rate, so that the balance holds at any state."""

GRIDS = {
    "half": half_span(6, End.CLAMPED, 10.0),
    "half pinned": half_span(6, End.PINNED, 10.0),
    "whole": whole_span(4, End.CLAMPED, End.PINNED, 10.0),
}


def test_longest_over_shortest_is_the_grading() -> None:
    for grading in [0.5, 1.0, 3.0, 30.0]:
        for cells in [2, 7, 40]:
            lengths = half_span(cells, End.CLAMPED, grading).cell_length
            assert lengths[0] / lengths[-1] == pytest.approx(grading, rel=1e-12)
            assert lengths.sum() == pytest.approx(0.5, rel=1e-15)
            assert lengths[1:] / lengths[:-1] == pytest.approx(grading ** (-1 / (cells - 1)), rel=1e-11)


def test_equal_cells_are_the_default() -> None:
    assert np.array_equal(half_span(8, End.CLAMPED).nodes, np.linspace(0.0, 0.5, 9))
    np.testing.assert_allclose(whole_span(8, End.CLAMPED, End.PINNED).nodes, np.linspace(-0.5, 0.5, 17), atol=1e-16)


def test_a_whole_span_is_the_half_and_its_mirror_image() -> None:
    half = half_span(9, End.CLAMPED, 10.0)
    whole = whole_span(9, End.CLAMPED, End.PINNED, 10.0)
    assert (whole.cells, whole.nodes[0], whole.nodes[9], whole.nodes[-1]) == (18, -0.5, 0.0, 0.5)
    assert np.array_equal(whole.nodes[9:], half.nodes)
    assert np.array_equal(whole.nodes, -whole.nodes[::-1])


def test_cells_lie_on_a_smooth_map() -> None:
    """Neighbours grow alike as cells are added, first order in 1/N, which is what second order of the theory needs."""
    jumps = [np.max(np.abs(np.diff(np.log(half_span(n, End.CLAMPED, 10.0).cell_length)))) for n in (40, 80, 160)]
    assert np.divide(jumps[:-1], jumps[1:]) == pytest.approx(2, rel=0.03)


def test_cells_are_short_under_a_weight_too() -> None:
    lengths = half_span(40, End.CLAMPED, 10.0, middle=True).cell_length
    np.testing.assert_allclose(lengths, lengths[::-1], rtol=1e-12)
    assert lengths.max() / lengths.min() == pytest.approx(10.0, rel=0.02)
    assert np.argmax(lengths) in (19, 20)
    jumps = [
        np.max(np.abs(np.diff(np.log(half_span(n, End.CLAMPED, 10.0, middle=True).cell_length)))) for n in (40, 80, 160)
    ]
    assert np.divide(jumps[:-1], jumps[1:]) == pytest.approx(2, rel=0.03)


@pytest.mark.parametrize(("mass", "short"), [("2 g", False), ("10 g", True)])
def test_a_weight_of_more_than_half_the_filament_makes_a_hinge(mass: str, short: bool) -> None:
    """The paper's strand weighs 13.7 g; an elastic one has no hinge under any weight."""
    scene = load_scene("arrested-overdamped", {"load.point_mass": mass})
    lengths = choose_grid(scene).cell_length
    assert (lengths[0] < 0.5 * lengths.max()) == short
    elastic = load_scene("no-yield", {"load.point_mass": mass})
    assert choose_grid(elastic).cell_length[0] == pytest.approx(choose_grid(elastic).cell_length.max())


def test_what_is_no_grid_is_refused() -> None:
    for cells, grading, word in [
        (0, 1.0, "cells"),
        (8, 0.0, "grading"),
        (8, -1.0, "grading"),
        (8, np.inf, "grading"),
        (8, np.nan, "grading"),
    ]:
        with pytest.raises(SoftcatError, match=word):
            half_span(cells, End.CLAMPED, grading)
        with pytest.raises(SoftcatError, match=word):
            whole_span(cells, End.CLAMPED, End.CLAMPED, grading)


def imbalance(graph: Graph, scene: Scene) -> float:
    """Largest |d(energy)/dt + dissipation + power of the gradient - power of the load| over what was added up.

    At random states so close to the straight filament that no cell, however short, is turned inside out.
    """
    energy = energy_of(graph, ("energy_kinetic", "energy_elastic", "energy_potential"))
    values = parameter_values(scene)
    unit = values["span"] * energy_scale(values["density"], values["span"], values["time_scale"])
    rates = [ca.gradient(energy, graph.x) * graph.ode, ca.jacobian(energy, graph.t), graph.quad * unit]
    function = ca.Function("power", [graph.t, graph.x, graph.p], rates)
    worst = 0.0
    for seed in range(3):
        x, _ = random_state(graph, seed, size=0.002)
        parts, pushed, (lost, gained, steepened) = value(function, 0.06, x, parameters(scene, graph))
        residual = float(np.sum(parts) + np.sum(pushed) + lost + steepened - gained)
        worst = max(worst, abs(residual) / float(np.sum(np.abs(parts)) + abs(lost)))
    return worst


@pytest.mark.parametrize("grid", GRIDS.values(), ids=list(GRIDS))
def test_published_filament_keeps_its_energy(grid: Grid) -> None:
    scene = scene_of()
    assert imbalance(build(scene, grid), scene) <= 1e-12


def test_shearing_filament_keeps_its_energy() -> None:
    for neck in [(), ("necking-gradient",)]:
        for grid in GRIDS.values():
            names = [*choose_effects(scene_of()).names, *REISSNER, *neck]
            scene = scene_of().replace({"run.effects": names})
            effects = choose_effects(scene)
            equations = derive(effects.terms(), SECTIONS[scene.filament.section], scene.run.closure)
            graph = assemble(equations, grid, effects.names, choose_theory(scene, equations))
            assert imbalance(graph, scene) <= 1e-12


def test_hinge_of_a_shearing_filament_sets_the_shortest_cell() -> None:
    """Whatever the number of cells, until they are few enough for the longest to matter."""
    scene = load_scene("arrested-overdamped")
    delta = 0.03
    for cells in (40, 60, 80):
        shortest = half_span(cells, End.CLAMPED, choose_grading(scene, cells)).cell_length[-1]
        assert shortest / delta == pytest.approx(HINGE_CELL, rel=0.05)
    assert choose_grading(scene, 10) == pytest.approx(MOST)
    assert choose_grading(scene, 1000) == pytest.approx(LEAST)


def test_grading_follows_ends_and_physics() -> None:
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
        assert choose_grading(load_scene(name).replace(changes), 40) == expected
