"""The programs of a work-precision diagram: the package's own integrators, and rivals on the same right-hand side.

A rival is written to win: explicit methods run on the generated C, SciPy's on the same C with an exact Jacobian,
sparse or banded, and BDF up to its fifth order stands beside the second order with which the package is content.
"""

from __future__ import annotations

import ctypes as ct
import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from softcat_sym.effects import choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene
from softcat_sym.solve import Prepared, Settings, Silence, Solution, choose_backend, prepare, settings_for
from softcat_sym.solve.assembled import Assembled, assembled
from softcat_sym.solve.c_model import Answer, CModel, Run, Status
from softcat_sym.solve.compiled import CompiledIntegration
from softcat_sym.solve.outcome import Outcome
from softcat_sym.study.work_precision_rates import CompiledRates, stable_step
from softcat_sym.study.work_precision_task import Task
from softcat_sym.trajectory.midpoint import midpoint_heights

Kind = Literal["own", "rival"]

_RODAS4 = 1
_FIFTH = 5
_TRIAL_STEPS = 50
_MISSING = "SciPy is missing: pip install 'softcat_sym[peers]'"


@dataclass(frozen=True, slots=True)
class Solved:
    """What one integration found, and how many steps and right-hand sides it took, 0 where nobody counts."""

    midpoint: Floats
    steps: int
    evaluations: int = 0


@dataclass(frozen=True, slots=True)
class Program:
    """A row of the diagram.

    Attributes
    ----------
    key, name : str
        In tables of ours, and for people.
    kind : str
        ``own``: what the package runs; ``rival``: what it does not.
    backend : str
        ``numerics.backend`` of the scene on which it runs.
    solver : str
        ``numerics.solver`` of the same.
    """

    key: str
    name: str
    kind: Kind
    backend: str
    solver: str


PROGRAMS: tuple[Program, ...] = (
    Program("compiled-rodas5p", "Rodas5P, compiled", "own", "compiled", "rosenbrock"),
    Program("compiled-rodas4", "Rodas4, compiled", "own", "compiled", "rosenbrock"),
    Program("rosenbrock", "Rosenbrock, interpreted", "own", "interpreted", "rosenbrock"),
    Program("cvodes", "CVODES, order 2", "own", "interpreted", "cvodes"),
    Program("cvodes-5", "CVODES, to order 5", "rival", "interpreted", "cvodes"),
    Program("idas", "IDAS, order 2", "own", "interpreted", "idas"),
    Program("idas-5", "IDAS, to order 5", "rival", "interpreted", "idas"),
    Program("compiled-rk4", "RK4, compiled", "rival", "compiled", "rosenbrock"),
    Program("numpy-rk4", "RK4, NumPy", "rival", "compiled", "rosenbrock"),
    Program("scipy-radau", "SciPy Radau", "rival", "compiled", "rosenbrock"),
    Program("scipy-bdf", "SciPy BDF", "rival", "compiled", "rosenbrock"),
    Program("scipy-lsoda", "SciPy LSODA", "rival", "compiled", "rosenbrock"),
)
_BY_KEY = {program.key: program for program in PROGRAMS}
_SCIPY = {"scipy-radau": "Radau", "scipy-bdf": "BDF", "scipy-lsoda": "LSODA"}


def program_of(key: str) -> Program:
    """The program with this key.

    Raises
    ------
    KeyError
        If there is none.
    """
    return _BY_KEY[key]


class _FifthOrder(Settings):
    """BDF up to its fifth order, which is accurate where flow damps the elastic waves, and unstable where none does."""

    def options(self) -> dict[str, Any]:
        return {**Settings.options(self), "max_order": _FIFTH}


class _Rodas4(CModel):
    """A compiled model integrated by the method of fourth order (Hairer & Wanner 1996); nothing is loaded anew."""

    def __init__(self, model: CModel) -> None:
        vars(self).update(vars(model))

    def integrate(self, run: Run, status: Status, stop: ct.c_int | None = None, room: Answer | None = None) -> Answer:
        return super().integrate(replace(run, method=_RODAS4), status, stop, room)


class Bench:
    """Makes programs ready for a scene, one after another; what they share is built once.

    Parameters
    ----------
    scene : Scene
        What is asked; its effects are a list.
    limit : float
        How long an integration may take [s].
    """

    def __init__(self, scene: Scene, limit: float) -> None:
        self._scene, self._limit = scene, limit
        self._built: tuple[Scene, Assembled] | None = None

    def ready(self, task: Task) -> Callable[[], Solved]:
        """Build all that a program needs; what is returned does nothing but integrate.

        Raises
        ------
        SoftcatError
            If the program cannot solve the scene, or would take longer than the limit.
        """
        prepared = self._prepare(task)
        if prepared.start is None:
            raise SoftcatError("no shape in balance was found to begin from")
        if task.program in ("compiled-rk4", "numpy-rk4"):
            return self._stepped(prepared, task)
        if task.program in _SCIPY:
            return _scipy(prepared, _SCIPY[task.program])
        return lambda: _own(prepared)

    def _prepare(self, task: Task) -> Prepared:
        program = program_of(task.program)
        scene = scene_of(self._scene, task, program)
        effects = choose_effects(scene)
        backend = choose_backend(scene, effects)
        settings = settings_for(scene, effects, compiled=backend.compiled)
        filament = self._assembled(scene.replace({"numerics.rtol": None, "numerics.solver": None}))
        code = filament.code(backend, settings)
        if task.program.endswith("-5"):
            settings = _FifthOrder(settings.solver, settings.rtol, settings.atol, settings.reason)
        prepared = prepare(scene, filament.graph, settings, filament.at_rest, (backend, code))
        whole = prepared.integration
        if task.program == "compiled-rodas4" and isinstance(whole, CompiledIntegration):
            other = replace(whole.filament, model=_Rodas4(whole.filament.model))
            return replace(prepared, integration=replace(whole, filament=other))
        return prepared

    def _assembled(self, scene: Scene) -> Assembled:
        """The filament of a scene, kept until another grid or section is asked for."""
        if self._built is None or self._built[0] != scene:
            self._built = scene, assembled(scene, choose_effects(scene))
        return self._built[1]

    def _stepped(self, prepared: Prepared, task: Task) -> Callable[[], Solved]:
        """RK4 in equal steps: in C, or step by step in NumPy."""
        rates = CompiledRates(prepared)
        step = task.rtol * _stable(prepared, rates)
        counts = [max(1, math.ceil(span / step)) if step > 0 else 1 for span in np.diff(prepared.times).tolist()]
        advance = rates.advance if task.program == "compiled-rk4" else _InNumpy(rates).advance
        trial, began = rates.start(), time.perf_counter()
        advance(trial, 0.0, _TRIAL_STEPS * min(step, float(prepared.times[1])), _TRIAL_STEPS)
        expected = (time.perf_counter() - began) / _TRIAL_STEPS * sum(counts)
        if expected > self._limit:
            raise SoftcatError(f"{sum(counts)} steps would take {expected:.3g} s")

        def solve() -> Solved:
            state = rates.start()
            states = np.empty((len(prepared.times), rates.size))
            states[0] = state
            for k, count in enumerate(counts):
                if not advance(state, float(prepared.times[k]), float(prepared.times[k + 1]), count):
                    raise SoftcatError(f"the answer is not finite after frame {k}")
                states[k + 1] = state
            return Solved(_midpoint(prepared, rates, states), sum(counts), 4 * sum(counts))

        return solve


def scene_of(scene: Scene, task: Task, program: Program) -> Scene:
    """The scene on which a task runs: one run, nothing chosen."""
    named = "numerics.order" if task.by_order else "numerics.fibres"
    sections = {"numerics.fibres": None, "numerics.order": None, named: task.section or None}
    return scene.replace(
        {
            **sections,
            "numerics.estimate": False,
            "numerics.cells": task.cells,
            "numerics.grading": task.grading,
            "numerics.backend": program.backend,
            "numerics.solver": program.solver,
            "numerics.rtol": 1e-3 if program.key in ("compiled-rk4", "numpy-rk4") else task.rtol,
        }
    )


class _InNumpy:
    """RK4 with the sums of a step in NumPy, in arrays that are made once."""

    def __init__(self, rates: CompiledRates) -> None:
        self._rates = rates.rates
        self._stage, self._sum = np.empty(rates.size), np.empty(rates.size)

    def advance(self, state: Floats, begin: float, end: float, steps: int) -> bool:
        """Carry a state through equal steps, in place; whether it is still finite."""
        rates, stage, total = self._rates, self._stage, self._sum
        dt = (end - begin) / steps
        for k in range(steps):
            t = begin + k * dt
            np.multiply(rates(t, state), dt / 6, out=total)
            np.multiply(total, 3.0, out=stage)
            for ahead in (0.5, 1.0):
                np.add(stage, state, out=stage)
                slope = rates(t + 0.5 * dt, stage)
                np.multiply(slope, ahead * dt, out=stage)
                slope *= dt / 3
                total += slope
            np.add(stage, state, out=stage)
            slope = rates(t + dt, stage)
            slope *= dt / 6
            total += slope
            state += total
        return bool(np.isfinite(state).all())


def _own(prepared: Prepared) -> Solved:
    solution = prepared.solve(Silence())
    if solution.outcome is not Outcome.solved:
        raise SoftcatError(f"{solution.outcome.name}: {solution.complaint}")
    return Solved(midpoint_heights(prepared.graph, solution), solution.steps)


def _scipy(prepared: Prepared, method: str) -> Callable[[], Solved]:
    """One of SciPy's integrators with an exact Jacobian, banded for LSODA, sparse for the others.

    Raises
    ------
    SoftcatError
        If SciPy is missing, or gives up.
    """
    try:
        from scipy.integrate import solve_ivp  # type: ignore[import-untyped]
    except ImportError:
        raise SoftcatError(_MISSING) from None
    rates, times = CompiledRates(prepared), prepared.times
    band = {"jac": rates.banded, "lband": rates.band, "uband": rates.band}
    options: dict[str, Any] = band if method == "LSODA" else {"jac": rates.sparse}
    options |= {"rtol": prepared.settings.rtol, "atol": prepared.settings.atol}

    def solve() -> Solved:
        found = solve_ivp(rates.rates, (0.0, times[-1]), rates.start(), method=method, t_eval=times, **options)
        if not found.success:
            raise SoftcatError(str(found.message))
        return Solved(_midpoint(prepared, rates, found.y.T.copy()), 0, int(found.nfev))

    return solve


def _stable(prepared: Prepared, rates: CompiledRates) -> float:
    """The longest stable step of RK4 at the start, midway and at the end of a run."""
    whole = prepared.integration
    solution = prepared.solve(Silence())
    if not isinstance(whole, CompiledIntegration) or solution.outcome is not Outcome.solved:
        raise SoftcatError(f"no run to find the stable step of: {solution.complaint}")
    found = []
    for frame in (0, len(solution.time) // 2, len(solution.time) - 1):
        state = whole.filament.sites.state(solution.x[:, frame], solution.z[:, frame]).ravel()
        found.append(stable_step(rates.dense(float(solution.time[frame]), state)))
    return min(*found, float(prepared.times[-1]))


def _midpoint(prepared: Prepared, rates: CompiledRates, states: Floats) -> Floats:
    x, z = rates.unknowns(states)
    nothing = np.zeros((3, len(states)))
    return midpoint_heights(prepared.graph, Solution(prepared.times, x, z, nothing, Outcome.solved, "", 0))
