"""How well a constant is known: standard error, 95 % interval, verdict."""

from __future__ import annotations

import math
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
