"""Each bad value is one fault at its path, and all of them come at once."""

from __future__ import annotations

import math
from typing import Any

import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from softcat_sym.errors import SceneError
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

from .tables import BINGHAM, faults_of, spoiled

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


@pytest.mark.parametrize(("changes", "path", "says"), BAD, ids=[f"{path}-{n}" for n, (_, path, _) in enumerate(BAD)])
def test_one_bad_value_is_one_fault(changes: dict[str, Any], path: str, says: str) -> None:
    faults = faults_of(spoiled(changes))
    if changes == {"filament": 3}:
        faults = faults[:1]
    assert [fault.path for fault in faults] == [path]
    assert says in str(faults[0])


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


@pytest.mark.parametrize("data", [None, 3, "arrested", [1]])
def test_what_is_no_table_is_refused(data: object) -> None:
    (fault,) = faults_of(data)
    assert "is not a table" in fault.found


def test_the_source_is_named(tmp_path: Any) -> None:
    path = tmp_path / "mine.toml"
    path.write_text('[filament]\nspan = "0.2"\n')
    with pytest.raises(SceneError) as caught:
        load_scene(path)
    assert str(caught.value).startswith(f"scene {path}: 5 faults")


@given(st.text(max_size=20) | st.builds("1 {}".format, st.text(alphabet="mskgPaN*/^()-+ 123.degCµ²_'\"#", max_size=12)))
@settings(max_examples=300, deadline=None)
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
@settings(max_examples=300, deadline=None)
def test_no_value_escapes_as_another_exception(value: object, path: str) -> None:
    faults_of(spoiled({path: value}, BINGHAM))
