"""The one reader of tables of data: what people, spreadsheets, instruments and trackers write, as columns in SI."""

from __future__ import annotations

import csv
import math
import re
import tomllib
import warnings
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
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

Scale = Callable[[str, str], tuple[float, float]]
"""SI value of the unit of a quantity, and the number at which it is zero; or it raises :class:`NotAQuantity`."""

MAX_MISSING = 1 / 3
"""Share of the rows from which on too many cannot be used."""

# Largest magnitude of a number, and smallest standard error, in SI units.
_MOST, _FINEST = 1e12, 1e-15
_LONGEST = 1 << 24
_FAULTS_SHOWN, _NAMES_SHOWN, _ROWS_SHOWN = 8, 8, 5
_SEPARATORS = ("\t", ";", ",", " ")
_MOST_UNIT_ROWS = 3  # TrackMate writes three lines below the names
_DECIMAL_COMMA = re.compile(r"([+-]?\d*),(\d*(?:[eE][+-]?\d+)?)")
_CLOCK = re.compile(r"(-?) ?(\d+):([0-5]\d):([0-5]\d)([:.,])(\d+)")
# Logger Pro writes the name of a data set before that of a column.
_HEADING = (
    r"(?:[^:]+:\s*)?(?P<name>{})"
    r"(?:_(?P<suffix>[^\s()\[\],;]+)|\s*(?:\[(?P<square>[^\[\]]+)\]|\((?P<round>[^()]+)\)|/\s*(?P<slash>[^()\[\],;]+)"
    r"|\bin\s+(?P<word>\S.*))|)"
)


@cache
def known(what: str) -> Any:
    """What columns, comments and cells may hold, and how people and makers write it."""
    return tomllib.loads((files("softcat_sym.scene") / "table_reader.toml").read_text(encoding="utf-8"))[what]


def read_text(file: Path, kind: str, accepted: str) -> str:
    """Read a text in UTF-8, UTF-16 with its mark, or Windows' Latin-1."""
    reason = "not text"
    try:
        content = read_limited(file, _LONGEST + 1)
    except OSError as error:
        content, reason = b"\0", f"cannot be read: {str(error.strerror).lower().removesuffix(' or directory')}"
    if len(content) > _LONGEST:
        content, reason = b"\0", f"longer than 16 MiB, which no {kind} is"
    is_wide = content.startswith((b"\xff\xfe", b"\xfe\xff"))
    for encoding in ("utf-16",) if is_wide else ("utf-8-sig", "cp1252"):
        text = content.decode(encoding, errors="surrogateescape")
        # A control character, or half a letter in place of a byte that is none.
        if not any(category(letter) in ("Cc", "Cs") and not letter.isspace() for letter in set(text)):
            return text
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


def number_in(text: str) -> float | None:
    """Return the number that a cell holds, perhaps with a decimal comma or not finite; None if it holds none."""
    match = _DECIMAL_COMMA.fullmatch(text)
    try:
        # Python reads 1_000 as a thousand; in a table it is a slip.
        return None if "_" in text else float(f"{match[1]}.{match[2]}" if match else text)
    except ValueError:
        return None


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


def is_pixels(unit: str) -> bool:
    """Tell whether a unit is that of a picture."""
    return unit.lower() in ("px", "pix", "pixel", "pixels")


def scale_of(quantity: str, unit: str) -> tuple[float, float]:
    """SI value of the unit of a column, and the number at which its quantity is zero."""
    kind, ratios = known("columns")[quantity], known("cells")["ratios"]
    if kind["dimension"] == "ratio":
        if unit.lower() not in ratios:
            raise NotAQuantity(f"{shown(unit)} is no unit of a ratio" if unit else "no unit, which may be % or 1")
        return ratios[unit.lower()], 0.0
    if not unit and kind["unit"]:
        raise NotAQuantity("no unit in its name")
    # Pint knows a px of 1/96 inch, which is no camera's, and takes turns for a shear rate.
    if is_pixels(unit):
        raise NotAQuantity("pixels, which only the scale of the picture turns into lengths")
    if unit.lower() in ("rpm", "rps"):
        raise NotAQuantity(f"{unit} is a rotational speed, whose shear rate depends on the geometry")
    return to_si(f"1 {_spelt(unit)}", kind["dimension"], kind["unit"]) if kind["unit"] else 1.0, 0.0


def _spelt(unit: str) -> str:
    """A unit of an instrument, or of a name in which no slash may stand, as Pint reads it."""
    unit = unit.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻·⋅∙", "0123456789-***"))
    for pattern, spelling in known("cells")["units"]:
        unit = re.sub(pattern, spelling, unit)
    return unit


@dataclass(kw_only=True)
class Source:
    """A file or arrays of data, and what was skipped or changed in them."""

    kind: str
    path: Path | None = None
    said: list[str] = field(default_factory=list)

    def refuse(self, faults: Sequence[Fault]) -> None:
        """Refuse the data if they have faults."""
        if faults:
            raise refusal(self.kind, self.path, faults)

    def without(self, table: pd.DataFrame, bad: pd.Series, what: str) -> pd.DataFrame:
        """Leave rows out and say so, or refuse a table of which they are too many."""
        if not bad.any():
            return table
        found = f"{bad.sum()} of {counted(len(table), 'row')} without a {what} ({listed(table.index[bad])})"
        if bad.sum() >= MAX_MISSING * len(table):
            self.refuse([Fault("", found, f"a {what} in every cell of at least two thirds of the rows")])
        self.said.append(f"left out {found}")
        return table[~bad]

    @property
    def notes(self) -> tuple[str, ...]:
        """What was skipped or changed, as one sentence, or none."""
        text = "; ".join(dict.fromkeys(self.said))
        return (f"{text[0].upper()}{text[1:]}.",) if text else ()


@dataclass(kw_only=True)
class Table(Source):
    """The table of a file, as text."""

    text: str  # Of the whole file
    line: int  # Of the header
    header: list[str]
    separator: str
    units: list[str] = field(default_factory=list)  # Of a row of their own, perhaps empty
    rows: list[tuple[int, list[str]]] = field(default_factory=list)  # Line and cells, as many as names at least

    def columns(self, quantities: tuple[str, ...], scale: Scale = scale_of) -> list[Column]:
        """Columns of some quantities."""
        found = []
        for place, name in enumerate(self.header):
            one = column_of(name, quantities)
            if one is None:
                continue
            one = replace(one, place=place, unit_name=one.unit_name or self.units[place])
            try:
                unit, zero = scale(one.quantity, one.unit_name)
                found.append(replace(one, unit=one.sign * unit, zero=zero))
            except NotAQuantity as error:
                accepted = known("columns")[one.quantity]["accepted"]
                fault = Fault(f"line {self.line}", f"column {shown(name)}: {error}", accepted)
                found.append(replace(one, fault=fault))
        return found

    def numbers(self, columns: Sequence[Column], needed: Sequence[str], more: Sequence[str] = ()) -> pd.DataFrame:
        """Numbers in SI by line, of one column for each quantity that is needed, and of `more` as far as they exist.

        Two columns for one quantity are refused, and none that can be read, and unknown units in brackets.
        """
        read, faults, where = list[Column](), list[Fault](), f"line {self.line}"
        for quantity in dict.fromkeys((*needed, *more)):
            there = [one for one in columns if one.quantity == quantity]
            readable = [one for one in there if one.fault is None]
            if len(readable) > 1:
                names = ", ".join(one.name for one in readable)
                faults.append(Fault(where, f"{len(readable)} columns for one quantity: {names}", "one of them"))
            # A name that goes on (time_stamp) is no matter where another column is read, a unit in brackets is.
            surely = [one for one in there if one.in_brackets and not is_pixels(one.unit_name)]
            faults += [one.fault for one in (surely if readable else there) if one.fault]
            faults += [self._absent(quantity)] if quantity in needed and not there else []
            read += readable[:1]
        self.refuse(faults)
        self.check_rows()
        return self._numbers(read)

    def number_rows(self, name: str) -> None:
        """Add a column with the numbers of the rows, from 0."""
        self.header, self.units = [name, *self.header], ["", *self.units]
        self.rows = [(line, [str(number), *row]) for number, (line, row) in enumerate(self.rows)]

    def check_rows(self) -> None:
        """Refuse a table without rows, or with more cells than names."""
        names = len(self.header)
        comma = "; decimal commas need semicolons or tabs between the cells" if self.separator == "," else ""
        wide = [(line, len(cells)) for line, cells in self.rows if any(cells[names:])]
        found = [(line, f"{count} cells under {counted(names, 'name')}") for line, count in wide]
        faults = [Fault(f"line {line}", what, f"a cell for each column{comma}") for line, what in found]
        no_rows = Fault(f"line {self.line}", "no rows below the header", "a row of cells below it")
        self.refuse(faults if self.rows else [no_rows])

    def _absent(self, quantity: str) -> Fault:
        """The fault of a column that is not there, with the nearest name that is."""
        accepted, header = known("columns")[quantity]["accepted"], self.header
        others = [name for name in header if column_of(name, tuple(known("columns"))) is None]
        near = did_you_mean(accepted.split(",")[0], others).replace("did you mean", "is it what is called")
        found = ", ".join(map(shown, header[:_NAMES_SHOWN])) + (", ..." if len(header) > _NAMES_SHOWN else "")
        hint = "; cells separated by commas, semicolons, tabs or blanks" if len(header) == 1 else ""
        what = f"no column {quantity.replace('_', ' ')} among {found}{near}"
        return Fault(f"line {self.line}", what, accepted + hint)

    def _numbers(self, columns: Sequence[Column]) -> pd.DataFrame:
        import pandas as pd  # not needed by a run

        missing: Sequence[str] = known("cells")["missing"]
        in_hundredths = "kinovea" in self.text.lower()
        faults, values = list[Fault](), list[list[float]]()
        for line, cells in self.rows:
            values.append([])
            for one in columns:
                cell = cells[one.place]
                number = math.nan if cell.lower() in missing else number_in(cell)
                clock = _seconds(cell, in_hundredths=in_hundredths) if one.quantity == "time" else None
                value = clock if clock is not None else math.nan if number is None else one.to_si(number)
                fault = None if math.isnan(value) else implausible(one.quantity, value)
                if number is None and clock is None:
                    fault = f"{shown(cell)} is not a number", "a number such as 0.5, or nothing"
                faults += [Fault(f"line {line}, {one.name}", *fault)] if fault else []
                values[-1].append(value)
        self.refuse(faults)
        lines, names = [f"line {line}" for line, _ in self.rows], [one.quantity for one in columns]
        return pd.DataFrame(values, lines, names, dtype=float)


def cells_of(line: str, separator: str) -> list[str]:
    """Split one line into its cells: as none goes on to the next line, a stray quote spoils one row only."""
    try:
        found = next(csv.reader([line], delimiter=separator, skipinitialspace=True), []) if separator != " " else []
    except csv.Error:
        # A cell of more than 128 KiB, or a stray carriage return: no number either way.
        return [line]
    return [cell.strip() for cell in found] or line.split()


def read_table(file: Path, kind: str, accepted: str, named: tuple[str, ...] | Callable[[str], object]) -> Table:
    """Read a file, and find the table in it that has columns of some quantities, or whose headings are understood.

    Its header is the line in which most names are understood, perhaps a comment, as NumPy writes it. Rows go on below
    every header that is the same; what stands between an empty line and the next header is another table's.
    """
    text = read_text(file, kind, accepted)
    understood = named if callable(named) else partial(column_of, quantities=named)
    lines = list(enumerate(text.splitlines(), start=1))
    data = [(k, line) for k, line in lines if line.strip() and not line.lstrip().startswith("#")]
    # By its first line Excel tells itself how cells are separated.
    data = data[1:] if data and re.fullmatch(r"sep=.?\s*", data[0][1], re.IGNORECASE) else data
    if not data:
        raise refusal(kind, file, [Fault("", "the file holds no data", accepted)])
    comments = [(k, line.lstrip().lstrip("#")) for k, line in lines if line.lstrip().startswith("#")]
    number, separator, header = _header(data, understood, 1) or _header(comments, understood, 2) or _first(*data[0])
    table = Table(kind=kind, path=file, text=text, line=number, header=header, separator=separator)
    if above := sum(k < number for k, _ in data):
        table.said.append(f"skipped {counted(above, 'line')} above the header in line {number}")
    _add_rows(table, [(k, line, k > 1 and not lines[k - 2][1].strip()) for k, line in data if k > number], understood)
    return table


def _header(
    lines: Iterable[tuple[int, str]], understood: Callable[[str], object], fewest: int
) -> tuple[int, str, list[str]] | None:
    """Number, separator and cells of the line in which most quantities are understood, if they are enough."""
    best, found = fewest - 1, None
    for number, line in lines:
        for separator in _SEPARATORS if any(map(str.isalpha, line)) else ():
            cells = cells_of(line, separator)
            names = {getattr(one, "quantity", one) for one in map(understood, cells) if one is not None}
            if len(names) > best:
                best, found = len(names), (number, separator, cells)
    return found


def _first(number: int, line: str) -> tuple[int, str, list[str]]:
    separator = next((one for one in "\t;" if one in line), ",")
    return number, separator, cells_of(line, separator)


def _add_rows(table: Table, lines: Iterable[tuple[int, str, bool]], understood: Callable[[str], object]) -> None:
    """Take rows, and perhaps their units, from the lines below the header; of each it is known if a blank precedes."""
    places = [k for k, name in enumerate(table.header) if understood(name) is not None]

    def has_number(row: Sequence[str]) -> bool:
        return any(number_in(row[place]) is not None for place in places)

    again, outside, is_inside = list[int](), list[int](), True
    for number, line, is_after_blank in lines:
        row = cells_of(line, table.separator)
        row += [""] * (len(table.header) - len(row))
        if row == table.header:
            is_inside = True
            again.append(number)
            continue
        is_inside = is_inside and not (table.rows and is_after_blank and any(row) and not has_number(row))
        if is_inside:
            table.rows.append((number, row))
        else:
            outside.append(number)
    if again:
        table.said.append(f"joined {len(again) + 1} tables with the same header (again in line {listed(again)})")
    if outside:
        table.said.append(f"left out {counted(len(outside), 'line')} outside of the table (line {listed(outside)})")
    if any(_DECIMAL_COMMA.fullmatch(cell) for _, row in table.rows for cell in row):
        table.said.append("read decimal commas")
    # Units stand in the last line between the header and the first number, and again below a header that is the same.
    first = next((k for k, (_, row) in enumerate(table.rows) if has_number(row)), 0)
    below, table.units = [row for _, row in table.rows[:first]], [""] * len(table.header)
    if 0 < first <= _MOST_UNIT_ROWS and any(_is_unit(below[-1][place]) for place in places):
        table.units = [cell.strip("[]()") for cell in below[-1]]
        table.said.append(f"took units from line {table.rows[first - 1][0]}")
        table.rows = [(number, row) for number, row in table.rows if row not in below]


def _seconds(cell: str, *, in_hundredths: bool) -> float | None:
    """A time of day [s]; None if a cell holds none. After the last colon Kinovea writes 1/100 s, others frames."""
    match = _CLOCK.fullmatch(cell)
    if not match or (match[5] == ":" and not in_hundredths):
        return None
    whole = 3600 * int(match[2]) + 60 * int(match[3]) + int(match[4])
    return float(f"{match[1]}{whole}.{match[6]}")


def _is_unit(text: str) -> bool:
    if text.lower() in known("cells")["missing"]:
        return False
    try:
        return text[0] in "[(" or is_pixels(text) or bool(to_si_of_any(f"1 {_spelt(text)}"))
    except NotAQuantity:
        return False


def points_in(file: Path, accepted: str) -> tuple[tuple[float, ...], ...]:
    """Rows of a path: x, y and z, in any unit of length."""
    axes = ("x", "y", "z")
    table = read_table(file, "polyline", f"a CSV file with {accepted}", axes)
    points = table.numbers(table.columns(axes), axes)
    missing = points.index[points.isna().any(axis=1)]
    table.refuse([Fault(line, "not a number", "a finite number in every cell") for line in missing])
    for note in table.notes:
        warnings.warn(f"{file}: {note}", SoftcatWarning, stacklevel=2)
    return tuple(map(tuple, points.to_numpy().tolist()))
