"""Lists of effects: dependencies between effects, and scenes with a list of effects."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from softcat_sym.effects.bending import BENDING
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.extensibility import EXTENSIBILITY
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.effects.finite_stretch import FINITE_STRETCH
from softcat_sym.effects.gravity_ramp import GRAVITY_RAMP
from softcat_sym.effects.inertia import INERTIA
from softcat_sym.effects.large_rotation import LARGE_ROTATION
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.selection import bare, why_not
from softcat_sym.effects.shear import SHEAR
from softcat_sym.effects.thinning import THINNING
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.viscous_stress import VISCOUS_STRESS
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.scene import Scene

Names = tuple[str, ...]


def ordered(names: Collection[str]) -> Names:
    """The names in the order of the registry."""
    return tuple(effect.name for effect in REGISTRY if effect.name in names)


def dependants(name: str, names: Iterable[str]) -> Names:
    """Names that depend on this one, directly or not."""
    present, gone = [effect for effect in REGISTRY if effect.name in set(names)], {name}
    while more := {effect.name for effect in present if gone & set(effect.needs)} - gone:
        gone |= more
    return ordered(gone - {name})


def requirements(name: str, names: Collection[str], scene: Scene) -> Names:
    """Further effects, not among the names, that this one requires, directly or not.

    Flow requires yielding for a law with a yield stress: otherwise the material would be a liquid.
    """
    needed = {name}
    while more := {need for effect in REGISTRY if effect.name in needed for need in effect.needs} - needed:
        needed |= more
    if VISCOUS_FLOW.name in needed - set(names) and YIELDING.applies(scene):
        needed.add(YIELDING.name)
    return ordered(needed - {name, *names})


def everything(scene: Scene, names: Collection[str]) -> Names:
    """All effects that the scene can have; those that make runs many times longer only if they are among the names."""
    return ordered({effect.name for effect in REGISTRY if effect.applies(scene) and not effect.dear} | set(names))


def with_effects(scene: Scene, names: Names) -> Scene:
    """The scene with this list of effects; without fibres, numerics.fibres and numerics.order that imply them go."""
    changes: dict[str, object] = {"run.effects": list(names)}
    if FIBRES.name not in names:
        changes["numerics.fibres"] = None
        if (scene.numerics.order or 0) > 1:
            changes["numerics.order"] = None
    return scene.replace(changes)


def of_a_rod(*, moves: bool, damped: bool) -> Names:
    """Effects of an elastic filament with shear; with inertia if it moves, with a viscous stress if it is damped."""
    always = (BENDING, EXTENSIBILITY, FINITE_STRETCH, THINNING, LARGE_ROTATION, SHEAR)
    sometimes = ((INERTIA, moves), (VISCOUS_STRESS, damped))
    return ordered({effect.name for effect in (*always, *(effect for effect, holds in sometimes if holds))})


def obstacle(effect: Effect, scene: Scene, names: Collection[str]) -> str:
    """Why an effect can be neither left out nor put in; empty if no reason is known."""
    if not effect.applies(scene):
        return f"cannot be had: {why_not(effect, scene)}"
    if effect.name not in names:
        return ""
    if why := effect.indispensable(scene):
        return f"cannot be left out: {why}"
    gone = dependants(effect.name, names)
    others = ((other.name, other.indispensable(scene)) for other in REGISTRY if other.name in gone)
    return next((f"{name} would go with it, but {why}" for name, why in others if why), "")


def named(*names: str) -> tuple[Effect, ...]:
    """The effects of these names, in the order of the registry."""
    return tuple(effect for effect in REGISTRY if effect.name in names)


def terms_of(scene: Scene, names: Iterable[str]) -> Terms:
    """The terms that effects of these names select."""
    terms = bare(scene)
    for effect in named(*names):
        terms = effect.added_to(terms, scene)
    return terms


def string_of(scene: Scene, names: Collection[str]) -> tuple[set[str], bool]:
    """Effects of a filament without bending, and whether its weight must be applied slowly.

    A string without inertia has no shape without weight: it is loaded from the start, or slowly. Extensibility is
    added, as a string carries its load in tension only.
    """
    terms, effects = terms_of(scene, names), {*names, EXTENSIBILITY.name}
    if terms.inertia:
        return effects, False
    if terms.flows:
        return effects | {INERTIA.name, GRAVITY_RAMP.name}, True
    return effects - {GRAVITY_RAMP.name, VISCOUS_STRESS.name}, False
