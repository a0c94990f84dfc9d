"""What a rheometer measures in shear, as the constants in tension that the laws are written in.

For a law of von Mises's equivalent stress, which is sqrt(3) tau in shear while the shear rate is sqrt(3) times the
equivalent strain rate (von Mises 1913; Trouton 1906 for the 3).
"""

from __future__ import annotations

from typing import cast

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.laws.power_law import K, n
from softcat_sym.equations.rheometry import mu
from softcat_sym.equations.symbols import STRESS, Dimension, enter, eta, sigma_Y

_HALF = sp.Rational(1, 2)

tau_Y = enter("tau_Y", r"\tau_Y", STRESS, "yield stress in shear", "von Mises 1913", positive=True)
k_shear = enter(
    "k_shear", "k", cast("Dimension", (1, -1, n - 2)), "consistency in shear, in Pa s^n", "Ostwald 1925", positive=True
)


def consistency_factor(index: sp.Expr) -> sp.Expr:
    """K/k = 3^((n + 1)/2): Trouton's 3 for n = 1."""
    return sp.Integer(3) ** (_HALF * (index + 1))


EQUATIONS: tuple[Equation, ...] = (
    Equation("tensile yield stress", sigma_Y, sp.sqrt(3) * tau_Y, "von Mises 1913"),
    Equation("tensile viscosity", eta, 3 * mu, "Trouton 1906"),
    Equation("tensile consistency", K, consistency_factor(n) * k_shear, "von Mises 1913"),
)
