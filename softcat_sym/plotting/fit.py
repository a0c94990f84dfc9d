"""A fit on the terminal, as a page and as files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from softcat_sym import drawing
from softcat_sym.drawing import Report, Shown, TextTable
from softcat_sym.files import json_bytes
from softcat_sym.fitting.closed_form import ClosedForm
from softcat_sym.fitting.plausibility import own_scene
from softcat_sym.fitting.result import Fit, features_dict
from softcat_sym.plotting import fit_words as words
from softcat_sym.plotting.fit_figures import FIGURES, collapse_figure, features_figure, laws_figure
from softcat_sym.plotting.track import model_figure
from softcat_sym.simulate import recalled, without_estimate

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from softcat_sym.fitting.collapse_test import CollapseTest
    from softcat_sym.fitting.model_selection import LawComparison
    from softcat_sym.fitting.posterior import Posterior
    from softcat_sym.tracking.result import Track


def _shown(
    fit: Fit, laws: LawComparison | None, posterior: Posterior | None, collapse: CollapseTest | None
) -> Iterator[Shown]:
    """Laws, parameters, outcome, warnings, diagnostics and gaps."""
    if laws is not None:
        yield words.law_table(laws)
        yield from words.law_remarks(laws)
    yield words.parameter_table(fit)
    rows = [("outcome", f"{fit.outcome.word}: {fit.outcome.value}")]
    rows += [(one.name, one.reason) for one in fit.parameters.values() if one.reason]
    rows += [("identified", text) for text in fit.combinations] + [("warning", text) for text in fit.warnings]
    rows += [*words.posterior_texts(posterior), *words.basis(fit)]
    for film in (film for film in fit.films if film.of_midpoint.any()):
        rows += [("film", film.name)] if len(fit.films) > 1 else []
        rows += words.film_features(film)
    yield _below(rows)
    if collapse is not None:
        yield words.gap_table(collapse)


def _below(rows: words.Rows) -> TextTable:
    """Words and what they say, below one another."""
    colours = {"outcome": "bold", "warning": "yellow"}
    return TextTable(("", ""), rows, kinds=[colours.get(name, "") for name, _ in rows], whole=[0])


_SOMETIMES = ("features", "features_*", "film", "film_*", "profiles", "correlation", "starts", "laws", "posterior")
"""Pictures that only some fits have, as has a collapse test its own."""


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
    beside = {"laws": laws, "posterior": posterior, "collapse_test": collapse}
    facts = fit.to_dict() | {name: one.to_dict() for name, one in beside.items() if one is not None}
    files: dict[str, object] = {
        "fit.json": json_bytes(facts, is_ascii=False),
        "scene.toml": fitted_toml(fit),
        "fit.csv": fit.to_frame,
        "laws.csv": None if laws is None else laws.to_frame,
        **{f"{name}.png": figure for name, (_, figure) in drawn.items()},
        "posterior.nc": None if posterior is None else posterior.to_bytes,
    }
    stale = ("laws.csv", "posterior.nc", "collapse.png", *(f"{name}.png" for name in _SOMETIMES))
    captions = {name: caption for name, (caption, _) in drawn.items()}
    texts, title = [*_shown(fit, laws, posterior, collapse)], f"{fit.scene.title or 'Filament'}: fit"
    return Report(files, texts, title, "fit.html", captions, command, stale)


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
    "correlation": ("correlation", "correlations of the estimates"),
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
