"""Lists of effects that make no sense: unknown names, physics that a law cannot have, effects that miss another."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterable, Mapping

from softcat_sym.effects.effect import SMALL_MODEL, Effect
from softcat_sym.effects.extensibility import EXTENSIBILITY
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene


def refuse_law(scene: Scene) -> None:
    """The small-deflection model has one plastic stretch for the whole filament, which only a linear law allows."""
    if scene.model == "small-deflection" and YIELDING.applies(scene):
        raise SceneError(
            [Fault("material.law", f"{scene.material.law!r} with model 'small-deflection'", "elastic or maxwell")]
        )


def refuse_closure(scene: Scene, chosen: tuple[Effect, ...]) -> None:
    """The printed closure is a plastic state linear through the thickness of a filament that does not shear."""
    beyond = [effect.name for effect in chosen if not effect.in_paper]
    if scene.run.closure == "printed" and beyond:
        key = "fibres" if scene.numerics.fibres is not None else "order"
        asked = getattr(scene.numerics, key)
        found = f"'printed' with numerics.{key} = {asked}" if asked else f"'printed' with {', '.join(beyond)}"
        accepted = "'material', or the published effects without numerics.fibres and with numerics.order = 1"
        raise SceneError([Fault("run.closure", found, accepted)])


def refuse_without(scene: Scene, chosen: tuple[Effect, ...]) -> None:
    """A scene may not leave out what it cannot do without."""
    faults = [
        Fault("run.effects", f"without {effect.name!r}, but {why}", f"add {effect.name!r}")
        for effect in REGISTRY
        if effect not in chosen and effect.applies(scene) and (why := effect.indispensable(scene))
    ]
    if faults:
        raise SceneError(faults)


def why_not(effect: Effect, scene: Scene) -> str:
    """Why a scene cannot have an effect: the model where that is what keeps it out, else the law or the load."""
    if SMALL_MODEL not in effect.without_it:
        return effect.without_it
    small = scene.model == "small-deflection"
    return SMALL_MODEL if small else effect.without_it.removesuffix(f", or {SMALL_MODEL}")


def refuse(scene: Scene, asked: Iterable[str]) -> None:
    """Refuse names that are unknown, that the scene cannot have, or that miss another one: one fault each."""
    known, named = {effect.name: effect for effect in REGISTRY}, tuple(asked)
    whole = [name for name in ("auto", "paper") if name in named]
    if whole:
        # What the rest would miss is not known: it may be what the word stands for.
        accepted = f"{whole[0]!r} by itself, or a list of {', '.join(known)}"
        raise SceneError([Fault("run.effects", f"{whole[0]!r} within a list", accepted)])
    faults: list[Fault] = []
    for name in named:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f" (did you mean {near[0]!r}?)" if near else ""
            faults.append(Fault("run.effects", f"unknown effect {name!r}{hint}", f"one of {', '.join(known)}"))
        elif not known[name].applies(scene):
            found = f"{name!r} cannot be had: {why_not(known[name], scene)}"
            faults.append(Fault("run.effects", found, f"leave {name!r} out"))
        elif missing := _missing(known[name], named, known):
            faults.append(_incomplete(scene, name, _joined(missing)))
    if faults:
        raise SceneError(faults)


def _missing(effect: Effect, named: Collection[str], known: Mapping[str, Effect]) -> list[str]:
    """What an effect needs that is not named, and what that needs, in the order of the registry."""
    found: set[str] = set()
    wanted = set(effect.needs)
    while wanted := wanted - {*named, *found}:
        found |= wanted
        wanted = {need for one in wanted for need in known[one].needs}
    # Extensibility comes by itself with whatever needs it.
    return [name for name in known if name in found and name != EXTENSIBILITY.name]


def _joined(names: list[str]) -> str:
    *first, last = map(repr, names)
    return f"{', '.join(first)} and {last}" if first else last


def _incomplete(scene: Scene, name: str, missing: str) -> Fault:
    if name in scene.run.effects:
        return Fault("run.effects", f"{name!r} without {missing}", f"add {missing}, or leave {name!r} out")
    key = "fibres" if scene.numerics.fibres is not None else "order"
    found = f"{getattr(scene.numerics, key)} resolves fibres, but without {missing}"
    return Fault(f"numerics.{key}", found, f"{missing} in run.effects too, or numerics.{key} left out")
