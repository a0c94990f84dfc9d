"""Effects priced: a chart, tables, files and the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import pandas as pd
from matplotlib.figure import Figure
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report, TextTable
from softcat_sym.plotting import style
from softcat_sym.plotting.style import legend, plain_log, styled, titled_figure
from softcat_sym.studies.effect_importance import Pricing, PricingRow, percent

_HEAD = ("scene", "effects in force", "time of everything", "in one sentence")


def pricing_table(pricings: Mapping[str, Pricing | str]) -> str:
    """Lay many scenes out as Markdown, a line for each; a text says why a scene could not be priced."""
    lines = [_HEAD, ("---",) * len(_HEAD)]
    for name, each in pricings.items():
        if isinstance(each, str):
            lines.append((name, "", "", f"not priced: {each}"))
            continue
        ratio = None if each.everything.fails else each.everything.to_dict()["time_ratio"]
        effects = ", ".join(each.base.effects) or "none"
        lines.append((name, effects, "–" if ratio is None else f"× {ratio:.2g}", each.reading))
    return "".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |\n" for line in lines)


_SMALLEST = 1e-3
"""Changes below this share of the accuracy asked are drawn there: solver tolerances make the rest."""

_MARKS: dict[str, dict[str, Any]] = {
    "in force, left out": {"marker": "o", "markersize": 5.5, "color": style.BLUE},
    "not in force, put in": {"marker": "D", "markersize": 5.0, "color": style.VERMILLION, "markerfacecolor": "white"},
    "everything at once": {"marker": "s", "markersize": 5.5, "color": style.BLACK},
}
_RATIOS = {"solve time (×)": "time_ratio", "unknowns (×)": "states_ratio", "instructions (×)": "instructions_ratio"}
_NOTE = "Ratios are with the effect over without it. What needs it is left out of both runs, what it needs is in both."


@drawing.plot.register(Pricing)
@styled()
def pricing_figure(pricing: Pricing) -> Figure:
    """Draw a row an effect: change of the midpoint, and ratios with the effect over without it."""
    # Everything is a point of its own only where it is more than the base.
    rows = [*pricing.rows, *([pricing.everything] if pricing.everything.also else [])]
    found = [(row, row.to_dict()) for row in rows]
    shown = [pair for pair in found if pair[1]["share"] is not None and pair[1]["time_ratio"] is not None]
    shown.sort(key=lambda pair: -pair[1]["share"])
    accuracy, lost = pricing.scene.run.accuracy, "; ".join(text for row in rows if row.fails for text in _failure(row))
    figure, body = titled_figure(
        pricing.scene, "each effect left out or put in, in turn", {"outcome": pricing.base.outcome.name},
        height=1.4 + 0.22 * len(shown), notes=_NOTE + (f"\nNot to be trusted, and not drawn: {lost}." if lost else ""),
    )  # fmt: skip
    panels = body.subplots(1, 4, sharey=True, width_ratios=[3, 2, 2, 2])
    table = pd.DataFrame([values for _, values in shown], columns=["share", *_RATIOS.values()])
    table["share"] = table["share"].clip(lower=_SMALLEST * accuracy)
    kinds = ["everything at once" if row is pricing.everything else list(_MARKS)[not row.in_force] for row, _ in shown]
    names = ["change of the midpoint", *_RATIOS]
    for axes, name, column in zip(panels, names, table, strict=True):
        axes.set_xscale("log")
        for kind, mark in _MARKS.items():
            picked = [k for k, each in enumerate(kinds) if each == kind]
            if picked:  # The legend would have it, too
                axes.plot(table[column][picked], picked, linestyle="none", label=kind, **mark)
        low, high = (accuracy / 3, 10 * accuracy) if axes is panels[0] else (0.8, 1.25)
        axes.update_datalim([(low, 0.0), (high, 1.0)])
        axes.set_xlabel(name)
        axes.margins(x=0.12)
        axes.grid(True)
        axes.tick_params(axis="x", labelsize=7)
    for axes in panels[1:]:
        axes.axvline(1.0, color=style.GREY, linewidth=0.5, zorder=1)
        plain_log(axes.xaxis, ticks=3)
    change, asked = panels[0], f"accuracy asked, {percent(accuracy)}"
    change.axvline(accuracy, color=style.GREY, linestyle="--", linewidth=0.9, label=asked)
    plain_log(change.xaxis, lambda share: f"{100 * share:g} %", 4)
    change.set_yticks(range(len(shown)), [row.effect for row, _ in shown])
    change.invert_yaxis()
    legend(body, of=change, ncols=4)
    return figure


def _failure(row: PricingRow) -> Iterator[str]:
    """How a run that is not to be trusted ended."""
    if row.variant is not None and row.fails:
        yield f"{'without' if row.in_force else 'with'} {row.effect}: {row.variant.outcome.name}"


_CAPTION = (
    "change of the midpoint, of its largest; own: without what goes along; expected: the estimate before the run;\n"
    "unknowns, instructions, time: with the effect over without it"
)


def remarks(pricing: Pricing) -> list[str]:
    """What went along, what failed, and why some were not run."""
    found = []
    for row in (*pricing.rows, pricing.everything):
        word = "without" if row.in_force else "with"
        for text in _failure(row):
            found.append(f"{text}; {row.variant.message if row.variant else ''}".rstrip("; "))
        if row.also:
            found.append(f"{word} {row.effect}: {'also' if row.in_force else 'and'} {word} {', '.join(row.also)}")
        if row.reason:
            found.append(f"{row.effect}: {row.reason}")
    return found


@drawing.report.register(Pricing)
def pricing_report(pricing: Pricing) -> Report:
    """The table of effects, the remarks and the sentence."""
    names = ("effect", "", "change", "own", "expected", "un-\nknowns", "instruc-\ntions", "time")
    rows = []
    for row in (*pricing.rows, pricing.everything):
        side, values = "" if row.variant is None else "out" if row.in_force else "in", row.to_dict()
        amounts = ["–" if values[key] is None else percent(values[key]) for key in ("change", "share", "estimate")]
        ratios = [values[key] for key in ("states_ratio", "instructions_ratio", "time_ratio")]
        costs = ["–" if value is None else f"{value:.2g}" if value < 100 else f"{value:.0f}" for value in ratios]
        rows.append((row.effect, side, *amounts, *costs))
    title = pricing.scene.title or "Filament"
    shown = TextTable(names, rows, range(2, 8), title=title, caption=_CAPTION, whole=range(8))
    files = {
        "effects.json": pricing.to_dict,
        "effects.csv": pricing.to_frame,
        "effects.png": pricing.plot,
        "scene.toml": pricing.scene.to_toml,
    }
    return Report(files, [shown, *(Text(text, style="dim") for text in remarks(pricing)), Text(f"{pricing.reading}.")])
