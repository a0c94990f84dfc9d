"""Every effect as a point: how far it moves the answer, against what it costs in time, unknowns and instructions."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from softcat_sym.report import style
from softcat_sym.report.canvas import HEADING, axes_in_inches, head, new_figure
from softcat_sym.report.labels import label_points
from softcat_sym.study.reading import percent

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.study.pricing import Pricing, PricingRow

_LEFT, _RIGHT, _GAP, _SIDE, _TALL, _LINE = 0.95, 0.2, 0.16, 1.12, 3.5, 0.145
_UNSEEN = 1e-3
"""Changes below this share of the accuracy asked are drawn there: solver tolerances make the rest."""

_TICKS = (
    ((1.0, 1.2, 1.5, 2.0, 3.0, 5.0, 7.0), 1),
    ((1.0, 1.5, 2.0, 3.0, 5.0, 7.0), 1),
    ((1.0, 2.0, 5.0), 1),
    ((1.0, 3.0), 1),
    *(((1.0,), every) for every in (1, 2, 3, 4, 6, 12)),
)
"""Steps within a decade and which decades, the densest first."""

_APART = 0.5
"""Least distance of two ticks [inch]."""

_MARKS: dict[str, dict[str, Any]] = {
    "in force, left out": {"marker": "o", "color": style.BLUE},
    "not in force, put in": {"marker": "D", "color": style.VERMILLION, "markerfacecolor": "white"},
    "everything at once": {"marker": "s", "color": style.BLACK},
}


def pricing_figure(pricing: Pricing) -> Figure:
    """Draw the chart: change of the midpoint upwards, ratios with the effect over without it to the right.

    Parameters
    ----------
    pricing : Pricing
        As from :func:`softcat_sym.study.pricing.price`.
    """
    # Everything is a point of its own only where it is more than the base.
    rows = [*pricing.rows, *([pricing.everything] if pricing.everything.also else [])]
    shown = [row for row in rows if row.share is not None and row.time_ratio is not None]
    notes = _notes(pricing, rows)
    bottom = 0.98 + _LINE * len(notes)
    with style.styled():
        figure = new_figure(style.WIDTH, bottom + _TALL + HEADING)
        head(
            figure,
            "each effect left out or put in, in turn",
            {"outcome": pricing.base.outcome.name},
            pricing.scene,
            _LEFT,
        )
        width = style.WIDTH - _LEFT - _RIGHT - 2 * (_SIDE + _GAP)
        places = [(_LEFT, width), *((_LEFT + width + _GAP + k * (_SIDE + _GAP), _SIDE) for k in (0, 1))]
        panels = [axes_in_inches(figure, left, bottom, wide, _TALL) for left, wide in places]
        ratios = ("time_ratio", "states_ratio", "instructions_ratio")
        accuracy = pricing.scene.run.accuracy
        floor = _UNSEEN * accuracy
        heights = [max(row.share or 0.0, floor) for row in shown]
        for axes, ratio, name in zip(panels, ratios, ("solve time", "unknowns", "instructions"), strict=True):
            points = [(getattr(row, ratio), height) for row, height in zip(shown, heights, strict=True)]
            axes.set_yscale("log")
            # Room for names above and below.
            axes.set_ylim(min([accuracy / 3, *heights]) / 3, 3 * max([10 * accuracy, *heights]))
            _upwards(axes)
            _panel(axes, points, shown, accuracy)
            axes.set_xlabel(name)
        panels[0].set_ylabel("change of the midpoint / its largest")
        for axes in panels[1:]:
            axes.tick_params(labelleft=False)
        times = [row.time_ratio or 1.0 for row in shown]
        label_points(panels[0], list(zip(times, heights, strict=True)), [row.effect for row in shown])
        _explain(figure, pricing, notes)
    return figure


def _panel(axes: Axes, points: Sequence[tuple[float, float]], rows: Sequence[PricingRow], accuracy: float) -> None:
    axes.set_xscale("log")
    axes.set_xlim(*_limits([x for x, _ in points]))
    _across(axes)
    axes.axhline(accuracy, color=style.GREY, linewidth=0.9, linestyle=(0, (4, 2)), zorder=1)
    axes.axvline(1.0, color=style.GREY, linewidth=0.5, zorder=1)
    for (x, y), row in zip(points, rows, strict=True):
        axes.plot([x], [y], linestyle="none", markersize=5.5, zorder=3, **_MARKS[_mark(row)])
    axes.grid(True)
    style.lighten(axes)


def _limits(ratios: Sequence[float]) -> tuple[float, float]:
    low, high = min([0.8, *ratios]), max([1.25, *ratios])
    room = (high / low) ** 0.08
    return low / room, high * room


def _mark(row: PricingRow) -> str:
    inside, outside, every = _MARKS
    return every if len(row.also) and row.effect == "everything" else inside if row.in_force else outside


def _across(axes: Axes) -> None:
    """As many ticks of round numbers as there is room for, written plainly; one at 1 at the least."""
    low, high = axes.get_xlim()
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    inches = axes.get_window_extent().width / style.DPI
    for steps, every in _TICKS:
        ticks = [step * 10.0**k for k in decades if k % every == 0 for step in steps]
        ticks = [tick for tick in ticks if low <= tick <= high]
        gaps = [inches * math.log(b / a) / math.log(high / low) for a, b in pairwise(ticks)]
        if min(gaps, default=_APART) >= _APART:
            break
    axes.xaxis.set_major_locator(FixedLocator(ticks))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"× {value:g}"))


def _upwards(axes: Axes) -> None:
    low, high = axes.get_ylim()
    decades = range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)
    axes.yaxis.set_major_locator(FixedLocator([10.0**k for k in decades]))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(
        FuncFormatter(lambda value, _: f"{100 * value:g} %" if value < 10 else f"{value:g} ×")
    )


def _notes(pricing: Pricing, rows: Sequence[PricingRow]) -> list[str]:
    """What the points cannot say."""
    said = [
        "Ratios are with the effect over without it. What needs it is left out of both runs, what it needs is in both."
    ]
    if any(row.share is not None and row.share <= _UNSEEN * pricing.scene.run.accuracy for row in rows):
        said.append(f"On the lowest line: {percent(_UNSEEN * pricing.scene.run.accuracy)} or less.")
    ends = [
        f"{'without' if row.in_force else 'with'} {row.effect}, {row.variant.outcome.name}"
        for row in rows
        if row.variant is not None and row.fails
    ]
    if ends:
        said.append(f"Not to be trusted, and not drawn: {'; '.join(ends)}.")
    return [line for text in said for line in textwrap.wrap(text, 112)]


def _explain(figure: Figure, pricing: Pricing, notes: Sequence[str]) -> None:
    height = figure.get_size_inches()[1]
    handles = [Line2D([], [], linestyle="none", markersize=5.5, label=name, **mark) for name, mark in _MARKS.items()]
    asked = f"accuracy asked, {percent(pricing.scene.run.accuracy)}"
    handles.append(Line2D([], [], color=style.GREY, linewidth=0.9, linestyle=(0, (4, 2)), label=asked))
    place = (_LEFT / style.WIDTH, (0.32 + _LINE * len(notes)) / height)
    figure.legend(handles=handles, loc="center left", bbox_to_anchor=place, ncols=4, borderaxespad=0.0, columnspacing=1)
    for k, line in enumerate(reversed(notes)):
        figure.text(_LEFT / style.WIDTH, (0.08 + _LINE * k) / height, line, fontsize=7.5, color=style.GREY)
