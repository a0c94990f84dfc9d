"""The table [material], its other names, and a user's own flow rule."""

from __future__ import annotations

import math
import pickle
import time
import tomllib
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic_core import PydanticCustomError

from softcat_sym.errors import SceneError
from softcat_sym.scene import laws
from softcat_sym.scene.formula import parse_formula
from softcat_sym.scene.material import Mode
from softcat_sym.scene.scene import Scene
from tests.common.scenes import LAWS, MODES, faults_of, spoiled

# Laws, their constants, shear data, lists of modes; and TOML there and back.
NUMBERS = {"youngs_modulus": 4e6, "second_modulus": 1e6, "viscosity": 3e3, "yield_stress": 9e3, "relaxation_time": 1e-3}
NUMBERS |= {"solvent_viscosity": 300.0, "finite_extensibility": 100.0, "mobility": 0.2, "ptt_epsilon": 0.1}
VALUES: dict[str, dict[str, float]] = {
    one.name: {name: NUMBERS[name] for name in one.constants}
    | ({"viscosity": 120.0, "index": 0.4} if one.has_index else {})
    for one in laws.LAWS.values()
}
VALUES["multimode-maxwell"] = {"mode_1_youngs_modulus": 1e6, "mode_1_viscosity": 2e3}
VALUES["multimode-maxwell"] |= {"mode_2_youngs_modulus": 3e6, "mode_2_viscosity": 50.0}
VALUES["custom"] |= {"m": 0.4, "K": 1.0, "tau_c": 2.0, "yield_stress": 2.0}


def table(law: str, **changes: Any) -> dict[str, Any]:
    """A scene of one law; None takes a constant out."""
    material = {"law": law} | LAWS[law] | changes
    return spoiled({"material": {name: value for name, value in material.items() if value is not None}})


def scene_of(law: str, **changes: Any) -> Scene:
    return Scene.model_validate(table(law, **changes))


def test_a_law_has_its_constants_and_comes_back_from_toml() -> None:
    for law in LAWS:
        scene = scene_of(law)
        assert scene.material.values() == pytest.approx(VALUES[law], rel=1e-12)
        assert scene.material.threshold == pytest.approx(VALUES[law].get("yield_stress", 0.0))
        again = Scene.model_validate(tomllib.loads(scene.to_toml()))
        assert again == scene
        assert hash(again) == hash(scene)
        assert again.to_toml() == scene.to_toml()
        assert scene.replace({"numerics.cells": 40}).material == scene.material
        assert pickle.loads(pickle.dumps(scene)) == scene
        assert (scene.material.formula is None) == (not laws.LAWS[law].has_formula)


def test_a_missing_constant_is_one_fault() -> None:
    for law, name in [(law, name) for law, spec in laws.LAWS.items() for name in spec.constants]:
        (fault,) = faults_of(table(law, **{name: None}))
        assert (fault.path, fault.found) == (f"material.{name}", f"missing: the law '{law}' needs it")


def test_a_consistency_has_the_unit_of_its_index() -> None:
    for changes, path, says in [
        ({"viscosity": "120 Pa*s"}, "viscosity", "'Pa*s' is a viscosity, not a consistency in Pa*s^0.4"),
        ({"viscosity": "120 Pa*s"}, "viscosity", 'such as "120 Pa*s^0.4"'),
        ({"viscosity": "120 Pa*s^0.5"}, "viscosity", "'Pa*s^0.5' is of unit kg*m^-1*s^-1.5, not a consistency"),
        ({"viscosity": "0 Pa*s^0.4"}, "viscosity", "is zero"),
        ({"viscosity": 120}, "viscosity", "120 has no unit"),
        ({"viscosity": None}, "viscosity", 'needs it; accepted: a positive consistency with its unit, such as "120 Pa'),
        ({"index": 0}, "index", "0 is out of range; accepted: a positive number"),
        ({"index": -0.4}, "index", "-0.4 is out of range"),
        ({"index": "0.4"}, "index", "'0.4' is not a number"),
        ({"viscosity": None, "shear_viscosity": "1 Pa*s"}, "shear_viscosity", "accepted: shear_consistency"),
        ({"shear_consistency": "1 Pa*s^0.4"}, "viscosity", "given twice, here and as material.shear_consistency"),
        ({"viscosity": None, "shear_consistency": "1 Pa*s"}, "shear_consistency", "not a consistency in Pa*s^0.4"),
    ]:
        faults = faults_of(table("power-law", **changes))
        assert path in [fault.path.removeprefix("material.") for fault in faults]
        assert says in "\n".join(map(str, faults))
        if "shear_viscosity" not in changes:
            assert len(faults) == 1


@pytest.mark.parametrize("index", [0.3, 0.5, 1.0, 2.0])
def test_shear_data_of_a_power_law(index: float) -> None:
    """A von Mises material in uniaxial tension: tau = sigma/sqrt(3), shear rate = sqrt(3) times the strain rate."""
    changes: dict[str, Any] = {"viscosity": None, "yield_stress": None, "index": index}
    shear = {"shear_consistency": f"40 Pa*s^{index!r}", "shear_yield_stress": "200 Pa"}
    scene = scene_of("herschel-bulkley", **changes, **shear)
    material = scene.material
    assert material.viscosity is not None
    assert material.yield_stress is not None
    strain_rate = 0.7
    in_tension = material.yield_stress + material.viscosity * strain_rate**index
    in_shear = 200 + 40 * (math.sqrt(3) * strain_rate) ** index
    assert in_tension == pytest.approx(math.sqrt(3) * in_shear, rel=1e-14)
    consistency, yields_at = material.notes
    assert consistency.startswith("consistency 40 Pa s")
    assert consistency.endswith(f"in tension, times 3^(({index:g}+1)/2)")
    assert f"= {40 * 3 ** ((index + 1) / 2):.6g} Pa s" in consistency
    assert f"yield stress 200 Pa in shear = {200 * math.sqrt(3):.6g} Pa in tension" in yields_at
    text = scene.to_toml()
    assert all(f"# {note}" in text for note in material.notes)
    again = scene.replace({"material.viscosity": f"1 Pa*s^{index!r}"})
    assert (again.material.viscosity, len(again.material.notes)) == (1.0, 1)
    assert scene.replace({"load.gravity": "1 m/s^2"}).material.notes == material.notes


def test_trouton() -> None:
    for law in ["maxwell", "newtonian", "kelvin-voigt", "standard-linear", "bingham"]:
        material = scene_of(law, viscosity=None, shear_viscosity="10 Pa*s").material
        assert material.viscosity == 30
        assert material.notes[0] == "viscosity 10 Pa s in shear = 30 Pa s in tension, times 3"
        faults = faults_of(table(law, viscosity=None, shear_consistency="10 Pa*s"))
        assert "material.shear_consistency" in [fault.path for fault in faults]


def test_modes() -> None:
    assert scene_of("multimode-maxwell").material.modes == (Mode(1e6, 2e3), Mode(3e6, 50.0))
    one = MODES[:1]
    bad: list[tuple[Any, list[tuple[str, str]]]] = [
        ([], [("", "missing: the law 'multimode-maxwell' needs it")]),
        ("1 MPa", [("", "'1 MPa' is not a list")]),
        (one * 51, [("", "a list of 51; accepted: a list of modes, at most 50")]),
        ([3, *one], [(".1", "3 is not a table")]),
        ([*one, {"youngs_modulus": "1 MPa"}], [(".2.viscosity", "missing")]),
        ([*one, one[0] | {"width": 1}], [(".2.width", "unknown key; accepted: youngs_modulus, viscosity")]),
        (
            [{"youngs_modulus": "-1 MPa", "viscosity": "1 Pa"}],
            [(".1.youngs_modulus", "is negative"), (".1.viscosity", "'Pa' is a stress, not a viscosity")],
        ),
    ]
    for modes, expected in bad:
        faults = faults_of(table("multimode-maxwell", modes=modes))
        assert [fault.path for fault in faults] == [f"material.modes{path}" for path, _ in expected]
        assert all(says in str(fault) for fault, (_, says) in zip(faults, expected, strict=True))


# Quantities as rheologists write them: each is converted and said, given once, and replaced by an override.
def table_other_names(**changes: Any) -> dict[str, Any]:
    found: dict[str, Any] = {
        "filament": {"span": "20 mm", "diameter": "1 mm", "density": "1050 kg/m^3"},
        "material": {"law": "elastic", "storage_modulus": "15 kPa", "loss_modulus": "0.75 kPa"},
        "run": {"duration": "1 s"},
    }
    for path, value in changes.items():
        part, _, key = path.partition("__")
        found[part].pop(key, None)
        if value is not None:
            found[part][key] = value
    return found


def faults(**changes: Any) -> list[str]:
    with pytest.raises(SceneError) as refused:
        Scene.model_validate(table_other_names(**changes))
    return [str(fault) for fault in refused.value.faults]


def test_each_is_the_quantity_that_it_names_and_is_said() -> None:
    scene = Scene.model_validate(table_other_names())
    assert scene.filament.thickness == scene.filament.width == 1e-3
    assert scene.filament.section == "circle"
    assert scene.material.youngs_modulus == pytest.approx(2 * 1.45 * 15e3)
    assert scene.material.loss_tangent == pytest.approx(0.05)
    said = " ".join(scene.notes)
    assert all(name in said for name in ("diameter", "storage modulus", "loss modulus"))
    assert "2 (1 + 0.45)" in said
    bulky = Scene.model_validate(table_other_names(material__poisson=0.2))
    assert bulky.material.youngs_modulus == pytest.approx(2 * 1.2 * 15e3)


def test_a_consistency_is_the_one_in_shear() -> None:
    flows: dict[str, Any] = {"law": "power-law", "youngs_modulus": "45 kPa", "index": 0.4}
    short, long = (
        Scene.model_validate(table_other_names() | {"material": flows | {name: "60 Pa*s^0.4"}})
        for name in ("consistency", "shear_consistency")
    )
    assert short == long
    assert short.material.viscosity == pytest.approx(60 * 3**0.7)
    assert any("consistency" in note for note in short.notes)


def test_two_names_of_one_quantity_are_refused_by_both() -> None:
    for changes, both in [
        ({"filament__thickness": "1 mm"}, ("filament.thickness", "filament.diameter")),
        ({"material__youngs_modulus": "45 kPa"}, ("material.youngs_modulus", "material.storage_modulus")),
        ({"material__loss_tangent": 0.1}, ("material.loss_tangent", "material.loss_modulus")),
        ({"material__solid_viscosity": "1 Pa*s"}, ("material.solid_viscosity", "material.loss_modulus")),
        (
            {"material__loss_modulus": None, "material__loss_tangent": 0.1, "material__solid_viscosity": "1 Pa*s"},
            ("material.solid_viscosity", "material.loss_tangent"),
        ),
    ]:
        (fault,) = faults(**changes)
        assert all(path in fault for path in both)


def test_what_makes_no_sense_is_refused() -> None:
    for changes, path, says in [
        ({"material__loss_modulus": "-1 kPa"}, "material.loss_modulus", "is negative"),
        (
            {"material__storage_modulus": None, "material__law": "newtonian"},
            "material.loss_modulus",
            "without material.storage_modulus",
        ),
        ({"material__loss_modulus": None, "material__loss_tangent": -0.1}, "material.loss_tangent", "out of range"),
        ({"filament__section": "rectangle"}, "filament.section", "filament.diameter is given"),
        ({"filament__diameter": None}, "filament.thickness", "missing"),
        ({"filament__diameter": "30 mm"}, "filament.thickness", "not less than the span"),
        ({"run__closure": "printed"}, "material.loss_modulus", "run.closure = 'printed'"),
        ({"run__until": "never"}, "run.until", "duration, settled"),
    ]:
        found = [fault for fault in faults(**changes) if fault.startswith(path)]
        assert found
        assert says in found[0]


# A user's own flow rule: what is read, what is refused, and that the tree means what the text says.
def own(flow: object, parameters: object = None, **changes: Any) -> dict[str, Any]:
    """A scene of a custom law."""
    material = {"law": "custom", "youngs_modulus": "4 MPa", "flow": flow}
    if parameters is not None:
        material["parameters"] = parameters
    return spoiled({"material": material | changes})


SINH = {"s0": "1 kPa", "t0": "2 s"}


@given(
    st.recursive(
        st.sampled_from(["sigma", "a", "2.5"]),
        lambda x: st.tuples(x, st.sampled_from("+-*"), x).map(lambda t: f"({t[0]}{t[1]}{t[2]})"),
        max_leaves=12,
    )
)
@settings(max_examples=100, deadline=None)
def test_the_tree_agrees_with_python(text: str) -> None:
    names = {"__builtins__": {}, "sigma": 1.25, "a": -0.75}
    assert parse_formula(text).value(1.25, {"a": -0.75}) == eval(text, names)


HOSTILE = [
    ("__import__('os').system('true')", "is not arithmetic"),
    ("sigma.real", "'sigma.real' is not arithmetic"),
    ("().__class__.__bases__[0]", "is not arithmetic"),
    ("sigma[0]", "'sigma[0]' is not arithmetic"),
    ("lambda: sigma", "'lambda: sigma' is not arithmetic"),
    ("'sigma'", "is not arithmetic"),
    ("sigma > 0", "'sigma > 0' is not arithmetic"),
    ("sigma if sigma else 0", "is not arithmetic"),
    ("[sigma for sigma in (1,)]", "is not arithmetic"),
    ("(sigma := 3)", "is not arithmetic"),
    ("sigma, sigma", "is not arithmetic"),
    ("await sigma", "is not"),
    ("True*sigma", "'True' is not arithmetic"),
    ("1j*sigma", "'1j' is not arithmetic"),
    ("sigma % 2", "is not arithmetic"),
    ("sigma^2", "accepted: ** for powers"),
    ("eval(sigma)", "unknown function 'eval'"),
    ("sinn(sigma)", "did you mean 'sin'?"),
    ("exp", "the function exp has no argument"),
    ("exp()", "exp of 0 arguments"),
    ("max(sigma)", "max of 1 arguments; accepted: max of two arguments"),
    ("exp(*sigma)", "is not arithmetic"),
    ("sigma; import os", "is no formula"),
    ("", "empty"),
    ("  ", "empty"),
    ("\0", "accepted"),
    ("sigma +", "is no formula"),
    ("(" * 10_000 + "sigma" + ")" * 10_000, "characters long"),
    ("abs(" * 70 + "-" * 40 + "sigma" + ")" * 70, "nested more than"),
    ("--" * 100 + "sigma", "nested more than"),
    ("1e999", "is not finite"),
]


def test_what_is_no_arithmetic_is_refused_by_name() -> None:
    for text, says in HOSTILE:
        before = time.process_time()
        with pytest.raises(PydanticCustomError) as caught:
            parse_formula(text)
        assert says in str(caught.value)
        assert len(str(caught.value)) < 400
        assert time.process_time() - before < 10
        if text.strip():
            (fault,) = faults_of(own(text))
            assert fault.path == "material.flow"
            assert says in str(fault)


SOUND: list[tuple[str, dict[str, Any], float]] = [
    ("sinh(sigma/s0)/t0", SINH, 0.0),
    ("sigma/eta", {"eta": "3 kPa*s"}, 0.0),
    ("sign(sigma)*(abs(sigma)/K)**(1/n)", {"K": "120 Pa*s^0.4", "n": 0.4}, 0.0),
    ("sigma*abs(sigma)**1.5/K**2.5", {"K": "120 Pa*s^0.4"}, 0.0),
    ("sign(sigma)*max(abs(sigma) - sY, 0)/eta", {"sY": "9.32 kPa", "eta": "3 kPa*s"}, 9320.0),
    ("sign(sigma)*(max(abs(sigma) - sY, 0)/K)**(1/n)", {"sY": "37 Pa", "K": "3 Pa*s^0.3", "n": 0.3}, 37.0),
    ("(max(sigma - sY, 0) + min(sigma + sY, 0))/eta", {"sY": "1 mPa", "eta": "1 Pa*s"}, 1e-3),
    ("sqrt(sigma**2/s0**2)*sigma/s0/t0", SINH, 0.0),
    ("sign(sigma)*sqrt(abs(sigma))/c", {"c": "2 Pa^0.5*s"}, 0.0),
    ("(sigma/s0)**61/t0", SINH, 0.0),
    ("(1/(1 + exp(-sigma/s0)) - 0.5)/t0", SINH, 0.0),
]


def test_a_sound_rule_is_taken_and_its_threshold_found() -> None:
    for flow, parameters, yields_at in SOUND:
        scene = Scene.model_validate(own(flow, parameters))
        assert Scene.model_validate(tomllib.loads(scene.to_toml())) == scene
        material = scene.material
        assert material.threshold == pytest.approx(yields_at, rel=1e-12, abs=1e-300)
        values = material.values()
        assert set(values) == {"youngs_modulus", *parameters} | ({"yield_stress"} if yields_at else set())
        assert material.formula is not None
        if yields_at:
            assert material.formula.value(material.threshold, values) == 0
            assert material.formula.value(material.threshold * (1 + 1e-9), values) > 0


UNSOUND: list[tuple[str, dict[str, Any], list[tuple[str, str]]]] = [
    ("sinh(sigma)/t0", {"t0": "1 s"}, [("flow", "the argument 'sigma' of sinh is of unit Pa")]),
    ("sinh(sigma/s0)", {"s0": "1 kPa"}, [("flow", "is a pure number; accepted: a strain rate, 1/s")]),
    ("sigma/s0", {"s0": "1 kPa*s^2"}, [("flow", "of unit s^-2")]),
    ("sigma/s0 + 1/t0*sigma", {"s0": "1 Pa*s", "t0": "1 s"}, [("flow", "puts 'sigma/s0', of unit 1/s, beside")]),
    ("max(sigma, 1)/s0", {"s0": "1 Pa*s"}, [("flow", "puts 'sigma', of unit Pa, beside '1', a pure number")]),
    ("2**sigma/t0", {"t0": "1 s"}, [("flow", "the exponent 'sigma' is of unit Pa")]),
    ("abs(sigma)**(sigma/s0)/t0", SINH, [("flow", "the exponent depends on sigma")]),
    ("sinh(sigma/s0)/t0", {"s0": 1000.0, "t0": "1 s"}, [("flow", "'sigma/s0' of sinh is of unit Pa")]),
    ("sinh(sigma/s1)/t0", SINH, [("flow", "unknown symbol 's1'"), ("parameters.s0", "not used by material.flow")]),
    ("sinh(sigma/a)/b", {}, [("flow", "unknown symbol 'a'"), ("flow", "unknown symbol 'b'")]),
    ("1/t0", {"t0": "1 s"}, [("flow", "the rate without stress is 1 1/s")]),
    ("(sigma/s0)**2/t0", SINH, [("flow", "not odd: ")]),
    ("sign(sigma)*sqrt(sigma/s0)/t0", SINH, [("flow", "not odd: ")]),
    ("log(sigma/s0)/t0", SINH, [("flow", "the rate without stress is nan")]),
    ("sin(sigma/s0)/t0", SINH, [("flow", "negative dissipation")]),
    ("(sigma - sigma**3/s0**2)/s0/t0", SINH, [("flow", "negative dissipation")]),
    ("-sigma/eta", {"eta": "1 Pa*s"}, [("flow", "negative dissipation")]),
    ("sigma/eta", {"eta": "-1 Pa*s"}, [("flow", "negative dissipation")]),
    ("s0/sigma/t0", SINH, [("flow", "the rate without stress is")]),
    ("0*sigma", {}, [("flow", "nothing flows at any stress")]),
    ("sigma/eta", {"eta": "0 Pa*s"}, [("flow", "at sigma =")]),
    ("log(1 - sigma/s0)/t0 - log(1 + sigma/s0)/t0", SINH, [("flow", "")]),
]


def test_an_unsound_rule_is_refused() -> None:
    for flow, parameters, expected in UNSOUND:
        faults = faults_of(own(flow, parameters))
        assert [fault.path for fault in faults] == [f"material.{path}" for path, _ in expected]
        for fault, (_, says) in zip(faults, expected, strict=True):
            assert says in str(fault)
