"""The section's closed forms against quadrature, and the material closure against fibres integrated one by one."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from scipy import special
from scipy.integrate import quad, solve_ivp

from softcat_sym.physics import closures as closure
from softcat_sym.physics import closures as layers
from softcat_sym.physics import closures as paper_section
from softcat_sym.physics.sections import CIRCLE, RECTANGLE, SHEET, UNIFORM, WIDE, Contraction, Section
from softcat_sym.physics.symbols import A0, E, M, T, c, eta, h0, s, sigma_Y, theta_X, zeta

SHAPES = [(RECTANGLE, UNIFORM), (SHEET, WIDE), (CIRCLE, UNIFORM)]
each_shape = pytest.mark.parametrize(("shape", "shrinking"), SHAPES, ids=[shape.name for shape, _ in SHAPES])
NODES, WEIGHTS = np.polynomial.legendre.leggauss(60)
ANGLES = math.pi / 2 * (NODES + 1)
MODULUS, THICKNESS = 3.0, 0.2

LAWS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "maxwell": lambda stress: stress / 2,
    "eyring": lambda stress: np.sinh(4 * stress) / 5,
    "cubic": lambda stress: 3 * stress**3,
    "bingham": lambda stress: np.sign(stress) * np.maximum(np.abs(stress) - 0.2, 0),
}


def fibres(shape: Section) -> tuple[np.ndarray, np.ndarray]:
    """Fibres and their share of the section, by quadrature in the angle of a circle or straight."""
    if shape is CIRCLE:
        return np.cos(ANGLES), math.pi / 2 * WEIGHTS * 2 / math.pi * np.sin(ANGLES) ** 2
    return NODES, WEIGHTS / 2


def path(time: float) -> tuple[float, float, float, float]:
    """Stretch and turning as they are driven, and their rates."""
    return (
        1 + 0.3 * time + 0.1 * math.sin(5 * time),
        2 * math.sin(3 * time),
        0.3 + 0.5 * math.cos(5 * time),
        6 * math.cos(3 * time),
    )


def lever(shrinking: Contraction, stretch: float) -> float:
    """h/(2 s)."""
    return THICKNESS / 2 * stretch ** (-2 if shrinking is WIDE else -1.5)


def test_polynomials_are_the_classical_ones() -> None:
    for order in range(6):
        at = np.linspace(-1, 1, 11)
        for shape, wanted in (
            (RECTANGLE, special.eval_legendre(order, at)),
            (SHEET, special.eval_legendre(order, at)),
            (CIRCLE, special.eval_chebyu(order, at) / (order + 1)),
        ):
            found = sp.lambdify(zeta, layers.polynomial(shape, order) + 0 * zeta)(at)
            assert found * np.ones(11) == pytest.approx(wanted, abs=1e-13)


@each_shape
def test_polynomials_are_orthogonal(shape: Section, shrinking: Contraction) -> None:
    del shrinking
    where, share = fibres(shape)
    table = np.array([sp.lambdify(zeta, layers.polynomial(shape, n))(where) * np.ones(60) for n in range(6)])
    wanted = np.diag([float(layers.mean_square(shape, n)) for n in range(6)])
    assert (table * share) @ table.T == pytest.approx(wanted, abs=1e-13)


@pytest.mark.parametrize("edge", [-0.999, -0.3, 0.0, 0.45, 0.98])
@each_shape
def test_partial_moments(shape: Section, shrinking: Contraction, edge: float) -> None:
    del shrinking
    weight = sp.lambdify(zeta, shape.weight)
    for held, integrand in (
        (shape.area, lambda v: weight(v)),
        (shape.overstress_mean, lambda v: (v - edge) * weight(v)),
        (shape.overstress_moment, lambda v: (v - edge) * v * weight(v)),
    ):
        assert float(held.subs(c, edge)) == pytest.approx(quad(integrand, edge, 1)[0], rel=1e-7, abs=1e-10)


def test_the_papers_bingham_rates_against_quadrature() -> None:
    """(2.26), (2.27), every pattern of yielding that random stresses bring."""
    letters = (T, M, paper_section.z_L, paper_section.z_H, paper_section.h, paper_section.D, sigma_Y, eta)
    P_t, C_t = (
        sp.lambdify(letters, rate, modules="numpy")
        for rate in (paper_section.plastic_stretch_rate(), paper_section.plastic_bend_rate())
    )
    h, D, Y, viscosity = 0.4, 0.7, 1.3, 2.0
    for mean, slope in np.random.default_rng(5).normal(0, 2.5, (200, 2)):
        tension, moment = mean * h * D, slope * D * h**2 / 6
        ends = sorted((level - mean) / slope * h / 2 for level in (-Y, Y))
        z_L, z_H = (min(max(end, -h / 2), h / 2) for end in ends)
        cuts = np.array([-h / 2, z_L, z_H, h / 2])
        wanted = np.zeros(2)
        for low, high in pairwise(cuts):
            z = (low + high) / 2 + (high - low) / 2 * NODES
            stress = mean + slope * z / (h / 2)
            flow = np.sign(stress) * np.maximum(np.abs(stress) - Y, 0) / viscosity
            wanted += (high - low) / 2 * D * np.array([np.sum(WEIGHTS * flow), np.sum(WEIGHTS * flow * z)])
        held = (tension, moment, z_L, z_H, h, D, Y, viscosity)
        assert [P_t(*held), C_t(*held)] == pytest.approx(wanted, rel=1e-11, abs=1e-12)


def run(shape: Section, shrinking: Contraction, law: str, order: int) -> tuple[np.ndarray, float, dict[str, float]]:
    """Integrate the states of one driven section; return them, its dissipation, and the work of Q, T and -M."""
    where, share = fibres(shape)
    basis = np.array([sp.lambdify(zeta, layers.polynomial(shape, n))(where) * np.ones(60) for n in range(order + 1)])
    norms = np.array([float(layers.mean_square(shape, n)) for n in range(order + 1)])
    excess = sp.lambdify((T, M, s, theta_X), layers.conjugate_force(shrinking))

    def rates(time: float, state: np.ndarray) -> np.ndarray:
        stretch, turning, stretch_t, turning_t = path(time)
        strain = math.log(stretch) - turning * lever(shrinking, stretch) * where
        stress = MODULUS * (strain - state[: order + 1] @ basis)
        flow = LAWS[law](stress)
        tension = np.sum(share * stress) / stretch
        moment = lever(shrinking, stretch) * np.sum(share * stress * where)
        force = excess(tension, moment, stretch, turning)
        work = (force * stretch_t - moment * turning_t, tension * stretch_t - moment * turning_t)
        return np.array([*(basis * share @ flow / norms), np.sum(share * stress * flow), *work])

    tolerance = 1e-8 if law == "bingham" else 1e-11
    last = solve_ivp(rates, (0, 1), np.zeros(order + 4), rtol=tolerance, atol=tolerance, method="DOP853").y[:, -1]
    return last[: order + 1], last[order + 1], {"Q": last[order + 2], "T": last[order + 3]}


@pytest.mark.parametrize("law", LAWS)
@each_shape
def test_energy_closes_at_any_order_with_the_conjugate_force_only(
    shape: Section, shrinking: Contraction, law: str
) -> None:
    for order in (1, 3):
        states, lost, work = run(shape, shrinking, law, order)
        stretch, turning, _, _ = path(1.0)
        stresses = layers.stress_amplitudes(shrinking, list(map(sp.Float, states)))
        stored = layers.stored_energy(shape, stresses)
        left = float(stored.subs({A0: 1, E: MODULUS, h0: THICKNESS, s: stretch, theta_X: turning}))
        assert left + lost == pytest.approx(work["Q"], rel=1e-6 if law == "bingham" else 1e-9)
        assert abs(left + lost - work["T"]) > 1e-3 * work["Q"]
        assert lost > 0


@pytest.mark.parametrize("law", ["eyring", "cubic"])
@each_shape
def test_the_orders_converge_to_the_fibres(shape: Section, shrinking: Contraction, law: str) -> None:
    """Each fibre on its own, no polynomials: the mean plastic strain and the bending one of order 1, 2, 4."""
    where, share = fibres(shape)

    def rates(time: float, plastic: np.ndarray) -> np.ndarray:
        stretch, turning, _, _ = path(time)
        strain = math.log(stretch) - turning * lever(shrinking, stretch) * where
        return LAWS[law](MODULUS * (strain - plastic))

    plastic = solve_ivp(rates, (0, 1), np.zeros(60), rtol=1e-9, atol=1e-10).y[:, -1]
    wanted = np.array([np.sum(share * plastic), np.sum(share * plastic * where) / np.sum(share * where**2)])
    errors = [np.abs(run(shape, shrinking, law, order)[0][:2] - wanted).max() for order in (1, 2, 4)]
    assert errors[2] < 0.1 * errors[0]
    assert errors[2] < 2e-3


@pytest.mark.parametrize("law", LAWS)
@each_shape
def test_both_parts_of_the_dissipation_are_positive(shape: Section, shrinking: Contraction, law: str) -> None:
    del shrinking
    where, share = fibres(shape)
    for mean, slope in np.random.default_rng(6).normal(0, 0.5, (300, 2)):
        flow = LAWS[law](mean + slope * where)
        assert mean * np.sum(share * flow) >= -1e-13
        assert slope * np.sum(share * flow * where) >= -1e-13


def test_a_flow_rule_that_is_not_odd_breaks_the_parts_but_not_the_sum() -> None:
    """Flow in tension alone: a section in compression on the whole lengthens, and still dissipates."""
    where, share = fibres(RECTANGLE)
    stress = -0.3 + where
    flow = np.maximum(stress, 0)
    assert -0.3 * np.sum(share * flow) < 0
    assert np.sum(share * stress * flow) > 0


def test_the_appendix_in_a_thickness_that_does_not_change() -> None:
    """(A 2) with a_n = sqrt(h/(2n + 1)) times ours, at s = 1, for a cubic flow rule by quadrature."""
    for order in range(4):
        h, turning = 0.4, 1.7
        ours = np.random.default_rng(9).normal(0, 0.1, 4)
        theirs = [a * math.sqrt(h / (2 * n + 1)) for n, a in enumerate(ours)]
        integral = paper_section.coefficient_rate(order, list(map(sp.Float, theirs)))
        numbers = {s: 1, E: 2.5, theta_X: turning, paper_section.h: h}
        flow = next(iter(integral.function.atoms(sp.core.function.AppliedUndef)))
        integrand = sp.lambdify(paper_section.z, (integral.function / flow * flow.args[0] ** 3).subs(numbers))
        paper = np.sum(WEIGHTS * h / 2 * integrand(h / 2 * NODES))
        basis = np.array([special.eval_legendre(n, NODES) for n in range(4)])
        stress = 2.5 * (-turning * h / 2 * NODES - ours @ basis)
        mine = np.sum(WEIGHTS / 2 * stress**3 * basis[order]) * (2 * order + 1)
        assert paper == pytest.approx(mine * math.sqrt(h / (2 * order + 1)), rel=1e-11)


def test_the_solver_and_the_layers_hold_the_same_axial_force() -> None:
    held = {e.name: e.right for e in closure.CLOSURE_EQUATIONS}
    assert sp.simplify(layers.conjugate_force(UNIFORM) - held["axial force, material closure"]) == 0
    assert sp.simplify(layers.conjugate_force(WIDE) - held["axial force of a sheet, material closure"]) == 0
