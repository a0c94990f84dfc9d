"""Equilibrium of a filament: Newton's method on what must vanish."""

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
    """A sparse matrix, factorised: steps are None where it is singular, as of a straight string that does not bend."""

    def __init__(self, sparsity: ca.Sparsity) -> None:
        # Named, "qr" is the sparse solver; without a name the same factorisation is a thousand times slower.
        self._solver = ca.Linsol("stiffness", "qr", sparsity)
        self._matrix: ca.DM | None = None

    def factorise(self, matrix: ca.DM) -> Stiffness:
        """Take a matrix; what is singular shows in the steps."""
        self._matrix = matrix
        try:
            self._solver.sfact(matrix)
            self._solver.nfact(matrix)
        except RuntimeError:
            self._matrix = None
        return self

    def step(self, force: Floats | ca.DM) -> Floats | None:
        """What the force displaces."""
        if self._matrix is None:
            return None
        try:
            step = np.asarray(self._solver.solve(self._matrix, ca.DM(force))).ravel()
        except RuntimeError:
            return None
        return step if np.all(np.isfinite(step)) else None


class Equilibrium:
    """Newton's method on 0 = alg(t, x, z, p), damped by what does not depend on how the equations are scaled.

    A step is shortened until the step that the same stiffness would take from its end is the shorter one (Deuflhard,
    Newton Methods for Nonlinear Problems, 2004, section 3.3: natural monotonicity).
    """

    def __init__(self, graph: Graph) -> None:
        # Only positions and angles make the equations nonlinear: velocities may be as large as they are.
        self._shape = np.isin(graph.z_kinds, _POSITIONS)
        self._bends = graph.terms.bending
        # Linear is a beam that does not stretch: the first whole step ends at the answer, however far that is.
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
            # Rounding of the positions times the axial stiffness, over that of bending: a thin filament stops short.
            if size < _TOLERANCE or (self._bends and size < _ROUNDING and size > 0.9 * before):
                return z + step
            before = size
            z = z + self._fraction(time, x, z, p, step) * step
        return None

    def _fraction(self, time: float, x: Floats, z: Floats, p: Floats, step: Floats) -> float:
        """Fraction of the step after which less remains; if there is none, the longest, in hope of the next."""
        if self._linear:
            return 1.0
        size = float(np.linalg.norm(step))
        # A straight string has next to no stiffness: its first step would end spans away, where elasticity softens.
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
    """As `Newton`, by CasADi."""
    return Equilibrium(graph).search(0.0, x, p, [guess])
