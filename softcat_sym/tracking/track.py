"""A film tracked: light, supports and scale from its first frame, then edges in every frame, then errors over time.

A frame is read, measured and forgotten; what stays of it are some forty numbers.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import SoftcatError
from softcat_sym.scene.units import NotAQuantity, to_si
from softcat_sym.tracking.calibration import STRAIGHT, Calibration, Ruler, calibrate, read_region
from softcat_sym.tracking.film import Film
from softcat_sym.tracking.over_time import UNSEEN, onset, refusals, release_of, time_factor
from softcat_sym.tracking.result import MAX_POINTS, RefusedFrame, Track
from softcat_sym.tracking.strand import Camera, Strand, UnreadableFrameError, measure

if TYPE_CHECKING:
    from softcat_sym.progress import Display

Floats = NDArray[np.float64]

_RESOLVED = 2.5
"""Thickness in blur widths below which blur and thickness cannot be told apart."""
_WINDOW = 0.1
"""Thickness of a bright part within a strand, over that of the dark part, from which on there may be two strands."""


def track(
    film: str | os.PathLike[str],
    scale: str,
    *,
    region: Sequence[object] | None = None,
    supports: Sequence[object] | None = None,
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
    region : sequence of four int, optional
        Columns and rows x0, x1, y0, y1 of the part of the picture to read.
    supports : sequence of two float, optional
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
    ruler = Ruler.read(scale)
    source = Film(Path(film), fps, None if region is None else read_region(region), vertical)
    setup = calibrate(source, supports, dark, ruler, flatten=flatten)
    readings, refused = _readings(source, setup, every, progress)
    height, std = readings.values[:, :2, MAX_POINTS // 2].T
    rate = readings.change / np.diff(readings.time, prepend=readings.time[0] - 1.0)
    reasons = refusals(rate, readings.rms, height, np.hypot(std, setup.floor), is_predicted=setup.is_predicted)
    refused += [RefusedFrame(int(readings.number[k]), float(readings.time[k]), why) for k, why in reasons.items()]
    # Of a strand whose middle is not seen the shape is.
    kept = np.array([reasons.get(k, UNSEEN) == UNSEEN for k in range(height.size)])
    _check_count(source, int(np.isfinite(height[kept]).sum()), refused)
    return _with_errors(source, setup, _Readings(*(one[kept] for one in readings)), tuple(sorted(refused)), release)


class _Readings(NamedTuple):
    """What stays of n frames, in pixels."""

    number: NDArray[np.int64]
    time: Floats  # [s]
    change: Floats  # to the frame before [grey level]
    rms: Floats
    line: Floats  # shape (n, 2); slope, and height in the middle, of a straight strand; NaN of a curved one
    values: Floats  # shape (n, 4, points); height, its standard error, thickness, its standard error


def _readings(
    source: Film, setup: Calibration, every: int, progress: Display | None
) -> tuple[_Readings, list[RefusedFrame]]:
    """Measure every frame."""
    rows, refused, before = list[tuple[object, ...]](), list[RefusedFrame](), None
    for frame in source:
        if frame.number % every:
            continue
        if progress is not None:
            progress.reach(frame.number / setup.frames, f"frame {frame.number} of {setup.frames}")
        small = frame.grey[::2, ::2].copy()
        change = np.inf if before is None else float(np.mean(np.abs(small - before)))
        before = small
        try:
            strand = measure(setup.camera, setup.camera.light.signal(frame.grey))
        except UnreadableFrameError as error:
            refused.append(RefusedFrame(frame.number, frame.time, str(error)))
            continue
        rows.append((frame.number, frame.time, change, strand.rms, *_line_and_values(strand, setup.camera)))
    _check_count(source, len(rows), refused)
    return _Readings(*(np.array(column) for column in zip(*rows, strict=True))), refused


def _line_and_values(strand: Strand, camera: Camera) -> tuple[Floats, Floats]:
    """Of one frame, as in :class:`_Readings`."""
    line, shown, at = np.polyfit(strand.x, strand.y, 1), strand.x[strand.line.kept], _places(camera)
    is_straight = np.std((strand.y - np.polyval(line, strand.x))[strand.line.kept]) < STRAIGHT
    near = np.abs(shown - at[:, None]) < max(0.02 * np.ptp(camera.supports), 6.0)
    values = strand.height(at), strand.line.std(at), strand.thickness(at), strand.apart.std(at)
    return np.where(is_straight, line, np.nan), np.where(near.sum(axis=1) >= 4, values, np.nan)


def _places(camera: Camera) -> Floats:
    """Places of the points of shapes [px], the midpoint among them; those at the supports are known."""
    return np.asarray(np.ptp(camera.supports) * (np.arange(1, MAX_POINTS + 1) / (MAX_POINTS + 1) - 0.5))


def _check_count(source: Film, count: int, refused: Sequence[RefusedFrame]) -> None:
    if count >= 5:
        return
    reasons = "; ".join(dict.fromkeys(one.reason for one in refused)) or "the film is too short"
    raise SoftcatError(f"film {source.path}: {count} of {count + len(refused)} frames read ({reasons}); accepted: at "
                       "least five frames with one strand from support to support")  # fmt: skip


def _with_errors(
    source: Film,
    setup: Calibration,
    readings: _Readings,
    refused: tuple[RefusedFrame, ...],
    release: str | float | None,
) -> Track:
    """Errors over time, zero, release and units."""
    pixel, middle, time = setup.pixel, MAX_POINTS // 2, readings.time
    height, std, thickness, thickness_std = readings.values.transpose(1, 0, 2).copy()
    seen = np.isfinite(height[:, middle])
    factors = (time_factor(time[seen], height[seen, middle], std[seen, middle]),
               time_factor(time[seen], thickness[seen, middle], thickness_std[seen, middle]))  # fmt: skip
    std = np.hypot(factors[0] * std, setup.floor)
    thickness_std = np.hypot(factors[1] * thickness_std, setup.floor)
    first = onset(height[seen, middle], std[seen, middle])
    when, when_std = _release(release, readings.number, time, height[:, middle], std[:, middle])
    # The level from all frames at rest, instead of from the first one.
    rest = (time < when) & np.isfinite(readings.line[:, 0])
    slope, zero = readings.line[rest].mean(axis=0) if rest.any() else (0.0, 0.0)
    camera = replace(setup.camera, row=setup.camera.row - float(zero), tilt=setup.camera.tilt - float(slope))
    height -= zero + slope * _places(camera)
    is_thin = bool(np.nanmedian(thickness[:, middle]) < _RESOLVED * camera.width)
    if is_thin:
        thickness[:] = np.nan
    found = _warnings(setup, is_thin=is_thin, is_late=first == 0, is_still=first == seen.sum())
    return Track(
        source, camera, pixel, setup.pixel_std, readings.number, time - when,
        pixel * height[:, middle], pixel * std[:, middle], pixel * thickness[:, middle],
        pixel * thickness_std[:, middle], pixel * _places(camera), pixel * height, pixel * std, pixel * thickness,
        when, when_std, readings.rms / np.median(readings.rms), refused, setup.codec.name, setup.bits_per_pixel,
        factors, found,
    )  # fmt: skip


def _warnings(setup: Calibration, *, is_thin: bool, is_late: bool, is_still: bool) -> tuple[str, ...]:
    width = setup.camera.width
    found = {
        f"{setup.bits_per_pixel:.2g} bits a pixel and frame: slow motion is late by up to {setup.floor} px; film as "
        "MJPEG, all-intra, or H.264 with crf 15 or less": setup.is_starved,
        f"thinner than {_RESOLVED} blur widths of {width:.2f} px: no thickness; come closer": is_thin,
        "light falls through the strand: what is between both outer edges is taken for one strand, not two": (
            setup.window > _WINDOW
        ),
        "nothing moves": is_still,
        "the film begins with the strand in motion: its first frame is taken for the release": is_late,
        "the supports' edges are known to half a pixel only": max(setup.camera.supports_std) >= 0.5,
    }
    return tuple(text for text, holds in found.items() if holds)


def _release(
    given: str | float | None, number: NDArray[np.int64], time: Floats, height: Floats, std: Floats
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
