"""Orders and fibres through the thickness on a cyclic stretch-and-bend history, against 64 plain fibres in NumPy."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from softcat_sym.discretization.section_rule import SectionRule, fibre_rule, order_rule
from tests.common.filaments import Array
from tests.common.one_cell import follow, one_cell
from tests.common.table import show
from tests.marks import few

YIELD = 0.01  # yield stress over E; viscosity, E and thickness are one
PERIOD, CYCLES, STEPS = 20.0, 3.25, 600
ORDERS = (1, 2, 3, 5, 8)
PROJECTIONS = (12, 24, 48)
FIBRES = (2, 4, 6, 8, 12, 24)
MANY = 64


@cache
def history() -> tuple[float, Array, Array]:
    """Duration, stretch and turning: bent to and fro while stretched by 13 % and let go, far into yield."""
    duration = PERIOD * CYCLES
    t = np.linspace(0.0, duration, 2 * STEPS + 1)
    stretch = np.exp(0.06 * (1 - np.cos(2 * np.pi * t / duration)) + 0.01 * np.sin(2 * np.pi * t / PERIOD))
    turning = 0.08 * np.sin(2 * np.pi * t / PERIOD) + 0.03 * np.sin(2 * np.pi * t / (1.7 * PERIOD))
    return duration, stretch, turning


def points(section: str, number: int) -> tuple[Array, Array]:
    """Gauss-Legendre over the thickness of a rectangle, over the angle of a circle's edge."""
    nodes, weights = np.polynomial.legendre.leggauss(number)
    if section == "circle":
        angle = nodes * np.pi / 2
        return np.sin(angle), weights * np.cos(angle) ** 2
    return nodes, weights / 2


@cache
def truth(section: str, number: int = MANY) -> tuple[Array, Array]:
    """T and M of so many fibres, each with its own plastic strain (2.8, 2.25); nothing of the package."""
    duration, s, turning = history()
    dt = duration / STEPS
    zeta, weight = points(section, number)

    def stress(n: int, plastic: Array) -> Array:
        return np.log(s[n]) - turning[n] * s[n] ** -1.5 * zeta / 2 - plastic

    def rate(n: int, plastic: Array) -> Array:
        sigma = stress(n, plastic)
        return np.sign(sigma) * np.maximum(np.abs(sigma) - YIELD, 0.0)

    plastic = np.zeros(number)
    tension, moment = np.empty(STEPS + 1), np.empty(STEPS + 1)
    for step in range(STEPS + 1):
        n = 2 * step
        sigma = stress(n, plastic)
        tension[step], moment[step] = weight @ sigma / s[n], weight @ (sigma * zeta) / 2 * s[n] ** -1.5
        if step == STEPS:
            break
        k1 = rate(n, plastic)
        k2 = rate(n + 1, plastic + dt / 2 * k1)
        k3 = rate(n + 1, plastic + dt / 2 * k2)
        k4 = rate(n + 2, plastic + dt * k3)
        plastic = plastic + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return tension, moment


def errors(found: tuple[Array, Array], wanted: tuple[Array, Array]) -> tuple[float, float]:
    """Largest error of T and M over their largest values."""
    tension, moment = (float(np.max(np.abs(a - b)) / np.max(np.abs(b))) for a, b in zip(found, wanted, strict=True))
    return tension, moment


def followed(section: str, rule: SectionRule) -> tuple[Array, Array]:
    return follow(one_cell(section, rule, YIELD), *history())


def of_order(section: str, order: int, projection: int) -> tuple[float, float]:
    return errors(followed(section, order_rule(section, order, projection)), truth(section))


@pytest.mark.slow
@pytest.mark.parametrize("section", few(["rectangle", "circle"], "circle"))
def test_error_falls_with_the_order(section: str) -> None:
    rows, worst = [], {}
    for order in ORDERS:
        by_points = {n: of_order(section, order, n) for n in (order + 1, *PROJECTIONS) if n > order}
        worst[order] = {n: max(pair) for n, pair in by_points.items()}
        tension, moment = by_points[PROJECTIONS[-1]]
        cells = [f"{worst[order][n]:.4f}" if n in worst[order] else "" for n in (order + 1, *PROJECTIONS)]
        rows.append([order, f"{tension:.4f}", f"{moment:.4f}", *cells])
    own = max(errors(truth(section), truth(section, 4 * MANY)))
    head = ("k", "T, 48 points", "M, 48 points", "k + 1 points", *(f"{n} points" for n in PROJECTIONS))
    show(f"{section}: largest error of T and M by order, 64 fibres are the truth (themselves {own:.5f})", head, rows)
    finest = [worst[order][PROJECTIONS[-1]] for order in ORDERS]
    assert all(fine < 0.75 * coarse for coarse, fine in pairwise(finest))
    assert finest[0] > 0.1
    assert finest[-1] < 0.02
    assert own < 1e-3
    # the 24 points that the program projects with by default leave the order its own error
    assert all(worst[order][24] == pytest.approx(worst[order][48], rel=0.1) for order in ORDERS)


@pytest.mark.parametrize("section", few(["rectangle", "circle"], "circle"))
def test_error_falls_with_the_fibres(section: str) -> None:
    rows, worst = [], []
    for number in FIBRES:
        tension, moment = errors(followed(section, fibre_rule(section, number)), truth(section))
        rows.append([number, f"{tension:.4f}", f"{moment:.4f}"])
        worst.append(max(tension, moment))
    show(f"{section}: largest error of T and M by fibres", ("fibres", "T", "M"), rows)
    assert all(fine < 0.7 * coarse for coarse, fine in pairwise(worst))
    order = np.log(worst[0] / worst[-1]) / np.log(FIBRES[-1] / FIBRES[0])
    print(f"falls as fibres^-{order:.1f}")
    assert order > 1.5


def test_as_many_fibres_are_the_truth() -> None:
    """At the same points both programs do the same, to rounding."""
    assert max(errors(followed("rectangle", fibre_rule("rectangle", MANY)), truth("rectangle"))) < 1e-12


def test_an_order_with_as_many_points_is_fibres() -> None:
    for section in ["rectangle", "circle"]:
        for order in [1, 3, 8]:
            amplitudes = followed(section, order_rule(section, order, order + 1))
            fibres = followed(section, fibre_rule(section, order + 1))
            assert max(errors(amplitudes, fibres)) < 1e-12


def test_the_history_is_a_hard_one() -> None:
    """Every part of it counts: reversals of the moment, stretch enough to thin, stress well beyond yield."""
    tension, moment = truth("rectangle")
    _, s, _ = history()
    assert np.sum(np.diff(np.sign(moment[1:])) != 0) >= 5
    assert s.max() > 1.12
    assert np.abs(tension * s[::2]).max() > 1.5 * YIELD
