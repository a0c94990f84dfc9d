"""Readings of a camera or a load cell as functions of the free parameters, with derivatives."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.free_parameters import INITIAL_SAG, TIME_OFFSET, FreeParameter, Unknowns
from softcat_sym.fitting.integration import (
    FrozenFilament,
    InterpretedForward,
    Path,
    Point,
    Timing,
    frozen_filament,
    timing_of,
)
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.scene import Scene, rest_length, undeformed_area
from softcat_sym.simulate import identity_of
from softcat_sym.solvers.solution import watched
from softcat_sym.solvers.start import Start
from softcat_sym.store import Arrays, Form, key_of, packed, stored, unpacked

_STEP = 1e-6  # In unknowns of order one, for the interpolation, which is smooth
_STENCIL = 4


class ForwardReadings:
    """Readings that depend on some unknowns at their times, for any values of the free parameters, with derivatives."""

    def __init__(
        self,
        filament: FrozenFilament,
        free: tuple[FreeParameter, ...],
        times: Floats,
        seen: tuple[int, ...],
        max_steps: int,
    ) -> None:
        self._filament, self._free, self._max_steps = filament, free, max_steps
        self._times, self._seen = times, seen
        self._shifts = any(one.path == TIME_OFFSET for one in free)

    def _read(self, values: Floats, ours: Floats, seconds: Floats, rows: NDArray[np.bool_]) -> Floats:
        """Some of the readings, from their unknowns row by row, the free parameters and the times."""
        raise NotImplementedError

    def readings(self, q: Floats) -> tuple[Floats, Floats]:
        """Readings without the offset of a camera's zero, and their derivatives."""
        q = np.asarray(q, dtype=float)
        ours = np.array([x for one, x in zip(self._free, q, strict=True) if not one.of_measurement])
        times = (self._times - self._value(q, TIME_OFFSET)) / self._filament.scale
        timing, point = timing_of(times, beside=self._shifts), self._filament.point(ours, slopes=True)
        m, derivatives = len(times), np.zeros((len(times), len(self._free)))
        if point is None:
            return np.full(m, np.nan), np.full_like(derivatives, np.nan)
        begin = np.concatenate([point.start.x, point.start.z])[list(self._seen)]
        d_begin = np.concatenate([point.d_x, point.d_z], axis=1)[:, list(self._seen)]
        values, slopes = np.tile(begin, (m, 1)), np.tile(d_begin[:, None, :], (1, m, 1))
        clock = np.zeros(m)
        if len(timing.model):
            path = self._filament.integrator.run_with_slopes(point.begin(timing.model), self._seen, self._max_steps)
            values[timing.after] = path.values[timing.row]
            slopes[:, timing.after] = path.slopes[:, timing.row] if path.slopes is not None else np.nan
            if self._shifts:
                clock[timing.after] = -self._rates(path.values, timing, ours)
        seconds, every = times * self._filament.scale, np.ones(m, dtype=bool)
        scene = iter(range(len(ours)))
        for column, one in enumerate(self._free):
            if one.path == TIME_OFFSET:
                derivatives[:, column] = clock * one.scale
            elif not one.of_measurement:
                n = next(scene)
                step = _STEP * np.eye(len(ours))[n]
                low, high = (
                    self._read(values + sign * _STEP * slopes[n], ours + sign * step, seconds, every)
                    for sign in (-1, 1)
                )
                derivatives[:, column] = (high - low) / (2 * _STEP)
        return self._read(values, ours, seconds, every), derivatives

    def _value(self, q: Floats, path: str) -> float:
        return next((one.value(float(x)) for one, x in zip(self._free, q, strict=True) if one.path == path), 0.0)

    def _rates(self, values: Floats, timing: Timing, ours: Floats) -> Floats:
        """Rates of the readings since the release [1/s]."""
        scale = self._filament.scale
        pair = [
            self._read(values[which], ours, timing.model[which] * scale, timing.after)
            for which in (timing.sooner, timing.later)
        ]
        apart = (timing.model[timing.later] - timing.model[timing.sooner]) * scale
        return (pair[1] - pair[0]) / apart


class ForwardForces(ForwardReadings):
    """Force of the right support on the filament, outwards (way 0) or upwards (way 1) [N]."""

    def __init__(
        self, filament: FrozenFilament, free: tuple[FreeParameter, ...], times: Floats, way: int, max_steps: int
    ) -> None:
        graph = filament.graph
        if not graph.program.support or graph.grid.last.is_free:
            found = "a force of the right support is known only for stretchable plane filaments that this support holds"
            raise SoftcatError(f"forces: {found}; leave the column of forces out")
        super().__init__(filament, free, times, tuple(range(len(graph.x_kinds) + len(graph.z_kinds))), max_steps)
        self._way = way

    def _read(self, values: Floats, ours: Floats, seconds: Floats, rows: NDArray[np.bool_]) -> Floats:
        filament, count = self._filament, len(self._filament.graph.x_kinds)
        times = np.maximum(seconds, 0.0) / filament.scale
        stress = filament.support(len(values))(
            times[None, :], values[:, :count].T, values[:, count:].T, filament.parameters(ours)
        )
        force: Floats = np.asarray(stress, dtype=float)[self._way] * undeformed_area(filament.scene_of(ours))
        return force


class ForwardShapes(ForwardReadings):
    """Heights at points of the centre line."""

    def __init__(
        self, filament: FrozenFilament, free: tuple[FreeParameter, ...], times: Floats, x: Floats, max_steps: int
    ) -> None:
        if times.shape != x.shape or times.ndim != 1 or not np.all(np.isfinite(times) & np.isfinite(x)):
            raise SoftcatError("shapes: give as many finite times [s] as places [m], in one row each")
        self._x, graph = x, filament.graph
        unknowns = [*zip(graph.x_kinds, graph.x_places, strict=True), *zip(graph.z_kinds, graph.z_places, strict=True)]
        seen = tuple(n for n, (kind, _) in enumerate(unknowns) if kind in ("x", "y"))
        super().__init__(filament, free, times, seen, max_steps)
        self._places = {
            kind: np.array([(k, unknowns[n][1]) for k, n in enumerate(seen) if unknowns[n][0] == kind], dtype=int)
            for kind in ("x", "y")
        }

    def heights(self, q: Floats) -> tuple[Floats, Floats]:
        """Heights, with the offset of the camera's zero, and their derivatives."""
        height, derivatives = self.readings(q)
        for column, one in enumerate(self._free):
            if one.path == INITIAL_SAG:
                derivatives[:, column] = np.where(np.isfinite(height), one.scale, np.nan)
        return height + self._value(np.asarray(q, dtype=float), INITIAL_SAG), derivatives

    def _read(self, values: Floats, ours: Floats, seconds: Floats, rows: NDArray[np.bool_]) -> Floats:
        x, scene = self._x[rows], self._filament.scene_of(ours)
        xs, ys = self._nodes(values, scene, seconds)
        return rest_length(scene) * _cubic(xs, ys, x / rest_length(scene))

    def _nodes(self, values: Floats, scene: Scene, seconds: Floats) -> tuple[Floats, Floats]:
        """Nodes from left to right over the rest length, shape (m, nodes)."""
        grid, length = self._filament.graph.grid, rest_length(scene)
        rows = [(0.0, 0.0, 0.0), *scene.ends.motion]
        along, up = (np.interp(seconds, [row[0] for row in rows], [row[axis] for row in rows]) for axis in (1, 2))
        # Supports, and the nodes of a theory in which they do not move along x.
        xs = np.tile(grid.nodes * (scene.filament.span / length), (len(values), 1))
        ys = np.zeros_like(xs)
        xs[:, -1] += along / length
        ys[:, -1] = (up - scene.ends.drop) / length
        for found, kind in ((xs, "x"), (ys, "y")):
            if self._places[kind].size:
                number, place = self._places[kind].T
                found[:, place] = values[:, number]
        if not grid.is_half:
            return xs, ys
        return np.concatenate([-xs[:, :0:-1], xs], axis=1), np.concatenate([ys[:, :0:-1], ys], axis=1)


def _cubic(xs: Floats, ys: Floats, x: Floats) -> Floats:
    """Lagrange's cubic through the four nodes nearest to x; NaN outside of the nodes, or if x does not increase."""
    nodes = xs.shape[1]
    first = np.clip(np.sum(xs < x[:, None], axis=1) - _STENCIL // 2, 0, nodes - _STENCIL)
    rows, columns = np.arange(len(x))[:, None], first[:, None] + np.arange(_STENCIL)
    at, height = xs[rows, columns], ys[rows, columns]
    result = np.zeros(len(x))
    for i in range(_STENCIL):
        others = [j for j in range(_STENCIL) if j != i]
        weight = np.prod((x[:, None] - at[:, others]) / (at[:, [i]] - at[:, others]), axis=1)
        result += weight * height[:, i]
    rounding = 1e-12
    inside = (x >= xs[:, 0] - rounding) & (x <= xs[:, -1] + rounding) & np.all(np.diff(xs, axis=1) > 0, axis=1)
    return np.where(inside, result, np.nan)


_FORM: Form[Arrays] = Form(packed, unpacked)
_X, _Z = "start x", "start z"


class StoredEvaluations:
    """Stored evaluations, each with its starting state, from which the next starting state is found."""

    def __init__(self, filament: FrozenFilament, model: tuple[object, ...]) -> None:
        self._filament, self._model = filament, model
        self._first = filament.near

    def of(self, what: tuple[object, ...], compute: Callable[[], Arrays]) -> Arrays:
        """Return an evaluation, from the store if it was made before."""
        near = self._filament.near
        begun = None if near is None else [near.x, near.z]

        def evaluated() -> Arrays:
            with watched():
                arrays, near = compute(), self._filament.near
            return arrays if near is None else {**arrays, _X: near.x, _Z: near.z}

        found = stored(key_of("evaluation", self._model, begun, what), evaluated, _FORM)
        self._filament.near = Start(np.asarray(found[_X]), np.asarray(found[_Z])) if _X in found else None
        return found

    def aside(self, compute: Callable[[], int]) -> int:
        """Compute something from the first starting state, and restore the present one afterwards."""
        near, self._filament.near = self._filament.near, self._first
        try:
            return compute()
        finally:
            self._filament.near = near


_MAX_STEPS, _MIN_STEPS, _TIMES_TYPICAL = 20_000, 2_000, 10


_NO_START = "no equilibrium was found to start from, or the filament would be slack where the scene's is taut"


@dataclass(frozen=True)
class _Answer:
    """Heights of the midpoint at the times of the data, and their derivatives if they were requested."""

    midpoint: Floats
    derivatives: Floats | None
    message: str


class ForwardModel(Unknowns):
    """Height of the midpoint (X = 0) as a camera shows it, for any values of the free parameters.

    Effects, grid, tolerances and the unit of time are chosen once, for the scene's own values, so that the model is
    smooth in its unknowns q (:class:`softcat_sym.fitting.free_parameters.FreeParameter`). Before the release the
    midpoint is at its initial height. The model refuses a parameter that has no effect, or omits it on request.
    """

    def __init__(
        self,
        scene: Scene,
        free: Sequence[FreeParameter],
        times: Floats,
        backend: str = "auto",
        rtol: float | None = None,
        *,
        without_idle: bool = False,
    ) -> None:
        self.times = np.asarray(times, dtype=float)
        if self.times.ndim != 1 or not np.all(np.isfinite(self.times)):
            raise SoftcatError("times: give a row of finite times in s")
        self._filament = frozen_filament(scene, free, backend, rtol, without_idle=without_idle)
        self.free = self._filament.all_free
        self._stored = StoredEvaluations(self._filament, (identity_of(scene), self.free, rtol, self.backend))
        self._seen = _seen_of(self._filament.graph)
        self._shifts = any(one.path == TIME_OFFSET for one in self.free)
        self._last: tuple[bytes, _Answer] | None = None
        self.message = ""

    @property
    def effects(self) -> tuple[str, ...]:
        """Names of the effects in force, for all values."""
        return self._filament.graph.effects

    @property
    def terms(self) -> Terms:
        """Terms of the equations that the effects keep."""
        return self._filament.graph.terms

    @property
    def backend(self) -> str:
        """The backend that integrates, with the reason."""
        return str(self._filament.backend)

    @property
    def compiled(self) -> bool:
        """Whether the backend is generated C."""
        return self._filament.backend.compiled

    def scene(self, q: Floats) -> Scene:
        """The scene with the values of these unknowns."""
        return self._filament.scene_of(self._of_scene(q))

    def midpoints(self, q: Floats) -> Floats:
        """Heights of the midpoint at the times of the data."""
        return self._answer(q, slopes=False).midpoint.copy()

    def with_derivatives(self, q: Floats) -> tuple[Floats, Floats]:
        """Heights of the midpoint with the derivatives of the discrete solution."""
        answer = self._answer(q, slopes=True)
        if answer.derivatives is None:
            raise SoftcatError("the forward model kept no derivatives")
        return answer.midpoint.copy(), answer.derivatives.copy()

    def gradient(self, q: Floats, weights: Floats) -> Floats:
        """Derivatives of the weighted sum of the midpoints.

        The interpreted backend uses the adjoint of the discrete solution, the compiled one :meth:`with_derivatives`.
        """
        integrator, weights = self._filament.integrator, np.asarray(weights, dtype=float)
        timing, point = self._timing(q), self._filament.point(self._of_scene(q), slopes=True)
        if not isinstance(integrator, InterpretedForward) or point is None or not len(timing.model):
            return np.asarray(weights @ self.with_derivatives(q)[1], dtype=float)
        begin = point.begin(timing.model)
        summed = np.zeros((len(timing.model), len(self._seen)))
        np.add.at(summed[:, 0], timing.row, weights[timing.after] * point.length)
        path = integrator.run(begin, self._seen, self._max_steps)
        by_scene = integrator.pull_back(begin, self._seen, self._max_steps, summed)
        by_scene += point.length * float(weights[~timing.after].sum()) * self._at_start(point)[1]
        by_scene += point.d_length * float(weights @ self._heights(path, point, timing))
        by_clock = weights @ self._by_clock(path, point, timing)
        row = self._gathered(by_scene[None, :], np.array([by_clock]), np.array([weights.sum()]))
        return np.asarray(row[0], dtype=float)

    def shapes(self, q: Floats, times: Floats, x: Floats) -> tuple[Floats, Floats]:
        """Heights of the centre line, interpolated between nodes by a cubic."""
        times, x = np.asarray(times, dtype=float), np.asarray(x, dtype=float)
        q = np.asarray(q, dtype=float)

        def heights() -> Arrays:
            found = ForwardShapes(self._filament, self.free, times, x, self._max_steps).heights(q)
            return {"height": found[0], "derivatives": found[1]}

        found = self._stored.of(("shapes", q, times, x), heights)
        return found["height"], found["derivatives"]

    def forces(self, q: Floats, times: Floats, way: int) -> tuple[Floats, Floats]:
        """Force of the right support on the filament [N], outwards (way 0) or upwards (way 1)."""
        times, q = np.asarray(times, dtype=float), np.asarray(q, dtype=float)

        def forces() -> Arrays:
            found = ForwardForces(self._filament, self.free, times, way, self._max_steps).readings(q)
            return {"force": found[0], "derivatives": found[1]}

        found = self._stored.of(("forces", q, times, way), forces)
        return found["force"], found["derivatives"]

    def _answer(self, q: Floats, *, slopes: bool) -> _Answer:
        q = np.asarray(q, dtype=float)
        key = q.tobytes()
        if self._last is None or self._last[0] != key or (slopes and self._last[1].derivatives is None):
            self._last = (key, self._evaluated(q, slopes=slopes))
        self.message = self._last[1].message
        return self._last[1]

    def _evaluated(self, q: Floats, *, slopes: bool) -> _Answer:
        def midpoint() -> Arrays:
            answer = self._integrated(q, slopes=slopes)
            arrays = {"midpoint": answer.midpoint, "message": np.array(answer.message)}
            return arrays if answer.derivatives is None else {**arrays, "derivatives": answer.derivatives}

        found = self._stored.of(("midpoint", slopes, q, self.times), midpoint)
        return _Answer(found["midpoint"], found.get("derivatives"), str(found["message"]))

    def _integrated(self, q: Floats, *, slopes: bool) -> _Answer:
        n, k = len(self.times), len(self.free)
        point = self._filament.point(self._of_scene(q), slopes=slopes)
        if point is None:
            return _Answer(np.full(n, np.nan), np.full((n, k), np.nan), _NO_START)
        timing, path = self._timing(q), Path(np.zeros((0, len(self._seen))), None, 0)
        if len(timing.model):
            run = self._filament.integrator.run_with_slopes if slopes else self._filament.integrator.run
            path = run(point.begin(timing.model), self._seen, self._max_steps)
        height = self._heights(path, point, timing)
        midpoint = point.length * height + self._value(q, INITIAL_SAG)
        if not slopes:
            return _Answer(midpoint, None, path.message)
        by_scene = np.repeat(self._at_start(point)[1][None, :], n, axis=0)
        if path.slopes is not None:
            by_scene[timing.after] = path.slopes[:, timing.row, 0].T
        by_scene = point.length * by_scene + height[:, None] * point.d_length
        derivatives = self._gathered(by_scene, self._by_clock(path, point, timing), np.ones(n))
        return _Answer(midpoint, derivatives, path.message)

    @cached_property
    def _max_steps(self) -> int:
        """Maximum number of time steps: a multiple of the typical filament's, so that absurd values fail soon."""
        q = self.typical

        def counted() -> int:
            point, timing = self._filament.point(self._of_scene(q), slopes=False), self._timing(q)
            if point is None or not len(timing.model):
                return _MAX_STEPS
            path = self._filament.integrator.run(point.begin(timing.model), self._seen, _MAX_STEPS)
            return _MAX_STEPS if path.message or not path.steps else max(_MIN_STEPS, _TIMES_TYPICAL * path.steps)

        return self._stored.aside(counted)

    def _of_scene(self, q: Floats) -> Floats:
        return np.array([x for one, x in zip(self.free, np.asarray(q), strict=True) if not one.of_measurement])

    def _value(self, q: Floats, path: str) -> float:
        return next((one.value(float(x)) for one, x in zip(self.free, q, strict=True) if one.path == path), 0.0)

    def _timing(self, q: Floats) -> Timing:
        times = (self.times - self._value(q, TIME_OFFSET)) / self._filament.scale
        return timing_of(times, beside=self._shifts and len(self._seen) == 1)

    def _at_start(self, point: Point) -> tuple[float, Floats]:
        """Height of the midpoint at the start over the rest length, and its derivatives."""
        start, number = point.start, self._seen[0]
        both = np.concatenate([start.x, start.z])
        return float(both[number]), np.concatenate([point.d_x, point.d_z], axis=1)[:, number]

    def _heights(self, path: Path, point: Point, timing: Timing) -> Floats:
        """Height of the midpoint over the rest length at the times of the data."""
        height = np.full(len(self.times), self._at_start(point)[0])
        height[timing.after] = path.values[timing.row, 0]
        return height

    def _by_clock(self, path: Path, point: Point, timing: Timing) -> Floats:
        """Derivative of the midpoint by the camera's clock [m/s]: minus its velocity."""
        result = np.zeros(len(self.times))
        if not self._shifts or not len(timing.model):
            return result
        if len(self._seen) > 1:
            rate = path.values[timing.row, 1]
        else:
            apart = timing.model[timing.later] - timing.model[timing.sooner]
            rate = (path.values[timing.later, 0] - path.values[timing.sooner, 0]) / apart
        result[timing.after] = -point.length * rate / self._filament.scale
        return result

    def _gathered(self, by_scene: Floats, by_clock: Floats, by_zero: Floats) -> Floats:
        """Derivatives by all unknowns in their order, shape (rows, k), from those of the scene and the camera's."""
        columns, scene = [], iter(by_scene.T)
        for one in self.free:
            if one.path == TIME_OFFSET:
                columns.append(by_clock * one.scale)
            elif one.path == INITIAL_SAG:
                columns.append(by_zero * one.scale)
            else:
                columns.append(next(scene))
        return np.stack(columns, axis=1)


def _seen_of(graph: Graph) -> tuple[int, ...]:
    """Numbers of the midpoint's height and, where it is an unknown, of its velocity, among all unknowns."""
    middle = int(np.argmin(np.abs(graph.grid.nodes)))
    unknowns = [*zip(graph.x_kinds, graph.x_places, strict=True), *zip(graph.z_kinds, graph.z_places, strict=True)]
    if ("y", middle) not in unknowns:
        raise SoftcatError("the filament has no node at midspan")
    return tuple(unknowns.index((kind, middle)) for kind in ("y", "v") if (kind, middle) in unknowns)
