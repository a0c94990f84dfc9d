"""Every effect: its limit, its absence from the graph, and the bundled scene that shows it."""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest

from softcat_sym.discretization.assembly import choose_body, choose_grid, choose_theory
from softcat_sym.discretization.graph import Graph
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.selection import choose_effects
from softcat_sym.physics.section_equations import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from tests.common import fading_filaments as fading
from tests.common.assembled import assemble
from tests.common.fading_filaments import Pair
from tests.common.rheology import STRING
from tests.common.table import show


# How fast each effect fades as its coefficient goes to zero: the table of limits, by effect.
@dataclass(frozen=True)
class Limit:
    """An effect that fades: where, and by which coefficient; theory's exponent and prefactor, each with its band."""

    effect: str
    what: str
    values: tuple[float, ...]
    exponent: tuple[float, float]
    pair: Callable[[float], Pair]
    prefactor: tuple[Callable[[], float] | float, float] | None = None


def halved(value: float) -> tuple[float, ...]:
    return value, value / 2, value / 4


_STRAIN = {"finite-stretch": 1 / 6, "thinning": 1 / 3, "large-rotation": 2 / 5}
_CABLE, _PINS = partial(fading.bending_of_a_cable, {}), partial(fading.bending_of_a_cable, fading.PINNED)
LIMITS: tuple[Limit, ...] = (
    Limit("inertia", "viscous string, rho at fixed rho g", (1.0, 0.1, 0.01), (1 / 5, 0.03), fading.inertia_always),
    Limit("inertia", "viscous beam, rho at fixed rho g", (1e-2, 1e-3, 1e-4), (1, 0.02), fading.inertia_of_a_beam),
    Limit("bending", "elastic cable between clamps, l/L", halved(0.016), (1, 0.06), _CABLE, (1.0, 0.04)),
    Limit("bending", "elastic cable between pins, l/L", halved(0.04), (3, 0.06), _PINS, (20.0, 0.04)),
    Limit(
        "extensibility",
        "clamped elastic beam, H/h",
        halved(0.2),
        (2, 0.03),
        fading.extensibility_of_a_beam,
        (fading.STIFFENING, 0.03),
    ),
    *(
        Limit(
            name,
            "elastic cable, mean strain",
            halved(0.02),
            (1, 0.03),
            partial(fading.geometry_of_a_cable, name),
            (_STRAIN[name], 0.03),
        )
        for name in STRING
    ),
    Limit("viscous-flow", "Maxwell cable, t E/eta", halved(0.1), (1, 0.03), fading.flow_of_a_cable, (1 / 3, 0.03)),
    Limit(
        "viscous-stress",
        "Kelvin-Voigt beam, eta/(E ramp)",
        halved(0.02),
        (1, 0.02),
        fading.viscous_stress_of_a_beam,
        (15 / 8, 0.03),
    ),
    Limit(
        "yielding",
        "creeping string, sigma_Y/(rho g L)",
        halved(0.4),
        (1, 0.03),
        fading.yielding_of_a_string,
        (2 * fading.CREPT, 0.03),
    ),
    Limit(
        "gravity-ramp",
        "creeping beam, ramp/duration",
        halved(0.1),
        (1, 0.02),
        fading.ramp_of_a_creeping_beam,
        (1 / 2, 0.03),
    ),
    Limit("shear", "clamped beam, h/L", halved(0.1), (2, 0.02), fading.shear_of_a_beam, (8 * 1.45 * 6 / 5, 0.01)),
    Limit("fibres", "Bingham beam, pins, sigma_Y/(rho g L)", halved(0.4), (2, 0.1), fading.fibres_of_a_beam),
    Limit("necking-gradient", "Maxwell string, pins, h/L", halved(0.1), (2, 0.04), fading.gradient_of_a_string),
    Limit(
        "rotary-inertia",
        "swinging clamped beam, h/L",
        halved(0.05),
        (2, 0.04),
        fading.rotation_of_a_beam,
        (fading.rayleigh_share, 0.04),
    ),
    Limit(
        "gravity-shaking",
        "swinging clamped beam, a",
        halved(0.4),
        (1, 0.01),
        fading.shaking_of_a_beam,
        (fading.duhamel_share, 0.01),
    ),
    Limit(
        "surface-tension", "clamped beam, F L^2/(E I)", halved(0.4), (1, 0.02), fading.surface_of_a_beam, (1 / 40, 0.01)
    ),
    Limit("buoyancy", "clamped beam, rho_b/rho", halved(0.2), (1, 0.001), fading.buoyancy_of_a_beam, (1.0, 0.001)),
    Limit("drag", "swinging clamped beam, mu_b", halved(0.1), (1, 0.03), fading.drag_of_a_beam),
    Limit("added-mass", "swinging clamped beam, rho_b/rho", halved(0.02), (1, 0.04), fading.mass_of_a_bath),
    Limit(
        "solid-damping",
        "swinging clamped beam, G''/G'",
        halved(0.02),
        (1, 0.04),
        fading.loss_of_a_beam,
        (fading.loss_share, 0.04),
    ),
    Limit("curing", "creeping beam, rate of the viscosity", halved(0.1), (1, 0.03), fading.curing_of_a_creeping_beam),
    Limit(
        "natural-strain",
        "clamped beam, F L^2/(E I)",
        halved(0.4),
        (1, 0.02),
        fading.shrinking_of_a_beam,
        (1 / 40 - 0.05**2 / 2, 0.02),
    ),
    Limit("temperature", "creeping beam, kelvin", halved(0.4), (1, 0.02), fading.warmth_of_a_creeping_beam),
    Limit("backstress", "Bingham beam, C/(rho g L)", halved(0.4), (1, 0.05), fading.hardening_of_a_beam),
    Limit("laying", "viscous beam, time of laying", (0.4, 0.2, 0.1), (1, 0.05), fading.laying_of_a_beam, (5 / 6, 0.05)),
    Limit("contact", "clamped beam, 1 - D/H", halved(0.2), (1, 0.02), fading.floor_of_a_beam, (1.0, 0.02)),
    Limit("structure", "Bingham beam, 1/t_b", halved(0.2), (1, 0.06), fading.structure_of_a_beam),
)
"""Every limit; each effect has one or more."""


# What every effect must have: a bundled scene, a limit test and a derivation.
NOTEBOOKS = Path(__file__).parents[2] / "derivations"
EQUATIONS = "softcat_sym.physics"
_SENTENCE = re.compile(r"Effects derived here:(.*?)\.(?:\s|$)(?!`)", re.DOTALL)
_ENTRY = re.compile(r"`([a-z-]+)`\s+\(([^)]*)\)")
_CELL = re.compile(r"^# %%(.*)$", re.MULTILINE)


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
    package = "softcat_sym" if module.startswith("effects.") else EQUATIONS
    try:
        return hasattr(importlib.import_module(f"{package}.{module}" if module else package), attribute)
    except ModuleNotFoundError:
        return False


# Graphs of bundled scenes with and without one effect, like with like.
CELLS = 6
BESIDE = {"shear": ("fibres",)}
"""Effects that hide another one: a resolved section keeps its shear, made stiff."""
WITHOUT: dict[str, dict[str, object]] = {
    "gravity-shaking": {"load.shake": 0.0, "load.shake_frequency": "0 Hz"},
    "laying": {"extrusion": None},
}
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
    """The scene with these effects and no other; it asks for none of the others."""
    named = list(names)
    absent = {key: value for name, asked in WITHOUT.items() if name not in named for key, value in asked.items()}
    return scene.replace({**absent, "run.effects": named})


def dispensing(effect: Effect) -> Scene:
    """The effect's scene, as it may do without the effect."""
    return load_scene(effect.example).replace(WITHOUT.get(effect.name, {}))


@cache
def graph_of(scene_name: str, names: tuple[str, ...]) -> Graph:
    """The scene's graph on few cells, with these effects and no other."""
    asked = with_effects(load_scene(scene_name), names).replace({"numerics.cells": CELLS, "numerics.grading": 1.0})
    effects = choose_effects(asked)
    if effects.names != names:
        raise ValueError(f"asked for {names}, got {effects.names}")
    equations = derive(effects.terms(), SECTIONS[asked.filament.section], asked.run.closure)
    grid = choose_grid(asked)
    return assemble(equations, grid, names, choose_theory(asked, equations.terms), choose_body(asked, grid))


def unknowns(graph: Graph) -> int:
    """Number of differential and algebraic states."""
    return len(graph.differential.names) + len(graph.algebraic.names)


# An effect whose coefficient goes to zero converges to its absence, at the rate that theory gives.
@pytest.mark.slow
@pytest.mark.parametrize("limit", LIMITS, ids=lambda limit: f"{limit.effect}: {limit.what}")
def test_a_fading_effect_is_its_absence(limit: Limit) -> None:
    pairs = [limit.pair(value) for value in limit.values]
    shares = [np.max(np.abs(present - absent)) / np.max(np.abs(absent)) for present, absent in pairs]
    exponents = np.diff(np.log(shares)) / np.diff(np.log(limit.values))
    exponent, band = limit.exponent
    rows = list(zip(limit.values, shares, (None, *exponents), shares / np.power(limit.values, exponent), strict=True))
    show(
        f"{limit.effect}, {limit.what}: {limit.exponent}", ("value", "share of the sag", "exponent", "prefactor"), rows
    )
    assert exponents[-1] == pytest.approx(exponent, abs=band)
    if limit.prefactor is not None:
        wanted, share = limit.prefactor
        assert rows[-1][-1] == pytest.approx(wanted() if callable(wanted) else wanted, rel=share)


@pytest.mark.slow
def test_a_linear_profile_of_fibres_is_the_run_without_them() -> None:
    """The two are discretised differently, so they agree as the square of the cells, down to a thousandth of shear."""
    threshold, rows, differences = 0.4, [], []
    for cells in (10, 20, 40):
        linear = fading.bingham_beam(threshold, (*fading.BENDING_FLOW, "fibres"), cells, {"order": 1})
        without = fading.bingham_beam(threshold, fading.BENDING_FLOW, cells, {})
        differences.append(float(np.max(np.abs(linear - without)) / np.max(without)))
        rows.append([cells, f"{without[-1]:.6f}", f"{linear[-1]:.6f}", f"{differences[-1]:.1e}"])
    show("linear profile", ("cells", "sag without fibres", "sag of linear fibres", "difference"), rows)
    assert differences[0] / differences[1] == pytest.approx(4, rel=0.2)
    assert differences[2] < 1e-3


# Every registered effect has a bundled scene in which it matters, a limit test and a derivation.
NAMES = [effect.name for effect in REGISTRY]


def test_every_effect_has_its_scene_its_limit_and_its_derivation() -> None:
    for effect in REGISTRY:
        assert not [*_without_scene(effect), *_without_derivation(effect, NOTEBOOKS)]


def test_no_limit_is_of_an_unknown_effect() -> None:
    assert {limit.effect for limit in LIMITS} == set(NAMES)


# An absent effect leaves no symbol in the graph and fewer instructions, in the bundled scene in which it matters.


def pair(effect: Effect) -> tuple[Graph, Graph]:
    """Graphs with and without the effect."""
    with_it, without_it = lists(effect)
    return graph_of(effect.example, with_it), graph_of(effect.example, without_it)


@pytest.mark.slow
def test_an_absent_effect_leaves_nothing() -> None:
    for effect in REGISTRY:
        present, absent = pair(effect)
        # A constant that follows a clock has the numbers of its table in its place.
        clocked = {name for name in absent.parameters if f"{name}_0" in present.parameters}
        assert set(absent.parameters) - clocked <= set(present.parameters)
        assert unknowns(absent) <= unknowns(present)
        assert absent.symbolic.instructions < present.symbolic.instructions
