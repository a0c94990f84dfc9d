"""What accuracy costs in time: every program at every grid and tolerance, against one converged answer."""

from __future__ import annotations

import functools
import os
import signal
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, suppress
from dataclasses import dataclass, field, replace
from math import inf, isfinite, log10, nan
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.discretization.assembly import DEFAULT_FIBRES, choose_grid
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.scene.scene import Scene
from softcat_sym.studies.work_precision_programs import (
    EXPECTED,
    PROGRAMS,
    STEPPED,
    Bench,
    Measured,
    Program,
    Task,
    integrate,
    message_of,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_GRIDS = (40, 80, 160)
_MIDDLE = 1
_TIGHT = 1e-7
_BDF_TOLERANCES = (1e-7, 1e-6, 1e-5)
_REMAINDER = 7
"""What is left of an extrapolated answer falls at least as the third power: by 8 from grid to grid."""

Measure = Callable[[Task], Measured]


@dataclass(frozen=True)
class Reference:
    """A midpoint for vanishing cells and steps."""

    midpoint: Floats  # shape (frames,); In rest lengths
    space: float  # How much the answer may still change with the grid, of its largest
    time: float  # How far the two families are apart on one grid, of the largest; NaN if the second gave no answer
    families: tuple[str, str]
    note: str  # What was run

    @property
    def floor(self) -> float:
        """The error below which nothing can be read off."""
        return max(self.space, self.time if np.isfinite(self.time) else 0.0)

    def error(self, midpoint: Sequence[float]) -> float:
        """Largest difference from it over the largest it has; infinite where the midpoint is not finite."""
        if len(midpoint) != len(self.midpoint):
            return inf
        difference = np.max(np.abs(np.array(midpoint) - self.midpoint)) / np.max(np.abs(self.midpoint))
        return float(difference) if np.isfinite(difference) else inf


def measure_reference(measure: Measure, grading: float, section: int, *, compiled: bool) -> Reference:
    """Rosenbrock on three grids, extrapolated; BDF on the middle one as a second family."""
    program = "compiled-rodas5p" if compiled else "rosenbrock"

    def midpoint(cells: int, fibres: int) -> Floats:
        task = Task(program, cells, grading, fibres, rtol=_TIGHT)
        found = measure(task)
        if found.message:
            raise SoftcatError(f"no reference: {program}, {task.text}: {found.message}")
        return np.array(found.midpoint)

    coarse, middle, fine = (midpoint(cells, section * cells // _GRIDS[0]) for cells in _GRIDS)
    scale = float(np.max(np.abs(fine)))
    if scale == 0:
        raise SoftcatError("the midpoint does not move: there is no error to measure")
    finer, coarser = fine + (fine - middle) / 3, middle + (middle - coarse) / 3
    space = float(np.max(np.abs(finer - coarser)) / _REMAINDER / scale)
    own, apart, second = midpoint(_GRIDS[_MIDDLE], section), nan, ""
    for rtol in _BDF_TOLERANCES:
        other = measure(Task("idas", _GRIDS[_MIDDLE], grading, section, rtol=rtol))
        second = f"IDAS gave no answer ({other.message})"
        if not other.message:
            apart = float(np.max(np.abs(np.array(other.midpoint) - own)) / scale)
            second = f"IDAS at rtol {rtol:.0e}"
            break
    grids = ", ".join(map(str, _GRIDS))
    note = f"{program} at rtol {_TIGHT:.0e} on {grids} cells, extrapolated; {second} on {_GRIDS[_MIDDLE]} cells"
    return Reference(finer, space, apart, ("Rosenbrock", "BDF"), note)


_BUILDING = 600.0  # s; compiling a large filament takes seconds
_GRACE = 3.0  # s that repeated runs may take beyond the limit of one
_PROCESSES = get_context("spawn")
DIED = "its process died"


@dataclass
class Worker:
    """One process at a time that measures tasks; started when it is first needed, and again after it was ended."""

    scene: Scene
    limit: float
    variables: Mapping[str, str] = field(default_factory=dict)
    process: BaseProcess | None = None
    _pipe: Connection | None = None

    def measure(self, task: Task) -> Measured:
        """Have a task measured; what is not done in time, or dies, comes back as a failure."""
        if self.process is None or self._pipe is None:
            self._pipe, other = _PROCESSES.Pipe()
            self.process = _PROCESSES.Process(
                target=_serve, args=(other, self.scene, self.limit, dict(self.variables)), daemon=True
            )
            self.process.start()
            other.close()
        began = time.perf_counter()
        with suppress(OSError):
            self._pipe.send(task)
        build = self._answer(self._pipe, _BUILDING)
        if not isinstance(build, float):
            return self._lost(build, time.perf_counter() - began, "building")
        found = self._answer(self._pipe, self.limit + _GRACE)
        if not isinstance(found, Measured):
            return replace(self._lost(found, self.limit, "integrating"), build=build)
        if found.first > self.limit:
            return replace(found, midpoint=(), message=f"stopped: it took {found.first:.3g} s", stopped=True)
        return found

    def close(self) -> None:
        """End the process, at once."""
        if self.process is not None and self._pipe is not None:
            self.process.kill()
            self.process.join()
            self._pipe.close()
            self.process = self._pipe = None

    @staticmethod
    def _answer(pipe: Connection, seconds: float) -> object:
        """What the process says next: None if it is silent for too long, an empty text if it is gone."""
        try:
            return pipe.recv() if pipe.poll(seconds) else None
        except (EOFError, OSError):
            return ""

    def _lost(self, answer: object, seconds: float, doing: str) -> Measured:
        text, died = f"stopped after {seconds:.3g} s, {doing}", answer == ""
        if died and self.process is not None:
            self.process.join()
            text = f"{DIED} while {doing} (status {self.process.exitcode})"
        self.close()
        return Measured(seconds, message=text, stopped=not died)


def _serve(pipe: Connection, scene: Scene, limit: float, variables: Mapping[str, str]) -> None:
    """What the process does: answer each task with the seconds of building, and with what was measured."""
    # Ctrl-C is for the command, which ends this process in whatever call it is; SUNDIALS and Fortran print at will.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)
    os.environ.update(variables)
    bench = Bench(scene, limit)
    with suppress(EOFError):
        while True:
            task, began = pipe.recv(), time.perf_counter()
            try:
                solve = bench.ready(task)
            except EXPECTED as error:
                pipe.send(time.perf_counter() - began)
                pipe.send(Measured(0.0, message=message_of(error), hopeless=isinstance(error, SceneError)))
                continue
            build = time.perf_counter() - began
            pipe.send(build)
            pipe.send(integrate(solve, build))


CELLS = (10, 20, 40, 60, 100, 200)
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
ORDERS = (1, 2, 3, 4, 6)
LEVELS = (1e-2, 1e-3, 1e-4, 1e-5)
_GRADED = 40
_GRADINGS = (1.0, 4.0)  # of RK4, whose step the shortest cell rules
_STEPS = (0.95,)  # of the stable step: the time error of RK4 there is far below that of any grid
_GAIN = 0.8
_TWICE = 2
_REFERENCE_LIMIT = 120.0  # s for each run that the reference needs


def record(program: Program, task: Task, run: Measured, error: float) -> dict[str, Any]:
    """A measured task as a row of the table; the error is None if it failed."""
    return {
        "key": program.key,
        "task": task,
        "program": program.name,
        "kind": program.kind,
        "cells": task.cells,
        "grading": task.grading,
        "fibres": task.section if task.section and not task.by_order else None,
        "order": task.section if task.by_order else None,
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
class WorkPrecision:
    """A work-precision study of one scene."""

    name: str
    scene: Scene
    effects: tuple[str, ...]
    grading: float
    limit: float
    reference: Reference
    runs: pd.DataFrame  # Columns of :func:`record`, failures included
    cold: dict[str, Measured]  # How programs start in a new process that has compiled nothing yet, by key

    @property
    def refusals(self) -> dict[str, str]:
        """Why programs have no answer at all, by key."""
        answered = self.runs.groupby("key", sort=False)["error"].count()
        first = self.runs.drop_duplicates("key").set_index("key")["message"]
        return {str(key): first[key] for key in answered[answered == 0].index}

    def knee(self, error: float, where: str = "kind in ('own', 'rival')") -> pd.Series[Any] | None:
        """The quickest run with at most this error of those that a query selects; None if there is none."""
        sound = self.runs[self.runs["error"].astype(float) <= error].query(where)
        return None if sound.empty else sound.loc[sound["seconds"].astype(float).idxmin()]

    @property
    def sentence(self) -> str:
        """What each accuracy costs: ``1e-3 costs 4 ms, 1e-5 costs 30 ms``; what no program reached is said."""
        parts = []
        for level in LEVELS:
            best, name = self.knee(level), f"1e-{round(-log10(level))}"
            if level < self.reference.floor:
                parts.append(f"{name} is below what the reference can tell")
            else:
                costs = "was not reached" if best is None else f"costs {seconds_text(best['seconds'])}"
                parts.append(f"{name} {costs}")
        return ", ".join(parts)

    def to_dict(self) -> dict[str, Any]:
        """What ``accuracy.json`` holds."""
        reference, knees, programs, hidden = self.reference, [], [], ["key", "task", "kind"]
        for level in LEVELS:
            pairs = {"best": self.knee(level), "best_rival": self.knee(level, "kind == 'rival'")}
            quick = {name: None if run is None else run.drop(hidden).to_dict() for name, run in pairs.items()}
            knees.append({"error": level, **quick})
        for key, runs in self.runs.groupby("key", sort=False):
            cold, first = self.cold.get(str(key)), runs.iloc[0]
            programs.append(
                {
                    "key": key,
                    "name": first["program"],
                    "kind": first["kind"],
                    "refusal": self.refusals.get(str(key)),
                    "cold": cold and {"build_s": cold.build, "first_solve_s": cold.first},
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
                "families": list(reference.families),
                "space_error": reference.space,
                "families_disagree_by": reference.time if isfinite(reference.time) else None,
                "floor": reference.floor,
                "midpoint_rest_lengths": reference.midpoint.tolist(),
            },
            "grading": self.grading,
            "limit_s": self.limit,
            "knee": self.sentence,
            "knees": knees,
            "programs": programs,
        }

    def to_frame(self) -> pd.DataFrame:
        """One row a run, failures included."""
        return self.runs.drop(columns=["key", "task"])

    def figures(self) -> dict[str, Figure]:
        """Error against time, one line a program."""
        from softcat_sym.plotting.accuracy import accuracy_figure

        return {"accuracy": accuracy_figure(self)}


def seconds_text(seconds: float) -> str:
    """A time as people read it: ``4.2 ms``, ``1.3 s``."""
    for size, unit in ((1.0, "s"), (1e-3, "ms")):
        if seconds >= size:
            return f"{seconds / size:.2g} {unit}" if seconds < 100 * size else f"{seconds / size:.0f} {unit}"
    return f"{1e6 * seconds:.0f} us"


@dataclass(frozen=True)
class Plan:
    """What is measured: numbers of cells, tolerances, programs; and how long one integration may take [s]."""

    cells: tuple[int, ...] = CELLS
    tolerances: tuple[float, ...] = TOLERANCES
    orders: tuple[int, ...] = ORDERS
    programs: tuple[str, ...] = tuple(program.key for program in PROGRAMS)
    limit: float = 10.0
    cold: bool = True

    @property
    def max_steps(self) -> int:
        """How many measurements there can be, for a progress bar."""
        return 1 + len(self.programs) * (len(self.cells) * len(self.tolerances) + self.cold)


def study(name: str, asked: Scene, plan: Plan, on_progress: Callable[[str], None] = lambda what: None) -> WorkPrecision:
    """Measure a scene with every program; times are worth something side by side only, and nothing of it is stored."""
    effects = choose_effects(asked)
    lengths = choose_grid(asked.replace({"numerics.cells": _GRADED}), effects).cell_length
    grading = float(lengths[0] / lengths[-1])
    section = DEFAULT_FIBRES if effects.terms().resolved else 0
    scene = asked.replace({"run.effects": list(effects.names), "numerics.estimate": False})
    with closing(Worker(scene, _REFERENCE_LIMIT)) as worker:
        on_progress("the reference")
        measure = functools.cache(worker.measure)
        reference = measure_reference(measure, grading, section, compiled=find_compiler() is not None)
    rows: list[dict[str, Any]] = []
    cold: dict[str, Measured] = {}
    with closing(Worker(scene, plan.limit)) as worker:
        measure = functools.cache(worker.measure)
        for program in (each for each in PROGRAMS if each.key in plan.programs):
            own = list(measured_rows(program, plan, (grading, section), reference, measure, on_progress))
            rows += own
            enough = min(_GRADED, *plan.cells)
            sound = (row["task"] for row in own if row["error"] is not None and row["cells"] >= enough)
            if plan.cold and (task := next(sound, None)) is not None:
                on_progress(f"{program.name}: cold")
                # A run in a new process that has compiled nothing yet.
                with (
                    tempfile.TemporaryDirectory() as cache,
                    closing(Worker(scene, plan.limit, {"SOFTCAT_CACHE": cache})) as fresh,
                ):
                    cold[program.key] = fresh.measure(task)
    table = pd.DataFrame(rows, dtype=object)
    return WorkPrecision(name, asked, effects.names, grading, plan.limit, reference, table, cold)


def measured_rows(
    program: Program,
    plan: Plan,
    grid: tuple[float, int],
    reference: Reference,
    measure: Measure,
    on_progress: Callable[[str], None],
) -> Iterator[dict[str, Any]]:
    """All that is measured of one program: on each grid and section tolerances until they gain nothing.

    A method may be unstable, and slow, at a loose tolerance: it is given up only where the next tighter one is stopped
    too.
    """
    for ladder in _ladders(program, plan, *grid):
        best, stopped = inf, 0
        for task in ladder:
            on_progress(f"{program.name}: {task.text}")
            measured = measure(task)
            error = inf if measured.message else reference.error(measured.midpoint)
            yield record(program, task, measured, error)
            if measured.hopeless:
                return
            stopped = stopped + 1 if measured.stopped else 0
            gains_nothing = error > _GAIN * best and isfinite(error) and task.rtol < min(1e-3, best)
            if stopped == _TWICE or gains_nothing:
                break
            best = min(best, error)
        if stopped and not isfinite(best):
            return


def _ladders(program: Program, plan: Plan, grading: float, section: int) -> Iterator[list[Task]]:
    """Grids and sections of a program, from coarse to fine, each with its tolerances from loose to tight."""
    if program.key in STEPPED:
        for g in _GRADINGS:
            for n in plan.cells:
                yield [Task(program.key, n, g, section, rtol=share) for share in _STEPS]
        return
    for n in plan.cells:
        # The errors of cells and of fibres fall as the square, so that both are doubled together.
        matched = max(4, section * n // _GRADED)
        every = (matched,) if n < _GRADED else tuple(dict.fromkeys((section, matched)))
        for fibres in every if section else (0,):
            yield [Task(program.key, n, grading, fibres, rtol=rtol) for rtol in plan.tolerances]
    if section and program.key == PROGRAMS[0].key:
        for k in plan.orders:
            yield [Task(program.key, _GRADED, grading, k, by_order=True, rtol=rtol) for rtol in plan.tolerances[1:4]]
