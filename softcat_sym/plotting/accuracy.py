"""What accuracy costs: words, rows, one document, the files and terminal output of ``softcat accuracy``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isclose, isfinite, log10
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from rich.console import Console

from softcat_sym.plotting import style
from softcat_sym.plotting.files import Quoted, csv_bytes, write_results
from softcat_sym.plotting.style import legend
from softcat_sym.plotting.terminal import text_table
from softcat_sym.studies.work_precision import LEVELS
from softcat_sym.studies.work_precision_programs import Measured

if TYPE_CHECKING:
    from softcat_sym.studies.work_precision import Curve, Row, WorkPrecision

_COLOURS = (
    *(style.BLUE, style.VERMILLION, style.ORANGE, style.GREEN, style.PURPLE),
    *(style.SKY, style.BLACK, style.GREY),
)
_MARKS = ("o", "s", "^", "D", "v", "P", "X")
_USELESS = 0.3
"""A relative error that no axis is stretched for."""

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True)
class WorkPoint:
    """One run."""

    seconds: float  # What it took, above zero [s]
    error: float  # Relative error of the answer, above zero; not finite for a run that failed, which is not drawn
    setting: str = ""  # What was set, such as ``"40 cells, rtol 1e-3"``; for the table


@dataclass(frozen=True, slots=True)
class WorkCurve:
    """All runs of one program; that of a rival is dashed."""

    name: str
    points: tuple[WorkPoint, ...]
    is_rival: bool = False


@dataclass(frozen=True, slots=True)
class WorkPanel:
    """Programs on one problem."""

    title: str
    curves: tuple[WorkCurve, ...]


def front(points: Sequence[WorkPoint]) -> tuple[WorkPoint, ...]:
    """Runs that no other run beats in both time and error, by growing time and falling error."""
    best: list[WorkPoint] = []
    for point in sorted(points, key=lambda p: (p.seconds, p.error)):
        if isfinite(point.error) and (not best or point.error < best[-1].error):
            best.append(point)
    return tuple(best)


def seconds_for(points: Sequence[WorkPoint], error: float) -> float | None:
    """Time of the quickest run with at most this error [s]; None if there is none."""
    return min((point.seconds for point in points if point.error <= error), default=None)


def work_precision_figure(
    panels: Sequence[WorkPanel], title: str, caption: str = "", floor: float | None = None
) -> Figure:
    """Draw one panel a problem, two in a row, all on the same axes."""
    drawn = [p for panel in panels for curve in panel.curves for p in curve.points if isfinite(p.error)]
    if not drawn:
        raise ValueError("there is no run with an error to draw")
    columns = min(2, len(panels))
    rows = -(-len(panels) // columns)
    names = list(dict.fromkeys(curve.name for panel in panels for curve in panel.curves))
    height = (4.2 if len(panels) == 1 and floor else 2.7 * rows) + 0.2 * -(-len(names) // 4)
    errors = [p.error for p in drawn if p.error <= _USELESS] or [p.error for p in drawn]
    limits = _limits([p.seconds for p in drawn]), _limits(errors + ([floor] if floor else []))
    with style.styled():
        figure, body = style.sheet(title, height=height, notes=caption, columns=122)
        each = body.subplots(rows, columns, squeeze=False)
        for number, axes in enumerate(each.flat):
            if number >= len(panels):
                axes.remove()
                continue
            _draw_panel(axes, panels[number], names, limits)
            if floor:
                axes.axhspan(limits[1][0], floor, color=style.FILAMENT, lw=0, zorder=0)
            axes.set_ylabel("" if number % columns else "relative error")
            axes.set_xlabel("seconds")
        legend(body, "upper left", handles=each.flat[0].get_legend_handles_labels()[0], ncols=4)
    return figure


def work_precision_csv(panels: Sequence[WorkPanel]) -> bytes:
    """One row a run: problem, program, setting, seconds, error; empty where a run failed."""
    rows = []
    for panel in panels:
        for curve in panel.curves:
            best = set(front(curve.points))
            for point in curve.points:
                texts = (Quoted(text) for text in (panel.title, curve.name, point.setting))
                rows.append((*texts, float(point.seconds), float(point.error), int(point in best)))
    return csv_bytes(("problem", "program", "setting", "seconds", "relative_error", "on_front"), rows)


def draw(panels: Sequence[WorkPanel], path: str | Path, title: str, caption: str = "") -> list[Path]:
    """Write the picture to `path`, a PNG, and its numbers beside it as CSV."""
    place, figure = Path(path), work_precision_figure(panels, title, caption)
    return write_results(place.parent, {place.name: figure, f"{place.stem}.csv": work_precision_csv(panels)})


def power_of_ten(value: float, place: float = 0) -> str:
    """Tick label of a decade without Mathtext, whose fonts not every machine has; other values are not labelled."""
    del place
    power = round(log10(value))
    return f"10{str(power).translate(_SUPERSCRIPT)}" if isclose(value, 10.0**power, rel_tol=1e-9) else ""


def _draw_panel(
    axes: Axes, panel: WorkPanel, names: Sequence[str], limits: tuple[tuple[float, float], tuple[float, float]]
) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(*limits[0])
    axes.set_ylim(*limits[1])
    axes.grid(True)
    axes.minorticks_off()
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(power_of_ten)
    for name in names:
        named = [curve for curve in panel.curves if curve.name == name]
        points = [point for curve in named for point in curve.points]
        line = "--" if any(curve.is_rival for curve in named) else "-"
        number = names.index(name)
        colour, mark = _COLOURS[number % len(_COLOURS)], _MARKS[number % len(_MARKS)]
        shown = [point for point in points if isfinite(point.error)]
        axes.plot(
            [p.seconds for p in shown], [p.error for p in shown], mark, color=colour, markersize=3, alpha=0.3, mew=0
        )
        best = front(points)
        axes.plot(
            [p.seconds for p in best],
            [p.error for p in best],
            f"{line}{mark}",
            color=colour,
            markersize=4,
            label=style.printable(name, 50),
        )
    axes.set_title(style.printable(panel.title), fontsize=9, loc="left", parse_math=False)
    style.lighten(axes)


def _limits(values: Sequence[float]) -> tuple[float, float]:
    """A little more than the range of positive numbers on a logarithmic axis."""
    low, high = min(values), max(values)
    room = max((high / low) ** 0.06, 1.3)
    return low / room, high * room


_COLUMNS = (
    *("program", "kind", "cells", "grading", "fibres", "order", "tolerance", "seconds", "error", "steps"),
    *("evaluations", "us_per_step", "repeats", "build_s", "message"),
)


def seconds_text(seconds: float) -> str:
    """A time as people read it: ``4.2 ms``, ``1.3 s``."""
    for size, unit in ((1.0, "s"), (1e-3, "ms")):
        if seconds >= size:
            return f"{seconds / size:.2g} {unit}" if seconds < 100 * size else f"{seconds / size:.0f} {unit}"
    return f"{1e6 * seconds:.0f} us"


def knee_sentence(found: WorkPrecision) -> str:
    """What each accuracy costs: ``1e-3 costs 4 ms, 1e-5 costs 30 ms``; what no program reached is said."""
    parts = []
    for level in LEVELS:
        best = found.knee(level)
        name = f"1e-{round(-log10(level))}"
        if level < found.reference.floor:
            parts.append(f"{name} is below what the reference can tell")
        elif best is None:
            parts.append(f"{name} was not reached")
        else:
            parts.append(f"{name} costs {seconds_text(best[1].measured.seconds)}")
    return ", ".join(parts)


def knee_rows(found: WorkPrecision) -> list[tuple[str, str, str, str, str]]:
    """For each error: the quickest run, its settings, time, and how many times longer the best rival takes."""
    rows = []
    for level in LEVELS:
        best, rival = found.knee(level), found.knee(level, ("rival",))
        if best is None or level < found.reference.floor:
            rows.append((f"{level:.0e}", "–", "", "", ""))
            continue
        program, row = best
        ratio = "no rival reached it"
        if rival is not None:
            ratio = f"{rival[1].measured.seconds / row.measured.seconds:.3g} ({rival[0].name})"
        time = seconds_text(row.measured.seconds)
        rows.append((f"{level:.0e}", program.name, row.task.text, time, ratio))
    return rows


def program_rows(found: WorkPrecision) -> list[tuple[str, ...]]:
    """For each program: its best time at each error, one step, how it starts cold, and how often it failed."""
    rows = []
    for curve in found.curves:
        if curve.refusal:
            rows.append((curve.program.name, *["–"] * len(LEVELS), "", "", "no answer"))
            continue
        times = [best(curve, level) for level in LEVELS]
        texts = [seconds_text(row.measured.seconds) if row is not None else "–" for row in times]
        failed = sum(not isfinite(row.error) for row in curve.rows)
        each = _step(curve)
        step = f"{each:.3g}" if each is not None else ""
        rows.append((curve.program.name, *texts, step, _cold(curve.cold), f"{failed} failed" if failed else ""))
    return rows


def refusals(found: WorkPrecision) -> list[str]:
    """Why programs have no answer at all."""
    return [f"{curve.program.name}: {curve.refusal}" for curve in found.curves if curve.refusal]


def best(curve: Curve, error: float) -> Row | None:
    """The quickest run of a program with at most this error."""
    return min((r for r in curve.rows if r.error <= error), key=lambda r: r.measured.seconds, default=None)


def points_csv(found: WorkPrecision) -> bytes:
    """One row a run, failures included; numbers read back exactly."""
    rows = []
    for curve in found.curves:
        for row in curve.rows:
            task, run = row.task, row.measured
            section = ("", task.section) if task.by_order else (task.section or "", "")
            rows.append(
                (
                    *(Quoted(curve.program.name), curve.program.kind, task.cells, task.grading, *section, task.rtol),
                    *(run.seconds or None, row.error, run.steps or None, run.evaluations or None, run.microseconds),
                    *(run.repeats, run.build, Quoted(run.message)),
                )
            )
    return csv_bytes(_COLUMNS, rows)


def document(found: WorkPrecision) -> dict[str, Any]:
    """All of it as plain values."""
    reference = found.reference
    return {
        "scene": found.name,
        "title": found.scene.title,
        "effects": list(found.effects),
        "error": "largest difference of the midpoint from the reference over the largest midpoint",
        "reference": {
            "what": reference.note,
            "families": list(reference.families),
            "space_error": reference.space,
            "families_disagree_by": reference.time if isfinite(reference.time) else None,
            "floor": reference.floor,
            "midpoint_rest_lengths": reference.midpoint.tolist(),
        },
        "grading": found.grading,
        "limit_s": found.limit,
        "knee": knee_sentence(found),
        "knees": [_knee(found, level) for level in LEVELS],
        "programs": [_program(curve) for curve in found.curves],
    }


def _knee(found: WorkPrecision, level: float) -> dict[str, Any]:
    pairs = {"best": found.knee(level), "best_rival": found.knee(level, ("rival",))}
    named = {name: None if pair is None else {"program": pair[0].name, **_row(pair[1])} for name, pair in pairs.items()}
    return {"error": level, **named}


def _program(curve: Curve) -> dict[str, Any]:
    cold = curve.cold
    return {
        "key": curve.program.key,
        "name": curve.program.name,
        "kind": curve.program.kind,
        "refusal": curve.refusal or None,
        "cold": None if cold is None else {"build_s": cold.build, "first_solve_s": cold.first},
        "runs": [_row(row) for row in curve.rows],
    }


def _row(row: Row) -> dict[str, Any]:
    task, run = row.task, row.measured
    return {
        "cells": task.cells,
        "grading": task.grading,
        "fibres": task.section if task.section and not task.by_order else None,
        "order": task.section if task.by_order else None,
        "tolerance": task.rtol,
        "error": row.error if isfinite(row.error) else None,
        "seconds": run.seconds,
        "steps": run.steps or None,
        "evaluations": run.evaluations or None,
        "us_per_step": run.microseconds,
        "repeats": run.repeats,
        "build_s": run.build,
        "message": run.message or None,
    }


def _step(curve: Curve) -> float | None:
    """Microseconds of one step on the grid of 40 cells, or on the first."""
    counted = [row for row in curve.rows if row.measured.microseconds is not None and isfinite(row.error)]
    chosen = min(counted, key=lambda row: abs(row.task.cells - 40), default=None)
    return None if chosen is None else chosen.measured.microseconds


def _cold(cold: Measured | None) -> str:
    if cold is None or cold.message:
        return ""
    return f"{seconds_text(cold.build)} + {seconds_text(cold.first)}"


_MARKS_NOTE = "Dashed: what the package does not run. Shaded: below what the reference can tell."


def write_accuracy(found: WorkPrecision, directory: str | Path) -> list[Path]:
    """Write ``accuracy.csv``, ``accuracy.json``, ``accuracy.png`` and ``scene.toml``."""
    contents = {
        "accuracy.csv": points_csv(found),
        "accuracy.json": document(found),
        "accuracy.png": accuracy_figure(found),
        "scene.toml": found.scene.to_toml(),
    }
    return write_results(directory, contents)


def panel_of(found: WorkPrecision) -> WorkPanel:
    """What is drawn of a study: programs that have an answer."""
    curves = tuple(
        WorkCurve(
            curve.program.name,
            tuple(WorkPoint(r.measured.seconds, r.error, r.task.text) for r in curve.rows),
            is_rival=curve.program.kind == "rival",
        )
        for curve in found.curves
        if not curve.refusal
    )
    return WorkPanel(found.scene.title or found.name, curves)


def accuracy_figure(found: WorkPrecision) -> Figure:
    """Draw error against time, one line a program."""
    lost = refusals(found)
    caption = f"{knee_sentence(found)}. {_reference(found)} {_MARKS_NOTE}"
    if lost:
        caption += f" Without an answer: {'; '.join(lost)}."
    title = "What accuracy costs: error of the midpoint, warm solves"
    return work_precision_figure([panel_of(found)], title, caption, found.reference.floor)


def print_accuracy(found: WorkPrecision, console: Console | None = None) -> None:
    """Print the knee, the programs, and what the reference is worth."""
    terminal = console or Console()
    header = ("program", *(f"{level:.0e}" for level in LEVELS), "us/step", "cold: build + solve", "")
    title = f"{found.scene.title or found.name}: quickest warm solve with at most this error"
    terminal.print(text_table(header, program_rows(found), title=title))
    header = ("error", "quickest", "with", "time", "best rival, times as long")
    terminal.print(text_table(header, knee_rows(found), title="The knee"))
    for line in refusals(found):
        terminal.print(f"No answer: {line}", markup=False, highlight=False)
    terminal.print(f"{knee_sentence(found)}\n{_reference(found)}", markup=False, highlight=False)


def _reference(found: WorkPrecision) -> str:
    reference = found.reference
    apart = (
        f"{' and '.join(reference.families)} differ by {reference.time:.1e} on one grid"
        if isfinite(reference.time)
        else "the second family gave no answer"
    )
    return f"Reference: {reference.note}; {apart}, and {reference.space:.1e} may be left of space."
