"""Pictures of a run for print: a journal's column or page wide, vectors, fonts embedded."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import xarray as xr
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from softcat_sym.plotting import style
from softcat_sym.plotting.energy import TERMS
from softcat_sym.plotting.section import telling_frames, vertical_stretch
from softcat_sym.plotting.shapes import Shape, shapes_of, yielded_label
from softcat_sym.plotting.space_time import draw_maps
from softcat_sym.plotting.style import (
    PicturedScene,
    Summary,
    Unit,
    constrained,
    energy_unit,
    length_unit,
    new_figure,
    shown_part,
    stamp,
    time_unit,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MILLIMETRE: Final = 1 / 25.4
"""[inch]."""

WIDTHS: Final = {"column": 84.0, "page": 174.0}
"""Widths of a figure [mm]: one column, or the whole page."""

DPI: Final = 400
"""Of the PNG files, and of what is drawn as pixels within a PDF."""

LINES: Final = (
    (style.BLACK, "-"),
    (style.BLUE, "-"),
    (style.VERMILLION, "--"),
    (style.SKY, "-."),
    (style.ORANGE, ":"),
    (style.GREEN, (0, (6, 1.5, 1, 1.5, 1, 1.5))),
)
"""Colours that the colour-blind tell apart, each with a line style of its own for print in black and white."""

_RC: Final[dict[str, Any]] = {
    "font.size": 8.0,
    "axes.labelsize": 8.0,
    "axes.titlesize": 8.0,
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "legend.fontsize": 8.0,
    "lines.linewidth": 0.9,
    "axes.linewidth": 0.5,
    "xtick.major.width": 0.5,
    "ytick.major.width": 0.5,
    "xtick.major.size": 2.5,
    "ytick.major.size": 2.5,
    "axes.labelpad": 2.5,
    "hatch.linewidth": 0.5,
}


@dataclass(frozen=True, slots=True)
class Sheet:
    """What every figure of one run shares."""

    width: float  # Of the figure [inch]
    data: xr.Dataset  # Trajectory
    summary: Summary  # The run's summary
    scene: PicturedScene  # The scene

    @property
    def clock(self) -> Unit:
        """The unit of time."""
        return time_unit(float(abs(self.data["time"].values).max()))

    @property
    def ruler(self) -> Unit:
        """The unit of length of the midpoint."""
        return length_unit(float(abs(self.data["midpoint"].values).max()), self.scene.filament.span)

    def figure(self, height: float) -> Figure:
        """A figure of this height [inch], laid out by what its axes need, stamped if the result is refused."""
        figure = new_figure(self.width, height)
        constrained(figure, heading=0.0)
        stamp(figure, self.summary)
        return figure

    def framed(self, height: float) -> tuple[Figure, Axes]:
        """A figure of this height [inch] with one pair of axes."""
        figure = self.figure(height)
        axes = figure.add_subplot()
        style.lighten(axes)
        return figure, axes


@contextmanager
def publication_style() -> Iterator[None]:
    """Put the style of print in force for the length of a ``with`` block; what was set before comes back."""
    from matplotlib import rc_context

    settings: Any = _RC
    with style.styled(), rc_context(settings):
        yield


def publication_figures(data: xr.Dataset, summary: Summary, scene: PicturedScene, width: str) -> dict[str, bytes]:
    """Draw a run for print: ``midpoint``, ``shapes``, ``energy`` and ``space-time``, each as PDF and PNG."""
    sheet = Sheet(WIDTHS[width] * MILLIMETRE, *shown_part(data, summary), scene)
    files: dict[str, bytes] = {}
    with publication_style():
        for name, drawn in (
            ("midpoint", midpoint(sheet)),
            ("shapes", shapes(sheet)),
            ("energy", energy(sheet)),
            ("space-time", space_time(sheet)),
        ):
            files |= printed(name, drawn)
    return files


def printed(name: str, figure: Figure) -> dict[str, bytes]:
    """A figure as PDF and PNG, while the style is in force: fonts and ticks are found only while drawing."""
    from io import BytesIO

    files = {}
    for ending, metadata in (("pdf", {"CreationDate": None}), ("png", None)):
        content = BytesIO()
        figure.savefig(content, format=ending, dpi=DPI, metadata=metadata)
        files[f"{name}.{ending}"] = content.getvalue()
    return files


_GOLDEN = 0.62
_SHAPES = 4
_TALLEST = 8.0
"""Of a figure [inch]."""

_LOW = 0.28
"""Below this height [inch] the axis of a shape has room for one number."""

_SPARE = 0.03
"""Height [inch] that the layout may be off by."""

_STEPS = (1, 2, 2.5, 5, 10)


def midpoint(sheet: Sheet) -> Figure:
    """Height of the midpoint against time, and the frames that the figure of shapes shows."""
    figure, axes = sheet.framed(min(_GOLDEN * sheet.width, 2.6))
    time, height = sheet.clock.of(sheet.data["time"].values), sheet.ruler.of(sheet.data["midpoint"].values)
    colour, line = LINES[1]
    axes.plot(time, height, linestyle=line, color=colour, label="midpoint")
    frames = telling_frames(sheet.data, _SHAPES)
    axes.plot(
        time[frames], height[frames], "o", color=style.VERMILLION, markersize=3, markerfacecolor="white", clip_on=False,
        label="shapes drawn",
    )  # fmt: skip
    _time_axis(axes, sheet)
    axes.margins(y=0.08)
    axes.set_ylabel(f"midpoint [{sheet.ruler.symbol}]")
    figure.legend(loc="outside upper center", ncols=2, borderaxespad=0.0)
    return figure


def energy(sheet: Sheet) -> Figure:
    """The energies against time; those that are nought throughout are left out."""
    figure, axes = sheet.framed(min(0.75 * sheet.width, 2.6))
    time = sheet.clock.of(sheet.data["time"].values)
    values = {name: np.asarray(sheet.data[name].values, dtype=np.float64) for name, *_ in TERMS}
    unit = energy_unit(max(float(np.abs(value).max()) for value in values.values()))
    kept = [term for term in TERMS if np.any(values[term[0]])]
    for (name, label, *_), (colour, line) in zip(kept, LINES, strict=False):
        axes.plot(time, unit.of(values[name]), linestyle=line, color=colour, label=label)
    _time_axis(axes, sheet)
    axes.set_ylabel(f"energy [{unit.symbol}]")
    if kept:
        figure.legend(loc="outside upper center", ncols=3, borderaxespad=0.0, handlelength=2.0)
    return figure


def space_time(sheet: Sheet) -> Figure:
    """Stretch and yielded share: one below the other in a column, side by side on a page."""
    side = sheet.width > 120 * MILLIMETRE
    figure = sheet.figure(1.9 if side else 3.2)
    panels = figure.subplots(*((1, 2) if side else (2, 1)), sharex=True)
    draw_maps(panels, sheet.data, sheet.summary, sheet.scene)
    panels[0].xaxis.set_major_locator(MaxNLocator(5, steps=_STEPS))
    return figure


def shapes(sheet: Sheet) -> Figure:
    """The filament at telling times, one below the other at one scale, coloured where it yields."""
    found = shapes_of(sheet.data, sheet.scene, telling_frames(sheet.data, _SHAPES))
    outlines = [shape.outline for shape in found]
    low, high = np.min([o.min(axis=0) for o in outlines], axis=0), np.max([o.max(axis=0) for o in outlines], axis=0)
    filament = sheet.scene.filament
    departure = max(float(np.ptp(shape.section.y)) for shape in found)
    stretch = vertical_stretch(departure, filament.thickness, filament.span)
    pad = 0.02 * float(high[0] - low[0])
    x = (float(low[0]) - pad, float(high[0]) + pad)
    margin = 0.2 * filament.thickness
    ranges = [(float(o[:, 1].min()) - margin, float(o[:, 1].max()) + margin) for o in outlines]
    tall = [stretch * (top - floor) / (x[1] - x[0]) for floor, top in ranges]
    figure = sheet.figure(sheet.width)
    panels = list(figure.subplots(len(found), 1, sharex=True, squeeze=False, height_ratios=tall)[:, 0])
    ruler = length_unit(max(abs(x[0]), abs(x[1])), filament.span)
    for axes, shape, bounds in zip(panels, found, ranges, strict=True):
        axes.set_xlim(*(float(ruler.of(bound)) for bound in x))
        axes.set_ylim(*(float(ruler.of(bound)) for bound in bounds))
        _shape(axes, shape, ruler, last=shape is found[-1])
        axes.yaxis.set_major_locator(MaxNLocator(2, steps=_STEPS))
    scaled = "" if stretch == 1 else f", vertical scale × {stretch:g}"
    panels[-1].set_xlabel(f"x [{ruler.symbol}]{scaled}")
    figure.supylabel(f"y [{ruler.symbol}]", fontsize=8.0)
    if sheet.scene.material.yield_stress is not None:
        patch = Patch(facecolor=style.VERMILLION, label=yielded_label(sheet.data, sheet.scene))
        figure.legend(handles=[patch], loc="outside upper center", borderaxespad=0.0, fontsize=7.0)
    _fit_height(figure, panels, tall)
    for axes in panels:
        axes.set_aspect(stretch, anchor="S")
    return figure


def _fit_height(figure: Figure, panels: Sequence[Axes], tall: Sequence[float]) -> None:
    """Make a figure as high as its panels need to be `tall` times as high as they are wide, up to the tallest."""
    figure.draw_without_rendering()
    width, height = figure.get_size_inches()
    places = [axes.get_position() for axes in panels]
    around = height * (1 - sum(place.height for place in places))
    scale = min(width * min(place.width for place in places), (_TALLEST - around) / sum(tall))
    figure.set_size_inches(width, around + max(scale * sum(tall), _LOW) + _SPARE)
    for axes, share in zip(panels, tall, strict=True):
        if scale * share < _LOW:
            # Room for one number.
            axes.set_yticks((0.0,))


def _shape(axes: Axes, shape: Shape, ruler: Unit, *, last: bool) -> None:
    """One shape, its time and its sag."""
    body = ruler.of(shape.outline)
    axes.fill(body[:, 0], body[:, 1], facecolor=style.FILAMENT, edgecolor="none", zorder=2)
    quads = PolyCollection(list(ruler.of(shape.yielded)), facecolors=style.VERMILLION, edgecolors="none", zorder=3)
    quads.set_antialiased(False)
    quads.set_rasterized(True)
    axes.add_collection(quads, autolim=False)
    axes.fill(body[:, 0], body[:, 1], facecolor="none", edgecolor=style.BLACK, linewidth=0.4, zorder=4)
    axes.set_title(", ".join(shape.label.split("\n")), loc="left", pad=2, fontsize=7)
    axes.xaxis.set_major_locator(MaxNLocator(6, steps=_STEPS))
    axes.tick_params(labelbottom=last, bottom=last)
    axes.spines["bottom"].set_visible(last)
    style.lighten(axes)


def _time_axis(axes: Axes, sheet: Sheet) -> None:
    time = sheet.clock.of(sheet.data["time"].values)
    start, end = float(time[0]), float(time[-1])
    axes.set_xlim(start, end if end > start else start + 1.0)
    axes.set_xlabel(f"time [{sheet.clock.symbol}]")
    axes.xaxis.set_major_locator(MaxNLocator(6, steps=_STEPS))
    axes.yaxis.set_major_locator(MaxNLocator(5, steps=_STEPS))
