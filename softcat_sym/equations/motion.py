"""Motion of the centreline as fields of the material coordinate and time: (2.1)-(2.5), with (2.4) corrected.

What stands here holds for any filament, whatever it is made of. A section pulls the part behind it with the force
F = Q t + N n, t = (cos theta, sin theta), n = (-sin theta, cos theta), and bends it with the moment M = <sigma z> A,
which is positive where the upper side is stretched. Q is the paper's T until a closure says otherwise (THEORY 4).
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.balance import mass_per_length
from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import FORCE, LENGTH, MOMENT, ONE, X, enter_field, g, t

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


def internal_force() -> tuple[sp.Expr, sp.Expr]:
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
        f"momentum, {name}",
        mass_per_length() * left,
        sp.Derivative(force, X) - mass_per_length() * pull,
        "THEORY 2",
    )
    for name, left, force, pull in zip(
        ("horizontal", "vertical"), acceleration, internal_force(), (sp.Integer(0), g), strict=True
    )
)
GEOMETRY = _geometry()

EQUATIONS: tuple[Equation, ...] = (TANGENTIAL, TRANSVERSE, MOMENT_BALANCE, *MOTION, *CONSERVATIVE, *GEOMETRY)
