"""Many starts: the hypercube, the waterfall, and starts without an answer."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.least_squares import latin_hypercube, multi_start
from tests.inverse.problems import Problem, X, decay, problem, product


def wave(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A sin(w x), q = A, w: one local optimum for every few periods."""
    values = q[0] * np.sin(q[1] * X)
    return values, np.stack([np.sin(q[1] * X), q[0] * X * np.cos(q[1] * X)], axis=1)


def wave_problem() -> Problem:
    p = problem("A w", wave, [1.0, 5.0], 0.05)
    p.lower, p.upper = np.array([0.1, 0.5]), np.array([3.0, 20.0])
    return p


def test_every_slice_of_every_unknown_has_one_point() -> None:
    lower, upper = np.array([-1.0, 0.0, 5.0]), np.array([1.0, 10.0, 6.0])
    points = latin_hypercube(lower, upper, 17, seed=3)
    slices = np.floor((points - lower) / (upper - lower) * 17).astype(int)
    assert np.array_equal(np.sort(slices, axis=0), np.tile(np.arange(17)[:, None], 3))
    assert np.array_equal(points, latin_hypercube(lower, upper, 17, seed=3))
    assert not np.array_equal(points, latin_hypercube(lower, upper, 17, seed=4))
    assert latin_hypercube(lower, upper, 0, seed=3).shape == (0, 3)


def test_the_best_of_many_optima_is_found() -> None:
    p = wave_problem()
    poor = multi_start(p, [np.array([1.0, 15.0])])
    fall = multi_start(p, [np.array([1.0, 15.0])], count=25, seed=1)
    np.testing.assert_allclose(fall.best.q, [1.0, 5.0], atol=0.05)
    assert poor.best.value > 10 * fall.best.value
    converged = [one.optimum.value for one in fall.falls if one.optimum.converged]
    assert converged == sorted(converged)
    assert [one.cluster for one in fall.falls][:2] == [0, 0]
    assert 1 < fall.reached_best < len(fall.falls) == 26
    assert len({one.cluster for one in fall.falls}) > 2
    same = [one.optimum.q for one in fall.falls if one.cluster == 0]
    assert np.ptp(same, axis=0).max() < 1e-3


def test_one_fit_with_many_values_is_one_cluster_that_is_spread() -> None:
    fall = multi_start(problem("A a b", product, [0.5, 0.2, 0.3], 0.01), [np.zeros(3)], count=8, seed=1)
    assert fall.reached_best == 9
    assert fall.spread()[0] < 1e-4
    assert np.all(fall.spread()[1:] > 0.5)


def test_fits_that_differ_by_less_than_their_errors_are_one() -> None:
    def rough(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, derivatives = decay(q)
        random = np.random.default_rng(np.frombuffer(q.tobytes(), dtype=np.uint32))
        return values * (1 + 1e-5 * random.standard_normal(values.size)), derivatives

    exact = problem("A k", decay, [0.5, 0.2], 0.01)
    p = Problem(exact.names, exact.lower, exact.upper, rough, exact.data, exact.std)
    fall = multi_start(p, [np.full(2, start) for start in (-1.0, 0.0, 1.0)])
    assert np.all(np.diff(fall.values) > 0)
    assert fall.reached_best == 3


def test_starts_without_an_answer_cost_no_derivatives() -> None:
    def partly(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, derivatives = decay(q)
        return (values if q[0] < 0 else values * np.nan), derivatives

    exact = problem("A k", decay, [-0.5, 0.2], 0.01)
    p = Problem(exact.names, exact.lower, exact.upper, partly, exact.data, exact.std)
    fall = multi_start(p, [], count=10, seed=0)
    assert fall.rejected == 5 == len(fall.falls)
    np.testing.assert_allclose(fall.best.q, [-0.5, 0.2], atol=0.05)
    p.lower = np.array([1.0, -6.0])
    p.asked.clear()
    with pytest.raises(SoftcatError, match="at any of 10 starts"):
        multi_start(p, [], count=10, seed=0)
    assert not p.asked
