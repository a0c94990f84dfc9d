"""Robust least squares, and smooth curves along a strand with errors from residuals and their correlation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_CORRELATED = 0.05
"""Correlation of residuals down to which it is summed."""
_FEWEST = 6
"""Points in a piece at least."""
_GRADED = 16
"""Pieces from which on those next to the supports are shorter."""


@dataclass(frozen=True, eq=False)
class RobustFit:
    """Linear least squares without outliers."""

    coefficients: Floats  # shape (k,)
    inverse: Floats  # shape (k, k); of the normal matrix
    residual: Floats  # shape (n,); times the square root of the weight
    kept: Flags  # shape (n,); which points are no outliers


def robust_fit(
    basis: Floats,
    values: Floats,
    rejected: tuple[float, float],
    *,
    weight: Floats | None = None,
    penalty: Floats | None = None,
    rounding: float = 1e-9,
) -> RobustFit:
    """Fit values by a basis, shape (n, k), without those that are too far below and above the others.

    `rejected` counts robust standard deviations, which are no smaller than `rounding`.
    """
    weight = np.ones_like(values) if weight is None else weight
    now = np.ones(values.size, bool)
    for _ in range(8):
        kept = now
        active = (weight * kept)[:, None] * basis
        inverse = np.linalg.inv(basis.T @ active + (0.0 if penalty is None else penalty))
        coefficients = inverse @ (active.T @ values)
        residual = (values - basis @ coefficients) * np.sqrt(weight)
        spread = max(1.4826 * float(np.median(np.abs(residual[kept]))), rounding)
        now = (residual > -rejected[0] * spread) & (residual < rejected[1] * spread)
        if np.array_equal(now, kept) or now.sum() < 2 * basis.shape[1]:
            break
    return RobustFit(coefficients, np.asarray(inverse), residual, kept)


@dataclass(frozen=True, eq=False)
class Curve:
    """A cubic spline fitted to points by least squares."""

    spline: BSpline
    inverse: Floats  # shape (k, k); inverse of the normal matrix, for weights of unit variance
    scale: float  # by which errors are larger: of the residuals, and of their correlation along the strand
    kept: Flags  # shape (n,); which points were not rejected

    def __call__(self, x: Floats, order: int = 0) -> Floats:
        """Value or derivative."""
        return np.asarray(self.spline(x, order))

    def std(self, x: Floats) -> Floats:
        """Standard errors of the values at some places, shape (m,)."""
        basis = _basis(self.spline.t, x)
        return np.asarray(self.scale * np.sqrt(np.maximum(np.sum((basis @ self.inverse) * basis, axis=1), 0.0)))


def curve(
    x: Floats, y: Floats, pieces: int, weight: Floats | None = None, *, rejected: float = 4.0, rounding: float = 1e-9
) -> Curve:
    """Fit a cubic spline of equal pieces, shorter ones next to the supports, to points of increasing x.

    A weight is an inverse variance up to a factor; outliers are left out as of :func:`robust_fit`.
    """
    pieces = max(min(pieces, x.size // _FEWEST), 1)
    inner = np.arange(1, pieces) / pieces
    if pieces >= _GRADED:
        # Next to a clamp a strand bends within its thickness.
        close = np.array([0.2, 0.5, 1.5]) / pieces
        inner = np.sort(np.concatenate([close, inner, 1 - close]))
    knots = x[0] + np.ptp(x) * np.concatenate([np.zeros(4), inner, np.ones(4)])
    basis = _basis(knots, x)
    # A gap without points is bridged by the smoothest curve; elsewhere this changes nothing.
    bend = np.diff(np.eye(basis.shape[1]), 2, axis=0)
    weight = None if weight is None else weight / weight.mean()
    fit = robust_fit(basis, y, (rejected, rejected), weight=weight, rounding=rounding,
                     penalty=1e-7 * x.size / pieces * bend.T @ bend)  # fmt: skip
    good = fit.residual[fit.kept]
    square = max(float(good @ good), 1e-300)
    # Integrated correlation of the residuals: the number of points that are worth one.
    correlation = np.append(np.correlate(good, good, "full")[good.size : good.size + good.size // 4] / square, 0.0)
    worth = 1 + 2 * correlation[: np.argmax(correlation < _CORRELATED)].sum()
    scale = float(np.sqrt(square / max(good.size - basis.shape[1], 1) * worth))
    return Curve(BSpline(knots, fit.coefficients, 3), fit.inverse, scale, fit.kept)


def _basis(knots: Floats, x: Floats) -> Floats:
    return np.asarray(BSpline.design_matrix(np.clip(x, knots[0], knots[-1]), knots, 3).toarray())
