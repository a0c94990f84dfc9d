"""The sag card as a page that prints on A4, and all its files."""

from __future__ import annotations

import base64
import csv
import importlib.metadata
import io
import json
from collections.abc import Iterable, Sequence
from html import escape
from importlib import resources
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING

from softcat_sym.files import write_all
from softcat_sym.plotting.card_picture import card_figure
from softcat_sym.plotting.card_terminal import RULE_HEADINGS, facts, rule_texts, verdict
from softcat_sym.plotting.style import length_unit, png, time_unit

if TYPE_CHECKING:
    from softcat_sym.studies.card_rules import Card, Rule

_NUMBERS = (1, 2, 3)
_READING = (
    "Error: rule over solver, minus one. Behind each cause stands the error of the rule for a filament in which "
    "nothing else of what the rule leaves out is at work."
)


def card_page(card: Card, picture: bytes | None, command: str = "") -> bytes:
    """Write the page."""
    folder = resources.files("softcat_sym.plotting") / "templates"
    template = Template((folder / "card.html").read_text(encoding="utf-8"))
    sound, sentence = verdict(card)
    page = template.substitute(
        title=escape(card.scene.title or "Filament"),
        version=escape(importlib.metadata.version("softcat_sym")),
        doubtful="" if sound else " doubtful",
        verdict=escape(sentence),
        numbers="".join(_number(*one) for one in _headline(card)),
        picture="" if picture is None else _picture(picture),
        facts="\n".join(_line("td", row) for row in facts(card)),
        rules=_rules(card.rules),
        command=f"<pre>{escape(command)}</pre>" if command else "",
    )
    return page.encode()


def _headline(card: Card) -> Iterable[tuple[str, str]]:
    """The numbers that a printer looks for first."""
    found = card.descent
    if found is not None:
        yield length_unit(abs(found.final), card.scene.filament.span).text(found.final), "final sag"
        yield f"{100 * found.final / card.scene.filament.span:.3g} %", "of the span"
        if found.to_90 is not None:
            yield time_unit(found.to_90).text(found.to_90), "to 90 % of it"
    if card.span is not None:
        yield length_unit(card.span.span).text(card.span.span), f"longest span for {card.limit}"
    if card.error_estimate is not None:
        yield f"{100 * card.error_estimate:.2g} %", "estimated error"


def _number(value: str, what: str) -> str:
    return f"<div><b>{escape(value)}</b><span>{escape(what)}</span></div>"


def _picture(content: bytes) -> str:
    data = base64.b64encode(content).decode()
    what = "final shape, descent with the predictions of the rules, exponents of the longest span"
    return f'<figure><img src="data:image/png;base64,{data}" alt="{what}"></figure>'


def _rules(rules: Sequence[Rule]) -> str:
    if not rules:
        return '<p class="grey">The run has nothing to compare them with.</p>'
    lines = ["<table>", _line("th", RULE_HEADINGS, numbers=True)]
    for rule in rules:
        kind = "holds" if rule.holds else "idle" if rule.predicted is None else ""
        row = _line("td", rule_texts(rule), numbers=True)
        lines.append(row.replace("<tr>", f'<tr class="{kind}">', 1) if kind else row)
    return "\n".join([*lines, "</table>", f'<p class="grey">{_READING}</p>'])


def _line(tag: str, texts: Sequence[str], *, numbers: bool = False) -> str:
    marks = [' class="number"' if numbers and k in _NUMBERS else "" for k in range(len(texts))]
    cells = (f"<{tag}{mark}>{escape(text)}</{tag}>" for text, mark in zip(texts, marks, strict=True))
    return f"<tr>{''.join(cells)}</tr>"


_COLUMNS = ("rule", "source", "quantity", "unit", "predicted", "solver", "error", "error_bare", "what_makes_it_fail")


def card_csv(card: Card) -> bytes:
    """One row a rule, in SI; empty where a rule does not apply."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_COLUMNS)
    for rule in card.rules:
        numbers = [rule.predicted, rule.solver, rule.error, rule.bare]
        written = ["" if number is None else repr(number) for number in numbers]
        writer.writerow([rule.name, rule.source, rule.quantity, rule.unit, *written, rule.text])
    return text.getvalue().encode()


def write_card(card: Card, directory: str | Path, command: str = "") -> list[Path]:
    """Write ``card.html``, ``card.json``, ``card.csv``, ``card.png`` and ``scene.toml``.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    figure = None if card.descent is None else card_figure(card)
    document = json.dumps(card.as_dict(), indent=2, allow_nan=False, ensure_ascii=False) + "\n"
    contents = {
        "card.html": card_page(card, None if figure is None else png(figure, titled=False), command),
        "card.json": document.encode(),
        "card.csv": card_csv(card),
        "scene.toml": card.scene.to_toml().encode(),
    }
    if figure is not None:
        contents["card.png"] = png(figure)
    return write_all(directory, contents)
