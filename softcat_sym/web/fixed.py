"""What a page fixes of a scene, the numbers that its sliders move, and the law by which these follow from keys."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from softcat_sym.batch.members import kind_of, written
from softcat_sym.codegen.c_model import Structure
from softcat_sym.codegen.interface import Description
from softcat_sym.discretization.assembly import choose_body, choose_grid
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import Effects, choose_effects
from softcat_sym.errors import SceneError
from softcat_sym.estimates.scaling import initial_strain
from softcat_sym.generation import export, start_of
from softcat_sym.scene.history import History
from softcat_sym.scene.material import physical_path
from softcat_sym.scene.scene import Scene, force_free_stretch
from softcat_sym.scene.units import Quantity
from softcat_sym.solvers.initial_state import is_straight, starting_state
from softcat_sym.solvers.solve import Assembled, structure_for

_FEW_CELLS = 16
_SAME_START = 1e-7
"""Of the rest length: by what a starting shape may differ and still be the same."""


@dataclass(frozen=True)
class Fixed:
    """A scene with all that a page fixes: its effects by name, and its resolution."""

    scene: Scene
    origin: Fixed | None = None  # Of a moved scene, that of the page

    @cached_property
    def effects(self) -> Effects:
        """The physics in force."""
        return choose_effects(self.scene)

    @cached_property
    def exported(self) -> tuple[Description, Assembled]:
        """The filament, described for C and as CasADi has it."""
        return export(self.scene)

    @cached_property
    def structure(self) -> Structure:
        """What its C text depends on."""
        return structure_for(self.scene, self.effects)

    @cached_property
    def start(self) -> Floats | None:
        """Unknowns from which it begins, where it does not begin straight."""
        return start_of(*self.exported)

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """Names of the parameters in C, in their order."""
        return self.origin.parameters if self.origin else self.exported[0].model.parameters

    @property
    def names(self) -> list[str]:
        """Names of the numbers that follow the sliders: the parameters, and the thickness that is drawn."""
        return list(dict.fromkeys([*self.parameters, "thickness"]))

    @cached_property
    def numbers(self) -> dict[str, float]:
        """Values of these numbers."""
        values = parameter_values(self.scene)
        return {name: float(values[name]) for name in self.names}

    def moved(self, values: Mapping[str, float]) -> Fixed:
        """The same with some keys at other values, SI; refused as the scene would be."""
        return Fixed(self.scene.replace(written(self.scene, dict(values))), self)

    def differs(self, other: Fixed) -> str:
        """What of the C text of another one is not as here, in words; empty if they share it."""
        # Where the fibres are is a matter of resolution, which stays as it is.
        if other.structure.key != self.structure.key:
            return "it changes the equations, for which another solver would have to be compiled"
        stated = zip(*(_stated(one.scene, one.effects) for one in (self, other)), strict=True)
        if not all(np.shape(a) == np.shape(b) and np.allclose(a, b, rtol=1e-12) for a, b in stated):
            return "it changes what the filament begins with, which the solver has been compiled with"
        return ""

    def starts_elsewhere(self, other: Fixed) -> bool:
        """Whether another one begins in another shape."""
        if self.start is None:
            return not is_straight(other.scene)
        ours, theirs = (self._few_cells_start(one.scene) for one in (self, other))
        return ours is None or theirs is None or bool(np.max(np.abs(ours - theirs)) > _SAME_START)

    @cached_property
    def _few_cells(self) -> Assembled:
        """The same on few cells, for whether its start depends on a key."""
        return Fixed(self.scene.replace({"numerics.cells": _FEW_CELLS})).exported[1]

    def _few_cells_start(self, scene: Scene) -> Floats | None:
        """Unknowns with which another scene of the same equations begins."""
        filament = self._few_cells
        p = filament.graph.vector(parameter_values(scene))
        found = starting_state(scene, filament.graph, p, filament.at_rest)
        return None if found is None else np.concatenate([found.x, found.z])


def _stated(scene: Scene, effects: Effects) -> Sequence[Floats | tuple[float, ...] | float]:
    """Numbers that stand in the C text itself."""
    natural = choose_body(scene, choose_grid(scene, effects)).natural
    given = (initial_strain(scene), scene.initial.C, scene.filament.profile, () if natural is None else natural)
    return (*given, force_free_stretch(scene))


def attribute(scene: Scene, path: str) -> object:
    """What a scene holds at a dotted path; None of what it does not have."""
    if (known := scene.named_constants().get(path)) is not None:
        return known.value
    found: object = scene
    for name in path.split("."):
        found = getattr(found, name, None)
    return found


def value_of(scene: Scene, key: str) -> float | None:
    """Value of a key in SI, also of one that the scene gives in another way; None where it is no one number."""
    physical = physical_path(key)
    value = attribute(scene, physical)
    if isinstance(value, (History, bool)) or not isinstance(value, (int, float)):
        return None
    table, _, name = key.partition(".")
    given = getattr(scene, table).given().get(name) if table in scene.__class__.model_fields and name else None
    kind = kind_of(scene, {}, key)
    if isinstance(kind, Quantity) and isinstance(given, str):
        return kind.measured(given)
    if physical == key:
        return float(value)
    one = attribute(scene.replace(written(scene, {key: 1.0})), physical)
    return float(value) / one if isinstance(one, float) and one else None


def random_points(
    base: Fixed, ranges: Mapping[str, tuple[float, float, str]], count: int, seed: int = 0
) -> Iterator[tuple[dict[str, float], Fixed]]:
    """Draw points of the ranges that the scene accepts, at most so many."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        shares = random.random(len(ranges))
        point = {key: between(*one, float(share)) for (key, one), share in zip(ranges.items(), shares, strict=True)}
        try:
            yield point, base.moved(point)
        except SceneError:
            continue  # Together they make no sense, such as a filament thicker than its span.


def between(low: float, high: float, scale: str, share: float = 0.5) -> float:
    """The value at a share of a range."""
    if scale == "log":
        return float(low * (high / low) ** share)
    value = low + share * (high - low)
    # Amid a range about zero a power would say nothing.
    return value if value or share != 0.5 else high / 2


def share_of(low: float, high: float, scale: str, value: float) -> float:
    """The share of a range at which a value is."""
    return math.log(value / low) / math.log(high / low) if scale == "log" else (value - low) / (high - low)


_CLOSE = 1e-12
_HALVES = 1e-6
_MORE = 1.25


def exponents_of(base: Fixed, key: str) -> dict[str, float]:
    """Exponents of one key in each number, by what a little more of it makes of them; NaN of what has no power."""
    value = value_of(base.scene, key) or 0.0
    first, second = (base.moved({key: factor * value}).numbers for factor in (1.0, _MORE))
    found = {}
    for name, before in first.items():
        ratio = second[name] / before if before else math.nan if second[name] else 1.0
        exponent = math.log(ratio) / math.log(_MORE) if ratio > 0 else math.nan
        nearest = round(2 * exponent) / 2 if math.isfinite(exponent) else math.nan
        found[name] = nearest if abs(exponent - nearest) < _HALVES else exponent
    return {name: exponent for name, exponent in found.items() if exponent != 0}


@dataclass(frozen=True)
class Interpolation:
    """The logarithm of a number that is no product of powers, as a polynomial of the logarithms of the keys."""

    keys: tuple[str, ...]
    middles: tuple[float, ...]  # Of the ranges of their logarithms, and half of these ranges
    halves: tuple[float, ...]
    degrees: tuple[tuple[int, ...], ...]  # Of each term in the keys
    coefficients: tuple[float, ...]

    def at(self, values: Mapping[str, float]) -> float:
        """The number at some values of the keys."""
        place = (np.log([values[key] for key in self.keys]) - self.middles) / self.halves
        return math.exp(float(np.prod(place ** np.array(self.degrees), axis=1) @ self.coefficients))


_DEGREE, _SAMPLES, _VERIFIED = 4, 4, 30
"""Of a polynomial; points for each of its terms, and further points at which it is verified."""

_ERRS = 0.01
"""Median error of an interpolation that may be used. It is that of a loss that people know to a tenth."""


def interpolated(base: Fixed, name: str, ranges: Mapping[str, tuple[float, float, str]]) -> Interpolation | None:
    """Interpolate a number of a scene between the ends of some keys; None where that errs too much."""
    if not ranges or any(scale != "log" for _, _, scale in ranges.values()):
        return None
    low, high = np.log([[low, high] for low, high, _ in ranges.values()]).T
    middles, halves = (low + high) / 2, (high - low) / 2
    degrees = [one for one in itertools.product(range(_DEGREE + 1), repeat=len(ranges)) if sum(one) <= _DEGREE]
    points = list(random_points(base, ranges, _SAMPLES * len(degrees) + _VERIFIED, seed=2))
    places = (np.log([[*at.values()] for at, _ in points]) - middles) / halves
    terms = np.prod(places[:, None, :] ** np.array(degrees), axis=2)
    logs = np.log([moved.numbers[name] for _, moved in points])
    coefficients = np.linalg.lstsq(terms[_VERIFIED:], logs[_VERIFIED:], rcond=None)[0]
    if not np.median(np.abs(terms[:_VERIFIED] @ coefficients - logs[:_VERIFIED])) < _ERRS:
        return None
    rounded = tuple(float(f"{one:.6g}") for one in coefficients)
    return Interpolation(tuple(ranges), tuple(middles.tolist()), tuple(halves.tolist()), tuple(degrees), rounded)


def is_close(one: float, other: float) -> bool:
    """Whether two numbers are the same but for rounding."""
    return math.isclose(one, other, rel_tol=_CLOSE) and math.isfinite(one)
