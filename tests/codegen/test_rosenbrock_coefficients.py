"""The coefficients fulfil the conditions of their order, wherever they were copied from."""

from __future__ import annotations

import numpy as np
import pytest

from tests.codegen import rosenbrock_library as rosenbrock

ORDERS = {rosenbrock.RODAS5P: 5, rosenbrock.RODAS4: 4, rosenbrock.RODAS3P: 3}


class Tableau:
    """alpha, gamma and weights of Hairer & Wanner (1996, section IV.7), from the form without products J k."""

    def __init__(self, method: int) -> None:
        raw = rosenbrock.library().softcat_method_of(method).contents
        stages = raw.stages
        self.raw, self.order = raw, ORDERS[method]
        self.a, c = (np.array(table)[:stages, :stages] for table in (raw.a, raw.c))
        self.gammas = np.linalg.inv(np.eye(stages) / raw.gamma - c)
        self.alphas = self.a @ self.gammas
        self.betas = self.alphas + self.gammas
        last = np.eye(stages)[-1]
        self.ends = self.a[-1] + last
        self.weights = self.ends @ self.gammas
        error = last if raw.embedded < 0 else last - np.eye(stages)[raw.embedded]
        self.embedded = (self.ends - error) @ self.gammas

    def defects(self, weights: np.ndarray, order: int) -> list[float]:
        """What is left of the 1, 1, 2, 4, 9 conditions of each order (Hairer & Wanner 1996, section IV.7)."""
        alpha, beta = self.alphas.sum(axis=1), self.betas.sum(axis=1)
        by_order = {
            1: [weights.sum() - 1],
            2: [weights @ beta - 1 / 2],
            3: [weights @ alpha**2 - 1 / 3, weights @ self.betas @ beta - 1 / 6],
            4: [
                weights @ alpha**3 - 1 / 4,
                weights @ (alpha * (self.alphas @ beta)) - 1 / 8,
                weights @ self.betas @ alpha**2 - 1 / 12,
                weights @ self.betas @ self.betas @ beta - 1 / 24,
            ],
            5: [
                weights @ alpha**4 - 1 / 5,
                weights @ (alpha**2 * (self.alphas @ beta)) - 1 / 10,
                weights @ (self.alphas @ beta) ** 2 - 1 / 20,
                weights @ (alpha * (self.alphas @ alpha**2)) - 1 / 15,
                weights @ (alpha * (self.alphas @ self.betas @ beta)) - 1 / 30,
                weights @ self.betas @ alpha**3 - 1 / 20,
                weights @ self.betas @ (alpha * (self.alphas @ beta)) - 1 / 40,
                weights @ self.betas @ self.betas @ alpha**2 - 1 / 60,
                weights @ self.betas @ self.betas @ self.betas @ beta - 1 / 120,
            ],
        }
        return [defect for at in range(1, order + 1) for defect in by_order[at]]


@pytest.fixture(params=rosenbrock.METHODS)
def tableau(request: pytest.FixtureRequest) -> Tableau:
    """Each method."""
    return Tableau(request.param)


def test_row_sums(tableau: Tableau) -> None:
    """time_i = sum alpha_ij and slope_i = sum gamma_ij."""
    stages = tableau.raw.stages
    np.testing.assert_allclose(tableau.alphas.sum(axis=1), tableau.raw.time[:stages], atol=3e-14)
    np.testing.assert_allclose(tableau.gammas.sum(axis=1), tableau.raw.slope[:stages], atol=3e-14)


def test_order_conditions(tableau: Tableau) -> None:
    """Method and embedded method have the orders they say, and the embedded one no higher."""
    assert tableau.raw.error_order == tableau.order
    assert np.abs(tableau.defects(tableau.weights, tableau.order)).max() < 1e-13
    assert np.abs(tableau.defects(tableau.embedded, tableau.order - 1)).max() < 1e-13
    assert np.abs(tableau.defects(tableau.embedded, tableau.order)).max() > 1e-4


def test_stiffly_accurate(tableau: Tableau) -> None:
    """The weights are the last row of beta, its time is the end, hence R(infinity) = 0 (ibid., section IV.15)."""
    np.testing.assert_allclose(tableau.weights, tableau.betas[-1], atol=1e-13)
    assert tableau.raw.time[tableau.raw.stages - 1] == 1.0
    at_infinity = 1.0 - tableau.weights @ np.linalg.solve(tableau.betas, np.ones(tableau.raw.stages))
    assert abs(at_infinity) < 1e-11


def test_a_stable_on_the_imaginary_axis(tableau: Tableau) -> None:
    """|R(iy)| <= 1, which with poles on the right gives A-stability (maximum principle)."""
    assert tableau.raw.gamma > 0.0
    ones, unit = np.ones(tableau.raw.stages), np.eye(tableau.raw.stages)
    for y in np.geomspace(1e-2, 1e6, 400):
        amplification = 1.0 + 1j * y * tableau.weights @ np.linalg.solve(unit - 1j * y * tableau.betas, ones)
        assert abs(amplification) <= 1.0 + 1e-13


def test_unknown_method() -> None:
    """There is none beyond the last."""
    assert not rosenbrock.library().softcat_method_of(3)
