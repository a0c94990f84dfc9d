"""The tables printed after a study of where the theory ends."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from softcat_sym.report.theory_end_tables import cost_rows, moment_names
from softcat_sym.report.units import significant

if TYPE_CHECKING:
    from rich.console import Console

    from softcat_sym.study.theory_end import Measured, TheoryEnd

Table = tuple[str, tuple[str, ...], list[tuple[str, ...]]]
"""Title, header, rows."""

_NOTE = "filament/elements − 1 in %: positive where the filament sags more; t in L √(ρ/E)"


def error_table(end: TheoryEnd) -> Table:
    """Errors of half as many elements, and of each theory, at each value."""
    rows: list[tuple[str, ...]] = []
    for one in end.measured:
        rows.append((one.text, "half the elements", *map(percent, one.mesh.values)))
        rows += [("", _short(theory.row.name), *map(percent, theory.error.values)) for theory in one.theories]
    rows += [(lost.text, "not run", *[""] * 6) for lost in end.unmeasured]
    return f"{end.variation.path}: error of the midpoint\n{_NOTE}", ("", "", *_moments(end)), rows


def limit_table(end: TheoryEnd) -> Table:
    """Intercept and uncertainty of each theory at each moment, then the order of its error."""
    rows = []
    for name, limits in end.limits.items():
        orders = ["–" if limit is None or math.isnan(limit.order) else f"{limit.order:.2f}" for limit in limits]
        rows += [
            (_short(name), "limit", *("–" if limit is None else percent(limit.intercept) for limit in limits)),
            ("", "±", *("–" if limit is None else f"{100 * limit.uncertainty:.2f}" for limit in limits)),
            ("", "order", *orders),
        ]
    return "Slender limit: the error as the thickness goes to zero, in %", ("", "", *_moments(end)), rows


def cost_table(end: TheoryEnd) -> Table:
    """What each run took, and how many times as much the finer elements did."""
    rows = [cells for one in end.measured for cells in _cost(one)]
    header = ("", "", "unknowns", "steps", "solve [s]", "×", "error")
    return "Cost; ×: seconds of the finer elements over it; error: the largest, in %", header, rows


def remarks(end: TheoryEnd) -> list[str]:
    """Each value at which a theory is not to be trusted or could not be run, and the warnings, each once."""
    path = end.variation.path
    said = [
        f"{path} = {one.text}, {theory.row.name}: {theory.row.trajectory.outcome.name}, not to be trusted"
        for one in end.measured
        for theory in one.theories
        if not theory.row.trajectory.outcome.is_success
    ]
    said += [f"{path} = {lost.text}: {lost.reason}" for lost in end.unmeasured]
    if resting := [one.text for one in end.measured if _rests(one)]:
        said.append(f"at rest in the end: {path} = {', '.join(resting)}")
    warnings = dict.fromkeys(text for one in end.measured for text in one.comparison.warnings)
    return [*said, *(f"warning: {text}" for text in warnings)]


def print_theory_end(end: TheoryEnd, console: Console | None = None) -> None:
    """Print the tables and the remarks.

    Parameters
    ----------
    end : TheoryEnd
        As from :func:`softcat_sym.study.theory_end.where_theory_ends`.
    console : rich.console.Console or None
        Where to; standard output by default.
    """
    from rich import box
    from rich.console import Console
    from rich.table import Table as RichTable
    from rich.text import Text

    screen = console or Console()
    tables = [error_table(end), *([limit_table(end)] if end.limits else []), cost_table(end)]
    for title, header, rows in tables:
        table = RichTable(title=Text(title), title_justify="left", box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0))
        for k, name in enumerate(header):
            table.add_column(Text(name), justify="left" if k < 2 else "right", no_wrap=True)
        for row in rows:
            table.add_row(*(Text(cell) for cell in row))
        screen.print(table)
    for text in remarks(end):
        screen.print(Text(text))


def percent(error: float) -> str:
    """A share as a signed percentage without its sign of per cent."""
    if not math.isfinite(error):
        return "–"
    return f"{100 * error:+.2f}" if abs(error) < 1 else f"{100 * error:+.3g}"


def _short(name: str) -> str:
    return name.removesuffix(" closure")


def _moments(end: TheoryEnd) -> tuple[str, ...]:
    return tuple(name.replace("t = ", "t ") for name in moment_names(end))


def _rests(one: Measured) -> bool:
    return str(one.comparison.filament.trajectory.summary["regime"]).startswith(("arrested", "no-yield"))


def _cost(one: Measured) -> Iterator[tuple[str, ...]]:
    finer = one.comparison.elements.wall
    for k, (name, dofs, steps, solve, _, error) in enumerate(cost_rows(one)):
        ratio = significant(finer / solve) if solve > 0 else "–"
        # The finest mesh has no finer one to be measured against.
        yield (
            one.text if k == 0 else "",
            name,
            str(dofs),
            str(steps),
            significant(solve),
            ratio,
            percent(error) if k else "",
        )
