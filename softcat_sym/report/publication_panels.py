"""The figures of a run as they are printed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.ticker import MaxNLocator

from softcat_sym.report import style
from softcat_sym.report.canvas import axes_in_inches, new_figure
from softcat_sym.report.energy import OPTIONAL, TERMS
from softcat_sym.report.frames import telling_frames
from softcat_sym.report.layout import vertical_stretch
from softcat_sym.report.publication import LINES, Sheet
from softcat_sym.report.shapes import Shape, shapes_of
from softcat_sym.report.space_time import draw_bar, draw_map, maps_of
from softcat_sym.report.units import Unit, energy_unit, length_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_GOLDEN = 0.62
_SHAPES = 4
_TALLEST = 8.0
"""Of a figure [inch]."""

_LOW = 0.28
"""Below this height [inch] the axis of a shape has room for one number."""

_STEPS = (1, 2, 2.5, 5, 10)


def midpoint(sheet: Sheet) -> Figure:
    """Height of the midpoint against time, and the frames that the figure of shapes shows."""
    figure, axes = sheet.framed(min(_GOLDEN * sheet.width, 2.6))
    time, height = sheet.clock.of(sheet.data["time"].values), sheet.ruler.of(sheet.data["midpoint"].values)
    colour, line = LINES[1]
    axes.plot(time, height, line, color=colour)
    frames = telling_frames(sheet.data, _SHAPES)
    axes.plot(
        time[frames], height[frames], "o", color=style.VERMILLION, markersize=3, markerfacecolor="white", clip_on=False
    )
    _time_axis(axes, sheet)
    axes.margins(y=0.08)
    axes.set_ylabel(f"midpoint [{sheet.ruler.symbol}]")
    return figure


def energy(sheet: Sheet) -> Figure:
    """The energies against time; those that are nought throughout are left out."""
    figure, axes = sheet.framed(min(_GOLDEN * sheet.width, 2.6), right=1.22)
    time = sheet.clock.of(sheet.data["time"].values)
    values = {name: np.asarray(sheet.data[name].values, dtype=np.float64) for name, *_ in TERMS}
    unit = energy_unit(max(float(np.abs(value).max()) for value in values.values()))
    kept = [term for term in TERMS if term[0] not in OPTIONAL and np.any(values[term[0]])]
    for (name, label, *_), (colour, line) in zip(kept, LINES, strict=False):
        axes.plot(time, unit.of(values[name]), line, color=colour, label=label)
    _time_axis(axes, sheet)
    axes.set_ylabel(f"energy [{unit.symbol}]")
    if kept:
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, handlelength=1.6)
    return figure


def space_time(sheet: Sheet) -> Figure:
    """Stretch and yielded share: one below the other in a column, side by side on a page."""
    from softcat_sym.report.publication import MILLIMETRE

    side = sheet.width > 120 * MILLIMETRE
    left, bar, bottom, gap, tall = 0.57, 0.7, 0.42, 0.16, 1.15
    each = sheet.width / 2 if side else sheet.width
    height = bottom + tall + 0.1 if side else bottom + 2 * tall + gap + 0.1
    figure = new_figure(sheet.width, height)
    for number, shown in enumerate(maps_of(sheet.data, sheet.scene)):
        at = left + number * each if side else left
        low = bottom if side or number == 1 else bottom + tall + gap
        axes = axes_in_inches(figure, at, low, each - left - bar, tall)
        mesh = draw_map(axes, sheet.data, shown, named=number == 0)
        axes.set_yticks((-0.5, 0.0, 0.5))
        scale = axes_in_inches(figure, at + each - left - bar + 0.06, low, 0.07, tall)
        draw_bar(scale, mesh, shown)
        if number == 1 or side:
            axes.set_xlabel(f"time [{sheet.clock.symbol}]")
        axes.tick_params(labelbottom=number == 1 or side)
        axes.xaxis.set_major_locator(MaxNLocator(5, steps=_STEPS))
    return figure


def shapes(sheet: Sheet) -> Figure:
    """The filament at telling times, one below the other at one scale, hatched where it yields."""
    found = shapes_of(sheet.data, sheet.scene, telling_frames(sheet.data, _SHAPES))
    outlines = [shape.outline for shape in found]
    low, high = np.min([o.min(axis=0) for o in outlines], axis=0), np.max([o.max(axis=0) for o in outlines], axis=0)
    filament = sheet.scene.filament
    departure = max(float(np.ptp(shape.section.y)) for shape in found)
    stretch = vertical_stretch(departure, filament.thickness, filament.span)
    left, right, bottom, gap, label = 0.56, 0.1, 0.42, 0.06, 0.15
    pad = 0.02 * float(high[0] - low[0])
    x = (float(low[0]) - pad, float(high[0]) + pad)
    ranges = [(o[:, 1].min() - 0.2 * filament.thickness, o[:, 1].max() + 0.2 * filament.thickness) for o in outlines]
    width = sheet.width - left - right
    total = sum(top - floor for floor, top in ranges) * stretch
    room = _TALLEST - bottom - len(found) * (label + gap)
    scale = min(width / (x[1] - x[0]), room / total)
    spare = 0.5 * (width / scale - (x[1] - x[0]))
    heights = [scale * stretch * (top - floor) for floor, top in ranges]
    height = bottom + sum(heights) + len(found) * (label + gap)
    figure = new_figure(sheet.width, height)
    ruler = length_unit(max(abs(x[0]), abs(x[1])), filament.span)
    top = height
    for shape, tall, (floor, ceiling) in zip(found, heights, ranges, strict=True):
        top -= label + tall + gap
        axes = axes_in_inches(figure, left, top + gap, width, tall)
        axes.set_xlim(float(ruler.of(x[0] - spare)), float(ruler.of(x[1] + spare)))
        axes.set_ylim(float(ruler.of(floor)), float(ruler.of(ceiling)))
        _shape(axes, shape, ruler, last=shape is found[-1])
        if tall < _LOW:
            axes.set_yticks((0.0,))
    scaled = "" if stretch == 1 else f", vertical scale × {stretch:g}"
    axes.set_xlabel(f"x [{ruler.symbol}]{scaled}")
    figure.text(0.03, 0.5, f"y [{ruler.symbol}]", rotation=90, va="center")
    return figure


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
    axes.yaxis.set_major_locator(MaxNLocator(2, steps=_STEPS))
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
