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
    "filament.section": ("rectangle", "circle"),
    "filament.rest_length": (SameAs("span"),),
    "filament.profile": ((),),
    "filament.curvature": (0.0,),
    "material.law": ("elastic", "maxwell", "bingham"),
    "material.index": (1.0,),
    "material.shear_consistency": (None,),
    "material.second_modulus": (None,),
    "material.modes": ((),),
    "material.flow": ("",),
    "material.parameters": ((),),
    "ends.left": ("clamped", "pinned"),
    "ends.right": ("clamped", "pinned"),
    "ends.drop": (0.0,),
    "ends.left_angle": (0.0,),
    "ends.right_angle": (0.0,),
    "ends.motion": ((),),
    "load.point_mass": (0.0,),
    "initial.stretch": (1.0,),
    "initial.relaxed": (True,),
    "initial.P": ((),),
    "initial.C": ((),),
    "numerics.backend": ("auto", "interpreted"),
    "groups.law": ("elastic", "maxwell", "bingham"),
    "groups.n": (1.0,),
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
