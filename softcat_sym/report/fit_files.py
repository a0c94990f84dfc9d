"""All files of one fit."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.files import write_all
from softcat_sym.report.canvas import png
from softcat_sym.report.features import features_figure
from softcat_sym.report.fit_correlation import correlation_figure
from softcat_sym.report.fit_curves import curves_figure
from softcat_sym.report.fit_document import fit_csv, fit_json
from softcat_sym.report.fit_page import fit_page
from softcat_sym.report.fit_profiles import profiles_figure
from softcat_sym.report.fit_starts import starts_figure
from softcat_sym.report.laws_figure import laws_figure
from softcat_sym.report.laws_table import laws_csv, laws_document

if TYPE_CHECKING:
    from softcat_sym.inverse.fitted import Fit
    from softcat_sym.inverse.laws import LawComparison

# Files that not every fit has: those of an earlier fit in the same folder would belong to no document there.
_SOMETIMES = re.compile(r"(features(_\d+)?|profiles|correlation|laws)\.png|laws\.csv")


def write_fit(fit: Fit, directory: str | Path, command: str = "", laws: LawComparison | None = None) -> list[Path]:
    """Write ``fit.json``, ``scene.toml``, ``fit.csv``, the pictures and ``fit.html``, and ``laws.csv`` of several.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.

    Parameters
    ----------
    fit : Fit
        As from :func:`softcat_sym.fit`.
    directory : str or pathlib.Path
        Where the files go; made if missing.
    command : str
        That makes the same fit again, for the page.
    laws : LawComparison, optional
        From which the fit comes: an entry of ``fit.json``, a section of the page, a table and a picture.

    Returns
    -------
    list of pathlib.Path
        The files written.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
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
    """Draw what there is to draw.

    Returns
    -------
    dict of str to (str, bytes)
        By file name: what it shows, and the PNG. No profiles if they were not asked for, no correlations of a single
        parameter, no features of a film that is too short.
    """
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
