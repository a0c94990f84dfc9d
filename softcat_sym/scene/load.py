"""What pulls the filament down, how suddenly, and how steadily."""

from __future__ import annotations

from typing import Annotated, ClassVar

from softcat_sym.scene.kinds import Number, Quantity
from softcat_sym.scene.part import Part


class Load(Part):
    """Gravity, its ramp and its shaking; SI.

    Attributes
    ----------
    gravity : float
        g [m/s^2], downwards.
    ramp : float
        Duration of the quintic smooth step from 0 to g [s]; 0 means at once.
    point_mass : float
        Mass at midspan [kg].
    shake : float
        Amplitude a with which gravity oscillates, over g: g(t) = g (1 + a sin(2 pi f t)), after the ramp if there is
        one; beyond 1 it is turned round once in every period, 0 means steady.
    shake_frequency : float
        Its frequency f [Hz], cycles in a second; given together with `shake`.
    """

    table_name: ClassVar[str] = "load"

    gravity: Annotated[float, Quantity("acceleration", "9.81 m/s^2", "non-negative")] = 9.81
    ramp: Annotated[float, Quantity("time", "0.1 s", "non-negative")] = 0.0
    point_mass: Annotated[float, Quantity("mass", "0 kg", "non-negative")] = 0.0
    shake: Annotated[float, Number(above=0, closed=True)] = 0.0
    shake_frequency: Annotated[float, Quantity("frequency", "5 Hz", "non-negative")] = 0.0
