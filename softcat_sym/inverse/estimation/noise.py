"""How far noise throws the unknowns of a fit: the scale of least squares and of M-estimators."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.inverse.estimation.least_squares import LINEAR, Floats, Loss

# To which the model is evaluated, relative to what a unit of q changes: less cannot be the noise of data.
_MODEL_ACCURACY = 1e-7
# Of the mean slope of psi: a loss with less charges nothing but outliers, and tells next to nothing.
_LEAST_SLOPE = 1e-3
# Of a normal distribution, over the median of magnitudes.
_MEDIAN_TO_DEVIATION = 1.4826


@dataclass(frozen=True)
class Noise:
    """The noise of a fit, in the unit of its residuals r.

    Attributes
    ----------
    deviation : float
        tau: the covariance of the unknowns is tau^2 (J^T J)^-1. Of least squares the standard deviation of r.
    score : float
        Standard deviation of psi(r), by which each residual pulls; of least squares again that of r.
    per_chi_square : float
        What twice the minimised value rises by for each unit of chi^2: tau^2 times the mean of psi'.
    reading : float
        Standard deviation of r without outliers: one if it is known.
    freedom : int or None
        m - k; None where the noise is known.
    """

    deviation: float
    score: float
    per_chi_square: float
    reading: float
    freedom: int | None


def noise_of(residuals: Floats, jacobian: Floats, *, noise_known: bool, loss: Loss = LINEAR) -> Noise:
    """Estimate the noise at an optimum.

    Of a robust loss, psi = rho'(r^2) r, the covariance is the sandwich of an M-estimator with residuals that are alike
    (Huber 1981, section 7.6): tau^2 = K^2 sum psi^2/(m - k) / mean(psi')^2, K = 1 + k/m var(psi')/mean(psi')^2. It is
    taken from the data even where their errors are stated, for outliers are part of it.

    Parameters
    ----------
    residuals, jacobian : ndarray, shape (m,), (m, k)
        At the optimum, before the loss.
    noise_known : bool
        Whether the residuals are in standard errors that were measured.
    loss : Loss
        What was minimised.

    Raises
    ------
    SoftcatError
        If the noise is to be estimated from no more residuals than unknowns.
    """
    unknowns = jacobian.shape[1]
    freedom = residuals.size - unknowns
    # With no more data than unknowns every loss meets them all: none is an outlier.
    if noise_known and (loss.kind == "linear" or freedom < 1):
        return Noise(1.0, 1.0, 1.0, 1.0, None)
    if freedom < 1:
        raise SoftcatError(
            f"{residuals.size} data for {unknowns} unknowns leave nothing to tell the noise by; accepted: at least "
            f"{unknowns + 1} data, or their standard errors"
        )
    least = max(_MODEL_ACCURACY * float(np.sqrt(np.mean(jacobian**2))), float(np.finfo(float).tiny))
    psi = residuals if loss.kind == "linear" else loss.weights(residuals) * residuals
    score = max(math.sqrt(float(psi @ psi) / freedom), least)
    if loss.kind == "linear":
        return Noise(score, score, score**2, score, freedom)
    slopes = loss.slopes(residuals)
    slope = max(float(slopes.mean()), _LEAST_SLOPE)
    few = 1 + unknowns / residuals.size * float(slopes.var()) / slope**2
    tau = few * score / slope
    middle = _MEDIAN_TO_DEVIATION * float(np.median(np.abs(residuals))) * math.sqrt(residuals.size / freedom)
    return Noise(tau, score, tau**2 * slope, 1.0 if noise_known else max(middle, least), freedom)
