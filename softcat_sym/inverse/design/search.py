"""Least value of a function of few variables that may jump: a coarse grid, then a pattern search; deterministic."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import product

import numpy as np

from softcat_sym.inverse.estimation.least_squares import Floats

_GRID = {1: 9, 2: 5}
_FINEST = math.log(1.05)
_DIGITS = 9

Point = tuple[float, ...]


def pattern_search(value: Callable[[Point], float], lower: Floats, upper: Floats, most: int) -> Point | None:
    """Search a box.

    Hooke and Jeeves (1961), polled in all directions of the axes and their diagonals, from the best point of a grid.
    The step is halved where nothing is better; bounds are polled themselves.

    Parameters
    ----------
    value : callable
        To be minimised; may be infinite. Called once for each point.
    lower, upper : ndarray, shape (d,)
        Logarithms, at most two.
    most : int
        Evaluations, at least those of the grid.

    Returns
    -------
    tuple of float or None
        The best point; None if the value is infinite at all of the grid.
    """
    if not lower.size:
        return () if math.isfinite(value(())) else None
    known: dict[Point, float] = {}

    def at(point: Point) -> float:
        key = tuple(round(x, _DIGITS) for x in point)
        if key not in known:
            known[key] = value(point) if len(known) < most else math.inf
        return known[key]

    axes = [np.linspace(a, b, _GRID[lower.size]).tolist() for a, b in zip(lower, upper, strict=True)]
    best = min((tuple(point) for point in product(*axes)), key=at)
    if not math.isfinite(at(best)):
        return None
    step = (upper - lower) / (2 * (_GRID[lower.size] - 1))
    directions = [np.array(one) for one in product((-1, 0, 1), repeat=lower.size) if any(one)]
    while step.max() > _FINEST and len(known) < most:
        polled = [tuple(np.clip(best + step * one, lower, upper).tolist()) for one in directions]
        better = min(polled, key=at)
        if at(better) < at(best):
            best = better
        else:
            step = step / 2
    return best
