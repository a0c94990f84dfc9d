"""Level and power of the tests for white residuals."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lfilter
from scipy.stats import chi2

from softcat_sym.fitting.identifiability import check_residuals


def noise(sets: int, points: int, correlation: float = 0.0) -> np.ndarray:
    white = np.random.default_rng(11).standard_normal((sets, points + 50))
    return lfilter([1.0], [1.0, -correlation], white, axis=1)[:, 50:]


def share_not_white(residuals: np.ndarray, filaments: int = 1) -> float:
    found = [check_residuals(np.split(one, filaments), 2, noise_known=False).verdict for one in residuals]
    return found.count("not white") / len(found)


@pytest.mark.parametrize(("points", "filaments"), [(60, 1), (200, 1), (200, 4)])
def test_white_residuals_are_rarely_accused(points: int, filaments: int) -> None:
    assert share_not_white(noise(2000, points), filaments) < 0.015


@pytest.mark.parametrize("points", [60, 200])
def test_each_test_has_its_level(points: int) -> None:
    checks = [check_residuals([one], 0, noise_known=False) for one in noise(2000, points)]
    for k in range(3):
        p_values = np.array([check.tests[k].p_value for check in checks])
        assert abs(np.mean(p_values < 0.05) - 0.05) < 0.02
        assert abs(np.mean(p_values < 0.5) - 0.5) < 0.1


@pytest.mark.parametrize("filaments", [1, 2])
def test_correlated_residuals_are_found(filaments: int) -> None:
    assert share_not_white(noise(300, 200, 0.5), filaments) > 0.99
    assert share_not_white(noise(300, 200, -0.5), filaments) > 0.99


def test_a_systematic_misfit_is_found() -> None:
    x = np.linspace(0, 1, 100)
    assert share_not_white(noise(300, 100) + 1.5 * np.sin(2 * np.pi * x)) > 0.99
    check = check_residuals([noise(1, 100)[0] + 5], 2, noise_known=False)
    assert check.verdict == "not white"


def test_the_end_of_one_filament_is_no_neighbour_of_the_next() -> None:
    series = noise(40, 25)
    joined = check_residuals(list(series), 2, noise_known=False)
    assert joined.verdict == "white"
    assert joined.autocorrelation == pytest.approx(0.0, abs=0.1)


def test_statistics_by_hand() -> None:
    one = noise(1, 40)[0]
    runs, neighbours, box = check_residuals([one], 2, noise_known=False).tests
    count = 1 + int(np.sum(np.sign(one[1:]) != np.sign(one[:-1])))
    above = int(np.sum(one > 0))
    mean = 2 * above * (40 - above) / 40 + 1
    variance = (mean - 1) * (mean - 2) / 39
    assert runs.value == pytest.approx(np.sign(count - mean) * max(abs(count - mean) - 0.5, 0) / np.sqrt(variance))
    lags = [np.sum(one[k:] * one[:-k]) / np.sum(one**2) for k in range(1, 9)]
    assert neighbours.value == pytest.approx(np.sqrt(40) * lags[0])
    assert box.value == pytest.approx(40 * 42 * sum(r**2 / (39 - k) for k, r in enumerate(lags)))
    assert box.p_value == pytest.approx(chi2.sf(box.value, 8))


def test_size_is_chi_square() -> None:
    one = noise(1, 100)[0]
    check = check_residuals([one], 3, noise_known=True)
    assert check.size.value == pytest.approx(float(one @ one))
    assert check.size.p_value == pytest.approx(chi2.sf(one @ one, 97), rel=1e-9)
    assert check_residuals([2 * one], 3, noise_known=True).size.p_value < 1e-6
    assert check_residuals([one], 3, noise_known=False).size is None


def test_few_or_exact_residuals_cannot_tell() -> None:
    assert check_residuals([np.ones(5)], 2, noise_known=False).verdict == "cannot tell"
    assert check_residuals([np.zeros(100)], 2, noise_known=True).verdict == "cannot tell"
