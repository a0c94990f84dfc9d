"""Sections: shapes, means over them, and the moment that bends them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import pairwise, product

import casadi as ca
import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad
from scipy.optimize import linprog

from softcat_sym.discretization.casadi_printer import CellFunction
from softcat_sym.discretization.section_rule import SectionRule, fibre_rule, order_rule
from softcat_sym.physics.constitutive_laws import (
    K,
    bingham_means,
    bingham_rate,
    herschel_bulkley_rate,
    maxwell_means,
    maxwell_rate,
    n,
    power_law_rate,
)
from softcat_sym.physics.sections import (
    CIRCLE,
    RECTANGLE,
    SECTIONS,
    Section,
    SectionMeans,
    quadrature_means,
)
from softcat_sym.physics.symbols import E, c, eta, sigma_0, sigma_1, sigma_Y, zeta
from tests.common.filaments import Array
from tests.common.one_cell import bend_slowly, one_cell

# Means of the Bingham rule over a section: the package's closed forms, and a reference that knows none of them.
MODULUS, VISCOSITY, YIELD = 4e6, 13.84e3, 9.32e3


@dataclass(frozen=True)
class Means:
    """<phi>, <phi zeta>, yielded fraction and largest rate."""

    rate: float
    moment: float
    yielded: float
    largest: float


@cache
def _compiled(section: str) -> Callable[..., tuple[float, ...]]:
    means = bingham_means(SECTIONS[section])
    moment = means.bending_rate * SECTIONS[section].zeta_squared
    expressions = [means.rate, moment, means.yielded_fraction, means.largest_rate]
    return sp.lambdify((sigma_0, sigma_1, sigma_Y, eta, E), expressions, modules="math")


def closed_form(section: str, mean: float, slope: float, *, threshold: float = YIELD) -> Means:
    """The package's means, where the stress is mean + slope zeta."""
    return Means(*_compiled(section)(mean, slope, threshold, VISCOSITY, MODULUS))


def flow_rule(stress: np.ndarray) -> np.ndarray:
    """<|sigma| - sigma_Y> sign(sigma)/eta."""
    return np.sign(stress) * np.maximum(np.abs(stress) - YIELD, 0.0) / VISCOSITY


def quadrature(section: str, mean: float, slope: float) -> Means:
    """Gauss quadrature in zeta = sin(angle), split at the yield points, where the flow rule has its kinks."""
    edges = [-1.0, 1.0]
    if slope != 0:
        edges += [zeta for zeta in ((YIELD - mean) / slope, (-YIELD - mean) / slope) if -1 < zeta < 1]
    angles = np.arcsin(np.sort(edges))
    nodes, weights = np.polynomial.legendre.leggauss(40)
    totals = np.zeros(3)
    for low, high in pairwise(angles):
        angle = (high + low) / 2 + (high - low) / 2 * nodes
        zeta = np.sin(angle)
        density = 2 / math.pi * np.cos(angle) if section == "circle" else np.full_like(zeta, 0.5)
        measure = weights * (high - low) / 2 * density * np.cos(angle)
        stress = mean + slope * zeta
        rate = flow_rule(stress)
        totals += [np.sum(measure * rate), np.sum(measure * rate * zeta), np.sum(measure * (np.abs(stress) > YIELD))]
    largest = float(np.max(np.abs(flow_rule(np.array([mean - slope, mean + slope])))))
    return Means(*map(float, totals), largest)


def sign_cases() -> dict[str, tuple[float, float]]:
    """(sigma_0, sigma_1) in units of the yield stress: every way to yield, in all four quadrants."""
    cases = {
        "rest": (0.0, 0.0),
        "below everywhere": (0.3, 0.4),
        "exactly at yield on one side": (0.25, 0.75),
        "exactly at yield, pure bending": (0.0, 1.0),
        "one side": (0.5, 1.2),
        "one side, barely": (0.5, 0.5001),
        "both sides": (0.2, 3.0),
        "both sides, pure bending": (0.0, 2.5),
        "half in tension": (1.0, 2.0),
        "right through": (3.0, 0.7),
        "right through, exactly": (2.0, 1.0),
        "right through, uniform": (1.7, 0.0),
        "uniform below": (0.7, 0.0),
        "nearly uniform above": (1.7, 1e-9),
        "nearly uniform at yield": (1.0, 1e-9),
        "very steep": (0.5, 500.0),
        "very far": (400.0, 3.0),
    }
    return {
        f"{name} {'+-'[a < 0]}{'+-'[b < 0]}": (a * mean, b * slope)
        for name, (mean, slope) in cases.items()
        for a in (1, -1)
        for b in (1, -1)
    }


# Weights, partial moments and contraction of the sections, against quadrature and symbolically.
SHAPES = [RECTANGLE, CIRCLE]
EDGES = ["-0.999", "-0.7", "-0.2", "0", "0.35", "0.8", "0.99"]


def name(shape: Section) -> str:
    return shape.name


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


# Means by quadrature: against closed forms and adaptive integration, and with derivatives wherever one may start.
MEAN_SHAPES = {shape.name: shape for shape in (RECTANGLE, CIRCLE)}
INDICES = (0.25, 0.3, 0.5, 0.7, 1.0, 1.4, 2.0)
NAMES = ("rate", "bending_rate", "yielded_fraction", "largest_rate")
each_shape = pytest.mark.parametrize("shape", MEAN_SHAPES.values(), ids=MEAN_SHAPES)

RULES: dict[str, tuple[sp.Expr, sp.Expr]] = {
    "power": (power_law_rate(), sp.S.Zero),
    "herschel-bulkley": (herschel_bulkley_rate(), sigma_Y),
}
EACH_MEAN = pytest.mark.parametrize(("name", "shape"), [*product(RULES, MEAN_SHAPES)])
CLOSED = {name: bingham_means(shape) for name, shape in MEAN_SHAPES.items()}


@cache
def by_quadrature(name: str, shape: str) -> SectionMeans:
    """Means of a rule by name, Bingham's among them."""
    rate, threshold = {**RULES, "bingham": (bingham_rate(), sigma_Y)}[name]
    return quadrature_means(MEAN_SHAPES[shape], rate, threshold)


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
    found, wanted = at(by_quadrature("bingham", shape.name), point), at(CLOSED[shape.name], point)
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
@EACH_MEAN
def test_against_adaptive_integration(name: str, shape: str, index: float) -> None:
    threshold = 0.0 if name == "power" else 1.0

    def flow(stress: float) -> float:
        return math.copysign(max(abs(stress) - threshold, 0) ** (1 / index), stress)

    worst = 0.0
    for mean, slope in np.random.default_rng(3).normal(0, 2.5, (25, 2)):
        found = at(by_quadrature(name, shape), values(mean, slope, index))
        wanted = integrated(MEAN_SHAPES[shape], flow, mean, slope, (threshold, -threshold))
        size = max(map(abs, wanted))
        misses = abs(found["rate"] - wanted[0]), abs(found["bending_rate"] - wanted[1])
        worst = max(worst, max(misses) / size if size else max(misses))
    assert worst < 3e-6


@each_shape
@pytest.mark.parametrize("index", (0.5, 1.0, 2.0))
def test_a_uniform_section_that_flows_resists_bending(shape: Section, index: float) -> None:
    """At zero moment the bending rate has the slope of the rule itself, phi'(sigma_0), and not that of a sign."""
    stress = ca.SX.sym("stress", 2)
    for name, threshold in (("power", 0.0), ("herschel-bulkley", 1.0)):
        point = {**values(3.0, 0.0, index), sigma_0: stress[0], sigma_1: stress[1]}
        means = by_quadrature(name, shape.name)
        rates = CellFunction({"mean": means.rate, "bend": means.bending_rate}, tuple(point))(point)
        jacobian = ca.Function("j", [stress], [ca.jacobian(ca.vertcat(rates["mean"], rates["bend"]), stress)])
        slope = (3.0 - threshold) ** (1 / index - 1) / index
        assert np.array(jacobian((3.0, 0.0))) == pytest.approx(slope * np.eye(2), rel=2e-6, abs=2e-6 * slope)


# The closed-form means of the Bingham rule, (2.26) and (2.27), against quadrature and the paper's own letters.
CASES = sign_cases()
BINGHAM_SHAPES = sorted(SECTIONS)


def agree(one: Means, two: Means, mean: float, slope: float, rel: float = 2e-14) -> None:
    scale = (abs(mean) + abs(slope)) / VISCOSITY
    assert one.rate == pytest.approx(two.rate, abs=rel * scale, rel=0)
    assert one.moment == pytest.approx(two.moment, abs=rel * scale, rel=0)
    assert one.yielded == pytest.approx(two.yielded, abs=1e-6)


def test_every_sign_case_against_quadrature() -> None:
    for section in BINGHAM_SHAPES:
        for case in CASES:
            mean, slope = (YIELD * value for value in CASES[case])
            found, wanted = closed_form(section, mean, slope), quadrature(section, mean, slope)
            agree(found, wanted, mean, slope)
            assert found.largest == pytest.approx(wanted.largest, rel=1e-12, abs=1e-12 * YIELD / VISCOSITY)


# Slow bending of an elastoplastic section, against the exact curves and ultimate moments of textbooks.
YIELD_SLOW = 1e-3
SECOND = {"rectangle": 1 / 3, "circle": 1 / 4}
ULTIMATE = {"rectangle": 3 / 2, "circle": 16 / (3 * np.pi)}
"""M_p/M_Y: sY b h^2/4 over sY b h^2/6, sY d^3/6 over pi sY d^3/32."""
FURTHEST = 10.0
CURVATURE = np.linspace(0.0, FURTHEST, 61)
SLOWNESS = 1e9
"""Relaxation times in which the curvature grows by that of first yield: the overstress of a fibre is a billionth, that
of an outermost point that flows for a whole section as many times more as its weight is less."""
OVERSTRESS = 1e-5
BENDING_RULES = {"fibres": (6, 12, 24, 64), "order": (1, 3, 5, 8)}


def exact(section: str, curvature: Array) -> Array:
    """M/M_Y of kappa/kappa_Y: an elastic core within c = kappa_Y/kappa of the centre, yield outside (Nadai 1931).

    Rectangle 3/2 (1 - c^2/3); circle (2/pi) [ asin(c)/c + (5 - 2 c^2) sqrt(1 - c^2)/3 ].
    """
    c = 1 / np.maximum(curvature, 1.0)
    plastic = {
        "rectangle": 3 / 2 * (1 - c**2 / 3),
        "circle": 2 / np.pi * (np.arcsin(c) / c + (5 - 2 * c**2) * np.sqrt(1 - c**2) / 3),
    }
    return np.where(curvature <= 1, curvature, plastic[section])


def found(section: str, rule: SectionRule) -> tuple[Array, Array]:
    """Mean stress over sY and M/M_Y; E = h0 = 1, so that kappa_Y = 2 sY."""
    turning = 2 * YIELD_SLOW * CURVATURE
    tension, moment = bend_slowly(one_cell(section, rule, YIELD_SLOW), rule, turning, SLOWNESS * CURVATURE[1])
    return tension / YIELD_SLOW, -moment / (YIELD_SLOW * SECOND[section] / 2)


def rule_of(section: str, kind: str, number: int) -> SectionRule:
    return fibre_rule(section, number) if kind == "fibres" else order_rule(section, number, 24)


def limit_moment(section: str, rule: SectionRule) -> float:
    """M_p/M_Y by the static theorem: the largest moment of a stress that exceeds yield nowhere, a linear program."""
    objective = -(rule.weight * rule.zeta) @ rule.recall / SECOND[section]
    both = np.vstack([rule.recall, -rule.recall])
    solved = linprog(objective, A_ub=both, b_ub=np.ones(len(both)), bounds=[(None, None)] * rule.states)
    assert solved.success
    return -float(solved.fun)


@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_closed_forms_are_integrals_over_the_section(section: str) -> None:
    """sigma = max(-1, min(1, kappa zeta)), and all of it at yield for the ultimate moment."""

    def width(zeta: float) -> float:
        return 1.0 if section == "rectangle" else 4 / np.pi * np.sqrt(1 - zeta**2)

    for curvature in (0.5, 1.0, 1.3, 3.0, 20.0):
        core = min(1.0, 1 / curvature)
        parts = ((0.0, core), (core, 1.0))
        whole = sum(quad(lambda z: z * min(1.0, curvature * z) * width(z), *part)[0] for part in parts)  # noqa: B023
        assert exact(section, np.array([curvature]))[0] == pytest.approx(whole / SECOND[section], abs=1e-9)
    ultimate = quad(lambda z: z * width(z), 0, 1)[0] / SECOND[section]
    assert pytest.approx(ultimate, abs=1e-9) == ULTIMATE[section]
    assert exact(section, np.array([1e6]))[0] == pytest.approx(ultimate, abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_moment_follows_curvature(section: str) -> None:
    wanted = exact(section, CURVATURE)
    curve: dict[str, list[float]] = {"fibres": [], "order": []}
    for kind, numbers in BENDING_RULES.items():
        for number in numbers:
            rule = rule_of(section, kind, number)
            axial, moment = found(section, rule)
            error = float(np.max(np.abs(moment - wanted)) / ULTIMATE[section])
            limit = limit_moment(section, rule)
            curve[kind].append(error)
            assert np.max(np.abs(axial)) < 1e-9
            assert moment.max() <= limit + OVERSTRESS
            # Drucker: no softening, whatever the stresses are free to do
            assert np.all(np.diff(moment) > -OVERSTRESS)
            elastic = CURVATURE <= 1
            np.testing.assert_allclose(moment[elastic], CURVATURE[elastic], atol=1e-9)
    assert all(fine < 0.4 * coarse for coarse, fine in pairwise(curve["fibres"]))
    assert curve["fibres"][-1] < 1e-3
    assert all(fine < coarse for coarse, fine in pairwise(curve["order"]))


@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_fibres_yield_one_by_one(section: str) -> None:
    """Each carries its strain or the yield stress: the whole curve, exactly, up to viscosity."""
    for number in (6, 24):
        rule = fibre_rule(section, number)
        stress = np.clip(CURVATURE[:, None] * rule.zeta, -1.0, 1.0)
        wanted = stress @ (rule.weight * rule.zeta) / SECOND[section]
        np.testing.assert_allclose(found(section, rule)[1], wanted, atol=1e-7)
