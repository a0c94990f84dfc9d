"""Scenes in three dimensions: their keys, whether they have a plane, and what does not go with them."""

from __future__ import annotations

import copy
import io
import json
import math
import tomllib
from typing import Any

import numpy as np
import pytest
from rich.console import Console

import softcat_sym as sc
from softcat_sym.cli.explain import print_explanation
from softcat_sym.effects.inertia import outrunning_faults
from softcat_sym.effects.selection import choose_effects
from softcat_sym.effects.theory_limits import theory_limits
from softcat_sym.errors import SceneError
from softcat_sym.estimates.expected_regime import expected_regime
from softcat_sym.estimates.forecast import forecast
from softcat_sym.estimates.quasi_static_sag import load_factor
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.dimensions import is_spatial, out_of_plane, reason_for_dimensions
from softcat_sym.scene.parts import DOWN
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene, is_symmetric
from softcat_sym.scene.tables import farthest, nearest
from softcat_sym.studies.explanation import explain
from tests.common.scenes import BINGHAM, LAWS, faults_of, scene_of, spoiled

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


def test_a_planar_scene_writes_none_of_the_keys() -> None:
    text = scene({}).to_toml()
    assert not any(key in text for key in ("twist", "direction", "tip_", "dimensions", "slides", "centre"))
    assert is_symmetric(scene({}))
    assert scene({"load.direction": [0, -2, 0]}) == scene({})
    assert scene({"ends.motion": [["0 s", "0 m", "0 m", "0 m"]]}).ends.motion == ((0.0, 0.0, 0.0),)


# The keys.
def test_values_are_stored_in_si() -> None:
    found = scene({**FREE, "load.direction": [3, 0, -4], "load.tip_force": ["1 kN", "-2 mN", "3 N"]})
    assert found.load.direction == pytest.approx((0.6, 0, -0.8), rel=1e-15)
    assert found.load.tip_force == (1000.0, -0.002, 3.0)
    path = scene({"ends.motion": OUT, "ends.right_twist": TURNS}).ends
    assert path.motion == ((0.0, 0.0, 0.0, 0.0), (1.0, 0.001, 0.002, 0.003))
    assert path.right_twist[1] == pytest.approx((1.0, 4 * math.pi))


def test_python_gives_numbers_in_si() -> None:
    table = {name: dict(part) for name, part in BINGHAM.items()}
    table |= {"ends": {"right": "free"}, "load": {"tip_force": (0, 1, 2.5), "tip_mass": 0.001}}
    assert sc.Scene(**table).load.tip_force == (0.0, 1.0, 2.5)
    table["ends"] = {"motion": [(0, 0, 0), (1, 0, 0, 0.003)], "right_twist": [(0, 0), (1, 6.5)]}
    table["load"] = {}
    ends = sc.Scene(**table).ends
    assert ends.motion[1] == (1.0, 0.0, 0.0, 0.003)
    assert ends.right_twist[1] == (1.0, 6.5)
    table["initial"] = {"centreline": np.array([[0, 0, 0], [0.1, 0.01, 0.002], [0.2, 0, 0]]).tolist()}
    assert sc.Scene(**table).initial.centreline[1] == (0.1, 0.01, 0.002)


def test_the_command_line_sets_them() -> None:
    changes = ["load.direction=[0, 0, -5]", "run.dimensions=3", "filament.twist=-2 1/m"]
    found = load_scene("arrested-overdamped", changes)
    assert found.load.direction == (0.0, 0.0, -1.0)
    assert found.run.dimensions == 3
    assert found.filament.twist == -2.0
    assert load_scene("arrested-overdamped", ["load.direction=[0, -1, 0]"]).load.direction == DOWN


@pytest.mark.parametrize("vector", [[1e-200, 1e-200, 0], [1e300, -1e300, 1e300], [-1, -6, 6], [-7, 11, 13]])
def test_a_direction_has_length_one_and_stays(vector: list[float]) -> None:
    found = scene({"load.direction": vector}).load.direction
    assert math.hypot(*found) == pytest.approx(1, rel=1e-15)
    assert scene({"load.direction": list(found)}).load.direction == found


def test_distances_count_the_way_across_the_plane() -> None:
    rows = [["0 s", "0 m", "0 m"], ["1 s", "0 m", "0 m", "0.15 m"], ["2 s", "-0.4 m", "0 m", "0.15 m"]]
    found = scene({"ends.motion": rows})
    assert farthest(found) == pytest.approx(0.25)
    # From (0.2, 0, 0.15) to (-0.2, 0, 0.15) past the left support.
    assert nearest(found) == pytest.approx(0.15)
    fast = scene({"ends.motion": [["0 s", "0 m", "0 m"], ["1 ms", "0 m", "0 m", "10 m"]]})
    assert [fault.path for fault in outrunning_faults(fast)] == ["ends.motion"]


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


def in_space(name: str, changes: dict[str, Any] = SPATIAL) -> list[str]:
    """Load a bundled scene in three dimensions, and return the paths of its faults."""
    with pytest.raises(SceneError) as caught:
        load_scene(name, changes)
    return [fault.path for fault in caught.value.faults]


def test_laws_and_models_of_the_plane_are_refused() -> None:
    small = {**scene_of("elastic").given(), "model": "small-deflection"}
    assert [fault.path for fault in faults_of(spoiled(SPATIAL, small))] == ["model"]
    assert "material.law" in in_space("polymer-thread")
    assert "material.structure" in in_space("printed-lintel")
    assert "material.natural_strain" in in_space("solvent-cast-strand")
    assert "temperature" in in_space("glass-fibre")
    assert "material.viscosity" in in_space("solvent-cast-strand")
    assert in_space("drying-ink") == ["initial.C"]
    syrup = {**BINGHAM, "material": {"law": "newtonian", **LAWS["newtonian"]}}
    assert not faults_of(spoiled(SPATIAL, syrup))
    for changes in ({"filament.twist": "1 1/m"}, {"initial.centreline": BENT}):
        assert [fault.path for fault in faults_of(spoiled(changes, syrup))] == list(changes)


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


@pytest.mark.parametrize("asked", ["paper", ["inertia", "viscous-flow", "yielding"], ["extensibility"]])
def test_lists_without_them_are_one_error(asked: Any) -> None:
    with pytest.raises(SceneError) as caught:
        choose_effects(scene({**ASIDE, "run.effects": asked}))
    (fault,) = caught.value.faults
    assert fault.path == "run.effects"
    assert "'shear'" in fault.found and "three dimensions: load.direction" in fault.found
    assert "'fibres'" in fault.accepted


def test_a_filament_let_go_from_a_curve_has_inertia() -> None:
    curve = {"initial.centreline": BENT, "load.gravity": "0 m/s^2"}
    assert "inertia" in choose_effects(scene(curve)).names
    with pytest.raises(SceneError, match=r"without 'inertia', but initial\.centreline need not"):
        choose_effects(scene({**curve, "run.effects": [*IN_SPACE, "viscous-flow", "yielding"]}))


def test_a_filament_that_begins_on_a_curve_need_not_hang() -> None:
    """What is longer than its supports are apart needs a weight to hang in, unless it is said where it begins."""
    weightless = {"filament.rest_length": "0.21 m", "load.gravity": "0 m/s^2"}
    assert [fault.path for fault in faults_of(spoiled(weightless))] == ["load.gravity"]
    assert not faults_of(spoiled({**weightless, "initial.centreline": BENT}))


def test_rotary_inertia_cannot_be_named() -> None:
    with pytest.raises(SceneError, match="'rotary-inertia' cannot be had: in three dimensions"):
        names = [*IN_SPACE, "inertia", "viscous-flow", "yielding", "rotary-inertia"]
        choose_effects(scene({**ASIDE, "run.effects": names}))


def test_a_stretch_at_which_sections_turn_by_themselves_is_refused() -> None:
    rubber = {**BINGHAM, "material": {"law": "elastic", **LAWS["elastic"]}}
    stretched = {"initial.stretch": 2.0, "initial.relaxed": False}
    assert "shear" not in choose_effects(scene(stretched, rubber)).names
    with pytest.raises(SceneError, match=r"initial.stretch: stretched elastically 2 times"):
        choose_effects(scene({**stretched, **ASIDE}, rubber))
    drawn = {"ends.motion": [["0 s", "0 m", "0 m"], ["1 s", "0.2 m", "0 m", "1 mm"]]}
    with pytest.raises(SceneError, match=r"ends.motion: stretched elastically 2 times"):
        choose_effects(scene(drawn, rubber))


@pytest.mark.parametrize("gravity", ["9.81 m/s^2", "0 m/s^2"])
@pytest.mark.parametrize("changes", [changes for changes, _ in CASES])
def test_forecasts_of_every_scene_are_numbers(changes: dict[str, Any], gravity: str) -> None:
    found = scene({**changes, "load.gravity": gravity})
    motion = forecast(found)
    assert math.isfinite(motion.sag) and math.isfinite(motion.missed)
    effects = choose_effects(found)
    assert expected_regime(found, effects.names).name
    assert isinstance(theory_limits(found, effects.names, effects.terms()), tuple)


def test_inertia_is_taken_in_where_an_end_is_pulled_or_turned() -> None:
    still = {"load.gravity": "0 m/s^2"}
    for changes in ({"ends.right_twist": TURNS}, {**FREE, "load.tip_force": ["0 N", "0 N", "1 mN"]}):
        assert "inertia" in choose_effects(scene({**still, **changes})).names


def test_a_mass_at_the_tip_bends_a_cantilever_as_theory_says() -> None:
    # Of E I w'' = M: q L^4/(8 E I) under its weight, and P L^3/(3 E I) under a force at its end.
    light = scene(
        {**FREE, "filament.thickness": "1 mm"}, {**BINGHAM, "material": {"law": "elastic", **LAWS["elastic"]}}
    )
    mass = light.filament.density * light.filament.thickness * light.filament.width * light.filament.span
    heavy = light.replace({"load.tip_mass": f"{mass!r} kg"})
    assert load_factor(heavy) == pytest.approx(1 + (1 / 3) / (1 / 8))
    assert load_factor(light) == 1


# What is explained.
def test_explain_says_the_dimensions() -> None:
    planar = explain(scene({}))
    assert (planar.dimensions, planar.dimensions_reason) == (2, "everything lies in one plane")
    assert planar.to_dict()["dimensions"] == 2
    for verbose in (False, True):
        out = Console(file=io.StringIO(), width=120)
        print_explanation(planar, out, verbose=verbose)
        assert "2, everything lies in one plane" in out.file.getvalue()  # type: ignore[attr-defined]


def test_bundled_scenes_are_spatial_only_where_something_leaves_the_plane() -> None:
    spatial = {"coil-spring", "hanging-curl", "overtwisted-rod", "windy-ink", "wrung-thread"}
    assert {name for name in bundled_names() if is_spatial(load_scene(name))} == spatial
