"""SymPy to CasADi: exact numbers, every function, refusals, vectors, random trees."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from sympy.logic.boolalg import BooleanFunction

from softcat_sym.discretization.casadi_printer import CasadiPrinter, CellFunction
from softcat_sym.errors import PrintingError


# SymPy to twenty digits, and the printer at the same point.
def exact(expr: sp.Expr, values: Mapping[sp.Symbol, float]) -> float:
    """SymPy's own value: every double is the number it is, and nothing is rounded before the twentieth digit."""
    return float(expr.xreplace({symbol: sp.Float(value, 40) for symbol, value in values.items()}).evalf(20))


def printed(expr: sp.Expr, values: Mapping[sp.Symbol, float]) -> float:
    """The printer's value in double precision."""
    at = {symbol: ca.DM(value) for symbol, value in values.items()}
    return float(CellFunction({"out": expr}, tuple(at))(at)["out"])


# Numbers arrive in CasADi as the nearest double, whatever SymPy calls them.
x = sp.Symbol("x", real=True)


def number(expr: sp.Expr) -> float:
    return float(CasadiPrinter({}).value(expr))


def test_constants_are_the_nearest_double() -> None:
    for expr, wanted in [
        (sp.Rational(1, 10), 0.1),
        (sp.Float(0.1), 0.1),
        (sp.Float("0.1", 40), 0.1),
        (sp.Rational(1, 3), 1 / 3),
        (sp.Rational(-2, 7), -2 / 7),
        (sp.Rational(10**30 + 1, 10**30), 1.0),
        (sp.Rational(1, 10**300), 1e-300),
        (sp.Integer(10) ** 300, 1e300),
        (sp.Float(0.1) + sp.Float(0.2), 0.30000000000000004),
        (sp.Float(1 / 3), 0.3333333333333333),
        (sp.Float(5e-324), 5e-324),
        (sp.Float(1.7976931348623157e308), 1.7976931348623157e308),
        (sp.pi, math.pi),
        (sp.E, math.e),
        (sp.EulerGamma, 0.5772156649015329),
    ]:
        assert number(expr) == wanted


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_every_float_survives_to_the_last_of_its_seventeen_digits(value: float) -> None:
    assert number(sp.Float(value)) == value


@given(st.integers(-(10**40), 10**40), st.integers(1, 10**40))
def test_every_rational_is_rounded_once(above: int, below: int) -> None:
    expr = sp.Rational(above, below)
    assert number(expr) == float(Fraction(above, below))


# The printer against twenty-digit SymPy, over a table of expressions at random admissible points.
x, y, z = sp.symbols("x y z", real=True)
Q = sp.Rational

# Smooth ones: (expression, (low, high) of x, y and z).
POSITIVE = (0.2, 3.0)
ANY = (-3.0, 3.0)
UNIT = (-0.95, 0.95)
LARGE = (1e3, 1e6)
SMALL = (1e-6, 1e-3)

SMOOTH: dict[str, tuple[sp.Expr, tuple[float, float]]] = {
    "square": (x**2, ANY),
    "cube": (x**3, ANY),
    "fifth": (x**5, ANY),
    "seventh": (x**7, ANY),
    "eighth": (x**8, ANY),
    "ninth": (x**9, ANY),
    "large power": (x**31, ANY),
    "reciprocal": (1 / x, POSITIVE),
    "negative power": (x**-4, ANY),
    "large negative power": (x**-17, POSITIVE),
    "root": (sp.sqrt(x), POSITIVE),
    "root of a small number": (sp.sqrt(x), SMALL),
    "three halves": (x ** Q(3, 2), POSITIVE),
    "seven halves": (x ** Q(7, 2), LARGE),
    "minus a half": (x ** Q(-1, 2), POSITIVE),
    "minus five halves": (x ** Q(-5, 2), POSITIVE),
    "cube root": (x ** Q(1, 3), POSITIVE),
    "two thirds of a large number": (x ** Q(2, 3), LARGE),
    "minus two fifths": (x ** Q(-2, 5), POSITIVE),
    "float power": (x**1.25, POSITIVE),
    "symbolic power": (x**y, POSITIVE),
    "negative symbolic power": (x ** (-y), POSITIVE),
    "power of a number": (2**x, ANY),
    "exp": (sp.exp(x), ANY),
    "exp of a negative": (sp.exp(-(x**2)), ANY),
    "log": (sp.log(x), (1.5, 20.0)),
    "log of a large number": (sp.log(x), LARGE),
    "sin": (sp.sin(x), UNIT),
    "cos": (sp.cos(x), UNIT),
    "tan": (sp.tan(x), UNIT),
    "asin": (sp.asin(x), UNIT),
    "acos": (sp.acos(x), UNIT),
    "atan": (sp.atan(x), ANY),
    "atan2": (sp.atan2(x, y), ANY),
    "sinh": (sp.sinh(x), ANY),
    "cosh": (sp.cosh(x), ANY),
    "tanh": (sp.tanh(x), ANY),
    "quotient": (x / y, POSITIVE),
    "quotient of products": (2 * x**2 * y / (3 * z), POSITIVE),
    "several below": (x / (y * z**2 * sp.sqrt(x)), POSITIVE),
    "sum": (x + 2 * y + 3 * z, POSITIVE),
    "rational coefficients": (Q(1, 3) * x + Q(2, 7) * y, POSITIVE),
    "minus": (-x / 3, ANY),
    "pi": (sp.pi * x / 4, ANY),
    "e": (sp.E * x, ANY),
    "golden": (sp.GoldenRatio * x, ANY),
    "nested": (sp.exp(sp.sin(x) / (1 + y**2)) * sp.sqrt(1 + z**2), ANY),
    "horner": (x**3 * (10 + x * (6 * x - 15)), POSITIVE),
    "abs": (sp.Abs(x - 1), ANY),
    "sign": (sp.sign(x) * y, ANY),
    "max": (sp.Max(x, y), ANY),
    "max of three": (sp.Max(x, y, z), ANY),
    "max with a number": (sp.Max(x, 0), ANY),
    "min": (sp.Min(x, y, Q(1, 2)), ANY),
    "clamp": (sp.Min(sp.Max(x, -1), 1) * y, ANY),
    "piecewise": (sp.Piecewise((x**2, x > 1), (y, x < -1), (z, True)), ANY),
    "piecewise in a product": (2 * z * sp.Piecewise((1, x >= y), (-1, True)), ANY),
    "nested piecewise": (sp.Piecewise((sp.Piecewise((x, y > 0), (y, True)), z > 0), (z, True)), ANY),
    "piecewise of roots outside their domain": (sp.Piecewise((sp.sqrt(x), x > 0), (sp.sqrt(-x), True)), ANY),
    "piecewise of a quotient by zero": (sp.Piecewise((1 / sp.Max(x, 0), x > 0), (y, True)), ANY),
}


def test_every_expression_to_fourteen_digits() -> None:
    for name in SMOOTH:
        expr, (low, high) = SMOOTH[name]
        symbols = sorted(expr.free_symbols, key=str)
        points = np.random.default_rng(20).uniform(low, high, (8, len(symbols)))
        for point in points:
            values = dict(zip(symbols, map(float, point), strict=True))
            assert printed(expr, values) == pytest.approx(exact(expr, values), rel=2e-14, abs=0), values


RELATIONS = {
    "gt": (x > y, (0.0, 0.0, 1.0)),
    "ge": (x >= y, (0.0, 1.0, 1.0)),
    "lt": (x < y, (1.0, 0.0, 0.0)),
    "le": (x <= y, (1.0, 1.0, 0.0)),
    "eq": (sp.Eq(x, y), (0.0, 1.0, 0.0)),
    "ne": (sp.Ne(x, y), (1.0, 0.0, 1.0)),
}


def test_relations_below_at_and_above_their_boundary() -> None:
    for name in RELATIONS:
        condition, wanted = RELATIONS[name]
        expr = sp.Piecewise((1, condition), (0, True))
        below, above = float(np.nextafter(0.3, 0)), float(np.nextafter(0.3, 1))
        found = tuple(printed(expr, {x: at, y: 0.3}) for at in (below, 0.3, above))
        assert found == wanted


def test_the_boundary_itself() -> None:
    for expr, at, wanted in [
        (sp.sign(x), 0.0, 0.0),
        (sp.Abs(x), 0.0, 0.0),
        (sp.Max(x, 0), 0.0, 0.0),
        (sp.atan2(x, -1), 0.0, np.pi),
        (x ** Q(3, 2), 0.0, 0.0),
        (sp.Piecewise((1, x >= 0), (-1, True)), 0.0, 1.0),
        (sp.Piecewise((1, x > 0), (-1, True)), 0.0, -1.0),
        (sp.acos(x), 1.0, 0.0),
    ]:
        assert printed(expr, {x: at}) == wanted


def test_a_branch_not_taken_cannot_spoil_the_value() -> None:
    expr = sp.Piecewise((sp.log(x), x > 0), (sp.Integer(7), True))
    assert printed(expr, {x: -1.0}) == 7.0
    assert printed(sp.Piecewise((1 / x, sp.Ne(x, 0)), (0, True)), {x: 0.0}) == 0.0


# What the printer does not know it refuses, by name: nothing becomes NaN, or zero, in silence.
x, y, hidden = sp.symbols("x y hidden", real=True)
unknown = sp.Function("unknown")

REFUSED = {
    "gamma": (sp.gamma(x), "gamma"),
    "erf": (sp.erf(x), "erf"),
    "Heaviside": (sp.Heaviside(x), "Heaviside"),
    "DiracDelta": (sp.DiracDelta(x), "DiracDelta"),
    "floor": (sp.floor(x), "floor"),
    "user function": (unknown(x), "unknown"),
    "derivative": (sp.Derivative(unknown(x), x), "Derivative"),
    "integral": (sp.Integral(sp.exp(-(x**2)), (x, 0, y)), "Integral"),
    "sum": (sp.Sum(x**y, (y, 1, 3)), "Sum"),
    "limit": (sp.Limit(sp.sin(x) / x, x, 0), "Limit"),
    "imaginary unit": (sp.I * x, "ImaginaryUnit"),
    "infinity": (sp.oo, "Infinity"),
    "minus infinity": (-sp.oo, "NegativeInfinity"),
    "nan": (sp.nan, "NaN"),
    "zoo": (sp.zoo, "ComplexInfinity"),
    "piecewise without default": (sp.Piecewise((x, x > 0)), "says nothing about what remains"),
    "piecewise with a last condition": (sp.Piecewise((x, x > 0), (y, x < -1)), "says nothing about what remains"),
    "matrix": (sp.Matrix([x, y]), "Matrix"),
    "hidden deep down": (sp.exp(1 + sp.sqrt(sp.gamma(x) + 2)), "gamma"),
}


def test_refused_by_name() -> None:
    for name in REFUSED:
        expr, word = REFUSED[name]
        with pytest.raises(PrintingError, match=word):
            CasadiPrinter({x: 1.0, y: 2.0}).value(expr)


def test_symbols_without_an_input_are_all_named() -> None:
    with pytest.raises(PrintingError) as caught:
        CellFunction({"a": x + y, "b": x * hidden}, (x,))
    assert "'hidden'" in str(caught.value)
    assert "'y'" in str(caught.value)
    assert "'x'" not in str(caught.value)


def test_an_input_without_a_value_is_named() -> None:
    with pytest.raises(PrintingError, match="symbol hidden has no value"):
        CellFunction({"a": x + hidden}, (x, hidden))({x: 1.0})


def test_same_name_other_assumptions_is_another_symbol() -> None:
    positive = sp.Symbol("x", positive=True)
    with pytest.raises(PrintingError, match="'x'"):
        CellFunction({"a": positive}, (x,))


# One cell's expression, given vectors, is the expression of all cells; common parts are shared.
x, y = sp.symbols("x y", real=True)
AT_X = np.array([-1.5, -0.3, 0.0, 0.4, 2.0])
AT_Y = np.array([0.7, -0.3, 1.0, 0.2, -1.0])

EXPRESSIONS = {
    "smooth": sp.exp(x) * sp.sqrt(1 + y**2) / (2 + sp.cos(x)),
    "piecewise": sp.Piecewise((x, x > y), (y**2, x < 0), (sp.Integer(3), True)),
    "piecewise of numbers": sp.Piecewise((1, x >= 0), (-1, True)),
    "max": sp.Max(x, y, sp.Rational(1, 4)),
    "min": sp.Min(sp.Max(x, -1), 1),
    "sign": sp.sign(x) + sp.Abs(y),
    "atan2": sp.atan2(y, x),
}


def one_by_one(expr: sp.Expr) -> np.ndarray[Any, Any]:
    function = CellFunction({"out": expr}, (x, y))
    return np.array([float(function({x: float(a), y: float(b)})["out"]) for a, b in zip(AT_X, AT_Y, strict=True)])


def test_symbolic_vectors_are_elementwise() -> None:
    for name in EXPRESSIONS:
        for kind in [ca.SX, ca.MX]:
            expr = EXPRESSIONS[name]
            a, b = kind.sym("a", 5), kind.sym("b", 5)
            value = CellFunction({"out": expr}, (x, y))({x: a, y: b})["out"]
            found = np.asarray(ca.Function("f", [a, b], [value])(AT_X, AT_Y)).ravel()
            np.testing.assert_allclose(found, one_by_one(expr), rtol=1e-15)


def test_a_scalar_meets_a_vector() -> None:
    vector, scalar = ca.SX.sym("a", 5), ca.SX.sym("b")
    value = CellFunction({"out": x * y + sp.Max(x, y)}, (x, y))({x: vector, y: scalar})["out"]
    found = np.asarray(ca.Function("f", [vector, scalar], [value])(AT_X, 0.5)).ravel()
    np.testing.assert_array_equal(found, AT_X * 0.5 + np.maximum(AT_X, 0.5))


def test_a_derivative_passes_through() -> None:
    variable = ca.SX.sym("a")
    expr = sp.Piecewise((x**3 * sp.exp(-x), x > 0), (sp.sin(x), True))
    slope = ca.Function("d", [variable], [ca.jacobian(CellFunction({"o": expr}, (x,))({x: variable})["o"], variable)])
    for at in (-0.7, 1.3):
        assert float(slope(at)) == pytest.approx(float(sp.diff(expr, x).subs(x, at)), rel=1e-14)


def test_common_parts_are_computed_once() -> None:
    costly = sp.log(2 + sp.sin(x) + y**2)
    several = {"a": costly + 1, "b": costly**2, "c": sp.tan(costly)}
    a, b = ca.SX.sym("a"), ca.SX.sym("b")
    values = CellFunction(several, (x, y))({x: a, y: b})
    function = ca.Function("f", [a, b], list(values.values()))
    codes = [function.instruction_id(k) for k in range(function.n_instructions())]
    assert codes.count(ca.OP_LOG) == 1
    assert codes.count(ca.OP_SIN) == 1


def test_sharing_changes_no_value() -> None:
    condition = x > y
    several = {
        "a": sp.Piecewise((x * y, condition), (0, True)) + sp.Abs(x * y),
        "b": sp.Piecewise((x + y, condition), (x * y, True)),
        "c": sp.Max(x * y, 0) * sp.Piecewise((1, condition), (-1, True)),
    }
    together = CellFunction(several, (x, y))
    for a, b in zip(AT_X, AT_Y, strict=True):
        values = together({x: float(a), y: float(b)})
        for name, expr in several.items():
            assert float(values[name]) == float(CellFunction({"o": expr}, (x, y))({x: float(a), y: float(b)})["o"])


def test_a_shared_symbol_cannot_meet_one_of_the_users() -> None:
    mine = sp.Symbol("w_0", real=True)
    function = CellFunction({"a": sp.sin(x) + mine, "b": sp.sin(x) * mine}, (x, mine))
    values = function({x: 0.5, mine: 10.0})
    assert float(values["a"]) == pytest.approx(np.sin(0.5) + 10)
    assert float(values["b"]) == pytest.approx(np.sin(0.5) * 10)


# Random expressions from the whitelist have SymPy's value, within the rounding that their own operations allow.
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


def _away(value: float, error: float, least: float = 1e-3) -> bool:
    """Whether a value is so far from zero that its error does not matter."""
    return value > least + 1e3 * error


# Of one or two terms: SymPy's function, the number's, the error by those of the terms, and where it may be had.
_ONE_TERM: tuple[tuple[Any, Any, Any, Any], ...] = (
    (sp.sqrt, math.sqrt, lambda a: a.error / math.sqrt(a.value), lambda a: _away(a.value, a.error)),
    (sp.log, math.log, lambda a: a.error / a.value, lambda a: _away(a.value, a.error)),
    (sp.exp, math.exp, lambda a: math.exp(a.value) * a.error, lambda a: abs(a.value) < 20),
    (sp.sin, math.sin, lambda a: a.error + _EPS, lambda a: abs(a.value) < 20),
    (sp.tanh, math.tanh, lambda a: a.error, lambda a: True),
    (sp.Abs, abs, lambda a: a.error, lambda a: True),
    (lambda x: x**3, lambda x: x**3, lambda a: 3 * a.value**2 * a.error, lambda a: True),
)


def _sum_error(a: Term, b: Term) -> float:
    return a.error + b.error + _EPS * (abs(a.value) + abs(b.value))


def _crossed(a: Term, b: Term) -> float:
    return abs(a.value) * b.error + abs(b.value) * a.error


def _turns(a: Term, b: Term) -> bool:
    cut = b.value < 0 and abs(a.value) < 1e-6 + 1e3 * a.error
    return a.value**2 + b.value**2 > 1e-6 and not cut


_TWO_TERMS: tuple[tuple[Any, Any, Any, Any], ...] = (
    (lambda x, y: x + y, lambda x, y: x + y, _sum_error, lambda a, b: True),
    (lambda x, y: x - y, lambda x, y: x - y, _sum_error, lambda a, b: True),
    (lambda x, y: x * y, lambda x, y: x * y, _crossed, lambda a, b: True),
    (
        lambda x, y: x / y,
        lambda x, y: x / y,
        lambda a, b: (a.error + abs(a.value / b.value) * b.error) / abs(b.value),
        lambda a, b: _away(abs(b.value), b.error),
    ),
    (sp.Max, max, lambda a, b: max(a.error, b.error), lambda a, b: True),
    (sp.Min, min, lambda a, b: max(a.error, b.error), lambda a, b: True),
    (
        lambda x, y: sp.Piecewise((x, x < y), (2 * y, True)),
        lambda x, y: x if x < y else 2 * y,
        lambda a, b: a.error + 2 * b.error,
        lambda a, b: _away(abs(a.value - b.value), a.error + b.error, 1e-6),
    ),
    (sp.atan2, math.atan2, lambda a, b: _crossed(a, b) / (a.value**2 + b.value**2), _turns),
)


def _apply(operation: tuple[Any, Any, Any, Any], *terms: Term) -> Term:
    symbolic, number, error, admissible = operation
    assume(admissible(*terms))
    return _term(symbolic(*(t.expr for t in terms)), number(*(t.value for t in terms)), error(*terms))


_ONE, _TWO = st.sampled_from(_ONE_TERM), st.sampled_from(_TWO_TERMS)
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
        st.tuples(_TWO, inner, inner).map(lambda t: _apply(*t)), st.tuples(_ONE, inner).map(lambda t: _apply(*t))
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
