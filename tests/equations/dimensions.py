"""Dimensional analysis of a SymPy expression from the table of symbols."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp
from sympy.core.relational import Relational

from softcat_sym.equations.symbols import entry

Dimension = tuple[Fraction, ...]
NONE: Dimension = (Fraction(0),) * 3
_PURE = (sp.log, sp.exp, sp.sin, sp.cos, sp.tan, sp.acos, sp.asin, sp.atan, sp.sinh, sp.cosh, sp.tanh)
_SAME = (sp.Add, sp.Max, sp.Min, Relational)


class MismatchError(Exception):
    """Terms that cannot be added, or a function of something that has a dimension."""


def dimension(expr: sp.Basic) -> Dimension | None:
    """Exponents of (kg, m, s); None for zero, which agrees with anything."""
    if expr == 0:
        return None
    if isinstance(expr, sp.Symbol):
        return tuple(map(Fraction, entry(expr).dimension))
    if expr.is_number:
        return NONE
    if isinstance(expr, sp.Mul):
        return _product([dimension(a) for a in expr.args])
    if isinstance(expr, sp.Pow):
        return _power(*expr.args)
    if isinstance(expr, sp.Piecewise):
        for _, condition in expr.args:
            if condition != sp.true:
                dimension(condition)
        return _agree(expr, [dimension(branch) for branch, _ in expr.args])
    inner = [dimension(a) for a in expr.args]
    if isinstance(expr, _SAME):
        return _agree(expr, inner)
    if isinstance(expr, sp.atan2):
        _agree(expr, inner)
        return NONE
    if isinstance(expr, sp.Abs):
        return inner[0]
    if isinstance(expr, _PURE):
        _agree(expr, [*inner, NONE])
        return NONE
    raise MismatchError(f"no rule for {type(expr).__name__}")


def _product(parts: list[Dimension | None]) -> Dimension | None:
    if any(part is None for part in parts):
        return None
    return tuple(map(sum, zip(*parts, strict=True)))


def _power(base: sp.Expr, exponent: sp.Expr) -> Dimension | None:
    inner = dimension(base)
    if not exponent.is_Rational:
        _agree(base**exponent, [inner, dimension(exponent), NONE])
        return NONE
    return None if inner is None else tuple(Fraction(exponent.p, exponent.q) * part for part in inner)


def _agree(expr: sp.Basic, parts: list[Dimension | None]) -> Dimension | None:
    known = {part for part in parts if part is not None}
    if len(known) > 1:
        raise MismatchError(f"{sorted(known)} in {expr}")
    return known.pop() if known else None
