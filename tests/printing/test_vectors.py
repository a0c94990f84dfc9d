"""One cell's expression, given vectors, is the expression of all cells; common parts are shared."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np
import pytest
import sympy as sp

from softcat_sym.discretization.casadi_printer import CellFunction

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


def test_numeric_vectors_are_elementwise() -> None:
    for name in EXPRESSIONS:
        expr = EXPRESSIONS[name]
        found = np.asarray(CellFunction({"out": expr}, (x, y))({x: ca.DM(AT_X), y: ca.DM(AT_Y)})["out"]).ravel()
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


def test_names_and_order_of_outputs_are_kept() -> None:
    function = CellFunction({"later": y, "earlier": x}, (x, y))
    assert function.names == ("later", "earlier")
    assert function({x: 1.0, y: 2.0}) == {"later": 2.0, "earlier": 1.0}


def test_a_shared_symbol_cannot_meet_one_of_the_users() -> None:
    mine = sp.Symbol("w_0", real=True)
    function = CellFunction({"a": sp.sin(x) + mine, "b": sp.sin(x) * mine}, (x, mine))
    values = function({x: 0.5, mine: 10.0})
    assert float(values["a"]) == pytest.approx(np.sin(0.5) + 10)
    assert float(values["b"]) == pytest.approx(np.sin(0.5) * 10)
