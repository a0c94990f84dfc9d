"""Scenes: files, units, TOML there and back, overrides, and keys that do not go together."""

from __future__ import annotations

import copy
import math
import pickle
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from softcat_sym.errors import SceneError
from softcat_sym.scene.bundled import bundled_names, bundled_text
from softcat_sym.scene.parts import Filament
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import (
    Scene,
    is_symmetric,
)
from softcat_sym.scene.tables import farthest, nearest
from softcat_sym.scene.units import COMMON, measured_by_pint
from tests.common.scenes import BINGHAM, LAWS, faults_of, refused, spoiled


# Files, units, and TOML there and back.
def test_a_bad_file_is_one_clear_error(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    for content, says in [
        (b"", "the file is empty"),
        (b"# nothing but a comment\n\n", "the file is empty"),
        (b"[filament]\nspan = 0.2 m\n", "not TOML: "),
        (b"[filament]\nspan = 0.2 m\n", "line 2"),
        (b"span\n", "not TOML"),
        (b"a = 1\na = 2\n", "not TOML"),
        (b'title = "\xff"\n', "not UTF-8 text (line 1)"),
        (b"a = " + b"9" * 5000, "not TOML"),
        (b"a = " + b"[" * 20000, "not TOML"),
        (b"#" * 2_000_000, "longer than 1 MiB"),
        (b"\x00\x01", "not TOML"),
    ]:
        path.write_bytes(content)
        text = refused(path)
        assert says in text and str(path) in text, text


def test_a_bundled_scene_is_found_by_name_and_a_file_by_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("no-yield").write_text("")
    assert load_scene("no-yield").title
    assert "empty" in refused("./no-yield")
    marked = tmp_path / "marked.toml"
    marked.write_bytes(b"\xef\xbb\xbf" + bundled_text("no-yield").replace("\n", "\r\n").encode())
    assert load_scene(str(marked)) == load_scene("no-yield")


def test_millimetres_and_metres_are_the_same_scene() -> None:
    metres = spoiled({"filament.span": "0.2 m", "filament.thickness": "0.006 m", "run.duration": "2 s"})
    millimetres = spoiled({"filament.span": "200 mm", "filament.thickness": "6 mm", "run.duration": "2000 ms"})
    other = spoiled({"material.youngs_modulus": "4 N/mm^2", "filament.density": "1.9 g/cm³"})
    assert Scene.model_validate(metres) == Scene.model_validate(millimetres) == Scene.model_validate(other)
    assert Scene.model_validate(metres).to_toml() == Scene.model_validate(millimetres).to_toml()


def test_python_values() -> None:
    ureg = pint.UnitRegistry()
    table = spoiled(
        {
            "filament.span": ureg.Quantity(200, "mm"),
            "filament.thickness": ureg.Quantity(np.float64(6.0), "mm"),
            "run.frames": np.int64(201),
            "run.accuracy": np.float32(0.5),
            "ends.left_angle": "0 deg",
        }
    )
    before = copy.deepcopy(table)
    scene = Scene.model_validate(table)
    assert table == before
    assert scene.replace({"run.accuracy": 0.01}) == Scene.model_validate(BINGHAM)
    assert type(scene.filament.thickness) is float
    assert type(scene.run.frames) is int
    assert Scene.model_validate(scene) is scene
    parts = {name: getattr(scene, name) for name in ("filament", "material", "run")}
    assert Scene.model_validate(parts) == scene
    assert Scene(**parts) == scene
    assert isinstance(parts["filament"], Filament)
    assert pickle.loads(pickle.dumps(scene)) == scene
    with pytest.raises(ValueError, match="frozen"):
        scene.filament.span = 1.0  # type: ignore[misc]


positive = st.floats(1e-12, 1e12)


@st.composite
def tables(draw: st.DrawFn) -> dict[str, Any]:
    span = draw(positive)
    law = draw(st.sampled_from(["elastic", "maxwell", "bingham"]))
    constants: dict[str, Any] = {"youngs_modulus": f"{draw(positive)!r} {draw(st.sampled_from(['Pa', 'kPa', 'psi']))}"}
    if law != "elastic":
        constants[draw(st.sampled_from(["viscosity", "shear_viscosity"]))] = f"{draw(positive)!r} cP"
    if law == "bingham":
        constants[draw(st.sampled_from(["yield_stress", "shear_yield_stress"]))] = f"{draw(positive)!r} mbar"
    section = draw(st.sampled_from(["rectangle", "circle"]))
    filament = {
        "span": f"{span!r} m",
        "thickness": f"{span * draw(st.floats(1e-6, 0.99))!r} m",
        "density": f"{draw(positive)!r} g/cm^3",
        "section": section,
    }
    if section == "rectangle" and draw(st.booleans()):
        filament["width"] = f"{draw(positive)!r} inch"
    end = st.sampled_from(["clamped", "pinned"])
    words = st.sampled_from(["auto", "paper"])
    some = st.just(0.0) | st.floats(1e-6, 1e6)
    numerics: dict[str, Any] = {"cells": 40, "rtol": 1e-7, "solver": "idas", "order": 1, "backend": "interpreted"}
    return {
        "title": draw(st.text(st.characters(exclude_categories=("Cs", "Cc")), max_size=20)),
        "filament": filament,
        "material": {"law": law} | constants,
        "ends": {"left": draw(end), "right": draw(end)},
        "load": {"gravity": f"{draw(some)!r} m/s^2", "ramp": f"{draw(some)!r} min"},
        "surroundings": {"surface_tension": f"{draw(some)!r} mN/m"},
        "run": {
            "duration": f"{draw(positive)!r} hour",
            "frames": draw(st.integers(2, 1000)),
            "accuracy": draw(st.floats(1e-12, 0.999)),
            "effects": draw(words | st.lists(st.text(max_size=5), min_size=1, max_size=3, unique=True)),
            "closure": draw(st.sampled_from(["material", "printed"])),
        },
        "numerics": draw(st.fixed_dictionaries({}, optional={key: st.just(value) for key, value in numerics.items()})),
    }


@given(tables())
@settings(max_examples=200, deadline=None)
def test_toml_there_and_back_is_the_identity(table: dict[str, Any]) -> None:
    scene = Scene.model_validate(table)
    text = scene.to_toml()
    again = Scene.model_validate(tomllib.loads(text))
    assert again == scene
    assert hash(again) == hash(scene)
    assert scene.replace({}) == scene


def test_bundled_scenes_there_and_back(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    for name in bundled_names():
        scene = load_scene(name)
        path.write_text(scene.to_toml(), encoding="utf-8")
        assert load_scene(path) == scene, name
        # What follows another value still follows it in the resolved file.
        thin = load_scene(path, ["filament.thickness=0.1 mm"]).filament
        follows = scene.filament.width == scene.filament.thickness
        assert thin.width == (1e-4 if follows else scene.filament.width), name


# Overrides from the command line, and replacements in Python.
def test_overrides_are_toml_or_text() -> None:
    texts = ["run.effects=paper", "numerics.cells=40", "groups.G=0.3", "title = a = b", "run.closure='printed'"]
    scene = load_scene("arrested-overdamped", texts)
    assert (scene.run.effects, scene.numerics.cells, scene.title) == ("paper", 40, "a = b")
    assert scene.run.closure == "printed"
    assert scene.material.yield_stress == pytest.approx(1900 * 9.81 * 0.2 / 0.3)
    assert scene == load_scene(
        "arrested-overdamped",
        dict(text.split("=", 1) for text in texts[:3]) | {"title": "a = b", "run.closure": "printed"},
    )
    listed = load_scene("no-yield", ['run.effects=["inertia", "bending"]'])
    assert listed.run.effects == ("inertia", "bending")


def test_a_bad_override_is_one_clear_error() -> None:
    for override, says in [
        ("numerics.cells", "--set: 'numerics.cells' sets nothing"),
        ("=3", "--set: '=3' sets nothing"),
        ("numerics..cells=3", "leads to no key"),
        ("title.x=3", "title.x: leads to no key"),
        ("run.duration=2", "run.duration: 2 has no unit"),
        ("run.duraton=2 s", "run.duraton: unknown key (did you mean 'duration'?)"),
        ("numerics.cells=4\n[x]", "numerics.cells: '4\\n[x]' is not a whole number"),
        ("run.accuracy=nan", "run.accuracy: nan is not finite"),
        ("groups.V=-1", "groups.V: -1 is out of range"),
        ("nosuch.table=1", "nosuch: unknown key"),
    ]:
        assert says in refused("arrested-overdamped", [override])


def test_replace() -> None:
    scene = Scene.model_validate(BINGHAM)
    other = scene.replace({"numerics.cells": 40, "material.yield_stress": "5 kPa", "filament.thickness": "3 mm"})
    assert (other.numerics.cells, other.material.yield_stress, other.filament.width) == (40, 5e3, 3e-3)
    assert scene.numerics.cells is None
    assert other.replace({"numerics.cells": None}).numerics.cells is None
    assert scene.replace({}) == scene
    assert hash(scene.replace({})) == hash(scene)
    assert scene != other
    with pytest.raises(SceneError, match="a resolved scene has no groups"):
        scene.replace({"groups.G": 0.3})
    with pytest.raises(SceneError, match="unknown key"):
        scene.replace({"numerics.cell": 40})


# load.shake and load.shake_frequency: a pair, in cycles a second; a scene without them is written without them.
PAIR = {"load.shake": 0.5, "load.shake_frequency": "9 Hz"}


def shaken(changes: dict[str, Any], name: str = "gelatin-strand") -> Scene:
    return load_scene(name, changes)


@pytest.mark.parametrize("missing", PAIR)
def test_one_without_the_other_is_one_fault(missing: str) -> None:
    (given,) = set(PAIR) - {missing}
    with pytest.raises(SceneError) as caught:
        shaken({given: PAIR[given]})
    (fault,) = caught.value.faults
    assert fault.path == missing
    assert given in fault.found
    assert given in fault.accepted


def test_a_frequency_counts_cycles() -> None:
    for text in ["9 Hz", "0.009 kHz", "9 1/s", "540 1/min"]:
        assert shaken(PAIR | {"load.shake_frequency": text}).load.shake_frequency == pytest.approx(9, rel=1e-15)


# Keys that are sound alone and do not go together: each pair one fault at its path, all at once.
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
      if law not in ("elastic", "maxwell")],
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


# The units that are known without pint are pint's, to the last bit; scenes written in them never load it.
def test_each_is_what_pint_measures() -> None:
    for unit in COMMON:
        assert COMMON[unit] == measured_by_pint(unit, "one of mass, length and time")
