"""Every term of every equation of the theory passes a dimension check, in symbols of the one table."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy.core.function import AppliedUndef

from softcat_sym.physics.equation import DimensionError, Equation, all_equations, check, dimension
from softcat_sym.physics.symbols import E, eta, field_entry, fields, s, sigma, sigma_Y, table

CATALOGUE = all_equations()
EVERY = [(module, equation) for module, equations in CATALOGUE.items() for equation in equations]


def test_every_term_has_the_dimension_of_its_equation() -> None:
    for _, equation in EVERY:
        check(equation)


def test_the_catalogue_spans_the_theory() -> None:
    modules = {name.partition(".")[0] for name in CATALOGUE}
    assert {"kinematics", "small_deflection", "regimes", "rheometry", "bulk", "necking", "reissner"} <= modules
    assert len(EVERY) > 200


def test_every_symbol_and_field_stands_in_the_table_with_its_latex() -> None:
    known = {row.symbol for row in table()}
    for module, equation in EVERY:
        both = sp.Tuple(equation.left, equation.right)
        bound = {limit[0] for integral in both.atoms(sp.Integral) for limit in integral.limits}
        assert (both.free_symbols | bound) <= known, (module, equation.name, both.free_symbols - known)
        for applied in both.atoms(AppliedUndef):
            field_entry(applied.func.__name__)
        assert equation.source, (module, equation.name)
    assert all(row.latex and row.meaning and row.source for row in (*table(), *fields()))
    assert len({row.symbol.name for row in table()}) == len(table())


@pytest.mark.parametrize(
    "wrong",
    [Equation("stress is a rate", sigma / eta, sigma, ""), Equation("sum", sigma + eta, sigma_Y, "")],
    ids=lambda equation: equation.name,
)
def test_the_check_can_say_no(wrong: Equation) -> None:
    with pytest.raises(DimensionError):
        check(wrong)


def test_functions_want_pure_numbers() -> None:
    assert dimension(sp.log(s)) == dimension(sp.Integer(1))
    with pytest.raises(DimensionError):
        dimension(sp.log(E))
