"""What each effect is worth: put in or left out in turn, the change of the answer against the change of the cost."""

from __future__ import annotations

from collections.abc import Callable, Collection
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.effects import REGISTRY, Decision, Estimate, choose_effects
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.scene import as_scene
from softcat_sym.scene.consistency import refuse_settled
from softcat_sym.simulate import without_estimate
from softcat_sym.solve import Progress, Silence
from softcat_sym.study.base_run import base_run, on_grid
from softcat_sym.study.priced_run import PricedRun, priced_run
from softcat_sym.study.variants import Names, dependants, everything, obstacle, ordered, requirements, with_effects

if TYPE_CHECKING:
    from softcat_sym.scene import Scene, SceneLike

Listening = Callable[[str], AbstractContextManager[Progress]]
"""Given what is about to run, a context whose value is told how far it is."""

EVERYTHING = "everything"
"""Name of the row that holds all that the scene can have, rotary inertia aside."""

DEFINITION = (
    "change: max |variant - base|/max |base| of the midpoint's height over the frames both reached; "
    "change_final: (variant - base)/max |base| at the last frame; own_change: the same maximum against the run in "
    "which only the effects that went with it are changed; ratios are with the effect over without it, all else equal"
)


@dataclass(frozen=True)
class PricingRow:
    """One effect, put in or left out.

    Attributes
    ----------
    effect : str
        Its name.
    in_force : bool
        Whether the base holds it: then it was left out, otherwise put in.
    also : tuple of str
        Effects that went with it, since they need it or it needs them; empty without a run.
    variant : PricedRun or None
        The run without it, or with it; None where there is none.
    reference : PricedRun or None
        The base but for `also`, or the base itself where that cannot be had: against it the effect's own share is
        measured. None without a variant.
    scale : float
        Largest ``|midpoint|`` of the base [m].
    change, change_final : float or None
        Of the midpoint against the base, relative to `scale`; None where there is nothing to compare.
    estimate : float or None
        Change that the program expected; None where the scene cannot have the effect.
    meaning : str
        What the estimate is.
    reason : str
        Why there is no run; empty where there is one.
    """

    effect: str
    in_force: bool
    also: Names
    variant: PricedRun | None
    reference: PricedRun | None
    scale: float
    change: float | None
    change_final: float | None
    estimate: float | None
    meaning: str
    reason: str

    @property
    def fails(self) -> bool:
        """Whether it was run and the run is not to be trusted."""
        return self.variant is not None and not self.variant.outcome.is_success

    @property
    def own_change(self) -> float | None:
        """Change that the effect makes by itself, relative to `scale`; None where a run fails."""
        if self.variant is None or self.reference is None:
            return None
        # With nothing that went along the reference is the base, which is what it is.
        sound = self.variant.outcome.is_success and (self.reference.outcome.is_success or not self.also)
        return _change(self.variant, self.reference, self.scale) if sound else None

    @property
    def share(self) -> float | None:
        """What the effect is credited with: no more than its removal changes, nor than it changes by itself."""
        known = [value for value in (self.change, self.own_change) if value is not None]
        return min(known) if known and not self.fails else None

    @property
    def states_ratio(self) -> float | None:
        """Unknowns with the effect over those without it, all else equal."""
        return self._ratio(lambda run: run.states + run.algebraic)

    @property
    def instructions_ratio(self) -> float | None:
        """Instructions with the effect over those without it, all else equal."""
        return self._ratio(lambda run: run.instructions)

    @property
    def time_ratio(self) -> float | None:
        """Solve time with the effect over that without it, all else equal."""
        return self._ratio(lambda run: run.solve)

    def _ratio(self, size: Callable[[PricedRun], float]) -> float | None:
        if self.variant is None or self.reference is None:
            return None
        having, lacking = (self.reference, self.variant) if self.in_force else (self.variant, self.reference)
        return size(having) / size(lacking) if size(lacking) > 0 else None


@dataclass(frozen=True)
class Pricing:
    """The effects of one scene, priced.

    Attributes
    ----------
    name : str
        Of the scene, as it was asked for; may be empty.
    scene : Scene
        What was asked.
    base : PricedRun
        Its run.
    cells : int
        Cells per half span of every run.
    grading : float
        Longest over shortest cell of every run.
    rows : tuple of PricingRow
        One an effect that was asked for, in the order of the registry.
    everything : PricingRow
        All that the scene can have, against the base.
    """

    name: str
    scene: Scene
    base: PricedRun
    cells: int
    grading: float
    rows: tuple[PricingRow, ...]
    everything: PricingRow

    @property
    def scale(self) -> float:
        """Largest ``|midpoint|`` of the base [m]."""
        return self.base.reach


def price_effects(
    scene: SceneLike, listening: Listening | None = None, name: str = "", only: Collection[str] | None = None
) -> Pricing:
    """Run a scene as it is, then with each effect put in or left out in turn, all on the same grid.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The base is the choice of ``auto``, the paper's list, or the scene's own.
    listening : callable, optional
        Called with what is about to run; returns a context whose value is told how far it is.
    name : str
        Of the scene, for tables.
    only : collection of str, optional
        Price these effects and no others; all unless given.

    Returns
    -------
    Pricing
        A variant that cannot be had or fails is a row that says so.

    Raises
    ------
    SceneError
        If the scene cannot have the effects that it names, or `only` holds an unknown name.
    KeyboardInterrupt
        On Ctrl-C.
    """
    scene = as_scene(scene)
    refuse_settled(scene, "variants are compared frame by frame")
    known = [effect.name for effect in REGISTRY]
    wanted = known if only is None else only
    if unknown := [one for one in wanted if one not in known]:
        raise SceneError([Fault("", f"no effect {one!r} to price", f"one of {', '.join(known)}") for one in unknown])
    told = listening or _nobody
    with told("the scene itself") as listener:
        once = without_estimate(scene)
        cells, grading, base = base_run(once, listener)
    names = base.effects
    listed = on_grid(once, names, cells).replace({"numerics.grading": grading})
    runs = _Runs(listed, told, {names: base})
    decisions = [one for one in choose_effects(listed).decisions if one.effect.name in wanted]
    rows = tuple(_row(one, names, runs) for one in decisions)
    return Pricing(name, scene, base, cells, grading, rows, _everything(names, runs))


@dataclass
class _Runs:
    """Runs of one scene, each list of effects once."""

    scene: Scene
    listening: Listening
    made: dict[Names, PricedRun] = field(default_factory=dict)

    @property
    def base(self) -> PricedRun:
        return next(iter(self.made.values()))

    def of(self, names: Names, what: str) -> PricedRun | str:
        """The run of a list of effects, or why there is none."""
        if names in self.made:
            return self.made[names]
        try:
            scene = with_effects(self.scene, names)
            chosen = choose_effects(scene)
            if unwanted := [name for name in chosen.names if name not in names]:
                return f"cannot be left out: {unwanted[0]} comes back, {chosen.reasons[unwanted[0]]}"
            with self.listening(what) as listener:
                self.made[names] = priced_run(scene, listener)
        except SoftcatError as error:
            return " ".join(str(error).split())
        # CasADi's own: an integrator that cannot even begin.
        except RuntimeError as error:
            return f"the solver refused: {str(error).splitlines()[0] if str(error) else type(error).__name__}"
        return self.made[names]


def _row(decision: Decision, names: Names, runs: _Runs) -> PricingRow:
    effect, inside = decision.effect, decision.effect.name in names
    also = dependants(effect.name, names) if inside else requirements(effect.name, names, runs.scene)
    # What goes with it is changed in both: the effect's own share is the difference of the two.
    others = ordered(set(names) - set(also) if inside else {*names, *also})
    wanted = ordered(set(others) - {effect.name} if inside else {*others, effect.name})
    what = f"{'without' if inside else 'with'} {effect.name}"
    variant = obstacle(effect, runs.scene, names) or runs.of(wanted, what)
    reference = variant if isinstance(variant, str) else runs.of(others, f"{what}, its own share")
    # Where they cannot be had without it, all that was changed is its share.
    if isinstance(reference, str) and not isinstance(variant, str):
        reference = runs.base
    return _compared(effect.name, inside, also, (variant, reference), decision.estimate, runs)


def _everything(names: Names, runs: _Runs) -> PricingRow:
    wanted = everything(runs.scene, names)
    variant = runs.of(wanted, EVERYTHING)
    return _compared(EVERYTHING, False, ordered(set(wanted) - set(names)), (variant, runs.base), None, runs)


def _compared(
    name: str,
    inside: bool,
    also: Names,
    pair: tuple[PricedRun | str, PricedRun | str],
    estimate: Estimate | None,
    runs: _Runs,
) -> PricingRow:
    variant, reference = (None if isinstance(one, str) else one for one in pair)
    final = None
    if variant is not None and len(variant.time) == len(runs.base.time) and runs.base.reach > 0:
        final = _finite(float(variant.midpoint[-1] - runs.base.midpoint[-1]) / runs.base.reach)
    return PricingRow(
        effect=name,
        in_force=inside,
        also=() if variant is None else also,
        variant=variant,
        reference=reference,
        scale=runs.base.reach,
        change=None if variant is None else _change(variant, runs.base, runs.base.reach),
        change_final=final,
        estimate=None if estimate is None else estimate.value,
        meaning="" if estimate is None else estimate.meaning,
        reason=pair[0] if isinstance(pair[0], str) else "",
    )


def _change(one: PricedRun, other: PricedRun, scale: float) -> float | None:
    """Largest distance of two midpoints over the frames that both reached, relative to `scale`."""
    frames = min(len(one.midpoint), len(other.midpoint))
    # The first frame is the start, which says nothing of a run that came no further.
    if frames < 2:
        return None
    apart = np.abs(one.midpoint[:frames] - other.midpoint[:frames])
    apart = apart[np.isfinite(apart)]
    return _finite(float(apart.max()) / scale) if apart.size and scale > 0 else None


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def _nobody(what: str) -> AbstractContextManager[Progress]:
    del what
    return nullcontext(Silence())
