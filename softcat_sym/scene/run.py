"""How long to run, how accurately, and with which physics."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from softcat_sym.scene.kinds import Choice, Names, Number, Quantity, Whole
from softcat_sym.scene.part import Part

Until = Literal["duration", "settled"]
Closure = Literal["material", "printed"]


class Run(Part):
    """What is asked of the run; times in s."""

    table_name: ClassVar[str] = "run"

    duration: Annotated[float, Quantity("time", "2 s")]
    """Simulated time; the longest one where the run may settle before."""
    frames: Annotated[int, Whole(2, 1_000_000)] = 201
    """Number of evenly spaced output times, t = 0 included."""
    accuracy: Annotated[float, Number(above=0, below=1)] = 0.01
    """Largest error of the midpoint over the largest midpoint."""
    until: Annotated[Until, Choice(("duration", "settled"))] = "duration"
    """Whether the run ends with its duration, or before when nothing moves any more by the accuracy asked."""
    effects: Annotated[str | tuple[str, ...], Names(("auto", "paper"))] = "auto"
    """Which physics is in force: auto chooses by estimates, paper is the published theory; or names of effects."""
    closure: Annotated[Closure, Choice(("material", "printed"))] = "material"
    """Plastic state, strain measure and axial force: that of the material, or as the paper prints it."""
