"""Graphs of bundled scenes with and without one effect, like with like."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from softcat_sym.discretization.assembly import assemble, choose_body, choose_grid, choose_theory
from softcat_sym.discretization.graph import Graph
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

CELLS = 6
BESIDE = {"shear": ("fibres",)}
"""Effects that hide another one: a resolved section keeps its shear, made stiff."""
STEADY = {"load.shake": 0.0, "load.shake_frequency": "0 Hz"}
"""What a scene must no longer ask for where an effect is left out that it could not do without."""


def dependents(name: str) -> set[str]:
    """Effects that make no sense without this one."""
    found = {name}
    while more := {effect.name for effect in REGISTRY if found & set(effect.needs)} - found:
        found |= more
    return found - {name}


def lists(effect: Effect) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What ``auto`` holds in the effect's scene, with the effect and what it needs, and the same without it.

    Neither has what needs the effect: that would leave with it, and be mistaken for it.
    """
    chosen = set(choose_effects(load_scene(effect.example)).names) | {effect.name}
    for other in reversed(REGISTRY):
        chosen |= set(other.needs) if other.name in chosen else set()
    chosen -= dependents(effect.name) | set(BESIDE.get(effect.name, ()))
    listed = tuple(other.name for other in REGISTRY if other.name in chosen)
    return listed, tuple(name for name in listed if name != effect.name)


def with_effects(scene: Scene, names: Iterable[str]) -> Scene:
    """The scene with these effects and no other; under steady gravity where its shaking is not among them."""
    named = list(names)
    return scene.replace({"run.effects": named, **({} if "gravity-shaking" in named else STEADY)})


def dispensing(effect: Effect) -> Scene:
    """The effect's scene, as it may do without the effect."""
    scene = load_scene(effect.example)
    return scene.replace(STEADY) if effect.name == "gravity-shaking" else scene


@cache
def graph_of(scene_name: str, names: tuple[str, ...]) -> Graph:
    """The scene's graph on few cells, with these effects and no other."""
    asked = with_effects(load_scene(scene_name), names).replace({"numerics.cells": CELLS, "numerics.grading": 1.0})
    effects = choose_effects(asked)
    if effects.names != names:
        raise ValueError(f"asked for {names}, got {effects.names}")
    equations = derive(effects.terms(), SECTIONS[asked.filament.section], asked.run.closure)
    grid = choose_grid(asked)
    return assemble(equations, grid, names, choose_theory(asked, equations), choose_body(asked, grid))


def unknowns(graph: Graph) -> int:
    """Number of differential and algebraic states."""
    return len(graph.state_names) + len(graph.algebraic_names)


def kinds(graph: Graph) -> set[str]:
    """Blocks of unknowns; plastic states through the thickness without their number."""
    return {without_number(kind) for kind in (*graph.x_kinds, *graph.z_kinds)}


def without_number(kind: str) -> str:
    """``axial_3`` is ``axial``, ``a_1`` itself."""
    head, _, tail = kind.rpartition("_")
    return head if tail.isdigit() and head in ("axial", "shear") else kind


def listed(names: Iterable[str]) -> str:
    """For a table."""
    return ", ".join(sorted(names)) or "-"
