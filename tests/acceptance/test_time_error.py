"""What the default integrator and tolerances leave of time error, scene by scene, on the first grid."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc

from .table import show

REFUSED = {"edge-of-rupture"}


@pytest.mark.slow
def test_time_error_is_a_tenth_of_the_accuracy() -> None:
    """Against CasADi's Rosenbrock method on the interpreted graph, with a tolerance far below the default's.

    Scenes run compiled by themselves: neither the integrator nor the evaluation of the right-hand side is shared.
    """
    rows, shares = [], {}
    for name in sc.bundled_names():
        if name in REFUSED:
            continue
        # At the first guess: the same grid for both; an interpreted estimate of hinges would take hours.
        scene = sc.load_scene(name, {"numerics.estimate": False})
        run = sc.simulate(scene)
        tight = 1e-7 if name == "glass-rod" else 1e-6
        other = {"numerics.backend": "interpreted", "numerics.solver": "rosenbrock", "numerics.rtol": tight}
        fine = sc.simulate(scene.replace(other))
        assert run.outcome is fine.outcome is sc.Outcome.solved
        assert list(run.summary["effects"]) == list(fine.summary["effects"]), name
        midpoint, reference = run.data.midpoint.values, fine.data.midpoint.values
        error = float(np.max(np.abs(midpoint - reference)) / np.max(np.abs(reference)))
        shares[name] = error / scene.run.accuracy
        rows.append([name, run.summary["solver"], run.summary["steps"], f"{error:.1e}"])
    show("time error of the midpoint at the accuracy of the scene", ("scene", "solver", "steps", "time error"), rows)
    for name, share in shares.items():
        assert share < 0.1, name
