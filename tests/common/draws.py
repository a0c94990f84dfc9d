"""Random draws of statistical tests, and how far chance takes what is made of them.

The variable SOFTCAT_TEST_SEED (a number; not set, draws are the same every day) gives all of them other draws:
``SOFTCAT_TEST_SEED=7 python -m pytest -m statistical``. Where a decomposition, an optimiser or a fit stands between a
draw and a check, another processor is another draw as well, so that no check may be passed by luck. Each comparison has
a chance of `RARE` to fail where nothing is wrong, in both directions together; a test makes fewer than ten independent
ones, or says how often it compares, and so fails less than once in a million.
"""

from __future__ import annotations

import math
import os

import numpy as np
from scipy import stats

RARE = 1e-7

_SHIFT = [int(seed)] if (seed := os.environ.get("SOFTCAT_TEST_SEED")) else []


def draws(*seed: int) -> np.random.Generator:
    """A generator that nobody shares; without the variable it is NumPy's of these numbers alone."""
    return np.random.default_rng([*seed, *_SHIFT])


def errors_away(freedom: float = math.inf, comparisons: int = 1) -> float:
    """Standard errors, known or estimated with so many degrees of freedom, beyond which lies no normal deviate."""
    return float(stats.t.isf(RARE / comparisons / 2, freedom))


def misses(best: float, ends: tuple[float | None, float | None], truth: float, freedom: float = math.inf) -> bool:
    """Whether a 95 % interval is so far off the truth as healthy ones of so many degrees of freedom never are.

    Its ends are moved away from the best value as an interval of 1 - RARE has them; what has no end holds everything.
    """
    wider = errors_away(freedom) / float(stats.t.isf(0.025, freedom))
    below, above = (None if end is None else wider * (end - best) for end in ends)
    return (below is not None and truth < best + below) or (above is not None and truth > best + above)


def shares(number: int, probability: float, comparisons: int = 1) -> tuple[float, float]:
    """Between which shares, ends included, lies what happens with a probability, of so many independent draws."""
    binomial, tail = stats.binom(number, probability), RARE / comparisons / 2
    return float(binomial.ppf(tail)) / number, float(binomial.isf(tail)) / number


def gain(readings: int, constants: int, comparisons: int = 1) -> float:
    """By how much at most so many constants without meaning lower N ln(RSS) of normal deviates."""
    left = stats.beta((readings - constants) / 2, constants / 2)
    return -readings * math.log(left.ppf(RARE / comparisons))


def deviations(freedom: int, comparisons: int = 1) -> tuple[float, float]:
    """Between which ratios to the true one lies a standard deviation of so many degrees of freedom."""
    chi_square, tail = stats.chi2(freedom), RARE / comparisons / 2
    return math.sqrt(chi_square.ppf(tail) / freedom), math.sqrt(chi_square.isf(tail) / freedom)
