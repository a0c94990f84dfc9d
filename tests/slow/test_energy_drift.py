"""Elastic filaments over many periods: nothing damps them, so that what energy they lose is the integrator's doing."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.single_run import build
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Silence
from tests.common.table import show

NUMERICS = {"estimate": False, "tail": "integrate"}
PERIODS, FRAMES, LAST, ACCURACY = 500, 8, 10, 1e-3
"""Frames are those of a period; over the last periods errors of the midpoint are looked at."""

# The first period [s], and the cells: what the time steps of a string lose does not need more.
SCENES: dict[str, tuple[float, dict[str, object], dict[str, Any]]] = {
    "no-yield, elastic": (
        0.0983,
        {},
        {
            "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "4 MPa"},
            "load": {"ramp": "0.0436 s"},
        },
    ),
    "stretched-rubber-band": (
        0.01277,
        {"cells": 10},
        {
            "filament": {"span": "0.1 m", "thickness": "1 mm", "density": "930 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "1 MPa"},
            "initial": {"stretch": 1.25, "relaxed": False},
        },
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_default_accuracy_keeps_the_energy_of_hundreds_of_periods(name: str) -> None:
    """To a tenth of the accuracy, the share of time errors; and so the midpoint, of a run in much shorter steps."""
    period, cells, tables = SCENES[name]
    drifts, midpoints = [], []
    for numerics in ({}, {"rtol": 2e-6}):
        run = {"duration": f"{period * PERIODS!r} s", "frames": FRAMES * PERIODS + 1, "accuracy": ACCURACY}
        scene = sc.Scene.model_validate({**tables, "run": run, "numerics": {**NUMERICS, **cells, **numerics}})
        prepared = build(scene, choose_effects(scene))
        solution = prepared.solve(Silence())
        assert solution.outcome is Outcome.solved
        after = slice(FRAMES // 2 + 1, None)  # The load is on after half a period
        fields = prepared.graph.observe(prepared.times[after], solution.x[:, after], solution.z[:, after], prepared.p)
        energy = (fields["energy_kinetic"] + fields["energy_elastic"] + fields["energy_potential"])[:, 0]
        drifts.append(float(np.max(np.abs(energy - energy[0])) / fields["energy_kinetic"].max()))
        midpoints.append(solution.x[prepared.graph.differential.kinds.index("y")][-LAST * FRAMES :])
    found, exact = midpoints
    error, lost = float(np.max(np.abs(found - exact))) / (np.ptp(exact) / 2), np.ptp(found) / np.ptp(exact) - 1
    show(name, ("drift", "in short steps", "midpoint", "amplitude"), [[f"{one:.1e}" for one in (*drifts, error, lost)]])
    assert max(*drifts, error, abs(lost)) < ACCURACY / 10
