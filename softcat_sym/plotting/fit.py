"""A fit as a page, on the terminal and as files."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report
from softcat_sym.files import json_bytes
from softcat_sym.fitting.closed_form import ClosedForm
from softcat_sym.fitting.plausibility import own_scene
from softcat_sym.fitting.result import Fit, features_dict
from softcat_sym.plotting import fit_words as words
from softcat_sym.plotting.files import page
from softcat_sym.plotting.fit_figures import FIGURES, collapse_figure, features_figure, laws_figure
from softcat_sym.plotting.style import png
from softcat_sym.plotting.track import model_figure
from softcat_sym.simulate import recalled, without_estimate

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from softcat_sym.fitting.collapse_test import CollapseTest
    from softcat_sym.fitting.model_selection import LawComparison
    from softcat_sym.fitting.posterior import Posterior
    from softcat_sym.tracking.result import Track


def _printed(
    fit: Fit, laws: LawComparison | None, posterior: Posterior | None, collapse: CollapseTest | None
) -> list[RenderableType]:
    """Laws, parameters, outcome, warnings, diagnostics and gaps for a terminal."""
    shown: list[RenderableType] = []
    if laws is not None:
        shown.append(words.law_table(laws).printed(f"Which law: {laws.sentence}", styles={"doubtful": "dim"}))
        shown += [*(Padding(Text(text), (0, 0, 0, 1)) for text in words.law_remarks(laws)), ""]
    rows = [("outcome", f"{fit.outcome.word}: {fit.outcome.value}")]
    rows += [(one.name, one.reason) for one in fit.parameters.values() if one.reason]
    rows += [("identified", text) for text in fit.combinations] + [("warning", text) for text in fit.warnings]
    rows += words.posterior_texts(posterior)
    rows += [row for row in words.basis(fit) if row[0] not in ("effects", "solver", "effort")]
    for film in (film for film in fit.films if film.of_midpoint.any()):
        rows += [("film", film.name)] if len(fit.films) > 1 else []
        rows += words.film_features(film)
    shown += [
        words.parameter_table(fit).printed(fit.scene.title or "Filament", styles={"doubtful": "yellow"}),
        _below(rows),
    ]
    return shown + ([] if collapse is None else [words.gap_table(collapse).printed("Collapse test: every gap")])


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
    return page(
        "fit.html",
        fit=fit,
        title=f"{fit.scene.title or 'Filament'}: fit",
        readings=sum(film.time.size for film in fit.films),
        is_solved=fit.outcome.name == "solved",
        laws=laws,
        law_table=laws and words.law_table(laws),
        law_remarks=words.law_remarks(laws) if laws else [],
        gap_table=collapse and words.gap_table(collapse),
        parameters=words.parameter_table(fit),
        reasons=[f"{one.name}: {one.reason}" for one in fit.parameters.values() if one.reason],
        remarks=[*fit.combinations, *(f"Warning: {text}" for text in fit.warnings)],
        basis=[*words.posterior_texts(posterior), *words.basis(fit)],
        features=[(film.name, words.film_features(film)) for film in fit.films if film.of_midpoint.any()],
        pictures=[(name, what, b64encode(one).decode()) for name, (what, one) in pictures.items()],
        command=command,
    )


_SOMETIMES = (
    "features",
    "features_*",
    "film",
    "film_*",
    "profiles",
    "correlation",
    "starts",
    "laws",
    "posterior",
    "collapse",
)
"""Pictures that only some fits have."""


@drawing.report.register(Fit)
def fit_report(
    fit: Fit,
    command: str = "",
    laws: LawComparison | None = None,
    posterior: Posterior | None = None,
    collapse: CollapseTest | None = None,
    tracks: Mapping[int, Track] | None = None,
) -> Report:
    """The fit with its pictures and a page, beside it the laws compared, draws, a collapse test, and tracked films."""
    drawn = captioned_figures(fit)
    for place, track in (tracks or {}).items():
        scene = own_scene(fit.measurements.series[place], fit.fitted_scene).replace(
            {"run.duration": f"{track.time[-1]:.9g} s"}
        )
        figure = model_figure(track, recalled(without_estimate(scene)))
        drawn["film" if place == 0 else f"film_{place + 1}"] = ("the last frame, and the fitted model over it", figure)
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
    stale = ("laws.csv", "posterior.nc", *(f"{name}.png" for name in _SOMETIMES))
    figures = {name: figure for name, (_, figure) in drawn.items()}
    return Report(files, _printed(fit, laws, posterior, collapse), stale=stale, pictures=figures)


@drawing.report.register(ClosedForm)
def features_report(found: ClosedForm, command: str = "") -> Report:
    """Features of a film and what the closed form makes of them, without a fit."""
    facts = {"command": command, **features_dict(found.features), "closed_form": found.to_dict()}
    files = {"features.json": json_bytes(facts, is_ascii=False), "features.png": found.plot()}
    texts = words.feature_texts(found.film.time, found.film.midpoint, found.features, found)
    return Report(files, [_below(texts)], title="Features of the film")


@drawing.plot.register(ClosedForm)
def _features_plot(found: ClosedForm) -> Figure:
    return features_figure(found.film.time, found.film.midpoint, found.features, found)


drawing.plot.register(Fit, lambda fit, what="curves": drawing.figure_by_name(FIGURES, what, fit))


_CAPTIONS = {
    "fit": ("curves", "data, model with its 95 % band, and residuals"),
    "profiles": ("profiles", "profile likelihoods with the 95 % threshold"),
    "correlation": ("correlation", "joint 95 % regions and correlations"),
    "starts": ("starts", "where every start began and ended"),
}


def captioned_figures(fit: Fit) -> dict[str, tuple[str, Figure]]:
    """Draw all figures that the fit has data for, with captions."""
    found = {}
    for name, (what, caption) in _CAPTIONS.items():
        if (figure := FIGURES[what](fit)) is not None:
            found[name] = (caption, figure)
    for number, film in enumerate(fit.films, start=1):
        if film.features is not None:
            part = film.part(film.of_midpoint)
            figure = features_figure(part.time, part.measured, film.features, film.closed, film.name)
            found["features" if number == 1 else f"features_{number}"] = (f"features read from {film.name}", figure)
    return found


def fitted_toml(fit: Fit) -> str:
    """Write the fitted scene, with the outcome and the parameters that are not identified as comments."""
    lines = [f"# Fitted: {fit.outcome.word}."]
    lines += [f"# {one.name}: {one.verdict}; {one.reason}" for one in fit.parameters.values() if one.reason]
    return "\n".join(lines) + "\n" + fit.fitted_scene.to_toml()
