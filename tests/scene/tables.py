"""Sound raw scenes to spoil."""

from __future__ import annotations

import copy
from typing import Any

import pytest

from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

BINGHAM: dict[str, Any] = {
    "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
    "material": {
        "law": "bingham",
        "youngs_modulus": "4 MPa",
        "viscosity": "13.84 kPa*s",
        "yield_stress": "9.32 kPa",
    },
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
