"""Akaike's criterion for laws fitted to the same data, with penalties that are exact for few points."""

from __future__ import annotations

import math

from scipy import stats

CRITERION = (
    "N ln(RSS/N) plus a penalty for each fitted constant: the gain that a constant without meaning exceeds with a "
    "probability of 15.7 % (Fisher's F with 1 and N - p degrees of freedom); for many points 2, as in Akaike (1974)"
)

_CHANCE = float(stats.chi2.sf(2, 1))
"""Probability that a constant without meaning gains more than Akaike's 2, with many points."""


def charge(points: int, constants: int, *, noise_known: bool = False) -> float:
    """Return the penalty of the last constant in N ln(RSS), or in chi^2 where the noise is known.

    AICc, which corrects the bias of AIC for few points, has too large a penalty: with six points it prefers a law of
    two constants with residuals of 11 % to a law of three constants with residuals of 1.3 %.
    """
    if noise_known:
        return 2.0
    freedom = points - constants
    # A constant without meaning lowers RSS by a factor that has this Beta distribution.
    return -points * math.log(stats.beta.ppf(_CHANCE, freedom / 2, 0.5)) if freedom > 0 else math.inf


def charges(points: int, constants: int, *, noise_known: bool = False) -> float:
    """Return the penalty of all constants together."""
    return sum(charge(points, number, noise_known=noise_known) for number in range(1, constants + 1))
