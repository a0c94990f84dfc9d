"""How long to run, how accurately, and with which physics."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from softcat_sym.scene.kinds import Choice, Names, Number, Quantity, Whole
from softcat_sym.scene.part import Part

Until = Literal["duration", "settled"]
Closure = Literal["material", "printed"]


class Run(Part):
    """What is asked of the run; times in s.

    Attributes
    ----------
    duration : float
        Simulated time [s]; the longest where the run may settle before.
    frames : int
        Number of evenly spaced output times, t = 0 included.
    accuracy : float
        Largest error of the midpoint over the largest midpoint.
    until : str
        ``"duration"``, or ``"settled"``: the run ends when nothing moves any more by the accuracy asked.
    effects : str or tuple of str
        ``"auto"``, ``"paper"`` or names of effects.
    closure : str
        ``"material"`` or ``"printed"`` (THEORY 4).
    """

    table_name: ClassVar[str] = "run"

    duration: Annotated[float, Quantity("time", "2 s")]
    frames: Annotated[int, Whole(2, 1_000_000)] = 201
    accuracy: Annotated[float, Number(above=0, below=1)] = 1e-3
    until: Annotated[Until, Choice(("duration", "settled"))] = "duration"
    effects: Annotated[str | tuple[str, ...], Names(("auto", "paper"))] = "auto"
    closure: Annotated[Closure, Choice(("material", "printed"))] = "material"
