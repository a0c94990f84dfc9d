"""The figures of a run as they are printed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from softcat_sym.report import style
from softcat_sym.report.energy import TERMS
from softcat_sym.report.frames import telling_frames
from softcat_sym.report.layout import vertical_stretch
from softcat_sym.report.publication import LINES, MILLIMETRE, Sheet
from softcat_sym.report.shapes import Shape, shapes_of, yielded_label
from softcat_sym.report.space_time import draw_maps
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
