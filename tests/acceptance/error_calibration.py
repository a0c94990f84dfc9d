"""Estimated errors beside true ones: a run against the same physics on finer cells, more fibres and shorter steps."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace
from multiprocessing.connection import Connection
from typing import Any

import numpy as np

import softcat_sym as sc
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.error_control.control import periods_of
from softcat_sym.error_control.estimate import Judge
from softcat_sym.errors import SoftcatError
from softcat_sym.simulate import without_estimate
from tests.common.limited_process import Ask, limit_this_process, side_by_side

from .kept_answers import fingerprint, kept

FINER, MORE_FIBRES, TIGHTER = 2, 2, 10
"""Of the reference: its own errors, by second order, are a quarter of those of the run."""

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


def calibrations(scenes: Sequence[tuple[str, sc.Scene]]) -> list[Calibrated]:
    """Calibrate scenes, side by side; answers are kept, so that an interrupted study goes on."""
    sources = fingerprint(__file__)

    def one(ask: Ask, question: tuple[str, str, float]) -> Calibrated:
        return Calibrated(**kept(tuple(map(str, question)), sources, lambda: asdict(_within_limits(ask, question))))

    return side_by_side(_serve, one, [(name, scene.to_toml(), scene.run.accuracy) for name, scene in scenes])


def _within_limits(ask: Ask, question: tuple[str, str, float]) -> Calibrated:
    """Ask a process for the run, then for its reference; what it has no time for has nothing to compare."""
    name, _, accuracy = question
    answers, died = ask(question, (RUN, REFERENCE))
    if len(answers) == 2:
        found: Calibrated = answers[1]
        return found
    if not answers:
        return Calibrated(name, accuracy, "dear", died or f"not as accurate as asked within {RUN:g} s")
    return replace(answers[0], why_not=died or f"no reference within {REFERENCE:g} s")


def _serve(there: Connection) -> None:
    """Answer scenes one after another."""
    there.send("ready")
    while True:
        try:
            name, text, _ = there.recv()
        except EOFError:
            return
        limit_this_process(RUN)
        scene = sc.Scene.model_validate(tomllib.loads(text))
        run, found = _run(name, scene)
        limit_this_process(REFERENCE)
        there.send(found)
        there.send(_judged(scene, run, found))
        limit_this_process(0)


def _run(name: str, scene: sc.Scene) -> tuple[sc.Trajectory | None, Calibrated]:
    """Run a scene as a user would."""
    accuracy = scene.run.accuracy
    try:
        run = sc.simulate(scene)
    except SoftcatError as refusal:
        return None, Calibrated(name, accuracy, "refused", str(refusal)[:200])
    told = run.summary
    estimate, wall = told["error_estimate"] or {}, told["wall_s"]
    unjudged = not run.outcome.is_success or estimate.get("total") is None
    why = (told["message"] or "no estimate") if unjudged else ""
    resolution = told["resolution"] or {}
    return run, Calibrated(
        name, accuracy, run.outcome.name, why, np.nan, estimate, resolution, wall["solve"], wall["estimate"]
    )


def _judged(scene: sc.Scene, run: sc.Trajectory | None, found: Calibrated) -> Calibrated:
    """With the true error, if there is an estimate to judge and a reference to judge by."""
    if run is None or found.why_not:
        return found
    true, why_not = true_error(scene, run)
    return replace(found, true=true, why_not=why_not)


def true_error(scene: sc.Scene, run: sc.Trajectory) -> tuple[float, str]:
    """Error of a run by a finer one, measured as the estimate is; or why there is none.

    A ringing that the frames do not show is compared at as many times as the estimate was.
    """
    periods, midpoint = periods_of(run), run.data.midpoint.values if run.heights is None else run.heights
    reference = sc.simulate(_finer(scene, run.summary).replace({"run.frames": len(midpoint)}))
    if not reference.outcome.is_success:
        return np.nan, f"reference: {reference.outcome.name}"
    wanted = reference.data.midpoint.values
    return Judge.of(wanted, periods, scene.run.accuracy).between(midpoint, wanted).size, ""


def _grading(scene: sc.Scene, effects: tuple[str, ...], at: dict[str, Any], cells: int) -> float:
    """That of the run, but for cells at a hinge, which may not become much shorter than the thickness."""
    named = without_estimate(scene.replace({"run.effects": list(effects)})) if scene.run.effects == "auto" else scene
    return min(at["grading"], choose_grading(named, cells, choose_effects(named)))


def _finer(scene: sc.Scene, told: dict[str, Any]) -> sc.Scene:
    """The reference of a run: the physics that was in force, resolved further in every direction."""
    at = told["resolution"]
    cells = FINER * at["cells"]
    further = {
        "cells": cells,
        "grading": _grading(scene, tuple(told["effects"]), at, cells),
        "rtol": at["rtol"] / TIGHTER,
        "order": at["order"] and MORE_FIBRES * at["order"],
        "fibres": at["fibres"] and MORE_FIBRES * at["fibres"],
    }
    return _same(scene, told | {"resolution": further})


def _same(scene: sc.Scene, told: dict[str, Any]) -> sc.Scene:
    """The physics that was in force at the resolution that was used, run once."""
    at = told["resolution"]
    changes: dict[str, object] = {f"numerics.{name}": at[name] for name in ("cells", "grading", "rtol")}
    if scene.run.effects == "auto":
        changes["run.effects"] = list(told["effects"])
    name = "order" if at["order"] is not None else "fibres"
    if at[name] is not None:
        changes[f"numerics.{name}"] = at[name]
    return without_estimate(scene.replace(changes))
