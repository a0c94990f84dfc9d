"""Closed forms by which a printer judges a spanning filament: beams that bend or creep, and their stiffness.

All hold a straight, level, uniform filament of small sag. The beam bends only: the tension of a sag of the order of the
thickness, flow beyond a yield stress and shear are not in it.
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.regimes import CATENARY_SAG, PINNED, Beam, H, gyration, sigma_max, u_L
from softcat_sym.equations.section import CIRCLE, RECTANGLE, Section
from softcat_sym.equations.symbols import STRESS, E, L, enter, eta, g, h0, rho, t

Rational = sp.Rational

G_prime = enter("G_prime", "G'", STRESS, "shear storage modulus that a spanning ink needs", "Smay 2002", positive=True)

SMAY_SAG = Rational(1, 20)
"""Sag over diameter that Smay, Cesarano & Lewis (Langmuir 18, 5429 (2002)) allow a spanning filament."""


def beam_sag(section: Section, beam: Beam) -> sp.Expr:
    """Sag at midspan of an elastic beam at rest, C rho g A L^4/(E I): 5/384 between pins, 1/384 between clamps."""
    return beam.midspan_sag * rho * g * L**4 / (E * gyration(section) * h0**2)


def viscous_beam_sag(section: Section, beam: Beam) -> sp.Expr:
    """The same of a viscous beam a time t after it was let go (Trouton 1906): E becomes eta/t."""
    return beam.midspan_sag * rho * g * L**4 * t / (eta * gyration(section) * h0**2)


def largest_bending_stress(section: Section, beam: Beam) -> sp.Expr:
    """Stress of the outermost fibre of an elastic beam at rest: largest moment over section modulus (3.11)."""
    return beam.largest_moment * rho * g * L**2 / (2 * gyration(section) * h0)


def smay_modulus(beam: Beam = PINNED) -> sp.Expr:
    """Shear modulus with which a round beam sags by :data:`SMAY_SAG` of its diameter: 1.39 rho g (L/D)^4 D.

    Incompressible, E = 3 G'. Published as G' >= 1.4 rho g s^4 D with s = L/D, between pins; clamps ask for a fifth.
    """
    return beam_sag(CIRCLE, beam) * E / (3 * SMAY_SAG * h0)


def catenary_stress(sag: float, digits: int = 15) -> sp.Float:
    """Largest stress of the exact catenary over rho g L, from its sag over span: cosh(u)/(2 u).

    Raises
    ------
    ValueError
        If it does not sag.
    """
    if not sag > 0:
        raise ValueError(f"a catenary of sag {sag} carries no load")
    root = sp.nsolve(CATENARY_SAG.right / L - sag, u_L, sp.asinh(4 * sag), prec=digits + 5)
    return (sp.cosh(u_L) / (2 * u_L)).subs(u_L, root).n(digits)


EQUATIONS: tuple[Equation, ...] = (
    Equation("sag of an elastic beam between pins", H, beam_sag(RECTANGLE, PINNED), "2.14"),
    Equation("sag of a viscous beam between pins", H, viscous_beam_sag(RECTANGLE, PINNED), "2.14"),
    Equation("largest stress of an elastic beam", sigma_max, largest_bending_stress(RECTANGLE, PINNED), "3.11"),
    Equation("modulus of a spanning ink", G_prime, smay_modulus(), "Smay 2002"),
)
