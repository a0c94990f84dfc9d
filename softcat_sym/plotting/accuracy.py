"""What accuracy costs: words, rows, one document, the files and terminal output of ``softcat accuracy``."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

from softcat_sym.files import write_all
from softcat_sym.plotting.style import png
from softcat_sym.plotting.work_precision import WorkCurve, WorkPanel, WorkPoint, work_precision_figure
from softcat_sym.studies.work_precision import LEVELS
from softcat_sym.studies.work_precision_programs import Measured

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.studies.work_precision import Curve, Row, WorkPrecision

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
        name = f"1e-{round(-_log10(level))}"
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
    lines = [",".join(_COLUMNS) + "\n"]
    for curve in found.curves:
        for row in curve.rows:
            task, run = row.task, row.measured
            section = ("", task.section) if task.by_order else (task.section or "", "")
            us = run.microseconds
            cells = (
                *(f'"{curve.program.name}"', curve.program.kind, task.cells, repr(task.grading), *section),
                *(repr(task.rtol), repr(run.seconds) if run.seconds else ""),
                *(repr(row.error) if isfinite(row.error) else "", run.steps or "", run.evaluations or ""),
                *("" if us is None else repr(us), run.repeats, repr(run.build)),
                '"' + run.message.replace('"', "'") + '"',
            )
            lines.append(",".join(map(str, cells)) + "\n")
    return "".join(lines).encode()


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


def _log10(value: float) -> float:
    from math import log10

    return log10(value)


_MARKS = "Dashed: what the package does not run. Shaded: below what the reference can tell."


def write_accuracy(found: WorkPrecision, directory: str | Path) -> list[Path]:
    """Write ``accuracy.csv``, ``accuracy.json``, ``accuracy.png`` and ``scene.toml``."""
    contents = {
        "accuracy.csv": points_csv(found),
        "accuracy.json": (json.dumps(document(found), indent=2, allow_nan=False) + "\n").encode(),
        "accuracy.png": accuracy_picture(found),
        "scene.toml": found.scene.to_toml().encode(),
    }
    return write_all(directory, contents)


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


def accuracy_picture(found: WorkPrecision) -> bytes:
    """Draw error against time, one line a program."""
    lost = refusals(found)
    caption = f"{knee_sentence(found)}. {_reference(found)} {_MARKS}"
    if lost:
        caption += f" Without an answer: {'; '.join(lost)}."
    title = "What accuracy costs: error of the midpoint, warm solves"
    return png(work_precision_figure([panel_of(found)], title, caption, found.reference.floor))


def print_accuracy(found: WorkPrecision, console: Console | None = None) -> None:
    """Print the knee, the programs, and what the reference is worth."""
    from rich.console import Console as Terminal

    terminal = console or Terminal()
    header = ("program", *(f"{level:.0e}" for level in LEVELS), "us/step", "cold: build + solve", "")
    title = f"{found.scene.title or found.name}: quickest warm solve with at most this error"
    terminal.print(_table(title, header, program_rows(found)))
    header = ("error", "quickest", "with", "time", "best rival, times as long")
    terminal.print(_table("The knee", header, knee_rows(found)))
    for line in refusals(found):
        terminal.print(f"No answer: {line}", markup=False, highlight=False)
    terminal.print(f"{knee_sentence(found)}\n{_reference(found)}", markup=False, highlight=False)


def _table(title: str, header: Sequence[str], rows: Sequence[Sequence[str]]) -> Table:
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(title=Text(title, style="bold"), title_justify="left", box=box.SIMPLE_HEAD)
    for name in header:
        table.add_column(Text(name))
    for row in rows:
        table.add_row(*map(Text, row))
    return table


def _reference(found: WorkPrecision) -> str:
    reference = found.reference
    apart = (
        f"{' and '.join(reference.families)} differ by {reference.time:.1e} on one grid"
        if isfinite(reference.time)
        else "the second family gave no answer"
    )
    return f"Reference: {reference.note}; {apart}, and {reference.space:.1e} may be left of space."
