"""Every term of every expression has the dimension that the table of symbols gives it."""

from __future__ import annotations

import pytest
import sympy as sp

from softcat_sym.physics import symbols as sy
from softcat_sym.physics.equation import PURE as NONE
from softcat_sym.physics.equation import DimensionError as MismatchError
from softcat_sym.physics.equation import dimension
from softcat_sym.physics.kinematics import mass_per_length
from softcat_sym.physics.laws import bingham_rate, elastic_stress, maxwell_rate
from softcat_sym.physics.loads import ramp_rate, ramped_gravity, shaking, shaking_rate
from softcat_sym.physics.sections import SECTIONS

from .variants import all_filaments, expressions

FORCE_RATE = (1, 1, -3)
WANTED = {
    "stress_mean": sy.STRESS,
    "stress_bending": sy.STRESS,
    "area": sy.AREA,
    "thickness": sy.LENGTH,
    "tension": sy.FORCE,
    "moment": sy.MOMENT,
    "stress_of_tension": sy.STRESS,
    "stress_of_moment": sy.STRESS,
    "axial_correction": sy.FORCE,
    # volume per unit length
    "volume": sy.AREA,
    "rate_mean": sy.RATE,
    "rate_bending": sy.RATE,
    # energy per unit length is a force
    "elastic_mean": sy.FORCE,
    "elastic_bending": sy.FORCE,
    "dissipation_mean": FORCE_RATE,
    "dissipation_bending": FORCE_RATE,
    "means.rate": sy.RATE,
    "means.bending_rate": sy.RATE,
    "means.yielded_fraction": sy.ONE,
    "means.largest_rate": sy.RATE,
    "stretch_gradient_x": sy.ONE,
    "stretch_gradient_y": sy.ONE,
    "angle_gradient_x": sy.ONE,
    "angle_gradient_y": sy.ONE,
    "force.horizontal": sy.FORCE,
    "force.vertical": sy.FORCE,
    "gravity": sy.ACCELERATION,
    "gravity_rate": (0, 1, -3),
    "stretch": sy.ONE,
    "turning": sy.ONE,
    "strain": sy.ONE,
    "arc_stretch": sy.ONE,
}


def test_every_expression_of_every_filament() -> None:
    seen: dict[tuple[str, sp.Expr], None] = {}
    for equations in all_filaments():
        for name, expr in expressions(equations).items():
            if (name, expr) in seen:
                continue
            seen[name, expr] = None
            found = dimension(expr)
            assert found is None or found == tuple(WANTED[name]), (name, expr)
    assert {name for name, _ in seen} == set(WANTED)


def test_every_symbol_is_in_the_table() -> None:
    known = {row.symbol for row in sy.table()}
    for equations in all_filaments():
        for name, expr in expressions(equations).items():
            assert expr.free_symbols <= known, (name, expr.free_symbols - known)


def test_the_laws_themselves() -> None:
    for expr, wanted in [
        (mass_per_length(), (1, -1, 0)),
        (ramped_gravity(), sy.ACCELERATION),
        (ramp_rate(), (0, 1, -3)),
        (shaking(), sy.ONE),
        (shaking_rate(), sy.RATE),
        (maxwell_rate(), sy.RATE),
        (bingham_rate(), sy.RATE),
        (elastic_stress(sp.log(sy.s), sy.a_0), sy.STRESS),
    ]:
        assert dimension(expr) == wanted


@pytest.mark.parametrize("name", SECTIONS)
def test_sections_are_dimensionless(name: str) -> None:
    shape = SECTIONS[name]
    for expr in (shape.weight, shape.area, shape.overstress_mean, shape.overstress_moment):
        assert dimension(expr) == NONE


def test_the_check_itself_can_say_no() -> None:
    for wrong in [
        sy.sigma + sy.eta,
        sp.log(sy.h0),
        sp.Max(sy.sigma, 1),
        sp.Piecewise((sy.sigma, sy.sigma > sy.sigma_Y), (sy.eta, True)),
        sp.Piecewise((sy.sigma, sy.sigma > 1), (0, True)),
        sp.atan2(sy.h0, sy.s),
        2**sy.t,
        sy.s + sy.E / (1 + sy.g_on),
    ]:
        with pytest.raises(MismatchError):
            dimension(wrong)


def test_the_table_has_no_two_rows_of_one_name() -> None:
    rows = sy.table()
    assert len({row.symbol.name for row in rows}) == len(rows)
    assert all(row.meaning and row.latex and row.source for row in rows)
    assert sy.entry(sy.E).dimension == sy.STRESS
    with pytest.raises(KeyError):
        sy.entry(sp.Symbol("E"))
