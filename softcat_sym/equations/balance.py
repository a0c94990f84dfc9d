"""Balance of momentum in conservative form (THEORY 2; equations 2.1-2.4 of the paper, corrected).

lambda_0 x_tt = d/dX (Q t + N n) - lambda_0 g e_y,   N = M_X / s.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.kinematics import Kinematics
from softcat_sym.equations.symbols import A0, FORCE, M_X, Q, enter, rho, s, theta

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


EQUATIONS: tuple[Equation, ...] = (
    Equation("internal force, horizontal", F_x, Q * sp.cos(theta) - M_X / s * sp.sin(theta), "2.4"),
    Equation("internal force, vertical", F_y, Q * sp.sin(theta) + M_X / s * sp.cos(theta), "2.4"),
)
