"""A fit as a page, on the terminal and as files."""

from __future__ import annotations

import base64
import re
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from importlib import resources
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING

from softcat_sym.files import write_all
from softcat_sym.fitting.fit import FitOutcome
from softcat_sym.plotting.features import features_figure
from softcat_sym.plotting.fit_correlation import correlation_figure
from softcat_sym.plotting.fit_curves import curves_figure
from softcat_sym.plotting.fit_profiles import profiles_figure
from softcat_sym.plotting.fit_starts import starts_figure
from softcat_sym.plotting.fit_words import (
    corrections,
    feature_texts,
    fit_csv,
    fit_json,
    noise_text,
    parameter_texts,
    residuals_text,
    starts_text,
    warnings,
)
from softcat_sym.plotting.laws_figure import laws_figure
from softcat_sym.plotting.laws_table import HEADINGS as LAW_HEADINGS
from softcat_sym.plotting.laws_table import law_texts, laws_csv, laws_document, remarks
from softcat_sym.plotting.style import png

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.fitting.fit import Fit
    from softcat_sym.fitting.model_selection import LawComparison

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
    """Print the ranking of several laws, the verdict, and what each law's constants are."""
    from rich.console import Console
    from rich.padding import Padding
    from rich.text import Text

    screen = console or Console()
    screen.print(laws_table(found))
    for text in remarks(found):
        screen.print(Padding(Text(text), (0, 0, 0, 1)))
    screen.print()


def print_fit(fit: Fit, console: Console | None = None) -> None:
    """Print parameters, outcome and what they rest on."""
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


_NUMBERS = (1, 2, 4)
"""Columns of the table of parameters that are numbers."""


def fit_page(
    fit: Fit, pictures: Mapping[str, tuple[str, bytes]], command: str = "", laws: LawComparison | None = None
) -> bytes:
    """Write a page that needs no other file."""
    folder = resources.files("softcat_sym.plotting") / "templates"
    template = Template((folder / "fit.html").read_text(encoding="utf-8"))
    films = ", ".join(film.name for film in fit.films)
    readings = sum(film.time.size for film in fit.films)
    outcome = fit.outcome.word
    page = template.substitute(
        title=escape(f"{fit.scene.title or 'Filament'}: fit"),
        subtitle=escape(f"{films} · {readings} readings of the midpoint"),
        doubtful="" if fit.outcome is FitOutcome.solved else " doubtful",
        outcome=escape(_capital(outcome)),
        advice=escape(f"{_capital(fit.outcome.value)}."),
        laws="" if laws is None else _laws(laws),
        parameters=_parameters(fit),
        remarks=_listed([*fit.combinations, *(f"Warning: {text}" for text in warnings(fit))]),
        basis=_rows(_basis(fit)),
        features="\n".join(_features(fit)),
        pictures="\n".join(_picture(name, *one) for name, one in pictures.items()),
        command=f"<h2>The same again</h2>\n<pre>{escape(command)}</pre>" if command else "",
    )
    return page.encode()


def _parameters(fit: Fit) -> str:
    marks = [' class="number"' if k in _NUMBERS else "" for k in range(len(HEADINGS))]
    lines = ["<table>", _line("th", HEADINGS, marks)]
    for one in fit.parameters.values():
        row = _line("td", parameter_texts(one), marks)
        lines.append(row if one.verdict == "identified" else row.replace("<tr>", '<tr class="doubtful">', 1))
    reasons = [f"{one.name}: {one.reason}" for one in fit.parameters.values() if one.reason]
    return "\n".join([*lines, "</table>", _listed(reasons)])


def _laws(found: LawComparison) -> str:
    marks = [' class="number"' if 0 < k < 6 or k == 7 else "" for k in range(len(LAW_HEADINGS))]
    lines = ["<h2>Which law</h2>", f"<p><strong>{escape(_capital(found.sentence))}.</strong></p>"]
    lines += ["<table>", _line("th", LAW_HEADINGS, marks)]
    for row in found.choice.table:
        line = _line("td", law_texts(found, row), marks)
        close = row.law.name in found.choice.close
        lines.append(line if close else line.replace("<tr>", '<tr class="doubtful">', 1))
    return "\n".join([*lines, "</table>", _listed(remarks(found))])


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _line(tag: str, texts: Sequence[str], marks: Sequence[str]) -> str:
    cells = (f"<{tag}{mark}>{escape(text)}</{tag}>" for text, mark in zip(texts, marks, strict=True))
    return f"<tr>{''.join(cells)}</tr>"


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


def _features(fit: Fit) -> Iterable[str]:
    for film in fit.films:
        if len(fit.films) > 1:
            yield f"<h3>{escape(film.name)}</h3>"
        yield _rows(feature_texts(film))


def _rows(rows: Iterable[tuple[str, str]]) -> str:
    return "\n".join(["<table>", *(_line("td", row, ("", "")) for row in rows), "</table>"])


def _listed(texts: Sequence[str]) -> str:
    if not texts:
        return ""
    return "\n".join(["<ul>", *(f"<li>{escape(text)}</li>" for text in texts), "</ul>"])


def _picture(name: str, what: str, content: bytes) -> str:
    data = base64.b64encode(content).decode()
    return (
        f'<figure id="{escape(name.removesuffix(".png"))}"><img src="data:image/png;base64,{data}" '
        f'alt="{escape(what)}"><figcaption class="grey">{escape(what)}</figcaption></figure>'
    )


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
    written = write_all(directory, contents)
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
