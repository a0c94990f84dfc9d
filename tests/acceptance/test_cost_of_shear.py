"""What the filament that shears costs, interpreted, and whether its energies add up with everything in force."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc

from .table import show

# IDAS at 1e-4: the integrator and tolerance of the goals. The last column is what that leaves of time error.
QUICK = {"numerics.cells": 40, "numerics.fibres": 6, "numerics.solver": "idas", "numerics.rtol": 1e-4}
GOALS = {"continual-descent": 0.2, "arrested-overdamped": 0.2, "arrested-underdamped": 2.0}
REPEATS = 3


@pytest.mark.slow
def test_seconds_of_the_solve_stage() -> None:
    rows, spent = [], {}
    for name in GOALS:
        runs = [sc.simulate(sc.load_scene(name, QUICK)) for _ in range(REPEATS)]
        default = sc.simulate(sc.load_scene(name, {"numerics.cells": 40, "numerics.fibres": 6}))
        spent[name] = min(run.summary["wall_s"]["solve"] for run in runs)
        found, expected = (run.data.midpoint.values for run in (runs[0], default))
        error = float(np.max(np.abs(found - expected)) / np.max(np.abs(expected)))
        own = f"{default.summary['solver']}, {default.summary['wall_s']['solve']:.2f}"
        rows.append([name, f"{spent[name]:.3f}", runs[0].summary["steps"], f"{error:.1e}", own])
        assert runs[0].outcome is default.outcome is sc.Outcome.solved
    header = ("scene", "IDAS, rtol 1e-4 [s]", "steps", "difference from the default", "the default [s]")
    show("N = 40, 6 fibres, to t~ = 460, best of three", header, rows)
    for name, goal in GOALS.items():
        assert spent[name] < goal, name


def test_energies_add_up_with_every_effect_in_force() -> None:
    everything = list(sc.simulate(SHORT).summary["effects"])
    every = [*everything, "rotary-inertia"]
    rows = []
    for effects in (everything, every):
        run = sc.simulate(SHORT.replace({"run.effects": effects}))
        gradient = run.data.energy_gradient.values[-1] / run.data.energy_dissipated.values[-1]
        rows.append([len(effects), run.summary["solver"], f"{run.summary['energy_residual']:.1e}", f"{gradient:.1e}"])
        assert run.outcome is sc.Outcome.solved
        assert run.summary["energy_residual"] < run.scene.run.accuracy
        assert gradient > 10 * run.summary["energy_residual"]
    assert set(every) == {*everything, "rotary-inertia"}
    assert len(every) == 12
    show("energy residual", ("effects", "solver", "residual", "work against the gradient/dissipated"), rows)


# The ringing filament until it has stopped and turned back, when all of its hinge has formed.
SHORT = sc.load_scene(
    "arrested-underdamped",
    {"groups.duration": 40.0, "run.frames": 41, "numerics.cells": 20, "numerics.fibres": 6},
)
