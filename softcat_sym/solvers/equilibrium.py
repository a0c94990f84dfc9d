"""Equilibrium of a filament by Newton's method on the residual forces."""

from __future__ import annotations

from collections.abc import Iterable

import casadi as ca
import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats

_ITERATIONS = 60
_HALVINGS = 30
_TOLERANCE = 1e-10
_ROUNDING = 1e-7
_LONGEST_STEP = 0.1

_POSITIONS = ("x", "y", "z", "psi", "q0", "q1", "q2", "q3")


class Stiffness:
    """A factorised sparse matrix; steps are None if it is singular, as for a straight string without bending."""

    def __init__(self, sparsity: ca.Sparsity) -> None:
        # The name "qr" selects the sparse solver; the default factorisation is a thousand times slower.
        self._solver = ca.Linsol("stiffness", "qr", sparsity)
        self._matrix: ca.DM | None = None

    def factorise(self, matrix: ca.DM) -> Stiffness:
        """Factorise a matrix; if it is singular, the next steps are None."""
        self._matrix = matrix
        try:
            self._solver.sfact(matrix)
            self._solver.nfact(matrix)
        except RuntimeError:
            self._matrix = None
        return self

    def step(self, force: Floats | ca.DM) -> Floats | None:
        """Displacement by a force."""
        if self._matrix is None:
            return None
        try:
            step = np.asarray(self._solver.solve(self._matrix, ca.DM(force))).ravel()
        except RuntimeError:
            return None
        return step if np.all(np.isfinite(step)) else None


class Equilibrium:
    """Newton's method on 0 = alg(t, x, z, p), with a damping that does not depend on the scaling of the equations.

    A step is shortened until the next step with the same stiffness would be the shorter one (Deuflhard, Newton Methods
    for Nonlinear Problems, 2004, section 3.3: natural monotonicity).
    """

    def __init__(self, graph: Graph) -> None:
        # Only positions and angles make the equations nonlinear: steps of velocities are not limited.
        self._shape = np.isin(graph.algebraic.kinds, _POSITIONS)
        self._bends = graph.terms.bending
        # For a linear beam without stretch the first full step gives the solution.
        self._residual, self._jacobian, self._linear = graph.symbolic.balance
        self._stiffness = Stiffness(self._jacobian.sparsity_out(0))

    def search(self, time: float, x: Floats, p: Floats, guesses: Iterable[Floats]) -> Floats | None:
        """Equilibrium reached from the first guess that leads to one; None if none does."""
        return next((z for guess in guesses if (z := self._newton(time, x, guess, p)) is not None), None)

    def _newton(self, time: float, x: Floats, z: Floats, p: Floats) -> Floats | None:
        before = np.inf
        for _ in range(_ITERATIONS):
            self._stiffness.factorise(self._jacobian(time, x, z, p))
            step = self._stiffness.step(-self._evaluate(time, x, z, p))
            if step is None:
                return None
            size = float(np.max(np.abs(step))) / max(1.0, float(np.max(np.abs(z + step), initial=0.0)))
            # Rounding of positions, times the axial over the bending stiffness, limits the accuracy of thin filaments.
            if size < _TOLERANCE or (self._bends and size < _ROUNDING and size > 0.9 * before):
                return z + step
            before = size
            z = z + self._fraction(time, x, z, p, step) * step
        return None

    def _fraction(self, time: float, x: Floats, z: Floats, p: Floats, step: Floats) -> float:
        """Largest tested fraction of the step that shortens the next step; the longest if there is none."""
        if self._linear:
            return 1.0
        size = float(np.linalg.norm(step))
        # A straight string has hardly any stiffness: its first full step would be several spans long.
        reach = float(np.max(np.abs(step[self._shape]), initial=0.0))
        longest = fraction = min(1.0, _LONGEST_STEP / reach) if reach > 0 else 1.0
        for _ in range(_HALVINGS):
            value = self._evaluate(time, x, z + fraction * step, p)
            if np.all(np.isfinite(value)):
                remains = self._stiffness.step(-value)
                if remains is not None and float(np.linalg.norm(remains)) <= (1 - fraction / 4) * size:
                    return fraction
            fraction /= 2
        return longest

    def _evaluate(self, time: float, x: Floats, z: Floats, p: Floats) -> Floats:
        return np.asarray(self._residual(time, x, z, p), dtype=float).ravel()


def newton_of_graph(graph: Graph, x: Floats, p: Floats, guess: Floats) -> Floats | None:
    """Solve as `Newton`, by CasADi."""
    return Equilibrium(graph).search(0.0, x, p, [guess])
