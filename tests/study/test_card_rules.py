"""The rules of the sag card: each in its limit against the solver, and against numbers that were worked out by hand."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

from softcat_sym.physics import closed_forms as spanning
from softcat_sym.physics import regimes
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import simulate, without_estimate
from softcat_sym.studies.card import applied_to
from softcat_sym.studies.card_rules import (
    RULES,
    WORDS,
    Rule,
    RuleOfTheField,
    Solver,
    blamed,
    descent_of,
    percent,
    smay_modulus_needed,
    unusual,
)

OWN = {one.key: one for one in RULES}


def filament(
    law: dict[str, object], *, ends: str = "clamped", thickness: str = "1 mm", duration: str = "1 s", ramp: str = "0 s"
) -> Scene:
    """A round filament of 10 cm and 1000 kg/m^3."""
    return Scene.model_validate(
        {
            "filament": {"span": "10 cm", "thickness": thickness, "section": "circle", "density": "1000 kg/m^3"},
            "material": law,
            "ends": {"left": ends, "right": ends},
            "load": {"ramp": ramp},
            "run": {"duration": duration, "accuracy": 2e-3, "frames": 101},
        }
    )


def at_rest(modulus: str, **more: str) -> Scene:
    """An elastic filament without inertia."""
    scene = filament({"law": "elastic", "youngs_modulus": modulus}, **more)
    names = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation"]
    return scene.replace({"run.effects": names})


def run_of(scene: Scene) -> Trajectory:
    run = simulate(without_estimate(scene))
    assert run.outcome.is_success, run.summary["message"]
    return run


def rule(run: Trajectory, key: str) -> Rule:
    return applied_to(run, OWN[key])


@pytest.mark.parametrize(("ends", "key"), [("clamped", "beam-clamped"), ("pinned", "smay-pinned")])
def test_a_stiff_rod_is_a_beam(ends: str, key: str) -> None:
    run = run_of(at_rest("10 GPa", ends=ends))
    # By hand: q L^4/(E I) of a circle, I = pi D^4/64 and A = pi D^2/4.
    whole = 16 * 1000 * 9.81 * 0.1**4 / (1e10 * 1e-6)
    assert rule(run, key).predicted == pytest.approx(whole * (5 if ends == "pinned" else 1) / 384)
    assert rule(run, key).error == pytest.approx(0, abs=0.01)
    assert rule(run, key).holds


def test_a_soft_thread_is_a_cable() -> None:
    run = run_of(at_rest("10 MPa", thickness="0.1 mm"))
    found = rule(run, "elastic-cable")
    assert found.predicted == pytest.approx((3 * 1000 * 9.81 * 0.1**4 / (64 * 1e7)) ** (1 / 3))
    # The clamps' boundary layers, h0/H long, take something off the solver's sag.
    assert found.error == pytest.approx(0, abs=0.03)
    assert abs(rule(run, "beam-clamped").error or 0) > 5


def test_a_viscous_thread_is_a_beam_first_and_a_string_later() -> None:
    def thread(viscosity: str, thickness: str) -> Trajectory:
        return run_of(filament({"law": "newtonian", "viscosity": viscosity}, thickness=thickness, duration="5 s"))

    early, late = thread("10 GPa*s", "1 mm"), thread("1 MPa*s", "0.05 mm")
    assert rule(early, "viscous-beam").error == pytest.approx(0, abs=0.01)
    assert rule(late, "viscous-string").error == pytest.approx(0, abs=0.03)
    assert abs(rule(late, "viscous-beam").error or 0) > 5
    assert rule(late, "elastic-cable").predicted is None and "no modulus" in rule(late, "elastic-cable").text


def test_the_pull_of_a_cable_is_that_of_its_catenary() -> None:
    run = run_of(at_rest("1 MPa", thickness="0.1 mm"))
    assert rule(run, "catenary-stress-exact").error == pytest.approx(0, abs=0.02)


def test_exact_catenary_at_its_lightest() -> None:
    """The least stress of a catenary is at twice the Laplace limit constant, 0.6627: Bernoulli's chain."""
    u = 1.19967864025773
    sag = (math.cosh(u) - 1) / (2 * u)
    assert float(spanning.catenary_stress(sag)) == pytest.approx(1 / (2 * 0.662743419349182), rel=1e-9)
    # A shallow one is a parabola.
    assert float(spanning.catenary_stress(1e-3)) == pytest.approx(1e-3 * 7 / 6 + 125, rel=1e-8)
    with pytest.raises(ValueError, match="carries no load"):
        spanning.catenary_stress(0.0)


def test_smay_asks_for_the_published_modulus() -> None:
    """G' >= 1.4 rho g s^4 D (Langmuir 18, 5429): 1.389 by the pinned beam, a fifth of it between clamps."""
    scene = filament({"law": "elastic", "youngs_modulus": "1 MPa"})
    unit = 1000 * 9.81 * (100.0**4) * 1e-3
    assert smay_modulus_needed(scene) / unit == pytest.approx(1.4, rel=0.01)
    assert smay_modulus_needed(scene) / unit == pytest.approx(25 / 18)
    assert float(spanning.smay_modulus(regimes.CLAMPED) / spanning.smay_modulus()) == pytest.approx(1 / 5)


def test_stress_of_the_bent_beam_is_moment_over_section_modulus() -> None:
    law: dict[str, object] = {
        "law": "bingham",
        "youngs_modulus": "1 GPa",
        "viscosity": "1 MPa*s",
        "yield_stress": "1 MPa",
    }
    run = run_of(filament(law, duration="0.2 s", ramp="0.1 s"))
    moment = 1000 * 9.81 * math.pi / 4 * 1e-6 * 0.1**2 / 12
    found = rule(run, "first-yield")
    assert found.predicted == pytest.approx(moment / (math.pi * 1e-9 / 32))
    # It swings a little about its rest, and its outermost cell is not the clamp itself.
    assert found.error == pytest.approx(0, abs=0.1)
    for key in ("viscous-beam", "viscous-string", "stop-exact"):
        assert rule(run, key).predicted is None and "no fibre yields" in rule(run, key).text


@pytest.fixture(scope="module")
def stretched() -> Trajectory:
    """A clamped filament that sags by about its thickness: tension carries a good part."""
    return run_of(at_rest("20 MPa"))


def blame(run: Trajectory, key: str) -> Rule:
    return blamed(rule(run, key), OWN[key], Solver(run))


def test_tension_is_to_blame_where_a_beam_sags_by_its_thickness(stretched: Trajectory) -> None:
    found = blame(stretched, "beam-clamped")
    assert found.error is not None and found.error > 0.2
    assert [one.cause for one in found.blames] == [WORDS["stretching"]]
    # Left out, the rule holds; put back, it is off by as much as before.
    assert found.bare == pytest.approx(0, abs=0.01)
    assert found.blames[0].error == pytest.approx(found.error, rel=0.02)


def test_the_ends_are_to_blame_between_clamps(stretched: Trajectory) -> None:
    found = blame(stretched, "smay-pinned")
    alone = {one.cause: one.error for one in found.blames}
    assert alone[WORDS["ends"]] == pytest.approx(4.0, rel=0.01)
    assert found.bare == pytest.approx(0, abs=0.01)
    assert WORDS["stretching"] in alone and "hold of the ends (+4" in found.text


def test_a_rule_that_holds_blames_nothing_and_runs_nothing() -> None:
    run = run_of(at_rest("1 GPa"))

    def told(what: str) -> None:
        raise AssertionError(what)

    found = blamed(rule(run, "beam-clamped"), OWN["beam-clamped"], Solver(run, told))
    assert (found.text, found.blames) == ("holds", ())


UNUSUAL = {
    "ends.drop": "1 cm",
    "ends.right": "free",
    "load.point_mass": "1 mg",
    "filament.profile": [1.0, 0.5, 1.0],
    "filament.curvature": "1 1/m",
    "filament.rest_length": "11 cm",
    "load.gravity": "0 m/s^2",
}


@pytest.mark.parametrize("path", UNUSUAL)
def test_no_rule_is_applied_to_what_it_was_not_made_for(path: str) -> None:
    scene = filament({"law": "elastic", "youngs_modulus": "1 MPa"})
    assert unusual(scene) == ""
    assert unusual(scene.replace({path: UNUSUAL[path]})) != ""


def test_descent_of_a_known_curve() -> None:
    """An exponential approach is at 90 % after ln 10 and within 1 % after ln 100 times its time."""
    time = np.linspace(0.0, 10.0, 2001)
    sag = 2e-3 * -np.expm1(-time)
    data = xr.Dataset(
        {"midpoint": ("time", -sag), "stretch": (("time", "cell"), np.tile([1.0, 1.3, 1.1], (len(time), 1)))},
        coords={"time": time, "X_cell": ("cell", [-0.04, 0.0, 0.04])},
    )
    run = SimpleNamespace(data=data, scene=SimpleNamespace(filament=SimpleNamespace(span=0.1)))
    found = descent_of(run)  # type: ignore[arg-type]
    assert found is not None and found.to_90 is not None and found.settled is not None
    assert found.to_90 == pytest.approx(math.log(10), rel=1e-3)
    assert found.settled == pytest.approx(math.log(100), rel=2e-3)
    assert (found.damping, found.stretch, found.stretch_at) == ("overdamped", 1.3, 0.0)


def test_errors_read_well() -> None:
    assert [percent(one) for one in (0.012, -0.5, 3.99, 14.0)] == ["+1.2 %", "−50 %", "+399 %", "× 15"]


def test_every_rule_names_causes_that_are_known() -> None:
    known: set[str] = set(WORDS)
    assert all(isinstance(one, RuleOfTheField) and set(one.neglects) <= known for one in RULES)


def test_a_beam_that_was_run_without_tension_still_has_a_cable_to_be_compared_with() -> None:
    run = run_of(at_rest("10 GPa").replace({"run.effects": ["bending"]}))
    found = blame(run, "elastic-cable")
    assert found.bare == pytest.approx(0, abs=0.01)
    assert [one.cause for one in found.blames] == [WORDS["bending"]]
