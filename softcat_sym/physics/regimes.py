"""Groups of a filament, straight beams and catenaries as expressions (3.9)-(3.14).

:mod:`softcat_sym.physics.beams` has the limits of the regimes in numbers; derivations/05_regimes.py derives them.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics import beams
from softcat_sym.physics.equation import Equation
from softcat_sym.physics.sections import Section
from softcat_sym.physics.symbols import LENGTH, ONE, STRESS, L, enter, g, rho

Rational = sp.Rational

delta = enter("delta", r"\delta", ONE, "slenderness h_0/L", "3.9", positive=True)
V = enter("V", "V", ONE, "viscous number eta/(rho sqrt(g L^3))", "3.10", positive=True)
E_star = enter("E_star", "E^*", ONE, "modulus over weight E/(rho g L)", "THEORY 5", positive=True)
tau_star = enter("tau_star", r"\tau^*", ONE, "relaxation time eta/E in units of sqrt(L/g)", "2.18", positive=True)
H = enter("H", "H", LENGTH, "sag of the midpoint", "section 3.2", positive=True)
u_L = enter("u_L", "u", ONE, "half span over catenary parameter, L/(2a)", "3.12", positive=True)
sigma_max = enter("sigma_max", r"\sigma_{max}", STRESS, "largest tensile stress of a catenary", "3.12", positive=True)
psi_T = enter("psi_T", r"\psi", ONE, "(L/2) sqrt(T/(E I)): how far tension carries a beam", "3.11", positive=True)
K_I = enter("K_I", "K", ONE, "form factor of the section, I = K A h^2", "2.18", positive=True)


@dataclass(frozen=True, slots=True)
class Beam:
    """A straight beam of span L under its own weight q per length, by the way its ends are held."""

    largest_moment: sp.Expr  # Largest static bending moment over q L^2
    midspan_sag: sp.Expr  # Static elastic sag at midspan over q L^4/(E I)
    # Bound on the largest moment over the static one, when the weight is applied at once and no mode is damped: the
    # moment that all modes add up to when all are at their worst.
    overshoot_bound: sp.Expr
    collapse: sp.Expr  # q L^2 over the fully plastic moment when enough hinges have formed for the beam to give way
    # Share of the largest static moment that a steady tension, such as that of the surface, leaves; of psi.
    relief: sp.Expr = sp.S.One


CLAMPED = Beam(Rational(1, 12), Rational(1, 384), sp.Integer(2), sp.Integer(16), beams.clamped_relief(psi_T, sp))
PROPPED = Beam(Rational(1, 8), Rational(1, 192), sp.Integer(2), 6 + 4 * sp.sqrt(2), beams.propped_relief(psi_T, sp))
PINNED = Beam(
    Rational(1, 8), Rational(5, 384), 1 + 28 * sp.zeta(3) / sp.pi**3, sp.Integer(8), beams.pinned_relief(psi_T, sp)
)

CANTILEVER = Beam(Rational(1, 2), Rational(17, 384), sp.Integer(2), sp.Integer(2))
"""One end clamped, the other free; the sag is that of the middle."""

BEAMS: dict[tuple[str, str], Beam] = {
    ("clamped", "clamped"): CLAMPED,
    ("clamped", "pinned"): PROPPED,
    ("pinned", "pinned"): PINNED,
}
NAMED: dict[str, Beam] = {"clamped": CLAMPED, "propped": PROPPED, "pinned": PINNED, "cantilever": CANTILEVER}
"""By the names that they have in numbers."""


def gyration(section: Section) -> sp.Expr:
    """K = I/(A h_0^2) = <zeta^2>/4: 1/12 for a rectangle, 1/16 for a circle (before 2.18)."""
    return section.zeta_squared / 4


# The catenary y = a (cosh(x/a) - cosh(L/2a)) between level supports; u = L/(2a).
CATENARY_SAG = Equation("sag of a catenary", H, L * (sp.cosh(u_L) - 1) / (2 * u_L), "before 3.12")
SHALLOW_STRESS = Equation("stress of a shallow catenary", sigma_max, rho * g * (H + L**2 / (8 * H)), "before 3.12")
