"""Films of a strand between two supports, rendered from exact geometry: what tracking is held against.

A part of a pixel has the share of its area that the strand covers, exact in the vertical and on three lines across;
supports are exact along the span. With its place in a part of 1/n px, an edge's squared blur width changes by up to
1/(4 n^2): thin strands need fine parts. A lens blurs before pixels average: blurred after it, an edge would move by a
hundredth of a pixel with its place in the pixel. Then follow light, noise, rounding to grey levels and a codec.
Rows count downwards; a pixel's centre has whole coordinates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any

import av
import numpy as np
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter1d

from tests.common.draws import draws

Array = np.ndarray
Shape = Callable[[float, Array], Array]

LINES = 3
"""Vertical lines in a part of a pixel on which its coverage is exact."""


def falling(sag: float, span: float, duration: float, release: float = 0.25) -> Shape:
    """Depth over time [s] and place of a strand with clamped ends, (1 - xi^2)^2; at rest until the release."""

    def depth(time: float, x: Array) -> Array:
        elapsed = max(time - release, 0.0) / (duration - release)
        return sag * (1 - np.exp(-2.5 * elapsed)) / (1 - np.exp(-2.5)) * (1 - (2 * x / span) ** 2) ** 2

    return depth


def simulated(data: Any, scale: float, release: float) -> Shape:
    """Depth of a run's midline, from its Dataset, where a metre has so many pixels."""
    time, x, y = (np.asarray(data[name]) for name in ("time", "x", "y"))

    def depth(when: float, place: Array) -> Array:
        at = np.clip(when - release, 0.0, time[-1])
        later = int(np.clip(np.searchsorted(time, at), 1, time.size - 1))
        share = (at - time[later - 1]) / (time[later] - time[later - 1])
        right, up = (scale * ((1 - share) * one[later - 1] + share * one[later]) for one in (x, y))
        return -np.asarray(CubicSpline(right - (right[0] + right[-1]) / 2, up)(place))

    return depth


FALLING = falling(55.0, 250.0, 1.1)


@dataclass(frozen=True)
class Picture:
    """What is filmed, in pixels, and how."""

    depth: Shape = FALLING  # of the midline below the supports' level, by time and x from the middle
    rows: int = 240
    columns: int = 320
    span: float = 250.0  # between the supports
    level: float = 70.3  # row of the supports' level in the middle
    centre: float = 160.2  # column halfway between the supports
    thickness: float = 12.0
    supports: str = "clamps"  # or pillars
    inner: tuple[tuple[float, float], ...] = ()  # places of the edges of further pillars below the strand
    tilt: float = 0.0  # of the camera [rad]: the picture turns clockwise
    blur: float = 1.0  # standard deviation of the lens
    noise: float = 1.0  # grey levels
    background: float = 205.0
    strand: float = 45.0
    gradient: float = 0.0  # of the light, from left to right
    vignette: float = 0.0  # loss of light in the corners
    glare: float = 0.0  # of a line along the middle, a fifth as thick: share of the contrast
    core: float = 0.0  # share of the thickness that is clear
    exposure: float = 0.0  # [s]
    perspective: float = 0.0  # change of scale from the left to the right edge of the picture
    second: float = 0.0  # distance below of a second strand; 0 for none
    dust: tuple[tuple[float, float, float], ...] = ()  # row, column and radius
    light_strand: bool = False
    fine: int = 2  # parts of a pixel in each direction
    seed: int = 0
    times: Array = field(default_factory=lambda: np.arange(9) / 7.2)

    def to_picture(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Columns and rows of points: x from the middle to the right, y above the supports' level."""
        scale = 1 + self.perspective * x / self.columns
        right, down = x * scale, -y * scale
        cos, sin = np.cos(self.tilt), np.sin(self.tilt)
        return self.centre + cos * right - sin * down, self.level + sin * right + cos * down

    def midpoint(self, times: Array) -> Array:
        """Height of the midpoint above the supports' level, exact."""
        return np.array([-float(self.depth(time, np.zeros(1))[0]) for time in times])

    def midline(self, time: float, x: Array) -> Array:
        return -self.depth(time, x)

    def frames(self) -> Iterator[Array]:
        """All frames as grey levels, shape (rows, columns)."""
        random = draws(self.seed)
        light = self._light()
        for time in self.times:
            shutter = np.linspace(0, self.exposure, 9) if self.exposure else np.zeros(1)
            covered = np.mean([self._covered(float(time) + late) for late in shutter], axis=0)
            contrast = self.strand - self.background
            bright = (self.background + contrast * self._sampled(covered)) * light
            bright = np.clip(np.rint(bright + self.noise * random.standard_normal(bright.shape)), 0, 255)
            yield (255 - bright if self.light_strand else bright).astype(np.uint8)

    def _sampled(self, covered: Array) -> Array:
        """Blurred by the lens, then averaged over pixels."""
        for axis in (0, 1):
            covered = gaussian_filter1d(covered.astype(np.float32), self.fine * self.blur, axis=axis, mode="nearest")
            parts = (-1, self.fine, covered.shape[1]) if axis == 0 else (covered.shape[0], -1, self.fine)
            covered = covered.reshape(parts).mean(axis=axis + 1)
        return covered

    def _light(self) -> Array:
        v, u = np.mgrid[-1 : 1 : self.rows * 1j, -1 : 1 : self.columns * 1j]
        return (1 + self.gradient * u / 2) * (1 - self.vignette * (u**2 + v**2) ** 2 / 4)

    def _covered(self, time: float) -> Array:
        """Share of the strand's darkness in each part of a pixel."""
        strand = self._ribbon(time, self.thickness)
        if self.glare:
            strand -= self.glare * self._ribbon(time, 0.2 * self.thickness)
        if self.core:
            strand -= self._ribbon(time, self.core * self.thickness)
        if self.second:
            strand = np.maximum(strand, self._ribbon(time, self.thickness, -self.second))
        return 1 - (1 - strand) * self._clear

    @cached_property
    def _clear(self) -> Array:
        """Share of each part of a pixel that supports and dust leave free."""
        free = np.ones((self.rows * self.fine, self.columns * self.fine))
        half, deep = self.span / 2, 45.0 * self.rows / 240
        for side in (-1, 1):
            top, bottom = (deep, -deep) if self.supports == "clamps" else (-self.thickness / 2, -2 * self.rows)
            columns, rows = self.to_picture(side * half + np.zeros(200), np.linspace(top, bottom, 200))
            # Transposed, the support reaches from its edge to the picture's.
            far = np.full(200, -9.0 if side < 0 else self.columns + 9.0)
            low, high = (far, columns) if side < 0 else (columns, far)
            free *= 1 - _coverage((rows, low), (rows, high), self.columns, self.rows, self.fine).T
        for edges in self.inner:
            y = np.linspace(-self.thickness / 2, -2 * self.rows, 200)
            (low, rows), (high, _) = (self.to_picture(edge + np.zeros(200), y) for edge in edges)
            free *= 1 - _coverage((rows, low), (rows, high), self.columns, self.rows, self.fine).T
        v, u = np.mgrid[: self.rows * self.fine, : self.columns * self.fine]
        for row, column, radius in self.dust:
            free *= np.clip(np.hypot(v - self.fine * row, u - self.fine * column) - self.fine * radius, 0, 1)
        return free

    def _ribbon(self, time: float, thickness: float, above: float = 0.0) -> Array:
        reach = self.columns if self.supports == "pillars" else self.span / 2 + 8
        x = np.linspace(-reach, reach, 4001)
        y = np.where(np.abs(x) < self.span / 2, self.midline(time, np.clip(x, -self.span / 2, self.span / 2)), 0.0)
        slope = np.gradient(y, x)
        normal = np.stack([-slope, np.ones_like(x)]) / np.hypot(slope, 1)
        edges = [self.to_picture(x + t * normal[0], y + above + t * normal[1]) for t in (thickness / 2, -thickness / 2)]
        return _coverage(edges[0], edges[1], self.rows, self.columns, self.fine)


def _coverage(upper: tuple[Array, Array], lower: tuple[Array, Array], rows: int, columns: int, fine: int) -> Array:
    """Share of each part of a pixel between two curves (columns, rows), which go to the right."""
    x = (np.arange(columns * fine * LINES) + 0.5) / (fine * LINES) - 0.5
    top = np.interp(x, *upper, left=np.nan, right=np.nan)
    bottom = np.interp(x, *lower, left=np.nan, right=np.nan)
    edge = np.arange(rows * fine + 1)[:, None] / fine - 0.5
    share = fine * np.diff(np.clip(edge, top, bottom), axis=0)
    return np.nan_to_num(share).reshape(rows * fine, columns * fine, LINES).mean(axis=2)


LOSSLESS = ("ffv1", "gray", {})
MJPEG = ("mjpeg", "yuvj420p", {"qscale": "3"})


def h264(crf: int) -> tuple[str, str, dict[str, str]]:
    """As phones write it, but for the quality."""
    return "libx264", "yuv420p", {"crf": str(crf), "threads": "1"}


def write_film(
    path: Path, frames: Iterable[Array], times: Array, codec: tuple[str, str, dict[str, str]] = LOSSLESS
) -> Path:
    """Encode grey frames at their own times [s], to a tenth of a millisecond."""
    name, pixels, options = codec
    base = Fraction(1, 10_000)
    with av.open(str(path), "w") as container:
        container.metadata["comment"] = "Not a measurement: softcat_sym's tests rendered it"
        stream = container.add_stream(name, rate=Fraction(round(len(times) / max(np.ptp(times), 1e-9)) or 1))
        stream.pix_fmt, stream.options = pixels, {key: value for key, value in options.items() if key != "qscale"}
        stream.codec_context.time_base = base
        if "qscale" in options:
            stream.codec_context.qmin = stream.codec_context.qmax = int(options["qscale"])
        for number, (grey, time) in enumerate(zip(frames, times, strict=True)):
            if number == 0:
                stream.height, stream.width = grey.shape[:2]
            frame = av.VideoFrame.from_ndarray(grey, format="gray" if grey.ndim == 2 else "rgb24").reformat(
                format=pixels
            )
            frame.pts, frame.time_base = round(float(time) / base), base
            container.mux(stream.encode(frame))
        container.mux(stream.encode(None))
    return path


def film(path: Path, codec: tuple[str, str, dict[str, str]] = LOSSLESS, **changes: object) -> Picture:
    """Write the film of a picture with these changes, and return the picture."""
    picture = replace(Picture(), **changes)
    write_film(path, picture.frames(), picture.times, codec)
    return picture
