"""Programs of a work-precision diagram: integrators of the package, and SciPy's Radau with the same rates."""

from __future__ import annotations

import ctypes as ct
import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
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
    CompiledIntegration,
    Doubles,
    Filament,
    Integers,
    runtime_sources,
)
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run import Assembled, Prepared, assembled, prepare
from softcat_sym.solvers.settings import choose_backend, settings_for
from softcat_sym.solvers.solution import Silence, Solution


@dataclass(frozen=True, slots=True)
class Task:
    """One program with its numerical settings."""

    program: str  # Key of a program, such as ``"compiled-rodas5p"``
    cells: int  # Per half span
    grading: float  # Length of the cells at midspan over that at the clamps
    section: int = 0  # Fibres through the thickness; 0 without fibres
    rtol: float = 1e-3  # Relative tolerance

    @property
    def text(self) -> str:
        """Text such as ``40 cells, 8 fibres, rtol 1e-03``."""
        parts = [f"{self.cells} cells"]
        if self.section:
            parts.append(f"{self.section} fibres")
        parts.append(f"rtol {self.rtol:.1g}")
        return ", ".join(parts)


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


_CALL = ct.CFUNCTYPE(ct.c_int, ct.POINTER(Filament), ct.c_double, Doubles, Doubles, Doubles)


_STIFF = 1e9
"""Relaxation rate of algebraic unknowns towards the solution of their equation, in units of the time scale; for large
rates a stiffly accurate method solves that equation itself (Hairer & Wanner 1996, VI.1)."""


class CompiledRates:
    """Rates and Jacobian of a compiled filament, for states with an entry for every slot."""

    def __init__(self, prepared: Prepared) -> None:
        whole = prepared.integration
        if not isinstance(whole, CompiledIntegration) or prepared.start is None:
            raise SoftcatError("the rates need a compiled filament and a starting shape")
        filament = whole.filament
        library = _library(filament.model.model.text)
        model = _Model.in_dll(library, "softcat_filament_model")
        self._rates_of, self._jacobian = _CALL(model.rates), _CALL(model.jacobian)
        self._sites = filament.sites
        sites, slots = self._sites.shape
        self.size = sites * slots
        self.start = self._sites.state(prepared.start.x, prepared.start.z).ravel()
        live = np.zeros(self.size, dtype=bool)
        live[np.concatenate([self._sites.x, self._sites.z])] = True
        # Memory is allocated and pointers are made once, so that a call costs little more than its arithmetic.
        parameters, places = np.ascontiguousarray(prepared.p), filament.places
        self._state, self._rates, self._scratch = (
            np.zeros(n) for n in (self.size, self.size, sites * model.scratch + 1)
        )
        self._entries = np.zeros(sites * model.entries)
        self._filament = ct.byref(Filament(sites, _pointer(parameters), _pointer(places)))
        self._for_rates = tuple(map(_pointer, (self._state, self._rates, self._scratch)))
        self._for_entries = tuple(map(_pointer, (self._state, self._entries, self._scratch)))
        self._keep = library, parameters, places
        # Row, column and number of every entry that can differ from zero, in the order of columns.
        row, offset, column = (
            np.array(part[: model.entries], dtype=np.int64) for part in (model.row, model.offset, model.column)
        )
        site = np.arange(sites)[:, None]
        rows, columns = np.broadcast_to(site * slots + row, (sites, model.entries)), (site + offset) * slots + column
        inside = (site + offset >= 0) & (site + offset < sites)
        inside[inside] = live[rows[inside]] & live[columns[inside]]
        order = np.lexsort((rows[inside], columns[inside]))
        self._rows, across = rows[inside][order], columns[inside][order]
        self._taken = np.flatnonzero(inside.ravel())[order]
        self._starts = np.concatenate([[0], np.cumsum(np.bincount(across, minlength=self.size))])
        self._pace = live.astype(float)
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
        self._rates_of(self._filament, t, *self._for_rates)
        return np.asarray(self._rates * self._pace)

    def entries(self, t: float, state: Floats) -> Floats:
        """Entries of the Jacobian that can differ from zero, column by column."""
        self._state[:] = state
        self._jacobian(self._filament, t, *self._for_entries)
        return np.asarray(self._entries[self._taken] * self._pace[self._rows])

    def sparse(self, t: float, state: Floats) -> Any:
        """The Jacobian as a ``scipy.sparse.csc_matrix``, shape (size, size)."""
        return csc_matrix((self.entries(t, state), self._rows, self._starts), shape=(self.size, self.size))


@lru_cache(maxsize=16)
def _library(text: str) -> ct.CDLL:
    """The C code of a model, loaded once in a process."""
    return load(compile_library({"filament.c": text, _HEADER: runtime_sources()[_HEADER]}))


def _pointer(array: Floats) -> ct._Pointer[ct.c_double]:
    return array.ctypes.data_as(Doubles)


Kind = Literal["own", "rival"]


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
    Program("cvodes", "CVODES (order 2)", "own", "interpreted", "cvodes"),
    Program("idas", "IDAS (order 2)", "own", "interpreted", "idas"),
    Program("scipy-radau", "SciPy Radau", "rival", "compiled", "rosenbrock"),
)
RIVALS = tuple(program for program in PROGRAMS if program.key in ("idas", "scipy-radau"))
"""Default rivals: the better IDAS, and a usual choice in Python for stiff equations."""

OTHER_FAMILIES = frozenset({"cvodes", "idas", "scipy-radau"})
"""Programs without a Rosenbrock method, which can confirm an answer."""

THIS_PROGRAM = "softcat"
"""Key of the program that `softcat run` uses."""


class Bench:
    """Prepares programs for a scene, one after another; common parts are built once."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._built: tuple[Scene, Assembled] | None = None

    def ready(self, task: Task) -> Callable[[], Solved]:
        """Build everything that a program needs; return a function that only integrates."""
        prepared = self._prepare(task)
        if prepared.start is None:
            raise SoftcatError("no equilibrium was found to start from")
        if task.program == "scipy-radau":
            return _radau(prepared)
        return lambda: _own(prepared)

    def _prepare(self, task: Task) -> Prepared:
        scene = scene_of(self._scene, task)
        effects = choose_effects(scene)
        backend = choose_backend(scene, effects)
        settings = settings_for(scene, effects, compiled=backend.compiled)
        filament = self._assembled(scene.replace({"numerics.rtol": None, "numerics.solver": None}))
        code = filament.code(backend, settings)
        return prepare(scene, filament.graph, settings, filament.at_rest, (backend, code), filament.code_at_rest)

    def _assembled(self, scene: Scene) -> Assembled:
        """The filament of a scene, kept until a scene with another grid or section comes."""
        if self._built is None or self._built[0] != scene:
            self._built = scene, assembled(scene, choose_effects(scene))
        return self._built[1]


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
            "numerics.rtol": task.rtol,
        }
    )


def _own(prepared: Prepared) -> Solved:
    solution = prepared.solve(Silence())
    if solution.outcome is not Outcome.solved:
        raise SoftcatError(f"{solution.outcome.name}: {solution.message}")
    return Solved(midpoint_heights(prepared.graph, solution), solution.steps)


def _radau(prepared: Prepared) -> Callable[[], Solved]:
    """SciPy's Radau with an exact, sparse Jacobian."""
    rates, times, settings = CompiledRates(prepared), prepared.times, prepared.settings
    options: dict[str, Any] = {"jac": rates.sparse, "rtol": settings.rtol, "atol": settings.atol}

    def solve() -> Solved:
        found = solve_ivp(rates.rates, (0.0, times[-1]), rates.start.copy(), method="Radau", t_eval=times, **options)
        if not found.success:
            raise SoftcatError(str(found.message))
        x, z = rates.unknowns(found.y.T.copy())
        nothing = np.zeros((3, len(times)))
        ended = Solution(times, x, z, nothing, Outcome.solved, "", 0)
        return Solved(midpoint_heights(prepared.graph, ended), 0, int(found.nfev))

    return solve


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
