"""Files of results: pictures, tables and documents, all made before any is written."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Callable, Iterable, Mapping
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

from softcat_sym.files import write_all


def write_results(directory: str | Path, contents: Mapping[str, object]) -> list[Path]:
    """Write figures as PNG, frames as CSV, documents as JSON, texts and bytes as they are; each file is replaced whole.

    Everything is drawn before anything is written. What is None is left out.
    """
    encoded = {name: _encoded(content) for name, content in contents.items() if content is not None}
    return write_all(directory, encoded)


def _encoded(content: Any) -> bytes:
    if isinstance(content, bytes):
        return content
    if isinstance(content, str):
        return content.encode()
    if hasattr(content, "savefig"):
        from softcat_sym.plotting.style import png

        return png(content)
    if hasattr(content, "to_csv"):
        table: str = content.to_csv(index=False)
        return table.encode()
    return json_bytes(content)


def json_bytes(content: object, *, is_ascii: bool = True) -> bytes:
    """A document; what is not finite in it is null."""
    return (json.dumps(finite(content), indent=2, allow_nan=False, ensure_ascii=is_ascii) + "\n").encode()


def finite(value: Any) -> Any:
    """The same with None in place of what JSON cannot say."""
    if isinstance(value, Mapping):
        return {name: finite(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [finite(part) for part in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def csv_bytes(header: Iterable[str], rows: Iterable[Iterable[object]], number: Callable[[float], str] = repr) -> bytes:
    """A table; every number reads back exactly, what is not there or not finite is empty."""

    def text(cell: object) -> str:
        if isinstance(cell, float):
            # NumPy's own floats print their type with repr.
            return number(float(cell)) if math.isfinite(cell) else ""
        return "" if cell is None else str(cell)

    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([list(header), *([text(cell) for cell in row] for row in rows)])
    return stream.getvalue().encode()


def columns_csv(columns: Mapping[str, Iterable[object]]) -> bytes:
    """A table of columns under their names."""
    lists = [values.tolist() if isinstance(values, np.ndarray) else list(values) for values in columns.values()]
    return csv_bytes(columns, zip(*lists, strict=True))


def page(template: str, **values: Any) -> bytes:
    """A page of the package's templates, in which no text is read as HTML unless it is marked as such."""
    import jinja2  # not needed by a run

    folder = resources.files("softcat_sym.plotting") / "templates"
    sources = {
        entry.name: entry.read_text(encoding="utf-8") for entry in folder.iterdir() if entry.name.endswith(".html")
    }
    environment = jinja2.Environment(
        loader=jinja2.DictLoader(sources), autoescape=True, trim_blocks=True, lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )  # fmt: skip
    return environment.get_template(template).render(**values).encode()
