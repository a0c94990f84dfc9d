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
from softcat_sym.report.laws_table import HEADINGS as LAW_HEADINGS
from softcat_sym.report.laws_table import law_texts, remarks

if TYPE_CHECKING:
    from softcat_sym.inverse.fitted import Fit
    from softcat_sym.inverse.laws import LawComparison

_NUMBERS = (1, 2, 4)
"""Columns of the table of parameters that are numbers."""


def fit_page(
    fit: Fit, pictures: Mapping[str, tuple[str, bytes]], command: str = "", laws: LawComparison | None = None
) -> bytes:
    """Write a page that needs no other file.

    Parameters
    ----------
    fit : Fit
        As from :func:`softcat_sym.fit`.
    pictures : mapping of str to (str, bytes)
        By file name: what each shows, and its PNG.
    command : str
        That makes the same fit again; empty if there is none.
    laws : LawComparison, optional
        From which the fit comes.

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
