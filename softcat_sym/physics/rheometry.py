"""Rheometry with a sagging Maxwell filament: (R, t_high, B) to modulus and viscosity, inverting (2.20)-(2.22).

Times are in units of sqrt(L/g), frequencies in sqrt(g/L). The formulas hold for a slender filament whose sag is small
against its span and large against its thickness, so that bending plays no part.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.regimes import SHALLOW_STRESS, E_star, Gam_s, H, V, tau_star
from softcat_sym.physics.symbols import A0, ONE, VISCOSITY, E, L, enter, eta, g, rho, sigma_Y

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
mu = enter("mu", r"\mu", VISCOSITY, "shear viscosity, a third of the extensional one", "THEORY 3", positive=True)
v_mid = enter("v_mid", "v", (0, 1, -1), "speed of the midpoint of a bending beam", "THEORY 11", positive=True)
m_load = enter("m_load", "m", (1, 0, 0), "mass hung at midspan", "THEORY 11", positive=True)
I_0 = enter("I_0", "I_0", (0, 4, 0), "second moment of area of the undeformed section", "2.9", positive=True)


def tension_stiffness() -> sp.Expr:
    """Stiffness c = (3 t_high^2/B)^(1/3): 6 c is the coefficient of f' in (2.21), frozen at t_high."""
    return sp.cbrt(3 * t_high**2 / B)


B_FROM_VISCOSITY = Equation("load over viscosity", B, rho * sp.sqrt(g * L**3) / (2 * eta), "2.20")
VISCOSITY_FROM_B = Equation("viscosity from B", eta, rho * sp.sqrt(g * L**3) / (2 * B), "2.20, inverted")
B_FROM_T_HIGH = Equation("B from the onset of the 1/3 law", B, 3 * t_high**5 * (6 * alpha) ** 3, "t_high, inverted")
B_FROM_SAG = Equation(
    "B from the 1/3 law itself", B, Rational(64, 9) * (H / L) ** 3 / t_star, "2.20, without its logarithm"
)
RINGING_FREQUENCY = Equation("frequency", R, sp.sqrt(24 * tau_star * tension_stiffness() - 1) / (2 * tau_star), "2.22")
DECAY = Equation("decay rate", d_R, 1 / (2 * tau_star), "2.22")
QUADRATIC = Equation(
    "relaxation time from the frequency",
    4 * R**2 * tau_star**2 - 24 * tension_stiffness() * tau_star + 1,
    sp.Integer(0),
    "2.22, squared",
)
CIRCLE_OF_DECAY = Equation(
    "frequency and decay rate lie on a circle", R**2 + d_R**2, 12 * tension_stiffness() * d_R, "2.22"
)
LARGEST_FREQUENCY = Equation("frequency at the double root", R, 6 * tension_stiffness(), "2.22")
LARGEST_FREQUENCY_AT_ONSET = Equation("the same with t_high and B tied", R, 1 / (alpha * t_high), "2.22")
MODULUS = Equation("modulus from viscosity and relaxation time", E, eta / (tau_star * sp.sqrt(L / g)), "2.17")
MODULUS_FROM_SAG = Equation(
    "modulus from the ringing and the sag about which it rings",
    E_star,
    (R**2 + d_R**2 - Rational(3, 2) * L / H) * L**2 / (64 * H**2),
    "2.18, before terms are dropped",
)
"""With nothing assumed about the past: no t_high, no B, one root, no double root; but the parabola's shape is held."""

_CABLE_ANGLE = R * sp.sqrt(2 * H / L)
MODULUS_FROM_CABLE = Equation(
    "modulus from the lowest symmetric mode of an elastic cable about its sag",
    E_star,
    _CABLE_ANGLE**3 / (128 * (H / L) ** 3 * (_CABLE_ANGLE - sp.tan(_CABLE_ANGLE))),
    "Irvine and Caughey 1974",
)
"""The shape follows; R sqrt(2H/L) between pi/2 (taut) and 4.493 (inextensible, where R says nothing of E)."""

YIELD_STRESS_FROM_SAG = Equation(
    "yield stress from the sag at which a catenary stopped", sigma_Y, SHALLOW_STRESS.right - Gam_s, "before 3.12"
)
"""What the sag itself reads is sigma_Y + gamma P/(2 A): its surface holds a part of the filament."""

MODULUS_BY_GROUPS = Equation("modulus over weight", E_star, 1 / (2 * B * tau_star), "2.17")
VISCOUS_NUMBER = Equation("viscous number", V, 1 / (2 * B), "2.20")
FREQUENCY_OVER_DECAY = Equation("frequency over decay rate", chi, 2 * R * tau_star, "2.22")

BEAM_VISCOMETRY = Equation(
    "shear viscosity from the speed of a simply supported beam",
    mu,
    g * L**3 / (144 * I_0 * v_mid) * (m_load + Rational(5, 8) * rho * A0 * L),
    "ASTM C598",
)
ASTM_C598 = Equation(
    "the same as the standard writes it, with v in length per minute",
    mu,
    g * L**3 / (Rational(12, 5) * I_0 * v_mid) * (m_load + rho * A0 * L / Rational(8, 5)),
    "ASTM C598",
)


@dataclass(frozen=True, slots=True)
class RelaxationTimes:
    """Both relaxation times that one frequency allows, in units of sqrt(L/g); real while R <= 6 c."""

    # The longer: the amplitude falls by less than exp(2 pi) a period (d < R). An oscillation one can see is this.
    ringing: sp.Expr
    fading: sp.Expr  # The shorter: the amplitude falls by more than exp(2 pi) = 535 a period (d > R)


def relaxation_times() -> RelaxationTimes:
    """Roots of :data:`QUADRATIC` in terms of R, t_high and B; their product is 1/(4 R^2)."""
    stiffness = 6 * tension_stiffness()
    root = sp.sqrt(stiffness**2 - R**2)
    return RelaxationTimes((stiffness + root) / (2 * R**2), (stiffness - root) / (2 * R**2))


def leverage() -> sp.Expr:
    """C = (chi^2 + 1)/(chi^2 - 1) = d log tau/d log c at fixed R; > 1 ringing, < -1 fading, infinite between."""
    return (chi**2 + 1) / (chi**2 - 1)


def sensitivity() -> sp.Matrix:
    """Jacobian d log(E, eta)/d log(R, t_high, B) of the map that takes all three as measured, as a function of chi."""
    C = leverage()
    return sp.Matrix([[1 + C, -Rational(2, 3) * C, Rational(1, 3) * C - 1], [0, 0, -1]])


def neglected() -> sp.Expr:
    """Relative size tau/(3 t) of what (2.21) drops from its terms in f'' and f'; the inversion needs it small."""
    return tau_star / (3 * t_high)


def sensitivity_at_onset() -> sp.Matrix:
    """Jacobian d log(E, eta)/d log(R, t_high) when B is computed from t_high."""
    C = leverage()
    return sp.Matrix([[1 + C, C - 5], [0, -5]])


def condition_number() -> sp.Expr:
    """Largest over smallest singular value of :func:`sensitivity`: sqrt(45/8) = 2.4 when chi is large."""
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


def combined_variance() -> sp.Expr:
    """Variance of log B when its own measurement and the one through t_high (five times its error) are averaged."""
    return 1 / (1 / var_B + 1 / (25 * var_t))


def combined_covariance() -> sp.Matrix:
    """Covariance of log(E, eta) of the best linear estimate, which uses that t_high and B measure one viscosity."""
    C = leverage()
    shared = combined_variance()
    cross = (1 - C / 5) * shared
    return sp.Matrix([[(1 + C) ** 2 * var_R + (1 - C / 5) ** 2 * shared, cross], [cross, shared]])


def combined_log_B() -> sp.Expr:
    """The weighted average of both measurements of log B that :func:`combined_variance` belongs to."""
    through_onset = sp.log(B_FROM_T_HIGH.right)
    return combined_variance() * (sp.log(B) / var_B + through_onset / (25 * var_t))


def misfit() -> sp.Expr:
    """Squared disagreement of B and t_high over its variance: chi-squared of one degree of freedom if (2.20) holds."""
    return sp.log(B / B_FROM_T_HIGH.right) ** 2 / (var_B + 25 * var_t)


RHEOMETRY_EQUATIONS: tuple[Equation, ...] = tuple(
    stated for stated in [*globals().values()] if isinstance(stated, Equation)
)
