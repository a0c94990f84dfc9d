"""One self-contained page on a fit."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from importlib import resources
from string import Template
from typing import TYPE_CHECKING

from softcat_sym.inverse.fit_outcome import FitOutcome
from softcat_sym.report.fit_terminal import HEADINGS
from softcat_sym.report.fit_words import (
    corrections,
    feature_texts,
    noise_text,
    parameter_texts,
    residuals_text,
    starts_text,
    warnings,
)

if TYPE_CHECKING:
    from softcat_sym.inverse.fitted import Fit

_NUMBERS = (1, 2, 4)
"""Columns of the table of parameters that are numbers."""


def fit_page(fit: Fit, pictures: Mapping[str, tuple[str, bytes]], command: str = "") -> bytes:
    """Write a page that needs no other file.

    Parameters
    ----------
    fit : Fit
        As from :func:`softcat_sym.fit`.
    pictures : mapping of str to (str, bytes)
        By file name: what each shows, and its PNG.
    command : str
        That makes the same fit again; empty if there is none.

    Returns
    -------
    bytes
        HTML in UTF-8; every word of the user's is escaped.
    """
    folder = resources.files("softcat_sym.report") / "templates"
    template = Template((folder / "fit.html").read_text(encoding="utf-8"))
    films = ", ".join(film.name for film in fit.films)
    readings = sum(film.time.size for film in fit.films)
    outcome = fit.outcome.word
    page = template.substitute(
        title=escape(f"{fit.scene.title or 'Filament'}: fit"),
        subtitle=escape(f"{films} · {readings} readings of the midpoint"),
        doubtful="" if fit.outcome is FitOutcome.solved else " doubtful",
        outcome=escape(outcome[0].upper() + outcome[1:]),
        advice=escape(f"{fit.outcome.value[0].upper()}{fit.outcome.value[1:]}."),
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
