"""Overrides of single values: ``material.yield_stress=5 kPa``."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from softcat_sym.errors import Fault
from softcat_sym.scene.shear_data import twins
from softcat_sym.scene.units import shown

_FORM = "dotted.key=value, such as material.yield_stress=5 kPa"


@dataclass(frozen=True, slots=True)
class Override:
    """One value to set; None takes the key out."""

    path: str
    value: object


def read_overrides(overrides: Mapping[str, object] | Sequence[str]) -> tuple[list[Override], list[Fault]]:
    """Read overrides as the command line gives them.

    Parameters
    ----------
    overrides : mapping or sequence of str
        ``{"run.effects": "paper"}`` or ``["run.effects=paper"]``. Text is TOML if it parses, else a string.

    Returns
    -------
    list of Override, list of Fault
    """
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


def apply(overrides: Iterable[Override], table: dict[str, Any]) -> list[Fault]:
    """Set the values in a raw table, in place.

    Parameters
    ----------
    overrides : iterable of Override
        In order; the last one wins.
    table : dict
        Raw scene. A table as a value replaces the table of the scene: an empty one is its defaults.

    Returns
    -------
    list of Fault
        Paths that lead through something that is no table.
    """
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
                if here.pop(twin.partition(".")[2], None) is not None and twin == "filament.diameter":
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
