"""All files of one sag card."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.files import write_all
from softcat_sym.report.canvas import png
from softcat_sym.report.card_page import card_page
from softcat_sym.report.card_picture import card_figure

if TYPE_CHECKING:
    from softcat_sym.study.card import Card

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

    Parameters
    ----------
    card : Card
        As from :func:`softcat_sym.study.card.card`.
    directory : str or pathlib.Path
        Where the files go; made if missing.
    command : str
        That makes the same card again, for the page.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
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
