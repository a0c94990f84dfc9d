"""Keys whose physics comes later are refused by name, unless they have no effect."""

from __future__ import annotations

from typing import Any

import pytest

from softcat_sym.scene import Scene
from softcat_sym.scene.model import known_keys
from softcat_sym.scene.notyet import AVAILABLE

from .tables import BINGHAM, faults_of, spoiled

LATER: list[tuple[str, Any]] = [("numerics.backend", "compiled")]


@pytest.mark.parametrize(("path", "value"), LATER)
def test_later_physics_is_refused_by_name(path: str, value: object) -> None:
    (fault,) = faults_of(spoiled({path: value}))
    assert fault.path == path
    assert "not yet" in fault.found
    assert fault.accepted.startswith("for now ")


def test_every_row_of_the_table_is_tried_and_is_a_key() -> None:
    assert {path for path, _ in LATER} == set(AVAILABLE)
    assert set(AVAILABLE) <= {f"{table}.{key}".lstrip(".") for table, names in known_keys().items() for key in names}


def test_a_key_without_effect_is_accepted() -> None:
    idle = {
        "model": "filament",
        "filament.profile": [],
        "filament.curvature": "0 1/mm",
        "material.index": 1,
        "material.modes": [],
        "material.flow": "",
        "material.parameters": {},
        "ends.drop": "0 mm",
        "ends.left_angle": "0 rad",
        "ends.motion": "",
        "load.point_mass": "0 g",
        "initial.stretch": 1,
        "initial.relaxed": True,
        "initial.P": [],
        "numerics.backend": "interpreted",
    }
    assert faults_of(spoiled(idle)) == ()
    idle.pop("numerics.backend")
    assert Scene.model_validate(spoiled(idle)) == Scene.model_validate(BINGHAM)
