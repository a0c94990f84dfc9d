"""Edges of a strand to a hundredth of a pixel: cuts along the normal of its midline, and their brightness."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import find_objects, gaussian_filter1d, label
from scipy.special import erf

from softcat_sym.tracking.film import Picture
from softcat_sym.tracking.splines import Curve, curve

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_STEPS = 5
_HUBER = 2.0
_MARGIN = 6.0
"""Reach of a cut beyond four blur widths from the edge [px]."""
_WIDEST = 0.7
"""Share of a strand's outer thickness, over that of its dark part, that a window in it may take."""


class UnreadableFrameError(Exception):
    """Why a frame cannot be read; it is refused, and the film goes on."""


@dataclass(frozen=True, eq=False)
class Edges:
    """Fitted edges of n cuts."""

    place: Floats  # shape (n, k); of the one or two edges along the cut [px]
    height: Floats  # shape (n,); of the step in brightness
    rms: Floats  # shape (n,); of the residuals
    variance: Floats  # shape (n,); of the mean of both edges, or of the one [px^2]
    width: Floats  # shape (n,); blur width [px]
    is_found: Flags  # shape (n,); whether the fit converged to edges within the cut


def fit_edges(
    values: Floats, along: Floats, guess: Floats, width: float, *, weights: Floats | None = None, free: bool = False
) -> Edges:
    """Fit edges with one Gaussian blur to n cuts of m samples at once, by Gauss-Newton with Huber's weights.

    ``I(s) = b + g s + A/2 [erf((s - e1)/(sqrt(2) w)) - erf((s - e2)/(sqrt(2) w))]``; `guess`, shape (n, 2), has e1 and
    e2, or of one edge, shape (n, 1), the first. `values` are positive in the strand, `weights` 0 where nothing counts;
    `free` gives each cut a width of its own.
    """
    edges, n, k = guess.copy(), guess.shape[0], guess.shape[1]
    blur = np.full((n, 1), width)
    base = np.ones_like(values) if weights is None else weights
    weights = base
    inside = (along > edges[:, :1]) & (along < edges[:, 1:]) if k == 2 else along > edges
    inside, outside = inside & (base > 0), ~inside & (base > 0)
    level = (values * outside).sum(axis=1, keepdims=True) / np.maximum(outside.sum(axis=1, keepdims=True), 1)
    # Light that falls through the strand or on it is above the dark part.
    ranked = np.sort(np.where(inside, values, np.inf), axis=1)
    counted = np.maximum(inside.sum(axis=1, keepdims=True) - 1, 0)
    height = np.take_along_axis(ranked, (0.8 * counted).astype(int), axis=1) - level
    height = np.where(np.isfinite(height), height, 0.0)
    slope = np.zeros((n, 1))
    jacobian = np.empty((n, values.shape[1], 3 + k + free))
    jacobian[:, :, 0], jacobian[:, :, 1] = 1.0, along
    residual, normal = values, np.eye(jacobian.shape[2])
    for step in range(_STEPS + 1):
        z = (along[:, None, :] - edges[:, :, None]) / blur[:, :, None]
        steps = erf(z * np.sqrt(0.5))
        bells = np.exp(-0.5 * z**2) * (height / blur)[:, :, None] / np.sqrt(2 * np.pi)
        signs = np.array([1.0, -1.0])[:k]
        shape = 0.5 * (steps[:, 0] + (1.0 if k == 1 else -steps[:, -1]))
        residual = values - level - slope * along - height * shape
        jacobian[:, :, 2] = shape
        jacobian[:, :, 3 : 3 + k] = (-signs[:, None] * bells).transpose(0, 2, 1)
        if free:
            jacobian[:, :, -1] = -np.sum(signs[:, None] * bells * z, axis=1)
        if step == 2:
            spread = np.maximum(1.4826 * np.median(np.abs(residual), axis=1, keepdims=True), 1e-6)
            weights = base * np.minimum(1.0, _HUBER * spread / np.maximum(np.abs(residual), 1e-9))
        weighted = (jacobian * weights[:, :, None]).transpose(0, 2, 1)
        normal = weighted @ jacobian
        normal += 1e-9 * np.eye(normal.shape[1]) * np.trace(normal, axis1=1, axis2=2)[:, None, None]
        if step == _STEPS:
            break
        change = np.linalg.solve(normal, weighted @ residual[:, :, None])[:, :, 0]
        level += change[:, 0:1]
        slope += change[:, 1:2]
        height += change[:, 2:3]
        edges += np.clip(change[:, 3 : 3 + k], -2 * width, 2 * width)
        if free:
            blur = np.clip(blur + change[:, -1:], 0.3 * width, 3 * width)
    rms = np.sqrt(np.sum(weights * residual**2, axis=1) / np.maximum(weights.sum(axis=1) - normal.shape[1], 1))
    inverse = np.linalg.inv(normal)[:, 3 : 3 + k, 3 : 3 + k]
    variance = rms**2 * inverse.mean(axis=(1, 2))
    place_found = np.all((edges > along[:, :1]) & (edges < along[:, -1:]), axis=1)
    is_found = place_found & (height[:, 0] > 3 * rms) & np.isfinite(variance) & (edges[:, -1] >= edges[:, 0])
    return Edges(edges, height[:, 0], rms, variance, blur[:, 0], is_found)


@dataclass(frozen=True, eq=False)
class Midline:
    """A strand's midline and thickness to about a pixel."""

    y: Curve  # row over column
    thickness: Floats  # shape (m,); along the normal, at `columns` [px]
    columns: Floats  # shape (m,); at which the strand is seen whole
    window: float  # thickness of a bright part within it, over that of the dark part; median


def midline(signal: Picture, level: float, left: float, right: float) -> Midline:
    """Find the strand between two columns as what is above `level`, whole or with a window in it."""
    first = int(np.ceil(left)) + 2
    count = (int(right) - 1 - first) // 2
    pairs = signal[:, first : first + 2 * count]
    smooth = gaussian_filter1d(pairs[:, ::2] + pairs[:, 1::2], 1.0, axis=0)
    mask = smooth > 2 * level
    parts, number = label(mask, np.ones((3, 3), int))
    wide = [k + 1 for k, found in enumerate(extents(parts, number)) if found >= 0.08 * count]
    mask = np.isin(parts, wide) if number else mask
    thick = mask.sum(axis=0)
    seen = thick > 0
    if seen.mean() < 0.6:
        raise UnreadableFrameError(f"no strand: seen over {seen.mean():.0%} of the span")
    top, bottom = mask.argmax(axis=0), mask.shape[0] - 1 - mask[::-1].argmax(axis=0)
    window = (bottom - top + 1 - thick) / np.maximum(thick, 1)
    if np.mean(window[seen] > _WIDEST) > 0.3:
        raise UnreadableFrameError("two strands, or something as wide as the strand above or below it")
    whole = seen & (top > 1) & (bottom < mask.shape[0] - 2) & (window <= _WIDEST)
    if whole.mean() < 0.5:
        raise UnreadableFrameError(f"cut by the edge of the picture over {1 - whole.mean():.0%} of the span")
    columns = np.asarray(first + 0.5 + 2.0 * np.flatnonzero(whole), dtype=np.float64)
    line = curve(columns, (top + bottom)[whole] / 2.0, 16, rejected=5.0, rounding=0.5)
    thickness = np.asarray((bottom - top + 1.0)[whole] / np.hypot(1, line(columns, 1)), dtype=np.float64)
    return Midline(line, thickness[line.kept], columns[line.kept], float(np.median(window[seen])))


def extents(parts: NDArray[np.int32], number: int) -> list[int]:
    """Columns that each labelled part crosses."""
    return [0 if place is None else place[1].stop - place[1].start for place in find_objects(parts, number)]


@dataclass(frozen=True, eq=False)
class Cuts:
    """The strand in one frame: points of its midline, and its thickness there."""

    x: Floats  # shape (n,); column of the middle between both edges
    y: Floats  # shape (n,); row
    thickness: Floats  # shape (n,); along the normal [px]
    variance: Floats  # shape (n,); of the middle [px^2]
    rms: float  # of the residuals of brightness, median over the cuts
    height: float  # of the step of brightness, median
    width: float  # blur width, median [px]


def cut(signal: Picture, coarse: Midline, left: float, right: float, width: float, *, free: bool = False) -> Cuts:
    """Fit both edges on cuts along the normal, one for each pixel of arc length, between the supports' columns."""
    ends = coarse.columns[[0, -1]]
    fine = np.linspace(float(ends[0]), float(ends[1]), 4 * int(np.ptp(ends)) + 1)
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(fine), np.diff(coarse.y(fine))))])
    x = np.interp(np.arange(0.5, arc[-1], 1.0), arc, fine)
    gap = np.interp(x, coarse.columns, np.arange(coarse.columns.size))
    spacing = np.diff(coarse.columns)[np.clip(gap.astype(int), 0, coarse.columns.size - 2)]
    x = x[spacing < 0.02 * np.ptp(ends) + 6]
    slope = coarse.y(x, 1)
    normal = np.stack([-slope, np.ones_like(x)]) / np.hypot(1, slope)
    half = 0.5 * curve(coarse.columns, coarse.thickness, 4)(x)
    reach = float(np.quantile(half, 0.95)) + 4 * width + _MARGIN
    along = np.arange(-np.ceil(reach), reach + 1)
    # Pixels next to the cut, each at its own distance from the midline: between them nothing is interpolated.
    column = np.rint(x[:, None] + normal[0, :, None] * along).astype(int)
    row = np.rint(coarse.y(x)[:, None] + normal[1, :, None] * along).astype(int)
    along = (column - x[:, None]) * normal[0, :, None] + (row - coarse.y(x)[:, None]) * normal[1, :, None]
    rows, columns = signal.shape
    values = signal[np.clip(row, 0, rows - 1), np.clip(column, 0, columns - 1)].astype(np.float64)
    clear = (column > max(left + 3 * width, 0)) & (column < min(right - 3 * width, columns - 1))
    clear &= (row >= 0) & (row <= rows - 1)
    if np.median(half) > 5 * width:
        # Glare, and what shines through the strand, is deeper than that.
        clear &= np.abs(along) > half[:, None] - 3 * width
    usable = clear.mean(axis=1) > 0.6 * np.median(clear.mean(axis=1))
    if usable.mean() < 0.5:
        raise UnreadableFrameError(f"{1 - usable.mean():.0%} of the cuts leave the picture")
    x, normal, half = x[usable], normal[:, usable], half[usable]
    guess = np.stack([-half, half], axis=1)
    found = fit_edges(values[usable], along[usable], guess, width, weights=clear[usable].astype(np.float64), free=free)
    good = found.is_found
    if good.mean() < 0.5:
        raise UnreadableFrameError(f"edges in {good.mean():.0%} of the cuts")
    middle, thick = found.place[good].mean(axis=1), np.diff(found.place[good], axis=1)[:, 0]
    at_x, at_y = x[good] + normal[0, good] * middle, coarse.y(x[good]) + normal[1, good] * middle
    medians = (float(np.median(values[good])) for values in (found.rms, found.height, found.width))
    return Cuts(at_x, at_y, thick, found.variance[good], *medians)
