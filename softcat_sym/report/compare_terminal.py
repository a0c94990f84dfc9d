"""The table printed after a comparison."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from softcat_sym.report.compare_axes import elements_name
from softcat_sym.report.units import significant
from softcat_sym.study.discrepancy import SHARES, moments

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.study.compare import Comparison


def comparison_columns(comparison: Comparison) -> list[tuple[str, ...]]:
    """One column for the elements, one for each filament, as texts below the names in `row_names`.

    Parameters
    ----------
    comparison : Comparison
        As from :func:`softcat_sym.study.compare.compare`.

    Returns
    -------
    list of tuple of str
        Name, final midpoint over span, errors in per cent at the moments, mean and largest, unknowns, seconds.
    """
    span, run = comparison.scene.filament.span, comparison.elements
    none = ("",) * (len(SHARES) + 2)
    columns = [
        (elements_name(comparison), _ratio(run.midpoint[-1] / span), *none, str(run.dofs), significant(run.wall))
    ]
    for row in comparison.filaments:
        found = row.discrepancy
        errors = (_percent(error) for error in (*found.at, found.mean, found.largest))
        wall = significant(row.trajectory.summary["wall_s"]["total"])
        columns.append((row.name, _ratio(row.midpoint[-1] / span), *errors, str(row.dofs), wall))
    return columns


def row_names(comparison: Comparison) -> tuple[str, ...]:
    """What stands left of the columns; the first is the name of the column."""
    run = comparison.elements
    times = (run.time[frame] / run.elastic_time for frame in moments(len(run.time)))
    errors = (f"error at t = {time:.4g}" for time in times)
    return ("", "final midpoint / L", *errors, "mean error", "largest error", "unknowns", "wall time [s]")


def comparison_table(comparison: Comparison) -> Table:
    """Lay the columns out below the names of the theories."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    note = "errors in %: (filament − elements)/max |elements|, midpoint; t in L √(ρ/E)"
    table = Table(
        title=Text(comparison.scene.title or "Filament", style="bold"),
        title_justify="left",
        caption=Text(note, style="dim"),
        caption_justify="left",
        box=box.SIMPLE_HEAD,
    )
    columns = [row_names(comparison), *comparison_columns(comparison)]
    for column in columns:
        name = column[0].replace("elements ", "elements\n").replace(", ", ",\n").replace(" closure", "\nclosure")
        table.add_column(Text(name), justify="left" if column is columns[0] else "right", no_wrap=True)
    for row in list(zip(*columns, strict=True))[1:]:
        table.add_row(*(Text(text) for text in row))
    return table


def remarks(comparison: Comparison) -> list[str]:
    """What a reader must know beside the numbers: each run that is not to be trusted, and every warning."""
    rows = ((row.name, row.trajectory) for row in comparison.filaments)
    bad = [f"{name}: {run.outcome.name}; {run.outcome.value}" for name, run in rows if not run.outcome.is_success]
    return [*bad, *(f"warning: {text}" for text in comparison.warnings)]


def print_comparison(comparison: Comparison, console: Console | None = None) -> None:
    """Print the table and the remarks.

    Parameters
    ----------
    comparison : Comparison
        As from :func:`softcat_sym.study.compare.compare`.
    console : rich.console.Console or None
        Where to; standard output by default.
    """
    from rich.console import Console
    from rich.text import Text

    screen = console or Console()
    screen.print(comparison_table(comparison))
    for text in remarks(comparison):
        screen.print(Text(text))


def _ratio(value: float) -> str:
    return f"{value:.5f}" if math.isfinite(value) else "–"


def _percent(error: float) -> str:
    if not math.isfinite(error):
        return "–"
    return f"{100 * error:+.2f}" if abs(error) < 1 else f"{100 * error:+.3g}"
