"""An equation of the theory as data: name, both sides, where it stands in the paper."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True, slots=True)
class Equation:
    """Two sides, left = right, in the symbols of :mod:`softcat_sym.equations.symbols`.

    Attributes
    ----------
    name : str
        In words.
    left, right : sympy.Expr
        Both sides; every term of them has one dimension.
    source : str
        Equation numbers of the paper, or section of the theory.
    """

    name: str
    left: sp.Expr
    right: sp.Expr
    source: str

    def residual(self) -> sp.Expr:
        """Left side minus right side, zero where the equation holds."""
        return self.left - self.right
