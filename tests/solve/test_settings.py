"""Which integrator, and how tightly."""

from __future__ import annotations

import pytest

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SceneError
from softcat_sym.scene.reading import load_scene
from softcat_sym.solvers.settings import choose_settings

from .filaments import scene_of, settings_of, without


def test_what_rings_goes_to_the_method_that_keeps_it() -> None:
    for name, solver in [
        ("continual-descent", "cvodes"),
        ("silicone-thread", "cvodes"),
        ("arrested-underdamped", "rosenbrock"),
        ("no-yield", "rosenbrock"),
        ("maxwell-slow", "rosenbrock"),
    ]:
        scene = load_scene(name, {"run.effects": "paper"})
        chosen = choose_settings(scene, choose_effects(scene))
        assert chosen.solver == solver
        assert chosen.reason
        # Section angles are algebraic, which CVODES cannot hold.
        sheared = load_scene(name)
        # Where nothing yields the method of fifth order then takes few steps, damped or not.
        expected = {"continual-descent": "idas", "silicone-thread": "rosenbrock"}.get(name, solver)
        assert choose_settings(sheared, choose_effects(sheared)).solver == expected


def test_a_sheared_filament_that_creeps_to_rest_goes_to_idas_tightly() -> None:
    creeping, ringing = load_scene("arrested-overdamped"), load_scene("arrested-underdamped")
    chosen = choose_settings(creeping, choose_effects(creeping))
    assert (chosen.solver, choose_settings(ringing, choose_effects(ringing)).solver) == ("idas", "rosenbrock")
    assert chosen.rtol < 0.1 * creeping.run.accuracy


def test_elastic_filaments_ring() -> None:
    assert settings_of(scene_of("elastic")).solver == "rosenbrock"


def test_without_inertia_it_is_a_dae() -> None:
    assert settings_of(without(scene_of(), "inertia")).solver == "idas"


@pytest.mark.parametrize("solver", ["cvodes", "idas", "rosenbrock"])
def test_the_scene_overrules(solver: str) -> None:
    chosen = settings_of(scene_of().replace({"numerics.solver": solver, "numerics.rtol": 3e-7}))
    assert (chosen.solver, chosen.rtol) == (solver, 3e-7)
    assert "numerics.solver" in chosen.reason


@pytest.mark.parametrize("solver", ["cvodes", "idas", "rosenbrock"])
def test_tolerances_follow_the_accuracy_asked(solver: str) -> None:
    asked = scene_of().replace({"numerics.solver": solver, "run.accuracy": 1e-2})
    coarse, fine = settings_of(asked), settings_of(asked.replace({"run.accuracy": 1e-4}))
    assert fine.rtol == pytest.approx(coarse.rtol / 100)
    assert fine.atol == pytest.approx(coarse.atol / 100)
    assert coarse.rtol < 1e-2


def test_absolute_tolerances_follow_the_strain_expected() -> None:
    soft, stiff = scene_of("elastic"), scene_of("elastic").replace({"material.youngs_modulus": "40 GPa"})
    assert 0 < settings_of(stiff).atol < settings_of(soft).atol <= 0.01 * settings_of(soft).rtol


def test_bdf_stays_where_it_is_stable() -> None:
    assert settings_of(scene_of(), solver="cvodes").options()["max_order"] == 2
    assert settings_of(scene_of(), solver="idas").options()["max_order"] == 2
    assert "max_order" not in settings_of(scene_of(), solver="rosenbrock").options()


def test_cvodes_is_refused_without_inertia() -> None:
    scene = sc.load_scene(
        "arrested-overdamped",
        {"numerics.solver": "cvodes", "run.effects": ["bending", "viscous-flow", "yielding"], "numerics.cells": 8},
    )
    with pytest.raises(SceneError, match=r"numerics\.solver: 'cvodes' cannot"):
        sc.simulate(scene)
