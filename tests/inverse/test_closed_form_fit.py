"""The features' common answer against exact features and against SciPy."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.closed_form import combined_estimate
from softcat_sym.fitting.features import Features, unread
from tests.inverse.known_features import DENSITY, GRAVITY, SPAN, features_of

PRESSURE = DENSITY * GRAVITY * SPAN
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
    assert found.constants.youngs_modulus == pytest.approx(4e4 * PRESSURE, rel=1e-6)
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
    assert math.log(found.constants.youngs_modulus / PRESSURE) == pytest.approx(oracle.x[0], abs=1e-6)
    assert math.log(found.constants.viscosity / VISCOUS) == pytest.approx(oracle.x[1], abs=1e-6)
    covariance = np.linalg.inv(oracle.jac.T @ oracle.jac)[:2, :2]
    np.testing.assert_allclose(found.constants.covariance, covariance, rtol=1e-4)
    np.testing.assert_allclose(list(found.residuals.values()), predicted(*oracle.x) - measured, atol=1e-6)


def test_what_the_film_does_not_show_is_left_out() -> None:
    truth = predicted(math.log(4e4), math.log(1.5e4), math.log(0.02))
    partial = replace(film(truth), t_high=unread("hidden"), prefactor=unread("too short"))
    found = combined_estimate(partial, DENSITY)
    assert set(found.residuals) == {"frequency", "decay", "sag"}
    assert found.constants.youngs_modulus == pytest.approx(4e4 * PRESSURE, rel=1e-6)


def test_without_an_oscillation_there_is_no_estimate_and_a_reason() -> None:
    truth = predicted(math.log(4e4), math.log(1.5e4), math.log(0.02))
    silent = replace(film(truth), ringing=None, frequency=unread("no oscillation is seen above the noise"))
    with pytest.raises(SoftcatError, match="no oscillation is seen"):
        combined_estimate(silent, DENSITY)
