"""Roots of a function of one variable: first crossings on a scan, then a bracketed secant method."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

_MOST = 60


def crossings(values: Sequence[float]) -> tuple[int, ...]:
    """Numbers i for which values i and i + 1 lie on different sides of zero; infinities count by their sign."""
    return tuple(i for i, (a, b) in enumerate(pairwise(values)) if (a < 0) != (b < 0))


def illinois(
    function: Callable[[float], float], low: tuple[float, float], high: tuple[float, float], tolerance: float
) -> tuple[float, float]:
    """Find a root by the Illinois method (Dowell and Jarratt 1971); by bisection while an end is infinite.

    Parameters
    ----------
    function : callable
        May be infinite.
    low, high : (float, float)
        Argument and value at either end; the values differ in sign.
    tolerance : float
        Length of the bracket, or distance of two iterates, at which to stop.

    Returns
    -------
    (float, float)
        Argument and value of the iterate with the least finite value.
    """
    (a, fa), (b, fb) = low, high
    best = min((low, high), key=lambda pair: abs(pair[1]))
    last = math.inf
    for _ in range(_MOST):
        c = (a * fb - b * fa) / (fb - fa) if math.isfinite(fa) and math.isfinite(fb) else 0.5 * (a + b)
        fc = function(c)
        best = min(best, (c, fc), key=lambda pair: abs(pair[1]))
        if fc == 0 or abs(c - last) <= tolerance or abs(b - a) <= tolerance:
            break
        last = c
        if (fc < 0) != (fb < 0):
            a, fa = b, fb
        else:
            fa = 0.5 * fa
        b, fb = c, fc
    return best
