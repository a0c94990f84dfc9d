"""A mass that hangs at midspan makes a hinge there: the error that is estimated is the true one."""

from __future__ import annotations

import pytest

import softcat_sym as sc
from tests.acceptance.error_calibration import true_error
from tests.acceptance.table import show

pytestmark = pytest.mark.slow

OWN = 13.7e-3
"""Mass of the strand [kg]."""


def strand(mass: float) -> sc.Scene:
    """A Bingham strand whose hinges turn until tension carries it."""
    return sc.Scene.model_validate(
        {
            "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
            "material": {
                "law": "bingham",
                "youngs_modulus": "4 MPa",
                "yield_stress": "20 kPa",
                "viscosity": "13.84 kPa*s",
            },
            "load": {"point_mass": f"{mass} kg"},
            "run": {"duration": "1 s", "accuracy": 1e-3, "frames": 101},
        }
    )


def test_the_estimated_error_of_a_strand_with_a_mass_is_its_error() -> None:
    rows, ratios = [], []
    for share in (0.3, 1.0, 2.0):
        run = sc.simulate(strand(share * OWN))
        true, why = true_error(run.scene, run)
        assert not why
        total, at = run.summary["error_estimate"]["total"], run.summary["resolution"]
        ratios.append(true / total)
        rows.append((share, run.outcome.name, f"{at['cells']} x {at['fibres']}", f"{total:.1e}", f"{true:.1e}"))
    show("a mass at midspan", ("mass over own", "outcome", "cells x fibres", "estimated", "true"), rows)
    assert max(ratios) < 1.5
