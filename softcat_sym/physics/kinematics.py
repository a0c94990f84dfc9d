"""Kinematics of the centreline and its balance of momentum (THEORY 2; equations 2.1-2.6)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from softcat_sym.physics.symbols import (
    A0,
    FORCE,
    M_X,
    Q,
    enter,
    rho,
    s,
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
    """How the tangent r_X = (x_X, y_X) of a cell gives its stretch, and two neighbours the angle between them."""

    stretch: sp.Expr  # s as a function of (x_X, y_X)
    turning: sp.Expr  # Angle from the tangent before a node to the one behind it
    source: str  # Equation numbers

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
    """Axial strain of the centreline as a function of the stretch, and what divides theta_X to give the curvature."""

    strain: sp.Expr  # log s (true strain) or s - 1
    arc_stretch: sp.Expr  # theta_s = theta_X / arc_stretch
    source: str  # Equation numbers


TRUE_STRAIN = StrainMeasure(strain=sp.log(s), arc_stretch=s, source="2.6")
SMALL_STRAIN = StrainMeasure(strain=s - 1, arc_stretch=sp.Integer(1), source="2.13")

F_x = enter("F_x", "F_x", FORCE, "horizontal component of the internal force", "2.4")
F_y = enter("F_y", "F_y", FORCE, "vertical component of the internal force", "2.4")


@dataclass(frozen=True, slots=True)
class InternalForce:
    """Force (F_x, F_y) that the filament behind a section exerts on the filament before it.

    Written through the gradients of stretch and angle, so that its power is Q s_t + M_X theta_t whatever the
    kinematics; for large rotations it is Q t + (M_X/s) n.
    """

    horizontal: sp.Expr
    vertical: sp.Expr


def internal_force(kinematics: Kinematics, *, bending: bool, stretches: bool = True) -> InternalForce:
    """Q grad s + M_X grad theta: without the first part when it does not stretch, the second when it does not bend."""
    along = kinematics.stretch_gradient()
    across = kinematics.angle_gradient()
    tension = Q if stretches else sp.Integer(0)
    moment_change = M_X if bending else sp.Integer(0)
    return InternalForce(
        horizontal=tension * along[0] + moment_change * across[0],
        vertical=tension * along[1] + moment_change * across[1],
    )


def mass_per_length() -> sp.Expr:
    """lambda_0 = rho A_0, mass per unit material length."""
    return rho * A0
