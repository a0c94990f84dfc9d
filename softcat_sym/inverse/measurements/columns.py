"""Columns of a table of measurements: what their names measure, in which unit, and with which sign."""

from __future__ import annotations

from softcat_sym.errors import Fault
from softcat_sym.inverse.csv_columns import Column, CsvTable, absent, header_pattern, is_pixels, named, unit_of
from softcat_sym.scene.units import NotAQuantity, shown

TIME, MIDPOINT, X, Y, STD = "time", "midpoint", "x", "y", "std"
"""What a column may hold; STD is the standard error of the midpoint or of y."""

_TIME_UNITS, _LENGTH_UNITS = ("s", "ms", "us", "min", "h"), ("m", "cm", "mm", "um")

# A name before its unit: what it is, and whether it counts downwards.
_KNOWN = {
    "time": (TIME, False),
    "t": (TIME, False),
    "midpoint": (MIDPOINT, False),
    "sag": (MIDPOINT, True),
    "deflection": (MIDPOINT, True),
    "midpoint_std": (STD, False),
    "sag_std": (STD, False),
    "deflection_std": (STD, False),
    "x": (X, False),
    "y": (Y, False),
    "y_std": (STD, False),
}
_NAME = header_pattern(_KNOWN)


def columns_of(table: CsvTable) -> tuple[dict[str, Column], list[Fault]]:
    """Find the columns that are read; others are left alone.

    Parameters
    ----------
    table : CsvTable
        Whose header has names with their units, such as ``time_s`` or ``Time [s]``.

    Returns
    -------
    dict of str to Column, list of Fault
        By what they hold: TIME and MIDPOINT, or TIME, X and Y; perhaps STD.
    """
    where = f"line {table.line}"
    candidates: dict[str, list[Column]] = {}
    unreadable: dict[str, Fault] = {}
    unknown: list[Fault] = []
    for place, name in enumerate(table.header):
        match = _NAME.fullmatch(name.strip())
        if match is None:
            continue
        known, unit, bracketed = named(match)
        quantity, down = _KNOWN[known]
        try:
            si = unit_of(unit, *(("time", "s") if quantity == TIME else ("length", "m")))
        except NotAQuantity as found:
            fault = Fault(where, f"column {shown(name)}: {found}", _names(quantity))
            if bracketed and not is_pixels(unit):
                # What stands in brackets is meant as a unit, wherever else there is one of ours.
                unknown.append(fault)
            unreadable.setdefault(quantity, fault)
            continue
        candidates.setdefault(quantity, []).append(Column(name, place, si, down))
    found_columns = {quantity: several[0] for quantity, several in candidates.items()}
    # Of a tracker that writes pixels besides: what is there in units will do.
    there = [{MIDPOINT} <= set(found_columns), {X, Y} <= set(found_columns)]
    unneeded = {X, Y} if there == [True, False] else {MIDPOINT} if there == [False, True] else set()
    faults = [
        Fault(where, f"{len(several)} columns for one quantity: {', '.join(c.name for c in several)}", "one of them")
        for quantity, several in candidates.items()
        if len(several) > 1 and quantity not in unneeded
    ]
    for quantity in unneeded:
        found_columns.pop(quantity, None)
        unreadable.pop(quantity, None)
    # A name of ours without a unit of ours is another's column (time_stamp) where ours is there too.
    faults += [
        fault for quantity, fault in unreadable.items() if quantity not in found_columns and fault not in unknown
    ]
    return found_columns, unknown + faults + _missing(table, {*found_columns, *unreadable})


def _missing(table: CsvTable, there: set[str]) -> list[Fault]:
    """What the columns that are there do not make up: a midpoint over time, or whole shapes."""
    faults, where = [], f"line {table.line}"
    if TIME not in there:
        faults.append(absent("column of times", "time_s", _names(TIME), table, _NAME))
    if MIDPOINT in there and there & {X, Y}:
        accepted = "either midpoint_m, or x_m and y_m; two files for both"
        faults.append(Fault(where, "both a midpoint and points of a whole shape", accepted))
    elif Y in there and X not in there:
        faults.append(Fault(where, "y without x", "x_m too for whole shapes; midpoint_m for the midpoint alone"))
    elif X in there and Y not in there:
        faults.append(Fault(where, "x without y", "both for whole shapes; midpoint_m for the midpoint alone"))
    elif MIDPOINT not in there and Y not in there:
        faults.append(absent("column of midpoints", "midpoint_m", _names(MIDPOINT), table, _NAME))
    return faults


def _names(quantity: str) -> str:
    if quantity == TIME:
        return "time_s, " + ", ".join(f"time_{unit}" for unit in _TIME_UNITS[1:])
    if quantity == MIDPOINT:
        names = ", ".join(f"midpoint_{unit}" for unit in _LENGTH_UNITS)
        return f"{names}; or sag_m, positive down"
    stem = "midpoint_std" if quantity == STD else quantity
    return ", ".join(f"{stem}_{unit}" for unit in _LENGTH_UNITS)
