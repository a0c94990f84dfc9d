"""Effects are well formed, independent of one another, and leave nothing behind when absent."""

from __future__ import annotations

import itertools
import random
from functools import cache
from typing import Any

import pytest

import softcat_sym as sc
from softcat_sym.discretization.assembly import assemble
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import End, half_span
from softcat_sym.discretization.kirchhoff import KIRCHHOFF
from softcat_sym.discretization.reissner import reissner
from softcat_sym.discretization.section_rule import fibre_rule
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.gravity_shaking import GRAVITY_SHAKING
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.errors import SceneError
from softcat_sym.physics.filament import Terms, derive
from softcat_sym.physics.laws import law_of
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import load_scene

from .scenes import scene_of

NAMES = tuple(effect.name for effect in REGISTRY)
ALL = (
    "inertia",
    "bending",
    "extensibility",
    "finite-stretch",
    "thinning",
    "large-rotation",
    "viscous-flow",
    "viscous-stress",
    "yielding",
    "gravity-ramp",
)
"""The published list."""
BEYOND = (
    *("shear", "fibres", "necking-gradient", "rotary-inertia", "gravity-shaking"),
    *("surface-tension", "solid-damping"),
)


@cache
def graph_of(names: tuple[str, ...], law: str = "bingham") -> Graph:
    terms = Terms(law=law_of(law))
    for effect in REGISTRY:
        if effect.name in names:
            terms = effect.contribute(terms)
    equations = derive(terms, SECTIONS["rectangle"], "material")
    theory = KIRCHHOFF if equations.resolved is None else reissner(fibre_rule(equations.shape, 3))
    return assemble(equations, half_span(4, End.CLAMPED), names, theory)


def without(*names: str) -> tuple[str, ...]:
    return tuple(name for name in ALL if name not in names)


def test_the_registry_is_the_papers_list_and_what_goes_beyond() -> None:
    assert NAMES == (*ALL, *BEYOND)
    assert tuple(effect.name for effect in REGISTRY if effect.in_paper) == ALL


def test_every_effect_says_what_it_is() -> None:
    for effect in REGISTRY:
        assert effect.summary  # type: ignore[attr-defined]
        assert effect.source  # type: ignore[attr-defined]
        assert effect.observable  # type: ignore[attr-defined]
        assert set(effect.needs) <= set(NAMES) - {effect.name}  # type: ignore[attr-defined]


def test_one_that_does_not_always_apply_says_why() -> None:
    for effect in REGISTRY:
        laws = ("elastic", "maxwell", "kelvin-voigt", "bingham")
        scenes = [scene_of(law, ramp) for law, ramp in itertools.product(laws, ("0 s", "1 s"))]
        scenes += [scene.replace({"model": "small-deflection"}) for scene in scenes[:2]]
        scenes.append(scenes[0].replace({"material.loss_tangent": 0.1}))
        scenes.append(scenes[0].replace({"load.shake": 0.5, "load.shake_frequency": "3 Hz"}))
        scenes.append(scenes[0].replace({"surroundings.surface_tension": "20 mN/m"}))
        applies = [effect.applies(scene) for scene in scenes]  # type: ignore[attr-defined]
        assert any(applies)
        assert bool(effect.without_it) is not all(applies)  # type: ignore[attr-defined]


def test_every_effect_changes_the_terms() -> None:
    for effect in REGISTRY:
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


def test_contributing_twice_is_contributing_once() -> None:
    for effect in REGISTRY:
        once = effect.contribute(Terms())  # type: ignore[attr-defined]
        assert effect.contribute(once) == once  # type: ignore[attr-defined]


def test_an_absent_effect_leaves_no_parameter() -> None:
    for absent, parameter in [
        (("bending",), "thickness"),
        (("yielding",), "yield_stress"),
        (("viscous-flow", "yielding"), "viscosity"),
        (("viscous-flow", "yielding"), "yield_stress"),
        (("gravity-ramp",), "ramp"),
        (("shear", "rotary-inertia"), "poisson"),
        (("necking-gradient",), "aspect"),
        (("gravity-shaking",), "shake"),
        (("gravity-shaking",), "shake_frequency"),
        (("surface-tension",), "surface_tension"),
        (("solid-damping",), "solid_viscosity"),
    ]:
        everything = (*ALL, *(set(BEYOND) & {*absent}))
        assert parameter in graph_of(everything).parameters
        assert parameter not in graph_of(tuple(name for name in everything if name not in absent)).parameters


def test_an_absent_effect_beyond_the_paper_leaves_no_state() -> None:
    both = graph_of((*ALL, "shear", "fibres"))
    assert {name[: name.index("[")] for name in both.state_names} == {
        *("x", "y", "u", "v"),
        *(f"{kind}_{n}" for kind in ("axial", "shear") for n in range(3)),
    }
    assert all(name.startswith("psi[") for name in both.algebraic_names)
    assert not any("shear" in name for name in graph_of((*ALL, "fibres")).state_names)
    assert not graph_of(ALL).algebraic_names
    turning = graph_of((*ALL, "shear", "fibres", "rotary-inertia"))
    assert not turning.is_dae
    assert any(name.startswith("omega[") for name in turning.state_names)
    assert len(both.state_names) + 2 * len(both.algebraic_names) == len(turning.state_names)


def test_absent_shaking_leaves_no_instruction() -> None:
    shaken = graph_of((*ALL, "gravity-shaking"))
    assert graph_of(ALL).instructions < shaken.instructions
    assert graph_of(ALL).state_names == shaken.state_names


def test_an_absent_gradient_leaves_no_power() -> None:
    assert graph_of(ALL).powers[2].is_zero()
    assert not graph_of((*ALL, "necking-gradient")).powers[2].is_zero()


def test_an_absent_effect_leaves_no_state() -> None:
    for absent, state in [
        (("inertia",), "u["),
        (("inertia",), "v["),
        (("bending",), "a_1["),
        (("viscous-flow", "yielding"), "a_"),
    ]:
        assert any(name.startswith(state) for name in graph_of(ALL).state_names)
        assert not any(name.startswith(state) for name in graph_of(without(*absent)).state_names)


def test_an_absent_effect_leaves_no_instruction() -> None:
    for absent in [name for name in ALL if name not in ("viscous-flow", "viscous-stress")]:
        gone = (absent, "finite-stretch", "thinning", "large-rotation") if absent == "extensibility" else (absent,)
        assert graph_of(without(*gone)).instructions < graph_of(without(*gone[1:])).instructions


def test_a_law_without_a_viscous_stress_is_the_same_with_that_effect() -> None:
    assert graph_of(without("viscous-stress")).instructions == graph_of(ALL).instructions


def test_an_absent_viscous_stress_leaves_no_instruction_and_no_parameter() -> None:
    solid, elastic = graph_of(ALL, "kelvin-voigt"), graph_of(without("viscous-stress"), "kelvin-voigt")
    assert elastic.instructions == graph_of(ALL, "elastic").instructions < solid.instructions
    assert "viscosity" in solid.parameters
    assert "viscosity" not in elastic.parameters


def test_without_inertia_a_viscous_stress_makes_the_velocities_algebraic() -> None:
    graph = graph_of(without("inertia"), "newtonian")
    assert {name[: name.index("[")] for name in graph.state_names} == {"x", "y"}
    assert {name[: name.index("[")] for name in graph.algebraic_names} == {"u", "v"}


def test_without_any_flow_there_are_fewer_instructions_still() -> None:
    assert graph_of(without("viscous-flow", "yielding")).instructions < graph_of(without("yielding")).instructions


def test_the_barest_filament_is_a_string_at_rest() -> None:
    graph = graph_of(("extensibility",))
    assert set(graph.parameters) == {"rest_length", "density", "gravity", "youngs_modulus", "time_scale"}
    assert not graph.state_names
    assert graph.is_dae


def test_paper_takes_the_published_effects_that_apply() -> None:
    for name in bundled_names():
        scene = load_scene(name, {"run.effects": "paper"})
        effects = choose_effects(scene)
        assert effects.names == tuple(
            e.name for e in REGISTRY if e.applies(scene) and (e.in_paper or e is GRAVITY_SHAKING)
        )
        assert set(effects.left_out) == {e.name for e in REGISTRY if e.applies(scene)} - set(effects.names)
        assert set(effects.reasons) == set(effects.names)


def test_auto_takes_shear_above_a_third_of_the_accuracy() -> None:
    for thickness, accuracy, shears in [
        ("6 mm", 1e-3, True),
        ("6 mm", 0.01, True),
        ("6 mm", 0.2, False),
        ("0.01 mm", 1e-3, False),
    ]:
        scene = scene_of("maxwell", filament={"thickness": thickness}, run={"accuracy": accuracy})
        assert ("shear" in choose_effects(scene).names) is shears


def test_auto_takes_fibres_where_the_law_yields() -> None:
    names = {law: choose_effects(scene_of(law)).names for law in ("elastic", "maxwell", "bingham")}
    assert [law for law, chosen in names.items() if "fibres" in chosen] == ["bingham"]


def test_auto_takes_rotary_inertia_where_a_thick_filament_rings_for_long() -> None:
    """Rayleigh's beam is slower by (12.3/24) (h0/L)^2: a hundred radians on, 4 % of a swing at h0/L = 0.03."""
    rings, damped = scene_of("elastic", "0 s"), scene_of("kelvin-voigt", "0 s", material={"viscosity": "1 MPa*s"})
    assert "rotary-inertia" in choose_effects(rings).names
    assert "rotary-inertia" not in choose_effects(damped).names


def test_auto_takes_points_where_they_are_quicker_than_means() -> None:
    thin: dict[str, dict[str, Any]] = {"filament": {"thickness": "0.02 mm"}, "run": {"accuracy": 0.1}}
    law = {"law": "power-law", "index": 1.5, "viscosity": "1 kPa*s**1.5"}
    quicker = choose_effects(scene_of("maxwell", material=law, **thin))
    assert "quicker" in quicker.reasons["shear"]
    assert "fibres" not in quicker.names
    assert "shear" not in choose_effects(scene_of("maxwell", **thin)).names


def test_auto_takes_the_gradient_where_a_neck_has_time_to_grow() -> None:
    for name, necks in [
        ("arrested-underdamped", True),
        ("arrested-overdamped", True),
        ("continual-descent", True),
        ("no-yield", False),
    ]:
        assert ("necking-gradient" in choose_effects(load_scene(name)).names) is necks


def test_the_printed_closure_is_the_published_theory() -> None:
    published = without("viscous-stress")
    assert choose_effects(scene_of(run={"closure": "printed"})).names == published
    listed = scene_of(run={"closure": "printed", "effects": [*published, "shear"]})
    with pytest.raises(SceneError, match=r"run\.closure: 'printed' with shear"):
        choose_effects(listed)
    with pytest.raises(SceneError, match=r"run\.closure: 'printed' with numerics\.order = 2"):
        choose_effects(scene_of(run={"closure": "printed"}, numerics={"order": 2}))


def test_fibres_that_are_asked_for_do_not_make_a_solid_flow() -> None:
    """A strand too short to yield calls for neither flow nor yielding; with fibres it has both, or would run away."""
    short = {"filament.span": "3 mm", "material.shear_yield_stress": "1 kPa"}
    assert not {"viscous-flow", "yielding"} & set(choose_effects(load_scene("ink-bridge", short)).names)
    with_fibres = choose_effects(load_scene("ink-bridge", short | {"numerics.fibres": 6}))
    assert {"fibres", "viscous-flow", "yielding"} <= set(with_fibres.names)
    assert "held by its yield stress" in with_fibres.reasons["yielding"]


@pytest.mark.parametrize("numerics", [{"fibres": 4}, {"order": 2}])
def test_numbers_of_fibres_ask_for_them(numerics: dict[str, int]) -> None:
    effects = choose_effects(scene_of("maxwell", run={"effects": "paper"}, numerics=numerics))
    assert "numerics.fibres or numerics.order" in effects.reasons["fibres"]
    assert "shear" not in effects.names
    with pytest.raises(SceneError, match=next(iter(numerics))):
        choose_effects(scene_of("elastic", numerics=numerics))


def test_a_named_list_reports_what_it_leaves_out() -> None:
    scene = scene_of(run={"effects": ["bending", "inertia", "viscous-flow"]})
    effects = choose_effects(scene)
    assert effects.names == ("inertia", "bending", "viscous-flow")
    assert set(effects.left_out) == set(NAMES) - set(effects.names) - {
        "viscous-stress",
        "gravity-shaking",
        "surface-tension",
        "solid-damping",
    }
    assert all("named in run.effects" in reason for reason in effects.reasons.values())


def test_what_does_not_apply_is_not_called_left_out() -> None:
    effects = choose_effects(scene_of("elastic", "0 s", run={"effects": ["inertia", "bending"]}))
    assert set(effects.left_out) == {
        *("extensibility", "finite-stretch", "thinning", "large-rotation", "shear", "rotary-inertia")
    }


def test_a_filament_stretched_so_far_that_sections_would_turn_is_not_given_shear() -> None:
    """Log s against kappa_s/(2 (1 + nu)) = 0.2874 of a rectangle: stretch 1.33."""
    for stretch, shears in ((1.30, True), (1.36, False)):
        asked = {"initial.stretch": stretch, "initial.relaxed": False, "run.effects": "auto", "run.accuracy": 1e-3}
        scene = scene_of("elastic").replace(asked)
        assert ("shear" in choose_effects(scene).names) is shears
    with pytest.raises(SceneError, match=r"'shear' cannot be had: the filament is stretched elastically"):
        choose_effects(
            scene.replace({"run.effects": [*without("viscous-flow", "viscous-stress", "yielding"), "shear"]})
        )


def test_a_stated_loss_is_taken_in_with_inertia_and_brings_none() -> None:
    ink = sc.load_scene("ink-bridge", {"load.ramp": "0 s", "material.loss_tangent": 0.1})
    assert {"inertia", "solid-damping"} <= set(choose_effects(ink).names)
    slow = choose_effects(sc.load_scene("glass-rod", {"material.loss_tangent": 0.1})).names
    assert not {"inertia", "solid-damping"} & set(slow)
