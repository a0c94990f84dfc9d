"""Measurements from CSV files, as people, spreadsheets and trackers write them."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.inverse.csv_text import cells_of, counted, data_lines, number_in, refusal, text_of
from softcat_sym.inverse.measurements.columns import MIDPOINT, STD, TIME, Column, X, Y, columns_of
from softcat_sym.inverse.measurements.overriding_comments import overrides_in
from softcat_sym.inverse.measurements.repairs import Table, repaired
from softcat_sym.inverse.measurements.series import Measurements, Series, Shapes, what_is_wrong
from softcat_sym.scene.units import shown

_KIND = "measurements"
_ACCEPTED = "a CSV file with the columns time_s and midpoint_m, or time_s, x_m and y_m"
# How trackers and spreadsheets write that there is nothing.
_NOTHING = frozenset({"", "nan", "na", "n/a", "#n/a", "null", "none", "-"})
# The first line by which Excel tells itself how cells are separated.
_SEPARATOR_LINE = re.compile(r"sep=.?\s*", re.IGNORECASE)
_DECIMAL_COMMA = re.compile(r"([+-]?\d*),(\d*(?:[eE][+-]?\d+)?)")


def read_measurements(paths: str | os.PathLike[str] | Sequence[str | os.PathLike[str]]) -> Measurements:
    """Read filmed filaments of one material.

    Parameters
    ----------
    paths : path or sequence of paths
        CSV files in UTF-8, one for each filament, whose header names ``time_s`` and ``midpoint_m`` with perhaps
        ``midpoint_std_m``, or ``time_s``, ``x_m`` and ``y_m`` with perhaps ``y_std_m``, in any unit (``time_ms``,
        ``midpoint [mm]``); ``sag_mm`` or ``deflection_mm`` counts downwards. Other columns are not read. Cells are
        separated by commas, or by semicolons or tabs, then with decimal points or commas. Lines that start with ``#``
        are comments; ``# filament.span = 5 mm`` gives this filament a value of its own.

    Returns
    -------
    Measurements
        In SI, in the order of the paths; what was corrected is in the notes of each series.

    Raises
    ------
    SoftcatError
        With the faults of all files, and their lines.
    """
    given = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    files = [Path(path) for path in given]
    if not files:
        raise refusal(_KIND, None, [Fault("", "no file", _ACCEPTED)])
    repeated = sorted({str(file) for file in files if sum(_same(file, other) for other in files) > 1})
    if repeated:
        found = f"{', '.join(repeated)} named twice, so the same filament would count twice"
        raise refusal(_KIND, None, [Fault("", found, "each file once")])
    series, refused = [], []
    for file in files:
        try:
            series.append(_series(file))
        except SoftcatError as error:
            refused.append(str(error))
    if refused:
        raise SoftcatError("\n".join(refused))
    return Measurements(tuple(series))


def _same(one: Path, other: Path) -> bool:
    return os.path.realpath(one) == os.path.realpath(other)


def _series(file: Path) -> Series:
    text = text_of(file, _KIND, _ACCEPTED)
    overrides, faults = overrides_in(text)
    lines = data_lines(text)
    if lines and _SEPARATOR_LINE.fullmatch(lines[0][1]):
        del lines[0]
    if not lines:
        raise refusal(_KIND, file, [*faults, Fault("", "the file holds no data", _ACCEPTED)])
    number, first = lines[0]
    separator = next((one for one in "\t;" if one in first), ",")
    header = cells_of(first, separator)
    columns, wrong = columns_of(header, f"line {number}")
    faults += wrong
    if wrong:
        raise refusal(_KIND, file, faults)
    rows = [(k, cells_of(line, separator)) for k, line in lines[1:]]
    table, wrong = _table(rows, columns, len(header), separator)
    faults += wrong
    notes: tuple[str, ...] = ()
    if not faults:
        table, notes, faults = repaired(table, lambda k: f"line {rows[k][0]}")
    if faults:
        raise refusal(_KIND, file, faults)
    std = table.get(STD)
    if MIDPOINT in table:
        down = columns[MIDPOINT].down
        if down:
            notes = (f"Turned the sign of {columns[MIDPOINT].name}, which counts downwards by its name.", *notes)
        midpoint = 0.0 - table[MIDPOINT] if down else table[MIDPOINT]
        return Series(table[TIME], midpoint, std, None, overrides, file, notes)
    try:
        shapes = Shapes(table[TIME], table[X], table[Y], std)
    except SoftcatError as error:
        raise SoftcatError(f"{_KIND} {file}: {error}") from None
    return Series(np.empty(0), np.empty(0), None, shapes, overrides, file, notes)


def _table(
    rows: Sequence[tuple[int, list[str]]], columns: dict[str, Column], width: int, separator: str
) -> tuple[Table, list[Fault]]:
    """Read the cells in SI units; NaN where one is empty."""
    faults: list[Fault] = []
    values: dict[str, list[float]] = {quantity: [] for quantity in columns}
    for line, cells in rows:
        if any(cells[width:]):
            decimal = "; decimal commas need semicolons or tabs between the cells" if separator == "," else ""
            found = f"{len(cells)} cells under {counted(width, 'name')}"
            faults.append(Fault(f"line {line}", found, f"a cell for each column{decimal}"))
            continue
        for quantity, column in columns.items():
            text = cells[column.place] if column.place < len(cells) else ""
            value, wrong = _value(text, column, quantity == STD, separator != ",")
            faults += [Fault(f"line {line}, {column.name}", *wrong)] if wrong else []
            values[quantity].append(value)
    return {quantity: np.array(column, dtype=np.float64) for quantity, column in values.items()}, faults


def _value(text: str, column: Column, is_std: bool, decimal_comma: bool) -> tuple[float, tuple[str, str] | None]:
    if text.lower() in _NOTHING:
        return math.nan, None
    match = _DECIMAL_COMMA.fullmatch(text) if decimal_comma else None
    value = number_in(f"{match[1]}.{match[2]}" if match else text)
    if value is None:
        return math.nan, (f"{shown(text)} is not a number", "a number such as 0.5, or nothing")
    if math.isnan(value):
        return value, None
    wrong = what_is_wrong(value, is_std) if not math.isfinite(value) else what_is_wrong(column.to_si(value), is_std)
    return (math.nan, wrong) if wrong else (column.to_si(value), None)
