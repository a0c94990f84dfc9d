"""Films of falling filaments, read from CSV files of spreadsheets and image trackers."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.fitting.trackers import Camera, camera_in, in_rows
from softcat_sym.scene.csv_reader import (
    Column,
    CsvTable,
    Table,
    absent,
    counted,
    header_pattern,
    is_pixels,
    listed,
    missing_rows,
    named,
    numbers_in,
    refusal,
    table_in,
    text_of,
    unit_of,
)
from softcat_sym.scene.scene import known_keys
from softcat_sym.scene.units import NotAQuantity, shown, unknown_key

TIME, MIDPOINT, X, Y, STD = "time", "midpoint", "x", "y", "std"
VERTICAL, HORIZONTAL = "vertical_force", "horizontal_force"
"""Quantities of columns; STD is the standard error of the midpoint or of y, that of a force begins with its name."""

WAYS = (HORIZONTAL, VERTICAL)
"""Forces of the right support on the filament, outwards and upwards."""

_OF_FORCE = {way: f"{way}_{STD}" for way in WAYS}
FORCE, FRAME = "force", "frame"
_TIME_UNITS, _LENGTH_UNITS, _FORCE_UNITS = ("s", "ms", "us", "min", "h"), ("m", "cm", "mm", "um"), ("N", "mN", "uN")

# For a name before its unit: the quantity, and whether it counts downwards.
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
    **{name: (name, False) for pair in _OF_FORCE.items() for name in pair},
    FORCE: (FORCE, False),
    FRAME: (FRAME, False),
}
_NAME = header_pattern(_KNOWN)


def columns_of(table: CsvTable, camera: Camera) -> tuple[dict[str, Column], list[Fault]]:
    """Find the columns to read; others are ignored."""
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
            si = _si(quantity, unit, camera)
        except NotAQuantity as found:
            fault = Fault(where, f"column {shown(name)}: {found}", _names(quantity))
            if bracketed and not is_pixels(unit):
                # Text in brackets is meant as a unit, even if another column has the quantity with a known unit.
                unknown.append(fault)
            unreadable.setdefault(quantity, fault)
            continue
        candidates.setdefault(quantity, []).append(Column(name, place, si, down))
    found_columns = {quantity: several[0] for quantity, several in candidates.items()}
    # Frames replace times where there are none.
    of_frames = found_columns.pop(FRAME, None), unreadable.pop(FRAME, None)
    candidates.pop(FRAME, None)
    if TIME not in {*found_columns, *unreadable}:
        found_columns |= {} if of_frames[0] is None else {TIME: of_frames[0]}
        unreadable |= {} if of_frames[1] is None else {TIME: of_frames[1]}
    # A tracker may write further columns in pixels: columns with a known unit suffice.
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
    # A known name with an unknown unit (time_stamp) is ignored if the quantity has another column with a known unit.
    faults += [
        fault for quantity, fault in unreadable.items() if quantity not in found_columns and fault not in unknown
    ]
    return found_columns, unknown + faults + _missing(table, {*found_columns, *unreadable})


def _si(quantity: str, unit: str, camera: Camera) -> float:
    """SI value of the unit of a column; the camera gives that of frames and pixels."""
    if quantity == FORCE:
        raise NotAQuantity("a force without its direction")
    if quantity == FRAME:
        if camera.fps is None:
            raise NotAQuantity("frames without a frame rate: write # camera.fps = 240 in the file")
        return 1 / camera.fps
    in_pixels = is_pixels(unit) or (not unit and quantity in (X, Y))
    if in_pixels and camera.pixel is not None:
        return camera.pixel
    try:
        return unit_of(unit, *_dimension(quantity))
    except NotAQuantity as found:
        hint = ": # camera.pixel = 0.05 mm in the file" if in_pixels else ""
        raise NotAQuantity(f"{found}{hint}") from None


def _missing(table: CsvTable, there: set[str]) -> list[Fault]:
    """Faults of a combination of columns that is neither a midpoint over time, nor whole shapes, nor forces."""
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
    elif Y in there and there & {*WAYS}:
        faults.append(Fault(where, "forces beside points of a whole shape", "two files for both"))
    elif not there & {MIDPOINT, Y, FORCE, *WAYS}:
        faults.append(absent("column of midpoints", "midpoint_m", _names(MIDPOINT), table, _NAME))
    return faults


def _dimension(quantity: str) -> tuple[str, str]:
    return ("time", "s") if quantity == TIME else ("force", "N") if FORCE in quantity else ("length", "m")


def _names(quantity: str) -> str:
    if FORCE in quantity:
        forces = WAYS if quantity == FORCE else (quantity,)
        return ", ".join(f"{name}_{unit}" for name in forces for unit in _FORCE_UNITS)
    if quantity in (TIME, FRAME):
        return "time_s, " + ", ".join(f"time_{unit}" for unit in _TIME_UNITS[1:])
    if quantity == MIDPOINT:
        names = ", ".join(f"midpoint_{unit}" for unit in _LENGTH_UNITS)
        return f"{names}; or sag_m, positive down"
    stem = "midpoint_std" if quantity == STD else quantity
    return ", ".join(f"{stem}_{unit}" for unit in _LENGTH_UNITS)


_DOTTED = re.compile(r"(?P<table>[A-Za-z_]\w*)\.(?P<key>[A-Za-z_]\w*)\b(?P<rest>.*)")
_FORM = "key = value, such as # filament.span = 5 mm"


def overrides_in(text: str) -> tuple[dict[str, str], list[Fault]]:
    """Read the overrides among the comments of a file."""
    tables = {name: keys for name, keys in known_keys().items() if name}
    overrides: dict[str, str] = {}
    faults: list[Fault] = []
    for number, line in enumerate(text.splitlines(), start=1):
        comment = line.strip()
        match = _DOTTED.match(comment.lstrip("#").strip()) if comment.startswith("#") else None
        if match is None:
            continue
        where, table, path = f"line {number}", match["table"], f"{match['table']}.{match['key']}"
        assigned = match["rest"].lstrip().startswith("=")
        # A spreadsheet ends a short line with the separators of its empty cells.
        value = match["rest"].lstrip().removeprefix("=").split(" #")[0].rstrip(",;\t ").lstrip()
        if table not in tables:
            near = get_close_matches(table, tables, n=1, cutoff=0.75)
            # A setting of another program (camera.fps = 60) is a comment; a misspelt table of a scene is a fault.
            if assigned and near:
                faults.append(
                    Fault(where, f"unknown table in {shown(path)} (did you mean '{near[0]}'?)", ", ".join(tables))
                )
        elif match["key"] not in tables[table]:
            unknown = unknown_key(path, tables)
            faults += [Fault(f"{where}, {path}", unknown.found, unknown.accepted)] if assigned else []
        elif not assigned or not value:
            faults.append(Fault(where, f"{shown(comment)} sets nothing", _FORM))
        elif path in overrides:
            faults.append(Fault(where, f"{path} set again", "each key once"))
        else:
            overrides[path] = value
    return overrides, faults


Floats = NDArray[np.float64]
SAME_TIME = 1e-9
"""Difference of two times, as a share of the last time, below which they are equal up to rounding."""

# Shares of the range of heights: motion before the release, and difference of two readings at one time, at most.
_AT_REST, _SAME = 0.05, 0.1
# Standard errors by which two readings of one height may differ.
_DEVIATIONS = 6.0


def repaired(table: Table, row: Callable[[int], str]) -> tuple[Table, tuple[str, ...], list[Fault]]:
    """Correct faults whose correction is unambiguous: missing rows, early rows, their order and repeated times."""
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
    height = table[next(name for name in (MIDPOINT, Y, FORCE) if name in table)]
    accepted = "times counted from the release of the filament, which is time 0"
    if count == rows.size:
        return table, rows, "", Fault("", "all times are before 0", accepted)
    if FORCE not in table and np.ptp(height[early]) > _AT_REST * np.ptp(height):
        return table, rows, "", Fault("", f"{found} in which the filament moves already", accepted)
    why = "" if FORCE in table else ": nothing moves in them"
    return *_kept(table, rows, ~early), f"Left out {found}, the release{why}.", None


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
    return _no_point_twice(table, rows, row) if Y in table else _averaged(table, rows, row)


def _averaged(table: Table, rows: NDArray[np.intp], row: Callable[[int], str]) -> Step:
    """One reading for each time; independent readings, so weights are 1/std^2 and the variances add inversely."""
    name, unit = (FORCE, "N") if FORCE in table else (MIDPOINT, "m")
    time, height, std = table[TIME], table[name], table.get(STD)
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
        pair = f"{lowest[worst]:g} {unit} and {highest[worst]:g} {unit}"
        found = f"{name}s of {pair} at the same time, {distinct[worst]:g} s"
        where = listed(same, row)
        return table, rows, "", Fault(where, found, "one of them at a time; one file for each filament")
    weight = np.ones_like(height) if std is None else (std.max() / std) ** 2
    total = np.add.reduceat(weight, first)
    averaged = {TIME: distinct, name: np.add.reduceat(weight * height, first) / total}
    if std is not None:
        averaged[STD] = std.max() / np.sqrt(total)
    count = int(repeated.sum())
    places = listed(rows[np.isin(time, distinct[repeated])], row)
    said = f"Averaged the {name}s at {counted(count, 'time')} that occurred more than once ({places})."
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


FEWEST = 5
"""Smallest number of distinct times, or points of shapes: with fewer, trend and noise cannot be separated."""

# Largest magnitude of a number, and smallest standard error, in SI units.
_MOST, _FINEST = 1e12, 1e-15
# Largest range of heights that is rounding error, as a share of the largest height.
_ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class Shapes:
    """Points of the centre line at one or several times."""

    # shape (points,); [s], not decreasing; [m] with x = 0 halfway between the supports; [m] upwards from the
    # supports' level. Kept as copies that cannot be written to.
    time: Floats
    x: Floats
    y: Floats
    std: Floats | None = None  # shape (points,); Standard errors of y [m]; None if they are not known
    level_std: float = 0.0  # Standard error of the supports' level, where that was read from the same picture [m]

    def __post_init__(self) -> None:
        faults = _adopt(self, ("time", "x", "y", "std"))
        if not faults and self.time.size < FEWEST:
            faults = [Fault("", counted(self.time.size, "point"), f"at least {FEWEST}")]
        if not faults and _is_constant(self.y):
            faults = [Fault("y", f"{self.y[0]:g} m at every point", "the shape of a filament that sags")]
        if faults:
            raise refusal("shapes", None, faults)

    @property
    def shows_supports(self) -> bool:
        """Whether the supports are in the same picture: their level, and with their distance its scale."""
        return self.level_std > 0


@dataclass(frozen=True, eq=False)
class Forces:
    """Force of the right support on the filament, as a load cell reads it; a symmetric filament has equal forces."""

    time: Floats  # shape (n,); [s] since the release, increasing
    force: Floats  # shape (n,); [N], outwards or upwards
    way: str  # One of `WAYS`
    std: Floats | None = None  # shape (n,); Standard errors [N]; None if they are not known

    def __post_init__(self) -> None:
        faults = _adopt(self, ("time", "force", "std"))
        if self.way not in WAYS:
            faults.append(Fault("way", shown(self.way), ", ".join(WAYS)))
        if not faults and self.time.size < FEWEST:
            faults = [Fault(self.way, counted(self.time.size, "distinct time"), f"at least {FEWEST}")]
        if not faults and not np.any(self.force):
            faults = [Fault(self.way, "0 N at every time", "the force of a support that carries the filament")]
        if faults:
            raise refusal("forces", None, faults)


@dataclass(frozen=True, eq=False)
class Series:
    """One filmed filament."""

    # shape (n,); [s] since the release, increasing; kept as a copy that cannot be written to, as the others are.
    time: Floats
    midpoint: Floats  # shape (n,); Height of the midpoint [m], negative below the supports' level
    # shape (n,); Standard errors of the midpoint [m]; None if they are not known, then they are estimated from the
    # residuals.
    std: Floats | None = None
    shapes: Shapes | None = None  # Whole shapes, besides the midpoint or instead; `time`, `midpoint` may be empty then
    # This filament's own values of the scene: ``{"filament.span": "5 mm"}``.
    overrides: Mapping[str, str] = field(default_factory=dict)
    path: Path | None = None  # The file of the measurements
    notes: tuple[str, ...] = ()  # Corrections, a sentence each
    forces: tuple[Forces, ...] = ()  # Forces of a support, besides the midpoint or instead; at times of their own
    label: str = ""  # Name of the film where that is not the name of its file

    def __post_init__(self) -> None:
        object.__setattr__(self, "overrides", dict(self.overrides))
        object.__setattr__(self, "forces", tuple(self.forces))
        object.__setattr__(self, "notes", tuple(self.notes))
        faults = _adopt(self, ("time", "midpoint", "std"))
        if not faults:
            faults = self._too_little()
        if faults:
            raise refusal("measurements", self.path, faults)

    def _too_little(self) -> list[Fault]:
        if (self.shapes is not None or self.forces) and not self.time.size:
            return []
        repeats = np.flatnonzero(np.diff(self.time) <= SAME_TIME * self.time[-1:])
        if repeats.size:
            again = int(repeats[0]) + 1
            return [
                Fault(f"time[{again}]", f"{self.time[again]:g} s again", "each time once (Measurements.of averages)")
            ]
        if self.time.size < FEWEST:
            accepted = f"at least {FEWEST}: fewer say nothing about a material"
            return [Fault("", counted(self.time.size, "distinct time"), accepted)]
        if _is_constant(self.midpoint):
            found = f"{self.midpoint[0]:g} m at every time: nothing moves"
            return [Fault("midpoint", found, "a filament filmed while it falls")]
        return []


@dataclass(frozen=True, eq=False)
class Measurements:
    """Filmed filaments of one material.

    Attributes
    ----------
    series : tuple of Series
        One for each filament, at least one.

    Raises
    ------
    SoftcatError
        If there is none.
    """

    series: tuple[Series, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "series", tuple(self.series))
        if not self.series or not all(isinstance(one, Series) for one in self.series):
            raise refusal("measurements", None, [Fault("series", "no filament", "at least one Series")])

    @classmethod
    def of(
        cls,
        time: ArrayLike,
        midpoint: ArrayLike,
        std: ArrayLike | None = None,
        overrides: Mapping[str, str] | None = None,
    ) -> Measurements:
        """Take one filament from arrays, with the same corrections and notes as for a file.

        Parameters
        ----------
        time : array_like, shape (n,)
            [s] since the release, in any order; rows with a NaN are left out if they are less than a third.
        midpoint : array_like, shape (n,)
            [m], negative below the supports' level.
        std : array_like, shape (n,), optional
            Standard errors of the midpoint [m]; one number stands for all.
        overrides : mapping of str to str, optional
            This filament's own values of the scene.

        Returns
        -------
        Measurements
            Of one series.

        Raises
        ------
        SoftcatError
            With every fault at once.
        """
        given = {TIME: time, MIDPOINT: midpoint} | ({} if std is None else {STD: std})
        table, faults = {}, []
        for name, values in given.items():
            try:
                table[name] = np.ma.filled(np.ma.array(values, dtype=np.float64), np.nan)
            except (TypeError, ValueError):
                faults.append(Fault(name, "not a list of numbers", "numbers in s or m"))
        if not faults:
            if STD in table and table[STD].ndim == 0:
                table[STD] = np.full(table[TIME].shape, table[STD])
            faults = _unequal(table)
        if not faults:
            faults = [fault for name, values in table.items() for fault in _implausible(name, values, missing=True)]
        if faults:
            raise refusal("measurements", None, faults)
        corrected, notes, faults = repaired(table, lambda k: f"index {k}")
        if faults:
            raise refusal("measurements", None, faults)
        one = Series(corrected[TIME], corrected[MIDPOINT], corrected.get(STD), overrides=overrides or {}, notes=notes)
        return cls((one,))


def _adopt(owner: Series | Shapes | Forces, names: tuple[str, ...]) -> list[Fault]:
    """Replace the fields of a frozen owner by read-only copies, and return their faults."""
    table: dict[str, Floats] = {}
    for name in names:
        if getattr(owner, name) is None:
            continue
        try:
            values = np.array(getattr(owner, name), dtype=np.float64)
        except (TypeError, ValueError):
            return [Fault(name, "not a list of numbers", "numbers in SI units")]
        values.flags.writeable = False
        object.__setattr__(owner, name, values)
        table[name] = values
    faults = _unequal(table)
    if faults:
        return faults
    faults = [fault for name, values in table.items() for fault in _implausible(name, values)]
    time = table["time"]
    if not faults and time.size and time.min() < 0:
        faults = [Fault(f"time[{int(time.argmin())}]", f"{time.min():g} s, before the release", "times from 0 s on")]
    back = np.flatnonzero(np.diff(time) < 0)
    if not faults and back.size:
        k = int(back[0])
        found = f"{time[k + 1]:g} s after {time[k]:g} s"
        faults = [Fault(f"time[{k + 1}]", found, "times in increasing order (Measurements.of sorts)")]
    return faults


def _unequal(table: Mapping[str, Floats]) -> list[Fault]:
    shapes = {values.shape for values in table.values()}
    if len(shapes) == 1 and len(next(iter(shapes))) == 1:
        return []
    found = ", ".join(f"{name} of shape {values.shape}" for name, values in table.items())
    return [Fault("", found, "lists of the same length")]


def _implausible(name: str, values: Floats, missing: bool = False) -> list[Fault]:
    """Faults of numbers that cannot be measurements; with `missing`, NaN marks a missing measurement."""
    faults = []
    positive = name == STD
    for k in np.flatnonzero(~(np.abs(values) <= _MOST) | (positive & ~(values >= _FINEST))).tolist():
        if not (missing and np.isnan(values[k])):
            faults.append(Fault(f"{name}[{k}]", *what_is_wrong(float(values[k]), positive) or ("", "")))
    return faults


def what_is_wrong(value: float, is_std: bool = False) -> tuple[str, str] | None:
    """Return why a number in SI units cannot be a time or height, or, with `is_std`, an error; None if it can."""
    accepted = "a positive number" if is_std else "a finite number"
    if not np.isfinite(value):
        return f"{value} is not finite", accepted
    if is_std and value <= 0:
        return f"{value:g} is not positive", "a positive standard error; leave the column out if it is not known"
    if abs(value) > _MOST or (is_std and value < _FINEST):
        return f"{value:g} is beyond anything measured", f"{accepted}, in the unit that its name says"
    return None


def _is_constant(values: Floats) -> bool:
    return bool(np.ptp(values) <= _ROUNDING * np.max(np.abs(values)))


_KIND = "measurements"
_ACCEPTED = "a CSV file with the columns time_s and midpoint_m, or time_s, x_m and y_m, or time_s and vertical_force_N"


def read_measurements(paths: str | os.PathLike[str] | Sequence[str | os.PathLike[str]]) -> Measurements:
    """Read filmed filaments of one material.

    Parameters
    ----------
    paths : path or sequence of paths
        CSV files in UTF-8, one for each filament, whose header names ``time_s`` and ``midpoint_m`` with perhaps
        ``midpoint_std_m``, or ``time_s``, ``x_m`` and ``y_m`` with perhaps ``y_std_m``, in any unit (``time_ms``,
        ``midpoint [mm]``); ``sag_mm`` or ``deflection_mm`` counts downwards. ``vertical_force_N`` (upwards) and
        ``horizontal_force_N`` (outwards) of the right support, with perhaps ``vertical_force_std_N``, stand beside the
        midpoint or alone; either may have rows in which the other is empty. Other columns are not read. Cells are
        separated by commas, or by semicolons or tabs, then with decimal points or commas. Lines that start with ``#``
        are comments; ``# filament.span = 5 mm`` sets a value of the scene for this filament only.

    Returns
    -------
    Measurements
        In SI, in the order of the paths; the notes of each series name its corrections.

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


def _placed(table: Table, columns: Mapping[str, Column], camera: Camera) -> tuple[Table, tuple[str, ...]]:
    """Count times from the release, and positions from halfway between the supports, as the camera's comments state."""
    placed, notes = dict(table), []
    if camera.release and columns[TIME].name.lower() == FRAME and camera.fps is not None:
        placed[TIME] = table[TIME] - camera.release / camera.fps
    if camera.pixel is not None and X in columns and columns[X].unit == camera.pixel:
        across, down = (camera.pixel * place for place in camera.origin)
        placed |= {X: table[X] - across, Y: down - table[Y]}
        notes.append(f"Counted pixels from {camera.origin[0]:g}, {camera.origin[1]:g}, downwards.")
    return placed, tuple(notes)


def _parts(table: Table) -> dict[str, tuple[Table, NDArray[np.intp]]]:
    """Split a table into heights, with an empty name, and forces; if there are several, each with its filled rows."""
    names = {"": MIDPOINT if MIDPOINT in table else Y, **{way: way for way in WAYS}}
    names = {part: name for part, name in names.items() if name in table}
    found = {}
    for part, name in names.items():
        given = {one: table[one] for one in (TIME, MIDPOINT, X, Y, STD) if one in table}
        if part:
            given = {TIME: table[TIME], FORCE: table[part]}
            given |= {STD: table[_OF_FORCE[part]]} if _OF_FORCE[part] in table else {}
        rows = np.flatnonzero(~np.isnan(table[name]) | (len(names) == 1))
        found[part] = {one: values[rows] for one, values in given.items()}, rows
    return found


def _series(file: Path) -> Series:
    text = text_of(file, _KIND, _ACCEPTED)
    overrides, faults = overrides_in(text)
    cells, (camera, wrong) = table_in(text), camera_in(text)
    if wrong:
        raise refusal(_KIND, file, faults + wrong)
    if cells is None:
        raise refusal(_KIND, file, [*faults, Fault("", "the file holds no data", _ACCEPTED)])
    cells, tracker = in_rows(cells)
    columns, wrong = columns_of(cells, camera)
    if wrong:
        raise refusal(_KIND, file, faults + wrong)
    table, wrong = numbers_in(cells, columns, lambda quantity, value: what_is_wrong(value, quantity.endswith(STD)))
    if faults or wrong:
        raise refusal(_KIND, file, faults + wrong)
    table, said = _placed(table, columns, camera)
    notes = [*([f"Read as a table of {tracker}."] if tracker else []), *said]
    parts: dict[str, Table] = {}
    for name, (part, rows) in _parts(table).items():
        lines = [cells.rows[k][0] for k in rows]
        parts[name], said, wrong = repaired(part, lambda k, lines=lines: f"line {lines[k]}")  # type: ignore[misc]
        notes += [one for one in said if one not in notes]
        faults += wrong
    if faults:
        raise refusal(_KIND, file, faults)
    try:
        return _of_parts(parts, columns, overrides, file, notes)
    except SoftcatError as error:
        message = str(error)
        raise SoftcatError(message if str(file) in message else f"{_KIND} {file}: {message}") from None


def _of_parts(
    parts: Mapping[str, Table],
    columns: Mapping[str, Column],
    overrides: Mapping[str, str],
    file: Path,
    notes: Sequence[str],
) -> Series:
    """One film from the parts of its table."""
    forces = tuple(
        Forces(parts[way][TIME], parts[way][FORCE], way, parts[way].get(STD)) for way in WAYS if way in parts
    )
    table = parts.get("", {})
    empty, std, said = np.empty(0), table.get(STD), tuple(notes)
    if MIDPOINT not in table:
        shapes = Shapes(table[TIME], table[X], table[Y], std) if table else None
        return Series(empty, empty, None, shapes, overrides, file, said, forces)
    down = columns[MIDPOINT].down
    if down:
        said = (f"Turned the sign of {columns[MIDPOINT].name}, which counts downwards by its name.", *said)
    midpoint = 0.0 - table[MIDPOINT] if down else table[MIDPOINT]
    return Series(table[TIME], midpoint, std, None, overrides, file, said, forces)
