"""The gradient term that stops a neck from gathering all strain in one place (THEORY 10).

The surface of a neck slopes, and the slope bends the stress: equilibrium across the filament puts the inside of a neck
under lateral tension, so that it carries more than its flow stress (Bridgman; Audoly & Hutchinson, JMPS 2016). To
leading order in slenderness the axial force gains - d/dX (b s_X), b = beta h0^2 T+/s^p. It is the work conjugate of a
density b s_X s_Xt, and it leaves the ends alone where s_X = 0.

Kept are the terms linear in s_XX, exact for any isotropic material, and of those quadratic in s_X the ones that the
conservative form brings along; derivations/08_necking.py says what remains.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics.cross_sections import CROSS_SECTIONS
from softcat_sym.physics.symbols import ONE, PER_LENGTH, T, enter, h0, s

s_slope = enter("s_slope", "s_{XX}", PER_LENGTH, "change of the stretch per unit material length", "THEORY 10")
aspect = enter("aspect", "D_0/h_0", ONE, "width over thickness of a rectangle", "THEORY 10", positive=True)


@dataclass(frozen=True, slots=True)
class Neck:
    """The gradient term of one shape of section."""

    name: str  # Section, as in the scene
    beta: sp.Expr  # b = beta h0^2 T+/s^power
    power: int  # 4 where the section contracts both ways, 5 for a sheet

    def stiffness(self) -> sp.Expr:
        """B of (T, s). Nothing in compression, where a bulge would be unstable at every wavelength."""
        return self.beta * h0**2 * sp.Max(T, 0) / s**self.power

    def double_force(self) -> sp.Expr:
        """B s_X, conjugate to the rate of s_X; the axial force gains minus its change per unit length."""
        return self.stiffness() * s_slope


RECTANGLE = Neck("rectangle", beta=CROSS_SECTIONS["rectangle"].neck(aspect), power=4)
CIRCLE = Neck("circle", beta=sp.Rational(CROSS_SECTIONS["circle"].neck(aspect)), power=4)
SHEET = Neck("sheet", beta=sp.Rational(CROSS_SECTIONS["sheet"].neck(aspect)), power=5)

NECKS: dict[str, Neck] = {neck.name: neck for neck in (RECTANGLE, CIRCLE, SHEET)}
