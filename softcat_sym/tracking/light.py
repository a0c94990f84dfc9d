"""Uneven light, and whether a strand is darker or lighter than what is behind it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from softcat_sym.tracking.film import Picture

Floats = NDArray[np.float64]

_BLOCKS = 8
_STRIDE = 4


@dataclass(frozen=True, eq=False)
class Light:
    """What is behind the strand: frames become positive where the strand is, and zero elsewhere.

    The background is a surface of the powers 1, u, v, u^2, uv, v^2, u^4, v^4 and u^2 v^2 of the place in the picture.
    """

    background: Picture  # shape (rows, columns); [grey level] without the strand
    is_dark: bool  # Whether the strand is darker

    @classmethod
    def of(cls, grey: Picture, is_dark: bool, *, flat: bool = True) -> Light:
        """Fit the background to one picture, without what is not background; of one grey level unless `flat`."""
        sign = 1.0 if is_dark else -1.0
        rows, columns = grey.shape
        small = sign * grey[::_STRIDE, ::_STRIDE].astype(np.float64)
        v, u = np.meshgrid(np.linspace(-1, 1, small.shape[0]), np.linspace(-1, 1, small.shape[1]), indexing="ij")
        if not flat:
            level = np.quantile(small, 0.8)
            return cls(np.full((1, 1), sign * level, np.float32), is_dark)
        # The brightest fifth of each block is background, unless the block is covered.
        parts = [(a, b) for a in np.array_split(np.arange(small.shape[0]), _BLOCKS)
                 for b in np.array_split(np.arange(small.shape[1]), _BLOCKS)]  # fmt: skip
        bright = np.array([np.quantile(small[np.ix_(a, b)], 0.8) for a, b in parts])
        where = np.array([(u[0, b].mean(), v[a, 0].mean()) for a, b in parts]).T
        coefficients = _one_sided(_powers(*where), bright)
        flat_u, flat_v, values = u.ravel(), v.ravel(), small.ravel()
        near = np.abs(values - _powers(flat_u, flat_v) @ coefficients) <= 0.5 * np.ptp(bright) + 0.1 * np.ptp(values)
        coefficients = _one_sided(_powers(flat_u[near], flat_v[near]), values[near])
        v, u = np.meshgrid(np.linspace(-1, 1, rows), np.linspace(-1, 1, columns), indexing="ij")
        surface = (_powers(u.ravel(), v.ravel()) @ coefficients).reshape(rows, columns)
        return cls((sign * surface).astype(np.float32), is_dark)

    def signal(self, grey: Picture) -> Picture:
        """Relative difference of a frame to the background, positive in the strand."""
        if self.is_dark:
            return np.asarray(1 - grey / np.maximum(self.background, np.float32(1.0)))
        # A dark background is no measure of the light that falls on the strand.
        return np.asarray((grey - self.background) / np.float32(max(float(self.background.mean()), 1.0)))


def _powers(u: Floats, v: Floats) -> Floats:
    return np.stack([np.ones_like(u), u, v, u * u, u * v, v * v, u**4, v**4, u * u * v * v], axis=1)


def _one_sided(powers: Floats, values: Floats) -> Floats:
    """Least squares without what is below the others by more than three standard deviations of what is above."""
    kept = np.ones(values.size, bool)
    coefficients: Floats = np.zeros(powers.shape[1])
    for _ in range(8):
        coefficients = np.asarray(np.linalg.lstsq(powers[kept], values[kept], rcond=None)[0], dtype=np.float64)
        residual = values - powers @ coefficients
        spread = max(1.4826 * np.median(np.abs(residual[kept])), 1e-9)
        now = (residual > -3 * spread) & (residual < 5 * spread)
        if now.sum() < 2 * powers.shape[1] or np.array_equal(now, kept):
            break
        kept = now
    return coefficients


def threshold(signal: Picture) -> float:
    """Otsu's threshold: that which separates two groups with the least variance within them.

    Otsu, "A threshold selection method from gray-level histograms", IEEE Trans. Syst. Man Cybern. 9, 62 (1979).
    """
    count, edges = np.histogram(signal, bins=256)
    level = (edges[1:] + edges[:-1]) / 2
    below, total = np.cumsum(count), count.sum()
    mass = np.cumsum(count * level)
    with np.errstate(divide="ignore", invalid="ignore"):
        between = (mass[-1] * below / total - mass) ** 2 / (below * (total - below))
    return float(level[np.nan_to_num(between[:-1]).argmax()])


def light_of(grey: Picture, is_dark: bool | None, *, flat: bool = True) -> Light:
    """The light, and the polarity whose mask crosses more of the picture's middle half with less area."""
    if is_dark is not None:
        return Light.of(grey, is_dark, flat=flat)

    def score(light: Light) -> float:
        middle = light.signal(grey)[:, grey.shape[1] // 4 : -grey.shape[1] // 4]
        smooth = gaussian_filter1d(gaussian_filter1d(middle, 1.5, axis=0), 1.5, axis=1)
        mask = smooth > max(threshold(smooth), 1e-6)
        return float(mask.any(axis=0).mean() - 3 * mask.mean())

    return max((Light.of(grey, dark, flat=flat) for dark in (True, False)), key=score)
