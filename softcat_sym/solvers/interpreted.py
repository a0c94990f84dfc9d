"""Integration in time with CVODES, IDAS or CasADi's Rosenbrock method, in chunks that report progress."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cached_property, partial
from typing import Any

import casadi as ca
import numpy as np
from scipy.interpolate import CubicHermiteSpline

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.interrupts import check_time
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import Settings
from softcat_sym.solvers.solution import Bounds, Extremes, Progress, Solution, Start, is_torn, watched

_LARGE = 1000
_LATEST, _LOOKS = 1e12, 900  # Times at which a fall that may not end is looked at, each by 3 % later than the last
_BESIDE = 8 * float(np.finfo(float).eps)

_OUTCOMES = {
    Outcome.step_limit: ("CV_TOO_MUCH_WORK", "IDA_TOO_MUCH_WORK"),
    Outcome.non_finite: (
        *("CV_RHSFUNC_FAIL", "CV_FIRST_RHSFUNC_ERR", "CV_REPTD_RHSFUNC_ERR", "CV_UNREC_RHSFUNC_ERR"),
        *("IDA_RES_FAIL", "IDA_REP_RES_ERR", "IDA_FIRST_RES_FAIL"),
    ),
}
"""Return flags of SUNDIALS; every other failure is one of convergence."""

_FLAG = re.compile(r'(\w+ returned "(\w+)")')
"""CasADi reports the flag in its exception only."""


class FrameIntegrator:
    """Integrates a filament over a number of equal output intervals.

    Time is t = start + interval * tau, so that one integrator serves every chunk of the run.

    Parameters
    ----------
    graph : Graph
        The filament; it must have differential states.
    settings : Settings
        Integrator and tolerances.
    intervals : int
        Output intervals in one call.
    """

    def __init__(self, graph: Graph, settings: Settings, intervals: int) -> None:
        self.intervals = intervals
        tau, start, interval = ca.SX.sym("tau"), ca.SX.sym("start"), ca.SX.sym("interval")
        now = start + interval * tau
        # Rosenbrock differentiates the quadratures too: sums of powers would fill rows of the Jacobian. BDF does not.
        local = settings.solver == "rosenbrock"
        powers = ca.vertcat(*graph.symbolic.powers) if local else graph.symbolic.quad
        sizes = [power.numel() if local else 1 for power in graph.symbolic.powers]
        self._firsts = np.cumsum([0, *sizes[:-1]])
        x, z, p = graph.symbolic.x, graph.symbolic.z, graph.symbolic.p
        ode, alg, quad = ca.substitute([graph.symbolic.ode, graph.symbolic.alg, powers], [graph.symbolic.t], [now])
        # Without inertia only flow limits the steps of IDAS; without flow a quadrature would have one point in a frame.
        # The powers then are unknowns, whose error is controlled.
        self._works = len(sizes) if settings.solver == "idas" and "v" not in graph.differential.kinds else 0
        works = ca.SX.sym("works", self._works)
        dae: dict[str, Any] = {
            "t": tau,
            "x": ca.vertcat(x, works),
            "p": ca.vertcat(p, start, interval),
            "ode": ca.vertcat(ode, quad if self._works else works) * interval,
            "quad": quad * interval,
        }
        if graph.is_dae:
            dae |= {"z": z, "alg": alg}
        self._dae, self._options, self._solver = dae, settings.options(), settings.solver
        self._build()

    def _build(self) -> None:
        call = ca.integrator("filament", self._solver, self._dae, 0, list(range(self.intervals + 1)), self._options)
        self._results = {name: np.zeros((self.intervals + 1, call.size1_out(name))) for name in ("xf", "zf", "qf")}
        self._arguments = {name: np.zeros(call.size1_in(name)) for name in ("x0", "z0", "p")}
        # The buffer shares NumPy's memory with CasADi; lists of Python floats would take as long as a short run.
        self._buffer, self._evaluate = call.buffer()
        for name, argument in self._arguments.items():
            self._buffer.set_arg(call.index_in(name), memoryview(argument.data))  # type: ignore[call-arg]
        for name, result in self._results.items():
            self._buffer.set_res(call.index_out(name), memoryview(result.data))  # type: ignore[call-arg]

    def advance(self, before: Solution, p: Floats, start: float, interval: float) -> Solution:
        """Frames at the end of each interval after the last one of `before`; without meaning after a failure."""
        given = (*before.x[:, -1], *np.zeros(self._works)), before.z[:, -1], (*p, start, interval)
        outcome, message, steps = self._integrate(*given)
        if steps == 0 and outcome is Outcome.no_convergence and self._solver == "idas" and self._starts_shortly(*given):
            outcome, message, steps = self._integrate(*given)
        x, z, local = (self._results[name][1:].T.copy() for name in ("xf", "zf", "qf"))
        quad = x[-self._works :] if self._works else np.add.reduceat(local, self._firsts, axis=0)
        x = x[: len(before.x)]
        # The Rosenbrock method does not raise an exception, but returns a code.
        if outcome is Outcome.solved and self._buffer.ret() != 0:
            outcome, message = Outcome.no_convergence, "even the smallest step was rejected"
            if steps >= self._options["max_num_steps"]:
                outcome, message = Outcome.step_limit, "the number of steps reached its limit"
        elif outcome is Outcome.solved and not all(np.all(np.isfinite(part)) for part in (x, z, quad)):
            outcome, message = Outcome.non_finite, "non-finite state"
        time = np.asarray(start + interval * np.arange(1, self.intervals + 1), dtype=float)
        return Solution(time, x, z, quad + before.quad[:, -1:], outcome, message, steps)

    def _integrate(self, x: Sequence[float], z: Floats, p: Sequence[float]) -> tuple[Outcome, str, int]:
        for name, values in (("x0", x), ("z0", z), ("p", p)):
            self._arguments[name][:] = values
        outcome, message = Outcome.solved, ""
        with watched():
            try:
                self._evaluate()
            except RuntimeError as error:
                outcome, message = _failure(error)
        stats = self._buffer.stats()
        return outcome, message, int(stats.get("nsteps", stats.get("n_steps", 0)))

    def _starts_shortly(self, x: Sequence[float], z: Floats, p: Sequence[float]) -> bool:
        """Shorten the first step of IDAS to the fastest rate of change, where it was not short already.

        It takes a thousandth of an interval, over which modes that relax by many decades faster leave Newton's method
        with rounding only.
        """
        if "step0" in self._options:
            return False
        symbols = [self._dae.get(name, ca.SX(0, 1)) for name in ("t", "x", "z", "p")]
        rates = ca.Function("rates", symbols, [self._dae["ode"]])(0, x, z, p)
        first = 0.01 * self._options["abstol"] / max(float(ca.norm_inf(rates)), 1.0)
        self._options |= {"step0": first, "first_time": first, "linear_solver": "csparse"}
        self._build()
        return True


def _failure(error: RuntimeError) -> tuple[Outcome, str]:
    """Outcome for the flag that SUNDIALS returned, and the flag."""
    found = _FLAG.search(str(error))
    if found is None:
        return Outcome.no_convergence, str(error).strip().splitlines()[-1][:200]
    return next((one for one, flags in _OUTCOMES.items() if found[2] in flags), Outcome.no_convergence), found[1]


class Integration:
    """A prepared run with its integrator.

    Parameters
    ----------
    graph, settings
        The filament, integrator and tolerances.
    frames : int
        Number of output times, t = 0 included.
    kinks : ndarray
        Times, in units of the time scale, at which a support changes its rate, and at which steps must end.
    bounds : Bounds
        Where the filament falls for ever, if it may.
    """

    def __init__(
        self,
        graph: Graph,
        settings: Settings,
        frames: int,
        kinks: Floats,
        bounds: Bounds | None = None,
    ) -> None:
        self._graph, self._settings, self._frames, self._kinks = graph, settings, frames, kinks
        self._bounds = bounds
        if bounds is not None and bounds.never and np.any(np.isfinite(bounds.stretch)):
            # What falls for ever is looked at between frames, too.
            self._kinks = np.union1d(kinks, np.geomspace(1.0, _LATEST, _LOOKS))
        # A multistep method restarts in each chunk, so that a short run has one chunk.
        chunks = 40 if len(graph.start) > _LARGE else 8 if settings.solver == "rosenbrock" else 1
        self._chunk = self._integrator(1 if len(self._kinks) else max(1, -(-(frames - 1) // chunks)))
        self._samples: FrameIntegrator | None = None

    def _integrator(self, intervals: int) -> FrameIntegrator:
        return FrameIntegrator(self._graph, self._settings, intervals)

    @cached_property
    def _single(self) -> FrameIntegrator:
        return self._chunk if self._chunk.intervals == 1 else self._integrator(1)

    def run(self, start: Start, p: Floats, duration: float, scale: float, progress: Progress) -> Solution:
        """Integrate from a filament at rest.

        Parameters
        ----------
        start : Start
            Differential and consistent algebraic states.
        p : ndarray
            Parameters.
        duration : float
            In units of the time scale.
        scale : float
            The time scale [s].
        progress : Progress
            Called after every chunk.
        """
        parts = [Solution.at(start.x, start.z, len(self._graph.powers))]
        try:
            return self._run(parts, p, duration / (self._frames - 1), scale, progress)
        except KeyboardInterrupt:
            raise self._whole(parts, duration / (self._frames - 1)).interrupted(scale) from None

    def _run(self, parts: list[Solution], p: Floats, interval: float, scale: float, progress: Progress) -> Solution:
        """Integrate, and put every part that was computed beside the others."""
        last, reached, integrator = self._frames - 1, 0, self._chunk
        while reached < last:
            check_time()
            if len(self._kinks):
                # A piece starts just after a kink and ends just before the next.
                cuts = self._cuts(reached * interval, (reached + 1) * interval)
                pieces = [(low * (1 + _BESIDE), high * (1 - _BESIDE)) for low, high in cuts]
                part = self._through(parts[-1], p, [(low, high - low) for low, high in pieces])
            else:
                part = integrator.advance(parts[-1], p, reached * interval, interval)
            if part.outcome is Outcome.solved:
                parts.append(part)
                reached += len(part.time)
                spent = len(part.time) * interval * scale
                progress.update(min(reached, last) * interval * scale, spent / part.steps if part.steps else None)
                if (ended := self._ended(part, p)) is not None:
                    falls = self._bounds is None or self._bounds.never
                    return self._whole(parts, interval).left(ended, scale, falls=falls)
                if is_torn(self._graph.terms, self._stretch(part.time[-1:], part.x[:, -1:], part.z[:, -1:], p)):
                    break
            elif integrator.intervals > 1:
                integrator = self._single  # Frame by frame up to the failure, to keep the valid frames
            else:
                outcome, message = self._broken(parts[-1], part, reached * interval, p, scale)
                return replace(self._whole(parts, interval), outcome=outcome, message=message)
        return self._whole(parts, interval).to_rupture(self._graph.terms, partial(self._stretch, p=p), scale)

    def _extremes(self, found: Solution) -> Extremes:
        """Turning points by heights and speeds at the output times, between which a cubic runs."""
        height = found.row(self._graph.midpoint_row("y"))
        if not self._graph.has_velocities or len(found.time) < 2:
            return Extremes.of(found.time, height)
        path = CubicHermiteSpline(found.time, height, found.row(self._graph.midpoint_row("v")))
        turns = path.derivative().roots(extrapolate=False)
        time = np.unique([found.time[0], *turns[np.isfinite(turns)], found.time[-1]])
        return Extremes(time, path(time), path.antiderivative()(time))

    def _stretch(self, time: Floats, x: Floats, z: Floats, p: Floats) -> Floats:
        return self._graph.observe(time, x, z, p)["stretch"]

    def _ended(self, part: Solution, p: Floats) -> float | None:
        """The time of the first of these frames in which the filament falls for ever; None without one."""
        bounds, kinds = self._bounds, [*self._graph.differential.kinds, *self._graph.algebraic.kinds]
        if bounds is None:
            return None
        places = np.abs(np.concatenate([part.x, part.z])[[kind in ("x", "y", "z") for kind in kinds]])
        stretch = self._stretch(part.time, part.x, part.z, p)
        beyond = (np.max(places, axis=0) > bounds.distance) | np.any(stretch > bounds.stretch, axis=1)
        return float(part.time[np.argmax(beyond)]) if np.any(beyond) else None

    def _whole(self, parts: list[Solution], interval: float) -> Solution:
        """All parts joined, without frames of the last chunk beyond the end."""
        found, frames = Solution.joined(parts), self._frames
        x, z, quad = (part[:, :frames] for part in (found.x, found.z, found.quad))
        found = replace(found, time=np.arange(x.shape[1], dtype=float) * interval, x=x, z=z, quad=quad)
        return replace(found, extremes=self._extremes(found))

    def piece(self, start: Start, p: Floats, times: Floats, scale: float, progress: Progress) -> Solution:
        """Integrate a part; parameters as :meth:`softcat_sym.solvers.solve.Prepared.piece`."""
        begin, end, samples = float(times[0]), float(times[-1]), len(times) - 1
        parts = [Solution.at(start.x, start.z, len(self._graph.powers))]
        if samples == 1:
            spans = [(low * (1 + _BESIDE), (high - low) * (1 - 2 * _BESIDE)) for low, high in self._cuts(begin, end)]
            parts.append(self._through(parts[0], p, spans))
        else:
            # All pieces of a run have the same number of samples.
            if self._samples is None or self._samples.intervals != samples:
                self._samples = self._integrator(samples)
            parts.append(self._samples.advance(parts[0], p, begin, (end - begin) / samples))
        if (failed := parts[-1]).outcome is not Outcome.solved:
            return replace(parts[0], time=times[:1], outcome=failed.outcome, message=failed.message)
        progress.update(end * scale, None)
        found = replace(Solution.joined(parts), time=times)
        return replace(found, extremes=self._extremes(found))

    def _cuts(self, begin: float, end: float) -> list[tuple[float, float]]:
        """The time from begin to end, divided at its kinks."""
        inside = self._kinks[(self._kinks > begin) & (self._kinks < end)].tolist()
        return [(low, high) for low, high in itertools.pairwise((begin, *inside, end)) if high > low]

    def _through(self, before: Solution, p: Floats, spans: Iterable[tuple[float, float]]) -> Solution:
        """One frame at the end of these spans (start and length), with one call for each span."""
        x, z, quad = (part[:, -1:] for part in (before.x, before.z, before.quad))
        here, steps = replace(before, time=before.time[-1:], x=x, z=z, quad=quad), 0
        for start, length in spans:
            here = self._single.advance(here, p, start, length)
            steps += here.steps
            if here.outcome is not Outcome.solved or self._ended(here, p) is not None:
                break
        return replace(here, steps=steps)

    def _broken(self, last: Solution, failed: Solution, time: float, p: Floats, scale: float) -> tuple[Outcome, str]:
        """Outcome and message of a failed run, with the fastest unknown at its last valid frame."""
        graph, outcome = self._graph, failed.outcome
        ode = ca.Function("ode", graph.symbolic.inputs, [graph.symbolic.ode])
        rates = np.abs(np.asarray(ode(time, last.x[:, -1], last.z[:, -1], p)))
        worst = graph.differential.names[int(np.argmax(np.where(np.isfinite(rates), rates, np.inf)))]
        if outcome is Outcome.no_convergence and not np.all(np.isfinite(rates)):
            outcome = Outcome.non_finite
        return outcome, f"stopped after t = {time * scale:.6g} s; fastest: {worst}; {failed.message}"
