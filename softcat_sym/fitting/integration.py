"""Integration of one filament for any values of its free parameters, with derivatives, interpreted or compiled."""

from __future__ import annotations

import ctypes as ct
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache, cached_property, lru_cache, partial
from typing import Any, TypeVar

import casadi as ca
import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from softcat_sym.batch.executor import worker_count
from softcat_sym.discretization.assembly import choose_body, choose_grid
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.parameters import TIME_SCALE, parameter_values, time_scale
from softcat_sym.discretization.unknowns import Floats, Layout
from softcat_sym.effects.selection import Effects, choose_effects
from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.free_parameters import FreeParameter, with_values
from softcat_sym.interrupts import check_time
from softcat_sym.scene.scene import Scene, is_slack, rest_length
from softcat_sym.solvers import compiled
from softcat_sym.solvers.compiled import (
    CompiledFilament,
    CompiledNewton,
    Directions,
    RunInput,
    Status,
    compile_filament,
)
from softcat_sym.solvers.equilibrium import Equilibrium
from softcat_sym.solvers.initial_state import is_straight, starting_state
from softcat_sym.solvers.settings import Backend, Settings, choose_backend, compiled_settings
from softcat_sym.solvers.solution import Newton, Start, watched
from softcat_sym.solvers.solve import Assembled, assembled

_Unknown = tuple[str, int]
Result = TypeVar("Result")


class Starts:
    """Starting states of a filament whose parameters change, found from the first one, of its typical values."""

    def __init__(self, assembled: Assembled, newton: Newton | None = None, *, follow: bool = True) -> None:
        self._graph, self._newton = assembled.graph, newton
        # In three dimensions the continuation from the natural shape takes only milliseconds in C.
        spatial = assembled.structure.recorded.theory.is_spatial
        self._follow = follow and not spatial
        self._straight, self._slack = is_straight(assembled.scene), is_slack(assembled.scene)
        # Without algebraic unknowns no balance is solved: the straight filament is the starting state.
        self._bare = replace(self._graph, algebraic=Layout([]))
        self._settles = self._graph.is_dae and not spatial
        # The shape at rest may belong to another graph, without inertia and viscous stress.
        is_followed = not self._straight and not self._graph.positions_are_algebraic
        self._at_rest = cache(assembled.at_rest)
        self._followed = (
            _Followed(self._graph, self._at_rest(), self._balanced) if is_followed and not spatial else None
        )
        self._equilibrium = cache(Equilibrium)
        self._first: Start | None = None

    def at(self, scene: Scene, p: Floats, near: Start | None = None, *, settle: bool = True) -> Start | None:
        """Starting state; None if no equilibrium is found, or if the filament is slack or straight unlike the first."""
        if is_slack(scene) != self._slack or is_straight(scene) != self._straight:
            return None
        near = near or self._first
        found = self._near(scene, p, near, settle) if near is not None and self._follow else None
        if found is None:
            found = starting_state(scene, self._graph, p, self._at_rest, self._newton)
        self._first = self._first or found
        return found

    def _near(self, scene: Scene, p: Floats, near: Start, settle: bool) -> Start | None:
        if self._followed is not None:
            rested = self._followed.at(near, p, slack=self._slack)
            if rested is None:
                return None
            x, guess = rested.x, rested.z
        elif self._straight and not self._graph.positions_are_algebraic:
            plain = starting_state(scene, self._bare, p, None)
            if plain is None:
                return None
            x, guess = plain.x, near.z if near.z.size else plain.z
        else:
            x, guess = near.x, near.z
        if not self._settles or not settle:
            return Start(x, guess)
        z = self._balanced(self._graph, x, p, guess)
        return None if z is None else Start(x, z)

    def _balanced(self, graph: Graph, x: Floats, p: Floats, guess: Floats) -> Floats | None:
        """Algebraic unknowns in balance, solved in C, or by CasADi where there is no C code or it fails."""
        found = None if self._newton is None else self._newton(graph, x, p, guess)
        return self._equilibrium(graph).search(0.0, x, p, [guess]) if found is None else found


class _Followed:
    """Shapes at rest, followed from one to the next, as unknowns of the moving filament."""

    def __init__(self, graph: Graph, rest: Graph, balanced: Newton) -> None:
        self._graph, self.rest, self._balanced = graph, rest, balanced
        x, z = _numbered(graph.differential), _numbered(graph.algebraic)
        rest_x, rest_z = _numbered(rest.differential), _numbered(rest.algebraic)
        self._plastic = _pairs(rest_x, x)
        self._moving, self._still = _pairs(rest_z, x), _pairs(rest_z, z)
        self._complete = len(self._moving[0]) + len(self._still[0]) == len(rest_z)

    def at(self, near: Start, p: Floats, *, slack: bool) -> Start | None:
        """The shape at rest with these parameters, followed from a neighbouring one; algebraic unknowns as there."""
        if not self._complete:
            return None
        x, z = self.rest.start.copy(), np.zeros(len(self.rest.algebraic))
        x[self._plastic[0]] = near.x[self._plastic[1]]
        z[self._moving[0]], z[self._still[0]] = near.x[self._moving[1]], near.z[self._still[1]]
        values = dict(zip(self._graph.parameters, p.tolist(), strict=True))
        if not slack:
            # A taut filament starts without its weight.
            values["gravity"] = 0.0
        constants = np.array([values[name] for name in self.rest.parameters])
        shape = self._balanced(self.rest, x, constants, z)
        if shape is None:
            return None
        result = Start(near.x.copy(), near.z.copy())
        result.x[self._moving[1]], result.z[self._still[1]] = shape[self._moving[0]], shape[self._still[0]]
        return result


def _numbered(layout: Layout) -> dict[_Unknown, int]:
    return {unknown: number for number, unknown in enumerate(layout.unknowns)}


def _pairs(
    ours: dict[_Unknown, int], theirs: dict[_Unknown, int]
) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    both = [(number, theirs[unknown]) for unknown, number in ours.items() if unknown in theirs]
    return np.array([a for a, _ in both], dtype=np.int64), np.array([b for _, b in both], dtype=np.int64)


@dataclass(frozen=True)
class Point:
    """A filament with given values of its free parameters, ready to run, with derivatives by the k of them."""

    q: Floats  # shape (k,); The unknowns of the scene
    start: Start  # Differential and algebraic states
    parameters: Floats  # shape (p,); In the order of the graph
    length: float  # Rest length [m]
    d_parameters: Floats  # shape (k, p); k = 0 if derivatives were not requested
    d_x: Floats
    d_z: Floats
    d_length: Floats

    def moved(self, unknown: int, step: float) -> Point:
        """The filament with one unknown changed, to first order."""
        return replace(
            self,
            q=self.q + step * np.eye(self.q.size)[unknown],
            start=Start(self.start.x + step * self.d_x[unknown], self.start.z + step * self.d_z[unknown]),
            parameters=self.parameters + step * self.d_parameters[unknown],
            length=self.length + step * float(self.d_length[unknown]),
        )


@dataclass(frozen=True)
class Path:
    """Some unknowns at the requested times; NaN at times that the integration did not reach."""

    values: Floats  # shape (n, seen); The unknowns that were requested
    slopes: Floats | None  # shape (k, n, seen); Their derivatives
    steps: int  # Number of time steps
    message: str = ""  # Why the integration failed; empty if it did not


_AT_START = 1e-12  # of the longest time
_BESIDE = 1e-6  # of the longest time, to either side, where no unknown is the velocity


@dataclass(frozen=True)
class Timing:
    """Correspondence between the times of the data and those of the integrator."""

    model: Floats  # shape (m,); Increasing and positive, in units of the time scale
    after: NDArray[np.bool_]  # shape (n,); Which data were taken after the filament began to move
    row: NDArray[np.int64]  # shape (sum(after),); Number of their time in `model`
    # shape (sum(after),); Numbers of neighbouring times, for the velocity; the same as `row` where it is an unknown.
    sooner: NDArray[np.int64]
    later: NDArray[np.int64]


def timing_of(times: Floats, *, beside: bool) -> Timing:
    """Sort the times of the data."""
    longest = float(np.max(np.abs(times), initial=0.0))
    after = times > _AT_START * longest
    asked = times[after]
    if not beside:
        model, row = np.unique(asked, return_inverse=True)
        return Timing(model, after, row, row, row)
    step = np.minimum(_BESIDE * longest, asked / 2)
    model, number = np.unique(np.concatenate([asked, asked - step, asked + step]), return_inverse=True)
    row, sooner, later = number.reshape(3, -1)
    return Timing(model, after, row, sooner, later)


_FAILED = "the integrator failed: it reached the maximum number of steps, or the state became infinite"
_LOOK = 0.1  # s between two checks for an interrupt
_SIZE = 1e-5  # In unknowns of order one: truncation errs by 1e-10, and rounding by 1e-11 of a step's condition
_APART, _MIN_APART = 0.5, 1e-4
"""One-sided difference steps between separate runs: this times the root of the tolerance, and at least that."""
_JUMP, _FURTHEST = 1.0, 0.3
"""Least change by such a step, rms over the largest value and the relative tolerance, and the largest step for it."""
_RINGING, _APART_RINGING = 1e-6, 2e-3
"""Absolute tolerance, over the rest length, below which a run follows a ringing; and the difference steps then."""


class Integrator(ABC):
    """Integration of a filament, and its derivatives by differences between separate runs."""

    settings: Settings  # Tolerances

    @abstractmethod
    def runs(self, points: Sequence[Point], times: Floats, seen: tuple[int, ...], max_steps: int) -> list[Path]:
        """Integrate several filaments through the times; differential unknowns are numbered first, then algebraic."""

    def run(self, point: Point, times: Floats, seen: tuple[int, ...], max_steps: int) -> Path:
        """Integrate one filament."""
        return self.runs([point], times, seen, max_steps)[0]

    def run_with_slopes(self, point: Point, times: Floats, seen: tuple[int, ...], max_steps: int) -> Path:
        """Integrate with derivatives by two-sided differences between separate runs.

        Their solutions jump by about the tolerance from one to the next, which its cube root makes least of.
        """
        return self._differences(point, times, seen, max_steps, (-1.0, 1.0), self.settings.rtol ** (1 / 3))

    def _differences(
        self,
        point: Point,
        times: Floats,
        seen: tuple[int, ...],
        max_steps: int,
        sides: tuple[float, ...],
        size: float,
    ) -> Path:
        """The base run, with differences to one or two neighbours of every unknown."""
        count = len(point.d_parameters)
        points = [point, *(point.moved(row, side * size) for row in range(count) for side in sides)]
        base, *others = self.runs(points, times, seen, max_steps)
        ends = np.array([path.values for path in others]).reshape(count, len(sides), *base.values.shape)
        low = ends[:, 0] if len(sides) > 1 else base.values
        return replace(base, slopes=(ends[:, -1] - low) / (len(sides) * size))


class InterpretedForward(Integrator):
    """CasADi's `rosenbrock` on the graph, from t = 0 to the first time and from there through the others."""

    def __init__(self, graph: Graph, settings: Settings) -> None:
        self._graph, self.settings = graph, settings
        # One function for each pattern of times, which rarely changes.
        self._function = lru_cache(maxsize=8)(self._make)

    def runs(self, points: Sequence[Point], times: Floats, seen: tuple[int, ...], max_steps: int) -> list[Path]:
        """Integrate one filament after another."""
        # Later times are distances from the first, so that a shift of the clock needs no new integrator.
        later, found = tuple(round(float(time), 12) for time in times[1:] - times[0]), list[Path]()
        for point in points:
            inputs = point.start.x, point.start.z, point.parameters, float(times[0])
            values, message = np.full((times.size, len(seen)), np.nan), _FAILED
            with watched(), suppress(RuntimeError):
                values = np.asarray(self._function(later, seen, max_steps)(*inputs), dtype=float).T
                message = "" if np.isfinite(values).all() else _FAILED
            found.append(Path(values if not message else np.full_like(values, np.nan), None, 0, message))
        return found

    def _make(self, later: tuple[float, ...], seen: tuple[int, ...], max_steps: int) -> ca.Function:
        graph = self._graph
        x, z, p = (
            ca.MX.sym(name, part.numel())
            for name, part in (("x", graph.symbolic.x), ("z", graph.symbolic.z), ("p", graph.symbolic.p))
        )
        first = ca.MX.sym("first")
        states, algebraic = self._step(x, z, p, ca.MX(0), first, (1.0,), max_steps)
        if later:
            more = self._step(states, algebraic, p, first, ca.MX(1), later, max_steps)
            states, algebraic = ca.horzcat(states, more[0]), ca.horzcat(algebraic, more[1])
        rows = ca.vertcat(states, algebraic) if graph.is_dae else states
        return ca.Function("path", [x, z, p, first], [rows[list(seen), :]])

    def _step(
        self, x: ca.MX, z: ca.MX, p: ca.MX, start: ca.MX, unit: ca.MX, taus: tuple[float, ...], max_steps: int
    ) -> tuple[ca.MX, ca.MX]:
        """States at start + unit * taus."""
        graph = self._graph
        tau, begins, interval = ca.SX.sym("tau"), ca.SX.sym("begins"), ca.SX.sym("interval")
        ode, alg = ca.substitute(
            [graph.symbolic.ode, graph.symbolic.alg], [graph.symbolic.t], [begins + interval * tau]
        )
        dae: dict[str, Any] = {"t": tau, "x": graph.symbolic.x, "p": ca.vertcat(graph.symbolic.p, begins, interval)}
        dae |= {"ode": ode * interval}
        if graph.is_dae:
            dae |= {"z": graph.symbolic.z, "alg": alg}
        options: dict[str, Any] = {"reltol": self.settings.rtol, "abstol": self.settings.atol}
        # A failure shows in the result, and is common in a fit: no warnings.
        options |= {"max_num_steps": max_steps, "show_eval_warnings": False}
        call = ca.integrator("filament", "rosenbrock", dae, 0.0, list(taus), options)
        algebraic = {"z0": z} if graph.is_dae else {}
        found = call(x0=x, p=ca.vertcat(p, start, unit), **algebraic)
        return found["xf"], found["zf"]


@dataclass(frozen=True)
class CompiledForward(Integrator):
    """Integration by the C runtime."""

    filament: CompiledFilament  # The compiled filament
    settings: Settings  # Tolerances
    kinks: Floats  # Times, in units of the time scale, at which a support changes its rate
    controls_work: bool  # Whether the error of the work limits the steps, as it must where little else does
    # Whether the discrete solution is a discontinuous function of its parameters, with jumps of about the tolerance:
    # fibres that begin to yield change the Jacobian of a linearly implicit step discontinuously.
    jumps: bool = False

    def runs(self, points: Sequence[Point], times: Floats, seen: tuple[int, ...], max_steps: int) -> list[Path]:
        """Integrate several filaments, as many at a time as there are cores."""
        statuses = [Status() for _ in points]
        work = [
            partial(self.filament.model.integrate, self._run(point, times, max_steps), status)
            for point, status in zip(points, statuses, strict=True)
        ]
        pairs = zip(_watched(*work), statuses, strict=True)
        return [self._path(answer.states, None, seen, status) for answer, status in pairs]

    def run_with_slopes(self, point: Point, times: Floats, seen: tuple[int, ...], max_steps: int) -> Path:
        """Integrate with two-sided differences in lock-step; their error is about 1e-9.

        The neighbouring runs share the steps of the base run; where one of them fails, runs are separate. So they are
        where the discrete solution jumps, as a short difference would measure the jumps instead of the slope: each
        neighbour lies further away and on one side, and differences err by about the root of the tolerance, which
        hardly moves an optimum. An unknown that hardly moves the filament has neighbours still further away, on both
        sides. A ringing run depends more nonlinearly on its unknowns and has a tighter tolerance: its neighbours lie
        nearer, on both sides.
        """
        if not self.jumps:
            path, code = self._in_lock_step(self._run(point, times, max_steps), point, seen)
            is_lost = code in (compiled.NON_FINITE, compiled.SINGULAR)
            return super().run_with_slopes(point, times, seen, max_steps) if is_lost else path
        asked = times, seen, max_steps
        if self.settings.atol < _RINGING:
            return self._differences(point, *asked, (-1.0, 1.0), _APART_RINGING)
        size = max(_APART * self.settings.rtol**0.5, _MIN_APART)
        base = self._differences(point, *asked, (1.0,), size)
        slopes = np.zeros((0, *base.values.shape)) if base.slopes is None else base.slopes
        least = _JUMP * self.settings.rtol * float(np.max(np.abs(base.values), initial=0.0))
        moved = np.sqrt(np.mean(slopes**2, axis=(1, 2)))
        near = np.flatnonzero(moved * size < least).tolist()
        further = least / np.maximum(moved[near], least / _FURTHEST)
        points = [point.moved(row, step) for row, far in zip(near, further, strict=True) for step in (-far, far)]
        paths = self.runs(points, *asked)
        for row, far, below, above in zip(near, further, paths[::2], paths[1::2], strict=True):
            slope = (above.values - below.values) / (2 * far)
            slopes[row] = np.where(np.isfinite(slope), slope, slopes[row])
        return base

    def _in_lock_step(self, run: RunInput, point: Point, seen: tuple[int, ...]) -> tuple[Path, int]:
        """Integrate once on each core, each with a share of the neighbouring runs; all take the same steps."""
        count, sites = len(point.d_parameters), self.filament.sites
        moved = np.zeros((count, sites.shape[0] * sites.shape[1]))
        moved[:, sites.x], moved[:, sites.z] = point.d_x, point.d_z
        shares = np.array_split(np.arange(count), max(1, min(worker_count(None), count)))
        statuses, work = [Status() for _ in shares], []
        for own, status in zip(shares, statuses, strict=True):
            states = moved[own].reshape(len(own), *sites.shape)
            directions = Directions(point.d_parameters[own], states, np.full(len(own), _SIZE))
            work.append(partial(self.filament.model.sensitivities, run, directions, status))
        answers = _watched(*work)
        # If the neighbours of one share failed, its status is that of all.
        worst = next((status for status in statuses if status.code != compiled.SOLVED), statuses[0])
        slopes = np.concatenate([slopes for _, slopes in answers])
        return self._path(answers[statuses.index(worst)][0], slopes, seen, worst), int(worst.code)

    def _run(self, point: Point, times: Floats, max_steps: int) -> RunInput:
        return RunInput(
            parameters=np.ascontiguousarray(point.parameters),
            places=self.filament.places,
            state=self.filament.sites.state(point.start.x, point.start.z),
            times=np.concatenate([[0.0], times]),
            relative=self.settings.rtol,
            absolute=self.settings.atol,
            work_absolute=self.settings.atol if self.controls_work else 0.0,
            kinks=self.kinks,
            max_steps=max_steps,
        )

    def _path(self, states: Floats, slopes: Floats | None, seen: tuple[int, ...], status: Status) -> Path:
        model, sites = self.filament.model, self.filament.sites
        compiled.refuse(status.code, model.message(status.code))
        where = np.concatenate([sites.x, sites.z])[list(seen)]
        values = states.reshape(len(states), -1)[1:, where]
        if slopes is not None:
            slopes = slopes.reshape(*slopes.shape[:2], sites.shape[0] * sites.shape[1])[:, 1:, where]
        message = "" if status.code == compiled.SOLVED else model.message(status.code)
        return Path(values, slopes, int(status.steps), message)


def _watched(*works: Callable[[ct.c_int], Result]) -> list[Result]:
    """Run functions in parallel threads, so that Ctrl-C can stop them."""
    stop = ct.c_int(0)
    with ThreadPoolExecutor(max(1, min(worker_count(None), len(works)))) as pool:
        answers = [pool.submit(work, stop) for work in works]
        try:
            while wait(answers, _LOOK).not_done:
                check_time()
        finally:
            stop.value = 1
    return [answer.result() for answer in answers]


_STEP = 1e-5  # In unknowns of order one; differences of smooth formulas err by 1e-10
_FURTHER = 1e-3  # In unknowns, to find the supports that free parameters move


class FrozenFilament:
    """A filament ready to be integrated with any values of its free parameters."""

    def __init__(self, scene: Scene, free: Sequence[FreeParameter], effects: Effects, backend: Backend) -> None:
        self._scene, self.backend = scene, backend
        self.all_free = tuple(free)
        self.scale = time_scale(scene)
        parts = _assembled(scene, effects, self.all_free)
        self.graph = parts.graph
        stays = scene.initial.surface == "fresh" and all(one.path != "initial.stretch" for one in self.all_free)
        self.integrator = self._integrator_for(parts, effects)
        newton = None
        if isinstance(self.integrator, CompiledForward):
            newton = CompiledNewton(parts.graph, self.integrator.filament, parts.code_at_rest, self.integrator.settings)
        self._starts = Starts(parts, newton, follow=stays)
        idle = self._idle()
        if idle:
            named, remedy = ", ".join(self.graph.effects), "run.effects with more"
            found = f"makes no difference with the effects in force: {named}"
            raise SceneError([Fault(f"free {one.name}", found, remedy) for one in idle])

    @cached_property
    def free(self) -> tuple[FreeParameter, ...]:
        """Free parameters of the scene, without those of the measurement."""
        return tuple(one for one in self.all_free if not one.of_measurement)

    def scene_of(self, q: Floats) -> Scene:
        """The scene with the values of these unknowns, without those of the measurement."""
        return with_values(self._scene, self.free, [one.value(float(x)) for one, x in zip(self.free, q, strict=True)])

    def parameters(self, scene: Scene) -> Floats:
        """Parameters of the graph for the scene with other values."""
        return self.graph.vector(parameter_values(scene) | {TIME_SCALE: self.scale})

    @cached_property
    def unknowns(self) -> list[_Unknown]:
        """Kind and place of every unknown of the state, differential ones first."""
        graph = self.graph
        return [*graph.differential.unknowns, *graph.algebraic.unknowns]

    def point(self, q: Floats, *, slopes: bool) -> Point | None:
        """The filament with these unknowns of the scene, and its derivatives by them; None without a starting state."""
        base = self._at(q, None, settle=True)
        if base is None:
            return None
        if not slopes:
            return base
        count = len(self.free)
        p, x, z = (np.zeros((count, part.size)) for part in (base.parameters, base.start.x, base.start.z))
        length, across = np.zeros(count), 2 * _STEP
        # In lock-step the compiled solver makes algebraic unknowns consistent by itself.
        settle = not self.backend.compiled or self.graph.positions_are_algebraic or self.graph.terms.resolved
        for row, direction in enumerate(np.eye(count)):
            low, high = (self._at(q + step * direction, base.start, settle=settle) for step in (-_STEP, _STEP))
            if low is None or high is None:
                return None
            p[row], x[row] = high.parameters - low.parameters, high.start.x - low.start.x
            z[row], length[row] = high.start.z - low.start.z, high.length - low.length
        return replace(base, d_parameters=p / across, d_x=x / across, d_z=z / across, d_length=length / across)

    def _at(self, q: Floats, near: Start | None, *, settle: bool) -> Point | None:
        scene = self.scene_of(q)
        if not scene.filament.thickness < scene.filament.span:
            return None
        values = self.parameters(scene)
        if not np.all(np.isfinite(values)):
            return None
        start = self._starts.at(scene, values, near, settle=settle)
        if start is None:
            return None
        p, x, z = (np.zeros((0, part.size)) for part in (values, start.x, start.z))
        return Point(q, start, values, rest_length(scene), p, x, z, np.zeros(0))

    def _integrator_for(self, parts: Assembled, effects: Effects) -> Integrator:
        scene = self._scene
        if scene.extrusion.present:
            found = "given, but derivatives are those of a strand that hangs from the start"
            raise SceneError([Fault("extrusion", found, "leaving it out")])
        settings = compiled_settings(scene, effects)
        kinks = np.array(
            sorted({row[0] / self.scale for row in (*scene.ends.motion, *scene.ends.right_twist) if row[0] > 0})
        )
        if not self.backend.compiled:
            if kinks.size:
                found = "a support that moves is followed by the compiled solver only, when derivatives are wanted"
                raise SceneError([Fault("ends.motion", found, f"a C compiler; {self.backend.reason}")])
            return InterpretedForward(parts.graph, settings)
        filament = compile_filament(parts.graph, parts.structure)
        works = "v" not in parts.graph.differential.kinds
        return CompiledForward(filament, settings, kinks, controls_work=works, jumps=parts.graph.terms.resolved)

    def _idle(self) -> list[FreeParameter]:
        """Free parameters that change neither start nor equations at the scene's own values."""
        point = self.point(np.array([one.scaled(one.typical) for one in self.free]), slopes=True)
        if point is None:
            found = "no equilibrium was found to start from"
            raise SceneError([Fault("ends", found, "supports between which a filament can rest")])
        columns = point.d_parameters, point.d_x, point.d_z, point.d_length[:, None]
        return [one for one, row in zip(self.free, np.concatenate(columns, axis=1), strict=True) if not row.any()]


def frozen_filament(scene: Scene, free: Sequence[FreeParameter], backend: str, rtol: float | None) -> FrozenFilament:
    """Choose effects, grid and backend once, for all values of the free parameters."""
    # Every backend uses a linearly implicit method, whose discrete solution can be differentiated.
    update: dict[str, object] = {"solver": None}
    if backend != "auto":
        update["backend"] = backend
    if rtol is not None:
        update["rtol"] = rtol
    scene = scene.model_copy(update={"numerics": scene.numerics.model_copy(update=update)})
    effects = choose_effects(scene)
    if not effects.terms().integrates:
        found = "without inertia or flow the motion does not depend on time"
        raise SceneError([Fault("run.effects", found, "inertia, or a law that flows")])
    return FrozenFilament(scene, free, effects, choose_backend(scene, effects))


def _assembled(scene: Scene, effects: Effects, free: Sequence[FreeParameter]) -> Assembled:
    """The assembled filament; every support that a free parameter can move is an input of its graph."""
    typical = assembled(scene, effects)
    moved = with_values(scene, free, [one.value(one.scaled(one.typical) - _FURTHER) for one in free])
    if choose_body(moved, choose_grid(scene, effects)).supports == typical.structure.recorded.body.supports:
        return typical
    return assembled(moved, effects)
