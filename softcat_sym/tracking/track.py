"""A film tracked: light, supports and scale from its first frame, then edges in every frame, then errors over time.

A frame is read, measured and forgotten; what stays of it are some forty numbers.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import SoftcatError
from softcat_sym.scene.units import NotAQuantity, to_si
from softcat_sym.tracking.edges import Cuts, UnreadableFrameError, cut, midline
from softcat_sym.tracking.film import Codec, Film, Frame, Picture, Region
from softcat_sym.tracking.light import light_of, threshold
from softcat_sym.tracking.over_time import REPEATED, UNSEEN, onset, refusals, release_of, time_factor
from softcat_sym.tracking.result import MAX_POINTS, Camera, RefusedFrame, Track
from softcat_sym.tracking.splines import Curve, curve
from softcat_sym.tracking.supports import Supports, find_supports, width_of

if TYPE_CHECKING:
    from softcat_sym.progress import Display

Floats = NDArray[np.float64]

_PIECES, _THICKNESS_PIECES = 16, 4
_BLOCKY = 0.02
"""Scatter of the cuts' edges at least, from which on one is an outlier: a codec repeats blocks exactly [px]."""
_STRAIGHT = 0.3
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
_RESOLVED = 2.5
"""Thickness in blur widths below which blur and thickness cannot be told apart."""
_BLUR = 1.1
"""First guess of the blur width [px]."""
_WINDOW = 0.1
"""Thickness of a bright part within a strand, over that of the dark part, from which on there may be two strands."""
_SMALLEST = 48
"""Rows and columns that a picture has at least."""
SCALES = "span=LENGTH, pixel=LENGTH, or needle@x0,x1,y0,y1=LENGTH, such as 'span=50 mm'"


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


def measure(camera: Camera, grey: Picture, *, width: float | None = None, free: bool = False) -> Measured:
    """Measure the strand in one frame; `free` blur widths for the first guess `width`.

    Raises
    ------
    UnreadableFrameError
        With the reason for which the frame is refused.
    """
    signal = camera.light.signal(grey)
    left, right = camera.supports.left, camera.supports.right
    coarse = midline(signal, camera.level, left, right)
    cuts = cut(signal, coarse, left, right, camera.width if width is None else width, free=free)
    x, y = camera.to_world(cuts.x, cuts.y)
    order = np.argsort(x)
    x, y = x[order], y[order]
    height = curve(x, y, _PIECES, 1 / cuts.variance[order], rounding=_BLOCKY)
    thickness = curve(x, cuts.thickness[order], _THICKNESS_PIECES, rounding=_BLOCKY)
    if height.kept.mean() < 0.5:
        raise UnreadableFrameError(f"{height.kept.mean():.0%} of the cuts agree with a smooth strand")
    return Measured(cuts, x, y, height, thickness, cuts.width, coarse.window)


def track(
    film: str | os.PathLike[str],
    scale: str,
    *,
    region: Sequence[int] | None = None,
    supports: tuple[float, float] | None = None,
    release: str | float | None = None,
    fps: float | None = None,
    dark: bool | None = None,
    vertical: bool = False,
    every: int = 1,
    flatten: bool = True,
    progress: Display | None = None,
) -> Track:
    """Track a strand between two supports through a film.

    Each edge is a step blurred by the lens, fitted on cuts along the normal of the strand's midline with one blur width
    for the film; smooth curves through the cuts give midpoint, thickness and shape, with standard errors from the
    residuals, from their correlation along the strand and from the scatter over time.

    Parameters
    ----------
    film : path
        A film, a TIFF stack, or a folder of pictures in the order of their names.
    scale : str
        ``"span=50 mm"`` (the distance of the supports), ``"pixel=20 um"``, or ``"needle@x0,x1,y0,y1=1.2 mm"`` (the
        width of a bar in a region of the first frame: a needle, a ruler).
    region : sequence of int, optional
        Columns and rows x0, x1, y0, y1 of the part of the picture to read.
    supports : (float, float), optional
        Columns of the supports' edges, in the region; found by default.
    release : str or float, optional
        Number of the frame of the release, or its time with a unit, ``"0.35 s"``; found by default, to half a frame.
    fps : float, optional
        Frames a second [1/s]; by default the times of the file. Pictures need it.
    dark : bool, optional
        Whether the strand is darker than the background; found by default.
    vertical : bool
        Whether the strand hangs: the picture is turned by 90 degrees.
    every : int
        Read every so many frames.
    flatten : bool
        Whether to take uneven light out.
    progress : Display, optional
        Receiver of progress reports.

    Returns
    -------
    Track
        Midpoint, thickness and shapes with standard errors, and the frames that were refused.

    Raises
    ------
    SoftcatError
        If there is no film, no scale, no strand or no support, or if fewer than five frames can be read.
    """
    if every < 1 or (fps is not None and not fps > 0):
        raise SoftcatError(f"every = {every}, fps = {fps}: accepted: a whole number from 1 on, and a positive one")
    ruler = _ruler(scale)
    source = Film(Path(film), fps, None if region is None else _region(region), vertical)
    look = _first_look(source, supports, dark, ruler, flatten=flatten)
    readings, refused = _readings(source, look, every, progress)
    std = np.hypot(readings.height_std, look.floor)
    rate = readings.change / np.diff(readings.time, prepend=readings.time[0] - 1.0)
    reasons = refusals(rate, readings.rms, readings.height, std, is_predicted=look.is_predicted)
    refused += [RefusedFrame(int(readings.number[k]), float(readings.time[k]), text, text == REPEATED)
                for k, text in reasons.items()]  # fmt: skip
    # Of a strand whose middle is not seen the shape is.
    kept = np.array([reasons.get(k, UNSEEN) == UNSEEN for k in range(readings.number.size)])
    _check_count(source, int(np.isfinite(readings.height[kept]).sum()), refused)
    refused.sort(key=lambda one: one.number)
    return _with_errors(source, look, readings.part(kept), tuple(refused), release)


@dataclass(frozen=True)
class _Ruler:
    """What gives the length of a pixel."""

    length: float  # [m]
    of: str  # span, pixel or needle
    region: Region | None = None  # of the needle


def _ruler(text: str) -> _Ruler:
    name, equals, length = (part.strip() for part in text.partition("="))
    kind, _, where = name.partition("@")
    try:
        if not equals or kind not in ("span", "pixel", "needle") or bool(where) != (kind == "needle"):
            raise NotAQuantity(f"scale {text!r}")
        if not to_si(length, "length") > 0:
            raise NotAQuantity(f"{length} is not positive")
        return _Ruler(to_si(length, "length"), kind, _region(where.split(",")) if where else None)
    except NotAQuantity as error:
        raise SoftcatError(f"scale: {error}; accepted: {SCALES}") from None


def _region(numbers: Sequence[object]) -> Region:
    try:
        x0, x1, y0, y1 = (int(str(number)) for number in numbers)
    except ValueError:
        raise SoftcatError(f"region {','.join(map(str, numbers))}: accepted: columns and rows x0,x1,y0,y1") from None
    return x0, x1, y0, y1


@dataclass(frozen=True, eq=False)
class _Look:
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
        return _STARVED_FLOOR if self.bits_per_pixel < _STARVED else _PREDICTED_FLOOR


def _first_look(
    source: Film, supports: tuple[float, float] | None, dark: bool | None, ruler: _Ruler, *, flatten: bool
) -> _Look:
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
    return _Look(camera, pixel, pixel_std, count, codec, codec.bits / (count * size), predicted > 0, window)


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
    if float(np.std(row - middle - slope * x)) < _STRAIGHT:
        return float(middle), float(slope)
    ends = []
    for side in (-1, 1):
        near = side * x > 0.75 * half
        ends.append(float(np.polyval(np.polyfit(x[near], row[near], 2), side * half)) if near.sum() > 5 else middle)
    return (ends[0] + ends[1]) / 2, (ends[1] - ends[0]) / (2 * half)


def _pixel(camera: Camera, frame: Frame, ruler: _Ruler) -> tuple[float, float]:
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


@dataclass(frozen=True, eq=False)
class _Readings:
    """What stays of n frames, in pixels."""

    number: NDArray[np.int64]
    time: Floats  # [s]
    change: Floats  # to the frame before [grey level]
    rms: Floats
    line: Floats  # shape (n, 2); height in the middle and slope of a straight strand; NaN of a curved one
    height: Floats  # of the midpoint
    height_std: Floats
    thickness: Floats
    thickness_std: Floats
    shapes: Floats  # shape (n, points)
    shapes_std: Floats
    shapes_thickness: Floats

    def part(self, kept: NDArray[np.bool_]) -> _Readings:
        """Some of the frames."""
        return _Readings(*(getattr(self, one.name)[kept] for one in fields(self)))


def _readings(source: Film, look: _Look, every: int, progress: Display | None) -> tuple[_Readings, list[RefusedFrame]]:
    """Measure every frame."""
    rows, refused = list[tuple[object, ...]](), list[RefusedFrame]()
    before: Picture | None = None
    for frame in source:
        if frame.number % every:
            continue
        if progress is not None:
            progress.reach(frame.number / look.frames, f"frame {frame.number} of {look.frames}")
        small = frame.grey[::2, ::2]
        change = np.inf if before is None else float(np.mean(np.abs(small - before)))
        before = small.copy()
        try:
            measured = measure(look.camera, frame.grey)
        except UnreadableFrameError as error:
            refused.append(RefusedFrame(frame.number, frame.time, str(error)))
            continue
        rows.append((frame.number, frame.time, change, measured.cuts.rms, *_numbers(look.camera, measured)))
    _check_count(source, len(rows), refused)
    return _Readings(*(np.array(column) for column in zip(*rows, strict=True))), refused


def _numbers(camera: Camera, measured: Measured) -> tuple[object, ...]:
    """Numbers of one frame, in the order of :class:`_Readings`."""
    reach = (camera.supports.right - camera.supports.left) / 2
    x, place = measured.x, _places(camera)
    slope, middle = np.polyfit(x, measured.y, 1)
    is_straight = float(np.std((measured.y - middle - slope * x)[measured.fitted.kept])) < _STRAIGHT
    shown = x[measured.fitted.kept]
    seen = np.array([np.sum(np.abs(shown - one) < max(0.04 * reach, 6.0)) >= 4 for one in (0.0, *place)])
    at = np.array([0.0, *place])
    values = [measured.height(at), measured.fitted.std(at), measured.thickness(at), measured.thickness.std(at)]
    height, height_std, thickness, thickness_std = (np.where(seen, one, np.nan) for one in values)
    # The middle of an asymmetric strand is where x is zero.
    line = (middle, slope) if is_straight else (np.nan, np.nan)
    return (line, height[0], height_std[0], thickness[0], thickness_std[0], height[1:], height_std[1:], thickness[1:])


def _places(camera: Camera) -> Floats:
    """Places of the points of shapes [px]; those at the supports are known."""
    half = (camera.supports.right - camera.supports.left) / 2
    return np.linspace(-half, half, MAX_POINTS + 2)[1:-1]


def _check_count(source: Film, count: int, refused: Sequence[RefusedFrame]) -> None:
    if count >= 5:
        return
    reasons = "; ".join(dict.fromkeys(one.reason for one in refused)) or "the film is too short"
    raise SoftcatError(f"film {source.path}: {count} of {count + len(refused)} frames read ({reasons}); accepted: at "
                       "least five frames with one strand from support to support")  # fmt: skip


def _with_errors(
    source: Film, look: _Look, readings: _Readings, refused: tuple[RefusedFrame, ...], release: str | float | None
) -> Track:
    """Errors over time, zero, release and units."""
    camera, pixel = look.camera, look.pixel
    seen = np.isfinite(readings.height)
    factors = (1.0, 1.0)
    if seen.sum() >= 5:
        time = readings.time[seen]
        factors = (time_factor(time, readings.height[seen], readings.height_std[seen]),
                   time_factor(time, readings.thickness[seen], readings.thickness_std[seen]))  # fmt: skip
    std = np.hypot(factors[0] * readings.height_std, look.floor)
    thickness_std = np.hypot(factors[1] * readings.thickness_std, look.floor)
    when, when_std = _release(release, readings.time, readings.number, readings.height, std)
    # The level from all frames at rest, instead of from the first one.
    rest = (readings.time < when) & np.isfinite(readings.line[:, 0])
    zero, slope = readings.line[rest].mean(axis=0) if rest.any() else (0.0, 0.0)
    camera = replace(camera, centre=(camera.centre[0], camera.centre[1] - float(zero)), tilt=camera.tilt - float(slope))
    shapes = readings.shapes - zero - slope * _places(camera)
    is_thin = np.nanmedian(readings.thickness) < _RESOLVED * camera.width
    thickness = np.where(is_thin, np.nan, readings.thickness)
    seen = np.isfinite(readings.height)
    first = onset(readings.height[seen], std[seen])
    found = _warnings(look, is_thin=bool(is_thin), is_late=first == 0, is_still=first == seen.sum())
    return Track(
        source, camera, pixel, look.pixel_std, readings.number, readings.time - when,
        pixel * (readings.height - zero), pixel * std, pixel * thickness, pixel * thickness_std,
        pixel * _places(camera), pixel * shapes, pixel * np.hypot(factors[0] * readings.shapes_std, look.floor),
        pixel * np.where(is_thin, np.nan, readings.shapes_thickness), when, when_std,
        readings.rms / np.median(readings.rms), refused, look.codec.name, look.bits_per_pixel, factors, found,
    )  # fmt: skip


def _warnings(look: _Look, *, is_thin: bool, is_late: bool, is_still: bool) -> tuple[str, ...]:
    found = []
    if look.floor == _STARVED_FLOOR:
        found.append(
            f"{look.bits_per_pixel:.2g} bits a pixel and frame: slow motion is late by up to {_STARVED_FLOOR} px; film "
            "as MJPEG, all-intra, or H.264 with crf 15 or less"
        )
    if is_thin:
        found.append(f"thinner than {_RESOLVED} blur widths of {look.camera.width:.2f} px: no thickness; come closer")
    if is_still:
        found.append("nothing moves")
    if look.window > _WINDOW:
        found.append(
            "light falls through the strand: what is between both outer edges is taken for one strand, not two"
        )
    if is_late:
        found.append("the film begins with the strand in motion: its first frame is taken for the release")
    if look.camera.supports.left_std >= 0.5:
        found.append("the supports' edges are known to half a pixel only")
    return tuple(found)


def _release(
    given: str | float | None, time: Floats, number: NDArray[np.int64], height: Floats, std: Floats
) -> tuple[float, float]:
    """Time of the release by the film's clock, and its standard error [s]."""
    if given is None:
        seen = np.isfinite(height)
        return release_of(time[seen], height[seen], std[seen])
    frame = float(np.median(np.diff(time)))
    try:
        try:
            when, error = float(np.interp(float(given), number, time, left=np.nan, right=np.nan)), 0.5 * frame
        except ValueError:
            when, error = to_si(given, "time"), 0.0
        if not time[0] <= when <= time[-1]:
            raise NotAQuantity(f"{given} is not within the film")
    except NotAQuantity as fault:
        raise SoftcatError(f"release: {fault}; accepted: the number of a frame, or a time such as '0.35 s'") from None
    return when, error
