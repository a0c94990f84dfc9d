"""A string of small sag under its own weight, without bending or inertia: how it hangs, and how it creeps.

The horizontal tension is uniform and the shape a parabola, whose midpoint hangs H below the supports. The flow of a
power-law fluid then makes H grow as t^(n/(2n + 1)): as t^(1/3) for a viscous fluid (2.20).
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.laws.power_law import K, n
from softcat_sym.equations.regimes import H
from softcat_sym.equations.symbols import ONE, E, L, enter, eta, g, rho, sigma, t

Rational = sp.Rational

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


EQUATIONS: tuple[Equation, ...] = (
    Equation("strain of a string", eps_string, string_strain(), "2.18"),
    Equation("stress of a string", sigma, string_stress(), "2.18"),
    Equation("sag of an elastic string", H, elastic_string_sag(), "2.18"),
    Equation("sag of a viscous string", H, viscous_string_sag(), "2.20"),
    Equation("sag of a power-law string", H, power_law_string_sag(), "2.20, for any index"),
)
