"""Laws, their constants, shear data, lists of modes; and TOML there and back."""

from __future__ import annotations

import math
import pickle
import tomllib
from typing import Any, get_args

import pytest

from softcat_sym.scene.material import CONSTANTS, Law, Mode, Parameter
from softcat_sym.scene.scene import Scene

from .tables import BINGHAM, faults_of, spoiled

E: dict[str, Any] = {"youngs_modulus": "4 MPa"}
ETA: dict[str, Any] = {"viscosity": "3 kPa*s"}
MODES = [{"youngs_modulus": "1 MPa", "viscosity": "2 kPa*s"}, {"youngs_modulus": "3 MPa", "viscosity": "50 Pa*s"}]
LAWS: dict[str, dict[str, Any]] = {
    "elastic": E,
    "maxwell": E | ETA,
    "newtonian": ETA,
    "kelvin-voigt": E | ETA,
    "standard-linear": E | ETA | {"second_modulus": "1 MPa"},
    "multimode-maxwell": {"modes": MODES},
    "bingham": E | ETA | {"yield_stress": "9 kPa"},
    "power-law": E | {"viscosity": "120 Pa*s^0.4", "index": 0.4},
    "herschel-bulkley": E | {"viscosity": "0.12 kPa*s^0.4", "index": 0.4, "yield_stress": "9 kPa"},
    "custom": E
    | {
        "flow": "sign(sigma)*(max(abs(sigma) - tau_c, 0)/K)**(1/m)",
        "parameters": {"m": 0.4, "K": "1 Pa*s^0.4", "tau_c": "2 Pa"},
    },
}
VALUES: dict[str, dict[str, float]] = {
    "elastic": {"youngs_modulus": 4e6},
    "maxwell": {"youngs_modulus": 4e6, "viscosity": 3e3},
    "newtonian": {"viscosity": 3e3},
    "kelvin-voigt": {"youngs_modulus": 4e6, "viscosity": 3e3},
    "standard-linear": {"youngs_modulus": 4e6, "viscosity": 3e3, "second_modulus": 1e6},
    "multimode-maxwell": {
        "mode_1_youngs_modulus": 1e6,
        "mode_1_viscosity": 2e3,
        "mode_2_youngs_modulus": 3e6,
        "mode_2_viscosity": 50.0,
    },
    "bingham": {"youngs_modulus": 4e6, "viscosity": 3e3, "yield_stress": 9e3},
    "power-law": {"youngs_modulus": 4e6, "viscosity": 120.0, "index": 0.4},
    "herschel-bulkley": {"youngs_modulus": 4e6, "viscosity": 120.0, "index": 0.4, "yield_stress": 9e3},
    "custom": {"youngs_modulus": 4e6, "m": 0.4, "K": 1.0, "tau_c": 2.0, "yield_stress": 2.0},
}


def table(law: str, **changes: Any) -> dict[str, Any]:
    """A scene of one law; None takes a constant out."""
    material = {"law": law} | LAWS[law] | changes
    return spoiled({"material": {name: value for name, value in material.items() if value is not None}})


def scene_of(law: str, **changes: Any) -> Scene:
    return Scene.model_validate(table(law, **changes))


def test_every_law_is_tried() -> None:
    assert set(LAWS) == set(VALUES) == set(CONSTANTS) == set(get_args(Law))


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
        assert (scene.material.formula is None) == (law != "custom")


def test_a_missing_constant_is_one_fault() -> None:
    for law, name in [(law, name) for law, constants in CONSTANTS.items() for name in (*constants,)]:
        (fault,) = faults_of(table(law, **{name: None}))
        assert (fault.path, fault.found) == (f"material.{name}", f"missing: the law '{law}' needs it")


def test_a_constant_too_many_is_one_fault() -> None:
    for law in LAWS:
        extra = {"youngs_modulus": "1 MPa", "yield_stress": "1 kPa", "second_modulus": "1 MPa", "modes": MODES}
        extra |= {"index": 0.5, "flow": "sigma/eta"}
        for name, value in extra.items():
            if name in LAWS[law]:
                continue
            faults = faults_of(table(law, **{name: value}))
            assert [fault.path for fault in faults] == [f"material.{name}"]
            assert f"the law '{law}'" in faults[0].found


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


def test_a_consistency_is_written_in_its_own_unit() -> None:
    for index in [0.3, 0.5, 1.0, 2.0, 1 / 3, 1e-5, 7.25]:
        scene = scene_of("power-law", index=index, viscosity=f"7 Pa*s^{index!r}")
        assert scene.material.viscosity == 7.0
        assert Scene.model_validate(tomllib.loads(scene.to_toml())) == scene
        if index == 1:
            assert scene_of("power-law", index=1, viscosity="7 Pa*s").material == scene.material


def test_a_consistency_may_be_written_with_rounded_exponents() -> None:
    thirds = scene_of("power-law", index=0.3333333333, viscosity="7 Pa*s^0.333333")
    assert thirds.material.viscosity == 7.0
    assert scene_of("power-law", index=0.5, viscosity="7 g/(cm*s^1.5)").material.viscosity == pytest.approx(0.7)


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
        (one * 51, [("", "51 modes; accepted: at most 50")]),
        ([3, *one], [(".1", "3 is not a mode")]),
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


def test_parameters_of_a_custom_law_can_be_replaced() -> None:
    scene = scene_of("custom")
    assert scene.material.parameters[-1] == Parameter("tau_c", 2.0, (1.0, -1.0, -2.0))
    other = scene.replace({"material.parameters.tau_c": "3 Pa"})
    assert other.material.threshold == pytest.approx(3.0, rel=1e-12)
    assert scene.material.threshold == pytest.approx(2.0, rel=1e-12)
    assert other != scene


def test_faults_of_a_material_come_with_the_others() -> None:
    bad = spoiled(
        {
            "material": {"law": "custom", "youngs_modulus": "4 MPa", "flow": "sigma^2", "parameters": {"pi": 3}},
            "run.frames": 1,
        },
        BINGHAM,
    )
    assert [fault.path for fault in faults_of(bad)] == ["material.flow", "material.parameters.pi", "run.frames"]
