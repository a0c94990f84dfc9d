"""A range of a key as text, ``filament.span=5:50 mm:10:log``: what a sweep varies, and between what a slider goes."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from softcat_sym.ensemble.members import is_group, kind_of
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import NotAQuantity, Quantity, Whole, shown

MAX_MEMBERS: Final = 10_000_000
Value = object

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
        raise refusal(key, f"{shown(text)} is no range", accepted)
    count = int(parts[2])
    low, high = _ends(scene, key, parts[:2], accepted)
    if scale == "log" and not (low > 0 and high > 0):
        raise refusal(key, f"{shown(text)} is logarithmic, and not positive", accepted)
    if low == high:
        raise refusal(key, f"both ends of {shown(text)} are the same", accepted)
    spaced = np.geomspace(low, high, count) if scale == "log" else np.linspace(low, high, count)
    # Twelve digits: what rounding adds would end up in tables.
    values: list[Value] = [float(f"{value:.12g}") for value in spaced]
    if isinstance(kind_of(scene, {}, key), Whole):
        values = [round(float(value)) for value in spaced]
        if low != round(low) or high != round(high) or (len(set(values)) < count and not drawn):
            raise refusal(key, f"{shown(text)} does not give {count} whole numbers", "whole ends, and fewer values")
    return SweepAxis(key, tuple(values), scale, (low, high))


def _ends(scene: Scene, key: str, ends: Sequence[str], accepted: str) -> list[float]:
    """The two ends of a range as numbers, quantities in SI; the first may have the unit of the second."""
    kind = kind_of(scene, {}, key)
    if not isinstance(kind, Quantity):
        try:
            numbers = [float(end) for end in ends]
        except ValueError:
            name = key if is_group(key) or kind is None else f"{key}, which is {kind.accepted}"
            raise refusal(key, f"{shown(':'.join(ends))} are no plain numbers", f"plain numbers for {name}") from None
        if not all(map(math.isfinite, numbers)):
            raise refusal(key, f"{shown(':'.join(ends))} is not finite", accepted)
        return numbers
    texts = [end if unit_of(end) else f"{end} {unit_of(ends[1])}".strip() for end in ends]
    try:
        return [kind.measured(text) for text in texts]
    except NotAQuantity as error:
        raise refusal(key, str(error), kind.accepted) from None


def unit_of(text: str) -> str:
    """The unit at the end of a quantity as text; empty without one."""
    match = _UNIT.match(text)
    return match[2] if match else ""


def refusal(key: str, found: str, accepted: str) -> SceneError:
    """The error of one key that cannot be varied so."""
    return SceneError([Fault(key, found, accepted)], SOURCE)
