"""Power-law fluid in tension, sigma = K |eps_t|^n sign(eps_t): phi = (|sigma|/K)^(1/n) sign(sigma).

Thinning for n < 1, thickening for n > 1, Maxwell's for n = 1 with K = eta (Ostwald 1925; in tension Norton 1929).
"""

from __future__ import annotations

from typing import cast

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.law import Branch, Constant, Flow, Law
from softcat_sym.equations.laws.flow_rule import flow_rule
from softcat_sym.equations.symbols import ONE, Dimension, E, enter, sigma

n = enter("n", "n", ONE, "flow index", "Ostwald 1925", positive=True)
K = enter("K", "K", cast("Dimension", (1, -1, n - 2)), "tensile consistency, in Pa s^n", "Ostwald 1925", positive=True)

# |sigma|^(1/n) has an infinite slope at zero stress if n > 1. Within this many E of zero the rule is linear instead;
# at a thousand times that it is off by less than a millionth. For n = 1 nothing is changed.
SMALL_STRESS = sp.Rational(1, 10**9)

CONSTANTS = (Constant("viscosity", K), Constant("index", n))


def power_of(stress: sp.Expr) -> sp.Expr:
    """(|stress|/K)^(1/n) sign(stress), with a finite slope where the stress vanishes.

    As s (s^2 + e^2)^((1/n - 1)/2) with s the stress over K: powers of K alone would overflow for small n.
    """
    relative = stress / K
    return relative * (relative**2 + (SMALL_STRESS * E / K) ** 2) ** ((1 / n - 1) / 2)


def power_law_rate() -> sp.Expr:
    """phi(sigma) = (|sigma|/K)^(1/n) sign(sigma)."""
    return power_of(sigma)


FLOW = Flow(power_law_rate())

LAW = Law("power-law", branches=(Branch(flow=FLOW),), constants=CONSTANTS)

EQUATIONS: tuple[Equation, ...] = (flow_rule("power-law fluid", power_law_rate(), "Ostwald 1925"),)
