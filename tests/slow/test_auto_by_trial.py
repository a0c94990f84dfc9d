"""Choosing effects by estimates, or by one trial run of everything on a coarse grid: which is right more often.


Both are judged by the run with everything: on the bundled scenes, and on two hundred random ones.
"""

from __future__ import annotations

import os
import time
import tomllib
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from multiprocessing import get_context
from unittest import mock

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects import choosing
from softcat_sym.effects.lists import everything
from softcat_sym.errors import SoftcatError
from softcat_sym.results.fields import displacements
from softcat_sym.results.motion import observed_motion
from softcat_sym.results.run import Run
from softcat_sym.simulate import without_estimate
from softcat_sym.solvers.solution import Extremes
from tests.common.auto_and_everything import difference
from tests.common.kept_answers import fingerprint, kept
from tests.common.random_scenes import random_scenes

NUMBER = int(os.environ.get("SOFTCAT_SCENES", "200"))
CELLS, FRAMES = 8, 41


@dataclass(frozen=True)
class Row:
    """One scene; errors of the midpoint over its accuracy."""

    name: str
    trouble: str = ""
    by_estimate: float = np.nan
    by_trial: float = np.nan
    effects_by_estimate: int = 0
    effects_by_trial: int = 0
    seconds_by_estimate: float = np.nan  # Its repeats included
    seconds_by_trial: float = np.nan  # The trial included
    seconds_everything: float = np.nan


def row_of(name: str, text: str) -> Row:
    """Choose, run and compare; a scene in which everything has no answer says nothing."""
    scene = without_estimate(sc.Scene.model_validate(tomllib.loads(text))).replace({"run.effects": "auto"})
    names = everything(scene, choosing.choose_effects(scene).names)

    def timed(given: sc.Scene) -> tuple[Run | None, float]:
        begun = time.perf_counter()
        try:
            run = sc.simulate(given)
        except SoftcatError:
            return None, np.nan
        return (run if run.outcome.is_success else None), time.perf_counter() - begun

    try:
        whole, long = timed(scene.replace({"run.effects": list(names)}))
        estimated, first = timed(scene)
        coarse = scene.replace(
            {"run.effects": list(names), "numerics.cells": CELLS, "run.frames": FRAMES, "run.accuracy": 0.05}
        )
        begun = time.perf_counter()
        trial, _ = timed(coarse)
        if whole is None or estimated is None or trial is None:
            return Row(name, "no answer with everything" if whole is None else "no answer")
        instants, *places = (trial.fields[name] for name in ("time", "X_node", "X_cell"))
        moved = displacements(scene, instants, trial.fields, places[0])
        motion = observed_motion(
            scene,
            choosing.choose_effects(coarse),
            instants,
            (places[0], places[1]),
            trial.fields,
            moved,
            Extremes.of(instants, trial.fields["midpoint"]),
        )
        with mock.patch.object(choosing, "forecast", lambda _: motion):
            chosen = choosing.choose_effects(scene).names
        choice = time.perf_counter() - begun
        tried, second = timed(scene.replace({"run.effects": list(chosen)}))
    except SoftcatError as error:
        return Row(name, str(error).splitlines()[-1].strip())
    return Row(
        name,
        "",
        difference(estimated, whole) / scene.run.accuracy,
        difference(tried, whole) / scene.run.accuracy if tried is not None else np.inf,
        len(estimated.summary["effects"]),
        len(chosen),
        first,
        choice + second,
        long,
    )


def _kept(job: tuple[str, str]) -> Row:
    return Row(**kept(job, fingerprint(__file__), lambda: asdict(row_of(*job))))


@pytest.mark.slow
def test_estimates_are_right_as_often_as_a_trial_run_and_quicker() -> None:
    """The choice by estimates stays; the table says what a trial would give."""
    bundled = [(name, sc.load_scene(name)) for name in sc.bundled_names()]
    drawn = [(f"random {k}", scene) for k, scene in enumerate(random_scenes(NUMBER))]
    with ProcessPoolExecutor(max_workers=os.cpu_count(), mp_context=get_context("spawn")) as pool:
        rows = list(pool.map(_kept, [(name, scene.to_toml()) for name, scene in (*bundled, *drawn)]))
    for label, part in (("bundled", rows[: len(bundled)]), ("random", rows[len(bundled) :])):
        good = [row for row in part if not row.trouble]
        print(f"\n{label}: {len(good)} of {len(part)} with answers")
        for way in ("estimate", "trial"):
            errors = np.array([getattr(row, f"by_{way}") for row in good])
            count = np.mean([getattr(row, f"effects_by_{way}") for row in good])
            seconds = np.array([getattr(row, f"seconds_by_{way}") for row in good])
            ratio = np.median(seconds / np.array([row.seconds_everything for row in good]))
            right, near = np.mean(errors <= 1), np.mean(errors <= 2)
            print(f"  by {way:9} {right:6.1%} within the accuracy, {near:6.1%} within twice")
            print(f"     {count:4.1f} effects, {np.median(seconds):6.2f} s (median), {ratio:.2f} of everything's time")
        for row in sorted(good, key=lambda one: -one.by_estimate)[:5]:
            print(f"    {row.name}: {row.by_estimate:.2g} accuracies by estimate, {row.by_trial:.2g} by trial")
    good = [row for row in rows if not row.trouble]
    right = {way: np.mean([getattr(row, f"by_{way}") <= 1 for row in good]) for way in ("estimate", "trial")}
    quicker = np.median([row.seconds_by_estimate / row.seconds_by_trial for row in good])
    assert len(good) > 0.8 * len(rows)
    assert right["estimate"] > 0.95 and right["estimate"] > right["trial"] - 0.02
    assert quicker < 1
