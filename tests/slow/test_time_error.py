"""What the default integrator and tolerances leave of time error, scene by scene, on the first grid."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.results.motion import period_of
from tests.common.table import show

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


@pytest.mark.slow
def test_steps_keep_a_ringing_of_hundreds_of_periods() -> None:
    """Within a tenth of the accuracy of a run in much shorter steps; four steps a period would lose most of it."""
    strand = sc.Scene(
        filament={"span": "7.3 mm", "thickness": "1.1 mm", "section": "circle", "density": "1200 kg/m^3"},
        material={
            "law": "bingham",
            "youngs_modulus": "940 kPa",
            "shear_yield_stress": "120 Pa",
            "shear_viscosity": "4.9 Pa*s",
        },
        surroundings={"surface_tension": "0.04 N/m"},
        run={"duration": "0.8 s", "frames": 2001},
        numerics={"cells": 10, "fibres": 8, "estimate": False},
    )
    found, exact = (sc.simulate(scene).summary for scene in (strand, strand.replace({"numerics.rtol": 2e-5})))
    largest, accuracy = exact["midpoint_largest_m"], strand.run.accuracy
    assert strand.run.duration > 100 * period_of(strand)
    assert exact["midpoint_settled_m"]["amplitude"] > 3 * accuracy * largest
    for name, value in exact["midpoint_settled_m"].items():
        assert found["midpoint_settled_m"][name] == pytest.approx(value, abs=0.1 * accuracy * largest), name
