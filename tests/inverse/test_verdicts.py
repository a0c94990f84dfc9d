"""Each kind of unknown gets its word, and no number stands alone for one that is not identified."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.fitting.identifiability import information
from softcat_sym.fitting.inference import ParameterVerdict, profile, verdicts
from softcat_sym.fitting.least_squares import minimise
from tests.inverse.problems import Problem, X, decay, problem, product, unused


def judged(p: Problem, *, profiled: bool = True, noise_known: bool = False) -> tuple[ParameterVerdict, ...]:
    best = minimise(p, np.zeros(len(p.names)))
    known = information(p.names, best.q, best.residuals, best.jacobian, (p.lower, p.upper), noise_known=noise_known)
    found = [profile(p, best.q, k, noise_known=noise_known) for k in range(len(p.names))] if profiled else None
    return verdicts(p, best, known, found)


@pytest.mark.parametrize("noise_known", [True, False])
@pytest.mark.parametrize("profiled", [True, False])
def test_identified(profiled: bool, noise_known: bool) -> None:
    quantile = 1.96 if noise_known else 2.0017
    found = judged(problem("A k", decay, [0.5, 0.2], 0.01), profiled=profiled, noise_known=noise_known)
    for one, truth in zip(found, (0.5, 0.2), strict=True):
        assert one.word == "identified"
        assert one.lower < truth < one.upper
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


@pytest.mark.parametrize("profiled", [True, False])
def test_unused(profiled: bool) -> None:
    *used, one = judged(problem("A k z", unused, [0.5, 0.2, 0.1], 0.01), profiled=profiled)
    assert {other.word for other in used} == {"identified"}
    assert (one.word, one.value, one.lower, one.upper) == ("not identified", None, None, None)


@pytest.mark.parametrize("seed", range(6))
def test_one_sided(seed: int) -> None:
    rate = judged(problem("A k", decay, [0.5, 5.0], 0.3, seed), noise_known=True)[1]
    assert rate.word == "one-sided"
    assert rate.value is None
    assert rate.lower < 5.0
    assert rate.upper is None
    assert "only the least possible value" in rate.reason


@pytest.mark.parametrize("profiled", [True, False])
def test_at_a_bound_that_the_data_pull_against(profiled: bool) -> None:
    p = problem("A k", decay, [0.5, 0.2], 0.01)
    p.upper = np.array([6.0, 0.0])
    A, k = judged(p, profiled=profiled, noise_known=True)
    assert k.word == "at a bound"
    assert "widen the bound" in k.reason
    assert A.word == "identified"


def test_an_interval_of_more_than_a_factor_e_says_next_to_nothing() -> None:
    def faint(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return X * q[0], X[:, None]

    spread = float(np.sqrt(np.sum(X**2)))
    for std, word in ((0.9 * spread, "identified"), (1.1 * spread, "not identified")):
        (one,) = judged(problem("slope", faint, [0.5], std, None), noise_known=True)
        assert one.word == word
        assert one.upper - one.lower == pytest.approx(2 * 1.96 * std / spread, rel=1e-3)
        assert (one.value is None) == (word == "not identified")
