"""Sound raw scenes to spoil, and small scenes of each law."""

from __future__ import annotations

import copy
from typing import Any

import pytest

from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import laws
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

BINGHAM: dict[str, Any] = {
    "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
    "material": {"law": "bingham", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s", "yield_stress": "9.32 kPa"},
    "run": {"duration": "2 s"},
}

GROUPS: dict[str, Any] = {"groups": {"delta": 0.03, "law": "bingham", "G": 0.4, "V": 26, "duration": 14.0}}


def spoiled(changes: dict[str, Any], base: dict[str, Any] = BINGHAM) -> dict[str, Any]:
    """Set dotted keys in a copy; None takes one out."""
    table = copy.deepcopy(base)
    for path, value in changes.items():
        *tables, key = path.split(".")
        here = table
        for name in tables:
            here = here.setdefault(name, {})
        if value is None:
            here.pop(key, None)
        else:
            here[key] = value
    return table


def faults_of(table: object) -> tuple[Fault, ...]:
    """Validate, and return what was refused."""
    try:
        Scene.model_validate(table)
    except SceneError as error:
        assert error.faults
        return error.faults
    return ()


def refused(name: object, overrides: Any = ()) -> str:
    """Load, and return the text of the one fault."""
    with pytest.raises(SceneError) as caught:
        load_scene(name, overrides)  # type: ignore[arg-type]
    text = str(caught.value)
    assert "Traceback" not in text
    assert "pydantic" not in text
    assert len(caught.value.faults) == 1
    return text


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


MODES = [{"youngs_modulus": "1 MPa", "viscosity": "2 kPa*s"}, {"youngs_modulus": "3 MPa", "viscosity": "50 Pa*s"}]
CONSTANTS: dict[str, Any] = {
    "youngs_modulus": "4 MPa",
    "second_modulus": "1 MPa",
    "viscosity": "3 kPa*s",
    "yield_stress": "9 kPa",
    "relaxation_time": "1 ms",
    "solvent_viscosity": "0.3 kPa*s",
    "finite_extensibility": 100.0,
    "mobility": 0.2,
    "ptt_epsilon": 0.1,
}
BESIDES: dict[str, dict[str, Any]] = {
    "multimode-maxwell": {"modes": MODES},
    "custom": {
        "flow": "sign(sigma)*(max(abs(sigma) - tau_c, 0)/K)**(1/m)",
        "parameters": {"m": 0.4, "K": "1 Pa*s^0.4", "tau_c": "2 Pa"},
    },
}
LAWS: dict[str, dict[str, Any]] = {
    one.name: {name: CONSTANTS[name] for name in one.constants}
    | ({"viscosity": "120 Pa*s^0.4", "index": 0.4} if one.has_index else {})
    | BESIDES.get(one.name, {})
    for one in laws.LAWS.values()
}
