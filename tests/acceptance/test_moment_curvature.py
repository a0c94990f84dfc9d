"""Slow bending of an elastoplastic section, against the exact curves and ultimate moments of textbooks."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import linprog

from softcat_sym.discretization.section_rule import SectionRule, fibre_rule, order_rule
from softcat_sym.physics.sections import SECTIONS

from ..physics.one_cell import bend_slowly, one_cell
from ..physics.scenes import Array
from .table import show

YIELD = 1e-3
SECOND = {"rectangle": 1 / 3, "circle": 1 / 4}
ULTIMATE = {"rectangle": 3 / 2, "circle": 16 / (3 * np.pi)}
"""M_p/M_Y: sY b h^2/4 over sY b h^2/6, sY d^3/6 over pi sY d^3/32."""
FURTHEST = 10.0
CURVATURE = np.linspace(0.0, FURTHEST, 61)
SLOWNESS = 1e9
"""Relaxation times in which the curvature grows by that of first yield: the overstress of a fibre is a billionth, that
of an outermost point that flows for a whole section as many times more as its weight is less."""
OVERSTRESS = 1e-5
RULES = {"fibres": (6, 12, 24, 64), "order": (1, 3, 5, 8)}


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
    turning = 2 * YIELD * CURVATURE
    tension, moment = bend_slowly(one_cell(section, rule, YIELD), rule, turning, SLOWNESS * CURVATURE[1])
    return tension / YIELD, -moment / (YIELD * SECOND[section] / 2)


def rule_of(section: str, kind: str, number: int) -> SectionRule:
    shape = SECTIONS[section]
    return fibre_rule(shape, number) if kind == "fibres" else order_rule(shape, number, 24)


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


@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_moment_follows_curvature(section: str) -> None:
    wanted, rows = exact(section, CURVATURE), []
    curve: dict[str, list[float]] = {"fibres": [], "order": []}
    for kind, numbers in RULES.items():
        for number in numbers:
            rule = rule_of(section, kind, number)
            axial, moment = found(section, rule)
            error = float(np.max(np.abs(moment - wanted)) / ULTIMATE[section])
            limit = limit_moment(section, rule)
            curve[kind].append(error)
            at_limit = f"{limit / ULTIMATE[section] - 1:+.4f}"
            rows.append([f"{kind} {number}", f"{error:.5f}", f"{moment[-1]:.5f}", f"{wanted[-1]:.5f}", at_limit])
            assert np.max(np.abs(axial)) < 1e-9
            assert moment.max() <= limit + OVERSTRESS
            # Drucker: no softening, whatever the stresses are free to do
            assert np.all(np.diff(moment) > -OVERSTRESS)
            elastic = CURVATURE <= 1
            np.testing.assert_allclose(moment[elastic], CURVATURE[elastic], atol=1e-9)
    head = ("section", "largest error/M_p", "M/M_Y at 10 kappa_Y", "exact", "its M_p/exact - 1")
    show(f"{section}: slow bending at fixed length", head, rows)
    assert all(fine < 0.4 * coarse for coarse, fine in pairwise(curve["fibres"]))
    assert curve["fibres"][-1] < 1e-3
    assert all(fine < coarse for coarse, fine in pairwise(curve["order"]))


@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_fibres_yield_one_by_one(section: str) -> None:
    """Each carries its strain or the yield stress: the whole curve, exactly, up to viscosity."""
    for number in (6, 24):
        rule = fibre_rule(SECTIONS[section], number)
        stress = np.clip(CURVATURE[:, None] * rule.zeta, -1.0, 1.0)
        wanted = stress @ (rule.weight * rule.zeta) / SECOND[section]
        np.testing.assert_allclose(found(section, rule)[1], wanted, atol=1e-7)


@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_a_linear_profile_stops_at_first_yield(section: str) -> None:
    """A linear stress that exceeds yield nowhere has at most the moment of first yield: M_p is out of reach."""
    rule = order_rule(SECTIONS[section], 1, 64)
    _, moment = found(section, rule)
    assert moment[-1] == pytest.approx(1 / rule.zeta[-1], abs=OVERSTRESS)
    assert moment[-1] == pytest.approx(1.0, abs=2e-3)
