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
    """Supports; lengths in m, angles in rad.

    Attributes
    ----------
    left, right : str
        How each end is held.
    drop : float
        Right support below the left one [m].
    left_angle, right_angle : float
        Of a clamp: of the tangent in the direction of growing X, counterclockwise from the horizontal [rad]. A
        symmetric pair is -a and a.
    motion : tuple of (float, float, float)
        Rows of time [s] and displacement of the right support from its first place, right and up [m]; linear between
        rows, none before the first, held after the last.
    """

    table_name: ClassVar[str] = "ends"

    left: Annotated[End, _END] = "clamped"
    right: Annotated[End, _END] = "clamped"
    drop: Annotated[float, Quantity("length", "0 m", "any")] = 0.0
    left_angle: Angle = 0.0
    right_angle: Angle = 0.0
    motion: Annotated[tuple[tuple[float, float, float], ...], Motion()] = ()

    @field_validator("left_angle", "right_angle", mode="wrap")
    @classmethod
    def _within_half_a_turn(cls, value: Any, handler: ValidatorFunctionWrapHandler) -> Any:
        angle = handler(value)
        if not -math.pi < angle < math.pi:
            raise refusal(f"{shown(value)} is half a turn or more", "an angle between -180 deg and 180 deg")
        return angle
