"""From an equilibrium that may be unstable to one that is not: the filament is nudged and creeps downhill.

Newton's method finds any equilibrium, a straight bar that a support has pushed together as well as the shape into which
it buckles. A filament at rest is in a minimum of its energy.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats

_NUDGE = 1e-3  # of a span
_LARGEST = 0.05  # change of a position in one step, in spans
_GROWTH, _SHRINKAGE = 2.0, 0.25
_SETTLED = 1e-11
_ITERATIONS = 400
_ROUNDING = 1e-13


def settled(graph: Graph, x: Floats, p: Floats, z: Floats, straight: Floats) -> Floats:
    """The minimum of the energy that a nudged equilibrium creeps into; the same where it is one already.

    An arch that stands may be such a minimum, too: it is turned over first, so that what hangs is found.

    Linearly implicit steps along dz/dtau = alg, the forces over the masses: each must lower the energy, so that none
    steps back onto a saddle.

    Parameters
    ----------
    graph : Graph
        With algebraic positions, whose forces derive from its energy.
    x, p, z : ndarray
        Differential states, parameters and the equilibrium found.
    straight : ndarray
        The straight filament between the same supports.
    """
    slope = _Slope(graph, x, p)
    nudge = _nudge(graph)
    low = slope.descended(min((z, _turned_over(graph, z, straight)), key=slope.energy) - nudge)
    # What leaves a straight bar may rise as well as hang.
    other = slope.descended(_turned_over(graph, low, straight) - nudge)
    return min((low, other), key=slope.energy)


def snapped(graph: Graph, time: float, x: Floats, p: Floats, z: Floats) -> Floats:
    """The minimum of the energy that a shape out of balance, nudged, creeps into: beyond a fold of its equilibria.

    Parameters
    ----------
    graph : Graph
        With algebraic positions, whose forces derive from its energy.
    time : float
        In units of the time scale: where the supports are.
    x, p, z : ndarray
        Differential states, parameters and the shape.
    """
    return _Slope(graph, x, p, time).descended(z - _nudge(graph))


def _nudge(graph: Graph) -> Floats:
    """Downwards, and a little more on one side."""
    weight = np.abs(graph.z_where) / 0.5
    size = np.array([_NUDGE if kind == "y" else 0.0 for kind in graph.z_kinds])
    return np.asarray(size * (1 - weight**2) * (1 + 0.1 * np.sign(graph.z_where)))


def _turned_over(graph: Graph, z: Floats, straight: Floats) -> Floats:
    """The shape on the other side of the line between the supports."""
    across = np.isin(graph.z_kinds, ("y", "psi"))
    return np.where(across, 2 * straight - z, z)


class _Slope:
    """Energy of the filament, and implicit steps down its slope."""

    def __init__(self, graph: Graph, x: Floats, p: Floats, time: float = 0.0) -> None:
        self._x, self._p, self._time, self._observables = x, p, time, graph.observables
        inputs = [graph.t, graph.x, graph.z, graph.p]
        pace = ca.SX.sym("pace")
        matrix = ca.SX.eye(graph.z.numel()) / pace - ca.jacobian(graph.alg, graph.z)
        self._system = ca.Function("system", [*inputs, pace], [graph.alg, matrix])
        self._solver = ca.Linsol("slope", "qr", self._system.sparsity_out(1))

    def energy(self, z: Floats) -> float:
        """Elastic, surface and potential energy per undeformed area."""
        seen = self._observables(time=self._time, state=self._x, algebraic=z, parameters=self._p)
        return sum(float(seen[f"energy_{kind}"]) for kind in ("elastic", "surface", "potential"))

    def descended(self, start: Floats) -> Floats:
        """The minimum that a shape creeps into.

        The first step is as short as that of an explicit method: what is stiff comes to rest before the steps are so
        long that they would end on a saddle.
        """
        _, matrix = self._system(self._time, self._x, start, self._p, 1.0)
        pace = 1 / float(np.max(np.abs(np.diag(np.asarray(matrix)))))
        best, lowest = start, self.energy(start)
        for _ in range(_ITERATIONS):
            step = self.step(best, pace)
            if step is None:
                pace *= _SHRINKAGE
                continue
            size = float(np.max(np.abs(step)))
            if size < _SETTLED and pace > 1:
                return best + step
            energy = self.energy(best + step)
            if size > _LARGEST or not energy <= lowest + _ROUNDING * abs(lowest):
                pace *= _SHRINKAGE
                continue
            best, lowest, pace = best + step, energy, pace * _GROWTH
        return best

    def step(self, z: Floats, pace: float) -> Floats | None:
        """One linearly implicit step; None where it cannot be computed."""
        force, matrix = self._system(self._time, self._x, z, self._p, pace)
        try:
            self._solver.sfact(matrix)
            self._solver.nfact(matrix)
            step = np.asarray(self._solver.solve(matrix, force)).ravel()
        except RuntimeError:
            return None
        return step if np.all(np.isfinite(step)) else None
