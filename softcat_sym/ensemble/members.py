"""From a table to members: each row a scene with its effects, every fault told before anything runs."""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeVar, TypeVarTuple

from softcat_sym.effects import Effects, choose_effects
from softcat_sym.effects.inertia import INERTIA
from softcat_sym.effects.outrunning import outrunning_faults
from softcat_sym.effects.refusing import refuse_closure, refuse_law, refuse_without, why_not
from softcat_sym.ensemble.grouped import constants_of, is_group
from softcat_sym.ensemble.table import SOURCE, Row, kind_of, written
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene
from softcat_sym.scene.consistency import refuse_settled
from softcat_sym.scene.kinds import Number, Quantity
from softcat_sym.scene.overriding import Override, apply
from softcat_sym.solve import Backend, choose_backend, settings_for

Choosing = Literal["once", "each"]

_NAMED = 4  # rows that a fault names
_LISTED = 20  # faults that an error lists

Given = TypeVarTuple("Given")
Made = TypeVar("Made")

# What a member has in common with others that can share its equations: its choices, and which of its numbers are zero.
Pattern = tuple[object, ...]


@dataclass(frozen=True)
class Member:
    """One row.

    Attributes
    ----------
    scene : Scene
        What is asked.
    effects : Effects
        The physics in force.
    backend : Backend
        What evaluates its right-hand side.
    parallel : bool
        Whether it is integrated outside Python, so that threads do not wait for each other.
    pattern : tuple
        Equal for members whose equations are the same if their effects are.
    """

    scene: Scene
    effects: Effects
    backend: Backend
    parallel: bool
    pattern: Pattern


def members_of(scene: Scene, rows: Sequence[Row], choosing: Choosing) -> list[Member]:
    """Validate every row, and choose its effects.

    Parameters
    ----------
    scene : Scene
        What the rows change.
    rows : sequence of dict
        Raw values by dotted key.
    choosing : str
        ``"once"``: effects of the base scene, but anew for the first row of another pattern (another law, another end,
        a number that is zero or no longer); ``"each"``: effects of every row.

    Raises
    ------
    SceneError
        With every fault at once, and the rows that have it.
    """
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
    """Refuse a scene that cannot have effects that were chosen for another one.

    Raises
    ------
    SceneError
        If it cannot have one of them, cannot do without another one, or outruns them.
    """
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
    outrun = outrunning_faults(scene) if INERTIA in chosen else []
    if outrun:
        raise SceneError(outrun)


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
        """Raise what was gathered.

        Raises
        ------
        SceneError
            If that is anything.
        """
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
