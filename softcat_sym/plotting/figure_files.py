"""Figures for print: a picture for the screen, one without pixels, and what belongs to them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from io import BytesIO
from typing import TYPE_CHECKING, Any

from softcat_sym.plotting.style import styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DPI = 240
"""Of the PNG files: a figure as wide as a page is sharp in print."""


def printed(name: str, figure: Figure) -> dict[str, bytes]:
    """Draw a figure as PNG and PDF; the same figure gives the same bytes."""
    drawn = {}
    for ending, settings in (("png", {"dpi": DPI}), ("pdf", {"metadata": {"CreationDate": None}, "dpi": DPI})):
        content = BytesIO()
        # Some settings are read only now: ticks are made, and fonts found, while drawing.
        with styled():
            figure.savefig(content, format=ending, **settings)
        drawn[f"{name}.{ending}"] = content.getvalue()
    return drawn


def table(columns: Iterable[str], rows: Iterable[Iterable[object]]) -> bytes:
    """Write a CSV file: names first, numbers in full; texts are without commas and quotes."""
    lines = [",".join(columns), *(",".join(_text(value) for value in row) for row in rows)]
    return ("\n".join(lines) + "\n").encode()


def _text(value: object) -> str:
    return f"{value:.8g}" if isinstance(value, float) else str(value)


def facts(content: Mapping[str, Any]) -> bytes:
    """Write a JSON file."""
    return (json.dumps(content, indent=2) + "\n").encode()
