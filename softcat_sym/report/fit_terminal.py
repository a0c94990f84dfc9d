"""What ``softcat fit`` prints."""

from __future__ import annotations

from typing import TYPE_CHECKING

from softcat_sym.report.fit_words import (
    corrections,
    feature_texts,
    noise_text,
    parameter_texts,
    residuals_text,
    starts_text,
    warnings,
)
from softcat_sym.report.laws_table import HEADINGS as LAW_HEADINGS
from softcat_sym.report.laws_table import law_texts, remarks

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.inverse.fitted import Fit
    from softcat_sym.inverse.laws import LawComparison

HEADINGS = ("parameter", "value ± std", "95 % interval", "verdict", "scene's")
"""Of the columns of :func:`softcat_sym.report.fit_words.parameter_texts`."""


def fit_rows(fit: Fit) -> list[tuple[str, str]]:
    """Put into words what stands below the table of parameters.

    Returns
    -------
    list of (str, str)
        Name and text of each row, in the order of reading.
    """
    rows = [("outcome", f"{fit.outcome.word}: {fit.outcome.value}")]
    rows += [(one.name, one.reason) for one in fit.parameters.values() if one.reason]
    rows += [("identified", text) for text in fit.combinations]
    rows += [("warning", text) for text in warnings(fit)]
    rows += [("corrected", text) for text in corrections(fit)]
    rows += [("repeated", text) for text in fit.repeats]
    rows += [("noise", noise_text(fit)), ("residuals", residuals_text(fit)), ("starts", starts_text(fit))]
    for film in fit.films:
        if len(fit.films) > 1:
            rows.append(("film", film.name))
        rows += feature_texts(film)
    return rows


def parameter_table(fit: Fit) -> Table:
    """Lay the parameters out as a table."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(
        title=Text(fit.scene.title or "Filament", style="bold"),
        title_justify="left",
        box=box.SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
    )
    for k, name in enumerate(HEADINGS):
        table.add_column(Text(name), justify="left" if k in (0, 3) else "right", overflow="fold")
    for one in fit.parameters.values():
        style = "" if one.verdict == "identified" else "yellow"
        table.add_row(*(Text(text, style=style) for text in parameter_texts(one)))
    return table


def laws_table(found: LawComparison) -> Table:
    """Lay several laws out as a table, the best first, those that are out of the question dim."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    title = Text(f"Which law: {found.sentence}", style="bold")
    table = Table(title=title, title_justify="left", box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0))
    for k, name in enumerate(LAW_HEADINGS):
        table.add_column(Text(name), justify="left" if k in (0, 6) else "right", overflow="fold")
    for row in found.choice.table:
        style = "" if row.law.name in found.choice.close else "dim"
        table.add_row(*(Text(text, style=style) for text in law_texts(found, row)))
    return table


def print_laws(found: LawComparison, console: Console | None = None) -> None:
    """Print the ranking of several laws, the verdict, and what each law's constants are.

    Parameters
    ----------
    found : LawComparison
        As from :func:`softcat_sym.inverse.fit_laws`.
    console : rich.console.Console or None
        Where to; standard output by default.
    """
    from rich.console import Console
    from rich.padding import Padding
    from rich.text import Text

    screen = console or Console()
    screen.print(laws_table(found))
    for text in remarks(found):
        screen.print(Padding(Text(text), (0, 0, 0, 1)))
    screen.print()


def print_fit(fit: Fit, console: Console | None = None) -> None:
    """Print parameters, outcome and what they rest on.

    Parameters
    ----------
    fit : Fit
        As from :func:`softcat_sym.fit`.
    console : rich.console.Console or None
        Where to; standard output by default.
    """
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    screen = console or Console()
    screen.print(parameter_table(fit))
    below = Table(box=None, show_header=False, padding=(0, 1, 0, 0))
    below.add_column(style="dim", overflow="fold")
    below.add_column(overflow="fold")
    styles = {"outcome": "bold", "warning": "yellow"}
    for name, text in fit_rows(fit):
        below.add_row(Text(name), Text(text, style=styles.get(name, "")))
    screen.print(below)
