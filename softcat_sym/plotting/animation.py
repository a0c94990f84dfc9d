"""A film of a run: the filament with its stress and what yields, a clock, its midpoint's trace; as GIF or MP4."""

from __future__ import annotations

import shutil
import subprocess
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize, to_rgb
from matplotlib.patches import Patch, PathPatch, Polygon
from matplotlib.path import Path as Outline
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from mpl_toolkits.mplot3d.axes3d import Axes3D

from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically
from softcat_sym.plotting import style
from softcat_sym.plotting.run import Sheet, yielded_label
from softcat_sym.plotting.section import (
    FilamentOutline,
    Floats,
    Magnification,
    array,
    largest_sag,
    outline,
    quads_outside,
    section_at,
    yielding_of,
)
from softcat_sym.plotting.spatial import draw_tube, frame_tube, tube
from softcat_sym.plotting.style import Fields, axes_in_inches, new_figure, stamp
from softcat_sym.plotting.units import length_unit, significant, stress_unit, time_unit

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from PIL.Image import Image as Picture

    from softcat_sym.plotting.units import Summary, Unit
    from softcat_sym.scene.scene import Scene

STRIPS = 8
"""Through the thickness."""

_ZETA = np.linspace(-1.0, 1.0, STRIPS + 1)
_AMID = 0.5 * (_ZETA[1:] + _ZETA[:-1])

_FIELDS = ("x", "y", "thickness", "stress_mean", "stress_bending")


def moments_of(data: Fields, scene: Scene, count: int) -> dict[str, Floats]:
    """Fields of a run at so many equally spaced times, linear between frames."""
    time, yields = array(data, "time"), yielding_of(data, scene)
    times = np.linspace(time[0], time[-1], max(1, count))
    fields = {name: array(data, name) for name in _FIELDS} | {"low": yields.low, "high": yields.high}
    found = {"time": times, "X_node": array(data, "X_node"), "X_cell": array(data, "X_cell")}
    if time.size == 1:
        return found | {name: np.repeat(values, times.size, axis=0) for name, values in fields.items()}
    before = np.clip(np.searchsorted(time, times) - 1, 0, time.size - 2)
    part = (times - time[before]) / (time[before + 1] - time[before])
    for name, values in fields.items():
        share = part.reshape(-1, *(1,) * (values.ndim - 1))
        found[name] = (1 - share) * values[before] + share * values[before + 1]
    return found


KINDS: Final = {"gif": 12.5, "mp4": 25.0}
"""Kinds of film, and their pictures a second; a GIF counts in hundredths of a second, and 8 of them are a picture."""

LONGEST: Final = 120.0
"""Of a film [s]: what is longer would fill the memory, and nobody would watch it."""

_HOLD_MS: Final = 1200
"""How long a GIF rests on its last picture before it begins again."""

_FRAMES_COLOURS: Final = 128
"""Of a GIF; it then holds pictures without dots, and less of them."""

_PAPER: Final = 247
"""Colours of a GIF that are as light as this are the paper's."""


@dataclass(frozen=True, slots=True)
class FilmOrder:
    """A film that was asked for, and can be made here."""

    name: str  # Of the file
    kind: str  # ``gif`` or ``mp4``
    seconds: float  # Its length [s]
    ffmpeg: str = ""  # The program, of an MP4

    @property
    def pictures(self) -> int:
        """How many it shows."""
        return max(2, round(self.seconds * KINDS[self.kind]))


def film_order(asked: str, seconds: float) -> FilmOrder:
    """Read what was asked for, before anything is computed."""
    name = asked if "." in asked else f"film.{asked}"
    kind = Path(name).suffix[1:].lower()
    if kind not in KINDS or Path(name).name != name or not Path(name).stem.strip("."):
        raise SoftcatError(
            f"--animate: {asked!r} is no film; accepted: gif, mp4, or a file name that ends so, such as film.gif; "
            "it goes into DIR"
        )
    if not 0 < seconds <= LONGEST:
        raise SoftcatError(f"--animate-seconds: {seconds:g} s; accepted: more than 0 and at most {LONGEST:g} s")
    return FilmOrder(name, kind, seconds, _ffmpeg() if kind == "mp4" else "")


def _ffmpeg() -> str:
    """The program on the path, or the one that the package imageio-ffmpeg brings along."""
    found = shutil.which("ffmpeg")
    if found:
        return found
    try:
        import imageio_ffmpeg

        return str(imageio_ffmpeg.get_ffmpeg_exe())
    except (ImportError, RuntimeError):
        raise SoftcatError(
            "--animate: an MP4 needs ffmpeg, and there is none: install it (Debian: apt install ffmpeg), or "
            "pip install 'softcat_sym[movies]'; a GIF needs nothing else"
        ) from None


def write_film(
    order: FilmOrder,
    directory: Path,
    run: tuple[Fields, Summary, Scene],
    step: Callable[[str], None] = lambda what: None,
    width: int = 1280,
) -> tuple[Path, str]:
    """Draw a film and write it, whole or not at all."""
    animation = animation_of(*run, order.pictures, width)

    def fill(path: Path) -> None:
        if order.kind == "gif":
            _gif(animation, path, step)
        else:
            _mp4(animation, path, order.ffmpeg, step)

    return fill_atomically(directory / order.name, fill), animation.note


class Pictures(ABC):
    """Moments of a run, drawn in one figure with a clock and the midpoint's trace.

    Attributes
    ----------
    figure : Figure
        What every moment is drawn in.
    times : ndarray
        The moments [s].
    note : str
        What they cannot show.
    """

    def __init__(self, sheet: Sheet, times: Floats, height: float, width: int) -> None:
        self._sheet, self.times, self.note = sheet, times, film_note(times, sheet.data, sheet.summary)
        self.figure = new_figure(WIDTH, height)
        self.figure.set_dpi(width / WIDTH)

    def __len__(self) -> int:
        return self.times.size

    @abstractmethod
    def picture(self, number: int) -> NDArray[np.uint8]:
        """Draw one moment, shape (height, width, 3)."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height [pixel], both even, as video wants them."""
        width, height = self.figure.canvas.get_width_height()
        return width - width % 2, height - height % 2

    def pixels(self) -> NDArray[np.uint8]:
        """What is drawn, shape (height, width, 3)."""
        canvas: Any = self.figure.canvas
        width, height = self.size
        drawn: NDArray[np.uint8] = np.asarray(canvas.buffer_rgba())[:height, :width, :3].copy()
        return drawn

    def head(self) -> Any:
        """Title, how the run ended, what the film cannot show, and the clock, which moves."""
        height, left, right = self.figure.get_figheight(), _LEFT / WIDTH, 1 - _RIGHT / WIDTH
        title, summary = style.printable(self._sheet.scene.title, 70) or "Filament", self._sheet.summary
        ending = style.printable(" · ".join(str(summary[key]) for key in ("regime", "outcome") if summary.get(key)), 90)
        place: dict[str, Any] = {"y": 1 - 0.14 / height, "va": "top"}
        below: dict[str, Any] = {"y": 1 - 0.45 / height, "va": "top"}
        self.figure.text(left, s=title, fontsize=16, fontweight="bold", parse_math=False, **place)
        self.figure.text(left, s=ending, fontsize=_FONT, color=style.GREY, **below)
        self.figure.text(right, s=self.note, ha="right", fontsize=0.85 * _FONT, color=style.VERMILLION, **below)
        self._now = self.figure.text(right, s="", ha="right", fontsize=16, **place)
        return self._now

    def trace(self, ruler: Unit, width: float) -> tuple[Any, ...]:
        """The midpoint against time: all of it in grey, what has passed in blue."""
        axes = axes_in_inches(self.figure, _LEFT, _BOTTOM, width, _TRACE)
        time, height = self._sheet.curves("midpoint")
        self._curve = time, ruler.of(height[:, 0])
        axes.plot(*self._curve, color="#d0d4d8", linewidth=1.6)
        _plain(axes, 7, 4)
        self._sheet.axis.dress(axes, 7)
        axes.set_xlabel(self._sheet.axis.label, fontsize=_FONT)
        axes.set_ylabel(f"midpoint [{ruler.symbol}]", fontsize=_FONT)
        axes.margins(y=0.12)
        (self._past,) = axes.plot([], [], color=style.BLUE, linewidth=2.2)
        (self._dot,) = axes.plot([], [], "o", color=style.BLUE, ms=8, markeredgecolor="white", clip_on=False)
        return self._past, self._dot

    def go_to(self, number: int) -> None:
        """Move the clock and the trace to a moment."""
        clock, now = self._sheet.clock, float(self._sheet.axis.unit.of(self.times[number]))
        time, height = self._curve
        end, here = int(np.searchsorted(time, now, side="right")), float(np.interp(now, time, height))
        self._past.set_data(np.append(time[:end], now), np.append(height[:end], here))
        self._dot.set_data([now], [here])
        largest = float(clock.of(self.times[-1]))
        decimals = 3 if largest < 10 else 2 if largest < 100 else 1
        self._now.set_text(f"t = {clock.of(self.times[number]):.{decimals}f} {clock.symbol}")


def animation_of(data: Fields, summary: Summary, scene: Scene, moments: int, width: int) -> Pictures:
    """The film of a run in its plane, or in space."""
    kind = SpatialAnimation if "quaternion" in data else Animation
    return kind(data, summary, scene, moments, width)


def _gif(animation: Pictures, path: Path, step: Callable[[str], None]) -> None:
    """All pictures with the colours of a few of them, so that what does not move is the same number in all."""
    from PIL import Image

    few = np.concatenate([animation.picture(k) for k in np.unique(np.linspace(0, len(animation) - 1, 5).astype(int))])
    palette = Image.fromarray(few).quantize(_FRAMES_COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    # The mean of what is nearly white is not white.
    colours = np.reshape(palette.getpalette() or [], (-1, 3))
    colours[colours.min(axis=1) >= _PAPER] = 255
    palette.putpalette(colours.ravel().tolist())

    def painted(number: int) -> Picture:
        step(f"picture {number + 1} of {len(animation)}")
        return Image.fromarray(animation.picture(number)).quantize(palette=palette, dither=Image.Dither.NONE)

    pause = round(1000 / KINDS["gif"])
    pauses = [pause] * (len(animation) - 1) + [_HOLD_MS]
    first, rest = painted(0), (painted(number) for number in range(1, len(animation)))
    with path.open("xb") as stream:
        first.save(stream, format="GIF", save_all=True, append_images=rest, duration=pauses, loop=0, optimize=False)


def _mp4(animation: Pictures, path: Path, ffmpeg: str, step: Callable[[str], None]) -> None:
    """Hand raw pictures to ffmpeg; H.264 that every player shows."""
    width, height = animation.size
    taken = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", f"{KINDS['mp4']:g}", "-i", "-"]
    made = ["-an", "-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart", str(path)]
    command = [ffmpeg, "-loglevel", "error", "-nostdin", "-y", *taken, *made]
    # A group of its own: Ctrl-C is ours to handle.
    pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE}
    with subprocess.Popen(command, start_new_session=True, **pipes) as process:
        ours, theirs = cast("IO[bytes]", process.stdin), cast("IO[bytes]", process.stderr)
        try:
            for number, picture in enumerate(map(animation.picture, range(len(animation)))):
                step(f"picture {number + 1} of {len(animation)}")
                ours.write(picture.tobytes())
            _, said = process.communicate()
        except BrokenPipeError:
            said = theirs.read()
            process.wait()
        except BaseException:
            process.kill()
            raise
    if process.returncode != 0:
        reason = " ".join(said.decode(errors="replace").split())[-300:] or f"exit status {process.returncode}"
        raise SoftcatError(f"--animate: ffmpeg could not write the film: {reason}")


WIDTH, DPI = 12.8, 100
"""Of a film [inch, pixel per inch]: 1280 pixels."""

_LEFT, _RIGHT, _TOP, _TRACE, _BOTTOM, _BETWEEN = 0.95, 0.35, 0.75, 1.5, 0.6, 0.75
_TALLEST, _LOWEST = 3.6, 1.3
_FONT = 12.0
_COLOURS = "YlGnBu"
"""From pale to dark, so that the colour-blind read it too, and what is hatched is seen on all of it."""

_FEWEST, _PICTURES = 2.5, 4.0
"""Pictures a period: fewer than the first show a slower swing that is not there; the second show it well."""

_HATCHED: Final[dict[str, Any]] = {
    "facecolor": (*to_rgb(style.VERMILLION), 0.15),
    "edgecolor": style.VERMILLION,
    "linewidth": 0.0,
    "hatch": "////",
}
_DASHED: Final[dict[str, Any]] = {"facecolor": "none", "edgecolor": style.GREY, "linestyle": (0, (4, 3))}


class Animation(Pictures):
    """Draws one moment after another; only what moves is drawn anew."""

    def __init__(
        self, data: Fields, summary: Summary, scene: Scene, moments: int, width: int = int(WIDTH * DPI)
    ) -> None:
        sheet = Sheet.of(data, summary, scene, style.SCREEN)
        self._scene, film = scene, moments_of(sheet.data, scene, moments)
        larger = Magnification.of(largest_sag(film["y"]), scene.filament.thickness, scene.filament.span)
        self.film = larger.drawn(film)
        outlines = np.stack([outline(self._section(k)) for k in range(len(film["time"]))])
        low, high = outlines.min(axis=(0, 1)), outlines.max(axis=(0, 1))
        self._largest = float(np.quantile([self._stress(k) for k in range(len(outlines))], 0.995))
        self._ruler = length_unit(float(np.abs([low, high]).max()), scene.filament.span)
        self._over = scene.material.yield_stress or stress_unit(self._largest).size
        # The largest scale at which every moment fits; what it leaves free is shared by both sides.
        across = WIDTH - _LEFT - _RIGHT
        extent = 1.04 * (high - low) + np.array([0.0, 0.7 * scene.filament.thickness * larger.thickness / larger.sag])
        scale = min(across / extent[0], _TALLEST / (larger.sag * extent[1]))
        tall = max(_LOWEST, scale * larger.sag * extent[1])
        half = np.array([across / scale, tall / (scale * larger.sag)]) / 2
        with style.styled():
            super().__init__(sheet, film["time"], _BOTTOM + _TRACE + _BETWEEN + tall + _TOP, width)
            self.axes = axes_in_inches(self.figure, _LEFT, _BOTTOM + _TRACE + _BETWEEN, across, tall)
            limits = self._ruler.of(np.array([-half, half]) + (low + high) / 2).T
            self.axes.set(xlim=limits[0], ylim=limits[1])
            _plain(self.axes, 9, max(2, int(tall / 0.45)))
            scaled = f" ({larger})" if str(larger) else ""
            self.axes.set_xlabel(f"x [{self._ruler.symbol}]{scaled}", fontsize=_FONT)
            self.axes.set_ylabel(f"y [{self._ruler.symbol}]", fontsize=_FONT)
            moving = [*self._filament(), *self.trace(self._ruler, 0.6 * across), self.head()]
            self._moving = [*moving, *stamp(self.figure, sheet.summary)]
            for artist in self._moving:
                artist.set_animated(True)
            self._legend(yielded_label(sheet.data, scene), is_linear_part="core_low" in sheet.data)
            self._background: Any = None

    def _section(self, number: int) -> FilamentOutline:
        ends = self._scene.ends
        return section_at(self.film, number, [one.holds_angle for one in ends.supports])

    def _stress(self, number: int) -> Floats:
        """Magnitude of the axial stress amid every strip of every cell [Pa]."""
        mean, slope = self.film["stress_mean"][number], self.film["stress_bending"][number]
        return np.asarray(np.abs(mean + np.multiply.outer(_AMID, slope)).ravel())

    def picture(self, number: int) -> NDArray[np.uint8]:
        """Draw one moment, shape (height, width, 3)."""
        canvas: Any = self.figure.canvas
        with style.styled():
            if self._background is None:
                canvas.draw()  # without what moves: that is marked as animated
                self._background = canvas.copy_from_bbox(self.figure.bbox)
            canvas.restore_region(self._background)
            self._show(number)
            for artist in self._moving:
                self.figure.draw_artist(artist)
        return self.pixels()

    def _show(self, number: int) -> None:
        """Move everything to where it is at a moment."""
        ruler, film, section = self._ruler, self.film, self._section(number)
        grid = ruler.of([section.at(float(zeta)) for zeta in _ZETA])
        strips = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], axis=2).reshape(-1, 4, 2)
        self._body.set_verts(list(strips))
        self._body.set_array(self._stress(number) / self._over)
        self._edge.set_xy(ruler.of(outline(section)))
        yielded = quads_outside(section, film["low"][number], film["high"][number])
        self._yielded.set_path(Outline.make_compound_path_from_polys(ruler.of(yielded)))
        self._yielded.set_visible(bool(len(yielded)))
        self.go_to(number)

    def _filament(self) -> tuple[Any, ...]:
        """Body coloured by stress, hatched where it yields, its edge; behind it the shape it started from."""
        start = self._ruler.of(outline(self._section(0)))
        self.axes.fill(*start.T, linewidth=0.8, **_DASHED)
        norm = Normalize(0.0, self._largest / self._over or 1.0)
        self._body = PolyCollection([], cmap=_COLOURS, norm=norm, edgecolors="none", antialiaseds=False)
        self.axes.add_collection(self._body, autolim=False)
        self._yielded = PathPatch(Outline(start), **_HATCHED)
        self._edge = Polygon(start, facecolor="none", edgecolor=style.BLACK, linewidth=0.9)
        self.axes.add_artist(self._yielded)
        self.axes.add_artist(self._edge)
        return self._body, self._yielded, self._edge

    def _legend(self, label: str, *, is_linear_part: bool) -> None:
        """The colour bar of the stress, and what hatching and dashes mean."""
        left = _LEFT + 0.67 * (WIDTH - _LEFT - _RIGHT)
        bar = axes_in_inches(self.figure, left, _BOTTOM + _TRACE - 0.2, WIDTH - _RIGHT - left, 0.18)
        # Of a section resolved fibre by fibre, this is the linear stress nearest to what its fibres bear.
        what = "linear part of the axial stress" if is_linear_part else "axial stress"
        limit = self._scene.material.yield_stress
        unit = f" [{stress_unit(self._largest).symbol}]" if limit is None else " / yield stress"
        drawn = self.figure.colorbar(self._body, cax=bar, orientation="horizontal")
        drawn.set_label(f"{what}{unit}", fontsize=_FONT)
        bar.tick_params(labelsize=10.5)
        handles = [Patch(label="start", **_DASHED)]
        if limit is not None:
            handles.insert(0, Patch(label=label.replace(", ", ",\n"), **_HATCHED))
        anchor = (left / WIDTH, (_BOTTOM - 0.25) / self.figure.get_figheight())
        self.figure.legend(handles=handles, loc="lower left", bbox_to_anchor=anchor, borderaxespad=0.0, fontsize=_FONT)


_SPATIAL_HEIGHT = 8.0
"""Of a film in space [inch]."""


class SpatialAnimation(Pictures):
    """Draws one moment of a filament in space after another, with a clock and the height of its midpoint."""

    def __init__(self, data: Fields, summary: Summary, scene: Scene, moments: int, width: int) -> None:
        sheet = Sheet.of(data, summary, scene, style.SCREEN)
        times = np.linspace(sheet.time[0], sheet.time[-1], moments)
        nearest = np.abs(sheet.time[:, None] - times).argmin(axis=0)
        tubes = {frame: tube(sheet.data, scene, frame, 1.0) for frame in np.unique(nearest).tolist()}
        corners = np.concatenate([one.reshape(-1, 3) for one in tubes.values()])
        low, high = corners.min(axis=0), corners.max(axis=0)
        ruler = length_unit(float(np.abs(corners).max()), scene.filament.span)
        self._shapes = [ruler.of(tubes[frame]) for frame in nearest.tolist()]
        with style.styled():
            super().__init__(sheet, times, _SPATIAL_HEIGHT, width)
            self.axes: Axes3D = self.figure.add_axes((0.0, 0.27, 1.0, 0.66), projection="3d")
            frame_tube(self.axes, ruler.of(low), ruler.of(high), ruler.symbol)
            self.head()
            self.trace(ruler, WIDTH - _LEFT - _RIGHT)
            stamp(self.figure, sheet.summary)
        self._body: Poly3DCollection | None = None

    def picture(self, number: int) -> NDArray[np.uint8]:
        """Draw one moment, shape (height, width, 3)."""
        canvas: Any = self.figure.canvas
        with style.styled():
            if self._body is not None:
                self._body.remove()
            self._body = draw_tube(self.axes, self._shapes[number])
            self.go_to(number)
            canvas.draw()
        return self.pixels()


def film_note(moments: Floats, data: Fields, summary: Summary) -> str:
    """What a film cannot show of a run that rings; empty where it shows all."""
    per_period, time = summary.get("frames_a_period"), array(data, "time")
    if not per_period or moments.size < 2 or not time[-1] > time[0]:
        return ""
    period = per_period * float(time[-1] - time[0]) / (time.size - 1)
    apart = float(moments[1] - moments[0])
    pictures, step = period / apart, time_unit(apart).text(apart)
    if pictures >= _FEWEST:
        return ""
    rings = f"It rings at {significant(1 / period)} Hz"
    if per_period < _PICTURES:
        return f"{rings}: the {time.size} frames of the run are too few to show that; take more run.frames."
    longer = significant(_PICTURES / pictures)
    return f"{rings}: pictures {step} apart do not show that, the curve does; a film {longer} times as long would."


def _plain(axes: Axes, across: int, up: int) -> None:
    axes.tick_params(labelsize=10.5)
    axes.xaxis.set_major_locator(MaxNLocator(across, steps=(1, 2, 2.5, 5, 10)))
    axes.yaxis.set_major_locator(MaxNLocator(up, steps=(1, 2, 2.5, 5, 10)))
