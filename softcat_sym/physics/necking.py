"""The gradient term that stops a neck from gathering all strain in one place (THEORY 10).

The surface of a neck slopes, and the slope bends the stress: equilibrium across the filament puts the inside of a neck
under lateral tension, so that it carries more than its flow stress (Bridgman; Audoly & Hutchinson, JMPS 2016). To
leading order in slenderness the axial force gains - d/dX (b s_X), b = beta h0^2 T+/s^p. It is the work conjugate of a
density b s_X s_Xt, and it leaves the ends alone where s_X = 0.

Kept are the terms linear in s_XX, exact for any isotropic material, and of those quadratic in s_X the ones that the
conservative form brings along; :meth:`Neck.neglected` is what remains.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics import sections
from softcat_sym.physics.equation import Equation, Equations
from softcat_sym.physics.kinematics import axial_force, stretch
from softcat_sym.physics.laws import bingham_rate
from softcat_sym.physics.symbols import FORCE, ONE, PER_LENGTH, RATE, T, X, enter, enter_field, h0, s, sigma, t

s_slope = enter("s_slope", "s_{XX}", PER_LENGTH, "change of the stretch per unit material length", "THEORY 10")
s_slope_rate = enter("s_slope_rate", r"\dot s_{XX}", (0, -1, -1), "rate of s_slope", "THEORY 10")
aspect = enter("aspect", "D_0/h_0", ONE, "width over thickness of a rectangle", "THEORY 10", positive=True)
wavenumber = enter("wavenumber", "K", PER_LENGTH, "material wavenumber of a neck", "THEORY 10", positive=True)
neck_rate = enter("neck_rate", r"\gamma_n", RATE, "growth rate of the logarithm of a neck", "THEORY 10")
tension = enter_field("tension", "T", FORCE, "tension, area times mean stress", "2.10")(X, t)


@dataclass(frozen=True, slots=True)
class Neck:
    """The gradient term of one shape of section."""

    name: str  # Section, as in the scene
    beta: sp.Expr  # b = beta h0^2 T+/s^power
    power: int  # 4 where the section contracts both ways, 5 for a sheet
    # What the shear of the sloping fibres takes from the tension of a rigid-plastic filament, in b s_X^2/s.
    flow_loss: sp.Rational
    contraction: sections.Contraction  # How the section shrinks

    def stiffness(self) -> sp.Expr:
        """B of (T, s). Nothing in compression, where a bulge would be unstable at every wavelength."""
        return self.beta * h0**2 * sp.Max(T, 0) / s**self.power

    def double_force(self) -> sp.Expr:
        """B s_X, conjugate to the rate of s_X; the axial force gains minus its change per unit length."""
        return self.stiffness() * s_slope

    def force(self) -> sp.Expr:
        """What Q gains, - d/dX (b s_X), in the fields of the filament."""
        here = {T: tension, s: stretch}
        return -sp.Derivative(self.stiffness().subs(here) * sp.Derivative(stretch, X), X)

    def gradient_power(self) -> sp.Expr:
        """B s_X s_Xt, power per unit material length for the energy audit.

        It is not all dissipation: while T/s^p is steady it is the rate of b s_X^2/2, given back when a neck levels out.
        """
        return self.double_force() * s_slope_rate

    def neglected(self) -> sp.Expr:
        """Terms of Q quadratic in s_X that are left out, for a rigid-plastic filament."""
        return -(1 + self.flow_loss) * self.stiffness() * s_slope**2 / s

    def growth_rate(self, rate: sp.Expr) -> sp.Expr:
        """Growth rate of log s at a wavenumber, sigma phi'(sigma) (1 - beta (h k)^2)."""
        current = (self.contraction.thickness * wavenumber / s) ** 2
        return sigma * sp.diff(rate, sigma) * (1 - self.beta * current)

    def shortest_neck(self) -> sp.Expr:
        """Current wavelength 2 pi sqrt(beta) h: shorter necks do not grow."""
        return 2 * sp.pi * sp.sqrt(self.beta) * self.contraction.thickness


RECTANGLE = Neck(
    "rectangle", beta=(1 + aspect**2) / 48, power=4, flow_loss=sp.Rational(3, 2), contraction=sections.UNIFORM
)
PLANE_STRESS = Neck(
    "plane stress", beta=sp.Rational(1, 48), power=4, flow_loss=sp.Rational(3, 2), contraction=sections.UNIFORM
)
SQUARE = Neck("square", beta=sp.Rational(1, 24), power=4, flow_loss=sp.Rational(3, 2), contraction=sections.UNIFORM)
CIRCLE = Neck("circle", beta=sp.Rational(1, 32), power=4, flow_loss=sp.Rational(3, 2), contraction=sections.UNIFORM)
SHEET = Neck("sheet", beta=sp.Rational(1, 12), power=5, flow_loss=sp.Integer(2), contraction=sections.WIDE)

NECKS: dict[str, Neck] = {neck.name: neck for neck in (RECTANGLE, PLANE_STRESS, SQUARE, CIRCLE, SHEET)}


def folds(rate: sp.Expr) -> sp.Expr:
    """Sigma phi'(sigma) t: by how many e-folds a long neck grows while the section flows for a time t.

    The term matters once this exceeds log(accuracy/noise).
    """
    return sigma * sp.diff(rate, sigma) * t


def _equations(neck: Neck) -> tuple[Equation, ...]:
    here = {T: tension, s: stretch, s_slope: sp.Derivative(stretch, X)}
    return (
        Equation(f"axial force at a neck, {neck.name}", axial_force, tension + neck.force(), "THEORY 10"),
        Equation(f"growth of a neck, {neck.name}", neck_rate, neck.growth_rate(bingham_rate()), "THEORY 10"),
        Equation(
            f"axial force at a rigid-plastic neck, {neck.name}",
            axial_force,
            tension + neck.force() + neck.neglected().subs(here),
            "THEORY 10",
        ),
        Equation(f"shortest neck, {neck.name}", 2 * sp.pi / wavenumber, neck.shortest_neck() / s, "THEORY 10"),
    )


EQUATIONS = Equations(lambda: (equation for neck in NECKS.values() for equation in _equations(neck)))
