"""Gravity as a function of time: at once, or by the paper's smooth ramp (section 3), steady or shaken."""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import ACCELERATION, ONE, a_g, enter_field, f_g, g, g_on, t

gravity = enter_field("gravity", "g(t)", ACCELERATION, "gravity while it is switched on", "section 3")(t)
shake = enter_field("shake", "S(t)", ONE, "oscillating gravity over what it would be at rest", "Rayleigh 1877")(t)


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


def shaking() -> sp.Expr:
    """Factor 1 + a sin(2 pi f t) of the gravity in a frame that is shaken up and down (Rayleigh 1877, section 46).

    At t = 0 it is one; an amplitude a > 1 turns gravity round once in every period.
    """
    return 1 + a_g * sp.sin(2 * sp.pi * f_g * t)


def shaking_rate() -> sp.Expr:
    """Derivative in time of :func:`shaking`."""
    return 2 * sp.pi * f_g * a_g * sp.cos(2 * sp.pi * f_g * t)


EQUATIONS: tuple[Equation, ...] = (
    Equation("gravity ramp", gravity, ramped_gravity(), "section 3"),
    Equation("rate of the gravity ramp", sp.Derivative(gravity, t), ramp_rate(), "section 3"),
    Equation("shaking of gravity", shake, shaking(), "Rayleigh 1877"),
    Equation("rate of the shaking", sp.Derivative(shake, t), shaking_rate(), "Rayleigh 1877"),
)
