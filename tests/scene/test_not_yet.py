"""Keys whose physics comes later are refused by name, unless they have no effect."""

from __future__ import annotations

from typing import Any

import pytest

from softcat_sym.scene import Scene
from softcat_sym.scene.material import CONSTANTS
from softcat_sym.scene.model import known_keys
from softcat_sym.scene.notyet import AVAILABLE

from .tables import BINGHAM, GROUPS, faults_of, spoiled

LAWS = ["newtonian", "kelvin-voigt", "standard-linear", "multimode-maxwell", "power-law", "herschel-bulkley", "custom"]
LATER: list[tuple[str, Any]] = [
    ("filament.section", "sheet"),
    ("filament.rest_length", "0.21 m"),
    ("filament.rest_length", "0.19 m"),
    ("filament.profile", [1.0, 0.5]),
    ("filament.curvature", "1 1/m"),
    *[("material.law", law) for law in LAWS],
    ("material.index", 0.5),
    ("material.shear_consistency", "3 Pa"),
    ("material.second_modulus", "1 MPa"),
    ("material.modes", [{"youngs_modulus": "1 MPa", "viscosity": "1 Pa s"}]),
    ("material.flow", "sinh(sigma/s0)/t0"),
    ("material.parameters", {"s0": "1 Pa"}),
    ("ends.left", "free"),
    ("ends.right", "free"),
    ("ends.drop", "1 cm"),
    ("ends.left_angle", "10 deg"),
    ("ends.right_angle", "0.1 rad"),
    ("ends.motion", "hold"),
    ("ends.motion", [["1 s", "0 m", "1 cm"]]),
    ("load.point_mass", "1 g"),
    ("initial.stretch", 1.1),
    ("initial.relaxed", False),
    ("initial.P", [0.1]),
    ("initial.C", [0.1]),
    ("numerics.backend", "compiled"),
    ("groups.n", 0.5),
    ("groups.law", "power-law"),
]


@pytest.mark.parametrize(("path", "value"), LATER)
def test_later_physics_is_refused_by_name(path: str, value: object) -> None:
    (fault,) = faults_of(spoiled({path: value}, GROUPS if path.startswith("groups") else BINGHAM))
    assert fault.path == path
    assert "not yet" in fault.found
    assert fault.accepted.startswith("for now ")


def test_every_row_of_the_table_is_tried() -> None:
    assert {path for path, _ in LATER} == set(AVAILABLE)


def test_every_row_is_a_key() -> None:
    keys = {f"{table}.{key}".lstrip(".") for table, names in known_keys().items() for key in names}
    assert set(AVAILABLE) <= keys


def test_every_available_law_has_its_constants() -> None:
    assert set(AVAILABLE["material.law"]) <= set(CONSTANTS)


def test_a_key_without_effect_is_accepted() -> None:
    idle = {
        "model": "filament",
        "filament.rest_length": "200 mm",
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
