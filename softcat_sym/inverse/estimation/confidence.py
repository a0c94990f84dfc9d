"""How well a constant is known: standard error, 95 % interval, verdict."""

from __future__ import annotations

import math
import statistics
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Verdict = Literal["determined", "undetermined", "on a bound"]

LEVEL = 0.95


@dataclass(frozen=True)
class Estimate:
    """A fitted constant.

    Attributes
    ----------
    value : float
        In SI units.
    half_width : float or None
        Of the 95 % interval before it is cut at the bounds; None with the standard error.
    standard_error : float or None
        Linearised, from the Jacobian at the optimum; None where it means nothing: on a bound, or with a singular
        Jacobian.
    interval : (float, float) or None
        95 % interval of Student's distribution, within the bounds of the constant; None with the standard error.
    verdict : str
        ``"undetermined"`` if the interval leaves the bounds of the constant (a yield stress that may be zero, say).
    """

    value: float
    standard_error: float | None
    interval: tuple[float, float] | None
    half_width: float | None
    verdict: Verdict


def estimate(value: float, error: float, quantile: float, bounds: tuple[float, float]) -> Estimate:
    """Judge a constant that stands between its bounds.

    Parameters
    ----------
    value, error : float
        The constant and its standard error, which may be infinite.
    quantile : float
        As from :func:`student_quantile`.
    bounds : (float, float)
        Least and largest possible value.
    """
    if not math.isfinite(error):
        return Estimate(value, None, None, None, "undetermined")
    half = quantile * error
    inside = bounds[0] < value - half and value + half < bounds[1]
    interval = (max(value - half, bounds[0]), min(value + half, bounds[1]))
    return Estimate(value, error, interval, half, "determined" if inside else "undetermined")


def standard_errors(jacobian: NDArray[np.float64], squares: float) -> NDArray[np.float64]:
    """Standard errors of a least-squares fit, sqrt(diag(s^2 (J^T J)^-1)) with s^2 = squares/(points - constants).

    Parameters
    ----------
    jacobian : ndarray, shape (points, constants)
        Derivatives of the residuals; more points than constants.
    squares : float
        Sum of the squared residuals.

    Returns
    -------
    ndarray, shape (constants,)
        Infinite where the columns depend on one another.
    """
    points, constants = jacobian.shape
    scale = np.linalg.norm(jacobian, axis=0)
    if not np.all(scale > 0):
        return np.full(constants, np.inf)
    triangle = np.linalg.qr(jacobian / scale, mode="r")
    if np.abs(np.diag(triangle)).min() < 1e-10:
        return np.full(constants, np.inf)
    spread = np.linalg.norm(np.linalg.inv(triangle), axis=1)
    errors: NDArray[np.float64] = math.sqrt(squares / (points - constants)) * spread / scale
    return errors


def student_quantile(freedom: int) -> float:
    """The number of standard errors within which Student's t lies with probability 95 %.

    Parameters
    ----------
    freedom : int
        Degrees of freedom, at least 1.
    """
    low, high = 0.0, 13.0
    # The interval is halved until the midpoint of two neighbouring floats is one of them.
    while low < (middle := 0.5 * (low + high)) < high:
        low, high = (middle, high) if _central_probability(middle, freedom) < LEVEL else (low, middle)
    return high


def _central_probability(t: float, freedom: int) -> float:
    """Probability of |T| < t, the finite series of Abramowitz and Stegun (1964), 26.7.3 and 26.7.4."""
    angle = math.atan(t / math.sqrt(freedom))
    odd = freedom % 2
    step = np.arange(1, max(freedom // 2, 1))
    ratios = (2 * step - 1 + odd) / (2 * step + odd) * math.cos(angle) ** 2
    series = 1.0 + float(np.cumprod(ratios).sum())
    if not odd:
        return math.sin(angle) * series
    return 2 / math.pi * (angle + (math.sin(angle) * math.cos(angle) * series if freedom > 1 else 0.0))


NORMAL_QUANTILE = statistics.NormalDist().inv_cdf(0.5 + 0.5 * LEVEL)
"""The number of standard deviations within which a normal variable lies with probability 95 %."""


def two_sided_quantile(freedom: int | None) -> float:
    """Of Student's t, or of the normal distribution where the noise is known.

    Its square is the 95 % quantile of F with one degree of freedom above `freedom`, or of chi^2 with one.

    Parameters
    ----------
    freedom : int or None
        Degrees of freedom of the estimated noise, at least 1; None: known noise.
    """
    return NORMAL_QUANTILE if freedom is None else student_quantile(freedom)


def normal_tail(z: float) -> float:
    """Probability that a normal variable lies further than |z| standard deviations from its mean, on either side."""
    return math.erfc(abs(z) / math.sqrt(2))


def chi_square_tail(x: float, freedom: int) -> float:
    """Probability that chi^2 exceeds x: the finite series of Abramowitz and Stegun (1964), 26.4.4 and 26.4.5.

    Parameters
    ----------
    x : float
        Not negative.
    freedom : int
        Degrees of freedom, at least 1.
    """
    if x <= 0:
        return 1.0
    half, odd = 0.5 * x, freedom % 2
    orders = np.arange(0.5 * odd, 0.5 * freedom)
    # Term j is exp(-x/2) (x/2)^j / Gamma(j + 1); by logarithms, for neither factor need be a number of the machine.
    logs = orders * math.log(half) - half - np.array([math.lgamma(order + 1) for order in orders])
    first = math.erfc(math.sqrt(half)) if odd else 0.0
    return min(first + float(np.exp(logs).sum()), 1.0)
