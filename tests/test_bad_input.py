"""Bad input: each mistake is one clear fault at its path, all of them come at once, and nothing is written."""

from __future__ import annotations

import json
import math
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

from .cli.in_process import Softcat, sets
from .scene.tables import BINGHAM, faults_of, spoiled

BAD: list[tuple[dict[str, Any], str, str]] = [
    ({"filament.spam": "0.2 m"}, "filament.spam", "unknown key (did you mean 'span'?)"),
    ({"filaments": {}}, "filaments", "unknown key (did you mean 'filament'?)"),
    ({"material.density": "1 kg/m^3"}, "material.density", "did you mean 'filament.density'?"),
    ({"filament.zzzz": 1}, "filament.zzzz", "unknown key; accepted: span, "),
    ({"duration": "2 s"}, "duration", "did you mean 'run.duration'?"),
    ({"material.law": "binghamm"}, "material.law", "did you mean 'bingham'?"),
    (
        {"material.law": "Bingham"},
        "material.law",
        "accepted: elastic, maxwell, newtonian, kelvin-voigt, standard",
    ),
    ({"material.law": 3}, "material.law", "3 is not a name"),
    ({"material.law": None}, "material.law", "missing"),
    ({"filament.section": "rectange"}, "filament.section", "did you mean 'rectangle'?"),
    ({"ends.left": "clampd"}, "ends.left", "did you mean 'clamped'?"),
    ({"run.closure": "materiel"}, "run.closure", "did you mean 'material'?"),
    ({"run.closure": "quux"}, "run.closure", "accepted: material, printed"),
    ({"numerics.solver": "cvode"}, "numerics.solver", "did you mean 'cvodes'?"),
    ({"numerics.backend": "interpret"}, "numerics.backend", "did you mean 'interpreted'?"),
    ({"model": "filamant"}, "model", "did you mean 'filament'?"),
    ({"filament.span": 0.2}, "filament.span", '0.2 has no unit; accepted: a positive length with its unit, such as "0'),
    ({"filament.span": "0.2"}, "filament.span", "has no unit"),
    ({"filament.span": 1}, "filament.span", "1 has no unit"),
    ({"filament.span": True}, "filament.span", "true is not a quantity"),
    ({"filament.span": ["0.2 m"]}, "filament.span", "is not a quantity"),
    ({"filament.span": {"m": 2}}, "filament.span", "a table is not a quantity"),
    ({"filament.span": ""}, "filament.span", "'' is not a number with a unit"),
    ({"filament.span": "m"}, "filament.span", "not a number with a unit"),
    ({"filament.span": "5 kPa"}, "filament.span", "'kPa' is a stress, not a length"),
    ({"filament.span": "5 K"}, "filament.span", "'K' is of dimension [temperature], not a length"),
    ({"filament.span": "20 degC"}, "filament.span", "'degC' is of dimension"),
    ({"filament.span": "5 metrs"}, "filament.span", "unknown unit 'metrs'"),
    ({"filament.span": "5 m)"}, "filament.span", "unknown unit 'm)'"),
    ({"filament.span": "5 -"}, "filament.span", "unknown unit '-'"),
    ({"filament.span": "1,5 m"}, "filament.span", "unknown unit ',5 m'"),
    ({"filament.span": "1 000 m"}, "filament.span", "unknown unit '000 m'"),
    ({"filament.span": "0 m"}, "filament.span", "is zero"),
    ({"filament.span": "-1 m"}, "filament.span", "is negative"),
    ({"filament.span": "nan m"}, "filament.span", "'nan m' is not finite"),
    ({"filament.span": math.nan}, "filament.span", "nan has no unit"),
    ({"filament.span": "inf m"}, "filament.span", "'inf m' is not finite"),
    ({"filament.span": "1e308 km"}, "filament.span", "is not finite"),
    ({"filament.span": "1e999 m"}, "filament.span", "is not finite"),
    ({"filament.span": None}, "filament.span", 'missing; accepted: a positive length with its unit, such as "0.2 m"'),
    ({"filament.span": pint.Quantity(1.0, "s")}, "filament.span", "is a time, not a length"),
    ({"filament.span": pint.Quantity(math.nan, "m")}, "filament.span", "nan is not finite"),
    ({"filament.density": "-1900 kg/m^3"}, "filament.density", "is negative; accepted: a positive density"),
    ({"filament.thickness": "0 mm"}, "filament.thickness", "'0 mm' is zero"),
    ({"filament.thickness": "0.2 m"}, "filament.thickness", "not less than the span; accepted: a thickness below"),
    ({"filament.thickness": "1 m"}, "filament.thickness", "not less than the span"),
    ({"filament.width": "-1 mm"}, "filament.width", "is negative"),
    ({"filament.section": "circle", "filament.width": "1 mm"}, "filament.width", "a circle has no width"),
    ({"filament": 3}, "filament", "3 is not a table; accepted: a table [filament]"),
    ({"ends": []}, "ends", "[] is not a table"),
    ({"title": 3}, "title", "3 is not text"),
    ({"material.youngs_modulus": None}, "material.youngs_modulus", "missing: the law 'bingham' needs it"),
    ({"material.viscosity": None}, "material.viscosity", "missing: the law 'bingham' needs it"),
    ({"material.yield_stress": None}, "material.yield_stress", "missing: the law 'bingham' needs it"),
    ({"material.viscosity": "9 kPa"}, "material.viscosity", "'kPa' is a stress, not a viscosity"),
    ({"material.yield_stress": "inf Pa"}, "material.yield_stress", "is not finite"),
    (
        {"material.shear_yield_stress": "5 kPa"},
        "material.yield_stress",
        "given twice, here and as material.shear_yield_stress",
    ),
    ({"material.shear_viscosity": "5 Pa s"}, "material.viscosity", "given twice, here and as material.shear_viscosity"),
    ({"load.gravity": "-9.81 m/s^2"}, "load.gravity", "is negative; accepted: a non-negative acceleration"),
    ({"load.gravity": 9.81}, "load.gravity", "9.81 has no unit"),
    ({"load.ramp": "-1 s"}, "load.ramp", "is negative"),
    ({"surroundings.surface_tension": "-1 N/m"}, "surroundings.surface_tension", "is negative"),
    ({"run.duration": "0 s"}, "run.duration", "is zero; accepted: a positive time"),
    ({"run.duration": None}, "run.duration", "missing"),
    ({"run.frames": -3}, "run.frames", "-3 is out of range; accepted: a whole number from 2"),
    ({"run.frames": 1}, "run.frames", "1 is out of range"),
    ({"run.frames": 2.5}, "run.frames", "2.5 is not a whole number"),
    ({"run.frames": True}, "run.frames", "true is not a whole number"),
    ({"run.frames": 10**12}, "run.frames", "out of range"),
    ({"run.accuracy": 0}, "run.accuracy", "accepted: a number between 0 and 1, both excluded"),
    ({"run.accuracy": 1.0}, "run.accuracy", "out of range"),
    ({"run.accuracy": math.nan}, "run.accuracy", "nan is not finite"),
    ({"run.accuracy": math.inf}, "run.accuracy", "inf is not finite"),
    ({"run.accuracy": 10**400}, "run.accuracy", "is not finite"),
    ({"run.accuracy": "1e-3"}, "run.accuracy", "'1e-3' is not a number"),
    ({"run.effects": "papers"}, "run.effects", "did you mean 'paper'?"),
    ({"run.effects": 3}, "run.effects", "3 is not a list of names"),
    ({"run.effects": ["inertia", 3]}, "run.effects", "is not a list of names"),
    ({"run.effects": ["inertia", "inertia"]}, "run.effects", "'inertia' named twice"),
    ({"numerics.cells": 3}, "numerics.cells", "3 is out of range; accepted: a whole number from 4"),
    ({"numerics.rtol": -1e-3}, "numerics.rtol", "out of range"),
    ({"title": "a\0b"}, "title", "holds a control character"),
    ({"title": "a\x1b[2J"}, "title", "holds a control character"),
    ({"numerics.order": 2, "numerics.fibres": 8}, "numerics.order", "2, but numerics.fibres is 8"),
    ({"material.yield_stress": "1e-300 Pa"}, "material.yield_stress", "beyond 1e-30 to 1e+30 in SI units"),
    ({"filament.rest_length": "1e9 km"}, "filament.rest_length", "times the distance of the supports"),
]


def test_one_bad_value_is_one_fault() -> None:
    for changes, path, says in BAD:
        faults = faults_of(spoiled(changes))
        if changes == {"filament": 3}:
            faults = faults[:1]
        assert [fault.path for fault in faults] == [path], changes
        assert says in str(faults[0]), changes


@pytest.mark.parametrize(
    ("law", "given_but_unused"),
    [("elastic", ["viscosity", "yield_stress"]), ("maxwell", ["yield_stress"])],
)
def test_a_constant_that_the_law_does_not_use_is_refused(law: str, given_but_unused: list[str]) -> None:
    faults = faults_of(spoiled({"material.law": law}))
    assert [fault.path for fault in faults] == [f"material.{name}" for name in given_but_unused]
    assert all(f"the law '{law}' does not" in fault.found for fault in faults)


def test_every_fault_of_a_bad_scene_is_listed() -> None:
    bad = {
        "filament.span": "0.2",
        "filament.density": "-1 kg/m^3",
        "filament.colour": "red",
        "material.yield_stress": None,
        "material.viscosity": "1 m",
        "ends.left": "loose",
        "run.frames": -3,
        "numerics.cells": 2,
        "nonsense": 1,
    }
    with pytest.raises(SceneError) as caught:
        Scene.model_validate(spoiled(bad))
    error = caught.value
    assert {fault.path for fault in error.faults} == set(bad)
    assert len(error.faults) == len(bad)
    text = str(error)
    assert text.startswith("scene: 9 faults\n")
    assert "pydantic" not in text
    assert "validation error" not in text


def test_cross_checks_run_beside_other_faults() -> None:
    bad = {"filament.density": 3, "filament.thickness": "3 m", "material.viscosity": 3, "material.yield_stress": None}
    assert [fault.path for fault in faults_of(spoiled(bad))] == [
        "filament.thickness",
        "filament.density",
        "material.viscosity",
        "material.yield_stress",
    ]


def test_an_empty_table_names_every_required_key() -> None:
    paths = [fault.path for fault in faults_of({})]
    assert paths == ["filament.span", "filament.thickness", "filament.density", "material.law", "run.duration"]


def test_what_is_no_table_is_refused() -> None:
    for data in (None, 3, "arrested", [1]):
        (fault,) = faults_of(data)
        assert "is not a table" in fault.found


def test_the_source_is_named(tmp_path: Any) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('[filament]\nspan = "0.2"\n')
    with pytest.raises(SceneError) as caught:
        load_scene(path)
    assert str(caught.value).startswith(f"scene {path}: 5 faults")


@given(st.text(max_size=20) | st.builds("1 {}".format, st.text(alphabet="mskgPaN*/^()-+ 123.degCµ²_'\"#", max_size=12)))
@settings(max_examples=100, deadline=None)
def test_no_text_escapes_as_another_exception(text: str) -> None:
    for path in ("filament.span", "load.gravity", "run.effects", "title", "material.law"):
        faults_of(spoiled({path: text}))


@given(
    st.recursive(
        st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
        lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
        max_leaves=5,
    ),
    st.sampled_from(["filament", "material", "run.frames", "ends.motion", "groups", "groups.G", "initial.P", "load"]),
)
@settings(max_examples=100, deadline=None)
def test_no_value_escapes_as_another_exception(value: object, path: str) -> None:
    faults_of(spoiled({path: value}, BINGHAM))


FILES: dict[str, tuple[bytes | None, str]] = {
    "value": (Scene.model_validate(BINGHAM).to_toml().replace("frames = ", "frames = -").encode(), "run.frames"),
    "empty": (b"", "empty"),
    "no TOML": (b"span == 3 metres", "TOML"),
    "binary": (b"\xff\xfe\x00\x01", "UTF-8"),
    "missing": (None, "no such"),
}


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def test_a_bad_file_is_one_clear_error(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "out"
    for case, (content, named) in FILES.items():
        scene = tmp_path / f"{case}.toml"
        if content is not None:
            scene.write_bytes(content)
        done = softcat("run", str(scene), "-o", str(output))
        assert (done.status, done.out, output.exists()) == (2, "", False), case
        assert named.lower() in done.err.lower(), done.err
    done = softcat("run", str(tmp_path), "-o", str(output))
    assert (done.status, "directory" in done.err, output.exists()) == (2, True, False)


def test_the_program_itself_refuses_with_status_2(tmp_path: Path) -> None:
    command = [str(Path(sys.executable).with_name("softcat")), "run", str(tmp_path / "no.toml"), "-o", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (2, "")
    assert "no such" in done.stderr and "Traceback" not in done.stderr


NAMES = ", ".join(effect.name for effect in REGISTRY)
STRING = ("inertia", "finite-stretch", "thinning", "large-rotation")
PUBLISHED = (*STRING, "bending", "viscous-flow", "yielding", "gravity-ramp")
INK, HONEY, STRAND, MAXWELL, FOUR = "ink-bridge", "cold-honey", "gelatin-strand", "maxwell-slow", "arrested-overdamped"
SMALL, PRINTED = "model=small-deflection", "run.closure=printed"


def of(*names: object) -> str:
    return f"run.effects={json.dumps(names)}"


# A scene, what is changed in it, what must be said of what was found and of what is accepted, and the key at fault.
MISTAKES: list[tuple[Any, ...]] = [
    (INK, [of("inertia", "bendign")], "'bendign' (did you mean 'bending'?)", "one of"),
    (INK, [of("viscous_flow")], "(did you mean 'viscous-flow'?)", "one of"),
    (INK, [of("Inertia")], "(did you mean 'inertia'?)", "one of"),
    (INK, [of("inertia", "magic")], "unknown effect 'magic'", f"one of {NAMES}"),
    (INK, [of("")], "unknown effect ''", f"one of {NAMES}"),
    (INK, [of("bending", "inertia", "bending")], "'bending' named twice", "each name once"),
    (INK, [of("bending", "bending", "bending")], "'bending' named", "each name once"),
    (INK, [of("auto")], "'auto'", NAMES),
    (INK, ["run.effects=atuo"], "did you mean 'auto'?", "auto, paper, or a list"),
    (INK, ["run.effects=inertia"], "'inertia'", '["inertia"]'),
    (INK, ["run.effects=3"], "3 is not a list of names", "auto, paper, or a list of names"),
    (INK, [of(1, 2)], "[1, 2] is not a list of names", "auto, paper, or a list of names"),
    (INK, ["run.effects=[]"], "[] names nothing", "auto, paper, or a list of names"),
    (INK, [of("yielding")], "'yielding' without 'viscous-flow'", "add 'viscous-flow'"),
    (INK, [of(*STRING, "shear")], "'shear' without 'bending'", "leave 'shear' out"),
    (INK, [of(*STRING, "bending", "rotary-inertia")], "'rotary-inertia' without 'shear'", "add 'shear'"),
    (INK, [of(*STRING[1:], "bending", "shear", "rotary-inertia")], "without 'inertia'", "add 'inertia'"),
    (INK, [of(*STRING, "bending", "fibres")], "'fibres' without 'viscous-flow'", "add"),
    (INK, [of("finite-stretch", "viscous-flow", "necking-gradient")], "without 'thinning'", "add 'thinning'"),
    (STRAND, [of("viscous-flow")], "no plastic strain", "leave 'viscous-flow' out"),
    (HONEY, [of("viscous-stress", "viscous-flow")], "no plastic strain", "leave 'viscous-flow' out"),
    (MAXWELL, [of("viscous-flow", "yielding")], "no yield stress", "leave 'yielding' out"),
    (INK, [of("bending", "viscous-stress")], "'viscous-stress' cannot be had", "leave 'viscous-stress' out"),
    ("stretched-rubber-band", [of("viscous-stress")], "'viscous-stress' cannot be had", "leave"),
    (HONEY, [of("inertia", "bending")], "no other stress", "add 'viscous-stress'"),
    (INK, ["load.ramp=0 s", of("gravity-ramp")], "load.ramp is zero", "leave 'gravity-ramp' out"),
    ("drying-ink", [of("inertia", "bending")], "initial state is a plastic strain", "add 'viscous-flow'"),
    ("curled-rod", [of("extensibility", "viscous-stress")], "curved by nature", "add 'bending'"),
    (MAXWELL, [SMALL, of("bending", "extensibility")], "small-deflection", "leave 'extensibility' out"),
    (INK, [SMALL], "'bingham'", "elastic or maxwell", "material.law"),
    (FOUR, [PRINTED, of(*PUBLISHED, "shear")], "'printed' with shear", "'material'", "run.closure"),
    (FOUR, [PRINTED, of(*PUBLISHED, "necking-gradient")], "with necking-gradient", "'material'", "run.closure"),
    (FOUR, [PRINTED, "numerics.order=3"], "'printed'", "order = 1", "run.closure"),
    (FOUR, [PRINTED, "numerics.fibres=8"], "'printed'", "fibres", "run.closure"),
    (STRAND, ["numerics.fibres=8"], "does not flow", "leaving it out", "numerics.fibres"),
    (STRAND, ["numerics.order=3"], "does not flow", "leaving it out", "numerics.order"),
    (INK, [of("bending"), "numerics.solver=cvodes"], "without inertia", "idas", "numerics.solver"),
    # Mistakes that could be told in many ways are told in one.
    (INK, [of("auto", "shear")], "'auto'", NAMES),
    (INK, [of("inertia", "shear")], "'shear' without", "leave 'shear' out"),
    (INK, [of("bending", "necking-gradient")], "'necking-gradient' without", "leave"),
    (INK, [of("bending", "viscous-flow", "fibres")], "'fibres' without", "leave 'fibres' out"),
    (
        INK,
        [of("bending", "viscous-flow"), "numerics.fibres=8"],
        "without 'finite-stretch'",
        "run.effects",
        "numerics.fibres",
    ),
    (INK, [of("inertia", "bending", "rotary-inertia")], "'rotary-inertia' without", "'finite-stretch'"),
    (STRAND, [of("bending", "yielding")], "no yield stress", "leave 'yielding' out"),
    (HONEY, [of("viscous-stress", "yielding")], "no yield stress", "leave 'yielding' out"),
    (STRAND, [of(*STRING, "bending", "fibres")], "'fibres' cannot be had", "leave 'fibres' out"),
    (MAXWELL, [SMALL, of("bending", "shear")], "small-deflection", "leave 'shear' out"),
    (MAXWELL, [SMALL, of("viscous-flow", "necking-gradient")], "small-deflection", "leave 'necking-gradient' out"),
]


def check(softcat: Softcat, command: str, mistake: tuple[Any, ...], output: Path) -> None:
    """The command tells one fault, and leaves nothing behind."""
    scene, changes, found, accepted, *path = mistake
    done = softcat(command, scene, "-o", str(output), *sets(*changes, "numerics.cells=4"))
    assert (done.status, done.out, output.exists()) == (2, "", False), done
    head, fault = done.err.splitlines()
    assert head.startswith("softcat: scene") and head.endswith("1 fault"), done.err
    says, _, better = fault.partition("; accepted: ")
    assert says.strip().startswith(f"{path[0] if path else 'run.effects'}: "), fault
    assert found in says and accepted in better, fault


def test_each_mistake_is_one_clear_fault_before_anything_runs(softcat: Softcat, tmp_path: Path) -> None:
    for mistake in MISTAKES:
        check(softcat, "explain", mistake, tmp_path / "out")
    for mistake in MISTAKES[::12]:
        for command in ("run", "effects"):
            check(softcat, command, mistake, tmp_path / "out")


def test_two_mistakes_are_two_faults(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("explain", INK, "-o", str(tmp_path / "out"), *sets(of("magic", "viscous-stress")))
    assert done.status == 2
    assert "2 faults" in done.err and "'magic'" in done.err and "'viscous-stress' cannot be had" in done.err
    assert not (tmp_path / "out").exists()


def test_stretching_is_implied_where_nothing_else_would_do(softcat: Softcat, tmp_path: Path) -> None:
    flowing = ("inertia", "bending", "viscous-flow")
    for scene, names, implied in (
        ("slack-taffy", flowing, True),
        ("slime-slope", flowing, True),
        ("drying-ink", flowing, True),
        (INK, ("inertia",), True),
        (INK, ("inertia", "bending"), False),
        (INK, ("bending", "finite-stretch"), True),
    ):
        done = softcat("explain", scene, "-q", "-o", str(tmp_path), *sets(of(*names), "numerics.cells=4"))
        assert (done.status, done.err) == (0, "")
        effects = {row["effect"]: row for row in json.loads((tmp_path / "explain.json").read_text())["effects"]}
        in_force = {name for name, row in effects.items() if row["in_force"]}
        assert in_force == {*names, *(["extensibility"] if implied else [])}, scene
        assert effects["extensibility"]["reason"] != "named in run.effects"


BODY = {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"}
EYRING = {"s0": "3 kPa", "t0": "2 s"}
GENTLE = [["0 s", "0 m", "0 m"]]


def custom(flow: str, **parameters: object) -> dict[str, object]:
    return {
        "material": {
            "law": "custom",
            "youngs_modulus": "2 MPa",
            "flow": flow,
            "parameters": {**EYRING, **parameters},
        }
    }


def power(index: float) -> dict[str, object]:
    return {"material": {"law": "power-law", "youngs_modulus": "2 MPa", "viscosity": "1 kPa*s", "index": index}}


def moved(*rows: list[str], law: str = "elastic") -> dict[str, object]:
    material = {"law": law, "youngs_modulus": "2 MPa"} | ({"viscosity": "1 kPa*s"} if law == "maxwell" else {})
    return {"material": material, "ends": {"motion": [*GENTLE, *rows]}}


STRINGS = ["finite-stretch", "thinning", "large-rotation"]
SLACK = {"filament": {**BODY, "rest_length": "0.25 m"}, "material": {"law": "elastic", "youngs_modulus": "2 MPa"}}

BAD_RHEOLOGY: dict[str, tuple[dict[str, object], str, str]] = {
    "not odd": (custom("sigma**2/(s0**2*t0)"), "material.flow", "not odd"),
    "gives work back": (custom("-sigma/(s0*t0)"), "material.flow", "negative dissipation"),
    "decreases": (custom("sin(sigma/s0)/t0"), "material.flow", "decreases"),
    "unknown symbol": (custom("sinh(sigma/s1)/t0 + sigma/(s0*t0)"), "material.flow", "'s1'"),
    "parameter without a unit": (custom("sinh(sigma/s0)/t0", s0=3000), "material.flow", "pure number"),
    "rate of the wrong dimension": (custom("sigma/s0*t0"), "material.flow", "1/s"),
    "import": (custom("__import__('os').system('true')"), "material.flow", "accepted"),
    "attribute": (custom("sigma.__class__"), "material.flow", "accepted"),
    "subscript": (custom("sigma[0]/(s0*t0)"), "material.flow", "accepted"),
    "tower of powers": (custom("9**9**9**9*sigma/(s0*t0)"), "material.flow", "accepted"),
    "index zero": (power(0), "material.index", "out of range"),
    "index negative": (power(-0.5), "material.index", "out of range"),
    "consistency of another index": (power(0.5), "material.viscosity", "Pa"),
    "supports meet": (moved(["0.1 s", "-0.3 m", "0 m"]), "ends.motion", "come within"),
    "beyond what an elastic filament follows": (moved(["9 s", "0.5 m", "0 m"]), "ends.motion", "2.718"),
    "faster than its waves": (moved(["1 ms", "0.1 m", "0 m"], law="maxwell"), "ends.motion", "waves"),
    "time runs back": (moved(["2 s", "1 cm", "0 m"], ["1 s", "0 m", "0 m"]), "ends.motion", "1"),
    "slack string without weight": (
        {**SLACK, "load": {"gravity": "0 m/s^2"}, "run": {"effects": STRINGS}},
        "load.gravity",
        "slack",
    ),
    "slack string, weight to come": (
        {**SLACK, "load": {"ramp": "0.1 s"}, "run": {"effects": STRINGS}},
        "load.ramp",
        "slack",
    ),
    "fluid in a turned clamp": (
        {"material": {"law": "newtonian", "viscosity": "1 kPa*s"}, "ends": {"left_angle": "10 deg"}},
        "ends.left_angle",
        "elastic shape",
    ),
    "fluid without its stress": (
        {"material": {"law": "newtonian", "viscosity": "1 kPa*s"}, "run": {"effects": ["inertia", "bending"]}},
        "run.effects",
        "viscous-stress",
    ),
}


def refusal(changes: dict[str, object]) -> str:
    """What is said of a scene; it must be refused before it runs."""
    run = {"duration": "0.2 s", "frames": 11, **changes.get("run", {})}  # type: ignore[dict-item]
    with pytest.raises(SoftcatError) as caught:
        sc.simulate(sc.Scene.model_validate({"filament": BODY, **changes, "run": run}))
    return str(caught.value)


def test_bad_rheology_ends_and_starts_are_one_clear_error_each() -> None:
    for name, (changes, path, word) in BAD_RHEOLOGY.items():
        said = refusal(changes)
        assert path in said, (name, said)
        assert word in said, (name, said)
        assert "Traceback" not in said
        # One fault for one mistake; an unknown name leaves the parameter that it replaces unused.
        assert said.splitlines()[0].endswith("1 fault"), (name, said)


def test_a_slack_string_that_could_only_be_pushed_is_not_solved(tmp_path: Path) -> None:
    """A right support that comes back turns a string slack: without weight it has no shape, and no answer is given."""
    scene = sc.Scene.model_validate(
        {
            "filament": BODY,
            "material": {"law": "elastic", "youngs_modulus": "2 MPa"},
            "load": {"gravity": "0 m/s^2"},
            "ends": {"motion": [*GENTLE, ["0.1 s", "-1 cm", "0 m"]]},
            "run": {"duration": "0.2 s", "frames": 11, "effects": STRINGS},
        }
    )
    done = sc.simulate(scene)
    assert not done.outcome.is_success
    done.save(tmp_path)
    assert tomllib.loads((tmp_path / "scene.toml").read_text(encoding="utf-8"))["ends"]["motion"]
