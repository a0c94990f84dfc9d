"""The sag card: each rule in its limit, what makes a rule fail, and ``softcat card`` as a user meets it."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.physics import closed_forms
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import without_estimate
from softcat_sym.studies.card import on_pillars
from softcat_sym.studies.card_rules import (
    RULES,
    Rule,
    applied_to,
    unusual,
)
from tests.common.in_process import Softcat, sets

FIELD = {rule.key: rule for rule in RULES}
ELASTIC = {"law": "elastic", "youngs_modulus": "1 MPa"}


def filament(law: dict[str, object], ends: str = "clamped", thickness: str = "1 mm", **load_and_run: object) -> Scene:
    """A round filament of 10 cm and 1000 kg/m^3."""
    scene = {
        "filament": {"span": "10 cm", "thickness": thickness, "section": "circle", "density": "1000 kg/m^3"},
        "material": law,
        "ends": {"left": ends, "right": ends},
        "run": {"duration": "1 s", "accuracy": 2e-3, "frames": 101},
    }
    return Scene.model_validate(scene).replace(load_and_run)


def run_of(scene: Scene) -> Run:
    run = sc.simulate(without_estimate(scene))
    assert run.outcome.is_success, run.summary["message"]
    return run


def at_rest(
    modulus: str, effects: str = "bending extensibility finite-stretch thinning large-rotation", **more: str
) -> Run:
    """An elastic filament without inertia."""
    scene = filament({"law": "elastic", "youngs_modulus": modulus}, **more)
    return run_of(scene.replace({"run.effects": effects.split()}))


def rule(run: Run, key: str) -> Rule:
    return applied_to(run, FIELD[key])


def test_elastic_rules_in_their_limits() -> None:
    """A stiff rod is a beam, a soft thread a cable that pulls as its catenary; numbers by hand."""
    whole = 16 * 1000 * 9.81 * 0.1**4 / (1e10 * 1e-6)  # q L^4/(E I), I = pi D^4/64, A = pi D^2/4
    for ends, key, factor in (("clamped", "beam-clamped", 1), ("pinned", "smay-pinned", 5)):
        found = rule(at_rest("10 GPa", ends=ends), key)
        assert found.predicted == pytest.approx(whole * factor / 384), key
        assert found.holds and found.error == pytest.approx(0, abs=0.01), key
    thread = at_rest("10 MPa", thickness="0.1 mm")
    cable = rule(thread, "elastic-cable")
    assert cable.predicted == pytest.approx((3 * 1000 * 9.81 * 0.1**4 / (64 * 1e7)) ** (1 / 3))
    # The clamps' boundary layers, h0/H long, take something off the solver's sag.
    assert cable.error == pytest.approx(0, abs=0.03)
    assert abs(rule(thread, "beam-clamped").error or 0) > 5
    soft = at_rest("1 MPa", thickness="0.1 mm")
    assert rule(soft, "catenary-stress-exact").error == pytest.approx(0, abs=0.02)


def test_a_viscous_thread_is_a_beam_first_and_a_string_later() -> None:
    early, late = (
        run_of(filament({"law": "newtonian", "viscosity": viscosity}, thickness=h, **{"run.duration": "5 s"}))
        for viscosity, h in (("10 GPa*s", "1 mm"), ("1 MPa*s", "0.05 mm"))
    )
    assert rule(early, "viscous-beam").error == pytest.approx(0, abs=0.01)
    assert rule(late, "viscous-string").error == pytest.approx(0, abs=0.03)
    assert abs(rule(late, "viscous-beam").error or 0) > 5
    assert rule(late, "elastic-cable").predicted is None and "no modulus" in rule(late, "elastic-cable").text


def test_exact_catenary_at_its_lightest() -> None:
    """The least stress of a catenary is at twice the Laplace limit constant, 0.6627: Bernoulli's chain."""
    u = 1.19967864025773
    stress = closed_forms.catenary_stress((math.cosh(u) - 1) / (2 * u))
    assert float(stress) == pytest.approx(1 / (2 * 0.662743419349182), rel=1e-9)
    # A shallow one is a parabola.
    assert float(closed_forms.catenary_stress(1e-3)) == pytest.approx(1e-3 * 7 / 6 + 125, rel=1e-8)
    with pytest.raises(ValueError, match="carries no load"):
        closed_forms.catenary_stress(0.0)


def test_stress_of_the_bent_beam_is_moment_over_section_modulus() -> None:
    law = {"law": "bingham", "youngs_modulus": "1 GPa", "viscosity": "1 MPa*s", "yield_stress": "1 MPa"}
    run = run_of(filament(law, **{"run.duration": "0.2 s", "load.ramp": "0.1 s"}))
    moment = 1000 * 9.81 * math.pi / 4 * 1e-6 * 0.1**2 / 12
    assert rule(run, "first-yield").predicted == pytest.approx(moment / (math.pi * 1e-9 / 32))
    # It swings a little about its rest, and its outermost cell is not the clamp itself.
    assert rule(run, "first-yield").error == pytest.approx(0, abs=0.1)
    for key in ("viscous-beam", "viscous-string", "stop-exact"):
        assert rule(run, key).predicted is None and "no fibre yields" in rule(run, key).text


def test_no_rule_is_applied_to_what_it_was_not_made_for() -> None:
    scene = filament(ELASTIC)
    assert unusual(scene) == ""
    for path, value in {
        "ends.drop": "1 cm",
        "ends.right": "free",
        "load.point_mass": "1 mg",
        "filament.profile": [1.0, 0.5, 1.0],
        "filament.curvature": "1 1/m",
        "filament.rest_length": "11 cm",
        "load.gravity": "0 m/s^2",
    }.items():
        assert unusual(scene.replace({path: value})), path


BAD: list[tuple[tuple[str, ...], str]] = [
    (("ink-brigde",), "did you mean 'ink-bridge'"),
    (("no-yield", *sets("material.visosity=1 Pa*s")), "material.visosity"),
    *((("no-yield", "--sag", sag), "sag") for sag in ("-1 mm", "1 Pa", "little")),
    (("no-yield", "--no-span", "--max-sag", "1 mm"), "--no-span"),
    (("no-yield", "--sag", "1 mm", "--max-sag", "1 mm"), "given twice"),
    (("no-yield", "--pillars", "-1 mm"), "pillars.edge"),
    (("no-yield", "--pillars", "1 Pa"), "pillars.edge"),
]


def test_a_card_over_pillars_has_the_gap_of_its_scene_and_a_longer_strand() -> None:
    scene, note = on_pillars(sc.load_scene("ink-bridge"), "0.1 mm")
    assert scene.pillars is not None and (scene.pillars.gap, scene.pillars.edge) == pytest.approx((5e-3, 1e-4))
    assert scene.filament.span == pytest.approx(12.5e-3) and "flat there" in note


@pytest.mark.slow
def test_bad_input_is_one_clear_error_and_nothing_is_written(softcat: Softcat, tmp_path: Path) -> None:
    for given, named in BAD:
        done = softcat("card", *given, "-o", str(tmp_path / "out"))
        assert (done.status, done.out) == (2, ""), given
        assert named.lower() in " ".join(done.err.lower().split()), (given, done.err)
        assert not (tmp_path / "out").exists(), given
