"""The sag card: each rule in its limit, what makes a rule fail, and ``softcat card`` as a user meets it."""

from __future__ import annotations

import csv
import json
import math
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.physics import beams, closed_forms
from softcat_sym.plotting.card import facts
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import without_estimate
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.card import Card, scene_from_flags
from softcat_sym.studies.card_rules import (
    RULES,
    WORDS,
    Rule,
    Variants,
    applied_to,
    blamed,
    certificate_of,
    descent_of,
    percent,
    smay_modulus_needed,
    unusual,
)
from softcat_sym.studies.card_surface import surface_hold
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


def blame(run: Run, key: str) -> Rule:
    return blamed(rule(run, key), FIELD[key], Variants(run, Silence()))


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


def test_smay_asks_for_the_published_modulus() -> None:
    """G' >= 1.4 rho g s^4 D (Langmuir 18, 5429): 1.389 by the pinned beam, a fifth of it between clamps."""
    unit = 1000 * 9.81 * (100.0**4) * 1e-3
    assert smay_modulus_needed(filament(ELASTIC)) / unit == pytest.approx(25 / 18)
    assert float(closed_forms.smay_modulus(beams.CLAMPED) / closed_forms.smay_modulus()) == pytest.approx(1 / 5)


def test_stress_of_the_bent_beam_is_moment_over_section_modulus() -> None:
    law = {"law": "bingham", "youngs_modulus": "1 GPa", "viscosity": "1 MPa*s", "yield_stress": "1 MPa"}
    run = run_of(filament(law, **{"run.duration": "0.2 s", "load.ramp": "0.1 s"}))
    moment = 1000 * 9.81 * math.pi / 4 * 1e-6 * 0.1**2 / 12
    assert rule(run, "first-yield").predicted == pytest.approx(moment / (math.pi * 1e-9 / 32))
    # It swings a little about its rest, and its outermost cell is not the clamp itself.
    assert rule(run, "first-yield").error == pytest.approx(0, abs=0.1)
    for key in ("viscous-beam", "viscous-string", "stop-exact"):
        assert rule(run, key).predicted is None and "no fibre yields" in rule(run, key).text


def test_what_makes_a_rule_fail() -> None:
    """Left out, the rule holds; put back, it is off by as much as before."""
    stretched = at_rest("20 MPa")  # sags by about its thickness: tension carries a good part
    beam = blame(stretched, "beam-clamped")
    assert beam.error is not None and beam.error > 0.2
    assert [each["cause"] for each in beam.blames] == [WORDS["stretching"]]
    assert beam.bare == pytest.approx(0, abs=0.01)
    assert beam.blames[0]["error"] == pytest.approx(beam.error, rel=0.02)
    pinned = blame(stretched, "smay-pinned")
    alone = {each["cause"]: each["error"] for each in pinned.blames}
    assert alone[WORDS["ends"]] == pytest.approx(4.0, rel=0.01) and WORDS["stretching"] in alone
    assert pinned.bare == pytest.approx(0, abs=0.01)
    # A beam that was run without tension still has a cable to be compared with.
    cable = blame(at_rest("10 GPa", "bending"), "elastic-cable")
    assert cable.bare == pytest.approx(0, abs=0.01)
    assert [each["cause"] for each in cable.blames] == [WORDS["bending"]]


@pytest.mark.slow
def test_a_bath_that_resists_is_blamed_for_what_it_slows_down() -> None:
    """Without its drag the viscous string is as the rule has it."""
    thread = filament({"law": "newtonian", "viscosity": "1 MPa*s"}, thickness="0.05 mm", **{"run.duration": "5 s"})
    slowed = blame(run_of(thread.replace({"surroundings.viscosity": "10 Pa*s"})), "viscous-string")
    assert slowed.error is not None and slowed.error > 0.2
    assert slowed.bare == pytest.approx(0, abs=0.03)
    assert [each["cause"] for each in slowed.blames] == [WORDS["bath"]]


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


def test_descent_of_a_known_curve() -> None:
    """An exponential approach is at 90 % after ln 10 and within 1 % after ln 100 times its time."""
    time = np.linspace(0.0, 10.0, 2001)
    data = xr.Dataset(
        {"midpoint": ("time", 2e-3 * np.expm1(-time)), "stretch": (("time", "cell"), [[1.0, 1.3, 1.1]] * len(time))},
        coords={"time": time, "X_cell": ("cell", [-0.04, 0.0, 0.04])},
    )
    seen = {"rebound": 0.0, "midpoint_lowest_m": -2e-3}
    run = SimpleNamespace(data=data, scene=SimpleNamespace(filament=SimpleNamespace(span=0.1)), summary=seen)
    found = descent_of(run)  # type: ignore[arg-type]
    assert found is not None
    assert found.to_90 == pytest.approx(math.log(10), rel=1e-3)
    assert found.settled == pytest.approx(math.log(100), rel=2e-3)
    assert (found.damping, found.stretch, found.stretch_at) == ("overdamped", 1.3, 0.0)
    assert [percent(error) for error in (0.012, -0.5, 3.99, 14.0)] == ["+1.2 %", "−50 %", "+399 %", "× 15"]


def test_what_surface_tension_holds_and_what_the_rules_say_that_ignore_it() -> None:
    """A thread at rest is a string under both pulls, 8 Q f = q L^2; a rule's longest span is its formula inverted."""
    effects = "bending extensibility finite-stretch thinning large-rotation surface-tension"
    coarse = {"numerics.cells": 12, "run.frames": 11}
    run = at_rest("0.1 MPa", effects, thickness="0.1 mm", **{"surroundings.surface_tension": "10 mN/m"}, **coarse)
    hold = surface_hold(run, "5 %", None, lambda _: (None, "not sought"), Silence())
    assert hold is not None and hold.pull == pytest.approx(200)
    sag, weight = -run.summary["midpoint_final_m"], 1000 * 9.81 * 0.1
    assert hold.share == pytest.approx(8 * 200 * sag / 0.1 / weight, rel=0.02)
    assert hold.sag_without == pytest.approx((3 * 1000 * 9.81 * 0.1**4 / (64 * 1e5)) ** (1 / 3), rel=0.05)
    assert sag < 0.97 * hold.sag_without
    assert hold.rule_spans["elastic-cable"] == pytest.approx(0.05**3 * 64 * 1e5 / (3 * 1000 * 9.81), rel=1e-5)
    stiffness = 384 * 1e5 * (1e-4) ** 2 / 16 / (1000 * 9.81)
    assert hold.rule_spans["beam-clamped"] == pytest.approx((0.05 * stiffness) ** (1 / 3), rel=1e-5)
    assert set(hold.rule_spans) == {"smay-pinned", "beam-clamped", "elastic-cable"}
    descent = descent_of(run)
    assert descent is not None
    rules = tuple(applied_to(run, field) for field in RULES)
    shown = Card("", run.scene, run, descent, certificate_of(run, descent), rules, "5 %", None, "not sought", hold, ())
    rows = dict(facts(shown))
    assert rows["surface tension"].startswith("pulls with 200 Pa, carries 1")
    assert "elastic cable 27.2 mm" in rows["spans by the rules"] and "span without it" not in rows
    found = json.loads(json.dumps(shown.to_dict()))["surface_tension"]
    assert (found["pull"], found["span_without"]) == (hold.pull, None)
    names = [line.get_label() for line in shown.plot().axes[1].lines]
    assert any(str(name).startswith("no surface tension") for name in names)
    assert surface_hold(at_rest("10 MPa", **coarse), "5 %", None, lambda _: (None, ""), Silence()) is None


def test_a_card_is_told_as_it_is_computed_and_kept_when_it_is_interrupted(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The first answers come before the longest span; what there is then is written, and says what is missing."""

    def stopped(*given: object, **more: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("softcat_sym.studies.card.critical_span", stopped)
    done = softcat("card", *OIL, *sets("numerics.cells=8", "numerics.estimate=false"), "-o", str(tmp_path))
    assert done.status == 130
    assert "marked as incomplete; the same command goes on from there" in " ".join(done.err.split())
    starts = [line.split("  ")[0] for line in done.out.splitlines()]
    told = ["newtonian, 1 mm across 10 cm", "expected", "expected sag", "regime", "final sag", "rule"]
    assert [line for line in starts if line in told] == told
    assert "longest span" not in starts and "viscous beam" in starts
    found = json.loads((tmp_path / "card.json").read_text())
    assert found["notes"][-1] == "Incomplete, as it was interrupted: without the longest span, what makes rules fail"
    assert found["descent"]["final"] > 0 and {path.name for path in tmp_path.iterdir()} == FILES
    assert "Incomplete, as it was interrupted" in (tmp_path / "card.html").read_text()


FILES = {"card.html", "card.json", "card.csv", "card.png", "scene.toml"}
BODY = ("--density", "1000 kg/m^3", "--span", "10 cm", "--diameter", "1 mm")
OIL = (*BODY, "--law", "newtonian", "--viscosity", "1 GPa*s", "--duration", "1 s")
INK = (*BODY, "--law", "bingham", "--youngs-modulus", "1 MPa", "--viscosity", "1 kPa*s", "--yield-stress", "3 kPa")
CURVE = "shear_rate_1_s,shear_stress_Pa\n" + "".join(f"{rate},{200 + 10 * rate}\n" for rate in (0.1, 1, 3, 10, 30, 100))


@pytest.mark.slow
def test_flags_make_a_page(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("card", *OIL, "--sag", "0.1 mm", *sets("numerics.cells=10"), "-o", str(tmp_path))
    assert done.status == 0, done.err
    assert {path.name for path in tmp_path.iterdir()} == FILES
    assert "It flows for as long as it is loaded." in done.out
    found = json.loads((tmp_path / "card.json").read_text())
    assert found["outcome"] == "solved" and found["regime"] == "viscous"
    rules = {each["key"]: each for each in found["rules"]}
    # Sagging by less than a tenth of its thickness it is a viscous beam; the other rules say why they are not for it.
    assert abs(rules["viscous-beam"]["error"]) < 0.05 and rules["viscous-beam"]["text"] == "holds"
    assert rules["smay-pinned"]["predicted"] is None and "no modulus" in rules["smay-pinned"]["text"]
    rows = list(csv.DictReader((tmp_path / "card.csv").read_text().splitlines()))
    assert [row["rule"] for row in rows] == [each["name"] for each in found["rules"]]
    assert float(rows[3]["predicted"]) == rules["viscous-beam"]["predicted"] and rows[0]["predicted"] == ""
    # The span it names sags as much as it may, and no more.
    span = found["longest_span"]["span_m"]
    scene = sc.load_scene(str(tmp_path / "scene.toml"), {"filament.span": f"{span!r} m"})
    assert -float(sc.simulate(scene).data.midpoint.values[-1]) == pytest.approx(1e-4, rel=0.02)
    page = (tmp_path / "card.html").read_text()
    assert not re.search(r"(src|href)=\"(?!data:)", page) and "http" not in page
    assert "--viscosity &#39;1 GPa*s&#39;" in page


def test_a_flow_curve_is_a_material_in_tension(tmp_path: Path) -> None:
    curve = tmp_path / "curve.csv"
    curve.write_text(CURVE)
    flags = {"density": "1000 kg/m^3", "span": "10 cm", "diameter": "1 mm"}
    flags |= {"flow-curve": str(curve), "youngs-modulus": "1 MPa"}
    scene, notes = scene_from_flags(flags)
    assert scene.material.law == "bingham" and scene.material.youngs_modulus == 1e6
    assert scene.material.yield_stress == pytest.approx(200 * 3**0.5, rel=1e-3)
    assert scene.material.viscosity == pytest.approx(30, rel=1e-3)
    # Twenty swings of sqrt(L/g), and five times eta/sigma_Y.
    assert scene.run.duration == pytest.approx(20 * (0.1 / 9.81) ** 0.5 + 5 * 30 / (200 * 3**0.5), rel=0.01)
    assert len(notes) == 2
    more = {"law": "herschel-bulkley", "duration": "3 s", "ends": "pinned", "surface-tension": "72 mN/m"}
    forced, _ = scene_from_flags({**flags, **more})
    assert forced.surroundings.surface_tension == 0.072
    assert (forced.material.law, forced.run.duration, forced.ends.left) == ("herschel-bulkley", 3.0, "pinned")


def without(name: str) -> tuple[str, ...]:
    place = INK.index(name)
    return INK[:place] + INK[place + 2 :]


STIFF = (*BODY, "--youngs-modulus", "1 MPa")
BAD: list[tuple[tuple[str, ...], str]] = [
    ((), "name a scene"),
    (("ink-bridge", "--density", "1 kg/m^3"), "a scene and --density"),
    (("ink-brigde",), "did you mean 'ink-bridge'"),
    *(
        (without(flag), f"{flag}: missing")
        for flag in ("--density", "--span", "--diameter", "--law", "--youngs-modulus")
    ),
    ((*without("--law"), "--law", "binghan"), "bingham"),
    (without("--viscosity"), "--viscosity: missing: the law 'bingham' needs it"),
    ((*without("--span"), "--span", "10 Pa"), "filament.span"),
    ((*without("--density"), "--density", "-1 kg/m^3"), "filament.density"),
    ((*without("--diameter"), "--diameter", "1 m"), "filament.thickness"),
    ((*INK, "--ends", "glued"), "ends.left"),
    ((*INK, "--surface-tension", "72 Pa"), "surroundings.surface_tension"),
    ((*INK, "--index", "thin"), "material.index"),
    ((*INK, "--duration", "0 s"), "run.duration"),
    ((*INK, *sets("material.visosity=1 Pa*s")), "material.visosity"),
    *(((*INK, "--sag", sag), "sag") for sag in ("-1 mm", "1 Pa", "little")),
    ((*INK, "--no-span", "--max-sag", "1 mm"), "--no-span"),
    ((*OIL, *sets("numerics.cells=6"), "--sag", "900 m"), "limit"),
    ((*STIFF, "--flow-curve", "none.csv"), "none.csv"),
    ((*BODY, "--flow-curve", "CURVE"), "says nothing about the modulus"),
    ((*STIFF, "--flow-curve", "BROKEN"), "shear_stress_pa"),
    ((*STIFF, "--flow-curve", "CURVE", "--viscosity", "1 Pa*s"), "twice"),
    ((*STIFF, "--flow-curve", "CURVE", "--law", "maxwell"), "maxwell"),
]


@pytest.mark.slow
def test_bad_input_is_one_clear_error_and_nothing_is_written(softcat: Softcat, tmp_path: Path) -> None:
    curves = {"CURVE": CURVE, "BROKEN": "shear_rate_1_s,stress\n1,two\n"}
    for name, text in curves.items():
        (tmp_path / name).write_text(text)
    for flags, named in BAD:
        given = [str(tmp_path / flag) if flag in curves else flag for flag in flags]
        done = softcat("card", *given, "-o", str(tmp_path / "out"))
        # That no span reaches a limit is known after the runs only.
        known = done.out.startswith("newtonian") and "expected sag" in done.out if "900 m" in flags else not done.out
        assert done.status == 2 and known, flags
        assert named.lower() in " ".join(done.err.lower().split()), (flags, done.err)
        assert not (tmp_path / "out").exists(), flags


def test_a_run_that_is_not_to_be_trusted_says_so_on_top(softcat: Softcat, tmp_path: Path) -> None:
    rough = sets("numerics.cells=4", "run.accuracy=1e-9", "numerics.rtol=1e-3")
    done = softcat("card", *OIL, *rough, "--no-span", "-o", str(tmp_path))
    assert done.status == 1
    said = [line.partition("  ")[0] for line in done.out.splitlines()]
    assert said.index("expected sag") < said.index(next(line for line in said if line.startswith("Not to be trusted")))
    assert "Not to be trusted: energy_drift" in done.out and "not sought" in done.out
    assert 'class="verdict doubtful"' in (tmp_path / "card.html").read_text()
    assert json.loads((tmp_path / "card.json").read_text())["outcome"] == "energy_drift"
