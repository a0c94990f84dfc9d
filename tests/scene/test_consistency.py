"""Keys that are sound alone and do not go together: each pair one fault at its path, all at once."""

from __future__ import annotations

import math
import tomllib
from typing import Any

import pytest

from softcat_sym.scene.parts import farthest, nearest
from softcat_sym.scene.scene import (
    Scene,
    chord_angle,
    distance,
    is_slack,
    is_symmetric,
    rest_length,
    stress_free_length,
    undeformed_area,
)

from .tables import faults_of, spoiled
from .test_material import LAWS


def table(law: str = "maxwell", **changes: Any) -> dict[str, Any]:
    """A scene of one law with `table__key` set."""
    return spoiled({"material": {"law": law} | LAWS[law]} | {k.replace("__", "."): v for k, v in changes.items()})


def scene_of(law: str = "maxwell", **changes: Any) -> Scene:
    return Scene.model_validate(table(law, **changes))


def path(*rows: tuple[float, float, float]) -> list[list[str]]:
    """A motion in s and cm."""
    return [[f"{time} s", f"{dx} cm", f"{dy} cm"] for time, dx, dy in rows]


BOTH_FREE = {"ends__left": "free", "ends__right": "free"}
OUT = path((0, 0, 0), (1, 40, 0))
SLACK = {"filament__rest_length": "0.3 m"}

# Each with the path and the words of its one fault.
BAD: list[tuple[str, dict[str, Any], str, str]] = [
    ("maxwell", BOTH_FREE, "ends", "both ends are free"),
    ("maxwell", {"ends__left": "pinned", "ends__left_angle": "5 deg"}, "ends.left_angle", "the left end is pinned"),
    ("maxwell", {"ends__right": "free", "ends__right_angle": "5 deg"}, "ends.right_angle", "the right end is free"),
    ("maxwell", {"ends__right": "free", "ends__drop": "1 cm"}, "ends.drop", "one end is free"),
    ("maxwell", {"ends__right": "free", "ends__motion": OUT}, "ends.motion", "the right end is free"),
    ("maxwell", {"ends__motion": path((-1, 0, 0), (1, 1, 0))}, "ends.motion", "a row at -1 s, before the start"),
    ("maxwell", {"ends__motion": path((0, 0, 0), (1, 1, 0), (1, 2, 0))}, "ends.motion", "a row at 1 s after one at 1"),
    ("maxwell", {"ends__motion": path((0, 0, 0), (2, 1, 0), (1, 2, 0))}, "ends.motion", "a row at 1 s after one at 2"),
    ("maxwell", {"ends__motion": path((0, 1, 0))}, "ends.motion", "the first row, at 0 s, moves the support at once"),
    ("maxwell", {"ends__motion": path((0, 0, 0), (1, -19.5, 0))}, "ends.motion", "within 0.005 m of each other"),
    ("maxwell", {"ends__motion": path((0, 0, 0), (1, -40, 0.1))}, "ends.motion", "within 0.0005"),
    *[(law, {"ends__motion": OUT}, "ends.motion", "3 times the rest length 0.2 m: beyond") for law in LAWS if law in (
        "elastic", "kelvin-voigt", "standard-linear")],
    ("elastic", {"filament__rest_length": "7 cm"}, "filament.rest_length", "2.857 times the rest length"),
    ("elastic", {"initial__stretch": 2.8, "initial__relaxed": False}, "initial.stretch", "2.8 times the rest length"),
    ("elastic", {"ends__drop": "60 cm", "filament__rest_length": "0.2 m"}, "filament.rest_length", "3.162 times"),
    ("newtonian", SLACK, "material.law", "a fluid has no shape to start from"),
    ("maxwell", SLACK | {"load__ramp": "1 s"}, "load.ramp", "hangs in its weight from the start"),
    ("maxwell", SLACK | {"load__gravity": "0 m/s^2"}, "load.gravity", "nothing tells what shape it has"),
    ("maxwell", SLACK | {"initial__P": [0.1]}, "initial.P", "the filament is slack (0.3 m over 0.2 m)"),
    ("maxwell", SLACK | {"initial__C": [0.1]}, "initial.C", "the filament is slack"),
    *[(law, {"initial__stretch": 1.1}, "initial.relaxed", f"true with a stretch, but the law '{law}' does not flow")
      for law in ("elastic", "kelvin-voigt", "standard-linear")],
    ("maxwell", {"initial__stretch": 1.1, "initial__relaxed": False, "filament__rest_length": "0.19 m"},
     "initial.stretch", "1.1, but filament.rest_length is 0.19 m"),
    *[(law, {"initial__P": [0.1]}, "initial.P", f"the law '{law}' has no plastic strain")
      for law in ("elastic", "newtonian", "kelvin-voigt", "standard-linear")],
    ("elastic", {"initial__C": [0.1, 0.2]}, "initial.C", "has no plastic strain"),
    ("newtonian", {"filament__curvature": "1 1/m"}, "filament.curvature", "no elastic shape to start from"),
    ("newtonian", {"ends__left_angle": "1 deg"}, "ends.left_angle", "a clamp at 1 deg off the line"),
    ("newtonian", {"ends__left": "pinned", "ends__drop": "1 cm"}, "ends.right_angle", "at -2.862 deg"),
    *[(law, {"model": "small-deflection"}, "material.law", f"'{law}' with model 'small-deflection'") for law in LAWS
      if law not in ("elastic", "maxwell", "bingham", "herschel-bulkley")],
    *[("maxwell", {"model": "small-deflection", key: value}, key.replace("__", "."), "with model 'small-deflection'")
      for key, value in {
        "filament__rest_length": "0.19 m", "filament__profile": [1, 1.1], "filament__curvature": "1 1/m",
        "ends__drop": "1 cm", "ends__left_angle": "1 deg", "ends__right_angle": "1 deg", "ends__right": "free",
        "ends__motion": path((0, 0, 0), (1, 1, 0)), "initial__stretch": 1.1, "initial__P": [0.1], "initial__C": [0.1],
        "filament__section": "sheet"}.items()],
]  # fmt: skip


def test_what_does_not_go_together_is_one_fault() -> None:
    for law, changes, where, says in BAD:
        (fault,) = faults_of(table(law, **changes))
        assert fault.path == where
        assert says in str(fault)
        assert fault.accepted


def test_all_come_at_once() -> None:
    bad = {"ends__drop": "1 cm", "ends__left_angle": "1 deg", "filament__curvature": "1 1/m", "initial__C": [1.0]}
    faults = faults_of(table("newtonian", **bad))
    paths = [fault.path for fault in faults]
    assert paths == ["initial.C", "filament.curvature", "ends.left_angle", "ends.right_angle"]


SINGLE: list[tuple[dict[str, Any], str, str]] = [
    ({"filament__profile": [1.0]}, "filament.profile", "a list of 1; accepted: a list of positive numbers without un"),
    ({"filament__profile": [1.0, 0.0]}, "filament.profile", "0.0 is out of range"),
    ({"filament__profile": [1.0, -1.0]}, "filament.profile", "-1.0 is out of range"),
    ({"filament__profile": ["1 mm", "2 mm"]}, "filament.profile", "'1 mm' is not a number"),
    ({"filament__profile": 1.0}, "filament.profile", "1.0 is not a list"),
    ({"filament__rest_length": "0 m"}, "filament.rest_length", "is zero"),
    ({"filament__curvature": "1 m"}, "filament.curvature", "'m' is a length, not a curvature"),
    ({"ends__left_angle": "180 deg"}, "ends.left_angle", "is half a turn or more"),
    ({"ends__right_angle": "-4 rad"}, "ends.right_angle", "accepted: an angle between -180 deg and 180 deg"),
    ({"ends__left_angle": 3}, "ends.left_angle", "3 has no unit"),
    ({"ends__motion": "go"}, "ends.motion", "'go' is not a list of rows"),
    ({"ends__motion": [3]}, "ends.motion", "3 is not a row [time, dx, dy]"),
    ({"ends__motion": [["0 s", "0 m"]]}, "ends.motion", "is not a row"),
    ({"ends__motion": [["0 m", "0 m", "0 m"]]}, "ends.motion", "'m' is a length, not a time"),
    ({"ends__motion": [["0 s", 0, "0 m"]]}, "ends.motion", "0 has no unit"),
    ({"initial__stretch": 0}, "initial.stretch", "0 is out of range"),
    ({"initial__relaxed": "no"}, "initial.relaxed", "is neither true nor false"),
    ({"initial__P": [math.nan]}, "initial.P", "nan is not finite"),
    ({"load__point_mass": "-1 g"}, "load.point_mass", "is negative"),
    ({"load__point_mass": "1 N"}, "load.point_mass", "not a mass"),
]


def test_one_bad_value_is_one_fault() -> None:
    for changes, where, says in SINGLE:
        (fault,) = faults_of(table(**changes))
        assert fault.path == where
        assert says in str(fault)


GOOD: list[tuple[str, dict[str, Any]]] = [
    ("maxwell", {"ends__right": "free"}),
    ("maxwell", {"ends__left": "free", "ends__right": "pinned"}),
    ("maxwell", {"ends__motion": OUT}),
    ("maxwell", {"ends__motion": "hold"}),
    ("elastic", {"ends__motion": path((0, 0, 0), (1, 34, 0), (2, -10, 3))}),
    ("maxwell", {"filament__rest_length": "7 cm"}),
    ("bingham", {"initial__P": [0.1, 0.2], "initial__C": [-0.1]}),
    ("maxwell", {"initial__stretch": 1.5}),
    ("elastic", {"initial__stretch": 1.5, "initial__relaxed": False}),
    ("elastic", {"initial__stretch": 1.25, "initial__relaxed": False, "filament__rest_length": "0.16 m"}),
    ("elastic", {"filament__rest_length": "0.16 m"}),
    ("bingham", SLACK | {"load__point_mass": "3 g"}),
    ("kelvin-voigt", {"filament__profile": [1, 2, 0.5], "filament__curvature": "-3 1/m"}),
    ("newtonian", {"ends__drop": "0.2 m", "ends__left_angle": "-45 deg", "ends__right_angle": "-45 deg"}),
    ("newtonian", {"ends__right": "free", "ends__left_angle": "-45 deg"}),
    ("bingham", {"model": "small-deflection"}),
    ("maxwell", {"model": "small-deflection", "load__point_mass": "1 g", "ends__left": "pinned"}),
    ("maxwell", {"filament__section": "sheet", "filament__width": "10 cm"}),
]


def test_what_goes_together_is_taken_and_comes_back_from_toml() -> None:
    for law, changes in GOOD:
        scene = scene_of(law, **changes)
        again = Scene.model_validate(tomllib.loads(scene.to_toml()))
        assert again == scene
        assert hash(again) == hash(scene)
        assert scene.replace({}) == scene


def test_the_path_of_a_support() -> None:
    scene = scene_of(ends__drop="10 cm", ends__motion=path((0, 0, 0), (1, -10, 20), (3, -30, -10)))
    assert scene.ends.motion == ((0.0, 0.0, 0.0), (1.0, -0.1, 0.2), (3.0, -0.3, -0.1))
    assert farthest(scene) == pytest.approx(math.hypot(0.2, 0.1))
    # From (0.1, 0.1) to (-0.1, -0.2): the foot of the perpendicular lies on the path.
    assert nearest(scene) == pytest.approx(abs(0.1 * -0.3 - 0.1 * -0.2) / math.hypot(0.2, 0.3))
    assert (nearest(scene_of()), farthest(scene_of())) == (0.2, 0.2)


def test_lengths() -> None:
    scene = scene_of(filament__span="3 m", ends__drop="4 m", initial__stretch=1.25)
    assert (distance(scene), rest_length(scene), stress_free_length(scene)) == (5.0, 4.0, 5.0)
    assert not is_slack(scene)
    elastic = scene.replace({"initial.relaxed": False})
    assert (rest_length(elastic), stress_free_length(elastic)) == (4.0, 4.0)
    given = scene.replace({"filament.rest_length": "4.5 m"})
    assert (rest_length(given), stress_free_length(given), is_slack(given)) == (4.5, 5.625, True)
    assert not is_slack(given.replace({"ends.right": "free", "ends.drop": None}))
    assert not is_slack(scene_of(filament__rest_length="200 mm"))
    assert is_slack(scene_of(filament__rest_length="200.1 mm"))
    assert chord_angle(scene) == pytest.approx(-math.atan2(4, 3))
    assert chord_angle(scene.replace({"ends.drop": "-4 m"})) == pytest.approx(math.atan2(4, 3))


def test_symmetry() -> None:
    for changes, symmetric in [
        ({}, True),
        ({"ends__left": "pinned"}, False),
        ({"ends__left": "pinned", "ends__right": "pinned"}, True),
        ({"ends__left_angle": "-10 deg", "ends__right_angle": "10 deg"}, True),
        ({"ends__left_angle": "10 deg", "ends__right_angle": "10 deg"}, False),
        ({"ends__drop": "1 mm"}, False),
        ({"ends__right": "free"}, False),
        ({"ends__motion": path((0, 0, 0), (1, 1, 0))}, False),
        ({"filament__profile": [1, 2, 1]}, True),
        ({"filament__profile": [1, 2]}, False),
        ({"initial__P": [0.1]}, True),
        ({"initial__P": [0.1, 0.2]}, False),
        ({"initial__C": [0.1, 0.2, 0.1]}, True),
        ({"initial__C": [0.1, -0.1]}, False),
        ({"filament__curvature": "3 1/m", "load__point_mass": "1 g"}, True),
        (SLACK, True),
    ]:
        assert is_symmetric(scene_of(**changes)) is symmetric


def test_the_undeformed_area() -> None:
    assert undeformed_area(scene_of()) == pytest.approx(0.006**2)
    assert undeformed_area(scene_of(filament__width="2 mm")) == pytest.approx(0.006 * 0.002)
    assert undeformed_area(scene_of(filament__section="sheet", filament__width="1 m")) == pytest.approx(0.006)
    assert undeformed_area(scene_of(filament__section="circle")) == pytest.approx(math.pi * 0.006**2 / 4)
