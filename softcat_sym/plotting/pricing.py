"""Effects priced: a chart, tables, files and the terminal."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from softcat_sym.plotting import style
from softcat_sym.plotting.files import csv_bytes, write_results
from softcat_sym.plotting.style import headed, label_points, legend
from softcat_sym.plotting.terminal import text_table
from softcat_sym.plotting.units import significant
from softcat_sym.studies.pricing import DEFINITION, Pricing, Unpriced, percent, reading

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.studies.pricing import PricedRun, PricingRow

_LARGEST = 3
_HEAD = ("scene", "effects in force", "what moves the answer most", "time of everything", "in one sentence")


def rows_csv(pricing: Pricing) -> bytes:
    """A line for each effect and for everything at once; what is not there is empty, every number reads back."""
    lines = [_flat(row) for row in (*pricing.rows, pricing.everything)]
    return csv_bytes(lines[0], (line.values() for line in lines))


def document(pricing: Pricing) -> dict[str, Any]:
    """What ``effects.json`` holds; every number finite or null."""
    return {
        "scene": pricing.name,
        "title": pricing.scene.title,
        "accuracy": pricing.scene.run.accuracy,
        "reading": reading(pricing),
        "definition": DEFINITION,
        "cells": pricing.cells,
        "grading": pricing.grading,
        "base": {"effects": list(pricing.base.effects), "midpoint_largest_m": pricing.scale, **_cost(pricing.base)},
        "effects": [_nested(row) for row in pricing.rows],
        "everything": _nested(pricing.everything),
    }


def pricing_table(pricings: Iterable[Pricing | Unpriced]) -> str:
    """Lay many scenes out as Markdown, a line for each."""
    lines = [_HEAD, ("---",) * len(_HEAD), *map(table_line, pricings)]
    return "".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |\n" for line in lines)


def table_line(one: Pricing | Unpriced) -> tuple[str, ...]:
    """The line of one scene in the table over many."""
    if isinstance(one, Unpriced):
        return (one.name, "", "", "", f"not priced: {one.reason}")
    ratio = None if one.everything.fails else one.everything.time_ratio
    time = "–" if ratio is None else f"× {ratio:.2g}"
    return (one.name or one.scene.title, in_short(one), _largest(one), time, reading(one))


def in_short(pricing: Pricing) -> str:
    """The effects in force, or those left out of what the scene can have, whichever is shorter."""
    # Without a run nothing is known of an effect but that it cannot be had, or cannot be left out.
    absent = [row.effect for row in pricing.rows if not row.in_force and row.variant is not None]
    if len(absent) >= len(pricing.base.effects):
        return ", ".join(pricing.base.effects) or "none"
    return f"all but {', '.join(absent)}" if absent else "all it can have"


def _largest(pricing: Pricing) -> str:
    rows = [row for row in pricing.rows if row.in_force]
    found = sorted(((share, row.effect) for row in rows if (share := row.share)), reverse=True)
    return ", ".join(f"{effect} {percent(share)}" for share, effect in found[:_LARGEST]) or "–"


def _nested(row: PricingRow) -> dict[str, Any]:
    """One effect, with its run."""
    return {
        "effect": row.effect,
        "in_force": row.in_force,
        "also": list(row.also),
        "change": row.change,
        "change_final": row.change_final,
        "own_change": row.own_change,
        "share": row.share,
        "estimate": row.estimate,
        "estimate_is": row.meaning,
        "states_ratio": row.states_ratio,
        "instructions_ratio": row.instructions_ratio,
        "time_ratio": row.time_ratio,
        "run": None if row.variant is None else _cost(row.variant),
        "reason": row.reason,
    }


def _flat(row: PricingRow) -> dict[str, object]:
    nested = _nested(row)
    run = nested.pop("run") or {}
    names = ("states", "algebraic", "instructions", "solve_s", "solver", "outcome", "message")
    return {**nested, "also": " ".join(row.also), **{name: run.get(name) for name in names}}


def _cost(run: PricedRun) -> dict[str, Any]:
    return {
        "states": run.states,
        "algebraic": run.algebraic,
        "instructions": run.instructions,
        "solve_s": run.solve,
        "solver": run.solver,
        "outcome": run.outcome.name,
        "message": run.message,
    }


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
    """Draw the chart: change of the midpoint upwards, ratios with the effect over without it to the right."""
    # Everything is a point of its own only where it is more than the base.
    rows = [*pricing.rows, *([pricing.everything] if pricing.everything.also else [])]
    shown = [row for row in rows if row.share is not None and row.time_ratio is not None]
    accuracy = pricing.scene.run.accuracy
    heights = [max(row.share or 0.0, _UNSEEN * accuracy) for row in shown]
    with style.styled():
        figure, body = headed(
            pricing.scene, "each effect left out or put in, in turn", {"outcome": pricing.base.outcome.name},
            height=4.2, notes="\n".join(_notes(pricing, rows)),
        )  # fmt: skip
        panels = body.subplots(1, 3, sharey=True, width_ratios=[3, 1, 1])
        panels[0].set_yscale("log")
        # Room for names above and below.
        panels[0].set_ylim(min([accuracy / 3, *heights]) / 3, 3 * max([10 * accuracy, *heights]))
        _upwards(panels[0])
        handles = [
            Line2D([], [], linestyle="none", markersize=5.5, label=name, **mark) for name, mark in _MARKS.items()
        ]
        asked = f"accuracy asked, {percent(accuracy)}"
        handles.append(Line2D([], [], color=style.GREY, linewidth=0.9, linestyle=(0, (4, 2)), label=asked))
        legend(body, handles=handles, ncols=4)
        # Ticks and names go where there is room for them.
        figure.draw_without_rendering()
        ratios = ("time_ratio", "states_ratio", "instructions_ratio")
        for axes, ratio, name in zip(panels, ratios, ("solve time", "unknowns", "instructions"), strict=True):
            points = [(getattr(row, ratio), height) for row, height in zip(shown, heights, strict=True)]
            _panel(axes, points, shown, accuracy)
            axes.set_xlabel(name)
        panels[0].set_ylabel("change of the midpoint / its largest")
        figure.draw_without_rendering()
        figure.set_layout_engine("none")
        times = [row.time_ratio or 1.0 for row in shown]
        label_points(panels[0], list(zip(times, heights, strict=True)), [row.effect for row in shown])
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
    return said


_NOTE = (
    "change of the midpoint, of its largest; own: without what goes along; expected: the estimate before the run;\n"
    "unknowns, instructions, time: with the effect over without it"
)

_LEAST = 1e-6


def row_texts(row: PricingRow) -> tuple[str, ...]:
    """Effect, in or out, change, own share, expected, and the ratios of unknowns, instructions and solve time."""
    amounts = (_share(value) for value in (row.change, row.share, row.estimate))
    ratios = (_ratio(value) for value in (row.states_ratio, row.instructions_ratio, row.time_ratio))
    return (row.effect, "" if row.variant is None else "out" if row.in_force else "in", *amounts, *ratios)


def pricing_columns(pricing: Pricing) -> Table:
    """Lay the rows out as a table for the terminal."""
    names = ("effect", "", "change", "own", "expected", "un-\nknowns", "instruc-\ntions", "time")
    rows = [row_texts(row) for row in (*pricing.rows, pricing.everything)]
    title = pricing.scene.title or "Filament"
    looks: dict[str, Any] = {"right": range(2, 8), "whole": range(9), "padding": (0, 1, 0, 0)}
    return text_table(names, rows, title=title, caption=_NOTE, **looks)


def remarks(pricing: Pricing) -> list[str]:
    """What went along, what failed, and why some were not run."""
    found = []
    for row in (*pricing.rows, pricing.everything):
        word = "without" if row.in_force else "with"
        if row.fails and row.variant is not None:
            found.append(f"{word} {row.effect}: {row.variant.outcome.name}; {row.variant.message}".rstrip("; "))
        if row.also:
            found.append(f"{word} {row.effect}: {'also' if row.in_force else 'and'} {word} {', '.join(row.also)}")
        if row.reason:
            found.append(f"{row.effect}: {row.reason}")
    return found


def print_pricing(pricing: Pricing, console: Console | None = None) -> None:
    """Print the table, the remarks and the sentence."""
    from rich.console import Console
    from rich.text import Text

    screen = console or Console()
    screen.print(pricing_columns(pricing))
    for text in remarks(pricing):
        screen.print(Text(text, style="dim"))
    screen.print(Text(f"{reading(pricing)}."))


def write_pricing(pricing: Pricing, directory: str | Path) -> list[Path]:
    """Write ``effects.json``, ``effects.csv``, ``effects.png`` and ``scene.toml``."""
    contents = {
        "effects.json": document(pricing),
        "effects.csv": rows_csv(pricing),
        "effects.png": pricing_figure(pricing),
        "scene.toml": pricing.scene.to_toml(),
    }
    return write_results(directory, contents)


def write_pricings(pricings: Iterable[Pricing | Unpriced], directory: str | Path) -> list[Path]:
    """Write ``effects_<scene>.json`` and ``.png`` of each scene as it comes, and ``pricing.md`` over all so far."""
    done: list[Pricing | Unpriced] = []
    written: dict[Path, None] = {}
    for one in pricings:
        done.append(one)
        contents: dict[str, object] = {"pricing.md": pricing_table(done)}
        if not isinstance(one, Unpriced):
            contents[f"effects_{one.name}.json"] = document(one)
            contents[f"effects_{one.name}.png"] = pricing_figure(one)
        written |= dict.fromkeys(write_results(directory, contents))
    return list(written)


def _share(value: float | None) -> str:
    if value is None:
        return "–"
    if 0 < value < _LEAST:
        return f"< {percent(_LEAST)}"
    return percent(value) if value < 10 else f"× {significant(value)}"


def _ratio(value: float | None) -> str:
    return "–" if value is None else f"{value:.2g}" if value < 100 else f"{value:.0f}"
