"""Elastic filaments that swing for many periods, and the symplectic methods that could follow them.

Gauss's collocation of one, two and three stages (the implicit midpoint rule, orders 4 and 6) on the package's compiled
right-hand side and its exact Jacobian. Written to win: stages are guessed by the polynomial of the step before, and a
Jacobian serves for as many steps as it can. Counted are evaluations of the right-hand side, each with a solve of its
share of the linear system, and factorisations.

Source: Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed. (2006), sections II.1.3 and VIII.6.
"""

from __future__ import annotations

import copy
import time
from dataclasses import dataclass, replace
from typing import Any

import casadi as ca
import numpy as np

import softcat_sym as sc
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.single_run import build
from softcat_sym.solvers.compiled import CompiledIntegration, RunInput, Status
from softcat_sym.solvers.run import Prepared
from tests.common.compiled_speed import GeneratedRates

_ROOT = 15**0.5
_COLLOCATION: dict[int, tuple[Floats, Floats]] = {
    1: (np.array([[0.5]]), np.array([1.0])),
    2: (np.array([[0.25, 0.25 - 3**0.5 / 6], [0.25 + 3**0.5 / 6, 0.25]]), np.array([0.5, 0.5])),
    3: (
        np.array(
            [
                [5 / 36, 2 / 9 - _ROOT / 15, 5 / 36 - _ROOT / 30],
                [5 / 36 + _ROOT / 24, 2 / 9, 5 / 36 - _ROOT / 24],
                [5 / 36 + _ROOT / 30, 2 / 9 + _ROOT / 15, 5 / 36],
            ]
        ),
        np.array([5 / 18, 4 / 9, 5 / 18]),
    ),
}
_ITERATIONS, _MANY = 30, 6
_MAX_STEPS = 1_000_000_000

_ELASTIC = "elastic"
SCENES: dict[str, dict[str, Any]] = {
    "no-yield, elastic": {
        "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
        "material": {"law": _ELASTIC, "youngs_modulus": "4 MPa"},
        "load": {"ramp": "0.0436 s"},
    },
    "stretched-rubber-band": {
        "filament": {"span": "0.1 m", "thickness": "1 mm", "density": "930 kg/m^3"},
        "material": {"law": _ELASTIC, "youngs_modulus": "1 MPa"},
        "initial": {"stretch": 1.25, "relaxed": False},
    },
    "drawn thin": {
        "filament": {"span": "0.2 m", "thickness": "0.2 mm", "density": "1900 kg/m^3"},
        "material": {"law": _ELASTIC, "youngs_modulus": "4 MPa"},
        "initial": {"stretch": 1.05, "relaxed": False},
    },
}
ACCURACY = 1e-3
"""Asked of every run."""

PERIODS = {"no-yield, elastic": 0.0983, "stretched-rubber-band": 0.01277, "drawn thin": 0.0394}
"""Of the first mode [s], as measured."""


def swinging(name: str, periods: int, frames: int, effects: str, numerics: dict[str, object]) -> Prepared:
    """An elastic filament for so many periods, with so many frames in each."""
    run = {
        "duration": f"{PERIODS[name] * periods!r} s",
        "frames": frames * periods + 1,
        "effects": effects,
        "accuracy": ACCURACY,
    }
    table = {"title": name, **SCENES[name], "run": run, "numerics": {"estimate": False, **numerics}}
    scene = sc.Scene.model_validate(table)
    return build(scene, choose_effects(scene))


def energies(prepared: Prepared, times: Floats, x: Floats, z: Floats) -> tuple[Floats, float]:
    """Energy at every frame, and the largest kinetic one, which is that of the swing."""
    fields = prepared.graph.observe(times, x, z, prepared.p)
    whole = fields["energy_kinetic"] + fields["energy_elastic"] + fields["energy_potential"]
    return whole[:, 0], float(fields["energy_kinetic"].max())


@dataclass(frozen=True)
class Path:
    """A run: states at the frames, shape (nx, frames), and what it took."""

    label: str
    x: Floats
    steps: int
    factorisations: int
    evaluations: int
    seconds: float


class Swing:
    """A filament of the published theory under its full weight, ready to swing."""

    def __init__(self, name: str, cells: int, periods: int, frames: int) -> None:
        self.prepared = swinging(name, 1, 1, "paper", {"cells": cells})
        whole, start = self.prepared.integration, self.prepared.start
        if not isinstance(whole, CompiledIntegration) or start is None:
            raise TypeError("a compiled run that has a start is wanted")
        self._model = copy.copy(whole.filament.model)
        self._model.model = replace(self._model.model, powers=())
        self._places, self._sites = whole.filament.places, whole.filament.sites
        self._rates = GeneratedRates(self.prepared)
        graph, settings = self.prepared.graph, self.prepared.settings
        jacobian = ca.jacobian(graph.ode, graph.x)
        self._jacobian = ca.Function("jacobian", [graph.t, graph.x, graph.p], [jacobian])
        self._absolute = settings.atol / settings.rtol
        self.periods, self.frames, self.middle = periods, frames, graph.x_kinds.index("y")
        self.period = PERIODS[name] / self.prepared.scale
        ramp = {"no-yield, elastic": 0.0436 / self.prepared.scale}.get(name, 0.0)
        self.times = ramp + self.period * np.arange(periods * frames + 1) / frames
        self.start = start.x
        if ramp:
            self.start = self._integrate(start.x, np.array([0.0, ramp]), 1e-10)[0][:, -1]

    def _integrate(self, x: Floats, times: Floats, rtol: float) -> tuple[Floats, Status]:
        status = Status()
        run = RunInput(
            parameters=np.ascontiguousarray(self.prepared.p),
            places=self._places,
            state=self._sites.state(x, np.zeros(0)),
            times=np.ascontiguousarray(times),
            relative=rtol,
            absolute=rtol * self._absolute,
            work_absolute=0.0,
            kinks=np.zeros(0),
            max_steps=_MAX_STEPS,
        )
        states = self._model.integrate(run, status).states
        if status.code:
            raise RuntimeError(self._model.message(status.code))
        return self._sites.vectors(states)[0], status

    def rodas(self, rtol: float) -> Path:
        """The package's own method, compiled."""
        began = time.process_time()
        x, status = self._integrate(self.start, self.times, rtol)
        seconds = time.process_time() - began
        counts = int(status.steps), int(status.factorisations), int(status.evaluations)
        return Path(f"Rodas5P, rtol {rtol:.0e}", x, *counts, seconds)

    def gauss(self, stages: int, per_period: int, tolerance: float) -> Path:
        """Collocation with steps of equal length; `tolerance` is that of the stages, in rest lengths."""
        method = _Gauss(self, stages, self.period / per_period, tolerance)
        x, kept, every = self.start, [self.start], per_period // self.frames
        began = time.process_time()
        for step in range(1, self.periods * per_period + 1):
            x = method.step(x)
            if step % every == 0:
                kept.append(x)
        seconds = time.process_time() - began
        label = f"Gauss of order {2 * stages}, {per_period}"
        counts = self.periods * per_period, method.factorisations, method.evaluations
        return Path(label, np.array(kept).T, *counts, seconds)

    def rates(self, x: Floats) -> Floats:
        """Under the full weight, shape (nx,)."""
        return self._rates.rates(float(self.times[-1]), x)

    def jacobian(self, x: Floats) -> Floats:
        """Of the rates, shape (nx, nx)."""
        return np.asarray(self._jacobian(float(self.times[-1]), x, self.prepared.p))


class _Gauss:
    """Simplified Newton iteration, with a new Jacobian where the old one takes many turns."""

    def __init__(self, swing: Swing, stages: int, length: float, tolerance: float) -> None:
        self._swing, self._stages, self._length, self._tolerance = swing, stages, length, tolerance
        self._a, self._b = _COLLOCATION[stages]
        powers = np.arange(stages)
        nodes = self._a.sum(axis=1)[:, None]
        self._ahead = (1 + nodes) ** powers @ np.linalg.inv(nodes**powers)
        self.factorisations = self.evaluations = 0
        self._k = np.tile(swing.rates(swing.start), (stages, 1))
        self._inverse = self._factorise(swing.start)

    def _factorise(self, x: Floats) -> Floats:
        self.factorisations += 1
        size = self._stages * len(x)
        return np.asarray(np.linalg.inv(np.eye(size) - self._length * np.kron(self._a, self._swing.jacobian(x))))

    def step(self, x: Floats) -> Floats:
        """One step."""
        guess = self._ahead @ self._k
        found, turns = self._solve(x, guess)
        if found is None or turns > _MANY:
            self._inverse = self._factorise(x)
        if found is None:
            found, _ = self._solve(x, guess)
        if found is None:
            raise RuntimeError("the stages do not converge: take shorter steps")
        self._k = found
        return x + self._length * (self._b @ found)

    def _solve(self, x: Floats, guess: Floats) -> tuple[Floats | None, int]:
        k, last = guess, np.inf
        for turn in range(1, _ITERATIONS + 1):
            points = x + self._length * (self._a @ k)
            defect = np.array([self._swing.rates(point) for point in points]) - k
            self.evaluations += self._stages
            change = (self._inverse @ defect.ravel()).reshape(k.shape)
            k, size = k + change, self._length * float(np.max(np.abs(change)))
            if size < self._tolerance:
                return k, turn
            if not size < 10 * last:
                break
            last = size
        return None, _ITERATIONS
