"""The two ends and how they are held."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from softcat_sym.scene.kinds import Choice, Empty, Quantity
from softcat_sym.scene.part import Part

End = Literal["clamped", "pinned", "free"]
_END = Choice(("clamped", "pinned", "free"))
_ANGLE = Quantity("angle", "10 deg", "any")


class Ends(Part):
    """Supports; lengths in m, angles in rad.

    Attributes
    ----------
    left, right : str
        How each end is held.
    drop : float
        Right support below the left one [m].
    left_angle, right_angle : float
        Of a clamp, from the horizontal [rad].
    motion : tuple
        Path of the right support.
    """

    table_name: ClassVar[str] = "ends"

    left: Annotated[End, _END] = "clamped"
    right: Annotated[End, _END] = "clamped"
    drop: Annotated[float, Quantity("length", "0 m", "any")] = 0.0
    left_angle: Annotated[float, _ANGLE] = 0.0
    right_angle: Annotated[float, _ANGLE] = 0.0
    motion: Annotated[tuple[()], Empty()] = ()
