"""The estimated error of a run is its true error within a factor of three, nine times of ten.

The variable SOFTCAT_CALIBRATED names scenes to look at alone, such as ``cold-honey,random 7``. Answers are kept in the
user's cache, so that an interrupted study goes on.
"""

from __future__ import annotations

import os
import tomllib
from dataclasses import asdict, dataclass, field, replace
from functools import cache
from multiprocessing.connection import Connection
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from tests.common.kept_answers import fingerprint, kept
from tests.common.limited_process import Ask, limit_this_process, side_by_side
from tests.common.random_scenes import SEED, random_scenes
from tests.common.table import show
from tests.common.true_error import true_error

pytestmark = pytest.mark.slow

LEAST, MOST, SHARE = 0.3, 3.0, 0.90
NUMBER = 60
"""Random scenes, the first of those that effects are judged by: all laws, sections, ends and starts."""
NOTHING = 1e-3
"""Share of the accuracy below which estimate and true error are both nothing, and their ratio is rounding."""
RUN, REFERENCE = 600.0, 1800.0
"""Seconds of the processor for a run with its estimates, and for its reference, which is eight times as much of one."""


@dataclass(frozen=True)
class Calibrated:
    """A scene at an accuracy, its estimated error and its true one."""

    name: str
    accuracy: float
    outcome: str
    why_not: str
    true: float = np.nan
    estimate: dict[str, float | None] = field(default_factory=dict)
    resolution: dict[str, Any] = field(default_factory=dict)
    seconds: float = 0.0
    estimating: float = 0.0

    @property
    def ratio(self) -> float:
        """True error over the estimate."""
        total = self.estimate["total"]
        return self.true / total if total else np.inf

    @property
    def is_calibrated(self) -> bool:
        nothing = NOTHING * self.accuracy
        return LEAST <= self.ratio <= MOST or (self.true < nothing and (self.estimate["total"] or 0.0) < nothing)


def within_limits(ask: Ask, question: tuple[str, str, float]) -> Calibrated:
    """Ask a process for the run, then for its reference; what it has no time for has nothing to compare."""
    name, _, accuracy = question
    answers, died = ask(question, (RUN, REFERENCE))
    if not answers:
        return Calibrated(name, accuracy, "dear", died or f"not as accurate as asked within {RUN:g} s")
    done: Calibrated = answers[-1]
    return done if len(answers) == 2 else replace(done, why_not=died or f"no reference within {REFERENCE:g} s")


def serve(there: Connection) -> None:
    """Answer scenes one after another: first the run as a user would do it, then with its true error."""
    there.send("ready")
    while True:
        try:
            name, text, accuracy = there.recv()
        except EOFError:
            return
        limit_this_process(RUN)
        scene = sc.Scene.model_validate(tomllib.loads(text))
        try:
            run = sc.simulate(scene)
        except SoftcatError as refusal:
            found = Calibrated(name, accuracy, "refused", str(refusal)[:200])
        else:
            summary = run.summary
            estimate, wall = summary["error_estimate"] or {}, summary["wall_s"]
            judged = run.outcome.is_success and estimate.get("total") is not None
            why_not = "" if judged else summary["message"] or "no estimate"
            measured = estimate, summary["resolution"] or {}, wall["solve"], wall["estimate"]
            found = Calibrated(name, accuracy, run.outcome.name, why_not, np.nan, *measured)
        limit_this_process(REFERENCE)
        there.send(found)
        if not found.why_not:
            true, why_not = true_error(scene, run)
            found = replace(found, true=true, why_not=why_not)
        there.send(found)
        limit_this_process(0)


@cache
def studied() -> tuple[Calibrated, ...]:
    bundled = [(name, sc.load_scene(name)) for name in sc.bundled_names()]
    every = bundled + [(f"random {number}", scene) for number, scene in enumerate(random_scenes(NUMBER, SEED))]
    named = {name.strip() for name in os.environ.get("SOFTCAT_CALIBRATED", "").split(",") if name.strip()}
    questions = [(name, scene.to_toml(), scene.run.accuracy) for name, scene in every if not named or name in named]
    sources = fingerprint(__file__)

    def answer(ask: Ask, question: tuple[str, str, float]) -> Calibrated:
        return Calibrated(**kept(tuple(map(str, question)), sources, lambda: asdict(within_limits(ask, question))))

    return tuple(side_by_side(serve, answer, questions))


def answered() -> list[Calibrated]:
    return [scene for scene in studied() if not scene.why_not]


def test_estimates_are_right_within_a_factor_of_three() -> None:
    rows = []
    for scene in answered():
        parts = [f"{scene.estimate[name] or 0:.1e}" for name in ("total", "space", "time", "section")]
        at = f"{scene.resolution['cells']} x {scene.resolution['fibres'] or scene.resolution['order'] or '-'}"
        rows.append((scene.name, f"{scene.accuracy:g}", f"{scene.true:.1e}", *parts, f"{scene.ratio:.2f}", at))
    header = ("scene", "asked", "true", "estimated", "space", "time", "section", "true/estimated", "cells x fibres")
    show("errors, true and estimated", header, rows)
    silent = [(scene.name, scene.outcome, scene.why_not[:90]) for scene in studied() if scene.why_not]
    show("nothing to compare", ("scene", "outcome", "why"), silent)
    within = [scene.is_calibrated for scene in answered()]
    median = np.median([scene.ratio for scene in answered()])
    print(f"\n{np.mean(within):.1%} of {len(within)} within a factor of three; median {median:.2f}")
    assert len(within) > 0.85 * len(studied())
    assert np.mean(within) >= SHARE


def test_what_is_called_accurate_is() -> None:
    missed = [(scene.name, scene.accuracy, scene.true) for scene in answered() if scene.true > 1.5 * scene.accuracy]
    show("true error beyond the accuracy asked", ("scene", "asked", "true"), missed)
    within = np.mean([scene.true <= scene.accuracy for scene in answered()])
    print(f"\n{within:.1%} within the accuracy asked")
    assert within >= 0.95
    assert len(missed) <= 0.02 * len(answered())


def test_what_control_costs() -> None:
    """Seconds of the estimate over those of the answer's own integration: printed, not judged."""
    dearest = sorted(answered(), key=lambda scene: -scene.estimating)[:10]
    rows = [(scene.name, f"{scene.seconds:.2f}", f"{scene.estimating:.2f}") for scene in dearest]
    show("the dearest estimates", ("scene", "solve [s]", "estimate [s]"), rows)
    assert np.median([scene.estimating for scene in answered()]) < 10.0


def test_the_hinge_under_a_hanging_mass() -> None:
    """A Bingham strand whose hinges turn until tension carries it; the mass is some share of its own, 13.7 g."""
    material = {
        "law": "bingham",
        "youngs_modulus": "4 MPa",
        "yield_stress": "20 kPa",
        "viscosity": "13.84 kPa*s",
    }
    strand = {
        "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
        "material": material,
        "run": {"duration": "1 s", "accuracy": 1e-3, "frames": 101},
    }
    rows, ratios = [], []
    for share in (0.3, 1.0, 2.0):
        run = sc.simulate(sc.Scene.model_validate({**strand, "load": {"point_mass": f"{share * 13.7e-3} kg"}}))
        true, why_not = true_error(run.scene, run)
        assert not why_not
        total, at = run.summary["error_estimate"]["total"], run.summary["resolution"]
        ratios.append(true / total)
        rows.append((share, run.outcome.name, f"{at['cells']} x {at['fibres']}", f"{total:.1e}", f"{true:.1e}"))
    show("a mass at midspan", ("mass over own", "outcome", "cells x fibres", "estimated", "true"), rows)
    assert max(ratios) < 1.5
