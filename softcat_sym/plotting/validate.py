"""Published cases: the table, a page with pictures, and all files."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import cycle
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report, Shown, TextTable
from softcat_sym.plotting import style
from softcat_sym.plotting.style import legend, plain_log, sheet, styled
from softcat_sym.plotting.units import typeset
from softcat_sym.scene.table_reader import counted
from softcat_sym.studies.published.case import Case, DataKind, PublishedValue, published_scene
from softcat_sym.studies.validate import Result, Validation

_LINES = (style.BLUE, style.VERMILLION, style.GREEN, style.ORANGE, style.PURPLE, style.SKY, style.BLACK)
_NAMED = 8
"""More curves than this are told apart by no legend."""


def difference_text(row: PublishedValue) -> str:
    """A difference in the unit of the number, or in per cent; none within a range that is published."""
    if row.agrees and row.band is not None and row.band[0] < row.band[1]:
        return "within"
    if row.is_absolute:
        return f"{row.difference:+.3g} {typeset(row.unit)}".rstrip()
    return f"{100 * row.difference:+.2g} %"


def _number(value: float, unit: str, digits: int) -> str:
    return f"{value:.{digits}g} {typeset(unit)}".rstrip()


def _published(row: PublishedValue) -> str:
    if row.band is None:
        return _number(row.published, row.unit, 4)
    low, high = row.band
    return _number(low, row.unit, 4) if low == high else f"{low:g} to {high:g} {typeset(row.unit)}".rstrip()


def _texts(row: PublishedValue, case: Case) -> tuple[str, str, str]:
    """What is published, ours, and the difference; what is assumed does not differ by being right."""
    apart = "assumed" if case.kind is DataKind.ASSUMED else difference_text(row)
    return _published(row), _number(row.ours, row.unit, 4), apart


def _remark(result: Result) -> str:
    """What may explain a difference, or why there is none."""
    if result.not_run:
        return f"not run: {result.not_run}"
    return f"no answer: {result.failure}" if result.failure else result.case.explains


def summary_of(validation: Validation) -> str:
    """One sentence on how many cases there are."""
    results = validation.results
    idle, failed = sum(bool(one.not_run) for one in results), len(validation.failures)
    assumed = sum(one.finding is not None and one.case.kind is DataKind.ASSUMED for one in results)
    compared = counted(len(results) - idle - failed - assumed, "case")
    parts = [f"{compared} compared", f"{assumed} assumed", f"{idle} not run"]
    return ", ".join([*parts, *([f"{failed} without an answer"] if failed else [])])


_VERDICTS = {None: "", True: "within what is published", False: "outside what is published"}


def shown(result: Result) -> Iterator[Shown]:
    """A case: its source, its numbers, and what may explain a difference."""
    case, numbers = result.case, result.finding.rows if result.finding else ()
    yield Text(f"\n{case.name}: {case.title} ({case.kind})", style="bold")
    yield Text(case.source, style="dim")
    if numbers:
        rows = [(row.quantity, *_texts(row, case), _VERDICTS[row.agrees]) for row in numbers]
        yield TextTable(("", "published", "ours", "difference", ""), rows, (1, 2, 3))
    yield Text(_remark(result), style="yellow" if result.not_run else "red" if result.failure else "dim")


@drawing.plot.register(Result)
@styled()
def case_figure(result: Result) -> Figure:
    """Draw what was run, as lines, beside what is published, as points."""
    case, picture = result.case, None if result.finding is None else result.finding.picture
    figure, body = sheet(case.title, case.source, height=3.1)
    axes = body.subplots()
    if picture is None:
        axes.set_axis_off()
        return figure
    drawn, many, colour = cycle(_LINES), len(picture.curves) > _NAMED, style.BLUE
    for curve in picture.curves:
        look: dict[str, Any] = {"linestyle": "none", "marker": "o", "markersize": 4.5, "markerfacecolor": "white"}
        if not curve.is_published or many:
            colour = next(drawn)
        if not curve.is_published:
            look = {"linewidth": 1.4}
        elif many:
            look = {"linewidth": 0.6, "marker": ".", "markersize": 3.0}
        axes.plot(curve.x, curve.y, color=colour, label=curve.label, **look)
    for place, draw in ((picture.published_x, axes.axvline), (picture.published_y, axes.axhline)):
        if place is not None:
            draw(place, color=style.GREY, linestyle="--", linewidth=1.0, label=f"published, {place:.4g}")
    axes.set(xlabel=picture.x, ylabel=picture.y)
    axes.margins(x=0.03, y=0.06)
    for name in "x" * picture.is_log_x + "y" * picture.is_log_y:
        axes.set(**{f"{name}scale": "log"})
        plain_log(getattr(axes, f"{name}axis"))
    axes.grid(True)
    if not many:
        legend(body, "lower center", ncols=2)
    return figure


def _relative(validation: Validation) -> list[tuple[str, float]]:
    """Names and relative differences of what is compared."""
    return [
        (f"{result.case.name}: {row.quantity}", row.difference)
        for result in validation.results
        if result.finding is not None and result.case.kind is not DataKind.ASSUMED
        for row in result.finding.rows
        if not row.is_absolute
    ]


@drawing.plot.register(Validation)
@styled()
def validation_figure(validation: Validation) -> Figure:
    """Draw every relative difference as a bar, on a scale that shows a tenth of a per cent and a half alike."""
    found = _relative(validation)
    figure, body = sheet(
        "Held against the world", summary_of(validation), height=0.5 + 0.24 * max(1, len(found)),
        notes="Ours over what is published, minus one; differences in kelvin, decades or counts are in the table.",
    )  # fmt: skip
    axes = body.subplots()
    values, places = np.array([100 * value for _, value in found]), np.arange(len(found))
    axes.barh(places, values, color=[style.BLUE if value >= 0 else style.VERMILLION for value in values], height=0.62)
    axes.set_yticks(places, [style.printable(name, 58) for name, _ in found], fontsize=7.0)
    axes.set_xscale("symlog", linthresh=0.1)
    ticks = (-30, -10, -3, -1, 0, 1, 3, 10, 30)
    axes.set_xticks(ticks, [str(tick) for tick in ticks])
    axes.axvline(0.0, color=style.GREY, lw=0.6)
    axes.invert_yaxis()
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel("difference [%]")
    axes.grid(True, axis="x")
    return figure


@drawing.report.register(Validation)
def validation_report(validation: Validation, command: str = "") -> Report:
    """All cases with their numbers; a picture and the scenes of each, and a page with all of them."""
    results = validation.results
    drawn = {one.case.name: one for one in results if one.finding is not None and one.finding.picture is not None}
    scenes = dict.fromkeys(name for result in results for name in result.case.scenes)
    files: dict[str, object] = {
        "validation.json": validation.to_dict,
        "validation.csv": validation.to_frame,
        "validation.png": validation.plot if _relative(validation) else None,
        **{f"{name}.png": partial(case_figure, result) for name, result in drawn.items()},
        **{f"{name}.toml": published_scene(name).to_toml for name in scenes},
    }
    summary = Text(f"{summary_of(validation)}; no constant is fitted", style="bold")
    texts = [text for one in results for text in shown(one)]
    captions = {"validation": summary_of(validation)} | {name: one.case.title for name, one in drawn.items()}
    return Report(files, [*texts, summary], "Held against the world", "validation.html", captions, command)
