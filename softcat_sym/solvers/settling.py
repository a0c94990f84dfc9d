"""Descent from unstable equilibria to a minimum of the energy."""

from __future__ import annotations

import casadi as ca
import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.solvers.equilibrium import Stiffness

_NUDGE = 1e-3  # Perturbation, over the span
_LARGEST = 0.05  # Largest change of a position in one step, over the span
_GROWTH, _SHRINKAGE = 2.0, 0.25
_SETTLED = 1e-11
_SETTLING_ITERATIONS = 400
_SETTLING_ROUNDING = 1e-13


def settled(graph: Graph, x: Floats, p: Floats, z: Floats, straight: Floats) -> Floats:
    """Minimum of the energy reached from a perturbed equilibrium; the equilibrium itself if it is a minimum.

    As a standing arch may be a minimum, too, the shape is first reflected to the lower side, so that the result hangs.

    The steps are linearly implicit along dz/dtau = alg, the forces over the masses: each must lower the energy, so that
    none returns to a saddle.
    """
    slope, nudge = _Slope(graph, x, p), _nudge(graph)

    def turned_over(shape: Floats) -> Floats:
        """The shape on the other side of the line between the supports."""
        return np.where(np.isin(graph.algebraic.kinds, ("y", "psi")), 2 * straight - shape, shape)

    low = slope.descended(min((z, turned_over(z)), key=slope.energy) - nudge)
    # A straight bar may buckle upwards or downwards.
    other = slope.descended(turned_over(low) - nudge)
    return min((low, other), key=slope.energy)


def snapped(graph: Graph, time: float, x: Floats, p: Floats, z: Floats) -> Floats:
    """Minimum of the energy reached from a perturbed shape out of balance, beyond a fold of its equilibria."""
    return _Slope(graph, x, p, time).descended(z - _nudge(graph))


def _nudge(graph: Graph) -> Floats:
    """Downward perturbation, slightly larger on one side."""
    weight, size = np.abs(graph.algebraic.where) / 0.5, np.where(np.isin(graph.algebraic.kinds, "y"), _NUDGE, 0.0)
    return np.asarray(size * (1 - weight**2) * (1 + 0.1 * np.sign(graph.algebraic.where)))


class _Slope:
    """Energy of the filament, and implicit steps along its negative gradient."""

    def __init__(self, graph: Graph, x: Floats, p: Floats, time: float = 0.0) -> None:
        self._x, self._p, self._time, self._observables = x, p, time, graph.symbolic.observables
        pace = ca.SX.sym("pace")
        matrix = ca.SX.eye(len(graph.straight)) / pace - ca.jacobian(graph.symbolic.alg, graph.symbolic.z)
        self._system = ca.Function(
            "system",
            [graph.symbolic.t, graph.symbolic.x, graph.symbolic.z, graph.symbolic.p, pace],
            [graph.symbolic.alg, matrix],
        )
        self._stiffness = Stiffness(self._system.sparsity_out(1))

    def energy(self, z: Floats) -> float:
        """Stored energy per undeformed area."""
        observed = self._observables(time=self._time, state=self._x, algebraic=z, parameters=self._p)
        names = (name for name in observed if name.startswith("energy_") and name != "energy_kinetic")
        return sum(float(observed[name]) for name in names)

    def descended(self, start: Floats) -> Floats:
        """Minimum of the energy reached from a shape.

        The first step is as short as that of an explicit method: stiff modes come to rest before the steps become long
        enough to end on a saddle.
        """
        _, matrix = self._system(self._time, self._x, start, self._p, 1.0)
        pace = 1 / float(np.max(np.abs(np.diag(np.asarray(matrix)))))
        best, lowest = start, self.energy(start)
        for _ in range(_SETTLING_ITERATIONS):
            force, matrix = self._system(self._time, self._x, best, self._p, pace)
            step = self._stiffness.factorise(matrix).step(force)
            if step is None:
                pace *= _SHRINKAGE
                continue
            size = float(np.max(np.abs(step)))
            if size < _SETTLED and pace > 1:
                return best + step
            energy = self.energy(best + step)
            if size > _LARGEST or not energy <= lowest + _SETTLING_ROUNDING * abs(lowest):
                pace *= _SHRINKAGE
                continue
            best, lowest, pace = best + step, energy, pace * _GROWTH
        return best
