"""What an effect is: a frozen object that picks terms, says what it needs, and states when a scene calls for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from softcat_sym.errors import Fault
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.material import constant_in_c
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import to_si_of_any

if TYPE_CHECKING:
    import sympy as sp

    from softcat_sym.physics.densities import Densities

# SymPy is imported where densities are asked for: no effect of the package has any, and no run loads it for these.


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
    speed: float  # Largest speed of the midpoint [m/s]
    capillary: float  # Share of the sag that surface tension would take, or takes
    rings_on: bool = False

    def amplified(self, change: float) -> float:
        """A relative change of the sag as it shows in the midpoint and in the phase of its ringing; 1 at the most."""
        return min(1.0, change * self.sag / self.scale * (1 + self.swings))


@dataclass(frozen=True, slots=True)
class Estimate:
    """How much an effect matters: before a run from the groups of the scene, after it from what it shows.

    Attributes
    ----------
    value : float
        Change of the midpoint, relative to its largest value, if the effect were left out.
    meaning, formula : str
        The number in plain words, and its formula in symbols.
    """

    value: float
    meaning: str
    formula: str = ""

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


def sound(scene: Scene) -> list[Fault]:
    """Nothing in the scene is more than a filament with the effect withstands."""
    del scene
    return []


def silent(scene: Scene, motion: Motion) -> list[str]:
    """Nothing to warn of."""
    del scene, motion
    return []


@dataclass(frozen=True, slots=True)
class EffectConstant:
    """A number that an effect asks for: ``[effects.NAME]`` of the scene states it.

    Attributes
    ----------
    name : str
        Key of the constant.
    symbol_name : str
        Name and LaTeX of its symbol in the equations.
    unit : str
        Unit, such as ``"Pa"``; ``"1"`` for a pure number.
    meaning : str
        Meaning, in half a sentence.
    """

    name: str
    symbol_name: str
    unit: str
    meaning: str

    @property
    def dimension(self) -> tuple[float, float, float]:
        """Exponents of kg, m and s."""
        return to_si_of_any(f"1 {self.unit}" if self.unit != "1" else 1.0)[1]

    @property
    def symbol(self) -> sp.Symbol:
        """What stands for it in the densities of its effect."""
        from softcat_sym.physics import symbols as sy

        kilogram, metre, second = (round(power) for power in self.dimension)
        return sy.enter(self.symbol_name, self.symbol_name, (kilogram, metre, second), self.meaning, "[effects]")


def never(scene: Scene) -> bool:
    """Applies to no scene: an effect that says nothing else applies where the scene has its table."""
    del scene
    return False


@dataclass(frozen=True, slots=True)
class Effect:
    """One piece of physics that can be in force or absent; absent, it leaves nothing in the graph.

    An effect either picks terms of the package's own physics (`contribute`), or adds densities of its own: a `stored`
    energy, a Rayleigh potential (`dissipation`) and a `kinetic` energy of a unit of rest length, in the symbols of
    ``softcat_sym.physics.symbols`` (place ``x, y``, velocity ``x_t, y_t``, tangent ``x_X, y_X`` and its rate, stretch
    ``s``, ``X, t``, ``A0, h0, rho, g, L_0``) and of its `constants`. Forces, energy audit, C, written equations and
    gradients of fits follow from them.

    Attributes
    ----------
    name : str
        Name, as in ``run.effects``.
    summary, source : str
        What the effect adds, in half a sentence; its equation numbers, or a paper.
    estimate : callable
        ``(scene, motion) -> Estimate``: how much the midpoint of a scene that moves so changes if the effect is left
        out; called before a run with the motion that is forecast, after it with the one that is observed.
    observable : str
        Quantity by which a run shows the effect.
    contribute : callable
        ``(terms) -> terms``: the terms with the effect.
    adapt : callable
        ``(scene, terms) -> terms``: the same, for an effect whose law depends on the scene.
    stored, dissipation, kinetic : sympy expression
        Densities [J/m], [W/m], [J/m].
    constants : tuple of EffectConstant
        Keys of ``[effects.NAME]``.
    applies : callable
        Whether a scene has the physics at all; for an effect with constants, where their table is given.
    without_it : str
        Why a scene cannot have the effect where it does not apply.
    example, derivation : str
        Bundled scene in which it matters, notebook that derives its terms.
    needs : tuple of str
        Effects without which this one makes no sense.
    in_paper : bool
        Whether it is part of the published theory.
    eases, saved, indispensable : callable
        Reason to enable the effect for speed only, to leave it out for speed, or why a scene cannot do without it; the
        texts are empty where there is none.
    faults : callable
        Faults of scenes that no filament with the effect withstands.
    warnings : callable
        ``(scene, motion)`` to sentences on what the theory does not hold, whether the effect is in force or not.
    cures : str
        Outcome of a run that leaving it out may have brought about, ``"failure"`` for any; `auto` then adds it.
    dear : bool
        Whether "everything" leaves it aside: followed through hinges that yield it takes many times as long.
    causes : tuple of str
        Under which causes a card counts it when a rule of thumb misses; at rest without flow: a filament that can lose
        nothing would swing for ever.
    """

    name: str
    summary: str
    source: str
    estimate: Callable[[Scene, Motion], Estimate]
    observable: str = ""
    contribute: Callable[[Terms], Terms] | None = None
    adapt: Callable[[Scene, Terms], Terms] | None = None
    stored: sp.Expr | float = 0
    dissipation: sp.Expr | float = 0
    kinetic: sp.Expr | float = 0
    constants: tuple[EffectConstant, ...] = ()
    applies: Callable[[Scene], bool] = never
    without_it: str = ""
    example: str = ""
    derivation: str = ""
    needs: tuple[str, ...] = ()
    in_paper: bool = True
    eases: Callable[[Scene], str] = dispensable
    saved: Callable[[Scene], str] = dispensable
    indispensable: Callable[[Scene], str] = dispensable
    faults: Callable[[Scene], list[Fault]] = sound
    warnings: Callable[[Scene, Motion], list[str]] = silent
    cures: str = ""
    dear: bool = False
    causes: tuple[str, ...] = ()

    @property
    def densities(self) -> Densities:
        """Its own densities, with the numbers that a run is given for its constants."""
        import sympy as sp

        from softcat_sym.physics.densities import Densities
        from softcat_sym.physics.laws import Constant

        given = tuple(Constant(constant_in_c(f"effects.{self.name}.{one.name}"), one.symbol) for one in self.constants)
        stored, dissipation, kinetic = (sp.sympify(part) for part in (self.stored, self.dissipation, self.kinetic))
        return Densities(self.name, stored, dissipation, kinetic, given)

    @property
    def adds_densities(self) -> bool:
        """Whether it has densities of its own."""
        return any(part != 0 for part in (self.stored, self.dissipation, self.kinetic))

    def added_to(self, terms: Terms, scene: Scene) -> Terms:
        """The terms with it."""
        if self.contribute is not None:
            terms = self.contribute(terms)
        if self.adapt is not None:
            terms = self.adapt(scene, terms)
        return replace(terms, densities=(*terms.densities, self.densities)) if self.adds_densities else terms


def of_large_deflections(scene: Scene) -> bool:
    """Applies unless the scene asks for the small-deflection model (2.13), which has none of it."""
    return scene.model == "filament"


SMALL_MODEL = "the small-deflection model has no such terms"


def always(scene: Scene) -> bool:
    """Applies to every scene."""
    del scene
    return True
