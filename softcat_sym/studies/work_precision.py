"""Work-precision diagram: error over time of this program and of rivals, against one converged answer."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from math import inf, isfinite, nan
from multiprocessing import get_context
from multiprocessing.pool import Pool
from typing import Any

import numpy as np
import pandas as pd

from softcat_sym.discretization.assembly import choose_fibres, choose_grid
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Drawable
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.progress import LOOK, seconds_text
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.settings import choose_backend, settings_for
from softcat_sym.studies.integrators import (
    OTHER_FAMILIES,
    RIVALS,
    THIS_PROGRAM,
    Measurement,
    Method,
    Task,
    measure,
)

CELLS = (10, 20, 40, 80, 160)
"""Grids of this program, each with a quarter of the error of the one before."""

TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
"""Tolerances of the other programs."""

LEVELS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5)
"""Errors at which programs are compared."""

LIMIT, LIMIT_OF_ALL = 45.0, 600.0
"""Time limits of a study in seconds, with two rivals and with all programs."""

_FIRST, _LOOSEST = 40, 1e-3
"""The grid with the tolerance that the program chooses, and the loosest tolerance of all grids."""

_SHARE, _GROWTH = 0.45, 4.0
"""Share of the time that this program may take, and smallest expected ratio of the times of successive grids."""

_EXTRAPOLATED = 3
_REMAINDER = 7
"""Factor of the error estimate: the error of an extrapolated answer falls by 8 or more from grid to grid."""

_GAIN, _NEARLY = 0.8, 2.0
_TWICE = 2

Answers = list[tuple[Method, Task, Measurement]]


@dataclass(frozen=True)
class Reference:
    """A midpoint extrapolated to vanishing cells and steps."""

    midpoint: Floats  # shape (frames,); In rest lengths
    space: float  # Estimated error by the grid, over the largest midpoint
    cells: tuple[int, ...]  # Grids from which it is extrapolated
    time: float = nan  # Difference of a rival from this program on one grid, over the largest; NaN without a rival
    rival: str = ""  # Name of the rival, and its grid

    @property
    def floor(self) -> float:
        """The smallest error that can be measured against the reference."""
        return max(self.space, self.time if isfinite(self.time) else 0.0)

    @property
    def note(self) -> str:
        """Text on the origin and the error of the reference."""
        text = (
            f"softcat on {', '.join(map(str, self.cells))} cells, extrapolated to zero cell length; its error is "
            f"{self.space:.1e} by two extrapolations"
        )
        if isfinite(self.time):
            return f"{text}; {self.rival} differs from softcat by {self.time:.1e}"
        return f"{text}; no rival had the time to confirm it"

    def error(self, midpoint: Sequence[float]) -> float:
        """Largest difference from the reference over its largest value; infinite if the midpoint is not finite."""
        if len(midpoint) != len(self.midpoint):
            return inf
        difference = _apart(midpoint, self.midpoint)
        return difference if isfinite(difference) else inf

    def confirmed(self, answers: Answers) -> Reference:
        """The reference with the nearest answer of a rival on the finest common grid."""
        own = {_grid(task): found.midpoint for program, task, found in answers if program.key == THIS_PROGRAM}
        beside = [
            (-task.cells, _apart(found.midpoint, own[_grid(task)]), f"{program.name}, on {task.cells} cells,")
            for program, task, found in answers
            if program.key in OTHER_FAMILIES and found.midpoint and own.get(_grid(task))
        ]
        if not beside:
            return self
        _, apart, rival = min(beside)
        return replace(self, time=apart, rival=rival)


def _apart(midpoint: Sequence[float], other: Sequence[float] | Floats) -> float:
    return float(np.max(np.abs(np.array(midpoint) - other)) / np.max(np.abs(other)))


def _grid(task: Task) -> tuple[int, float, int]:
    return task.cells, task.grading, task.section


def extrapolated(answers: Answers) -> Reference:
    """Richardson extrapolation from the last three grids, with cells, fibres and time steps refined together."""
    sound = [(task, np.array(found.midpoint)) for _, task, found in answers if not found.message][-_EXTRAPOLATED:]
    if len(sound) < _EXTRAPOLATED:
        why = next((found.message for _, _, found in answers if found.message), "")
        raise SoftcatError(f"no reference: {len(sound)} of the three grids that it needs were solved ({why})")
    coarse, middle, fine = (midpoint for _, midpoint in sound)
    scale = float(np.max(np.abs(fine)))
    if scale == 0:
        raise SoftcatError("the midpoint does not move: there is no error to measure")
    finer, coarser = fine + (fine - middle) / 3, middle + (middle - coarse) / 3
    space = float(np.max(np.abs(finer - coarser)) / _REMAINDER / scale)
    return Reference(finer, space, tuple(task.cells for task, _ in sound))


class Budget:
    """The remaining time of a study, with progress reports."""

    def __init__(self, seconds: float, on_progress: Callable[[str, float], None]) -> None:
        self.seconds, self.end = seconds, time.monotonic() + seconds
        self._tell, self._doing = on_progress, ""

    def doing(self, what: str) -> None:
        """Set the name of the present task, and report it."""
        self._doing = what
        self.tick()

    def tick(self) -> None:
        """Report the time that has passed."""
        self._tell(f"{self._doing}, at most {self.left:.0f} s left", 1 - self.left / self.seconds)

    @property
    def left(self) -> float:
        """Seconds until the end."""
        return max(0.0, self.end - time.monotonic())


NO_TIME = "no time was left"


class Worker:
    """One process at a time that measures tasks; it starts on first use, and again after it was ended."""

    def __init__(self, scene: Scene, budget: Budget) -> None:
        self._scene, self._budget = scene, budget
        self._process: Pool | None = None

    def measure(self, task: Task, seconds: float) -> Measurement:
        """Measure a task in the process; a task that exceeds its time is a failure."""
        if seconds <= 0:
            return Measurement(0.0, message=NO_TIME, stopped=True)
        end = time.monotonic() + seconds
        if self._process is None:
            self._process = get_context("spawn").Pool(1, _silence)
        answer = self._process.apply_async(measure, (self._scene, task, seconds))
        while (left := end - time.monotonic()) > 0:
            answer.wait(min(left, LOOK))
            if answer.ready():
                return answer.get()
            self._budget.tick()
        self.close()
        return Measurement(seconds, message=f"stopped after {seconds_text(seconds)}", stopped=True)

    def close(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.terminate()
            self._process.join()
            self._process = None


def _silence() -> None:
    """In the process: leave Ctrl-C to the command, and discard output, as SUNDIALS and Fortran print freely."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)


def record(program: Method, task: Task, run: Measurement, error: float) -> dict[str, Any]:
    """A measured task as a row of the table; the error is None if it failed."""
    return {
        "key": program.key,
        "task": task,
        "program": program.name,
        "kind": program.kind,
        "cells": task.cells,
        "grading": task.grading,
        "fibres": task.section or None,
        "tolerance": task.rtol,
        "seconds": run.seconds,
        "error": error if isfinite(error) else None,
        "steps": run.steps or None,
        "evaluations": run.evaluations or None,
        "us_per_step": 1e6 * run.seconds / run.steps if run.steps else None,
        "repeats": run.repeats,
        "build_s": run.build,
        "message": run.message or None,
    }


@dataclass(frozen=True)
class WorkPrecision(Drawable):
    """A work-precision study of one scene."""

    name: str
    scene: Scene
    effects: tuple[str, ...]
    limit: float
    reference: Reference
    runs: pd.DataFrame  # Columns of :func:`record`, failures included

    @property
    def names(self) -> dict[str, str]:
        """Names of the programs, by key."""
        return {str(key): str(name) for key, name in zip(self.runs["key"], self.runs["program"], strict=True)}

    @property
    def refusals(self) -> dict[str, str]:
        """Reasons of programs without any answer, by key."""
        answered = self.runs.groupby("key", sort=False)["error"].count()
        last = self.runs.drop_duplicates("key", keep="last").set_index("key")["message"]
        return {str(key): last[key] for key in answered[answered == 0].index}

    @property
    def cut(self) -> set[str]:
        """Programs for which the time was too short, by key."""
        stopped = self.runs["message"].str.contains(f"stopped|{NO_TIME}|would take", na=False)
        return set(self.runs[stopped]["key"])

    def knee(self, error: float, where: str = "kind in ('own', 'rival')") -> pd.Series[Any] | None:
        """The fastest run with at most this error among those that a query selects; None if there is none."""
        sound = self.runs[self.runs["error"].astype(float) <= error].query(where)
        return None if sound.empty else sound.loc[sound["seconds"].astype(float).idxmin()]

    @property
    def level(self) -> float:
        """The scene's accuracy, or the next of 3, 10, 30 times it that the reference resolves and a run reached."""
        own = [step * self.scene.run.accuracy for step in (1, 3, 10, 30)]
        reached = (level for level in own if level >= self.reference.floor and self._time(THIS_PROGRAM, level))
        return next(reached, own[-1])

    def _time(self, key: str, level: float) -> str:
        best = self.knee(level, f"key == '{key}'")
        return "" if best is None else seconds_text(best["seconds"])

    @property
    def sentence(self) -> str:
        """``At an error of 0.1 % this program takes 8 ms; IDAS 31 ms, SciPy Radau 240 ms.``"""
        level, parts = self.level, []
        for program in RIVALS:
            if program.key in self.names:
                missed = "has no answer" if program.key in self.refusals else "did not reach it"
                missed += " in its time" if program.key in self.cut else ""
                parts.append(f"{program.name} {self._time(program.key, level) or missed}")
        own = f"At an error of {100 * level:.3g} % this program takes {self._time(THIS_PROGRAM, level) or 'too long'}"
        return f"{'; '.join(filter(None, [own, ', '.join(parts)]))}."

    def to_dict(self) -> dict[str, Any]:
        """Content of ``accuracy.json``."""
        reference, knees, programs, hidden = self.reference, [], [], ["key", "task", "kind"]
        for level in LEVELS:
            pairs = {"best": self.knee(level), "best_rival": self.knee(level, "kind == 'rival'")}
            quick = {name: None if run is None else run.drop(hidden).to_dict() for name, run in pairs.items()}
            knees.append({"error": level, **quick})
        for key, runs in self.runs.groupby("key", sort=False):
            first = runs.iloc[0]
            programs.append(
                {
                    "key": key,
                    "name": first["program"],
                    "kind": first["kind"],
                    "refusal": self.refusals.get(str(key)),
                    "cut_off": key in self.cut,
                    "runs": runs.drop(columns=[*hidden, "program"]).to_dict("records"),
                }
            )
        return {
            "scene": self.name,
            "title": self.scene.title,
            "effects": list(self.effects),
            "error": "largest difference of the midpoint from the reference over the largest midpoint",
            "reference": {
                "what": reference.note,
                "space_error": reference.space,
                "rival_differs_by": reference.time if isfinite(reference.time) else None,
                "floor": reference.floor,
                "midpoint_rest_lengths": reference.midpoint.tolist(),
            },
            "limit_s": self.limit,
            "sentence": self.sentence,
            "knees": knees,
            "programs": programs,
        }

    def to_frame(self) -> pd.DataFrame:
        """One row for each run, failures included."""
        return self.runs.drop(columns=["key", "task"])


def study(
    name: str,
    asked: Scene,
    programs: Sequence[Method] = RIVALS,
    limit: float = LIMIT,
    on_progress: Callable[[str, float], None] = lambda what, share: None,
) -> WorkPrecision:
    """Measure a scene with this program and others, within `limit` [s]; times are comparable within one study only.

    `on_progress` receives the present task, and the share of the time that has passed. Nothing is stored.
    """
    effects = choose_effects(asked)
    backend = choose_backend(asked, effects)
    settings = settings_for(asked, effects, compiled=backend.compiled)
    own = Method(THIS_PROGRAM, "softcat", "own", "compiled" if backend.compiled else "interpreted", settings.solver)
    lengths = choose_grid(asked.replace({"numerics.cells": _FIRST}), effects).cell_length
    fibres = choose_fibres(asked) if effects.terms().resolved else 0
    scene = asked.replace({"run.effects": list(effects.names), "numerics.estimate": False})
    # Fibres are doubled with the cells, as both errors are quadratic; not in three dimensions.
    sections = [max(4, fibres * n // _FIRST) if fibres and not is_spatial(asked) else fibres for n in CELLS]
    loosest = max(settings.rtol, _LOOSEST)
    ladder = [
        Task(own.key, n, float(lengths[0] / lengths[-1]), section, min(settings.rtol * (_FIRST / n) ** 2, loosest))
        for n, section in zip(CELLS, sections, strict=True)
    ]
    budget = Budget(limit, on_progress)
    with closing(Worker(scene, budget)) as worker:
        answers = _from_coarse_to_fine(own, ladder, worker, budget)
        reference = extrapolated(answers)
        solved = [_grid(task) for _, task, found in answers if not found.message]
        for number, program in enumerate(programs):
            until = time.monotonic() + budget.left / (len(programs) - number)
            answers += measured(program, solved, reference, worker, budget, until)
    rows = [
        record(program, task, found, inf if found.message else reference.error(found.midpoint))
        for program, task, found in answers
    ]
    confirmed, table = reference.confirmed(answers), pd.DataFrame(rows, dtype=object)
    return WorkPrecision(name, asked, effects.names, limit, confirmed, table)


def _from_coarse_to_fine(own: Method, ladder: Sequence[Task], worker: Worker, budget: Budget) -> Answers:
    """Run the package itself on one grid after another, until the next would take too long."""
    answers: Answers = []
    until, expected = time.monotonic() + _SHARE * budget.left, 0.0
    for task in ladder:
        left = until - time.monotonic()
        if len(answers) >= _EXTRAPOLATED and expected > left:
            answers.append(
                (own, task, Measurement(0.0, message=f"it would take {seconds_text(expected)}", stopped=True))
            )
            break
        budget.doing(f"softcat: {task.text}")
        # The first three grids may take all of the time, as the reference needs them.
        found = worker.measure(task, left if len(answers) >= _EXTRAPOLATED else budget.left)
        answers.append((own, task, found))
        if found.stopped:
            break
        expected = _GROWTH * found.first + found.build
    return answers


def measured(
    program: Method,
    grids: Sequence[tuple[int, float, int]],
    reference: Reference,
    worker: Worker,
    budget: Budget,
    until: float,
) -> Iterator[tuple[Method, Task, Measurement]]:
    """Measure one program until its time is over: on each grid, tighter tolerances until the error no longer falls.

    A method may be unstable, and slow, at a loose tolerance: a task may take at most half of the remaining time, and a
    grid ends if two successive tolerances are stopped. A finer grid begins at the loosest tolerance that was nearly as
    accurate as the best one on the grid before.
    """
    begin = 0
    for cells, grading, section in grids:
        errors, best, stopped = dict[int, float](), inf, 0
        for k, rtol in enumerate(TOLERANCES[begin:], begin):
            task = Task(program.key, cells, grading, section, rtol)
            budget.doing(f"{program.name}: {task.text}")
            found = worker.measure(task, (until - time.monotonic()) / 2)
            yield program, task, found
            if found.hopeless or found.message == NO_TIME:
                return
            error = inf if found.message else reference.error(found.midpoint)
            stopped = stopped + 1 if found.stopped else 0
            gains_nothing = error > _GAIN * best and isfinite(error) and rtol < min(1e-3, best)
            errors[k], best = error, min(error, best)
            if stopped == _TWICE or gains_nothing:
                break
        if stopped and not isfinite(best):
            return
        begin = next((k for k, error in errors.items() if error <= _NEARLY * best), begin)
