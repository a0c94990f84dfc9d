"""The picture of a sag card: the final shape, the descent with the rules beside it, and what moves the longest span."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from softcat_sym.plotting import style
from softcat_sym.plotting.card_terminal import exponents
from softcat_sym.plotting.section import (
    Floats,
    Section,
    outline,
    quads_outside,
    section_at,
    vertical_stretch,
    yielding_of,
)
from softcat_sym.plotting.style import (
    HEADING,
    Unit,
    axes_in_inches,
    head,
    length_unit,
    new_figure,
    shown_part,
    significant,
    time_unit,
)
from softcat_sym.studies.card_rules import percent

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.studies.card_rules import Card, Rule

_LEFT, _RIGHT, _BETWEEN, _BOTTOM, _LOW = 0.65, 0.2, 0.78, 0.52, 1.95
_TALLEST, _LEAST = 1.7, 0.55
_CURVE, _MARKS, _NAMES = 2.0, 1.87, 1.12
_ABOVE = 1.35
"""Height of the curve's axes over the largest sag that is shown."""

_SHOWN = 2.5
"""A rule that predicts more than this many times the sag is named at the edge."""


def card_figure(card: Card) -> Figure:
    """Draw the card's picture."""
    data, summary = shown_part(card.run.data, card.summary)
    card = replace(card, run=replace(card.run, data=data))
    ends = card.scene.ends
    section = section_at(card.run.data, -1, (ends.left == "clamped", ends.right == "clamped"))
    body = outline(section)
    stretch = vertical_stretch(float(np.ptp(section.y)), card.scene.filament.thickness, card.scene.filament.span)
    width = style.WIDTH - _LEFT - _RIGHT
    across = float(np.ptp(body[:, 0])) * 1.04
    tall = float(np.ptp(body[:, 1])) * 1.15 * stretch / across * width
    drawn = min(max(tall, _LEAST), _TALLEST)
    with style.styled():
        figure = new_figure(style.WIDTH, _BOTTOM + _LOW + _BETWEEN + drawn + HEADING)
        head(figure, _caption(stretch), summary, card.scene, 0.2)
        shape = axes_in_inches(figure, _LEFT, _BOTTOM + _LOW + _BETWEEN, width, drawn)
        _shape(shape, card, section, body, width / drawn, stretch)
        _curve(axes_in_inches(figure, _LEFT, _BOTTOM, _CURVE, _LOW), card)
        left = _LEFT + _CURVE + _MARKS + _NAMES
        _bars(axes_in_inches(figure, left, _BOTTOM, style.WIDTH - _RIGHT - left, _LOW), card)
    return figure


def _caption(stretch: float) -> str:
    scaled = "" if stretch == 1 else f", heights and thickness × {stretch:g}"
    return f"shape at the end{scaled}"


def _shape(axes: Axes, card: Card, section: Section, body: Floats, aspect: float, stretch: float) -> None:
    """The filament with what has yielded; one scale along both axes but for the stretch."""
    limit = card.scene.material.yield_stress
    ruler = length_unit(card.scene.filament.span)
    (inside,) = axes.fill(*ruler.of(body).T, facecolor=style.FILAMENT, edgecolor="none", zorder=2)
    handles = []
    if limit is not None:
        for colour, now, label in ((style.ORANGE, False, "has yielded"), (style.VERMILLION, True, "yields at the end")):
            quads = quads_outside(section, *_core(card, now=now))
            if len(quads):
                patch = PolyCollection(list(ruler.of(quads)), facecolors=colour, edgecolors="none", antialiaseds=False)
                patch.set_zorder(4 if now else 3)
                axes.add_collection(patch, autolim=False)
                # At a clamp the sections of the first cell cross: what they cover beyond the body is none.
                patch.set_clip_path(inside)
                handles.append(Patch(facecolor=colour, label=label))
    axes.fill(*ruler.of(body).T, facecolor="none", edgecolor=style.BLACK, linewidth=0.5, zorder=5)
    centre = ruler.of(body.min(axis=0) + body.max(axis=0)) / 2
    half = 0.52 * float(ruler.of(np.ptp(body[:, 0])))
    axes.set_xlim(centre[0] - half, centre[0] + half)
    high = max(half / aspect / stretch, 0.54 * float(ruler.of(np.ptp(body[:, 1]))))
    axes.set_ylim(centre[1] - high, centre[1] + high)
    axes.plot(ruler.of(section.x[[0, -1]]), ruler.of(section.y[[0, -1]]), ":", color=style.GREY, lw=0.7)
    axes.yaxis.set_major_locator(MaxNLocator(3))
    axes.set_xlabel(f"x [{ruler.symbol}]", labelpad=1)
    axes.set_ylabel(f"y [{ruler.symbol}]")
    style.lighten(axes)
    if handles:
        axes.legend(handles=handles, loc="lower center", ncols=2, bbox_to_anchor=(0.5, 0.98), borderaxespad=0.0)


def _core(card: Card, *, now: bool) -> tuple[Floats, Floats]:
    """Limits in zeta between which no fibre yields at the end, or none ever did, shape (cell,)."""
    found = yielding_of(card.run.data, card.scene)
    if now:
        return found.low[-1], found.high[-1]
    low, high = np.max(found.low, axis=0), np.min(found.high, axis=0)
    return np.minimum(low, high), np.maximum(low, high)


def _curve(axes: Axes, card: Card) -> None:
    """Sag over time, downwards, and what the rules say of it."""
    data = card.run.data
    time, sag = data["time"].values, -data["midpoint"].values
    clock, ruler = time_unit(float(time[-1])), length_unit(float(np.max(np.abs(sag))), card.scene.filament.span)
    axes.plot(clock.of(time), ruler.of(sag), color=style.BLUE, zorder=3)
    final = float(sag[-1])
    rules = [one for one in card.rules if one.unit == "m" and one.predicted is not None]
    inside = [one for one in rules if (one.predicted or 0.0) <= _SHOWN * float(np.max(sag))]
    deepest = max([float(np.max(sag)), *((one.predicted or 0.0) for one in inside)])
    bottom = _ABOVE * deepest if deepest > 0 else 1.0
    axes.set_ylim(float(ruler.of(bottom)), min(0.0, float(ruler.of(np.min(sag)))))
    axes.set_xlim(0.0, float(clock.of(time[-1])))
    found = card.descent
    if found is not None and found.to_90 is not None:
        at = (float(clock.of(found.to_90)), float(ruler.of(0.9 * final)))
        axes.plot(*at, "o", color=style.BLUE, markersize=4, zorder=4)
        axes.annotate("90 %", at, xytext=(4, 4), textcoords="offset points", fontsize=7.5, color=style.BLUE)
    axes.set_xlabel(f"time [{clock.symbol}]")
    axes.set_ylabel(f"sag of the midpoint [{ruler.symbol}]")
    axes.grid(True)
    style.lighten(axes)
    axes.set_title("descent, and what the rules predict", fontsize=8.5, loc="left")
    _marks(axes, rules, ruler, bottom, final)


def _marks(axes: Axes, rules: list[Rule], ruler: Unit, bottom: float, final: float) -> None:
    """A mark at the depth of each rule, names spread out so that none covers another; deeper ones in the last lines."""
    marked = sorted([*rules], key=lambda one: one.predicted or 0.0)
    named = [("solver", final, style.BLUE)]
    named += [
        (f"{one.name} {percent(one.error)}" if one.error is not None else one.name, one.predicted or 0.0, _colour(one))
        for one in marked
    ]
    named.sort(key=lambda one: one[1])
    step = 0.085
    places: list[float] = []
    for _, depth, _ in named:
        wanted = min(depth / bottom, 1.0)
        places.append(max(wanted, places[-1] + step if places else 0.0))
    excess = max(0.0, places[-1] - 1.0)
    for k in range(len(places) - 1, -1, -1):
        # Pushed back up from the lower edge, each above the next.
        ceiling = 1.0 if k == len(places) - 1 else places[k + 1] - step
        places[k] = min(places[k], ceiling) if excess else places[k]
    for (name, depth, colour), place in zip(named, places, strict=True):
        beyond = depth > bottom
        level = 0.0 if beyond else 1 - depth / bottom
        axes.plot(
            [1.0, 1.03, 1.07], [level, level, 1 - place], color=colour, lw=0.9, clip_on=False, transform=axes.transAxes
        )
        text = f"{name} ↓" if beyond else name
        axes.text(1.09, 1 - place, text, transform=axes.transAxes, va="center", fontsize=6.8, color=colour)


def _colour(rule: Rule) -> str:
    return style.GREEN if rule.holds else style.BLACK


def _bars(axes: Axes, card: Card) -> None:
    """Exponents of the longest span, the strongest on top."""
    found = exponents(card)
    if not found:
        axes.set_axis_off()
        note = "longest span:\n" + ("not known" if card.span is None else "nothing moves it")
        axes.text(0.5, 0.5, note, ha="center", va="center", fontsize=8.0, color=style.GREY, transform=axes.transAxes)
        return
    axes.set_title(f"longest span for {style.printable(card.limit, 12)}: exponents", fontsize=8.5, loc="right")
    names, powers = zip(*found, strict=True)
    places = np.arange(len(found))[::-1]
    colours = [style.BLUE if power > 0 else style.VERMILLION for power in powers]
    axes.barh(places, powers, color=colours, height=0.62, zorder=2)
    widest = 3.2 * max(abs(power) for power in powers)
    axes.set_xlim(-widest, widest)
    axes.set_ylim(-0.6, len(found) - 0.4)
    for place, power in zip(places, powers, strict=True):
        right = power > 0
        axes.annotate(
            significant(round(power, 3)), (power, place), xytext=(3 if right else -3, 0), textcoords="offset points",
            ha="left" if right else "right", va="center", fontsize=7.0,
        )  # fmt: skip
    axes.axvline(0.0, color=style.GREY, lw=0.6)
    axes.set_yticks(places, [style.printable(name, 18) for name in names])
    axes.xaxis.set_major_locator(MaxNLocator(3))
    axes.set_xlabel("d ln span / d ln parameter", loc="right")
    style.lighten(axes)
    axes.tick_params(axis="y", length=0)
