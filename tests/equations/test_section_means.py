"""Means by quadrature: against closed forms and adaptive integration, and with derivatives wherever one may start."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from itertools import pairwise

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from softcat_sym.discretization.casadi_printer import CellFunction
from softcat_sym.physics.laws import (
    K,
    bingham_means,
    bingham_rate,
    herschel_bulkley_rate,
    maxwell_means,
    maxwell_rate,
    n,
    power_law_rate,
)
from softcat_sym.physics.sections import CIRCLE, RECTANGLE, Section, SectionMeans, quadrature_means, scaled
from softcat_sym.physics.symbols import E, eta, sigma_0, sigma_1, sigma_Y, zeta

from .means import MODULUS, VISCOSITY, YIELD, sign_cases

SHAPES = {shape.name: shape for shape in (RECTANGLE, CIRCLE)}
INDICES = (0.25, 0.3, 0.5, 0.7, 1.0, 1.4, 2.0)
NAMES = ("rate", "bending_rate", "yielded_fraction", "largest_rate")
each_shape = pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
few = settings(max_examples=40, deadline=None)
stresses = st.floats(-6, 6)

RULES: dict[str, tuple[sp.Expr, sp.Expr]] = {
    "power": (power_law_rate(), sp.S.Zero),
    "herschel-bulkley": (herschel_bulkley_rate(), sigma_Y),
}
MEANS = {
    (name, shape): quadrature_means(SHAPES[shape], rate, threshold)
    for name, (rate, threshold) in RULES.items()
    for shape in SHAPES
}
BINGHAM = {name: quadrature_means(shape, bingham_rate(), sigma_Y) for name, shape in SHAPES.items()}
CLOSED = {name: bingham_means(shape) for name, shape in SHAPES.items()}


def values(mean: float, slope: float, index: float = 1.0) -> dict[sp.Symbol, float]:
    """Stresses in units of the yield stress; a rate of one at a stress of one."""
    return {sigma_0: mean, sigma_1: slope, sigma_Y: 1.0, E: 400.0, K: 1.0, n: index}


@cache
def _printed(means: SectionMeans) -> tuple[list[sp.Symbol], ca.Function]:
    outputs = {name: sp.sympify(getattr(means, name)) for name in NAMES}
    symbols = sorted(set().union(*(value.free_symbols for value in outputs.values())), key=str)
    inputs = {symbol: ca.SX.sym(symbol.name) for symbol in symbols}
    found = CellFunction(outputs, symbols)(inputs)
    return symbols, ca.Function("means", list(inputs.values()), [ca.SX(found[name]) for name in NAMES])


def at(means: SectionMeans, given_values: dict[sp.Symbol, float]) -> dict[str, float]:
    symbols, function = _printed(means)
    return dict(zip(NAMES, map(float, function(*(given_values[symbol] for symbol in symbols))), strict=True))


def integrated(shape: Section, flow: Callable[[float], float], mean: float, slope: float, kinks: tuple[float, ...]):
    """<phi> and <phi zeta>/<zeta^2>, adaptively in zeta = sin(angle) between the kinks."""
    inside = [(kink - mean) / slope for kink in kinks if slope != 0 and abs(kink - mean) < abs(slope)]
    angles = [math.asin(edge) for edge in sorted({-1.0, 1.0, *inside})]

    def density(angle: float) -> float:
        return 2 / math.pi * math.cos(angle) ** 2 if shape is CIRCLE else math.cos(angle) / 2

    def moment(order: int) -> float:
        def integrand(angle: float) -> float:
            return flow(mean + slope * math.sin(angle)) * density(angle) * math.sin(angle) ** order

        return sum(quad(integrand, a, b, epsabs=0, epsrel=1e-10, limit=200)[0] for a, b in pairwise(angles))

    return moment(0), moment(1) / float(shape.zeta_squared)


@each_shape
@pytest.mark.parametrize("case", sign_cases())
def test_of_the_bingham_rule_they_are_the_closed_ones(shape: Section, case: str) -> None:
    mean, slope = (YIELD * value for value in sign_cases()[case])
    point = {sigma_0: mean, sigma_1: slope, sigma_Y: YIELD, eta: VISCOSITY, E: MODULUS}
    found, wanted = at(BINGHAM[shape.name], point), at(CLOSED[shape.name], point)
    scale = (abs(mean) + abs(slope)) / VISCOSITY
    within = 1e-14 if shape is RECTANGLE else 1e-6
    for name in ("rate", "bending_rate", "largest_rate"):
        assert found[name] == pytest.approx(wanted[name], abs=within * scale, rel=0), name
    assert found["yielded_fraction"] == pytest.approx(wanted["yielded_fraction"], abs=1e-12)


@each_shape
def test_of_the_maxwell_rule_they_are_the_closed_ones(shape: Section) -> None:
    found, wanted = quadrature_means(shape, maxwell_rate(), sp.S.Zero), maxwell_means(shape)
    for mean, slope in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.3, -0.7), (-2.0, 0.1)):
        point = {sigma_0: mean, sigma_1: slope, eta: 2.0, E: 400.0}
        for name, value in at(wanted, point).items():
            assert at(found, point)[name] == pytest.approx(value, abs=1e-14 if shape is RECTANGLE else 1e-6)


@pytest.mark.parametrize("index", INDICES)
@pytest.mark.parametrize(("name", "shape"), MEANS)
def test_against_adaptive_integration(name: str, shape: str, index: float) -> None:
    threshold = 0.0 if name == "power" else 1.0

    def flow(stress: float) -> float:
        return math.copysign(max(abs(stress) - threshold, 0) ** (1 / index), stress)

    worst = 0.0
    for mean, slope in np.random.default_rng(3).normal(0, 2.5, (25, 2)):
        found = at(MEANS[name, shape], values(mean, slope, index))
        wanted = integrated(SHAPES[shape], flow, mean, slope, (threshold, -threshold))
        size = max(map(abs, wanted))
        misses = abs(found["rate"] - wanted[0]), abs(found["bending_rate"] - wanted[1])
        worst = max(worst, max(misses) / size if size else max(misses))
    assert worst < 3e-6


def test_derivatives_are_finite_wherever_one_may_start() -> None:
    for index in INDICES:
        for name, shape in MEANS:
            means = MEANS[name, shape]
            stress = ca.SX.sym("stress", 2)
            point = {**values(0.0, 0.0, index), sigma_0: stress[0], sigma_1: stress[1]}
            rates = CellFunction({key: getattr(means, key) for key in NAMES}, tuple(point))(point)
            both = ca.vertcat(*(rates[key] for key in NAMES))
            function = ca.Function("means", [stress], [both, ca.jacobian(both, stress)])
            starts = [
                (a, b)
                for a in (0.0, 0.5, 1.0, 3.0, -1.0, -3.0)
                for b in (0.0, 1e-12, 0.5, 1.0, 2.0, 4.0, -2.0, -1e-300)
            ]
            for start in starts:
                for value in function(start):
                    assert np.all(np.isfinite(np.array(value))), start


@each_shape
@pytest.mark.parametrize("index", (0.5, 1.0, 2.0))
def test_a_uniform_section_that_flows_resists_bending(shape: Section, index: float) -> None:
    """At zero moment the bending rate has the slope of the rule itself, phi'(sigma_0), and not that of a sign."""
    stress = ca.SX.sym("stress", 2)
    for name, threshold in (("power", 0.0), ("herschel-bulkley", 1.0)):
        point = {**values(3.0, 0.0, index), sigma_0: stress[0], sigma_1: stress[1]}
        means = MEANS[name, shape.name]
        rates = CellFunction({"mean": means.rate, "bend": means.bending_rate}, tuple(point))(point)
        jacobian = ca.Function("j", [stress], [ca.jacobian(ca.vertcat(rates["mean"], rates["bend"]), stress)])
        slope = (3.0 - threshold) ** (1 / index - 1) / index
        assert np.array(jacobian((3.0, 0.0))) == pytest.approx(slope * np.eye(2), rel=2e-6, abs=2e-6 * slope)


@pytest.mark.parametrize(("name", "shape"), MEANS)
@few
@given(mean=stresses, slope=stresses, step=st.floats(0, 1), index=st.sampled_from(INDICES))
def test_odd_monotone_and_never_giving_work_back(
    name: str, shape: str, mean: float, slope: float, step: float, index: float
) -> None:
    means = MEANS[name, shape]
    found, opposite = at(means, values(mean, slope, index)), at(means, values(-mean, -slope, index))
    largest = at(means, values(abs(mean) + step, abs(slope) + step, index))["largest_rate"]
    # Which side is in tension is not known where the stress varies by less than 1e-30 E.
    noise = 1e-12 * largest + 1e-25
    for key in ("rate", "bending_rate"):
        assert found[key] == pytest.approx(-opposite[key], abs=noise)
    assert mean * found["rate"] + slope * found["bending_rate"] * float(SHAPES[shape].zeta_squared) >= -noise * 12
    error = 1e-5 * largest
    assert at(means, values(mean + step, slope, index))["rate"] >= found["rate"] - error
    assert at(means, values(mean, slope + step, index))["bending_rate"] >= found["bending_rate"] - 4 * error


@few
@given(share=st.floats(-1, 1), size=st.floats(0, 0.999), index=st.sampled_from(INDICES))
def test_below_yield_nothing_flows_at_all(share: float, size: float, index: float) -> None:
    for shape in SHAPES:
        point = values(size * share, size * (1 - abs(share)), index)
        assert set(at(MEANS["herschel-bulkley", shape], point).values()) == {0.0}


def test_a_wide_sheet_flows_by_the_rule_of_its_equivalent_stress() -> None:
    """r phi(r sigma), r = sqrt(3)/2: 4/3 of the viscosity, 2/sqrt(3) of the yield stress, (2/sqrt(3))^(n+1) of K."""
    r = math.sqrt(3) / 2
    base = {sigma_0: 1.7, sigma_1: -0.9, E: 400.0}
    fluids = {"maxwell": maxwell_means(RECTANGLE), "bingham": CLOSED["rectangle"]}
    fluids |= {name: MEANS[name, "rectangle"] for name in RULES}
    for means in fluids.values():
        sheet = scaled(means, sp.sqrt(3) / 2)
        for index in INDICES:
            material = {eta: 2.0, sigma_Y: 1.0, K: 2.0, n: index}
            wide = {eta: 2.0 * 4 / 3, sigma_Y: 1 / r, K: 2.0 * r ** -(index + 1), n: index}
            assert at(sheet, {**base, **material}) == pytest.approx(at(means, {**base, **wide}), rel=1e-11)


def test_a_weight_it_does_not_know_is_refused() -> None:
    wrong = replace(RECTANGLE, name="wedge", weight=(1 + zeta) / 2)
    with pytest.raises(ValueError, match="wedge"):
        quadrature_means(wrong, maxwell_rate(), sp.S.Zero)
