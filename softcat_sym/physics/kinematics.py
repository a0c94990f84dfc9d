"""Kinematics of the centreline and its balance of momentum (THEORY 2; equations 2.1-2.6)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.symbols import (
    A0,
    FORCE,
    LENGTH,
    M_X,
    MOMENT,
    ONE,
    Q,
    X,
    enter,
    enter_field,
    g,
    rho,
    s,
    t,
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

KINEMATICS_EQUATIONS: tuple[Equation, ...] = (
    Equation("stretch of a cell", s, LARGE_ROTATION.stretch, LARGE_ROTATION.source),
    Equation("tangent angle of a cell", theta, sp.atan2(y_X, x_X), LARGE_ROTATION.source),
    Equation("stretch of a cell at small slope", s, SMALL_SLOPE.stretch, SMALL_SLOPE.source),
    Equation("tangent angle of a cell at small slope", theta, y_X, SMALL_SLOPE.source),
)

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


BALANCE_EQUATIONS: tuple[Equation, ...] = (
    Equation("internal force, horizontal", F_x, Q * sp.cos(theta) - M_X / s * sp.sin(theta), "2.4"),
    Equation("internal force, vertical", F_y, Q * sp.sin(theta) + M_X / s * sp.cos(theta), "2.4"),
)

_at = (X, t)

x = enter_field("position_x", "x", LENGTH, "horizontal position of the centreline", "2.1")(*_at)
y = enter_field("position_y", "y", LENGTH, "height of the centreline", "2.1")(*_at)
stretch = enter_field("stretch", "s_X", ONE, "stretch of the centreline", "2.5")(*_at)
angle = enter_field("angle", r"\theta", ONE, "tangent angle from the horizontal", "2.5")(*_at)
axial_force = enter_field("axial_force", "Q", FORCE, "force along the tangent", "2.1")(*_at)
transverse_force = enter_field("transverse_force", "N", FORCE, "force along the normal", "2.1")(*_at)
moment = enter_field("moment", "M", MOMENT, "bending moment", "2.3")(*_at)

tangent = (sp.cos(angle), sp.sin(angle))
normal = (-sp.sin(angle), sp.cos(angle))
acceleration = (sp.Derivative(x, (t, 2)), sp.Derivative(y, (t, 2)))


def along(direction: tuple[sp.Expr, sp.Expr], vector: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """Component of a vector."""
    return direction[0] * vector[0] + direction[1] * vector[1]


def by_arclength(field: sp.Expr) -> sp.Expr:
    """d/ds = (1/s_X) d/dX."""
    return sp.Derivative(field, X) / stretch


def shear_force() -> sp.Expr:
    """N = M_s = M_X/s (2.3)."""
    return by_arclength(moment)


def net_force() -> tuple[sp.Expr, sp.Expr]:
    """Tangential and normal force per unit material length, the column of (2.4) without gravity.

    The paper's second entry lacks the factor 1/s of its first two terms: N_X = (M_XX - M_X s_X/s)/s.
    """
    turning, change = sp.Derivative(angle, X), sp.Derivative(moment, X)
    return (
        sp.Derivative(axial_force, X) - change * turning / stretch,
        (sp.Derivative(moment, (X, 2)) - change * sp.Derivative(stretch, X) / stretch) / stretch
        + axial_force * turning,
    )


def corrected_acceleration() -> tuple[sp.Expr, sp.Expr]:
    """x_tt and y_tt of (2.4); the paper's matrix is the transpose, which turns the forces the wrong way."""
    tangential, transverse = net_force()
    weight = mass_per_length() * g
    column = (tangential - weight * sp.sin(angle), transverse - weight * sp.cos(angle))
    return (
        (sp.cos(angle) * column[0] - sp.sin(angle) * column[1]) / mass_per_length(),
        (sp.sin(angle) * column[0] + sp.cos(angle) * column[1]) / mass_per_length(),
    )


def internal_force_field() -> tuple[sp.Expr, sp.Expr]:
    """Q t + (M_X/s) n, whose divergence moves the filament (THEORY 2)."""
    return tuple(axial_force * a + shear_force() * b for a, b in zip(tangent, normal, strict=True))


def _balance_of_an_arc() -> tuple[Equation, Equation, Equation]:
    density = mass_per_length() / stretch
    bend = by_arclength(angle)
    return (
        Equation(
            "force along the tangent",
            by_arclength(axial_force) - transverse_force * bend - density * g * sp.sin(angle),
            density * along(tangent, acceleration),
            "2.1",
        ),
        Equation(
            "force along the normal",
            by_arclength(transverse_force) + axial_force * bend - density * g * sp.cos(angle),
            density * along(normal, acceleration),
            "2.2",
        ),
        Equation("moment", transverse_force, shear_force(), "2.3"),
    )


def _geometry() -> tuple[Equation, ...]:
    x_X, y_X = sp.Derivative(x, X), sp.Derivative(y, X)
    x_XX, y_XX = sp.Derivative(x, (X, 2)), sp.Derivative(y, (X, 2))
    return (
        Equation("stretch", stretch, sp.sqrt(x_X**2 + y_X**2), "2.5"),
        Equation("change of the stretch", sp.Derivative(stretch, X), (x_X * x_XX + y_X * y_XX) / stretch, "2.5"),
        Equation("tangent angle", angle, sp.atan2(y_X, x_X), "2.5"),
        Equation("turning", sp.Derivative(angle, X), (x_X * y_XX - y_X * x_XX) / stretch**2, "2.5"),
    )


TANGENTIAL, TRANSVERSE, MOMENT_BALANCE = _balance_of_an_arc()
MOTION = tuple(
    Equation(f"acceleration, {name}", left, right, "2.4, corrected")
    for name, left, right in zip(("horizontal", "vertical"), acceleration, corrected_acceleration(), strict=True)
)
CONSERVATIVE = tuple(
    Equation(
        f"momentum, {name}", mass_per_length() * left, sp.Derivative(force, X) - mass_per_length() * pull, "THEORY 2"
    )
    for name, left, force, pull in zip(
        ("horizontal", "vertical"), acceleration, internal_force_field(), (sp.Integer(0), g), strict=True
    )
)
GEOMETRY = _geometry()

MOTION_EQUATIONS: tuple[Equation, ...] = (TANGENTIAL, TRANSVERSE, MOMENT_BALANCE, *MOTION, *CONSERVATIVE, *GEOMETRY)
