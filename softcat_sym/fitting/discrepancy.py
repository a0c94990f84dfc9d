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

    def covariance(self, time: Floats, heights: Floats, rates: Floats) -> Floats:
        """Covariance of the error at times since the onset of gravity, shape (n, n).

        It is amplitude^2 (1 + s) exp(-s) (h h' + t h_t t' h_t') for heights h of the model and their rates h_t; before
        the onset there is no error of pace. A change of a frequency moves heights as an error of pace does.
        """
        logarithm = np.log(np.maximum(time, np.finfo(float).tiny))
        apart = _FALLEN * np.abs(np.subtract.outer(logarithm, logarithm)) / self.correlation
        pace = np.maximum(time, 0.0) * rates
        both = np.outer(heights, heights) + np.outer(pace, pace)
        return np.asarray(self.amplitude**2 * (1 + apart) * np.exp(-apart) * both)


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
