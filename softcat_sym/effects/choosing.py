"""Which effects are in force for a scene, and why."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import dataclass

from softcat_sym.effects.bending import BENDING
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.finite_stretch import FINITE_STRETCH
from softcat_sym.effects.gravity_ramp import GRAVITY_RAMP
from softcat_sym.effects.inertia import INERTIA
from softcat_sym.effects.large_rotation import LARGE_ROTATION
from softcat_sym.effects.thinning import THINNING
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.equations.filament import Terms
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene

REGISTRY: tuple[Effect, ...] = (
    INERTIA,
    BENDING,
    FINITE_STRETCH,
    THINNING,
    LARGE_ROTATION,
    VISCOUS_FLOW,
    YIELDING,
    GRAVITY_RAMP,
)


@dataclass(frozen=True, slots=True)
class Effects:
    """The physics of one run.

    Attributes
    ----------
    in_force : tuple of Effect
        In the order of the registry.
    reasons : mapping of str to str
        Why each is in force.
    left_out : mapping of str to float
        Estimate of each effect that the scene has but the run does not.
    """

    in_force: tuple[Effect, ...]
    reasons: Mapping[str, str]
    left_out: Mapping[str, float]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the effects in force."""
        return tuple(effect.name for effect in self.in_force)

    def terms(self) -> Terms:
        """The terms that these effects pick."""
        terms = Terms()
        for effect in self.in_force:
            terms = effect.contribute(terms)
        return terms


def choose_effects(scene: Scene) -> Effects:
    """Choose the effects of a scene: those it names, or the paper's list.

    Raises
    ------
    SceneError
        If it names an effect that is unknown, that its law or load cannot have, or that needs another one.
    """
    asked = scene.run.effects
    _refuse_law(scene)
    if isinstance(asked, str):
        chosen = tuple(effect for effect in REGISTRY if effect.applies(scene))
        why = "in the paper's list"
    else:
        _refuse(scene, asked)
        chosen = tuple(effect for effect in REGISTRY if effect.name in asked)
        why = "named in run.effects"
    reasons = {effect.name: f"{why}; {effect.estimate(scene)}" for effect in chosen}
    left_out = {e.name: e.estimate(scene).value for e in REGISTRY if e.applies(scene) and e not in chosen}
    return Effects(chosen, reasons, left_out)


def _refuse_law(scene: Scene) -> None:
    """The small-deflection model has one plastic stretch for the whole filament, which only a linear law allows."""
    if scene.model == "small-deflection" and YIELDING.applies(scene):
        raise SceneError(
            [Fault("material.law", f"{scene.material.law!r} with model 'small-deflection'", "elastic or maxwell")]
        )


def _refuse(scene: Scene, asked: tuple[str, ...]) -> None:
    known = {effect.name: effect for effect in REGISTRY}
    faults: list[Fault] = []
    for name in asked:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f"did you mean {near[0]!r}? " if near else ""
            faults.append(Fault("run.effects", f"unknown effect {name!r}", f"{hint}one of {', '.join(known)}"))
            continue
        effect = known[name]
        if not effect.applies(scene):
            faults.append(Fault("run.effects", f"{name!r} cannot be had: {effect.without_it}", f"leave {name!r} out"))
        faults += [
            Fault("run.effects", f"{name!r} without {need!r}", f"add {need!r} or leave {name!r} out")
            for need in effect.needs
            if need not in asked
        ]
    if faults:
        raise SceneError(faults)
