"""Small scenes of each law."""

from __future__ import annotations

import copy
from typing import Any

from softcat_sym.scene.scene import Scene

_FILAMENT = {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"}
_MATERIALS: dict[str, dict[str, Any]] = {
    "elastic": {"law": "elastic", "youngs_modulus": "4 MPa"},
    "kelvin-voigt": {"law": "kelvin-voigt", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s"},
    "maxwell": {"law": "maxwell", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s"},
    "bingham": {"law": "bingham", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s", "yield_stress": "9.32 kPa"},
}


def scene_of(law: str = "bingham", ramp: str = "0.1 s", **tables: dict[str, Any]) -> Scene:
    """A scene of one law; further tables override."""
    table: dict[str, Any] = {
        "filament": dict(_FILAMENT),
        "material": copy.deepcopy(_MATERIALS[law]),
        "load": {"ramp": ramp},
        "run": {"duration": "0.5 s", "frames": 11},
    }
    for name, values in tables.items():
        table.setdefault(name, {}).update(values)
    return Scene.model_validate(table)
