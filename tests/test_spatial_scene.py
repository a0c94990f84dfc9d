"""Scenes in three dimensions: their keys, whether they have a plane, and what does not go with them."""

from __future__ import annotations

import copy
import json
import math
import tomllib
from typing import Any

import pytest

from softcat_sym.effects.selection import choose_effects
from softcat_sym.estimates.quasi_static_sag import load_factor
from softcat_sym.scene.dimensions import is_spatial, out_of_plane, reason_for_dimensions
from softcat_sym.scene.scene import Scene, is_symmetric
from tests.common.scenes import BINGHAM, LAWS, faults_of, spoiled

IN_SPACE = ("bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear", "fibres")
"""What the theory in three dimensions holds, of a law that flows."""

FREE = {"ends.right": "free"}
ASIDE = {"load.direction": [0, -1, 1]}
OUT = [["0 s", "0 m", "0 m"], ["1 s", "1 mm", "2 mm", "3 mm"]]
TURNS = [["0 s", "0 deg"], ["1 s", "720 deg"]]
BENT = [["0 m", "0 m", "0 m"], ["10 cm", "1 cm", "2 mm"], ["20 cm", "0 m", "0 m"]]
CASES: list[tuple[dict[str, Any], str]] = [
    (ASIDE, "load.direction points out"),
    ({"load.direction": [1, -1, 0]}, "load.direction is not straight down"),
    ({**FREE, "load.tip_force": ["0 N", "0 N", "2 mN"]}, "load.tip_force points out"),
    ({**FREE, "load.tip_force": ["0 N", "1 mN", "0 N"]}, "load.tip_force pulls"),
    ({**FREE, "load.tip_torque": ["0 N*m", "0 N*m", "1 mN*m"]}, "load.tip_torque turns"),
    ({**FREE, "load.tip_mass": "1 g"}, "load.tip_mass"),
    ({"ends.motion": OUT}, "ends.motion leaves"),
    ({"ends.right_twist": TURNS}, "ends.right_twist"),
    ({"filament.twist": "-3 1/m"}, "filament.twist turns"),
    ({"filament.twist": "3 1/m", "filament.curvature": "2 1/m"}, "a helix"),
    ({"ends.right_slides": True}, "ends.right_slides lets"),
    ({"initial.centreline": BENT}, "initial.centreline says"),
    ({"run.dimensions": 3}, "run.dimensions asks"),
]


def scene(changes: dict[str, Any], base: dict[str, Any] = BINGHAM) -> Scene:
    return Scene.model_validate(spoiled(changes, base))


# Which scenes have a plane, and what is written of them.
@pytest.mark.parametrize(("changes", "why"), CASES)
def test_a_scene_without_a_plane_is_followed_in_space(changes: dict[str, Any], why: str) -> None:
    found = scene(changes)
    assert is_spatial(found)
    assert not is_symmetric(found)
    assert why in reason_for_dimensions(found)


@pytest.mark.parametrize("changes", [changes for changes, _ in CASES])
def test_it_is_read_back_as_it_was_written(changes: dict[str, Any]) -> None:
    found = scene(changes)
    again = Scene.model_validate(tomllib.loads(found.to_toml()))
    assert again == found and hash(again) == hash(found)
    assert Scene.model_validate(json.loads(json.dumps(found.given()))) == found
    assert found.replace({"run.frames": 3}).replace({"run.frames": found.run.frames}) == found
    assert Scene.from_dict(copy.deepcopy(found.given())) == found


@pytest.mark.parametrize(
    "changes",
    [
        {"run.dimensions": 2},
        {"load.direction": [0, -9.81, 0]},
        {**FREE, "load.tip_force": ["0 N"] * 3, "load.tip_mass": "0 kg"},
        {"ends.motion": [["0 s", "0 m", "0 m", "0 m"], ["1 s", "1 mm", "2 mm", "0 mm"]]},
        {"ends.right_twist": "hold"},
        {"ends.right_twist": [["0 s", "0 deg"], ["1 s", "0 deg"]]},
        {"filament.curvature": "2 1/m"},
        {"ends.right_slides": False, "initial.centreline": []},
    ],
)
def test_what_stays_in_the_plane_is_planar(changes: dict[str, Any]) -> None:
    found = scene(changes)
    assert not is_spatial(found)
    assert out_of_plane(found) == ""
    assert reason_for_dimensions(found) == "everything lies in one plane"


# What is refused.
SPATIAL = {"run.dimensions": 3}
REFUSED: list[tuple[dict[str, Any], str, str]] = [
    ({"filament.twist": "3 m"}, "filament.twist", "'m' is a length"),
    ({"filament.twist": 3}, "filament.twist", "3 has no unit"),
    ({"load.direction": [0, 0, 0]}, "load.direction", "points nowhere"),
    ({"load.direction": [0, -1]}, "load.direction", "a list of 2"),
    ({"load.direction": ["0 m", "1 m", "0 m"]}, "load.direction", "'0 m' is not a number"),
    ({"load.direction": [0, math.nan, 1]}, "load.direction", "not finite"),
    ({"load.direction": "down"}, "load.direction", "'down' is not a list"),
    ({**FREE, "load.tip_force": [0, 1, 0]}, "load.tip_force", "0 has no unit"),
    ({**FREE, "load.tip_force": ["0 N", "1 kg", "0 N"]}, "load.tip_force", "'kg' is a mass, not a force"),
    ({**FREE, "load.tip_force": "1 N"}, "load.tip_force", "'1 N' is not a list"),
    ({**FREE, "load.tip_torque": [0, 1, 0]}, "load.tip_torque", "0 has no unit"),
    ({**FREE, "load.tip_torque": ["0 N", "1 N", "0 N"]}, "load.tip_torque", "'N' is a force, not a torque"),
    ({**FREE, "load.tip_torque": ["0 N*m", "1 N*m"]}, "load.tip_torque", "a list of 2"),
    ({"load.tip_torque": ["0 N*m", "1 N*m", "0 N*m"]}, "load.tip_torque", "the right end is clamped"),
    ({**FREE, "load.tip_mass": "-1 g"}, "load.tip_mass", "'-1 g' is negative"),
    ({"load.tip_force": ["0 N", "1 N", "0 N"]}, "load.tip_force", "the right end is clamped"),
    ({"ends.right": "pinned", "load.tip_mass": "1 g"}, "load.tip_mass", "the right end is pinned"),
    ({"ends.right": "pinned", "ends.right_twist": TURNS}, "ends.right_twist", "the right end is pinned"),
    ({"ends.right_slides": "yes"}, "ends.right_slides", "'yes' is neither true nor false"),
    ({"ends.right_slides": True, "ends.right": "pinned"}, "ends.right_slides", "the right end is pinned"),
    ({"ends.right_slides": True, "ends.right_angle": "5 deg"}, "ends.right_angle", "the clamp slides along the span"),
    ({"ends.right_slides": True, "load.tip_force": ["0 N", "1 N", "0 N"]}, "load.tip_force", "across the way"),
    ({"ends.right_slides": True, "load.tip_mass": "1 g"}, "load.tip_mass", "the right end is clamped"),
    ({"ends.right_slides": True, "ends.motion": OUT}, "ends.motion", "along the span, where ends.right_slides"),
    ({"initial.centreline": "straight"}, "initial.centreline", "'straight' is not a list of rows"),
    ({"initial.centreline": BENT[::2]}, "initial.centreline", "a list of 2"),
    ({"initial.centreline": [[0, 0, 0], *BENT[1:]]}, "initial.centreline", "0 has no unit"),
    ({"initial.centreline": [row[:2] for row in BENT]}, "initial.centreline", "is not a row [x, y, z]"),
    ({"initial.centreline": [["0 m", "0 m", "1 mm"], *BENT[1:]]}, "initial.centreline", "a left end at [0.0"),
    ({"initial.centreline": BENT, "ends.drop": "1 mm"}, "initial.centreline", "the support is at [0.2, -0.001, 0.0]"),
    ({"initial.centreline": [BENT[0], *BENT]}, "initial.centreline", "two neighbouring points in one place"),
    ({"initial.centreline": BENT, "initial.stretch": 1.1}, "initial.stretch", "says where the filament begins"),
    ({"initial.centreline": BENT, "run.dimensions": 2}, "run.dimensions", "initial.centreline says"),
    ({"ends.right_twist": "spin"}, "ends.right_twist", "'spin' is not a list of rows"),
    ({"ends.right_twist": [["0 s"]]}, "ends.right_twist", "['0 s'] is not a row [time, angle]"),
    ({"ends.right_twist": [["0 s", "0 m"]]}, "ends.right_twist", "'m' is a length, not an angle"),
    ({"ends.right_twist": [["0 s", "90 deg"]]}, "ends.right_twist", "turns the clamp at once"),
    ({"ends.right_twist": [["-1 s", "0 deg"]]}, "ends.right_twist", "before the start"),
    ({"ends.right_twist": [*TURNS, ["1 s", "0 deg"]]}, "ends.right_twist", "a row at 1 s after one at 1 s"),
    ({"ends.motion": [["0 s", "0 m", "0 m", "1 mm"]]}, "ends.motion", "moves the support at once"),
    ({"ends.motion": [["0 s", "0 m", "0 m", "0 m", "0 m"]]}, "ends.motion", "is not a row [time, dx, dy] or"),
    ({"run.dimensions": 4}, "run.dimensions", "4 is none of these"),
    ({"run.dimensions": "3"}, "run.dimensions", "'3' is not a name"),
    ({"run.dimensions": True}, "run.dimensions", "true is none of these"),
    ({"run.dimensions": 3.0}, "run.dimensions", "3.0 is none of these"),
    *[({**changes, "run.dimensions": 2}, "run.dimensions", why) for changes, why in CASES[:-1]],
    ({**SPATIAL, "filament.section": "sheet"}, "filament.section", "torsion is a plate's"),
    ({**SPATIAL, "run.closure": "printed"}, "run.closure", "only in the plane"),
    ({**ASIDE, "surroundings.density": "1000 kg/m^3"}, "surroundings.density", "only in the plane"),
    ({**ASIDE, "surroundings.viscosity": "1 mPa*s"}, "surroundings.viscosity", "load.direction points out"),
    ({**SPATIAL, "load.point_mass": "1 g"}, "load.point_mass", "only in the plane"),
    ({**SPATIAL, "initial.C": [0.1]}, "initial.C", "only in the plane"),
    ({**SPATIAL, "numerics.order": 1}, "numerics.order", "only in the plane"),
    ({**SPATIAL, "effects.spring": {"stiffness": "1 Pa"}}, "effects.spring", "only in the plane"),
    ({**ASIDE, "filament.rest_length": "0.3 m"}, "load.direction", "the filament is slack"),
    ({"filament.twist": "1 1/m", "filament.rest_length": "0.3 m"}, "filament.twist", "the filament is slack"),
]  # fmt: skip


@pytest.mark.parametrize(("changes", "path", "says"), REFUSED)
def test_each_of_these_is_one_fault(changes: dict[str, Any], path: str, says: str) -> None:
    (fault,) = faults_of(spoiled(changes))
    assert fault.path == path
    assert says in fault.found
    assert fault.accepted


# The effects.
@pytest.mark.parametrize("law", [law for law in LAWS if "relaxation_time" not in LAWS[law]])
@pytest.mark.parametrize(("changes", "why"), [CASES[0], CASES[-1]])
def test_every_law_has_what_space_asks_for(law: str, changes: dict[str, Any], why: str) -> None:
    found = scene(changes, {**BINGHAM, "material": {"law": law, **LAWS[law]}})
    effects = choose_effects(found)
    # A law without plastic strain has no points that flow.
    flows = "viscous-flow" in effects.names
    assert set(effects.names) >= {name for name in IN_SPACE if flows or name != "fibres"}
    assert "rotary-inertia" not in effects.names
    assert "three dimensions: " in effects.reasons["shear"] and why in effects.reasons["shear"]
    decision = next(one for one in effects.decisions if one.effect.name == "rotary-inertia")
    assert "in three dimensions" in decision.reason and decision.estimate is None


def test_a_mass_at_the_tip_bends_a_cantilever_as_theory_says() -> None:
    # Of E I w'' = M: q L^4/(8 E I) under its weight, and P L^3/(3 E I) under a force at its end.
    light = scene(
        {**FREE, "filament.thickness": "1 mm"}, {**BINGHAM, "material": {"law": "elastic", **LAWS["elastic"]}}
    )
    mass = light.filament.density * light.filament.thickness * light.filament.width * light.filament.span
    heavy = light.replace({"load.tip_mass": f"{mass!r} kg"})
    assert load_factor(heavy) == pytest.approx(1 + (1 / 3) / (1 / 8))
    assert load_factor(light) == 1
