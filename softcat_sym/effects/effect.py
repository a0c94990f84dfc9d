"""Effects: frozen objects that select terms, name what they need, and estimate when a scene calls for them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import Fault
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.material import constant_in_c
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import length_text, to_si_of_any

if TYPE_CHECKING:
    import sympy as sp

    from softcat_sym.physics.densities import Densities

# SymPy is imported only for densities, which no effect of the package has, so that runs do not load it.


@dataclass(frozen=True, slots=True)
class Estimate:
    """Size of an effect: before a run from the groups of the scene, after it from the observed motion.

    Attributes
    ----------
    value : float
        Change of the midpoint, relative to its largest value, if the effect were left out.
    meaning, formula : str
        Meaning of the number in words, and its formula.
    without : float or None
        Sag without the effect over that with it; None where that is not known.
    late : bool
        Whether the effect changes when the midpoint gets where it goes, and how it swings.
    sag : float
        Sag with the effect [m]; 0 where it is not known.
    """

    value: float
    meaning: str
    formula: str = ""
    without: float | None = None
    late: bool = False
    sag: float = 0.0

    def seen(self, sag: float, *, lacking: bool = False) -> Estimate:
        """The estimate for a filament with this sag [m], which has the effect or lacks it."""
        return replace(self, sag=sag / self.without if lacking and self.without else sag)

    def __str__(self) -> str:
        """What the midpoint does without the effect: ``sag about 12 um; without it 61 um``."""
        share = rough_percent(self.value)
        if self.value < _NOTHING:
            return "it changes nothing"
        if self.late:
            return f"it changes when the midpoint gets there and how it swings, by {share} of the sag on the way"
        if self.without is None or not self.sag > 0:
            return f"it moves the midpoint by {share} of the sag"
        if abs(self.without - 1) < _ALIKE:
            apart = abs(self.without - 1)
            swings = "it changes how the midpoint swings; " if self.value > _SWINGS * apart else ""
            more = "larger" if self.without > 1 else "smaller"
            return f"{swings}without it the sag is {rough_percent(apart)} {more}"
        deep = length_text(self.sag * self.without, 2) if self.without < _BOUNDLESS else "unbounded"
        return f"sag about {length_text(self.sag, 2)}; without it {deep}"


@dataclass(frozen=True, slots=True)
class OfMotion:
    """An estimate that is one number of the motion, or a multiple of it."""

    quantity: str  # Name of the number in :class:`Motion`
    meaning: str
    formula: str = ""
    amplified: bool = False  # Whether it is a relative change of the sag, which ringing amplifies
    factor: float = 1.0
    without: Callable[[float], float] | None = None  # Sag without the effect over that with it, of the number
    late: bool = False  # Whether it changes when the midpoint gets there, and how it swings

    def __call__(self, scene: Scene, motion: Motion) -> Estimate:
        """Return the estimate; the scene is not used."""
        share = self.factor * getattr(motion, self.quantity)
        value, without = motion.amplified(share) if self.amplified else share, self.without and self.without(share)
        return Estimate(value, self.meaning, self.formula, without, self.late)


_WHOLE, _NOTHING, _ALIKE, _SWINGS, _BOUNDLESS = 0.95, 1e-6, 0.1, 3.0, 1e3


def rough_percent(share: float) -> str:
    """A share of the sag, with the single digit of an estimate."""
    return f"about {float(f'{100 * share:.1g}'):g} %" if share < _WHOLE else "all"


def held_up(share: float) -> float:
    """Sag without an effect over that with it, where the effect carries this share of the load."""
    return 1 / (1 - share) if share < 1 else math.inf


def let_down(share: float) -> float:
    """Sag without an effect over that with it, where the effect adds this share to the sag without it."""
    return 1 / (1 + share)


@dataclass(frozen=True, slots=True)
class EffectConstant:
    """A constant of an effect, stated in ``[effects.NAME]`` of the scene.

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
        """Symbol of the constant in the densities of its effect."""
        from softcat_sym.physics import symbols as sy

        kilogram, metre, second = (round(power) for power in self.dimension)
        return sy.enter(self.symbol_name, self.symbol_name, (kilogram, metre, second), self.meaning, "[effects]")


Fields = Mapping[str, npt.NDArray[np.float64]]
"""Variables of a trajectory by name."""


@dataclass(frozen=True, slots=True)
class Observed:
    """What an effect adds to a finished run."""

    fields: Fields = field(default_factory=dict)  # Further variables
    summary: Mapping[str, Any] = field(default_factory=dict)  # Further entries of the summary
    doubt: str = ""  # Why the answer is not to be trusted; empty if it is


def _nothing(_scene: Scene, _fields: Fields) -> Observed:
    return Observed()


def never(scene: Scene) -> bool:
    """Apply to no scene: the default of an effect, which then applies to scenes with its table."""
    del scene
    return False


@dataclass(frozen=True, slots=True)
class Effect:
    """A part of the physics that is in force or absent; an absent effect leaves nothing in the graph.

    An effect either selects terms of the package's own physics (`contribute`), or adds densities of its own: a `stored`
    energy, a Rayleigh potential (`dissipation`) and a `kinetic` energy of a unit of rest length, in the symbols of
    ``softcat_sym.physics.symbols`` (place ``x, y``, velocity ``x_t, y_t``, tangent ``x_X, y_X`` and its rate, stretch
    ``s``, ``X, t``, ``A0, h0, rho, g, L_0``) and of its `constants`. Forces, energy audit, C, written equations and
    gradients of fits follow from them.

    Attributes
    ----------
    name : str
        Name, as in ``run.effects``.
    summary, source : str
        Description in half a sentence; equation numbers, or a paper.
    estimate : callable
        ``(scene, motion) -> Estimate``: change of the midpoint if the effect is left out, for a scene with this motion;
        called before a run with the forecast motion, after it with the observed one.
    observable : str
        Quantity by which a run shows the effect.
    contribute : callable
        ``(terms) -> terms``: the terms with the effect.
    adapt : callable
        ``(scene, terms) -> terms``: the same for an effect whose terms depend on the scene.
    stored, dissipation, kinetic : sympy expression
        Densities [J/m], [W/m], [J/m].
    constants : tuple of EffectConstant
        Keys of ``[effects.NAME]``.
    applies : callable
        Whether a scene can have the effect; by default, for an effect with constants, if their table is given.
    without_it : str
        Why a scene to which it does not apply cannot have the effect.
    example, derivation : str
        Bundled scene in which it matters, notebook that derives its terms.
    needs : tuple of str
        Effects that this one requires.
    in_paper : bool
        Whether it is part of the published theory.
    eases, saved, indispensable : callable
        Reason to enable the effect for speed only, reason to leave it out for speed, and reason why a scene requires
        it; each text is empty if there is no such reason.
    faults : callable
        Faults of scenes in which a filament with the effect is unstable.
    warnings : callable
        ``(scene, motion)`` to sentences on limits of the theory, whether the effect is in force or not.
    cures : str
        Outcome of a run that may be due to its absence, ``"failure"`` for any; `auto` then adds the effect.
    dear : bool
        Whether "everything" omits it, as it makes runs with yielding hinges many times longer.
    values : callable
        ``scene -> {name: value}``: numbers of its terms that the scene does not state itself.
    observe : callable
        ``(scene, fields) -> Observed``: what it adds to a finished run in which it is in force.
    causes : tuple of str
        Causes under which a card counts the effect if a rule of thumb fails. Inertia is also left out with flow, as a
        filament without losses would oscillate for ever.
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
    eases: Callable[[Scene], str] = lambda _scene: ""
    saved: Callable[[Scene], str] = lambda _scene: ""
    indispensable: Callable[[Scene], str] = lambda _scene: ""
    faults: Callable[[Scene], list[Fault]] = lambda _scene: []
    warnings: Callable[[Scene, Motion], list[str]] = lambda _scene, _motion: []
    cures: str = ""
    dear: bool = False
    causes: tuple[str, ...] = ()
    values: Callable[[Scene], dict[str, float]] = lambda _scene: {}
    observe: Callable[[Scene, Fields], Observed] = _nothing

    @property
    def densities(self) -> Densities:
        """Densities of the effect, with the constants of its table."""
        import sympy as sp

        from softcat_sym.physics.constitutive_laws import Constant
        from softcat_sym.physics.densities import Densities

        given = tuple(Constant(constant_in_c(f"effects.{self.name}.{one.name}"), one.symbol) for one in self.constants)
        stored, dissipation, kinetic = (sp.sympify(part) for part in (self.stored, self.dissipation, self.kinetic))
        return Densities(self.name, stored, dissipation, kinetic, given)

    @property
    def adds_densities(self) -> bool:
        """Whether it has densities of its own."""
        return any(part != 0 for part in (self.stored, self.dissipation, self.kinetic))

    def added_to(self, terms: Terms, scene: Scene) -> Terms:
        """The terms with the effect."""
        if self.contribute is not None:
            terms = self.contribute(terms)
        if self.adapt is not None:
            terms = self.adapt(scene, terms)
        return replace(terms, densities=(*terms.densities, self.densities)) if self.adds_densities else terms


def of_large_deflections(scene: Scene) -> bool:
    """Apply unless the scene has the small-deflection model (2.13), which has no such terms."""
    return scene.model == "filament"


SMALL_MODEL = "the small-deflection model has no such terms"


def always(scene: Scene) -> bool:
    """Apply to every scene."""
    del scene
    return True
