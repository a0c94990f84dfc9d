"""The paper's arrested and descending filaments, both closures, against converged values found by other programs."""

from __future__ import annotations

import numpy as np

import softcat_sym as sc

from .table import show

INSTANTS = (46, 115, 230, 460)  # t~ = (t/L) sqrt(E/rho); the runs end at 460 with 201 frames
FRAMES = [20, 50, 100, 200]

CONVERGED = {
    ("arrested-overdamped", "material"): (-0.06256, -0.06386, -0.06534, -0.0666),
    ("arrested-overdamped", "printed"): (-0.06240, -0.06368, -0.06512, -0.0664),
    ("continual-descent", "material"): (-0.12148, -0.16379, -0.20092, -0.24409),
    ("continual-descent", "printed"): (-0.12183, -0.16497, -0.20339, -0.24978),
}


def test_midpoint_is_within_half_a_percent_of_the_converged_value() -> None:
    for name, closure in CONVERGED:
        scene = sc.load_scene(
            name, {"run.effects": "paper", "run.closure": closure, "numerics.cells": 80, "numerics.estimate": False}
        )
        run = sc.simulate(scene)
        midpoint = run.data.midpoint.values[FRAMES] / scene.filament.span
        error = midpoint / np.array(CONVERGED[name, closure]) - 1
        rows = [
            [t, f"{m:.5f}", f"{c:.5f}", f"{100 * e:+.2f} %"]
            for t, m, c, e in zip(INSTANTS, midpoint, CONVERGED[name, closure], error, strict=True)
        ]
        show(f"{name}, {closure} closure, N = 80", ("t~", "midpoint/L", "converged", "difference"), rows)
        assert run.outcome is sc.Outcome.solved
        assert np.max(np.abs(error)) < 0.005


def test_edge_of_rupture_is_refused_as_localised() -> None:
    rows = []
    for cells in (20, 40, 80):
        published = {"run.effects": "paper", "numerics.cells": cells, "numerics.grading": 1.0}
        run = sc.simulate(sc.load_scene("edge-of-rupture", published))
        sag = -run.summary["midpoint_final_m"] / run.scene.filament.span
        rows.append([cells, f"{sag:.3g}", run.outcome.name, run.summary["message"]])
    show("edge-of-rupture: the answer depends on the grid", ("N", "sag/L at 460", "outcome", "because"), rows)
    assert run.outcome is sc.Outcome.localised
    assert not run.outcome.is_success
    assert float(rows[-1][1]) > 10 * float(rows[0][1])


def test_scenes_that_converge_are_not_called_localised() -> None:
    from softcat_sym.results.verdict import SHARE_OF_ONE_CELL, largest_share_of_one_cell

    rows = []
    for name in ("no-yield", "arrested-overdamped", "continual-descent", "ink-bridge", "maxwell-slow", "maxwell-fast"):
        for cells in (20, 80):
            numerics = {"numerics.cells": cells, "numerics.grading": 1.0, "numerics.estimate": False}
            published = {"run.effects": "paper", **numerics}
            data = sc.simulate(sc.load_scene(name, published)).data
            share = max(largest_share_of_one_cell(s, np.diff(data.X_node.values)) for s in data.stretch.values[1:])
            rows.append([name, cells, f"{share:.3f}"])
            assert share < SHARE_OF_ONE_CELL
    show(f"largest share of one cell (limit {SHARE_OF_ONE_CELL})", ("scene", "N", "share"), rows)
