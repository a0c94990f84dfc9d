"""Solves and right-hand sides of the generated C, timed beside those of its rivals in the same minute."""

from __future__ import annotations

import copy
import ctypes as c
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.codegen.library import OPTIMISED, compile_library, load
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.solvers.compiled import CompiledIntegration, Filament, RunInput, Status, doubles
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.settings import RODAS4
from softcat_sym.solvers.solution import Silence
from tests.common.rivals import scenes
from tests.common.rivals.radau import Solved
from tests.common.rivals.scenes import Physics
from tests.common.rosenbrock import RUNTIME

REPEATS = 7
MAX_STEPS = 1_000_000
_LOOP = """\
#include "softcat_model.h"

int repeat(const softcat_filament *, double, const double *, double *, double *, int);
extern const softcat_model softcat_filament_model;

int repeat(const softcat_filament *filament, double t, const double *y, double *f, double *scratch,
           int count)
{
    int code = SOFTCAT_SOLVED;
    for (; count > 0; count--)
        code |= softcat_filament_model.rates(filament, t, y, f, scratch);
    return code;
}
"""

# rtol and atol of Rodas4, chosen as for the rivals: of those tried the pair of the fewest steps with the midpoint of 40
# cells within 1e-3 of the converged one. Of the descent both are what numerics.rtol alone gives.
LOOSEST: dict[tuple[str, Physics], tuple[float, float]] = {
    ("continual-descent", "paper"): (3e-3, 3e-5),
    ("arrested-overdamped", "paper"): (1e-1, 3e-4),
    ("continual-descent", "fibres"): (1e-2, 1e-4),
    ("arrested-overdamped", "fibres"): (3e-3, 3e-5),
}


@dataclass(frozen=True, slots=True)
class Timing:
    """Medians of many calls [s]: by the clock on the wall, and of the processor alone."""

    wall: float
    processor: float


def medians(calls: Mapping[str, Callable[[], object]], repeats: int = REPEATS) -> dict[str, Timing]:
    """Time calls in turns, so that whatever else the machine does meets all of them."""
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in calls}
    for name, call in calls.items():
        call()
        found[name].clear()
    for _ in range(repeats):
        for name, call in calls.items():
            wall, processor = time.perf_counter(), time.process_time()
            call()
            found[name].append((time.perf_counter() - wall, time.process_time() - processor))
    return {name: Timing(*np.median(spent, axis=0).tolist()) for name, spent in found.items()}


def compiled(name: str, physics: Physics = "paper", cells: int = scenes.CELLS, rtol: float | None = None) -> Prepared:
    """A bundled scene, ready to be solved by generated C; at its loosest tolerances if no relative one is given."""
    relative, absolute = LOOSEST[name, physics]
    asked = relative if rtol is None else rtol
    prepared = scenes.prepare(name, physics, cells, numerics={"backend": "compiled", "rtol": asked})
    if rtol is not None:
        return prepared
    chosen: dict[str, float] = {"rtol": relative, "atol": absolute, "across": absolute, "velocity": 10 * absolute}
    whole, settings = prepared.integration, replace(prepared.settings, **chosen, method=RODAS4)
    if not isinstance(whole, CompiledIntegration):
        raise TypeError(f"{name} is not compiled")
    return replace(prepared, settings=settings, integration=replace(whole, settings=settings))


class Bare:
    """The compiled solver from the start to the end in one call, without powers, as the rivals solve."""

    def __init__(self, prepared: Prepared, method: int | None = None) -> None:
        whole = prepared.integration
        if not isinstance(whole, CompiledIntegration) or prepared.start is None:
            raise TypeError("a compiled run that has a start is wanted")
        self._model = copy.copy(whole.filament.model)
        self._model.model = replace(self._model.model, powers=())
        self._graph, self._sites = prepared.graph, whole.filament.sites
        settings = prepared.settings
        self._run = RunInput(
            parameters=np.ascontiguousarray(prepared.p),
            places=whole.filament.places,
            state=self._sites.state(prepared.start.x, prepared.start.z),
            times=prepared.times[[0, -1]],
            relative=settings.rtol,
            absolute=settings.absolute(slot.name for slot in self._model.model.slots),
            work_absolute=0.0,
            kinks=whole.kinks,
            max_steps=MAX_STEPS,
            method=settings.method if method is None else method,
        )

    def solve(self) -> Solved:
        """Integrate."""
        status = Status()
        began = time.perf_counter()
        states = self._model.integrate(self._run, status).states
        seconds = time.perf_counter() - began
        if status.code:
            raise RuntimeError(self._model.message(status.code))
        x, _ = self._sites.vectors(states)
        midpoint = float(x[self._graph.x_kinds.index("y"), -1])
        return Solved(seconds, midpoint, int(status.steps), int(status.evaluations))


def error_of(solved: Solved, name: str, physics: Physics = "paper") -> float:
    """Of the midpoint at the end, against the converged one."""
    return solved.midpoint / scenes.converged_midpoint(name, physics) - 1


def whole_error(prepared: Prepared, name: str, physics: Physics = "paper") -> float:
    """The same of a whole run as a user has it."""
    solution = prepared.solve(Silence())
    midpoint = float(solution.x[prepared.graph.x_kinds.index("y"), -1])
    return midpoint / scenes.converged_midpoint(name, physics) - 1


class GeneratedRates:
    """The generated right-hand side in a loop of C, compiled by the flags of every run."""

    def __init__(self, prepared: Prepared) -> None:
        whole = prepared.integration
        if not isinstance(whole, CompiledIntegration):
            raise TypeError("a compiled run is wanted")
        header = (RUNTIME / "softcat_model.h").read_text(encoding="utf-8")
        texts = {"filament.c": whole.filament.model.model.text, "loop.c": _LOOP, "softcat_model.h": header}
        self._repeat = load(compile_library(texts, flags=OPTIMISED)).repeat
        self._sites, self._p, self._places = whole.filament.sites, np.array(prepared.p), whole.filament.places
        self._filament = Filament(self._sites.shape[0], doubles(self._p), doubles(self._places))
        count = self._sites.shape[0] * self._sites.shape[1]
        self._rates = np.zeros(count)
        # More than any structure asks for.
        self._scratch = np.zeros(100 * count)

    def rates(self, t: float, x: Floats) -> Floats:
        """Rates in the order of the graph, shape (nx,)."""
        self._call(t, x, 1)
        return self._rates[self._sites.x].copy()

    def seconds(self, t: float, x: Floats, calls: int) -> float:
        """Time of one call, of many in a row."""
        began = time.perf_counter()
        self._call(t, x, calls)
        return (time.perf_counter() - began) / calls

    def _call(self, t: float, x: Floats, calls: int) -> None:
        state = self._sites.state(x, np.zeros(0)).ravel()
        arrays = (doubles(array) for array in (state, self._rates, self._scratch))
        code = self._repeat(c.byref(self._filament), c.c_double(t), *arrays, c.c_int(calls))
        if code:
            raise RuntimeError(f"the right-hand side returned {code}")
