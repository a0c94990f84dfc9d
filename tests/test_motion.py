"""The few numbers that describe a motion, ringing and settling, of shapes and histories that are known exactly."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from softcat_sym import simulate
from softcat_sym.effects.selection import choose_effects
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.forecast import compliant_sag, lagging
from softcat_sym.results.fields import displacements
from softcat_sym.results.motion import (
    creep_of,
    observed_motion,
)
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.solution import Extremes

Array = np.ndarray[Any, Any]

SPAN, CELLS, FRAMES = 2.0, 200, 2001
DENSITY, GRAVITY = 1000.0, 10.0
NODES = np.linspace(-SPAN / 2, SPAN / 2, CELLS + 1)
LIMIT, VISCOSITY = 2000.0, 1e4
ALL = ("inertia", "bending", "finite-stretch", "thinning", "large-rotation", "viscous-flow", "yielding")


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
        "numerics": {"estimate": False},
    }
    for name, values in tables.items():
        table[name] = table.get(name, {}) | values
    return Scene.model_validate(table)


def shapes(depth: Array, drop: float = 0.0) -> dict[str, Array]:
    """Parabolas of these depths [m] below a line that falls by a drop, without any stress."""
    line = -drop * (NODES / SPAN + 0.5)
    y = line - depth[:, None] * (1 - (2 * NODES / SPAN) ** 2)
    x = np.broadcast_to(NODES, y.shape)
    stretch = np.hypot(np.diff(x), np.diff(y)) / np.diff(NODES)
    names = ("shear_force", "stress_mean", "stress_bending", "yielded_fraction")
    energies = dict.fromkeys(("energy_dissipated", "energy_elastic"), np.zeros(len(y)))
    return {"x": x, "y": y, "stretch": stretch} | dict.fromkeys(names, np.zeros_like(stretch)) | energies


def motion_of(scene: Scene, fields: dict[str, Array]) -> Motion:
    time = np.linspace(0.0, scene.run.duration, len(fields["y"]))
    places, moved = (NODES, (NODES[1:] + NODES[:-1]) / 2), displacements(scene, time, fields, NODES)
    seen = Extremes.of(time, fields["y"][:, CELLS // 2])
    return observed_motion(scene, choose_effects(scene), time, places, fields, moved, seen)


def motion_of_run(run: Run) -> Motion:
    places = (run.fields["X_node"], run.fields["X_cell"])
    time = run.fields["time"]
    moved, seen = displacements(run.scene, time, run.fields, places[0]), Extremes.of(time, run.fields["midpoint"])
    return observed_motion(run.scene, choose_effects(run.scene), time, places, run.fields, moved, seen)


def test_swings_are_the_phase_times_the_share_of_the_sag() -> None:
    """About 0.7 of the largest sag it swings by 0.3 of it; of A exp(-t/tau) cos(omega t) the phase omega tau counts."""
    for periods in (1, 3.5, 12):
        phase = 2 * np.pi * periods * np.linspace(0, 1, FRAMES)
        found = motion_of(scene_of(*ALL), shapes(0.1 * (0.7 - 0.3 * np.cos(phase))))
        exact = 0.3 * 2 * np.pi * periods
        # The way that it has gone for good is no swing: half a period more ends at the other side.
        assert found.swings == pytest.approx(exact - (0.3 * np.pi if periods % 1 else 0), rel=1e-3)
    assert motion_of(scene_of(*ALL), shapes(np.linspace(0, 0.3, FRAMES) ** 2)).swings == pytest.approx(0, abs=1e-12)
    assert motion_of(scene_of(*ALL), shapes(np.zeros(3))).swings == 0
    time = np.linspace(0, 8, FRAMES)
    found = motion_of(scene_of(*ALL), shapes(0.1 * (1 - np.exp(-time) * np.cos(40 * time))))
    # Travelled, less what it has come down by for good.
    assert found.swings == pytest.approx((40 - np.pi / 2) / (1 + math.exp(-np.pi / 40)), rel=0.02)


def test_sag_slope_and_strain_of_a_parabola() -> None:
    """Slope 4 H/L at the ends; arc length of y = -H (1 - u^2) in closed form; the largest frame counts."""
    for depth in (1e-3, 0.1, 0.6):
        found = motion_of(scene_of(*ALL), shapes(np.append(np.linspace(0, depth, 5), depth / 4)))
        steep = 4 * depth / SPAN
        arc = math.sqrt(1 + steep**2) / 2 + math.asinh(steep) / (2 * steep)
        assert (found.sag, found.scale) == pytest.approx((depth / SPAN, depth / SPAN))
        assert found.slope == pytest.approx(math.atan(steep), rel=0.01)
        assert found.strain == pytest.approx(arc - 1, rel=1e-3)
    # From the line between the supports.
    found = motion_of(scene_of(*ALL, ends={"drop": "0.4 m"}), shapes(np.linspace(0, 0.1, 5), drop=0.4))
    assert (found.sag, found.scale) == pytest.approx((0.1 / SPAN, 0.1 / SPAN))
    assert found.slope == pytest.approx(math.atan(0.4 / SPAN + 4 * 0.1 / SPAN), rel=0.01)
    still = motion_of(scene_of(*ALL), shapes(np.zeros(5)))
    assert 0 < still.sag < 1e-9 and still.strain == 0
    assert all(math.isfinite(value) for value in (still.sheared, still.tension_share, still.missed))


def test_folds_of_a_uniform_flow() -> None:
    """Sigma/eta for as long as the whole section flows; without a yield stress a neck grows with the strain."""
    fields = shapes(np.zeros(301))
    flowing = fields["stretch"] * 0
    flowing[100:201] = 1.0  # a second
    fields |= {"stress_mean": np.full_like(flowing, 3 * LIMIT), "yielded_fraction": flowing}
    assert motion_of(scene_of(*ALL), fields).folds == pytest.approx(3 * LIMIT / VISCOSITY * 1.0, rel=0.02)
    pushed = motion_of(scene_of(*ALL), fields | {"stress_mean": np.full_like(flowing, -3 * LIMIT)})
    assert pushed.folds == 0
    scene = scene_of(*(name for name in ALL if name != "yielding"), material={"law": "maxwell", "yield_stress": None})
    found = motion_of(scene, shapes(np.linspace(0, 0.4, 5)))
    assert found.folds == found.strain > 0.05
    assert math.isinf(found.overstress)


def test_overstress_is_that_of_the_outermost_fibre() -> None:
    for mean, bent in ((0.5, 0.25), (-0.5, 0.25), (0.5, -0.25)):
        fields = shapes(np.zeros(4))
        stress, bending = fields["stress_mean"].copy(), np.zeros_like(fields["stress_mean"])
        stress[2, 7], bending[2, 7] = mean * LIMIT, bent * LIMIT
        found = motion_of(scene_of(*ALL), fields | {"stress_mean": stress, "stress_bending": bending})
        assert found.overstress == pytest.approx(0.75)
    # Below first yield, between clamps, rho g L^2/(2 h0): w L^2/12 over w h0^2/6.
    thickness, strength = 0.1, 1e6
    scene = scene_of("bending", thickness=thickness, E=1e10, run={"frames": 2}, numerics={"cells": 40}).replace(
        {"material.yield_stress": f"{strength!r} Pa"}
    )
    found = motion_of_run(simulate(scene))
    assert found.overstress == pytest.approx(DENSITY * GRAVITY * SPAN**2 / (2 * thickness) / strength, rel=0.03)
    assert found.relaxed == 0


def test_what_relaxes_is_what_flowed_or_without_flow_all_above_the_yield_stress() -> None:
    fields = shapes(np.zeros(4))
    fields["stress_mean"] = np.full_like(fields["stress_mean"], 4 * LIMIT)
    assert motion_of(scene_of("bending"), fields).relaxed == pytest.approx(3 / 4)
    scene, fields = scene_of(*ALL, material={"yield_stress": "1 GPa"}), shapes(np.zeros(4))
    assert motion_of(scene, fields).relaxed == 0
    fields["energy_elastic"] = np.array([0.0, 1.0, 0.5, 0.5])
    fields["energy_dissipated"] = np.array([0.0, 1.0, 2.0, 3.0])
    assert motion_of(scene, fields).relaxed == pytest.approx(3 / 4)


def test_compliance_is_timoshenkos() -> None:
    """The sag by shear alone, q L^2/(8 kappa mu A), of the transverse force of a run without shear."""
    poisson, E = 0.3, 1e9
    corrections = {
        "rectangle": 10 * (1 + poisson) / (12 + 11 * poisson),
        "circle": 6 * (1 + poisson) / (7 + 6 * poisson),
    }
    for end in ("clamped", "pinned"):
        for section, correction in corrections.items():
            scene = scene_of(
                "bending",
                thickness=0.2,
                filament={"section": section},
                material={"poisson": poisson, "yield_stress": "1 GPa"},
                E=E,
                ends={"left": end, "right": end},
                run={"frames": 2},
                numerics={"cells": 40},
            )
            run = simulate(scene)
            added = compliant_sag(scene, run.fields["shear_force"], np.diff(run.fields["X_node"])) * SPAN
            found = motion_of_run(run)
            exact = DENSITY * GRAVITY * SPAN**2 / (8 * correction * E / (2 * (1 + poisson)))
            assert added == pytest.approx(exact, rel=0.03), (end, section)
            assert found.sheared * found.sag * SPAN == pytest.approx(exact, rel=0.07), (end, section)
    # A Kelvin-Voigt solid follows a force that sets in and stays as 1 - exp(-t/lag).
    time, lag = np.linspace(0, 3, 31), 0.7
    force = np.tile([2.0, -1.0], (31, 1))
    np.testing.assert_allclose(lagging(time, force, lag), force * (1 - np.exp(-time / lag))[:, None], atol=1e-14)
    assert lagging(time, force, 0.0) is force


def test_a_run_without_inertia_misses_its_free_fall_and_shows_its_share_within_the_ramp() -> None:
    """A viscous descent H = c t: late by what it falls while it catches up, c^2/g."""
    speed, duration = 0.05, 3.0
    names = [name for name in ALL if name != "inertia"]
    found = motion_of(scene_of(*names), shapes(speed * np.linspace(0, duration, 301)))
    assert 1 < found.missed / (speed / GRAVITY / duration) < 3
    # A coil that draws out along a level axis, at twice a quarter of gravity: its midpoint stays at its height.
    time = np.linspace(0, 0.2, 101)
    still, away = shapes(np.zeros(101)), (GRAVITY / 4 * time**2)[:, None] * (NODES / SPAN + 0.5)
    level = still | {"x": still["x"] + away, "z": np.zeros_like(away)}
    coil = scene_of(*names, load={"ramp": "0.2 s"}, run={"duration": "0.2 s"})
    assert motion_of(coil, level).missed == pytest.approx(0.5, rel=0.05)
    assert motion_of(coil, still).missed == 0
    for reached in (0.25, 0.75):
        depth = np.interp(np.linspace(0, 3, 301), [0, 1.5, 3], [0, reached * 0.1, 0.1])
        assert motion_of(scene_of(*names, load={"ramp": "1.5 s"}), shapes(depth)).risen == pytest.approx(reached)


def path(height: Callable[[Array], Array], duration: float = 2.0, samples: int = 20001) -> Extremes:
    """The extremes of a history that is known everywhere."""
    time = np.linspace(0, duration, samples)
    return Extremes.of(time, height(time)).beyond(0.0)


def swing(frequency: float, amplitude: float = 0.5, decay: float = 0.0) -> Callable[[Array], Array]:
    return lambda time: -1 + amplitude * np.exp(-decay * time) * np.cos(2 * math.pi * frequency * time)


def test_extremes_are_the_turning_points_between_both_ends() -> None:
    found = path(swing(2.0))
    np.testing.assert_allclose(found.time, np.arange(0, 2.01, 0.25), atol=2e-4)
    np.testing.assert_allclose(found.height, -1 + 0.5 * (-1.0) ** np.arange(9), atol=1e-6)
    np.testing.assert_allclose(found.area, -found.time, atol=1e-4)
    # A ripple of a hundredth is none where swings count from two hundredths on, whichever way it all goes meanwhile.
    assert len(path(lambda t: swing(2.0)(t) + 0.01 * np.cos(300 * t)).beyond(0.021).time) == 9
    assert len(path(lambda t: -t + 0.01 * np.cos(300 * t)).beyond(0.021).time) == 2


ACCURACY = 0.01


def strand(*, backend: str = "compiled", run: dict[str, Any] | None = None, **material: Any) -> Scene:
    return Scene.model_validate(
        {
            "filament": {"span": "20 mm", "diameter": "1 mm", "density": "1050 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "450 kPa", "loss_tangent": 0.1, **material},
            "run": {"duration": "3 s", "frames": 41, "accuracy": ACCURACY, "until": "settled", **(run or {})},
            "numerics": {"estimate": False, "cells": 16, "backend": backend},
        }
    )


def creep(move: Callable[[Array], Array], law: str = "standard-linear", duration: float = 8.0) -> Any:
    second = {"second_modulus": "1 MPa"} if law == "standard-linear" else {}
    material = {"law": law, "youngs_modulus": "1 MPa", "viscosity": "1 MPa*s", "loss_tangent": 0.0, **second}
    scene = strand(run={"duration": f"{duration} s", "until": "duration"}, **material)
    time, seen = np.linspace(0, duration, 41), path(move, duration)
    return creep_of(scene, seen, time, move(time))


def test_a_creep_has_a_rate_and_a_solid_a_height_to_which_it_tends() -> None:
    found = creep(lambda t: -1 + np.exp(-t / 5))
    assert found["rate_m_per_s"] == pytest.approx(-math.exp(-8 / 5) / 5, rel=3e-3)
    assert found["tends_to_m"] == pytest.approx(-1, rel=1e-6)
    # What goes on for ever, or may, tends nowhere that could be told.
    for move in (lambda t: -np.log(1 + t), lambda t: -np.cbrt(t), lambda t: -t, lambda t: -(t**2)):
        assert creep(move)["tends_to_m"] is None
    assert creep(lambda t: -1 + np.exp(-t / 5), "maxwell")["tends_to_m"] is None
    assert creep(lambda t: -1 + np.exp(-t)) is None, "it has come to rest by the accuracy asked"
    assert creep(lambda t: -1 - 0.2 * np.cos(9 * t)) is None, "it swings"
    # Beside a ripple the rate is that of the mean.
    slow = creep(lambda t: -0.1 * t + 0.004 * np.cos(60 * t))
    assert slow["rate_m_per_s"] == pytest.approx(-0.1, rel=0.01)
