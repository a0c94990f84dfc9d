"""Laws in their limits, and the user's own."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.rheology import GEOMETRY, Array, flow_of, scene, solved
from tests.common.table import show
from tests.marks import few

# Each law becomes the simpler one it contains: the same trajectory to the tolerance, or a limit at a stated rate.
E, ETA, STRESS = 1e6, 5e4, 1e4
"""Modulus [Pa], viscosity [Pa s] and the weight's own stress rho g L [Pa]."""
RTOL = 1e-7
SPRING = {"youngs_modulus": E}

PAIRS: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "Herschel-Bulkley, n = 1, and Bingham": (
        {"law": "herschel-bulkley", **SPRING, "viscosity": ETA, "index": 1.0, "yield_stress": 0.8 * STRESS},
        {"law": "bingham", **SPRING, "viscosity": ETA, "yield_stress": 0.8 * STRESS},
    ),
    "Herschel-Bulkley, sY = 1e-9 rho g L, n = 0.5, and the power law": (
        {"law": "herschel-bulkley", **SPRING, "viscosity": ETA, "index": 0.5, "yield_stress": 1e-9 * STRESS},
        {"law": "power-law", **SPRING, "viscosity": ETA, "index": 0.5},
    ),
    "Herschel-Bulkley, sY = 1e-9 rho g L, n = 1.5, and the power law": (
        {"law": "herschel-bulkley", **SPRING, "viscosity": ETA, "index": 1.5, "yield_stress": 1e-9 * STRESS},
        {"law": "power-law", **SPRING, "viscosity": ETA, "index": 1.5},
    ),
    "power law, n = 1, and Maxwell": (
        {"law": "power-law", **SPRING, "viscosity": ETA, "index": 1.0},
        {"law": "maxwell", **SPRING, "viscosity": ETA},
    ),
    "one mode and Maxwell": (
        {"law": "multimode-maxwell", "modes": [{**SPRING, "viscosity": ETA}]},
        {"law": "maxwell", **SPRING, "viscosity": ETA},
    ),
    "two equal modes and Maxwell": (
        {"law": "multimode-maxwell", "modes": 2 * [{"youngs_modulus": E / 2, "viscosity": ETA / 2}]},
        {"law": "maxwell", **SPRING, "viscosity": ETA},
    ),
}


def sags(material: dict[str, Any], effects: str | tuple[str, ...], rtol: float = RTOL) -> Array:
    """Heights of the midpoint."""
    filament = {"thickness": 0.05}
    asked = scene(material, filament, effects=effects, run={"frames": 21, "accuracy": 1e-2}, cells=10, rtol=rtol)
    return np.asarray(solved(asked)["midpoint"].values)


@pytest.mark.parametrize(
    "name",
    few(PAIRS, "two equal modes and Maxwell"),
)
def test_a_law_is_the_one_it_contains(name: str) -> None:
    """With inertia and with every term of the published list; the difference falls with the tolerance."""
    one, other = PAIRS[name]
    rows, errors = [], []
    for rtol in (1e-5, RTOL):
        found, expected = sags(one, "paper", rtol), sags(other, "paper", rtol)
        errors.append(float(np.max(np.abs(found - expected)) / np.max(np.abs(expected))))
        rows.append([f"{rtol:g}", f"{-expected[-1]:.8f}", f"{-found[-1]:.8f}", f"{errors[-1]:.1e}"])
    show(name, ("rtol", "sag, simpler law", "sag", "largest difference, relative"), rows)
    assert errors[-1] < 2e-6


def quasi_static(material: dict[str, Any]) -> Array:
    return sags(material, (*GEOMETRY, *flow_of(material["law"])))


def test_stiff_maxwell_tends_to_newtonian_as_one_over_the_modulus() -> None:
    newtonian = quasi_static({"law": "newtonian", "viscosity": ETA})
    moduli, errors = 1e6 * np.array([10.0, 100.0, 1000.0]), []
    for modulus in moduli:
        stiff = quasi_static({"law": "maxwell", "youngs_modulus": float(modulus), "viscosity": ETA})
        errors.append(float(np.max(np.abs(stiff - newtonian)) / np.max(np.abs(newtonian))))
    orders = [float("nan"), *np.log10(np.array(errors[:-1]) / np.array(errors[1:]))]
    rows = [[f"{E:.0e}", f"{e:.2e}", f"{order:.3f}"] for E, e, order in zip(moduli, errors, orders, strict=True)]
    show(f"Maxwell against Newtonian, sag {-newtonian[-1]:.4f} L", ("E [Pa]", "difference", "order in 1/E"), rows)
    assert orders[-1] == pytest.approx(1.0, abs=0.05)


def test_stiff_arm_makes_a_standard_linear_solid_kelvin_voigt() -> None:
    limit = quasi_static({"law": "kelvin-voigt", **SPRING, "viscosity": ETA})
    errors, arms = [], (1e8, 1e9)
    for arm in arms:
        solid = {"law": "standard-linear", **SPRING, "second_modulus": arm, "viscosity": ETA}
        errors.append(float(np.max(np.abs(quasi_static(solid) - limit)) / np.max(np.abs(limit))))
    order = float(np.log10(errors[0] / errors[1]))
    rows = [[f"{arm:.0e}", f"{error:.2e}"] for arm, error in zip(arms, errors, strict=True)]
    show(f"standard linear solid against Kelvin-Voigt, order {order:.3f}", ("arm [Pa]", "difference"), rows)
    assert order == pytest.approx(1.0, abs=0.05)


# A flow rule of one's own, one line in the scene, against the built-in law that it repeats.
BODY = {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"}
PAIRS_CUSTOM_LAW = {
    "maxwell": (
        {"law": "maxwell", "viscosity": "13.84 kPa*s"},
        {"flow": "sigma/e0", "parameters": {"e0": "13.84 kPa*s"}},
    ),
    "bingham": (
        {"law": "bingham", "viscosity": "13.84 kPa*s", "yield_stress": "2.5 kPa"},
        {"flow": "max(abs(sigma) - sY, 0)*sign(sigma)/e0", "parameters": {"e0": "13.84 kPa*s", "sY": "2.5 kPa"}},
    ),
    "power-law": (
        {"law": "power-law", "viscosity": "5 kPa*s^0.5", "index": 0.5},
        {"flow": "sigma*abs(sigma)/K**2", "parameters": {"K": "5 kPa*s^0.5"}},
    ),
    "herschel-bulkley": (
        {"law": "herschel-bulkley", "viscosity": "5 kPa*s^0.5", "index": 0.5, "yield_stress": "2.5 kPa"},
        {"flow": "(max(abs(sigma) - sY, 0)/K)**2*sign(sigma)", "parameters": {"K": "5 kPa*s^0.5", "sY": "2.5 kPa"}},
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
@pytest.mark.slow
def test_a_custom_law_is_the_built_in_one(effects: str) -> None:
    """Both theories: closed-form or split means of the published one, fibres with shear of the other."""
    rows, errors = [], []
    for name, pair in PAIRS_CUSTOM_LAW.items():
        runs = [sc.simulate(scene_of(dict(material), effects)) for material in pair]
        assert all(run.outcome.is_success for run in runs)
        errors.append(difference(*(run.data.midpoint.values for run in runs)))
        rows.append([name, pair[1]["flow"], f"{1e3 * runs[0].data.midpoint.values[-1]:.4f}", f"{errors[-1]:.1e}"])
    show(f"custom laws, effects = {effects}", ["law", "phi(sigma)", "midpoint/mm", "difference/sag"], rows)
    # A hundredth of the accuracy asked.
    assert max(errors) < 1e-4
