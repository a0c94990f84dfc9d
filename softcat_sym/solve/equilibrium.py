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
_ROUNDING = 1e-7
_LONGEST_STEP = 0.1


class Equilibrium:
    """Newton's method on 0 = alg(t, x, z, p), damped by what does not depend on how the equations are scaled.

    A step is shortened until the step that the same stiffness would take from its end is the shorter one (Deuflhard,
    Newton Methods for Nonlinear Problems, 2004, section 3.3: natural monotonicity).

    Parameters
    ----------
    graph : Graph
        A filament with algebraic unknowns.
    """

    def __init__(self, graph: Graph) -> None:
        # Only positions and angles make the equations nonlinear: velocities may be as large as they are.
        self._shape = np.isin(graph.z_kinds, ("x", "y", "psi"))
        self._bends = "bending" in graph.effects
        inputs = [graph.t, graph.x, graph.z, graph.p]
        # As built: a handful of evaluations is not worth the search for common subexpressions.
        alg = ca.densify(graph.raw.rates[1])
        jacobian = ca.jacobian(alg, graph.z)
        # Of a beam that does not stretch: the first whole step ends at the answer, however far that is.
        self._linear = not ca.depends_on(jacobian, graph.z)
        self._residual = ca.Function("residual", inputs, [alg])
        self._jacobian = ca.Function("jacobian", inputs, [jacobian])
        # Named, "qr" is the sparse solver; without a name the same factorisation is a thousand times slower.
        self._stiffness = ca.Linsol("stiffness", "qr", self._jacobian.sparsity_out(0))

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
        before = np.inf
        for _ in range(_ITERATIONS):
            stiffness = self._jacobian(time, x, z, p)
            step = self._step(stiffness, self._evaluate(time, x, z, p), factorise=True)
            if step is None:
                return None
            size = float(np.max(np.abs(step))) / max(1.0, float(np.max(np.abs(z + step), initial=0.0)))
            # Rounding of the positions times the axial stiffness, over that of bending: a thin filament stops short.
            if size < _TOLERANCE or (self._bends and size < _ROUNDING and size > 0.9 * before):
                return z + step
            before = size
            z = z + self._fraction(time, x, z, p, stiffness, step) * step
        return None

    def _step(self, stiffness: ca.DM, residual: Floats, *, factorise: bool = False) -> Floats | None:
        """Newton's step; None where the stiffness is singular, as of a straight string that does not bend."""
        try:
            if factorise:
                self._stiffness.sfact(stiffness)
                self._stiffness.nfact(stiffness)
            step = -np.asarray(self._stiffness.solve(stiffness, ca.DM(residual))).ravel()
        except RuntimeError:
            return None
        return step if np.all(np.isfinite(step)) else None

    def _fraction(self, time: float, x: Floats, z: Floats, p: Floats, stiffness: ca.DM, step: Floats) -> float:
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
                remains = self._step(stiffness, value)
                if remains is not None and float(np.linalg.norm(remains)) <= (1 - fraction / 4) * size:
                    return fraction
            fraction /= 2
        return longest

    def _evaluate(self, time: float, x: Floats, z: Floats, p: Floats) -> Floats:
        return np.asarray(self._residual(time, x, z, p), dtype=float).ravel()


def sagging_guesses(graph: Graph, straight: Floats, sag: float) -> list[Floats]:
    """Parabolas around the sag (over span) expected, and the straight filament."""
    is_height = np.array([kind == "y" for kind in graph.z_kinds])
    parabola = np.where(is_height, -(1 - 4 * graph.z_where**2), 0.0)
    return [straight + depth * parabola for depth in (sag, sag / 4, 0.0, 3 * sag)]
