"""Heights of the whole centre line at given places, interpolated between the nodes."""

from __future__ import annotations

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.graph.grid import Floats
from softcat_sym.inverse.forward.free import INITIAL_SAG, TIME_OFFSET, FreeParameter
from softcat_sym.inverse.forward.frozen_filament import FrozenFilament
from softcat_sym.inverse.forward.timing import Timing, timing_of
from softcat_sym.scene import Scene, rest_length

_STEP = 1e-6  # in unknowns of order one, of the interpolation, which is smooth
_STENCIL = 4


class ForwardShapes:
    """Heights at points of the centre line, for any values of what is free.

    Parameters
    ----------
    filament : FrozenFilament
        What moves.
    free : sequence of FreeParameter
        All of them, those of the camera too.
    times, x : ndarray, shape (m,)
        Where and when: on the camera's clock [s], and [m] from halfway between the supports.
    """

    def __init__(
        self, filament: FrozenFilament, free: tuple[FreeParameter, ...], times: Floats, x: Floats, most_steps: int
    ) -> None:
        if times.shape != x.shape or times.ndim != 1 or not np.all(np.isfinite(times) & np.isfinite(x)):
            raise SoftcatError("shapes: give as many finite times [s] as places [m], in one row each")
        self._filament, self._free, self._most_steps = filament, free, most_steps
        self._times, self._x = times, x
        self._shifts = any(one.path == TIME_OFFSET for one in free)
        graph = filament.graph
        unknowns = [*zip(graph.x_kinds, graph.x_places, strict=True), *zip(graph.z_kinds, graph.z_places, strict=True)]
        self._seen = tuple(n for n, (kind, _) in enumerate(unknowns) if kind in ("x", "y"))
        self._places = {
            kind: np.array([(k, unknowns[n][1]) for k, n in enumerate(self._seen) if unknowns[n][0] == kind], dtype=int)
            for kind in ("x", "y")
        }

    def heights(self, q: Floats) -> tuple[Floats, Floats]:
        """Heights and their derivatives.

        Returns
        -------
        height : ndarray, shape (m,)
            [m], in the camera's frame; NaN beyond the filament, where it hangs over itself, and without an answer.
        derivatives : ndarray, shape (m, k)
            d height/dq [m].
        """
        q = np.asarray(q, dtype=float)
        ours = np.array([x for one, x in zip(self._free, q, strict=True) if not one.of_measurement])
        offset, zero = (self._value(q, path) for path in (TIME_OFFSET, INITIAL_SAG))
        times = (self._times - offset) / self._filament.scale
        timing, point = timing_of(times, beside=self._shifts), self._filament.point(ours, slopes=True)
        m, derivatives = len(self._x), np.full((len(self._x), len(self._free)), np.nan)
        if point is None:
            return np.full(m, np.nan), derivatives
        begin = np.concatenate([point.start.x, point.start.z])[list(self._seen)]
        d_begin = np.concatenate([point.d_x, point.d_z], axis=1)[:, list(self._seen)]
        values, slopes = np.tile(begin, (m, 1)), np.tile(d_begin[:, None, :], (1, m, 1))
        clock = np.zeros(m)
        if len(timing.model):
            path = self._filament.integrator.run_with_slopes(point.begin(timing.model), self._seen, self._most_steps)
            values[timing.after] = path.values[timing.row]
            slopes[:, timing.after] = path.slopes[:, timing.row] if path.slopes is not None else np.nan
            if self._shifts:
                clock[timing.after] = -self._rates(path.values, timing, ours)
        seconds = times * self._filament.scale
        height = self._interpolated(values, ours, seconds, self._x)
        scene = iter(range(len(ours)))
        for column, one in enumerate(self._free):
            if one.path == TIME_OFFSET:
                derivatives[:, column] = clock * one.scale
            elif one.path == INITIAL_SAG:
                derivatives[:, column] = np.where(np.isfinite(height), one.scale, np.nan)
            else:
                n = next(scene)
                step = _STEP * np.eye(len(ours))[n]
                low, high = (
                    self._interpolated(values + sign * _STEP * slopes[n], ours + sign * step, seconds, self._x)
                    for sign in (-1, 1)
                )
                derivatives[:, column] = (high - low) / (2 * _STEP)
        return height + zero, derivatives

    def _value(self, q: Floats, path: str) -> float:
        return next((one.value(float(x)) for one, x in zip(self._free, q, strict=True) if one.path == path), 0.0)

    def _rates(self, values: Floats, timing: Timing, ours: Floats) -> Floats:
        """Velocity of the centre line at the places [m/s]."""
        scale, x = self._filament.scale, self._x[timing.after]
        pair = [
            self._interpolated(values[which], ours, timing.model[which] * scale, x)
            for which in (timing.sooner, timing.later)
        ]
        apart = (timing.model[timing.later] - timing.model[timing.sooner]) * scale
        return (pair[1] - pair[0]) / apart

    def _interpolated(self, values: Floats, ours: Floats, seconds: Floats, x: Floats) -> Floats:
        """Heights [m] at places, one for each row of unknowns."""
        scene = self._filament.scene_of(ours)
        xs, ys = self._nodes(values, scene, seconds)
        return rest_length(scene) * _cubic(xs, ys, x / rest_length(scene))

    def _nodes(self, values: Floats, scene: Scene, seconds: Floats) -> tuple[Floats, Floats]:
        """Nodes from left to right over the rest length, shape (m, nodes)."""
        grid, length = self._filament.graph.grid, rest_length(scene)
        rows = [(0.0, 0.0, 0.0), *scene.ends.motion]
        along, up = (np.interp(seconds, [row[0] for row in rows], [row[axis] for row in rows]) for axis in (1, 2))
        # Supports, and the places of a theory that has no others.
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
    """Lagrange's cubic through the four nodes around each place; NaN where there are none, or x is not increasing."""
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
