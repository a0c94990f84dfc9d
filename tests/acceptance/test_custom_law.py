"""A flow rule of one's own, one line in the scene, against the built-in law that it repeats."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc

from .table import show

BODY = {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"}
PAIRS = {
    "maxwell": (
        {"law": "maxwell", "viscosity": "13.84 kPa*s"},
        {"flow": "sigma/e0", "parameters": {"e0": "13.84 kPa*s"}},
    ),
    "bingham": (
        {"law": "bingham", "viscosity": "13.84 kPa*s", "yield_stress": "2.5 kPa"},
        {
            "flow": "max(abs(sigma) - sY, 0)*sign(sigma)/e0",
            "parameters": {"e0": "13.84 kPa*s", "sY": "2.5 kPa"},
        },
    ),
    "power-law": (
        {"law": "power-law", "viscosity": "5 kPa*s^0.5", "index": 0.5},
        {"flow": "sigma*abs(sigma)/K**2", "parameters": {"K": "5 kPa*s^0.5"}},
    ),
    "herschel-bulkley": (
        {"law": "herschel-bulkley", "viscosity": "5 kPa*s^0.5", "index": 0.5, "yield_stress": "2.5 kPa"},
        {
            "flow": "(max(abs(sigma) - sY, 0)/K)**2*sign(sigma)",
            "parameters": {"K": "5 kPa*s^0.5", "sY": "2.5 kPa"},
        },
    ),
}


def scene_of(material: dict[str, object], effects: str) -> sc.Scene:
    """A clamped filament of 4 MPa that sags for half a second."""
    law = {"law": "custom", **material} if "flow" in material else material
    return sc.Scene.model_validate(
        {
            "filament": BODY,
            "material": {"youngs_modulus": "4 MPa", **law},
            "load": {"ramp": "50 ms"},
            "run": {"duration": "0.5 s", "frames": 26, "effects": effects},
            "numerics": {"cells": 8, "estimate": False},
        }
    )


def difference(one: np.ndarray, other: np.ndarray) -> float:
    """Largest difference of two midpoints over the largest sag."""
    return float(np.max(np.abs(one - other)) / np.max(np.abs(one)))


@pytest.mark.parametrize("effects", ["paper", "auto"])
def test_a_custom_law_is_the_built_in_one(effects: str) -> None:
    """Both theories: closed-form or split means of the published one, fibres with shear of the other."""
    rows, errors = [], []
    for name, pair in PAIRS.items():
        runs = [sc.simulate(scene_of(dict(material), effects)) for material in pair]
        assert all(run.outcome.is_success for run in runs)
        errors.append(difference(*(run.data.midpoint.values for run in runs)))
        rows.append([name, pair[1]["flow"], f"{1e3 * runs[0].data.midpoint.values[-1]:.4f}", f"{errors[-1]:.1e}"])
    show(f"custom laws, effects = {effects}", ["law", "phi(sigma)", "midpoint/mm", "difference/sag"], rows)
    # A hundredth of the accuracy asked.
    assert max(errors) < 1e-4
