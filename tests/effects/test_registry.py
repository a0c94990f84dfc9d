"""Effects are well formed, independent of one another, and leave nothing behind when absent."""

from __future__ import annotations

import itertools
import random
from functools import cache

import pytest

from softcat_sym.effects import REGISTRY, choose_effects
from softcat_sym.equations.filament import Terms, derive
from softcat_sym.equations.section import SECTIONS
from softcat_sym.graph import End, Graph, assemble, half_span
from softcat_sym.scene import bundled_names, load_scene

from .scenes import scene_of

NAMES = tuple(effect.name for effect in REGISTRY)
ALL = (
    "inertia",
    "bending",
    "finite-stretch",
    "thinning",
    "large-rotation",
    "viscous-flow",
    "yielding",
    "gravity-ramp",
)


@cache
def graph_of(names: tuple[str, ...]) -> Graph:
    terms = Terms()
    for effect in REGISTRY:
        if effect.name in names:
            terms = effect.contribute(terms)
    return assemble(derive(terms, SECTIONS["rectangle"], "material"), half_span(4, End.CLAMPED), names)


def without(*names: str) -> tuple[str, ...]:
    return tuple(name for name in ALL if name not in names)


def test_the_registry_is_the_papers_list() -> None:
    assert sorted(NAMES) == sorted(ALL)
    assert len(set(NAMES)) == len(NAMES)


@pytest.mark.parametrize("effect", REGISTRY, ids=NAMES)
def test_every_effect_says_what_it_is(effect: object) -> None:
    assert effect.summary  # type: ignore[attr-defined]
    assert effect.source  # type: ignore[attr-defined]
    assert effect.observable  # type: ignore[attr-defined]
    assert set(effect.needs) <= set(NAMES) - {effect.name}  # type: ignore[attr-defined]


@pytest.mark.parametrize("effect", REGISTRY, ids=NAMES)
def test_one_that_does_not_always_apply_says_why(effect: object) -> None:
    scenes = [scene_of(law, ramp) for law, ramp in itertools.product(("elastic", "maxwell", "bingham"), ("0 s", "1 s"))]
    scenes += [scene.replace({"model": "small-deflection"}) for scene in scenes[:2]]
    applies = [effect.applies(scene) for scene in scenes]  # type: ignore[attr-defined]
    assert any(applies)
    assert bool(effect.without_it) is not all(applies)  # type: ignore[attr-defined]


@pytest.mark.parametrize("effect", REGISTRY, ids=NAMES)
def test_every_effect_changes_the_terms(effect: object) -> None:
    assert effect.contribute(Terms()) != Terms()  # type: ignore[attr-defined]
    others = Terms()
    for other in REGISTRY:
        if other is not effect:
            others = other.contribute(others)
    assert effect.contribute(others) != others  # type: ignore[attr-defined]


def test_the_order_of_contributions_does_not_matter() -> None:
    orders = [list(REGISTRY), list(reversed(REGISTRY))]
    generator = random.Random(3)
    for _ in range(20):
        orders.append(generator.sample(REGISTRY, len(REGISTRY)))
    results = []
    for order in orders:
        terms = Terms()
        for effect in order:
            terms = effect.contribute(terms)
        results.append(terms)
    assert all(terms == results[0] for terms in results)


@pytest.mark.parametrize("effect", REGISTRY, ids=NAMES)
def test_contributing_twice_is_contributing_once(effect: object) -> None:
    once = effect.contribute(Terms())  # type: ignore[attr-defined]
    assert effect.contribute(once) == once  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("absent", "parameter"),
    [
        (("bending",), "thickness"),
        (("yielding",), "yield_stress"),
        (("viscous-flow", "yielding"), "viscosity"),
        (("viscous-flow", "yielding"), "yield_stress"),
        (("gravity-ramp",), "ramp"),
    ],
)
def test_an_absent_effect_leaves_no_parameter(absent: tuple[str, ...], parameter: str) -> None:
    assert parameter in graph_of(ALL).parameters
    assert parameter not in graph_of(without(*absent)).parameters


@pytest.mark.parametrize(
    ("absent", "state"),
    [(("inertia",), "u["), (("inertia",), "v["), (("bending",), "a_1["), (("viscous-flow", "yielding"), "a_")],
)
def test_an_absent_effect_leaves_no_state(absent: tuple[str, ...], state: str) -> None:
    assert any(name.startswith(state) for name in graph_of(ALL).state_names)
    assert not any(name.startswith(state) for name in graph_of(without(*absent)).state_names)


@pytest.mark.parametrize("absent", [name for name in ALL if name != "viscous-flow"])
def test_an_absent_effect_leaves_no_instruction(absent: str) -> None:
    assert graph_of(without(absent)).instructions < graph_of(ALL).instructions


def test_without_any_flow_there_are_fewer_instructions_still() -> None:
    assert graph_of(without("viscous-flow", "yielding")).instructions < graph_of(without("yielding")).instructions


def test_the_barest_filament_is_a_string_at_rest() -> None:
    graph = graph_of(())
    assert set(graph.parameters) == {"span", "density", "gravity", "youngs_modulus", "time_scale"}
    assert not graph.state_names
    assert graph.is_dae


@pytest.mark.parametrize("name", bundled_names())
def test_auto_and_paper_take_what_applies(name: str) -> None:
    scene = load_scene(name)
    for asked in ("auto", "paper"):
        effects = choose_effects(scene.replace({"run.effects": asked}))
        assert effects.names == tuple(e.name for e in REGISTRY if e.applies(scene))
        assert not effects.left_out
        assert set(effects.reasons) == set(effects.names)


def test_a_named_list_reports_what_it_leaves_out() -> None:
    scene = scene_of(run={"effects": ["bending", "inertia", "viscous-flow"]})
    effects = choose_effects(scene)
    assert effects.names == ("inertia", "bending", "viscous-flow")
    assert set(effects.left_out) == set(ALL) - set(effects.names)
    assert all("named in run.effects" in reason for reason in effects.reasons.values())


def test_what_does_not_apply_is_not_called_left_out() -> None:
    effects = choose_effects(scene_of("elastic", "0 s", run={"effects": ["inertia", "bending"]}))
    assert set(effects.left_out) == {"finite-stretch", "thinning", "large-rotation"}
