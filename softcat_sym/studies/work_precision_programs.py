"""Programs of a work-precision diagram: integrators of the package, and rivals with the same right-hand side."""

from __future__ import annotations

import ctypes as ct
import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from importlib import resources
from statistics import median
from typing import Any, Literal

import numpy as np
from scipy.integrate import solve_ivp
from scipy.sparse import csc_matrix

from softcat_sym.codegen.library import compile_library, load
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.results.fields import midpoint_heights
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.compiled import (
    Answer,
    CModel,
    CompiledIntegration,
    Doubles,
    Filament,
    Integers,
    RunInput,
    Status,
    runtime_sources,
)
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run import Assembled, Prepared, assembled, prepare
from softcat_sym.solvers.settings import Settings, choose_backend, settings_for
from softcat_sym.solvers.solution import Silence, Solution


@dataclass(frozen=True, slots=True)
class Task:
    """One program with its numerical settings."""

    program: str  # Key of a program, such as ``"compiled-rodas5p"``
    cells: int  # Per half span
    grading: float  # Length of the cells at midspan over that at the clamps
    section: int = 0  # Fibres through the thickness; 0 without fibres
    rtol: float = 1e-3  # Relative tolerance; for RK4, the step over the longest stable one

    @property
    def text(self) -> str:
        """Text such as ``40 cells, 8 fibres, rtol 1e-03``."""
        parts = [f"{self.cells} cells"]
        if self.section:
            parts.append(f"{self.section} fibres")
        if self.program in STEPPED:
            parts += [f"grading {self.grading:.3g}", f"{self.rtol:g} of the stable step"]
        else:
            parts.append(f"rtol {self.rtol:.1g}")
        return ", ".join(parts)


STEPPED = frozenset({"compiled-rk4", "numpy-rk4"})
"""Programs with a constant step."""


@dataclass(frozen=True, slots=True)
class Measured:
    """Measurement of a task."""

    # Median processor time of the integration in several warm runs [s]; for a failure, the time until it failed
    seconds: float
    build: float = 0.0  # Wall time of all preparations, the first time in a process, with cached libraries [s]
    steps: int = 0  # Number of steps; 0 if not counted
    evaluations: int = 0  # Number of right-hand sides, without those of Jacobians; 0 if not counted
    repeats: int = 0  # Runs of which `seconds` is the median
    midpoint: tuple[float, ...] = ()  # Height of midspan at the output times, in rest lengths; empty if it failed
    message: str = ""  # Why it failed; empty if it did not
    first: float = 0.0  # Processor time of the first, cold integration [s]
    stopped: bool = False  # Whether it took longer than the limit
    hopeless: bool = False  # Whether it would fail with any grid or tolerance


_HEADER = "softcat_model.h"
_ON_THE_LIMIT = 1 + 1e-9
_REACH = 2.83
"""RK4 is stable up to 2.83 on the imaginary axis and 2.79 on the real one."""


class _Model(ct.Structure):
    """softcat_model."""

    _fields_ = (
        *(
            (n, ct.c_int)
            for n in ("slots", "sections", "parameters", "places", "scratch", "entries", "powers", "moves")
        ),
        *((n, Integers) for n in ("rate", "differential", "held_first", "held_last", "row", "offset", "column")),
        *((n, ct.c_void_p) for n in ("rates", "jacobian", "work", "work_slope")),
    )


_JACOBIAN = ct.CFUNCTYPE(ct.c_int, ct.POINTER(Filament), ct.c_double, Doubles, Doubles, Doubles)


_STIFF = 1e9
"""Relaxation rate of algebraic unknowns towards the solution of their equation, in units of the time scale; for large
rates a stiffly accurate method solves that equation itself (Hairer & Wanner 1996, VI.1)."""


class CompiledRates:
    """Rates and Jacobian of a compiled filament, for states with an entry for every slot."""

    def __init__(self, prepared: Prepared) -> None:
        whole = prepared.integration
        if not isinstance(whole, CompiledIntegration) or prepared.start is None:
            raise SoftcatError("an explicit method needs a compiled right-hand side and a starting shape")
        filament, source = whole.filament, "work_precision_explicit.c"
        library = _library("filament.c", filament.model.model.text)
        self._c = _library(source, (resources.files("softcat_sym.studies") / source).read_text(encoding="utf-8"))
        self._c.explicit_rates.restype = self._c.explicit_rk4.restype = ct.c_int
        model = _Model.in_dll(library, "softcat_filament_model")
        self._jacobian = _JACOBIAN(model.jacobian)
        self._sites = filament.sites
        sites, slots = self._sites.shape
        self.size = sites * slots
        self.start = self._sites.state(prepared.start.x, prepared.start.z).ravel()
        live = np.zeros(self.size, dtype=bool)
        live[np.concatenate([self._sites.x, self._sites.z])] = True
        # Memory is allocated and pointers are made once, so that a call costs little more than its arithmetic.
        parameters, places = np.ascontiguousarray(prepared.p), filament.places
        held = np.flatnonzero(~live).astype(np.int32)
        self._state, self._rates, self._scratch = (
            np.zeros(n) for n in (self.size, self.size, sites * model.scratch + 1)
        )
        self._entries, self._room = np.zeros(sites * model.entries), np.zeros(3 * self.size + sites * model.scratch)
        self._filament = ct.byref(Filament(sites, _pointer(parameters), _pointer(places)))
        self._head = ct.byref(model), self._filament, held.ctypes.data_as(Integers), ct.c_int(len(held))
        self._for_rates = tuple(map(_pointer, (self._state, self._rates, self._scratch)))
        self._for_entries = tuple(map(_pointer, (self._state, self._entries, self._scratch)))
        self._keep = library, parameters, places, held, model
        # Row, column and number of every entry that can differ from zero, in the order of columns.
        row, offset, column = (
            np.array(part[: model.entries], dtype=np.int64) for part in (model.row, model.offset, model.column)
        )
        site = np.arange(sites)[:, None]
        rows, columns = np.broadcast_to(site * slots + row, (sites, model.entries)), (site + offset) * slots + column
        inside = (site + offset >= 0) & (site + offset < sites)
        inside[inside] = live[rows[inside]] & live[columns[inside]]
        order = np.lexsort((rows[inside], columns[inside]))
        self._rows, self._columns = rows[inside][order], columns[inside][order]
        self._taken = np.flatnonzero(inside.ravel())[order]
        self._starts = np.concatenate([[0], np.cumsum(np.bincount(self._columns, minlength=self.size))])
        self.band = int(np.max(np.abs(self._rows - self._columns), initial=0))
        self._pace = np.ones(self.size)
        if prepared.graph.is_dae:
            algebraic = self._sites.z
            towards = self.sparse(0.0, self.start).diagonal()[algebraic]
            if np.any(towards == 0):
                raise SceneError(
                    [Fault("run.effects", "algebraic unknowns without an equation of their own", "others")]
                )
            self._pace[algebraic] = -_STIFF / towards

    def unknowns(self, states: Floats) -> tuple[Floats, Floats]:
        """Arrays x and z of :class:`softcat_sym.solvers.Solution`, from states (frames, size)."""
        return self._sites.vectors(states.reshape(len(states), *self._sites.shape))

    def rates(self, t: float, state: Floats) -> Floats:
        """Rates of a state, shape (size,); zero for entries that are held."""
        self._state[:] = state
        self._c.explicit_rates(*self._head, ct.c_double(t), *self._for_rates)
        return self._rates * self._pace

    def entries(self, t: float, state: Floats) -> Floats:
        """Entries of the Jacobian that can differ from zero, column by column."""
        self._state[:] = state
        self._jacobian(self._filament, t, *self._for_entries)
        return self._entries[self._taken] * self._pace[self._rows]

    def sparse(self, t: float, state: Floats) -> Any:
        """The Jacobian as a ``scipy.sparse.csc_matrix``, shape (size, size)."""
        return csc_matrix((self.entries(t, state), self._rows, self._starts), shape=(self.size, self.size))

    def banded(self, t: float, state: Floats) -> Floats:
        """The Jacobian by diagonals, shape (2 band + 1, size), in the format of LAPACK and LSODA."""
        packed = np.zeros((2 * self.band + 1, self.size))
        packed[self._rows - self._columns + self.band, self._columns] = self.entries(t, state)
        return packed

    def dense(self, t: float, state: Floats) -> Floats:
        """The Jacobian of the entries that are not held, shape (nx, nx)."""
        live = np.sort(self._sites.x)
        return np.asarray(self.sparse(t, state).toarray()[np.ix_(live, live)])

    def advance(self, state: Floats, begin: float, end: float, steps: int) -> bool:
        """Advance a state by constant steps of RK4, in place; return whether it is still finite."""
        ends, room = (ct.c_double(begin), ct.c_double(end), ct.c_long(steps)), (_pointer(state), _pointer(self._room))
        return self._c.explicit_rk4(*self._head, *ends, *room) == 0 and bool(np.isfinite(state).all())


def stable_step(jacobian: Floats) -> float:
    """The longest step of RK4 at which no mode of a linear system grows."""
    modes = np.linalg.eigvals(jacobian)
    # Modes that grow physically do so with any step.
    modes = modes[modes.real <= 1e-6 * np.abs(modes)]
    fastest = float(np.abs(modes).max(initial=0.0))
    if fastest == 0:
        return np.inf
    low, high = 0.0, _REACH / fastest
    for _ in range(40):
        middle = (low + high) / 2
        q = middle * np.minimum(modes.real, 0.0) + 1j * middle * modes.imag
        stable = np.abs(1 + q * (1 + q / 2 * (1 + q / 3 * (1 + q / 4)))).max() <= _ON_THE_LIMIT
        low, high = (middle, high) if stable else (low, middle)
    return float(low)


@lru_cache(maxsize=16)
def _library(name: str, text: str) -> ct.CDLL:
    """C code that includes the model's header, loaded once in a process."""
    return load(compile_library({name: text, _HEADER: runtime_sources()[_HEADER]}))


def _pointer(array: Floats) -> ct._Pointer[ct.c_double]:
    return array.ctypes.data_as(Doubles)


Kind = Literal["own", "rival"]

_RODAS4 = 2
_FIFTH = 5
_TRIAL_STEPS = 50


@dataclass(frozen=True, slots=True)
class Solved:
    """Result of one integration, with the numbers of steps and right-hand sides; 0 if not counted."""

    midpoint: Floats
    steps: int
    evaluations: int = 0


@dataclass(frozen=True, slots=True)
class Program:
    """A row of the diagram."""

    key: str  # Key in tables, and name for readers
    name: str
    kind: Kind  # ``own``: an integrator of the package; ``rival``: another one
    backend: str  # ``numerics.backend`` of its scene
    solver: str  # ``numerics.solver`` of its scene


PROGRAMS: tuple[Program, ...] = (
    Program("compiled-rodas5p", "Rodas5P, compiled", "own", "compiled", "rosenbrock"),
    Program("compiled-rodas4", "Rodas4, compiled", "own", "compiled", "rosenbrock"),
    Program("rosenbrock", "Rosenbrock, interpreted", "own", "interpreted", "rosenbrock"),
    Program("cvodes", "CVODES (order 2)", "own", "interpreted", "cvodes"),
    Program("cvodes-5", "CVODES (to order 5)", "rival", "interpreted", "cvodes"),
    Program("idas", "IDAS (order 2)", "own", "interpreted", "idas"),
    Program("idas-5", "IDAS (to order 5)", "rival", "interpreted", "idas"),
    Program("compiled-rk4", "RK4, compiled", "rival", "compiled", "rosenbrock"),
    Program("numpy-rk4", "RK4, NumPy", "rival", "compiled", "rosenbrock"),
    Program("scipy-radau", "SciPy Radau", "rival", "compiled", "rosenbrock"),
    Program("scipy-bdf", "SciPy BDF", "rival", "compiled", "rosenbrock"),
    Program("scipy-lsoda", "SciPy LSODA", "rival", "compiled", "rosenbrock"),
)
RIVALS = tuple(program for program in PROGRAMS if program.key in ("idas", "scipy-radau"))
"""Default rivals: the better IDAS, and a usual choice in Python for stiff equations."""

OTHER_FAMILIES = frozenset({"cvodes", "cvodes-5", "idas", "idas-5", "scipy-radau", "scipy-bdf", "scipy-lsoda"})
"""Programs without a Rosenbrock method, which can confirm an answer."""

THIS_PROGRAM = "softcat"
"""Key of the program that `softcat run` uses."""

_SCIPY = {"scipy-radau": "Radau", "scipy-bdf": "BDF", "scipy-lsoda": "LSODA"}


class _FifthOrder(Settings):
    """BDF up to order five, which is accurate where flow damps the elastic waves, and unstable without damping."""

    def options(self) -> dict[str, Any]:
        return {**Settings.options(self), "max_order": _FIFTH}


class _Rodas4(CModel):
    """A compiled model, integrated by the method of order four (Hairer & Wanner 1996) with the same library."""

    def __init__(self, model: CModel) -> None:
        vars(self).update(vars(model))

    def integrate(
        self, run: RunInput, status: Status, stop: ct.c_int | None = None, room: Answer | None = None
    ) -> Answer:
        return super().integrate(replace(run, method=_RODAS4), status, stop, room)


class Bench:
    """Prepares programs for a scene, one after another; common parts are built once."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._built: tuple[Scene, Assembled] | None = None

    def ready(self, task: Task, seconds: float = math.inf) -> Callable[[], Solved]:
        """Build everything that a program needs; return a function that only integrates, within a time limit."""
        prepared = self._prepare(task)
        if prepared.start is None:
            raise SoftcatError("no equilibrium was found to start from")
        if task.program in ("compiled-rk4", "numpy-rk4"):
            return self._stepped(prepared, task, seconds)
        if task.program in _SCIPY:
            return _scipy(prepared, _SCIPY[task.program])
        return lambda: _own(prepared)

    def _prepare(self, task: Task) -> Prepared:
        scene = scene_of(self._scene, task)
        effects = choose_effects(scene)
        backend = choose_backend(scene, effects)
        settings = settings_for(scene, effects, compiled=backend.compiled)
        filament = self._assembled(scene.replace({"numerics.rtol": None, "numerics.solver": None}))
        code = filament.code(backend, settings)
        if task.program.endswith("-5"):
            settings = _FifthOrder(settings.solver, settings.rtol, settings.atol, settings.reason)
        prepared = prepare(scene, filament.graph, settings, filament.at_rest, (backend, code), filament.code_at_rest)
        whole = prepared.integration
        if task.program == "compiled-rodas4" and isinstance(whole, CompiledIntegration):
            other = replace(whole.filament, model=_Rodas4(whole.filament.model))
            return replace(prepared, integration=replace(whole, filament=other))
        return prepared

    def _assembled(self, scene: Scene) -> Assembled:
        """The filament of a scene, kept until a scene with another grid or section comes."""
        if self._built is None or self._built[0] != scene:
            self._built = scene, assembled(scene, choose_effects(scene))
        return self._built[1]

    def _stepped(self, prepared: Prepared, task: Task, seconds: float) -> Callable[[], Solved]:
        """RK4 with a constant step, in C or in NumPy."""
        if prepared.graph.is_dae:
            raise SceneError(
                [Fault("run.effects", "algebraic unknowns", "effects without any, for an explicit method")]
            )
        rates = CompiledRates(prepared)
        step = task.rtol * _stable(prepared, rates)
        counts = [max(1, math.ceil(span / step)) if step > 0 else 1 for span in np.diff(prepared.times).tolist()]
        advance = rates.advance if task.program == "compiled-rk4" else partial(_advance_in_numpy, rates)
        trial, began = rates.start.copy(), time.process_time()
        advance(trial, 0.0, _TRIAL_STEPS * min(step, float(prepared.times[1])), _TRIAL_STEPS)
        expected = (time.process_time() - began) / _TRIAL_STEPS * sum(counts)
        if expected > seconds:
            raise SoftcatError(f"{sum(counts)} steps would take {expected:.3g} s")

        def solve() -> Solved:
            state = rates.start.copy()
            states = np.empty((len(prepared.times), rates.size))
            states[0] = state
            for k, count in enumerate(counts):
                if not advance(state, float(prepared.times[k]), float(prepared.times[k + 1]), count):
                    raise SoftcatError(f"the answer is not finite after frame {k}")
                states[k + 1] = state
            return Solved(_midpoint(prepared, rates, states), sum(counts), 4 * sum(counts))

        return solve


def scene_of(scene: Scene, task: Task) -> Scene:
    """The scene of a task: a single run with the settings of the task."""
    program = next((each for each in PROGRAMS if each.key == task.program), None)
    return scene.replace(
        {
            "numerics.order": None,
            "numerics.fibres": task.section or None,
            "numerics.estimate": False,
            "numerics.cells": task.cells,
            "numerics.grading": task.grading,
            "numerics.backend": program.backend if program else scene.numerics.backend,
            "numerics.solver": program.solver if program else scene.numerics.solver,
            "numerics.rtol": 1e-3 if task.program in STEPPED else task.rtol,
        }
    )


def _advance_in_numpy(rates: CompiledRates, state: Floats, begin: float, end: float, steps: int) -> bool:
    """Advance a state by constant steps of RK4, in place; return whether it is still finite."""
    stage, total, dt = np.empty(rates.size), np.empty(rates.size), (end - begin) / steps
    for t in begin + dt * np.arange(steps):
        np.multiply(rates.rates(t, state), dt / 6, out=total)
        np.multiply(total, 3.0, out=stage)
        for ahead in (0.5, 1.0):
            np.add(stage, state, out=stage)
            slope = rates.rates(t + 0.5 * dt, stage)
            np.multiply(slope, ahead * dt, out=stage)
            slope *= dt / 3
            total += slope
        np.add(stage, state, out=stage)
        slope = rates.rates(t + dt, stage)
        slope *= dt / 6
        total += slope
        state += total
    return bool(np.isfinite(state).all())


def _own(prepared: Prepared) -> Solved:
    solution = prepared.solve(Silence())
    if solution.outcome is not Outcome.solved:
        raise SoftcatError(f"{solution.outcome.name}: {solution.message}")
    return Solved(midpoint_heights(prepared.graph, solution), solution.steps)


def _scipy(prepared: Prepared, method: str) -> Callable[[], Solved]:
    """One of SciPy's integrators with an exact Jacobian, banded for LSODA, sparse for the others."""
    rates, times = CompiledRates(prepared), prepared.times
    band = {"jac": rates.banded, "lband": rates.band, "uband": rates.band}
    options: dict[str, Any] = band if method == "LSODA" else {"jac": rates.sparse}
    options |= {"rtol": prepared.settings.rtol, "atol": prepared.settings.atol}

    def solve() -> Solved:
        found = solve_ivp(rates.rates, (0.0, times[-1]), rates.start.copy(), method=method, t_eval=times, **options)
        if not found.success:
            raise SoftcatError(str(found.message))
        return Solved(_midpoint(prepared, rates, found.y.T.copy()), 0, int(found.nfev))

    return solve


def _stable(prepared: Prepared, rates: CompiledRates) -> float:
    """The longest stable step of RK4 at the start, midway and at the end of a run."""
    whole = prepared.integration
    solution = prepared.solve(Silence())
    if not isinstance(whole, CompiledIntegration) or solution.outcome is not Outcome.solved:
        raise SoftcatError(f"no run to find the stable step of: {solution.message}")
    found = []
    for frame in (0, len(solution.time) // 2, len(solution.time) - 1):
        state = whole.filament.sites.state(solution.x[:, frame], solution.z[:, frame]).ravel()
        found.append(stable_step(rates.dense(float(solution.time[frame]), state)))
    return min(*found, float(prepared.times[-1]))


def _midpoint(prepared: Prepared, rates: CompiledRates, states: Floats) -> Floats:
    x, z = rates.unknowns(states)
    nothing = np.zeros((3, len(states)))
    return midpoint_heights(prepared.graph, Solution(prepared.times, x, z, nothing, Outcome.solved, "", 0))


_REPEATS = 7
_LONG = 0.5  # s; total time after which there are no further repetitions
EXPECTED = (SoftcatError, RuntimeError, ArithmeticError, ValueError, MemoryError)
"""Errors of other integrators that fail, and our own."""


def integrate(solve: Callable[[], Solved], build: float, seconds: float = math.inf) -> Measured:
    """Integrate once to warm up, then several times; only once if that is long or takes most of the remaining time."""
    began = time.process_time()
    try:
        found = solve()
    except EXPECTED as error:
        return Measured(time.process_time() - began, build, message=message_of(error))
    first = spent = time.process_time() - began
    warm: list[float] = []
    while len(warm) < _REPEATS and spent < _LONG and spent + first < seconds:
        began = time.process_time()
        solve()
        warm.append(time.process_time() - began)
        spent += warm[-1]
    warm = warm or [first]
    midpoint = tuple(found.midpoint.tolist())
    return Measured(median(warm), build, found.steps, found.evaluations, len(warm), midpoint, first=first)


def message_of(error: BaseException) -> str:
    """An error in one line."""
    return " ".join(str(error).split())[:300] or type(error).__name__
