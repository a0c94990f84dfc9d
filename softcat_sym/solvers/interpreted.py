"""Integration in time with CVODES, IDAS or CasADi's Rosenbrock method, in chunks that report progress."""

from __future__ import annotations

import contextlib
import io
import itertools
from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats
from softcat_sym.solvers.compiled import External
from softcat_sym.solvers.initial_state import Start
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import Settings
from softcat_sym.solvers.solution import Progress, Record, Solution, State, watched

_LARGE = 1000
_BESIDE = 8 * float(np.finfo(float).eps)


class FrameIntegrator:
    """Carries a filament over a number of equal output intervals.

    Time is written t = start + interval * tau, so that one integrator serves every chunk of the run.

    Parameters
    ----------
    graph : Graph
        What to integrate; it must have differential states.
    settings : Settings
        Integrator and tolerances.
    intervals : int
        Output intervals in one call.
    external : External
        The compiled right-hand side of the graph, in its place; not for Rosenbrock, which differentiates the powers.
    """

    def __init__(self, graph: Graph, settings: Settings, intervals: int, external: External | None = None) -> None:
        self.intervals = intervals
        kind: Any = ca.SX if external is None else ca.MX
        tau, start, interval = kind.sym("tau"), kind.sym("start"), kind.sym("interval")
        now = start + interval * tau
        # Rosenbrock differentiates the quadratures too, and a sum would fill a row of its Jacobian; BDF does not.
        local = settings.solver == "rosenbrock"
        powers = ca.vertcat(*graph.powers) if local else graph.quad
        sizes = [power.numel() if local else 1 for power in graph.powers]
        self._firsts = [0, sizes[0], sizes[0] + sizes[1]]
        x: Any = graph.x
        z: Any = graph.z
        p: Any = graph.p
        if external is None:
            ode, alg, quad = ca.substitute([graph.ode, graph.alg, powers], [graph.t], [now])
        else:
            x, z, p = external.symbols()
            (ode, alg), quad = external.rhs(now, x, z, p), external.powers(now, x, z, p)
        # Without inertia nothing but flow limits the steps of IDAS, and where nothing flows a quadrature would be left
        # with one point a frame: the powers then count as unknowns, whose error is controlled.
        self._works = 3 if settings.solver == "idas" and "v" not in graph.x_kinds else 0
        works = kind.sym("works", self._works)
        dae: dict[str, Any] = {
            "t": tau,
            "x": ca.vertcat(x, works),
            "p": ca.vertcat(p, start, interval),
            "ode": ca.vertcat(ode, quad if self._works else works) * interval,
            "quad": quad * interval,
        }
        if graph.is_dae:
            dae |= {"z": z, "alg": alg}
        options = settings.options()
        self._max_steps = int(options["max_num_steps"])
        call = ca.integrator("filament", settings.solver, dae, 0, list(range(intervals + 1)), options)
        self._results = {name: np.zeros((intervals + 1, call.size1_out(name))) for name in ("xf", "zf", "qf")}
        self._arguments = {name: np.zeros(call.size1_in(name)) for name in ("x0", "z0", "p")}
        # A buffer hands NumPy's memory to CasADi: no lists of Python floats, which would cost as much as a quick run.
        self._buffer, self._evaluate = call.buffer()
        for name, argument in self._arguments.items():
            self._buffer.set_arg(call.index_in(name), memoryview(argument.data))  # type: ignore[call-arg]
        for name, result in self._results.items():
            self._buffer.set_res(call.index_out(name), memoryview(result.data))  # type: ignore[call-arg]

    def advance(self, state: State, p: Floats, start: float, interval: float) -> tuple[Floats, Floats, Floats, int]:
        """States and quadratures at the end of each interval (as columns), and the steps taken.

        Raises
        ------
        RuntimeError
            If the integrator gives up.
        KeyboardInterrupt
            If the user does.
        """
        self._arguments["x0"][:] = (*state.x, *np.zeros(self._works))
        self._arguments["z0"][:] = state.z
        self._arguments["p"][:] = (*p, start, interval)
        silence = io.StringIO()
        with watched() as interrupts, contextlib.redirect_stdout(silence), contextlib.redirect_stderr(silence):
            try:
                self._evaluate()
            finally:
                interrupts.check()
        stats = self._buffer.stats()
        steps = int(stats.get("nsteps", stats.get("n_steps", 0)))
        if self._buffer.ret() != 0:
            # The Rosenbrock method does not raise: it leaves a code, and results that are not to be used.
            raise RuntimeError(_reason(silence.getvalue(), steps, self._max_steps))
        x, z, local = (self._results[name][1:].T.copy() for name in ("xf", "zf", "qf"))
        quad = x[-self._works :] if self._works else np.add.reduceat(local, self._firsts, axis=0)
        x = x[: len(state.x)]
        return x, z, quad + state.quad[:, None], steps


class Integration:
    """A prepared run: the integrator is built, and can be asked for the solution.

    Parameters
    ----------
    graph, settings
        What to integrate and how.
    frames : int
        Number of output times, t = 0 included.
    kinks : ndarray
        Times, in units of the time scale, at which a support changes pace: no step runs over one.
    external : External
        The compiled right-hand side, if there is one.
    """

    def __init__(
        self, graph: Graph, settings: Settings, frames: int, kinks: Floats, external: External | None = None
    ) -> None:
        self._graph, self._settings, self._frames, self._kinks = graph, settings, frames, kinks
        self._external = external
        self._samples: FrameIntegrator | None = None
        intervals = 1 if len(kinks) else max(1, -(-(frames - 1) // _chunks(graph, settings)))
        self._chunk = FrameIntegrator(graph, settings, intervals, external)

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
            The time scale [s], for messages.
        progress : Progress
            Told after every chunk.
        """
        interval = duration / (self._frames - 1)
        record = Record(start.x, start.z)

        def tell(simulated: float) -> None:
            """After every chunk of that many seconds."""
            done = min(record.reached, self._frames - 1) * interval * scale
            progress.update(done, simulated / record.last_steps if record.last_steps else None)

        return self._through(record, p, interval, scale, tell)

    def piece(
        self,
        start: Start,
        p: Floats,
        times: tuple[float, float, float],
        samples: int,
        scale: float,
        progress: Progress,
    ) -> Solution:
        """Integrate a part; parameters as :meth:`softcat_sym.solvers.run.Prepared.piece`."""
        begin, first, end = times
        record = Record(start.x, start.z)
        inside = self._kinks[(self._kinks > begin) & (self._kinks < first)].tolist()
        state = record.last
        try:
            for low, high in itertools.pairwise((begin, *inside, first)):
                if high > low:
                    x, z, quad, _ = self._single.advance(
                        state, p, low * (1 + _BESIDE), (high - low) * (1 - 2 * _BESIDE)
                    )
                    state = State(x[:, -1], z[:, -1], quad[:, -1])
            record.extend(state.x[:, None], state.z[:, None], state.quad[:, None], 0)
            record.extend(*self._sampling(samples).advance(state, p, first, (end - first) / samples))
        except RuntimeError as error:
            found = record.solution(0.0, samples + 2, Outcome.no_convergence, str(error))
            return replace(found, time=np.full(len(found.time), begin), steps=0)
        progress.update(end * scale, None)
        time = np.concatenate([[begin], np.linspace(first, end, samples + 1)])
        return replace(record.solution(0.0, samples + 2, Outcome.solved, ""), time=time)

    @cached_property
    def _single(self) -> FrameIntegrator:
        return FrameIntegrator(self._graph, self._settings, 1, self._external)

    def _sampling(self, samples: int) -> FrameIntegrator:
        """An integrator of so many samples; there is no second number of them in a run."""
        if self._samples is None or self._samples.intervals != samples:
            self._samples = FrameIntegrator(self._graph, self._settings, samples, self._external)
        return self._samples

    def _through(
        self, record: Record, p: Floats, interval: float, scale: float, tell: Callable[[float], None]
    ) -> Solution:
        """Integrate from where a record stands to the end, or to where it fails."""
        if len(self._kinks):
            return self._by_pieces(record, p, interval, scale, tell)
        while record.reached < self._frames - 1:
            message = self._attempt(self._chunk, record, p, interval)
            if message:
                return self._to_the_bitter_end(record, p, interval, scale, message)
            tell(self._chunk.intervals * interval * scale)
        return record.solution(interval, self._frames, Outcome.solved, "")

    def _attempt(self, integrator: FrameIntegrator, record: Record, p: Floats, interval: float) -> str:
        """Advance by one call; what went wrong, or an empty text."""
        try:
            x, z, quad, steps = integrator.advance(record.last, p, record.reached * interval, interval)
        except RuntimeError as error:
            return str(error) or "the integrator gave up"
        if not all(np.all(np.isfinite(part)) for part in (x, z, quad)):
            return "non-finite state"
        record.extend(x, z, quad, steps)
        return ""

    def _by_pieces(
        self, record: Record, p: Floats, interval: float, scale: float, tell: Callable[[float], None]
    ) -> Solution:
        """Frame by frame, and within a frame from kink to kink."""
        while record.reached < self._frames - 1:
            begin, end = record.reached * interval, (record.reached + 1) * interval
            inside = self._kinks[(self._kinks > begin) & (self._kinks < end)]
            state, steps = record.last, 0
            for low, high in itertools.pairwise((begin, *inside.tolist(), end)):
                try:
                    # A piece begins just behind its kink and ends just before the next.
                    first, last = low * (1 + _BESIDE), high * (1 - _BESIDE)
                    x, z, quad, taken = self._chunk.advance(state, p, first, last - first)
                except RuntimeError as error:
                    return self._broken(record, p, interval, scale, str(error) or "the integrator gave up")
                if not all(np.all(np.isfinite(part)) for part in (x, z, quad)):
                    return self._broken(record, p, interval, scale, "non-finite state")
                state, steps = State(x[:, -1], z[:, -1], quad[:, -1]), steps + taken
            record.extend(state.x[:, None], state.z[:, None], state.quad[:, None], steps)
            tell(interval * scale)
        return record.solution(interval, self._frames, Outcome.solved, "")

    def _to_the_bitter_end(self, record: Record, p: Floats, interval: float, scale: float, message: str) -> Solution:
        """Go on frame by frame to where it fails, so that the part that is sound is kept."""
        single = FrameIntegrator(self._graph, self._settings, 1, self._external)
        while record.reached < self._frames - 1:
            failed = self._attempt(single, record, p, interval)
            if failed:
                message = failed
                break
        else:
            return record.solution(interval, self._frames, Outcome.solved, "")
        return self._broken(record, p, interval, scale, message)

    def _broken(self, record: Record, p: Floats, interval: float, scale: float, message: str) -> Solution:
        """What was reached before it failed, and why it did."""
        worst = worst_component(self._graph, record.reached * interval, record.last.x, record.last.z, p)
        text = f"stopped after t = {record.reached * interval * scale:.6g} s; fastest: {worst}; {_digest(message)}"
        return record.solution(interval, self._frames, _outcome_of(message), text)


def _chunks(graph: Graph, settings: Settings) -> int:
    """In how many calls to integrate: a multistep method starts anew in each, so a short run gets one."""
    if graph.x.numel() > _LARGE:
        return 40
    return 8 if settings.solver == "rosenbrock" else 1


def worst_component(graph: Graph, time: float, x: Floats, z: Floats, p: Floats) -> str:
    """Name of the differential state that changes fastest."""
    rates = np.abs(np.asarray(ca.Function("ode", [graph.t, graph.x, graph.z, graph.p], [graph.ode])(time, x, z, p)))
    return graph.state_names[int(np.argmax(np.where(np.isfinite(rates), rates, np.inf)))]


def _reason(told: str, steps: int, most: int) -> str:
    """Why the Rosenbrock method gave up, which it does not say itself."""
    if steps >= most:
        return "the number of steps reached its limit"
    if "NaN detected" in told or "Inf detected" in told:
        return "non-finite right-hand side"
    return "even the smallest step was rejected"


def _outcome_of(message: str) -> Outcome:
    # Steps first: a run may have recovered from an infinity before it ran out of steps.
    if any(sign in message for sign in ("TOO_MUCH_WORK", "number of steps")):
        return Outcome.step_limit
    if any(sign in message for sign in ("non-finite", "RHSFUNC", "RES_FAIL", "RESFUNC")):
        return Outcome.non_finite
    return Outcome.no_convergence


def _digest(message: str) -> str:
    """The integrator's own words, without its source files."""
    return message.strip().splitlines()[-1].split(": ", 1)[-1][:200]
