"""What a sweep varies, as axes or as the rows of a CSV file, and its members in order."""

from __future__ import annotations

import math
import re
import tomllib
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Final, Literal

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.ensemble.executor import Block
from softcat_sym.ensemble.table import Row, is_group, is_number, kind_of
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.fitting.csv_reader import cells_of, counted, data_lines, number_in, refusal, text_of
from softcat_sym.scene.material import OF_THE_INDEX
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.toml import read_overrides
from softcat_sym.scene.units import SI_UNITS, NotAQuantity, Number, Quantity, Whole, shown, si_unit, to_si, to_si_of_any
from softcat_sym.simulate import identity_of
from softcat_sym.store import key_of

_FORM = (
    "KEY=a:b:n, KEY=a:b:n:log or KEY=v1,v2,v3, such as groups.G=0.01:3:40:log or 'material.yield_stress=5:20 kPa:10'"
)
_SPACED = "two ends and at least 2 values, a:b:n or a:b:n:log; positive ends for log"
_MOST = 10_000_000
_UNIT = re.compile(r"^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)$")

_TOLD = 10

Value = object


@dataclass(frozen=True)
class SweepAxis:
    """One key and its values."""

    key: str  # Dotted path in the scene
    values: tuple[Value, ...]  # In the order given; plain numbers are in SI
    scale: str = "lin"  # ``"log"`` where values are spaced evenly in their logarithm, otherwise ``"lin"``
    ends: tuple[float, float] | None = None  # Of a range, in SI: what a Latin hypercube draws between. None for a list

    def at(self, share: float) -> Value:
        """The value at a share of the way, 0 to 1: between the ends of a range, or one of a list."""
        if self.ends is None:
            return self.values[min(int(share * len(self.values)), len(self.values) - 1)]
        low, high = self.ends
        value = low * (high / low) ** share if self.scale == "log" else low + share * (high - low)
        return round(value) if isinstance(self.values[0], int) else value

    def described(self) -> dict[str, Any]:
        """For the record."""
        return {"key": self.key, "values": list(self.values), "scale": self.scale, "ends": self.ends}


def read_axes(
    scene: Scene, vary: Mapping[str, Sequence[Value] | str] | Sequence[str], *, drawn: bool = False
) -> tuple[SweepAxis, ...]:
    """Read what is to be varied."""
    if isinstance(vary, str):
        vary = [vary]
    pairs = list(vary.items()) if isinstance(vary, Mapping) else [_split(text) for text in vary]
    faults: list[Fault] = []
    axes: list[SweepAxis] = []
    for key, values in pairs:
        try:
            if key in {axis.key for axis in axes}:
                raise _refusal(key, "varied twice", "each key once")
            axes.append(_axis(scene, str(key), values, drawn))
        except SceneError as error:
            faults += error.faults
    if not pairs:
        faults.append(Fault("", "nothing is varied", _FORM))
    if faults:
        raise SceneError(faults, "of a sweep")
    return tuple(axes)


def refuse_units(scene: Scene, axes: Sequence[SweepAxis]) -> None:
    """Refuse text that is no quantity where one is needed: a slip, where a value out of range is a refused member."""
    if {"material.index", "material.law"} & {axis.key for axis in axes}:
        axes = [axis for axis in axes if axis.key.rpartition(".")[2] not in OF_THE_INDEX]
    faults = []
    for axis in axes:
        kind = kind_of(scene, {}, axis.key)
        for value in axis.values if isinstance(kind, Quantity) else ():
            try:
                if not is_number(value) and isinstance(kind, Quantity):
                    to_si(value, kind.dimension, kind.unit)
            except NotAQuantity as error:
                faults.append(Fault(axis.key, str(error), kind.accepted if kind is not None else ""))
    if faults:
        raise SceneError(list(dict.fromkeys(faults))[:_TOLD], "of a sweep")


def _split(text: object) -> tuple[str, str]:
    key, equals, values = (part.strip() for part in str(text).partition("="))
    if not isinstance(text, str) or not key or not equals or not values:
        raise SceneError([Fault("--vary", f"{shown(text)} varies nothing", _FORM)], "of a sweep")
    return key, values


def _axis(scene: Scene, key: str, values: Sequence[Value] | str, drawn: bool) -> SweepAxis:
    if isinstance(values, str):
        if values.count(":") >= (1 if drawn else 2):
            return _range(scene, key, values, drawn)
        if ":" in values and not values.lstrip().startswith(("[", "{", '"')):
            raise _refusal(key, f"{shown(values)} is no range", _SPACED)
        found: list[Value] = _list(scene, key, values)
    else:
        if not hasattr(values, "__len__"):
            raise _refusal(key, f"{shown(values)} is no sequence of values", _FORM)
        found = [value.item() if isinstance(value, np.generic) else value for value in values]
    if not found:
        raise _refusal(key, "no value", _FORM)
    odd = [value for value in found if is_number(value) and not math.isfinite(float(value))]
    if odd:
        raise _refusal(key, f"{odd[0]} is not finite", "finite numbers")
    return SweepAxis(key, tuple(found))


def _range(scene: Scene, key: str, text: str, drawn: bool) -> SweepAxis:
    parts = [part.strip().strip("\"'").strip() for part in text.split(":")]
    scale = parts.pop() if parts[-1] == "log" else "lin"
    if drawn and len(parts) == 2:
        parts.append("2")  # how many does not matter
    if len(parts) != 3 or not re.fullmatch(r"\d{1,8}", parts[2]) or not 2 <= int(parts[2]) <= _MOST:
        raise _refusal(key, f"{shown(text)} is no range", _SPACED)
    count = int(parts[2])
    low, high = _numbers(scene, key, parts[:2])
    if scale == "log" and not (low > 0 and high > 0):
        raise _refusal(key, f"{shown(text)} is logarithmic, and not positive", _SPACED)
    if low == high:
        raise _refusal(key, f"both ends of {shown(text)} are the same", _SPACED)
    spaced = np.geomspace(low, high, count) if scale == "log" else np.linspace(low, high, count)
    # Twelve digits: what rounding adds would end up in tables.
    values: list[Value] = [float(f"{value:.12g}") for value in spaced]
    if isinstance(kind_of(scene, {}, key), Whole):
        whole = [round(float(value)) for value in spaced]
        if low != round(low) or high != round(high) or (len(set(whole)) < count and not drawn):
            raise _refusal(key, f"{shown(text)} does not give {count} whole numbers", "whole ends, and fewer values")
        values = [*whole]
    return SweepAxis(key, tuple(values), scale, (low, high))


def _list(scene: Scene, key: str, text: str) -> list[Value]:
    """Values between commas, in TOML if they are; plain numbers take the unit of the last value."""
    try:
        found: list[Value] = tomllib.loads(f"values = [{text}]")["values"]
    except (ValueError, RecursionError):
        parts = [part.strip() for part in text.split(",")]
        if not all(parts):
            raise _refusal(key, f"{shown(text)} has an empty value", _FORM) from None
        overrides, faults = read_overrides([f"{key}={part}" for part in parts])
        if faults:
            raise SceneError(faults) from None
        found = [override.value for override in overrides]
    if not isinstance(kind_of(scene, {}, key), Quantity):
        return found
    unit = _unit_of(str(found[-1])) if found else ""
    if not unit and any(is_number(value) for value in found):
        raise _refusal(key, f"{shown(text)} has no unit", _accepted(scene, key))
    return [f"{value!r} {unit}" if is_number(value) else value for value in found]


def _numbers(scene: Scene, key: str, ends: Sequence[str]) -> list[float]:
    """The two ends of a range as numbers, quantities in SI; the first may have the unit of the second."""
    kind = kind_of(scene, {}, key)
    if not isinstance(kind, Quantity):
        try:
            found = [float(end) for end in ends]
        except ValueError:
            name = key if is_group(key) or kind is None else f"{key}, which is {kind.accepted}"
            raise _refusal(key, f"{shown(':'.join(ends))} are no plain numbers", f"plain numbers for {name}") from None
        if not all(map(math.isfinite, found)):
            raise _refusal(key, f"{shown(':'.join(ends))} is not finite", _SPACED)
        return found
    unit = _unit_of(ends[1])
    texts = [f"{end} {unit}".strip() if not _unit_of(end) else end for end in ends]
    try:
        return [to_si(text, kind.dimension, kind.unit) for text in texts]
    except NotAQuantity as error:
        raise _refusal(key, str(error), _accepted(scene, key)) from None


def _unit_of(text: str) -> str:
    found = _UNIT.match(text)
    return found[2] if found else ""


def _accepted(scene: Scene, key: str) -> str:
    kind = kind_of(scene, {}, key)
    return kind.accepted if kind is not None else _FORM


def _refusal(key: str, found: str, accepted: str) -> SceneError:
    return SceneError([Fault(key, found, accepted)], "of a sweep")


_KIND = "table of a sweep"
_CSV_FORM = "a header of dotted keys, groups.G,material.yield_stress [kPa], and a row of values for each member"
_HEADER = re.compile(r"([A-Za-z_][\w-]*(?:\.[A-Za-z_][\w-]*)*)\s*(?:[\[(]\s*([^\])]*?)\s*[\])])?")


def read_table(scene: Scene, path: str | Path) -> tuple[SweepAxis, ...]:
    """Read the members of a sweep."""
    file = Path(path)
    lines = data_lines(text_of(file, _KIND, _CSV_FORM))
    if not lines:
        raise refusal(_KIND, file, [Fault("", "empty", _CSV_FORM)])
    header = _header(file, *lines[0])
    if len(lines) == 1:
        raise refusal(_KIND, file, [Fault("", "no rows below the header", _CSV_FORM)])
    faults: list[Fault] = []
    rows: list[list[object]] = []
    for number, line in lines[1:]:
        row, wrong = _row(scene, header, cells_of(line))
        rows.append(row)
        faults += [Fault(f"line {number}{fault.path}", fault.found, fault.accepted) for fault in wrong]
    if faults:
        raise refusal(_KIND, file, faults)
    columns = zip(*rows, strict=True)
    return tuple(SweepAxis(key, tuple(column)) for (key, _), column in zip(header, columns, strict=True))


def _row(scene: Scene, header: Sequence[tuple[str, str]], cells: Sequence[str]) -> tuple[list[object], list[Fault]]:
    """The values of a row, and what is wrong with them."""
    if len(cells) != len(header):
        found = f"{counted(len(cells), 'value')}, but the header has {counted(len(header), 'key')}"
        return [], [Fault("", found, "a value for each key")]
    row: list[object] = []
    faults: list[Fault] = []
    for (key, unit), cell in zip(header, cells, strict=True):
        value = _value(key, unit, cell)
        needed = "" if unit or not is_number(value) else _unit_needed(scene, key)
        if needed:
            value = Fault(key, f"{shown(cell)} has no unit", f"a unit, or in the header: {key} [{needed}]")
        if isinstance(value, Fault):
            faults.append(Fault(f", {key}", value.found, value.accepted))
        row.append(value)
    return row, faults


def _header(file: Path, number: int, line: str) -> list[tuple[str, str]]:
    """Keys and units."""
    found: list[tuple[str, str]] = []
    faults: list[Fault] = []
    for cell in cells_of(line):
        match = _HEADER.fullmatch(cell)
        if match is None or ("." not in match[1] and match[1] != "model"):
            faults.append(Fault(f"line {number}", f"{shown(cell)} is no dotted key", _CSV_FORM))
        elif match[1] in {key for key, _ in found}:
            faults.append(Fault(f"line {number}", f"{match[1]} stands there twice", "each key once"))
        else:
            found.append((match[1], match[2] or ""))
            faults += _unit_faults(f"line {number}, {match[1]}", match[2] or "1")
    if faults:
        raise refusal(_KIND, file, faults)
    return found


def _unit_faults(where: str, unit: str) -> list[Fault]:
    """What is wrong with the unit of a column that nobody knows."""
    try:
        to_si_of_any(f"1 {unit}" if unit != "1" else 1)
    except NotAQuantity as found:
        return [Fault(where, str(found), "a unit, such as [mm]")]
    return []


def _value(key: str, unit: str, cell: str) -> object:
    """What a cell holds, or what is wrong with it."""
    if not cell:
        return Fault(key, "an empty cell", "a value")
    number = number_in(cell)
    if number is None:
        overrides, faults = read_overrides([f"{key}={cell}"])
        return faults[0] if faults else overrides[0].value
    if not math.isfinite(number):
        return Fault(key, f"{shown(cell)} is not finite", "a finite number")
    if unit and unit != "1":
        return f"{cell} {unit}"
    return int(cell) if re.fullmatch(r"[+-]?\d+", cell) else number


def _unit_needed(scene: Scene, key: str) -> str:
    """An example of the unit that a key needs; an empty text if it needs none."""
    kind = kind_of(scene, {}, key)
    return kind.example.split()[-1] if isinstance(kind, Quantity) else ""


def csv_columns_of(axes: Sequence[SweepAxis]) -> int:
    """How many rows columns have."""
    lengths = {axis.key: len(axis.values) for axis in axes}
    if len(set(lengths.values())) > 1:
        found = ", ".join(f"{key} has {count}" for key, count in lengths.items())
        raise SoftcatError(f"axes of unequal lengths cannot be zipped: {found}; give each as many values, or take grid")
    return next(iter(lengths.values()))


Mode = Literal["grid", "zip", "lhs", "table"]
MODES: Final = ("grid", "zip", "lhs")

MOST: Final = 10_000_000
"""Members of a sweep."""

SHAPE_FRAMES, SHAPE_NODES = 21, 41

_FEW, _MANY, _BLOCKS, _SLOW = 10, 500, 200, 4
"""Least and most members of a block, how many blocks a sweep should have, and members of a block where each takes
seconds: what an interruption can cost, against a file for each."""

_LISTED = 200
"""Values of an axis that the record lists; of longer ones it gives the number."""

_SHARED = frozenset({"run.frames"})


@dataclass(frozen=True)
class SweepPlan:
    """What is to be run."""

    scene: Scene  # What the members have in common
    axes: tuple[SweepAxis, ...]  # What varies
    # ``"grid"``: every combination, the last axis fastest; ``"zip"`` and ``"table"``: values side by side; ``"lhs"``:
    # a Latin hypercube (McKay, Beckman and Conover 1979).
    mode: Mode = "grid"
    samples: int = 0  # Of the hypercube
    seed: int = 0
    shapes: bool = False  # Whether shapes are kept
    # Whether each member is run as :func:`softcat_sym.simulate` runs it, with its error estimated.
    estimate: bool = False

    @property
    def keys(self) -> tuple[str, ...]:
        """What varies."""
        return tuple(axis.key for axis in self.axes)

    @cached_property
    def members(self) -> int:
        """How many there are."""
        if self.mode == "grid":
            return math.prod(len(axis.values) for axis in self.axes)
        return self.samples if self.mode == "lhs" else len(self.axes[0].values)

    @property
    def block_size(self) -> int:
        """Members of a block."""
        if self.estimate:
            return _SLOW
        return min(_MANY, max(_FEW, math.ceil(self.members / _BLOCKS)))

    @property
    def blocks(self) -> int:
        """How many there are."""
        return math.ceil(self.members / self.block_size)

    def block(self, number: int) -> Block[Row]:
        """The members of a block: rows of raw values by key."""
        start = number * self.block_size
        stop = min(start + self.block_size, self.members)
        return Block(number, tuple(self.row(member) for member in range(start, stop)))

    def row(self, member: int) -> Row:
        """What a member changes in the scene."""
        if self.mode == "grid":
            places = np.unravel_index(member, [len(axis.values) for axis in self.axes])
            return {axis.key: axis.values[int(place)] for axis, place in zip(self.axes, places, strict=True)}
        if self.mode == "lhs":
            shares = zip(self.axes, self._shares[member], strict=True)
            return {axis.key: axis.at(float(share)) for axis, share in shares}
        return {axis.key: axis.values[member] for axis in self.axes}

    @cached_property
    def _shares(self) -> Floats:
        """Places of the samples, shape (samples, axes), each axis cut into as many equal parts, one in each."""
        random = np.random.default_rng(self.seed)
        parts = np.stack([random.permutation(self.samples) for _ in self.axes], axis=1)
        return np.asarray((parts + random.random(parts.shape)) / self.samples)

    def described(self) -> dict[str, Any]:
        """For the record; long lists of values are left to the table of results."""
        axes = [axis.described() for axis in self.axes]
        for axis in axes:
            if len(axis["values"]) > _LISTED:
                axis["values"] = len(axis["values"])
        told: dict[str, Any] = {"mode": self.mode, "members": self.members, "axes": axes}
        if self.mode == "lhs":
            told |= {"samples": self.samples, "seed": self.seed}
        return told | {"block": self.block_size, "shapes": self.shapes, "estimate": self.estimate}

    @cached_property
    def digest(self) -> str:
        """Hash of all that decides the results."""
        axes = [axis.described() for axis in self.axes]
        how = [self.mode, self.samples, self.seed, self.shapes, self.estimate, self.block_size]
        return key_of("plan of a sweep", identity_of(self.scene), axes, how)

    def key(self, block: Block[Row]) -> str:
        """Key of the results of a block."""
        return key_of("sweep", identity_of(self.scene), block.items, self.shapes, self.estimate)


def plan_sweep(
    scene: Scene,
    vary: Mapping[str, Sequence[object] | str] | Sequence[str] | Path,
    mode: str = "grid",
    *,
    samples: int | None = None,
    seed: int = 0,
    shapes: bool = False,
    estimate: bool = False,
) -> SweepPlan:
    """Read what is asked for."""
    if mode not in MODES:
        raise SoftcatError(f"no mode {mode!r} of a sweep; accepted: {', '.join(MODES)}")
    _check_samples(mode, samples, seed)
    if isinstance(vary, Path):
        if mode != "grid":
            raise SoftcatError(f"a table has its members in rows: no mode {mode!r}")
        axes, kind = read_table(scene, vary), "table"
    else:
        axes, kind = read_axes(scene, vary, drawn=mode == "lhs"), mode
        if kind == "grid":
            _check_distinct(axes)
        elif kind == "zip":
            csv_columns_of(axes)
    refuse_units(scene, axes)
    shared = [axis.key for axis in axes if axis.key in _SHARED]
    if shared:
        raise SceneError([Fault(shared[0], "varied, but members share their frames", "--set run.frames=...")], "")
    plan = SweepPlan(scene, axes, _mode(kind), samples or 0, seed, shapes, estimate)
    if plan.members > MOST:
        raise SoftcatError(f"a sweep of {plan.members} members; accepted: up to {MOST}")
    return plan


def _mode(kind: str) -> Mode:
    modes: dict[str, Mode] = {"grid": "grid", "zip": "zip", "lhs": "lhs", "table": "table"}
    return modes[kind]


def _check_samples(mode: str, samples: int | None, seed: int) -> None:
    if mode == "lhs":
        if isinstance(samples, bool) or not isinstance(samples, int) or not 2 <= samples <= MOST:
            raise SoftcatError(f"samples = {samples!r}: a Latin hypercube needs a number of samples, 2 to {MOST}")
        if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
            raise SoftcatError(f"seed = {seed!r}: accepted: a whole number, 0 or more")
    elif samples is not None:
        raise SoftcatError(f"samples are for a Latin hypercube (mode lhs), not for mode {mode}")


def _check_distinct(axes: Sequence[SweepAxis]) -> None:
    """Refuse an axis that names a value twice: its members would be run twice."""
    for axis in axes:
        value, times = Counter(map(repr, axis.values)).most_common(1)[0]
        if times > 1:
            raise SceneError([Fault(axis.key, f"{value} is named twice", "different values")], "of a sweep")


_LISTED_VALUES = 3
"""Positive values over more than this ratio are shown over a logarithm, whatever way they were spaced."""


@dataclass(frozen=True)
class VariedColumn:
    """How the values of a key are stored."""

    key: str  # Which
    units: str  # ``"1"`` of pure numbers; an empty text of text
    scale: str  # ``"lin"`` or ``"log"``
    dimension: str  # By which text with a unit is read; empty where any unit will do
    is_text: bool  # Whether values are no numbers

    def numbers(self, values: Sequence[object]) -> Floats:
        """Values as numbers in SI, NaN where one makes none."""
        return np.array([self._number(value) for value in values], dtype=float)

    def _number(self, value: object) -> float:
        if is_number(value):
            return float(value)
        try:
            return to_si(value, self.dimension, self.units) if self.dimension else to_si_of_any(value)[0]
        except NotAQuantity:
            return math.nan


def columns_of(plan: SweepPlan) -> tuple[VariedColumn, ...]:
    """A column for each axis of a plan."""
    return tuple(_column(plan, k) for k in range(len(plan.axes)))


def _column(plan: SweepPlan, k: int) -> VariedColumn:
    axis = plan.axes[k]
    kind = kind_of(plan.scene, {}, axis.key)
    if isinstance(kind, Quantity):
        units, dimension = kind.unit or SI_UNITS[kind.dimension], kind.dimension
    elif isinstance(kind, (Number, Whole)) or is_group(axis.key) or all(map(is_number, axis.values)):
        units, dimension = "1", ""
    else:
        found = [to_si_of_any(value) for value in axis.values if _is_quantity(value)]
        if len(found) < len(axis.values):
            return VariedColumn(axis.key, "", "lin", "", True)
        units, dimension = si_unit(found[0][1]) or "1", ""
    column = VariedColumn(axis.key, units, axis.scale, dimension, False)
    if axis.ends is None and _spreads(column.numbers(axis.values)):
        column = VariedColumn(axis.key, units, "log", dimension, False)
    return column


def _spreads(values: Floats) -> bool:
    """Whether listed values are better seen over a logarithm: positive, and over more than a decade."""
    known = values[np.isfinite(values)]
    return len(known) > _LISTED_VALUES - 1 and bool(np.min(known) > 0) and float(np.max(known) / np.min(known)) > 10


def _is_quantity(value: object) -> bool:
    try:
        to_si_of_any(value)
    except NotAQuantity:
        return False
    return True
