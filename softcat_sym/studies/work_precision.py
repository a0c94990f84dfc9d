"""What accuracy costs in time: every program at every grid and tolerance, against one converged answer."""

from __future__ import annotations

import contextlib
import functools
import json
import os
import queue
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from math import isfinite
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np

from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.discretization.assembly import DEFAULT_FIBRES, choose_grid
from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.scene import Scene
from softcat_sym.studies.work_precision_programs import PROGRAMS, STEPPED, Measured, Program, Task

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
    families: tuple[str, str]  # Of the two
    note: str  # What was run

    @property
    def floor(self) -> float:
        """The error below which nothing can be read off."""
        return max(self.space, self.time if np.isfinite(self.time) else 0.0)

    def error_of(self, midpoint: tuple[float, ...]) -> float:
        """Largest difference from it over the largest it has; infinite where the midpoint is not finite."""
        if len(midpoint) != len(self.midpoint):
            return np.inf
        difference = np.max(np.abs(np.array(midpoint) - self.midpoint))
        return float(difference / self.scale) if np.isfinite(difference) else np.inf

    @property
    def scale(self) -> float:
        """Largest distance of the midpoint from the chord."""
        return float(np.max(np.abs(self.midpoint)))


def reference_of(measure: Measure, grading: float, section: int, *, compiled: bool) -> Reference:
    """Measure the reference."""
    first = "compiled-rodas5p" if compiled else "rosenbrock"
    found = [_solved(measure, Task(first, n, grading, section * n // _GRIDS[0], rtol=_TIGHT)) for n in _GRIDS]
    scale = float(np.max(np.abs(found[-1])))
    if scale == 0:
        raise SoftcatError("the midpoint does not move: there is no error to measure")
    finer, coarser = (b + (b - a) / 3 for a, b in ((found[1], found[2]), (found[0], found[1])))
    space = float(np.max(np.abs(finer - coarser)) / _REMAINDER / scale)
    time, second = _of_time(measure, Task(first, _GRIDS[_MIDDLE], grading, section, rtol=_TIGHT), scale)
    grids = ", ".join(map(str, _GRIDS))
    note = f"{first} at rtol {_TIGHT:.0e} on {grids} cells, extrapolated; {second} on {_GRIDS[_MIDDLE]} cells"
    return Reference(finer, space, time, ("Rosenbrock", "BDF"), note)


def _of_time(measure: Measure, task: Task, scale: float) -> tuple[float, str]:
    """How far BDF is from a tight answer on one grid, and what it was run with."""
    own = _solved(measure, task)
    for rtol in _BDF_TOLERANCES:
        other = measure(Task("idas", task.cells, task.grading, task.section, rtol=rtol))
        if not other.message:
            return float(np.max(np.abs(np.array(other.midpoint) - own)) / scale), f"IDAS at rtol {rtol:.0e}"
    return float("nan"), f"IDAS gave no answer ({other.message})"


def _solved(measure: Measure, task: Task) -> Floats:
    found = measure(task)
    if found.message:
        raise SoftcatError(f"no reference: {task.program}, {task.text}: {found.message}")
    return np.array(found.midpoint)


_BUILDING = 600.0  # s; compiling a large filament takes seconds
_GRACE = 3.0  # s that repeated runs may take beyond the limit of one
_MODULE = "softcat_sym.studies.work_precision_programs"
DIED = "its process died"


class Worker:
    """One process at a time that measures tasks; started when it is first needed, and again after it was ended."""

    def __init__(self, scene: Path, limit: float, variables: Mapping[str, str] | None = None) -> None:
        self._command = [sys.executable, "-m", _MODULE, str(scene), repr(limit)]
        self._limit, self._variables = limit, dict(variables or {})
        self._child: subprocess.Popen[str] | None = None
        self._lines: queue.SimpleQueue[str] = queue.SimpleQueue()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.end()

    def measure(self, task: Task) -> Measured:
        """Have a task measured; what is not done in time, or dies, comes back as a failure."""
        child = self._running()
        began = time.perf_counter()
        with contextlib.suppress(BrokenPipeError):
            child.stdin.write(json.dumps(asdict(task)) + "\n")  # type: ignore[union-attr]
            child.stdin.flush()  # type: ignore[union-attr]
        build: Any = self._answer(_BUILDING)
        if not isinstance(build, float):
            return self._lost(build, time.perf_counter() - began, "building")
        found: Any = self._answer(self._limit + _GRACE)
        if not isinstance(found, dict):
            return replace(self._lost(found, self._limit, "integrating"), build=build)
        measured = Measured.from_document(found)
        if measured.first > self._limit:
            return replace(measured, midpoint=(), message=f"stopped: it took {measured.first:.3g} s")
        return measured

    def end(self) -> None:
        """End the process, at once."""
        child, self._child = self._child, None
        if child is None:
            return
        child.kill()
        child.wait()
        for stream in (child.stdin, child.stdout):
            with contextlib.suppress(BrokenPipeError):
                stream.close()  # type: ignore[union-attr]

    def _running(self) -> subprocess.Popen[str]:
        if self._child is None:
            self._lines = queue.SimpleQueue()
            self._child = subprocess.Popen(
                self._command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                text=True,
                env={**os.environ, **self._variables},
                # Ctrl-C is ours to hear: the process is then ended, in whatever call it is.
                start_new_session=True,
            )
            threading.Thread(target=_read, args=(self._child, self._lines), daemon=True).start()
        return self._child

    def _answer(self, seconds: float) -> object:
        """What the process says next: None if it is silent for too long, an empty text if it is gone."""
        try:
            line = self._lines.get(timeout=seconds)
        except queue.Empty:
            return None
        return json.loads(line) if line else ""

    def _lost(self, answer: object, seconds: float, doing: str) -> Measured:
        gone = answer == ""
        code = self._child.wait() if gone and self._child is not None else None
        self.end()
        text = f"{DIED} while {doing} (status {code})" if gone else f"stopped after {seconds:.3g} s, {doing}"
        return Measured(seconds, message=text)


def _read(child: subprocess.Popen[str], lines: queue.SimpleQueue[str]) -> None:
    """Pass on what a process says, and an empty text at its end."""
    with contextlib.suppress(ValueError):
        for line in child.stdout:  # type: ignore[union-attr]
            lines.put(line)
    lines.put("")


CELLS = (10, 20, 40, 60, 100, 200)
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
ORDERS = (1, 2, 3, 4, 6)
LEVELS = (1e-2, 1e-3, 1e-4, 1e-5)
_GRADED = 40
_GRADINGS = (1.0, 4.0)  # of RK4, whose step the shortest cell rules
_STEPS = (0.95,)  # of the stable step: the time error of RK4 there is far below that of any grid
_GAIN = 0.8
_TWICE = 2
_HOPELESS = ("cannot", "scene", "SciPy is")
"""How a complaint begins that no other grid or tolerance would mend."""

_REFERENCE_LIMIT = 120.0  # s for each run that the reference needs


@dataclass(frozen=True)
class Row:
    """A measured task with its error, not finite if it failed."""

    task: Task
    measured: Measured
    error: float


@dataclass(frozen=True)
class Curve:
    """A program with all that was measured of it, and how it starts cold."""

    program: Program
    rows: tuple[Row, ...]
    cold: Measured | None

    @property
    def refusal(self) -> str:
        """Why it has no answer at all; empty if it has one."""
        return "" if any(isfinite(row.error) for row in self.rows) else self.rows[0].measured.message


@dataclass(frozen=True)
class WorkPrecision:
    """A work-precision study of one scene."""

    name: str
    scene: Scene
    effects: tuple[str, ...]
    grading: float
    limit: float
    reference: Reference
    curves: tuple[Curve, ...]

    def knee(self, error: float, kinds: Sequence[str] = ("own", "rival")) -> tuple[Program, Row] | None:
        """The quickest run with at most this error; None if there is none."""
        rows = [(c.program, r) for c in self.curves if c.program.kind in kinds for r in c.rows if r.error <= error]
        return min(rows, key=lambda pair: pair[1].measured.seconds, default=None)


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


def study(name: str, asked: Scene, plan: Plan, tell: Callable[[str], None] = lambda what: None) -> WorkPrecision:
    """Measure a scene with every program; times are worth something side by side only, and nothing of it is kept."""
    effects = choose_effects(asked)
    lengths = choose_grid(asked.replace({"numerics.cells": _GRADED}), effects).cell_length
    grading = float(lengths[0] / lengths[-1])
    section = DEFAULT_FIBRES if FIBRES.name in effects.names else 0
    scene = asked.replace({"run.effects": list(effects.names), "numerics.estimate": False})
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(scene.to_toml(), encoding="utf-8")
        with Worker(path, _REFERENCE_LIMIT) as worker:
            tell("the reference")
            measure = functools.cache(worker.measure)
            reference = reference_of(measure, grading, section, compiled=find_compiler() is not None)
        curves = []
        with Worker(path, plan.limit) as worker:
            measure = functools.cache(worker.measure)
            for program in PROGRAMS:
                if program.key in plan.programs:
                    rows = tuple(_rows(program, plan, (grading, section), reference, measure, tell))
                    cold = _cold(program, rows, path, plan, tell) if plan.cold else None
                    curves.append(Curve(program, rows, cold))
    return WorkPrecision(name, asked, effects.names, grading, plan.limit, reference, tuple(curves))


def _rows(
    program: Program,
    plan: Plan,
    grid: tuple[float, int],
    reference: Reference,
    measure: Callable[[Task], Measured],
    tell: Callable[[str], None],
) -> Iterator[Row]:
    """All that is measured of one program: on each grid and section tolerances until they gain nothing.

    A method may be unstable, and slow, at a loose tolerance: it is given up only where the next tighter one is stopped
    too.
    """
    for ladder in _ladders(program, plan, *grid):
        best, stopped = float("inf"), 0
        for task in ladder:
            tell(f"{program.name}: {task.text}")
            measured = measure(task)
            error = float("inf") if measured.message else reference.error_of(measured.midpoint)
            yield Row(task, measured, error)
            if measured.message.startswith(_HOPELESS):
                return
            stopped = stopped + 1 if measured.message.startswith("stopped") else 0
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
        for fibres in _fibres(n, section):
            yield [Task(program.key, n, grading, fibres, rtol=rtol) for rtol in plan.tolerances]
    if section and program.key == PROGRAMS[0].key:
        for k in plan.orders:
            yield [Task(program.key, _GRADED, grading, k, by_order=True, rtol=rtol) for rtol in plan.tolerances[1:4]]


def _fibres(cells: int, section: int) -> tuple[int, ...]:
    """Fibres that go with so many cells: both errors fall as the square, so that both are doubled together."""
    if not section:
        return (0,)
    matched = max(4, section * cells // _GRADED)
    return (matched,) if cells < _GRADED else (section, matched) if matched != section else (section,)


def _cold(
    program: Program, rows: Sequence[Row], scene: Path, plan: Plan, tell: Callable[[str], None]
) -> Measured | None:
    """The first sound run again in a new process that has compiled nothing yet; None if there is none."""
    task = next((row.task for row in rows if isfinite(row.error) and row.task.cells >= min(_GRADED, *plan.cells)), None)
    if task is None:
        return None
    tell(f"{program.name}: cold")
    with (
        tempfile.TemporaryDirectory() as cache,
        Worker(scene, plan.limit, {"SOFTCAT_CACHE": cache}) as worker,
    ):
        return worker.measure(task)
