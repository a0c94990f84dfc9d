"""What accuracy costs: the work-precision diagram, the files and the terminal output of ``softcat accuracy``."""

from __future__ import annotations

from itertools import cycle
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report, TextTable
from softcat_sym.plotting import style
from softcat_sym.plotting.style import legend, log_axes, printable
from softcat_sym.progress import seconds_text
from softcat_sym.studies.work_precision import LEVELS, WorkPrecision

_COLOURS = (
    *(style.BLUE, style.VERMILLION, style.ORANGE, style.GREEN, style.PURPLE),
    *(style.SKY, style.BLACK, style.GREY),
)
_MARKS = ("o", "s", "^", "D", "v", "P", "X")
_USELESS = 0.3
"""A relative error that no axis is stretched for."""


def front(runs: pd.DataFrame) -> pd.DataFrame:
    """Runs that no other run beats in both ``seconds`` and ``error``, by growing time and falling error."""
    ranked = runs[np.isfinite(runs["error"].astype(float))].sort_values(["seconds", "error"])
    return ranked[ranked["error"] < ranked["error"].cummin().shift(fill_value=np.inf)]


def _refusals(found: WorkPrecision) -> list[str]:
    """Why programs have no answer at all."""
    return [f"{found.names[key]}: {why}" for key, why in found.refusals.items()]


@drawing.plot.register(WorkPrecision)
@style.styled()
def accuracy_figure(found: WorkPrecision) -> Figure:
    """Draw error against time, one line a program that has an answer."""
    runs = found.runs[~found.runs["key"].isin(found.refusals)].astype({"seconds": float, "error": float})
    drawn, programs = runs[np.isfinite(runs["error"])], list(dict.fromkeys(runs["program"]))
    if drawn.empty:
        raise ValueError("there is no run with an error to draw")
    caption = f"{found.sentence} Reference: {found.reference.note}. Shaded: below what it can tell."
    if found.refusals:
        caption += f" Without an answer: {'; '.join(_refusals(found))}."
    useful = drawn["error"][drawn["error"] <= _USELESS]
    lowest, floor = float(drawn["error"].min()), found.reference.floor
    figure, body = style.sheet(
        "What accuracy costs: error of the midpoint", height=4.2 + 0.2 * -(-len(programs) // 4),
        notes=f"{caption} Pale: all settings; joined: the best. Dashed: what the package does not run.", columns=122,
    )  # fmt: skip
    axes = body.subplots()
    for program, colour, marker in zip(programs, cycle(_COLOURS), cycle(_MARKS), strict=False):
        own, look = drawn[drawn["program"] == program], dict[str, Any](color=colour, marker=marker)
        axes.plot(own["seconds"], own["error"], linestyle="none", markersize=3, alpha=0.3, mew=0, **look)
        best, line = front(own), "--" if (own["kind"] == "rival").any() else "-"
        look |= {"linestyle": line, "label": printable(program, 50)}
        axes.plot(best["seconds"], best["error"], markersize=4, **look)
    if floor:
        axes.axhspan(floor / 10, floor, color=style.FILAMENT, lw=0, zorder=0)
    axes.set_title(printable(found.scene.title or found.name), fontsize=9, loc="left", parse_math=False)
    axes.grid(True)
    axes.margins(0.05)
    highest = float((useful if len(useful) else drawn["error"]).max())
    log_axes(axes, ylim=(min(lowest, floor or lowest) / 1.6, 1.6 * highest))
    axes.set(xlabel="processor time [s]", ylabel="relative error")
    legend(body, "upper left", of=axes, ncols=4)
    return figure


def program_rows(found: WorkPrecision) -> list[tuple[str, ...]]:
    """For each program: its best time at each error, one step, and whether it was cut off."""
    rows: list[tuple[str, ...]] = []
    for key, runs in found.runs.groupby("key", sort=False):
        best = [found.knee(level, f"key == '{key}'") for level in LEVELS]
        times = ["–" if run is None else seconds_text(run["seconds"]) for run in best]
        # Of a step on the grid of 40 cells, or on the nearest.
        counted = runs.dropna(subset=["error", "us_per_step"])
        step = counted["us_per_step"].iloc[int(abs(counted["cells"] - 40).argmin())] if len(counted) else None
        cut = "no answer" if key in found.refusals else "cut off" if key in found.cut else ""
        rows.append((found.names[str(key)], *times, "" if step is None else f"{step:.3g}", cut))
    return rows


@drawing.report.register(WorkPrecision)
def accuracy_report(found: WorkPrecision) -> Report:
    """What each program takes to which error, and what the reference is worth."""
    header = ("program", *(f"{100 * level:g} %" for level in LEVELS), "us/step", "")
    title = f"{found.scene.title or found.name}: quickest warm solve with at most this error"
    lines = [f"No answer: {line}" for line in _refusals(found)]
    lines += [found.sentence, f"Reference: {found.reference.note}."]
    files = {
        "accuracy.csv": found.to_frame,
        "accuracy.json": found.to_dict,
        "accuracy.png": found.plot,
        "scene.toml": found.scene.to_toml,
    }
    return Report(files, [TextTable(header, program_rows(found), title=title), *map(Text, lines)])
