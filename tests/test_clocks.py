"""Materials that change while the filament hangs: histories, springs that join, natural strains; exact solutions."""

from __future__ import annotations

import math
import pickle
import tomllib
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad

import softcat_sym as sc
from softcat_sym.discretization.casadi_printer import evaluate
from softcat_sym.effects.selection import choose_effects
from softcat_sym.fitting.free_parameters import candidates, free_parameters, with_values
from softcat_sym.physics.clocks import varying
from softcat_sym.physics.symbols import t
from softcat_sym.physics.terms import Course
from softcat_sym.scene.history import ChangingQuantity, History

BACKENDS = ("interpreted", "compiled")

STRESS = ChangingQuantity("stress", "9 kPa")
BAR = {"span": 0.2, "thickness": 0.002, "density": 1000.0}
TABLE = {"0 s": "200 Pa", "20 s": "500 Pa", "1 min": "900 Pa"}
FORMULAS = (
    "200 Pa + 5 Pa/s*t",
    "1 kPa*(2 - exp(-t/20 s))",
    "min(200 Pa + 10 Pa/s*t, 1 kPa)",
    "1 kPa*(1 + t/1 min)**0.5",
    "200 Pa + 3 Pa*abs(t/1 s - 40)",
)


def scene(material: Mapping[str, Any], **tables: Mapping[str, Any]) -> sc.Scene:
    """A thin bar without weight, its effects and numerics as they are given."""
    given: dict[str, Any] = {"filament": BAR, "load": {"gravity": 0.0}, "run": {"duration": 1.0, "frames": 11}}
    given["numerics"] = {"estimate": False, "cells": 6}
    for name, table in tables.items():
        given[name] = {**given.get(name, {}), **table}
    return sc.Scene.from_dict({**given, "material": material})


@pytest.mark.parametrize("given", [TABLE, *FORMULAS], ids=str)
def test_a_history_is_one_expression_and_comes_back_from_its_file(given: Any) -> None:
    history = STRESS.read(given)
    assert isinstance(history, History)
    found, times = varying(Course.of("yield_stress", history)), np.linspace(0, 100, 83) + 0.0123
    numbers = {one.symbol: np.full(83, value) for one, value in zip(found.constants, history.numbers, strict=True)}
    wanted, step = np.array([history.at(time) for time in times]), 1e-6
    slopes = [(history.at(time + step) - history.at(time - step)) / (2 * step) for time in times]
    assert evaluate(found.value, {t: times, **numbers}) == pytest.approx(wanted, rel=1e-12)
    assert evaluate(found.rate, {t: times, **numbers}) == pytest.approx(slopes, rel=1e-6, abs=1e-6)
    assert STRESS.read(STRESS.write(history)) == history == pickle.loads(pickle.dumps(history))
    assert history.scaled(2.0).at(30.0) == pytest.approx(2 * history.at(30.0))


@pytest.mark.parametrize(
    ("given", "path", "words"),
    [
        ("200 Pa + 5 Pa*t", "material.yield_stress", "beside"),
        ("200 Pa + 5 Pa/s*t*x", "material.yield_stress", "unknown name 'x'"),
        ("200 Pa + 5 Pa / s * t", "material.yield_stress", "unknown name 's'"),
        ("exp(t)*1 Pa", "material.yield_stress", "is of unit s"),
        ("200 Pa*t^2", "material.yield_stress", "** for powers"),
        ("(2 Pa)**(t/1 s)", "material.yield_stress", "exponent depends on t"),
        ("200 Pa + open('x')*t", "material.yield_stress", "unknown function 'open'"),
        ("200 Pa - 300 Pa/s*t", "material.yield_stress", "at every time of the run"),
        ("1 Pa/s*t", "material.yield_stress", "zero"),
        ("5 Foo/s*t", "material.yield_stress", "unknown unit 'Foo/s'"),
        ({"0 s": "200 Pa"}, "material.yield_stress", "a table of 1 times"),
        ({"0 s": "200 Pa", "60": "3 Pa"}, "material.yield_stress.60", "has no unit"),
        ({"0 s": "200 Pa", "60 s": "-3 Pa"}, "material.yield_stress.60 s", "negative"),
        ({"1 min": "200 Pa", "60 s": "3 Pa"}, "material.yield_stress.60 s", "twice"),
    ],
)
def test_a_fault_in_a_history_is_named_where_it_stands(given: object, path: str, words: str) -> None:
    material = {"law": "bingham", "youngs_modulus": 1e6, "viscosity": 1e3, "yield_stress": given}
    with pytest.raises(sc.SceneError) as error:
        scene(material)
    (fault,) = error.value.faults
    assert fault.path == path
    assert words in f"{fault.found}; {fault.accepted}"


@pytest.mark.parametrize("given", [-0.05, "-0.05*exp(-t/20 s)", "-0.05*t", "-3/1 s*t", {"0 s": 0, "1 s": -1.5}])
def test_a_natural_strain_is_a_history_from_zero(given: object) -> None:
    with pytest.raises(sc.SceneError, match=r"material\.natural_strain"):
        scene({"law": "elastic", "youngs_modulus": 1e6, "natural_strain": given})


def test_a_scene_with_histories_comes_back_from_its_file() -> None:
    modes = [{"youngs_modulus": {"0 s": "1 kPa", "9 s": "2 kPa"}, "viscosity": "1 kPa*s + 1 kPa*t"}]
    one = scene({"law": "multimode-maxwell", "modes": modes, "natural_strain": "-0.02*t/(t + 1 s)"})
    assert sc.Scene.model_validate(tomllib.loads(one.to_toml())) == one
    sheared = {
        "law": "bingham",
        "storage_modulus": "1 kPa + 1 Pa/s*t",
        "shear_viscosity": TABLE,
        "shear_yield_stress": 9.0,
    }
    with pytest.raises(sc.SceneError, match=r"shear_viscosity\.0 s"):
        scene(sheared)
    other = scene({**sheared, "shear_viscosity": "2 Pa*s", "shear_yield_stress": TABLE})
    assert sc.Scene.model_validate(tomllib.loads(other.to_toml())) == other
    assert other.at(60.0).material.yield_stress == pytest.approx(math.sqrt(3) * 900)


def pulled(modulus: Any, backend: str, **numerics: Any) -> sc.Run:
    """A bar whose right end is drawn away by 10 % within a second."""
    names = ["bending", "extensibility", "finite-stretch", "thinning", "curing"]
    run = {"effects": names, "accuracy": 1e-5}
    ends = {"motion": [[0.0, 0.0, 0.0], [1.0, 0.02, 0.0]]}
    material = {"law": "elastic", "youngs_modulus": modulus}
    return sc.simulate(scene(material, ends=ends, run=run, numerics={"backend": backend, **numerics}))


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("growth", [4.0, -0.8])
def test_springs_that_join_are_without_stress_and_those_that_break_let_go(backend: str, growth: float) -> None:
    def modulus(time: float) -> float:
        return 1e6 * math.exp(growth * time)

    run = pulled(f"1 MPa*exp({growth!r}*t/1 s)", backend)
    strain = math.log(1.1)
    joined = quad(lambda time: modulus(time) * 0.1 / (1 + 0.1 * time), 0, 1)[0]
    wanted = (joined if growth > 0 else modulus(1.0) * strain) * 4e-6 / 1.1
    assert float(run.data["tension"][-1, 3]) == pytest.approx(wanted, rel=2e-4)
    assert run.summary["energy_residual"] < 1e-3


@pytest.mark.parametrize("theory", [["bending"], ["bending", "shear"]], ids=str)
def test_a_held_strand_that_shrinks_tightens(theory: list[str]) -> None:
    names = ["extensibility", "finite-stretch", "thinning", "large-rotation", "natural-strain", *theory]
    material = {"law": "elastic", "youngs_modulus": 1e6, "natural_strain": "-0.05*t/1 s"}
    run = sc.simulate(scene(material, run={"effects": names}, numerics={"backend": "interpreted"}))
    # Of a section that has shrunk in all directions, so that the filament has the volume exp(-0.15) of the beginning.
    wanted = 4e-6 * math.exp(-0.15) * 1e6 * 0.05
    assert run.data["tension"].values[-1] == pytest.approx(np.full(12, wanted), rel=1e-6)
    assert float(run.data["energy_elastic"][-1]) == pytest.approx(wanted * 0.05 / 2 * 0.2, rel=1e-6)
    assert run.summary["energy_residual"] < 1e-6


@pytest.mark.parametrize("backend", BACKENDS)
def test_what_resists_does_not_feel_the_strain_without_stress(backend: str) -> None:
    names = ["bending", "extensibility", "finite-stretch", "thinning", "viscous-stress", "natural-strain"]
    material = {"law": "kelvin-voigt", "youngs_modulus": 1e6, "viscosity": 1e5, "natural_strain": "-0.05*t/1 s"}
    run = sc.simulate(scene(material, run={"effects": names, "accuracy": 1e-4}, numerics={"backend": backend}))
    wanted = 4e-6 * math.exp(-0.15) * (1e6 * 0.05 + 1e5 * 0.05)
    assert run.data["tension"].values[-1] == pytest.approx(np.full(12, wanted), rel=1e-5)
    assert run.summary["energy_residual"] < 1e-4


@pytest.mark.parametrize("theory", [["bending"], ["bending", "shear"]], ids=str)
def test_a_cable_that_has_shrunk_is_a_smaller_one_of_the_same_mass(theory: list[str]) -> None:
    names = ["extensibility", "finite-stretch", "thinning", "large-rotation", *theory]
    shrunk, kept = math.exp(-0.03), {"load": {"gravity": 9.81}, "numerics": {"backend": "interpreted"}}
    drying = {"law": "elastic", "youngs_modulus": 1e5, "natural_strain": "-0.03*t/1 s"}
    slack = {"rest_length": 0.22, "thickness": 0.002, "width": 0.003, "density": 1000.0}
    one = sc.simulate(scene(drying, filament=slack, run={"effects": [*names, "natural-strain"]}, **kept))
    smaller = {name: value * shrunk for name, value in slack.items()} | {"density": 1000.0 / shrunk**3}
    other = sc.simulate(scene({**drying, "natural_strain": 0.0}, filament=smaller, run={"effects": names}, **kept))
    assert one.data["y"].values[-1] == pytest.approx(other.data["y"].values[-1], rel=1e-6, abs=1e-9)
    assert one.data["tension"].values[-1] == pytest.approx(other.data["tension"].values[-1], rel=1e-6)
    assert one.data["thickness"].values[-1] == pytest.approx(other.data["thickness"].values[-1], rel=1e-6)


@pytest.mark.parametrize(("section", "factor"), [("rectangle", 1.0), ("circle", 1.0), ("sheet", 1.45)])
@pytest.mark.parametrize("theory", [["bending"], ["bending", "shear"]], ids=str)
def test_a_free_strand_whose_top_shrinks_curls_without_stress(theory: list[str], section: str, factor: float) -> None:
    names = ["extensibility", "finite-stretch", "thinning", "large-rotation", "natural-strain", *theory]
    material = {"law": "elastic", "youngs_modulus": 1e6, "natural_strain_difference": "-0.02*t/1 s"}
    filament = {"section": section, "width": 0.002}
    given = {"filament": filament, "ends": {"right": "free"}, "run": {"effects": names}}
    run = sc.simulate(scene(material, **given, numerics={"backend": "interpreted"}))
    # Its curvature is the difference over the thickness; of a sheet 1 + nu times as much, since it cannot curl across.
    assert run.data["curvature"].values[-1, :-1] == pytest.approx(np.full(11, factor * 0.02 / 0.002), rel=1e-6)
    assert np.abs(run.data["stress_bending"].values[-1]).max() < 1e-3
    assert float(run.data["y"][-1, -1]) > 0.1


def test_a_fluid_that_shrinks_freely_is_without_stress() -> None:
    names = ["extensibility", "finite-stretch", "thinning", "bending", "viscous-stress", "natural-strain"]
    material = {"law": "newtonian", "viscosity": 1e3, "natural_strain": "-0.1*t/1 s"}
    free = sc.simulate(scene(material, ends={"right": "free"}, run={"effects": names}))
    assert free.data["stretch"].values[-1] == pytest.approx(np.full(12, math.exp(-0.1)), rel=1e-4)
    held = sc.simulate(scene(material, run={"effects": names}))
    assert held.data["stress_mean"].values[-1] == pytest.approx(np.full(12, 100.0), rel=1e-6)
    assert held.summary["energy_residual"] < 1e-6


HANGING = {
    "bingham": {"law": "bingham", "youngs_modulus": 4e6, "viscosity": 13.84e3, "yield_stress": 4e3},
    "kelvin-voigt": {"law": "kelvin-voigt", "youngs_modulus": 1e5, "viscosity": 1e3},
}
CHANGES: dict[str, dict[str, Any]] = {
    "bingham": {
        "youngs_modulus": "4 MPa*(1 + t/0.1 s)",
        "yield_stress": {"0 s": "4 kPa", "0.1 s": "5 kPa", "0.15 s": "8 kPa"},
        "natural_strain": "-0.01*t/0.2 s",
        "natural_strain_difference": "0.004*t/0.2 s",
    },
    "kelvin-voigt": {"youngs_modulus": "100 kPa*exp(-t/0.3 s)", "viscosity": "1 kPa*s*(1 + t/0.1 s)"},
}


def hanging(law: str, backend: str, **changes: Any) -> sc.Run:
    """A strand in its weight."""
    filament = {"thickness": 0.006, "density": 1900.0}
    run = {"duration": 0.2, "frames": 9, "accuracy": 1e-3}
    material = {**HANGING[law], **changes}
    numerics = {"backend": backend, "cells": 8}
    given = scene(material, filament=filament, load={"gravity": 9.81}, run=run, numerics=numerics)
    return sc.simulate(given)


@pytest.mark.parametrize("law", [pytest.param("bingham", marks=pytest.mark.slow), "kelvin-voigt"])
def test_both_backends_agree_and_the_audit_closes(law: str) -> None:
    one, other = (hanging(law, backend, **CHANGES[law]) for backend in ("interpreted", "compiled"))
    assert "curing" in one.summary["effects"]
    scale = float(np.max(np.abs(one.data["midpoint"])))
    assert other.data["midpoint"].values == pytest.approx(one.data["midpoint"].values, abs=2e-4 * scale)
    assert other.summary["energy_residual"] < 1e-5
    largest = float(np.max(np.abs(one.data["work_ageing"])))
    assert largest > 0
    assert other.data["work_ageing"].values == pytest.approx(one.data["work_ageing"].values, abs=2e-3 * largest)


def test_auto_takes_a_change_in_where_it_matters() -> None:
    def chosen(limit: str) -> sc.Scene:
        return scene(
            {**HANGING["bingham"], "yield_stress": limit}, filament={"thickness": 0.006}, load={"gravity": 9.81}
        )

    assert "curing" in choose_effects(chosen("1 kPa + 3 kPa/s*t")).names
    slow = choose_effects(chosen("1 kPa + 0.001 Pa/s*t"))
    assert "curing" not in slow.names
    assert 0 <= slow.left_out["curing"] < 1e-4
    with pytest.raises(sc.SceneError, match="'curing' cannot be had"):
        choose_effects(scene(HANGING["bingham"], run={"effects": ["extensibility", "curing"]}))


def test_what_is_free_keeps_its_history() -> None:
    table = {"0 s": "100 Pa", "1 s": "300 Pa"}
    material = {"law": "bingham", "youngs_modulus": 1e6, "shear_viscosity": "200 Pa*s + 5 Pa*t"}
    given = scene({**material, "yield_stress": table})
    known = {one.name: one for one in candidates(given)}
    assert [known[f"yield_stress_{k}"].typical for k in (1, 2)] == [100.0, 300.0]
    assert [known[f"shear_viscosity_{k}"].unit for k in (1, 2)] == ["Pa*s", "Pa"]

    def with_free(**values: float) -> sc.Scene:
        return with_values(given, free_parameters(given, list(values)), list(values.values()))

    # Scaled as a whole, or one number of it; what is not free stays, in tension as in shear.
    assert with_free(yield_stress=200.0).material.yield_stress.at(1.0) == 600.0
    changed = with_free(yield_stress_2=500.0, poisson=0.3).material
    assert [changed.yield_stress.at(time) for time in (0.0, 1.0)] == [100.0, 500.0]
    assert changed.viscosity.at(1.0) == pytest.approx(3 * 205)
    assert with_free(shear_viscosity=400.0).material.viscosity.at(1.0) == pytest.approx(3 * 410)
    assert with_free(shear_viscosity_2=7.0).material.viscosity.at(1.0) == pytest.approx(3 * 207)
