"""A point of the law in plane stress: its C, its energy, its invariance."""

from __future__ import annotations

import copy
import math

import numpy as np
import pytest
from scipy.linalg import logm
from scipy.optimize import brentq

from softcat_sym.codegen.library import OPTIMISED, compile_library
from softcat_sym.errors import SoftcatError
from softcat_sym.reference.material_point import LAWS, point_code
from tests.common.material_point import MaterialPoint
from tests.common.paths import BINGHAM, ELASTIC, MAXWELL, Floats, cycle, integrate, march, shear_and_stretch

STRICT = ("-Wall", "-Wextra", "-pedantic", "-Werror", "-Wshadow", "-Wconversion", "-Wstrict-prototypes")
# An element loop in small: the point in its own translation unit.
LOOP = """
#define SOFTCAT_POINT_API static
#include "point.c"
double pulled(double stretch, const double *material);
double pulled(double stretch, const double *material) {
    double F[4] = {1.0, 0.0, 0.0, 1.0}, state[SOFTCAT_POINT_STATE] = {1.0, 0.0, 1.0};
    double P[4], record[SOFTCAT_POINT_RECORD];
    F[0] = stretch;
    if (softcat_point(F, state, 0.0, material, P, record) != SOFTCAT_POINT_DONE) return -1.0;
    return P[0];
}
"""


@pytest.mark.parametrize("law", LAWS)
def test_it_compiles_clean_under_every_warning(law: str) -> None:
    source = point_code(law).source
    compile_library(source, flags=(*OPTIMISED, *STRICT))
    compile_library({**source, "loop.c": LOOP}, flags=(*OPTIMISED, *STRICT), units=["loop.c"])


POINTS = [("elastic", ELASTIC), ("maxwell", MAXWELL), ("bingham", BINGHAM)]


@pytest.mark.parametrize(("law", "constants"), POINTS, ids=lambda value: value if isinstance(value, str) else "")
def test_the_stress_is_the_slope_of_the_energy(law: str, constants: dict[str, float]) -> None:
    point = march(MaterialPoint(law, constants), shear_and_stretch, 40)
    point.step(point.deformation, 0.0)
    small = 1e-5
    for i in range(2):
        for j in range(2):
            energies = []
            for side in (1, -1):
                moved = copy.copy(point)
                deformation = point.deformation.copy()
                deformation[i, j] += side * small
                moved.step(deformation, 0.0)
                energies.append(moved.energy)
            assert (energies[0] - energies[1]) / (2 * small) == pytest.approx(point.stress[i, j], abs=1e-9)
    assert point.energy > 1e-4


def test_a_held_maxwell_point_relaxes_exponentially() -> None:
    """Held, M_1 + M_2 decays with rate E/(2 (1 - nu) eta) and M_1 - M_2 with 3E/(2 (1 + nu) eta)."""
    E, nu, eta = MAXWELL["youngs_modulus"], MAXWELL["poisson"], MAXWELL["viscosity"]
    held, time = np.array([[1.12, 0.05], [0.05, 0.97]]), 0.8
    start = MaterialPoint("maxwell", MAXWELL)
    start.step(held, 0.0)
    errors = []
    wanted = np.array([math.exp(-E * time / (2 * (1 - nu) * eta)), math.exp(-1.5 * E * time / ((1 + nu) * eta))])
    for steps in (50, 100, 200):
        point = copy.copy(start)
        for _ in range(steps):
            point.step(held, time / steps)
        left = []
        for tau in (point.kirchhoff, start.kirchhoff):
            left.append([np.trace(tau), math.hypot(tau[0, 0] - tau[1, 1], 2 * tau[0, 1])])
        found = np.array(left[0]) / np.array(left[1])
        errors.append(np.abs(found - wanted))
    assert errors[0] / errors[1] == pytest.approx([2, 2], abs=0.05)
    assert errors[1] / errors[2] == pytest.approx([2, 2], abs=0.05)
    assert errors[2].max() < 2e-3


@pytest.mark.parametrize(("law", "constants"), POINTS[1:], ids=lambda value: value if isinstance(value, str) else "")
def test_flow_never_gives_energy_back(law: str, constants: dict[str, float]) -> None:
    rng, done = np.random.default_rng(9), 0.0
    point = MaterialPoint(law, constants)
    for _ in range(300):
        point.step(np.eye(2) + 0.2 * rng.uniform(-1, 1, size=(2, 2)), rng.uniform(0, 1))
        assert point.work >= done
        assert point.energy >= 0
        assert point.rate >= 0
        done = point.work
    assert done > 0.1


@pytest.mark.parametrize(("law", "constants"), POINTS, ids=lambda value: value if isinstance(value, str) else "")
def test_the_energy_of_a_cycle_balances(law: str, constants: dict[str, float]) -> None:
    misses = []
    for steps in (200, 400, 800, 1600):
        point, given = MaterialPoint(law, constants), 0.0
        for n in range(1, steps + 1):
            before, stress = point.deformation, point.stress
            point.step(cycle(n / steps), 1 / steps)
            given += float(np.sum((stress + point.stress) / 2 * (point.deformation - before)))
        misses.append(given - point.energy - point.work)
    if law == "elastic":
        assert abs(given) < 1e-6
        assert point.energy == pytest.approx(0, abs=1e-30)
    else:
        assert given > 1e-4
        assert misses[-2] / misses[-1] == pytest.approx(2, abs=0.15)
    assert abs(misses[-1]) < 0.01 * max(point.work, 1e-4)


def test_below_the_yield_stress_a_bingham_point_is_the_elastic_one() -> None:
    elastic, bingham = MaterialPoint("elastic", ELASTIC), MaterialPoint("bingham", {**BINGHAM, "yield_stress": 10.0})
    for point in (elastic, bingham):
        march(point, shear_and_stretch, 10)
    assert np.array_equal(elastic.stress, bingham.stress)
    assert np.array_equal(bingham.state, [1, 0, 1])
    assert bingham.work == bingham.rate == 0


E, NU = BINGHAM["youngs_modulus"], BINGHAM["poisson"]


def turned(angle: float) -> Floats:
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])


def test_equal_principal_stretches() -> None:
    """Tau = E/(1 - nu) log(stretch) 1, and a disturbance of the equality is felt in proportion."""
    for stretch in [0.6, 0.9, 1 - 1e-12, 1 + 1e-12, 1.1, 1.8]:
        rest = MaterialPoint("elastic", ELASTIC)
        for disturbance in (0.0, 1e-16, 1e-12, 1e-8, 1e-6):
            for angle in (0.0, 0.4, math.pi / 4):
                point = copy.copy(rest)
                axes = turned(angle)
                point.step(axes @ np.diag([1 + disturbance, 1 - disturbance]) @ axes.T * stretch, 1.0)
                equal = E / (1 - NU) * (math.log(stretch) + math.log1p(-(disturbance**2)) / 2)
                deviator = E / (1 + NU) * math.atanh(disturbance) * axes @ np.diag([1, -1]) @ axes.T
                assert point.kirchhoff == pytest.approx(equal * np.eye(2) + deviator, abs=1e-14)


def test_what_is_inverted_or_not_finite_is_refused_and_leaves_the_point_alone() -> None:
    for wrong in [
        [[-1.0, 0], [0, 1]],
        [[0.0, 1], [1, 0]],
        [[1.0, 1], [1, 1]],
        [[0.0, 0], [0, 0]],
        [[math.nan, 0], [0, 1]],
        [[1.0, math.nan], [0, 1]],
        [[math.inf, 0], [0, 1]],
        [[1.0, math.inf], [0, 1]],
        [[1e200, 0], [0, 1e200]],
    ]:
        for law, constants in [("elastic", ELASTIC), ("bingham", BINGHAM)]:
            point = MaterialPoint(law, constants)
            point.step([[1.1, 0], [0, 1]], 0.1)
            state, stress, work = point.state.copy(), point.stress.copy(), point.work
            with pytest.raises(SoftcatError, match="no positive determinant, or it is not finite"):
                point.step(wrong, 0.1)
            assert np.array_equal(point.state, state)
            assert np.array_equal(point.stress, stress)
            assert point.work == work


def pull(point: MaterialPoint, strain: float, duration: float) -> None:
    """Stretch along the first axis with the sides free: F_22 is where P_22 vanishes."""

    def side_stress(contraction: float) -> float:
        trial = copy.copy(point)  # a step replaces the arrays of a point, it does not write into them
        trial.step(np.diag([math.exp(strain), math.exp(contraction)]), duration)
        return float(trial.stress[1, 1])

    found = brentq(side_stress, -0.8 * strain - 1e-3, 0.0, xtol=1e-15, rtol=1e-14)
    point.step(np.diag([math.exp(strain), math.exp(found)]), duration)


# (law, constants, stress wanted at a true rate)
TENSILE = [
    ("maxwell", MAXWELL, lambda rate: 0.5 * rate),
    ("bingham", BINGHAM, lambda rate: 0.02 + 0.5 * rate),
]


def test_steady_stress_of_a_tensile_test() -> None:
    """sY + eta rate is a Kirchhoff stress (the flow rule is written in M); Cauchy's is that over J = exp(tr Ee)."""
    rate, steps, duration = 0.1, 160, 0.1
    for law, constants, wanted in TENSILE:
        point = MaterialPoint(law, constants)
        for n in range(1, steps + 1):
            pull(point, n * rate * duration, duration)
        tau, target = point.kirchhoff[0, 0], wanted(rate)
        volume = math.exp((1 - 2 * BINGHAM["poisson"]) * target / BINGHAM["youngs_modulus"])
        assert tau == pytest.approx(target, rel=1e-10), law
        assert point.cauchy[0, 0] == pytest.approx(target / volume, rel=1e-10), law
        assert point.rate == pytest.approx(rate, rel=1e-10), law
        # isotropic: the width contracts as the side does
        assert point.width_stretch == pytest.approx(point.deformation[1, 1], rel=1e-10), law


def test_a_finite_path_of_shear_and_stretch_is_first_order_in_the_step() -> None:
    stress, state, width = integrate(shear_and_stretch, 3000, BINGHAM)
    coarse, _, _ = integrate(shear_and_stretch, 1500, BINGHAM)
    trust = np.abs(stress - coarse).max()
    assert trust < 1e-8, "the judge has converged"
    errors = []
    for steps in (100, 200, 400, 800, 1600):
        point = march(MaterialPoint("bingham", BINGHAM), shear_and_stretch, steps)
        found = np.array([[point.state[0], point.state[1]], [point.state[1], point.state[2]]])
        error = np.array(
            [
                np.abs(point.stress - stress).max() / np.abs(stress).max(),
                np.abs(found - state).max(),
                abs(point.width_stretch - width),
            ]
        )
        errors.append(error)
    assert errors[-1].max() < 1e-3
    assert errors[-2] / errors[-1] == pytest.approx(2 * np.ones(3), abs=0.05)


def test_every_step_however_long_solves_the_implicit_equations() -> None:
    """Ee_trial - Ee_new = dt Lp(M_new), with matrix logarithms, for steps from 1e-5 to 1e5 relaxation times."""
    for law, constants in POINTS[1:]:
        rng = np.random.default_rng(5)
        rest, flowed = MaterialPoint(law, constants), 0
        for _ in range(200):
            point = copy.copy(rest)
            point.step(np.eye(2) + 0.1 * rng.normal(size=(2, 2)), 0.1)
            before, deformation = point.state, np.eye(2) + 0.15 * rng.normal(size=(2, 2))
            duration = 0.5 * 10 ** rng.uniform(-5, 5)
            point.step(deformation, duration)
            lost = _strain(deformation, before) - _strain(deformation, point.state)
            tau = np.zeros((3, 3))
            tau[:2, :2] = point.kirchhoff
            deviator = tau - np.trace(tau) / 3 * np.eye(3)
            size = math.sqrt(1.5 * np.sum(deviator**2))
            flow = 1.5 * duration * point.rate * deviator[:2, :2] / max(size, 1e-300)
            assert lost == pytest.approx(flow, rel=1e-9, abs=2e-12)
            flowed += point.rate > 0
        assert flowed > 150


def _strain(deformation: Floats, state: Floats) -> Floats:
    metric = np.array([[state[0], state[1]], [state[1], state[2]]])
    return np.asarray(logm(deformation @ metric @ deformation.T)) / 2


def test_frame_indifference() -> None:
    """An observer who turns sees the stress turned, and the same energy, work and thickness."""
    for law, constants in (("elastic", ELASTIC), ("maxwell", MAXWELL), ("bingham", BINGHAM)):
        still, seen = MaterialPoint(law, constants), MaterialPoint(law, constants)
        worst = 0.0
        for n in range(1, 201):
            angle = 9 * n / 200 + 3 * math.sin(7 * n / 200)
            spin = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
            still.step(shear_and_stretch(n / 200), 1 / 200)
            seen.step(spin @ shear_and_stretch(n / 200), 1 / 200)
            scalars = (seen.energy - still.energy, seen.work - still.work, seen.width_stretch - still.width_stretch)
            worst = max(worst, float(np.abs(seen.stress - spin @ still.stress).max()), *map(abs, scalars))
        assert worst < 1e-12
