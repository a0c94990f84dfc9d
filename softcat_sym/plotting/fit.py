"""A fit as a page, on the terminal and as files."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report
from softcat_sym.files import json_bytes
from softcat_sym.fitting.closed_form import ClosedForm
from softcat_sym.fitting.result import Fit, FittedFilm, features_dict
from softcat_sym.plotting.files import page
from softcat_sym.plotting.fit_figures import FIGURES, collapse_figure, features_figure, laws_figure
from softcat_sym.plotting.fit_words import (
    GAP_HEADINGS,
    LAW_HEADINGS,
    basis,
    feature_texts,
    gap_texts,
    law_remarks,
    law_texts,
    parameter_texts,
    posterior_texts,
)
from softcat_sym.plotting.style import png
from softcat_sym.plotting.terminal import text_table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from softcat_sym.fitting.collapse_test import CollapseTest
    from softcat_sym.fitting.model_selection import LawComparison
    from softcat_sym.fitting.posterior import Posterior

HEADINGS = ("parameter", "value ± std", "95 % interval", "verdict", "scene's")
"""Headings of the columns of :func:`softcat_sym.plotting.fit_words.parameter_texts`."""

_NUMBERS, _LAW_NUMBERS = (1, 2, 4), (1, 2, 3, 4, 5, 7)
"""Columns of the tables that are numbers."""


def _of_laws(found: LawComparison) -> list[RenderableType]:
    """The ranking of several laws, the verdict, and the constants of each law."""
    rows = [law_texts(found, row) for row in found.choice.table]
    styles = ["" if row.law.name in found.choice.close else "dim" for row in found.choice.table]
    title, numbers = f"Which law: {found.sentence}", _LAW_NUMBERS
    table = text_table(LAW_HEADINGS, rows, title=title, right=numbers, styles=styles, padding=(0, 1, 0, 0))
    return [table, *(Padding(Text(text), (0, 0, 0, 1)) for text in law_remarks(found)), ""]


def _of_gaps(test: CollapseTest) -> RenderableType:
    """What every gap of a collapse test shows."""
    rows = [gap_texts(one) for one in test.results]
    title, numbers = "Collapse test: every gap", tuple(range(len(GAP_HEADINGS)))
    return text_table(GAP_HEADINGS, rows, title=title, right=numbers, padding=(0, 1, 0, 0))


def _of_fit(fit: Fit, posterior: Posterior | None = None) -> list[RenderableType]:
    """Parameters, outcome, warnings and diagnostics of a fit."""
    parameters = list(fit.parameters.values())
    texts, title = [parameter_texts(one) for one in parameters], fit.scene.title or "Filament"
    styles = ["" if one.verdict == "identified" else "yellow" for one in parameters]
    table = text_table(HEADINGS, texts, title=title, right=_NUMBERS, styles=styles, padding=(0, 1, 0, 0))
    rows = [("outcome", f"{fit.outcome.word}: {fit.outcome.value}")]
    rows += [(one.name, one.reason) for one in parameters if one.reason]
    rows += [("identified", text) for text in fit.combinations]
    rows += [("warning", text) for text in fit.warnings]
    rows += [] if posterior is None else posterior_texts(posterior)
    rows += [row for row in basis(fit) if row[0] not in ("effects", "solver", "effort")]
    for film in (film for film in fit.films if film.of_midpoint.any()):
        rows += [("film", film.name)] if len(fit.films) > 1 else []
        rows += _features_of(film)
    return [table, _below(rows)]


def _features_of(film: FittedFilm) -> list[tuple[str, str]]:
    part = film.part(film.of_midpoint)
    return feature_texts(part.time, part.measured, film.features, film.closed)


def _below(rows: Sequence[tuple[str, str]]) -> Table:
    """Words and what they say, below one another."""
    below = Table(box=None, show_header=False, padding=(0, 1, 0, 0))
    below.add_column(style="dim", overflow="fold")
    below.add_column(overflow="fold")
    colours = {"outcome": "bold", "warning": "yellow"}
    for name, text in rows:
        below.add_row(Text(name), Text(text, style=colours.get(name, "")))
    return below


def fit_page(
    fit: Fit,
    pictures: Mapping[str, tuple[str, bytes]],
    command: str = "",
    laws: LawComparison | None = None,
    posterior: Posterior | None = None,
    collapse: CollapseTest | None = None,
) -> bytes:
    """Write a self-contained page."""
    table = [] if laws is None else laws.choice.table
    parameters = list(fit.parameters.values())
    return page(
        "fit.html",
        fit=fit,
        title=f"{fit.scene.title or 'Filament'}: fit",
        readings=sum(film.time.size for film in fit.films),
        is_solved=fit.outcome.name == "solved",
        laws=laws,
        law_headings=LAW_HEADINGS,
        law_rows=[(row.law.name in laws.choice.close, law_texts(laws, row)) for row in table] if laws else [],
        law_remarks=law_remarks(laws) if laws else [],
        law_numbers=_LAW_NUMBERS,
        gap_headings=GAP_HEADINGS,
        gap_rows=[gap_texts(one) for one in collapse.results] if collapse else [],
        headings=HEADINGS,
        numbers=_NUMBERS,
        rows=[(one.verdict == "identified", parameter_texts(one)) for one in parameters],
        reasons=[f"{one.name}: {one.reason}" for one in parameters if one.reason],
        remarks=[*fit.combinations, *(f"Warning: {text}" for text in fit.warnings)],
        basis=[*([] if posterior is None else posterior_texts(posterior)), *basis(fit)],
        features=[(film.name, _features_of(film)) for film in fit.films if film.of_midpoint.any()],
        pictures=[(name, what, b64encode(one).decode()) for name, (what, one) in pictures.items()],
        command=command,
    )


_SOMETIMES = ("features", "features_*", "profiles", "correlation", "starts", "laws", "posterior", "collapse")
"""Pictures that only some fits have."""


@drawing.report.register(Fit)
def fit_report(
    fit: Fit,
    command: str = "",
    laws: LawComparison | None = None,
    posterior: Posterior | None = None,
    collapse: CollapseTest | None = None,
) -> Report:
    """The fit with its pictures and a page, beside it the laws that were compared, draws, and a collapse test."""
    drawn = captioned_figures(fit)
    if laws is not None:
        drawn["laws"] = ("residuals of every law, the best law first", laws_figure(laws))
    if posterior is not None:
        drawn["posterior"] = ("draws of the posterior, best fit and intervals", posterior.plot(fit))
    if collapse is not None:
        drawn["collapse"] = ("the levelled contour and the fitted filaments", collapse_figure(collapse))
    pictures = {name: (caption, png(figure)) for name, (caption, figure) in drawn.items()}
    beside = {"laws": laws, "posterior": posterior, "collapse_test": collapse}
    facts = fit.to_dict() | {name: one.to_dict() for name, one in beside.items() if one is not None}
    files: dict[str, object] = {
        "fit.json": json_bytes(facts, is_ascii=False),
        "scene.toml": fitted_toml(fit),
        "fit.csv": fit.to_frame,
        "laws.csv": None if laws is None else laws.to_frame,
        **{f"{name}.png": picture for name, (_, picture) in pictures.items()},
        "posterior.nc": None if posterior is None else posterior.to_bytes,
        "fit.html": lambda: fit_page(fit, pictures, command, laws, posterior, collapse),
    }
    texts = [*([] if laws is None else _of_laws(laws)), *_of_fit(fit, posterior)]
    texts += [] if collapse is None else [_of_gaps(collapse)]
    stale = ("laws.csv", "posterior.nc", *(f"{name}.png" for name in _SOMETIMES))
    return Report(files, texts, stale=stale, pictures={name: figure for name, (_, figure) in drawn.items()})


@drawing.report.register(ClosedForm)
def features_report(found: ClosedForm, command: str = "") -> Report:
    """Features of a film and what the closed form makes of them, without a fit."""
    time, heights = found.film.time, found.film.midpoint
    facts = {"command": command, **features_dict(found.features), "closed_form": found.to_dict()}
    files = {"features.json": json_bytes(facts, is_ascii=False), "features.png": found.plot()}
    return Report(files, [_below(feature_texts(time, heights, found.features, found))], title="Features of the film")


@drawing.plot.register(ClosedForm)
def _features_plot(found: ClosedForm) -> Figure:
    return features_figure(found.film.time, found.film.midpoint, found.features, found)


_CAPTIONS = {
    "curves": ("fit", "data, model with its 95 % band, and residuals"),
    "profiles": ("profiles", "profile likelihoods with the 95 % threshold"),
    "correlation": ("correlation", "joint 95 % regions and correlations"),
    "starts": ("starts", "where every start began and ended"),
}


drawing.plot.register(Fit, lambda fit, what="curves": drawing.figure_by_name(FIGURES, what, fit))


def captioned_figures(fit: Fit) -> dict[str, tuple[str, Figure]]:
    """Draw all figures that the fit has data for, with captions."""
    shown = {
        "profiles": bool(fit.profiles),
        "correlation": bool(np.isfinite(fit.correlation[~np.eye(len(fit.correlation), dtype=bool)]).any()),
        "starts": len(fit.starts.results) > 1,
    }
    found = {
        name: (caption, FIGURES[what](fit)) for what, (name, caption) in _CAPTIONS.items() if shown.get(what, True)
    }
    for number, film in enumerate(fit.films, start=1):
        if film.features is not None:
            name = "features" if number == 1 else f"features_{number}"
            part = film.part(film.of_midpoint)
            figure = features_figure(part.time, part.measured, film.features, film.closed, film.name)
            found[name] = (f"features read from {film.name}", figure)
    return found


def fitted_toml(fit: Fit) -> str:
    """Write the fitted scene, with the outcome and the parameters that are not identified as comments."""
    lines = [f"# Fitted: {fit.outcome.word}."]
    lines += [f"# {one.name}: {one.verdict}; {one.reason}" for one in fit.parameters.values() if one.reason]
    return "\n".join(lines) + "\n" + fit.fitted_scene.to_toml()
