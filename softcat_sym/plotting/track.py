"""A tracked film: its midpoint over time, frames with the edges that were found, tables."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from functools import partial
from io import BytesIO
from itertools import takewhile
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from numpy.typing import NDArray
from PIL import Image
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report, TextTable
from softcat_sym.plotting import style
from softcat_sym.plotting.files import mp4
from softcat_sym.plotting.style import styled
from softcat_sym.plotting.time_axis import TimeAxis
from softcat_sym.plotting.units import length_unit
from softcat_sym.tracking.contour import PillarContour
from softcat_sym.tracking.film import Picture
from softcat_sym.tracking.result import Track
from softcat_sym.tracking.strand import Camera, Strand, UnreadableFrameError, measure

if TYPE_CHECKING:
    from softcat_sym.results.run import Run

Floats = NDArray[np.float64]

_EDGE, _MIDLINE, _REJECTED, _SUPPORT, _MODEL = (
    np.frombuffer(bytes.fromhex(one[1:]), np.uint8)
    for one in (style.SKY, style.ORANGE, style.VERMILLION, style.GREEN, style.PURPLE)
)
_WIDE = 1280
"""Columns that a frame is enlarged to at least, by a whole factor."""


@drawing.plot.register(Track)
@styled()
def track_figure(track: Track) -> Figure:
    """Draw midpoint and thickness with their standard errors over time, and the frames that were refused."""
    below = f"{track.number.size} frames read, {len(track.refused)} refused · {track.codec}"
    figure, body = style.sheet(track.film.path.name, below, height=4.6, notes="\n".join(track.warnings))
    above, under = body.subplots(2, 1, height_ratios=[2.2, 1])
    axis = TimeAxis.of(track.time)
    refused = axis.unit.of([one.time - track.release for one in track.refused])
    for axes, values, std, name in (
        (above, track.midpoint, track.midpoint_std, "midpoint height"),
        (under, track.thickness, track.thickness_std, "thickness"),
    ):
        seen = np.isfinite(values)
        ruler = length_unit(float(np.abs(values[seen]).max()) if seen.any() else 1e-3)
        look: dict[str, Any] = {"color": style.BLACK, "markersize": 3, "elinewidth": 0.7, "linestyle": ""}
        time = axis.unit.of(track.time[seen])
        axes.errorbar(time, ruler.of(values[seen]), yerr=1.96 * ruler.of(std[seen]), fmt=".", **look)
        axes.set_ylabel(f"{name} [{ruler.symbol}]")
        axes.grid(True)
        edge: dict[str, Any] = {"transform": axes.get_xaxis_transform(), "markersize": 9, "clip_on": False}
        (marks,) = axes.plot(refused, np.zeros_like(refused), "|", color=style.VERMILLION, **edge)
        marks.set_in_layout(False)
        axis.dress(axes, label=axis.label if axes is under else "")
    above.tick_params(labelbottom=False)
    return figure


@styled()
def model_figure(track: Track, run: Run) -> Figure:
    """Draw the last frame with the edges found in it, and the midline of a run of the fitted filament at its time."""
    number, end = int(track.number[-1]), run.data["time"][-1]
    now = run.data[["x", "y"]].interp(time=min(max(track.time[-1], 0.0), float(end)))
    x, y = now["x"].to_numpy() / track.pixel, now["y"].to_numpy() / track.pixel
    fine = np.linspace(x[0], x[-1], 2 * _WIDE)
    canvas = _canvases(track, {number})[number]
    canvas.paint(*track.camera.to_picture(fine - (x[0] + x[-1]) / 2, np.interp(fine, x, y)), _MODEL)
    below = f"frame {number}, {track.time[-1]:.4g} s after the release: edges, midline, and in purple the model"
    rows, columns, _ = canvas.picture.shape
    figure, body = style.sheet(track.film.path.name, below, height=style.WIDTH * rows / columns)
    axes = body.subplots()
    axes.imshow(canvas.picture)
    axes.set_axis_off()
    return figure


@drawing.report.register(Track)
def track_report(track: Track, table: str = "track.csv", points: int = 0, *, overlay: bool = False) -> Report:
    """Tables, pictures and, if asked for, a film of all frames with their edges."""
    seen = np.flatnonzero(np.isfinite(track.midpoint))
    shown = {"first": seen[0], "middle": seen[seen.size // 2], "last": seen[-1],
             "worst": seen[track.misfit[seen].argmax()]}  # fmt: skip
    pictures = _canvases(track, {int(track.number[place]) for place in shown.values()})
    refused = pd.DataFrame(track.refused, columns=["frame_number", "time_s", "reason"])
    refused["time_s"] -= track.release
    files: dict[str, object] = {
        table: track.to_csv(points),
        "refused.csv": refused,
        "track.json": track.to_dict,
        "track.png": partial(track_figure, track),
        **{f"overlay-{name}.png": pictures[int(track.number[place])].png() for name, place in shown.items()},
        "overlay.mp4": partial(_film, track) if overlay else None,
    }
    return Report(files, _texts(track), stale=() if overlay else ("overlay.mp4",))


def _texts(track: Track) -> list[Any]:
    ruler = length_unit(track.span)
    thick = track.thickness[np.isfinite(track.thickness)]
    rows = [
        ("frames", f"{track.number.size} read, {len(track.refused)} refused"),
        ("span", ruler.text(track.span)),
        ("pixel", f"{1e6 * track.pixel:.5g} ± {1e6 * track.pixel_std:.1g} µm"),
        ("tilt", f"{np.degrees(track.camera.tilt):.2f}°, taken out"),
        ("sag", f"{ruler.text(-float(np.nanmin(track.midpoint)))} at most, "
                f"± {1e6 * float(np.nanmedian(track.midpoint_std)):.2g} µm"),
        ("thickness", f"{ruler.text(thick[0])} to {ruler.text(thick.min())}" if thick.size else "not resolved"),
        ("release", f"{track.release:.5g} ± {track.release_std:.2g} s of the film"),
    ]  # fmt: skip
    reasons = pd.Series([one.reason for one in track.refused], dtype=str).value_counts()
    rows += [("refused", f"{count}: {reason}") for reason, count in reasons.items()]
    table = TextTable(("", ""), rows, title=track.film.path.name)
    return [table, *(Text(f"warning: {text}", style="yellow") for text in track.warnings)]


def _canvases(track: Track, numbers: set[int]) -> dict[int, _Canvas]:
    """Some frames of the film, read again."""
    frames = takewhile(lambda frame: frame.number <= max(numbers), track.film)
    return {one.number: _Canvas(one.grey, [track.camera]) for one in frames if one.number in numbers}


class _Canvas:
    """One frame, enlarged, with supports, edges, midline and rejected cuts of the strand that each camera sees."""

    def __init__(self, grey: Picture, cameras: Iterable[Camera]) -> None:
        self.factor = max(1, round(_WIDE / grey.shape[1]))
        level = np.rint(grey * (255 / 65535 if grey.max() > 255 else 1)).astype(np.uint8)
        self.picture = np.repeat(np.kron(level, np.ones((self.factor, self.factor), np.uint8))[:, :, None], 3, axis=2)
        for camera in cameras:
            row = np.arange(0, grey.shape[0], 2.0)
            for edge in camera.supports:
                self.paint(edge - np.tan(camera.tilt) * (row - camera.row), row, _SUPPORT)
            with suppress(UnreadableFrameError):
                self._paint_strand(camera, measure(camera, camera.light.signal(grey)))

    def _paint_strand(self, camera: Camera, strand: Strand) -> None:
        x = np.arange(strand.x[0], strand.x[-1], 0.3 / self.factor)
        y, half = strand.height(x), strand.thickness(x) / 2
        slope = np.gradient(y, x)
        normal = np.stack([-slope, np.ones_like(x)]) / np.hypot(slope, 1)
        for side in (-1, 1):
            self.paint(*camera.to_picture(x + side * half * normal[0], y + side * half * normal[1]), _EDGE)
        self.paint(*camera.to_picture(x, y), _MIDLINE)
        bad = ~strand.line.kept
        self.paint(*camera.to_picture(strand.x[bad], strand.y[bad]), _REJECTED, 3)

    def paint(self, x: Floats, y: Floats, colour: NDArray[np.uint8], size: int = 2) -> None:
        """Paint squares at columns and rows of the frame."""
        # The centre of the first pixel is at half of the factor.
        column, row = (np.rint((one + 0.5) * self.factor - 0.5).astype(int) for one in (x, y))
        for shift in np.ndindex(size, size):
            down, right = row + shift[0] - size // 2, column + shift[1] - size // 2
            inside = (right >= 0) & (right < self.picture.shape[1]) & (down >= 0) & (down < self.picture.shape[0])
            self.picture[down[inside], right[inside]] = colour

    def png(self) -> bytes:
        """The picture as a file."""
        stream = BytesIO()
        Image.fromarray(self.picture).save(stream, "png", optimize=True)
        return stream.getvalue()


@drawing.report.register(PillarContour)
def contour_report(found: PillarContour, table: str = "contour.csv") -> Report:
    """The table of a contour, and the picture with the edges found in it."""
    picture = _Canvas(next(iter(found.film)).grey, found.cameras).png()
    rows = [(f"gap {number}", length_unit(right - left).text(right - left))
            for number, (left, right) in enumerate(found.gaps, start=1)]  # fmt: skip
    shown: list[Any] = [TextTable(("", ""), rows, title=found.film.path.name)]
    shown += [Text(f"warning: left out {text}", style="yellow") for text in found.refused]
    return Report({table: found.to_csv(), "overlay-contour.png": picture}, shown)


def _film(track: Track) -> bytes:
    """All frames with their edges, as MP4 at the rate of the film."""
    rate = round(1 / float(np.median(np.diff(track.time))))
    pictures = (_Canvas(frame.grey, [track.camera]).picture for frame in track.film)
    return mp4(pictures, min(max(rate, 1), 60))
