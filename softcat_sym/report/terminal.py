"""The table printed after a run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from softcat_sym.report.units import significant

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.report.contract import PicturedScene, Summary

_RINGS = 1e-3
"""Amplitude over mean from which on the ringing at the end is told."""

STAGES = ("build", "compile", "solve", "estimate", "write", "total")


def summary_rows(summary: Summary, scene: PicturedScene) -> list[tuple[str, str]]:
    """Put a summary into words.

    Parameters
    ----------
    summary : mapping
        What ``summary.json`` holds; missing entries are left out.
    scene : PicturedScene
        Its span makes the midpoint dimensionless.

    Returns
    -------
    list of (str, str)
        Name and text of each row, in the order of reading.
    """
    rows = [("outcome", _outcome(summary))]
    if summary.get("complaint"):
        rows.append(("because", str(summary["complaint"])))
    if summary.get("regime"):
        rows.append(("regime", str(summary["regime"])))
    final = summary.get("midpoint_final_m")
    if final is not None:
        share = significant(final / scene.filament.span)
        rows.append(("final midpoint", f"{significant(1e3 * final)} mm = {share} of the span"))
    rows.extend(_settled(summary))
    rows.append(("error estimate", _estimate(summary.get("error_estimate"))))
    if summary.get("energy_residual") is not None:
        rows.append(("energy residual", f"{significant(summary['energy_residual'])} of the largest energy"))
    rows.append(("effects", _listed(summary.get("effects"))))
    if summary.get("left_out"):
        rows.append(("left out", _left_out(summary)))
    rows.extend(("repeated", str(text)) for text in summary.get("repeats") or ())
    rows.extend(("refined", str(text)) for text in summary.get("refinements") or ())
    parts = [str(summary[key]) for key in ("solver", "backend") if summary.get(key)]
    if summary.get("cells") is not None:
        parts.append(f"{summary['cells']} cells a half span")
    rows.append(("solver", ", ".join(parts) or "not stated"))
    rows.append(("wall time", _wall(summary.get("wall_s"))))
    rows.extend(("converted", str(text)) for text in summary.get("converted") or ())
    rows.extend(("warning", str(text)) for text in summary.get("warnings") or ())
    return rows


def summary_table(summary: Summary, scene: PicturedScene) -> Table:
    """Lay the summary out as a table.

    Parameters
    ----------
    summary : mapping
        What ``summary.json`` holds.
    scene : PicturedScene
        Title and span are read.

    Returns
    -------
    rich.table.Table
        The table; no text of the user's is read as markup.
    """
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(
        title=Text(scene.title or "Filament", style="bold"),
        title_justify="left",
        box=box.SIMPLE_HEAD,
        show_header=False,
    )
    table.add_column(no_wrap=True, style="dim")
    table.add_column(overflow="fold")
    styles = {"outcome": "bold", "warning": "yellow"}
    for name, text in summary_rows(summary, scene):
        table.add_row(Text(name), Text(text, style=styles.get(name, "")))
    return table


def print_summary(summary: Summary, scene: PicturedScene, console: Console | None = None) -> None:
    """Print the summary's table.

    Parameters
    ----------
    summary : mapping
        What ``summary.json`` holds.
    scene : PicturedScene
        Title and span are read.
    console : rich.console.Console or None
        Where to; standard output by default.
    """
    from rich.console import Console

    (console or Console()).print(summary_table(summary, scene))


def _settled(summary: Summary) -> list[tuple[str, str]]:
    """When it has settled, and about which height it rings where it still does."""
    rings, at = summary.get("midpoint_settled_m"), summary.get("settled_s")
    rows = [] if at is None else [("settled", f"after {significant(at)} s")]
    if rings and rings["amplitude"] > _RINGS * abs(rings["mean"]):
        rows.append(
            ("rings about", f"{significant(1e3 * rings['mean'])} mm by {significant(1e3 * rings['amplitude'])} mm")
        )
    return rows


def _outcome(summary: Summary) -> str:
    """Outcome and advice, each on its line."""
    return "\n".join(str(summary[key]) for key in ("outcome", "advice") if summary.get(key)) or "not stated"


def _estimate(estimate: Mapping[str, Any] | None) -> str:
    """The total and its parts, or that nothing has estimated it."""
    if estimate is None:
        return "not estimated"
    named = ("space", "time", "section")
    parts = [f"{name} {_value(estimate[name])}" for name in named if estimate.get(name) is not None]
    total = estimate.get("total")
    text = f"{_value(total)} of the largest midpoint" if total is not None else "not estimated in full"
    omitted = estimate.get("effects")
    beside = f"; effects left out may be worth {_value(omitted)}" if omitted else ""
    return f"{text} ({', '.join(parts)}){beside}" if parts else f"{text}{beside}"


def _listed(reasons: Mapping[str, Any] | None) -> str:
    """One name and its reason or estimate per line."""
    if not reasons:
        return "none"
    return "\n".join(f"{name}: {_value(value)}" if value not in (None, "") else name for name, value in reasons.items())


def _left_out(summary: Summary) -> str:
    """What each omitted effect would have changed, as expected before the run and as the run shows it."""
    shown = summary.get("checked") or {}
    lines = []
    for name, expected in summary["left_out"].items():
        seen = f", seen {significant(shown[name])}" if name in shown else ""
        lines.append(f"{name}: expected {significant(expected)}{seen}")
    return "\n".join(lines)


def _wall(stages: Mapping[str, float] | None) -> str:
    """Wall time of each stage, in the order in which they happen."""
    if not stages:
        return "not measured"
    known = [name for name in STAGES if name in stages] + [name for name in stages if name not in STAGES]
    return ", ".join(f"{name} {significant(stages[name])} s" for name in known if stages[name] is not None)


def _value(value: object) -> str:
    """A number with three digits, anything else as it is."""
    return significant(value) if isinstance(value, float) else str(value)
