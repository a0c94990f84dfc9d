"""How far the theory is from the continuum that it stands for: the covariance of its midpoint's error."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.scene.scene import Scene, groups_of

FLOWING, STOPPING = 0.04, 0.3
"""Amplitude over h0/L with shear and, of a law that yields, fibres: in general, and where a catenary stops the fall."""

PUBLISHED_FLOWING, PUBLISHED_STOPPING = 0.6, 1.8
"""The same without them, in either closure."""

CORRELATION = 2.0
"""Difference of log t over which the error's likeness falls to 1/e."""


@dataclass(frozen=True)
class Discrepancy:
    """Error of a theory, h(t) = (1 + a(t)) y((1 + b(t)) t) of the continuum's y: a slow change of height and of pace.

    Both a and b are Gaussian, independent, and alike over a factor of the time (Ornstein & Uhlenbeck in log t).
    """

    amplitude: float  # Standard deviation of a and of b
    correlation: float = CORRELATION  # Of log t

    def covariance(self, time: Floats, heights: Floats) -> Floats:
        """Covariance of the error.

        Parameters
        ----------
        time : ndarray, shape (n,)
            Since gravity came on [s], increasing; what comes before has no error.
        heights : ndarray, shape (n,)
            Of the midpoint, as the model has them.

        Returns
        -------
        ndarray, shape (n, n)
            amplitude^2 (t_</t_>)^(1/correlation) (h h' + t h_t t' h_t'), in the square of the unit of the heights.
        """
        begun = np.maximum(time, np.finfo(float).tiny)
        # Divided first: the least of all times to a power must not vanish.
        alike = (np.minimum.outer(begun, begun) / np.maximum.outer(begun, begun)) ** (1 / self.correlation)
        pace = np.where(time > 0, time * np.gradient(heights, time), 0.0) if time.size > 1 else np.zeros(time.size)
        return np.asarray(self.amplitude**2 * alike * (np.outer(heights, heights) + np.outer(pace, pace)))


def discrepancy(scene: Scene, effects: Collection[str]) -> Discrepancy:
    """Return how far a theory is from the continuum.

    Parameters
    ----------
    scene : Scene
        The best that is known of it: its thickness over span, and whether it stops (3.12), decide.
    effects : collection of str
        In force.

    Returns
    -------
    Discrepancy
        Constants are those of clamped elastic, Maxwell and Bingham filaments of h0/L = 0.01 to 0.1 against plane-stress
        elements, as ``tests/slow/test_discrepancy.py`` prints them; other laws and ends are taken to be alike.
    """
    regime = expected_regime(scene, effects)
    number, limit = regime.gravity_number, regime.arrest_exact
    stops = number is not None and limit is not None and regime.name != "no-yield" and number < limit
    resolved = "shear" in effects and ("fibres" in effects or "yielding" not in effects)
    flowing, stopping = (FLOWING, STOPPING) if resolved else (PUBLISHED_FLOWING, PUBLISHED_STOPPING)
    return Discrepancy((stopping if stops else flowing) * groups_of(scene).delta)
