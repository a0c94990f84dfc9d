"""The printer against twenty-digit SymPy, over a table of expressions at random admissible points."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from .exact import exact, printed

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


def test_the_table_is_long_enough() -> None:
    assert len(SMOOTH) >= 40
