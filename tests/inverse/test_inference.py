"""Inference at an optimum: what information, profiles and verdicts say together, and better optima met on the way."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from softcat_sym.fitting import inference
from softcat_sym.fitting.inference import infer
from softcat_sym.fitting.least_squares import LINEAR, Loss, multi_start
from tests.inverse.problems import Problem, decay, problem, product


@dataclass
class Judged(Problem):
    noise_known: bool = True

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        return (True,) * len(self.names)


def judged(plain: Problem) -> Judged:
    return Judged(plain.names, plain.lower, plain.upper, plain.model, plain.data, plain.std)


def two_wells(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Least squares with minima near 1 and, the better one, at -1; chi^2 rises by one between them."""
    (x,) = q
    return np.array([1.5 * (x**2 - 1), 0.6 * (x + 1)]), np.array([[3.0 * x], [0.6]])


def wells() -> Judged:
    return Judged(("x",), np.array([-3.0]), np.array([3.0]), two_wells, np.zeros(2), 1.0)


def test_a_better_optimum_that_a_profile_meets_is_the_one_that_is_judged() -> None:
    p = wells()
    falls = multi_start(p, [np.array([1.4])])
    assert falls.best.q[0] == pytest.approx(0.91, abs=0.03)
    found = infer(p, falls, LINEAR)
    assert found.restarts == 1
    assert found.starts.best.q[0] == pytest.approx(-1, abs=1e-6)
    assert [fall.cluster for fall in found.starts.falls] == [0, 1]
    assert found.starts.falls[1].optimum is falls.best
    assert found.profiles[0].optimum == found.starts.best.q[0] and found.profiles[0].better is None
    assert found.verdicts[0].best == found.starts.best.q[0]


def test_no_more_restarts_than_allowed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(inference, "MAX_RESTARTS", 0)
    p = wells()
    found = infer(p, multi_start(p, [np.array([1.4])]), LINEAR)
    assert found.restarts == 0 and found.profiles[0].better is not None


def test_a_good_optimum_stays_and_progress_is_told() -> None:
    p = judged(problem("A k", decay, [0.3, -0.2], 0.02))
    falls = multi_start(p, [np.zeros(2)])
    heard: list[tuple[int, int]] = []
    found = infer(p, falls, LINEAR, told=lambda done, total: heard.append((done, total)))
    assert found.starts is falls and found.restarts == 0
    assert heard == [(0, 2), (1, 2)]
    assert [one.word for one in found.verdicts] == ["identified", "identified"]


def test_without_profiles_the_interval_is_that_of_the_curvature() -> None:
    p = judged(problem("A k", decay, [0.3, -0.2], 0.02))
    falls = multi_start(p, [np.zeros(2)])
    found = infer(p, falls, LINEAR, profiles=False)
    assert found.profiles == ()
    half = 1.959964 * found.information.standard_errors
    for one, q, h in zip(found.verdicts, falls.best.q, half, strict=True):
        assert (one.lower, one.upper) == pytest.approx((q - h, q + h))


def test_combinations_are_named_where_a_direction_is_unknown_though_no_single_error_is_large() -> None:
    """The box ends a direction at 1.2, so that each single error is below one; the profiles know better."""
    p = judged(problem("A a b", product, [0.0, 0.0, 0.0], 0.01, half=0.8))
    found = infer(p, multi_start(p, [np.zeros(3)]), LINEAR)
    assert np.all(found.information.standard_errors < 1)
    assert [one.word for one in found.verdicts] == ["identified", "not identified", "not identified"]
    assert [one.text for one in found.information.combinations] == ["a^1 * b^-1"]
    assert "a^1 * b^-1" in found.verdicts[1].reason


def test_a_robust_loss_has_intervals_of_its_own() -> None:
    p = judged(problem("A k", decay, [0.3, -0.2], 0.02))
    p.data[10] += 2.0
    loss = Loss("cauchy", 2.0)
    found = infer(p, multi_start(p, [np.zeros(2)], loss=loss), loss)
    plain = infer(p, multi_start(p, [np.zeros(2)]), LINEAR)
    jacobian = p.linearised(found.starts.best.q)[1]
    tau = found.information.noise
    np.testing.assert_allclose(found.information.matrix, jacobian.T @ jacobian / tau**2, rtol=1e-9)
    assert tau == pytest.approx(1.0, abs=0.15)
    assert plain.information.noise == 1.0
    for one, error in zip(found.profiles, found.information.standard_errors, strict=True):
        assert one.lower.flag == one.upper.flag == "crosses"
        half = 0.5 * (one.upper.crossing - one.lower.crossing)
        assert half == pytest.approx(found.information.quantile * error, rel=0.15)
    truth = np.array([0.3, -0.2])
    ends = [(one.lower, one.upper) for one in found.verdicts]
    assert all(low < value < high for (low, high), value in zip(ends, truth, strict=True))  # type: ignore[operator]
    assert np.abs(found.starts.best.q - truth).max() < 0.3 * np.abs(plain.starts.best.q - truth).max()
