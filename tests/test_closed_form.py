"""Modulus and viscosity from what a film shows, against the formulas they invert, and their common answer by IPOPT."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.closed_form import closed_form, combined_estimate
from softcat_sym.fitting.features import SLACKEST, TAUTEST, Features, modulus_of, sensitivity, stiffness_number, unread
from tests.common.draws import draws
from tests.common.known_features import DENSITY, GRAVITY, SPAN, UNIT, features_of

B = 3.3e-5
CLOCK = 0.2
STIFFNESS = (3 * CLOCK**2 / B) ** (1 / 3)
PRESSURE = DENSITY * GRAVITY * SPAN


def ringing_at(tau: float) -> float:
    """(2.22), by hand."""
    return math.sqrt(24 * tau * STIFFNESS - 1) / (2 * tau)


@pytest.mark.parametrize(("tau", "root"), [(0.35, "ringing"), (0.035, "ringing"), (0.0035, "fading")])
def test_both_roots_are_found_and_the_decay_rate_picks_the_true_one(tau: float, root: str) -> None:
    found = closed_form(features_of(ringing_at(tau), 1 / (2 * tau), 0.02, B), DENSITY)
    assert found.ringing is not None
    assert found.fading is not None
    assert found.picked == root
    assert found.paper.youngs_modulus == pytest.approx(PRESSURE / (2 * B * tau))
    assert found.paper.viscosity == pytest.approx(DENSITY * math.sqrt(GRAVITY * SPAN**3) / (2 * B))
    product = found.ringing.relaxation_time * found.fading.relaxation_time / UNIT**2
    assert product == pytest.approx(1 / (4 * ringing_at(tau) ** 2))


def test_without_a_decay_rate_neither_root_is_picked() -> None:
    found = closed_form(features_of(ringing_at(0.35), None, 0.02, B), DENSITY)
    assert found.picked is None
    assert found.paper is None
    assert found.ringing.youngs_modulus < found.fading.youngs_modulus


def test_a_frequency_beyond_the_double_root_is_refused_with_its_excess() -> None:
    found = closed_form(features_of(6 * STIFFNESS * 1.1, 30.0, 0.02, B), DENSITY)
    assert found.ringing is None
    assert found.fading is None
    assert "10 %" in found.refused["(2.22)"]


def test_without_the_third_law_the_decay_gives_the_viscosity() -> None:
    modulus, tau, sag = 4e4, 0.35, 0.02
    decay = 1 / (2 * tau)
    frequency = math.sqrt(64 * modulus * sag**2 + 1.5 / sag - decay**2)
    found = closed_form(features_of(frequency, decay, sag, None), DENSITY)
    assert found.from_sag.youngs_modulus == pytest.approx(modulus * PRESSURE)
    assert found.from_sag.viscosity == pytest.approx(modulus * PRESSURE * tau * UNIT)
    assert "not late enough" in found.refused["(2.22)"]


@pytest.mark.slow
@pytest.mark.statistical
def test_errors_are_those_of_many_readings() -> None:
    tau, sag, errors = 0.35, 0.02, (0.01, 0.02, 0.01, 0.02)
    at = np.array([ringing_at(tau), 1 / (2 * tau), sag, B])
    told = closed_form(features_of(*at, errors=errors), DENSITY)
    drawn = draws(5).standard_normal((800, 4))
    many = [closed_form(features_of(*(at * np.exp(draw * errors))), DENSITY) for draw in drawn]
    for name in ("ringing", "from_sag"):
        logs = np.log([[getattr(one, name).youngs_modulus, getattr(one, name).viscosity] for one in many])
        # A variance of 800 draws is off by up to 5.3 sqrt(2/800) = 27 %, a covariance by a little more.
        np.testing.assert_allclose(np.cov(logs.T), getattr(told, name).covariance, rtol=0.35, atol=1.5e-4)
    assert 2 < told.ringing.condition < 3


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


def test_the_film_is_told_by_how_much_its_onset_contradicts_its_law() -> None:
    onset = (B / 3) ** 0.2 * (6 / 15) ** -0.6
    agreed = closed_form(features_of(ringing_at(0.35), 1.4, 0.02, B, t_high=onset), DENSITY)
    assert agreed.onset_misfit == pytest.approx(0.0, abs=1e-9)
    contrary = closed_form(features_of(ringing_at(0.35), 1.4, 0.02, B, t_high=1.5 * onset), DENSITY)
    assert contrary.onset_misfit == pytest.approx((5 * math.log(1.5)) ** 2 / (0.03**2 + 25 * 0.02**2))


@pytest.mark.parametrize("density", [0.0, -1.0, math.nan, math.inf])
def test_a_density_that_is_none_is_refused(density: float) -> None:
    with pytest.raises(SoftcatError, match="positive number"):
        closed_form(features_of(20.0, 1.4, 0.02, B), density)


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
    np.testing.assert_allclose(found.constants.covariance, covariance, rtol=1e-4)
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
