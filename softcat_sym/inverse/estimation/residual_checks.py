"""Whether residuals are white noise: signs in runs, correlation of neighbours, size."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from softcat_sym.inverse.estimation.confidence import chi_square_tail, normal_tail
from softcat_sym.inverse.estimation.least_squares import Floats

SIGNIFICANCE = 0.01
"""Probability with which white residuals are called not white, at most."""

FEWEST = 20
"""Residuals in a row below which the approximations of these tests do not hold."""

_LAGS = 10


@dataclass(frozen=True)
class Statistic:
    """What one test of the hypothesis that residuals are white finds.

    Attributes
    ----------
    name : str
        Whose test it is.
    value : float
        Standard normal, or chi^2.
    p_value : float
        Probability of a statistic at least as extreme from white residuals.
    """

    name: str
    value: float
    p_value: float


@dataclass(frozen=True)
class ResidualChecks:
    """What the residuals of a fit say about its model.

    Attributes
    ----------
    verdict : str
        ``"white"``; ``"not white"``: the model misses something that the data show, and intervals are too narrow; or
        ``"cannot tell"``: fewer than `FEWEST` in every series.
    tests : tuple of Statistic
        Runs of signs (Wald and Wolfowitz 1940), correlation of neighbours, the first lags together (Ljung and Box
        1978). The verdict is "not white" if the least of their p-values is below `SIGNIFICANCE` over their number
        (Bonferroni).
    autocorrelation : float or None
        Of neighbours, the mean over the series.
    size : Statistic or None
        RSS against chi^2 with m - k degrees of freedom, where the noise is known: a small p-value says that the model
        misses more than the stated errors, whatever the order. None where the noise is estimated.
    """

    verdict: Literal["white", "not white", "cannot tell"]
    tests: tuple[Statistic, ...]
    autocorrelation: float | None
    size: Statistic | None


def check_residuals(series: Sequence[Floats], unknowns: int, *, noise_known: bool) -> ResidualChecks:
    """Test the residuals of a fit.

    Parameters
    ----------
    series : sequence of ndarray, shape (m_i,)
        Residuals in the order of time, one array for every filmed filament: the end of one and the beginning of the
        next are no neighbours.
    unknowns : int
        That were fitted to all of them.
    noise_known : bool
        Whether they are in standard errors that were measured.
    """
    total = sum(one.size for one in series)
    squares = float(sum(one @ one for one in series))
    size = None
    if noise_known and total > unknowns:
        size = Statistic("chi-square", squares, chi_square_tail(squares, total - unknowns))
    # Residuals that are all zero have no order.
    long = [one for one in series if one.size >= FEWEST and np.any(one != 0)]
    if not long:
        return ResidualChecks("cannot tell", (), None, size)
    correlations = [_autocorrelations(one) for one in long]
    tests = (_runs(long), _neighbours(long, correlations), _ljung_box(long, correlations))
    white = min(test.p_value for test in tests) >= SIGNIFICANCE / len(tests)
    mean = float(np.mean([lags[0] for lags in correlations]))
    return ResidualChecks("white" if white else "not white", tests, mean, size)


def _runs(series: Sequence[Floats]) -> Statistic:
    """Numbers of runs of one sign, against their mean and variance for random order, summed over the series."""
    excess, variance = 0.0, 0.0
    for one in series:
        signs = one[one != 0] > 0
        above, below = int(signs.sum()), int((~signs).sum())
        both, count = 2 * above * below, above + below
        if count > 1:
            excess += 1 + int((signs[1:] != signs[:-1]).sum()) - (both / count + 1)
            variance += both * (both - count) / (count**2 * (count - 1))
    if variance <= 0:
        # One sign only, throughout: the mean of the residuals is not zero.
        return Statistic("Wald-Wolfowitz runs", -math.inf, 0.0)
    # Half a run of continuity.
    z = math.copysign(max(abs(excess) - 0.5, 0.0), excess) / math.sqrt(variance)
    return Statistic("Wald-Wolfowitz runs", z, normal_tail(z))


def _autocorrelations(one: Floats) -> Floats:
    """Of the first lags, without subtraction of a mean: that of residuals is to be zero."""
    lags = range(1, min(_LAGS, one.size // 5) + 1)
    return np.array([float(one[lag:] @ one[:-lag]) for lag in lags]) / float(one @ one)


def _neighbours(series: Sequence[Floats], correlations: Sequence[Floats]) -> Statistic:
    sizes = np.array([one.size for one in series])
    first = np.array([lags[0] for lags in correlations])
    z = float((np.sqrt(sizes) * first).sum() / math.sqrt(len(sizes)))
    return Statistic("lag-one autocorrelation", z, normal_tail(z))


def _ljung_box(series: Sequence[Floats], correlations: Sequence[Floats]) -> Statistic:
    statistic, freedom = 0.0, 0
    for one, lags in zip(series, correlations, strict=True):
        n = one.size
        statistic += n * (n + 2) * float((lags**2 / (n - np.arange(1, lags.size + 1))).sum())
        freedom += lags.size
    return Statistic("Ljung-Box", statistic, chi_square_tail(statistic, freedom))
