"""The elastic part of every law: stress of an elastic strain (2.8)."""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import ONE, E, enter, sigma

elastic_part = enter("eps_e", r"\epsilon^e", ONE, "elastic strain of a fibre", "2.8")


def elastic_stress(strain: sp.Expr, plastic_strain: sp.Expr) -> sp.Expr:
    """Axial stress E (eps - eps_p) (2.8)."""
    return E * (strain - plastic_strain)


EQUATIONS: tuple[Equation, ...] = (
    Equation("stress of an elastic strain", sigma, elastic_stress(elastic_part, sp.Integer(0)), "2.8"),
)
