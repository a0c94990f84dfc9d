"""What the first frame of a film tells: light, supports, level, scale; and its first pass: blur width and codec."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.scene.units import NotAQuantity, to_si
from softcat_sym.tracking.film import Codec, Film, Frame, Picture, Region, part_of
from softcat_sym.tracking.light import Light, threshold
from softcat_sym.tracking.strand import Camera, Strand, UnreadableFrameError, measure
from softcat_sym.tracking.supports import find_gaps

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
_LEVEL = 0.45
"""Share of the contrast above which a pixel is the strand's."""
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

    @classmethod
    def read(cls, text: str) -> Ruler:
        """Read what gives the scale; see `SCALES`."""
        name, equals, length = (part.strip() for part in text.partition("="))
        kind, _, where = name.partition("@")
        try:
            if not equals or kind not in ("span", "pixel", "needle") or bool(where) != (kind == "needle"):
                raise NotAQuantity(f"scale {text!r}")
            if not to_si(length, "length") > 0:
                raise NotAQuantity(f"{length} is not positive")
            return cls(to_si(length, "length"), kind, read_region(where.split(",")) if where else None)
        except NotAQuantity as error:
            raise SoftcatError(f"scale: {error}; accepted: {SCALES}") from None

    def pixel(self, camera: Camera, grey: Picture) -> tuple[float, float]:
        """Length of a pixel, and its standard error [m]."""
        if self.of == "pixel":
            return self.length, 0.0
        across, std = camera.span, float(np.hypot(*camera.supports_std))
        if self.region is not None:
            across, std = _width_of(part_of(camera.light.signal(grey), self.region, "needle"), camera, self.region)
        return self.length / across, self.length * std / across**2


def read_region(numbers: Sequence[object]) -> Region:
    """Read columns and rows of a part of a picture."""
    x0, x1, y0, y1 = (int(one) for one in read_numbers("region", numbers, "0,640,100,400"))
    return x0, x1, y0, y1


def read_numbers(name: str, numbers: Sequence[object], example: str) -> list[float]:
    """Read as many numbers as there are in an example."""
    with suppress(ValueError, OverflowError):
        found = [float(str(one)) for one in numbers]
        if len(found) == example.count(",") + 1 and np.isfinite(found).all():
            return found
    raise SoftcatError(f"{name} {','.join(map(str, numbers))}: accepted: numbers such as {example}")


def _width_of(part: Picture, camera: Camera, region: Region) -> tuple[float, float]:
    """Width of a straight bar in a part of a picture, such as a needle, and its standard error [px]."""
    is_strand = part > camera.level
    # The bar is a strand; one that stands is turned.
    if is_strand.any(axis=1).mean() > is_strand.any(axis=0).mean():
        part = part.T
    try:
        bar = measure(replace(camera, supports=(-2.0, part.shape[1] + 1.0), tilt=0.0), part, free=True)
    except (UnreadableFrameError, ValueError):
        x0, x1, y0, y1 = region
        raise SoftcatError(f"no bar across the region {x0},{x1},{y0},{y1}: both of its edges, and nothing else, belong "
                           "in it") from None  # fmt: skip
    at = np.linspace(bar.x[0], bar.x[-1], 20)
    # Of a bar that is not equally wide everywhere it is not known where the width was measured.
    return float(bar.thickness(at).mean()), float(np.hypot(bar.apart.std(at).mean(), bar.thickness(at).std()))


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
    def is_starved(self) -> bool:
        """Whether frames are predicted from so few bits that slow motion is late."""
        return self.is_predicted and self.bits_per_pixel < _STARVED

    @property
    def floor(self) -> float:
        """Smallest standard error [px]."""
        if not self.is_predicted:
            return _FLOOR if self.codec.is_lossless else _LOSSY_FLOOR
        return _STARVED_FLOOR if self.is_starved else _PREDICTED_FLOOR


def calibrate(
    source: Film, supports: Sequence[object] | None, dark: bool | None, ruler: Ruler, *, flatten: bool
) -> Calibration:
    """Light, supports and scale from the first frame, the blur width from frames 1, 2, 4, 8 and so on."""
    strands, predicted, first = list[Strand](), list[bool](), next(iter(source), None)
    if first is None:
        raise SoftcatError(f"film {source.path}: no frame in it; accepted: a film of at least five frames")
    camera = _camera(source, first, supports, dark, flatten=flatten)
    pixel, pixel_std = ruler.pixel(camera, first.grey)
    for frame in source:
        # At powers of two, as nobody knows yet how long the film is; cuts go as far as the width asks.
        for _ in range(0 if frame.number & (frame.number - 1) else 1 if strands else 2):
            with suppress(UnreadableFrameError):
                strands.append(measure(camera, camera.light.signal(frame.grey), free=True))
                widths = [one.blur for one in strands]
                camera = replace(camera, width=float(np.median(widths[len(widths) > 1 :])))
        predicted.append(frame.is_predicted)
    if len(predicted) == 1:
        raise SoftcatError(f"film {source.path}: one frame; accepted: a film of at least five")
    codec = source.codec()
    return Calibration(camera, pixel, pixel_std, len(predicted), codec, codec.bits / (len(predicted) * first.grey.size),
                       any(predicted), max((one.window for one in strands), default=0.0))  # fmt: skip


def _level_of(signal: Picture) -> float:
    """Brightness above which a pixel is the strand's, from the median of what is above Otsu's threshold."""
    is_strand = signal > threshold(signal)
    strand, rest = signal[is_strand], signal[~is_strand]
    is_seen = min(strand.size, rest.size) > 1
    if not is_seen or strand.mean() - rest.mean() < max(_VISIBLE * float(rest.std()), _FAINTEST):
        raise SoftcatError("no strand stands out from the noise of the rest; accepted: one that is darker or lighter "
                           "than what is behind it")  # fmt: skip
    return _LEVEL * float(np.median(strand))


def cameras_of_gaps(
    source: Film, frame: Frame, dark: bool | None, supports: Sequence[object] | None = None, *, flatten: bool
) -> list[Camera]:
    """How each gap is seen that a strand crosses in one frame, from left to right, or the one between given supports.

    Row and tilt are not found yet.
    """
    rows, columns = frame.grey.shape
    if min(rows, columns) < _SMALLEST:
        raise SoftcatError(
            f"film {source.path}: {columns} x {rows} pixels; accepted: at least {_SMALLEST} in both directions"
        )
    light = Light.of(frame.grey, dark, flat=flatten)
    signal = light.signal(frame.grey)
    if supports is None:
        level = _level_of(signal)
        return [Camera(light, level, _BLUR, *gap) for gap in find_gaps(signal, level, _BLUR)]
    left, right = read_numbers("supports", supports, "35,285")
    if not 0 <= left < right <= columns - 1 or right - left < 20:
        raise SoftcatError(f"supports {left:g},{right:g}: accepted: two columns x0 < x1 of the picture, 0 to "
                           f"{columns - 1}, at least 20 apart")  # fmt: skip
    return [Camera(light, _level_of(signal[:, int(left) : int(right) + 1]), _BLUR, (left, right))]


def _camera(
    source: Film, frame: Frame, supports: Sequence[object] | None, dark: bool | None, *, flatten: bool
) -> Camera:
    """How the strand is seen that crosses the picture's middle, in the first frame."""
    middle, cameras = frame.grey.shape[1] / 2, cameras_of_gaps(source, frame, dark, supports, flatten=flatten)
    near = [one for one in cameras if supports is not None or one.supports[0] < middle < one.supports[1]]
    if not near:
        raise SoftcatError(
            "no support found to the left or to the right of the picture's middle: give the columns of both edges "
            "by --supports x0,x1; --vertical is for a strand that hangs"
        )
    (camera,) = near
    try:
        first = measure(camera, camera.light.signal(frame.grey))
    except UnreadableFrameError as error:
        raise SoftcatError(f"film {source.path}: first frame: {error}; accepted: one strand from support to support; "
                           "--roi leaves out what else is in the picture, --dark or --light name the strand, "
                           "--vertical turns a hanging one") from None  # fmt: skip
    height, slope = _rest_line(first, camera.span / 2)
    return replace(camera, row=-height, tilt=-float(np.arctan(slope)), level=_LEVEL * first.contrast)


def _rest_line(strand: Strand, half: float) -> tuple[float, float]:
    """Height and slope of the line between the supports: through a straight strand, or the ends of a curved one."""
    x, y = strand.x, strand.y
    slope, middle = np.polyfit(x, y, 1)
    if float(np.std(y - middle - slope * x)) < STRAIGHT:
        return float(middle), float(slope)
    ends = []
    for side in (-1, 1):
        near = side * x > 0.75 * half
        ends.append(float(np.polyval(np.polyfit(x[near], y[near], 2), side * half)) if near.sum() > 5 else middle)
    return sum(ends) / 2, (ends[1] - ends[0]) / (2 * half)
