"""What was left out is measured on the finished run: against the same run with it, to within a factor of five."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
import pytest

from softcat_sym import simulate
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.effect import Estimate
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.results.verdict import missing_effect
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import Outcome

CABLE = ("bending", "extensibility", "finite-stretch", "thinning", "large-rotation")
WEIGHT = 1e4
"""rho g L [Pa], L = 1 m."""
GUIDED = {"clamped": 32.0, "pinned": 6.4, "free": 32 * 12 / 204}
"""E (h0/L)^2 H over rho g L^2 of the linear beam: 384/12, 384/60 and, of the middle of a cantilever, 384/204."""
FACTOR = 5.0


def scene_of(effects: Sequence[str], thickness: float, E: float, right: str = "clamped", **tables: Any) -> Scene:
    """An elastic filament of span 1 m at rest under its weight, unless tables say otherwise."""
    table: dict[str, Any] = {
        "filament": {"span": "1 m", "thickness": f"{thickness!r} m", "density": "1000 kg/m^3"},
        "material": {"law": "elastic", "youngs_modulus": f"{float(E)!r} Pa"},
        "ends": {"left": "clamped" if right == "free" else right, "right": right},
        "load": {"gravity": "10 m/s^2"},
        "run": {"duration": "1 s", "frames": 2, "effects": list(effects)},
        "numerics": {"cells": 20, "estimate": False},
    }
    for name, values in tables.items():
        table[name] = table.get(name, {}) | values
    return Scene.model_validate(table)


def beam_modulus(thickness: float, sag: float, right: str = "clamped") -> float:
    """Young's modulus at which the linear beam sags so far."""
    return WEIGHT / (GUIDED[right] * thickness**2 * sag)


@cache
def run(scene: Scene) -> Trajectory:
    """One run for all that is left out of it."""
    done = simulate(scene)
    assert done.outcome.is_success, done.summary["message"]
    return done


def measured_and_true(scene: Scene, *absent: str, first: int = 0) -> tuple[float, float]:
    """The measure of the first effect absent on a run without them, and the change from a first frame on."""
    names = [name for name in scene.run.effects if name not in absent]
    whole, reduced = run(scene), run(scene.replace({"run.effects": names}))
    y, without = (done.data["midpoint"].values[first:] for done in (whole, reduced))
    change = float(np.max(np.abs(without - y)) / np.max(np.abs(y)))
    measure = float(reduced.summary["checked"][absent[0]])
    print(f"{absent[0]}: measured {measure:.3g}, changes the midpoint by {change:.3g}")
    return measure, change


def assert_tells(scene: Scene, *absent: str, least: float = 1 / FACTOR, most: float = FACTOR, first: int = 0) -> None:
    """The measure is the change, to within factors."""
    measure, change = measured_and_true(scene, *absent, first=first)
    assert change > 1e-4, "nothing to measure"
    assert least < measure / change < most


@pytest.mark.parametrize("periods", [2, 5, 10])
def test_inertia_left_out_of_a_beam_that_is_loaded_slowly(periods: int) -> None:
    thickness = 0.05
    E = beam_modulus(thickness, 0.005)
    period = 2 * np.pi / (4.730041**2 * np.sqrt(E * thickness**2 / 12 / 1000))
    ramp, duration = f"{float(periods * period)!r} s", f"{float(1.2 * periods * period)!r} s"
    tables = {"load": {"ramp": ramp}, "run": {"duration": duration, "frames": 101}}
    tables["run"]["effects"] = ["inertia", "gravity-ramp", "bending"]
    assert_tells(scene_of((), thickness, E, **tables), "inertia")


def test_inertia_left_out_of_a_beam_that_rings_is_everything() -> None:
    scene = scene_of(("bending",), 0.05, beam_modulus(0.05, 0.005), run={"frames": 41, "duration": "0.3 s"})
    measure, change = measured_and_true(scene.replace({"run.effects": ["inertia", "bending"]}), "inertia")
    assert change > 0.4
    assert measure > 0.4


def test_geometry_left_out_of_a_cable() -> None:
    for effect in ["finite-stretch", "thinning", "large-rotation"]:
        for E in [100 * WEIGHT, 1000 * WEIGHT]:
            assert_tells(scene_of(CABLE, 1e-3, E), effect)


def test_large_rotation_left_out_of_a_cantilever() -> None:
    assert_tells(scene_of(CABLE, 0.05, beam_modulus(0.05, 0.1, "free"), "free"), "large-rotation")


@pytest.mark.parametrize("thickness", [0.003, 0.01])
def test_bending_left_out_of_a_cable(thickness: float) -> None:
    assert_tells(scene_of(CABLE, thickness, 100 * WEIGHT), "bending")


@pytest.mark.parametrize("right", GUIDED)
def test_shear_left_out_of_a_thick_beam(right: str) -> None:
    assert_tells(scene_of((*CABLE, "shear"), 0.1, beam_modulus(0.1, 0.005, right), right), "shear")


@pytest.mark.parametrize("right", ["clamped", "pinned"])
def test_extensibility_left_out_of_a_beam_that_sags_by_half_its_thickness(right: str) -> None:
    """It is 14 % between clamps and more than a third between pins."""
    scene = scene_of(("bending", "extensibility"), 0.05, beam_modulus(0.05, 0.025, right), right)
    assert_tells(scene, "extensibility", least=0.8, most=1.5)


def test_extensibility_left_out_of_a_cantilever_is_nothing() -> None:
    scene = scene_of(("bending", "extensibility"), 0.05, beam_modulus(0.05, 0.025, "free"), "free")
    measure, change = measured_and_true(scene, "extensibility")
    assert change < 1e-9
    assert measure < 1e-3


def flowing(law: str, effects: Sequence[str], **tables: Any) -> Scene:
    """A beam whose law gives way within a second."""
    material = {"law": law, "viscosity": f"{tables.pop('eta') * beam_modulus(0.05, 0.005)!r} Pa*s"}
    tables["run"] = {"frames": 21} | tables.get("run", {})
    return scene_of(effects, 0.05, beam_modulus(0.05, 0.005), material=material, **tables).replace(
        {"run.effects": list(effects)}
    )


@pytest.mark.parametrize("eta", [3.0, 30.0])
def test_viscous_flow_left_out_of_a_beam(eta: float) -> None:
    assert_tells(flowing("maxwell", ("bending", "viscous-flow"), eta=eta), "viscous-flow")


@pytest.mark.parametrize("eta", [0.03, 0.3])
def test_viscous_stress_left_out_of_a_solid(eta: float) -> None:
    """It comes to rest late: exp(-E t/eta) is missing, most at the first frame after the load."""
    scene = flowing("kelvin-voigt", ("bending", "viscous-stress"), eta=eta)
    assert_tells(scene, "viscous-stress", least=0.8, most=1.2, first=1)


def test_the_ramp_left_out_is_the_sag_that_it_delays() -> None:
    tables = {"load": {"ramp": "0.5 s"}, "run": {"frames": 21}}
    assert_tells(flowing("maxwell", ("bending", "viscous-flow", "gravity-ramp"), eta=3.0, **tables), "gravity-ramp")


def test_only_what_was_left_out_and_can_be_had_is_measured() -> None:
    checked = run(scene_of(("bending", "extensibility"), 0.05, beam_modulus(0.05, 0.025))).summary["checked"]
    assert {"inertia", "shear", "thinning", "finite-stretch", "large-rotation", "rotary-inertia"} <= set(checked)
    assert not {"bending", "extensibility", "viscous-flow", "yielding", "gravity-ramp"} & set(checked)
    assert all(np.isfinite(value) and value >= 0 for value in checked.values())


def with_auto(**changes: Any) -> tuple[Scene, Any]:
    """A scene that leaves its effects to the program, with what it then has."""
    asked = {"effects": "auto", "accuracy": 0.01}
    scene = scene_of((), 0.01, beam_modulus(0.01, 1e-5), load={"ramp": "0.5 s"}, run=asked, **changes)
    return scene, choose_effects(scene)


@pytest.mark.parametrize(("value", "told"), [(0.0101, True), (0.0099, False)])
def test_more_than_the_accuracy_is_overlooked(value: float, told: bool) -> None:
    scene, effects = with_auto()
    assert "thinning" not in effects.names
    found = missing_effect(scene, effects, {"thinning": Estimate(value, "half the strain")}, Outcome.solved)
    assert set(found) == ({"thinning"} if told else set())
    assert all("worth about 1 % of the sag" in text for text in found.values())


@pytest.mark.parametrize("asked", [{"run.effects": "paper"}, {"run.effects": ["bending"]}, {"run.closure": "printed"}])
def test_what_the_user_has_left_out_is_not_overlooked(asked: dict[str, Any]) -> None:
    scene = with_auto()[0].replace(asked)
    measured = {"shear": Estimate(1.0, "much")}
    assert missing_effect(scene, choose_effects(scene), measured, Outcome.solved) == {}
    assert missing_effect(scene, choose_effects(scene), measured, Outcome.no_convergence) == {}


def test_a_run_that_fails_wants_the_published_theory() -> None:
    scene, effects = with_auto()
    measured = {name: Estimate(1e-9, "nothing") for name in ("thinning", "large-rotation", "shear", "rotary-inertia")}
    for outcome in (Outcome.no_convergence, Outcome.no_equilibrium, Outcome.step_limit, Outcome.non_finite):
        assert set(missing_effect(scene, effects, measured, outcome)) == {"thinning", "large-rotation"}
    assert missing_effect(scene, effects, measured, Outcome.energy_drift) == {}


def test_a_neck_wants_its_gradient_and_nothing_else() -> None:
    maxwell = {"law": "maxwell", "viscosity": f"{1e6 * beam_modulus(0.01, 1e-5)!r} Pa*s"}
    scene, effects = with_auto(material=maxwell)
    assert not {"necking-gradient", "thinning"} & set(effects.names)
    measured = {name: Estimate(0.0, "") for name in ("necking-gradient", "thinning")}
    assert set(missing_effect(scene, effects, measured, Outcome.localised)) == {"necking-gradient"}


def test_the_ramp_left_out_of_what_hangs_at_once_is_everything() -> None:
    """Without inertia and flow the whole sag is there from the first frame on."""
    tables = {"load": {"ramp": "0.5 s"}, "run": {"frames": 21}}
    scene = scene_of(("bending",), 0.05, beam_modulus(0.05, 0.005), **tables).replace(
        {"run.effects": ["bending", "gravity-ramp"]}
    )
    measure, change = measured_and_true(scene, "gravity-ramp")
    assert change == pytest.approx(1, rel=1e-3)
    assert measure > 0.5
