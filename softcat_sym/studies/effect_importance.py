"""Value of each effect: change of the answer against change of the cost, with effects put in or left out in turn."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from softcat_sym.discretization.grid import choose_grading
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Drawable
from softcat_sym.effects.effect import Estimate
from softcat_sym.effects.effect_sets import (
    Names,
    dependants,
    everything,
    obstacle,
    ordered,
    requirements,
    with_effects,
)
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.selection import Decision, choose_effects
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.results.run import Run, run_form
from softcat_sym.scene.reading import as_scene
from softcat_sym.scene.scene import Scene, refuse_settled
from softcat_sym.scene.units import length_text
from softcat_sym.simulate import identity_of, recalled, simulated, without_estimate
from softcat_sym.single_run import build
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Progress, Silence, watched
from softcat_sym.store import key_of, stored

if TYPE_CHECKING:
    from softcat_sym.scene.reading import Changes, SceneLike

_SHORT, _REPEATS = 1.0, 3
"""Runs shorter than so many seconds are repeated so often, to reduce the influence of other load on the machine."""


@dataclass(frozen=True)
class PricedRun:
    """A run of one list of effects."""

    effects: tuple[str, ...]  # Names in force
    time: Floats  # shape (frames,); output times [s], fewer where the run ended early
    midpoint: Floats  # shape (frames,); its height [m]
    states: int  # Differential and algebraic unknowns
    algebraic: int
    instructions: int  # Elementary operations in one evaluation of the right-hand side
    solve: float  # Wall time of the integration [s], the median of three where it is short
    solver: str  # The integrator that these effects call for
    outcome: Outcome
    message: str  # Why it is not a success

    @property
    def reach(self) -> float:
        """Largest |midpoint| [m]."""
        return float(np.abs(self.midpoint[np.isfinite(self.midpoint)]).max(initial=0.0))

    def cost(self) -> dict[str, Any]:
        """Sizes, time and verdict as plain values."""
        named = {name: getattr(self, name) for name in ("states", "algebraic", "instructions")}
        ending = {"solver": self.solver, "outcome": self.outcome.name, "message": self.message}
        return {**named, "solve_s": self.solve, **ending}


def priced_run(scene: Scene, progress: Progress, run: Run | None = None) -> PricedRun:
    """Run a scene with a list of effects, unless it was run before, and measure its cost.

    The answer may come from the store; times are always measured, as only times of one command are comparable.
    """
    seconds: list[float] = []

    def solve() -> Run:
        found = simulated(once, progress)
        seconds.append(float(found.summary["wall_s"]["solve"]))
        return found

    with watched():
        once = without_estimate(scene)
        run = run or stored(key_of("run", identity_of(once)), solve, run_form(once))
        prepared = build(scene, choose_effects(scene))
        while not seconds or (seconds[0] < _SHORT and len(seconds) < _REPEATS):
            start = time.perf_counter()
            prepared.solve(progress)
            seconds.append(time.perf_counter() - start)
    graph, summary = prepared.graph, run.summary
    return PricedRun(
        effects=tuple(summary["effects"]),
        time=run.data["time"].values,
        midpoint=run.data["midpoint"].values,
        states=len(graph.start),
        algebraic=len(graph.straight),
        instructions=graph.symbolic.instructions,
        solve=median(seconds),
        solver=summary["solver"],
        outcome=run.outcome,
        message=summary["message"],
    )


EVERYTHING = "everything"
"""Name of the row with all effects that the scene can have, except rotary inertia."""

DEFINITION = (
    "change: max |variant - base|/max |base| of the midpoint's height over the frames both reached; "
    "change_final: (variant - base)/max |base| at the last frame; own_change: the same maximum against the run in "
    "which only the effects that went with it are changed; ratios are with the effect over without it, all else equal"
)


@dataclass(frozen=True)
class PricingRow:
    """One effect, put in or left out."""

    effect: str
    in_force: bool  # Whether the base includes it: then it was left out, otherwise put in
    also: Names  # Effects that were changed with it, as they need it or it needs them; empty without a run
    variant: PricedRun | None  # The run without it, or with it; None if there is none
    # The base with `also` changed, or the base itself if the scene cannot have that: the reference of the effect's own
    # share. None without a variant.
    reference: PricedRun | None
    scale: float  # Largest ``|midpoint|`` of the base [m]
    change: float | None  # Of the midpoint against the base, over `scale`; None if there is nothing to compare
    change_final: float | None
    estimate: float | None  # Change that the program estimates; None if the scene cannot have the effect
    meaning: str  # Meaning of the estimate
    reason: str  # Why there is no run; empty where there is one

    @property
    def fails(self) -> bool:
        """Whether there is a run and it fails."""
        return self.variant is not None and not self.variant.outcome.is_success

    @property
    def own_change(self) -> float | None:
        """Change that the effect makes by itself, relative to `scale`; None where a run fails."""
        if self.variant is None or self.reference is None or self.fails:
            return None
        # Without further changes the reference is the base, which may fail.
        is_valid = self.reference.outcome.is_success or not self.also
        return _change(self.variant, self.reference, self.scale) if is_valid else None

    @property
    def share(self) -> float | None:
        """The smaller of the total change and the effect's own change."""
        changes = [value for value in (self.change, self.own_change) if value is not None]
        return min(changes) if changes and not self.fails else None

    @property
    def _with_and_without(self) -> tuple[PricedRun, PricedRun] | None:
        """Runs with the effect and without it, all else equal; None where one is missing."""
        if self.variant is None or self.reference is None:
            return None
        return (self.reference, self.variant) if self.in_force else (self.variant, self.reference)

    @property
    def sags(self) -> str:
        """Name of the effect, and the last depth of the midpoint with it and without it."""
        if self._with_and_without is None:
            return self.effect
        sag, without = (length_text(-float(run.midpoint[-1])) for run in self._with_and_without)
        return f"{self.effect} (sag {sag}; without it {without})"

    def ratio(self, size: Callable[[PricedRun], float]) -> float | None:
        """Ratio of a size with the effect to that without it, all else equal."""
        if self._with_and_without is None:
            return None
        having, lacking = self._with_and_without
        return size(having) / size(lacking) if size(lacking) > 0 else None

    def to_dict(self) -> dict[str, Any]:
        """Entry of the effect in ``effects.json``."""
        return {
            "effect": self.effect,
            "in_force": self.in_force,
            "also": list(self.also),
            "change": self.change,
            "change_final": self.change_final,
            "own_change": self.own_change,
            "share": self.share,
            "estimate": self.estimate,
            "estimate_is": self.meaning,
            "states_ratio": self.ratio(lambda run: run.states + run.algebraic),
            "instructions_ratio": self.ratio(lambda run: run.instructions),
            "time_ratio": self.ratio(lambda run: run.solve),
            "run": None if self.variant is None else self.variant.cost(),
            "reason": self.reason,
        }


@dataclass(frozen=True)
class Pricing(Drawable):
    """The effects of one scene, priced.

    Attributes
    ----------
    name : str
        Name of the scene; may be empty.
    scene : Scene
        The scene as it was given.
    base : PricedRun
        The run of that scene.
    cells : int
        Cells per half span of every run.
    grading : float
        Longest over shortest cell of every run.
    rows : tuple of PricingRow
        One row for each requested effect, in the order of the registry.
    everything : PricingRow
        All effects that the scene can have at once, against the base.
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

    @property
    def reading(self) -> str:
        """Text with the effects that move the midpoint by more than the requested accuracy, the largest first."""
        parts = []
        for word, in_force in (("in force", True), ("left out", False)):
            shares = [(row.share or 0.0, row) for row in self.rows if row.in_force is in_force]
            large = sorted((one for one in shares if one[0] > self.scene.run.accuracy), key=lambda one: -one[0])
            parts.append(f"{word}: {', '.join(row.sags for _, row in large) or 'none'}")
        trusted = "" if self.base.outcome.is_success else f"not to be trusted ({self.base.outcome.name}); "
        return f"{trusted}beyond the accuracy asked, {'; '.join(parts)}"

    def __repr__(self) -> str:
        return (
            f"Pricing {self.scene.title!r}: {len(self.rows)} effects\n  {self.reading}\n  .rows, .to_frame(), .plot()"
        )

    def to_dict(self) -> dict[str, Any]:
        """Content of ``effects.json``."""
        base = {"effects": list(self.base.effects), "midpoint_largest_m": self.scale, **self.base.cost()}
        return {
            "scene": self.name,
            "title": self.scene.title,
            "accuracy": self.scene.run.accuracy,
            "reading": self.reading,
            "definition": DEFINITION,
            "cells": self.cells,
            "grading": self.grading,
            "base": base,
            "effects": [row.to_dict() for row in self.rows],
            "everything": self.everything.to_dict(),
        }

    def to_frame(self) -> pd.DataFrame:
        """A row for each effect, and one for everything at once; values that do not exist are missing."""
        rows = [row.to_dict() for row in (*self.rows, self.everything)]
        flat = [{**row, "also": " ".join(row["also"]), **(row.pop("run") or {})} for row in rows]
        return pd.DataFrame(flat, columns=[*rows[0], *self.base.cost()], dtype=object)


def percent(value: float) -> str:
    """A share in per cent with two digits; from ten on, as a factor."""
    if value >= 10:
        return f"× {float(f'{value:.2g}'):g}"
    return f"{float(f'{100 * value:.2g}'):g} %" if value >= 1e-6 or value == 0 else "< 1e-4 %"


def price_effects(
    scene: SceneLike,
    progress: Progress | None = None,
    name: str = "",
    only: Collection[str] | None = None,
    *,
    changes: Changes = (),
) -> Pricing:
    """Run a scene as it is, then with each effect put in or left out in turn, all on the same grid.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The base has the effects of this scene: chosen by ``auto``, the paper's list, or its own list.
    progress : Progress, optional
        Receiver of progress reports; each run begins a stage.
    name : str
        Name of the scene, for tables.
    only : collection of str, optional
        Price only these effects; by default all.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.

    Returns
    -------
    Pricing
        A row for each effect; a row whose variant does not exist or fails has the reason.

    Raises
    ------
    SceneError
        If the scene cannot have the effects that it names, or `only` holds an unknown name.
    KeyboardInterrupt
        On Ctrl-C.
    """
    scene, progress = as_scene(scene, changes), progress or Silence()
    refuse_settled(scene, "variants are compared frame by frame")
    known = [effect.name for effect in REGISTRY]
    requested = known if only is None else only
    if unknown := [effect for effect in requested if effect not in known]:
        accepted = f"one of {', '.join(known)}"
        raise SceneError([Fault("", f"no effect {effect!r} to price", accepted) for effect in unknown])
    stage = f"{name}, " if name else ""
    progress.stage(f"{stage}the scene itself")
    once = without_estimate(scene)
    first = recalled(once, progress)
    names, cells = tuple(first.summary["effects"]), int(first.summary["cells"])
    listed = with_effects(once.replace({"numerics.cells": cells}), names)
    # Theories grade their grids differently; on a common grid only the physics differs.
    grading = scene.numerics.grading or choose_grading(listed, cells)
    listed = listed.replace({"numerics.grading": grading})
    base = priced_run(listed, progress, first)
    runs = _Runs(listed, base, progress, stage, {names: base})
    rows = tuple(_row(each, names, runs) for each in choose_effects(listed).decisions if each.effect.name in requested)
    whole = everything(listed, names)
    variant, also = runs.run(whole, EVERYTHING), ordered(set(whole) - set(names))
    total = _compared(EVERYTHING, False, also, variant, base, None, base)
    return Pricing(name, scene, base, cells, grading, rows, total)


@dataclass
class _Runs:
    """Runs of one scene, one for each list of effects."""

    scene: Scene
    base: PricedRun
    progress: Progress
    stage: str  # Beginning of the names of stages
    finished: dict[Names, PricedRun] = field(default_factory=dict)

    def run(self, names: Names, stage: str) -> PricedRun | str:
        """The run of a list of effects, or why there is none."""
        if names in self.finished:
            return self.finished[names]
        try:
            scene = with_effects(self.scene, names)
            chosen = choose_effects(scene)
            if back := [name for name in chosen.names if name not in names]:
                return f"cannot be left out: {back[0]} comes back, {chosen.reasons[back[0]]}"
            self.progress.stage(f"{self.stage}{stage}")
            self.finished[names] = priced_run(scene, self.progress)
        except SoftcatError as error:
            return " ".join(str(error).split())
        # CasADi raises it for an integrator that cannot start.
        except RuntimeError as error:
            return f"the solver refused: {str(error).splitlines()[0] if str(error) else type(error).__name__}"
        return self.finished[names]


def _row(decision: Decision, names: Names, runs: _Runs) -> PricingRow:
    effect, inside = decision.effect, decision.effect.name in names
    also = dependants(effect.name, names) if inside else requirements(effect.name, names, runs.scene)
    # Effects that are changed with it are so in both runs: the effect's own share is their difference.
    others = ordered(set(names) - set(also) if inside else {*names, *also})
    changed = ordered(set(others) - {effect.name} if inside else {*others, effect.name})
    stage = f"{'without' if inside else 'with'} {effect.name}"
    variant = obstacle(effect, runs.scene, names) or runs.run(changed, stage)
    reference = None if isinstance(variant, str) else runs.run(others, f"{stage}, its own share")
    # If the scene cannot have the others without it, the whole change is its share.
    own = runs.base if isinstance(reference, str) else reference
    return _compared(effect.name, inside, also, variant, own, decision.estimate, runs.base)


def _compared(
    name: str,
    inside: bool,
    also: Names,
    result: PricedRun | str,
    reference: PricedRun | None,
    estimate: Estimate | None,
    base: PricedRun,
) -> PricingRow:
    value, meaning = (estimate.value, estimate.meaning) if estimate else (None, "")
    if isinstance(result, str):
        return PricingRow(name, inside, (), None, None, base.reach, None, None, value, meaning, result)
    final: float | None = None
    if len(result.time) == len(base.time) and base.reach > 0:
        final = _finite(float(result.midpoint[-1] - base.midpoint[-1]) / base.reach)
    change = _change(result, base, base.reach)
    return PricingRow(name, inside, also, result, reference, base.reach, change, final, value, meaning, "")


def _change(run: PricedRun, other: PricedRun, scale: float) -> float | None:
    """Largest distance of two midpoints over the frames that both reached, relative to `scale`."""
    frames = min(len(run.midpoint), len(other.midpoint))
    # The first frame is the start: a run without further frames cannot be compared.
    if frames < 2:
        return None
    apart = np.abs(run.midpoint[:frames] - other.midpoint[:frames])
    apart = apart[np.isfinite(apart)]
    return _finite(float(apart.max()) / scale) if apart.size and scale > 0 else None


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None
