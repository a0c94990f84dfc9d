"""Scene to TOML: physical form, SI units, exact numbers."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from softcat_sym.scene.filament import Filament
from softcat_sym.scene.material import Material
from softcat_sym.scene.part import Part
from softcat_sym.scene.shear_data import INDEXED

if TYPE_CHECKING:
    from softcat_sym.scene.model import Scene


_IDLE_AT_ZERO = {"load": ("shake", "shake_frequency"), "material": ("loss_tangent",)}
"""Keys that say nothing where they are zero."""


def toml_of(scene: Scene, *, every_default: bool = False) -> str:
    """Write a scene so that reading it again gives an equal one.

    Parameters
    ----------
    scene : Scene
        Any scene.
    every_default : bool
        Whether keys that say nothing are written too: an empty list, no shaking; in a comment what has no value.

    Returns
    -------
    str
        TOML; every number is the shortest text that reads back to the same float.
    """
    lines = ["# The scene as resolved: physical values, SI units.", *_table_lines(scene, every_default)]
    for name in type(scene).model_fields:
        part = getattr(scene, name)
        if isinstance(part, Part):
            written = _table_lines(part, every_default)
            if written:
                lines += ["", f"[{name}]", *written]
    return "\n".join([*lines, ""])


def _table_lines(part: Part, every_default: bool) -> list[str]:
    kinds = part.kinds()
    follows = part.follows() if isinstance(part, Filament) else {}
    lines = []
    for name, value in part.physics().items():
        if name not in kinds or (not every_default and _is_idle(part, name, value)):
            continue
        if value is None:
            # A constant that is not there is none of the law's.
            if every_default and not isinstance(part, Material):
                lines.append(f"# {name}: {type(part).model_fields[name].description}")
            continue
        if name in follows:
            # As a comment, so that an override of the one it follows still carries it along.
            lines.append(f"# {name} = {follows[name]}")
        else:
            lines.append(f"{name} = {toml_value(kinds[name].write(value))}")
    if part.table_name:
        lines += [f"# {note}" for note in part.notes]
    return lines


def _is_idle(part: Part, name: str, value: object) -> bool:
    """Tell whether a key says nothing: an empty list, the index of a law that has none, no shaking."""
    if isinstance(part, Material) and name == "index":
        return part.law not in INDEXED
    if name in _IDLE_AT_ZERO.get(part.table_name, ()):
        return value == 0
    if part.table_name == "run" and name == "until":
        return value == "duration"
    return bool(part.table_name) and value in ((), "") and value == type(part).model_fields[name].default


def toml_value(value: object) -> str:
    """Write a raw value as TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        # JSON strings are TOML basic strings but for DEL, which TOML wants escaped.
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(toml_value(item) for item in value)}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key} = {toml_value(item)}' for key, item in value.items())}}}"
    return repr(value)
