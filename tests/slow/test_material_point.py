"""The material point flows as the three-dimensional law says: in a tensile test, and on a path with turning axes."""

from __future__ import annotations

import copy
import math

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import logm
from scipy.optimize import brentq

from softcat_sym.physics.symbols import sigma
from softcat_sym.reference.material_point import MaterialPoint, PointLaw
from tests.common.paths import BINGHAM, ELASTIC, MAXWELL, Floats, integrate, march, shear_and_stretch
from tests.common.table import show

K = sp.Symbol("K", positive=True)
THINNING = PointLaw((sigma / K) ** 3, {"consistency": K})
THICKENING = PointLaw(sp.sqrt(sp.Max(sigma, 0) / K), {"consistency": K})
SINH = PointLaw(sp.sinh(sigma / K), {"consistency": K})
OF_ITS_OWN = {**ELASTIC, "consistency": 0.1}


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
    (THINNING, OF_ITS_OWN, lambda rate: 0.1 * rate ** (1 / 3)),
    (THICKENING, OF_ITS_OWN, lambda rate: 0.1 * rate**2),
    (SINH, OF_ITS_OWN, lambda rate: 0.1 * math.asinh(rate)),
]


def test_steady_stress_of_a_tensile_test() -> None:
    """sY + eta rate is a Kirchhoff stress (the flow rule is written in M); Cauchy's is that over J = exp(tr Ee)."""
    rows, rate, steps, duration = [], 0.1, 160, 0.1
    for law, constants, wanted in TENSILE:
        point = MaterialPoint(law, constants)
        for n in range(1, steps + 1):
            pull(point, n * rate * duration, duration)
        tau, target = point.kirchhoff[0, 0], wanted(rate)
        volume = math.exp((1 - 2 * BINGHAM["poisson"]) * target / BINGHAM["youngs_modulus"])
        name = law if isinstance(law, str) else str(law.rate)
        rows.append([name, f"{target:.12f}", f"{tau:.12f}", f"{tau / target - 1:.1e}", f"{point.cauchy[0, 0]:.12f}"])
        assert tau == pytest.approx(target, rel=1e-10), name
        assert point.cauchy[0, 0] == pytest.approx(target / volume, rel=1e-10), name
        assert point.rate == pytest.approx(rate, rel=1e-10), name
        # isotropic: the width contracts as the side does
        assert point.width_stretch == pytest.approx(point.deformation[1, 1], rel=1e-10), name
    title = f"tensile test at true rate {rate}, stretched by {math.exp(steps * rate * duration):.2f}"
    show(title, ("flow rule", "wanted", "Kirchhoff", "relative error", "Cauchy"), rows)


def test_a_finite_path_of_shear_and_stretch_is_first_order_in_the_step() -> None:
    stress, state, width = integrate(shear_and_stretch, 3000, BINGHAM)
    coarse, _, _ = integrate(shear_and_stretch, 1500, BINGHAM)
    trust = np.abs(stress - coarse).max()
    assert trust < 1e-8, "the judge has converged"
    rows, errors = [], []
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
        ratio = errors[-1] / error if errors else np.full(3, np.nan)
        errors.append(error)
        rows.append([steps, *(f"{e:.2e} ({r:.2f})" for e, r in zip(error, ratio, strict=True))])
    show(
        f"implicit step against Runge-Kutta in 3 x 3 (its own error {trust:.0e}); in brackets the gain of halving",
        ("steps", "P, relative", "Cp^-1", "F33"),
        rows,
    )
    assert errors[-1].max() < 1e-3
    assert errors[-2] / errors[-1] == pytest.approx(2 * np.ones(3), abs=0.05)


def test_every_step_however_long_solves_the_implicit_equations() -> None:
    """Ee_trial - Ee_new = dt Lp(M_new), with matrix logarithms, for steps from 1e-5 to 1e5 relaxation times."""
    for law in ["maxwell", "bingham", THINNING, THICKENING, SINH]:
        rng = np.random.default_rng(5)
        constants = OF_ITS_OWN if isinstance(law, PointLaw) else {"maxwell": MAXWELL, "bingham": BINGHAM}[law]
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
    rows = []
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
        rows.append([law, f"{worst:.1e}"])
        assert worst < 1e-12
    show("200 steps seen by an observer who turns", ("law", "largest difference of Q P, energy, work, F33"), rows)
