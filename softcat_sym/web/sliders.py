"""Which keys of a scene get a slider, their ranges and units, and how the solver's numbers follow from them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from softcat_sym.batch.members import kind_of
from softcat_sym.batch.plan import read_range
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.material import twins
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import COMMON, Quantity, si_unit
from softcat_sym.web.fixed import (
    Fixed,
    Interpolation,
    between,
    exponents_of,
    interpolated,
    is_close,
    random_points,
    value_of,
)

SOURCE = "of a page"
FORM = "KEY, KEY=low:high or KEY=low:high:log, such as 'filament.span=3:9 mm:log'"

_MATERIAL: tuple[str, ...] = (
    "youngs_modulus",
    "storage_modulus",
    "viscosity",
    "shear_viscosity",
    "shear_consistency",
    "consistency",
)
_MATERIAL += ("yield_stress", "shear_yield_stress", "relaxation_time", "solvent_viscosity", "shear_solvent_viscosity")
_DEFAULT = (
    *(f"filament.{name}" for name in ("span", "diameter", "thickness", "density")),
    *(f"material.{name}" for name in _MATERIAL),
    "surroundings.surface_tension",
    "run.duration",
)
"""Keys that get a slider by themselves, where the scene gives them."""

_HALF, _DECADE = 2.0, math.sqrt(10.0)
_FACTORS = {f"filament.{name}": _HALF for name in ("span", "diameter", "thickness", "density")}
_UNUSUAL = {"cm", "km", "g/cm^3", "rad"}
_READ_WELL = 3.0  # times a value: the largest unit that is taken, so that 0.4 mm is not 400 um
_POINTS, _TRIES = 8, 200
ESTIMATED = "solid_viscosity"
"""What may be interpolated: the viscosity of a loss tangent, at the first frequency that 40 elements have."""

_ROUGHLY = 0.1
"""Largest error of an interpolation, at the ends of ranges; its median is a hundredth of that."""


@dataclass(frozen=True)
class Slider:
    """One key that moves, between two values in SI."""

    key: str
    name: str  # In words
    unit: str  # Which people use; empty of a pure number
    si: float  # One of it in SI
    low: float
    high: float
    scale: str  # ``log`` or ``linear``
    written: str  # Unit of its value in SI, as a scene file has it
    exponents: dict[str, float]  # Of the numbers that follow it, by their names

    @property
    def range(self) -> tuple[float, float, str]:
        """Its ends and their scale."""
        return self.low, self.high, self.scale

    def to_dict(self) -> dict[str, object]:
        """As the page has it: its ends in its unit."""
        ends = {"low": float(f"{self.low / self.si:.12g}"), "high": float(f"{self.high / self.si:.12g}")}
        about = {"key": self.key, "name": self.name, "unit": self.unit, "si": self.si}
        return {**about, **ends, "scale": self.scale, "written": self.written, "exponents": self.exponents}


@dataclass(frozen=True)
class Sliders:
    """All sliders of a page, and how numbers follow them: by powers, and by an interpolation where there is one."""

    each: tuple[Slider, ...] = ()
    interpolations: Mapping[str, Interpolation] = field(default_factory=dict)

    def values(self, scene: Scene) -> dict[str, float | None]:
        """Values of their keys in a scene, by key."""
        return {slider.key: value_of(scene, slider.key) for slider in self.each}

    def number(self, name: str, coefficient: float, at: Mapping[str, float]) -> float:
        """A number by its law."""
        interpolation = self.interpolations.get(name)
        # Zero to a negative power is what no number of a scene equals.
        with np.errstate(divide="ignore", invalid="ignore"):
            for slider in self.each:
                coefficient *= float(np.power(at.get(slider.key, 1.0), slider.exponents.get(name, 0.0)))
        return coefficient * (interpolation.at(at) if interpolation else 1.0)

    def middle_of(self, base: Fixed) -> Fixed:
        """The scene with all sliders amid their ranges, or as it stands where that makes no sense."""
        moved = moved_to(base, {slider.key: between(*slider.range) for slider in self.each})
        return base if isinstance(moved, str) else moved

    def coefficients(self, base: Fixed) -> dict[str, float]:
        """What the powers of the keys are multiplied by, at values where none of them is zero."""
        middle = self.middle_of(base)
        at = {key: value for key, value in self.values(middle.scene).items() if value is not None}
        return {name: value / self.number(name, 1.0, at) for name, value in middle.numbers.items()}

    def follows(self, name: str, coefficient: float, at: Mapping[str, float], moved: Fixed) -> bool:
        """Whether a number of a scene at other values is as its law has it."""
        found, expected = self.number(name, coefficient, at), moved.numbers[name]
        if name in self.interpolations:
            return math.isclose(found, expected, rel_tol=_ROUGHLY)
        return is_close(found, expected)

    def lost(self, base: Fixed, names: Iterable[str]) -> list[str]:
        """Those of some numbers that do not follow the sliders, at random points and at the ends of each."""
        coefficients = self.coefficients(base)
        drawn = random_points(base, {slider.key: slider.range for slider in self.each}, _TRIES)
        points = [point for point, _ in zip(drawn, range(_POINTS), strict=False)]
        middle = {key: value or 0.0 for key, value in self.values(self.middle_of(base).scene).items()}
        ends = ({**middle, slider.key: end} for slider in self.each for end in (slider.low, slider.high))
        points += [(point, moved) for point in ends if isinstance(moved := moved_to(base, point), Fixed)]
        return [name for name in names if not all(self.follows(name, coefficients[name], *point) for point in points)]


def choose_sliders(base: Fixed, asked: Sequence[str] = ()) -> Sliders:
    """Choose the sliders of a page: what matters by default, and what is asked for.

    Parameters
    ----------
    base : Fixed
        What the page fixes of its scene.
    asked : sequence of str
        Further keys, or other ranges, as ``KEY=low:high[:log]``; ``KEY`` alone takes the default range.

    Returns
    -------
    Sliders
        Those by default first.

    Raises
    ------
    SceneError
        Of a key that is asked for and cannot be a slider: why not, and which can.
    """
    named = _read(base.scene, asked)
    overruled = {twin for key in named for twin in twins(key)}
    usual = [key for key in _DEFAULT if key not in overruled and (key in named or _is_given(base.scene, key))]
    found, faults = dict[str, Slider](), dict[str, str]()
    for key in (*usual, *(key for key in named if key not in usual)):
        slider = _ranged(base, key, named.get(key))
        why = slider if isinstance(slider, str) else _obstacle(base, slider)
        if isinstance(slider, Slider) and not why:
            found[key] = slider
        elif key in named:
            faults[key] = why
    sliders = _with_powers(base, found, named, faults)
    if faults:
        can = (
            f"{FORM}; here {', '.join(slider.key for slider in sliders.each)} can be sliders" if sliders.each else FORM
        )
        raise SceneError([Fault(key, why, can) for key, why in faults.items()], SOURCE)
    return sliders


def _read(scene: Scene, asked: Sequence[str]) -> dict[str, tuple[float, float, str] | None]:
    """What is asked for: ends and scale of each key, None where only the key is named."""
    named, faults = dict[str, tuple[float, float, str] | None](), list[Fault]()
    for text in asked:
        key, equals, ends = (part.strip() for part in text.partition("="))
        try:
            if key in named or not key or (equals and not ends):
                found = "named twice" if key in named else f"{text!r} names no slider"
                raise SceneError([Fault(key or "--slider", found, FORM)])
            axis = read_range(scene, key, ends, drawn=True, accepted=FORM) if equals else None
            low, high = sorted(axis.ends) if axis is not None and axis.ends is not None else (0.0, 0.0)
            named[key] = None if axis is None else (low, high, "log" if axis.scale == "log" else "linear")
        except SceneError as error:
            faults += error.faults
    if faults:
        raise SceneError(faults, SOURCE)
    return named


def _is_given(scene: Scene, key: str) -> bool:
    table, _, name = key.partition(".")
    return name in getattr(scene, table).given()


def _ranged(base: Fixed, key: str, asked: tuple[float, float, str] | None) -> Slider | str:
    """A slider without exponents, or why there is none."""
    scene, (table, _, name) = base.scene, key.partition(".")
    if (table in ("run", "numerics") and key != "run.duration") or not name:
        return "it says how the filament is computed"
    value = value_of(scene, key)
    if value is None:
        return "it is no number of this scene, or one that changes in time"
    unit, factor, written = _unit(scene, key, value)
    if asked is None:
        if value <= 0:
            return f"it is {value:g} here: there is no range by default"
        by = _FACTORS.get(key, _DECADE)
        ends = (_rounded(value / by / factor, up=False) * factor, _rounded(value * by / factor, up=True) * factor)
        low, high = (_clipped(base, key, end, value, factor) for end in ends)
        asked = (low, high, "log")
    words = "diameter" if name == "thickness" and scene.filament.section == "circle" else name.replace("_", " ")
    words = (
        f"{words.removeprefix('shear ')} in shear" if words.startswith("shear ") else words.replace("youngs", "Young's")
    )
    return Slider(key, words, unit, factor, *asked, written, {})


def _unit(scene: Scene, key: str, value: float) -> tuple[str, float, str]:
    """Unit in which people read a value, its size, and the SI unit that a scene file has."""
    kind, known = kind_of(scene, {}, key), scene.named_constants().get(key)
    written = si_unit(known.dimension) if known is not None else ""
    if isinstance(kind, Quantity):
        written = kind.unit
    if written not in COMMON:
        return written, 1.0, written
    alike = {unit: size for unit, (size, of) in COMMON.items() if of == COMMON[written][1] and unit not in _UNUSUAL}
    reached = [unit for unit, size in alike.items() if size <= _READ_WELL * abs(value)]
    unit = max(reached or [min(alike, key=alike.__getitem__)], key=alike.__getitem__) if value else written
    return unit, COMMON[unit][0], written


def _rounded(value: float, *, up: bool) -> float:
    """The next of 1, 2 and 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    steps = [step * power for step in (1.0, 2.0, 5.0, 10.0)]
    slack = 1e-9 * value
    found = min(one for one in steps if one >= value - slack) if up else max(s for s in steps if s <= value + slack)
    return float(f"{found:.12g}")


def _clipped(base: Fixed, key: str, end: float, value: float, factor: float) -> float:
    """An end of a range moved towards the scene's value, from one round number to the next, until it is accepted."""
    while (end - value) * (1 if end > value else -1) > 0 and isinstance(moved_to(base, {key: end}), str):
        end = _rounded(end / factor * (0.9 if end > value else 1.1), up=end < value) * factor
    return float(f"{end:.12g}")


def moved_to(base: Fixed, values: Mapping[str, float]) -> Fixed | str:
    """The scene at other values, or why it refuses them."""
    try:
        moved = base.moved(values)
        moved.effects.terms()
    except SceneError as error:
        return "; ".join(fault.found for fault in error.faults)
    return moved


def _obstacle(base: Fixed, slider: Slider) -> str:
    """Why a key cannot be moved within its range; empty if it can."""
    if slider.low >= slider.high:
        return "the scene accepts no other value of it"
    for value in (slider.low, slider.high, between(*slider.range)):
        moved = moved_to(base, {slider.key: value})
        if isinstance(moved, str):
            return f"{value / slider.si:.4g} {slider.unit}".strip() + f" is refused: {moved}"
        if why := base.differs(moved):
            return why
        if base.starts_elsewhere(moved):
            return "it changes the shape that the filament begins with, which was computed for the scene's own value"
    return ""


def _with_powers(
    base: Fixed, found: Mapping[str, Slider], named: Mapping[str, object], faults: dict[str, str]
) -> Sliders:
    """Give sliders their exponents; those that numbers do not follow are left out, and are faults if asked for."""
    kept = dict(found)
    while kept:
        sliders = Sliders(tuple(kept.values()))
        middle = sliders.middle_of(base)
        powers = (replace(one, exponents=exponents_of(middle, one.key)) for one in sliders.each)
        sliders = _interpolating(base, Sliders(tuple(powers)))
        wrong = _wrong(base, sliders)
        if not wrong:
            return sliders
        # What was asked for goes last.
        key = max(wrong, key=lambda one: one not in named)
        if key in named:
            faults[key] = wrong[key]
        del kept[key]
    return Sliders()


def _interpolating(base: Fixed, sliders: Sliders) -> Sliders:
    """The same with a number interpolated that is itself an estimate and that they do not follow."""
    ranges = {one.key: one.range for one in sliders.each if ESTIMATED in one.exponents}
    if ESTIMATED not in base.parameters or not sliders.lost(base, [ESTIMATED]):
        return sliders
    try:
        found = interpolated(base, ESTIMATED, ranges)
    except SceneError:
        found = None  # Somewhere in the ranges there is no stable shape, and no frequency.
    if found is None:
        return sliders
    others = ({name: power for name, power in one.exponents.items() if name != ESTIMATED} for one in sliders.each)
    each = (replace(one, exponents=powers) for one, powers in zip(sliders.each, others, strict=True))
    return Sliders(tuple(each), {ESTIMATED: found})


def _wrong(base: Fixed, sliders: Sliders) -> dict[str, str]:
    """Sliders that the numbers of a page do not follow by a power, or not at all, and why."""
    for slider in sliders.each:
        if slider.key != "run.duration" and not any(name in slider.exponents for name in base.parameters):
            return {slider.key: "no number of the solver depends on it, with these effects"}
    for name in sliders.lost(base, base.numbers):
        movers = {one.key: one.exponents[name] for one in sliders.each if name in one.exponents}
        if name in sliders.interpolations:
            movers = dict.fromkeys(sliders.interpolations[name].keys, 1.0)
        uneven = [key for key, power in movers.items() if 2 * power % 1 != 0]
        # Of a sum of two keys neither is a power; of what is left both are to blame, the last goes.
        return dict.fromkeys(uneven or [*movers][-1:], f"{name} is no product of powers with it")
    return {}
