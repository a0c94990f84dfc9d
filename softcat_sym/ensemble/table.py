"""A table of parameters as members: each row a scene with its effects, every fault told before anything runs."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from numbers import Real
from typing import Any, Literal, TypeGuard, TypeVar, TypeVarTuple

import numpy as np

from softcat_sym.effects.choosing import Effects, choose_effects, refuse_closure, refuse_law, refuse_without, why_not
from softcat_sym.effects.forecast import outrunning_faults
from softcat_sym.effects.inertia import INERTIA
from softcat_sym.effects.surface_tension import SURFACE_TENSION, unstable_faults
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.groups import GROUND, RELATES, Relation, faults_of, solve
from softcat_sym.scene.material import CONSTANTS, OF_THE_INDEX, kind_of_constant, power, shear_names
from softcat_sym.scene.parts import Part
from softcat_sym.scene.scene import Scene, refuse_settled
from softcat_sym.scene.toml import Override, apply
from softcat_sym.scene.units import Dimension, Kind, Number, Quantity, shown, si_unit, with_unit
from softcat_sym.solvers.settings import Backend, choose_backend, settings_for

SOURCE = "(rows of the table)"
_FORM = 'equally long sequences, {"material.yield_stress": [4e3, "5 kPa"]}, or a list of such rows'
_FRAMES = "run.frames"

Row = dict[str, object]


def rows_of(parameters: object) -> list[Row]:
    """The rows of a table."""
    columns = _columns(parameters)
    lengths = {key: len(column) for key, column in columns.items()}
    if len(set(lengths.values())) > 1:
        found = ", ".join(f"{key} has {length}" for key, length in lengths.items())
        raise _refusal("", f"columns of unequal lengths: {found}", _FORM)
    if not columns or not next(iter(lengths.values())):
        raise _refusal("", "a table without rows", _FORM)
    if _FRAMES in columns:
        raise _refusal(_FRAMES, "given in the table, but members share their frames", "run.frames of the scene")
    return [dict(zip(columns, values, strict=True)) for values in zip(*columns.values(), strict=True)]


def written(scene: Scene, row: Row) -> Row:
    """The values of a row as a scene file would give them: plain numbers get the SI unit of their key."""
    return {key: _written(scene, row, key, value) for key, value in row.items()}


def kind_of(scene: Scene, row: Row, key: str) -> Kind | None:
    """How the value of a key is read and written; None of a key that is none, or of the parameter of a custom law."""
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


def is_number(value: object) -> TypeGuard[Real]:
    """Whether a value is a plain number; a truth value is none."""
    return not isinstance(value, bool) and isinstance(value, Real)


def _written(scene: Scene, row: Row, key: str, value: object) -> object:
    if not is_number(value):
        return value
    kind = kind_of(scene, row, key)
    if isinstance(kind, Quantity):
        return kind.write(float(value))
    *tables, name = key.split(".")
    if tables == ["material", "parameters"]:
        for known in scene.material.parameters:
            if known.name == name:
                return _in_si(float(value), known.dimension)
    return value


def _in_si(value: float, dimension: Dimension) -> object:
    unit = si_unit(dimension)
    return f"{value!r} {unit}" if unit else value


def _columns(parameters: object) -> dict[str, list[Any]]:
    names = getattr(getattr(parameters, "dtype", None), "names", None)
    if names:
        array = np.atleast_1d(np.asarray(parameters))
        return {str(name): _plain(name, array[name]) for name in names}
    if hasattr(parameters, "keys") and hasattr(parameters, "__getitem__"):
        return {str(key): _plain(key, parameters[key]) for key in parameters.keys()}  # noqa: SIM118
    if not isinstance(parameters, Sequence) or isinstance(parameters, str):
        raise _refusal("", f"{shown(parameters)} is no table", _FORM)
    faults = [
        Fault(f"row {number}", f"{shown(row)} is not a mapping of keys to values", _FORM)
        for number, row in enumerate(parameters)
        if not isinstance(row, Mapping)
    ]
    keys = [] if faults or not parameters else [str(key) for key in parameters[0]]
    for number, row in enumerate([] if faults else parameters):
        if set(row) != set(keys):
            odd = ", ".join(sorted(map(str, set(row) ^ set(keys))))
            faults.append(Fault(f"row {number}", f"its keys differ from those of row 0 by {odd}", "rows of equal keys"))
    if faults:
        raise SceneError(faults, SOURCE)
    return {key: [_item(row[key]) for row in parameters] for key in keys}


def _plain(key: object, column: Any) -> list[Any]:
    """A column of plain Python values."""
    if isinstance(column, (str, bytes, Mapping)) or not hasattr(column, "__len__") or np.ndim(column) == 0:
        raise _refusal(str(key), f"{shown(column)} is not a column", _FORM)
    return [_item(value) for value in column]


def _item(value: object) -> object:
    return (
        value.item() if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and not value.ndim) else value
    )


def _refusal(path: str, found: str, accepted: str) -> SceneError:
    return SceneError([Fault(path, found, accepted)], SOURCE)


TABLE = "groups."
_SLENDERNESS = "groups.delta"


def is_group(key: str) -> bool:
    """Whether a key belongs to the groups."""
    return key.startswith(TABLE)


def constants_of(scene: Scene, row: Row) -> Row:
    """What the groups of a row set in a scene, as a scene file would give it."""
    groups = {key.removeprefix(TABLE): value for key, value in row.items() if is_group(key)}
    faults = [fault for key, value in groups.items() if (fault := _fault(key, value)) is not None]
    if scene.load.gravity == 0 and not faults:
        faults = [Fault("load.gravity", "zero, but the groups are measured by it", "a positive gravity")]
    if faults:
        raise SceneError(faults)
    numbers = {key: float(value) for key, value in groups.items() if is_number(value)}
    slenderness = numbers.pop("delta", None)
    set_by_groups: Row = {}
    if slenderness is not None:
        set_by_groups["filament.thickness"] = with_unit(slenderness * scene.filament.span, "length")
    material, at = scene.material, _units(scene)
    relations = [Relation(TABLE + key, *RELATES[key], _ratio(key, value, at)) for key, value in numbers.items()]
    given = [
        name for name in CONSTANTS[material.law] if {f"material.{one}" for one in (name, *shear_names(name))} & set(row)
    ]
    relations += [_kept(scene, name) for name in given]
    for name in CONSTANTS[material.law]:
        if name not in solve(relations):
            relations.append(_kept(scene, name))
    faults = faults_of(relations, material.law)
    if faults:
        raise SceneError(faults)
    for name, value in solve(relations).items():
        if name not in given and value != getattr(material, name):
            set_by_groups[f"material.{name}"] = kind_of_constant(name, material.law, material.index).write(value)
    return set_by_groups


def _fault(key: str, value: object) -> Fault | None:
    known = ("delta", *RELATES)
    if key not in known:
        accepted = f"{', '.join(known)}; times as run.duration and load.ramp, an index as material.index"
        return Fault(TABLE + key, "no group that a table can change", accepted)
    if not is_number(value) or not 0 < float(value) < math.inf:
        return Fault(TABLE + key, f"{shown(value)} is no positive number", "a positive number without a unit")
    return None


def _units(scene: Scene) -> tuple[float, float, float]:
    """Stress rho g L [Pa], time sqrt(L/g) [s] and the index."""
    span, gravity = scene.filament.span, scene.load.gravity
    return scene.filament.density * gravity * span, math.sqrt(span / gravity), scene.material.index


def _ratio(key: str, group: float, at: tuple[float, float, float]) -> float:
    stress, time, index = at
    ratios = {
        "G": stress / group,
        "eps_Y": group,
        "E_star": stress * group,
        "V": stress * power(time, index) * group,
        "B": stress * time / (2 * group),
        "tau": time * group,
    }
    return ratios[key]


def _kept(scene: Scene, name: str) -> Relation:
    return Relation(f"material.{name}", name, GROUND, getattr(scene.material, name))


Choosing = Literal["once", "each"]

_NAMED = 4  # rows that a fault names
_LISTED = 20  # faults that an error lists

Given = TypeVarTuple("Given")
Made = TypeVar("Made")

# What a member has in common with others that can share its equations: its choices, and which of its numbers are zero.
Pattern = tuple[object, ...]


@dataclass(frozen=True)
class Member:
    """One row."""

    scene: Scene  # What is asked
    effects: Effects  # The physics in force
    backend: Backend  # What evaluates its right-hand side
    parallel: bool  # Whether it is integrated outside Python, so that threads do not wait for each other
    pattern: Pattern  # Equal for members whose equations are the same if their effects are


def members_of(scene: Scene, rows: Sequence[Row], choosing: Choosing) -> list[Member]:
    """Validate every row, and choose its effects."""
    refuse_settled(scene, "members share their output times")
    faults = _Faults()
    base = _Rows(scene)
    read = [faults.gather(number, base.scene, row) for number, row in enumerate(rows)]
    faults.refuse()
    scenes = [one for one in read if one is not None]
    chosen = _effects_of(scene, rows, scenes, choosing, faults)
    faults.refuse()
    members: list[Member] = []
    known: dict[tuple[Pattern, tuple[str, ...]], tuple[Backend, bool]] = {}
    for number, (one, (effects, pattern)) in enumerate(zip(scenes, chosen, strict=True)):
        key = pattern, effects.names
        if key not in known:
            found = faults.gather(number, _backend, one, effects)
            known[key] = found or (Backend(False, "none"), False)
        members.append(Member(one, effects, *known[key], pattern))
    faults.refuse()
    return members


def _effects_of(
    scene: Scene, rows: Sequence[Row], scenes: Sequence[Scene], choosing: Choosing, faults: _Faults
) -> list[tuple[Effects, Pattern]]:
    """Effects and pattern of every row that can have them."""
    patterns = [pattern_of(one, row) for one, row in zip(scenes, rows, strict=True)]
    known: dict[Pattern, Effects] = {}
    if pattern_of(scene, rows[0]) in patterns and choosing == "once":
        known[pattern_of(scene, rows[0])] = choose_effects(scene)
    found = []
    for number, (one, pattern) in enumerate(zip(scenes, patterns, strict=True)):
        effects = known.get(pattern) if choosing == "once" else None
        if effects is None:
            effects = faults.gather(number, choose_effects, one)
        else:
            faults.gather(number, _admit, one, effects)
        if effects is not None:
            known.setdefault(pattern, effects)
            found.append((effects, pattern))
    return found


def _backend(scene: Scene, effects: Effects) -> tuple[Backend, bool]:
    """What evaluates, and whether that integrates by itself."""
    backend = choose_backend(scene, effects)
    settings = settings_for(scene, effects, compiled=backend.compiled)
    return backend, backend.compiled and settings.solver == "rosenbrock"


class _Rows:
    """Scenes that differ from a base in some values; written out once, as that is what takes longest."""

    def __init__(self, scene: Scene) -> None:
        self._base, self._given = scene, scene.given()

    def scene(self, row: Row) -> Scene:
        """The scene of a row, validated as :meth:`Scene.replace` does."""
        plain = {key: value for key, value in written(self._base, row).items() if not is_group(key)}
        scene = self._replaced(plain) if plain else self._base
        if len(plain) < len(row):
            scene = self._replaced(plain | constants_of(scene, row))
        return scene

    def _replaced(self, changes: Row) -> Scene:
        table = copy.deepcopy(self._given)
        faults = apply([Override(key, value) for key, value in changes.items()], table)
        if faults:
            raise SceneError(faults)
        return Scene.model_validate(table)


def pattern_of(scene: Scene, row: Row) -> Pattern:
    """What decides a member's equations, beyond its effects: choices as such, of numbers whether they are zero."""
    material, initial = scene.material, scene.initial
    found: list[object] = [material.threshold > 0, material.index == 1, initial.stretch == 1]
    for key in row:
        if is_group(key):
            continue
        table, _, name = key.partition(".")
        value: Any = getattr(getattr(scene, table), name.partition(".")[0]) if name else getattr(scene, table)
        is_number = isinstance(kind_of(scene, row, key), (Quantity, Number)) or key.count(".") > 1
        found.append((key, not value if is_number else repr(value)))
    return tuple(found)


def _admit(scene: Scene, effects: Effects) -> None:
    """Refuse a scene that cannot have effects that were chosen for another one."""
    chosen = effects.in_force
    barred = [effect for effect in chosen if not effect.applies(scene)]
    if barred:
        raise SceneError(
            [
                Fault("run.effects", f"{one.name!r} cannot be had: {why_not(one, scene)}", 'effects="each"')
                for one in barred
            ]
        )
    refuse_law(scene)
    refuse_closure(scene, chosen)
    refuse_without(scene, chosen)
    faults = outrunning_faults(scene) if INERTIA in chosen else []
    faults += unstable_faults(scene) if SURFACE_TENSION in chosen else []
    if faults:
        raise SceneError(faults)


@dataclass
class _Faults:
    """Faults of rows, those that several rows share told once."""

    rows: dict[Fault, list[int]] = field(default_factory=dict)

    def gather(self, row: int, make: Callable[[*Given], Made], *given: *Given) -> Made | None:
        """What `make` returns; None, and a note of the faults, where it raises."""
        try:
            return make(*given)
        except SceneError as error:
            for fault in error.faults:
                self.rows.setdefault(fault, []).append(row)
            return None

    def refuse(self) -> None:
        """Raise what was gathered."""
        if not self.rows:
            return
        told = [
            Fault(f"{_named(rows)}: {fault.path}" if fault.path else _named(rows), fault.found, fault.accepted)
            for fault, rows in self.rows.items()
        ]
        rest = len(told) - _LISTED
        if rest > 0:
            told = [*told[:_LISTED], Fault("", f"and {rest} more faults", "")]
        raise SceneError(told, SOURCE)


def _named(rows: list[int]) -> str:
    if len(rows) == 1:
        return f"row {rows[0]}"
    shown = ", ".join(map(str, rows[:_NAMED]))
    return f"rows {shown}" + (f" and {len(rows) - _NAMED} more" if len(rows) > _NAMED else "")
