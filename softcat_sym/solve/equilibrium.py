"""Static equilibrium of the algebraic unknowns, where a run without inertia begins."""

from __future__ import annotations

from collections.abc import Iterable

import casadi as ca
import numpy as np

from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats

_ITERATIONS = 60
_HALVINGS = 30
_TOLERANCE = 1e-10


class Equilibrium:
    """Newton's method with a line search on 0 = alg(t, x, z, p).

    Parameters
    ----------
    graph : Graph
        A filament without inertia.
    """

    def __init__(self, graph: Graph) -> None:
        self._graph = graph
        inputs = [graph.t, graph.x, graph.z, graph.p]
        self._residual = ca.Function("residual", inputs, [graph.alg])
        self._jacobian = ca.Function("jacobian", inputs, [ca.jacobian(graph.alg, graph.z)])

    def search(self, time: float, x: Floats, p: Floats, guesses: Iterable[Floats]) -> Floats | None:
        """Equilibrium reached from the first guess that leads to one; None if none does.

        Parameters
        ----------
        time : float
            In units of the time scale.
        x, p : ndarray
            Differential states and parameters.
        guesses : iterable of ndarray, shape (nz,)
            Where to begin.
        """
        for guess in guesses:
            z = self._newton(time, x, guess, p)
            if z is not None:
                return z
        return None

    def _newton(self, time: float, x: Floats, z: Floats, p: Floats) -> Floats | None:
        residual = self._evaluate(time, x, z, p)
        for _ in range(_ITERATIONS):
            step = self._step(time, x, z, p, residual)
            if step is None:
                return None
            if np.max(np.abs(step)) < _TOLERANCE:
                return z + step
            z, residual = self._damped(time, x, z, p, step, residual)
        return None

    def _step(self, time: float, x: Floats, z: Floats, p: Floats, residual: Floats) -> Floats | None:
        """Newton's step; None where the stiffness is singular, as of a straight string that does not bend."""
        try:
            # Named, "qr" is the sparse solver; without a name the same factorisation is a thousand times slower.
            step = -np.asarray(ca.solve(self._jacobian(time, x, z, p), ca.DM(residual), "qr")).ravel()
        except RuntimeError:
            return None
        return step if np.all(np.isfinite(step)) else None

    def _damped(
        self, time: float, x: Floats, z: Floats, p: Floats, step: Floats, residual: Floats
    ) -> tuple[Floats, Floats]:
        """Shorten the step until the residual falls; if it never does, take the whole step and hope for the next."""
        size = float(np.linalg.norm(residual))
        fraction = 1.0
        for _ in range(_HALVINGS):
            trial = z + fraction * step
            value = self._evaluate(time, x, trial, p)
            if np.all(np.isfinite(value)) and float(np.linalg.norm(value)) <= (1 - fraction / 10) * size:
                return trial, value
            fraction /= 2
        return z + step, self._evaluate(time, x, z + step, p)

    def _evaluate(self, time: float, x: Floats, z: Floats, p: Floats) -> Floats:
        return np.asarray(self._residual(time, x, z, p), dtype=float).ravel()


def sagging_guesses(graph: Graph, sag: float) -> list[Floats]:
    """The straight filament, and parabolas around the sag (over span) expected."""
    node_x = np.array([_position(name) for name in graph.algebraic_names])
    is_height = np.array([name.startswith("y") for name in graph.algebraic_names])
    parabola = np.where(is_height, -(1 - 4 * node_x**2), 0.0)
    return [graph.straight + depth * parabola for depth in (0.0, sag, sag / 4, 3 * sag)]


def _position(name: str) -> float:
    return float(name.rsplit("=", 1)[1])
