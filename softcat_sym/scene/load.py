"""What pulls the filament down, and how suddenly."""

from __future__ import annotations

from typing import Annotated, ClassVar

from softcat_sym.scene.kinds import Quantity
from softcat_sym.scene.part import Part


class Load(Part):
    """Gravity and its ramp; SI.

    Attributes
    ----------
    gravity : float
        g [m/s^2], downwards.
    ramp : float
        Duration of the quintic smooth step from 0 to g [s]; 0 means at once.
    point_mass : float
        Mass at midspan [kg].
    """

    table_name: ClassVar[str] = "load"

    gravity: Annotated[float, Quantity("acceleration", "9.81 m/s^2", "non-negative")] = 9.81
    ramp: Annotated[float, Quantity("time", "0.1 s", "non-negative")] = 0.0
    point_mass: Annotated[float, Quantity("mass", "0 kg", "non-negative")] = 0.0
