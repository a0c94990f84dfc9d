"""Rough predictions have the prefactors of the closed forms that they are made of."""

from __future__ import annotations

import math

import pytest

from softcat_sym.effects.forecast import expected_sag, expected_strain, forecast
from softcat_sym.effects.quasi_static import flow_sag
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.scaling_estimates import (
    bending_stiffness,
    duration_star,
    elastic_sag,
    first_yield_gravity_number,
    smaller_of,
    weight_stress,
)
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

from .scenes import scene_of

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


def test_a_thin_cable_sags_as_the_elastic_cable() -> None:
    scene = scene_of("elastic", filament={"thickness": "0.05 mm"})
    wanted = (3 * RHO * G * SPAN**4 / (64 * 4e6)) ** (1 / 3)
    assert elastic_sag(scene) * SPAN == pytest.approx(wanted, rel=0.01)


def test_the_beam_of_one_clamp_lies_between() -> None:
    between = bending_stiffness(scene_of(ends=MIXED))
    mirrored = bending_stiffness(scene_of(ends={"left": "clamped", "right": "pinned"}))
    assert between == mirrored
    # sag of a propped cantilever at midspan: q L^4/(192 E I), half that of a clamped beam's stiffness
    assert between == pytest.approx(bending_stiffness(scene_of()) / 2, rel=1e-14)
    assert bending_stiffness(scene_of(ends=PINNED)) == pytest.approx(between * 2 / 5, rel=1e-14)


def test_a_circle_bends_more_easily_than_a_square() -> None:
    circle = bending_stiffness(scene_of(filament={"section": "circle"}))
    assert circle / bending_stiffness(scene_of()) == pytest.approx(12 / 16, rel=1e-14)
    assert bending_stiffness(scene_of()) == pytest.approx(384 / 12 * 0.03**2, rel=1e-12)


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


def test_a_viscous_string_flows_as_the_cube_root_of_time() -> None:
    scene = scene_of("maxwell", "0 s", filament={"thickness": "0.02 mm"}, run={"duration": "1 ms"})
    wanted = (9 * RHO * G * SPAN**4 * 1e-3 / (128 * 13840)) ** (1 / 3)
    assert flowing_sag(scene) * SPAN == pytest.approx(wanted, rel=0.01)


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


def test_above_the_square_root_of_two_nothing_holds() -> None:
    weak = {"yield_stress": f"{RHO * G * SPAN / 1.5!r} Pa", "viscosity": "1 Pa*s"}
    scene = scene_of(material=weak, run={"duration": "1000 s"})
    assert flowing_sag(scene) > 1


def test_no_prediction_goes_beyond_free_fall() -> None:
    scene = scene_of("maxwell", "0 s", run={"duration": "5 ms"})
    assert expected_sag(scene) * SPAN == pytest.approx(G * 0.005**2 / 2)


def test_two_resistances_together() -> None:
    for bending, stretching in [(1.0, 2.0), (0.5, 1e-3), (1e9, 0.3), (0.3, 1e9)]:
        both = smaller_of(bending, stretching)
        assert 0 < both < min(bending, stretching)
        assert both >= min(bending, stretching) / 2
        assert smaller_of(0.0, stretching) == smaller_of(bending, 0.0) == 0


def test_strain_of_a_shallow_parabola() -> None:
    scene = scene_of("elastic")
    assert expected_strain(scene) == pytest.approx(8 / 3 * expected_sag(scene) ** 2)


def test_duration_in_units_of_the_fall() -> None:
    assert duration_star(scene_of(run={"duration": "1 s"})) == pytest.approx(1 / math.sqrt(SPAN / G))
    assert duration_star(scene_of(load={"gravity": "0 m/s^2"})) == 0


def test_estimates_of_bundled_scenes_are_finite_and_not_negative() -> None:
    for name in bundled_names():
        scene = load_scene(name)
        for effect in REGISTRY:
            estimate = effect.estimate(scene, forecast(scene))
            assert math.isfinite(estimate.value), effect.name
            assert estimate.value >= 0, effect.name
            assert estimate.meaning
        assert 0 < expected_sag(scene) < math.inf


def test_estimates_of_any_scene_are_finite_and_not_negative() -> None:
    for law in ["elastic", "maxwell", "bingham"]:
        for gravity in ["0 m/s^2", "9.81 m/s^2"]:
            for ends in [{}, PINNED, MIXED]:
                scene = scene_of(law, load={"gravity": gravity}, ends=ends)
                for effect in REGISTRY:
                    assert math.isfinite(effect.estimate(scene, forecast(scene)).value), effect.name
                    assert effect.estimate(scene, forecast(scene)).value >= 0, effect.name
