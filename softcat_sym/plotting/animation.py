"""A film of a run: the filament with its stress and what yields, a clock, its midpoint's trace; as GIF or MP4."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize, to_rgb
from matplotlib.patches import Patch, PathPatch, Polygon
from matplotlib.path import Path as Outline
from matplotlib.ticker import MaxNLocator

from softcat_sym.errors import SoftcatError
from softcat_sym.files import replace_atomically
from softcat_sym.plotting import style
from softcat_sym.plotting.bodies import draw_bodies, draw_nozzle, walls_at
from softcat_sym.plotting.files import mp4
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
from softcat_sym.plotting.style import Fields, axes_in_inches, ending_of, new_figure, stamp, styled
from softcat_sym.plotting.time_axis import STEPS, between
from softcat_sym.plotting.units import length_unit, significant, stress_unit, time_unit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from softcat_sym.plotting.units import Summary, Unit
    from softcat_sym.scene.scene import Scene

_ZETA = np.linspace(-1.0, 1.0, 9)
"""Between the strips through the thickness that are coloured by their stress."""

_FIELDS = ("x", "y", "thickness", "stress_mean", "stress_bending")


def moments_of(data: Fields, scene: Scene, count: int) -> dict[str, Floats]:
    """Fields of a run at so many equally spaced times, linear between frames."""
    time, yields = array(data, "time"), yielding_of(data, scene)
    times = np.linspace(time[0], time[-1], max(1, count))
    fields = {name: array(data, name) for name in _FIELDS} | {"low": yields.low, "high": yields.high}
    whole = {"time": times, "X_node": array(data, "X_node"), "X_cell": array(data, "X_cell")}
    return whole | {name: between(time, values, times) for name, values in fields.items()}


KINDS: Final = {"gif": 12.5, "mp4": 25.0}
"""Kinds of film, and their pictures a second; a GIF counts in hundredths of a second, and 8 of them are a picture."""

LONGEST: Final = 120.0
"""Of a film [s]: what is longer would fill the memory, and nobody would watch it."""

_HOLD_MS: Final = 1200
"""How long a GIF rests on its last picture before it begins again."""

_COLOURS_OF_GIF, _PAPER = 128, 247
"""Of a GIF, which then holds pictures without dots and less of them; those as light as the second are the paper's."""


@dataclass(frozen=True, slots=True)
class FilmOrder:
    """A film that was asked for, and can be made here."""

    name: str  # Of the file
    kind: str  # ``gif`` or ``mp4``
    seconds: float  # Its length [s]

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
    if kind == "mp4" and find_spec("av") is None:
        needs = "an MP4 is written by PyAV, which is not installed: pip install 'softcat_sym[movies]'"
        raise SoftcatError(f"--animate: {needs}; a GIF needs nothing else")
    return FilmOrder(name, kind, seconds)


def write_film(
    order: FilmOrder,
    directory: Path,
    run: tuple[Fields, Summary, Scene],
    step: Callable[[str], None] = lambda what: None,
    width: int = 1280,
) -> tuple[Path, str]:
    """Draw a film and write it, whole or not at all."""
    animation = Animation(*run, order.pictures, width)

    def pictures() -> Iterator[NDArray[np.uint8]]:
        for number in range(order.pictures):
            step(f"picture {number + 1} of {order.pictures}")
            yield animation.picture(number)

    content = _gif(animation, pictures()) if order.kind == "gif" else mp4(pictures(), round(KINDS["mp4"]))
    return replace_atomically(directory / order.name, content), animation.note


def _gif(animation: Animation, pictures: Iterator[NDArray[np.uint8]]) -> bytes:
    """All pictures with the colours of a few of them, so that what does not move is the same number in all."""
    from PIL import Image

    count = animation.times.size
    few = np.concatenate([animation.picture(k) for k in np.unique(np.linspace(0, count - 1, 5).astype(int))])
    plain: dict[str, Any] = {"dither": Image.Dither.NONE}
    palette = Image.fromarray(few).quantize(_COLOURS_OF_GIF, method=Image.Quantize.MEDIANCUT, **plain)
    # The mean of what is nearly white is not white.
    colours = np.reshape(palette.getpalette() or [], (-1, 3))
    colours[colours.min(axis=1) >= _PAPER] = 255
    palette.putpalette(colours.ravel().tolist())
    first, *pauses = [round(1000 / KINDS["gif"])] * (count - 1) + [_HOLD_MS]
    frames = (Image.fromarray(picture).quantize(palette=palette, **plain) for picture in pictures)
    looks: dict[str, Any] = {"duration": [first, *pauses], "loop": 0, "optimize": False}
    next(frames).save(stream := BytesIO(), format="GIF", save_all=True, append_images=frames, **looks)
    return stream.getvalue()


WIDTH, DPI = 12.8, 100
"""Of a film [inch, pixel per inch]: 1280 pixels."""

_LEFT, _RIGHT, _TOP, _TRACE, _BOTTOM, _BETWEEN = 0.95, 0.35, 0.75, 1.5, 0.6, 0.75
_ACROSS = WIDTH - _LEFT - _RIGHT
_TALLEST, _LOWEST, _SPATIAL_HEIGHT = 3.6, 1.3, 8.0
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


class Animation:
    """Moments of a run in its plane or in space, drawn in one figure with a clock and the midpoint's trace.

    Attributes
    ----------
    figure, axes : Figure, Axes
        What every moment is drawn in, and the part with the filament.
    times : ndarray
        The moments [s].
    note : str
        What they cannot show.
    """

    def __init__(
        self, data: Fields, summary: Summary, scene: Scene, moments: int, width: int = int(WIDTH * DPI)
    ) -> None:
        self._sheet = sheet = Sheet.of(data, summary, scene)
        self.times = np.linspace(sheet.time[0], sheet.time[-1], max(1, moments))
        self.note = film_note(self.times, sheet.data, summary)
        self._moving: list[Any] = []  # What is drawn anew; in space all is
        self._background: Any = None
        with styled():
            is_spatial = "quaternion" in sheet.data
            self._show = self._in_space(width) if is_spatial else self._in_plane(width)
            moving = [*self._trace(1.0 if is_spatial else 0.6), self._head(), *stamp(self.figure, sheet.summary)]
            self._moving += [] if is_spatial else moving
            for artist in self._moving:
                artist.set_animated(True)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height [pixel], both even, as video wants them."""
        width, height = self.figure.canvas.get_width_height()
        return width - width % 2, height - height % 2

    @styled()
    def picture(self, number: int) -> NDArray[np.uint8]:
        """Draw one moment, shape (height, width, 3)."""
        canvas: Any = self.figure.canvas
        if self._moving and self._background is None:
            canvas.draw()  # without what moves: that is marked as animated
            self._background = canvas.copy_from_bbox(self.figure.bbox)
        if self._moving:
            canvas.restore_region(self._background)
        self._show(number)
        self._go_to(number)
        for artist in self._moving:
            self.figure.draw_artist(artist)
        if not self._moving:
            canvas.draw()
        width, height = self.size
        drawn: NDArray[np.uint8] = np.asarray(canvas.buffer_rgba())[:height, :width, :3].copy()
        return drawn

    def _begin(self, height: float, width: int, ruler: Unit) -> None:
        self.figure, self._ruler = new_figure(WIDTH, height), ruler
        self.figure.set_dpi(width / WIDTH)

    def _head(self) -> Any:
        """Title, how the run ended, what the film cannot show, and the clock, which moves."""
        height, left, right = self.figure.get_figheight(), _LEFT / WIDTH, 1 - _RIGHT / WIDTH
        title = style.printable(self._sheet.scene.title, 70) or "Filament"
        ending = style.printable(" · ".join(ending_of(self._sheet.summary)), 90)
        place: dict[str, Any] = {"y": 1 - 0.14 / height, "va": "top", "fontsize": 16}
        below: dict[str, Any] = {"y": 1 - 0.45 / height, "va": "top"}
        self.figure.text(left, s=title, fontweight="bold", parse_math=False, **place)
        self.figure.text(left, s=ending, fontsize=_FONT, color=style.GREY, **below)
        self.figure.text(right, s=self.note, ha="right", fontsize=0.85 * _FONT, color=style.VERMILLION, **below)
        self._now = self.figure.text(right, s="", ha="right", **place)
        return self._now

    def _trace(self, share: float) -> tuple[Any, ...]:
        """The midpoint against time, over a share of the width: all of it in grey, what has passed in blue."""
        axes = axes_in_inches(self.figure, _LEFT, _BOTTOM, share * _ACROSS, _TRACE)
        time, height = self._sheet.curves("midpoint")
        self._curve = time, self._ruler.of(height[:, 0])
        axes.plot(*self._curve, color="#d0d4d8", linewidth=1.6)
        _plain(axes, 7, 4)
        self._sheet.axis.dress(axes, 7)
        axes.set_xlabel(self._sheet.axis.label, fontsize=_FONT)
        axes.set_ylabel(f"midpoint [{self._ruler.symbol}]", fontsize=_FONT)
        axes.margins(y=0.12)
        (self._past,) = axes.plot([], [], color=style.BLUE, linewidth=2.2)
        (self._dot,) = axes.plot([], [], "o", color=style.BLUE, ms=8, markeredgecolor="white", clip_on=False)
        return self._past, self._dot

    def _go_to(self, number: int) -> None:
        """Move the clock and the trace to a moment."""
        clock, now = self._sheet.clock, float(self._sheet.axis.unit.of(self.times[number]))
        time, height = self._curve
        end, here = int(np.searchsorted(time, now, side="right")), float(np.interp(now, time, height))
        self._past.set_data(np.append(time[:end], now), np.append(height[:end], here))
        self._dot.set_data([now], [here])
        largest = float(clock.of(self.times[-1]))
        decimals = 3 if largest < 10 else 2 if largest < 100 else 1
        self._now.set_text(f"t = {clock.of(self.times[number]):.{decimals}f} {clock.symbol}")

    def _in_plane(self, width: int) -> Callable[[int], None]:
        """Body coloured by stress, hatched where it yields, its edge, and the shape it started from; what shows it."""
        sheet, scene = self._sheet, self._sheet.scene
        film = moments_of(sheet.data, scene, self.times.size)
        larger = Magnification.of(largest_sag(film["y"]), scene.filament.thickness, scene.filament.span)
        film = larger.drawn(film)
        held = [one.holds_angle for one in scene.ends.supports]
        sections: list[FilamentOutline] = [section_at(film, k, held) for k in range(self.times.size)]
        corners = np.concatenate([outline(section) for section in sections])
        low, high = corners.min(axis=0), corners.max(axis=0)
        # Magnitude of the axial stress amid every strip of every cell [Pa], shape (moment, strip and cell).
        slopes = film["stress_bending"][:, None] * (0.5 * (_ZETA[1:] + _ZETA[:-1]))[:, None]
        stresses = np.abs(film["stress_mean"][:, None] + slopes).reshape(self.times.size, -1)
        largest = float(np.quantile(stresses, 0.995))
        # The largest scale at which every moment fits; what it leaves free is shared by both sides.
        extent = 1.04 * (high - low) + np.array([0.0, 0.7 * scene.filament.thickness * larger.thickness / larger.sag])
        scale = min(_ACROSS / extent[0], _TALLEST / (larger.sag * extent[1]))
        tall = max(_LOWEST, scale * larger.sag * extent[1])
        half = np.array([_ACROSS / scale, tall / (scale * larger.sag)]) / 2
        ruler = length_unit(float(np.abs([low, high]).max()), scene.filament.span)
        self._begin(_BOTTOM + _TRACE + _BETWEEN + tall + _TOP, width, ruler)
        self.axes = axes_in_inches(self.figure, _LEFT, _BOTTOM + _TRACE + _BETWEEN, _ACROSS, tall)
        limits = ruler.of(np.array([-half, half]) + (low + high) / 2).T
        self.axes.set(xlim=limits[0], ylim=limits[1])
        _plain(self.axes, 9, max(2, int(tall / 0.45)))
        self.axes.set_xlabel(f"x [{ruler.symbol}]" + (f" ({larger})" if str(larger) else ""), fontsize=_FONT)
        self.axes.set_ylabel(f"y [{ruler.symbol}]", fontsize=_FONT)
        start, over = ruler.of(outline(sections[0])), scene.material.yield_stress or stress_unit(largest).size
        self.axes.fill(*start.T, linewidth=0.8, **_DASHED)
        norm = Normalize(0.0, largest / over or 1.0)
        body = PolyCollection([], cmap=_COLOURS, norm=norm, edgecolors="none", antialiaseds=False)
        self.axes.add_collection(body, autolim=False)
        yields = PathPatch(Outline(start), **_HATCHED)
        edge = Polygon(start, facecolor="none", edgecolor=style.BLACK, linewidth=0.9)
        self.axes.add_artist(yields)
        self.axes.add_artist(edge)
        drawn = scene.filament.thickness * larger.thickness / larger.sag
        draw_bodies(self.axes, scene, drawn, (-half[0] + low[0], half[0] + high[0]), low[1] - half[1], ruler)
        nozzle = draw_nozzle(self.axes, scene, 0.0, drawn, ruler) if scene.extrusion.present else None
        self._moving = [*filter(None, [nozzle]), body, yields, edge]
        self._legend(body, stress_unit(largest).symbol)

        def show(number: int) -> None:
            section = sections[number]
            grid = ruler.of([section.at(float(zeta)) for zeta in _ZETA])
            strips = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], axis=2).reshape(-1, 4, 2)
            body.set_verts(list(strips))
            body.set_array(stresses[number] / over)
            edge.set_xy(ruler.of(outline(section)))
            if nozzle is not None:
                nozzle.set_xy(ruler.of(walls_at(scene, float(self.times[number]), drawn)))
            quads = quads_outside(section, film["low"][number], film["high"][number])
            yields.set_path(Outline.make_compound_path_from_polys(ruler.of(quads)))
            yields.set_visible(bool(len(quads)))

        return show

    def _legend(self, body: PolyCollection, unit: str) -> None:
        """The colour bar of the stress, and what hatching and dashes mean."""
        left, limit = _LEFT + 0.67 * _ACROSS, self._sheet.scene.material.yield_stress
        bar = axes_in_inches(self.figure, left, _BOTTOM + _TRACE - 0.2, WIDTH - _RIGHT - left, 0.18)
        # Of a section resolved fibre by fibre, this is the linear stress nearest to what its fibres bear.
        what = "linear part of the axial stress" if "core_low" in self._sheet.data else "axial stress"
        drawn = self.figure.colorbar(body, cax=bar, orientation="horizontal")
        drawn.set_label(what + (f" [{unit}]" if limit is None else " / yield stress"), fontsize=_FONT)
        bar.tick_params(labelsize=10.5)
        handles = [Patch(label="start", **_DASHED)]
        if limit is not None:
            label = yielded_label(self._sheet.data, self._sheet.scene).replace(", ", ",\n")
            handles.insert(0, Patch(label=label, **_HATCHED))
        anchor = (left / WIDTH, (_BOTTOM - 0.25) / self.figure.get_figheight())
        self.figure.legend(handles=handles, loc="lower left", bbox_to_anchor=anchor, borderaxespad=0.0, fontsize=_FONT)

    def _in_space(self, width: int) -> Callable[[int], None]:
        """The tube of the frame nearest to a moment; what shows it."""
        sheet = self._sheet
        nearest = np.abs(sheet.time[:, None] - self.times).argmin(axis=0).tolist()
        tubes = {frame: tube(sheet.data, sheet.scene, frame, 1.0) for frame in set(nearest)}
        corners = np.concatenate([one.reshape(-1, 3) for one in tubes.values()])
        ruler = length_unit(float(np.abs(corners).max()), sheet.scene.filament.span)
        self._begin(_SPATIAL_HEIGHT, width, ruler)
        self.axes = axes = self.figure.add_axes((0.0, 0.27, 1.0, 0.66), projection="3d")
        frame_tube(axes, ruler.of(corners.min(axis=0)), ruler.of(corners.max(axis=0)), ruler.symbol)
        bodies: list[Any] = []

        def show(number: int) -> None:
            while bodies:
                bodies.pop().remove()
            bodies.append(draw_tube(axes, ruler.of(tubes[nearest[number]])))

        return show


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
    axes.xaxis.set_major_locator(MaxNLocator(across, steps=STEPS))
    axes.yaxis.set_major_locator(MaxNLocator(up, steps=STEPS))
