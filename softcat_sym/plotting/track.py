"""A tracked film: its midpoint over time, frames with the edges that were found, tables."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from numpy.typing import NDArray
from PIL import Image
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report
from softcat_sym.plotting import style
from softcat_sym.plotting.terminal import TextTable
from softcat_sym.plotting.time_axis import TimeAxis
from softcat_sym.plotting.units import length_unit
from softcat_sym.tracking.edges import UnreadableFrameError
from softcat_sym.tracking.film import Frame, pyav
from softcat_sym.tracking.result import Track
from softcat_sym.tracking.strand import Measured, measure

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
def track_figure(track: Track) -> Figure:
    """Draw midpoint and thickness with their standard errors over time, and the frames that were refused."""
    with style.styled():
        below = f"{track.number.size} frames read, {len(track.refused)} refused · {track.codec}"
        figure, body = style.sheet(track.film.path.name, below, height=4.6, notes="\n".join(track.warnings))
        above, under = body.subplots(2, 1, height_ratios=[2.2, 1])
        axis = TimeAxis.of(track.time)
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
            refused = axis.unit.of([one.time - track.release for one in track.refused])
            marks = axes.plot(refused, np.zeros_like(refused), "|", color=style.VERMILLION, markersize=9, clip_on=False,
                              transform=axes.get_xaxis_transform())  # fmt: skip
            marks[0].set_in_layout(False)
            axis.dress(axes, label=axis.label if axes is under else "")
    return figure


def model_figure(track: Track, run: Run) -> Figure:
    """Draw the last frame with the edges found in it, and the midline of a run of the fitted filament at its time."""
    number, data = int(track.number[-1]), run.data
    time, height = data["time"].to_numpy(), data["y"].to_numpy()

    def model(when: float, x: Floats) -> Floats:
        later = int(np.clip(np.searchsorted(time, when), 1, time.size - 1))
        share = float(np.clip((when - time[later - 1]) / (time[later] - time[later - 1]), 0, 1))
        place, y = ((1 - share) * one[later - 1] + share * one[later] for one in (data["x"].to_numpy(), height))
        return np.asarray(np.interp(x, place - (place[0] + place[-1]) / 2, y))

    picture = overlays(track, [number], model)[number]
    with style.styled():
        below = f"frame {number}, {track.time[-1]:.4g} s after the release: edges, midline, and in purple the model"
        tall = style.WIDTH * picture.shape[0] / picture.shape[1]
        figure, body = style.sheet(track.film.path.name, below, height=tall)
        axes = body.subplots()
        axes.imshow(picture)
        axes.set_axis_off()
    return figure


@drawing.report.register(Track)
def track_report(track: Track, table: str = "track.csv", points: int = 0, *, overlay: bool = False) -> Report:
    """Tables, pictures and, if asked for, a film of all frames with their edges."""
    seen = np.flatnonzero(np.isfinite(track.midpoint))
    shown = {"first": seen[0], "middle": seen[seen.size // 2], "last": seen[-1],
             "worst": seen[track.misfit[seen].argmax()]}  # fmt: skip
    pictures = overlays(track, {int(track.number[place]) for place in shown.values()})
    refused = pd.DataFrame(
        [(one.number, one.time - track.release, one.reason) for one in track.refused],
        columns=["frame_number", "time_s", "reason"],
    )
    files: dict[str, object] = {
        table: track.to_csv(points),
        "refused.csv": refused,
        "track.json": track.to_dict,
        "track.png": partial(track_figure, track),
        **{f"overlay-{name}.png": _png(pictures[int(track.number[place])]) for name, place in shown.items()},
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
    table = TextTable(("", ""), rows).printed(track.film.path.name)
    return [table, *(Text(f"warning: {text}", style="yellow") for text in track.warnings)]


def overlays(
    track: Track, numbers: Iterable[int], model: Callable[[float, Floats], Floats] | None = None
) -> dict[int, NDArray[np.uint8]]:
    """Frames with the edges found in them, and perhaps a model's midline: by their numbers, shape (rows, columns, 3).

    Parameters
    ----------
    track : Track
        Whose film is read again.
    numbers : iterable of int
        Of the frames.
    model : callable, optional
        Heights [m] at a time [s] and at places [m] from halfway between the supports.
    """
    wanted = set(numbers)
    found = dict[int, NDArray[np.uint8]]()
    for frame in track.film:
        if frame.number in wanted:
            found[frame.number] = _painted(track, frame, model)
        if len(found) == len(wanted):
            break
    return found


def _painted(track: Track, frame: Frame, model: Callable[[float, Floats], Floats] | None = None) -> NDArray[np.uint8]:
    """One frame, enlarged, with its curves."""
    camera, rows, columns = track.camera, *frame.grey.shape
    factor = max(1, round(_WIDE / columns))
    grey = frame.grey * (255 / 65535 if frame.grey.max() > 255 else 1)
    picture = np.repeat(np.repeat(np.rint(grey).astype(np.uint8), factor, axis=0), factor, axis=1)
    painted = np.repeat(picture[:, :, None], 3, axis=2)

    def paint(x: Floats, y: Floats, colour: NDArray[np.uint8], size: int = 2) -> None:
        for right in range(-(size // 2), size - size // 2):
            for down in range(-(size // 2), size - size // 2):
                # The centre of the first pixel is at half of the factor.
                column = np.rint((x + 0.5) * factor - 0.5).astype(int) + right
                row = np.rint((y + 0.5) * factor - 0.5).astype(int) + down
                inside = (column >= 0) & (column < columns * factor) & (row >= 0) & (row < rows * factor)
                painted[row[inside], column[inside]] = colour

    level = np.arange(0, rows, 0.5 / factor)
    for edge in (camera.supports.left, camera.supports.right):
        at = edge - np.tan(camera.tilt) * (level - camera.centre[1])
        paint(at[:: 4 * factor], level[:: 4 * factor], _SUPPORT)
    try:
        measured = measure(camera, frame.grey)
    except UnreadableFrameError:
        return painted
    _paint_strand(track, measured, paint, factor)
    if model is not None:
        half = track.span / 2
        x = np.linspace(-half, half, 2 * columns * factor)
        paint(*camera.to_picture(x / track.pixel, model(frame.time - track.release, x) / track.pixel), _MODEL)
    return painted


def _paint_strand(track: Track, measured: Measured, paint: Callable[..., None], factor: int) -> None:
    x = np.arange(measured.x[0], measured.x[-1], 0.3 / factor)
    y, half = measured.height(x), measured.thickness(x) / 2
    slope = np.gradient(y, x)
    normal = np.stack([-slope, np.ones_like(x)]) / np.hypot(slope, 1)
    for side in (-1, 1):
        paint(*track.camera.to_picture(x + side * half * normal[0], y + side * half * normal[1]), _EDGE)
    paint(*track.camera.to_picture(x, y), _MIDLINE)
    bad = ~measured.fitted.kept
    paint(*track.camera.to_picture(measured.x[bad], measured.y[bad]), _REJECTED, 3)


def _png(picture: NDArray[np.uint8]) -> bytes:
    stream = BytesIO()
    Image.fromarray(picture).save(stream, "png", optimize=True)
    return stream.getvalue()


def _film(track: Track) -> bytes:
    """All frames with their edges, as MP4 at the rate of the film."""
    av, stream = pyav(), BytesIO()
    rate = round(1 / float(np.median(np.diff(track.time)))) or 1
    with av.open(stream, "w", format="mp4") as container:
        video = container.add_stream(
            "libx264" if "libx264" in av.codecs_available else "mpeg4", rate=min(max(rate, 1), 60)
        )
        for number, picture in enumerate(_even(map(partial(_painted, track), track.film))):
            if number == 0:
                video.height, video.width, video.pix_fmt = *picture.shape[:2], "yuv420p"
            container.mux(video.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        container.mux(video.encode(None))
    return stream.getvalue()


def _even(pictures: Iterable[NDArray[np.uint8]]) -> Iterator[NDArray[np.uint8]]:
    """Pictures of even numbers of rows and columns, as H.264 has them."""
    for picture in pictures:
        rows, columns = (size - size % 2 for size in picture.shape[:2])
        yield np.ascontiguousarray(picture[:rows, :columns])
