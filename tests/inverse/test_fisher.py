"""Covariance, rank and combinations against closed forms, SciPy and Monte Carlo."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import curve_fit
from scipy.stats import chi2, norm

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.identifiability import (
    Information,
    chi_square_tail,
    information,
    normal_tail,
    standard_errors,
    two_sided_quantile,
)
from softcat_sym.fitting.least_squares import minimise
from tests.inverse.problems import Problem, X, decay, line, problem, product, unused


def judged(p: Problem, *, noise_known: bool, logarithmic: tuple[bool, ...] | None = None) -> Information:
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
    found = judged(p, noise_known=True)
    spread = np.sum((X - X.mean()) ** 2)
    slope = 0.01 / spread
    offset = 0.01 * (1 / X.size + X.mean() ** 2 / spread)
    mixed = -0.01 * X.mean() / spread
    np.testing.assert_allclose(found.covariance, [[offset, mixed], [mixed, slope]], rtol=1e-10)
    assert found.correlation[0, 1] == pytest.approx(mixed / np.sqrt(offset * slope))
    np.testing.assert_allclose(found.matrix @ found.covariance, np.eye(2), atol=1e-9)
    assert found.identified.all()
    assert found.rank == 2
    assert found.combinations == ()


def test_estimated_noise_gives_the_covariance_of_scipy() -> None:
    p = problem("A k", decay, [0.5, 0.2], 0.01)
    found = judged(p, noise_known=False)
    _, covariance = curve_fit(lambda _, a, k: p.model(np.array([a, k]))[0], X, p.data, p0=[0.5, 0.2], xtol=1e-14)
    np.testing.assert_allclose(found.covariance, covariance, rtol=1e-4)
    best = minimise(p, np.zeros(2))
    np.testing.assert_allclose(found.standard_errors, standard_errors(best.jacobian, 2 * best.value), rtol=1e-9)
    assert found.freedom == 58


@pytest.mark.parametrize("noise_known", [True, False])
@pytest.mark.parametrize("seed", [0, None])
def test_a_quotient_is_identified_where_its_parts_are_not(seed: int | None, noise_known: bool) -> None:
    p = problem("A youngs_modulus viscosity", product, [0.5, 0.2, 0.3], 0.01, seed)
    found = judged(p, noise_known=noise_known)
    assert found.identified.tolist() == [True, False, False]
    assert found.rank == 2
    (one,) = found.combinations
    assert one.text == "youngs_modulus^1 * viscosity^-1"
    assert one.exponents == (1.0, -1.0)
    single = judged(problem("A k", decay, [0.5, -0.1], 0.01, seed), noise_known=noise_known)
    assert one.standard_error == pytest.approx(single.standard_errors[1], rel=0.1)
    assert one.interval[0] - 1e-9 < -0.1 < one.interval[1] + 1e-9
    value, low, high = one.product([3e4, 1e3])
    assert value == pytest.approx(30 * np.exp(one.value))
    assert low < value < high
    # An unknown that is not identified has an error no larger than the box.
    assert np.all(found.standard_errors < 12)


@pytest.mark.parametrize(("power", "text"), [(2.0, "a^1 * b^(1/2)"), (3.0, "a^1 * b^(1/3)"), (0.5, "a^(1/2) * b^1")])
def test_exponents_are_simple_numbers(power: float, text: str) -> None:
    def powers(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, columns = decay(np.array([0.3, (power * q[0] + q[1]) / 3]))
        return values, columns[:, 1:] * [power / 3, 1 / 3]

    (one,) = judged(problem("a b", powers, [0.1, 0.2], 0.01), noise_known=True).combinations
    assert one.text == text


def test_linear_unknowns_are_added_and_not_multiplied() -> None:
    def sums(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return (q[0] - 0.5 * q[1]) * X, np.stack([X, -0.5 * X], axis=1)

    p = problem("drift shift", sums, [0.1, 0.2], 0.01)
    (one,) = judged(p, noise_known=True, logarithmic=(False, False)).combinations
    assert one.text == "1 * drift - 1/2 * shift"
    (one,) = judged(p, noise_known=True, logarithmic=(True, False)).combinations
    assert one.text == "1 * log(drift) - 1/2 * shift"


def test_an_unused_unknown_is_in_no_combination() -> None:
    found = judged(problem("A k unused", unused, [0.5, 0.2, 0.1], 0.01), noise_known=True)
    assert found.identified.tolist() == [True, True, False]
    assert found.combinations == ()
    assert found.standard_errors[2] == pytest.approx(6.0)


def test_noise_that_hides_an_unknown_closes_the_gate() -> None:
    assert judged(problem("A k", decay, [0.5, -3.0], 0.05), noise_known=True).identified.tolist() == [True, True]
    hidden = judged(problem("A k", decay, [0.5, -5.0], 1.0), noise_known=True)
    assert hidden.identified.tolist() == [True, False]
    assert hidden.rank == 1


def test_no_more_data_than_unknowns_leave_no_noise() -> None:
    arrays = np.zeros(2), np.zeros(2), np.eye(2)
    box = (np.full(2, -1.0), np.full(2, 1.0))
    with pytest.raises(SoftcatError, match="at least 3 data, or their standard errors"):
        information(("a", "b"), *arrays, box, noise_known=False)
    fewer = information(("a", "b"), np.zeros(2), np.zeros(1), np.array([[50.0, 50.0]]), box, noise_known=True)
    assert fewer.rank == 1
    assert fewer.combinations[0].text == "a^1 * b^1"


@pytest.mark.parametrize("freedom", [1, 2, 3, 10, 57, 1999])
def test_tails_are_those_of_scipy(freedom: int) -> None:
    for x in (1e-3 * freedom, 0.7 * freedom, freedom, 1.3 * freedom, 3.0 * freedom + 5):
        assert chi_square_tail(x, freedom) == pytest.approx(chi2.sf(x, freedom), rel=1e-9, abs=1e-300)
    assert chi_square_tail(0.0, freedom) == 1.0
    for z in (-3.0, 0.0, 1.0, 6.0):
        assert normal_tail(z) == pytest.approx(2 * norm.sf(abs(z)), rel=1e-12)
    assert two_sided_quantile(None) ** 2 == pytest.approx(chi2.ppf(0.95, 1), rel=1e-12)
