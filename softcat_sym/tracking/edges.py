"""Edges of a strand to a hundredth of a pixel: their brightness along cuts, fitted with one blur."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr

Floats = NDArray[np.float64]

_STEPS, _HUBER_FROM = 5, 2
_HUBER = 2.0


@dataclass(frozen=True, eq=False)
class Edges:
    """Fitted edges of n cuts."""

    place: Floats  # shape (n, k); of the one or two edges along the cut [px]
    height: Floats  # shape (n,); of the step in brightness
    rms: Floats  # shape (n,); of the residuals
    variance: Floats  # shape (n,); of the mean of both edges, or of the one [px^2]
    width: Floats  # shape (n,); blur width [px]
    is_found: NDArray[np.bool_]  # shape (n,); whether the fit converged to edges within the cut


def fit_edges(
    values: Floats, along: Floats, guess: Floats, width: float, *, weights: Floats | None = None, free: bool = False
) -> Edges:
    """Fit edges with one Gaussian blur to n cuts of m samples at once, by Gauss-Newton with Huber's weights.

    ``I(s) = b + g s + A [Phi((s - e1)/w) - Phi((s - e2)/w)]`` with the normal distribution Phi; `guess`, shape (n, 2),
    has e1 and e2, or of one edge, shape (n, 1), the first. `values` are positive in the strand, `weights` 0 where
    nothing counts; `free` gives each cut a width of its own.
    """
    n, k = guess.shape
    base = weights = np.ones_like(values) if weights is None else weights
    signs = np.array([1.0, -1.0])[:k, None]
    # b, g, A, edges, w; light that falls on the strand or through it is below the dark part.
    p = np.column_stack([np.zeros((n, 2)), np.max(values, axis=1), guess, np.full(n, width)])
    fitted = p.shape[1] - (not free)
    limit = np.array([np.inf] * 3 + [2 * width] * k + [np.inf])[:fitted]
    jacobian = np.empty((n, p.shape[1], values.shape[1]))
    jacobian[:, 0], jacobian[:, 1] = 1.0, along
    for step in range(_STEPS + 1):
        z = (along[:, None] - p[:, 3:-1, None]) / p[:, -1:, None]
        bells = signs * np.exp(-0.5 * z**2) * (p[:, 2] / p[:, -1] / np.sqrt(2 * np.pi))[:, None, None]
        jacobian[:, 2] = np.sum(signs * ndtr(z), axis=1)
        jacobian[:, 3:-1], jacobian[:, -1] = -bells, -np.sum(bells * z, axis=1)
        residual = values - np.einsum("np,npm->nm", p[:, :3], jacobian[:, :3])
        if step == _HUBER_FROM:
            spread = np.maximum(1.4826 * np.median(np.abs(residual), axis=1, keepdims=True), 1e-6)
            weights = base * np.minimum(1.0, _HUBER * spread / np.maximum(np.abs(residual), 1e-9))
        active = jacobian[:, :fitted]
        weighted = active * weights[:, None]
        normal = weighted @ active.transpose(0, 2, 1)
        normal += 1e-9 * np.eye(fitted) * np.trace(normal, axis1=1, axis2=2)[:, None, None]
        if step < _STEPS:
            change = np.linalg.solve(normal, weighted @ residual[:, :, None])[:, :, 0]
            p[:, :fitted] += np.clip(change, -limit, limit)
            p[:, -1] = np.clip(p[:, -1], 0.3 * width, 3 * width)
    rms = np.sqrt(np.sum(weights * residual**2, axis=1) / np.maximum(weights.sum(axis=1) - fitted, 1))
    variance = rms**2 * np.linalg.inv(normal)[:, 3 : 3 + k, 3 : 3 + k].mean(axis=(1, 2))
    place, height = p[:, 3:-1], p[:, 2]
    is_found = np.all((place > along[:, :1]) & (place < along[:, -1:]), axis=1) & (place[:, -1] >= place[:, 0])
    is_found &= (height > 3 * rms) & np.isfinite(variance)
    return Edges(place, height, rms, variance, p[:, -1], is_found)
