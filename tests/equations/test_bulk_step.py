"""The one scalar equation of a step in plane stress is the implicit exponential map of the three-dimensional law."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import logm

from softcat_sym.discretization.casadi_printer import evaluate
from softcat_sym.physics import bulk
from softcat_sym.physics import bulk as bulk_step
from softcat_sym.physics.symbols import E, sigma

PHI = sp.Function("phi", positive=True)
SUM, GAP = bulk_step.strain_sum, bulk_step.strain_gap
FIRST, SECOND = bulk.elastic_strain[0, 0], bulk.elastic_strain[1, 1]
HALVES = {FIRST: (SUM + GAP) / 2, SECOND: (SUM - GAP) / 2}


def plane_stress_chain() -> tuple[sp.Matrix, sp.Matrix, sp.Expr]:
    """Mandel stress, Lp and sig_eq of the general law in principal axes, in the sum and the gap of the strains."""
    law = bulk.plane_stress(PHI(sigma))
    stress = law.stress.subs(HALVES).applyfunc(sp.simplify)
    of_stress = {bulk.mandel[0, 0]: stress[0, 0], bulk.mandel[1, 1]: stress[1, 1]}
    return stress, law.flow.subs(of_stress), law.equivalent.subs(of_stress)


def with_stiffness(expr: sp.Expr) -> sp.Expr:
    return expr.subs(bulk_step.stiffness())


def test_the_relaxed_strains_solve_the_three_dimensional_step() -> None:
    stress, flow, _ = plane_stress_chain()
    assert stress[2, 2] == 0
    relaxed = bulk_step.relaxed_strains(PHI(sigma))
    before = (bulk_step.trial_sum + bulk_step.trial_gap) / 2, (bulk_step.trial_sum - bulk_step.trial_gap) / 2
    after = HALVES[FIRST], HALVES[SECOND]
    for axis in range(2):
        left = (before[axis] - after[axis] - bulk.step * flow[axis, axis]).subs(relaxed, simultaneous=True)
        assert sp.simplify(with_stiffness(left)) == 0


def test_the_equivalent_stress_is_that_of_the_general_law() -> None:
    _, _, equivalent = plane_stress_chain()
    assert sp.simplify(with_stiffness(bulk_step.plane_stress_equivalent_stress()) ** 2 - equivalent**2) == 0


def test_the_residual_vanishes_where_the_relaxed_strains_have_the_stress_announced() -> None:
    rate = PHI(sigma)
    product = sp.prod(bulk_step.relaxation(rate))
    closed = bulk.sigma_eq - bulk_step.plane_stress_equivalent_stress().subs(
        bulk_step.relaxed_strains(rate), simultaneous=True
    )
    numbers = {
        bulk_step.trial_sum: sp.Rational(3, 10),
        bulk_step.trial_gap: sp.Rational(-1, 5),
        bulk_step.stiffness_sum: 2,
        bulk_step.stiffness_gap: sp.Rational(2, 3),
        bulk.step: sp.Rational(1, 7),
        bulk.sigma_eq: sp.Rational(1, 5),
        PHI(bulk.sigma_eq): sp.Rational(3, 4),
        PHI(sp.Rational(1, 5)): sp.Rational(3, 4),
    }
    assert sp.simplify((bulk_step.residual(rate) - product * closed).subs(numbers)) == 0


def test_one_root_for_every_flow_rule_that_never_falls() -> None:
    x, a, b, s, d = sp.symbols("x a b s d", positive=True)
    squared = (s / (1 + a * x)) ** 2 + (d / (1 + b * x)) ** 2
    # every term of numerator and denominator is positive: sig_eq falls and x sig_eq grows with x
    for expression in (-squared.diff(x), (x**2 * squared).diff(x)):
        top, bottom = sp.fraction(sp.together(expression))
        assert sp.expand(top).is_positive
        assert sp.expand(bottom).is_positive


def test_energy_and_width_are_those_of_the_general_law() -> None:
    strain = bulk.plane_stress(PHI(sigma)).strain.subs(HALVES)
    assert sp.simplify(with_stiffness(bulk_step.plane_stress_elastic_energy()) - bulk.elastic_energy(strain)) == 0
    assert (
        sp.simplify(sp.log(bulk_step.width_stretch().subs(bulk_step.state[1], 0)).diff(SUM) - strain[2, 2] / SUM) == 0
    )


def test_trial_strains_are_the_logarithm_of_be() -> None:
    rng = np.random.default_rng(2)
    inputs = (*bulk_step.deformation, *bulk_step.state)
    for _ in range(6):
        deformation = np.eye(2) + 0.4 * rng.normal(size=(2, 2))
        deformation[0] *= np.sign(np.linalg.det(deformation))
        plastic = np.eye(2) + 0.2 * rng.normal(size=(2, 2))
        plastic = plastic @ plastic.T
        numbers = (*deformation.ravel(), plastic[0, 0], plastic[0, 1], plastic[1, 1])
        values = {symbol: float(number) for symbol, number in zip(inputs, numbers, strict=True)}
        values[bulk_step.jacobian] = float(np.linalg.det(deformation))
        for stage in (bulk_step.axes(), bulk_step.trial_determinants(), bulk_step.trial_strains()):
            values |= {symbol: float(evaluate(value, values)[0]) for symbol, value in stage.items()}
        plane = bulk_step.along_axes(bulk_step.trial_sum / 2, bulk_step.trial_gap / 2)
        wanted = logm(deformation @ plastic @ deformation.T) / 2
        assert [evaluate(part, values)[0] for part in plane] == pytest.approx(wanted.ravel(), abs=1e-12)


def test_stiffness_in_closed_form() -> None:
    found = bulk_step.stiffness()
    assert sp.simplify(found[bulk_step.stiffness_sum] - E / (1 - bulk.nu)) == 0
    assert sp.simplify(found[bulk_step.stiffness_gap] - E / (1 + bulk.nu)) == 0
