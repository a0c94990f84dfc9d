"""What pulls the filament down, how suddenly, and how steadily."""

from __future__ import annotations

from typing import Annotated, ClassVar

from softcat_sym.scene.kinds import Number, Quantity
from softcat_sym.scene.part import Part


class Load(Part):
    """Gravity, its ramp and its shaking; SI."""

    table_name: ClassVar[str] = "load"

    gravity: Annotated[float, Quantity("acceleration", "9.81 m/s^2", "non-negative")] = 9.81
    """Acceleration g, downwards."""
    ramp: Annotated[float, Quantity("time", "0.1 s", "non-negative")] = 0.0
    """Time in which gravity grows from nothing, by a quintic smooth step; 0: at once."""
    point_mass: Annotated[float, Quantity("mass", "0 kg", "non-negative")] = 0.0
    """Mass at midspan."""
    shake: Annotated[float, Number(above=0, closed=True)] = 0.0
    """Amplitude a of oscillating gravity over g, after the ramp: g (1 + a sin(2 pi f t)); 0: steady."""
    shake_frequency: Annotated[float, Quantity("frequency", "5 Hz", "non-negative")] = 0.0
    """Frequency f of oscillating gravity, in cycles a second; given together with load.shake."""
