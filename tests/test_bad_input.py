"""Bad input: each mistake is one clear fault at its path, all of them come at once, and nothing is written."""

from __future__ import annotations

import json
import math
import tomllib
from pathlib import Path
from typing import Any

import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.errors import Fault, SceneError
from tests.common.in_process import Softcat, sets
from tests.common.scenes import BINGHAM, faults_of, spoiled

BAD: list[tuple[dict[str, Any], str, str]] = [
    ({"filament.spam": "0.2 m"}, "filament.spam", "unknown key (did you mean 'span'?)"),
    ({"filaments": {}}, "filaments", "unknown key (did you mean 'filament'?)"),
    ({"material.density": "1 kg/m^3"}, "material.density", "did you mean 'filament.density'?"),
    ({"material.temperature": "3 K"}, "material.temperature", "table [temperature]?); accepted: temperature.initial, "),
    ({"filament.zzzz": 1}, "filament.zzzz", "unknown key; accepted: span, "),
    ({"duration": "2 s"}, "duration", "did you mean 'run.duration'?"),
    ({"material.law": "Bingham"}, "material.law", "accepted: elastic, maxwell, newtonian, kelvin-voigt, standard"),
    ({"material.law": 3}, "material.law", "3 is not a name"),
    ({"material.law": None}, "material.law", "missing"),
    ({"filament.section": "rectange"}, "filament.section", "did you mean 'rectangle'?"),
    ({"run.closure": "quux"}, "run.closure", "accepted: material, printed"),
    ({"model": "filamant"}, "model", "did you mean 'filament'?"),
    ({"filament.span": 0.2}, "filament.span", '0.2 has no unit; accepted: a positive length with its unit, such as "0'),
    ({"filament.span": True}, "filament.span", "true is not a quantity"),
    ({"filament.span": {"m": 2}}, "filament.span", "a table is not a quantity"),
    ({"filament.span": ""}, "filament.span", "'' is not a number with a unit"),
    ({"filament.span": "5 kPa"}, "filament.span", "'kPa' is a stress, not a length"),
    ({"filament.span": "20 degC"}, "filament.span", "'degC' is of dimension"),
    ({"filament.span": "5 metrs"}, "filament.span", "unknown unit 'metrs'"),
    ({"filament.span": "1,5 m"}, "filament.span", "unknown unit ',5 m'"),
    ({"filament.span": "0 m"}, "filament.span", "is zero"),
    ({"filament.span": "-1 m"}, "filament.span", "is negative"),
    ({"filament.span": "nan m"}, "filament.span", "'nan m' is not finite"),
    ({"filament.span": "1e308 km"}, "filament.span", "is not finite"),
    ({"temperature.initial": "1e300 K"}, "temperature.initial", "'1e300 K' is beyond"),
    ({"filament.span": None}, "filament.span", 'missing; accepted: a positive length with its unit, such as "0.2 m"'),
    ({"filament.span": pint.Quantity(1.0, "s")}, "filament.span", "is a time, not a length"),
    ({"filament.span": pint.Quantity(math.nan, "m")}, "filament.span", "nan is not finite"),
    ({"filament.thickness": "0.2 m"}, "filament.thickness", "not less than the span; accepted: a thickness below"),
    ({"filament.section": "circle", "filament.width": "1 mm"}, "filament.width", "a circle has no width"),
    ({"filament.rest_length": "1e9 km"}, "filament.rest_length", "times the distance of the supports"),
    ({"ends": []}, "ends", "[] is not a table"),
    ({"title": 3}, "title", "3 is not text"),
    ({"title": "a\0b"}, "title", "holds a control character"),
    ({"title": "a\x1b[2J"}, "title", "holds a control character"),
    ({"material.youngs_modulus": None}, "material.youngs_modulus", "missing: the law 'bingham' needs it"),
    ({"material.viscosity": "9 kPa"}, "material.viscosity", "'kPa' is a stress, not a viscosity"),
    ({"material.shear_yield_stress": "5 kPa"}, "material.yield_stress", "given twice, here and as material.shear_yiel"),
    ({"material.shear_viscosity": "5 Pa s"}, "material.viscosity", "given twice, here and as material.shear_viscosity"),
    ({"material.yield_stress": "1e-300 Pa"}, "material.yield_stress", "beyond 1e-30 to 1e+30 in SI units"),
    ({"load.gravity": "-9.81 m/s^2"}, "load.gravity", "is negative; accepted: a non-negative acceleration"),
    ({"surroundings.surface_tension": "-1 N/m"}, "surroundings.surface_tension", "is negative"),
    ({"run.duration": "0 s"}, "run.duration", "is zero; accepted: a positive time"),
    ({"run.frames": 1}, "run.frames", "1 is out of range; accepted: a whole number from 2"),
    ({"run.frames": 2.5}, "run.frames", "2.5 is not a whole number"),
    ({"run.frames": True}, "run.frames", "true is not a whole number"),
    ({"run.accuracy": 0}, "run.accuracy", "accepted: a number between 0 and 1, both excluded"),
    ({"run.accuracy": math.nan}, "run.accuracy", "nan is not finite"),
    ({"run.accuracy": 10**400}, "run.accuracy", "is not finite"),
    ({"run.accuracy": "1e-3"}, "run.accuracy", "'1e-3' is not a number"),
    ({"numerics.cells": 3}, "numerics.cells", "3 is out of range; accepted: a whole number from 4"),
    ({"numerics.rtol": -1e-3}, "numerics.rtol", "out of range"),
    ({"numerics.order": 2, "numerics.fibres": 8}, "numerics.order", "2, but numerics.fibres is 8"),
    ({"filament.profile": [1.0]}, "filament.profile", "a list of 1; accepted: a list of positive numbers without un"),
    ({"filament.profile": ["1 mm", "2 mm"]}, "filament.profile", "'1 mm' is not a number"),
    ({"ends.left_angle": "180 deg"}, "ends.left_angle", "is half a turn or more; accepted: an angle between -180 deg"),
    ({"ends.motion": "go"}, "ends.motion", "'go' is not a list of rows"),
    ({"ends.motion": [["0 s", "0 m"]]}, "ends.motion", "is not a row [time, dx, dy]"),
    ({"ends.motion": [["0 m", "0 m", "0 m"]]}, "ends.motion", "'m' is a length, not a time"),
    ({"initial.relaxed": "no"}, "initial.relaxed", "is neither true nor false"),
    ({"initial.P": [math.nan]}, "initial.P", "nan is not finite"),
    ({"load.shake": "50 %"}, "load.shake", "is not a number"),
    *(
        ({"load.shake": 0.5, "load.shake_frequency": text}, "load.shake_frequency", says)
        for text, says in (
            ("9 s", "'s' is a time, not a frequency"),
            ("540 rpm", "'rpm' measures an angle, not cycles"),
        )
    ),
]
"""What is changed in a sound scene, the key at fault, and what must be said."""


def judge(title: str, name: object, faults: tuple[Fault, ...], path: str, says: tuple[str, ...]) -> None:
    """One fault for one mistake, at its path, with these words."""
    text = [str(fault) for fault in faults]
    assert [fault.path for fault in faults] == [path], (title, name, text)
    assert all(word in text[0] for word in says), (title, name, text)


def test_one_bad_value_is_one_fault() -> None:
    for changes, path, says in BAD:
        judge("bad value", changes, faults_of(spoiled(changes)), path, (says,))


def test_a_constant_that_the_law_does_not_use_is_refused() -> None:
    for law, unused in {"elastic": ["viscosity", "yield_stress"], "maxwell": ["yield_stress"]}.items():
        faults = faults_of(spoiled({"material.law": law}))
        assert [fault.path for fault in faults] == [f"material.{name}" for name in unused]
        assert all(f"the law '{law}' does not" in fault.found for fault in faults)


def test_every_fault_of_a_bad_scene_is_listed(tmp_path: Path) -> None:
    bad = {
        **{"filament.span": "0.2", "filament.density": "-1 kg/m^3", "filament.colour": "red", "nonsense": 1},
        **{"material.yield_stress": None, "material.viscosity": "1 m", "ends.left": "loose", "run.frames": -3},
    }
    with pytest.raises(SceneError) as caught:
        sc.Scene.model_validate(spoiled(bad))
    assert sorted(fault.path for fault in caught.value.faults) == sorted(bad)
    assert str(caught.value).startswith("scene: 8 faults\n")
    assert "pydantic" not in str(caught.value) and "validation error" not in str(caught.value)
    # Checks across keys run beside other faults.
    bad = {"filament.density": 3, "filament.thickness": "3 m", "material.viscosity": 3, "material.yield_stress": None}
    assert sorted(fault.path for fault in faults_of(spoiled(bad))) == sorted(bad)
    required = ["filament.span", "filament.thickness", "filament.density", "material.law", "run.duration"]
    assert [fault.path for fault in faults_of({})] == required
    for data in (None, 3, "arrested", [1]):
        (fault,) = faults_of(data)
        assert "is not a table" in fault.found
    (tmp_path / "mine.toml").write_text('[filament]\nspan = "0.2"\n')
    with pytest.raises(SceneError, match=r"^scene .*mine.toml: 5 faults"):
        sc.load_scene(tmp_path / "mine.toml")


UNITS = st.text(alphabet="mskgPaN*/^()-+ 123.degCµ²_'\"#", max_size=12)
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=5,
)
PLACES = ("filament", "material", "run.frames", "ends.motion", "groups", "groups.G", "initial.P", "load")


@given(st.text(max_size=20) | st.builds("1 {}".format, UNITS), VALUES)
@settings(max_examples=100, deadline=None)
def test_nothing_escapes_as_another_exception(text: str, value: object) -> None:
    for path in ("filament.span", "load.gravity", "run.effects", "title", "material.law"):
        faults_of(spoiled({path: text}))
    for path in PLACES:
        faults_of(spoiled({path: value}, BINGHAM))


NAMES = ", ".join(effect.name for effect in REGISTRY)
STRING = ("inertia", "finite-stretch", "thinning", "large-rotation")
PUBLISHED = (*STRING, "bending", "viscous-flow", "yielding", "gravity-ramp")
INK, HONEY, STRAND, MAXWELL, FOUR = "ink-bridge", "cold-honey", "gelatin-strand", "maxwell-slow", "arrested-overdamped"
SMALL, PRINTED = "model=small-deflection", "run.closure=printed"


def of(*names: object) -> str:
    return f"run.effects={json.dumps(names)}"


ALONE = "leave {} out".format
MISTAKES: dict[tuple[str, ...], tuple[str, ...]] = {
    # Names.
    (INK, of("inertia", "bendign")): ("'bendign' (did you mean 'bending'?)", "one of"),
    (INK, of("inertia", "magic")): ("unknown effect 'magic'", f"one of {NAMES}"),
    (INK, of("bending", "bending", "bending")): ("'bending' named", "each name once"),
    (INK, of("auto", "shear")): ("'auto'", NAMES),
    (INK, "run.effects=atuo"): ("did you mean 'auto'?", "auto, paper, or a list"),
    (INK, "run.effects=inertia"): ("'inertia'", '["inertia"]'),
    (INK, "run.effects=3"): ("3 is not a list of names", "auto, paper, or a list of names"),
    (INK, "run.effects=[]"): ("[] names nothing", "auto, paper, or a list of names"),
    # Effects that miss another.
    (INK, of("yielding")): ("'yielding' without 'viscous-flow'", "add 'viscous-flow'"),
    (INK, of(*STRING, "shear")): ("'shear' without 'bending'", ALONE("'shear'")),
    (INK, of(*STRING, "bending", "rotary-inertia")): ("'rotary-inertia' without 'shear'", "add 'shear'"),
    (INK, of(*STRING[1:], "bending", "shear", "rotary-inertia")): ("without 'inertia'", "add 'inertia'"),
    (INK, of(*STRING, "bending", "fibres")): ("'fibres' without 'viscous-flow'", "add"),
    (INK, of("finite-stretch", "viscous-flow", "necking-gradient")): ("without 'thinning'", "add 'thinning'"),
    # Effects that the law cannot have, or cannot do without.
    (STRAND, of("viscous-flow")): ("no plastic strain", ALONE("'viscous-flow'")),
    (STRAND, of("bending", "yielding")): ("no yield stress", ALONE("'yielding'")),
    (STRAND, of(*STRING, "bending", "fibres")): ("'fibres' cannot be had", ALONE("'fibres'")),
    (HONEY, of("inertia", "bending")): ("no other stress", "add 'viscous-stress'"),
    (MAXWELL, of("viscous-flow", "yielding")): ("no yield stress", ALONE("'yielding'")),
    (INK, of("bending", "viscous-stress")): ("'viscous-stress' cannot be had", ALONE("'viscous-stress'")),
    # Effects that the scene, the model or the closure cannot have, or cannot do without.
    (INK, "load.ramp=0 s", of("gravity-ramp")): ("load.ramp is zero", ALONE("'gravity-ramp'")),
    ("drying-ink", of("inertia", "bending")): ("initial state is a plastic strain", "add 'viscous-flow'"),
    ("curled-rod", of("extensibility", "viscous-stress")): ("curved by nature", "add 'bending'"),
    (MAXWELL, SMALL, of("bending", "extensibility")): ("small-deflection", ALONE("'extensibility'")),
    (INK, SMALL): ("material.law", "'bingham'", "elastic or maxwell"),
    (FOUR, PRINTED, of(*PUBLISHED, "shear")): ("run.closure", "'printed' with shear", "'material'"),
    (FOUR, PRINTED, of(*PUBLISHED, "necking-gradient")): ("run.closure", "with necking-gradient", "'material'"),
    (FOUR, PRINTED, "numerics.order=3"): ("run.closure", "'printed'", "order = 1"),
    (FOUR, PRINTED, "numerics.fibres=8"): ("run.closure", "'printed'", "fibres"),
    (STRAND, "numerics.fibres=8"): ("numerics.fibres", "does not flow", "leaving it out"),
    (INK, of("bending"), "numerics.solver=cvodes"): ("numerics.solver", "without inertia", "idas"),
    # One mistake that could be named in many ways.
    (INK, of("inertia", "shear")): ("'shear' without", ALONE("'shear'")),
    (INK, of("bending", "viscous-flow"), "numerics.fibres=8"): ("numerics.fibres", "without 'finite-stretch'"),
    (INK, of("inertia", "bending", "rotary-inertia")): ("'rotary-inertia' without", "'finite-stretch'"),
}
"""A bundled scene with changes: what must be said, and before it the key at fault, unless that is run.effects."""
KEYS = ("material.law", "run.closure", "numerics.fibres", "numerics.order", "numerics.solver")


def test_each_mistake_about_effects_is_one_clear_fault() -> None:
    for (scene, *changes), words in MISTAKES.items():
        with pytest.raises(SceneError) as caught:
            sc.explain(sc.load_scene(scene, [*changes, "numerics.cells=4"]))
        path, says = (words[0], words[1:]) if words[0] in KEYS else ("run.effects", words)
        judge("effects", (scene, *changes), caught.value.faults, path, says)
    with pytest.raises(SceneError, match="2 faults") as caught:
        sc.explain(sc.load_scene(INK, [of("magic", "viscous-stress")]))
    assert "'magic'" in str(caught.value) and "'viscous-stress' cannot be had" in str(caught.value)


def test_stretching_is_implied_where_nothing_else_would_do() -> None:
    for scene, *names in (
        ("slack-taffy", "inertia", "bending", "viscous-flow"),
        ("slime-slope", "inertia", "bending", "viscous-flow"),
        ("drying-ink", "inertia", "bending", "viscous-flow"),
        (INK, "inertia"),
        (INK, "inertia", "bending"),
        (INK, "bending", "finite-stretch"),
    ):
        explained = sc.explain(sc.load_scene(scene, [of(*names), "numerics.cells=4"]))
        effects = {each["effect"]: each for each in explained.effects}
        implied = (scene, *names) != (INK, "inertia", "bending")
        in_force = {name for name, each in effects.items() if each["in_force"]}
        assert in_force == {*names, *(["extensibility"] if implied else [])}, (scene, names)
        assert effects["extensibility"]["reason"] != "named in run.effects"


BODY = {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"}
SHORT = {"filament": BODY, "run": {"duration": "0.2 s", "frames": 11}}
ELASTIC = {**SHORT, "material": {"law": "elastic", "youngs_modulus": "2 MPa"}}
VISCOUS = {"youngs_modulus": "2 MPa", "viscosity": "1 kPa*s"}
FLUID = {**SHORT, "material": {"law": "newtonian", "viscosity": "1 kPa*s"}}
POWER = {**SHORT, "material": {"law": "power-law", **VISCOUS, "index": 1.0}}
EYRING = {"law": "custom", "youngs_modulus": "2 MPa", "parameters": {"s0": "3 kPa", "t0": "2 s"}}
CUSTOM = {**SHORT, "material": {**EYRING, "flow": "sinh(sigma/s0)/t0"}}
SLACK = spoiled(
    {"filament.rest_length": "0.25 m", "run.effects": ["finite-stretch", "thinning", "large-rotation"]}, ELASTIC
)


def moved(*rows: list[str]) -> dict[str, object]:
    return {"ends.motion": [["0 s", "0 m", "0 m"], *rows]}


REFUSED: list[tuple[dict[str, Any], dict[str, Any], str, str]] = [
    (CUSTOM, {"material.flow": "sigma**2/(s0**2*t0)"}, "material.flow", "not odd"),
    (CUSTOM, {"material.flow": "-sigma/(s0*t0)"}, "material.flow", "negative dissipation"),
    (CUSTOM, {"material.flow": "sin(sigma/s0)/t0"}, "material.flow", "decreases"),
    (CUSTOM, {"material.flow": "sinh(sigma/s1)/t0 + sigma/(s0*t0)"}, "material.flow", "'s1'"),
    (CUSTOM, {"material.parameters.s0": 3000}, "material.flow", "pure number"),
    (CUSTOM, {"material.flow": "sigma/s0*t0"}, "material.flow", "1/s"),
    (CUSTOM, {"material.flow": "__import__('os').system('true')"}, "material.flow", "accepted"),
    (CUSTOM, {"material.flow": "sigma.__class__"}, "material.flow", "accepted"),
    (CUSTOM, {"material.flow": "9**9**9**9*sigma/(s0*t0)"}, "material.flow", "accepted"),
    (POWER, {"material.index": 0}, "material.index", "out of range"),
    (POWER, {"material.index": 0.5}, "material.viscosity", "Pa"),
    (ELASTIC, moved(["0.1 s", "-0.3 m", "0 m"]), "ends.motion", "come within"),
    (ELASTIC, moved(["9 s", "0.5 m", "0 m"]), "ends.motion", "2.718"),
    (ELASTIC, moved(["2 s", "1 cm", "0 m"], ["1 s", "0 m", "0 m"]), "ends.motion", "1"),
    (SHORT, {"material": {"law": "maxwell", **VISCOUS}, **moved(["1 ms", "0.1 m", "0 m"])}, "ends.motion", "waves"),
    (SLACK, {"load.gravity": "0 m/s^2"}, "load.gravity", "slack"),
    (SLACK, {"load.ramp": "0.1 s"}, "load.ramp", "slack"),
    (FLUID, {"ends.left_angle": "10 deg"}, "ends.left_angle", "elastic shape"),
    (FLUID, {"run.effects": ["inertia", "bending"]}, "run.effects", "viscous-stress"),
]
"""Rheology, ends and starts: a sound scene, what is changed in it, the key at fault, and what must be said."""


def test_bad_rheology_ends_and_starts_are_one_clear_error_each_before_anything_runs() -> None:
    for base, changes, path, says in REFUSED:
        with pytest.raises(SceneError) as caught:
            sc.simulate(sc.Scene.model_validate(spoiled(changes, base)))
        judge("rheology", changes, caught.value.faults, path, (says,))


def test_a_slack_string_that_could_only_be_pushed_is_not_solved(tmp_path: Path) -> None:
    """A right support that comes back turns a string slack: without weight it has no shape, and no answer is given."""
    changes = {"load.gravity": "0 m/s^2", "filament.rest_length": None, **moved(["0.1 s", "-1 cm", "0 m"])}
    done = sc.simulate(sc.Scene.model_validate(spoiled(changes, SLACK)))
    assert not done.outcome.is_success
    done.save(tmp_path)
    assert tomllib.loads((tmp_path / "scene.toml").read_text(encoding="utf-8"))["ends"]["motion"]


BEFORE_ALL: dict[tuple[str, ...], str] = {
    ("fit", "--prior", "viscosity=lognrom(s=0.5, scale=30 Pa*s)"): "no distribution 'lognrom' (did you mean",
    ("fit", "--prior", "viscsity=norm(1 Pa*s, 1 Pa*s)"): "prior of viscsity: not free (did you mean 'viscosity'?)",
    ("fit", "--flow-curve", "missing.csv"): "no such file",
    ("laws", "--prior", "viscosity=norm(30 Pa*s)"): "prior of viscosity: norm without scale",
    ("laws", "--prior", "span=norm(1 m, 1 m)"): "prior of span: not free in any law",
    ("experiment", "--noise", "10"): "noise: ",
    ("experiment", "--noise", "10 um", "--max-sag", "0 mm"): "max_sag: ",
}
FILM = str(Path(sc.__file__).parent / "samples" / "film.csv")
LEADING = {
    "fit": ("fit", FILM, "--scene", "ink-bridge", "--free", "viscosity", "--posterior"),
    "laws": ("fit", FILM, "--scene", "ink-bridge", "--law", "bingham", "--law", "casson", "--posterior"),
    "experiment": ("experiment", FOUR, "--free", "viscosity"),
}


@pytest.mark.parametrize("words", BEFORE_ALL)
def test_what_options_name_is_read_before_the_work(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path, words: tuple[str, ...]
) -> None:
    for place in ("fitting.fit.multi_start", "design.experiment.least_in_box"):
        monkeypatch.delattr(f"softcat_sym.{place}")
    monkeypatch.setattr("softcat_sym.fitting.posterior.packages", lambda: None)
    done = Softcat(monkeypatch, capsys)(*LEADING[words[0]], *words[1:], "-q", "-o", str(tmp_path / "out"))
    assert (done.status, done.out, (tmp_path / "out").exists()) == (2, "", False)
    assert BEFORE_ALL[words] in done.err, done.err


def test_commands_refuse_before_they_write_anything(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    softcat, output = Softcat(monkeypatch, capsys), tmp_path / "out"
    files: dict[str, tuple[bytes | None, str]] = {
        "value": (sc.Scene.model_validate(BINGHAM).to_toml().replace("frames = ", "frames = -").encode(), "run.frames"),
        "empty": (b"", "empty"),
        "no TOML": (b"span == 3 metres", "TOML"),
        "binary": (b"\xff\xfe\x00\x01", "UTF-8"),
        "missing": (None, "no such"),
    }
    for case, (content, named) in files.items():
        scene = tmp_path / f"{case}.toml"
        if content is not None:
            scene.write_bytes(content)
        done = softcat("run", str(scene), "-o", str(output))
        assert (done.status, done.out, output.exists()) == (2, "", False), case
        assert named.lower() in done.err.lower(), done.err
    done = softcat("run", str(tmp_path), "-o", str(output))
    assert (done.status, "directory" in done.err, output.exists()) == (2, True, False)
    for command in ("run", "explain", "effects"):
        done = softcat(command, FOUR, "-o", str(output), *sets(PRINTED, "numerics.order=3"))
        assert (done.status, done.out, output.exists(), "1 fault\n" in done.err) == (2, "", False, True), done
