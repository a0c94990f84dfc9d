"""Measurements from CSV files, as people, spreadsheets and trackers write them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.inverse.csv_columns import numbers_in, table_in
from softcat_sym.inverse.csv_text import refusal, text_of
from softcat_sym.inverse.measurements.columns import MIDPOINT, STD, TIME, X, Y, columns_of
from softcat_sym.inverse.measurements.overriding_comments import overrides_in
from softcat_sym.inverse.measurements.repairs import repaired
from softcat_sym.inverse.measurements.series import Measurements, Series, Shapes, what_is_wrong

_KIND = "measurements"
_ACCEPTED = "a CSV file with the columns time_s and midpoint_m, or time_s, x_m and y_m"


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
    cells = table_in(text)
    if cells is None:
        raise refusal(_KIND, file, [*faults, Fault("", "the file holds no data", _ACCEPTED)])
    columns, wrong = columns_of(cells)
    faults += wrong
    if wrong:
        raise refusal(_KIND, file, faults)
    table, wrong = numbers_in(cells, columns, lambda quantity, value: what_is_wrong(value, quantity == STD))
    faults += wrong
    notes: tuple[str, ...] = ()
    if not faults:
        table, notes, faults = repaired(table, lambda k: f"line {cells.rows[k][0]}")
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
