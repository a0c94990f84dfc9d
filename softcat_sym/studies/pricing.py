"""What each effect is worth: put in or left out in turn, the change of the answer against the change of the cost."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import asdict, dataclass, field, replace
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.discretization.grid import Floats, choose_grading
from softcat_sym.effects.choosing import Decision, choose_effects, why_not
from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.rotary_inertia import ROTARY_INERTIA
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.scene.reading import as_scene, load_scene
from softcat_sym.scene.scene import Scene, refuse_settled
from softcat_sym.simulate import identity_of, recalled, simulated, without_estimate
from softcat_sym.single_run import build
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Progress, Silence, watched
from softcat_sym.store import json_form, key_of, stored

if TYPE_CHECKING:
    from softcat_sym.results.trajectory import Trajectory
    from softcat_sym.scene.reading import SceneLike
    from softcat_sym.solvers.run import Prepared

Names = tuple[str, ...]


def ordered(names: Collection[str]) -> Names:
    """The names in the order of the registry."""
    return tuple(effect.name for effect in REGISTRY if effect.name in names)


def dependants(name: str, names: Iterable[str]) -> Names:
    """Which of the names cannot stay without this one: what needs it, what needs that, and so on."""
    present = {effect.name: effect for effect in REGISTRY if effect.name in set(names)}
    gone = {name}
    while more := {other for other, effect in present.items() if other not in gone and gone & set(effect.needs)}:
        gone |= more
    return ordered(gone - {name})


def requirements(name: str, names: Collection[str], scene: Scene) -> Names:
    """What comes with this one beside the names: what it needs, what that needs, and so on.

    Flow brings the yield stress of a law that has one: without it the filament would be another material, a liquid.
    """
    known = {effect.name: effect for effect in REGISTRY}
    wanted = {name}
    while more := {need for one in wanted for need in known[one].needs} - wanted:
        wanted |= more
    if VISCOUS_FLOW.name in wanted - set(names) and YIELDING.applies(scene):
        wanted.add(YIELDING.name)
    return ordered(wanted - {name, *names})


def everything(scene: Scene, names: Collection[str]) -> Names:
    """All that the scene can have; rotary inertia, which adds a wave of its own, only if it is among the names."""
    every = {effect.name for effect in REGISTRY if effect.applies(scene) and effect != ROTARY_INERTIA}
    return ordered(every | set(names))


def with_effects(scene: Scene, names: Names) -> Scene:
    """The scene with this list of effects; numbers of fibres and orders that would bring fibres back are taken out."""
    changes: dict[str, object] = {"run.effects": list(names)}
    if FIBRES.name not in names:
        changes["numerics.fibres"] = None
        if (scene.numerics.order or 0) > 1:
            changes["numerics.order"] = None
    return scene.replace(changes)


def obstacle(effect: Effect, scene: Scene, names: Collection[str]) -> str:
    """Why an effect can be neither left out nor put in; an empty text where nothing is known to stand against it."""
    if not effect.applies(scene):
        return f"cannot be had: {why_not(effect, scene)}"
    if effect.name not in names:
        return ""
    for one in (effect, *(other for other in REGISTRY if other.name in dependants(effect.name, names))):
        if why := one.indispensable(scene):
            return f"cannot be left out: {why}" if one is effect else f"{one.name} would go with it, but {why}"
    return ""


_SHORT = 1.0
"""Runs below this many seconds are repeated: what else the machine does would show."""

_REPEATS = 3


@dataclass(frozen=True)
class PricedRun:
    """A run of one list of effects."""

    effects: tuple[str, ...]  # Names in force
    # shape (frames,); Output times [s] and height of the midpoint [m]; fewer frames where the run ended early.
    time: Floats
    midpoint: Floats
    states: int  # Differential and algebraic unknowns
    algebraic: int
    instructions: int  # Elementary operations in one evaluation of the right-hand side
    solve: float  # Wall time of the integration [s], the median of three where it is short
    solver: str  # The integrator that these effects call for
    outcome: Outcome  # Verdict
    message: str  # Why it is not a success

    @property
    def reach(self) -> float:
        """Largest |midpoint| [m]."""
        heights = np.abs(self.midpoint[np.isfinite(self.midpoint)])
        return float(heights.max()) if heights.size else 0.0


def _plain(run: PricedRun) -> dict[str, Any]:
    """A run as lists, text and numbers; not its time, which is measured anew."""
    told = {"time": run.time.tolist(), "midpoint": run.midpoint.tolist(), "outcome": run.outcome.name}
    return asdict(run) | told | {"solve": math.nan}


def _read(told: dict[str, Any]) -> PricedRun:
    arrays = {name: np.array(told[name], dtype=float) for name in ("time", "midpoint")}
    return PricedRun(**{**told, **arrays, "effects": tuple(told["effects"]), "outcome": Outcome[told["outcome"]]})


_FORM = json_form(_plain, _read)


def priced_run(scene: Scene, progress: Progress, first: Trajectory | None = None) -> PricedRun:
    """Run a scene with a list of effects and take down what it cost."""
    with watched() as interrupts:
        try:
            run = stored(
                key_of("priced run", identity_of(scene), first is None), lambda: _priced(scene, progress, first), _FORM
            )
            if math.isnan(run.solve):
                # The answer is from the store; a time is worth something only beside others of the same command.
                prepared = build(scene, choose_effects(scene))
                run = replace(run, solve=median(_times(prepared, progress, [])))
            return run
        finally:
            interrupts.check()


def _priced(scene: Scene, progress: Progress, first: Trajectory | None) -> PricedRun:
    run = first or simulated(without_estimate(scene), progress)
    prepared = build(scene, choose_effects(scene))
    graph = prepared.graph
    # What was given may come from the store: its time is not of this command.
    known = [] if first else [float(run.summary["wall_s"]["solve"])]
    return PricedRun(
        effects=tuple(run.summary["effects"]),
        time=run.data["time"].values,
        midpoint=run.data["midpoint"].values,
        states=int(graph.x.numel()),
        algebraic=int(graph.z.numel()),
        instructions=graph.instructions,
        solve=median(_times(prepared, progress, known)),
        solver=run.summary["solver"],
        outcome=run.outcome,
        message=run.summary["message"],
    )


def _times(prepared: Prepared, progress: Progress, known: list[float]) -> list[float]:
    """Wall times of the integration [s], those that are known among them; several where it is short."""
    found = [*known]
    while not found or (found[0] < _SHORT and len(found) < _REPEATS):
        start = time.perf_counter()
        prepared.solve(progress)
        found.append(time.perf_counter() - start)
    return found


def base_run(scene: Scene, listener: Progress) -> tuple[int, float, PricedRun]:
    """Run a scene as it is: its cells, their grading, and the run."""
    first = recalled(scene, listener)
    names, cells = tuple(first.summary["effects"]), int(first.summary["cells"])
    listed = on_grid(scene, names, cells)
    # Theories grade their grids differently: on one grid only physics differs.
    grading = scene.numerics.grading or choose_grading(listed, cells)
    return cells, grading, priced_run(listed.replace({"numerics.grading": grading}), listener, first)


def on_grid(scene: Scene, names: Names, cells: int) -> Scene:
    """The scene with these effects, and so many cells per half span."""
    return with_effects(scene.replace({"numerics.cells": cells}), names)


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
    """One effect, put in or left out."""

    effect: str  # Its name
    in_force: bool  # Whether the base holds it: then it was left out, otherwise put in
    also: Names  # Effects that went with it, since they need it or it needs them; empty without a run
    variant: PricedRun | None  # The run without it, or with it; None where there is none
    # The base but for `also`, or the base itself where that cannot be had: against it the effect's own share is
    # measured. None without a variant.
    reference: PricedRun | None
    scale: float  # Largest ``|midpoint|`` of the base [m]
    # Of the midpoint against the base, relative to `scale`; None where there is nothing to compare.
    change: float | None
    change_final: float | None
    estimate: float | None  # Change that the program expected; None where the scene cannot have the effect
    meaning: str  # What the estimate is
    reason: str  # Why there is no run; empty where there is one

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


_NAMED = 4
"""So many effects are named with their change; the rest are counted."""

_DEAR = 1.5
"""Cost in time from which it is worth a word."""


_NAMELESS, _SMALLEST = 0.99e-6, "0.0001 %"
"""Changes below this are told as below this."""


def reading(pricing: Pricing) -> str:
    """Say what the table says: what moves the answer, what fails, what goes unnoticed, what was left out.

    "Unnoticed" is a change below the accuracy asked. Each effect speaks for its own share.
    """
    accuracy = pricing.scene.run.accuracy
    inside, outside = ([row for row in pricing.rows if row.in_force is side] for side in (True, False))
    parts = [_movers(_beyond(inside, accuracy), "moves the midpoint"), *_failures(inside, "without")]
    quiet = [row.effect for row in inside if (share := row.share) is not None and share <= accuracy]
    if quiet:
        parts.append(f"{listed(quiet)} {'goes' if len(quiet) == 1 else 'go'} unnoticed")
    missed = _beyond(outside, accuracy)
    if missed:
        parts.append(f"left out, {_movers(missed, 'would move it')}")
    else:
        harmless = [share for row in outside if (share := row.share) is not None]
        if harmless:
            largest = max(harmless)
            bound = f"as much as {_SMALLEST}" if 0 < largest < _NAMELESS else f"more than {percent(largest)}"
            parts.append(f"nothing that was left out would move it by {bound}")
    parts += _failures(outside, "with")
    said = "; ".join(part for part in parts if part) or "no effect can be put in or left out"
    if pricing.base.outcome.is_success:
        return said
    return f"not to be trusted, since the run itself ends as {pricing.base.outcome.name}: {said}"


def percent(value: float) -> str:
    """A share as per cent with two digits; beyond tenfold as a factor."""
    if value >= 10:
        return f"{float(f'{value:.2g}'):.6g} times its largest value"
    share = 100 * value
    return f"{float(f'{share:.2g}'):g} %" if value >= _NAMELESS or value == 0 else f"less than {_SMALLEST}"


def listed(names: Sequence[str], word: str = "and") -> str:
    """``a, b and c``; beyond four the rest are counted."""
    if len(names) > _NAMED:
        return f"{', '.join(names[:_NAMED])} {word} {len(names) - _NAMED} more"
    return f" {word} ".join(filter(None, [", ".join(names[:-1]), names[-1]]))


def _beyond(rows: Sequence[PricingRow], accuracy: float) -> list[tuple[float, PricingRow]]:
    """Rows that change the answer by more than was asked for, the largest first."""
    changes = [(share, row) for row in rows if (share := row.share) is not None and share > accuracy]
    return sorted(changes, key=lambda pair: -pair[0])


def _movers(found: Sequence[tuple[float, PricingRow]], verb: str) -> str:
    """``inertia moves the midpoint by 12 %, shear by 1.4 % for 5 times the time``."""
    if not found:
        return ""
    (largest, first), *others = found[:_NAMED]
    shown = [f"{first.effect} {verb} by {percent(largest)}{_dear(first)}"]
    shown += [f"{row.effect} by {percent(share)}{_dear(row)}" for share, row in others]
    rest = len(found) - len(shown)
    if rest:
        shown.append(f"{rest} more by {percent(found[_NAMED][0])} or less")
    return ", ".join(shown)


def _dear(row: PricingRow) -> str:
    ratio = row.time_ratio
    return f" for {float(f'{ratio:.2g}'):g} times the time" if ratio is not None and ratio >= _DEAR else ""


def _failures(rows: Sequence[PricingRow], word: str) -> list[str]:
    """``without bending and yielding the run ends as no_convergence``, a part for each outcome."""
    ends: dict[str, list[str]] = {}
    for row in rows:
        if row.variant is not None and row.fails:
            ends.setdefault(row.variant.outcome.name, []).append(row.effect)
    return [f"{word} {listed(names, 'or')} the run ends as {outcome}" for outcome, names in ends.items()]


@dataclass(frozen=True)
class Unpriced:
    """A scene whose own run could not be made."""

    name: str  # Of the scene
    reason: str  # Why


def price_bundled(
    names: Iterable[str], listening: Callable[[str, Scene], Listening] | None = None, changes: Iterable[str] = ()
) -> Iterator[Pricing | Unpriced]:
    """Price scenes by name, one at a time, so that each can be written before the next begins."""
    overrides = list(changes)
    for name in names:
        try:
            scene = load_scene(name, overrides)
            yield price_effects(scene, listening and listening(name, scene), name)
        # RuntimeError is CasADi's own: an integrator that cannot even begin.
        except (SoftcatError, RuntimeError) as error:
            yield Unpriced(name, " ".join(str(error).split()))
