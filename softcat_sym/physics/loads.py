"""Gravity as a function of time, and the energy that surface tension puts into the filament's surface."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.kinematics import axial_force
from softcat_sym.physics.kinematics import stretch as stretch_field
from softcat_sym.physics.necking import aspect, tension
from softcat_sym.physics.symbols import A0, ACCELERATION, ONE, a_g, enter, enter_field, f_g, g, g_on, h0, s, t

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


LOADING_EQUATIONS: tuple[Equation, ...] = (
    Equation("gravity ramp", gravity, ramped_gravity(), "section 3"),
    Equation("rate of the gravity ramp", sp.Derivative(gravity, t), ramp_rate(), "section 3"),
    Equation("shaking of gravity", shake, shaking(), "Rayleigh 1877"),
    Equation("rate of the shaking", sp.Derivative(shake, t), shaking_rate(), "Rayleigh 1877"),
)

surface_tension = enter("gamma_s", r"\gamma", (1, 0, -2), "surface tension", "Eggers & Dupont 1994", positive=True)


@dataclass(frozen=True, slots=True)
class Surface:
    """Surface of one shape of section."""

    name: str  # Section, as in the scene
    # Gam, axial force over area at s = 1: gamma P_0/(2 A_0) where the whole perimeter shrinks, 2 gamma/h_0 of a
    # sheet, whose width is held.
    pressure: sp.Expr
    shrinks: bool = True  # Whether the perimeter shrinks as the filament stretches

    def energy(self) -> sp.Expr:
        """Energy per unit undeformed volume [Pa], gamma times the lateral area over A_0: 2 Gam sqrt(s), sheet Gam s."""
        return 2 * self.pressure * sp.sqrt(s) if self.shrinks else self.pressure * s

    def force(self) -> sp.Expr:
        """Axial force over undeformed area [Pa], conjugate to the stretch."""
        return sp.diff(self.energy(), s)


RECTANGLE = Surface("rectangle", surface_tension / h0 * (1 + 1 / aspect))
CIRCLE = Surface("circle", 2 * surface_tension / h0)
SHEET = Surface("sheet", 2 * surface_tension / h0, shrinks=False)

SURFACES: dict[str, Surface] = {surface.name: surface for surface in (RECTANGLE, CIRCLE, SHEET)}

SURFACE_EQUATIONS: tuple[Equation, ...] = tuple(
    Equation(
        f"axial force with surface tension, {surface.name}",
        axial_force,
        tension + A0 * surface.force().subs(s, stretch_field),
        "Eggers & Dupont 1994",
    )
    for surface in SURFACES.values()
)
