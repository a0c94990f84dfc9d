"""Smooth curves through points along a strand, with errors from the residuals and their correlation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_REJECTED = 4.0
"""Robust standard deviations beyond which a point is left out."""
_CORRELATED = 0.05
"""Correlation of residuals down to which it is summed."""

_GRADED = 16
"""Pieces from which on those next to the supports are shorter."""


@dataclass(frozen=True, eq=False)
class Curve:
    """A cubic spline fitted to points by least squares."""

    spline: BSpline
    inverse: Floats  # shape (k, k); inverse of the normal matrix, for weights of unit variance
    scale: float  # by which errors are larger: of the residuals, and of their correlation along the strand
    kept: Flags  # shape (n,); which points were not rejected
    rms: float  # of the residuals of these points

    def __call__(self, x: Floats, order: int = 0) -> Floats:
        """Value or derivative."""
        return np.asarray(self.spline(x, order))

    def covariance(self, x: Floats) -> Floats:
        """Covariance of the values at some places, shape (m, m)."""
        basis = _basis(self.spline.t, np.asarray(x, dtype=np.float64))
        return np.asarray(self.scale**2 * (basis @ self.inverse @ basis.T))

    def std(self, x: Floats) -> Floats:
        """Standard errors of the values at some places, shape (m,)."""
        return np.asarray(np.sqrt(np.maximum(np.diag(self.covariance(x)), 0.0)))


def curve(
    x: Floats,
    y: Floats,
    pieces: int,
    weight: Floats | None = None,
    *,
    rejected: float = _REJECTED,
    rounding: float = 0.0,
) -> Curve:
    """Fit a cubic spline of equal pieces, shorter ones next to the supports, to points of increasing x.

    Left out are points that are off by more than `rejected` robust standard deviations, which are no smaller than
    `rounding`. A weight is an inverse variance up to a factor.
    """
    inner = np.arange(1, pieces) / pieces
    if pieces >= _GRADED:
        # Next to a clamp a strand bends within its thickness.
        close = np.array([0.2, 0.5, 1.5]) / pieces
        inner = np.sort(np.concatenate([close, inner, 1 - close]))
    ends = x[[0, -1]]
    knots = np.concatenate([[ends[0]] * 4, ends[0] + inner * np.ptp(ends), [ends[1]] * 4])
    basis = _basis(knots, x)
    weight = np.ones_like(x) if weight is None else weight / weight.mean()
    kept = np.ones(x.size, bool)
    # A gap without points is bridged by the smoothest curve; elsewhere this changes nothing.
    bend = np.diff(np.eye(basis.shape[1]), 2, axis=0)
    smooth = 1e-7 * x.size / pieces * bend.T @ bend
    for _ in range(6):
        active = weight * kept
        inverse = np.linalg.inv(basis.T @ (active[:, None] * basis) + smooth)
        coefficients = inverse @ (basis.T @ (active * y))
        residual = (y - basis @ coefficients) * np.sqrt(weight)
        spread = max(1.4826 * float(np.median(np.abs(residual[kept]))), rounding, 1e-9)
        now = np.abs(residual) < rejected * spread
        if np.array_equal(now, kept) or now.sum() < 2 * basis.shape[1]:
            break
        kept = now
    good = residual[kept]
    mean_square = float(good @ good) / max(good.size - basis.shape[1], 1)
    scale = float(np.sqrt(mean_square * _correlation_time(good)))
    rms = float(np.sqrt(np.mean((y - basis @ coefficients)[kept] ** 2)))
    return Curve(BSpline(knots, coefficients, 3), np.asarray(inverse, dtype=np.float64), scale, kept, rms)


def _basis(knots: Floats, x: Floats) -> Floats:
    inside = np.clip(x, knots[0], knots[-1])
    return np.asarray(BSpline.design_matrix(inside, knots, 3).toarray())


def _correlation_time(residual: Floats) -> float:
    """Integrated correlation of residuals: the number of points that are worth one."""
    square = float(residual @ residual)
    if square <= 0:
        return 1.0
    total = 1.0
    for lag in range(1, residual.size // 4):
        correlation = float(residual[lag:] @ residual[:-lag]) / square
        if correlation < _CORRELATED:
            break
        total += 2 * correlation
    return total
