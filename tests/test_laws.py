"""Laws at a material point; `derivations/11_rheologies.py` proves what each becomes in its limits."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.linalg import logm

from softcat_sym.discretization.casadi_printer import CellFunction, evaluate
from softcat_sym.physics import bulk
from softcat_sym.physics import bulk as bulk_step
from softcat_sym.physics import closed_forms as strings
from softcat_sym.physics.constitutive_laws import K, law_of, n
from softcat_sym.physics.regimes import H
from softcat_sym.physics.sections import CIRCLE, RECTANGLE
from softcat_sym.physics.symbols import E, L, eta, g, rho, sigma, sigma_0, sigma_1, sigma_Y, t
from softcat_sym.scene.formula import parse_formula

# A formula of one's own that says what a built-in law says is that law.
STRESSES = np.array([-30.0, -3.0, -1.0, -0.3, 0.0, 0.3, 1.0, 3.0, 30.0])


@dataclass(frozen=True)
class Tree:
    """A formula as nested tuples: a number, a name, or (operation, *operands)."""

    node: Any

    def fold(
        self, number: Callable[[float], Any], name: Callable[[str], Any], operation: Callable[[str, Sequence[Any]], Any]
    ) -> Any:
        if isinstance(self.node, str):
            return name(self.node)
        if isinstance(self.node, tuple):
            return operation(self.node[0], [Tree(part).fold(number, name, operation) for part in self.node[1:]])
        return number(self.node)


OVERSTRESS = ("max", ("sub", ("abs", "sigma"), "y0"), 0)
BINGHAM = Tree(("mul", ("sign", "sigma"), ("div", OVERSTRESS, "eta0")))
EYRING = Tree(("mul", "rate", ("sinh", ("div", "sigma", "s"))))
PLASTIC = Tree(("mul", "rate", ("asinh", ("div", "sigma", "s"))))


def custom(tree: Tree, *, yields: bool = False):
    law = law_of("custom", formula=tree, yields=yields)
    (branch,) = law.branches
    return law, branch, {constant.name: constant.symbol for constant in law.constants}


@pytest.mark.parametrize("shape", (RECTANGLE, CIRCLE), ids=lambda shape: shape.name)
def test_with_a_threshold_it_is_bingham(shape) -> None:
    law, branch, constants = custom(BINGHAM, yields=True)
    assert (law.flows, law.yields) == (True, True)
    wanted = law_of("bingham").branches[0]
    assert branch.flow == branch.flow_beyond_yield
    material = {sigma_Y: 1.0, E: 400.0, eta: 2.0, constants["eta0"]: 2.0, constants["y0"]: 1.0}
    ours, theirs = branch.flow_beyond_yield, wanted.flow_beyond_yield
    point = {**material, sigma: STRESSES}
    np.testing.assert_allclose(evaluate(ours.rate, point), evaluate(theirs.rate, point), rtol=1e-15)
    one, other = ours.means(shape), theirs.means(shape)
    point = {**material, sigma_0: STRESSES, sigma_1: STRESSES[::-1] * 0.7}
    for name in ("rate", "bending_rate", "yielded_fraction", "largest_rate"):
        found, exact = (evaluate(getattr(means, name), point) for means in (one, other))
        np.testing.assert_allclose(found, exact, atol=1e-13 if shape is RECTANGLE else 1e-5)


@pytest.mark.parametrize(
    "text", ["sinh(sigma/s0)/t0", "sign(sigma)*max(abs(sigma) - y0, 0)**1.5", "asinh(sigma/s0)**3"]
)
def test_a_formula_of_a_scene(text: str) -> None:
    """As the scene evaluates it in plain floats, so the printed expression does."""
    formula = parse_formula(text)
    law = law_of("custom", formula=formula)
    values = {"s0": 2.0, "t0": 0.5, "y0": 0.7}
    at = {constant.symbol: values[constant.name] for constant in law.constants} | {sigma: STRESSES}
    wanted = [formula.value(stress, values) for stress in STRESSES]
    np.testing.assert_allclose(evaluate(law.branches[0].flow.rate, at), wanted, rtol=1e-13)


@pytest.mark.parametrize(("tree", "exact"), [(EYRING, np.sinh), (PLASTIC, np.arcsinh)], ids=["sinh", "asinh"])
def test_values_and_slopes_of_a_formula_as_printed(tree: Tree, exact: Callable[[np.ndarray], np.ndarray]) -> None:
    _, branch, constants = custom(tree)
    at = {sigma: STRESSES, constants["rate"]: 3.0, constants["s"]: 2.0, E: 400.0}
    np.testing.assert_allclose(evaluate(branch.flow.rate, at), 3 * exact(STRESSES / 2), rtol=1e-14)
    means = branch.flow.means(RECTANGLE)
    stress = ca.SX.sym("stress", 2)
    point = {**at, sigma_0: stress[0], sigma_1: stress[1]}
    del point[sigma]
    both = CellFunction({"mean": means.rate, "bend": means.bending_rate}, tuple(point))(point)
    slope = ca.Function("slope", [stress], [ca.jacobian(ca.vertcat(both["mean"], both["bend"]), stress)])
    # at rest either is a dashpot of 3/2
    np.testing.assert_allclose(np.array(slope((0.0, 0.0))), 1.5 * np.eye(2), atol=1e-12)


# The sag of a string, against its own equation integrated by a machine.
AT = {rho: 1e3, g: 9.81, L: 0.2, K: 700.0, eta: 700.0, E: 3e5}
STRING_STRAIN, STRING_STRESS = sp.Rational(8, 3) * (H / L) ** 2, rho * g * L**2 / (8 * H)


@pytest.mark.parametrize("index", (0.3, 0.5, 1.0, 2.0))
def test_a_power_law_string_creeps_by_its_own_flow_rule(index: float) -> None:
    known = {**AT, n: index}
    # (d eps/dH) H_t = (sigma/K)^(1/n)
    rate = (sigma / K) ** (1 / n) / sp.diff(STRING_STRAIN, H)
    of_sag = sp.lambdify(H, rate.subs(sigma, STRING_STRESS).subs(known), modules="math")
    closed = sp.lambdify(t, strings.power_law_string_sag().subs(known), modules="math")
    start, end = 1e-3, 10.0
    found = solve_ivp(lambda _, sag: [of_sag(sag[0])], (start, end), [closed(start)], rtol=1e-10, atol=1e-14)
    assert found.y[0, -1] == pytest.approx(closed(end), rel=1e-7)
    assert closed(2.0) / closed(1.0) == pytest.approx(2 ** (index / (2 * index + 1)), rel=1e-12)


# The one scalar equation of a step in plane stress is the implicit exponential map of the three-dimensional law.
PHI = sp.Function("phi", positive=True)
SUM, GAP = bulk_step.strain_sum, bulk_step.strain_gap
FIRST, SECOND = bulk.elastic_strain[0, 0], bulk.elastic_strain[1, 1]
HALVES = {FIRST: (SUM + GAP) / 2, SECOND: (SUM - GAP) / 2}


def plane_stress_chain() -> tuple[sp.Matrix, sp.Matrix, sp.Expr]:
    """Mandel stress, Lp and sig_eq of the general law in principal axes, in the sum and the gap of the strains."""
    stress = bulk.mandel_stress(bulk.flat_strain()).subs(HALVES).applyfunc(sp.simplify)
    mandel = sp.diag(bulk.mandel[0, 0], bulk.mandel[1, 1], 0)
    of_stress = {bulk.mandel[0, 0]: stress[0, 0], bulk.mandel[1, 1]: stress[1, 1]}
    flow, equivalent = bulk.plastic_flow(mandel, PHI(sigma)), bulk.equivalent_stress(mandel)
    return stress, flow.subs(of_stress), equivalent.subs(of_stress)


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
