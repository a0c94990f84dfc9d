"""What data tell: covariance, combinations, profiles, verdicts and white residuals, against closed forms and SciPy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.optimize import brentq, curve_fit, minimize_scalar
from scipy.signal import lfilter
from scipy.stats import f as fisher

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.identifiability import (
    Information,
    check_residuals,
    information,
    standard_errors,
)
from softcat_sym.fitting.inference import ParameterVerdict, Profile, infer, profile, verdicts
from softcat_sym.fitting.least_squares import Fixed, minimise, multi_start
from tests.common.draws import draws, errors_away, shares
from tests.common.fit_problems import Problem, X, decay, line, problem, product, saturation


def informed(p: Problem, *, noise_known: bool, logarithmic: tuple[bool, ...] | None = None) -> Information:
    best = minimise(p, np.zeros(len(p.names)))
    return information(
        p.names,
        best.q,
        best.residuals,
        best.jacobian,
        (p.lower, p.upper),
        noise_known=noise_known,
        logarithmic=logarithmic,
    )


def test_straight_line_has_the_textbook_covariance() -> None:
    p = problem("offset slope", line, [1.0, 2.0], 0.1)
    found = informed(p, noise_known=True)
    spread = np.sum((X - X.mean()) ** 2)
    slope = 0.01 / spread
    offset = 0.01 * (1 / X.size + X.mean() ** 2 / spread)
    mixed = -0.01 * X.mean() / spread
    np.testing.assert_allclose(found.covariance, [[offset, mixed], [mixed, slope]], rtol=1e-10)
    assert found.correlation[0, 1] == pytest.approx(mixed / np.sqrt(offset * slope))
    assert found.identified.all()
    assert found.determined.sum() == 2
    assert found.combinations == ()


def test_estimated_noise_gives_the_covariance_of_scipy() -> None:
    p = problem("A k", decay, [0.5, 0.2], 0.01)
    found = informed(p, noise_known=False)
    _, covariance = curve_fit(lambda _, a, k: p.model(np.array([a, k]))[0], X, p.data, p0=[0.5, 0.2], xtol=1e-14)
    np.testing.assert_allclose(found.covariance, covariance, rtol=1e-4)
    best = minimise(p, np.zeros(2))
    np.testing.assert_allclose(found.standard_errors, standard_errors(best.jacobian, 2 * best.value), rtol=1e-9)
    assert found.freedom == 58


@pytest.mark.statistical
@pytest.mark.parametrize("noise_known", [True, False])
@pytest.mark.parametrize("seed", [0, None])
def test_a_quotient_is_identified_where_its_parts_are_not(seed: int | None, noise_known: bool) -> None:
    p = problem("A youngs_modulus viscosity", product, [0.5, 0.2, 0.3], 0.01, seed)
    found = informed(p, noise_known=noise_known)
    assert found.identified.tolist() == [True, False, False]
    assert found.determined.sum() == 2
    (one,) = found.combinations
    assert one.text == "youngs_modulus^1 * viscosity^-1"
    assert one.exponents == (1.0, -1.0)
    single = informed(problem("A k", decay, [0.5, -0.1], 0.01, seed), noise_known=noise_known)
    assert one.standard_error == pytest.approx(single.standard_errors[1], rel=0.1)
    # A deviate of Student's distribution with the freedom of 60 readings less two, or a normal one.
    far = 0.0 if seed is None else errors_away(np.inf if noise_known else 58)
    assert abs(one.value + 0.1) <= far * one.standard_error + 1e-9
    assert one.interval[0] < one.value < one.interval[1]
    value, low, high = one.product([3e4, 1e3])
    assert value == pytest.approx(30 * np.exp(one.value))
    assert low < value < high
    # An unknown that is not identified has an error no larger than the box.
    assert np.all(found.standard_errors < 12)


def test_no_more_data_than_unknowns_leave_no_noise() -> None:
    arrays = np.zeros(2), np.zeros(2), np.eye(2)
    box = (np.full(2, -1.0), np.full(2, 1.0))
    with pytest.raises(SoftcatError, match="at least 3 data, or their standard errors"):
        information(("a", "b"), *arrays, box, noise_known=False)
    fewer = information(("a", "b"), np.zeros(2), np.zeros(1), np.array([[50.0, 50.0]]), box, noise_known=True)
    assert fewer.determined.sum() == 1
    assert fewer.combinations[0].text == "a^1 * b^1"


def profiles(p: Problem, *, noise_known: bool) -> list[Profile]:
    best = minimise(p, np.zeros(len(p.names)))
    return [profile(p, best.q, k, noise_known=noise_known) for k in range(len(p.names))]


@pytest.mark.parametrize("noise_known", [True, False])
def test_profile_of_a_straight_line_is_the_interval_of_the_linear_theory(noise_known: bool) -> None:
    p = problem("offset slope", line, [1.0, 2.0], 0.1)
    best = minimise(p, np.zeros(2))
    known = information(p.names, best.q, best.residuals, best.jacobian, (p.lower, p.upper), noise_known=noise_known)
    for k, one in enumerate(profiles(p, noise_known=noise_known)):
        half = known.quantile * known.standard_errors[k]
        assert one.lower.crossing == pytest.approx(best.q[k] - half, abs=1e-6)
        assert one.upper.crossing == pytest.approx(best.q[k] + half, abs=1e-6)
        np.testing.assert_allclose(one.increase, ((one.q - best.q[k]) / known.standard_errors[k]) ** 2, atol=1e-4)
        assert one.lower.flag == one.upper.flag == "crosses"
        assert (one.unconverged, one.better) == (0, None)
        assert np.all(np.diff(one.q) > 0)
    quantile = 3.841458820694124 if noise_known else fisher.ppf(0.95, 1, 58)
    assert one.threshold == pytest.approx(quantile, rel=1e-9)


@pytest.mark.parametrize("model", [decay, saturation])
def test_crossings_are_those_of_a_brute_force_search(model) -> None:
    p = problem("one two", model, [0.5, 0.2], 0.2)
    best = minimise(p, np.zeros(2))
    for k, one in enumerate(profiles(p, noise_known=True)):

        def increase(at: float, k: int = k) -> float:
            def squares(other: float) -> float:
                q = np.insert([other], k, at)
                return float(np.sum(p.residuals(q) ** 2))

            start = float(best.q[1 - k])
            found = minimize_scalar(squares, (start - 0.1, start + 0.1), tol=1e-12)
            return float(found.fun) - 2 * best.value - 3.841458820694124

        low = brentq(increase, best.q[k] - 2.0, best.q[k])
        high = brentq(increase, best.q[k], best.q[k] + 2.0)
        assert one.lower.crossing == pytest.approx(low, abs=0.003 * (high - low))
        assert one.upper.crossing == pytest.approx(high, abs=0.003 * (high - low))
        assert one.q.size < 15


def too_fast(seed: int = 0) -> Problem:
    """A decay that is over between the first two readings, the amplitude being 16 deviations.

    Were the readings right after the first drawn, one in forty sets would have seen a slower decay at 95 %.
    """
    p = problem("A k", decay, [0.5, 5.0], 0.1, seed)
    p.data[1:4] = 0.0
    return p


def test_a_rate_too_fast_to_see_is_bounded_on_one_side() -> None:
    p = too_fast()
    rate = profiles(p, noise_known=True)[1]
    assert rate.lower.flag == "crosses"
    assert rate.upper.flag == "reaches the bound"
    assert rate.upper.crossing is None
    assert 1.0 < rate.lower.crossing < 5.0
    # Far from a parabola, the crossing is still where the best fit is worse by the threshold.
    held = minimise(Fixed(p, 1, rate.lower.crossing), np.zeros(1))
    assert 2 * (held.value - minimise(p, np.zeros(2)).value) == pytest.approx(rate.threshold, rel=0.02)


def waves(seed: int) -> Problem:
    """A sin(w x) in so much noise that other w fit nearly as well: sets that were chosen for it, drawn once for all."""

    def wave(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values = q[0] * np.sin(q[1] * X)
        return values, np.stack([np.sin(q[1] * X), q[0] * X * np.cos(q[1] * X)], axis=1)

    p = problem("A w", wave, [1.0, 5.0], 1.5, None)
    p.data = p.data + p.std * np.random.default_rng(seed).standard_normal(p.data.size)
    p.lower, p.upper = np.array([0.1, 3.0]), np.array([3.0, 9.0])
    return p


@dataclass
class Posed(Problem):
    noise_known: bool = True
    systematic: float = 0.0

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        return (True,) * len(self.names)


def posed(plain: Problem) -> Posed:
    return Posed(plain.names, plain.lower, plain.upper, plain.model, plain.data, plain.std)


def two_wells(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Least squares with minima near 1 and, the better one, at -1; chi^2 rises by one between them."""
    (x,) = q
    return np.array([1.5 * (x**2 - 1), 0.6 * (x + 1)]), np.array([[3.0 * x], [0.6]])


def wells() -> Posed:
    return Posed(("x",), np.array([-3.0]), np.array([3.0]), two_wells, np.zeros(2), 1.0)


def test_a_better_optimum_that_a_profile_meets_is_the_one_that_is_posed() -> None:
    p = wells()
    starts = multi_start(p, [np.array([1.4])])
    assert starts.best.q[0] == pytest.approx(0.91, abs=0.03)
    found = infer(p, starts)
    assert found.restarts == 1
    assert found.starts.best.q[0] == pytest.approx(-1, abs=1e-6)
    assert [result.cluster for result in found.starts.results] == [0, 1]
    assert found.starts.results[1].optimum is starts.best
    assert found.profiles[0].optimum == found.starts.best.q[0] and found.profiles[0].better is None
    assert found.verdicts[0].best == found.starts.best.q[0]


def test_an_interval_reaches_over_all_optima_that_are_nearly_as_good() -> None:
    p = posed(waves(seed=0))
    starts = multi_start(p, [np.array([0.5, 8.0])])
    found = infer(p, starts)
    assert (found.restarts, found.alternatives) == (1, 1)
    pace = np.linspace(3.0, 9.0, 60001)
    waved = np.sin(np.outer(pace, X))
    amplitude = np.clip(waved @ p.data / np.sum(waved**2, axis=1), 0.1, 3.0)
    chi_square = np.sum((amplitude[:, None] * waved - p.data) ** 2, axis=1) / p.std**2
    within = pace[chi_square < chi_square.min() + found.profiles[1].threshold]
    assert np.any(np.diff(within) > 0.1)
    lower, upper = found.verdicts[1].lower, found.verdicts[1].upper
    assert (lower, upper) == (pytest.approx(within[0], abs=0.01), pytest.approx(within[-1], abs=0.01))
    shown = np.interp(found.profiles[1].q, pace, chi_square - chi_square.min())
    np.testing.assert_allclose(found.profiles[1].increase, shown, atol=0.02)


def judged(p: Problem, *, profiled: bool = True, noise_known: bool = False) -> tuple[ParameterVerdict, ...]:
    best = minimise(p, np.zeros(len(p.names)))
    known = information(p.names, best.q, best.residuals, best.jacobian, (p.lower, p.upper), noise_known=noise_known)
    found = [profile(p, best.q, k, noise_known=noise_known) for k in range(len(p.names))] if profiled else None
    return verdicts(p, best, known, found)


@pytest.mark.statistical
@pytest.mark.parametrize("noise_known", [True, False])
@pytest.mark.parametrize("profiled", [True, False])
def test_identified(profiled: bool, noise_known: bool) -> None:
    quantile, far = (1.96, errors_away()) if noise_known else (2.0017, errors_away(58))
    found = judged(problem("A k", decay, [0.5, 0.2], 0.01), profiled=profiled, noise_known=noise_known)
    for one, truth in zip(found, (0.5, 0.2), strict=True):
        assert one.word == "identified"
        assert abs(one.value - truth) < far * one.standard_error
        assert one.lower < one.value < one.upper
        assert one.upper - one.lower == pytest.approx(2 * quantile * one.standard_error, rel=0.02)
        assert one.reason == ""


@pytest.mark.parametrize("seed", [0, 1, None])
@pytest.mark.parametrize("profiled", [True, False])
def test_not_identified_but_in_combination(profiled: bool, seed: int | None) -> None:
    A, a, b = judged(problem("A a b", product, [0.5, 0.2, 0.3], 0.01, seed), profiled=profiled)
    assert A.word == "identified"
    for one in (a, b):
        assert one.word == "not identified"
        assert one.value is None
        assert one.standard_error is None
        assert "a^1 * b^-1" in one.reason


@pytest.mark.statistical
@pytest.mark.parametrize("seed", range(6))
def test_one_sided(seed: int) -> None:
    rate = judged(too_fast(seed), noise_known=True)[1]
    assert rate.word == "one-sided"
    assert rate.value is None
    # At exp(3.75) = 42 the second reading alone is two deviations off, if the amplitude is right; the limit goes as
    # its logarithm, and nothing is determined only where the first reading is off by more than ten.
    assert rate.lower < 5.0
    assert rate.upper is None
    assert "only its lower limit" in rate.reason


def test_an_interval_of_more_than_a_factor_of_two_is_poor_and_one_of_more_than_e_says_next_to_nothing() -> None:
    def faint(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return X * q[0], X[:, None]

    spread = float(np.sqrt(np.sum(X**2)))
    # 2 * 1.96 standard errors of log 2 = 0.693 are one of 0.177.
    words = {0.17: "identified", 0.18: "poorly determined", 0.9: "poorly determined", 1.1: "not identified"}
    for error, word in words.items():
        std = error * spread
        (one,) = judged(problem("slope", faint, [0.5], std, None), noise_known=True)
        assert ("factor" in one.reason) == (word != "identified")
        assert one.word == word
        assert one.upper - one.lower == pytest.approx(2 * 1.96 * std / spread, rel=1e-3)
        assert (one.value is None) == (word == "not identified")


def noise(sets: int, points: int, correlation: float = 0.0) -> np.ndarray:
    white = draws(11).standard_normal((sets, points + 50))
    return lfilter([1.0], [1.0, -correlation], white, axis=1)[:, 50:]


def share_not_white(residuals: np.ndarray, filaments: int = 1) -> float:
    found = [check_residuals(np.split(one, filaments), 2, noise_known=False).verdict for one in residuals]
    return found.count("not white") / len(found)


@pytest.mark.statistical
@pytest.mark.parametrize(("points", "filaments"), [(60, 1), (200, 1), (200, 4)])
def test_white_residuals_are_rarely_accused(points: int, filaments: int) -> None:
    # One in a hundred by the statistics' limits for long series; of these lengths 1.0 to 1.4 in 20 000 series.
    assert share_not_white(noise(2000, points), filaments) <= shares(2000, 0.014)[1]


@pytest.mark.statistical
@pytest.mark.parametrize("filaments", [1, 2])
def test_correlated_residuals_are_found(filaments: int) -> None:
    # The lag-one statistic is normal about sqrt(200)/2 = 7.1 with 0.87, and accuses from 2.9 on: a set in 1e6 escapes.
    # Here up to two of 300 may, of which the chance is (300e-6)^3/6.
    assert share_not_white(noise(300, 200, 0.5), filaments) > 0.99
    assert share_not_white(noise(300, 200, -0.5), filaments) > 0.99


def test_the_end_of_one_filament_is_no_neighbour_of_the_next() -> None:
    series = noise(40, 25)
    series[:, -1] = series[:, 0] = 5.0
    joined = check_residuals(list(series), 2, noise_known=False)
    within = [row[1:] @ row[:-1] / (row @ row) for row in series]
    assert joined.autocorrelation == pytest.approx(np.mean(within), rel=1e-9)
    # Ends beside each other would add 25 to each sum of squares of some 73.
    whole = series.ravel()
    assert whole[1:] @ whole[:-1] / (whole @ whole) > joined.autocorrelation + 0.2
