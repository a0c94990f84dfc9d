"""The surface of the filament and the energy that surface tension puts into it.

A bent tube has the lateral area of a straight one (Pappus), and one that shears that of its centreline up to a fourth
power of the shear: the area is a function of the stretch of the centreline alone, so that surface tension brings an
axial force along its tangent, and neither a moment nor a transverse force. That the outline slopes where the stretch
changes is left out, of the order (R/L)^2.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.motion import axial_force
from softcat_sym.equations.motion import stretch as stretch_field
from softcat_sym.equations.necking import aspect, tension
from softcat_sym.equations.symbols import A0, enter, h0, s

surface_tension = enter("gamma_s", r"\gamma", (1, 0, -2), "surface tension", "Eggers & Dupont 1994", positive=True)


@dataclass(frozen=True, slots=True)
class Surface:
    """Surface of one shape of section.

    Attributes
    ----------
    name : str
        Section, as in the scene.
    pressure : sympy.Expr
        Gam, axial force over area at s = 1: gamma P_0/(2 A_0) where the whole perimeter shrinks, 2 gamma/h_0 of a
        sheet, whose width is held.
    shrinks : bool
        Whether the perimeter shrinks as the filament stretches.
    """

    name: str
    pressure: sp.Expr
    shrinks: bool = True

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

EQUATIONS: tuple[Equation, ...] = tuple(
    Equation(
        f"axial force with surface tension, {surface.name}",
        axial_force,
        tension + A0 * surface.force().subs(s, stretch_field),
        "Eggers & Dupont 1994",
    )
    for surface in SURFACES.values()
)
