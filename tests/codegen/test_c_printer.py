"""Every elementary operation is in C what it is in CasADi, and what all sites share is computed once."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from softcat_sym.codegen.c_printer import Target, When, number, statements
from softcat_sym.codegen.recording import Code, Instruction, code_of
from softcat_sym.errors import PrintingError

from .snippets import compiled, evaluated, text_of, values

A, B, C = (ca.SX.sym(name) for name in "abc")
OPERATIONS: dict[str, ca.SX] = {
    "ADD": A + B,
    "SUB": A - B,
    "MUL": A * B,
    "DIV": A / B,
    "NEG": -A,
    "INV": 1 / A,
    "TWICE": 2 * A,
    "SQ": A * A,
    "EXP": ca.exp(A),
    "LOG": ca.log(ca.fabs(A)),
    "POW": ca.power(ca.fabs(A), B),
    "CONSTPOW": ca.power(ca.fabs(A), 0.3),
    "SQRT": ca.sqrt(ca.fabs(A)),
    "SIN": ca.sin(A),
    "COS": ca.cos(A),
    "TAN": ca.tan(A),
    "ASIN": ca.asin(A / 10),
    "ACOS": ca.acos(A / 10),
    "ATAN": ca.atan(A),
    "ATAN2": ca.atan2(A, B),
    "SINH": ca.sinh(A),
    "COSH": ca.cosh(A),
    "TANH": ca.tanh(A),
    "FABS": ca.fabs(A),
    "COPYSIGN": ca.copysign(A, B),
    "LOG1P": ca.log1p(ca.fabs(A)),
    "EXPM1": ca.expm1(A),
    "HYPOT": ca.hypot(A, B),
    "FMIN": ca.fmin(A, B),
    "FMAX": ca.fmax(A, B),
    "SIGN": ca.sign(A),
    "LT": A < B,
    "LE": A <= B,
    "EQ": ca.eq(A, B),
    "NE": ca.ne(A, B),
    "NOT": ca.logic_not(A),
    "AND": ca.logic_and(A, B),
    "OR": ca.logic_or(A, B),
    "IF_ELSE_ZERO": ca.if_else(A < B, C, 0),
}


def points() -> np.ndarray:
    """Random ones, and those at which cases differ: equal, zero, of either sign."""
    generator = np.random.default_rng(3)
    edges = [[0, 0, 1], [0, 1, 2], [1, 0, 2], [-1, 0, 2], [2, 2, 3], [-2, -2, 3], [0, -1, 1]]
    return np.concatenate([generator.uniform(-3, 3, (40, 3)), np.array(edges, dtype=float)])


def test_every_operation_is_casadis() -> None:
    x, expressions = points(), list(OPERATIONS.values())
    with np.errstate(all="ignore"):
        found, wanted = compiled([A, B, C], expressions, x), evaluated([A, B, C], expressions, x)
    for k, name in enumerate(OPERATIONS):
        used = {one.operation for one in code_of([A, B, C], [expressions[k]]).instructions}
        assert name in used, f"{name} is not what CasADi makes of it: {used}"
        np.testing.assert_allclose(found[:, k], wanted[:, k], rtol=4e-16, atol=0, err_msg=name)


def test_the_order_of_operations_is_kept() -> None:
    nested = [A - (B - C), (A - B) - C, A / (B / C), A / B / C, -(A + B) * C, A - (-B), (A + B) * (A - C), -(-A - 1.5)]
    x = np.random.default_rng(4).uniform(0.5, 2, (20, 3))
    np.testing.assert_allclose(compiled([A, B, C], nested, x), evaluated([A, B, C], nested, x), rtol=1e-15, atol=1e-15)


def test_deep_expressions_are_cut_into_statements() -> None:
    deep = A
    for k in range(60):
        deep = ca.sin(deep * B + k) - C
    x = np.random.default_rng(4).uniform(0.5, 2, (5, 3))
    code = code_of([A, B, C], [deep])
    assert max(map(len, text_of(code, 3).splitlines())) < 200
    np.testing.assert_allclose(compiled([A, B, C], [deep], x), evaluated([A, B, C], [deep], x), rtol=1e-13)


def test_equal_expressions_are_computed_once() -> None:
    code = code_of([A, B], [ca.exp(A * B) + 1, ca.exp(A * B) * 2, ca.SX(0), A])
    names = [one.operation for one in code.instructions]
    assert names.count("EXP") == names.count("MUL") == 1
    assert code.instructions[code.results[2]] == Instruction("CONST", (), 0.0)


def test_what_all_rows_share_is_computed_before_the_loop() -> None:
    code = code_of([A, B], [ca.exp(B) * A, ca.exp(B) + B])
    found = statements(code, ["y[i]", "p[0]"], [When.SITE, When.BEFORE], [Target("f[i]"), Target("g[i]")])
    assert sum("exp" in line for line in found[When.BEFORE]) == 1
    assert not any("exp" in line for line in found[When.SITE])
    x = np.array([[1.0, 0.5], [2.0, 99.0]])
    found = values(text_of(code, 2, [False, True]), x, 2)
    np.testing.assert_allclose(found, [[np.exp(0.5), np.exp(0.5) + 0.5], [2 * np.exp(0.5), np.exp(0.5) + 0.5]])


def test_what_all_fibres_of_a_site_share_is_computed_before_the_loop_over_them() -> None:
    code = code_of([A, B], [ca.exp(B) * A])
    found = statements(code, ["z[k]", "y[i]"], [When.FIBRE, When.SITE], [Target("sum", each=True, adds=True)])
    assert "exp" in found[When.SITE][0]
    assert found[When.FIBRE] == ["sum += v1 * z[k];"]


def test_a_fibre_that_needs_the_sum_over_all_of_them_is_refused() -> None:
    with pytest.raises(PrintingError, match="sum over all"):
        statements(code_of([A, B], [A * B]), ["z[k]", "sum"], [When.FIBRE, When.AFTER], [Target("f[i]")])
    with pytest.raises(PrintingError, match="fibres"):
        statements(code_of([A], [ca.sin(A)]), ["z[k]"], [When.FIBRE], [Target("f[i]")])


def test_numbers_are_read_as_the_same() -> None:
    for value in [0.1, -0.1, 1e-300, 1 / 3, 5e-324, 1.7976931348623157e308, 12345678901234567.0]:
        code = Code((Instruction("CONST", (), value),), (0,))
        assert values(text_of(code, 1), np.zeros((1, 1)), 1)[0, 0] == value


def test_infinity_has_a_text_and_what_is_no_number_has_none() -> None:
    assert (number(float("inf")), number(float("-inf"))) == ("HUGE_VAL", "(-HUGE_VAL)")
    with pytest.raises(PrintingError, match="not a number"):
        number(float("nan"))


def test_an_operation_without_c_is_refused() -> None:
    with pytest.raises(PrintingError, match="ERF"):
        statements(code_of([A], [ca.erf(A)]), ["x"], [When.SITE], [Target("y")])


def test_a_symbol_that_is_no_input_is_refused() -> None:
    with pytest.raises(PrintingError, match="no input"):
        code_of([A], [A + B])
