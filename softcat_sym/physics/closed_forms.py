"""Closed forms: a sagging Maxwell filament in limits (2.20-2.22), strings, spanning beams, shear data as tension."""

from __future__ import annotations

from typing import cast

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.laws import K, n
from softcat_sym.physics.regimes import CATENARY_SAG, PINNED, Beam, H, V, delta, gyration, sigma_max, tau_star, u_L
from softcat_sym.physics.rheometry import B, R, alpha, mu, t_high, t_star
from softcat_sym.physics.sections import CIRCLE, RECTANGLE, Section
from softcat_sym.physics.small_deflection import K_I, x_bar, y_bar
from softcat_sym.physics.symbols import (
    ONE,
    STRESS,
    Dimension,
    E,
    L,
    enter,
    enter_field,
    eta,
    g,
    h0,
    rho,
    sigma,
    sigma_Y,
    t,
)

Rational = sp.Rational

phi = enter("phi", r"\phi", ONE, "factor of the parabola, four times the sag", "2.20", positive=True)
phi_t = enter("phi_t", r"\phi_t", ONE, "rate of phi", "2.20")
phi_tt = enter("phi_tt", r"\phi_{tt}", ONE, "acceleration of phi", "2.20")
t_low = enter("t_low", "t_{low}", ONE, "time until which the midpoint falls freely", "after 2.20", positive=True)
f_rest = enter("f_rest", "a_1", ONE, "where the oscillation ends", "2.22")
f_cos = enter("f_cos", "a_2", ONE, "cosine amplitude of the oscillation", "2.22")
f_sin = enter("f_sin", "a_3", ONE, "sine amplitude of the oscillation", "2.22")
phi_of = enter_field("phi_of", r"\phi", ONE, "factor of the parabola, of time", "2.20")
f_of = enter_field("f_of", "f", ONE, "departure of phi from the slow descent, of time", "2.21")

TOLERANCE = Rational(1, 15)
"""The paper's alpha."""

PARABOLA = x_bar**2 - Rational(1, 4)
"""Shape of the outer solution; it ignores the bent layers at the supports (2.20)."""

MIDPOINT = -phi / 4
"""y(0) of the parabola."""

FREE_FALL = -(t_star**2) / 2
"""Midpoint before the supports are felt."""

FREE_FALL_FACTOR = 2 * t_star**2
"""phi of the parabola whose midpoint falls freely."""

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

LATE_RATIO = (B / (3 * t_star**5)) ** Rational(1, 3) / 6
"""Inertia over tension on the 1/3 law."""

T_HIGH = (B / 3) ** Rational(1, 5) * (6 * alpha) ** Rational(-3, 5)
"""Start of the 1/3 law."""

OSCILLATION = (tau_star, sp.Integer(1), 6 * (3 * t_star**2 / B) ** Rational(1, 3))
"""Coefficients of f''', f'' and f' in (2.21), a small departure from the 1/3 law."""

OSCILLATION_COMPLETE = (
    tau_star,
    1 - tau_star * phi_t / phi,
    2 * phi**2 / B + tau_star * (6 - phi_tt) / phi,
    4 * phi * phi_t / B - tau_star * phi_t * (6 - phi_tt) / phi**2,
)
"""Coefficients of f''', f'', f' and f before any is dropped, for a departure from any slow phi(t)."""

FREQUENCY = sp.sqrt(24 * tau_star * (3 * t_high**2 / B) ** Rational(1, 3) - 1) / (2 * tau_star)
"""R, angular frequency of (2.21) with its coefficient frozen at t_high."""

PERIOD = 2 * sp.pi / R
"""Of (2.22)."""

DECAY_RATE = 1 / (2 * tau_star)
"""Of (2.22)."""

RINGING = f_rest + sp.exp(-DECAY_RATE * t_star) * (f_cos * sp.cos(R * t_star) + f_sin * sp.sin(R * t_star))
"""f(t) near t_high (2.22)."""

TENSION_TO_BENDING = (phi / (4 * delta)) ** 2 / (18 * K_I)
"""Load borne by tension over load borne by bending in an elastic filament with clamped ends: (2/3)(sag/h)^2 of a
rectangle. While a viscous filament flows it is twice that."""

_phi, _f = phi_of(t_star), f_of(t_star)
_motion = {phi: _phi, phi_t: sp.Derivative(_phi, t_star), phi_tt: sp.Derivative(_phi, t_star, t_star)}


def _linear(coefficients: tuple[sp.Expr, ...], orders: tuple[int, ...]) -> sp.Expr:
    return sum(c * sp.Derivative(_f, (t_star, n)) for c, n in zip(coefficients, orders, strict=True))


OUTER_SHAPE = Equation("a parabola at all times", y_bar(x_bar, t_star), PARABOLA * _phi, "2.20")
PARABOLA_MOTION = Equation(
    "the parabola with inertia, averaged over the span",
    tau_star * sp.Derivative(_phi, (t_star, 3))
    + sp.Derivative(_phi, (t_star, 2))
    + tau_star * (6 - sp.Derivative(_phi, (t_star, 2))) * sp.Derivative(_phi, t_star) / _phi
    + 2 * _phi**2 * sp.Derivative(_phi, t_star) / B,
    sp.Integer(6),
    "2.18, before 2.21",
)
OUTER_FLOW = Equation(
    "the parabola without inertia",
    tau_star * sp.Derivative(_phi, t_star) / _phi + _phi**2 * sp.Derivative(_phi, t_star) / (3 * B),
    sp.Integer(1),
    "2.20",
)
OSCILLATION_EQUATION = Equation("departure from the 1/3 law", _linear(OSCILLATION, (3, 2, 1)), sp.Integer(0), "2.21")

ASYMPTOTICS_EQUATIONS: tuple[Equation, ...] = (
    Equation("load over viscosity", B, 1 / (2 * V), "2.20"),
    OUTER_SHAPE,
    PARABOLA_MOTION,
    OUTER_FLOW,
    Equation("outer solution", t_star, OUTER_TIME, "2.20"),
    Equation("outer solution from rest", t_star, OUTER_TIME_FROM_REST, "2.20"),
    Equation("1/3 law", phi, THIRD_LAW_FACTOR, "after 2.20"),
    Equation("end of free fall, relaxed", t_low, T_LOW_LONG, "after 2.20"),
    Equation("end of free fall, elastic", t_low, T_LOW_SHORT, "after 2.20, the other limit"),
    Equation("inertia falls to alpha of the tension", LATE_RATIO.subs(t_star, t_high), alpha, "after 2.20"),
    Equation("start of the 1/3 law", t_high, T_HIGH, "after 2.20"),
    OSCILLATION_EQUATION,
    Equation(
        "departure from any slow descent",
        sum(
            c.subs(_motion) * sp.Derivative(_f, (t_star, n))
            for c, n in zip(OSCILLATION_COMPLETE, (3, 2, 1, 0), strict=True)
        ),
        sp.Integer(0),
        "before 2.21",
    ),
    Equation("ringing", _f, RINGING, "2.22"),
    Equation("frequency of ringing", R, FREQUENCY, "2.22"),
)

eps_string = enter("eps_string", r"\epsilon", ONE, "mean strain of a string", "2.18")


def string_strain(sag: sp.Expr = H) -> sp.Expr:
    """Mean strain of a parabola of small sag, (8/3)(H/L)^2."""
    return Rational(8, 3) * (sag / L) ** 2


def string_stress(sag: sp.Expr = H) -> sp.Expr:
    """Stress rho g L^2/(8 H) that carries the weight."""
    return rho * g * L**2 / (8 * sag)


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


STRINGS_EQUATIONS: tuple[Equation, ...] = (
    Equation("strain of a string", eps_string, string_strain(), "2.18"),
    Equation("stress of a string", sigma, string_stress(), "2.18"),
    Equation("sag of an elastic string", H, elastic_string_sag(), "2.18"),
    Equation("sag of a viscous string", H, viscous_string_sag(), "2.20"),
    Equation("sag of a power-law string", H, power_law_string_sag(), "2.20, for any index"),
)

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
    """Largest stress of the exact catenary over rho g L, from its sag over span: cosh(u)/(2 u)."""
    if not sag > 0:
        raise ValueError(f"a catenary of sag {sag} carries no load")
    root = sp.nsolve(CATENARY_SAG.right / L - sag, u_L, sp.asinh(4 * sag), prec=digits + 5)
    return (sp.cosh(u_L) / (2 * u_L)).subs(u_L, root).n(digits)


SPANNING_EQUATIONS: tuple[Equation, ...] = (
    Equation("sag of an elastic beam between pins", H, beam_sag(RECTANGLE, PINNED), "2.14"),
    Equation("sag of a viscous beam between pins", H, viscous_beam_sag(RECTANGLE, PINNED), "2.14"),
    Equation("largest stress of an elastic beam", sigma_max, largest_bending_stress(RECTANGLE, PINNED), "3.11"),
    Equation("modulus of a spanning ink", G_prime, smay_modulus(), "Smay 2002"),
)

_HALF = sp.Rational(1, 2)

tau_Y = enter("tau_Y", r"\tau_Y", STRESS, "yield stress in shear", "von Mises 1913", positive=True)
k_shear = enter(
    "k_shear", "k", cast("Dimension", (1, -1, n - 2)), "consistency in shear, in Pa s^n", "Ostwald 1925", positive=True
)


def consistency_factor(index: sp.Expr) -> sp.Expr:
    """K/k = 3^((n + 1)/2): Trouton's 3 for n = 1."""
    return sp.Integer(3) ** (_HALF * (index + 1))


FROM_SHEAR_EQUATIONS: tuple[Equation, ...] = (
    Equation("tensile yield stress", sigma_Y, sp.sqrt(3) * tau_Y, "von Mises 1913"),
    Equation("tensile viscosity", eta, 3 * mu, "Trouton 1906"),
    Equation("tensile consistency", K, consistency_factor(n) * k_shear, "von Mises 1913"),
)
