"""The three-dimensional law in numbers: integrated along a path, against what a tensile test must give."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm
from scipy.optimize import brentq

from softcat_sym.physics import bulk
from softcat_sym.physics.equation import check
from softcat_sym.physics.laws import bingham_rate, maxwell_rate
from softcat_sym.physics.symbols import E, eta, sigma_Y

MODULUS, POISSON, YIELD, VISCOSITY = 1.0, 0.45, 0.02, 0.5
CONSTANTS = {E: MODULUS, bulk.nu: POISSON, sigma_Y: YIELD, eta: VISCOSITY}
LAW = bulk.general(bingham_rate())
UPPER = [(i, j) for i in range(3) for j in range(i, 3)]


def compiled(inputs: list[sp.Symbol], expression: sp.Expr | sp.Matrix) -> Callable[..., np.ndarray]:
    return sp.lambdify(inputs, expression.subs(CONSTANTS), modules="numpy")


STRESS = compiled([bulk.elastic_strain[i, j] for i, j in UPPER], LAW.stress)
EQUIVALENT = compiled([bulk.mandel[i, j] for i, j in UPPER], LAW.equivalent)
FLOW = compiled([bulk.mandel[i, j] for i, j in UPPER] + [bulk.sigma_eq], LAW.flow)
RESIDUAL = compiled([bulk.sigma_eq, bulk.sigma_trial, bulk.step], LAW.residual)


def six(tensor: np.ndarray) -> list[float]:
    return [tensor[i, j] for i, j in UPPER]


def of_symmetric(function: Callable[[np.ndarray], np.ndarray], tensor: np.ndarray) -> np.ndarray:
    values, axes = np.linalg.eigh(tensor)
    return axes @ np.diag(function(values)) @ axes.T


def elastic_strain(deformation: np.ndarray, plastic: np.ndarray) -> np.ndarray:
    elastic = deformation @ np.linalg.inv(plastic)
    return of_symmetric(np.log, elastic.T @ elastic) / 2


def flow_at(stress: np.ndarray) -> np.ndarray:
    equivalent = max(float(EQUIVALENT(*six(stress))), 1e-12)
    return np.array(FLOW(*six(stress), equivalent), dtype=float)


def shear_and_stretch(time: float) -> np.ndarray:
    stretch = 1 + 0.1 * time
    return np.array([[stretch, 0.15 * np.sin(3 * time), 0], [0, stretch**-0.5, 0.05 * time], [0, 0, stretch**-0.5]])


def explicit(path: Callable[[float], np.ndarray], steps: int) -> np.ndarray:
    plastic, dt = np.eye(3), 1 / steps
    for n in range(steps):
        stress = STRESS(*six(elastic_strain(path(n * dt), plastic)))
        plastic = of_symmetric(np.exp, dt * flow_at(stress)) @ plastic
    return plastic


def implicit(path: Callable[[float], np.ndarray], steps: int) -> np.ndarray:
    """Radial return: one scalar equation a step."""
    plastic, dt = np.eye(3), 1 / steps
    for n in range(steps):
        trial = STRESS(*six(elastic_strain(path((n + 1) * dt), plastic)))
        size = float(EQUIVALENT(*six(trial)))
        new = brentq(RESIDUAL, 1e-12, size, args=(size, dt), xtol=1e-15) if size > 1e-12 else size
        plastic = of_symmetric(np.exp, dt * flow_at(trial * new / size)) @ plastic if size > 1e-12 else plastic
    return plastic


@pytest.mark.parametrize("stress", [0.01, 0.03, -0.05])
def test_a_tensile_test_flows_at_the_rate_of_the_fibre(stress: float) -> None:
    flow = flow_at(np.diag([stress, 0, 0]))
    rate = np.sign(stress) * max(abs(stress) - YIELD, 0) / VISCOSITY
    assert np.diag(flow) == pytest.approx([rate, -rate / 2, -rate / 2])


def test_pulled_elastically_a_bar_has_its_modulus_and_poisson_ratio() -> None:
    stretch = 1.3
    stress = STRESS(*six(elastic_strain(np.diag([stretch, stretch**-POISSON, stretch**-POISSON]), np.eye(3))))
    assert np.diag(stress) == pytest.approx([MODULUS * np.log(stretch), 0, 0], abs=1e-14)


def test_flow_keeps_the_volume_and_dissipates() -> None:
    rng = np.random.default_rng(1)
    for _ in range(50):
        stress = rng.normal(size=(3, 3)) * 0.05
        stress = stress + stress.T
        flow = flow_at(stress)
        size = float(EQUIVALENT(*six(stress)))
        assert np.trace(flow) == pytest.approx(0, abs=1e-14)
        assert np.sum(stress * flow) == pytest.approx(size * max(size - YIELD, 0) / VISCOSITY)
    assert np.linalg.det(explicit(shear_and_stretch, 50)) == pytest.approx(1, abs=1e-12)


def test_implicit_steps_converge_to_the_explicit_path() -> None:
    reference = explicit(shear_and_stretch, 1600)
    assert np.abs(reference - np.eye(3)).max() > 0.02
    errors = [np.abs(implicit(shear_and_stretch, steps) - reference).max() for steps in (25, 50)]
    assert errors[1] < 2e-3
    assert errors[0] / errors[1] == pytest.approx(2, abs=0.4)


def test_an_implicit_step_ends_at_the_stress_it_announces() -> None:
    deformation, dt = shear_and_stretch(0.4), 0.3
    trial = STRESS(*six(elastic_strain(deformation, np.eye(3))))
    size = float(EQUIVALENT(*six(trial)))
    new = brentq(RESIDUAL, 1e-12, size, args=(size, dt), xtol=1e-15)
    plastic = of_symmetric(np.exp, dt * flow_at(trial * new / size))
    stress = STRESS(*six(elastic_strain(deformation, plastic)))
    assert YIELD < new < 0.9 * size
    assert float(EQUIVALENT(*six(stress))) == pytest.approx(new, rel=1e-9)


def test_the_stress_is_the_slope_of_the_energy() -> None:
    energy = compiled([bulk.elastic_strain[i, j] for i, j in UPPER], bulk.elastic_energy(bulk.elastic_strain))
    strain, change = np.diag([0.03, -0.01, 0.02]), np.array([[1, 2, 0], [2, -1, 0.5], [0, 0.5, 3]]) * 1e-4
    gained = energy(*six(strain + change)) - energy(*six(strain - change))
    assert gained == pytest.approx(2 * np.sum(STRESS(*six(strain)) * change))


def test_closed_form_of_the_return() -> None:
    closed = compiled([bulk.sigma_trial, bulk.step], bulk.bingham_return())
    for trial in (0.01, 0.02, 0.05, 1.0):
        assert RESIDUAL(float(closed(trial, 0.3)), trial, 0.3) == pytest.approx(0, abs=1e-15)


def test_a_turning_observer_sees_the_same_flow() -> None:
    spin = np.array([[0, -1.0, 0.5], [1.0, 0, 0.2], [-0.5, -0.2, 0]])
    turned = explicit(lambda time: expm(spin * time) @ shear_and_stretch(time), 40)
    assert turned == pytest.approx(explicit(shear_and_stretch, 40), abs=1e-12)


def test_plane_stress_is_the_general_law_with_a_free_width() -> None:
    law = bulk.plane_stress(maxwell_rate())
    plane = [bulk.elastic_strain[0, 0], bulk.elastic_strain[1, 1]]
    strain = np.array(compiled(plane, law.strain)(0.02, -0.005), dtype=float)
    assert np.array(compiled(plane, law.stress)(0.02, -0.005)) == pytest.approx(STRESS(*six(strain)), abs=1e-15)
    assert STRESS(*six(strain))[2, 2] == pytest.approx(0, abs=1e-16)


def test_dimensions() -> None:
    for equation in bulk.BULK_EQUATIONS:
        assert check(equation) is not None
