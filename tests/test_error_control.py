"""Errors that are known are found, each in its place, and refined away; runs beside closed forms and finer grids."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.special import lambertw

from softcat_sym import Scene, load_scene, simulate
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.error_control import control, refinement
from softcat_sym.error_control.estimate import (
    Before,
    Differences,
    Judge,
    Resolution,
    differences,
    resolution_of,
    with_more_fibres,
)
from softcat_sym.error_control.price import Timed, next_digit
from softcat_sym.error_control.refinement import ROUNDS, Controlled, controlled
from softcat_sym.plotting.terminal import answer_rows
from softcat_sym.results.fields import cubic_weights, displacements
from softcat_sym.results.observed import DISPLACEMENT, OWN, Series, Watched
from softcat_sym.results.run import Run
from softcat_sym.simulate import without_estimate
from softcat_sym.solvers.compiled import CompiledIntegration

EXACT: Floats = -0.02 * np.linspace(0.0, 1.0, 11)


@dataclass
class Known:
    """Runs whose midpoint is exact + a/N^2 + b rtol + c/n^2, relative to the largest."""

    space: float = 0.0
    time: float = 0.0
    section: float = 0.0
    order: float = 2.0
    fails_below: int = 0
    fails_above: float = 1.0  # Tolerance
    asked: list[Resolution] = field(default_factory=list)

    def parts(self, at: Resolution) -> tuple[float, float, float]:
        return self.space / at.cells**self.order, self.time * at.rtol, self.section / at.fibres**2 if at.fibres else 0.0

    def __call__(self, at: Resolution) -> Series | None:
        self.asked.append(at)
        if at.cells < self.fails_below or at.rtol > self.fails_above:
            return None
        error = sum(self.parts(at))
        return {DISPLACEMENT: EXACT[:, None] * (1 + error), "turn": 50 * EXACT[:, None] * (1 + 3 * error)}

    def judged(self, at: Resolution, before: Before | None = None) -> Differences:
        """What is found of an answer at this resolution; `asked` holds its companions."""
        answer = self(at)
        assert answer is not None
        self.asked.clear()
        return differences(answer, at, self, judged(answer), ACCURACY, before)


ACCURACY = 1e-3
FIRST = Resolution(cells=40, grading=10.0, fibres=8, order=None, rtol=1e-4)
LINEAR = replace(FIRST, fibres=None)


def judged(answer: Series) -> Judge:
    """Judge by an answer instant by instant."""
    return Judge({name: float(np.max(np.abs(values))) for name, values in answer.items()}, ())


def scene_of(accuracy: float = 1e-3, **numerics: object) -> Scene:
    changes: dict[str, object] = {"run.accuracy": accuracy}
    return load_scene("continual-descent", changes | {f"numerics.{name}": value for name, value in numerics.items()})


def test_each_error_is_found_in_its_place() -> None:
    for known in (Known(space=2.0), Known(time=3.0), Known(section=0.1), Known(space=2.0, time=3.0, section=0.1)):
        found = known.judged(FIRST)
        # Relative to the largest midpoint of the answer, which is itself off by no more than 1 %.
        assert (found.space, found.time, found.section) == pytest.approx(known.parts(FIRST), rel=1e-2, abs=1e-12)
        assert found.failed == ()
        assert {at.grading for at in known.asked} == {FIRST.grading}, "companions lie on one map"
    # The turn errs by three times as much of its own largest value, in every part of it.
    told, largest = found.to_dict(effects=0.0), np.array([1.0, 3.0]) / (1 + np.array([1, 3]) * sum(known.parts(FIRST)))
    assert told["total"] is not None and told["turn"] is not None and told["torque"] is None
    assert told["turn"] / told["total"] == pytest.approx(largest[1] / largest[0], rel=1e-9)
    known = Known(space=2.0)
    assert known.judged(LINEAR).section is None
    assert len(known.asked) == 2, "what has nothing to resolve is not run"
    found = Known(space=2.0, fails_below=30).judged(FIRST)
    assert (found.space, found.failed) == (None, ("20 cells",))


def test_the_error_of_the_steps_is_found_where_larger_ones_have_no_answer() -> None:
    found = Known(time=3.0, fails_above=FIRST.rtol).judged(LINEAR)
    assert found.time == pytest.approx(3.0 * FIRST.rtol, rel=1e-2) and found.failed == ()


def test_what_steps_take_from_a_ringing_is_found_though_looser_ones_can_take_little_more() -> None:
    """Of a higher mode nearly all is lost in the end at this tolerance, and all of it at once at a looser one."""
    time, asked = np.linspace(0.0, 1.0, 2001), []

    def run(at: Resolution) -> Series:
        asked.append(at)
        lost = 10 * (at.rtol / FIRST.rtol) ** 2
        return seen(np.cos(400 * np.pi * time) - 1 + 0.03 * np.exp(-lost * time) * np.cos(2160 * np.pi * time))

    answer, exact = run(FIRST), run(replace(FIRST, rtol=1e-9))
    judge = judge_of(answer, 200.0, ACCURACY)
    found = differences(answer, FIRST, run, judge, ACCURACY)
    assert found.time == pytest.approx(judge.between(answer, exact).size, rel=0.3)
    assert min(at.rtol for at in asked[2:]) > 0.1 * FIRST.rtol


def test_what_is_known_is_not_run_again_and_what_was_too_long_is() -> None:
    """Of a finer grid and shorter steps only the grid is asked: the fibres are the same, the steps were good enough."""
    known = Known(space=2.0, time=1e-4, section=0.1)
    before = Before(FIRST, Differences(space=1e-2, time=1e-4 * FIRST.rtol, section=0.1 / 64, phase=None, failed=()))
    finer = replace(FIRST, cells=80, rtol=FIRST.rtol / 2)
    found = known.judged(finer, before)
    assert known.asked == [replace(finer, cells=40)]
    assert (found.space, found.time, found.section) == pytest.approx(known.parts(finer), rel=1e-2)
    # More fibres alone are judged by the answer before, of the same grid, whose error is known.
    known = Known(space=2.0, section=0.1)
    before = Before(FIRST, Differences(space=1e-3, time=0.0, section=0.1 / 64, phase=None, failed=()))
    found = known.judged(replace(FIRST, fibres=12), before)
    assert known.asked == [FIRST] and (found.space, found.time) == (1e-3, 0.0)
    assert found.section == pytest.approx(0.1 / 144, rel=1e-2)
    # More of both by those before on fewer cells, so that no library is compiled for a companion alone.
    finer = replace(FIRST, fibres=12, cells=80)
    found = known.judged(finer, before)
    assert {at.fibres for at in known.asked} == {8, 12}
    assert (found.space, found.section) == pytest.approx((known.parts(finer)[0], known.parts(finer)[2]), rel=1e-2)
    # More cells on the same map likewise, if there are enough more: by second order, whatever their ratio.
    for cells, asked in ((70, 40), (50, 25)):
        known = Known(space=2.0)
        found = known.judged(replace(LINEAR, cells=cells), Before(LINEAR, replace(before.found, section=None)))
        assert [at.cells for at in known.asked] == [asked]
        assert found.space == pytest.approx(2.0 / cells**2, rel=1e-2)
    known = Known(space=0.1, time=20.0)
    before = Before(FIRST, Differences(space=1e-4, time=20 * FIRST.rtol, section=0.0, phase=None, failed=()))
    tighter = replace(FIRST, rtol=FIRST.rtol / 8)
    known.judged(tighter, before)
    assert [at.rtol for at in known.asked] == [tighter.rtol, 8 * tighter.rtol]
    for earlier, later in (
        (FIRST, replace(FIRST, fibres=12)),
        (replace(LINEAR, order=2), replace(LINEAR, order=3)),
        (LINEAR, LINEAR),
    ):
        assert with_more_fibres(earlier, 1.5) == later


def test_what_falls_short_is_refined_and_nothing_else() -> None:
    cases = {
        "space": (Known(space=5.0), {"cells"}, (1e-5,)),
        "time": (Known(time=200.0), {"rtol"}, (1e-5,)),
        "section": (Known(section=0.09), {"fibres"}, (1e-4,)),
        "all": (Known(space=5.0, time=200.0, section=0.09), {"cells", "rtol", "fibres"}, (1e-3, 1e-4)),
    }
    for name, (known, touched, accuracies) in cases.items():
        for accuracy in accuracies:
            found = controlled(scene_of(accuracy), FIRST, known, known, lambda cells: FIRST.grading, judged)
            assert sum(known.parts(found.resolution)) <= accuracy, name
            changed = {
                key for key in ("cells", "rtol", "fibres") if getattr(found.resolution, key) != getattr(FIRST, key)
            }
            assert changed == touched and found.refinements, name


def test_what_will_do_is_fixed_or_hopeless_is_left_alone() -> None:
    def run(known: Known, scene: Scene) -> Controlled:
        return controlled(scene, FIRST, known, known, lambda cells: 400 / cells, judged)

    for known, scene in (
        (Known(space=0.8), scene_of()),
        (Known(space=20.0, time=200.0, section=0.3), scene_of(1e-5, cells=40, rtol=1e-4, fibres=8)),
    ):
        found = run(known, scene)
        assert (found.resolution, found.refinements) == (FIRST, ())
    hopeless = run(Known(space=1.0, order=0.3), scene_of(1e-5))
    assert hopeless.found is not None and hopeless.found.space is not None and hopeless.found.space > 1e-5
    assert len(hopeless.refinements) < ROUNDS
    known = Known(space=1.0)
    assert controlled(scene_of(), FIRST, lambda at: None, known, lambda cells: 10.0, judged).found is None
    assert known.asked == [], "a run that is not to be trusted is not refined"
    # Finer grids are graded anew: at a hinge no cell may become much shorter than the thickness.
    finer = run(Known(space=5.0), scene_of(1e-4)).resolution
    assert finer.cells > FIRST.cells and finer.grading == 400 / finer.cells


@pytest.mark.parametrize("accuracy", [1e-2, 1e-3])
def test_the_next_digit_costs_what_was_foretold(accuracy: float) -> None:
    """Of errors that fall by their orders, and of runs that take as long as they have unknowns and steps."""

    def timed(at: Resolution, *, answer: bool) -> Timed:
        steps = round(40 * at.rtol**-0.3)
        return Timed(at, answer, steps, 1e-6 * at.cells * ((at.fibres or 0) + 6) * steps, 0.02)

    def loop(scene: Scene) -> tuple[Controlled, list[Timed]]:
        known, beside = (Known(space=5.0, time=20.0, section=0.01, order=1.6) for _ in range(2))
        first = resolution_of(scene, effects, compiled=True)
        ended = controlled(scene, first, known, beside, lambda cells: first.grading, judged)
        made = [timed(at, answer=False) for at in dict.fromkeys(beside.asked)]
        return ended, made + [timed(at, answer=True) for at in known.asked]

    scene = scene_of(accuracy)
    effects = choose_effects(scene)
    scene = scene.replace({"run.effects": list(effects.names)})
    ended, made = loop(scene)
    assert ended.found is not None
    price = next_digit(scene, effects, (ended.resolution, ended.found), made, 0.5)
    assert price.accuracy <= accuracy / 10 and price.seconds is not None
    then = sum(run.solve + run.besides for run in loop(scene.replace({"run.accuracy": price.accuracy}))[1])
    assert price.seconds == pytest.approx(0.5 + then, rel=0.1)
    assert f"{100 * price.accuracy:g} % would take about" in price.text
    fixed = scene.replace({"numerics.cells": ended.resolution.cells})
    beyond = next_digit(fixed, effects, (ended.resolution, ended.found), made, 0.5)
    assert beyond.seconds is None and f"out of reach of N = {ended.resolution.cells}" in beyond.text


PERIODS = 200.0
TIME = np.linspace(0.0, 1.0, 2001)


def seen(midpoint: Floats) -> Series:
    """All that is compared of a run that moves up and down."""
    return {DISPLACEMENT: np.asarray(midpoint)[:, None]}


def judge_of(answer: Series, periods: float, accuracy: float) -> Judge:
    """Judge by an answer that begins on the line between its supports."""
    watched = Watched({DISPLACEMENT: 0.0}, {DISPLACEMENT: float(np.max(np.abs(answer[DISPLACEMENT])))})
    return Judge.of(answer, watched, periods, accuracy)


def ringing(height: float = 1.0, amplitude: float = 1.0, frequency: float = PERIODS, decay: float = 0.0) -> Series:
    """A midpoint that rings about a height, with a higher mode a tenth as large."""
    turn = 2 * np.pi * frequency * TIME
    swing = np.cos(turn) + 0.1 * np.cos(5.4 * turn + 1.0)
    return seen(-height + amplitude * np.exp(-decay * TIME) * swing)


def test_of_a_long_ringing_height_and_amplitude_are_compared_and_the_phase_beside() -> None:
    answer = ringing()
    judge = judge_of(answer, PERIODS, 1e-2)
    largest = judge.scale[DISPLACEMENT]
    late = ringing(frequency=1.003 * PERIODS)
    found = judge.between(answer, late)
    assert np.max(np.abs(answer[DISPLACEMENT] - late[DISPLACEMENT])) > 1.5
    assert found.size < 1e-3
    assert found.phase == pytest.approx(0.6, abs=0.02)
    for changed in ({"height": 1.02}, {"amplitude": 1.02}, {"height": 0.98, "frequency": 200.7}):
        assert judge.between(answer, ringing(**changed)).size == pytest.approx(0.02 / largest, rel=0.1)
    fading = judge.between(answer, ringing(decay=0.05))
    assert fading.size == pytest.approx((1 - np.exp(-0.05)) / largest, rel=0.1)
    # What comes to rest or hardly rings is compared instant by instant.
    for answer, periods in ((ringing(frequency=8.0), 8.0), (ringing(decay=20.0), PERIODS), (ringing(), 0.0)):
        one = answer[DISPLACEMENT]
        other = np.roll(one, 1)
        found = judge_of(answer, periods, 1e-2).between(answer, {DISPLACEMENT: other})
        assert found.size == pytest.approx(np.max(np.abs(one - other)) / np.max(np.abs(one)))
        assert found.phase is None


CASES = Path(__file__).parent / "cases"
HONEY = {"run.frames": 21}
SAG = 1e-4


def beam(accuracy: float, **numerics: object) -> Scene:
    """A beam at rest whose largest sag by beam theory, rho g L^4/(32 E h0^2), is a ten-thousandth of its span."""
    span, thickness, weight = 1.0, 0.02, 1e4
    modulus = weight * span**4 / thickness**2 / SAG / 32
    return Scene.model_validate(
        {
            "filament": {"span": f"{span} m", "thickness": f"{thickness} m", "density": "1000 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": f"{modulus!r} Pa"},
            "load": {"gravity": "10 m/s^2", "ramp": "1 s"},
            "run": {"duration": "1 s", "frames": 3, "effects": ["bending"], "accuracy": accuracy},
            "numerics": numerics,
        }
    )


@cache
def honey(accuracy: float, **numerics: object) -> Run:
    """A Newtonian thread at an accuracy."""
    changes = HONEY | {"run.accuracy": accuracy} | {f"numerics.{name}": value for name, value in numerics.items()}
    return simulate(load_scene("cold-honey", changes))


def test_the_estimate_of_a_beam_is_its_error_and_it_is_refined_until_that_will_do() -> None:
    run = simulate(beam(0.1, cells=40))
    estimate = run.summary["error_estimate"]
    assert run.outcome.is_success
    assert estimate["space"] == pytest.approx(abs(float(run.data.midpoint[-1]) / -SAG - 1), rel=0.1)
    assert estimate["section"] is None
    assert estimate["total"] == estimate["space"] + estimate["time"]
    for accuracy in (1e-3, 1e-4, 1e-5):
        run = simulate(beam(accuracy))
        assert run.outcome.is_success, run.summary["message"]
        assert abs(float(run.data.midpoint[-1]) / -SAG - 1) < accuracy
    assert run.summary["refinements"]
    assert run.summary["cells"] == run.summary["resolution"]["cells"] > 40


@pytest.mark.parametrize("accuracy", [1e-3, pytest.param(1e-5, marks=pytest.mark.slow)])
def test_a_run_is_as_near_a_finer_one_as_its_estimate_says(accuracy: float) -> None:
    run = honey(accuracy)
    at, wall = run.summary["resolution"], run.summary["wall_s"]
    finer = {"numerics.cells": 4 * at["cells"], "numerics.grading": at["grading"], "numerics.rtol": at["rtol"] / 50}
    best = simulate(without_estimate(run.scene.replace(finer)))
    true = float(np.max(np.abs(run.data.midpoint - best.data.midpoint)) / np.max(np.abs(best.data.midpoint)))
    assert true < accuracy
    assert 0.3 < true / run.summary["error_estimate"]["total"] < 3
    assert wall["estimate"] > 0, "companions count there"
    assert wall["total"] == pytest.approx(sum(seconds for stage, seconds in wall.items() if stage != "total"))
    assert (best.summary["error_estimate"], best.summary["wall_s"]["estimate"]) == (None, 0)
    digit = run.summary["next_digit"]
    assert accuracy / 200 < digit["accuracy"] < run.summary["error_estimate"]["total"] and digit["seconds"] > 0
    assert ("next digit", digit["text"]) in answer_rows(run.summary, run.scene)
    assert best.summary["next_digit"] is None


@pytest.mark.compiled
def test_a_rod_pulled_along_its_axis_is_judged_and_told_by_its_extension() -> None:
    """A viscous thread under a dead force F, eta A_0/s d(log s)/dt = F: s = 1/(1 - F t/(eta A_0))."""
    run = simulate(CASES / "pulled-rod-newtonian.toml")
    summary, scene = run.summary, run.scene
    drawn = 1.0 * scene.run.duration / (3.08e12 * np.pi * 5e-3**2 / 4)
    extension = 0.1 / (1 - drawn) - 0.1
    assert extension == pytest.approx(1.0102e-3, rel=1e-4)
    assert (summary["outcome"], summary["refinements"], summary["cells"]) == ("solved", [], 40)
    assert summary["displacement"]["final_m"][0] == pytest.approx(extension, rel=1e-5)
    assert summary["error_estimate"]["total"] < 1e-5
    # Of the slender theory, as fits have it: h0/L is 0.05.
    assert summary["theory_error"] == pytest.approx(4e-4 + 0.7 * 0.05**2, rel=1e-12)
    # What does not turn, twist or leave its plane has no error of that, however large it is beside its rounding.
    assert [summary["error_estimate"][name] for name in OWN] == [None, None, None]
    assert "moved 1.01 mm to the right ± " in dict(answer_rows(summary, scene))["right end"]
    assert dict(answer_rows(summary, scene))["settled"].startswith("no: it moved by 2")
    assert all(worth < 1e-6 for worth in summary["checked"].values())


def test_a_hanging_fibre_is_judged_by_its_elongation() -> None:
    """Of a fibre of incompressible rubber with log s/s = rho g (L - X)/E."""
    run = simulate(CASES / "hanging-fibre.toml")
    strain = 1000 * 9.81 * np.linspace(0, 0.1, 2001) / 1e6
    elongation = float(np.trapezoid(-np.real(lambertw(-strain)[1:]) / strain[1:] - 1, dx=0.1 / 2000))
    displacement, error = run.summary["displacement"], run.summary["error_estimate"]["total"]
    assert displacement["where"] == 0.5 and displacement["largest_m"] == pytest.approx(elongation, rel=1e-3)
    # Of the depth of 0.1 m the stated error would be a two thousandth of this one. It may be too large: steps are few.
    finer = simulate(without_estimate(run.scene.replace({"numerics.cells": 80, "numerics.rtol": 1e-6})))
    apart = run.fields["y"][:, -1] - finer.fields["y"][:, -1]
    assert float(np.max(np.abs(apart))) / displacement["largest_m"] < 3 * error
    assert "moved 49.1 µm down ± 0." in dict(answer_rows(run.summary, run.scene))["right end"]


@pytest.mark.slow
@pytest.mark.compiled
def test_what_is_only_pulled_straight_or_turned_about_itself_is_not_refined() -> None:
    """It is displaced by rounding, a thousandth of how far its end goes, or a hundredth of how far its surface does."""
    loaded = {"load.gravity": "0 m/s^2", "ends.right": "clamped"}
    for changes in (
        {"ends.motion": [["0 s", "0 m", "0 m"], ["5 s", "0.005 m", "0 m"]]},
        {"ends.right_twist": [["0 s", "0 deg"], ["1 s", "40 deg"]]},
        {},
    ):
        run = simulate(load_scene(str(CASES / "hanging-fibre.toml"), loaded | {"ends.left_angle": "0 deg"} | changes))
        rows = dict(answer_rows(run.summary, run.scene))
        assert (run.outcome.name, run.summary["refinements"]) == ("solved", []), changes
        assert rows["displacement"].startswith("as good as none: at most ") and "sag" not in rows
        assert run.summary["error_estimate"]["sideways"] is None
        assert ("right_twist" in str(changes)) == (run.summary["error_estimate"]["turn"] is not None)


def test_a_support_that_stops_as_the_run_ends_moves_until_then() -> None:
    """Else the last step of an interpreted run leaves the nodes beside it behind: 2e-3 of the energy."""
    loaded = {"load.gravity": "0 m/s^2", "ends.right": "clamped", "ends.left_angle": "0 deg"}
    loaded |= {"numerics.backend": "interpreted", "numerics.cells": "10", "numerics.estimate": "false"}
    pulled = {"ends.motion": [["0 s", "0 m", "0 m"], ["5 s", "0.005 m", "0 m"]]}
    run = simulate(load_scene(str(CASES / "hanging-fibre.toml"), loaded | pulled))
    assert run.outcome.is_success and run.summary["energy_residual"] < 1e-6


def test_displacement_counts_from_where_supports_hold_a_straight_filament() -> None:
    """It is none of what is carried along, and a slack one's is its depth; four nodes have any cubic between them."""
    nodes, time = np.linspace(-0.5, 0.5, 11), np.array([0.0, 1.0])
    pinned = {"ends.left": "pinned", "ends.right": "pinned"}
    scene = load_scene("cold-honey", {"filament.span": "1 m", "ends.drop": "0.2 m", **pinned})
    moving = scene.replace({"ends.motion": [["0 s", "0 m", "0 m"], ["1 s", "0.5 m", "0.1 m"]], "run.duration": "1 s"})
    line = {"x": np.stack([nodes, nodes * 1.5 + 0.25]), "y": np.stack([-0.2 * (nodes + 0.5), -0.1 * (nodes + 0.5)])}
    assert np.max(np.abs(displacements(moving, time, line, nodes))) < 1e-15
    bent = line | {"y": line["y"] - 0.3 * (1 - 4 * nodes**2)}
    assert displacements(moving, time, bent, nodes)[:, 5] == pytest.approx(np.array([[0, -0.3], [0, -0.3]]))
    free = load_scene("modelling-clay")
    assert np.max(np.abs(displacements(free, time, bent, nodes)[0])) == 0
    places = np.array([0.0, 0.1, 0.3, 0.35, 0.7, 1.0])
    for where in (-0.05, 0.05, 0.3, 0.62, 1.0):
        near, weights = cubic_weights(places, where)
        assert weights @ places[near] ** 3 == pytest.approx(where**3, rel=1e-12, abs=1e-15)
    assert list(cubic_weights(places, 0.3)[1]) == [0.0, 0.0, 1.0, 0.0]


def test_what_the_user_fixed_stays_and_is_told() -> None:
    run = honey(1e-5, cells=12)
    assert run.outcome.is_success and run.summary["cells"] == 12
    assert any("numerics.cells" in warning for warning in run.summary["warnings"])


def test_an_accuracy_missed_by_little_is_an_answer_and_by_more_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of what may have no more cells: with a warning up to twice the accuracy, and no advice that is no use."""
    monkeypatch.setattr(refinement, "MAX_CELLS", 1)
    error = simulate(beam(1e-4)).summary["error_estimate"]["total"]
    for times, outcome in ((0.9, "solved"), (1.5, "solved"), (2.5, "inaccurate")):
        run = simulate(beam(error / times))
        assert (run.outcome.name, run.summary["refinements"]) == (outcome, [])
        texts = [text for text in (*run.summary["warnings"], run.summary["message"]) if "accuracy" in text]
        assert len(texts) == (times > 1)
        assert not any("leave out" in text or "by hand" in text for text in (*texts, run.summary["advice"]))
        if times == 1.5:
            assert texts == [f"accuracy {error:.2g} instead of {error / times:g}"]
    monkeypatch.setattr(refinement, "MAX_CELLS", 40)
    run = simulate(load_scene("cold-honey", HONEY | {"run.accuracy": 1e-6}))
    assert (run.outcome.name, run.summary["regime"]) == ("inaccurate", None)
    assert "1e-06" in run.summary["message"]


@pytest.mark.slow
def test_a_hinge_that_necks_as_the_grid_lets_it_is_no_success() -> None:
    by_hand = {"numerics.cells": 80, "numerics.grading": 10, "numerics.fibres": 8}
    run = simulate(load_scene("arrested-underdamped", by_hand))
    if run.outcome.is_success:
        # Rounding decides whether the neck begins on this grid: without it the answer is that of the usual grid.
        right = simulate(load_scene("arrested-underdamped", {"numerics.estimate": False})).summary["midpoint_final_m"]
        assert run.summary["midpoint_final_m"] == pytest.approx(right, rel=run.summary["error_estimate"]["total"])
    else:
        assert run.outcome.name == "inaccurate"
        assert "numerics.grading" in run.summary["message"]


@pytest.mark.compiled
@pytest.mark.parametrize(("most", "fewest"), [(20_000_000, 800), (10_000, 100)])
def test_a_long_ringing_is_integrated_once_to_be_told_and_to_be_judged(
    most: int, fewest: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Companions have its output times, also where memory limits their number (``most`` values)."""
    effects = ["inertia", "bending", "extensibility", "large-rotation"]
    scene = Scene.model_validate(
        {
            "filament": {"span": "0.1 m", "thickness": "2 mm", "density": "1000 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "1 MPa"},
            "run": {"duration": "4 s", "frames": 21, "effects": effects},
            "numerics": {"cells": 12, "backend": "compiled"},
        }
    )
    monkeypatch.setattr(control, "MAX_NUMBERS", most)
    plain, begun = CompiledIntegration.run, list[tuple[int, int]]()

    def counted(self: CompiledIntegration, *given: object) -> object:
        begun.append((self.graph.grid.cells, self.frames))
        return plain(self, *given)  # type: ignore[arg-type]

    alone = simulate(scene.replace({"numerics.estimate": False}))
    monkeypatch.setattr(CompiledIntegration, "run", counted)
    judged = simulate(scene)
    assert [cells for cells, _ in begun].count(12) == 1
    assert {frames for _, frames in begun} == {begun[0][1]}
    assert (begun[0][1] - 1) % 20 == 0 and begun[0][1] > fewest
    for name in ("time", "midpoint", "tension", "energy_kinetic"):
        np.testing.assert_allclose(judged.data[name], alone.data[name], rtol=1e-9, atol=1e-12)
