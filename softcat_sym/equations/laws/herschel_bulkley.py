"""Herschel-Bulkley fluid: elastic up to the yield stress, a power law of the overstress beyond.

phi = (<|sigma| - sigma_Y>/K)^(1/n) sign(sigma): Bingham's for n = 1, the power law for sigma_Y = 0 (Herschel & Bulkley
1926).
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.law import Branch, Flow, Law
from softcat_sym.equations.laws.flow_rule import flow_rule
from softcat_sym.equations.laws.power_law import CONSTANTS, FLOW, power_of
from softcat_sym.equations.symbols import sigma, sigma_Y


def herschel_bulkley_rate() -> sp.Expr:
    """phi(sigma) = (<|sigma| - sigma_Y>/K)^(1/n) sign(sigma)."""
    return sp.sign(sigma) * power_of(sp.Max(sp.Abs(sigma) - sigma_Y, 0))


LAW = Law(
    "herschel-bulkley",
    branches=(Branch(flow=FLOW, flow_beyond_yield=Flow(herschel_bulkley_rate(), sigma_Y)),),
    constants=CONSTANTS,
)

EQUATIONS: tuple[Equation, ...] = (
    flow_rule("Herschel-Bulkley fluid", herschel_bulkley_rate(), "Herschel & Bulkley 1926"),
)
