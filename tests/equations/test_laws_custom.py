"""A formula of one's own that says what a built-in law says is that law."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
import pytest
import sympy as sp

from softcat_sym.discretization.casadi_printer import CellFunction, evaluate
from softcat_sym.physics.laws import law_of
from softcat_sym.physics.sections import CIRCLE, RECTANGLE
from softcat_sym.physics.symbols import E, eta, s, sigma, sigma_0, sigma_1, sigma_Y
from softcat_sym.scene.formula import parse_formula

STRESSES = np.array([-30.0, -3.0, -1.0, -0.3, 0.0, 0.3, 1.0, 3.0, 30.0])


@dataclass(frozen=True)
class Tree:
    """A formula as nested tuples: a number, a name, or (operation, *operands)."""

    node: Any

    def fold(
        self,
        number: Callable[[float], Any],
        name: Callable[[str], Any],
        operation: Callable[[str, Sequence[Any]], Any],
    ) -> Any:
        if isinstance(self.node, str):
            return name(self.node)
        if isinstance(self.node, tuple):
            return operation(self.node[0], [Tree(part).fold(number, name, operation) for part in self.node[1:]])
        return number(self.node)


MAXWELL = Tree(("div", "sigma", "eta0"))
OVERSTRESS = ("max", ("sub", ("abs", "sigma"), "y0"), 0)
BINGHAM = Tree(("mul", ("sign", "sigma"), ("div", OVERSTRESS, "eta0")))
EYRING = Tree(("mul", "rate", ("sinh", ("div", "sigma", "s"))))
PLASTIC = Tree(("mul", "rate", ("asinh", ("div", "sigma", "s"))))


def custom(tree: Tree, *, yields: bool = False):
    law = law_of("custom", formula=tree, yields=yields)
    (branch,) = law.branches
    return law, branch, {constant.name: constant.symbol for constant in law.constants}


def test_sigma_over_a_viscosity_is_maxwell() -> None:
    law, branch, constants = custom(MAXWELL)
    assert list(constants) == ["eta0"]
    assert branch.flow.rate.xreplace({constants["eta0"]: eta}) == sigma / eta
    assert (law.flows, law.yields) == (True, False)


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


def test_a_users_name_is_not_taken_for_one_of_the_theory() -> None:
    _, branch, constants = custom(EYRING)
    assert set(constants) == {"rate", "s"}
    assert s not in branch.flow.rate.free_symbols


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


def test_a_number_keeps_its_digits() -> None:
    _, branch, _ = custom(Tree(("mul", 0.1, ("pow", "sigma", 3))))
    assert branch.flow.rate == sp.Float(0.1, 17) * sigma**3


def test_an_operation_that_there_is_not() -> None:
    with pytest.raises(ValueError, match="__import__"):
        custom(Tree(("__import__", "sigma")))
