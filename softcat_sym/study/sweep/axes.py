"""What a sweep varies: ``KEY=a:b:n``, ``KEY=a:b:n:log``, ``KEY=v1,v2,v3``, or a sequence of values."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from softcat_sym.ensemble.grouped import is_group
from softcat_sym.ensemble.table import is_number, kind_of
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene
from softcat_sym.scene.kinds import Quantity, Whole
from softcat_sym.scene.laws import OF_THE_INDEX
from softcat_sym.scene.overriding import read_overrides
from softcat_sym.scene.units import NotAQuantity, shown, to_si

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
    """One key and its values.

    Attributes
    ----------
    key : str
        Dotted path in the scene.
    values : tuple
        In the order given; plain numbers are in SI.
    scale : str
        ``"log"`` where values are spaced evenly in their logarithm, otherwise ``"lin"``.
    ends : tuple of float, optional
        Of a range, in SI: what a Latin hypercube draws between. None for a list.
    """

    key: str
    values: tuple[Value, ...]
    scale: str = "lin"
    ends: tuple[float, float] | None = None

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
    """Read what is to be varied.

    Parameters
    ----------
    scene : Scene
        Whose keys they are.
    vary : mapping of str to sequence or str, or sequence of str
        Values, or text as on the command line, by key; or texts ``KEY=...``.
    drawn : bool
        Whether ends alone will do, as samples are drawn between them.

    Raises
    ------
    SceneError
        With every fault.
    """
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
    """Refuse text that is no quantity where one is needed: a slip, where a value out of range is a refused member.

    Raises
    ------
    SceneError
        With every such text.
    """
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
