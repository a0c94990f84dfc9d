"""Quantities as rheologists write them: each is converted and said, given once, and replaced by an override."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError
from softcat_sym.scene.scene import Scene


def table(**changes: Any) -> dict[str, Any]:
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
        Scene.model_validate(table(**changes))
    return [str(fault) for fault in refused.value.faults]


def test_each_is_the_quantity_that_it_names_and_is_said() -> None:
    scene = Scene.model_validate(table())
    assert scene.filament.thickness == scene.filament.width == 1e-3
    assert scene.filament.section == "circle"
    assert scene.material.youngs_modulus == pytest.approx(2 * 1.45 * 15e3)
    assert scene.material.loss_tangent == pytest.approx(0.05)
    said = " ".join(scene.notes)
    assert all(name in said for name in ("diameter", "storage modulus", "loss modulus"))
    assert "2 (1 + 0.45)" in said
    bulky = Scene.model_validate(table(material__poisson=0.2))
    assert bulky.material.youngs_modulus == pytest.approx(2 * 1.2 * 15e3)


def test_a_consistency_is_the_one_in_shear() -> None:
    flows: dict[str, Any] = {"law": "power-law", "youngs_modulus": "45 kPa", "index": 0.4}
    short, long = (
        Scene.model_validate(table() | {"material": flows | {name: "60 Pa*s^0.4"}})
        for name in ("consistency", "shear_consistency")
    )
    assert short == long
    assert short.material.viscosity == pytest.approx(60 * 3**0.7)
    assert any("consistency" in note for note in short.notes)


def test_the_scene_as_resolved_is_the_same_scene() -> None:
    for scene in (Scene.model_validate(table()), sc.load_scene("agar-bar", {"run.until": "settled"})):
        again = Scene.model_validate(tomllib.loads(scene.to_toml()))
        assert again == scene
        assert again.filament == scene.filament
        assert again.to_toml().count("youngs_modulus") == 1
    viscous = Scene.model_validate(table(material__loss_modulus=None, material__solid_viscosity="2 Pa*s"))
    assert Scene.model_validate(tomllib.loads(viscous.to_toml())).material.solid_viscosity == 2


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


@pytest.mark.parametrize("law", ["newtonian", "kelvin-voigt"])
def test_a_law_that_cannot_have_a_loss_is_named(law: str) -> None:
    constants = {"law": law, "viscosity": "1 Pa*s", "loss_tangent": 0.1}
    constants |= {"youngs_modulus": "1 kPa"} if law == "kelvin-voigt" else {}
    with pytest.raises(SceneError) as refused:
        Scene.model_validate(table() | {"material": constants})
    (fault,) = refused.value.faults
    assert fault.path == "material.loss_tangent"
    assert f"'{law}'" in fault.found
    assert "elastic" in fault.accepted


def test_an_override_replaces_the_other_name() -> None:
    by_thickness = sc.load_scene("ink-bridge", {"filament.diameter": "0.5 mm"})
    assert by_thickness.filament.thickness == 5e-4
    agar = sc.load_scene("agar-bar", {"filament.thickness": "5 mm", "material.loss_tangent": 0.2})
    assert (agar.filament.thickness, agar.filament.section, agar.material.loss_tangent) == (5e-3, "circle", 0.2)
    assert sc.load_scene("agar-bar", {"material.solid_viscosity": "3 Pa*s"}).material.loss_tangent == 0
    stiff = sc.load_scene("agar-bar", {"material.storage_modulus": "30 kPa"})
    assert stiff.material.loss_tangent == pytest.approx(0.025)
    soft = sc.load_scene("agar-bar", {"material.youngs_modulus": "22.35 kPa"})
    assert soft.material.loss_tangent == pytest.approx(0.1)
    grouped = sc.load_scene("no-yield", {"filament.diameter": "5 mm", "material.storage_modulus": "1 MPa"})
    assert grouped.filament.thickness == 5e-3
    assert grouped.material.youngs_modulus == pytest.approx(2.9e6)
    bread = sc.load_scene("bread-dough")
    thinner = sc.load_scene("bread-dough", {"material.consistency": f"1 kPa*s^{bread.material.index}"})
    assert thinner.material.viscosity == pytest.approx(1e3 * 3 ** ((bread.material.index + 1) / 2))
    replaced = agar.replace({"filament.diameter": "4 mm"})
    assert replaced.filament.thickness == replaced.filament.width == 4e-3


def test_groups_count_them_too() -> None:
    scene = Scene.model_validate(
        {"groups": {"delta": 0.03, "law": "elastic", "duration": 5}, "material": {"storage_modulus": "1 MPa"}}
    )
    assert scene.material.youngs_modulus == pytest.approx(2.9e6)
    with pytest.raises(SceneError, match=r"filament.diameter: given twice, here and as groups.delta"):
        Scene.model_validate(
            {"groups": {"delta": 0.03, "law": "elastic", "duration": 5}, "filament": {"diameter": "1 mm"}}
        )


def test_they_are_keys_that_may_be_varied() -> None:
    from softcat_sym.studies.sweep_table import read_axes

    axes = read_axes(sc.load_scene("agar-bar"), ["filament.diameter=4:6 mm:3", "material.loss_tangent=0.1,0.2"])
    assert axes[0].values == (4e-3, 5e-3, 6e-3)
    many = sc.simulate_many(
        sc.load_scene("agar-bar", {"run.frames": 3, "run.duration": "0.1 s", "numerics.cells": 8}),
        {"material.loss_tangent": [0.05, 0.8], "filament.diameter": [4e-3, 6e-3]},
    )
    assert len(set(many.data.midpoint[:, -1].values.tolist())) == 2
