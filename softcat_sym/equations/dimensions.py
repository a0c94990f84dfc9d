"""Dimensional analysis by machine: every term of every equation, from the table of symbols."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import entry, field_entry

Exponents = tuple[Fraction | sp.Expr, ...]
"""Exponents of (kg, m, s): numbers, or expressions in a material constant, as the n in the Pa s^n of a consistency."""

PURE: Exponents = (Fraction(0),) * 3
_OF_PURE = (
    sp.log,
    sp.exp,
    sp.sin,
    sp.cos,
    sp.tan,
    sp.acos,
    sp.asin,
    sp.atan,
    sp.sinh,
    sp.cosh,
    sp.tanh,
    sp.asinh,
    sp.acosh,
)
_SAME = (sp.Add, sp.Max, sp.Min, Relational)


class DimensionError(ValueError):
    """Terms that cannot be added, or a function of something that has a dimension: the equation is wrong."""


def dimension(expr: sp.Basic) -> Exponents | None:  # noqa: C901 - one branch a kind of node
    """Exponents of (kg, m, s) of an expression; None for zero, which agrees with anything.

    Raises
    ------
    DimensionError
        If two terms disagree, or a kind of expression has no rule.
    KeyError
        If a symbol or a field is not in the table.
    """
    if expr == 0:
        return None
    if isinstance(expr, sp.Symbol):
        return tuple(map(_exact, entry(expr).dimension))
    if expr.is_number:
        return PURE
    if isinstance(expr, sp.Mul):
        return _product([dimension(a) for a in expr.args])
    if isinstance(expr, sp.Pow):
        return _power(*expr.args)
    if isinstance(expr, sp.Piecewise):
        return _branches(expr)
    if isinstance(expr, sp.Derivative | sp.Integral | AppliedUndef | sp.Subs):
        return _of_field(expr)
    inner = [dimension(a) for a in expr.args]
    if isinstance(expr, _SAME):
        return _agree(expr, inner)
    if isinstance(expr, sp.atan2):
        _agree(expr, inner)
        return PURE
    if isinstance(expr, sp.Abs):
        return inner[0]
    if isinstance(expr, sp.sign | sp.Heaviside | sp.Or | sp.And):
        return PURE
    if isinstance(expr, _OF_PURE):
        _agree(expr, [*inner, PURE])
        return PURE
    raise DimensionError(f"no rule for {type(expr).__name__}")


def check(equation: Equation) -> Exponents | None:
    """The dimension that both sides of an equation share.

    Raises
    ------
    DimensionError
        If a term differs.
    """
    return _agree(equation.residual(), [dimension(sp.expand(side)) for side in (equation.left, equation.right)])


def _of_field(expr: sp.Basic) -> Exponents | None:
    if isinstance(expr, AppliedUndef):
        return tuple(map(Fraction, field_entry(expr.func.__name__).dimension))
    if isinstance(expr, sp.Subs):
        return dimension(expr.expr)
    inner = dimension(expr.expr) if isinstance(expr, sp.Derivative) else dimension(expr.function)
    if inner is None:
        return None
    sign = -1 if isinstance(expr, sp.Derivative) else 1
    counts = expr.variable_count if isinstance(expr, sp.Derivative) else [(limit[0], 1) for limit in expr.limits]
    for variable, count in counts:
        step = dimension(variable) or PURE
        inner = tuple(a + sign * int(count) * b for a, b in zip(inner, step, strict=True))
    return inner


def _branches(expr: sp.Piecewise) -> Exponents | None:
    for _, condition in expr.args:
        if condition != sp.true:
            dimension(condition)
    return _agree(expr, [dimension(branch) for branch, _ in expr.args])


def _product(parts: list[Exponents | None]) -> Exponents | None:
    known = [part for part in parts if part is not None]
    if len(known) < len(parts):
        return None
    return tuple(_exact(sum(column, Fraction(0))) for column in zip(*known, strict=True))


def _power(base: sp.Expr, exponent: sp.Expr) -> Exponents | None:
    inner = dimension(base)
    if not exponent.is_Rational:
        _agree(base**exponent, [dimension(exponent), PURE])
        return PURE if inner is None else tuple(_exact(exponent * part) for part in inner)
    return None if inner is None else tuple(_exact(Fraction(exponent.p, exponent.q) * part) for part in inner)


def _exact(exponent: int | Fraction | sp.Expr) -> Fraction | sp.Expr:
    """An exponent in the one form in which equal ones are the same."""
    if not isinstance(exponent, sp.Basic):
        return Fraction(exponent)
    settled = sp.cancel(exponent)
    return Fraction(int(settled.p), int(settled.q)) if settled.is_Rational else settled


def _agree(expr: sp.Basic, parts: list[Exponents | None]) -> Exponents | None:
    known = {part for part in parts if part is not None}
    if len(known) > 1:
        raise DimensionError(f"{sorted(known, key=str)} in {expr}")
    return known.pop() if known else None
