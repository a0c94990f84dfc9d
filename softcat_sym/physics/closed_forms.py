"""Closed forms: a sagging Maxwell filament in limits (2.20-2.22), strings, spanning beams, shear data as tension."""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics.beams import PINNED, Beam
from softcat_sym.physics.constitutive_laws import K, n
from softcat_sym.physics.regimes import CATENARY_SAG, K_I, delta, gyration, tau_star, u_L
from softcat_sym.physics.rheometry import B, alpha, t_high, t_star
from softcat_sym.physics.sections import CIRCLE, Section
from softcat_sym.physics.symbols import ONE, E, L, enter, eta, g, h0, rho, t

Rational = sp.Rational

phi = enter("phi", r"\phi", ONE, "factor of the parabola, four times the sag", "2.20", positive=True)

TOLERANCE = Rational(1, 15)
"""The paper's alpha."""

FREE_FALL = -(t_star**2) / 2
"""Midpoint before the supports are felt."""

EARLY_RATIO = (
    Rational(16, 3)
    * t_star**2
    / B
    * (t_star**3 - 3 * tau_star * t_star**2 + 6 * tau_star**2 * (t_star - tau_star * (1 - sp.exp(-t_star / tau_star))))
)
"""Tension over inertia on the freely falling parabola, for any t/tau: 16 t^5/(3B) late, 4 t^6/(3 B tau) early."""

T_LOW_LONG = (3 * B * alpha / 16) ** Rational(1, 5)
"""End of free fall if it is much longer than the relaxation time (the paper's only case)."""

T_LOW_SHORT = (3 * B * tau_star * alpha / 4) ** Rational(1, 6)
"""End of free fall if it is much shorter than the relaxation time: the filament is still elastic."""

OUTER_TIME = tau_star * sp.log(phi) + phi**3 / (9 * B)
"""Time as a function of phi without inertia and bending, as printed: one of a family that time shifts (2.20)."""

ELASTIC_START = (6 * B * tau_star) ** Rational(1, 3)
"""phi to which an elastic string without inertia sags at once."""

OUTER_TIME_FROM_REST = tau_star * sp.log(phi / ELASTIC_START) + (phi**3 - ELASTIC_START**3) / (9 * B)
"""The one member of that family that satisfies (2.20) with its integral from t = 0: phi(0) = ELASTIC_START."""

THIRD_LAW_FACTOR = (9 * B * t_star) ** Rational(1, 3)
"""phi long after the relaxation time."""

THIRD_LAW = -THIRD_LAW_FACTOR / 4
"""Midpoint long after the relaxation time: the viscous string, sag^3 = 9 rho g L^4 t/(128 eta)."""

T_HIGH = (B / 3) ** Rational(1, 5) * (6 * alpha) ** Rational(-3, 5)
"""Start of the 1/3 law."""

OSCILLATION = (tau_star, sp.Integer(1), 6 * (3 * t_star**2 / B) ** Rational(1, 3))
"""Coefficients of f''', f'' and f' in (2.21), a small departure from the 1/3 law."""

FREQUENCY = sp.sqrt(24 * tau_star * (3 * t_high**2 / B) ** Rational(1, 3) - 1) / (2 * tau_star)
"""R, angular frequency of (2.21) with its coefficient frozen at t_high."""

DECAY_RATE = 1 / (2 * tau_star)
"""Of (2.22)."""

TENSION_TO_BENDING = (phi / (4 * delta)) ** 2 / (18 * K_I)
"""Load borne by tension over load borne by bending in an elastic filament with clamped ends: (2/3)(sag/h)^2 of a
rectangle. While a viscous filament flows it is twice that."""


def power_law_string_sag() -> sp.Expr:
    """H(t) of a string of a power-law fluid that hangs straight at t = 0.

    H = [ (2n+1)/n (3 L^2/16) (rho g L^2/(8 K))^(1/n) t ]^(n/(2n+1)).
    """
    growth = (2 * n + 1) / n * Rational(3, 16) * L**2 * (rho * g * L**2 / (8 * K)) ** (1 / n)
    return (growth * t) ** (n / (2 * n + 1))


def viscous_string_sag() -> sp.Expr:
    """H(t) of a string of a viscous fluid: H^3 = 9 rho g L^4 t/(128 eta) (2.20)."""
    return sp.cbrt(Rational(9, 128) * rho * g * L**4 * t / eta)


def elastic_string_sag() -> sp.Expr:
    """H of an elastic string at rest: H^3 = 3 rho g L^4/(64 E)."""
    return sp.cbrt(Rational(3, 64) * rho * g * L**4 / E)


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
    """Largest stress of the exact catenary over rho g L, from its sag over span: cosh(u)/(2 u)."""
    if not sag > 0:
        raise ValueError(f"a catenary of sag {sag} carries no load")
    root = sp.nsolve(CATENARY_SAG.right / L - sag, u_L, sp.asinh(4 * sag), prec=digits + 5)
    return (sp.cosh(u_L) / (2 * u_L)).subs(u_L, root).n(digits)
