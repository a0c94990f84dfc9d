"""A fit as a page, on the terminal and as files."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from softcat_sym.fitting.fit import FitOutcome
from softcat_sym.plotting.fit_figures import (
    correlation_figure,
    curves_figure,
    features_figure,
    laws_figure,
    profiles_figure,
    starts_figure,
)
from softcat_sym.plotting.style import png

if TYPE_CHECKING:
    from softcat_sym.fitting.fit import Fit
    from softcat_sym.fitting.model_selection import LawComparison

from base64 import b64encode

from softcat_sym.plotting.files import page, write_results
from softcat_sym.plotting.fit_words import (
    LAW_HEADINGS,
    corrections,
    feature_texts,
    fit_csv,
    fit_json,
    law_remarks,
    law_texts,
    laws_csv,
    laws_document,
    noise_text,
    parameter_texts,
    residuals_text,
    starts_text,
    warnings,
)
from softcat_sym.plotting.terminal import text_table

HEADINGS = ("parameter", "value ± std", "95 % interval", "verdict", "scene's")
"""Of the columns of :func:`softcat_sym.plotting.fit_words.parameter_texts`."""


def fit_rows(fit: Fit) -> list[tuple[str, str]]:
    """Put into words what stands below the table of parameters."""
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
    rows = [parameter_texts(one) for one in fit.parameters.values()]
    styles = ["" if one.verdict == "identified" else "yellow" for one in fit.parameters.values()]
    title = fit.scene.title or "Filament"
    return text_table(HEADINGS, rows, title=title, right=_NUMBERS, styles=styles, padding=(0, 1, 0, 0))


def laws_table(found: LawComparison) -> Table:
    """Lay several laws out as a table, the best first, those that are out of the question dim."""
    rows = [law_texts(found, row) for row in found.choice.table]
    styles = ["" if row.law.name in found.choice.close else "dim" for row in found.choice.table]
    title = f"Which law: {found.sentence}"
    return text_table(LAW_HEADINGS, rows, title=title, right=_LAW_NUMBERS, styles=styles, padding=(0, 1, 0, 0))


def print_laws(found: LawComparison, console: Console | None = None) -> None:
    """Print the ranking of several laws, the verdict, and what each law's constants are."""
    screen = console or Console()
    screen.print(laws_table(found))
    for text in law_remarks(found):
        screen.print(Padding(Text(text), (0, 0, 0, 1)))
    screen.print()


def print_fit(fit: Fit, console: Console | None = None) -> None:
    """Print parameters, outcome and what they rest on."""
    screen = console or Console()
    screen.print(parameter_table(fit))
    below = Table(box=None, show_header=False, padding=(0, 1, 0, 0))
    below.add_column(style="dim", overflow="fold")
    below.add_column(overflow="fold")
    styles = {"outcome": "bold", "warning": "yellow"}
    for name, text in fit_rows(fit):
        below.add_row(Text(name), Text(text, style=styles.get(name, "")))
    screen.print(below)


_NUMBERS, _LAW_NUMBERS = (1, 2, 4), (1, 2, 3, 4, 5, 7)
"""Columns of the tables that are numbers."""


def fit_page(
    fit: Fit, pictures: Mapping[str, tuple[str, bytes]], command: str = "", laws: LawComparison | None = None
) -> bytes:
    """Write a page that needs no other file."""
    table = [] if laws is None else laws.choice.table
    return page(
        "fit.html",
        fit=fit,
        title=f"{fit.scene.title or 'Filament'}: fit",
        readings=sum(film.time.size for film in fit.films),
        is_solved=fit.outcome is FitOutcome.solved,
        laws=laws,
        law_headings=LAW_HEADINGS,
        law_rows=[(row.law.name in laws.choice.close, law_texts(laws, row)) for row in table] if laws else [],
        law_remarks=law_remarks(laws) if laws else [],
        law_numbers=_LAW_NUMBERS,
        headings=HEADINGS,
        numbers=_NUMBERS,
        rows=[(one.verdict == "identified", parameter_texts(one)) for one in fit.parameters.values()],
        reasons=[f"{one.name}: {one.reason}" for one in fit.parameters.values() if one.reason],
        remarks=[*fit.combinations, *(f"Warning: {text}" for text in warnings(fit))],
        basis=list(_basis(fit)),
        features=[(film.name, feature_texts(film)) for film in fit.films],
        pictures=[(name.removesuffix(".png"), what, b64encode(one).decode()) for name, (what, one) in pictures.items()],
        command=command,
    )


def _basis(fit: Fit) -> Iterable[tuple[str, str]]:
    yield "noise", noise_text(fit)
    yield "residuals", residuals_text(fit)
    yield "starts", starts_text(fit)
    yield from (("corrected", text) for text in corrections(fit))
    yield from (("repeated", text) for text in fit.repeats)
    yield "effects", ", ".join(fit.effects)
    yield "solver", fit.backend
    evaluations = sum(one.optimum.evaluations for one in fit.starts.falls)
    yield "effort", f"{fit.seconds:.2g} s; {evaluations} evaluations with derivatives from all starts"


# Files that not every fit has: those of an earlier fit in the same folder would belong to no document there.
_SOMETIMES = re.compile(r"(features(_\d+)?|profiles|correlation|laws)\.png|laws\.csv")


def write_fit(fit: Fit, directory: str | Path, command: str = "", laws: LawComparison | None = None) -> list[Path]:
    """Write ``fit.json``, ``scene.toml``, ``fit.csv``, the pictures and ``fit.html``, and ``laws.csv`` of several.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    pictures = fit_pictures(fit)
    more = {}
    if laws is not None:
        pictures["laws.png"] = ("what every law leaves unexplained, the best law first", png(laws_figure(laws)))
        more["laws"] = laws_document(laws)
    contents = {
        "fit.json": fit_json(fit, more),
        "scene.toml": fitted_toml(fit),
        "fit.csv": fit_csv(fit),
        **({} if laws is None else {"laws.csv": laws_csv(laws)}),
        **{name: content for name, (_, content) in pictures.items()},
        "fit.html": fit_page(fit, pictures, command, laws),
    }
    written = write_results(directory, contents)
    for path in Path(directory).iterdir():
        if _SOMETIMES.fullmatch(path.name) and path.name not in contents:
            path.unlink()
    return written


def fit_pictures(fit: Fit) -> dict[str, tuple[str, bytes]]:
    """Draw what there is to draw."""
    found = {"fit.png": ("data, model with its 95 % band, and residuals", png(curves_figure(fit)))}
    if fit.profiles:
        found["profiles.png"] = ("profile likelihoods with the 95 % threshold", png(profiles_figure(fit)))
    if len(fit.problem.free) > 1:
        found["correlation.png"] = ("joint 95 % regions and correlations", png(correlation_figure(fit)))
    found["starts.png"] = ("where every start began and ended", png(starts_figure(fit)))
    for number, film in enumerate(fit.films, start=1):
        if film.features is None:
            continue
        name = "features.png" if number == 1 else f"features_{number}.png"
        seen = film.part(film.of_midpoint)
        figure = features_figure(seen.time, seen.measured, film.features, film.name)
        found[name] = (f"features read from {film.name}", png(figure))
    return found


def fitted_toml(fit: Fit) -> bytes:
    """Write the fitted scene, with the fit's outcome and what it does not know as a comment."""
    lines = [f"# Fitted: {fit.outcome.word}."]
    lines += [f"# {one.name}: {one.verdict}; {one.reason}" for one in fit.parameters.values() if one.reason]
    return ("\n".join(lines) + "\n" + fit.fitted_scene.to_toml()).encode()
