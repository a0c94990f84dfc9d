"""Akaike's criterion for laws fitted to the same data, with charges that are exact for few points."""

from __future__ import annotations

import math

from scipy import stats

CRITERION = (
    "N ln(RSS/N) plus a charge for each fitted constant, which is what chance alone would gain with the probability of "
    "15.7 % (Fisher's F with 1 and N - p degrees of freedom); with many points 2, as Akaike (1974) charges"
)

_CHANCE = float(stats.chi2.sf(2, 1))
"""Probability with which a constant without meaning gains more than Akaike's 2, with many points."""


def charge(points: int, constants: int, *, noise_known: bool = False) -> float:
    """Return what the last of several constants must gain in N ln(RSS), or in chi^2 where the noise is known.

    AICc, which corrects the bias of AIC for few points, charges too much there: it holds a law of two constants with
    residuals of 11 % for better than one of three with 1.3 %, if there are six points.
    """
    if noise_known:
        return 2.0
    freedom = points - constants
    # By a constant without meaning RSS becomes less by a factor that has this Beta distribution.
    return -points * math.log(stats.beta.ppf(_CHANCE, freedom / 2, 0.5)) if freedom > 0 else math.inf


def charges(points: int, constants: int, *, noise_known: bool = False) -> float:
    """Return what all constants are charged."""
    return sum(charge(points, number, noise_known=noise_known) for number in range(1, constants + 1))
