"""A table of parameters as members: each row a scene with its effects, every fault listed before anything runs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from numbers import Real
from typing import Any, Literal, TypeGuard

import numpy as np
import numpy.typing as npt
import pandas as pd
from pydantic_core import to_json

from softcat_sym.effects.selection import (
    Effects,
    choose_effects,
    refuse_together,
    why_not,
)
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.groups import GROUND, RELATES, Relation, faults_of, relation_of, solve
from softcat_sym.scene.laws import OF_THE_INDEX, kind_of_constant
from softcat_sym.scene.material import shear_names
from softcat_sym.scene.parts import Part
from softcat_sym.scene.scene import Scene, refuse_settled
from softcat_sym.scene.units import (
    Kind,
    NotAQuantity,
    Number,
    Quantity,
    Whole,
    shown,
    si_unit,
    to_si_of_any,
    with_unit,
)
from softcat_sym.solvers.settings import Backend, choose_backend

SOURCE = "(rows of the table)"
_FORM = 'equally long sequences, {"material.yield_stress": [4e3, "5 kPa"]}, or a list of such rows'
_FRAMES = "run.frames"
_GROUPS = "groups."
_ROWS_NAMED, _FAULTS_LISTED = 4, 20

Row = dict[str, object]
Choosing = Literal["once", "each"]
Pattern = tuple[object, ...]
"""What a member has in common with others that can share its equations: its choices, which of its numbers are zero."""


def rows_of(parameters: Any) -> list[Row]:
    """The rows of a table: a mapping of columns, a structured array, a data frame or a sequence of rows."""
    if isinstance(parameters, (str, bytes)) or not hasattr(parameters, "__len__"):
        raise _refusal("", f"{shown(parameters)} is no table", _FORM)
    faults = []
    for number, row in enumerate(parameters if isinstance(parameters, Sequence) else ()):
        if not isinstance(row, Mapping):
            faults.append(Fault(f"row {number}", f"{shown(row)} is not a mapping of keys to values", _FORM))
        elif isinstance(parameters[0], Mapping) and set(row) != set(parameters[0]):
            odd = ", ".join(sorted(map(str, set(row) ^ set(parameters[0]))))
            faults.append(Fault(f"row {number}", f"its keys differ from those of row 0 by {odd}", "rows of equal keys"))
    if faults:
        raise SceneError(faults, SOURCE)
    try:
        table = pd.DataFrame(parameters, dtype=object)
    except ValueError as error:
        raise _refusal("", f"columns that make no table ({error})", _FORM) from None
    if table.empty:
        raise _refusal("", "a table without rows", _FORM)
    if _FRAMES in table:
        raise _refusal(_FRAMES, "given in the table, but members share their frames", "run.frames of the scene")
    plain = table.map(lambda value: value.item() if isinstance(value, np.generic) else value)
    return [{str(key): value for key, value in row.items()} for row in plain.to_dict("records")]


def _refusal(path: str, found: str, accepted: str) -> SceneError:
    return SceneError([Fault(path, found, accepted)], SOURCE)


def kind_of(scene: Scene, row: Row, key: str) -> Kind | None:
    """How the value of a key is read and written; None of an unknown key, or of the parameter of a custom law."""
    table, _, name = key.partition(".")
    part = getattr(scene, table, None) if table in type(scene).model_fields else None
    if not isinstance(part, Part):
        return scene.kinds().get(key)
    if table == "material" and name in OF_THE_INDEX:
        # Its unit depends on the index, which the row may change.
        index = row.get("material.index", scene.material.index)
        law = str(row.get("material.law", scene.material.law))
        return kind_of_constant(name, law, float(index) if isinstance(index, Real) else 1.0)
    return part.kinds().get(name)


def column_of(scene: Scene, key: str, values: Sequence[object]) -> tuple[npt.NDArray[Any], dict[str, str]]:
    """Values of a key as numbers in SI, with their unit, or as text; NaN is a value that cannot be read, or is none."""
    kind, unit = kind_of(scene, {}, key), "1"
    if isinstance(kind, Quantity):
        unit = kind.unit
    elif not (isinstance(kind, (Number, Whole)) or is_group(key) or all(map(is_number, values))):
        try:
            (dimension, *_) = [to_si_of_any(value)[1] for value in values]
        except NotAQuantity:
            return np.array(list(map(str, values))), {}
        unit = si_unit(dimension) or "1"

    def number(value: object) -> float:
        if is_number(value):
            return float(value)
        try:
            return kind.measured(value) if isinstance(kind, Quantity) else to_si_of_any(value)[0]
        except NotAQuantity:
            return math.nan

    return np.array(list(map(number, values))), {"units": unit}


def is_number(value: object) -> TypeGuard[Real]:
    """Whether a value is a plain number; a truth value is none."""
    return not isinstance(value, bool) and isinstance(value, Real)


def is_group(key: str) -> bool:
    """Whether a key belongs to the groups."""
    return key.startswith(_GROUPS)


def written(scene: Scene, row: Row) -> Row:
    """The values of a row as a scene file would give them: plain numbers get the SI unit of their key."""
    return {key: _written(scene, row, key, value) if is_number(value) else value for key, value in row.items()}


def _written(scene: Scene, row: Row, key: str, value: Real) -> object:
    kind = kind_of(scene, row, key)
    if isinstance(kind, Quantity):
        return kind.write(float(value))
    known = scene.named_constants().get(key)
    unit = si_unit(known.dimension) if known is not None else ""
    return f"{float(value)!r} {unit}" if unit else value


def constants_of(scene: Scene, row: Row) -> Row:
    """What the groups of a row set in a scene, as a scene file would give it."""
    groups = {key.removeprefix(_GROUPS): value for key, value in row.items() if is_group(key)}
    faults = [fault for key, value in groups.items() if (fault := _group_fault(key, value)) is not None]
    if scene.load.gravity == 0 and not faults:
        faults = [Fault("load.gravity", "zero, but the groups are measured by it", "a positive gravity")]
    if faults:
        raise SceneError(faults)
    numbers = {key: float(value) for key, value in groups.items() if is_number(value)}
    slenderness = numbers.pop("delta", None)
    constants: Row = {}
    if slenderness is not None:
        constants["filament.thickness"] = with_unit(slenderness * scene.filament.span, "m")
    material = scene.material
    names = material.spec.constants

    def kept(name: str) -> Relation:
        return Relation(f"material.{name}", name, GROUND, getattr(material, name))

    span, gravity = scene.filament.span, scene.load.gravity
    stress, time = scene.filament.density * gravity * span, math.sqrt(span / gravity)
    relations = [relation_of(key, value, stress, time, material.index) for key, value in numbers.items()]
    given = [name for name in names if {f"material.{key}" for key in (name, *shear_names(name))} & set(row)]
    relations += [kept(name) for name in given]
    for name in names:
        if name not in solve(relations):
            relations.append(kept(name))
    faults = faults_of(relations, material.law)
    if faults:
        raise SceneError(faults)
    for name, value in solve(relations).items():
        if name not in given and value != getattr(material, name):
            constants[f"material.{name}"] = kind_of_constant(name, material.law, material.index).write(value)
    return constants


def _group_fault(key: str, value: object) -> Fault | None:
    known = ("delta", *RELATES)
    if key not in known:
        accepted = f"{', '.join(known)}; times as run.duration and load.ramp, an index as material.index"
        return Fault(_GROUPS + key, "no group that a table can change", accepted)
    if not is_number(value) or not 0 < float(value) < math.inf:
        return Fault(_GROUPS + key, f"{shown(value)} is no positive number", "a positive number without a unit")
    return None


@dataclass(frozen=True)
class Member:
    """One row."""

    scene: Scene
    effects: Effects
    backend: Backend
    pattern: Pattern  # Equal for members whose equations are the same if their effects are


def members_of(scene: Scene, rows: Sequence[Row], choosing: Choosing) -> list[Member]:
    """Validate every row, and choose its effects; one error lists the faults of all rows."""
    maker, members = MemberMaker(scene, choosing), []
    faults: dict[Fault, list[int]] = {}
    for number, row in enumerate(rows):
        try:
            members.append(maker.member(row))
        except SceneError as error:
            for fault in error.faults:
                faults.setdefault(fault, []).append(number)
    if faults:
        listed = [
            Fault(f"{_named(rows)}: {fault.path}" if fault.path else _named(rows), fault.found, fault.accepted)
            for fault, rows in faults.items()
        ]
        more = len(listed) - _FAULTS_LISTED
        raise SceneError(listed[:_FAULTS_LISTED] + [Fault("", f"and {more} more faults", "")] * (more > 0), SOURCE)
    return members


def _named(rows: list[int]) -> str:
    if len(rows) == 1:
        return f"row {rows[0]}"
    first = ", ".join(map(str, rows[:_ROWS_NAMED]))
    return f"rows {first}" + (f" and {len(rows) - _ROWS_NAMED} more" if len(rows) > _ROWS_NAMED else "")


class MemberMaker:
    """Makes members of rows; what many rows share is worked out once.

    With `choosing` ``"once"`` the effects of the scene hold for all rows but those of other equations. These are chosen
    by the first such row for all, or by each for itself where a member must not depend on its `neighbours`.
    """

    def __init__(self, scene: Scene, choosing: Choosing, *, neighbours: bool = True) -> None:
        refuse_settled(scene, "members share their output times")
        self.scene, self._choosing, self._neighbours = scene, choosing, neighbours
        self._effects: dict[Pattern, Effects] = {}
        self._backends: dict[tuple[Pattern, tuple[str, ...]], Backend] = {}

    def member(self, row: Row) -> Member:
        """The member of a row."""
        scene = self._scene(row)
        pattern = pattern_of(scene, row)
        effects = self._chosen(scene, pattern, row)
        key = pattern, effects.names
        if key not in self._backends:
            self._backends[key] = choose_backend(scene, effects)
        return Member(scene, effects, self._backends[key], pattern)

    def _scene(self, row: Row) -> Scene:
        """The scene of a row."""
        plain = {key: value for key, value in written(self.scene, row).items() if not is_group(key)}
        scene = self.scene.replace(plain) if plain else self.scene
        return self.scene.replace(plain | constants_of(scene, row)) if len(plain) < len(row) else scene

    def _chosen(self, scene: Scene, pattern: Pattern, row: Row) -> Effects:
        if self._choosing == "each":
            return choose_effects(scene)
        if pattern not in self._effects:
            if pattern != pattern_of(self.scene, row):
                effects = choose_effects(scene)
                if self._neighbours:
                    self._effects[pattern] = effects
                return effects
            self._effects[pattern] = choose_effects(self.scene)
        # The effects were chosen for another scene.
        chosen = self._effects[pattern].in_force
        barred = [
            Fault("run.effects", f"{effect.name!r} cannot be had: {why_not(effect, scene)}", 'effects="each"')
            for effect in chosen
            if not effect.applies(scene)
        ]
        if barred:
            raise SceneError(barred)
        refuse_together(scene, chosen)
        return self._effects[pattern]


def pattern_of(scene: Scene, row: Row) -> Pattern:
    """What decides a member's equations, beyond its effects: choices as such, of numbers whether they are zero."""
    material, initial = scene.material, scene.initial
    pattern: list[object] = [material.threshold > 0, material.index == 1, initial.stretch == 1]
    for key in row:
        if is_group(key):
            continue
        table, _, name = key.partition(".")
        known = scene.named_constants().get(key)
        value: Any = known.value if known else getattr(getattr(scene, table), name) if name else getattr(scene, table)
        is_value = known is not None or isinstance(kind_of(scene, row, key), (Quantity, Number))
        pattern.append((key, not value if is_value else to_json(value, inf_nan_mode="constants")))
    return tuple(pattern)
