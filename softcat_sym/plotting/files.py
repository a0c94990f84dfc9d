"""Tables and pages of results."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable
from typing import Any


def csv_bytes(header: Iterable[str], rows: Iterable[Iterable[object]]) -> bytes:
    """A table; every number reads back exactly, what is not there or not finite is empty."""

    def text(cell: object) -> str:
        if isinstance(cell, float):
            # NumPy's own floats print their type with repr.
            return repr(float(cell)) if math.isfinite(cell) else ""
        return "" if cell is None else str(cell)

    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([list(header), *([text(cell) for cell in row] for row in rows)])
    return stream.getvalue().encode()


def page(template: str, **values: Any) -> bytes:
    """A page of the package's templates, in which no text is read as HTML unless it is marked as such."""
    import jinja2  # not needed by a run

    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("softcat_sym.plotting"), autoescape=True, trim_blocks=True, lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )  # fmt: skip
    return environment.get_template(template).render(**values).encode()
