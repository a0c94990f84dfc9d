"""Corrections of measurements that need no guess: rows without a number, their order, repeated times.

Each is said in a sentence; what cannot be corrected without a guess is a fault.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import Fault
from softcat_sym.inverse.csv_columns import Table, listed, missing_rows
from softcat_sym.inverse.csv_text import counted
from softcat_sym.inverse.measurements.columns import MIDPOINT, STD, TIME, X, Y

Floats = NDArray[np.float64]
SAME_TIME = 1e-9
"""Of the last time: what two clocks' arithmetic makes of one instant; no camera is that fast for that long."""

# Of the range of all heights: before its release a filament hardly moves, and one filament is at one height at a time.
_AT_REST, _SAME = 0.05, 0.1
# Standard errors by which two readings of one height may differ.
_DEVIATIONS = 6.0


def repaired(table: Table, row: Callable[[int], str]) -> tuple[Table, tuple[str, ...], list[Fault]]:
    """Correct what needs no guess.

    Parameters
    ----------
    table : dict of str to ndarray, shape (rows,)
        TIME and MIDPOINT, or TIME, X and Y; perhaps STD. NaN where nothing is known.
    row : callable
        Given the index of a row, its name in a message: ``"line 7"``.

    Returns
    -------
    dict of str to ndarray
        In the order of time; no NaN, no time before 0, of the midpoint no time twice.
    tuple of str
        What was corrected, a sentence each.
    list of Fault
        Why it cannot be corrected; the table then means nothing.
    """
    notes: list[str] = []
    faults: list[Fault] = []
    rows = np.arange(table[TIME].size)
    for step in (_without_missing, _from_release, _in_order, _once):
        table, rows, said, fault = step(table, rows, row)
        notes += [said] if said else []
        if fault:
            faults.append(fault)
            break
    return table, tuple(notes), faults


Step = tuple[Table, NDArray[np.intp], str, Fault | None]


def _kept(table: Table, rows: NDArray[np.intp], which: NDArray[np.generic]) -> tuple[Table, NDArray[np.intp]]:
    return {name: values[which] for name, values in table.items()}, rows[which]


def _without_missing(table: Table, rows: NDArray[np.intp], row: Callable[[int], str]) -> Step:
    missing, said, fault = missing_rows(table, lambda k: row(int(rows[k])))
    return *(_kept(table, rows, ~missing) if said else (table, rows)), said, fault


def _from_release(table: Table, rows: NDArray[np.intp], row: Callable[[int], str]) -> Step:
    early = table[TIME] < 0
    count = int(early.sum())
    if not count:
        return table, rows, "", None
    found = f"{counted(count, 'row')} before time 0 ({listed(rows[early], row)})"
    height = table[MIDPOINT if MIDPOINT in table else Y]
    accepted = "times counted from the release of the filament, which is time 0"
    if count == rows.size:
        return table, rows, "", Fault("", "all times are before 0", accepted)
    if np.ptp(height[early]) > _AT_REST * np.ptp(height):
        return table, rows, "", Fault("", f"{found} in which the filament moves already", accepted)
    return *_kept(table, rows, ~early), f"Left out {found}, the release: nothing moves in them.", None


def _in_order(table: Table, rows: NDArray[np.intp], row: Callable[[int], str]) -> Step:
    if np.all(np.diff(table[TIME]) >= 0):
        return table, rows, "", None
    first = int(np.flatnonzero(np.diff(table[TIME]) < 0)[0]) + 1
    said = f"Sorted the rows by time; {row(int(rows[first]))} was the first to go back."
    return *_kept(table, rows, np.argsort(table[TIME], kind="stable")), said, None


def _once(table: Table, rows: NDArray[np.intp], row: Callable[[int], str]) -> Step:
    time = table[TIME]
    later = np.diff(time, prepend=-np.inf) > SAME_TIME * time[-1:]
    table = {**table, TIME: time[later][np.cumsum(later) - 1]}
    return _averaged(table, rows, row) if MIDPOINT in table else _no_point_twice(table, rows, row)


def _averaged(table: Table, rows: NDArray[np.intp], row: Callable[[int], str]) -> Step:
    """One midpoint for each time; independent readings, so weights are 1/std^2 and the variances add inversely."""
    time, height, std = table[TIME], table[MIDPOINT], table.get(STD)
    distinct, first, counts = np.unique(time, return_index=True, return_counts=True)
    if distinct.size == time.size:
        return table, rows, "", None
    lowest, highest = np.minimum.reduceat(height, first), np.maximum.reduceat(height, first)
    apart = highest - lowest
    allowed = _SAME * np.ptp(height) + (0.0 if std is None else _DEVIATIONS * np.maximum.reduceat(std, first))
    repeated = counts > 1
    if np.any(repeated & (apart > allowed)):
        worst = int(np.argmax(np.where(repeated, apart - allowed, -np.inf)))
        same = rows[time == distinct[worst]]
        found = f"midpoints of {lowest[worst]:g} m and {highest[worst]:g} m at the same time, {distinct[worst]:g} s"
        where = listed(same, row)
        return table, rows, "", Fault(where, found, "one height at a time; one file for each filament")
    weight = np.ones_like(height) if std is None else (std.max() / std) ** 2
    total = np.add.reduceat(weight, first)
    averaged = {TIME: distinct, MIDPOINT: np.add.reduceat(weight * height, first) / total}
    if std is not None:
        averaged[STD] = std.max() / np.sqrt(total)
    count = int(repeated.sum())
    places = listed(rows[np.isin(time, distinct[repeated])], row)
    said = f"Averaged the midpoints at {counted(count, 'time')} that occurred more than once ({places})."
    return averaged, rows[first], said, None


def _no_point_twice(table: Table, rows: NDArray[np.intp], row: Callable[[int], str]) -> Step:
    points = np.column_stack([table[TIME], table[X], table[Y]])
    _, first = np.unique(points, axis=0, return_index=True)
    if first.size == rows.size:
        return table, rows, "", None
    count = rows.size - first.size
    repeat = "repeats another" if count == 1 else "repeat others"
    said = f"Left out {counted(count, 'point')} of the shapes that {repeat}."
    return *_kept(table, rows, np.sort(first)), said, None
