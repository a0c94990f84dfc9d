"""Second order in 1/N survives unequal cells, and cells gathered at the clamp buy accuracy."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.discretization.assembly import assemble, choose_theory
from softcat_sym.discretization.grid import End, Grid, choose_grading, half_span
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.run import prepare
from softcat_sym.solvers.settings import choose_settings
from softcat_sym.solvers.solution import Silence

from .scenes import GEOMETRY, extrapolated, paper_scene, scene

GRADING = 10.0


def _elastic(*effects: str, ramp: float = 0.0) -> Scene:
    return scene(thickness=0.03, E=3e6, ramp=ramp, duration=0.4, rtol=1e-5, effects=(*GEOMETRY, *effects))


def _creeping(*effects: str) -> Scene:
    names = (*GEOMETRY, "viscous-flow", *effects)
    return scene(thickness=0.03, E=1e7, eta=1e5, duration=0.3, rtol=1e-6, effects=names)


SMOOTH = {
    "elastic beam": _elastic(),
    "elastic beam that shears": _elastic("shear"),
    "elastic swing that shears": _elastic("inertia", "gravity-ramp", "shear", ramp=0.3),
    "Maxwell creep": _creeping(),
    "Maxwell creep that shears": _creeping("shear"),
}
LONG = 460
DESCENT = paper_scene(1.9, 26, LONG, rtol=1e-4, solver="rosenbrock")
ARREST = paper_scene(0.4, 26, LONG, rtol=1e-4, solver="rosenbrock")


def depth(asked: Scene, grid: Grid) -> float:
    """Final sag over span, on a grid of one's own."""
    effects = choose_effects(asked)
    equations = derive(effects.terms(), SECTIONS[asked.filament.section], asked.run.closure)
    graph = assemble(equations, grid, effects.names, choose_theory(asked, equations))
    prepared = prepare(asked, graph, choose_settings(asked, effects))
    solution = prepared.solve(Silence())
    assert solution.outcome.is_success, solution.message
    shown = graph.observe(solution.time, solution.x, solution.z, prepared.p)
    middle = int(np.flatnonzero(grid.nodes == 0.0)[0])
    return -float(shown["y"][-1, middle]) / asked.filament.span


def graded(cells: int) -> Grid:
    return half_span(cells, End.CLAMPED, GRADING)


def test_midpoint_is_second_order_on_graded_cells() -> None:
    for asked in SMOOTH.values():
        sags = [depth(asked, graded(cells)) for cells in (10, 20, 40)]
        order = np.log2((sags[0] - sags[1]) / (sags[1] - sags[2]))
        print(f"sag/L at N = 10, 20, 40: {', '.join(f'{sag:.7f}' for sag in sags)}; order {order:.2f}")
        assert 1.8 < order < 2.3


@pytest.mark.parametrize("name", ["elastic beam", "elastic beam that shears"])
def test_graded_and_equal_cells_have_one_limit(name: str) -> None:
    asked = SMOOTH[name]
    coarse, fine = (depth(asked, graded(cells)) for cells in (20, 40))
    equal = [depth(asked, half_span(cells, End.CLAMPED)) for cells in (20, 40)]
    assert extrapolated(coarse, fine) == pytest.approx(extrapolated(*equal), rel=5e-5)


@pytest.mark.parametrize(
    ("asked", "effects"),
    [(DESCENT, "paper"), (ARREST, "paper"), pytest.param(ARREST, "auto", marks=pytest.mark.slow)],
    ids=["descent", "arrest", "arrest that shears"],
)
def test_chosen_grading_is_worth_twice_the_cells(asked: Scene, effects: str) -> None:
    """Against fine graded cells: 20 of the chosen grading come closer than 40 equal ones, to the shape at rest too."""
    asked = asked.replace({"run.effects": effects})
    limit = depth(asked, graded(80))
    error = abs(depth(asked, half_span(20, End.CLAMPED, choose_grading(asked, 20))) / limit - 1)
    equal = abs(depth(asked, half_span(40, End.CLAMPED)) / limit - 1)
    print(f"relative error of the sag: 20 graded cells {error:.1e}, 40 equal cells {equal:.1e}")
    assert error < equal / 2
