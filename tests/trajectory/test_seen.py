"""The few numbers that describe a motion, of shapes and histories that are known exactly."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from softcat_sym import simulate
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.effect import Motion
from softcat_sym.effects.forecast import compliant_sag, lagging
from softcat_sym.results.motion import seen
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.scene import Scene

Array = np.ndarray[Any, Any]

SPAN, CELLS, FRAMES = 2.0, 200, 2001
DENSITY, GRAVITY = 1000.0, 10.0
NODES = np.linspace(-SPAN / 2, SPAN / 2, CELLS + 1)
LIMIT, VISCOSITY = 2000.0, 1e4


def scene_of(*effects: str, thickness: float = 0.02, E: float = 1e7, **tables: dict[str, Any]) -> Scene:
    """A Bingham filament, or one of another law, with named effects."""
    table: dict[str, Any] = {
        "filament": {"span": f"{SPAN} m", "thickness": f"{thickness!r} m", "density": f"{DENSITY} kg/m^3"},
        "material": {
            "law": "bingham",
            "youngs_modulus": f"{E!r} Pa",
            "viscosity": f"{VISCOSITY} Pa*s",
            "yield_stress": f"{LIMIT} Pa",
        },
        "load": {"gravity": f"{GRAVITY} m/s^2"},
        "run": {"duration": "3 s", "frames": FRAMES, "effects": list(effects)},
    }
    for name, values in tables.items():
        table[name] = table.get(name, {}) | values
    return Scene.model_validate(table)


ALL = ("inertia", "bending", "finite-stretch", "thinning", "large-rotation", "viscous-flow", "yielding")


def shapes(depth: Array, drop: float = 0.0) -> dict[str, Array]:
    """Parabolas of these depths [m] below a line that falls by a drop, without any stress."""
    line = -drop * (NODES / SPAN + 0.5)
    y = line - depth[:, None] * (1 - (2 * NODES / SPAN) ** 2)
    x = np.broadcast_to(NODES, y.shape)
    stretch = np.hypot(np.diff(x), np.diff(y)) / np.diff(NODES)
    nothing = np.zeros_like(stretch)
    names = ("shear_force", "stress_mean", "stress_bending", "yielded_fraction")
    energies = dict.fromkeys(("energy_dissipated", "energy_elastic"), np.zeros(len(y)))
    return {"x": x, "y": y, "stretch": stretch} | dict.fromkeys(names, nothing) | energies


def motion_of(scene: Scene, fields: dict[str, Array]) -> Motion:
    """What is seen of the fields."""
    time = np.linspace(0.0, scene.run.duration, len(fields["y"]))
    return seen(scene, choose_effects(scene), time, (NODES, (NODES[1:] + NODES[:-1]) / 2), fields)


def motion_of_run(done: Trajectory) -> Motion:
    """What is seen of a finished run."""
    data = done.data
    places = (data["X_node"].values, data["X_cell"].values)
    fields = {str(name): values.values for name, values in data.data_vars.items()}
    return seen(done.scene, choose_effects(done.scene), data["time"].values, places, fields)


@pytest.mark.parametrize("periods", [1, 3.5, 12])
def test_swings_of_a_sine_are_its_phase_times_its_share_of_the_sag(periods: float) -> None:
    """About 0.7 of the largest sag it swings by 0.3 of it."""
    phase = 2 * np.pi * periods * np.linspace(0, 1, FRAMES)
    found = motion_of(scene_of(*ALL), shapes(0.1 * (0.7 - 0.3 * np.cos(phase))))
    exact = 0.3 * 2 * np.pi * periods
    # The way that it has gone for good is no swing: half a period more ends at the other side.
    assert found.swings == pytest.approx(exact - (0.3 * np.pi if periods % 1 else 0), rel=1e-3)


def test_a_descent_does_not_swing() -> None:
    assert motion_of(scene_of(*ALL), shapes(np.linspace(0, 0.3, FRAMES) ** 2)).swings == pytest.approx(0, abs=1e-12)
    assert motion_of(scene_of(*ALL), shapes(np.zeros(3))).swings == 0


def test_a_ringing_that_dies_away_counts_what_it_has_rung() -> None:
    """A exp(-t/tau) cos(omega t): the phase omega tau of the amplitude that it began with."""
    time = np.linspace(0, 8, FRAMES)
    found = motion_of(scene_of(*ALL), shapes(0.1 * (1 - np.exp(-time) * np.cos(40 * time))))
    largest = 1 + math.exp(-np.pi / 40)
    # travelled, less what it has come down by for good
    assert found.swings == pytest.approx((40 - np.pi / 2) / largest, rel=0.02)


@pytest.mark.parametrize("depth", [1e-3, 0.1, 0.6])
def test_sag_slope_and_strain_of_a_parabola(depth: float) -> None:
    """Slope 4 H/L at the ends; arc length of y = -H (1 - u^2) in closed form."""
    found = motion_of(scene_of(*ALL), shapes(np.linspace(0, depth, 5)))
    steep = 4 * depth / SPAN
    arc = math.sqrt(1 + steep**2) / 2 + math.asinh(steep) / (2 * steep)
    assert found.sag == pytest.approx(depth / SPAN)
    assert found.scale == pytest.approx(depth / SPAN)
    assert found.slope == pytest.approx(math.atan(steep), rel=0.01)
    assert found.strain == pytest.approx(arc - 1, rel=1e-3)


def test_sag_counts_from_the_line_and_an_error_from_the_left_support() -> None:
    scene = scene_of(*ALL, ends={"drop": "0.4 m"})
    found = motion_of(scene, shapes(np.linspace(0, 0.1, 5), drop=0.4))
    assert found.sag == pytest.approx(0.1 / SPAN)
    assert found.scale == pytest.approx(0.3 / SPAN)
    assert found.slope == pytest.approx(math.atan(0.4 / SPAN + 4 * 0.1 / SPAN), rel=0.01)


def test_the_largest_frame_counts_not_the_last() -> None:
    found = motion_of(scene_of(*ALL), shapes(np.array([0.0, 0.2, 0.05])))
    assert found.sag == pytest.approx(0.1)
    assert found.strain == pytest.approx(8 / 3 * 0.1**2, rel=0.03)


def test_a_filament_that_does_not_move_is_seen_all_the_same() -> None:
    found = motion_of(scene_of(*ALL), shapes(np.zeros(5)))
    assert 0 < found.sag < 1e-9
    assert found.strain == 0
    assert all(math.isfinite(value) for value in (found.sheared, found.tension_share, found.missed))


def test_folds_of_a_uniform_flow() -> None:
    """Sigma/eta for as long as the whole section flows."""
    fields = shapes(np.zeros(301))
    flowing = fields["stretch"] * 0
    flowing[100:201] = 1.0  # a second
    fields |= {"stress_mean": np.full_like(flowing, 3 * LIMIT), "yielded_fraction": flowing}
    found = motion_of(scene_of(*ALL), fields)
    assert found.folds == pytest.approx(3 * LIMIT / VISCOSITY * 1.0, rel=0.02)
    pushed = motion_of(scene_of(*ALL), fields | {"stress_mean": np.full_like(flowing, -3 * LIMIT)})
    assert pushed.folds == 0


def test_without_a_yield_stress_a_neck_grows_with_the_strain() -> None:
    scene = scene_of(*(name for name in ALL if name != "yielding"), material={"law": "maxwell", "yield_stress": None})
    found = motion_of(scene, shapes(np.linspace(0, 0.4, 5)))
    assert found.folds == found.strain > 0.05
    assert math.isinf(found.overstress)


@pytest.mark.parametrize(("mean", "bent"), [(0.5, 0.25), (-0.5, 0.25), (0.5, -0.25)])
def test_overstress_is_that_of_the_outermost_fibre(mean: float, bent: float) -> None:
    fields = shapes(np.zeros(4))
    stress, zeros = fields["stress_mean"].copy(), np.zeros_like(fields["stress_mean"])
    stress[2, 7] = mean * LIMIT
    bending = zeros.copy()
    bending[2, 7] = bent * LIMIT
    found = motion_of(scene_of(*ALL), fields | {"stress_mean": stress, "stress_bending": bending})
    assert found.overstress == pytest.approx(0.75)


def test_overstress_of_a_run_below_first_yield() -> None:
    """Between clamps rho g L^2/(2 h0): w L^2/12 over w h0^2/6."""
    thickness, strength = 0.1, 1e6
    scene = scene_of("bending", thickness=thickness, E=1e10, run={"frames": 2}, numerics={"cells": 40}).replace(
        {"material.yield_stress": f"{strength!r} Pa"}
    )
    found = motion_of_run(simulate(scene))
    assert found.overstress == pytest.approx(DENSITY * GRAVITY * SPAN**2 / (2 * thickness) / strength, rel=0.03)
    assert found.relaxed == 0


def test_what_does_not_flow_is_not_foreseen_to_relax_beyond_its_overstress() -> None:
    """Without the effect the stress is the elastic one: all above the yield stress may go."""
    fields = shapes(np.zeros(4))
    fields["stress_mean"] = np.full_like(fields["stress_mean"], 4 * LIMIT)
    assert motion_of(scene_of("bending"), fields).relaxed == pytest.approx(3 / 4)


def test_what_has_flowed_shows_in_the_work_that_is_lost() -> None:
    """Of a filament that was not foreseen to yield: what is lost, of that and the most that was stored."""
    scene = scene_of(*ALL, material={"yield_stress": "1 GPa"})
    fields = shapes(np.zeros(4))
    assert motion_of(scene, fields).relaxed == 0
    fields["energy_elastic"] = np.array([0.0, 1.0, 0.5, 0.5])
    fields["energy_dissipated"] = np.array([0.0, 1.0, 2.0, 3.0])
    assert motion_of(scene, fields).relaxed == pytest.approx(3 / 4)


def test_compliance_is_timoshenkos() -> None:
    """The sag by shear alone, q L^2/(8 kappa mu A), of the transverse force of a run without shear."""
    for ends in [("clamped", "clamped"), ("pinned", "pinned")]:
        for section in ["rectangle", "circle"]:
            poisson, E = 0.3, 1e9
            scene = scene_of(
                "bending",
                thickness=0.2,
                filament={"section": section},
                material={"poisson": poisson, "yield_stress": "1 GPa"},
                E=E,
                ends={"left": ends[0], "right": ends[1]},
                run={"frames": 2},
                numerics={"cells": 40},
            )
            done = simulate(scene)
            added = compliant_sag(scene, done.data["shear_force"].values, np.diff(done.data["X_node"].values)) * SPAN
            found = motion_of_run(done)
            correction = {
                "rectangle": 10 * (1 + poisson) / (12 + 11 * poisson),
                "circle": 6 * (1 + poisson) / (7 + 6 * poisson),
            }
            exact = DENSITY * GRAVITY * SPAN**2 / (8 * correction[section] * E / (2 * (1 + poisson)))
            print(f"{ends} {section}: {added:.4e} against {exact:.4e}")
            assert added == pytest.approx(exact, rel=0.03)
            assert found.sheared * found.sag * SPAN == pytest.approx(exact, rel=0.07)


def test_a_viscous_stress_delays_shear() -> None:
    """A force that sets in and stays: a Kelvin-Voigt solid follows it as 1 - exp(-t/lag)."""
    time, lag = np.linspace(0, 3, 31), 0.7
    force = np.tile([2.0, -1.0], (31, 1))
    np.testing.assert_allclose(lagging(time, force, lag), force * (1 - np.exp(-time / lag))[:, None], atol=1e-14)
    assert lagging(time, force, 0.0) is force


def test_a_mass_on_a_viscoelastic_string_shears_it() -> None:
    """Beside the mass, where the string bends, its transverse force shears it; the check sees what shear makes."""
    scene = Scene.model_validate(
        {
            "filament": {"span": "0.2 m", "thickness": "4 mm", "density": "1000 kg/m^3"},
            "material": {"law": "kelvin-voigt", "youngs_modulus": "28 kPa", "viscosity": "29 kPa*s"},
            "ends": {"left": "pinned", "right": "pinned"},
            "load": {"ramp": "0.75 s", "point_mass": "1.5 g"},
            "run": {"duration": "12 s", "accuracy": 1e-3},
        }
    )
    chosen = simulate(scene)
    assert [said.split(":")[0] for said in chosen.summary["repeats"]] == ["shear"]
    less = simulate(scene.replace({"run.effects": [name for name in chosen.summary["effects"] if name != "shear"]}))
    made = abs(less.data.midpoint.values[-1] / chosen.data.midpoint.values[-1] - 1)
    found = motion_of_run(less).sheared
    print(f"shear makes {made:.2e} of the sag, the check finds {found:.2e}")
    assert 1 < found / made < 4


def test_a_run_without_inertia_misses_its_free_fall() -> None:
    """A viscous descent H = c t: late by what it falls while it catches up, c^2/g."""
    speed, duration = 0.05, 3.0
    names = [name for name in ALL if name != "inertia"]
    found = motion_of(scene_of(*names), shapes(speed * np.linspace(0, duration, 301)))
    assert 1 < found.missed / (speed / GRAVITY / duration) < 3


@pytest.mark.parametrize("reached", [0.25, 0.75])
def test_the_share_of_the_sag_within_the_ramp(reached: float) -> None:
    names = [name for name in ALL if name != "inertia"]
    scene = scene_of(*names, load={"ramp": "1.5 s"})
    depth = np.interp(np.linspace(0, 3, 301), [0, 1.5, 3], [0, reached * 0.1, 0.1])
    assert motion_of(scene, shapes(depth)).risen == pytest.approx(reached)
