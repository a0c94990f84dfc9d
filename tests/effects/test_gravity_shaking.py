"""The shaking of gravity: who must have it, how large it is foreseen to be, and who refuses it by name."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.effects.forecast import forecast, shaken_share, steady_gain
from softcat_sym.effects.free_vibration import ringing
from softcat_sym.errors import SceneError
from softcat_sym.reference.calculix import calculix_deck
from softcat_sym.reference.element_loop import problem_of
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.studies.card_rules import unusual
from softcat_sym.studies.phase_runs import refuse_scene

from .scenes import scene_of

BEAM = {"filament": {"thickness": "20 mm"}}


def shaken(scene: Scene, a: float = 0.5, ratio: float = 0.1) -> Scene:
    """At a share of the first frequency."""
    frequency = ringing(scene).frequency
    hertz = ratio * (frequency if math.isfinite(frequency) else 30.0) / (2 * math.pi)
    return scene.replace({"load.shake": a, "load.shake_frequency": f"{hertz!r} Hz"})


def test_a_scene_that_shakes_has_it_and_inertia() -> None:
    for law in ["elastic", "kelvin-voigt", "maxwell", "bingham"]:
        for asked in ["auto", "paper"]:
            scene = shaken(scene_of(law, run={"effects": asked}))
            names = choose_effects(scene).names
            assert {"gravity-shaking", "inertia"} <= set(names)
            assert "gravity-shaking" not in choose_effects(scene_of(law, run={"effects": asked})).names


def test_the_small_deflection_model_has_it_too() -> None:
    scene = shaken(scene_of("elastic").replace({"model": "small-deflection"}))
    assert "gravity-shaking" in choose_effects(scene).names


def test_a_list_without_it_is_refused_by_name() -> None:
    with pytest.raises(SceneError, match="without 'gravity-shaking', but gravity is shaken at") as caught:
        choose_effects(shaken(scene_of("elastic", run={"effects": ["inertia", "bending"]})))
    assert [fault.path for fault in caught.value.faults] == ["run.effects"]


def test_without_inertia_it_is_refused() -> None:
    with pytest.raises(SceneError, match="'gravity-shaking' without 'inertia'"):
        choose_effects(shaken(scene_of("elastic", run={"effects": ["bending", "gravity-shaking"]})))


def test_steady_gravity_cannot_have_it() -> None:
    with pytest.raises(SceneError, match=r"'gravity-shaking' cannot be had: load\.shake is zero"):
        choose_effects(scene_of("elastic", run={"effects": ["inertia", "bending", "gravity-shaking"]}))


def test_the_printed_closure_refuses_it() -> None:
    with pytest.raises(SceneError, match="'printed' with gravity-shaking"):
        choose_effects(shaken(scene_of("bingham", run={"closure": "printed"})))


def test_the_gain_is_that_of_an_oscillator() -> None:
    for ratio, gain in [(0.01, 1.0), (0.5, 4 / 3), (2.0, 1 / 3), (10.0, 1 / 99)]:
        scene = shaken(scene_of("elastic", "0 s", **BEAM), ratio=ratio)
        # The run is long: what it allows of damping is little.
        scene = scene.replace({"run.duration": "100 s"})
        assert steady_gain(scene) == pytest.approx(gain, rel=1e-3)
        assert shaken_share(scene) == pytest.approx(0.5 * (1 + ratio) * gain, rel=1e-3)


def test_at_resonance_it_grows_with_the_run() -> None:
    """An undamped oscillator driven at its own frequency grows by half a static deflection in 1/omega."""
    short, long = (
        shaken(scene_of("elastic", "0 s", run={"duration": time}, **BEAM), ratio=1.0) for time in ("1 s", "10 s")
    )
    assert steady_gain(short) == pytest.approx(ringing(short).frequency * 1.0 / 2, rel=1e-12)
    assert shaken_share(long) == pytest.approx(10 * shaken_share(short), rel=1e-12)


def test_what_flows_does_not_resonate() -> None:
    assert shaken_share(shaken(load_scene("cold-honey"), a=0.3)) == pytest.approx(0.3)


def test_a_shaken_filament_is_foreseen_to_go_deeper() -> None:
    scene = scene_of("elastic", "0 s", **BEAM)
    steady, moved = forecast(scene), forecast(shaken(scene, ratio=0.8))
    assert moved.sag > 1.5 * steady.sag
    assert moved.strain > steady.strain
    assert moved.missed >= steady.missed


@pytest.mark.parametrize(
    ("refuses", "scene"),
    [
        (problem_of, "arrested-overdamped"),
        (calculix_deck, "arrested-overdamped"),
        (refuse_scene, "arrested-overdamped"),
    ],
)
def test_who_does_not_know_it_says_so(refuses: Callable[[Scene], object], scene: str) -> None:
    refuses(load_scene(scene))
    with pytest.raises(SceneError) as caught:
        refuses(shaken(load_scene(scene)))
    assert [fault.path for fault in caught.value.faults] == ["load.shake"]


def test_no_rule_of_the_sag_card_knows_it() -> None:
    assert unusual(load_scene("no-yield")) == ""
    assert "shaken" in unusual(shaken(load_scene("no-yield")))


def test_the_regime_to_expect() -> None:
    for name, a, regime in [
        ("arrested-overdamped", 0.3, "shaken"),
        ("continual-descent", 0.3, "descending"),
        ("no-yield", 0.01, "no-yield"),
        ("no-yield", 9.0, "shaken"),
        ("rubber-strand", 0.3, "elastic"),
    ]:
        scene = shaken(load_scene(name), a=a)
        assert expected_regime(scene, choose_effects(scene).names).name == regime
