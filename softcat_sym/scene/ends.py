"""The two ends and how they are held."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import ValidatorFunctionWrapHandler, field_validator

from softcat_sym.scene.kinds import Choice, Motion, Quantity, refusal
from softcat_sym.scene.part import Part
from softcat_sym.scene.units import shown

End = Literal["clamped", "pinned", "free"]
_END = Choice(("clamped", "pinned", "free"))
_ANGLE = Quantity("angle", "10 deg", "any")
Angle = Annotated[float, _ANGLE]


class Ends(Part):
    """Supports; lengths in m, angles in rad."""

    table_name: ClassVar[str] = "ends"

    left: Annotated[End, _END] = "clamped"
    """How the left end is held."""
    right: Annotated[End, _END] = "clamped"
    """How the right end is held."""
    drop: Annotated[float, Quantity("length", "0 m", "any")] = 0.0
    """Right support below the left one."""
    left_angle: Angle = 0.0
    """Of a left clamp: its tangent, counterclockwise from the horizontal; a symmetric pair is -a and a."""
    right_angle: Angle = 0.0
    """Of a right clamp, likewise."""
    motion: Annotated[tuple[tuple[float, float, float], ...], Motion()] = ()
    """Path of the right support, right and up from its first place, linear between rows, held after the last."""

    @field_validator("left_angle", "right_angle", mode="wrap")
    @classmethod
    def _within_half_a_turn(cls, value: Any, handler: ValidatorFunctionWrapHandler) -> Any:
        angle = handler(value)
        if not -math.pi < angle < math.pi:
            raise refusal(f"{shown(value)} is half a turn or more", "an angle between -180 deg and 180 deg")
        return angle
