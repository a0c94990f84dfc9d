"""What the printer does not know it refuses, by name: nothing becomes NaN, or zero, in silence."""

from __future__ import annotations

import pytest
import sympy as sp

from softcat_sym.discretization.casadi_printer import CasadiPrinter, CellFunction
from softcat_sym.errors import PrintingError, SoftcatError

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


def test_refused_within_a_cell_function() -> None:
    for name in sorted(set(REFUSED) - {"matrix", "infinity", "minus infinity", "nan", "zoo"}):
        expr, word = REFUSED[name]
        with pytest.raises(PrintingError, match=word):
            CellFunction({"good": x, "bad": 2 * expr}, (x, y))({x: 1.0, y: 2.0})


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


def test_an_input_that_does_not_occur_needs_no_value() -> None:
    assert CellFunction({"a": 2 * x}, (x, hidden))({x: 1.5}) == {"a": 3.0}


def test_a_refusal_is_one_of_the_package_errors() -> None:
    assert issubclass(PrintingError, SoftcatError)
