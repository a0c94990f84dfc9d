"""Drag: what surrounds the filament resists its motion, as a slender body or, faster, in cross-flow.

Both laws derive from a Rayleigh potential of the velocity along and across the tangent, so that their loss is exact in
the energy audit.
"""

from __future__ import annotations

import math
from dataclasses import replace

import sympy as sp

from softcat_sym.effects import scaling_estimates as scales
from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, Motion
from softcat_sym.effects.free_vibration import ringing
from softcat_sym.physics.densities import Densities
from softcat_sym.physics.filament import Terms
from softcat_sym.physics.laws import Constant
from softcat_sym.physics.symbols import VISCOSITY, enter, h0, mu_b, rho_b, s, x_t, x_X, y_t, y_X
from softcat_sym.scene.scene import Scene, undeformed_area

zeta_n = enter("zeta_n", r"\zeta_n", VISCOSITY, "force per length and velocity across a slender body", "Cox 1970")
zeta_t = enter("zeta_t", r"\zeta_t", VISCOSITY, "force per length and velocity along a slender body", "Cox 1970")

_along = (x_X * x_t + y_X * y_t) / s
_across = (x_X * y_t - y_X * x_t) / s
_diameter = h0 / sp.sqrt(s)

SLENDER = s * (zeta_t * _along**2 + zeta_n * _across**2) / 2
"""Per rest length, a body of length s dX (Cox 1970, Batchelor 1970)."""

CROSS_FLOW = s * (
    zeta_t * _along**2 / 2
    + rho_b
    * _diameter
    / 2
    * (
        sp.Abs(_across) ** 3 / 3
        + sp.Rational(30, 7) * (mu_b / (rho_b * _diameter)) ** sp.Rational(2, 3) * sp.Abs(_across) ** sp.Rational(7, 3)
    )
)
"""Potential of (1/2) rho_b C_d d |v_n| v_n with C_d = 1 + 10 Re^(-2/3) (White 1991), and a slender body along."""
