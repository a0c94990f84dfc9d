"""Numbers arrive in CasADi as the nearest double, whatever SymPy calls them."""

from __future__ import annotations

import math
from fractions import Fraction

import casadi as ca
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from softcat_sym.discretization.casadi_printer import CasadiPrinter

from .exact import printed

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


@given(st.floats(-1e10, 1e10))
def test_a_coefficient_is_not_cut_inside_an_expression(value: float) -> None:
    assert printed(sp.Float(value) + x, {x: 0.0}) == value


def test_a_coefficient_is_not_cut_in_a_graph() -> None:
    variable = ca.SX.sym("x")
    graph = ca.Function("f", [variable], [CasadiPrinter({x: variable}).value(x + sp.Float(0.1234567890123456789))])
    assert float(graph(0.0)) == 0.1234567890123456789
