"""Effects: what they need, when they are chosen, and that they leave nothing where they are absent."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.effects.effect_sets import terms_of
from softcat_sym.effects.gravity_shaking import GRAVITY_SHAKING
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.selection import choose_effects
from softcat_sym.effects.theory_limits import theory_limits
from softcat_sym.errors import SceneError
from softcat_sym.estimates.expected_regime import ExpectedRegime, expected_regime
from softcat_sym.estimates.forecast import (
    damping,
    expected_sag,
    forecast,
    missed_inertia,
    overshoot,
    shaken_share,
    steady_gain,
)
from softcat_sym.estimates.free_vibration import ringing
from softcat_sym.estimates.quasi_static_sag import flow_sag, quasi_static_history
from softcat_sym.estimates.scaling import (
    elastic_sag,
    first_yield_gravity_number,
    weight_stress,
)
from softcat_sym.reference.calculix import calculix_deck
from softcat_sym.reference.element_loop import problem_of
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.tables import bodies_of
from softcat_sym.scene.units import length_text
from softcat_sym.studies.phase_runs import refuse_scene
from tests.common.scenes import scene_of

# Effects are well formed, independent of one another, and leave nothing behind when absent.
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


def without(*names: str) -> tuple[str, ...]:
    return tuple(name for name in ALL if name not in names)


def test_paper_takes_the_published_effects_that_apply() -> None:
    for name in bundled_names():
        scene = load_scene(name, {"run.effects": "paper"})
        if any(body.room() == 0 for body in bodies_of(scene)):
            with pytest.raises(SceneError, match="lies on"):
                choose_effects(scene)
            continue
        if scene.material.spec.has_chains:
            # Its bending is not linear through the thickness, which the published list takes for granted.
            with pytest.raises(SceneError, match="fibres"):
                choose_effects(scene)
            continue
        if is_spatial(scene):
            with pytest.raises(SceneError, match="three dimensions"):
                choose_effects(scene)
            continue
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
    assert "faster" in quicker.reasons["shear"]
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
    assert "yield stress holds" in with_fibres.reasons["yielding"]


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
    possible = {effect.name for effect in REGISTRY if effect.applies(scene)}
    assert set(effects.left_out) == possible - set(effects.names)
    assert all("named in run.effects" in reason for reason in effects.reasons.values())


def test_a_filament_stretched_so_far_that_sections_would_turn_is_not_given_shear() -> None:
    """Log s against kappa_s/(2 (1 + nu) (1 - kappa_s/2)) = 0.4926 of a rectangle: stretch 1.637."""
    for stretch, shears in ((1.60, True), (1.67, False)):
        asked = {"initial.stretch": stretch, "initial.relaxed": False, "run.effects": "auto", "run.accuracy": 1e-4}
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


# Rough predictions have the prefactors of the closed forms that they are made of.
G, RHO, SPAN = 9.81, 1900.0, 0.2
PINNED = {"left": "pinned", "right": "pinned"}
MIXED = {"left": "pinned", "right": "clamped"}


def flowing_sag(scene: Scene) -> float:
    """What flow adds in the run to a filament that begins nearly straight."""
    return flow_sag(scene, weight_stress(scene), 1e-7, scene.run.duration)


def second_moment(section: str, thickness: float) -> tuple[float, float]:
    """Area and second moment of area."""
    if section == "circle":
        return math.pi * thickness**2 / 4, math.pi * thickness**4 / 64
    return thickness**2, thickness**4 / 12


def test_a_stiff_beam_sags_as_the_textbook_says() -> None:
    for ends, constant in [({}, 384.0), (PINNED, 76.8)]:
        for section in ["rectangle", "circle"]:
            modulus, thickness = 1e11, 0.006
            scene = scene_of(
                "elastic", filament={"section": section}, material={"youngs_modulus": "100 GPa"}, ends=ends
            )
            area, inertia = second_moment(section, thickness)
            wanted = RHO * G * area * SPAN**4 / (constant * modulus * inertia)
            # stretching takes a share of the load even here
            assert elastic_sag(scene) * SPAN == pytest.approx(wanted, rel=0.01)
            assert elastic_sag(scene) * SPAN < wanted


def test_first_yield() -> None:
    for section, ends, wanted in [
        ("rectangle", {}, 2.0),
        ("circle", {}, 1.5),
        ("rectangle", PINNED, 4 / 3),
        ("circle", PINNED, 1.0),
        ("rectangle", MIXED, 4 / 3),
    ]:
        scene = scene_of(filament={"section": section}, ends=ends)
        assert first_yield_gravity_number(scene) == pytest.approx(wanted * 0.03)


def test_a_viscous_beam_flows_in_proportion_to_time() -> None:
    scene = scene_of("maxwell", "0 s", filament={"section": "circle"}, run={"duration": "1e-6 s"})
    area, inertia = second_moment("circle", 0.006)
    wanted = RHO * G * area * SPAN**4 * 1e-6 / (384 * 13840 * inertia)
    assert flowing_sag(scene) * SPAN == pytest.approx(wanted, rel=0.02)


def test_nothing_flows_below_first_yield_or_without_a_viscosity() -> None:
    assert flowing_sag(scene_of(material={"yield_stress": "1 MPa"})) == 0
    assert flowing_sag(scene_of("elastic")) == 0
    assert flowing_sag(load_scene("no-yield")) == 0


def test_arrest_is_no_deeper_than_the_catenary_that_just_holds() -> None:
    """(3.13): sigma_Y = rho g L (H + 1/(8 H)), the tension of a shallow catenary at its supports."""
    for gravity_number in [0.2, 0.4, 1.0, 1.4]:
        stress = RHO * G * SPAN / gravity_number
        scene = scene_of(material={"yield_stress": f"{stress!r} Pa", "viscosity": "1 Pa*s"}, run={"duration": "1000 s"})
        stop = flowing_sag(scene)  # the last of a table whose sags are 17 % apart
        assert 1 <= gravity_number * (stop + 1 / (8 * stop)) < 1.2
        assert stop <= 1 / math.sqrt(8)


def test_an_effect_is_told_by_the_sag_without_it() -> None:
    """An elastic beam and cable: (64/3) H^3 + k H = q L/E in spans, of which the one term or the other is left out."""
    L, h, E, q = 0.1, 2e-3, 1e6, 1000 * 9.81 * 0.1
    table: dict[str, Any] = {
        "filament": {"span": L, "thickness": h, "width": h, "density": 1000.0},
        "material": {"law": "elastic", "youngs_modulus": E},
        "load": {"ramp": "1 s"},
        "run": {"duration": 1.0},
    }
    scene = sc.Scene.from_dict(table)
    bent = 32 * (h / L) ** 2
    sag = brentq(lambda H: 64 / 3 * H**3 + bent * H - q / E, 0, 1)
    found = {one.effect.name: one.estimate for one in choose_effects(scene).decisions if one.estimate}
    # The forecast, half the harmonic mean of both, is up to 20 % too low, and what is told to a factor of two.
    assert found["bending"].sag == pytest.approx(sag * L, rel=0.2)
    for name, alone in (("bending", (3 / 64 * q / E) ** (1 / 3)), ("extensibility", q / E / bent)):
        assert 1.1 * sag < alone
        assert 0.5 < found[name].sag * found[name].without / (alone * L) < 2
    reasons = choose_effects(scene).reasons
    for name in ("bending", "extensibility"):
        sag, without = (length_text(one, 2) for one in (found[name].sag, found[name].sag * found[name].without))
        assert reasons[name] == f"sag about {sag}; without it {without}"


def test_no_prediction_goes_beyond_free_fall() -> None:
    scene = scene_of("maxwell", "0 s", run={"duration": "5 ms"})
    assert expected_sag(scene) * SPAN == pytest.approx(G * 0.005**2 / 2)


def test_estimates_of_bundled_scenes_are_finite_and_not_negative() -> None:
    for name in bundled_names():
        scene = load_scene(name)
        for effect in REGISTRY:
            estimate = effect.estimate(scene, forecast(scene))
            assert math.isfinite(estimate.value), effect.name
            assert estimate.value >= 0, effect.name
            assert estimate.meaning
        assert 0 < expected_sag(scene) < math.inf


# What is foreseen of a motion agrees with one-mode filaments integrated here, to a factor that estimates may miss.
G_SHAKEN, RHO_SHAKEN, SPAN_SHAKEN, E = 9.81, 1900.0, 0.2, 4e6
STRESS = RHO_SHAKEN * G_SHAKEN * SPAN_SHAKEN
THIN = {"thickness": "0.02 mm"}
TIMES = np.linspace(0.0, 1.0, 201)


def depth(force: Callable[[float, float, float], float]) -> np.ndarray:
    """Depth of H'' = force(t, H, H') from rest."""
    found = solve_ivp(
        lambda t, y: [y[1], force(t, y[0], y[1])], (0, 1), [0.0, 0.0], "Radau", TIMES, rtol=1e-9, atol=1e-12
    )
    return np.asarray(found.y[0])


@pytest.mark.parametrize("drag", [50.0, 500.0, 5000.0])
def test_a_dashpot_misses_what_it_falls_while_it_catches_up(drag: float) -> None:
    """H'' = g - drag H': late by 1/drag for ever; balanced, H = g t/drag."""
    truth, balanced = depth(lambda t, h, v: G_SHAKEN - drag * v), G_SHAKEN * TIMES / drag
    missing = float(np.max(np.abs(truth - balanced)) / np.max(balanced))
    assert missing == pytest.approx(1 / drag, rel=0.02)
    assert 1 < missed_inertia(TIMES, balanced, G_SHAKEN, 0.0) / missing < 3


@pytest.mark.parametrize("drag", [1e3, 1e5, 1e7])
def test_a_string_misses_the_layer_at_its_beginning(drag: float) -> None:
    """H'' = g - drag H^2 H': balanced, H = (3 g t/drag)^(1/3), with an infinite speed at the beginning."""
    truth, balanced = depth(lambda t, h, v: G_SHAKEN - drag * h * h * v), np.cbrt(3 * G_SHAKEN * TIMES / drag)
    missing = float(np.max(np.abs(truth - balanced)) / np.max(balanced))
    assert 0.3 < missed_inertia(TIMES, balanced, G_SHAKEN, 0.0) / missing < 4


def test_quasi_static_sag_of_a_thin_cable_and_of_a_viscous_string() -> None:
    cable = quasi_static_history(scene_of("elastic", "0 s", filament=THIN)).sag
    assert cable == pytest.approx((3 * STRESS / (64 * E)) ** (1 / 3), rel=0.01)
    # at a sag of a seventh the span what a shallow parabola leaves out is 4 %
    stiff = {"viscosity": "10 kPa*s", "youngs_modulus": "1e12 Pa"}
    string = quasi_static_history(scene_of("maxwell", "0 s", filament=THIN, run={"duration": "0.1 s"}, material=stiff))
    assert string.sag[1:] == pytest.approx(np.cbrt(9 * STRESS * string.time[1:] / (128 * 1e4)), rel=0.05)


def test_a_ramp_leaves_little_ringing() -> None:
    sudden, slow = (ringing(scene_of("elastic", ramp, filament={"thickness": "20 mm"})) for ramp in ("0 s", "0.5 s"))
    assert slow.amplitude < 1e-3 * sudden.amplitude
    assert sudden.phase(1.0) == pytest.approx(sudden.frequency)


def test_flow_and_a_viscous_stress_end_the_ringing() -> None:
    maxwell = ringing(scene_of("maxwell", "0 s", filament={"thickness": "20 mm"}, material={"viscosity": "400 kPa*s"}))
    assert maxwell.decay == pytest.approx(E / (2 * 4e5))
    solid = scene_of("kelvin-voigt", "0 s", filament={"thickness": "20 mm"}, material={"viscosity": "4 kPa*s"})
    found = ringing(solid)
    assert found.decay == pytest.approx(found.frequency**2 * 1e-3 / 2)
    assert ringing(solid.replace({"material.viscosity": "4 MPa*s"})).amplitude == 0


KNOWN = {
    "arrested-overdamped": 0.06478,  # plane-stress elements
    "continual-descent": 0.24925,  # plane-stress elements
    "maxwell-slow": (9 * 3.3e-5 * 20) ** (1 / 3) / 4,  # the 1/3 law
    "cold-honey": (9 * 1420 * 9.81 * 0.05 * 0.3 / (128 * 600)) ** (1 / 3),  # viscous string
    "glass-rod": 8.5e-6 / 0.05,  # ASTM C598
}
"""Largest sags over the span, none of them computed here."""


def test_sag_is_foreseen_within_a_third() -> None:
    for name in KNOWN:
        assert forecast(load_scene(name)).sag == pytest.approx(KNOWN[name], rel=0.34)


def test_what_gives_way_while_it_hangs_slack_keeps_its_inertia() -> None:
    """Its hinges yield from the first moment on; one that only its strength holds back hangs in balance."""
    slack = {"filament": {"rest_length": "0.25 m"}, "load": {"ramp": "0 s"}}
    weak, strong = (scene_of(material={"yield_stress": stress}, **slack) for stress in ("9 kPa", "90 MPa"))
    assert forecast(weak).missed == 1
    assert forecast(strong).missed < 0.01


# The shaking of gravity: who must have it, how large it is foreseen to be, and who refuses it by name.
BEAM = {"filament": {"thickness": "20 mm"}}


def shaken(scene: Scene, a: float = 0.5, ratio: float = 0.1) -> Scene:
    """At a share of the first frequency."""
    frequency = ringing(scene).frequency
    hertz = ratio * (frequency if math.isfinite(frequency) else 30.0) / (2 * math.pi)
    return scene.replace({"load.shake": a, "load.shake_frequency": f"{hertz!r} Hz"})


def test_shaking_is_refused_where_it_cannot_be_had_and_where_it_is_left_out() -> None:
    for scene, says in (
        (shaken(scene_of("elastic", run={"effects": ["inertia", "bending"]})), "without 'gravity-shaking'"),
        (shaken(scene_of("elastic", run={"effects": ["bending", "gravity-shaking"]})), "without 'inertia'"),
        (scene_of("elastic", run={"effects": ["inertia", "bending", "gravity-shaking"]}), r"load\.shake is zero"),
        (shaken(scene_of("bingham", run={"closure": "printed"})), "'printed' with gravity-shaking"),
    ):
        with pytest.raises(SceneError, match=says):
            choose_effects(scene)


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


def test_a_shaken_filament_is_foreseen_to_go_deeper() -> None:
    scene = scene_of("elastic", "0 s", **BEAM)
    steady, moved = forecast(scene), forecast(shaken(scene, ratio=0.8))
    assert moved.sag > 1.5 * steady.sag
    assert moved.strain > steady.strain
    assert moved.missed >= steady.missed


@pytest.mark.parametrize("refuses", [problem_of, calculix_deck, refuse_scene])
def test_who_does_not_know_it_says_so(refuses: Callable[[Scene], object]) -> None:
    scene = load_scene("arrested-overdamped")
    refuses(scene)
    with pytest.raises(SceneError) as caught:
        refuses(shaken(scene))
    assert [fault.path for fault in caught.value.faults] == ["load.shake"]


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


# The regime and the warnings foretold: numbers against independent roots, names against what runs have shown.
PAPER = "arrested-overdamped"
PUBLISHED = ("inertia", "bending", "viscous-flow", "yielding", "gravity-ramp")


def of(name: str, *changes: str) -> ExpectedRegime:
    scene = sc.load_scene(name, list(changes))
    return expected_regime(scene, choose_effects(scene).names)


def grouped(G: float, V: float) -> tuple[str, str]:
    return f"groups.G={G}", f"groups.V={V}"


def test_depths_end_where_no_catenary_is_held() -> None:
    for G, paper, exact in [(1.32, True, True), (1.33, True, False), (1.41, True, False), (1.42, False, False)]:
        found = expected_regime(sc.load_scene(PAPER, [f"groups.G={G}"]), PUBLISHED)
        assert (found.stopping_depth_paper is not None, found.stopping_depth_exact is not None) == (paper, exact)
        assert found.name == "descending"  # below the threshold by its hinges, beyond it for ever


# What runs have shown: the bundled scenes at their own accuracy, the others on 16 cells a half span.
BUNDLED = {
    "arrested-overdamped": "arrested-overdamped", "arrested-underdamped": "arrested-underdamped",
    "continual-descent": "descending", "no-yield": "no-yield",
    "ink-bridge": "arrested-overdamped", "toothpaste": "arrested-underdamped", "maxwell-slow": "viscous",
    "cold-honey": "viscous", "bread-dough": "viscous", "transient-gel": "viscous", "rubber-strand": "elastic",
    "cooked-spaghetti": "elastic", "stretched-rubber-band": "elastic",
}  # fmt: skip
SHOWN = {
    (0.03, 26): "no-yield", (0.04, 26): "arrested-underdamped", (0.08, 26): "arrested-underdamped",
    (0.08, 1): "arrested-underdamped", (0.15, 26): "arrested-underdamped", (0.15, 3): "arrested-underdamped",
    (0.25, 26): "arrested-underdamped", (0.25, 10): "arrested-underdamped", (0.25, 3): "arrested-underdamped",
    (0.3, 0.4): "arrested-underdamped", (0.4, 10): "arrested-overdamped", (0.4, 3): "arrested-overdamped",
    (0.8, 26): "descending", (1.2, 26): "descending", (1.37, 26): "descending", (1.5, 26): "descending",
}  # fmt: skip


def test_bundled_scenes_are_foretold() -> None:
    for name in list(BUNDLED):
        assert of(name, "run.effects=paper").name == BUNDLED[name]


def test_the_paper_s_filament_is_foretold() -> None:
    for G, V in list(SHOWN):
        scene = sc.load_scene(PAPER, list(grouped(G, V)))
        assert expected_regime(scene, PUBLISHED).name == SHOWN[G, V]


@pytest.mark.parametrize("D", [0.0, 0.005, 0.05, 0.4, 0.85, 1.45, 2.2, 3.5, 6.0])
def test_overshoot_is_where_the_falling_parabola_stops(D: float) -> None:
    G = 0.4
    V = D / damping(G, 1.0)

    def still(time: float, state: np.ndarray) -> float:
        return state[1] if time > 1e-3 else 1.0

    still.terminal, still.direction = True, -1  # type: ignore[attr-defined]
    # In sags over span and sqrt(L/g), as the balance of the parabola is first written.
    fall = solve_ivp(
        lambda _, s: [s[1], 5 / 4 - 10 * s[0] * (1 / G + 16 / 3 * V * s[0] * s[1])],
        (0, 60),
        [0.0, 0.0],
        events=still,
        rtol=1e-8,
        atol=1e-12,
        method="LSODA",
    )
    assert overshoot(G, V, 0.0) == pytest.approx(fall.y[0].max() / (G / 8), abs=0.01)


def test_a_slow_ramp_leaves_nothing_to_ring() -> None:
    assert overshoot(0.25, 0.4, 100.0) == pytest.approx(1, abs=1e-3)
    slow = expected_regime(sc.load_scene("arrested-underdamped", ["groups.ramp=400"]), PUBLISHED)
    assert slow.name == "arrested-overdamped"
    # With nothing that rings the threshold is the static one; at once, or nearly so, it is half of it.
    sudden = expected_regime(sc.load_scene(PAPER, ["groups.ramp=0"]), PUBLISHED)
    assert slow.first_yield is not None
    assert sudden.first_yield == pytest.approx(0.03)
    assert slow.first_yield == pytest.approx(0.06, rel=0.2)


def test_without_inertia_it_neither_overshoots_nor_rebounds() -> None:
    scene = sc.load_scene("arrested-underdamped")
    found = expected_regime(scene, [name for name in PUBLISHED if name != "inertia"])
    assert (found.overshoot, found.rebound, found.name) == (1.0, 0.0, "arrested-overdamped")


def test_a_cantilever_of_a_paste_stops_where_it_can_hang() -> None:
    free = ['ends.right="free"', "run.effects=paper"]
    assert of("toothpaste", *free, "filament.thickness=1 mm").stopping_depth_exact is None
    held = expected_regime(sc.load_scene(PAPER, [*grouped(0.9, 0.4), 'ends.right="free"']), PUBLISHED)
    lost = expected_regime(sc.load_scene(PAPER, [*grouped(1.1, 0.4), 'ends.right="free"']), PUBLISHED)
    assert held.name != "no-yield"
    assert "hangs" in held.reason
    assert (lost.name, lost.arrest_exact) == ("descending", 1.0)


def test_rupture_is_foretold_where_runs_have_shown_it() -> None:
    for G, V, ruptures in [
        (0.25, 0.4, False),
        (0.4, 0.4, True),
        (0.4, 1, False),
        (0.4, 26, False),
        (1.2, 2, True),
        (0.8, 3, True),
        (0.8, 26, False),
    ]:
        scene = sc.load_scene(PAPER, list(grouped(G, V)))
        told = " ".join(theory_limits(scene, PUBLISHED, terms_of(scene, PUBLISHED)))
        assert ("near rupture" in told) == ruptures


def test_surface_tension_adds_to_the_yield_stress_where_tension_holds() -> None:
    """G = rho g L/(sigma_Y + gamma/R) of a circle, and no number of bending feels it."""
    pulled, bare = of("ink-bridge"), of("ink-bridge", "surroundings.surface_tension=0 N/m")
    number, limit, added = bare.gravity_number, 3**0.5 * 200, 0.072 / 0.2e-3
    assert number is not None
    assert bare.collapse is not None
    assert pulled.gravity_number == pytest.approx(number * limit / (limit + added))
    assert pulled.collapse == pytest.approx(bare.collapse * limit / (limit + added))
    assert pulled.stopping_depth_paper == pytest.approx(pulled.gravity_number / 8, rel=0.01)
    assert "gamma" in pulled.reason
