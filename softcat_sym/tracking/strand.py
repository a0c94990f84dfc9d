"""The strand in one frame: how a camera sees it, its midline to a pixel, cuts along the normal, smooth curves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import find_objects, gaussian_filter1d, label

from softcat_sym.tracking.edges import fit_edges
from softcat_sym.tracking.film import Picture
from softcat_sym.tracking.light import Light
from softcat_sym.tracking.splines import Curve, curve

Floats = NDArray[np.float64]

_PIECES, _THICKNESS_PIECES = 16, 4
_BLOCKY = 0.02
"""Scatter of the cuts' edges at least, from which on one is an outlier: a codec repeats blocks exactly [px]."""
_MARGIN = 6.0
"""Reach of a cut beyond four blur widths from the edge [px]."""
_WIDEST = 0.7
"""Share of a strand's outer thickness, over that of its dark part, that a window in it may take."""


class UnreadableFrameError(Exception):
    """Why a frame cannot be read; it is refused, and the film goes on."""


@dataclass(frozen=True, eq=False)
class Camera:
    """How a film sees the strand."""

    light: Light
    level: float  # brightness above which a pixel is the strand's
    width: float  # blur width [px]
    supports: tuple[float, float]  # columns of their edges at the strand's level [px]
    supports_std: tuple[float, float] = (0.5, 0.5)  # standard errors [px]
    row: float = 0.0  # of the supports' level, halfway between them
    tilt: float = 0.0  # of this level in the picture, clockwise [rad]

    @property
    def span(self) -> float:
        """Distance of the supports along their level [px]."""
        return float(np.diff(self.supports)[0] / np.cos(self.tilt))

    def to_world(self, x: Floats, y: Floats) -> tuple[Floats, Floats]:
        """Places to the right of the middle, and heights above the supports' level, of columns and rows [px]."""
        right, down = x - sum(self.supports) / 2, y - self.row
        cos, sin = np.cos(self.tilt), np.sin(self.tilt)
        return cos * right + sin * down, sin * right - cos * down

    def to_picture(self, x: Floats, y: Floats) -> tuple[Floats, Floats]:
        """Columns and rows of places and heights [px]."""
        cos, sin = np.cos(self.tilt), np.sin(self.tilt)
        return sum(self.supports) / 2 + cos * x + sin * y, self.row + sin * x - cos * y


@dataclass(frozen=True, eq=False)
class Strand:
    """The smooth midline and thickness in one frame, in the frame of the world, in pixels."""

    x: Floats  # shape (n,); place of each cut
    y: Floats  # shape (n,); height of each cut
    line: Curve  # halfway between both edges
    apart: Curve  # distance of the edges
    rms: float  # of the residuals of brightness, median over the cuts
    contrast: float  # step of brightness, median
    blur: float  # width, median
    window: float  # thickness of a bright part within the strand over that of the dark part

    # Blur moves an edge of curvature k by w^2 k/2 towards the centre of its circle, the inner one by w^2 k^2 h/2 more.

    def height(self, x: Floats) -> Floats:
        """Heights of the midline."""
        return np.asarray(self.line(x) - self.blur**2 / 2 * self.line(x, 2) / (1 + self.line(x, 1) ** 2))

    def thickness(self, x: Floats) -> Floats:
        """Thicknesses along the normal."""
        curvature = self.line(x, 2) / (1 + self.line(x, 1) ** 2) ** 1.5
        return np.asarray(self.apart(x) * (1 - (self.blur * curvature) ** 2 / 2))


def measure(camera: Camera, signal: Picture, *, free: bool = False) -> Strand:
    """Measure the strand in the light's signal, with one blur width or one for each cut.

    Both edges are fitted on cuts along the normal of the coarse midline, one for each pixel of arc length.

    Raises
    ------
    UnreadableFrameError
        With the reason.
    """
    (left, right), width = camera.supports, camera.width
    columns, line, thick, window = _coarse_midline(signal, camera.level, left, right)
    fine = np.linspace(columns[0], columns[-1], 4 * int(np.ptp(columns)) + 1)
    arc = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(fine), np.diff(line(fine))))])
    x = np.interp(np.arange(0.5, arc[-1], 1.0), arc, fine)
    gaps = np.diff(columns)[np.searchsorted(columns, x).clip(1, columns.size - 1) - 1]
    x = x[gaps < 0.02 * np.ptp(columns) + 6]
    y, slope, half = line(x), line(x, 1), 0.5 * thick(x)
    normal = np.stack([-slope, np.ones_like(x)]) / np.hypot(1, slope)
    reach = np.ceil(np.quantile(half, 0.95) + 4 * width + _MARGIN)
    along = np.arange(-reach, reach + 1)
    # Pixels next to the cut, each at its own distance from the midline: between them nothing is interpolated.
    column = np.rint(x[:, None] + normal[0, :, None] * along).astype(int)
    row = np.rint(y[:, None] + normal[1, :, None] * along).astype(int)
    along = (column - x[:, None]) * normal[0, :, None] + (row - y[:, None]) * normal[1, :, None]
    last = np.array(signal.shape) - 1
    values = signal[row.clip(0, last[0]), column.clip(0, last[1])].astype(np.float64)
    clear = (column > max(left + 3 * width, 0)) & (column < min(right - 3 * width, last[1]))
    clear &= (row >= 0) & (row <= last[0])
    if np.median(half) > 5 * width:
        # Glare, and what shines through the strand, is deeper than that.
        clear &= np.abs(along) > half[:, None] - 3 * width
    seen = clear.mean(axis=1)
    usable = seen > 0.6 * np.median(seen)
    _check(usable, 0.5, "{:.0%} of the cuts stay in the picture")
    guess = np.stack([-half, half], axis=1)[usable]
    found = fit_edges(values[usable], along[usable], guess, width, weights=1.0 * clear[usable], free=free)
    good = found.is_found
    _check(good, 0.5, "edges in {:.0%} of the cuts")
    middle = found.place.mean(axis=1)
    x, y = camera.to_world(x[usable] + normal[0, usable] * middle, y[usable] + normal[1, usable] * middle)
    order = np.argsort(x[good])
    x, y, wide, variance = (one[good][order] for one in (x, y, np.diff(found.place, axis=1)[:, 0], found.variance))
    smooth = curve(x, y, _PIECES, 1 / variance, rounding=_BLOCKY)
    _check(smooth.kept, 0.5, "{:.0%} of the cuts agree with a smooth strand")
    rms, contrast, blur = (float(np.median(one[good])) for one in (found.rms, found.height, found.width))
    apart = curve(x, wide, _THICKNESS_PIECES, rounding=_BLOCKY)
    return Strand(x, y, smooth, apart, rms, contrast, blur, window)


def _coarse_midline(signal: Picture, level: float, left: float, right: float) -> tuple[Floats, Curve, Curve, float]:
    """What is above `level` between two columns, whole or with a window: columns, midline, thickness and window."""
    first = int(np.ceil(left)) + 2
    count = (int(right) - 1 - first) // 2
    pairs = signal[:, first : first + 2 * count]
    mask = gaussian_filter1d(pairs[:, ::2] + pairs[:, 1::2], 1.0, axis=0) > 2 * level
    mask = np.isin(*wide_parts(mask, 0.08 * count))
    dark = mask.sum(axis=0)
    seen = dark > 0
    _check(seen, 0.6, "no strand: seen over {:.0%} of the span")
    top, bottom = mask.argmax(axis=0), mask.shape[0] - 1 - mask[::-1].argmax(axis=0)
    window = (bottom - top + 1 - dark) / np.maximum(dark, 1)
    _check(window[seen] <= _WIDEST, 0.7, "two strands, or something as wide as the strand above or below it")
    whole = seen & (top > 1) & (bottom < mask.shape[0] - 2) & (window <= _WIDEST)
    _check(whole, 0.5, "within the picture over {:.0%} of the span only")
    columns = first + 0.5 + 2.0 * np.flatnonzero(whole).astype(np.float64)
    line = curve(columns, (top + bottom)[whole] / 2.0, _PIECES, rejected=5.0, rounding=0.5)
    outer = (bottom - top + 1.0)[whole] / np.hypot(1, line(columns, 1))
    columns, outer = columns[line.kept], outer[line.kept]
    return columns, line, curve(columns, outer, _THICKNESS_PIECES), float(np.median(window[seen]))


def _check(good: NDArray[np.bool_], least: float, reason: str) -> None:
    """Refuse a frame of which too small a share is good."""
    share = good.mean() if good.size else 0.0
    if share < least:
        raise UnreadableFrameError(reason.format(share))


def wide_parts(mask: NDArray[np.bool_], least: float) -> tuple[NDArray[np.int32], list[int]]:
    """Labels of a mask's connected parts, and which of them cross so many columns."""
    parts, _ = label(mask, np.ones((3, 3), int))
    return parts, [k for k, place in enumerate(find_objects(parts), 1) if place[1].stop - place[1].start >= least]
