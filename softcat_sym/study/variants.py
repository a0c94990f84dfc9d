"""Lists of effects one effect away from another: what leaves with it, what comes with it."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from softcat_sym.effects import REGISTRY, Effect
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.effects.refusing import why_not
from softcat_sym.effects.rotary_inertia import ROTARY_INERTIA
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.scene import Scene

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
    """The scene with this list of effects; numbers of fibres and orders that would bring fibres back are taken out.

    Raises
    ------
    SceneError
        If the list is one that the scene cannot have.
    """
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
