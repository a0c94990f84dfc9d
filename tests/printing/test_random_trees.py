"""Random expressions from the whitelist have SymPy's value, within the rounding that their own operations allow."""

from __future__ import annotations

import math
from dataclasses import dataclass

import sympy as sp
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from sympy.logic.boolalg import BooleanFunction

from .exact import exact, printed

SYMBOLS = sp.symbols("x y z", real=True)
_EPS = 2.0**-52
_HUGE = 1e30


@dataclass(frozen=True)
class Term:
    """An expression, its rough value, and what rounding may do to it."""

    expr: sp.Expr
    value: float
    error: float


def _term(expr: sp.Expr, value: float, error: float) -> Term:
    assume(math.isfinite(value) and abs(value) < _HUGE and (value == 0 or abs(value) > 1 / _HUGE))
    return Term(expr, value, error + _EPS * abs(value))


def _add(a: Term, b: Term) -> Term:
    return _term(a.expr + b.expr, a.value + b.value, a.error + b.error + _EPS * (abs(a.value) + abs(b.value)))


def _subtract(a: Term, b: Term) -> Term:
    return _term(a.expr - b.expr, a.value - b.value, a.error + b.error + _EPS * (abs(a.value) + abs(b.value)))


def _multiply(a: Term, b: Term) -> Term:
    return _term(a.expr * b.expr, a.value * b.value, abs(a.value) * b.error + abs(b.value) * a.error)


def _divide(a: Term, b: Term) -> Term:
    assume(abs(b.value) > 1e-3 + 1e3 * b.error)
    return _term(a.expr / b.expr, a.value / b.value, (a.error + abs(a.value / b.value) * b.error) / abs(b.value))


def _larger(a: Term, b: Term) -> Term:
    return _term(sp.Max(a.expr, b.expr), max(a.value, b.value), max(a.error, b.error))


def _smaller(a: Term, b: Term) -> Term:
    return _term(sp.Min(a.expr, b.expr), min(a.value, b.value), max(a.error, b.error))


def _choose(a: Term, b: Term) -> Term:
    assume(abs(a.value - b.value) > 1e-6 + 1e3 * (a.error + b.error))
    expr = sp.Piecewise((a.expr, a.expr < b.expr), (2 * b.expr, True))
    return _term(expr, a.value if a.value < b.value else 2 * b.value, a.error + 2 * b.error)


def _root(a: Term) -> Term:
    assume(a.value > 1e-3 + 1e3 * a.error)
    return _term(sp.sqrt(a.expr), math.sqrt(a.value), a.error / math.sqrt(a.value))


def _log(a: Term) -> Term:
    assume(a.value > 1e-3 + 1e3 * a.error)
    return _term(sp.log(a.expr), math.log(a.value), a.error / a.value)


def _exp(a: Term) -> Term:
    assume(abs(a.value) < 20)
    return _term(sp.exp(a.expr), math.exp(a.value), math.exp(a.value) * a.error)


def _sin(a: Term) -> Term:
    assume(abs(a.value) < 20)
    return _term(sp.sin(a.expr), math.sin(a.value), a.error + _EPS)


def _tanh(a: Term) -> Term:
    return _term(sp.tanh(a.expr), math.tanh(a.value), a.error)


def _abs(a: Term) -> Term:
    return _term(sp.Abs(a.expr), abs(a.value), a.error)


def _cube(a: Term) -> Term:
    return _term(a.expr**3, a.value**3, 3 * a.value**2 * a.error)


def _turn(a: Term, b: Term) -> Term:
    size = a.value**2 + b.value**2
    assume(size > 1e-6 and not (b.value < 0 and abs(a.value) < 1e-6 + 1e3 * a.error))
    slope = (abs(a.value) * b.error + abs(b.value) * a.error) / size
    return _term(sp.atan2(a.expr, b.expr), math.atan2(a.value, b.value), slope)


_TWO = st.sampled_from([_add, _subtract, _multiply, _divide, _larger, _smaller, _choose, _turn])
_ONE = st.sampled_from([_root, _log, _exp, _sin, _tanh, _abs, _cube])
_AT = {SYMBOLS[0]: 0.7310585786300049, SYMBOLS[1]: -1.2345678901234567, SYMBOLS[2]: 2.718281828459045}
_leaves = st.one_of(
    st.sampled_from(SYMBOLS).map(lambda symbol: Term(symbol, _AT[symbol], 0.0)),
    st.fractions(-5, 5, max_denominator=12)
    .filter(bool)
    .map(lambda f: Term(sp.Rational(f), float(f), _EPS * abs(float(f)))),
    st.floats(0.01, 5).map(lambda f: Term(sp.Float(f), f, 0.0)),
)
_trees = st.recursive(
    _leaves,
    lambda inner: st.one_of(
        st.tuples(_TWO, inner, inner).map(lambda t: t[0](t[1], t[2])), st.tuples(_ONE, inner).map(lambda t: t[0](t[1]))
    ),
    max_leaves=8,
)


@settings(max_examples=120, deadline=None, suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow])
@given(_trees)
def test_random_trees_have_the_value_of_sympy(tree: Term) -> None:
    # A condition on a Piecewise becomes ITE, And or Or in SymPy's hands: those the printer refuses.
    assume(not tree.expr.has(BooleanFunction))
    wanted = exact(tree.expr, _AT)
    assert abs(printed(tree.expr, _AT) - wanted) <= 64 * tree.error + 64 * _EPS * abs(wanted)
