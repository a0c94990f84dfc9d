"""Optima of models whose values have more noise than their derivatives, as integrators that choose their steps have."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.fitting.least_squares import NOISE, REACHED, minimise

TRUTH = np.array([0.3, -0.2])


class Jagged:
    """y = a exp(-b t) in logarithms, whose residuals jump a little from point to point."""

    names = ("a", "b")
    lower, upper = np.full(2, -3.0), np.full(2, 3.0)

    def __init__(self, noise: float) -> None:
        self._time = np.linspace(0.0, 2.0, 100)
        self._noise = noise
        self._data = self._exact(TRUTH)[0] + 0.01 * np.random.default_rng(0).standard_normal(100)

    def _exact(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        a, b = np.exp(q)
        y = a * np.exp(-b * self._time)
        return y, np.stack([y, -b * self._time * y], axis=1)

    def residuals(self, q: np.ndarray) -> np.ndarray:
        return self.linearised(q)[0]

    def linearised(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        y, slopes = self._exact(q)
        # A jump of all residuals alike in proportion: of the value, hardly of where its gradient is zero.
        jump = 1 + self._noise * np.sin(1e9 * float(q.sum()))
        return jump * (y - self._data) / 0.01, slopes / 0.01


@pytest.mark.parametrize("noise", [1e-6, 1e-7])
def test_few_points_are_spent_on_noise(noise: float) -> None:
    exact, found = (minimise(Jagged(size), np.zeros(2)) for size in (0.0, noise))
    assert found.converged
    assert found.evaluations <= exact.evaluations + 1
    assert found.offset < 10 * REACHED
    np.testing.assert_allclose(found.q, exact.q, atol=1e-6)


def test_the_noise_is_named() -> None:
    assert any(minimise(Jagged(size), np.zeros(2)).status == NOISE for size in (3e-7, 1e-6, 3e-6))
