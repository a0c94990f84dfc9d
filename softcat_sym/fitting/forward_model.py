"""Readings of a camera as functions of the free parameters, with derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.free_parameters import INITIAL_SAG, TIME_OFFSET, FreeParameter, Unknowns
from softcat_sym.fitting.integration import FrozenFilament, Point, frozen_filament, timing_of
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import identity_of
from softcat_sym.solvers.solution import watched
from softcat_sym.store import Arrays, Form, key_of, packed, stored, unpacked

_STEP = 1e-6  # In unknowns of order one, for observables that are smooth functions of the state
_STENCIL = 4


class Observable:
    """What is read off the state of a filament at some times."""

    seen: tuple[int, ...]  # Numbers of the unknowns that it depends on: differential ones first
    has_rate = False  # Whether the second of these unknowns is its rate over the rest length

    def read(self, values: Floats, point: Point, seconds: Floats, rows: NDArray[np.bool_]) -> Floats:
        """Readings in some rows, from the unknowns, shape (rows, seen), and the times since the release [s]."""
        raise NotImplementedError

    def slopes(self, values: Floats, d_values: Floats, point: Point, seconds: Floats) -> Floats:
        """Derivatives of all readings by the k free parameters of the scene, shape (k, readings), by differences."""
        every = np.ones(len(values), dtype=bool)
        pairs = [
            [self.read(values + step * row, point.moved(number, step), seconds, every) for step in (-_STEP, _STEP)]
            for number, row in enumerate(d_values)
        ]
        ends = np.array(pairs).reshape(len(d_values), 2, len(values))
        return np.asarray((ends[:, 1] - ends[:, 0]) / (2 * _STEP))


class Midpoint(Observable):
    """Height of the midpoint."""

    def __init__(self, filament: FrozenFilament) -> None:
        middle = int(np.argmin(np.abs(filament.graph.grid.nodes)))
        unknowns = filament.unknowns
        if ("y", middle) not in unknowns:
            raise SoftcatError("the filament has no node at midspan")
        self.seen = tuple(unknowns.index((kind, middle)) for kind in ("y", "v") if (kind, middle) in unknowns)
        self.has_rate = len(self.seen) > 1

    def read(self, values: Floats, point: Point, seconds: Floats, rows: NDArray[np.bool_]) -> Floats:
        """Height over the rest length, times the rest length."""
        return np.asarray(point.length * values[:, 0])

    def slopes(self, values: Floats, d_values: Floats, point: Point, seconds: Floats) -> Floats:
        """Derivatives of the product."""
        return np.asarray(point.length * d_values[:, :, 0] + point.d_length[:, None] * values[:, 0])


class ShapePoints(Observable):
    """Heights at points of the centre line."""

    def __init__(self, filament: FrozenFilament, x: Floats) -> None:
        self._filament, self._x, unknowns = filament, x, filament.unknowns
        self.seen = tuple(n for n, (kind, _) in enumerate(unknowns) if kind in ("x", "y"))
        self._places = {
            kind: np.array([(k, unknowns[n][1]) for k, n in enumerate(self.seen) if unknowns[n][0] == kind], dtype=int)
            for kind in ("x", "y")
        }

    def read(self, values: Floats, point: Point, seconds: Floats, rows: NDArray[np.bool_]) -> Floats:
        """Interpolate between nodes by a cubic."""
        scene, x = self._filament.scene_of(point.q), self._x[rows]
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
_MAX_STEPS, _MIN_STEPS, _TIMES_TYPICAL = 20_000, 2_000, 10
_NO_START = "no equilibrium was found to start from, or the filament would be slack where the scene's is taut"


class ForwardModel(Unknowns):
    """Heights as a camera shows them, for any values of the free parameters.

    Effects, grid, tolerances and the unit of time are chosen once, for the scene's own values, so that the model is
    smooth in its unknowns q (:class:`softcat_sym.fitting.free_parameters.FreeParameter`). Before the release the
    filament is as at the start. The model refuses a parameter that has no effect, or omits it on request. Evaluations
    are kept in the store.
    """

    def __init__(
        self,
        scene: Scene,
        free: Sequence[FreeParameter],
        times: Floats,
        backend: str = "auto",
        rtol: float | None = None,
    ) -> None:
        self.times = np.asarray(times, dtype=float)
        if self.times.ndim != 1 or not np.all(np.isfinite(self.times)):
            raise SoftcatError("times: give a row of finite times in s")
        self._filament = frozen_filament(scene, free, backend, rtol)
        self.free = self._filament.all_free
        self._paths = {one.path for one in self.free}
        self._identity = identity_of(scene), self.free, rtol, self.backend
        self._midpoint = Midpoint(self._filament)
        self._last: tuple[bytes, Arrays] = b"", {}
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

    def release(self, q: Floats) -> float:
        """Time of the release on the camera's clock [s]."""
        return self._value(q, TIME_OFFSET)

    def midpoints(self, q: Floats) -> Floats:
        """Heights of the midpoint at the times of the data."""
        return self._midpoints(q, slopes=False)["values"].copy()

    def with_derivatives(self, q: Floats) -> tuple[Floats, Floats]:
        """Heights of the midpoint with the derivatives of the discrete solution."""
        answer = self._midpoints(q, slopes=True)
        return answer["values"].copy(), answer["derivatives"].copy()

    def shapes(self, q: Floats, times: Floats, x: Floats) -> tuple[Floats, Floats]:
        """Heights of the centre line at points, with their derivatives."""
        times, x = np.asarray(times, dtype=float), np.asarray(x, dtype=float)
        if times.shape != x.shape or times.ndim != 1 or not np.all(np.isfinite(times) & np.isfinite(x)):
            raise SoftcatError("shapes: give as many finite times [s] as places [m], in one row each")
        found = self._stored(ShapePoints(self._filament, x), q, times, ("shapes", x), slopes=True)
        return found["values"], found["derivatives"]

    def _midpoints(self, q: Floats, *, slopes: bool) -> Arrays:
        key = np.asarray(q, dtype=float).tobytes()
        if self._last[0] != key or (slopes and "derivatives" not in self._last[1]):
            self._last = key, self._stored(self._midpoint, q, self.times, ("midpoint", slopes), slopes=slopes)
        self.message = str(self._last[1]["message"])
        return self._last[1]

    def _stored(self, what: Observable, q: Floats, times: Floats, name: tuple[object, ...], *, slopes: bool) -> Arrays:
        """Readings of an observable, from the store if they were computed before."""
        q, times = np.asarray(q, dtype=float), np.asarray(times, dtype=float)

        def evaluated() -> Arrays:
            with watched():
                return self._observed(what, q, times, slopes=slopes)

        return stored(key_of("evaluation", self._identity, name, q, times), evaluated, _FORM)

    def _observed(self, what: Observable, q: Floats, times: Floats, *, slopes: bool) -> Arrays:
        filament, rows = self._filament, len(times)
        point = filament.point(self._of_scene(q), slopes=slopes)
        if point is None:
            none = {"values": np.full(rows, np.nan), "derivatives": np.full((rows, len(self.free)), np.nan)}
            return {**none, "message": np.array(_NO_START)}
        since, shifts = times - self.release(q), TIME_OFFSET in self._paths
        timing = timing_of(since / filament.scale, beside=shifts and not what.has_rate)
        seen, message = list(what.seen), ""
        values = np.tile(np.concatenate([point.start.x, point.start.z])[seen], (rows, 1))
        d_values = np.repeat(np.concatenate([point.d_x, point.d_z], axis=1)[:, None, seen], rows, axis=1)
        rates = np.zeros(rows)
        if len(timing.model):
            run = filament.integrator.run_with_slopes if slopes else filament.integrator.run
            path = run(point, timing.model, what.seen, self._max_steps)
            values[timing.after], message = path.values[timing.row], path.message
            if slopes:
                d_values[:, timing.after] = np.nan if path.slopes is None else path.slopes[:, timing.row]
            if slopes and shifts and what.has_rate:
                rates[timing.after] = point.length * path.values[timing.row, 1] / filament.scale
            elif slopes and shifts:
                ends = [
                    what.read(path.values[which], point, timing.model[which] * filament.scale, timing.after)
                    for which in (timing.sooner, timing.later)
                ]
                apart = (timing.model[timing.later] - timing.model[timing.sooner]) * filament.scale
                rates[timing.after] = (ends[1] - ends[0]) / apart
        read = what.read(values, point, since, np.ones(rows, dtype=bool))
        answer = {"values": read + self._value(q, INITIAL_SAG), "message": np.array(message)}
        if not slopes:
            return answer
        by_zero = np.where(np.isfinite(read), 1.0, np.nan)
        by_scene = iter(what.slopes(values, d_values, point, since))
        of_camera = {TIME_OFFSET: -rates, INITIAL_SAG: by_zero}
        columns = [of_camera[one.path] * one.scale if one.path in of_camera else next(by_scene) for one in self.free]
        return {**answer, "derivatives": np.stack(columns, axis=1)}

    @cached_property
    def _max_steps(self) -> int:
        """Maximum number of time steps: a multiple of the typical filament's, so that absurd values fail soon."""
        point = self._filament.point(self._of_scene(self.typical), slopes=False)
        since = (self.times - self.release(self.typical)) / self._filament.scale
        timing = timing_of(since, beside=TIME_OFFSET in self._paths and not self._midpoint.has_rate)
        if point is None or not len(timing.model):
            return _MAX_STEPS
        path = self._filament.integrator.run(point, timing.model, self._midpoint.seen, _MAX_STEPS)
        return _MAX_STEPS if path.message or not path.steps else max(_MIN_STEPS, _TIMES_TYPICAL * path.steps)

    def _of_scene(self, q: Floats) -> Floats:
        return np.array([x for one, x in zip(self.free, np.asarray(q), strict=True) if not one.of_measurement])

    def _value(self, q: Floats, path: str) -> float:
        return next((one.value(float(x)) for one, x in zip(self.free, q, strict=True) if one.path == path), 0.0)
