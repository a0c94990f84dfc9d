"""What every effect must have: a bundled scene, a limit test and a derivation.

A notebook says what it derives in one sentence, *Effects derived here:* each name with the objects of
``softcat_sym.physics`` that it is compared with, in backquotes; those objects must occur in its code.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Sequence
from pathlib import Path

from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.effect import Effect
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import load_scene

from .effect_graphs import dispensing, lists
from .effect_limits import Limit

NOTEBOOKS = Path(__file__).parents[2] / "derivations"
EQUATIONS = "softcat_sym.physics"
_SENTENCE = re.compile(r"Effects derived here:(.*?)\.(?:\s|$)(?!`)", re.DOTALL)
_ENTRY = re.compile(r"`([a-z-]+)`\s+\(([^)]*)\)")
_CELL = re.compile(r"^# %%(.*)$", re.MULTILINE)


def lacking(effect: Effect, limits: Sequence[Limit], notebooks: Path = NOTEBOOKS) -> list[str]:
    """Whatever of the three the effect lacks; empty if it has them all."""
    missing = [*_without_scene(effect), *_without_derivation(effect, notebooks)]
    if not any(limit.effect == effect.name for limit in limits):
        missing.append("limit: none in the table")
    return missing


def _without_scene(effect: Effect) -> list[str]:
    if effect.example not in bundled_names():
        return [f"scene: no bundled scene {effect.example!r}"]
    scene = load_scene(effect.example)
    if not effect.applies(scene):
        return [f"scene: {effect.example} cannot have it"]
    if reason := effect.indispensable(dispensing(effect)):
        return [f"scene: {effect.example} cannot do without it, so that nothing shows: {reason}"]
    asked = scene if not effect.saved(scene) else scene.replace({"run.effects": list(lists(effect)[0])})
    if effect.name not in choose_effects(asked).names:
        return [f"scene: {effect.example} does not take it in"]
    return []


def _without_derivation(effect: Effect, notebooks: Path) -> list[str]:
    path = notebooks / f"{effect.derivation}.py"
    if not path.is_file():
        return [f"derivation: no notebook {effect.derivation!r}"]
    prose, code = _cells(path.read_text("utf-8"))
    objects = derived_in(prose).get(effect.name)
    if not objects:
        return [f"derivation: {effect.derivation} does not say that it derives it"]
    missing = [name for name in objects if not _is_held(name)]
    missing += [name for name in objects if not re.search(rf"\b{name.rpartition('.')[2]}\b", code)]
    return [f"derivation: {effect.derivation} compares nothing with {name}" for name in missing]


def derived_in(prose: str) -> dict[str, tuple[str, ...]]:
    """Effects that a notebook says it derives, with the objects that they are compared with."""
    sentence = _SENTENCE.search(prose)
    entries = _ENTRY.findall(sentence.group(1)) if sentence else []
    return {name: tuple(re.findall(r"`([\w.]+)`", objects)) for name, objects in entries}


def _cells(text: str) -> tuple[str, str]:
    """Text of the markdown cells, and of the code cells without their imports."""
    prose, code = [], []
    parts = _CELL.split(text)[1:]
    for kind, cell in zip(parts[::2], parts[1::2], strict=True):
        if "[markdown]" in kind:
            prose.append(re.sub(r"^# ?", "", cell, flags=re.MULTILINE))
        else:
            code.append(re.sub(r"^from \S+ import (\([^)]*\)|.*)$", "", cell, flags=re.MULTILINE))
    return "\n".join(prose), "\n".join(code)


def _is_held(name: str) -> bool:
    """Whether the equations have an object of this name."""
    module, _, attribute = name.rpartition(".")
    try:
        return hasattr(importlib.import_module(f"{EQUATIONS}.{module}" if module else EQUATIONS), attribute)
    except ModuleNotFoundError:
        return False
