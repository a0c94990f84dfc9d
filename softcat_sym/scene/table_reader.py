"""The one reader of tables of data: what people, spreadsheets, instruments and trackers write, as columns in SI."""

from __future__ import annotations

import csv
import math
import re
import tomllib
import warnings
from collections.abc import Callable, Container, Iterable, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cache, lru_cache, partial
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any
from unicodedata import category

from softcat_sym.errors import Fault, SoftcatError, SoftcatWarning
from softcat_sym.files import read_limited
from softcat_sym.scene.units import NotAQuantity, did_you_mean, shown, to_si, to_si_of_any

if TYPE_CHECKING:
    import pandas as pd

MISSING = 1 / 3
"""Share of the rows from which on too many cannot be used."""

NOTHING = frozenset({"", "nan", "na", "n/a", "#n/a", "null", "none", "-", "---"})
"""How trackers, rheometers and spreadsheets write that there is nothing."""

# Largest magnitude of a number, and smallest standard error, in SI units.
_MOST, _FINEST = 1e12, 1e-15
_LONGEST = 1 << 24
_FAULTS_SHOWN, _NAMES_SHOWN, _ROWS_SHOWN = 8, 8, 5
_SEPARATORS = ("\t", ";", ",", " ")
_MOST_UNIT_ROWS = 3  # TrackMate writes three lines below the names
_DECIMAL_COMMA = re.compile(r"([+-]?\d*),(\d*(?:[eE][+-]?\d+)?)")
# Logger Pro writes the name of a data set before that of a column.
_HEADING = (
    r"(?:[^:]+:\s*)?(?P<name>{})"
    r"(?:_(?P<suffix>[^\s()\[\],;]+)|\s*(?:\[(?P<square>[^\[\]]+)\]|\((?P<round>[^()]+)\)|/\s*(?P<slash>[^()\[\],;]+)"
    r"|\bin\s+(?P<word>\S.*))|)"
)
# How instruments, and names in which no slash may stand, write units that Pint reads otherwise.
_SIGNS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻·⋅∙", "0123456789-***")
_SPELLINGS = (
    (re.compile(r"1_s"), "1/s"),
    (re.compile(r"(?<=[A-Za-z])\.(?=[A-Za-z])"), "*"),
    (re.compile(r"(?<=Pa)s$"), "*s"),
    (re.compile(r"(?<=[A-Za-z])\^?(-\d)"), r"^\1"),
)


_RATIOS = {"%": 0.01, "pct": 0.01, "percent": 0.01, "1": 1.0, "-": 1.0}
"""SI value of what instruments write as the unit of a strain."""


def read_text(file: Path, kind: str, accepted: str) -> str:
    """Read a text in UTF-8, UTF-16 with its mark, or Windows' Latin-1."""
    reason = "not text"
    try:
        content = read_limited(file, _LONGEST + 1)
        if len(content) > _LONGEST:
            raise ValueError(f"longer than 16 MiB, which no {kind} is")
        is_wide = content.startswith((b"\xff\xfe", b"\xfe\xff"))
        for encoding in ("utf-16",) if is_wide else ("utf-8-sig", "cp1252"):
            text = content.decode(encoding, errors="surrogateescape")
            # A control character, or half a letter in place of a byte that is none.
            if not any(category(letter) in ("Cc", "Cs") and not letter.isspace() for letter in set(text)):
                return text
    except FileNotFoundError:
        reason = "no such file"
    except IsADirectoryError:
        reason = "a directory, not a file"
    except (OSError, ValueError) as error:
        reason = f"cannot be read: {error.strerror if isinstance(error, OSError) else error}"
    raise refusal(kind, file, [Fault("", reason, accepted)])


def refusal(kind: str, path: Path | None, faults: Sequence[Fault]) -> SoftcatError:
    """Build the error that lists what is wrong with a file, the first faults in full and the others counted."""
    more = len(faults) - _FAULTS_SHOWN
    lines = [f"  {fault}" for fault in faults[:_FAULTS_SHOWN]] + ([f"  and {more} more"] if more > 0 else [])
    head = f"{kind} {path}" if path else kind
    return SoftcatError("\n".join([f"{head}: {counted(len(faults), 'fault')}", *lines]))


def counted(count: int, noun: str) -> str:
    """Write a number of things, such as ``1 fault`` or ``2 faults``."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def listed(names: Iterable[object]) -> str:
    """Name the first of some rows."""
    first = list(map(str, names))
    return ", ".join(first[:_ROWS_SHOWN]) + (", ..." if len(first) > _ROWS_SHOWN else "")


def sentence(*parts: str) -> tuple[str, ...]:
    """Join what is said into one sentence, or none."""
    text = "; ".join(filter(None, dict.fromkeys(parts)))
    return (f"{text[0].upper()}{text[1:]}.",) if text else ()


def number_in(text: str) -> float | None:
    """Return the number that a cell holds, perhaps with a decimal comma or not finite; None if it holds none."""
    match = _DECIMAL_COMMA.fullmatch(text)
    try:
        # Python reads 1_000 as a thousand; in a table it is a slip.
        return None if "_" in text else float(f"{match[1]}.{match[2]}" if match else text)
    except ValueError:
        return None


@cache
def known(what: str) -> Any:
    """What columns or comments may hold, and how people and makers call it."""
    table: dict[str, Any] = tomllib.loads(
        (files("softcat_sym.scene") / "table_reader.toml").read_text(encoding="utf-8")
    )
    return table[what]


@dataclass(frozen=True, slots=True)
class Column:
    """A column of a known quantity."""

    quantity: str
    name: str  # As the header writes it
    unit_name: str = ""  # As written, or empty
    in_brackets: bool = False  # Whether that cannot be a part of another name
    sign: int = 1  # Negative if its name says that it counts downwards
    place: int = 0  # Counted from 0
    unit: float = math.nan  # SI value of its unit, with the sign
    zero: float = 0.0  # Number at which the quantity is zero
    fault: Fault | None = None  # Why it cannot be read

    def to_si(self, number: float) -> float:
        """The SI value of a number; in decimal, so that 6 mm is the same float as 0.006 m."""
        if not math.isfinite(number):
            return number
        return float((Decimal(repr(number)) - Decimal(repr(self.zero))) * Decimal(repr(self.unit))) + 0.0


@lru_cache(maxsize=4096)
def column_of(name: str, quantities: tuple[str, ...]) -> Column | None:
    """Understand ``time_s``, ``Time (s)``, ``time / s`` or ``Latest: Time [s]``; the longest name counts."""
    longest, found = 0, None
    for quantity in quantities:
        for alias in known("columns")[quantity]["names"]:
            pattern = _HEADING.format(alias.removeprefix("-").replace(" ", "[ _]"))
            match = re.fullmatch(pattern, name.strip(), re.IGNORECASE)
            if match and len(match["name"]) > longest:
                longest = len(match["name"])
                bracketed = match["square"] or match["round"] or match["slash"] or match["word"]
                unit, sign = (bracketed or match["suffix"] or "").strip(), -1 if alias[0] == "-" else 1
                found = Column(quantity, name, unit, bracketed is not None, sign)
    return found


def quantity_of(name: str, quantities: tuple[str, ...]) -> str | None:
    """The quantity that a heading names, if it is one of these."""
    column = column_of(name, quantities)
    return column.quantity if column else None


def is_pixels(unit: str) -> bool:
    """Tell whether a unit is that of a picture."""
    return unit.lower() in ("px", "pix", "pixel", "pixels")


def scale_of(quantity: str, unit: str) -> tuple[float, float]:
    """SI value of the unit of a column, and the number at which its quantity is zero."""
    kind = known("columns")[quantity]
    if not unit and kind["unit"] and kind["dimension"] != "ratio":
        raise NotAQuantity("no unit in its name")
    # Pint knows a px of 1/96 inch, which is no camera's, and takes turns for a shear rate.
    if is_pixels(unit):
        raise NotAQuantity("pixels, which only the scale of the picture turns into lengths")
    if unit.lower() in ("rpm", "rps"):
        raise NotAQuantity(f"{unit} is a rotational speed, whose shear rate depends on the geometry")
    if kind["dimension"] == "ratio":
        if unit.lower() not in _RATIOS:
            raise NotAQuantity(f"{shown(unit)} is no unit of a ratio" if unit else "no unit, which may be % or 1")
        return _RATIOS[unit.lower()], 0.0
    return to_si(f"1 {_spelt(unit)}", kind["dimension"], kind["unit"]) if kind["unit"] else 1.0, 0.0


def _spelt(unit: str) -> str:
    plain = unit.translate(_SIGNS)
    for pattern, spelling in _SPELLINGS:
        plain = pattern.sub(spelling, plain)
    return plain


@dataclass
class Cells:
    """A table as text."""

    line: int  # Of the header
    header: list[str]
    rows: list[tuple[int, list[str]]]  # Line and cells
    separator: str
    said: list[str]  # What was skipped or changed
    units: tuple[str, ...] = ()  # Of a row of their own

    def columns(
        self, quantities: tuple[str, ...], scale: Callable[[str, str], tuple[float, float]] = scale_of
    ) -> list[Column]:
        """Columns of some quantities; `scale` has the unit and the zero of one, or raises :class:`NotAQuantity`."""
        found = []
        for place, name in enumerate(self.header):
            one = column_of(name, quantities)
            if one is None:
                continue
            unit_name = one.unit_name or (self.units[place] if self.units else "")
            try:
                unit, zero = scale(one.quantity, unit_name)
                found.append(replace(one, place=place, unit=one.sign * unit, zero=zero))
            except NotAQuantity as error:
                accepted = known("columns")[one.quantity]["accepted"]
                fault = Fault(f"line {self.line}", f"column {shown(name)}: {error}", accepted)
                found.append(replace(one, place=place, fault=fault))
        return found

    def chosen(self, columns: Sequence[Column], needed: Iterable[str]) -> tuple[dict[str, Column], list[Fault]]:
        """One column that can be read for each quantity.

        Faults are two of them for one, none that can be read, unknown units in brackets, and what is needed and absent.
        """
        read, faults, where = dict[str, Column](), list[Fault](), f"line {self.line}"
        for quantity in dict.fromkeys((*needed, *(one.quantity for one in columns))):
            there = [one for one in columns if one.quantity == quantity]
            readable = [one for one in there if one.fault is None]
            if len(readable) > 1:
                names = ", ".join(one.name for one in readable)
                faults.append(Fault(where, f"{len(readable)} columns for one quantity: {names}", "one of them"))
            # A name that goes on (time_stamp) is no matter where another column is read, a unit in brackets is.
            surely = [one for one in there if one.in_brackets and not is_pixels(one.unit_name)]
            faults += [one.fault for one in (surely if readable else there) if one.fault]
            faults += [] if there else [self.absent(quantity)]
            read |= {quantity: readable[0]} if readable else {}
        return read, faults or self.no_rows()

    def no_rows(self) -> list[Fault]:
        """The fault of a table that has none."""
        return [] if self.rows else [Fault(f"line {self.line}", "no rows below the header", "a row of cells below it")]

    def absent(self, quantity: str) -> Fault:
        """The fault of a column that is not there, with the nearest name that is."""
        accepted, header = known("columns")[quantity]["accepted"], self.header
        others = [name for name in header if column_of(name, tuple(known("columns"))) is None]
        near = did_you_mean(accepted.split(",")[0], others).replace("did you mean", "is it what is called")
        found = ", ".join(map(shown, header[:_NAMES_SHOWN])) + (", ..." if len(header) > _NAMES_SHOWN else "")
        hint = "; cells separated by commas, semicolons, tabs or blanks" if len(header) == 1 else ""
        what = f"no column {quantity.replace('_', ' ')} among {found}{near}"
        return Fault(f"line {self.line}", what, accepted + hint)

    def numbers(self, columns: Sequence[Column]) -> tuple[pd.DataFrame, list[Fault]]:
        """Numbers of some columns in SI, by line."""
        import pandas as pd  # not needed by a run

        faults, lines, values, width = list[Fault](), list[str](), list[list[float]](), len(self.header)
        for line, cells in self.rows:
            if any(cells[width:]):
                comma = "; decimal commas need semicolons or tabs between the cells" if self.separator == "," else ""
                found = f"{len(cells)} cells under {counted(width, 'name')}"
                faults.append(Fault(f"line {line}", found, f"a cell for each column{comma}"))
                continue
            row = []
            for one in columns:
                text = cells[one.place] if one.place < len(cells) else ""
                number = math.nan if text.lower() in NOTHING else number_in(text)
                row.append(math.nan if number is None else one.to_si(number))
                fault = None if math.isnan(row[-1]) else implausible(one.quantity, row[-1])
                if number is None:
                    fault = f"{shown(text)} is not a number", "a number such as 0.5, or nothing"
                faults += [Fault(f"line {line}, {one.name}", *fault)] if fault else []
            lines.append(f"line {line}")
            values.append(row)
        return pd.DataFrame(values, lines, [one.quantity for one in columns], dtype=float), faults


def implausible(quantity: str, value: float) -> tuple[str, str] | None:
    """Why a number in SI units cannot be measured, and what would be accepted; None if it can."""
    is_std = quantity.endswith("std")
    accepted = "a positive number" if is_std else "a finite number"
    if not math.isfinite(value):
        return f"{value} is not finite", accepted
    if is_std and value <= 0:
        return f"{value:g} is not positive", "a positive standard error; leave the column out if it is not known"
    if abs(value) > _MOST or (is_std and value < _FINEST):
        return f"{value:g} is beyond anything measured", f"{accepted}, in the unit that its name says"
    return None


def cells_of(line: str, separator: str) -> list[str]:
    """Split one line into its cells: as none goes on to the next line, a stray quote spoils one row only."""
    try:
        found = next(csv.reader([line], delimiter=separator, skipinitialspace=True), []) if separator != " " else []
    except csv.Error:
        # A cell of more than 128 KiB, or a stray carriage return: no number either way.
        return [line]
    return [cell.strip() for cell in found] or line.split()


Lines = list[tuple[int, str]]


def read_cells(
    file: Path, kind: str, accepted: str, understood: tuple[str, ...] | Callable[[str], str | None]
) -> tuple[str, Cells]:
    """Read a file, and find the table in it that has columns of some quantities, or whose headings are understood.

    Its header is the line in which most names are understood, perhaps a comment, as NumPy writes it. Rows go on below
    every header that is the same; what stands between an empty line and the next header is another table's.
    """
    text = read_text(file, kind, accepted)
    named = understood if callable(understood) else partial(quantity_of, quantities=understood)
    lines = list(enumerate(text.splitlines(), start=1))
    data = [(k, line) for k, line in lines if line.strip() and not line.lstrip().startswith("#")]
    # By its first line Excel tells itself how cells are separated.
    data = data[1:] if data and re.fullmatch(r"sep=.?\s*", data[0][1], re.IGNORECASE) else data
    if not data:
        raise refusal(kind, file, [Fault("", "the file holds no data", accepted)])
    number, first, separator = _header(lines, data, named)
    places = [k for k, name in enumerate(cells_of(first, separator)) if named(name) is not None]
    after_blank = {k + 1 for k, line in lines if not line.strip()}
    above = sum(k < number for k, _ in data)
    cells = Cells(number, cells_of(first, separator), [], separator, [])
    if above:
        cells.said.append(f"skipped {counted(above, 'line')} above the header in line {number}")
    _fill(cells, [(k, line) for k, line in data if k > number], places, after_blank)
    return text, _with_units(cells, places)


def _fill(cells: Cells, lines: Lines, places: Sequence[int], after_blank: Container[int]) -> None:
    """Take the rows from the lines below the header."""
    again, left, is_read = list[int](), list[int](), True
    for k, line in lines:
        row = cells_of(line, cells.separator)
        if row == cells.header:
            is_read = True
            again.append(k)
            continue
        if cells.rows and k in after_blank and any(row) and not _has_number(row, places):
            is_read = False
        if is_read:
            cells.rows.append((k, row))
        else:
            left.append(k)
    if again:
        cells.said.append(f"joined {len(again) + 1} tables with the same header (again in line {listed(again)})")
    if left:
        cells.said.append(f"left out {counted(len(left), 'line')} outside of the table (line {listed(left)})")
    if any(_DECIMAL_COMMA.fullmatch(cell) for _, row in cells.rows for cell in row):
        cells.said.append("read decimal commas")


def _header(lines: Lines, data: Lines, named: Callable[[str], str | None]) -> tuple[int, str, str]:
    """Number and text of the header, and what separates cells."""
    comments = [(k, line.lstrip().lstrip("#")) for k, line in lines if line.lstrip().startswith("#")]
    for candidates, fewest in ((data, 1), (comments, 2)):
        understood = (
            (len({*map(named, cells_of(line, one))} - {None}), k, line, one)
            for k, line in candidates
            if any(letter.isalpha() for letter in line)
            for one in _SEPARATORS
        )
        best = max(understood, key=lambda one: one[0], default=(0, 0, "", ""))
        if best[0] >= fewest:
            return best[1:]
    number, first = data[0]
    return number, first, next((one for one in "\t;" if one in first), ",")


def _has_number(cells: Sequence[str], places: Iterable[int]) -> bool:
    return any(place < len(cells) and number_in(cells[place]) is not None for place in places)


def _with_units(cells: Cells, places: Sequence[int]) -> Cells:
    """Take the units from the last line between the header and the first number, if it holds some."""
    count = next((k for k, (_, row) in enumerate(cells.rows) if _has_number(row, places)), 0)
    if not 0 < count <= _MOST_UNIT_ROWS:
        return cells
    line, last = cells.rows[count - 1]
    if not any(
        last[k][0] in "[(" or _is_unit(last[k]) for k in places if last[k : k + 1] and last[k].lower() not in NOTHING
    ):
        return cells
    below = [row for _, row in cells.rows[:count]]
    rows = [(k, row) for k, row in cells.rows if row not in below]
    units = tuple(cell.strip("[]()") for cell in (*last, *[""] * (len(cells.header) - len(last))))
    return replace(cells, rows=rows, units=units, said=[*cells.said, f"took units from line {line}"])


def _is_unit(text: str) -> bool:
    try:
        to_si_of_any(f"1 {_spelt(text)}")
    except NotAQuantity:
        return is_pixels(text)
    return True


def without(table: pd.DataFrame, bad: pd.Series, what: str) -> tuple[pd.DataFrame, str, list[Fault]]:
    """Leave rows out and say so, or refuse a table of which they are too many."""
    count = int(bad.sum())
    if not count:
        return table, "", []
    found = f"{count} of {counted(len(table), 'row')} without a {what} ({listed(table.index[bad])})"
    if count >= MISSING * len(table):
        return table, "", [Fault("", found, f"a {what} in every cell of at least two thirds of the rows")]
    return table[~bad], f"left out {found}", []


def points_in(file: Path, accepted: str) -> tuple[tuple[float, ...], ...]:
    """Rows of a path: x, y and z, in any unit of length."""
    kind, axes = "polyline", ("x", "y", "z")
    _, cells = read_cells(file, kind, f"a CSV file with {accepted}", axes)
    columns, faults = cells.chosen(cells.columns(axes), axes)
    if not faults:
        table, faults = cells.numbers([columns[axis] for axis in axes])
        missing = table.index[table.isna().any(axis=1)]
        faults = faults or [Fault(line, "not a number", "a finite number in every cell") for line in missing]
    if faults:
        raise refusal(kind, file, faults)
    for note in sentence(*cells.said):
        warnings.warn(f"{file}: {note}", SoftcatWarning, stacklevel=2)
    return tuple(map(tuple, table.to_numpy().tolist()))
