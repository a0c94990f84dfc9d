"""The one reader of a table of numbers that a person or an instrument wrote."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.files import read_limited
from softcat_sym.scene.units import NotAQuantity, did_you_mean, shown, to_si

_LONGEST = 1 << 24
_FAULTS_SHOWN = 8


def text_of(file: Path, kind: str, accepted: str) -> str:
    """Read a file of UTF-8 text, with or without a byte order mark."""

    def refused(found: str, where: str = "", instead: str = accepted) -> SoftcatError:
        return refusal(kind, file, [Fault(where, found, instead)])

    try:
        content = read_limited(file, _LONGEST + 1)
    except FileNotFoundError:
        raise refused("no such file") from None
    except IsADirectoryError:
        raise refused("a directory, not a file") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise refused(f"cannot be read: {reason}") from None
    if len(content) > _LONGEST:
        raise refused(f"longer than 16 MiB, which no {kind} is")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise refused("not UTF-8 text", f"line {line}", "CSV in UTF-8") from None
    if "\0" in text:
        raise refused("not text")
    return text


def data_lines(text: str) -> list[tuple[int, str]]:
    """Number the lines from 1 and keep those that are neither empty nor comments."""
    lines = enumerate(text.splitlines(), start=1)
    return [(number, line) for number, line in lines if line.strip() and not line.lstrip().startswith("#")]


def cells_of(line: str, separator: str = ",") -> list[str]:
    """Split one line into its cells.

    Line by line, since no cell of such a table goes on to the next line, and a stray quote then spoils one row only.
    """
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=separator), [])]
    except csv.Error:
        # A cell of more than 128 KiB, or a stray carriage return: no number either way.
        return [line]


def number_in(text: str) -> float | None:
    """Return the number that a cell holds, perhaps not finite; None if it holds none."""
    # Python reads 1_000 as a thousand; in a table it is a slip.
    if "_" in text:
        return None
    try:
        return float(text)
    except ValueError:
        return None


def counted(count: int, noun: str) -> str:
    """Write a number of things, such as ``1 fault`` or ``2 faults``."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def refusal(kind: str, path: Path | None, faults: Sequence[Fault]) -> SoftcatError:
    """Build the error that lists what is wrong with a file, the first faults in full and the others counted."""
    more = len(faults) - _FAULTS_SHOWN
    listed = [f"  {fault}" for fault in faults[:_FAULTS_SHOWN]] + ([f"  and {more} more"] if more > 0 else [])
    head = f"{kind} {path}" if path else kind
    return SoftcatError("\n".join([f"{head}: {counted(len(faults), 'fault')}", *listed]))


Table = dict[str, NDArray[np.float64]]
"""Columns of one length by what they hold, in SI; NaN where a cell is empty."""

MISSING = 1 / 3
"""Share of the rows from which on too many hold no number."""

# How trackers, rheometers and spreadsheets write that there is nothing.
_NOTHING = frozenset({"", "nan", "na", "n/a", "#n/a", "null", "none", "-"})
# The first line by which Excel tells itself how cells are separated.
_SEPARATOR_LINE = re.compile(r"sep=.?\s*", re.IGNORECASE)
_DECIMAL_COMMA = re.compile(r"([+-]?\d*),(\d*(?:[eE][+-]?\d+)?)")
_PIXELS = frozenset({"px", "pix", "pixel", "pixels"})
# How a name of a column, in which no slash may stand, and an instrument write 1/s.
_PER_SECOND = re.compile(r"1_s|s\^?-1")
_NAMES_SHOWN, _ROWS_SHOWN = 8, 5


@dataclass(frozen=True, slots=True)
class CsvTable:
    """Header and rows as cells, with the numbers of their lines."""

    line: int  # Of the header
    header: list[str]  # Names of the columns
    rows: list[tuple[int, list[str]]]  # Line and cells
    decimal_comma: bool  # Whether a comma separates no cells, so that it may stand in a number


@dataclass(frozen=True, slots=True)
class Column:
    """One column that is read."""

    name: str  # As the header writes it
    place: int  # Counted from 0
    unit: float  # SI value of its unit
    down: bool = False  # Whether its name says that it counts downwards

    def to_si(self, value: float) -> float:
        """Return the SI value of a finite number; in decimal, so that 6 mm is the same float as 0.006 m."""
        return float(Decimal(repr(value)) * Decimal(repr(self.unit)))


@dataclass(frozen=True, slots=True)
class Wanted:
    """What a column that is read holds."""

    quantity: str
    dimension: str
    si: str  # Its unit
    example: str  # Name as it should be
    accepted: str  # Names in words
    optional: bool = False  # Whether there may be no such column


def table_in(text: str) -> CsvTable | None:
    """Split a text into cells; separated by tabs, else by semicolons, else by commas. None if it holds no data."""
    lines = data_lines(text)
    if lines and _SEPARATOR_LINE.fullmatch(lines[0][1]):
        del lines[0]
    if not lines:
        return None
    number, first = lines[0]
    separator = next((one for one in "\t;" if one in first), ",")
    rows = [(k, cells_of(line, separator)) for k, line in lines[1:]]
    return CsvTable(number, cells_of(first, separator), rows, separator != ",")


def header_pattern(names: Iterable[str]) -> re.Pattern[str]:
    """Match a column's name with its unit: ``time_s``, ``time [s]``, ``Time (s)``, ``time / s``.

    The longest name that fits comes first, so that ``midpoint_std_m`` is no midpoint; an underscore in it may be a
    space.
    """
    spaced = [name.replace("_", "[_ ]") for name in sorted(names, key=len, reverse=True)]
    return re.compile(
        rf"(?P<name>{'|'.join(spaced)})"
        r"(?:_(?P<suffix>[^\s\[\](),;]+)|\s*\[(?P<square>[^\[\]]+)\]|\s*\((?P<round>[^()]+)\)|\s*/\s*(?P<slash>[^\[\]();,]+)|)",
        re.IGNORECASE,
    )


def named(match: re.Match[str]) -> tuple[str, str, bool]:
    """Return what :func:`header_pattern` has found: the name, its unit or nothing, whether that stands in brackets."""
    bracketed = match["square"] or match["round"] or match["slash"]
    return match["name"].lower().replace(" ", "_"), bracketed or match["suffix"] or "", bool(bracketed)


def is_pixels(unit: str) -> bool:
    """Tell whether a unit is that of a picture."""
    return unit.lower() in _PIXELS


def unit_of(unit: str, dimension: str, si: str) -> float:
    """Return the SI value of a column's unit."""
    if not unit:
        raise NotAQuantity("no unit in its name")
    # Pint knows a px of 1/96 inch, which is no camera's.
    if is_pixels(unit):
        raise NotAQuantity("pixels, which only the scale of the picture turns into lengths")
    return to_si(f"1 {'1/s' if _PER_SECOND.fullmatch(unit) else unit}", dimension, si)


def absent(what: str, wanted: str, accepted: str, table: CsvTable, pattern: re.Pattern[str]) -> Fault:
    """Build the fault of a column that is not there, with the nearest name that is."""
    header = table.header
    others = [] if len(header) == 1 else [name for name in header if pattern.fullmatch(name.strip()) is None]
    is_it = did_you_mean(wanted, others).replace("did you mean", "is it what is called")
    found = ", ".join(shown(name) for name in header[:_NAMES_SHOWN]) + (", ..." if len(header) > _NAMES_SHOWN else "")
    hint = "; cells separated by commas, semicolons or tabs" if len(header) == 1 else ""
    return Fault(f"line {table.line}", f"no {what} among {found}{is_it}", accepted + hint)


def columns_in(
    table: CsvTable,
    pattern: re.Pattern[str],
    wanted: Mapping[str, Wanted],
    unit_in: Callable[[str, str], float],
) -> tuple[dict[str, Column], list[Fault]]:
    """Find the columns of a table whose names match a pattern; `wanted` says what each name holds.

    `unit_in` returns the SI value of the unit in the heading of such a name, or raises :class:`NotAQuantity`.
    """
    where, faults = f"line {table.line}", list[Fault]()
    found: dict[str, list[Column]] = {one.quantity: [] for one in wanted.values()}
    for place, name in enumerate(table.header):
        match = pattern.fullmatch(name.strip())
        if match is None:
            continue
        known, unit, _ = named(match)
        try:
            si = unit_in(known, unit)
        except NotAQuantity as error:
            si = math.nan
            faults.append(Fault(where, f"column {shown(name)}: {error}", wanted[known].accepted))
        found[wanted[known].quantity].append(Column(name, place, si))
    for one in dict.fromkeys(wanted.values()):
        several = found[one.quantity]
        if not several and not one.optional:
            faults.append(absent(f"column {one.quantity}", one.example, one.accepted, table, pattern))
        elif len(several) > 1:
            names = ", ".join(column.name for column in several)
            faults.append(Fault(where, f"{len(several)} columns for one quantity: {names}", "one of them"))
    return {quantity: several[0] for quantity, several in found.items() if several}, faults


def numbers_in(
    table: CsvTable, columns: Mapping[str, Column], wrong: Callable[[str, float], tuple[str, str] | None]
) -> tuple[Table, list[Fault]]:
    """Read the cells of some columns in SI units."""
    faults: list[Fault] = []
    values: dict[str, list[float]] = {quantity: [] for quantity in columns}
    width = len(table.header)
    for line, cells in table.rows:
        if any(cells[width:]):
            decimal = "" if table.decimal_comma else "; decimal commas need semicolons or tabs between the cells"
            found = f"{len(cells)} cells under {counted(width, 'name')}"
            faults.append(Fault(f"line {line}", found, f"a cell for each column{decimal}"))
            continue
        for quantity, column in columns.items():
            text = cells[column.place] if column.place < len(cells) else ""
            value, fault = _number(text, table.decimal_comma)
            if not fault and not math.isnan(value):
                value = column.to_si(value) if math.isfinite(value) else value
                fault = wrong(quantity, value)
            faults += [Fault(f"line {line}, {column.name}", *fault)] if fault else []
            values[quantity].append(math.nan if fault else value)
    return {quantity: np.array(column, dtype=np.float64) for quantity, column in values.items()}, faults


def _number(text: str, decimal_comma: bool) -> tuple[float, tuple[str, str] | None]:
    if text.lower() in _NOTHING:
        return math.nan, None
    match = _DECIMAL_COMMA.fullmatch(text) if decimal_comma else None
    value = number_in(f"{match[1]}.{match[2]}" if match else text)
    if value is None:
        return math.nan, (f"{shown(text)} is not a number", "a number such as 0.5, or nothing")
    return value, None


def missing_rows(table: Table, row: Callable[[int], str]) -> tuple[NDArray[np.bool_], str, Fault | None]:
    """Find rows without a number; say that they are left out, or refuse a table of which they are too many."""
    missing = np.any([np.isnan(values) for values in table.values()], axis=0)
    count = int(missing.sum())
    if not count:
        return missing, "", None
    found = f"{count} of {counted(missing.size, 'row')} without a number ({listed(np.flatnonzero(missing), row)})"
    if count >= MISSING * missing.size:
        return missing, "", Fault("", found, "a number in every cell of at least two thirds of the rows")
    return missing, f"Left out {found}.", None


def listed(rows: NDArray[np.intp], row: Callable[[int], str]) -> str:
    """Name the first of some rows."""
    names = [row(int(k)) for k in rows[:_ROWS_SHOWN]]
    return ", ".join(names) + (", ..." if rows.size > _ROWS_SHOWN else "")
