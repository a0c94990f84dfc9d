"""The forward model by the compiled solver: derivatives by neighbours that take the same steps."""

from __future__ import annotations

import ctypes as ct
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from softcat_sym.ensemble.running import workers_of
from softcat_sym.graph.grid import Floats
from softcat_sym.inverse.forward.path import Begin, Path
from softcat_sym.solve import Settings, c_model
from softcat_sym.solve.c_model import Directions, Run, Status
from softcat_sym.solve.compiled import CompiledFilament

_LOOK = 0.1  # s between two looks whether somebody wants it to stop
_SIZE = 1e-5  # in unknowns of order one: what bends in them errs by 1e-10, and rounding by 1e-11 of a step's condition
_TIGHTENINGS = (1.0, 0.1, 0.01)
_APART, _LEAST_APART = 0.5, 1e-4
"""Steps of differences between runs of their own: this times the root of the relative tolerance, and at least that."""

Result = TypeVar("Result")


@dataclass(frozen=True)
class CompiledForward:
    """The C runtime with some unknowns picked out.

    Attributes
    ----------
    filament : CompiledFilament
        What is integrated.
    settings : Settings
        Tolerances.
    kinks : ndarray
        Times, in units of the time scale, at which a support changes pace.
    controls_work : bool
        Whether the error of the work limits the steps, as it must where little else does.
    jumps : bool
        Whether the discrete solution jumps where its parameters move, by about its tolerance: fibres that begin to
        yield change the Jacobian at once, from which a linearly implicit step is made.
    """

    filament: CompiledFilament
    settings: Settings
    kinks: Floats
    controls_work: bool
    jumps: bool = False

    def run(self, begin: Begin, seen: tuple[int, ...], most_steps: int) -> Path:
        """Integrate; parameters as :class:`softcat_sym.inverse.forward.path.Integrator`."""
        run, status = self._run(begin, most_steps), Status()
        (answer,) = _watched(lambda stop: self.filament.model.integrate(run, status, stop))
        return self._path(answer.states, None, seen, status)

    def run_with_slopes(self, begin: Begin, seen: tuple[int, ...], most_steps: int) -> Path:
        """Integrate with two-sided differences in lock-step; their error is about 1e-9.

        Neighbours have no step control of their own, and may be lost where the run itself is not: then the steps are
        chosen more tightly. Where the discrete solution jumps, a short difference sees the jumps and not the slope:
        there neighbours lie further apart, each with step control of its own, and err by about the root of the
        tolerance times that of the solution.
        """
        if self.jumps:
            return self._apart(begin, seen, most_steps)
        for tightening in _TIGHTENINGS:
            run = self._run(begin, most_steps, tightening)
            path, code = self._with_slopes(run, begin, seen)
            if code not in (c_model.NON_FINITE, c_model.SINGULAR) or self.run(begin, (), most_steps).complaint:
                break
        return path

    def _apart(self, begin: Begin, seen: tuple[int, ...], most_steps: int) -> Path:
        """Integrate, and two neighbours for every unknown."""
        path = self.run(begin, seen, most_steps)
        slopes = np.full((len(begin.d_parameters), *path.values.shape), np.nan)
        size = max(_APART * self.settings.rtol**0.5, _LEAST_APART)
        for row in range(len(slopes)):
            low, high = (self.run(begin.moved(row, step), seen, most_steps) for step in (-size, size))
            slopes[row] = (high.values - low.values) / (2 * size)
        return replace(path, slopes=slopes)

    def _with_slopes(self, run: Run, begin: Begin, seen: tuple[int, ...]) -> tuple[Path, int]:
        """One integration for each core, with its share of the neighbours beside it: all take the same steps."""
        count, sites = len(begin.d_parameters), self.filament.sites
        moved = np.zeros((count, sites.shape[0] * sites.shape[1]))
        moved[:, sites.x], moved[:, sites.z] = begin.d_x, begin.d_z
        shares = np.array_split(np.arange(count), max(1, min(workers_of(None), count)))
        statuses = [Status() for _ in shares]

        def part(number: int) -> Callable[[ct.c_int], tuple[Floats, Floats]]:
            own, status = shares[number], statuses[number]
            directions = Directions(
                begin.d_parameters[own], moved[own].reshape(len(own), *sites.shape), np.full(len(own), _SIZE)
            )
            return lambda stop: self.filament.model.sensitivities(run, directions, status, stop)

        answers = _watched(*(part(number) for number in range(len(shares))))
        # A share whose neighbours were lost speaks for all.
        worst = next((status for status in statuses if status.code != c_model.SOLVED), statuses[0])
        slopes = np.concatenate([slopes for _, slopes in answers])
        states = answers[statuses.index(worst)][0]
        return self._path(states, slopes, seen, worst), int(worst.code)

    def _run(self, begin: Begin, most_steps: int, tightening: float = 1.0) -> Run:
        return Run(
            parameters=np.ascontiguousarray(begin.parameters),
            places=self.filament.places,
            state=self.filament.sites.state(begin.start.x, begin.start.z),
            times=np.concatenate([[0.0], begin.times]),
            relative=self.settings.rtol * tightening,
            absolute=self.settings.atol * tightening,
            work_absolute=self.settings.atol if self.controls_work else 0.0,
            kinks=self.kinks,
            most_steps=round(most_steps / tightening**0.5),
        )

    def _path(self, states: Floats, slopes: Floats | None, seen: tuple[int, ...], status: Status) -> Path:
        model, sites = self.filament.model, self.filament.sites
        c_model.refuse(status.code, model.message(status.code))
        where = np.concatenate([sites.x, sites.z])[list(seen)]
        values = states.reshape(len(states), -1)[1:, where]
        if slopes is not None:
            slopes = slopes.reshape(*slopes.shape[:2], sites.shape[0] * sites.shape[1])[:, 1:, where]
        complaint = "" if status.code == c_model.SOLVED else model.message(status.code)
        return Path(values, slopes, int(status.steps), complaint)


def _watched(*works: Callable[[ct.c_int], Result]) -> list[Result]:
    """Work in threads, side by side, so that Ctrl-C is heard meanwhile, and stops it.

    Raises
    ------
    KeyboardInterrupt
        If the user stops it.
    """
    stop = ct.c_int(0)
    with ThreadPoolExecutor(len(works)) as pool:
        answers = [pool.submit(work, stop) for work in works]
        try:
            while wait(answers, _LOOK).not_done:
                pass
        finally:
            stop.value = 1
    return [answer.result() for answer in answers]
