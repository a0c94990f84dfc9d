"""The scene: all that is asked, in plain SI values."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Annotated, Any, Literal

from pydantic import ModelWrapValidatorHandler, ValidationInfo, model_validator
from pydantic_core import ValidationError

from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.consistency import faults_between_parts
from softcat_sym.scene.ends import Ends
from softcat_sym.scene.faults import fault_of
from softcat_sym.scene.filament import Filament
from softcat_sym.scene.groups import GroupBlock
from softcat_sym.scene.initial import Initial
from softcat_sym.scene.kinds import Choice, Text
from softcat_sym.scene.load import Load
from softcat_sym.scene.material import Material
from softcat_sym.scene.numerics import Numerics
from softcat_sym.scene.overriding import Override, apply
from softcat_sym.scene.part import Part, dotted, kinds_of
from softcat_sym.scene.resolving import Table, resolve_groups
from softcat_sym.scene.run import Run
from softcat_sym.scene.surroundings import Surroundings
from softcat_sym.scene.units import shown
from softcat_sym.scene.writing import toml_of

LATE = "late overrides"


class Scene(Part):
    """All that is asked of one run; frozen, every value plain SI.

    Build one with `load_scene`, or with ``Scene.model_validate`` from nested dicts whose quantities are text with a
    unit or pint quantities.

    Attributes
    ----------
    title : str
        For pictures and tables.
    model : str
        ``"filament"``.
    filament, material, ends, load, initial, surroundings, run, numerics : Part
        The tables of the scene file, under the file's own names.

    Raises
    ------
    SceneError
        With every fault at once.
    """

    title: Annotated[str, Text()] = ""
    """For pictures and tables."""
    model: Annotated[Literal["filament", "small-deflection"], Choice(("filament", "small-deflection"))] = "filament"
    """The theory: the filament with all its effects, or small deflections of an elastic or Maxwell one."""
    filament: Filament
    material: Material
    ends: Ends = Ends()
    load: Load = Load()
    initial: Initial = Initial()
    surroundings: Surroundings = Surroundings()
    run: Run
    numerics: Numerics = Numerics()

    @model_validator(mode="wrap")
    @classmethod
    def _list_every_fault(cls, data: Any, handler: ModelWrapValidatorHandler[Scene], info: ValidationInfo) -> Scene:
        if isinstance(data, Scene):
            return data
        resolved = resolve_groups(_as_table(data))
        late: tuple[Override, ...] = (info.context or {}).get(LATE, ())
        faults = [*resolved.faults, *apply(late, resolved.table)]
        for required in ("filament", "material", "run"):
            # So that each missing key is named, and not only its table.
            resolved.table.setdefault(required, {})
        try:
            scene = handler(resolved.table)
        except ValidationError as error:
            found = [fault_of(one, known_keys(), _accepted()) for one in error.errors()]
            own = [fault for fault in found if not resolved.excuses(fault)]
            faults += own if own or faults else found
            raise SceneError(faults) from None
        faults += faults_between_parts(scene)
        if faults:
            raise SceneError(faults)
        return scene

    @property
    def notes(self) -> tuple[str, ...]:
        """What was converted from other names or data, in all tables."""
        return tuple(note for part in (self.filament, self.material) for note in part.notes)

    def given(self) -> dict[str, object]:
        """Return the raw table as it was asked for, after `groups` were resolved."""
        table = super().given()
        for name in type(self).model_fields:
            part = getattr(self, name)
            if isinstance(part, Part):
                table[name] = part.given()
        return table

    def without_numerics(self) -> Scene:
        """The same scene at the program's own resolution: what does not depend on it is computed once."""
        return self.model_copy(update={"numerics": Numerics()})

    def replace(self, changes: Mapping[str, object]) -> Scene:
        """Return a scene with some values changed, validated anew.

        Parameters
        ----------
        changes : mapping of str to object
            ``{"numerics.cells": 40, "material.yield_stress": "5 kPa"}``; None takes a key out.

        Returns
        -------
        Scene
            What follows from a changed value (a width that was not given, say) follows again.

        Raises
        ------
        SceneError
            With every fault at once.
        """
        table = self.given()
        faults = [
            Fault(path, "a resolved scene has no groups", "load_scene(name, overrides), or physical values")
            for path in changes
            if path.split(".")[0] == "groups"
        ]
        faults += apply([Override(path, value) for path, value in changes.items()], table)
        if faults:
            raise SceneError(faults)
        return Scene.model_validate(table)

    def to_toml(self) -> str:
        """Write the scene as TOML in physical form with units; reading it again gives an equal scene."""
        return toml_of(self)


def _as_table(data: object) -> Table:
    if not isinstance(data, Mapping):
        raise SceneError([Fault("", f"{shown(data)} is not a table", "a mapping of tables, as in a scene file")])
    return {
        key: value.given() if isinstance(value, Part) else dict(value) if isinstance(value, Mapping) else value
        for key, value in data.items()
    }


@cache
def known_keys() -> dict[str, tuple[str, ...]]:
    """Return the keys of every table; ``""`` is the file itself."""
    tables = {"": (*Scene.model_fields, "groups")} | {
        name: tuple(part.model_fields) for name, part in parts_of_scene().items()
    }
    # Last, so that a misplaced key is sent to its physical table first.
    return tables | {"groups": tuple(GroupBlock.model_fields)}


@cache
def _accepted() -> dict[str, str]:
    parts: dict[str, type[Part]] = {"": Scene, **parts_of_scene()}
    kinds = ((table, name, kind) for table, part in parts.items() for name, kind in kinds_of(part).items())
    return {dotted(table, name): kind.accepted for table, name, kind in kinds}


def parts_of_scene() -> dict[str, type[Part]]:
    """Return the tables of the scene file by name, but for ``groups``."""
    annotations = {name: info.annotation for name, info in Scene.model_fields.items()}
    return {name: part for name, part in annotations.items() if isinstance(part, type) and issubclass(part, Part)}
