"""Keys of the scene file whose physics comes later: refused by name unless they sit where they have no effect.

To make a key available, delete its row, or add to the values that it lists.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class SameAs:
    """The value of another key of the same table."""

    key: str


AVAILABLE: dict[str, tuple[object, ...]] = {
    "numerics.backend": ("auto", "interpreted"),
}


def has_physics(path: str, value: object, siblings: Mapping[str, object]) -> bool:
    """Tell whether the key at `path` may hold `value` now.

    Parameters
    ----------
    path : str
        Dotted path.
    value : object
        Validated value, SI.
    siblings : mapping
        The sound values of the same table.

    Returns
    -------
    bool
        True for every key without a row.
    """
    return path not in AVAILABLE or any(_equal(value, allowed, siblings) for allowed in AVAILABLE[path])


def available(path: str) -> str:
    """Say which values of the key at `path` have physics now."""
    return ", ".join(_written(value) for value in AVAILABLE[path] if value is not None) or "leaving it out"


def _equal(value: object, allowed: object, siblings: Mapping[str, object]) -> bool:
    if isinstance(allowed, SameAs):
        # Where the other key is itself at fault there is nothing to compare with.
        allowed = siblings.get(allowed.key, value)
    if isinstance(value, float) and isinstance(allowed, float):
        return math.isclose(value, allowed, rel_tol=1e-12)
    return value == allowed


def _written(value: object) -> str:
    if isinstance(value, SameAs):
        return f"the same as {value.key}"
    if value in ((), ""):
        return "nothing (empty)"
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:g}" if isinstance(value, float) else str(value)
