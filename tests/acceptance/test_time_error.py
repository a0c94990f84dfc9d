"""What the default integrator and tolerances leave of time error, scene by scene, on the grid of the scene."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc

from .table import show

REFUSED = {"edge-of-rupture"}


@pytest.mark.slow
def test_time_error_is_a_tenth_of_the_accuracy() -> None:
    """Against the fifth-order Rosenbrock method with a tolerance far below the default's.

    For scenes that run with that method themselves this is a refinement, for the others another family of methods; the
    oracle of the tests checks both against code that is not ours.
    """
    rows, shares = [], {}
    for name in sc.bundled_names():
        if name in REFUSED:
            continue
        scene = sc.load_scene(name)
        run = sc.simulate(scene)
        tight = "1e-7" if name == "glass-rod" else "1e-6"
        fine = sc.simulate(sc.load_scene(name, {"numerics.solver": "rosenbrock", "numerics.rtol": tight}))
        assert run.outcome is fine.outcome is sc.Outcome.solved
        midpoint, reference = run.data.midpoint.values, fine.data.midpoint.values
        error = float(np.max(np.abs(midpoint - reference)) / np.max(np.abs(reference)))
        shares[name] = error / scene.run.accuracy
        rows.append([name, run.summary["solver"], run.summary["steps"], f"{error:.1e}"])
    show("time error of the midpoint at accuracy 1e-3", ("scene", "solver", "steps", "time error"), rows)
    for name, share in shares.items():
        assert share < 0.1, name
