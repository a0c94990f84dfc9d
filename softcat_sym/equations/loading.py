"""Gravity as a function of time: at once, or by the paper's smooth ramp (section 3)."""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import ACCELERATION, enter_field, g, g_on, t

gravity = enter_field("gravity", "g(t)", ACCELERATION, "gravity while it is switched on", "section 3")(t)


def quintic_step(u: sp.Expr) -> sp.Expr:
    """Smooth step 10 u^3 - 15 u^4 + 6 u^5, 0 before u = 0 and 1 after u = 1, with two continuous derivatives."""
    v = sp.Min(sp.Max(u, 0), 1)
    return v**3 * (10 + v * (6 * v - 15))


def ramped_gravity() -> sp.Expr:
    """g(t) switched on over 0 < t < g_on."""
    return g * quintic_step(t / g_on)


def ramp_rate() -> sp.Expr:
    """dg/dt of :func:`ramped_gravity`, whose power on the filament is external work."""
    v = sp.Min(sp.Max(t / g_on, 0), 1)
    return g * 30 * v**2 * (1 - v) ** 2 / g_on


EQUATIONS: tuple[Equation, ...] = (
    Equation("gravity ramp", gravity, ramped_gravity(), "section 3"),
    Equation("rate of the gravity ramp", sp.Derivative(gravity, t), ramp_rate(), "section 3"),
)
