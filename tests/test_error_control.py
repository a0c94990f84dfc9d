"""Errors that are known are found, each in its place, and refined away; runs beside closed forms and finer grids."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
import pytest

from softcat_sym import Scene, load_scene, simulate
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.error_control.estimate import (
    Before,
    Differences,
    Judge,
    Resolution,
    differences,
    resolution_of,
)
from softcat_sym.error_control.price import Timed, next_digit
from softcat_sym.error_control.refinement import Controlled, controlled
from softcat_sym.results.observed import DISPLACEMENT, Series, Watched

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
