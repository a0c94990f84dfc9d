"""The key `filament.shape`: a word, or the points of a polyline, which may stand in a CSV file."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np

from softcat_sym.errors import Fault, SoftcatError
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
from softcat_sym.scene.units import Kind, NotAQuantity, Points, did_you_mean, shown

STRAIGHT, ARC, HELIX = "straight", "arc", "helix"
CSV = ".csv"
_WORDS = (STRAIGHT, ARC, HELIX)
_COLUMNS = "the columns x_m, y_m and z_m, or in another unit, such as x [mm]"
_NO_NUMBER = "not a number", "a finite number in every cell"
_LEAST, _MOST = 4, 5000


class Shape(Kind):
    """A word, the path of a CSV file, or points."""

    si = True
    accepted = f"{', '.join(_WORDS)}, a CSV file with {_COLUMNS}, or a list of points [x, y, z], {_LEAST} to {_MOST}"

    def read(self, value: object) -> str | tuple[tuple[float, ...], ...]:
        """Return the word, or the points; raises `refusal`."""
        if isinstance(value, str) and value in _WORDS:
            return value
        if isinstance(value, str) and value.lower().endswith(CSV):
            return self._long_enough(self._from_file(Path(value)))
        if isinstance(value, str):
            raise self.refuse(
                f"{shown(value)} is neither a shape known here nor a CSV file{did_you_mean(value, _WORDS)}"
            )
        return self._long_enough(Points().read(value))

    def write(self, value: str | tuple[tuple[float, ...], ...]) -> object:
        """Return what a scene file holds."""
        return value if isinstance(value, str) else Points().write(value)

    def _from_file(self, file: Path) -> tuple[tuple[float, ...], ...]:
        try:
            return _points_in(file)
        except SoftcatError as error:
            # The first fault says enough, and what is accepted is said below.
            first = str(error).splitlines()[1].partition("; accepted: ")[0].strip()
            raise self.refuse(f"{shown(file.name)}: {first}") from None

    def _long_enough(self, points: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
        if not _LEAST <= len(points) <= _MOST:
            raise self.refuse(f"a polyline of {len(points)} points")
        if any(a == b for a, b in pairwise(points)):
            raise self.refuse("a polyline with two neighbouring points in one place")
        return points


def _points_in(file: Path) -> tuple[tuple[float, ...], ...]:
    """Rows of a file."""
    table = table_in(text_of(file, "polyline", f"a CSV file with {_COLUMNS}"))
    if table is None:
        raise refusal("polyline", file, [Fault("", "the file holds no data", _COLUMNS)])
    pattern, columns, faults = header_pattern("xyz"), dict[str, Column](), list[Fault]()
    for place, name in enumerate(table.header):
        match = pattern.fullmatch(name.strip())
        if match is None:
            continue
        axis, unit, _ = named(match)
        try:
            columns[axis] = Column(name, place, unit_of(unit, "length", "m"))
        except NotAQuantity as found:
            faults.append(Fault(f"line {table.line}", f"column {shown(name)}: {found}", _COLUMNS))
    missing = [axis for axis in "xyz" if axis not in columns]
    faults = faults or [absent(f"column {axis}", axis, _COLUMNS, table, pattern) for axis in missing]
    if not faults:
        values, faults = numbers_in(table, columns, lambda _, value: None if np.isfinite(value) else _NO_NUMBER)
        points = np.column_stack([values[axis] for axis in "xyz"])
        empty = np.flatnonzero(np.isnan(points).any(axis=1))
        faults = faults or [Fault(f"line {table.rows[k][0]}", *_NO_NUMBER) for k in empty]
    if faults:
        raise refusal("polyline", file, faults)
    return tuple(tuple(row) for row in points.tolist())
