"""What an effect is: a frozen object that picks terms, says what it needs, and states when a scene calls for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from softcat_sym.physics.filament import Terms
from softcat_sym.scene.scene import Scene


@dataclass(frozen=True, slots=True)
class Motion:
    """What the sizes of all effects are computed from; lengths are in spans."""

    sag: float  # Largest depth of the midpoint below the line between the supports
    scale: float  # Largest distance of the midpoint from the height of the left support: what an error is measured by
    strain: float  # Largest mean strain of the centreline
    slope: float  # Largest slope against the horizontal
    tension_share: float  # Share of the load that is carried in tension once the filament hangs deepest
    swings: float  # Phase of the ringing times its share of the sag
    missed: float  # Change of the midpoint, in scales, by a filament that is in balance at every instant
    risen: float  # Share of the largest sag that a filament loaded at once would have reached by the end of the ramp
    relaxed: float  # Share of the stress that flow takes away, 0 to 1
    overstress: float  # Largest fibre stress over the yield stress; infinite without one
    flowing_overstress: float  # Mean stress of the flowing filament over the yield stress; infinite without one
    retarded: float  # Change of the midpoint, in scales, by a solid that does not resist the rate of its strain
    damped: float  # Change of the midpoint, in scales, by a solid that loses nothing below yield
    sheared: float  # Share of the sag that shear makes, of a filament that does not flow beyond a yield stress
    folds: float  # Growth of a neck, e-folds
    capillary: float  # Share of the sag that surface tension would take, or takes
    rings_on: bool = False

    def amplified(self, change: float) -> float:
        """A relative change of the sag as it shows in the midpoint and in the phase of its ringing; 1 at the most."""
        return min(1.0, change * self.sag / self.scale * (1 + self.swings))


@dataclass(frozen=True, slots=True)
class Estimate:
    """How much an effect matters: before a run from the groups of the scene, after it from what it shows."""

    value: float  # Change of the midpoint, relative to the largest, that leaving the effect out would make
    meaning: str  # What the number is, in plain words
    formula: str = ""  # How it is worked out, in symbols

    def __str__(self) -> str:
        return amount(self.value)


@dataclass(frozen=True, slots=True)
class OfMotion:
    """An estimate that is one number of the motion, or a multiple of it."""

    quantity: str  # Name of the number in :class:`Motion`
    meaning: str
    formula: str = ""
    amplified: bool = False  # Whether it is a relative change of the sag, which ringing amplifies
    factor: float = 1.0

    def __call__(self, scene: Scene, motion: Motion) -> Estimate:
        """Read the number; the scene itself does not matter."""
        value = self.factor * getattr(motion, self.quantity)
        return Estimate(motion.amplified(value) if self.amplified else value, self.meaning, self.formula)


_WHOLE, _NOTHING = 0.95, 1e-6


def amount(value: float) -> str:
    """A change of the sag as people say it, to the one digit that an estimate has: ``about 90 % of the sag``."""
    if value >= _WHOLE:
        return "the whole sag"
    if value < _NOTHING:
        return "nothing"
    return f"about {float(f'{100 * value:.1g}'):g} % of the sag"


def dispensable(scene: Scene) -> str:
    """Nothing speaks against leaving the effect out."""
    del scene
    return ""


@dataclass(frozen=True, slots=True)
class Effect:
    """One piece of physics that can be in force or absent; absent, it leaves nothing in the graph."""

    name: str  # As in ``run.effects``
    summary: str  # What it adds, in half a sentence
    source: str  # Equation numbers of the terms it picks
    contribute: Callable[[Terms], Terms]  # Terms before to terms after
    applies: Callable[[Scene], bool]  # Whether the scene has the physics at all (a law that flows, a ramp, ...)
    without_it: str  # Why it cannot be had where it does not apply
    estimate: Callable[[Scene, Motion], Estimate]  # How much it matters in a scene that moves so
    observable: str
    example: str  # Bundled scene in which it matters
    derivation: str  # Notebook that derives its terms
    needs: tuple[str, ...] = ()  # Effects without which it makes no sense
    in_paper: bool = True  # Whether it is part of the published theory
    eases: Callable[[Scene], str] = dispensable  # Why a scene is run more quickly with it, although it may not matter
    saved: Callable[[Scene], str] = dispensable
    indispensable: Callable[[Scene], str] = dispensable  # Why a scene cannot do without it; an empty text where it can


def of_large_deflections(scene: Scene) -> bool:
    """Applies unless the scene asks for the small-deflection model (2.13), which has none of it."""
    return scene.model == "filament"


SMALL_MODEL = "the small-deflection model has no such terms"


def always(scene: Scene) -> bool:
    """Applies to every scene."""
    del scene
    return True
