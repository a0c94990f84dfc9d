"""Columns of a table of measurements: what their names measure, in which unit, and with which sign."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal

from softcat_sym.errors import Fault
from softcat_sym.scene.faults import did_you_mean
from softcat_sym.scene.units import NotAQuantity, shown, to_si

TIME, MIDPOINT, X, Y, STD = "time", "midpoint", "x", "y", "std"
"""What a column may hold; STD is the standard error of the midpoint or of y."""

_TIME_UNITS, _LENGTH_UNITS = ("s", "ms", "us", "min", "h"), ("m", "cm", "mm", "um")
_NAMES_SHOWN = 8
_PIXELS = frozenset({"px", "pix", "pixel", "pixels"})

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
# time_s, time [s], Time (s): the longest name that fits comes first, so that midpoint_std_m is no midpoint.
_NAME = re.compile(
    rf"(?P<name>{'|'.join(sorted(_KNOWN, key=len, reverse=True))})"
    r"(?:_(?P<suffix>[^\s\[\](),;]+)|\s*\[(?P<square>[^\[\]]+)\]|\s*\((?P<round>[^()]+)\)|)",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class Column:
    """One column that is read.

    Attributes
    ----------
    name : str
        As the header writes it.
    place : int
        Counted from 0.
    unit : float
        SI value of its unit, [s] or [m].
    down : bool
        Whether its name says that it counts downwards.
    """

    name: str
    place: int
    unit: float
    down: bool = False

    def to_si(self, value: float) -> float:
        """Return the SI value of a finite number; in decimal, so that 6 mm is the same float as 0.006 m."""
        return float(Decimal(repr(value)) * Decimal(repr(self.unit)))


def columns_of(header: Sequence[str], where: str = "") -> tuple[dict[str, Column], list[Fault]]:
    """Find the columns that are read; others are left alone.

    Parameters
    ----------
    header : sequence of str
        Names with their units, such as ``time_s`` or ``Time [s]``.
    where : str
        What the faults name as their place.

    Returns
    -------
    dict of str to Column, list of Fault
        By what they hold: TIME and MIDPOINT, or TIME, X and Y; perhaps STD.
    """
    candidates: dict[str, list[Column]] = {}
    unreadable: dict[str, Fault] = {}
    for place, name in enumerate(header):
        match = _NAME.fullmatch(name.strip())
        if match is None:
            continue
        quantity, down = _KNOWN[match["name"].lower()]
        try:
            unit = _unit(match["suffix"] or match["square"] or match["round"], quantity)
        except NotAQuantity as found:
            unreadable.setdefault(quantity, Fault(where, f"column {shown(name)}: {found}", _names(quantity)))
            continue
        candidates.setdefault(quantity, []).append(Column(name, place, unit, down))
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
    faults += [fault for quantity, fault in unreadable.items() if quantity not in found_columns]
    return found_columns, faults + _missing(header, {*found_columns, *unreadable}, where)


def _unit(unit: str | None, quantity: str) -> float:
    """SI value of a unit of time or length; raises `NotAQuantity`."""
    if not unit:
        raise NotAQuantity("no unit in its name")
    # Pint knows a px of 1/96 inch, which is no camera's.
    if unit.lower() in _PIXELS:
        raise NotAQuantity("pixels, which only the scale of the picture turns into lengths")
    return to_si(f"1 {unit}", "time" if quantity == TIME else "length")


def _missing(header: Sequence[str], there: set[str], where: str) -> list[Fault]:
    """What the columns that are there do not make up: a midpoint over time, or whole shapes."""
    faults = []
    if TIME not in there:
        faults.append(_absent("column of times", TIME, header, where))
    if MIDPOINT in there and there & {X, Y}:
        accepted = "either midpoint_m, or x_m and y_m; two files for both"
        faults.append(Fault(where, "both a midpoint and points of a whole shape", accepted))
    elif Y in there and X not in there:
        faults.append(Fault(where, "y without x", "x_m too for whole shapes; midpoint_m for the midpoint alone"))
    elif X in there and Y not in there:
        faults.append(Fault(where, "x without y", "both for whole shapes; midpoint_m for the midpoint alone"))
    elif MIDPOINT not in there and Y not in there:
        faults.append(_absent("column of midpoints", MIDPOINT, header, where))
    return faults


def _absent(what: str, quantity: str, header: Sequence[str], where: str) -> Fault:
    wanted = "time_s" if quantity == TIME else "midpoint_m"
    near = (
        ""
        if len(header) == 1
        else did_you_mean(wanted, [name for name in header if _NAME.fullmatch(name.strip()) is None])
    )
    found = ", ".join(shown(name) for name in header[:_NAMES_SHOWN]) + (", ..." if len(header) > _NAMES_SHOWN else "")
    hint = "; cells separated by commas, semicolons or tabs" if len(header) == 1 else ""
    is_it = near.replace("did you mean", "is it what is called")
    return Fault(where, f"no {what} among {found}{is_it}", _names(quantity) + hint)


def _names(quantity: str) -> str:
    if quantity == TIME:
        return "time_s, " + ", ".join(f"time_{unit}" for unit in _TIME_UNITS[1:])
    if quantity == MIDPOINT:
        names = ", ".join(f"midpoint_{unit}" for unit in _LENGTH_UNITS)
        return f"{names}; or sag_m, positive down"
    stem = "midpoint_std" if quantity == STD else quantity
    return ", ".join(f"{stem}_{unit}" for unit in _LENGTH_UNITS)
