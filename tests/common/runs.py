"""Short, coarse scenes of one law, and finished runs, one of each kind, computed once."""

from __future__ import annotations

from functools import cache
from typing import Any

from softcat_sym import simulate
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene

_MATERIALS: dict[str, dict[str, Any]] = {
    "elastic": {"law": "elastic", "youngs_modulus": "4 MPa"},
    "maxwell": {"law": "maxwell", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s"},
    "bingham": {"law": "bingham", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s", "yield_stress": "1.96 kPa"},
}


def scene_of(law: str = "bingham", **tables: dict[str, Any]) -> Scene:
    """A short, coarse scene of one law; further tables override."""
    table: dict[str, Any] = {
        "title": "A short one",
        "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
        "material": dict(_MATERIALS[law]),
        "load": {"ramp": "0.04 s"},
        "run": {"duration": "0.12 s", "frames": 13, "accuracy": 1e-3},
        "numerics": {"cells": 6, "estimate": False},
    }
    for name, values in tables.items():
        table.setdefault(name, {}).update(values)
    return Scene.model_validate(table)


@cache
def run(law: str = "bingham", left: str = "clamped") -> Run:
    """One run for all tests."""
    return simulate(scene_of(law, ends={"left": left}))
