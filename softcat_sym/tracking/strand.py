"""The strand in one frame: how a camera sees it, and its smooth midline and thickness."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from softcat_sym.tracking.edges import Cuts, UnreadableFrameError, cut, midline
from softcat_sym.tracking.film import Picture
from softcat_sym.tracking.light import Light
from softcat_sym.tracking.splines import Curve, curve
from softcat_sym.tracking.supports import Supports

Floats = NDArray[np.float64]

_PIECES, _THICKNESS_PIECES = 16, 4
_BLOCKY = 0.02
"""Scatter of the cuts' edges at least, from which on one is an outlier: a codec repeats blocks exactly [px]."""


@dataclass(frozen=True, eq=False)
class Camera:
    """How a film sees the strand."""

    light: Light
    level: float  # brightness above which a pixel is the strand's
    width: float  # blur width [px]
    supports: Supports
    centre: tuple[float, float]  # column and row halfway between the supports, at their level
    tilt: float  # of the supports' level in the picture, clockwise [rad]

    def to_world(self, x: Floats, y: Floats) -> tuple[Floats, Floats]:
        """Places from the centre to the right, and heights above the supports' level, of columns and rows [px]."""
        right, down = x - self.centre[0], y - self.centre[1]
        cos, sin = np.cos(self.tilt), np.sin(self.tilt)
        return cos * right + sin * down, sin * right - cos * down

    def to_picture(self, x: Floats, y: Floats) -> tuple[Floats, Floats]:
        """Columns and rows of places and heights [px]."""
        cos, sin = np.cos(self.tilt), np.sin(self.tilt)
        return self.centre[0] + cos * x + sin * y, self.centre[1] + sin * x - cos * y


@dataclass(frozen=True, eq=False)
class Measured:
    """One frame: the smooth midline and thickness in the frame of the world, in pixels."""

    cuts: Cuts
    x: Floats  # shape (n,); place of each cut
    y: Floats  # shape (n,); height of each cut
    fitted: Curve
    thickness: Curve
    blur: float  # width [px]
    window: float  # thickness of a bright part within the strand over that of the dark part

    def height(self, x: Floats) -> Floats:
        """Heights of the midline; blur moves an edge of curvature k by w^2 k/2 towards the centre of its circle."""
        bend = self.fitted(x, 2) / (1 + self.fitted(x, 1) ** 2)
        return np.asarray(self.fitted(x) - self.blur**2 / 2 * bend)


def measure(camera: Camera, grey: Picture, *, free: bool = False) -> Measured:
    """Measure the strand in one frame, with one blur width or one for each cut, or say why it cannot be read."""
    signal = camera.light.signal(grey)
    left, right = camera.supports.left, camera.supports.right
    coarse = midline(signal, camera.level, left, right)
    cuts = cut(signal, coarse, left, right, camera.width, free=free)
    x, y = camera.to_world(cuts.x, cuts.y)
    order = np.argsort(x)
    x, y = x[order], y[order]
    height = curve(x, y, _PIECES, 1 / cuts.variance[order], rounding=_BLOCKY)
    thickness = curve(x, cuts.thickness[order], _THICKNESS_PIECES, rounding=_BLOCKY)
    if height.kept.mean() < 0.5:
        raise UnreadableFrameError(f"{height.kept.mean():.0%} of the cuts agree with a smooth strand")
    return Measured(cuts, x, y, height, thickness, cuts.width, coarse.window)
