"""What an experimenter may choose: span, thickness, frame rate and duration, each within bounds or fixed."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Real

from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene
from softcat_sym.scene.faults import did_you_mean
from softcat_sym.scene.units import NotAQuantity, shown, to_si

SPAN, THICKNESS, FRAME_RATE, DURATION = "filament.span", "filament.thickness", "frame_rate", "run.duration"
VARIABLES = (SPAN, THICKNESS, FRAME_RATE, DURATION)
UNITS = {SPAN: "m", THICKNESS: "m", FRAME_RATE: "1/s", DURATION: "s"}

_KINDS = {SPAN: "length", THICKNESS: "length", FRAME_RATE: "frequency", DURATION: "time"}
_EXAMPLES = {SPAN: "20 mm", THICKNESS: "2 mm", FRAME_RATE: "100 Hz", DURATION: "5 s"}
_SAME = 1e-9

Within = Mapping[str, object]


@dataclass(frozen=True, slots=True)
class Range:
    """Bounds of one design variable.

    Attributes
    ----------
    path : str
        One of `VARIABLES`.
    low, high : float
        SI; equal if it is fixed.
    """

    path: str
    low: float
    high: float

    @property
    def is_fixed(self) -> bool:
        """Whether there is nothing to choose."""
        return self.low == self.high

    def snapped(self, value: float) -> float:
        """The value, or the bound that it lies at but for rounding, or beyond."""
        bound = self.bound_at(value)
        return self.low if self.is_fixed or bound == "lower" else self.high if bound else value

    def bound_at(self, value: float) -> str:
        """Name the bound at which a value lies: ``"lower"``, ``"upper"``, or empty."""
        if self.is_fixed:
            return ""
        if value <= self.low * (1 + _SAME):
            return "lower"
        return "upper" if value >= self.high * (1 - _SAME) else ""


def as_given(scene: Scene) -> dict[str, float]:
    """The design variables of the scene as it is [SI]; its frames are those of the camera."""
    run, filament = scene.run, scene.filament
    rate = (run.frames - 1) / run.duration
    return {SPAN: filament.span, THICKNESS: filament.thickness, FRAME_RATE: rate, DURATION: run.duration}


def read_ranges(scene: Scene, within: Within) -> dict[str, Range]:
    """Read the bounds of an experiment.

    Parameters
    ----------
    scene : Scene
        What is not named keeps its value.
    within : mapping
        A pair ``("2 mm", "50 mm")`` by dotted path or leaf name, or one value that it is fixed at; text with a unit, or
        numbers in SI.

    Returns
    -------
    dict of str to Range
        One for each of `VARIABLES`.

    Raises
    ------
    SceneError
        With every variable that is unknown and every bound that makes no sense.
    """
    leaves = {path.rpartition(".")[2]: path for path in VARIABLES}
    ranges = {path: Range(path, value, value) for path, value in as_given(scene).items()}
    faults = []
    for name, bounds in within.items():
        path = leaves.get(name, name)
        if path not in VARIABLES:
            hint = did_you_mean(name, VARIABLES)
            faults.append(Fault(f"within {name}", f"no design variable{hint}", ", ".join(VARIABLES)))
            continue
        try:
            ranges[path] = _range(path, bounds)
        except NotAQuantity as error:
            faults.append(Fault(f"within {path}", str(error), _accepted(path)))
    if not faults and not ranges[THICKNESS].low < ranges[SPAN].high:
        found = f"{ranges[THICKNESS].low:g} m or more, and no span above {ranges[SPAN].high:g} m"
        faults.append(Fault(f"within {THICKNESS}", found, "a thickness below the span"))
    if faults:
        raise SceneError(faults)
    return ranges


def read_positive(value: object, kind: str, unit: str) -> float:
    """Read a positive quantity: text with a unit, or a number in SI.

    Raises
    ------
    NotAQuantity
        Its text says what was found.
    """
    if isinstance(value, (int, float, Real)) and not isinstance(value, bool):
        number = float(value)
        if not math.isfinite(number):
            raise NotAQuantity(f"{shown(value)} is not finite")
    else:
        number = to_si(value, kind, unit)
    if number <= 0:
        raise NotAQuantity(f"{shown(value)} is not positive")
    return number


def read_share(value: object) -> float | None:
    """Read a percentage such as ``"1 %"`` as a fraction; None if it is none.

    Raises
    ------
    NotAQuantity
        If it is no positive one. Its text says what was found.
    """
    found = re.fullmatch(r"\s*([^%]*?)\s*%\s*", value) if isinstance(value, str) else None
    if found is None:
        return None
    try:
        share = float(found[1]) / 100
    except ValueError:
        raise NotAQuantity(f"{shown(value)} is no percentage") from None
    if not 0 < share < math.inf:
        raise NotAQuantity(f"{shown(value)} is not positive and finite")
    return share


def _range(path: str, bounds: object) -> Range:
    kind, unit = _KINDS[path], UNITS[path]
    if not isinstance(bounds, (tuple, list)):
        value = read_positive(bounds, kind, unit)
        return Range(path, value, value)
    if len(bounds) != 2:
        raise NotAQuantity(f"{len(bounds)} values")
    low, high = (read_positive(bound, kind, unit) for bound in bounds)
    if low > high:
        raise NotAQuantity(f"{shown(bounds[0])} is above {shown(bounds[1])}")
    return Range(path, low, high)


def _accepted(path: str) -> str:
    example = _EXAMPLES[path]
    return f'a positive {_KINDS[path]} such as "{example}", or a pair of them, the lower one first'
