"""Rheometry with a sagging Maxwell filament: (R, t_high, B) to modulus and viscosity, inverting (2.20)-(2.22).

Times are in units of sqrt(L/g), frequencies in sqrt(g/L). The formulas hold for a slender filament whose sag is small
against its span and large against its thickness, so that bending plays no part.
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.regimes import E_star, H, V, tau_star
from softcat_sym.physics.symbols import ONE, L, enter, eta, g, rho

Rational = sp.Rational

B = enter("B", "B", ONE, "load over viscosity 1/(2V)", "2.20", positive=True)
R = enter("R", "R", ONE, "angular frequency of the oscillation at t_high", "2.22", positive=True)
t_high = enter("t_high", "t_{high}", ONE, "time from which the 1/3 power law holds", "after 2.20", positive=True)
alpha = enter("alpha", r"\alpha", ONE, "tolerance in t_low and t_high, 1/15 in the paper", "after 2.20", positive=True)
t_star = enter("t_star", "t^*", ONE, "time over sqrt(L/g)", "2.18", positive=True)
d_R = enter("d_R", "d", ONE, "decay rate of the oscillation at t_high", "2.22", positive=True)


B_FROM_VISCOSITY = Equation("load over viscosity", B, rho * sp.sqrt(g * L**3) / (2 * eta), "2.20")
VISCOSITY_FROM_B = Equation("viscosity from B", eta, rho * sp.sqrt(g * L**3) / (2 * B), "2.20, inverted")
B_FROM_SAG = Equation(
    "B from the 1/3 law itself", B, Rational(64, 9) * (H / L) ** 3 / t_star, "2.20, without its logarithm"
)
DECAY = Equation("decay rate", d_R, 1 / (2 * tau_star), "2.22")
MODULUS_FROM_SAG = Equation(
    "modulus from the ringing and the sag about which it rings",
    E_star,
    (R**2 + d_R**2 - Rational(3, 2) * L / H) * L**2 / (64 * H**2),
    "2.18, before terms are dropped",
)
"""With nothing assumed about the past: no t_high, no B, one root, no double root; but the parabola's shape is held."""

VISCOUS_NUMBER = Equation("viscous number", V, 1 / (2 * B), "2.20")
