"""What an effect is: a frozen object that picks terms, says what it needs, and states when a scene calls for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene


@dataclass(frozen=True, slots=True)
class Estimate:
    """How much an effect matters in a scene, before anything is run.

    Attributes
    ----------
    value : float
        Dimensionless; compared with the accuracy asked.
    meaning : str
        What the number is, with its formula.
    """

    value: float
    meaning: str

    def __str__(self) -> str:
        return f"{self.meaning} = {self.value:.2g}"


@dataclass(frozen=True, slots=True)
class Effect:
    """One piece of physics that can be in force or absent; absent, it leaves nothing in the graph.

    Attributes
    ----------
    name : str
        As in ``run.effects``.
    summary : str
        What it adds, in half a sentence.
    source : str
        Equation numbers of the terms it picks.
    contribute : callable
        Terms before to terms after; effects touch different fields, so their order does not matter.
    applies : callable
        Whether the scene has the physics at all (a law that flows, a ramp, ...).
    without_it : str
        Why it cannot be had where it does not apply.
    estimate : callable
        How much it matters in a scene.
    observable : str
        Measure of a finished run that shows whether leaving it out was harmless.
    needs : tuple of str
        Effects without which it makes no sense.
    in_paper : bool
        Whether it is part of the published theory.
    called_for : callable
        Whether ``auto`` takes it in, from the scene and the value of the estimate.
    """

    name: str
    summary: str
    source: str
    contribute: Callable[[Terms], Terms]
    applies: Callable[[Scene], bool]
    without_it: str
    estimate: Callable[[Scene], Estimate]
    observable: str
    needs: tuple[str, ...] = ()
    in_paper: bool = True
    called_for: Callable[[Scene, float], bool] = lambda _scene, _value: True


def of_large_deflections(scene: Scene) -> bool:
    """Applies unless the scene asks for the small-deflection model (2.13), which has none of it."""
    return scene.model == "filament"


SMALL_MODEL = "the small-deflection model has no such terms"


def always(scene: Scene) -> bool:
    """Applies to every scene."""
    del scene
    return True
