"""What effects are worth: changes against closed forms and other laws, what goes along, ``softcat effects``."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.studies.effect_importance import (
    Pricing,
    PricingRow,
    dependants,
    everything,
    price_effects,
    requirements,
    with_effects,
)
from tests.common.closed_forms import von_karman_sag
from tests.common.in_process import Softcat
from tests.common.scenes import scene_of

QUICK = ["run.frames=11", "numerics.cells=4"]
HONEY = sc.load_scene("cold-honey", [*QUICK, "run.duration=0.05 s"])
NAMES = [effect.name for effect in REGISTRY]


def rows_of(pricing: Pricing) -> dict[str, PricingRow]:
    return {row.effect: row for row in pricing.rows}


@pytest.fixture(scope="module")
def yielding() -> Pricing:
    """The published theory, a while into its flow."""
    scene = sc.load_scene("arrested-overdamped", [*QUICK, "groups.duration=40", "run.effects=paper"])
    return price_effects(scene, only=("inertia", "bending", "viscous-flow", "yielding", "shear"))


@pytest.fixture(scope="module")
def honey() -> Pricing:
    only = ("inertia", "finite-stretch", "shear")
    return price_effects(HONEY, name="cold-honey", only=(*only, "rotary-inertia", "yielding"))


def test_without_bending_the_beam_is_the_string_and_without_stretching_the_linear_beam() -> None:
    run = {"effects": ["bending", "extensibility"], "frames": 3, "duration": "0.01 s"}
    scene = scene_of("elastic", "0 s", run=run, numerics={"cells": 20})
    beam = price_effects(scene, only=("bending", "extensibility"))
    filament, modulus = scene.filament, scene.material.youngs_modulus or 0.0
    weight, inertia = filament.density * scene.load.gravity, filament.thickness**2 / 12
    both = von_karman_sag(modulus, inertia, weight, filament.span)
    assert beam.scale == pytest.approx(both, rel=0.01)
    string = (3 * weight * filament.span**4 / (64 * modulus)) ** (1 / 3)
    linear = weight * filament.span**4 / (384 * modulus * inertia)
    for name, sag in (("bending", string), ("extensibility", linear)):
        row = rows_of(beam)[name]
        assert row.variant is not None and row.variant.outcome is Outcome.solved
        # Heights are negative: what sags less lies above.
        assert row.change_final == pytest.approx((both - sag) / both, abs=0.02)
        assert row.change == pytest.approx(abs(row.change_final or 0), rel=1e-9)
        assert row.change > 0.05


@pytest.mark.slow
def test_a_law_that_lost_an_effect_is_the_simpler_law(yielding: Pricing) -> None:
    for effect, law, without in (
        ("yielding", "maxwell", ("yield_stress",)),
        ("viscous-flow", "elastic", ("yield_stress", "viscosity")),
    ):
        row = rows_of(yielding)[effect]
        names = [name for name in yielding.base.effects if name not in (effect, *row.also)]
        changes: dict[str, object] = {"material.law": law, "run.effects": names, "numerics.grading": yielding.grading}
        run = sc.simulate(yielding.scene.replace(changes | {f"material.{key}": None for key in without}))
        apart = run.data.midpoint.values - yielding.base.midpoint
        # The simpler law may call for another integrator: they agree as closely as the time error allows.
        assert row.change == pytest.approx(np.abs(apart).max() / yielding.scale, rel=1e-2), law
        assert row.change_final == pytest.approx(apart[-1] / yielding.scale, rel=1e-2), law


def test_what_needs_an_effect_leaves_with_it_and_what_it_needs_comes_along() -> None:
    liquid = scene_of("maxwell")
    for effect in REGISTRY:
        gone = {effect.name, *dependants(effect.name, NAMES)}
        assert all(not gone & set(other.needs) for other in REGISTRY if other.name not in gone)
        had = {effect.name, *requirements(effect.name, (), liquid)}
        assert all(set(other.needs) <= had for other in REGISTRY if other.name in had)
    assert {"shear", "fibres"} <= set(dependants("bending", NAMES))
    assert dependants("bending", ("inertia", "bending")) == ()
    assert "viscous-flow" in requirements("yielding", (), liquid)
    assert requirements("shear", NAMES, liquid) == ()
    # Fibres do not come back through the numerics.
    for numerics in ({"order": 2}, {"fibres": 6}):
        bare = with_effects(scene_of(numerics=numerics), ("inertia", "bending", "extensibility"))
        assert bare.numerics.order is None and bare.numerics.fibres is None


@pytest.mark.slow
def test_an_effect_is_credited_with_its_own_share(honey: Pricing) -> None:
    row = rows_of(honey)["finite-stretch"]
    assert "shear" in row.also and row.variant is not None and row.reference is not None
    assert set(row.reference.effects) - set(row.variant.effects) == {"finite-stretch"}
    own = np.abs(row.variant.midpoint - row.reference.midpoint).max() / honey.scale
    assert row.own_change == pytest.approx(own, rel=1e-12)
    assert row.share == min(row.change or 0, own)
    possible = {effect.name for effect in REGISTRY if effect.applies(honey.scene)}
    assert set(everything(honey.scene, ())) == possible - {"rotary-inertia"}
    assert "rotary-inertia" in everything(honey.scene, ("rotary-inertia",))


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


BAD: list[tuple[tuple[str, ...], str]] = [
    ((), "name one scene, or ask for --bundled"),
    (("cold-honey", "--bundled"), "name one scene, or ask for --bundled"),
    (("nowhere.toml",), "no such file"),
    (("cold-honey", "--set", "nonsense"), "'nonsense' sets nothing"),
    (("cold-honey", "--set", "numerics.cells=2.5"), "numerics.cells"),
    (("ink-bridge", "--set", "model=small-deflection"), "material.law"),
    *((("--bundled", "--set", change), change.split("=")[0]) for change in ("nonsense", "material.yeild_stress=3 Pa")),
]


def test_bad_input_is_one_message_and_leaves_nothing(softcat: Softcat, tmp_path: Path) -> None:
    softcat.monkeypatch.setattr("softcat_sym.scene.bundled.bundled_names", lambda: ("cold-honey", "gelatin-strand"))
    for arguments, named in BAD:
        done = softcat("effects", *arguments, "-o", str(tmp_path / "out"))
        assert (done.status, done.out) == (2, ""), arguments
        assert named in done.err, (arguments, done.err)
        assert not (tmp_path / "out").exists(), arguments
    (tmp_path / "taken").write_text("a file")
    for scene in ("cold-honey", "--bundled"):
        done = softcat("effects", scene, "-o", str(tmp_path / "taken" / "below"))
        assert done.status == 2 and "is not a directory" in done.err
