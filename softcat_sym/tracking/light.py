"""Uneven light, and whether a strand is darker or lighter than what is behind it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from softcat_sym.tracking.film import Picture
from softcat_sym.tracking.splines import robust_fit

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
    def of(cls, grey: Picture, is_dark: bool | None, *, flat: bool = True) -> Light:
        """Fit the background to one picture, without what is not background; of one grey level unless `flat`.

        A polarity that is not given is the one whose mask crosses more of the middle half with less area.
        """
        if is_dark is None:
            return max((cls.of(grey, one, flat=flat) for one in (True, False)), key=lambda one: one._crossing(grey))
        sign = 1.0 if is_dark else -1.0
        small = sign * grey[::_STRIDE, ::_STRIDE].astype(np.float64)
        if not flat:
            return cls(np.full(grey.shape, sign * np.quantile(small, 0.8), np.float32), is_dark)
        powers = _powers(small.shape)
        # The brightest fifth of each block is background, unless the block is covered.
        parts = [part for band in np.array_split(np.arange(small.size).reshape(small.shape), _BLOCKS)
                 for part in np.array_split(band, _BLOCKS, axis=1)]  # fmt: skip
        bright = np.array([np.quantile(small.flat[part], 0.8) for part in parts])
        rough = robust_fit(np.array([powers[part].mean(axis=(0, 1)) for part in parts]), bright, (3, 5)).coefficients
        values = small.ravel()
        near = np.abs(values - powers @ rough) <= 0.5 * np.ptp(bright) + 0.1 * np.ptp(values)
        surface = _powers(grey.shape) @ robust_fit(powers[near], values[near], (3, 5)).coefficients
        return cls((sign * surface).astype(np.float32).reshape(grey.shape), is_dark)

    def signal(self, grey: Picture) -> Picture:
        """Relative difference of a frame to the background, positive in the strand."""
        if self.is_dark:
            return np.asarray(1 - grey / np.maximum(self.background, np.float32(1.0)))
        # A dark background is no measure of the light that falls on the strand.
        return np.asarray((grey - self.background) / np.float32(max(float(self.background.mean()), 1.0)))

    def _crossing(self, grey: Picture) -> float:
        smooth = gaussian_filter(self.signal(grey)[:, grey.shape[1] // 4 : -grey.shape[1] // 4], 1.5)
        mask = smooth > max(threshold(smooth), 1e-6)
        return float(mask.any(axis=0).mean() - 3 * mask.mean())


def _powers(shape: tuple[int, ...]) -> Floats:
    """Powers of the place in a picture, shape (pixels, 9)."""
    v, u = (one.ravel() for one in np.mgrid[-1 : 1 : shape[0] * 1j, -1 : 1 : shape[1] * 1j])
    return np.stack([np.ones_like(u), u, v, u * u, u * v, v * v, u**4, v**4, u * u * v * v], axis=1)


def threshold(signal: Picture) -> float:
    """Otsu's threshold: that which separates two groups with the least variance within them.

    Otsu, "A threshold selection method from gray-level histograms", IEEE Trans. Syst. Man Cybern. 9, 62 (1979).
    """
    count, edges = np.histogram(signal, bins=256)
    level = (edges[1:] + edges[:-1]) / 2
    below, mass = np.cumsum(count), np.cumsum(count * level)
    with np.errstate(divide="ignore", invalid="ignore"):
        between = (mass[-1] * below / below[-1] - mass) ** 2 / (below * (below[-1] - below))
    return float(level[np.nan_to_num(between[:-1]).argmax()])
