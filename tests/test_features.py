"""Features of a film against films whose features are known, against noise alone, and against their own errors."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.features import SLACKEST, TAUTEST, Features, read_features, sensitivity
from tests.common.draws import deviations, draws, errors_away, shares
from tests.common.films import DECAY, GRAVITY, SLOPE, SPAN, UNIT, film, frequency_at, third_law

TRUE_B = 64 / 9 * SLOPE * UNIT / SPAN**3


def read(time: np.ndarray, midpoint: np.ndarray, std: float | None = None) -> Features:
    errors = None if std is None else np.full_like(midpoint, std)
    return read_features(time, midpoint, errors, GRAVITY, SPAN)


def test_a_film_without_noise_gives_back_its_formula() -> None:
    found = read(*film(401, 0.0, 0, rings=True))
    assert found.ringing is not None
    middle = found.ringing.middle
    assert found.frequency.value == pytest.approx(frequency_at(middle), rel=2e-3)
    assert found.decay.value == pytest.approx(DECAY, rel=0.02)
    assert found.sag.value == pytest.approx(third_law(np.array([middle]))[0], rel=2e-3)
    assert found.prefactor.value == pytest.approx(TRUE_B, rel=0.02)


@pytest.mark.slow
@pytest.mark.statistical
def test_noise_on_a_smooth_descent_is_no_oscillation() -> None:
    alarms = sum(read(*film(80, 0.01, seed, rings=False)).ringing is not None for seed in range(200))
    # One in a thousand is promised: of 200, six at most.
    assert alarms / 200 <= shares(200, 1e-3)[1]


@pytest.mark.parametrize("curve", [np.cbrt, lambda t: 1 - np.exp(-2 * t)])
def test_a_smooth_descent_without_noise_is_no_oscillation(curve: object) -> None:
    time = np.linspace(0, 3, 101)
    found = read(time, -5e-3 * curve(time))  # type: ignore[operator]
    assert found.frequency.value is None
    assert found.frequency.reason


@pytest.mark.slow
@pytest.mark.statistical
def test_the_errors_are_what_the_scatter_of_many_films_says() -> None:
    off: dict[str, list[float]] = {"R": [], "d": [], "H": [], "B": []}
    count = 300
    for seed in range(count):
        found = read(*film(200, 0.01, 1000 + seed, rings=True))
        assert found.ringing is not None, found.frequency.reason
        middle = found.ringing.middle
        true = {"R": frequency_at(middle), "d": DECAY, "H": third_law(np.array([middle]))[0], "B": TRUE_B}
        readings = {"R": found.frequency, "d": found.decay, "H": found.sag, "B": found.prefactor}
        for name, one in readings.items():
            if one.value is not None and one.error is not None:
                off[name].append((one.value - true[name]) / one.error)
    for name, values in off.items():
        print(name, len(values), np.mean(values), np.sqrt(np.mean(np.square(values))))
        # All of them are there: the decay, the least certain, is 6.9 to 9.5 of its standard errors.
        assert len(values) > 0.93 * count, name
        # What a frame more or less brings is no error: deviations are 0.87 to 1.03 of what is said, means 0.04 of it.
        low, high = deviations(len(values))
        assert abs(np.mean(values)) < 0.06 + errors_away() / math.sqrt(len(values)), name
        assert 0.85 * low < np.sqrt(np.mean(np.square(values))) < 1.05 * high, name


@cache
def slow_maxwell() -> sc.Run:
    """Four gravity times of the small-deflection model."""
    changes = {"model": "small-deflection", "groups.duration": 4, "run.frames": 201, "numerics.estimate": False}
    return sc.simulate(sc.load_scene("maxwell-slow", changes))


@pytest.mark.slow
@pytest.mark.statistical
@pytest.mark.parametrize("noise", [0.01, 0.03])
def test_the_ringing_of_the_slow_maxwell_scene_is_found_under_noise(noise: float) -> None:
    run = slow_maxwell()
    time, midpoint = run.data.time.values, run.data.midpoint.values
    scale = float(np.abs(midpoint).max())
    clean = read(time, midpoint, 1e-3 * scale)
    assert clean.ringing is not None
    for seed in range(2):
        scatter = draws(seed).standard_normal(len(time))
        found = read(time, midpoint + noise * scale * scatter)
        # Its energy is 470 variances of a frame or more; 35 are enough to be found.
        assert found.ringing is not None, found.frequency.reason
        there = found.ringing.middle / clean.ringing.middle
        expected = clean.ringing.frequency * there**clean.ringing.stiffening
        # Of 60 draws the error is 0.3 to 1.5 %, and the stiffening's, of the clean film, is less than half a per cent.
        assert found.frequency.error is not None and found.frequency.error < 0.05 * expected
        assert abs(found.ringing.frequency - expected) < errors_away() * found.frequency.error + 0.005 * expected
        assert found.decay.value is None or found.decay.value * UNIT * 2 * 0.35 == pytest.approx(1.0, rel=1.0)


@pytest.mark.statistical
def test_the_start_of_the_third_law_is_where_a_closely_filmed_descent_has_slowed_down() -> None:
    time = np.linspace(0, 0.5, 2001)
    early, late = 0.5 * GRAVITY * time[1:] ** 2, third_law(time[1:])
    sag = np.concatenate([[0.0], (early**-8 + late**-8) ** (-1 / 8)])
    slowing = -np.gradient(np.gradient(sag, time), time)
    beyond = np.flatnonzero((slowing < GRAVITY / 15) & (time > time[np.argmax(slowing)]))[0]
    found = read(time, -sag, 1e-7)
    assert found.t_high.value == pytest.approx(time[beyond], rel=0.05)
    noisy = read(time, -sag + 1e-4 * draws(0).standard_normal(len(time)))
    assert noisy.t_high.value is None
    assert noisy.t_high.reason


@pytest.mark.statistical
def test_a_beam_that_flows_has_no_third_law() -> None:
    time = np.linspace(0, 3, 120)
    # The slope of log(sag) over log(t) errs by 1e-6/(1e-3 * 2)/(sqrt(80) * 0.3) = 2e-4: 0.005, by which it would be
    # printed as another, is 25 standard errors away.
    scatter = 1e-6 * draws(2).standard_normal(len(time))
    found = read(time, -1e-3 * time + scatter)
    assert found.prefactor.value is None
    assert "t^1.0" in found.prefactor.reason


def test_an_oscillation_that_does_not_fade_has_no_decay_rate() -> None:
    time = np.linspace(0, 2, 200)
    sag = 5e-3 + 5e-4 * np.cos(40 * time)
    sag[time < 0.05] = np.minimum(0.5 * GRAVITY * time**2, sag)[time < 0.05]
    # Noise of one sign and the other in turn: what is drawn fades once in fifty films.
    found = read(time, -sag + 1e-4 * (-1.0) ** np.arange(len(time)))
    assert found.frequency.value == pytest.approx(40, rel=0.01)
    assert found.decay.value is None
    assert "slower than" in found.decay.reason
    assert math.isnan(found.ringing_covariance[1, 1])


def test_a_midpoint_that_never_moves_has_no_features_and_says_why() -> None:
    found = read(np.linspace(0, 1, 50), np.zeros(50))
    for one in (found.t_high, found.frequency, found.decay, found.sag, found.prefactor):
        assert one.value is None
        assert one.reason


@pytest.mark.parametrize("mode", [4.0, 6.0, 8.0, 8.9])
def test_the_sensitivity_is_the_slope_of_the_modulus_of_a_cable(mode: float) -> None:
    def log_modulus(log_mode: float) -> float:
        # Irvine and Caughey 1974, at a given sag
        half = math.exp(log_mode) / 2
        return math.log(half**3 / (half - math.tan(half)))

    middle, step = math.log(mode), 1e-5
    slope = (log_modulus(middle + step) - log_modulus(middle - step)) / (2 * step)
    assert sensitivity(mode) == pytest.approx(slope, rel=1e-5)
    assert math.tan(SLACKEST / 2) == pytest.approx(SLACKEST / 2, rel=1e-3)
    assert math.isinf(sensitivity(1.001 * SLACKEST))
    assert math.isinf(sensitivity(0.999 * TAUTEST))
