"""The ends of the filament: what each kind of support holds, and the table [ends]."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Any, ClassVar, Literal

from pydantic import ValidatorFunctionWrapHandler, field_validator

from softcat_sym.scene.parts import Part
from softcat_sym.scene.units import MOTION, TURNS, Choice, Flag, Quantity, refusal, shown


class Hold(Enum):
    """How one coordinate of an end is held."""

    FREE = "by nothing"
    SPRING = "by a spring"
    RIGID = "rigidly"


@dataclass(frozen=True, slots=True)
class Support:
    """What holds an end of the filament."""

    name: str  # As in the scene
    x: Hold  # Along the span, upwards and out of the plane, and the angle of the section
    y: Hold
    angle: Hold

    @property
    def holds(self) -> tuple[str, str, str]:
        """How its coordinates are held, as keys of what is kept have them."""
        return self.x.name, self.y.name, self.angle.name

    @property
    def holds_x(self) -> bool:
        """Whether x is given."""
        return self.x is Hold.RIGID

    @property
    def holds_height(self) -> bool:
        """Whether y is given, and z in three dimensions."""
        return self.y is Hold.RIGID

    @property
    def holds_angle(self) -> bool:
        """Whether the angle of the section is given."""
        return self.angle is Hold.RIGID

    @property
    def is_free(self) -> bool:
        """Whether it carries no weight."""
        return self.x is self.y is Hold.FREE

    @property
    def carries_moment(self) -> bool:
        """Whether the end resists a turn of its section."""
        return self.angle is not Hold.FREE

    @property
    def kind(self) -> str:
        """The plain support most like it, as C and live pages name it."""
        if self.y is Hold.FREE:
            return "free" if self.is_free else "symmetry"
        return "clamped" if self.carries_moment else "pinned"


CLAMPED = Support("clamped", Hold.RIGID, Hold.RIGID, Hold.RIGID)
PINNED = Support("pinned", Hold.RIGID, Hold.RIGID, Hold.FREE)
FREE = Support("free", Hold.FREE, Hold.FREE, Hold.FREE)
SLIDING = Support("sliding", Hold.FREE, Hold.RIGID, Hold.RIGID)
"""A clamp under ``ends.right_slides``."""
SYMMETRY = Support("symmetry", Hold.RIGID, Hold.FREE, Hold.RIGID)
"""The middle of a filament of which one half is followed."""

SUPPORTS: dict[str, Support] = {one.name: one for one in (CLAMPED, PINNED, FREE)}

End = Literal["clamped", "pinned", "free"]
_END = Choice(End)
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
    """Depth of the right support below the left one."""
    left_angle: Angle = 0.0
    """Angle of a left clamp, counterclockwise from the horizontal; a symmetric pair has -a and a."""
    right_angle: Angle = 0.0
    """Angle of a right clamp, counterclockwise from the horizontal."""
    motion: Annotated[tuple[tuple[float, ...], ...], MOTION] = ()
    """Path of the right support, right, up and towards the viewer, linear between rows, held after the last."""
    right_twist: Annotated[tuple[tuple[float, ...], ...], TURNS] = ()
    """Turn of a right clamp about its own normal, linear between rows, held after the last; any number of turns."""
    right_slides: Annotated[bool, Flag()] = False
    """Whether a right clamp is free to slide along the span, as under load.tip_force; in three dimensions."""

    @property
    def supports(self) -> tuple[Support, Support]:
        """What holds the left and the right end."""
        right = SUPPORTS[self.right]
        return SUPPORTS[self.left], SLIDING if self.right_slides and right == CLAMPED else right

    @property
    def sides(self) -> tuple[tuple[str, Support, float], ...]:
        """Name, support and angle of either end."""
        return tuple(zip(("left", "right"), self.supports, (self.left_angle, self.right_angle), strict=True))

    @field_validator("left_angle", "right_angle", mode="wrap")
    @classmethod
    def _within_half_a_turn(cls, value: Any, handler: ValidatorFunctionWrapHandler) -> Any:
        angle = handler(value)
        if not -math.pi < angle < math.pi:
            raise refusal(f"{shown(value)} is half a turn or more", "an angle between -180 deg and 180 deg")
        return angle
