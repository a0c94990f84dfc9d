"""Kinematics of the centreline: stretch, turning and strain, exact (2.5, 2.6) or for small slopes (2.13)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import (
    s,
    theta,
    x_X,
    x_X_before,
    x_Xt,
    x_Xt_before,
    y_X,
    y_X_before,
    y_Xt,
    y_Xt_before,
)


@dataclass(frozen=True, slots=True)
class Kinematics:
    """How the tangent r_X = (x_X, y_X) of a cell gives its stretch, and two neighbours the angle between them.

    Attributes
    ----------
    stretch : sympy.Expr
        s as a function of (x_X, y_X).
    turning : sympy.Expr
        Angle from the tangent before a node to the one behind it.
    source : str
        Equation numbers.
    """

    stretch: sp.Expr
    turning: sp.Expr
    source: str

    def stretch_gradient(self) -> tuple[sp.Expr, sp.Expr]:
        """(ds/dx_X, ds/dy_X): the direction of the axial force Q. The unit tangent t when rotations are large."""
        return (self._by_stretch(sp.diff(self.stretch, x_X)), self._by_stretch(sp.diff(self.stretch, y_X)))

    def angle_gradient(self) -> tuple[sp.Expr, sp.Expr]:
        """(dtheta/dx_X, dtheta/dy_X): the direction of the transverse force M_X. n/s when rotations are large."""
        angle = self.turning.subs({x_X_before: 1, y_X_before: 0})
        return (self._by_stretch(sp.diff(angle, x_X)), self._by_stretch(sp.diff(angle, y_X)))

    def stretch_rate(self) -> sp.Expr:
        """Rate of the stretch, of the tangent and its rate."""
        return sp.diff(self.stretch, x_X) * x_Xt + sp.diff(self.stretch, y_X) * y_Xt

    def turning_rate(self) -> sp.Expr:
        """Rate of the angle between neighbouring tangents, of both tangents and their rates."""
        return _rate_of_turning(self.turning)

    def _by_stretch(self, expression: sp.Expr) -> sp.Expr:
        """Write the stretch as s where it occurs, so that it is computed once."""
        return _with_stretch(expression, self.stretch)


@cache
def _rate_of_turning(turning: sp.Expr) -> sp.Expr:
    pairs = ((x_X_before, x_Xt_before), (y_X_before, y_Xt_before), (x_X, x_Xt), (y_X, y_Xt))
    return sp.Add(*(sp.simplify(sp.diff(turning, of)) * rate for of, rate in pairs))


@cache
def _with_stretch(expression: sp.Expr, stretch: sp.Expr) -> sp.Expr:
    return sp.powsimp(expression).subs(stretch, s).subs(stretch**2, s**2)


# The turning angle is atan2(cross, dot) of neighbouring tangents, so that nothing wraps past the vertical.
LARGE_ROTATION = Kinematics(
    stretch=sp.sqrt(x_X**2 + y_X**2),
    turning=sp.atan2(x_X_before * y_X - y_X_before * x_X, x_X_before * x_X + y_X_before * y_X),
    source="2.5",
)

SMALL_SLOPE = Kinematics(stretch=x_X + y_X**2 / 2, turning=y_X - y_X_before, source="2.13")


@dataclass(frozen=True, slots=True)
class StrainMeasure:
    """Axial strain of the centreline as a function of the stretch, and what divides theta_X to give the curvature.

    Attributes
    ----------
    strain : sympy.Expr
        log s (true strain) or s - 1.
    arc_stretch : sympy.Expr
        theta_s = theta_X / arc_stretch.
    source : str
        Equation numbers.
    """

    strain: sp.Expr
    arc_stretch: sp.Expr
    source: str


TRUE_STRAIN = StrainMeasure(strain=sp.log(s), arc_stretch=s, source="2.6")
SMALL_STRAIN = StrainMeasure(strain=s - 1, arc_stretch=sp.Integer(1), source="2.13")

EQUATIONS: tuple[Equation, ...] = (
    Equation("stretch of a cell", s, LARGE_ROTATION.stretch, LARGE_ROTATION.source),
    Equation("tangent angle of a cell", theta, sp.atan2(y_X, x_X), LARGE_ROTATION.source),
    Equation("stretch of a cell at small slope", s, SMALL_SLOPE.stretch, SMALL_SLOPE.source),
    Equation("tangent angle of a cell at small slope", theta, y_X, SMALL_SLOPE.source),
)
