"""What the first frame of a film tells: light, supports, level, scale; and its first pass: blur width and codec."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import SoftcatError
from softcat_sym.scene.units import NotAQuantity, to_si
from softcat_sym.tracking.edges import UnreadableFrameError
from softcat_sym.tracking.film import Codec, Film, Frame, Picture, Region
from softcat_sym.tracking.light import light_of, threshold
from softcat_sym.tracking.strand import Camera, measure
from softcat_sym.tracking.supports import Supports, find_supports, width_of

Floats = NDArray[np.float64]

STRAIGHT = 0.3
"""Largest rms of a strand about a line that is at rest between its supports [px]."""
_FLOOR, _LOSSY_FLOOR, _PREDICTED_FLOOR, _STARVED_FLOOR = 0.003, 0.006, 0.1, 0.3
"""Smallest standard errors [px]: of exact frames, compressed ones, predicted ones, and of these at a low bit rate.

What a codec leaves out may be the same all along the strand, and if it predicts for many frames, so that no residual
shows it.
"""
_STARVED = 0.02
"""Bits a pixel and frame below which predicted frames follow slow motion late."""
_VISIBLE, _FAINTEST = 4.0, 0.02
"""Contrast of a strand over the noise of the background, and over its brightness, at least."""
_BLUR = 1.1
"""First guess of the blur width [px]."""
_SMALLEST = 48
"""Rows and columns that a picture has at least."""
SCALES = "span=LENGTH, pixel=LENGTH, or needle@x0,x1,y0,y1=LENGTH, such as 'span=50 mm'"


@dataclass(frozen=True)
class Ruler:
    """What gives the length of a pixel."""

    length: float  # [m]
    of: str  # span, pixel or needle
    region: Region | None = None  # of the needle


def read_ruler(text: str) -> Ruler:
    """Read what gives the scale; see `SCALES`."""
    name, equals, length = (part.strip() for part in text.partition("="))
    kind, _, where = name.partition("@")
    try:
        if not equals or kind not in ("span", "pixel", "needle") or bool(where) != (kind == "needle"):
            raise NotAQuantity(f"scale {text!r}")
        if not to_si(length, "length") > 0:
            raise NotAQuantity(f"{length} is not positive")
        return Ruler(to_si(length, "length"), kind, read_region(where.split(",")) if where else None)
    except NotAQuantity as error:
        raise SoftcatError(f"scale: {error}; accepted: {SCALES}") from None


def read_region(numbers: Sequence[object]) -> Region:
    """Read columns and rows of a part of a picture."""
    try:
        x0, x1, y0, y1 = (int(str(number)) for number in numbers)
    except ValueError:
        raise SoftcatError(f"region {','.join(map(str, numbers))}: accepted: columns and rows x0,x1,y0,y1") from None
    return x0, x1, y0, y1


@dataclass(frozen=True, eq=False)
class Calibration:
    """What the first pass over a film finds."""

    camera: Camera
    pixel: float  # [m]
    pixel_std: float
    frames: int
    codec: Codec
    bits_per_pixel: float
    is_predicted: bool
    window: float  # thickness of a bright part within the strand, over that of the dark part

    @property
    def floor(self) -> float:
        """Smallest standard error [px]."""
        if not self.is_predicted:
            return _FLOOR if self.codec.is_lossless else _LOSSY_FLOOR
        return _STARVED_FLOOR if self.is_starved else _PREDICTED_FLOOR

    @property
    def is_starved(self) -> bool:
        """Whether frames are predicted from so few bits that slow motion is late."""
        return self.is_predicted and self.bits_per_pixel < _STARVED


def calibrate(
    source: Film, supports: tuple[float, float] | None, dark: bool | None, ruler: Ruler, *, flatten: bool
) -> Calibration:
    """Light, supports and scale from the first frame, the blur width from frames 1, 2, 4, 8 and so on."""
    camera: Camera | None = None
    widths, window, count, predicted, size, pixel, pixel_std = list[float](), 0.0, 0, 0, 1, 0.0, 0.0
    for frame in source:
        if camera is None:
            camera = _camera(source, frame, supports, dark, flatten=flatten)
            pixel, pixel_std = _pixel(camera, frame, ruler)
            size = frame.grey.size
        # At powers of two, as nobody knows yet how long the film is; cuts go as far as the width asks.
        for _ in range(0 if frame.number & (frame.number - 1) else 2 if not widths else 1):
            with suppress(UnreadableFrameError):
                measured = measure(camera, frame.grey, free=True)
                widths.append(measured.cuts.width)
                window = max(window, measured.window)
                camera = replace(camera, width=float(np.median(widths[len(widths) > 1 :])))
        count += 1
        predicted += frame.is_predicted
    if camera is None:
        raise SoftcatError(f"film {source.path}: no frame in it; accepted: a film of at least five frames")
    if count == 1:
        raise SoftcatError(f"film {source.path}: one frame; accepted: a film of at least five")
    codec = source.codec()
    return Calibration(camera, pixel, pixel_std, count, codec, codec.bits / (count * size), predicted > 0, window)


def _camera(
    source: Film, frame: Frame, supports: tuple[float, float] | None, dark: bool | None, *, flatten: bool
) -> Camera:
    rows, columns = frame.grey.shape
    if rows < _SMALLEST or columns < _SMALLEST:
        raise SoftcatError(
            f"film {source.path}: {columns} x {rows} pixels; accepted: at least {_SMALLEST} in both directions"
        )
    light = light_of(frame.grey, dark, flat=flatten)
    signal = light.signal(frame.grey)
    if supports is None:
        level = 0.45 * _contrast(signal)
        edges = find_supports(signal, level, _BLUR)
    else:
        left, right = supports
        if not 0 <= left < right <= columns - 1 or right - left < 20:
            raise SoftcatError(f"supports {left:g},{right:g}: accepted: two columns x0 < x1 of the picture, 0 to "
                               f"{columns - 1}, at least 20 apart")  # fmt: skip
        edges = Supports(float(left), float(right), 0.5, 0.5)
        level = 0.45 * _contrast(signal[:, int(left) : int(right) + 1])
    centre, tilt = ((edges.left + edges.right) / 2, 0.0), 0.0
    camera = Camera(light, level, _BLUR, edges, centre, tilt)
    try:
        first = measure(camera, frame.grey)
    except UnreadableFrameError as error:
        raise SoftcatError(f"film {source.path}: first frame: {error}; accepted: one strand from support to support; "
                           "--roi leaves out what else is in the picture, --dark or --light name the strand, "
                           "--vertical turns a hanging one") from None  # fmt: skip
    row, slope = _level(first.x, -first.y, edges)
    centre = ((edges.left + edges.right) / 2, row)
    return replace(camera, centre=centre, tilt=float(np.arctan(slope)), level=0.45 * first.cuts.height)


def _contrast(signal: Picture) -> float:
    """Brightness of the strand: median of what is above Otsu's threshold."""
    is_strand = signal > threshold(signal)
    strand, rest = signal[is_strand], signal[~is_strand]
    is_seen = min(strand.size, rest.size) > 1
    if not is_seen or strand.mean() - rest.mean() < max(_VISIBLE * float(rest.std()), _FAINTEST):
        raise SoftcatError("no strand stands out from the noise of the rest; accepted: one that is darker or lighter "
                           "than what is behind it")  # fmt: skip
    return float(np.median(strand))


def _level(x: Floats, row: Floats, edges: Supports) -> tuple[float, float]:
    """Row and slope of the line between the supports, through a straight strand or through the ends of a curved one.

    x is counted from halfway between the supports.
    """
    half = (edges.right - edges.left) / 2
    slope, middle = np.polyfit(x, row, 1)
    if float(np.std(row - middle - slope * x)) < STRAIGHT:
        return float(middle), float(slope)
    ends = []
    for side in (-1, 1):
        near = side * x > 0.75 * half
        ends.append(float(np.polyval(np.polyfit(x[near], row[near], 2), side * half)) if near.sum() > 5 else middle)
    return (ends[0] + ends[1]) / 2, (ends[1] - ends[0]) / (2 * half)


def _pixel(camera: Camera, frame: Frame, ruler: Ruler) -> tuple[float, float]:
    """Length of a pixel, and its standard error [m]."""
    edges = camera.supports
    if ruler.of == "pixel":
        return ruler.length, 0.0
    if ruler.of == "span":
        across, std = (edges.right - edges.left) / np.cos(camera.tilt), np.hypot(edges.left_std, edges.right_std)
    else:
        x0, x1, y0, y1 = ruler.region or (0, 0, 0, 0)
        rows, columns = frame.grey.shape
        if not (0 <= x0 < x1 <= columns and 0 <= y0 < y1 <= rows):
            raise SoftcatError(f"needle@{x0},{x1},{y0},{y1} is outside of the picture of {columns} x {rows} pixels")
        across, std = width_of(camera.light.signal(frame.grey), (x0, x1, y0, y1), camera.level, camera.width)
    return ruler.length / across, ruler.length * float(std) / across**2
