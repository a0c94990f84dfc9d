"""Films of falling filaments: their data, and how they are read from tables of spreadsheets and image trackers."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike, NDArray

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.scene.scene import known_keys
from softcat_sym.scene.table_reader import (
    Cells,
    Column,
    counted,
    is_pixels,
    listed,
    quantity_of,
    read_cells,
    refusal,
    scale_of,
    sentence,
    settings_in,
    without,
)
from softcat_sym.scene.units import NotAQuantity, shown, unknown_key

Floats = NDArray[np.float64]
VERTICAL, HORIZONTAL = "vertical_force", "horizontal_force"
WAYS = (HORIZONTAL, VERTICAL)
"""Forces of the right support on the filament, outwards and upwards."""

SAME_TIME = 1e-9
"""Difference of two times, as a share of the last time, below which they are equal up to rounding."""

FEWEST = 5
"""Smallest number of distinct times, or points of shapes: with fewer, trend and noise cannot be separated."""

# Largest magnitude of a number, and smallest standard error, in SI units.
_MOST, _FINEST = 1e12, 1e-15
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
class Forces:
    """Force of the right support on the filament, as a load cell reads it; a symmetric filament has equal forces."""

    time: Floats  # shape (n,); [s] since the release, increasing
    force: Floats  # shape (n,); [N], outwards or upwards
    way: str  # One of `WAYS`
    std: Floats | None = None  # shape (n,); Standard errors [N]; None if they are not known

    def __post_init__(self) -> None:
        faults = _adopt_in_time(self, ("time", "force", "std"))
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
        faults = _adopt_in_time(self, ("time", "midpoint", "std")) or self._too_little()
        if faults:
            raise refusal("measurements", self.path, faults)

    def _too_little(self) -> list[Fault]:
        if (self.shapes is not None or self.forces) and not self.time.size:
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
        table = pd.DataFrame(arrays, [f"index {k}" for k in range(arrays["time"].size)])
        table, said, faults = repaired(table)
        if faults:
            raise refusal("measurements", None, faults)
        columns = {name: table[name].to_numpy() for name in table}
        return cls((Series(**columns, overrides=overrides or {}, notes=sentence(*said)),))


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


def _adopt_in_time(owner: Series | Shapes | Forces, names: tuple[str, ...]) -> list[Fault]:
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


def _is_constant(values: Floats) -> bool:
    return bool(np.ptp(values) <= _ROUNDING * np.max(np.abs(values)))


def repaired(table: pd.DataFrame) -> tuple[pd.DataFrame, list[str], list[Fault]]:
    """Correct faults whose correction is unambiguous: missing rows, early rows, their order and repeated times."""
    table, said, faults = without(table, table.isna().any(axis=1), "number")
    name, notes = next(one for one in ("midpoint", "y", "force") if one in table), [said]
    early = table["time"] < 0
    if early.any() and not faults:
        found = f"{counted(int(early.sum()), 'row')} before time 0 ({listed(table.index[early])})"
        accepted = "times counted from the release of the filament, which is time 0"
        if early.all():
            faults = [Fault("", "all times are before 0", accepted)]
        elif name != "force" and np.ptp(table[name][early]) > _AT_REST * np.ptp(table[name]):
            faults = [Fault("", f"{found} in which the filament moves already", accepted)]
        notes.append(f"left out {found}, the release")
        table = table[~early]
    if faults or table.empty:
        return table, notes, faults
    back = np.flatnonzero(np.diff(table["time"]) < 0)
    if back.size:
        notes.append(f"sorted the rows by time ({table.index[back[0] + 1]} was the first to go back)")
        table = table.sort_values("time", kind="stable")
    time = table["time"].to_numpy()
    later = np.diff(time, prepend=-np.inf) > SAME_TIME * time[-1]
    table = table.assign(time=time[later][np.cumsum(later) - 1])
    if name != "y":
        table, said, faults = _averaged(table, name)
        return table, [*notes, said], faults
    twice = table.duplicated(["time", "x", "y"])
    if twice.any():
        notes.append(f"left out {counted(int(twice.sum()), 'point')} of the shapes that occurred before")
    return table[~twice], notes, []


def _averaged(table: pd.DataFrame, name: str) -> tuple[pd.DataFrame, str, list[Fault]]:
    """One reading for each time; independent readings, so weights are 1/std^2 and the variances add inversely."""
    groups = table.groupby("time")
    repeated = groups.size() > 1
    if not repeated.any():
        return table, "", []
    low, high = groups[name].min()[repeated], groups[name].max()[repeated]
    excess = high - low - _SAME * np.ptp(table[name])
    std = table.get("std", pd.Series(1.0, table.index))
    excess -= _DEVIATIONS * groups["std"].max()[repeated] if "std" in table else 0.0
    if excess.max() > 0:
        worst, unit = excess.idxmax(), "N" if name == "force" else "m"
        found = f"{name}s of {low[worst]:g} {unit} and {high[worst]:g} {unit} at the same time, {worst:g} s"
        where = listed(table.index[table["time"] == worst])
        return table, "", [Fault(where, found, "one of them at a time; one file for each filament")]
    weighted = table.assign(weight=(std.max() / std) ** 2)
    weighted[name] *= weighted["weight"]
    sums = weighted.groupby("time")[[name, "weight"]].sum()
    found = {"time": sums.index, name: sums[name] / sums["weight"], "std": std.max() / np.sqrt(sums["weight"])}
    where = listed(table.index[table["time"].isin(repeated.index[repeated])])
    said = f"averaged the {name}s at {counted(int(repeated.sum()), 'time')} that occurred more than once ({where})"
    return pd.DataFrame({one: np.asarray(found[one]) for one in table}), said, []


_CAMERA = {
    "fps": "camera.fps = 240",
    "pixel": "camera.pixel = 0.05 mm",
    "origin": "camera.origin = 640 212",
    "release": "camera.release = 12",
    "unit": "camera.unit = 1 mm",
    "time": "camera.time = 1 ms",
}


@dataclass(frozen=True)
class Camera:
    """Conversion of frames into seconds and of pixels into metres."""

    fps: float | None = None  # [1/s]
    pixel: float | None = None  # Length of a pixel [m]
    origin: tuple[float, float] = (0.0, 0.0)  # Pixel halfway between the supports, at their level
    release: float | None = None  # Frame of the release; the first one by default
    unit: float | None = None  # SI value of lengths without a unit, upwards [m]
    time: float | None = None  # SI value of times without a unit [s]

    def scale(self, quantity: str, unit: str) -> tuple[float, float]:
        """SI value of the unit of a film's column, and the number at which its quantity is zero."""
        if quantity == "force":
            raise NotAQuantity("a force without its direction")
        if quantity in ("frame", "slice"):
            if self.fps is None:
                raise NotAQuantity("frames without a frame rate: write # camera.fps = 240 in the file")
            # ImageJ counts the slices of a stack from one.
            return 1 / self.fps, float(quantity == "slice") if self.release is None else self.release
        own = {"time": self.time, "x": self.unit, "y": self.unit}.get(quantity)
        if own is not None and not unit:
            return own, 0.0
        if self.pixel is None or not (is_pixels(unit) or (not unit and quantity in ("x", "y"))):
            return scale_of(quantity, unit)
        # A picture's rows count downwards.
        zero = dict(zip("xy", self.origin, strict=True)).get(quantity, 0.0)
        return -self.pixel if quantity == "y" else self.pixel, zero


def camera_in(text: str) -> tuple[Camera, list[Fault]]:
    """Read the comments about the camera; comments of other programs are ignored."""
    found, faults = dict[str, Any](), list[Fault]()
    for one in settings_in(text):
        if one.table != "camera" or one.key not in _CAMERA or one.value is None:
            continue
        quantity = {"fps": "frequency", "time": "time"}.get(one.key, "length")
        try:
            plain = float if one.key in ("fps", "origin", "release") else None
            values = one.numbers(2 if one.key == "origin" else 1, quantity, plain)
            if one.key not in ("origin", "release") and values[0] <= 0:
                raise NotAQuantity(shown(one.value))
            found[one.key] = tuple(values) if one.key == "origin" else values[0]
        except NotAQuantity as error:
            faults.append(Fault(one.where, str(error), _CAMERA[one.key]))
    return Camera(**found), faults


def overrides_in(text: str) -> tuple[dict[str, str], list[Fault]]:
    """Read a film's own values of its scene among the comments of a file."""
    tables = {name: keys for name, keys in known_keys().items() if name}
    overrides, faults = dict[str, str](), list[Fault]()
    for one in settings_in(text):
        path = f"{one.table}.{one.key}"
        if one.table not in tables:
            near = get_close_matches(one.table, tables, n=1, cutoff=0.75)
            # A setting of another program (camera.fps = 60) is a comment; a misspelt table of a scene is a fault.
            if one.value is not None and near:
                found = f"unknown table in {shown(path)} (did you mean '{near[0]}'?)"
                faults.append(Fault(one.line, found, ", ".join(tables)))
        elif one.key not in tables[one.table]:
            unknown = unknown_key(path, tables)
            faults += [] if one.value is None else [Fault(one.where, unknown.found, unknown.accepted)]
        elif not one.value:
            faults.append(Fault(one.line, f"{path} sets nothing", "key = value, such as # filament.span = 5 mm"))
        elif path in overrides:
            faults.append(Fault(one.line, f"{path} set again", "each key once"))
        else:
            overrides[path] = one.value
    return overrides, faults


_KIND = "measurements"
_ACCEPTED = "a CSV file with the columns time_s and midpoint_m, or time_s, x_m and y_m, or time_s and vertical_force_N"
_CLOCKS = ("time", "frame", "slice")
_FORMS = (("midpoint",), ("x", "y"), (HORIZONTAL,), (VERTICAL,), ("force",))
_STDS = ("std", f"{HORIZONTAL}_std", f"{VERTICAL}_std")
_QUANTITIES = (*_CLOCKS, *(one for form in _FORMS for one in form), *_STDS, "likelihood")


def read_measurements(paths: str | os.PathLike[str] | Sequence[str | os.PathLike[str]]) -> Measurements:
    """Read filmed filaments of one material.

    Parameters
    ----------
    paths : path or sequence of paths
        Tables, one for each filament, with ``time_s`` and ``midpoint_m`` (and perhaps ``midpoint_std_m``), or
        ``time_s``, ``x_m`` and ``y_m``, in any unit (``time_ms``, ``midpoint [mm]``; ``sag_mm`` counts downwards), or
        as trackers write them. ``vertical_force_N`` (upwards) and ``horizontal_force_N`` (outwards) of the right
        support stand beside the midpoint or alone; either may have rows in which the other is empty. Lines that start
        with ``#`` are comments; ``# filament.span = 5 mm`` sets a value of the scene for this filament only.

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
    text, cells = read_cells(file, _KIND, _ACCEPTED, lambda name: quantity_of(name, _QUANTITIES))
    (overrides, faults), (camera, wrong) = overrides_in(text), camera_in(text)
    # The first line of an export of Tracker is the name of its track; times are in s, and lengths in m by default.
    above = text.splitlines()[cells.line - 2] if cells.line > 1 else ""
    if camera == Camera() and re.fullmatch(r"\w+", above.strip()) and {"t", "x", "y"} <= {*cells.header}:
        camera, cells = Camera(unit=1.0, time=1.0), cells.also("took Tracker's t in s, x and y in m")
    parts, cells, more = _parts(cells, camera)
    faults += wrong + more
    arrays = dict[str, dict[str, Floats]]()
    for form, part in parts.items() if not faults else ():
        table, said, wrong = repaired(part)
        cells = cells.also(*said)
        faults += wrong
        arrays[form] = {name: table[name].to_numpy() for name in table}
    if faults:
        raise refusal(_KIND, file, faults)
    return Series(
        **arrays.get("midpoint", {"time": np.empty(0), "midpoint": np.empty(0)}),
        shapes=Shapes(**arrays["y"]) if "y" in arrays else None,
        overrides=overrides,
        path=file,
        notes=cells.notes,
        forces=tuple(Forces(**arrays[way], way=way) for way in WAYS if way in arrays),
    )


def _parts(cells: Cells, camera: Camera) -> tuple[dict[str, pd.DataFrame], Cells, list[Fault]]:
    """Split a table into midpoints, points of shapes ("y") and forces, in SI."""
    columns = cells.columns(_QUANTITIES, camera.scale)
    named, read = {one.quantity for one in columns}, {one.quantity for one in columns if one.fault is None}
    x, y = ([one for one in columns if one.quantity == axis and not one.fault] for axis in "xy")
    pairs = list(zip(x, y, strict=False))
    if len(x) == len(y) > 1 and len({(one.unit, other.unit) for one, other in pairs}) == 1:
        return _side_by_side(cells, camera, columns, pairs)
    clock = next((one for known in (read, named) for one in _CLOCKS if one in known), "time")
    whole = [form for form in _FORMS if {*form} <= read]
    needed = whole or [max(_FORMS, key=lambda form: len(named & {*form}))]
    quantities = (clock, *(one for form in needed for one in form))
    used = [one for one in columns if one.quantity in (*quantities, *_STDS)]
    chosen, faults = cells.chosen(used, quantities)
    if ("x", "y") in whole and len(whole) > 1:
        found = f"points of whole shapes beside {', '.join(name for form in whole if len(form) == 1 for name in form)}"
        faults.append(Fault(f"line {cells.line}", found, "two files for both"))
    if faults:
        return {}, cells, faults
    table, faults = cells.numbers([*chosen.values()], implausible)
    table = table.rename(columns={clock: "time"})
    parts = dict[str, pd.DataFrame]()
    for form in whole:
        name = form[-1]
        std = f"{name}_std" if name in WAYS else "std"
        part = table[[one for one in ("time", *form, std) if one in table]]
        part = part.rename(columns={std: "std"} | ({name: "force"} if name in WAYS else {}))
        parts[name] = part[table[name].notna()] if len(whole) > 1 else part
    turned = [one.name for one in chosen.values() if one.heading.sign < 0]
    said = f"turned the sign of {turned[0]}, which counts downwards by its name" if turned else ""
    return parts, _placed(cells.also(said), camera, chosen.get("x")), faults


def _placed(cells: Cells, camera: Camera, x: Column | None) -> Cells:
    if camera.pixel is None or x is None or x.unit != camera.pixel:
        return cells
    return cells.also(f"counted pixels from {camera.origin[0]:g}, {camera.origin[1]:g}, downwards")


def _side_by_side(
    cells: Cells, camera: Camera, columns: Sequence[Column], pairs: Sequence[tuple[Column, Column]]
) -> tuple[dict[str, pd.DataFrame], Cells, list[Fault]]:
    """Points of one picture in one row; pictures are counted where no column has them."""
    clock = next((one for one in columns if one.quantity in _CLOCKS), None)
    if clock is None:
        rows = [(line, [str(k), *row]) for k, (line, row) in enumerate(cells.rows)]
        return _parts(replace(cells, header=["frame", *cells.header], rows=rows), camera)
    if clock.fault:
        return {}, cells, [clock.fault]
    likelihoods: list[Column | None] = [one for one in columns if one.quantity == "likelihood"]
    tables, faults = list[pd.DataFrame](), list[Fault]()
    for k, (x, y) in enumerate(pairs):
        likelihood = likelihoods[k] if len(likelihoods) == len(pairs) else None
        table, wrong = cells.numbers([clock, x, y, *([likelihood] if likelihood else [])], implausible)
        tables.append(table)
        faults += wrong
    # A point that the tracker did not find gives no row.
    points = pd.concat(tables).rename(columns={clock.quantity: "time"}).dropna()
    said = [f"read {len(pairs)} points side by side"]
    if "likelihood" in points:
        doubtful = points.pop("likelihood") < _LIKELY
        points = points[~doubtful]
        if doubtful.any():
            said.append(f"left out {counted(int(doubtful.sum()), 'point')} with a likelihood below {_LIKELY}")
    points = points.sort_values("time", kind="stable")
    return {"y": points}, _placed(cells.also(*said), camera, pairs[0][0]), list(dict.fromkeys(faults))
