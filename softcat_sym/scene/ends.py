"""The ends of the filament: what each kind of support holds, and the table [ends]."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import Enum
from functools import lru_cache
from typing import Annotated, Literal

from pydantic import field_validator

from softcat_sym.scene.parts import Part, Rule
from softcat_sym.scene.units import FLAG, MOTION, TURNS, Choice, Quantity, refusal


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
    def has_springs(self) -> bool:
        """Whether anything of it gives way."""
        return Hold.SPRING in (self.x, self.y, self.angle)

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

ELASTIC = Support("elastic", Hold.SPRING, Hold.SPRING, Hold.SPRING)
"""What of it is not given is rigid."""

SUPPORTS: dict[str, Support] = {one.name: one for one in (CLAMPED, PINNED, FREE, ELASTIC)}


@lru_cache(maxsize=256)
def _support(name: str, place: float | None, turn: float | None) -> Support:
    """A support with springs of this stiffness: rigid where none is given, none where it is zero. Asked very often."""
    one = SUPPORTS[name]
    if not one.has_springs:
        return one
    x, y, angle = (
        hold if hold is not Hold.SPRING else Hold.RIGID if value is None else hold if value else Hold.FREE
        for hold, value in zip((one.x, one.y, one.angle), (place, place, turn), strict=True)
    )
    return replace(one, x=x, y=y, angle=angle)


End = Literal["clamped", "pinned", "free", "elastic"]
_END = Choice(End)
_ANGLE = Quantity("angle", "10 deg", "any")
Angle = Annotated[float, _ANGLE]
Stiffness = Annotated[float | None, Quantity("stiffness", "200 N/m")]
RotationalStiffness = Annotated[float | None, Quantity("rotational stiffness", "0.01 N*m/rad", "non-negative")]


class Ends(Part, table="ends"):
    """Supports; lengths in m, angles in rad."""

    left: Annotated[End, _END] = "clamped"
    """How the left end is held."""
    right: Annotated[End, _END] = "clamped"
    """How the right end is held."""
    left_stiffness: Stiffness = None
    """Stiffness of a left end that is elastic, against displacements in every direction; rigid unless given."""
    right_stiffness: Stiffness = None
    """Stiffness of a right end that is elastic, likewise."""
    left_rotational_stiffness: RotationalStiffness = None
    """Stiffness of a left end that is elastic, against turning about every axis; rigid unless given, 0 as a pin."""
    right_rotational_stiffness: RotationalStiffness = None
    """Stiffness of a right end that is elastic, likewise."""
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
    right_slides: Annotated[bool, FLAG] = False
    """Whether a right clamp is free to slide along the span, as under load.tip_force; in three dimensions."""

    @property
    def supports(self) -> tuple[Support, Support]:
        """What holds the left and the right end."""
        left = _support(self.left, self.left_stiffness, self.left_rotational_stiffness)
        right = _support(self.right, self.right_stiffness, self.right_rotational_stiffness)
        return left, SLIDING if self.right_slides and right == CLAMPED else right

    def stiffness(self, side: str) -> tuple[float, float]:
        """Stiffness of an end in displacement [N/m] and in turning [N m/rad]: infinite where rigid, 0 where free."""
        support, own = SUPPORTS[getattr(self, side)], {Hold.RIGID: math.inf, Hold.FREE: 0.0}
        place, turn = (math.inf if value is None else value for value in self.given_stiffness(side).values())
        return own.get(support.y, place), own.get(support.angle, turn)

    def given_stiffness(self, side: str) -> dict[str, float | None]:
        """Stiffnesses of an end as the scene has them, by their keys."""
        return {key: getattr(self, key) for key in (f"{side}_stiffness", f"{side}_rotational_stiffness")}

    @property
    def springs(self) -> dict[str, float]:
        """Stiffness of each spring that holds an end, by its key."""
        keys = (key for side in ("left", "right") for key in self.given_stiffness(side))
        values = (*self.stiffness("left"), *self.stiffness("right"))
        return {key: value for key, value in zip(keys, values, strict=True) if 0 < value < math.inf}

    @property
    def sides(self) -> tuple[tuple[str, Support, float], ...]:
        """Name, support and angle of either end."""
        return tuple(zip(("left", "right"), self.supports, (self.left_angle, self.right_angle), strict=True))

    @field_validator("left_angle", "right_angle")
    @classmethod
    def _within_half_a_turn(cls, angle: float) -> float:
        if not -math.pi < angle < math.pi:
            found = f"{math.degrees(angle):g} deg is half a turn or more"
            raise refusal(found, "an angle between -180 deg and 180 deg")
        return angle


def end_rules(ends: Ends) -> Iterator[Rule]:
    """List what does not go together in the table [ends]."""
    out, free = "leaving it out", [support.is_free for support in ends.supports]
    yield all(free), "ends", "both ends are free", "at least one end clamped or pinned"
    for side, support, angle in ends.sides:
        found, accepted = f"given, but the {side} end is {support.name}", f'{out}, or ends.{side} = "clamped"'
        yield not support.carries_moment and angle != 0, f"ends.{side}_angle", found, accepted
        stiffnesses = ends.given_stiffness(side)
        if SUPPORTS[getattr(ends, side)].has_springs:
            given = any(value is not None for value in stiffnesses.values())
            yield not given, f"ends.{side}", "'elastic' without a stiffness", f"{' or '.join(stiffnesses)}, or clamped"
        else:
            for key, value in stiffnesses.items():
                yield value is not None, f"ends.{key}", found, f'{out}, or ends.{side} = "elastic"'
    yield ends.drop and any(free), "ends.drop", "given, but one end is free", f"{out}, or two ends that are held"
    broken, found = ends.motion and free[1], "given, but the right end is free"
    yield broken, "ends.motion", found, f"{out}, or a right end that is held"
