"""Files and terminal output of ``softcat accuracy``."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.files import write_all
from softcat_sym.report.accuracy_tables import document, knee_rows, knee_sentence, points_csv, program_rows, refusals
from softcat_sym.report.canvas import png
from softcat_sym.report.work_precision import WorkCurve, WorkPanel, WorkPoint, work_precision_figure
from softcat_sym.study.work_precision import LEVELS

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.study.work_precision import WorkPrecision

_MARKS = "Dashed: what the package does not run. Shaded: below what the reference can tell."


def write_accuracy(found: WorkPrecision, directory: str | Path) -> list[Path]:
    """Write ``accuracy.csv``, ``accuracy.json``, ``accuracy.png`` and ``scene.toml``.

    Raises
    ------
    ValueError
        If no run has an answer.
    OSError
        If the folder cannot be made or written.
    """
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
