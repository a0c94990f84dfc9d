"""A film of a fall, as arrays and as CSV text."""

from __future__ import annotations

from pathlib import Path

import numpy as np

TIME = np.arange(1, 21) / 20
FALL = -0.02 * TIME**2


def rows_of(*columns: np.ndarray, separator: str = ",", comma: bool = False) -> str:
    """Rows with numbers that read back exactly, with decimal commas if so asked."""
    rows = (separator.join(repr(float(value)) for value in row) for row in zip(*columns, strict=True))
    text = "".join(f"{row}\n" for row in rows)
    return text.replace(".", ",") if comma else text


def written(folder: Path, text: str, name: str = "film.csv") -> Path:
    """A file in a folder."""
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path
