"""Weights, partial moments and contraction of the sections, against quadrature and symbolically."""

from __future__ import annotations

import math

import mpmath
import pytest
import sympy as sp

from softcat_sym.physics.sections import CIRCLE, NONE, RECTANGLE, SECTIONS, SHEET, UNIFORM, Section
from softcat_sym.physics.symbols import A0, c, h0, s, zeta

SHAPES = [RECTANGLE, CIRCLE]
EDGES = ["-0.999", "-0.7", "-0.2", "0", "0.35", "0.8", "0.99"]


def name(shape: Section) -> str:
    return shape.name


@pytest.mark.parametrize("shape", SHAPES, ids=name)
def test_the_weight_is_a_density_of_zeta(shape: Section) -> None:
    with mpmath.workdps(30):
        weight = sp.lambdify(zeta, shape.weight, "mpmath")
        for power, wanted in ((0, 1), (1, 0), (2, shape.zeta_squared)):
            found = mpmath.quad(
                lambda angle, n=power: weight(mpmath.sin(angle)) * mpmath.sin(angle) ** n * mpmath.cos(angle),
                [-mpmath.pi / 2, 0, mpmath.pi / 2],
            )
            assert abs(found - mpmath.mpf(int(sp.numer(wanted))) / int(sp.denom(wanted))) < mpmath.mpf(10) ** -24


@pytest.mark.parametrize("shape", SHAPES, ids=name)
@pytest.mark.parametrize("edge", EDGES)
def test_partial_moments_against_quadrature(shape: Section, edge: str) -> None:
    with mpmath.workdps(30):
        at = mpmath.mpf(edge)
        weight = sp.lambdify(zeta, shape.weight, "mpmath")

        def beyond(power: int, offset: mpmath.mpf | int) -> mpmath.mpf:
            # in zeta = sin(angle), so that the chord of a circle is smooth at its end
            def integrand(angle: mpmath.mpf) -> mpmath.mpf:
                place = mpmath.sin(angle)
                return (place - offset if offset != 1 else 1) * place**power * weight(place) * mpmath.cos(angle)

            return mpmath.quad(integrand, [mpmath.asin(at), mpmath.pi / 2])

        for expr, wanted in (
            (shape.area, beyond(0, 1)),
            (shape.overstress_mean, beyond(0, at)),
            (shape.overstress_moment, beyond(1, at)),
        ):
            found = sp.lambdify(c, expr, "mpmath")(at)
            assert abs(found - wanted) < mpmath.mpf(10) ** -24


@pytest.mark.parametrize("shape", SHAPES, ids=name)
def test_derivatives_of_the_partial_moments(shape: Section) -> None:
    """K_n' = -J_n, the integral of zeta^n w beyond c, and J_n' = -c^n w(c)."""
    weight = shape.weight.subs(zeta, c)
    assert sp.simplify(sp.diff(shape.overstress_mean, c) + shape.area) == 0
    assert sp.simplify(sp.diff(shape.area, c) + weight) == 0
    first = -sp.diff(shape.overstress_moment, c)
    assert sp.simplify(sp.diff(first, c) + c * weight) == 0
    assert sp.limit(first, c, 1, "-") == 0


@pytest.mark.parametrize("shape", SHAPES, ids=name)
def test_nothing_lies_beyond_the_upper_fibre_and_all_beyond_the_lower(shape: Section) -> None:
    for expr, below in ((shape.area, 1), (shape.overstress_mean, 1), (shape.overstress_moment, shape.zeta_squared)):
        assert expr.subs(c, 1) == 0
        assert sp.simplify(expr.subs(c, -1) - below) == 0


@pytest.mark.parametrize("shape", SHAPES, ids=name)
def test_the_interval_of_the_edge_is_the_section(shape: Section) -> None:
    low, high = shape.interval
    assert -1 <= low < high <= 1
    assert float(high - low) == pytest.approx(2, abs=1e-13)
    slopes = [sp.diff(e, c) for e in (shape.area, shape.overstress_mean, shape.overstress_moment)]
    assert all(math.isfinite(slope.subs(c, end)) for slope in slopes for end in (low, high))


def test_second_moments_are_those_of_the_textbook() -> None:
    width, thickness = sp.symbols("D h", positive=True)
    half = thickness / 2
    assert width * thickness * half**2 * RECTANGLE.zeta_squared == width * thickness**3 / 12
    assert sp.pi * half**2 * half**2 * CIRCLE.zeta_squared == sp.pi * thickness**4 / 64


def test_uniform_contraction_keeps_the_volume_and_the_shape() -> None:
    assert UNIFORM.area * s == A0
    assert sp.simplify(UNIFORM.thickness**2 / UNIFORM.area - h0**2 / A0) == 0
    assert UNIFORM.area.subs(s, 1) == NONE.area == A0
    assert UNIFORM.thickness.subs(s, 1) == NONE.thickness == h0


def test_sections_are_found_by_the_name_in_the_scene() -> None:
    assert SECTIONS == {"rectangle": RECTANGLE, "circle": CIRCLE, "sheet": SHEET}
