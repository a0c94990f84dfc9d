"""Error of the theory against the continuum: its covariance at the midpoint."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from softcat_sym.effects.theory_limits import theory_error
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.scene import Scene

_FALLEN = 2.1462  # (1 + s) exp(-s) is 1/e here


@dataclass(frozen=True)
class Discrepancy:
    """Error of a theory, h(t) = (1 + a(t)) y((1 + b(t)) t) of the continuum's y: a slow change of height and of pace.

    Both a and b are independent Gaussian processes of log t, with paths that have one derivative and an autocorrelation
    of (1 + s) exp(-s), s = 2.146 |log t - log t'|/correlation (Matern's, order 3/2; Rasmussen & Williams 2006, 4.2.1).
    """

    amplitude: float  # Standard deviation of a and of b
    correlation: float = 1.0  # Difference of log t over which their autocorrelation falls to 1/e

    def covariance(self, time: Floats, heights: Floats) -> Floats:
        """Covariance of the error at times since the onset of gravity, for heights of the model, shape (n, n).

        It is amplitude^2 (1 + s) exp(-s) (h h' + t h_t t' h_t'), where h_t is the difference quotient over two standard
        deviations of the pace, so that t h_t of a fast ringing is no larger than the ringing itself.
        """
        logarithm = np.log(np.maximum(time, np.finfo(float).tiny))
        apart = _FALLEN * np.abs(np.subtract.outer(logarithm, logarithm)) / self.correlation
        correlation = (1 + apart) * np.exp(-apart)
        pace = self._pace(time, heights)
        return np.asarray(self.amplitude**2 * correlation * (np.outer(heights, heights) + np.outer(pace, pace)))

    def _pace(self, time: Floats, heights: Floats) -> Floats:
        """Change of height for a relative change of pace, t h_t; none before the onset, or of a single time."""
        if time.size < 2:
            return np.zeros(time.size)
        sooner = np.clip((1 - self.amplitude) * time, time[0], time[-1])
        later = np.clip((1 + self.amplitude) * time, time[0], time[-1])
        apart = later - sooner
        rise = np.interp(later, time, heights) - np.interp(sooner, time, heights)
        return np.where((time > 0) & (apart > 0), time * rise / np.where(apart > 0, apart, 1.0), 0.0)


_CORRELATION_LENGTH = 1 / 8  # Over the span: a hinge is a few thicknesses long


def shape_covariance(place: Floats, span: float) -> Floats:
    """Covariance of the relative errors of two points of a shape over that of the midpoint, shape (n, n).

    It is 1 + k(x, x') - k(x, 0) k(0, x') at places x from halfway between the supports (NaN of a midpoint), where k is
    Gaussian with a standard deviation of an eighth of the span; the same on both sides of the midpoint. Elements sag
    less by some share everywhere, and near their clamps by up to twice of it.
    """
    x = np.abs(np.nan_to_num(place)) / (span * _CORRELATION_LENGTH)
    beside = np.exp(-0.5 * x**2)
    return np.asarray(1 + np.exp(-0.5 * np.subtract.outer(x, x) ** 2) - np.outer(beside, beside))


def discrepancy(scene: Scene, effects: Collection[str], terms: Terms) -> Discrepancy:
    """Return the error of a theory against the continuum, as large as :func:`theory_error` says of a best estimate."""
    return Discrepancy(theory_error(scene, effects, terms))
