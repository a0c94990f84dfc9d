"""The supports in a picture: the gaps that a strand crosses."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import find_objects, gaussian_filter, label

from softcat_sym.errors import SoftcatError
from softcat_sym.tracking.edges import fit_edges
from softcat_sym.tracking.film import Picture
from softcat_sym.tracking.splines import robust_fit
from softcat_sym.tracking.strand import wide_parts

_FEWEST_ROWS = 4


def find_gaps(signal: Picture, level: float, width: float) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Find the gaps that a strand crosses, from left to right: columns of both edges and their standard errors [px].

    A support has more dark rows than the strand is thick. Its edge is then fitted in every row that it reaches and the
    strand does not, and a line through them is read at the strand's level.
    """
    mask = gaussian_filter(signal, 1.0) > level
    middle = mask.shape[1] // 2
    if not wide_parts(mask[:, middle // 2 : -middle // 2], 0.2 * middle)[1]:
        raise SoftcatError(
            "no strand crosses the middle of the picture; accepted: one from the left to the right, darker or lighter "
            "than what is behind it; --vertical for one that hangs"
        )
    count = mask.sum(axis=0)
    inner = count[middle - middle // 2 : middle + middle // 2]
    thick = float(np.median(inner[inner > 0]))
    many = find_objects(label(count > max(1.8 * thick, thick + 12))[0])
    # A grain of dust at the strand is no support.
    supports = [place for (place,) in many if place.stop - place.start > max(0.5 * thick, 4)]
    edges = [(_edge(signal, mask, one.stop - 1, -1, thick, width), _edge(signal, mask, other.start, 1, thick, width))
             for one, other in pairwise(supports)]  # fmt: skip
    return [((left[0], right[0]), (left[1], right[1])) for left, right in edges]


def _edge(
    signal: Picture, mask: NDArray[np.bool_], column: int, side: int, thick: float, width: float
) -> tuple[float, float]:
    """Column of a support's edge at the strand's level, and its standard error, near a whole column."""
    far, (rows, columns) = thick / 2 + 4 * width, mask.shape
    # The strand's level at the edge, from a line through what is seen of it beside the edge.
    beside = column - side * np.arange(int(far) + 2, int(far + 3 * thick) + 12)
    beside = beside[(beside >= 0) & (beside < columns)]
    beside = beside[mask[:, beside].any(axis=0)]
    level = [float(np.flatnonzero(mask[:, one]).mean()) for one in beside]
    strand = float(np.polyval(np.polyfit(beside, level, 1), column)) if len(level) > 1 else rows / 2
    inside, outside = (mask[:, np.clip(column + shift, 0, columns - 1)] for shift in (4 * side, -4 * side))
    # Far enough from the strand and from the support's own corners, unless it leaves the picture.
    row, reached = np.flatnonzero(inside & ~outside), np.flatnonzero(inside)[[0, -1]]
    low, high = np.where(reached == [0, rows - 1], [-np.inf, np.inf], reached + 4 * width * np.array([1, -1]))
    row = row[(np.abs(row - strand) > far) & (row > low) & (row < high)]
    along = np.broadcast_to(np.arange(-10.0, 11.0), (row.size, 21))
    values = signal[row[:, None], np.clip(column + side * along.astype(int), 0, columns - 1)].astype(np.float64)
    found = fit_edges(values, along, np.full((row.size, 1), -0.5), width, free=True)
    if found.is_found.sum() < _FEWEST_ROWS:
        return float(column - 0.5 * side), 1.0
    height, place = row[found.is_found] - strand, column + side * found.place[found.is_found, 0]
    line = robust_fit(np.stack([np.ones_like(height), height], axis=1), place, (3, 3), rounding=1e-3)
    return float(line.coefficients[0]), float(np.std(line.residual[line.kept]) * np.sqrt(line.inverse[0, 0]))
