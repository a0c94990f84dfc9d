"""A scene as TOML in physical form, SI units and exact numbers; and overrides of single values."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from softcat_sym.errors import Fault
from softcat_sym.scene.bodies import Body
from softcat_sym.scene.extrusion import Extrusion
from softcat_sym.scene.material import Material, twins
from softcat_sym.scene.parts import Filament, Part, meanings_of
from softcat_sym.scene.temperature_table import Temperature
from softcat_sym.scene.units import shown

_FORM = "dotted.key=value, such as material.yield_stress=5 kPa"


@dataclass(frozen=True, slots=True)
class Override:
    """One value to set; None takes the key out."""

    path: str
    value: object


def read_overrides(overrides: Mapping[str, object] | Sequence[str]) -> tuple[list[Override], list[Fault]]:
    """Read overrides as the command line gives them."""
    if isinstance(overrides, Mapping):
        pairs = [(str(path), _value(value) if isinstance(value, str) else value) for path, value in overrides.items()]
        return [Override(path, value) for path, value in pairs], []
    read: list[Override] = []
    faults: list[Fault] = []
    for text in [overrides] if isinstance(overrides, str) else overrides:
        path, equals, given = text.partition("=")
        override = Override(path.strip(), _value(given))
        if not equals or not override.path:
            faults.append(Fault("--set", f"{shown(text)} sets nothing", _FORM))
        elif override.value == {} and "." not in override.path:
            faults.append(Fault(override.path, "an empty table, which would drop every key", "table.key=value"))
        else:
            read.append(override)
    return read, faults


_ROUND = ("filament.diameter", "filament.line_width")


def apply(overrides: Iterable[Override], table: dict[str, Any]) -> list[Fault]:
    """Set the values in a raw table, in place."""
    faults = []
    for override in overrides:
        *tables, key = override.path.split(".")
        here: Any = table if all((*tables, key)) else None
        for name in tables:
            here = here.setdefault(name, {}) if isinstance(here, dict) else None
        if not isinstance(here, dict):
            faults.append(Fault(override.path, "leads to no key", "table.key, as in the scene file"))
        elif override.value is None:
            here.pop(key, None)
        else:
            here[key] = override.value
            # The same quantity given the other way: overruled, or it would be given twice.
            for twin in twins(override.path):
                if here.pop(twin.partition(".")[2], None) is not None and twin in _ROUND:
                    # What was round stays so.
                    here.setdefault("section", "circle")
    return faults


def _value(text: str) -> object:
    try:
        parsed = tomllib.loads(f"value = {text.strip()}")
    except (ValueError, RecursionError):
        return text.strip()
    # More than one key: the text went on to a second line of its own.
    return parsed["value"] if set(parsed) == {"value"} else text.strip()


_IDLE = {
    "filament": ("twist",),
    "ends": ("right_slides",),
    "load": ("shake", "shake_frequency", "direction", "tip_mass", "tip_force", "tip_torque"),
    "material": ("loss_tangent", "natural_strain", "natural_strain_difference"),
    "surroundings": ("density", "viscosity"),
    "run": ("until", "dimensions"),
}
"""Keys that say nothing at their defaults."""


def toml_of(scene: Part, *, every_default: bool = False) -> str:
    """Write a scene so that reading it again gives an equal one."""
    lines = ["# The scene as resolved: physical values, SI units.", *_table_lines(scene, every_default)]
    for name in type(scene).model_fields:
        part = getattr(scene, name)
        if isinstance(part, Part):
            written = _table_lines(part, every_default)
            if written:
                lines += ["", f"[{name}]", *written]
    return "\n".join([*lines, ""])


_ABSENT = (Body, Extrusion)
"""Tables that a scene may be without, of which the keys then are comments."""


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
                lines.append(f"# {name}: {meanings_of(type(part))[name]}")
            continue
        if name in follows:
            # As a comment, so that an override of the one it follows still carries it along.
            lines.append(f"# {name} = {follows[name]}")
        else:
            absent = "# " if isinstance(part, _ABSENT) and not part.present else ""
            lines.append(f"{absent}{name} = {toml_value(kinds[name].write(value))}")
    if part.table_name:
        lines += [f"# {note}" for note in part.notes]
    return lines


def _is_idle(part: Part, name: str, value: object) -> bool:
    """Tell whether a key says nothing: an empty list, the index of a law that has none, no shaking."""
    if isinstance(part, Material) and name == "index":
        return not part.spec.has_index
    says_nothing = name in _IDLE.get(part.table_name, ()) or isinstance(part, (Temperature, *_ABSENT))
    says_nothing = says_nothing or value in ((), "")
    return bool(part.table_name) and says_nothing and bool(value == type(part).model_fields[name].default)


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
        return f"{{{', '.join(f'{toml_key(key)} = {toml_value(item)}' for key, item in value.items())}}}"
    return repr(value)


def toml_key(key: str) -> str:
    """Write a key: bare where TOML takes it so, else as text."""
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else toml_value(key)
