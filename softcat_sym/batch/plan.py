"""The plan of a sweep: varied keys, as axes or as the rows of a CSV file, and the members in order.

A range of a key is a text, ``filament.span=5:50 mm:10:log``: what a sweep varies, and between what a slider goes.
"""

from __future__ import annotations

import json
import math
import re
import tomllib
import warnings
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from itertools import product
from pathlib import Path
from typing import Any, Final, Literal, cast

import numpy as np
import numpy.typing as npt

from softcat_sym.batch.members import Row, column_of, is_group, is_number, kind_of
from softcat_sym.errors import Fault, SceneError, SoftcatError, SoftcatWarning
from softcat_sym.scene.keys import scene_keys
from softcat_sym.scene.laws import OF_THE_INDEX
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.table_reader import number_in, read_table
from softcat_sym.scene.toml import read_overrides
from softcat_sym.scene.units import NotAQuantity, Quantity, Whole, shown, to_si_of_any
from softcat_sym.simulate import identity_of
from softcat_sym.store import key_of

Value = object
Mode = Literal["grid", "zip", "lhs", "table"]
MODES: Final = ("grid", "zip", "lhs")
MAX_MEMBERS: Final = 1_000_000

_FORM = (
    "KEY=a:b:n, KEY=a:b:n:log or KEY=v1,v2,v3, such as groups.G=0.01:3:40:log or 'material.yield_stress=5:20 kPa:10'"
)
_FAULTS_LISTED, _VALUES_LISTED = 10, 200
_BLOCK, _BLOCKS, _SLOW_BLOCK = (10, 500), 200, 4
"""Range of the members of a block, target number of blocks, and members of a block where each takes seconds: small
blocks lose less in an interruption, large ones need fewer files."""

SOURCE = "of a sweep"
SPACED = "two ends and at least 2 values, a:b:n or a:b:n:log; positive ends for log"
_UNIT = re.compile(r"^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)$")


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


def read_range(scene: Scene, key: str, text: str, *, drawn: bool, accepted: str = SPACED) -> SweepAxis:
    """Read a range; one that is drawn from need not say how many values it has."""
    parts = [part.strip().strip("\"'").strip() for part in text.split(":")]
    scale = parts.pop() if parts[-1] == "log" else "lin"
    if drawn and len(parts) == 2:
        parts.append("2")  # how many does not matter
    if len(parts) != 3 or not re.fullmatch(r"\d{1,8}", parts[2]) or not 2 <= int(parts[2]) <= MAX_MEMBERS:
        raise _refusal(key, f"{shown(text)} is no range", accepted)
    count = int(parts[2])
    low, high = _ends(scene, key, parts[:2], accepted)
    if scale == "log" and not (low > 0 and high > 0):
        raise _refusal(key, f"{shown(text)} is logarithmic, and not positive", accepted)
    if low == high:
        raise _refusal(key, f"both ends of {shown(text)} are the same", accepted)
    spaced = np.geomspace(low, high, count) if scale == "log" else np.linspace(low, high, count)
    # Twelve digits: what rounding adds would end up in tables.
    values: list[Value] = [float(f"{value:.12g}") for value in spaced]
    if isinstance(kind_of(scene, {}, key), Whole):
        values = [round(float(value)) for value in spaced]
        if low != round(low) or high != round(high) or (len(set(values)) < count and not drawn):
            raise _refusal(key, f"{shown(text)} does not give {count} whole numbers", "whole ends, and fewer values")
    return SweepAxis(key, tuple(values), scale, (low, high))


def _ends(scene: Scene, key: str, ends: Sequence[str], accepted: str) -> list[float]:
    """The two ends of a range as numbers, quantities in SI; the first may have the unit of the second."""
    kind = kind_of(scene, {}, key)
    if not isinstance(kind, Quantity):
        try:
            numbers = [float(end) for end in ends]
        except ValueError:
            name = key if is_group(key) or kind is None else f"{key}, which is {kind.accepted}"
            raise _refusal(key, f"{shown(':'.join(ends))} are no plain numbers", f"plain numbers for {name}") from None
        if not all(map(math.isfinite, numbers)):
            raise _refusal(key, f"{shown(':'.join(ends))} is not finite", accepted)
        return numbers
    texts = [end if unit_of(end) else f"{end} {unit_of(ends[1])}".strip() for end in ends]
    try:
        return [kind.measured(text) for text in texts]
    except NotAQuantity as error:
        raise _refusal(key, str(error), kind.accepted) from None


def unit_of(text: str) -> str:
    """The unit at the end of a quantity as text; empty without one."""
    match = _UNIT.match(text)
    return match[2] if match else ""


def _refusal(key: str, found: str, accepted: str) -> SceneError:
    """The error of one key that cannot be varied so."""
    return SceneError([Fault(key, found, accepted)], SOURCE)


@dataclass(frozen=True)
class SweepPlan:
    """The members of a sweep."""

    scene: Scene  # The common part of the members
    axes: tuple[SweepAxis, ...]  # The varied keys
    # ``"grid"``: every combination, the last axis fastest; ``"zip"`` and ``"table"``: values side by side; ``"lhs"``:
    # a Latin hypercube (McKay, Beckman and Conover 1979).
    mode: Mode = "grid"
    samples: int = 0  # Number of samples of the hypercube
    seed: int = 0
    # Whether each member is run as :func:`softcat_sym.simulate` runs it, with its error estimated.
    estimate: bool = False

    @cached_property
    def members(self) -> int:
        """Number of members."""
        if self.mode == "grid":
            return math.prod(len(axis.values) for axis in self.axes)
        return self.samples if self.mode == "lhs" else len(self.axes[0].values)

    @property
    def block_size(self) -> int:
        """Number of members that are stored together."""
        return _SLOW_BLOCK if self.estimate else int(np.clip(math.ceil(self.members / _BLOCKS), *_BLOCK))

    @cached_property
    def rows(self) -> list[Row]:
        """Values of the varied keys for each member."""
        keys = [axis.key for axis in self.axes]
        if self.mode == "grid":
            return [dict(zip(keys, row, strict=True)) for row in product(*(axis.values for axis in self.axes))]
        if self.mode != "lhs":
            return [dict(zip(keys, row, strict=True)) for row in zip(*(axis.values for axis in self.axes), strict=True)]
        # One sample in each of as many equal parts of every axis.
        random = np.random.default_rng(self.seed)
        parts = np.stack([random.permutation(self.samples) for _ in keys], axis=1)
        shares = ((parts + random.random(parts.shape)) / self.samples).tolist()
        return [{axis.key: axis.at(share) for axis, share in zip(self.axes, row, strict=True)} for row in shares]

    @property
    def middle(self) -> Row:
        """Values of the varied keys for the member in the middle of the ranges."""
        if self.mode == "grid":
            return {axis.key: axis.values[len(axis.values) // 2] for axis in self.axes}
        return {axis.key: axis.at(0.5) for axis in self.axes} if self.mode == "lhs" else self.rows[self.members // 2]

    def variables(self) -> dict[str, tuple[str, npt.NDArray[Any], dict[str, Any]]]:
        """The varied keys, as :class:`xarray.Dataset` takes them."""
        found = {}
        for axis in self.axes:
            values, attrs = column_of(self.scene, axis.key, [row[axis.key] for row in self.rows])
            # Listed positive values over more than a decade have a logarithmic axis.
            known = np.unique(values[np.isfinite(values)] if attrs else [])
            wide = axis.ends is None and len(known) > 2 and known[0] > 0 and known[-1] / known[0] > 10
            found[axis.key] = "member", values, {"varied": 1, "scale": "log" if wide else axis.scale} | attrs
        return found

    def unknown_keys(self) -> Iterator[tuple[str, Value]]:
        """Keys that no scene file has, each with a value."""
        known = [key.path for key in scene_keys()]
        for axis in self.axes:
            nested = axis.key in known or any(axis.key.startswith(f"{key}.") for key in known)
            if not nested and not is_group(axis.key):
                yield axis.key, axis.values[0]

    def to_dict(self) -> dict[str, Any]:
        """The plan for records; a long list of values is replaced by its length."""
        axes = [asdict(axis) for axis in self.axes]
        for axis in axes:
            axis["values"] = len(axis["values"]) if len(axis["values"]) > _VALUES_LISTED else list(axis["values"])
        record: dict[str, Any] = {"mode": self.mode, "members": self.members, "axes": axes}
        if self.mode == "lhs":
            record |= {"samples": self.samples, "seed": self.seed}
        return record | {"block": self.block_size, "estimate": self.estimate}

    @cached_property
    def digest(self) -> str:
        """Hash of everything on which the results depend."""
        how = [self.mode, self.samples, self.seed, self.estimate, self.block_size]
        return key_of("plan of a sweep", identity_of(self.scene), self.axes, how)


def plan_sweep(
    scene: Scene,
    vary: Mapping[str, Sequence[object] | str] | Sequence[str] | Path,
    mode: str = "grid",
    *,
    samples: int | None = None,
    seed: int = 0,
    estimate: bool = False,
) -> SweepPlan:
    """Make the plan of a sweep from its arguments."""
    if mode not in MODES:
        raise SoftcatError(f"no mode {mode!r} of a sweep; accepted: {', '.join(MODES)}")
    if mode == "lhs":
        if type(samples) is not int or not 2 <= samples <= MAX_MEMBERS:
            raise SoftcatError(
                f"samples = {samples!r}: a Latin hypercube needs a number of samples, 2 to {MAX_MEMBERS}"
            )
        if type(seed) is not int or seed < 0:
            raise SoftcatError(f"seed = {seed!r}: accepted: a whole number, 0 or more")
    elif samples is not None:
        raise SoftcatError(f"samples are for a Latin hypercube (mode lhs), not for mode {mode}")
    if isinstance(vary, Path):
        if mode != "grid":
            raise SoftcatError(f"a table lists its members in rows: it has no mode {mode!r}")
        mode, axes = "table", _table_axes(scene, vary)
    else:
        axes = read_axes(scene, vary, drawn=mode == "lhs")
        _check_axes(axes, mode)
    _check_units(scene, axes)
    if "run.frames" in {axis.key for axis in axes}:
        raise SceneError([Fault("run.frames", "varied, but members share their frames", "--set run.frames=...")], "")
    plan = SweepPlan(scene, axes, cast(Mode, mode), samples or 0, seed, estimate)
    if plan.members > MAX_MEMBERS:
        raise SoftcatError(f"a sweep of {plan.members} members; accepted: up to {MAX_MEMBERS}")
    return plan


def _check_axes(axes: Sequence[SweepAxis], mode: str) -> None:
    """Refuse zipped axes of unequal lengths, and values of a grid that are named twice, as members would run twice."""
    lengths = {axis.key: len(axis.values) for axis in axes}
    if mode == "zip" and len(set(lengths.values())) > 1:
        found = ", ".join(f"{key} has {count}" for key, count in lengths.items())
        raise SoftcatError(f"axes of unequal lengths cannot be zipped: {found}; give each as many values, or take grid")
    for axis in axes if mode == "grid" else ():
        text, times = Counter(json.dumps(value, default=str) for value in axis.values).most_common(1)[0]
        if times > 1:
            raise _refusal(axis.key, f"{text} is named twice", "different values")


def _check_units(scene: Scene, axes: Sequence[SweepAxis]) -> None:
    """Refuse text that is not the needed quantity; a value out of range, in contrast, is a refused member."""
    if {"material.index", "material.law"} & {axis.key for axis in axes}:
        axes = [axis for axis in axes if axis.key.rpartition(".")[2] not in OF_THE_INDEX]
    faults = []
    for axis in axes:
        kind = kind_of(scene, {}, axis.key)
        if isinstance(kind, Quantity):
            faults += [fault for one in axis.values if not is_number(one) for fault in _faults_of(axis.key, one, kind)]
    if faults:
        raise SceneError(list(dict.fromkeys(faults))[:_FAULTS_LISTED], SOURCE)


def _faults_of(key: str, value: Value, kind: Quantity) -> list[Fault]:
    """The fault of text that is not the quantity of a key."""
    try:
        kind.measured(value)
    except NotAQuantity as error:
        return [Fault(key, str(error), kind.accepted)]
    return []


def read_axes(
    scene: Scene, vary: Mapping[str, Sequence[Value] | str] | Sequence[str], *, drawn: bool = False
) -> tuple[SweepAxis, ...]:
    """Read the varied keys with their values."""
    texts = [vary] if isinstance(vary, str) else vary
    faults: list[Fault] = []
    axes: dict[str, SweepAxis] = {}
    pairs = texts.items() if isinstance(texts, Mapping) else [(text, None) for text in texts]
    for key, values in pairs:
        try:
            key, values = (str(key), values) if values is not None else _split(key)
            if key in axes:
                raise _refusal(key, "varied twice", "each key once")
            axes[key] = _axis(scene, key, values, drawn)
        except SceneError as error:
            faults += error.faults
    if not pairs:
        faults.append(Fault("", "nothing is varied", _FORM))
    if faults:
        raise SceneError(faults, SOURCE)
    return tuple(axes.values())


def _split(text: object) -> tuple[str, str]:
    key, equals, values = (part.strip() for part in str(text).partition("="))
    if not isinstance(text, str) or not key or not equals or not values:
        raise _refusal("--vary", f"{shown(text)} varies nothing", _FORM)
    return key, values


def _axis(scene: Scene, key: str, values: Sequence[Value] | str, drawn: bool) -> SweepAxis:
    if isinstance(values, str):
        if values.count(":") >= (1 if drawn else 2):
            return read_range(scene, key, values, drawn=drawn)
        if ":" in values and not values.lstrip().startswith(("[", "{", '"')):
            raise _refusal(key, f"{shown(values)} is no range", SPACED)
        listed = _list(scene, key, values)
    elif not hasattr(values, "__len__"):
        raise _refusal(key, f"{shown(values)} is no sequence of values", _FORM)
    else:
        listed = [value.item() if isinstance(value, np.generic) else value for value in values]
    if not listed:
        raise _refusal(key, "no value", _FORM)
    for value in listed:
        if is_number(value) and not math.isfinite(float(value)):
            raise _refusal(key, f"{value} is not finite", "finite numbers")
    return SweepAxis(key, tuple(listed))


def _list(scene: Scene, key: str, text: str) -> list[Value]:
    """Values between commas, read as TOML if possible; plain numbers take the unit of the last value."""
    try:
        values: list[Value] = tomllib.loads(f"values = [{text}]")["values"]
    except (ValueError, RecursionError):
        parts = [part.strip() for part in text.split(",")]
        if not all(parts):
            raise _refusal(key, f"{shown(text)} has an empty value", _FORM) from None
        overrides, faults = read_overrides([f"{key}={part}" for part in parts])
        if faults:
            raise SceneError(faults) from None
        values = [override.value for override in overrides]
    kind = kind_of(scene, {}, key)
    if not isinstance(kind, Quantity):
        return values
    unit = unit_of(str(values[-1])) if values else ""
    if not unit and any(is_number(value) for value in values):
        raise _refusal(key, f"{shown(text)} has no unit", kind.accepted)
    return [f"{value!r} {unit}" if is_number(value) else value for value in values]


_KIND = "table of a sweep"
_CSV_FORM = "a header of dotted keys, groups.G,material.yield_stress [kPa], and a row of values for each member"
_HEADER = re.compile(r"(model|[A-Za-z_][\w-]*(?:\.[A-Za-z_][\w-]*)+)\s*(?:[\[(]\s*([^\])]*?)\s*[\])])?")


def _key_of(heading: str) -> str | None:
    match = _HEADER.fullmatch(heading)
    return match[1] if match else None


def _table_axes(scene: Scene, path: Path) -> tuple[SweepAxis, ...]:
    """Read the members of a sweep from the rows of a CSV file."""
    table = read_table(path, _KIND, _CSV_FORM, _key_of)
    where, faults, header = f"line {table.line}", list[Fault](), list[tuple[str, str]]()
    for place, heading in enumerate(table.header):
        match = _HEADER.fullmatch(heading)
        if match is None:
            faults.append(Fault(where, f"{shown(heading)} is no dotted key", _CSV_FORM))
            continue
        key, unit = match[1], match[2] or table.units[place]
        if key in dict(header):
            faults.append(Fault(where, f"{key} stands there twice", "each key once"))
        try:
            to_si_of_any(f"1 {unit}" if unit not in ("", "1") else 1.0)
        except NotAQuantity:
            faults.append(Fault(f"{where}, {key}", f"unknown unit {shown(unit)}", "a unit, such as [mm]"))
        header.append((key, unit))
    table.refuse(faults)
    table.check_rows()
    rows = [[_cell(scene, *heading, cell) for heading, cell in zip(header, row, strict=False)] for _, row in table.rows]
    for (number, _), row in zip(table.rows, rows, strict=True):
        wrong = [one for one in row if isinstance(one, Fault)]
        faults += [Fault(f"line {number}, {one.path}", one.found, one.accepted) for one in wrong]
    table.refuse(faults)
    for note in table.notes:
        warnings.warn(f"{path}: {note}", SoftcatWarning, stacklevel=3)
    return tuple(SweepAxis(key, tuple(row[k] for row in rows)) for k, (key, _) in enumerate(header))


def _cell(scene: Scene, key: str, unit: str, cell: str) -> Value | Fault:
    """Value of a cell, or its fault."""
    if not cell:
        return Fault(key, "an empty cell", "a value")
    number, kind = number_in(cell), kind_of(scene, {}, key)
    if number is None:
        overrides, faults = read_overrides([f"{key}={cell}"])
        if not faults and isinstance(kind, Quantity):
            faults = _faults_of(key, overrides[0].value, kind)
        return faults[0] if faults else overrides[0].value
    if not math.isfinite(number):
        return Fault(key, f"{shown(cell)} is not finite", "a finite number")
    if unit and unit != "1":
        return f"{cell.replace(',', '.')} {unit}"
    if not unit and isinstance(kind, Quantity):
        return Fault(key, f"{shown(cell)} has no unit", f"a unit, or in the header: {key} [{kind.example.split()[-1]}]")
    return int(cell) if re.fullmatch(r"[+-]?\d+", cell) else number
