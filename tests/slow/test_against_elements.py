"""The filament minus the elements at the paper's slenderness, grids converged on both sides.

Beside the default, in the same table, stands the published physics with both closures.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pytest

from softcat_sym.reference.element_loop import Mesh
from softcat_sym.results.run import Run
from tests.common.elements import (
    INSTANTS,
    PUBLISHED,
    AnyRun,
    Floats,
    curve,
    digits,
    elements,
    filament,
    mean,
    midpoints,
    name_of,
    percent,
    plane,
)
from tests.common.table import show

SHEARING = (*PUBLISHED, "shear", "fibres")
GRADIENT = (*SHEARING, "necking-gradient")

# The error of the integrator must not show beside a tenth of a percent. The ratio of the cells is fixed, so that twice
# as many are half as long everywhere: left to itself the program keeps the cell at a hinge a fraction of the thickness.
TIGHT: Mapping[str, object] = {"numerics.solver": "idas", "numerics.rtol": 1e-4, "numerics.grading": 10.0}
FINE: Mapping[str, object] = {**TIGHT, "numerics.cells": 160, "numerics.fibres": 12}
HALVED: Mapping[str, object] = {**TIGHT, "numerics.cells": 80, "numerics.fibres": 12}
FEWER_FIBRES: Mapping[str, object] = {**TIGHT, "numerics.cells": 80, "numerics.fibres": 6}
# The published theory has no algebraic unknown.
PUBLISHED: Mapping[str, object] = {
    **TIGHT,
    "numerics.solver": "cvodes",
    "numerics.cells": 160,
    "run.effects": "paper",
}


@dataclass(frozen=True)
class Side:
    """One row of the table: a scene, and what a filament makes of it."""

    title: str
    name: str
    changes: Mapping[str, object]

    @property
    def run(self) -> Run:
        return filament(self.name, self.changes)

    @property
    def midpoints(self) -> Floats:
        return midpoints(plane(self.name), self.run)

    @property
    def mean(self) -> float:
        return mean(plane(self.name), self.run)


def published(name: str) -> list[Side]:
    """The paper's theory, with its own closure and with ours."""
    return [
        Side(f"published physics, {closure} closure", name, {**PUBLISHED, "run.closure": closure})
        for closure in ("material", "printed")
    ]


def against(name: str, meshes: tuple[Mesh, ...], sides: list[Side]) -> tuple[Floats, float]:
    """Print the table; midpoints of the last elements at the instants, and their mean."""
    scene = plane(name)
    runs = [elements(scene, mesh) for mesh in meshes]
    truth, average = midpoints(scene, runs[-1]), mean(scene, runs[-1])
    rows = [
        [f"elements {name_of(run.mesh)}", *digits([*midpoints(scene, run), mean(scene, run)]), "", ""] for run in runs
    ]
    for side in sides:
        found, wanted = [*side.midpoints, side.mean], [*truth, average]
        both = [f"{value} ({apart})" for value, apart in zip(digits(found), percent(found, wanted), strict=True)]
        rows.append([side.title, *both, f"{side.run.summary['wall_s']['solve']:.1f}", side.run.outcome.name])
    header = ["midpoint/L", *(f"t~ = {t:g}" for t in INSTANTS), "mean of 60 to 460", "solve s", "outcome"]
    show(f"{name}, delta = 0.03, plane stress; differences from the last elements", header, rows)
    return truth, average


def errors(side: Side, truth: Floats) -> Floats:
    return np.abs(side.midpoints / truth - 1)


@pytest.mark.slow
def test_descent() -> None:
    name = "continual-descent"
    ours = Side("N = 160, 12 fibres", name, FINE)
    halved = Side("N = 80, 12 fibres", name, HALVED)
    fewer = Side("N = 80, 6 fibres", name, FEWER_FIBRES)
    default = Side("as the program chooses", name, {})
    gradient = Side("N = 80, 6 fibres, with the gradient", name, {**FEWER_FIBRES, "run.effects": GRADIENT})
    sides = [default, ours, halved, fewer, gradient, *published(name)]
    truth, _ = against(name, (Mesh(32, 2), Mesh(64, 4), Mesh(96, 6)), sides)
    assert np.all(errors(ours, truth) < 0.005)
    assert np.all(errors(default, truth) < 0.005)
    assert np.all(errors(halved, ours.midpoints) < 5e-4)
    assert np.all(errors(fewer, ours.midpoints) < 5e-4)


@pytest.mark.slow
def test_overdamped_arrest() -> None:
    """A hinge at the clamp creeps: 6 fibres hardly resolve it, and without the gradient it has no length."""
    name = "arrested-overdamped"
    ours = Side("N = 160, 12 fibres", name, FINE)
    halved = Side("N = 80, 12 fibres", name, HALVED)
    fewer = Side("N = 80, 6 fibres", name, FEWER_FIBRES)
    default = Side("as the program chooses", name, {})
    more = Side("N = 80, 24 fibres", name, {**HALVED, "numerics.fibres": 24})
    without = Side("N = 160, 12 fibres, without the gradient", name, {**FINE, "run.effects": SHEARING})
    sides = [default, ours, halved, fewer, more, without, *published(name)]
    truth, _ = against(name, (Mesh(32, 2), Mesh(64, 4), Mesh(96, 6), Mesh(48, 6, grading=10.0)), sides)
    goal = np.array([0.005, 0.005, 0.012, 0.02])
    assert np.all(errors(ours, truth) < goal)
    assert np.all(errors(default, truth) < goal)
    assert errors(without, truth)[-1] > goal[-1]
    assert np.all(errors(halved, ours.midpoints) < 5e-4)
    assert np.all(errors(more, halved.midpoints) < 5e-4)


@pytest.mark.slow
def test_underdamped_arrest() -> None:
    """Means, since the sag rings; the published physics has no limit as the grid is refined."""
    name = "arrested-underdamped"
    ours = Side("N = 160, 12 fibres", name, FINE)
    halved = Side("N = 80, 12 fibres", name, HALVED)
    coarse = Side("N = 40, 12 fibres", name, {**HALVED, "numerics.cells": 40})
    default = Side("as the program chooses", name, {})
    sides = [default, ours, halved, coarse, *published(name)]
    _, average = against(name, (Mesh(32, 2), Mesh(64, 4), Mesh(96, 6)), sides)
    assert max(abs(side.mean / average - 1) for side in sides[:4]) < 0.02
    assert all(side.run.outcome.is_success for side in sides[:4])
    assert not any(side.run.outcome.is_success for side in sides[4:])


def first_swing(name: str, run: AnyRun) -> float:
    """Height of the first turning point, by a parabola through the lowest frame and its neighbours."""
    _, height = curve(plane(name), run)
    k = int(np.argmax(np.diff(height) > 0))
    before, lowest, after = height[k - 1 : k + 2]
    return float(lowest - (after - before) ** 2 / (8 * (after - 2 * lowest + before)))


def period(name: str, run: AnyRun) -> float:
    """Mean time between upward crossings of the mean height, t~."""
    time, height = curve(plane(name), run)
    swing = height - height.mean()
    up = np.flatnonzero((swing[:-1] < 0) & (swing[1:] >= 0))
    crossings = time[up] - swing[up] * np.diff(time)[up] / np.diff(swing)[up]
    return float(np.mean(np.diff(crossings)))


@pytest.mark.slow
def test_elastic_swing() -> None:
    name = "no-yield"
    scene = plane(name)
    meshes = (Mesh(32, 2), Mesh(64, 4), Mesh(96, 6))
    runs: dict[str, AnyRun] = {f"elements {name_of(mesh)}": elements(scene, mesh) for mesh in meshes}
    # Nothing but the fifth-order method rings for so long without a loss.
    grids = {f"N = {cells}": {"numerics.cells": cells} for cells in (80, 160)}
    runs |= {title: filament(name, changes) for title, changes in grids.items()}
    paper = {"run.effects": "paper", "numerics.cells": 160}
    runs |= {
        f"published physics, {closure} closure": filament(name, {**paper, "run.closure": closure})
        for closure in ("material", "printed")
    }
    found = {title: (first_swing(name, run), period(name, run)) for title, run in runs.items()}
    truth = found[f"elements {name_of(meshes[-1])}"]
    rows = [
        [title, f"{swing:.6f}", f"{time:.4f}", *percent((swing, time), truth)] for title, (swing, time) in found.items()
    ]
    show(name, ["", "first swing/L", "period, t~", "swing", "period"], rows)
    for title in grids:
        assert found[title] == pytest.approx(truth, rel=5e-3)
