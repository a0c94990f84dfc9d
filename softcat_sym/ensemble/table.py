"""A table of parameters, however it is given, as one row of raw values for each member."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Real
from typing import Any, TypeGuard

import numpy as np

from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene
from softcat_sym.scene.kinds import Kind, Quantity
from softcat_sym.scene.laws import OF_THE_INDEX, kind_of_constant
from softcat_sym.scene.part import Part
from softcat_sym.scene.units import Dimension, shown, si_unit

SOURCE = "(rows of the table)"
_FORM = 'equally long sequences, {"material.yield_stress": [4e3, "5 kPa"]}, or a list of such rows'
_FRAMES = "run.frames"

Row = dict[str, object]


def rows_of(parameters: object) -> list[Row]:
    """The rows of a table.

    Parameters
    ----------
    parameters : mapping of str to sequence, sequence of mappings, or structured array
        By dotted keys of the scene. What has ``keys()``, such as a data frame, is a mapping.

    Raises
    ------
    SceneError
        If it is no table: columns of unequal lengths, rows of other keys, nothing in it.
    """
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
    """A column of plain Python values.

    Raises
    ------
    SceneError
        If it is a single value.
    """
    if isinstance(column, (str, bytes, Mapping)) or not hasattr(column, "__len__") or np.ndim(column) == 0:
        raise _refusal(str(key), f"{shown(column)} is not a column", _FORM)
    return [_item(value) for value in column]


def _item(value: object) -> object:
    return (
        value.item() if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and not value.ndim) else value
    )


def _refusal(path: str, found: str, accepted: str) -> SceneError:
    return SceneError([Fault(path, found, accepted)], SOURCE)
