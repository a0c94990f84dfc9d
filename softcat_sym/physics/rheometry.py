"""Rheometry with a sagging Maxwell filament: (R, t_high, B) to modulus and viscosity, inverting (2.20)-(2.22).

Times are in units of sqrt(L/g), frequencies in sqrt(g/L). First the formulas of the paper, for a slender filament whose
sag is small against its span and large against its thickness; then those of a beam under tension between clamps.
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.regimes import E_star, H
from softcat_sym.physics.symbols import ONE, L, enter

Rational = sp.Rational

B = enter("B", "B", ONE, "load over viscosity 1/(2V)", "2.20", positive=True)
R = enter("R", "R", ONE, "angular frequency of the oscillation at t_high", "2.22", positive=True)
t_high = enter("t_high", "t_{high}", ONE, "time from which the 1/3 power law holds", "after 2.20", positive=True)
alpha = enter("alpha", r"\alpha", ONE, "tolerance in t_low and t_high, 1/15 in the paper", "after 2.20", positive=True)
t_star = enter("t_star", "t^*", ONE, "time over sqrt(L/g)", "2.18", positive=True)
d_R = enter("d_R", "d", ONE, "decay rate of the oscillation at t_high", "2.22", positive=True)

B_FROM_SAG = Equation(
    "B from the 1/3 law itself", B, Rational(64, 9) * (H / L) ** 3 / t_star, "2.20, without its logarithm"
)
k_g = enter("k_g", "k_g", ONE, "radius of gyration of the section over the span", "THEORY 8", positive=True)
r_T = enter("r_T", "r_T", ONE, "span over the length of a clamp's boundary layer", "THEORY 8", positive=True)
Omega = enter("Omega", r"\Omega", ONE, "angular frequency without relaxation", "THEORY 8", positive=True)

_COTH = 1 / sp.tanh(r_T / 2)
SAG_SHARE = Rational(1, 8) - sp.tanh(r_T / 4) / (2 * r_T)
"""Sag times tension, G, of a beam under tension and its weight between clamps: 1/8 of a string."""
STRETCH_SHARE = Rational(1, 12) + 2 / r_T**2 - 3 * _COTH / (4 * r_T) - (_COTH**2 - 1) / 8
"""Mean square slope times the square of the tension, S: 1/12 of a string."""

LAYER = Equation(
    "boundary layer at a sag",
    r_T**2 * k_g**2,
    STRETCH_SHARE * (H / L) ** 2 / (2 * SAG_SHARE**2),
    "2.18 at rest: the strain is T/(E A), and r_T^2 = T L^2/(E I)",
)
"""The shape at a sag is taken for that of an elastic filament that rests there, whatever the material."""


def late_prefactor() -> sp.Expr:
    """Slope of sag^3 in time over that of the 1/3 law, by rates of stretching through the shapes at rest.

    Bending slows the descent; a deep sag hastens it, as the filament becomes longer and thinner: 1 + (52/5) (H/L)^2 of
    a string.
    """
    spread = 2 - r_T * sp.diff(sp.log(STRETCH_SHARE), r_T) + 2 * r_T * sp.diff(sp.log(SAG_SHARE), r_T)
    return Rational(64, 3) * SAG_SHARE**3 * spread / STRETCH_SHARE * (1 + Rational(52, 5) * (H / L) ** 2)


def vibration() -> sp.Expr:
    """Zero at the frequencies of a clamped beam under tension that hangs by a sag and stretches as it swings.

    -Omega^2 w = T w_xx - b w_xxxx + h y_xx, h = E* int y_x w_x dx, b = E* k_g^2, T = G L/H, with the shape at rest y;
    for b = 0 the cable of Irvine and Caughey (1974). The determinant of the clamps multiplies it, so that it has no
    poles.
    """
    tension, beam = SAG_SHARE * L / H, E_star * k_g**2
    root = sp.sqrt(tension**2 + 4 * beam * Omega**2)
    kappa, k = sp.sqrt((tension + root) / (2 * beam)), Omega * sp.sqrt(2 / (tension + root))
    tanh, cos, sin = sp.tanh(kappa / 2), sp.cos(k / 2), sp.sin(k / 2)
    # For h = 1, w = (a cos(k x) + c cosh(kappa x)/cosh(kappa/2))/clamps + uniform + layer cosh(r x)/sinh(r/2).
    uniform = -1 / (tension * Omega**2)
    layer = -r_T / (2 * tension * beam * (r_T**2 - kappa**2) * (r_T**2 + k**2))
    clamps, at_end = cos * kappa * tanh + k * sin, uniform + layer * _COTH
    a, c = layer * r_T - at_end * kappa * tanh, -layer * r_T * cos - at_end * k * sin
    mean = a * 2 * sin / k + c * 2 * tanh / kappa + clamps * (uniform + 2 * layer / r_T)
    near_clamps = (
        a * 2 * (r_T * cos + k * sin * _COTH) / (r_T**2 + k**2)
        + c * 2 * (kappa * tanh * _COTH - r_T) / (kappa**2 - r_T**2)
        + clamps * (2 * uniform / r_T + layer * ((_COTH**2 - 1) / 2 + _COTH / r_T))
    )
    return clamps + E_star * (mean - r_T / 2 * near_clamps) / tension
