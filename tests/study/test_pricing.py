"""Prices of effects: changes against closed forms and other laws, what goes along, why some are not run."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.errors import SceneError
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.pricing import (
    Pricing,
    PricingRow,
    Unpriced,
    dependants,
    everything,
    listed,
    percent,
    price_bundled,
    price_effects,
    reading,
    requirements,
    with_effects,
)
from tests.common.closed_forms import von_karman_sag
from tests.common.scenes import scene_of

QUICK = ["run.frames=11", "numerics.cells=4"]


def rows_of(pricing: Pricing) -> dict[str, PricingRow]:
    return {row.effect: row for row in pricing.rows}


@pytest.fixture(scope="module")
def yielding() -> Pricing:
    """The published theory, a while into its flow."""
    asked = [*QUICK, "groups.duration=40", "run.effects=paper"]
    scene = sc.load_scene("arrested-overdamped", asked)
    return price_effects(scene, only=("inertia", "bending", "viscous-flow", "yielding", "shear"))


@pytest.fixture(scope="module")
def honey() -> Pricing:
    return price_effects(sc.load_scene("cold-honey", [*QUICK, "run.duration=0.05 s"]), name="cold-honey")


@pytest.fixture(scope="module")
def beam() -> Pricing:
    """Elastic beam of small slope that stretches, in equilibrium under its weight."""
    run = {"effects": ["bending", "extensibility"], "frames": 3, "duration": "0.01 s"}
    return price_effects(scene_of("elastic", "0 s", run=run, numerics={"cells": 20}), only=("bending", "extensibility"))


def test_without_bending_the_beam_is_the_string_and_without_stretching_the_linear_beam(beam: Pricing) -> None:
    filament, modulus = beam.scene.filament, beam.scene.material.youngs_modulus or 0.0
    weight, inertia = filament.density * beam.scene.load.gravity, filament.thickness**2 / 12
    both = von_karman_sag(modulus, inertia, weight, filament.span)
    string = (3 * weight * filament.span**4 / (64 * modulus)) ** (1 / 3)
    linear = weight * filament.span**4 / (384 * modulus * inertia)
    assert beam.scale == pytest.approx(both, rel=0.01)
    found = rows_of(beam)
    for name, sag in (("bending", string), ("extensibility", linear)):
        row = found[name]
        assert row.variant is not None and row.variant.outcome is Outcome.solved
        # Heights are negative: what sags less lies above.
        assert row.change_final == pytest.approx((both - sag) / both, abs=0.02)
        assert row.change == pytest.approx(abs(row.change_final or 0), rel=1e-9)
        assert row.change > 0.05


@pytest.mark.parametrize(
    ("effect", "law", "without"),
    [("yielding", "maxwell", ("yield_stress",)), ("viscous-flow", "elastic", ("yield_stress", "viscosity"))],
)
def test_a_law_that_lost_an_effect_is_the_simpler_law(
    yielding: Pricing, effect: str, law: str, without: tuple[str, ...]
) -> None:
    row = rows_of(yielding)[effect]
    names = [name for name in yielding.base.effects if name not in (effect, *row.also)]
    changes: dict[str, object] = {"material.law": law, "run.effects": names, "numerics.grading": yielding.grading}
    run = sc.simulate(yielding.scene.replace(changes | {f"material.{key}": None for key in without}))
    apart = run.data.midpoint.values - yielding.base.midpoint
    # The simpler law may call for another integrator: they agree as closely as the time error allows.
    assert row.change == pytest.approx(np.abs(apart).max() / yielding.scale, rel=1e-2)
    assert row.change_final == pytest.approx(apart[-1] / yielding.scale, rel=1e-2)


def test_what_needs_an_effect_leaves_with_it_and_what_it_needs_comes_along() -> None:
    liquid = scene_of("maxwell")
    every = [effect.name for effect in REGISTRY]
    for effect in REGISTRY:
        gone = {effect.name, *dependants(effect.name, every)}
        assert all(not gone & set(other.needs) for other in REGISTRY if other.name not in gone)
        had = {effect.name, *requirements(effect.name, (), liquid)}
        assert all(set(other.needs) <= had for other in REGISTRY if other.name in had)
    # Through yielding: nothing needs the flow itself but what yields or is resolved.
    assert {"shear", "fibres"} <= set(dependants("bending", every))
    assert dependants("bending", ("inertia", "bending")) == ()
    assert "viscous-flow" in requirements("yielding", (), liquid)
    assert requirements("shear", every, liquid) == ()


def test_flow_put_in_brings_the_yield_stress() -> None:
    """A filament that no fibre of which yields is elastic, with flow and yield stress in it too."""
    changes = [*QUICK, "groups.duration=20", 'run.effects=["inertia", "bending", "gravity-ramp"]']
    row = rows_of(price_effects(sc.load_scene("no-yield", changes), only=["viscous-flow"]))["viscous-flow"]
    assert row.also == ("yielding",) and row.reference is not None
    assert row.share is not None and row.share < 1e-4
    assert row.states_ratio is not None and row.states_ratio > 1


def test_everything_is_all_but_rotary_inertia(honey: Pricing) -> None:
    scene = honey.scene
    names = everything(scene, ())
    assert "rotary-inertia" not in names and "rotary-inertia" in everything(scene, ("rotary-inertia",))
    assert set(names) == {effect.name for effect in REGISTRY if effect.applies(scene)} - {"rotary-inertia"}


def test_fibres_do_not_come_back_through_the_numerics() -> None:
    for asked in ({"order": 2}, {"fibres": 6}):
        scene = scene_of(numerics=asked)
        bare = with_effects(scene, ("inertia", "bending", "extensibility"))
        assert bare.numerics.order is None and bare.numerics.fibres is None
        assert with_effects(scene, ("fibres",)).numerics == scene.numerics


def test_every_effect_has_a_row_and_every_row_a_run_or_a_reason(yielding: Pricing, honey: Pricing) -> None:
    assert [row.effect for row in honey.rows] == [effect.name for effect in REGISTRY]
    for pricing in (yielding, honey):
        for row in pricing.rows:
            assert (row.variant is None) == bool(row.reason)
            assert row.in_force == (row.effect in pricing.base.effects)
            if row.variant is not None:
                assert (row.effect in row.variant.effects) != row.in_force
                assert not (row.in_force and set(row.also) & set(row.variant.effects))
    found = rows_of(honey)
    assert "yield stress" in found["yielding"].reason
    assert found["viscous-stress"].reason.startswith("cannot be left out")
    assert found["yielding"].estimate is None and found["shear"].estimate is not None


def test_only_physics_differs_and_its_size_is_that_of_the_graph(yielding: Pricing) -> None:
    found, cells = rows_of(yielding), yielding.cells
    assert cells == 4
    # Half a span: a height a cell, a place a node that is free, each with its velocity; a_0 on cells and a_1 on nodes.
    positions = 2 * cells - 1
    assert yielding.base.states == 2 * positions + cells + cells + 1
    assert yielding.base.algebraic == 0
    still = found["inertia"].variant
    assert still is not None and still.algebraic == positions and still.states == 2 * cells + 1
    shear = found["shear"]
    assert shear.variant is not None and shear.reference is yielding.base
    assert shear.states_ratio is not None and shear.states_ratio > 1
    assert shear.time_ratio == shear.variant.solve / yielding.base.solve
    bending = found["bending"]
    assert bending.variant is not None and bending.instructions_ratio is not None
    assert bending.instructions_ratio == yielding.base.instructions / bending.variant.instructions > 1
    assert bending.time_ratio == yielding.base.solve / bending.variant.solve


def test_an_effect_is_credited_with_its_own_share(honey: Pricing) -> None:
    row = rows_of(honey)["finite-stretch"]
    assert "shear" in row.also
    assert row.variant is not None and row.reference is not None
    assert set(row.reference.effects) - set(row.variant.effects) == {"finite-stretch"}
    own = np.abs(row.variant.midpoint - row.reference.midpoint).max() / honey.scale
    assert row.own_change == pytest.approx(own, rel=1e-12)
    assert row.share == min(row.change or 0, own)


def test_a_list_that_cannot_be_had_is_a_row_with_its_reason() -> None:
    scene = scene_of("elastic", run={"effects": ["inertia", "bending"]}, numerics={"cells": 4, "solver": "cvodes"})
    row = rows_of(price_effects(scene, only=["inertia"]))["inertia"]
    assert row.variant is None and row.change is None and row.time_ratio is None
    assert "cvodes" in row.reason


def test_a_scene_that_cannot_be_had_does_not_keep_others_from_being_priced() -> None:
    told: list[str] = []

    @contextmanager
    def listening(what: str) -> Iterator[Silence]:
        told.append(what)
        yield Silence()

    def of_scene(name: str, scene: Scene) -> object:
        told.append(name)
        return listening

    asked = [*QUICK, "run.duration=0.02 s"]
    bad, good = price_bundled(["no-such-scene", "cold-honey"], of_scene, asked)  # type: ignore[arg-type]
    assert isinstance(bad, Unpriced) and "no-such-scene" in bad.reason
    assert isinstance(good, Pricing) and good.name == "cold-honey"
    assert told[:3] == ["cold-honey", "the scene itself", "without inertia"]


def test_the_sentence_names_the_largest_first(yielding: Pricing) -> None:
    inside = [(row.share, row.effect) for row in yielding.rows if row.in_force and row.share is not None]
    share, largest = max(inside)
    assert reading(yielding).startswith(f"{largest} moves the midpoint by {percent(share)}")


def test_the_sentence_says_what_fails_what_is_missed_and_what_goes_unnoticed(honey: Pricing) -> None:
    found = rows_of(honey)
    base, shear = honey.base, found["shear"]
    assert shear.variant is not None
    failed = replace(shear, variant=replace(shear.variant, outcome=Outcome.step_limit))
    same = replace(found["inertia"], variant=base, reference=base, change=0.0)
    moved = replace(base, midpoint=base.midpoint + 0.25 * honey.scale)
    missed = replace(found["rotary-inertia"], in_force=False, variant=moved, reference=base, change=0.25)
    text = reading(replace(honey, rows=(same, failed, missed)))
    assert text == (
        "without shear the run ends as step_limit; inertia goes unnoticed; "
        "left out, rotary-inertia would move it by 25 %"
    )
    broken = replace(honey, base=replace(base, outcome=Outcome.localised))
    assert reading(broken).startswith("not to be trusted, since the run itself ends as localised: ")


@pytest.mark.parametrize(
    ("share", "said"), [(3e-5, "more than 0.003 %"), (1e-9, "as much as 0.0001 %"), (0.0, "more than 0 %")]
)
def test_what_was_left_out_is_bounded_once(honey: Pricing, share: float, said: str) -> None:
    base = honey.base
    moved = replace(base, midpoint=base.midpoint + share * honey.scale)
    left_out = replace(rows_of(honey)["rotary-inertia"], in_force=False, variant=moved, reference=base, change=share)
    assert reading(replace(honey, rows=(left_out,))) == f"nothing that was left out would move it by {said}"


def test_a_run_that_came_nowhere_changes_nothing_that_could_be_told(honey: Pricing) -> None:
    """Without bending or inertia a straight string has no equilibrium: its only frame is the start."""
    scene = honey.scene.replace({"run.effects": ["bending", "extensibility", "viscous-stress"], "load.ramp": "0.1 s"})
    row = rows_of(price_effects(scene, only=["bending"]))["bending"]
    assert row.fails and row.variant is not None and len(row.variant.time) == 1
    assert row.change is None and row.share is None and row.change_final is None


def test_unknown_names_are_refused_before_anything_runs(honey: Pricing) -> None:
    with pytest.raises(SceneError, match="no effect 'inertai' to price"):
        price_effects(honey.scene, only=["inertai"])


def test_numbers_and_lists_read_well() -> None:
    assert [percent(value) for value in (0.1234, 0.00141, 2.0, 37.2, 0.0, 1e-9)] == [
        "12 %",
        "0.14 %",
        "200 %",
        "37 times its largest value",
        "0 %",
        "less than 0.0001 %",
    ]
    assert listed(["a"]) == "a" and listed(["a", "b", "c"]) == "a, b and c"
    assert listed(["a", "b", "c", "d", "e", "f"]) == "a, b, c, d and 2 more"
