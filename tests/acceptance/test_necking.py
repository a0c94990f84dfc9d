"""The underdamped scene necks at its clamps: converged with the gradient, refused without it, and near rupture beyond.

The sag rings with a period of some 11 t~, so means over 60 < t~ < 460 are compared. No constant is fitted: beta is that
of plane stress, 1/48, and kappa_s is 5/6.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.scaling_estimates import neck_length
from softcat_sym.errors import SoftcatError
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.results.verdict import neck_strain

from .elements import curve, elements, filament, mean, name_of, plane
from .table import show
from .test_against_elements import SHEARING, TIGHT

NAME = "arrested-underdamped"
CELLS = (40, 80, 160)
MESHES = (Mesh(32, 2), Mesh(64, 4), Mesh(96, 6))

Row = list[object]


def case(G: float, cells: int, fibres: int) -> Mapping[str, object]:
    # The bundled value is left alone, so that a run that another check made is found again.
    gravity: Mapping[str, object] = {} if G == 0.25 else {"groups.G": G}
    return {**TIGHT, "numerics.cells": cells, "numerics.fibres": fibres, **gravity}


def row(title: str, run: Trajectory) -> Row:
    scene = plane(NAME)
    sag = f"{-mean(scene, run):.5g}"
    stretch = run.data.stretch.values[-1]
    neck = neck_strain(stretch, np.diff(run.data.X_node.values), neck_length(run.scene))
    last = f"{-curve(scene, run)[1][-1]:.5g}"
    return [title, sag, last, f"{stretch.max():.4g}", f"{neck:.3g}", run.outcome.name, run.summary["message"]]


def of_elements(G: float, mesh: Mesh) -> Row:
    """A row, or what the elements refuse; their stretch is the mean over the column of elements at the clamp."""
    scene = plane(NAME, {} if G == 0.25 else {"groups.G": G})
    try:
        run = elements(scene, mesh)
    except SoftcatError as refusal:
        return [f"elements {name_of(mesh)}", "", "", "", "", "refused", str(refusal)]
    largest = f"{math.exp(run.clamp_strain[-1]):.4g}"
    return [
        f"elements {name_of(mesh)}",
        f"{-mean(scene, run):.5g}",
        f"{-curve(scene, run)[1][-1]:.5g}",
        largest,
        "",
        "",
        "",
    ]


HEADER = ["", "mean sag/L", "sag/L at the end", "stretch at the clamp", "strain of the neck", "outcome", "because"]


@pytest.mark.slow
def test_with_the_gradient_the_grids_agree() -> None:
    runs = {cells: filament(NAME, case(0.25, cells, 12)) for cells in CELLS}
    rows = [row(f"N = {cells}, 12 fibres", run) for cells, run in runs.items()]
    show("G = 0.25, V = 0.4", HEADER, rows + [of_elements(0.25, mesh) for mesh in MESHES])
    means = [mean(plane(NAME), run) for run in runs.values()]
    assert all("necking-gradient" in run.summary["effects"] for run in runs.values())
    assert all(run.outcome is sc.Outcome.solved for run in runs.values())
    assert max(means) / min(means) < 1.015
    necks = [float(str(seen[4])) for seen in rows]
    assert max(necks) / min(necks) < 1.05


@pytest.mark.slow
def test_without_the_gradient_the_answer_is_refused() -> None:
    changes = [{**TIGHT, "numerics.cells": cells, "run.effects": SHEARING} for cells in CELLS]
    runs = [filament(NAME, change) for change in changes]
    rows = [row(f"N = {cells}, 6 fibres", run) for cells, run in zip(CELLS, runs, strict=True)]
    show("G = 0.25, V = 0.4 without the gradient", HEADER, rows)
    for run in runs:
        assert run.outcome is sc.Outcome.localised
        assert not run.outcome.is_success
        assert "necking-gradient" in run.outcome.value


@pytest.mark.slow
def test_the_means_do_not_depend_on_the_integrator() -> None:
    grid = {**TIGHT, "numerics.cells": 40, "numerics.fibres": 6}
    rings = filament(NAME, {**grid, "numerics.solver": "rosenbrock"})
    damps = filament(NAME, grid)
    first, second = mean(plane(NAME), rings), mean(plane(NAME), damps)
    rows = [
        [run.summary["solver"], f"{average:.6f}", run.summary["steps"], f"{run.summary['wall_s']['solve']:.1f}"]
        for run, average in ((rings, first), (damps, second))
    ]
    show("G = 0.25, N = 40, 6 fibres", ["integrator", "mean midpoint/L", "steps", "s"], rows)
    assert abs(second / first - 1) < 2e-3


@pytest.mark.slow
@pytest.mark.parametrize("G", [0.3, 0.4])
def test_near_rupture(G: float) -> None:
    """Nothing is fitted here, and nothing is hidden: what grids, fibres and elements do, and what the program says."""
    cases = [*((cells, 12) for cells in CELLS), *((80, fibres) for fibres in (6, 24))]
    runs = {(cells, fibres): filament(NAME, case(G, cells, fibres)) for cells, fibres in cases}
    rows = [row(f"N = {cells}, {fibres} fibres", run) for (cells, fibres), run in runs.items()]
    show(f"G = {G}, V = 0.4, with the gradient", HEADER, rows + [of_elements(G, mesh) for mesh in MESHES])
    if G == 0.4:
        assert all(run.outcome is sc.Outcome.localised for run in runs.values())
    else:
        sags = [-mean(plane(NAME), run) for run in runs.values()]
        assert all(run.outcome is sc.Outcome.solved for run in runs.values())
        assert max(sags) / min(sags) < 1.015
