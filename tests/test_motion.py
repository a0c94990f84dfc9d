"""The few numbers that describe a motion, ringing and settling, of shapes and histories that are known exactly."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from softcat_sym.effects.selection import choose_effects
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.results.fields import displacements
from softcat_sym.results.motion import (
    creep_of,
    observed_motion,
)
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
