"""Whether what a run left out mattered: each effect's measure on the finished run, against the accuracy asked."""

from __future__ import annotations

from softcat_sym.effects import Effects, Estimate
from softcat_sym.effects.motion import Motion
from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.rotary_inertia import ROTARY_INERTIA
from softcat_sym.scene import Scene
from softcat_sym.solve import Outcome


def measures(scene: Scene, effects: Effects, motion: Motion) -> dict[str, Estimate]:
    """The size of every effect that the scene has and the run left out, from how the filament has moved.

    Parameters
    ----------
    scene : Scene
        What was asked.
    effects : Effects
        What was in force.
    motion : Motion
        What the run has shown.
    """
    return {
        decision.effect.name: decision.effect.estimate(scene, motion)
        for decision in effects.decisions
        if not decision.in_force and decision.estimate is not None
    }


def overlooked(scene: Scene, effects: Effects, measured: dict[str, Estimate], outcome: Outcome) -> dict[str, str]:
    """Effects that ``auto`` has left out and the run shows to matter more than the accuracy asked, and how.

    A run that fails shows nothing: then it is everything in the published theory that was left out, and of one that
    localises the gradient that limits a neck. Nothing where the scene names its effects: what the user has left out is
    reported, not repaired.
    """
    if scene.run.effects != "auto" or scene.run.closure == "printed" or scene.model == "small-deflection":
        return {}
    omitted = [decision.effect for decision in effects.decisions if decision.effect.name in measured]
    if outcome is Outcome.localised:
        return {e.name: "without it a neck has no width" for e in omitted if e is NECKING_GRADIENT}
    if not outcome.is_success and outcome is not Outcome.energy_drift:
        # Without rotary inertia the angles of sheared sections are algebraic: a stiff pull may leave them no solution.
        turning = set(ROTARY_INERTIA.needs) <= set(effects.names)
        wanted = [e for e in omitted if e.in_paper or (turning and e is ROTARY_INERTIA)]
        return {e.name: "the run without it failed" for e in wanted}
    return {
        effect.name: f"the run without it shows that it is worth {measured[effect.name]}"
        for effect in omitted
        if measured[effect.name].value > scene.run.accuracy and not effect.spared(scene)
    }


def spared(scene: Scene, effects: Effects, measured: dict[str, Estimate]) -> list[str]:
    """Warn of effects that ``auto`` leaves out for what they cost, and that the run shows to matter."""
    if scene.run.effects != "auto":
        return []
    return [
        f"{decision.effect.name} is left out ({why}), but may be worth {measured[decision.effect.name]}; "
        "name it in run.effects to have it"
        for decision in effects.decisions
        if decision.effect.name in measured
        and measured[decision.effect.name].value > scene.run.accuracy
        and (why := decision.effect.spared(scene))
    ]
