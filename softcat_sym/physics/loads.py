"""Gravity as a function of time, and the energy that surface tension puts into the filament's surface."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from softcat_sym.physics import sections
from softcat_sym.physics.necking import aspect, s_slope
from softcat_sym.physics.symbols import ONE, a_g, enter, f_g, g, g_on, h0, s, t


def quintic_step(u: sp.Expr) -> sp.Expr:
    """Smooth step 10 u^3 - 15 u^4 + 6 u^5, 0 before u = 0 and 1 after u = 1, with two continuous derivatives."""
    v = sp.Min(sp.Max(u, 0), 1)
    return v**3 * (10 + v * (6 * v - 15))


@cache
def ramped_gravity() -> sp.Expr:
    """g(t) switched on over 0 < t < g_on."""
    return g * quintic_step(t / g_on)


@cache
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


surface_tension = enter("gamma_s", r"\gamma", (1, 0, -2), "surface tension", "Eggers & Dupont 1994", positive=True)
h0_slope = enter(
    "h0_slope", r"h_{0,X}", ONE, "change of the undeformed thickness per unit material length", "THEORY 10"
)


@dataclass(frozen=True, slots=True)
class Sides:
    """A part of a section's outline: two sides that face each other, or the whole of a circle."""

    pull: sp.Expr  # Surface tension times this part of the undeformed perimeter, over A_0 [Pa]
    apart: sp.Expr  # How far they are from each other, undeformed
    slope: sp.Expr = h0_slope  # How that changes per unit material length


@dataclass(frozen=True, slots=True)
class Surface:
    """Surface of one shape of section: gamma times the lateral area is an energy of the centreline's stretch.

    The area is that of the outline along the filament, perimeter times sqrt(s^2 + R_X^2) of a circle, here to the
    second order of the slope R_X/s.
    """

    name: str  # Section, as in the scene
    sides: tuple[Sides, ...]
    contraction: sections.Contraction = sections.UNIFORM  # How the section shrinks; of a sheet the width is held

    def energy(self) -> sp.Expr:
        """Energy per unit undeformed volume [Pa] of a filament that does not change along its length.

        2 Gam sqrt(s) where the perimeter shrinks, Gam s of a sheet, with Gam = :attr:`pressure`.
        """
        return sp.Add(*(one.pull * self._shrunk() * s for one in self.sides))

    def gradient_energy(self) -> sp.Expr:
        """What the slope of the outline adds to it, of (s, s_X): Gam R_0^2 s_X^2/(4 s^(9/2)) of a circle."""
        return sp.Add(*(one.pull * self._shrunk() * self._tilt(one) ** 2 / (2 * s) for one in self.sides))

    @property
    def pressure(self) -> sp.Expr:
        """Gam, axial force over area at s = 1: gamma P_0/(2 A_0), of a sheet 2 gamma/h_0."""
        return self.force().subs(s, 1)

    @property
    def shrinks(self) -> bool:
        """Whether the perimeter shrinks as the filament stretches."""
        return self.contraction is not sections.WIDE

    def force(self) -> sp.Expr:
        """Axial force over undeformed area [Pa], conjugate to the stretch, where the outline does not slope."""
        return sp.diff(self.energy(), s)

    def slope_forces(self) -> tuple[sp.Expr, sp.Expr]:
        """Derivatives of the gradient part by s and by s_X; the axial force gains the first less d/dX of the second."""
        return sp.diff(self.gradient_energy(), s), sp.diff(self.gradient_energy(), s_slope)

    def _shrunk(self) -> sp.Expr:
        """Length of the outline over the undeformed one."""
        return 1 / sp.sqrt(s) if self.shrinks else sp.S.One

    def _tilt(self, of: Sides) -> sp.Expr:
        """By how much one of two sides leaves the centreline per unit material length, R_X of a circle."""
        across = self.contraction.thickness / h0
        return (of.slope * across + of.apart * sp.diff(across, s) * s_slope) / 2


_FACES, _WIDTH = Sides(2 * surface_tension / h0, h0), aspect * h0
# Along a profile the width stays.
RECTANGLE = Surface("rectangle", (_FACES, Sides(2 * surface_tension / _WIDTH, _WIDTH, sp.S.Zero)))
CIRCLE = Surface("circle", (Sides(4 * surface_tension / h0, h0),))
SHEET = Surface("sheet", (_FACES,), sections.WIDE)

SURFACES: dict[str, Surface] = {surface.name: surface for surface in (RECTANGLE, CIRCLE, SHEET)}
