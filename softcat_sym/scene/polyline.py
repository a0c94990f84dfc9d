"""A polyline of a CSV file: columns x, y and z, in any unit of length."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from softcat_sym.errors import Fault
from softcat_sym.scene.csv_reader import (
    Column,
    absent,
    header_pattern,
    named,
    numbers_in,
    refusal,
    table_in,
    text_of,
    unit_of,
)
from softcat_sym.scene.units import NotAQuantity, shown

_NO_NUMBER = "not a number", "a finite number in every cell"


def points_in(file: Path, accepted: str) -> tuple[tuple[float, ...], ...]:
    """Rows of a file with the columns that are accepted."""
    table = table_in(text_of(file, "polyline", f"a CSV file with {accepted}"))
    if table is None:
        raise refusal("polyline", file, [Fault("", "the file holds no data", accepted)])
    pattern, columns, faults = header_pattern("xyz"), dict[str, Column](), list[Fault]()
    for place, name in enumerate(table.header):
        match = pattern.fullmatch(name.strip())
        if match is None:
            continue
        axis, unit, _ = named(match)
        try:
            columns[axis] = Column(name, place, unit_of(unit, "length", "m"))
        except NotAQuantity as found:
            faults.append(Fault(f"line {table.line}", f"column {shown(name)}: {found}", accepted))
    missing = [axis for axis in "xyz" if axis not in columns]
    faults = faults or [absent(f"column {axis}", axis, accepted, table, pattern) for axis in missing]
    if not faults:
        values, faults = numbers_in(table, columns, lambda _, value: None if np.isfinite(value) else _NO_NUMBER)
        points = np.column_stack([values[axis] for axis in "xyz"])
        empty = np.flatnonzero(np.isnan(points).any(axis=1))
        faults = faults or [Fault(f"line {table.rows[k][0]}", *_NO_NUMBER) for k in empty]
    if faults:
        raise refusal("polyline", file, faults)
    return tuple(tuple(row) for row in points.tolist())
