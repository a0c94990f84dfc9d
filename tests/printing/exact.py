"""SymPy to twenty digits, and the printer at the same point."""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import sympy as sp

from softcat_sym.discretization.casadi_printer import CellFunction


def exact(expr: sp.Expr, values: Mapping[sp.Symbol, float]) -> float:
    """SymPy's own value: every double is the number it is, and nothing is rounded before the twentieth digit."""
    return float(expr.xreplace({symbol: sp.Float(value, 40) for symbol, value in values.items()}).evalf(20))


def printed(expr: sp.Expr, values: Mapping[sp.Symbol, float]) -> float:
    """The printer's value in double precision."""
    at = {symbol: ca.DM(value) for symbol, value in values.items()}
    return float(CellFunction({"out": expr}, tuple(at))(at)["out"])
