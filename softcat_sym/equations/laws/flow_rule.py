"""The plastic strain rate of a fibre, which every flow rule gives as a function of its stress."""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import RATE, enter

plastic_rate = enter("eps_p_t", r"\epsilon^p_t", RATE, "plastic strain rate of a fibre", "2.7")


def flow_rule(name: str, rate: sp.Expr, source: str) -> Equation:
    """The equation eps_p_t = phi(sigma)."""
    return Equation(name, plastic_rate, rate, source)
