"""Films of falling filaments: their data, and how they are read from tables of spreadsheets and image trackers."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike, NDArray

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.scene.scene import known_keys
from softcat_sym.scene.table_reader import (
    Column,
    Scale,
    Source,
    Table,
    counted,
    implausible,
    is_pixels,
    known,
    listed,
    number_in,
    read_table,
    refusal,
    scale_of,
)
from softcat_sym.scene.units import NotAQuantity, shown, to_si, unknown_key

Floats = NDArray[np.float64]
SAME_TIME = 1e-9
"""Difference of two times, as a share of the last time, below which they are equal up to rounding."""

FEWEST = 5
"""Smallest number of distinct times, or points of shapes: with fewer, trend and noise cannot be separated."""

# Largest range of heights that is rounding error, as a share of the largest height.
_ROUNDING = 1e-12
# Shares of the range of heights: motion before the release, and difference of two readings at one time, at most.
_AT_REST, _SAME = 0.05, 0.1
# Standard errors by which two readings of one height may differ.
_DEVIATIONS = 6.0
# Smallest likelihood of DeepLabCut at which a point is kept.
_LIKELY = 0.6


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
        faults = _adopt_in_time(self, ("time", "x", "y", "std"))
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
    label: str = ""  # Name of the film where that is not the name of its file

    def __post_init__(self) -> None:
        object.__setattr__(self, "overrides", dict(self.overrides))
        object.__setattr__(self, "notes", tuple(self.notes))
        faults = _adopt_in_time(self, ("time", "midpoint", "std")) or self._too_little()
        if faults:
            raise refusal("measurements", self.path, faults)

    def _too_little(self) -> list[Fault]:
        if self.shapes is not None and not self.time.size:
            return []
        repeats = np.flatnonzero(np.diff(self.time) <= SAME_TIME * self.time[-1:])
        if repeats.size:
            again, accepted = int(repeats[0]) + 1, "each time once (Measurements.of averages)"
            return [Fault(f"time[{again}]", f"{self.time[again]:g} s again", accepted)]
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
        given = {"time": time, "midpoint": midpoint} | ({} if std is None else {"std": std})
        arrays, faults = arrays_of(given, lambda name, value: None if np.isnan(value) else implausible(name, value))
        if faults:
            raise refusal("measurements", None, faults)
        source = Source(kind="measurements")
        table = repaired(pd.DataFrame(arrays, [f"index {k}" for k in range(arrays["time"].size)]), source)
        columns = {name: table[name].to_numpy() for name in table}
        return cls((Series(**columns, overrides=overrides or {}, notes=source.notes),))


def arrays_of(
    given: Mapping[str, Any], wrong: Callable[[str, float], tuple[str, str] | None]
) -> tuple[dict[str, Floats], list[Fault]]:
    """Arrays of one length that cannot be written to, and the faults of their numbers."""
    arrays, faults = dict[str, Floats](), list[Fault]()
    for name, values in given.items():
        try:
            arrays[name] = np.ma.filled(np.ma.array(values, dtype=np.float64, copy=True), np.nan)
        except (TypeError, ValueError):
            faults.append(Fault(name, "not a list of numbers", "numbers in SI units"))
            continue
        if name == "std" and not arrays[name].ndim and "time" in arrays:
            arrays[name] = np.full(arrays["time"].shape, arrays[name])
        arrays[name].flags.writeable = False
    shapes = {values.shape for values in arrays.values()}
    if not faults and (len(shapes) > 1 or len(next(iter(shapes))) != 1):
        found = ", ".join(f"{name} of shape {values.shape}" for name, values in arrays.items())
        return arrays, [Fault("", found, "lists of the same length")]
    for name, values in arrays.items():
        judged = ((k, wrong(name, value)) for k, value in enumerate(values.flat))
        faults += [Fault(f"{name}[{k}]", *fault) for k, fault in judged if fault]
    return arrays, faults


def _adopt_in_time(owner: Series | Shapes, names: tuple[str, ...]) -> list[Fault]:
    """Replace the fields of a frozen owner by read-only copies, and return their faults."""
    given = {name: getattr(owner, name) for name in names if getattr(owner, name) is not None}
    arrays, faults = arrays_of(given, implausible)
    for name, values in arrays.items():
        object.__setattr__(owner, name, values)
    if faults:
        return faults
    time = arrays["time"]
    if time.size and time.min() < 0:
        return [Fault(f"time[{int(time.argmin())}]", f"{time.min():g} s, before the release", "times from 0 s on")]
    back, accepted = np.flatnonzero(np.diff(time) < 0)[:1], "times in increasing order (Measurements.of sorts)"
    return [Fault(f"time[{k + 1}]", f"{time[k + 1]:g} s after {time[k]:g} s", accepted) for k in back]


def _is_constant(values: Floats) -> bool:
    return bool(np.ptp(values) <= _ROUNDING * np.max(np.abs(values)))


def repaired(table: pd.DataFrame, source: Source) -> pd.DataFrame:
    """Correct faults whose correction is unambiguous: missing rows, early rows, their order and repeated times."""
    table = source.without(table, table.isna().any(axis=1), "number")
    name = "y" if "y" in table else "midpoint"
    early = table["time"] < 0
    if early.any():
        found = f"{counted(int(early.sum()), 'row')} before time 0 ({listed(table.index[early])})"
        accepted = "times counted from the release of the filament, which is time 0"
        if early.all():
            source.refuse([Fault("", "all times are before 0", accepted)])
        if np.ptp(table[name][early]) > _AT_REST * np.ptp(table[name]):
            source.refuse([Fault("", f"{found} in which the filament moves already", accepted)])
        source.said.append(f"left out {found}, the release")
        table = table[~early]
    back = np.flatnonzero(np.diff(table["time"]) < 0)
    if back.size:
        source.said.append(f"sorted the rows by time ({table.index[back[0] + 1]} was the first to go back)")
        table = table.sort_values("time", kind="stable")
    time = table["time"].to_numpy()
    first = np.diff(time, prepend=-np.inf) > SAME_TIME * time[-1:]
    table = table.assign(time=time[first][np.cumsum(first) - 1])
    if name != "y":
        return table if first.all() else _averaged(table, source)
    twice = table.duplicated(["time", "x", "y"])
    if twice.any():
        source.said.append(f"left out {counted(int(twice.sum()), 'point')} of the shapes that occurred before")
    return table[~twice]


def _averaged(table: pd.DataFrame, source: Source) -> pd.DataFrame:
    """One reading for each time; independent readings, so weights are 1/std^2 and the variances add inversely."""
    repeated = table[table.duplicated("time", keep=False)]
    readings = repeated.groupby("time")
    low, high = readings["midpoint"].min(), readings["midpoint"].max()
    apart = high - low - _SAME * np.ptp(table["midpoint"])
    if "std" in table:
        apart -= _DEVIATIONS * readings["std"].max()
    worst = apart.idxmax()
    if apart[worst] > 0:
        found = f"midpoints of {low[worst]:g} m and {high[worst]:g} m at the same time, {worst:g} s"
        where = listed(repeated.index[repeated["time"] == worst])
        source.refuse([Fault(where, found, "one of them at a time; one file for each filament")])
    weight = (table["std"].max() / table["std"]) ** 2 if "std" in table else pd.Series(1.0, table.index)
    weighted = pd.DataFrame({"time": table["time"], "midpoint": weight * table["midpoint"], "weight": weight})
    sums = weighted.groupby("time").sum()
    averaged = pd.DataFrame({"time": sums.index, "midpoint": (sums["midpoint"] / sums["weight"]).to_numpy()})
    if "std" in table:
        averaged["std"] = (table["std"].max() / np.sqrt(sums["weight"])).to_numpy()
    many = counted(len(low), "time")
    source.said.append(f"averaged the midpoints at {many} that occurred more than once ({listed(repeated.index)})")
    return averaged


class PlainNumber(float):
    """A number without a unit."""


Comments = dict[str, list[tuple[float, ...]]]
"""Of the comments about the camera and pillars by their keys, one for each line."""

_COMMENT = re.compile(r"#\s*(?P<path>(?P<table>[A-Za-z_]\w*)\.(?P<key>[A-Za-z_]\w*))\b\s*(?P<value>=.*)?")


def comments_in(text: str) -> tuple[dict[str, str], Comments, list[Fault]]:
    """Read the comments ``# table.key = value``: values of the scene for this film only, and `Comments`.

    Comments of other programs are ignored.
    """
    own, tables = known("comments"), {name: keys for name, keys in known_keys().items() if name}
    overrides, values, faults = dict[str, str](), Comments(), list[Fault]()
    for number, line in enumerate(text.splitlines(), start=1):
        match = _COMMENT.match(line.strip())
        if match is None:
            continue
        path, table, fault = match["path"], match["table"], None
        is_key = match["key"] in tables.get(table, ())
        # A spreadsheet ends a short line with the separators of its empty cells.
        value = (match["value"] or "")[1:].split(" #")[0].rstrip(",;\t ").lstrip()
        if not value and is_key:
            fault = "sets nothing", "key = value, such as # filament.span = 5 mm"
        elif (path in overrides or path in values) and path != "pillars.gap":
            fault = "set again", "each key once"
        elif path in own:
            try:
                values.setdefault(path, []).append(_numbers_of(path, value))
            except NotAQuantity as error:
                fault = str(error), own[path]["form"]
        elif is_key:
            overrides[path] = value
        elif value and table in tables:
            unknown = unknown_key(path, tables)
            fault = unknown.found, unknown.accepted
        elif value and (near := get_close_matches(table, tables, n=1, cutoff=0.75)):
            fault = f"unknown key (did you mean table '{near[0]}'?)", ", ".join(own)
        faults += [Fault(f"line {number}, {path}", *fault)] if fault else []
    return overrides, values, faults


def _numbers_of(path: str, text: str) -> tuple[float, ...]:
    kind = known("comments")[path]
    parts = re.split(r"\s*[,;]\s*|(?<=\d)\s+(?=[-\d])", text) if kind["count"] > 1 else [text]
    if any(is_pixels(part.lstrip("+-.0123456789eE ")) for part in parts):
        raise NotAQuantity(f"{shown(text)} in pixels, which are plain numbers beside a column x_px")
    pairs = [(part, number_in(part) if kind["plain"] else None) for part in parts]
    found = tuple(to_si(part, kind["dimension"]) if number is None else PlainNumber(number) for part, number in pairs)
    if len(found) != kind["count"] or not np.all(np.isfinite(found)) or (not kind["plain"] and found[0] <= 0):
        raise NotAQuantity(shown(text))
    return found


def film_scale(comments: Comments) -> Scale:
    """Scale of the columns of a film: of frames and pixels by its comments about the camera, of others by their units.

    Without a unit, times and places have that of ``camera.time`` and ``camera.unit``.
    """
    fps, pixel, release, length, time = (
        comments[f"camera.{name}"][0][0] if f"camera.{name}" in comments else None
        for name in ("fps", "pixel", "release", "unit", "time")
    )
    origin = dict(zip("xy", comments.get("camera.origin", [(0.0, 0.0)])[0], strict=True))
    plain = {"time": time, "x": length, "y": length}

    def scale(quantity: str, unit: str) -> tuple[float, float]:
        if quantity in ("frame", "slice"):
            if fps is None or fps <= 0:
                raise NotAQuantity("frames without a frame rate")
            # ImageJ counts the slices of a stack from one.
            return 1 / fps, float(quantity == "slice") if release is None else release
        if not unit and (own := plain.get(quantity)) is not None:
            return own, 0.0
        if pixel is None or not (is_pixels(unit) or (not unit and quantity in origin)):
            return scale_of(quantity, unit)
        # A picture's rows count downwards.
        return -pixel if quantity == "y" else pixel, origin.get(quantity, 0.0)

    return scale


_KIND = "measurements"
_ACCEPTED = "a CSV file with the columns time_s and midpoint_m, or time_s, x_m and y_m"
_CLOCKS = ("time", "frame", "slice")
_FORMS: tuple[tuple[str, ...], ...] = (("midpoint",), ("x", "y"))
_QUANTITIES = (*_CLOCKS, "midpoint", "x", "y", "std", "likelihood")


def read_measurements(paths: str | os.PathLike[str] | Sequence[str | os.PathLike[str]]) -> Measurements:
    """Read filmed filaments of one material.

    Parameters
    ----------
    paths : path or sequence of paths
        Tables, one for each filament, with ``time_s`` and ``midpoint_m``, or ``time_s``, ``x_m`` and ``y_m``, in any
        unit (``time_ms``, ``midpoint [mm]``; ``sag_mm`` counts downwards), or as trackers write them; with perhaps
        ``midpoint_std_m``.
        ``# filament.span = 5 mm`` sets a value of the scene for this filament only.

    Returns
    -------
    Measurements
        In SI, in the order of the paths; the notes of each series name its corrections.

    Raises
    ------
    SoftcatError
        With the faults of all files, and their lines.
    """
    files = [Path(path) for path in ([paths] if isinstance(paths, (str, os.PathLike)) else paths)]
    if not files:
        raise refusal(_KIND, None, [Fault("", "no file", _ACCEPTED)])
    places = [os.path.realpath(file) for file in files]
    repeated = sorted({str(file) for file, place in zip(files, places, strict=True) if places.count(place) > 1})
    if repeated:
        found = f"{', '.join(repeated)} named twice, so the same filament would count twice"
        raise refusal(_KIND, None, [Fault("", found, "each file once")])
    series, refused = list[Series](), list[str]()
    for file in files:
        try:
            series.append(_series(file))
        except SoftcatError as error:
            message = str(error)
            refused.append(message if str(file) in message else f"{_KIND} {file}: {message}")
    if refused:
        raise SoftcatError("\n".join(refused))
    return Measurements(tuple(series))


def _series(file: Path) -> Series:
    table = read_table(file, _KIND, _ACCEPTED, _QUANTITIES)
    overrides, comments, faults = comments_in(table.text)
    table.refuse(faults)
    for name, maker in known("makers").items():
        absent = {key: value for key, value in maker["comments"].items() if key not in comments}
        if absent and "camera.pixel" not in comments and re.search(maker["text"], table.text):
            comments |= {key: [_numbers_of(key, value)] for key, value in absent.items()}
            table.said.append(f"took {' and '.join(map(' = '.join, absent.items()))} of {name}")
    read = {name: column.to_numpy() for name, column in repaired(_readings(table, comments), table).items()}
    shapes = Shapes(**read) if "y" in read else None
    return Series(
        **(read if shapes is None else {"time": np.empty(0), "midpoint": np.empty(0)}),
        shapes=shapes,
        overrides=overrides,
        path=file,
        notes=table.notes,
    )


def _readings(table: Table, comments: Comments) -> pd.DataFrame:
    """Midpoints, or points of shapes ("x", "y"), over time in SI."""
    columns = table.columns(_QUANTITIES, film_scale(comments))
    if sum(one.quantity == "x" for one in columns) > 1 and not any(one.quantity in _CLOCKS for one in columns):
        table.number_rows("frame")
        columns = table.columns(_QUANTITIES, film_scale(comments))
    named, read = {one.quantity for one in columns}, {one.quantity for one in columns if one.fault is None}
    clock = next((one for there in (read, named) for one in _CLOCKS if one in there), "time")
    whole = [form for form in _FORMS if {*form} <= read]
    needed = (clock, *(one for form in whole or [max(_FORMS, key=lambda form: len(named & {*form}))] for one in form))
    if len(whole) > 1:
        table.refuse([Fault(f"line {table.line}", "points of whole shapes beside midpoint", "two files for both")])
    # A tracker may write further columns, in pixels.
    more = [one for one in _QUANTITIES if one in named and one not in ("midpoint", "x", "y", *_CLOCKS)]
    numbers = _points_side_by_side(table, columns)
    if numbers is None:
        numbers = table.numbers(columns, needed, more)
    numbers = numbers.rename(columns={clock: "time"})
    if "likelihood" in numbers:
        doubtful = numbers.pop("likelihood") < _LIKELY
        if doubtful.any():
            table.said.append(f"left out {counted(int(doubtful.sum()), 'point')} with a likelihood below {_LIKELY}")
        numbers = numbers[~doubtful]
    turned = [one.name for one in columns if one.sign < 0 and one.quantity in needed]
    table.said += [f"turned the sign of {name}, which counts downwards by its name" for name in turned]
    if any(one.quantity == "x" and (one.unit,) in comments.get("camera.pixel", []) for one in columns):
        origin = ", ".join(f"{one:g}" for one in comments.get("camera.origin", [(0.0, 0.0)])[0])
        table.said.append(f"counted pixels from {origin}, downwards")
    return numbers[[one for one in ("time", *whole[0], "std") if one in numbers]]


def _points_side_by_side(table: Table, columns: Sequence[Column]) -> pd.DataFrame | None:
    """The points of a picture below each other, if they stand in one row."""
    x, y, likelihoods = ([one for one in columns if one.quantity == name] for name in ("x", "y", "likelihood"))
    points = list(zip(x, y, *([likelihoods] if likelihoods else []), strict=False))
    # Two units of one quantity are two columns for it, and refused.
    if len(x) != len(y) or len(x) < 2 or len({(one.unit, other.unit) for one, other, *_ in points}) > 1:
        return None
    clock = next(one for one in columns if one.quantity in _CLOCKS)
    read = [table.numbers([clock, *point], [one.quantity for one in (clock, *point)]) for point in points]
    table.said.append(f"read {len(read)} points side by side")
    # A point that the tracker did not find gives no row.
    return pd.concat(read).iloc[np.arange(len(read) * len(read[0])).reshape(len(read), -1).T.ravel()].dropna()
