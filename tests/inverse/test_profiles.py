"""Profile likelihoods against closed forms, a brute-force search, and their own claim of 95 %."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar
from scipy.stats import f as fisher

from softcat_sym.fitting.identifiability import information
from softcat_sym.fitting.inference import Profile, profile
from softcat_sym.fitting.least_squares import Fixed, minimise
from tests.inverse.problems import Problem, X, decay, line, problem, product, saturation


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


def test_one_unknown_needs_no_derivatives_along_the_way() -> None:
    def alone(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, derivatives = decay(np.array([0.5, q[0]]))
        return values, derivatives[:, 1:]

    p = problem("k", alone, [0.2], 0.1)
    best = minimise(p, np.zeros(1))
    p.asked.clear()
    one = profile(p, best.q, 0, noise_known=True)
    assert len(p.asked) == 1
    for side in (one.lower, one.upper):
        assert side.crossing is not None
        rise = np.sum(p.residuals(np.array([side.crossing])) ** 2) - 2 * best.value
        assert rise == pytest.approx(one.threshold, rel=0.02)


def test_a_rate_too_fast_to_see_is_bounded_on_one_side() -> None:
    p = problem("A k", decay, [0.5, 5.0], 0.3)
    rate = profiles(p, noise_known=True)[1]
    assert rate.lower.flag == "crosses"
    assert rate.upper.flag == "reaches the bound"
    assert rate.upper.crossing is None
    assert 1.0 < rate.lower.crossing < 5.0
    # Far from a parabola, the crossing is still where the best fit is worse by the threshold.
    held = minimise(Fixed(p, 1, rate.lower.crossing), np.zeros(1))
    assert 2 * (held.value - minimise(p, np.zeros(2)).value) == pytest.approx(rate.threshold, rel=0.02)


def test_a_flat_profile_reaches_the_bounds_or_is_held_back_by_another_unknown() -> None:
    _, a, b = profiles(problem("A a b", product, [0.5, 0.2, 0.8], 0.01), noise_known=True)
    assert np.abs(a.increase[np.abs(a.q) < 5]).max() < 1e-3
    assert (a.lower.flag, b.upper.flag) == ("reaches the bound", "reaches the bound") or a.lower.held_back == ("b",)
    assert a.upper.held_back in ((), ("b",))
    assert (a.upper.crossing is None) == (a.upper.held_back == ())


def test_the_edge_of_the_model_is_said() -> None:
    def partly(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, derivatives = decay(q)
        return (values if q[1] < 0.3 else values * np.nan), derivatives

    exact = problem("A k", decay, [0.5, 0.2], 0.3)
    p = Problem(exact.names, exact.lower, exact.upper, partly, exact.data, exact.std)
    one = profile(p, minimise(p, np.zeros(2)).q, 1, noise_known=True)
    assert one.upper.flag == "the model has no answer beyond"
    assert one.q.max() > 0.25
    assert one.lower.flag == "crosses"


def test_a_better_optimum_on_the_way_is_said() -> None:
    def wave(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values = q[0] * np.sin(q[1] * X)
        return values, np.stack([np.sin(q[1] * X), q[0] * X * np.cos(q[1] * X)], axis=1)

    p = problem("A w", wave, [1.0, 5.0], 1.5, seed=1)
    p.lower, p.upper = np.array([0.1, 3.0]), np.array([3.0, 9.0])
    local = minimise(p, np.array([0.5, 8.0]))
    best = minimise(p, np.array([1.0, 5.0]))
    assert local.value > best.value + 0.1
    one = profile(p, local.q, 1, noise_known=True)
    assert one.better is not None
    assert minimise(p, one.better).value == pytest.approx(best.value, rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("noise_known", [True, False])
def test_intervals_contain_the_truth_in_95_of_100(noise_known: bool) -> None:
    truth, sets = np.array([0.5, 0.2]), 400
    inside = np.zeros(2)
    for seed in range(sets):
        p = problem("v K", saturation, [0.5, 0.2], 0.1, seed)
        for k, one in enumerate(profiles(p, noise_known=noise_known)):
            inside[k] += one.lower.crossing < truth[k] < one.upper.crossing
    # Four standard deviations of a binomial of 400 at 95 % are 4.4 %.
    assert np.all(np.abs(inside / sets - 0.95) < 0.044)


def test_intervals_contain_the_truth_in_a_quick_count() -> None:
    sets, inside = 60, 0
    for seed in range(sets):
        p = problem("A k", decay, [0.5, 0.2], 0.2, 1000 + seed)
        one = profile(p, minimise(p, np.zeros(2)).q, 1, noise_known=False)
        inside += one.lower.crossing < 0.2 < one.upper.crossing
    assert 0.86 < inside / sets < 1.0
