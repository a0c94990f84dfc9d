"""Modulus and viscosity from what a film shows, against the formulas they invert, and their common answer by IPOPT."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.closed_form import combined_estimate, first_guess
from softcat_sym.fitting.features import (
    SLACKEST,
    TAUTEST,
    Features,
    mode_number,
    modulus_of,
    sensitivity,
    stiffness_number,
    unread,
)
from tests.common.known_features import DENSITY, GRAVITY, SPAN, UNIT, features_of

B = 3.3e-5
PRESSURE = DENSITY * GRAVITY * SPAN


def test_without_the_third_law_the_decay_gives_the_viscosity() -> None:
    modulus, tau, sag = 4e4, 0.35, 0.02
    decay = 1 / (2 * tau)
    frequency = math.sqrt(64 * modulus * sag**2 + 1.5 / sag - decay**2)
    # Beyond the range of a cable the shape is held.
    assert mode_number(frequency / UNIT, sag * SPAN, GRAVITY) > SLACKEST
    found = first_guess(features_of(frequency, decay, sag, None), DENSITY)
    assert found.youngs_modulus == pytest.approx(modulus * PRESSURE)
    assert found.viscosity == pytest.approx(modulus * PRESSURE * tau * UNIT)
    with pytest.raises(SoftcatError, match=r"neither B nor a decay rate.*not late enough"):
        first_guess(features_of(frequency, None, sag, None), DENSITY)


def frequencies_of_a_cable(modulus: float, tau: float, sag: float, cells: int = 300) -> np.ndarray:
    """Eigenvalues of a Maxwell cable by finite differences on half its span, in L and sqrt(L/g).

    y_tt = T y_xx - 8 H q, q_t = E 8 H (int y dx)_t - q/tau, T = 1/(8 H), symmetric about x = 0.
    """
    x, step = np.linspace(0, 0.5, cells + 1)[:-1], 0.5 / cells
    second = (np.diag(np.full(cells, -2.0)) + np.eye(cells, k=1) + np.eye(cells, k=-1)) / step**2
    second[0, 1] *= 2
    weight = np.full(len(x), 2 * step)
    weight[0] = step
    state = np.zeros((2 * cells + 1, 2 * cells + 1))
    state[:cells, cells:-1] = np.eye(cells)
    state[cells:-1, :cells] = second / (8 * sag)
    state[cells:-1, -1] = -8 * sag
    state[-1, cells:-1] = 8 * sag * modulus * weight
    state[-1, -1] = -1 / tau
    return np.linalg.eigvals(state)


@pytest.mark.parametrize(("modulus", "tau", "sag"), [(4e4, 0.35, 0.01), (4e4, 0.1, 0.01), (500.0, 2.0, 0.05)])
def test_a_cable_gives_back_its_modulus_and_relaxation_time(modulus: float, tau: float, sag: float) -> None:
    values = frequencies_of_a_cable(modulus, tau, sag)
    lowest = min((value for value in values if value.imag > 1), key=lambda value: value.imag)
    found = modulus_of(lowest.imag / UNIT, -lowest.real / UNIT, sag * SPAN, GRAVITY, SPAN)
    assert found is not None
    assert found.modulus == pytest.approx(modulus, rel=2e-3)
    assert found.relaxation_time / UNIT == pytest.approx(tau, rel=2e-3)


def test_the_cable_says_nothing_at_either_end_of_its_range() -> None:
    assert modulus_of(1.01 * SLACKEST / math.sqrt(8 * 0.004 / GRAVITY), 1.0, 0.004, GRAVITY, SPAN) is None
    assert modulus_of(0.99 * TAUTEST / math.sqrt(8 * 0.004 / GRAVITY), 1.0, 0.004, GRAVITY, SPAN) is None
    for mode in (4.0, 6.0, 8.0, 8.9):
        ratio = abs(stiffness_number(mode * 1.0001) / stiffness_number(mode / 1.0001))
        assert sensitivity(mode) == pytest.approx(math.log(ratio) / 2e-4, rel=1e-3)


@pytest.mark.parametrize("density", [0.0, -1.0, math.nan, math.inf])
def test_a_density_that_is_none_is_refused(density: float) -> None:
    with pytest.raises(SoftcatError, match="positive number"):
        first_guess(features_of(20.0, 1.4, 0.02, B), density)


LOAD = DENSITY * GRAVITY * SPAN
VISCOUS = DENSITY * math.sqrt(GRAVITY * SPAN**3)
ERRORS = np.array([0.01, 0.05, 0.02, 0.03, 0.02])


def predicted(log_E: float, log_V: float, log_H: float) -> np.ndarray:
    """Logarithms of R, d, H, B and t_high, written by hand."""
    modulus, number, sag = math.exp(log_E), math.exp(log_V), math.exp(log_H)
    decay, load = modulus / (2 * number), 1 / (2 * number)
    square = 64 * modulus * sag**2 + 1.5 / sag - decay**2
    onset = (load / 3) ** 0.2 * (6 / 15) ** -0.6
    return np.log([math.sqrt(square), decay, sag, load, onset])


def film(log_features: np.ndarray) -> Features:
    R, d, H, load, onset = np.exp(log_features)
    return features_of(R, d, H, load, t_high=onset)


def test_exact_features_give_back_their_constants() -> None:
    truth = predicted(math.log(4e4), math.log(1.5e4), math.log(0.02))
    found = combined_estimate(film(truth), DENSITY)
    assert found.constants.youngs_modulus == pytest.approx(4e4 * LOAD, rel=1e-6)
    assert found.constants.viscosity == pytest.approx(1.5e4 * VISCOUS, rel=1e-6)
    assert found.misfit == pytest.approx(0.0, abs=1e-9)
    assert found.freedom == 3


@pytest.mark.parametrize("theory_error", [0.0, 0.05])
def test_features_that_disagree_are_weighed_as_scipy_weighs_them(theory_error: float) -> None:
    start = np.array([math.log(4e4), math.log(1.5e4), math.log(0.02)])
    spread = np.sqrt(ERRORS**2 + theory_error**2)
    measured = predicted(*start) + ERRORS * np.array([1.0, -2.0, 0.5, 1.5, -1.0])
    # Away from E = E/(2 d), where one of the features alone would already decide.
    found = combined_estimate(film(measured), DENSITY, theory_error)
    oracle = least_squares(lambda q: (predicted(*q) - measured) / spread, start, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    assert found.misfit == pytest.approx(2 * oracle.cost, rel=1e-6)
    assert math.log(found.constants.youngs_modulus / LOAD) == pytest.approx(oracle.x[0], abs=1e-6)
    assert math.log(found.constants.viscosity / VISCOUS) == pytest.approx(oracle.x[1], abs=1e-6)
    covariance = np.linalg.inv(oracle.jac.T @ oracle.jac)[:2, :2]
    np.testing.assert_allclose(found.covariance, covariance, rtol=1e-4)
    np.testing.assert_allclose(list(found.residuals.values()), predicted(*oracle.x) - measured, atol=1e-6)


def test_what_the_film_does_not_show_is_left_out() -> None:
    truth = predicted(math.log(4e4), math.log(1.5e4), math.log(0.02))
    partial = replace(film(truth), t_high=unread("hidden"), prefactor=unread("too short"))
    found = combined_estimate(partial, DENSITY)
    assert set(found.residuals) == {"frequency", "decay", "sag"}
    assert found.constants.youngs_modulus == pytest.approx(4e4 * LOAD, rel=1e-6)


def test_without_an_oscillation_there_is_no_estimate_and_a_reason() -> None:
    truth = predicted(math.log(4e4), math.log(1.5e4), math.log(0.02))
    silent = replace(film(truth), ringing=None, frequency=unread("no oscillation is seen above the noise"))
    with pytest.raises(SoftcatError, match="no oscillation is seen"):
        combined_estimate(silent, DENSITY)
