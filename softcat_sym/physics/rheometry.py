"""Rheometry with a sagging Maxwell filament: (R, t_high, B) to modulus and viscosity, inverting (2.20)-(2.22).

Times are in units of sqrt(L/g), frequencies in sqrt(g/L). The formulas hold for a slender filament whose sag is small
against its span and large against its thickness, so that bending plays no part.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.regimes import E_star, H, V, tau_star
from softcat_sym.physics.symbols import ONE, E, L, enter, eta, g, rho

Rational = sp.Rational

B = enter("B", "B", ONE, "load over viscosity 1/(2V)", "2.20", positive=True)
R = enter("R", "R", ONE, "angular frequency of the oscillation at t_high", "2.22", positive=True)
t_high = enter("t_high", "t_{high}", ONE, "time from which the 1/3 power law holds", "after 2.20", positive=True)
alpha = enter("alpha", r"\alpha", ONE, "tolerance in t_low and t_high, 1/15 in the paper", "after 2.20", positive=True)
t_star = enter("t_star", "t^*", ONE, "time over sqrt(L/g)", "2.18", positive=True)
d_R = enter("d_R", "d", ONE, "decay rate of the oscillation at t_high", "2.22", positive=True)
chi = enter("chi", r"\chi", ONE, "frequency over decay rate of the oscillation, 2 R tau", "2.22", positive=True)
var_R = enter("var_R", r"\sigma_R^2", ONE, "variance of log R", "2.22", positive=True)
var_t = enter("var_t", r"\sigma_t^2", ONE, "variance of log t_high", "2.22", positive=True)
var_B = enter("var_B", r"\sigma_B^2", ONE, "variance of log B", "2.22", positive=True)


def tension_stiffness() -> sp.Expr:
    """Stiffness c = (3 t_high^2/B)^(1/3): 6 c is the coefficient of f' in (2.21), frozen at t_high."""
    return sp.cbrt(3 * t_high**2 / B)


B_FROM_VISCOSITY = Equation("load over viscosity", B, rho * sp.sqrt(g * L**3) / (2 * eta), "2.20")
VISCOSITY_FROM_B = Equation("viscosity from B", eta, rho * sp.sqrt(g * L**3) / (2 * B), "2.20, inverted")
B_FROM_T_HIGH = Equation("B from the onset of the 1/3 law", B, 3 * t_high**5 * (6 * alpha) ** 3, "t_high, inverted")
B_FROM_SAG = Equation(
    "B from the 1/3 law itself", B, Rational(64, 9) * (H / L) ** 3 / t_star, "2.20, without its logarithm"
)
DECAY = Equation("decay rate", d_R, 1 / (2 * tau_star), "2.22")
LARGEST_FREQUENCY = Equation("frequency at the double root", R, 6 * tension_stiffness(), "2.22")
MODULUS = Equation("modulus from viscosity and relaxation time", E, eta / (tau_star * sp.sqrt(L / g)), "2.17")
MODULUS_FROM_SAG = Equation(
    "modulus from the ringing and the sag about which it rings",
    E_star,
    (R**2 + d_R**2 - Rational(3, 2) * L / H) * L**2 / (64 * H**2),
    "2.18, before terms are dropped",
)
"""With nothing assumed about the past: no t_high, no B, one root, no double root; but the parabola's shape is held."""

VISCOUS_NUMBER = Equation("viscous number", V, 1 / (2 * B), "2.20")
FREQUENCY_OVER_DECAY = Equation("frequency over decay rate", chi, 2 * R * tau_star, "2.22")


@dataclass(frozen=True, slots=True)
class RelaxationTimes:
    """Both relaxation times that one frequency allows, in units of sqrt(L/g); real while R <= 6 c."""

    # The longer: the amplitude falls by less than exp(2 pi) a period (d < R). An oscillation one can see is this.
    ringing: sp.Expr
    fading: sp.Expr  # The shorter: the amplitude falls by more than exp(2 pi) = 535 a period (d > R)


def relaxation_times() -> RelaxationTimes:
    """Roots of 4 R^2 tau^2 - 24 c tau + 1 = 0 in terms of R, t_high and B; their product is 1/(4 R^2)."""
    stiffness = 6 * tension_stiffness()
    root = sp.sqrt(stiffness**2 - R**2)
    return RelaxationTimes((stiffness + root) / (2 * R**2), (stiffness - root) / (2 * R**2))


def leverage() -> sp.Expr:
    """C = (chi^2 + 1)/(chi^2 - 1) = d log tau/d log c at fixed R; > 1 ringing, < -1 fading, infinite between."""
    return (chi**2 + 1) / (chi**2 - 1)


def condition_number() -> sp.Expr:
    """Largest over smallest singular value of d log(E, eta)/d log(R, t_high, B): sqrt(45/8) = 2.4 when chi is large."""
    C = leverage()
    trace = (1 + C) ** 2 + Rational(4, 9) * C**2 + (1 - C / 3) ** 2 + 1
    determinant = (1 + C) ** 2 + Rational(4, 9) * C**2
    spread = sp.sqrt(trace**2 - 4 * determinant)
    return (trace + spread) / (2 * sp.sqrt(determinant))


def covariance() -> sp.Matrix:
    """Covariance of log(E, eta) to first order, R, t_high and B taken as three independent measurements."""
    C = leverage()
    cross = (1 - C / 3) * var_B
    modulus = (1 + C) ** 2 * var_R + Rational(4, 9) * C**2 * var_t + (1 - C / 3) ** 2 * var_B
    return sp.Matrix([[modulus, cross], [cross, var_B]])


def misfit() -> sp.Expr:
    """Squared disagreement of B and t_high over its variance: chi-squared of one degree of freedom if (2.20) holds."""
    return sp.log(B / B_FROM_T_HIGH.right) ** 2 / (var_B + 25 * var_t)
