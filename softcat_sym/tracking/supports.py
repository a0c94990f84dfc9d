"""The frame of the world in a picture: supports, scale, and the level of the strand between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d, label

from softcat_sym.errors import SoftcatError
from softcat_sym.tracking.edges import extents, fit_edges
from softcat_sym.tracking.film import Picture, Region
from softcat_sym.tracking.splines import curve

Floats = NDArray[np.float64]

_FEWEST_ROWS = 4


@dataclass(frozen=True)
class Supports:
    """Edges of the supports between which the strand hangs."""

    left: float  # Column of each at the strand's level [px]
    right: float
    left_std: float = 0.0  # Standard errors [px]
    right_std: float = 0.0


def find_supports(signal: Picture, level: float, width: float) -> Supports:
    """Find the columns from which on, outwards from the middle, more rows are dark than the strand is thick.

    The edge is then fitted in every row that the support reaches and the strand does not, and a line through these
    edges is read at the strand's level.
    """
    mask = gaussian_filter1d(gaussian_filter1d(signal, 1.0, axis=0), 1.0, axis=1) > level
    middle = mask.shape[1] // 2
    if max(extents(*label(mask[:, middle // 2 : -middle // 2], np.ones((3, 3), int))), default=0) < 0.2 * middle:
        raise SoftcatError(
            "no strand crosses the middle of the picture; accepted: one from the left to the right, darker or lighter "
            "than what is behind it; --vertical for one that hangs"
        )
    count = mask.sum(axis=0)
    inner = count[middle - middle // 2 : middle + middle // 2]
    thick = float(np.median(inner[inner > 0]))
    many = count > max(1.8 * thick, thick + 12)
    found = list[tuple[float, float]]()
    for side, name in ((-1, "left"), (1, "right")):
        columns = np.arange(middle, -1 if side < 0 else mask.shape[1], side)
        # Two columns in a row, so that a grain of dust at one is no support.
        there = np.flatnonzero(many[columns[:-1]] & many[columns[1:]])
        there = there[there > 0.1 * middle]
        if not there.size:
            raise SoftcatError(
                f"no {name} support found: give the columns of both edges by --supports x0,x1; "
                "--vertical is for a strand that hangs"
            )
        found.append(_edge_at(signal, mask, int(columns[there[0]]), side, thick, width))
    (left, left_std), (right, right_std) = found
    return Supports(left, right, left_std, right_std)


def _edge_at(
    signal: Picture, mask: NDArray[np.bool_], column: int, side: int, thick: float, width: float
) -> tuple[float, float]:
    """Column of a support's edge at the strand's level, and its standard error, near a whole column."""
    beside = np.clip(column - side * int(thick / 2 + 4 * width + 2), 0, mask.shape[1] - 1)
    rows = np.flatnonzero(mask[:, beside])
    strand = float(rows.mean()) if rows.size else mask.shape[0] / 2
    inside = np.clip(column + side * 4, 0, mask.shape[1] - 1)
    dark = mask[:, inside]
    rows = np.flatnonzero(dark & ~mask[:, np.clip(column - side * 4, 0, mask.shape[1] - 1)])
    # Far enough from the strand and from the support's own corners.
    far = thick / 2 + 4 * width
    rows = rows[np.abs(rows - strand) > far]
    limits = np.flatnonzero(dark)[[0, -1]]
    limits = np.array([limits[0] if limits[0] > 0 else -99, limits[1] if limits[1] < mask.shape[0] - 1 else 1e9])
    rows = rows[(rows > limits[0] + 4 * width) & (rows < limits[1] - 4 * width)]
    if rows.size < _FEWEST_ROWS:
        return float(column - 0.5 * side), 1.0
    along = np.arange(-10, 11)
    values = signal[rows[:, None], np.clip(column + side * along, 0, mask.shape[1] - 1)].astype(np.float64)
    grid = np.broadcast_to(along.astype(np.float64), values.shape)
    found = fit_edges(values, grid, np.full((rows.size, 1), -0.5), width, free=True)
    good = found.is_found
    if good.sum() < _FEWEST_ROWS:
        return float(column - 0.5 * side), 1.0
    y, x = rows[good] - strand, column + side * found.place[good, 0]
    kept = np.ones(x.size, bool)
    for _ in range(5):
        powers = np.stack([np.ones(kept.sum()), y[kept]], axis=1)
        line = np.linalg.lstsq(powers, x[kept], rcond=None)[0]
        residual = x - line[0] - line[1] * y
        spread = max(1.4826 * float(np.median(np.abs(residual[kept]))), 1e-3)
        kept = np.abs(residual) < 3 * spread
    inverse = np.linalg.inv(powers.T @ powers)
    rms = float(np.std(residual[kept]))
    return float(line[0]), float(rms * np.sqrt(inverse[0, 0]))


def width_of(signal: Picture, region: Region, level: float, width: float) -> tuple[float, float]:
    """Width of a straight bar in a region, such as a needle or a nozzle, and its standard error [px]."""
    x0, x1, y0, y1 = region
    part = signal[y0:y1, x0:x1]
    mask = gaussian_filter1d(part, 1.0, axis=1) > level
    crossed = mask.any(axis=1).mean(), mask.any(axis=0).mean()
    # Cuts go along the rows of a bar that stands.
    if mask.all(axis=1).mean() > mask.all(axis=0).mean() or (crossed[0] < crossed[1]):
        part, mask = part.T, mask.T
    whole = np.flatnonzero(mask.any(axis=1) & ~mask[:, 0] & ~mask[:, -1])
    if whole.size < 2 * _FEWEST_ROWS:
        raise SoftcatError(f"no bar across the region {x0},{x1},{y0},{y1}: both of its edges, and nothing else, belong "
                           "in it")  # fmt: skip
    left, right = mask[whole].argmax(axis=1), mask.shape[1] - 1 - mask[whole][:, ::-1].argmax(axis=1)
    axis = np.polyfit(whole, (left + right) / 2, 1)
    half = float(np.median(right - left + 1)) / 2
    reach = min(half + 4 * width + 6, (mask.shape[1] - 1) / 2)
    middle = np.polyval(axis, whole)
    columns = np.rint(middle[:, None] + np.arange(-reach, reach + 1)).astype(int).clip(0, mask.shape[1] - 1)
    values = part[whole[:, None], columns].astype(np.float64)
    guess = np.tile([-half, half], (whole.size, 1))
    found = fit_edges(values, columns - middle[:, None], guess, width, free=True)
    good = found.is_found
    if good.sum() < 2 * _FEWEST_ROWS:
        raise SoftcatError(f"no sharp edges in the region {x0},{x1},{y0},{y1}")
    # The slope of the fitted axis, not of the mask's.
    centre = middle[good] + found.place[good].mean(axis=1)
    cosine = 1 / np.hypot(1, np.polyfit(whole[good], centre, 1)[0])
    fitted = curve(whole[good].astype(np.float64), np.diff(found.place[good], axis=1)[:, 0] * cosine, 1)
    at = np.linspace(whole[0], whole[-1], 20)
    # Of a bar that is not equally wide everywhere it is not known where the width was measured.
    return float(fitted(at).mean()), float(np.hypot(np.sqrt(fitted.covariance(at).mean()), fitted(at).std()))
