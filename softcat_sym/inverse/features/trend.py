"""The slow descent under the noise: local polynomials in the logarithm of time, by weighted least squares."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from softcat_sym.inverse.features.reading import Floats

DEGREE = 3
"""Of the trend in log t: over a factor of five in time it follows any power law to 1e-3 of its change."""

_BLOCK = 7


@dataclass(frozen=True, eq=False)
class LogPolynomial:
    """Chebyshev polynomials of log t, scaled to [-1, 1] on a stretch of time.

    Attributes
    ----------
    first, last : float
        Ends of the stretch [s], positive.
    degree : int
        Highest degree.
    """

    first: float
    last: float
    degree: int

    def columns(self, time: Floats) -> Floats:
        """Values of the basis at times [s], shape (n, degree + 1)."""
        columns: Floats = np.asarray(chebyshev.chebvander(self._scaled(time), self.degree), dtype=np.float64)
        return columns

    def second_derivative(self, time: float) -> Floats:
        """d^2/dt^2 of the basis at one time [1/s^2], shape (degree + 1,)."""
        identity = np.eye(self.degree + 1)
        x, slope = float(self._scaled(np.array([time]))[0]), self._slope
        first = chebyshev.chebval(x, chebyshev.chebder(identity, 1))
        second = chebyshev.chebval(x, chebyshev.chebder(identity, 2))
        # x = a + b log t, so that x' = b/t and x'' = -b/t^2.
        curvature: Floats = np.asarray(second * slope**2 - first * slope, dtype=np.float64) / time**2
        return curvature

    @property
    def _slope(self) -> float:
        return 2 / math.log(self.last / self.first)

    def _scaled(self, time: Floats) -> Floats:
        scaled: Floats = np.log(time / self.first) * self._slope - 1
        return scaled


def noise_of(time: Floats, sag: Floats) -> float:
    """Scatter of the frames about short parabolas, over the later half of the film [m].

    Blocks of seven neighbouring frames each have a parabola of their own; an oscillation that is filmed with fewer
    frames a period counts as scatter.

    Parameters
    ----------
    time, sag : ndarray, shape (n,)
        Of the frames, n >= 4.
    """
    half = max(len(time) // 2, min(len(time), _BLOCK))
    late_time, late_sag = time[-half:], sag[-half:]
    squares, freedom = 0.0, 0
    for start in range(0, len(late_time) - 3, _BLOCK):
        block = slice(start, start + _BLOCK)
        t, y = late_time[block], late_sag[block]
        if len(t) < 4:
            continue
        columns = np.vander((t - t.mean()) / (np.ptp(t) or 1.0), 3)
        rest = y - columns @ np.linalg.lstsq(columns, y, rcond=None)[0]
        squares, freedom = squares + float(rest @ rest), freedom + len(t) - 3
    return math.sqrt(squares / freedom) if freedom else 0.0
