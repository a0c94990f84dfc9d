"""Relative least squares for tau_Y + k g^n by variable projection: the linear constants in closed form, n by search."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

INDEX_BOUNDS = (0.05, 3.0)
"""Least and largest flow index n that is looked for."""

_STEP = 0.005
_GOLDEN = (math.sqrt(5) - 1) / 2


@dataclass(frozen=True)
class LinearPart:
    """The best tau_Y >= 0 and k >= 0 for given n.

    Attributes
    ----------
    tau_Y : ndarray, shape (indices,)
        Yield stress [Pa].
    k : ndarray, shape (indices,)
        Stress tau - tau_Y at the reference rate [Pa].
    squares : ndarray, shape (indices,)
        Sum over the points of ((tau_Y + k g^n)/tau - 1)^2.
    """

    tau_Y: Floats
    k: Floats
    squares: Floats


def linear_part(ratio: Floats, stress: Floats, index: Floats, *, yields: bool) -> LinearPart:
    """Solve the non-negative linear least squares of two columns (of one, if the law does not yield).

    A quadratic in the quadrant has its least value at its own minimum, or on the axis that the way there crosses; all
    entries are positive, so that each column alone has a positive coefficient.

    Parameters
    ----------
    ratio : ndarray, shape (points,)
        Shear rate over the reference rate.
    stress : ndarray, shape (points,)
        Shear stress [Pa].
    index : ndarray, shape (indices,)
        Flow indices n.
    yields : bool
        Whether there is a tau_Y.
    """
    flow = ratio ** index[:, None] / stress
    power = np.einsum("ij,ij->i", flow, flow)
    tau_Y, k = np.zeros(len(index)), flow.sum(axis=1) / power
    if yields:
        size = float(np.linalg.norm(1 / stress))
        still = 1 / stress / size
        along = flow @ still
        across = flow - along[:, None] * still
        k_both = across.sum(axis=1) / np.einsum("ij,ij->i", across, across)
        tau_both = (still.sum() - along * k_both) / size
        plateau = k_both < 0
        k_both[plateau], tau_both[plateau] = 0.0, still.sum() / size
        better = tau_both > 0
        tau_Y[better], k[better] = tau_both[better], k_both[better]
    residual = tau_Y[:, None] / stress + k[:, None] * flow - 1
    return LinearPart(tau_Y, k, np.einsum("ij,ij->i", residual, residual))


def best_index(ratio: Floats, stress: Floats, *, yields: bool) -> float:
    """Find the flow index of the least sum of squares within `INDEX_BOUNDS`.

    Every minimum of a fine grid is refined by golden section, and the least one wins; no starting value is needed.

    Parameters
    ----------
    ratio, stress : ndarray, shape (points,)
        As in :func:`linear_part`.
    yields : bool
        Likewise.
    """

    def squares(index: Floats) -> Floats:
        return linear_part(ratio, stress, index, yields=yields).squares

    low, high = INDEX_BOUNDS
    grid = np.linspace(low, high, round((high - low) / _STEP) + 1)
    walled = np.concatenate(([np.inf], squares(grid), [np.inf]))
    here = walled[1:-1]
    minima = np.flatnonzero((here < walled[:-2]) & (here <= walled[2:])).tolist()
    last = len(grid) - 1
    found = [_golden_section(squares, grid[max(at - 1, 0)], grid[min(at + 1, last)]) for at in minima]
    candidates = np.array([*found, low, high])
    return float(candidates[np.argmin(squares(candidates))])


def _golden_section(function: Callable[[Floats], Floats], low: float, high: float) -> float:
    """Minimum of a function with one minimum between two places, to the last digits that its values tell."""
    left, right = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    at_left, at_right = function(np.array([left, right]))
    while high - low > 1e-13:
        if at_left <= at_right:
            high, right, at_right = right, left, at_left
            left = high - _GOLDEN * (high - low)
            at_left = function(np.array([left]))[0]
        else:
            low, left, at_left = left, right, at_right
            right = low + _GOLDEN * (high - low)
            at_right = function(np.array([right]))[0]
    return 0.5 * (low + high)
