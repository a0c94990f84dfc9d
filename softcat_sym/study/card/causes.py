"""Which effect makes a rule fail: the solver is run without what the rule leaves out, then with one effect put back."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from softcat_sym.errors import SoftcatError
from softcat_sym.scene import Scene
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.study.card.contents import HOLDS, Blame, Rule
from softcat_sym.study.card.rules import MEASURES, RuleOfTheField
from softcat_sym.study.variants import dependants, ordered, with_effects

if TYPE_CHECKING:
    from softcat_sym.trajectory import Trajectory

_STIFFER = 100.0
_SAID = 2

_NEEDS = {"shear": "stretching"}
"""Causes that cannot be put back without another, which then counts for itself: a beam that shears also stretches."""

LEAVING_OUT: Mapping[str, tuple[str, ...]] = {
    # At rest without flow: a filament that can lose nothing would swing for ever.
    "flow": ("viscous-flow", "viscous-stress", "inertia"),
    "yield stress": ("yielding",),
    "stretching": ("extensibility",),
    "bending": ("bending",),
    "shear": ("shear",),
    "inertia": ("inertia",),
    "surface": ("surface-tension",),
    "slopes": ("large-rotation", "finite-stretch", "thinning"),
    "elasticity": (),
    "ends": (),
}
"""Effects that go, by cause; stiffness and ends are changed instead."""

WORDS: Mapping[str, str] = {
    "flow": "flow",
    "yield stress": "yield stress",
    "stretching": "tension",
    "bending": "bending",
    "shear": "shear",
    "inertia": "inertia",
    "surface": "surface tension",
    "slopes": "finite strain and slope",
    "elasticity": "elasticity",
    "ends": "hold of the ends",
}

Told = Callable[[str], None]


class Solver:
    """Runs of one filament with causes left out, each made once.

    Parameters
    ----------
    run : Trajectory
        The filament as it is; its grid is kept.
    told : callable, optional
        Told what is about to run.
    """

    def __init__(self, run: Trajectory, told: Told | None = None) -> None:
        self._run, self._told = run, told
        self._names = tuple(run.summary["effects"])
        self._known: dict[tuple[frozenset[str], str], Trajectory | None] = {}

    def in_force(self, cause: str, ends: str) -> bool:
        """Whether there is something to leave out."""
        scene = self._run.scene
        if cause == "ends":
            return bool(ends) and {scene.ends.left, scene.ends.right} != {ends}
        if cause == "elasticity":
            return scene.material.youngs_modulus is not None
        return LEAVING_OUT[cause][0] in self._names

    def without(self, causes: frozenset[str], ends: str) -> Trajectory | None:
        """The run without them; None where it cannot be had or is not to be trusted."""
        key = (causes, ends if "ends" in causes else "")
        if key not in self._known:
            if self._told is not None:
                self._told(f"without {', '.join(sorted(WORDS[cause] for cause in causes))}")
            self._known[key] = self._variant(causes, ends)
        return self._known[key]

    def _variant(self, causes: frozenset[str], ends: str) -> Trajectory | None:
        try:
            run = simulated(without_estimate(self._changed(causes, ends)))
        except SoftcatError:
            return None
        return run if run.outcome.is_success else None

    def _changed(self, causes: frozenset[str], ends: str) -> Scene:
        gone = {effect for cause in causes for effect in LEAVING_OUT[cause]} & set(self._names)
        for effect in tuple(gone):
            gone |= set(dependants(effect, self._names))
        kept, changes = self._at_rest(set(self._names) - gone, gone)
        if "bending" in gone:
            # A beam that was run without tension has nothing else to hang by.
            kept.add("extensibility")
        scene = with_effects(self._run.scene, ordered(kept))
        if scene.numerics.cells is None:
            changes["numerics.cells"] = (self._run.summary.get("resolution") or {}).get("cells")
        if "ends" in causes:
            changes |= {"ends.left": ends, "ends.right": ends}
        if "elasticity" in causes:
            changes["material.youngs_modulus"] = f"{_STIFFER * (scene.material.youngs_modulus or 0.0)!r} Pa"
        return scene.replace(changes)

    def _at_rest(self, kept: set[str], gone: set[str]) -> tuple[set[str], dict[str, object]]:
        """A string without inertia has no shape before there is weight: it is loaded from the start, or slowly."""
        if "bending" not in gone or "inertia" in kept:
            return kept, {}
        if "viscous-flow" not in kept:
            return kept - {"gravity-ramp", "viscous-stress"}, {}
        scene = self._run.scene
        slow = max(scene.load.ramp, scene.run.duration / 2)
        return kept | {"inertia", "gravity-ramp"}, {"load.ramp": f"{slow!r} s"}


def blamed(rule: Rule, own: RuleOfTheField, solver: Solver) -> Rule:
    """Find what makes a rule fail, and say it.

    First the solver is run without anything that the rule leaves out: there they must agree. Then each effect is put
    back alone; what takes the two apart is to blame, and by how much is said.

    Parameters
    ----------
    rule : Rule
        As applied.
    own : RuleOfTheField
        The rule, for what it leaves out.
    solver : Solver
        Runs the variants.
    """
    if rule.error is None:
        return rule
    if rule.holds:
        return replace(rule, text="holds")
    neglected = [cause for cause in own.neglects if solver.in_force(cause, own.ends)]
    bare = _error(own, solver, frozenset(neglected))
    if bare is None:
        return replace(rule, text="cannot be told: without what it leaves out the filament has no answer")
    alone = {cause: _alone(own, solver, frozenset(neglected), cause, bare) for cause in neglected}
    known = [Blame(WORDS[cause], error) for cause, error in alone.items() if error is not None]
    apart = [one for one in known if abs(one.error) > HOLDS and abs(one.error - bare) > HOLDS * max(1.0, 1 + bare)]
    blames = tuple(sorted(apart, key=lambda one: -_off(one.error)))
    failed = [WORDS[cause] for cause, error in alone.items() if error is None]
    return replace(rule, bare=bare, blames=blames, text=_sentence(blames, failed, bare, rule.error))


def _alone(own: RuleOfTheField, solver: Solver, neglected: frozenset[str], cause: str, bare: float) -> float | None:
    """Error with one cause put back; of one that brings another along, its factor beyond that of the other."""
    needed = _NEEDS.get(cause)
    if needed not in neglected:
        return _error(own, solver, neglected - {cause})
    both, other = _error(own, solver, neglected - {cause, needed}), _error(own, solver, neglected - {needed})
    return None if both is None or other is None else (1 + both) / (1 + other) * (1 + bare) - 1


def _error(own: RuleOfTheField, solver: Solver, causes: frozenset[str]) -> float | None:
    """Rule over solver minus one, of the filament without some causes."""
    run = solver.without(causes, own.ends)
    if run is None:
        return None
    predicted = own.predict(run.scene, run)
    said = MEASURES[own.quantity](run)
    return None if isinstance(predicted, str) or not said > 0 else predicted / said - 1


def _off(error: float) -> float:
    """Size of an error, the same for a factor and for its reciprocal."""
    return abs(math.log1p(error)) if error > -1 else math.inf


def _sentence(blames: tuple[Blame, ...], failed: list[str], bare: float, error: float) -> str:
    """The strongest causes, each with what it does alone; said so where none alone does half of it."""
    said = [f"{one.cause} ({percent(one.error)})" for one in blames[:_SAID]]
    if not said:
        return "no single effect: several together" if not failed else f"perhaps {', '.join(failed)}: no answer with it"
    rest = f"; else {percent(bare)}" if abs(bare) > HOLDS else ""
    weak = "only together: " if len(said) + len(failed) > 1 and _off(blames[0].error) < _off(error) / 2 else ""
    return weak + ", ".join(said) + rest


def percent(error: float) -> str:
    """A relative error in words: ``+3.2 %``, or a factor where it is large."""
    if error >= 9:
        return f"× {1 + error:.0f}" if error < 9999 else f"× {1 + error:.1e}"
    return f"{100 * error:+.{1 if abs(error) < 0.0995 else 0}f} %".replace("-", "\N{MINUS SIGN}")
