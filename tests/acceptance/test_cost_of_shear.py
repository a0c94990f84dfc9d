"""What the filament that shears costs, interpreted, and whether its energies add up with everything in force."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc

from .table import show

SIZE = {"numerics.cells": 40, "numerics.fibres": 6, "numerics.estimate": False}
# Scene, tolerance of IDAS, goal in seconds, and how much longer than the compiled solver it may take: about twice
# what was measured on a busy machine. The ringing filament is judged by its mean: at 3e-4 that is good to 1e-3, while
# single swings are a per cent off.
CASES = (
    ("continual-descent", 1e-4, 0.2, 12.0),
    ("arrested-overdamped", 1e-4, 0.2, 8.0),
    ("arrested-underdamped", 3e-4, 2.0, 5.0),
)
REPEATS = 3
LATE = 60 / 460  # of the run: from here on means are taken


@pytest.mark.slow
def test_seconds_of_the_solve_stage() -> None:
    """Seconds depend on the machine and are printed beside their goals; what is asserted is the ratio in one run."""
    rows = []
    for name, rtol, goal, most in CASES:
        quick = {**SIZE, "numerics.solver": "idas", "numerics.rtol": rtol}
        # In turn, so that a busy neighbour slows both.
        pairs = [[sc.simulate(sc.load_scene(name, one)) for one in (quick, SIZE)] for _ in range(REPEATS)]
        spent, own = (min(pair[k].summary["wall_s"]["solve"] for pair in pairs) for k in (0, 1))
        run, default = pairs[0]
        found, expected = (one.data.midpoint.values for one in (run, default))
        late = slice(round(LATE * len(found)), None)
        error = float(np.max(np.abs(found - expected)) / np.max(np.abs(expected)))
        of_mean = abs(float(found[late].mean() / expected[late].mean()) - 1)
        told = [f"{own:.3f}", f"{spent / own:.1f}", f"{most:g}"]
        rows.append([name, f"{rtol:g}", f"{spent:.3f}", f"{goal:g}", run.summary["steps"], f"{error:.1e}"])
        rows[-1] += [f"{of_mean:.1e}", *told]
        assert run.outcome is default.outcome is sc.Outcome.solved
        assert (run.summary["solver"], default.summary["backend"]) == ("idas", "compiled")
        assert of_mean < 1e-3
        assert spent < most * own, name
    differences = ("largest difference", "of the mean")
    header = ("scene", "rtol", "IDAS [s]", "goal", "steps", *differences, "compiled [s]", "ratio", "at most")
    show("N = 40, 6 fibres, to t~ = 460, best of three; differences from the default", header, rows)


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
    assert len(every) == 13
    show("energy residual", ("effects", "solver", "residual", "work against the gradient/dissipated"), rows)


# The ringing filament until it has stopped and turned back, when all of its hinge has formed.
SHORT = sc.load_scene(
    "arrested-underdamped",
    {"groups.duration": 40.0, "run.frames": 41, "numerics.cells": 20, "numerics.fibres": 6, "numerics.estimate": False},
)
