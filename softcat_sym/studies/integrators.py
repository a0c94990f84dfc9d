"""What is compared in a work-precision diagram: integrators of the package, and SciPy's Radau with the same rates."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from statistics import median
from typing import Any, Literal

import numpy as np
from scipy.integrate import solve_ivp

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.results.fields import midpoint_heights
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.rates import Rates
from softcat_sym.solvers.settings import choose_backend, settings_for
from softcat_sym.solvers.solution import Silence, Solution
from softcat_sym.solvers.solve import Assembled, Prepared, assembled, prepare


@dataclass(frozen=True, slots=True)
class Method:
    """A row of the diagram."""

    key: str  # Key in tables, and name for readers
    name: str
    kind: Literal["own", "rival"]  # ``own``: an integrator of the package; ``rival``: another one
    backend: str  # ``numerics.backend`` of its scene
    solver: str  # ``numerics.solver`` of its scene


METHODS: tuple[Method, ...] = (
    Method("compiled-rodas5p", "Rodas5P, compiled", "own", "compiled", "rosenbrock"),
    Method("cvodes", "CVODES (order 2)", "own", "interpreted", "cvodes"),
    Method("idas", "IDAS (order 2)", "own", "interpreted", "idas"),
    Method("scipy-radau", "SciPy Radau", "rival", "compiled", "rosenbrock"),
)
RIVALS = tuple(method for method in METHODS if method.key in ("idas", "scipy-radau"))
"""Default rivals: the better IDAS, and a usual choice in Python for stiff equations."""

OTHER_FAMILIES = frozenset({"cvodes", "idas", "scipy-radau"})
"""Methods other than Rosenbrock's, which can confirm an answer."""

THIS_PROGRAM = "softcat"
"""Key of the method that `softcat run` uses."""


@dataclass(frozen=True, slots=True)
class Task:
    """One method with its numerical settings."""

    method: str  # Key of a method, such as ``"compiled-rodas5p"``
    cells: int  # Per half span
    grading: float  # Length of the cells at midspan over that at the clamps
    section: int = 0  # Fibres through the thickness; 0 without fibres
    rtol: float = 1e-3  # Relative tolerance

    @property
    def text(self) -> str:
        """Text such as ``40 cells, 8 fibres, rtol 1e-03``."""
        fibres = [f"{self.section} fibres"] if self.section else []
        return ", ".join([f"{self.cells} cells", *fibres, f"rtol {self.rtol:.1g}"])


@dataclass(frozen=True, slots=True)
class Measurement:
    """What a task took, and its answer."""

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


@dataclass(frozen=True, slots=True)
class Solved:
    """Result of one integration, with the numbers of steps and right-hand sides; 0 if not counted."""

    midpoint: Floats
    steps: int
    evaluations: int = 0


def scene_of(scene: Scene, task: Task) -> Scene:
    """The scene of a task: a single run with the settings of the task."""
    method = next((each for each in METHODS if each.key == task.method), None)
    return scene.replace(
        {
            "numerics.order": None,
            "numerics.fibres": task.section or None,
            "numerics.estimate": False,
            "numerics.cells": task.cells,
            "numerics.grading": task.grading,
            "numerics.backend": method.backend if method else scene.numerics.backend,
            "numerics.solver": method.solver if method else scene.numerics.solver,
            "numerics.rtol": task.rtol,
            "numerics.tail": "integrate",
        }
    )


@lru_cache(maxsize=1)
def _assembled(scene: Scene) -> Assembled:
    """The filament of a scene, kept until a scene with another grid or section comes."""
    return assembled(scene, choose_effects(scene))


def ready(scene: Scene, task: Task) -> Callable[[], Solved]:
    """Build everything that a method needs; return a function that only integrates."""
    scene = scene_of(scene, task)
    effects = choose_effects(scene)
    backend = choose_backend(scene, effects)
    settings = settings_for(scene, effects, compiled=backend.compiled)
    filament = _assembled(scene.replace({"numerics.rtol": None, "numerics.solver": None}))
    prepared = prepare(scene, filament.graph, settings, replace(filament, backend=backend))
    if prepared.start is None:
        raise SoftcatError("no equilibrium was found to start from")
    if task.method == "scipy-radau":
        if prepared.code is None:
            raise SoftcatError("SciPy's Radau takes its rates from the compiled filament, and it is not compiled")
        return _radau(prepared, Rates(prepared.code, prepared.start, prepared.p))
    return lambda: _own(prepared)


def _own(prepared: Prepared) -> Solved:
    solution = prepared.solve(Silence())
    if solution.outcome is not Outcome.solved:
        raise SoftcatError(f"{solution.outcome.name}: {solution.message}")
    return Solved(midpoint_heights(prepared.graph, solution), solution.steps)


def _radau(prepared: Prepared, rates: Rates) -> Callable[[], Solved]:
    """SciPy's Radau with an exact, sparse Jacobian."""
    times, settings, moving = prepared.times, prepared.settings, prepared.graph.symbolic.x.numel()
    options: dict[str, Any] = {"jac": rates.jacobian, "rtol": settings.rtol, "atol": settings.atol}

    def solve() -> Solved:
        found = solve_ivp(rates.rates, (0.0, times[-1]), rates.start, method="Radau", t_eval=times, **options)
        if not found.success:
            raise SoftcatError(str(found.message))
        nothing = np.zeros((3, len(times)))
        ended = Solution(times, found.y[:moving], found.y[moving:], nothing, Outcome.solved, "", 0)
        return Solved(midpoint_heights(prepared.graph, ended), 0, int(found.nfev))

    return solve


_REPEATS = 7
_LONG = 0.5  # s; total time after which there are no further repetitions
EXPECTED = (SoftcatError, RuntimeError, ArithmeticError, ValueError, MemoryError)
"""Errors of other integrators that fail, and our own."""


def measure(scene: Scene, task: Task, seconds: float = math.inf) -> Measurement:
    """Build a task and integrate it, once to warm up and then several times; only once if that is long."""
    began = time.perf_counter()
    try:
        solve = ready(scene, task)
    except EXPECTED as error:
        return Measurement(0.0, message=_message_of(error), hopeless=isinstance(error, SceneError))
    build, began = time.perf_counter() - began, time.process_time()
    try:
        found = solve()
    except EXPECTED as error:
        return Measurement(time.process_time() - began, build, message=_message_of(error))
    first = spent = time.process_time() - began
    warm: list[float] = []
    while len(warm) < _REPEATS and spent < _LONG and spent + first < seconds - build:
        began = time.process_time()
        solve()
        warm.append(time.process_time() - began)
        spent += warm[-1]
    warm = warm or [first]
    midpoint = tuple(found.midpoint.tolist())
    return Measurement(median(warm), build, found.steps, found.evaluations, len(warm), midpoint, first=first)


def _message_of(error: BaseException) -> str:
    """An error in one line."""
    return " ".join(str(error).split())[:300] or type(error).__name__
