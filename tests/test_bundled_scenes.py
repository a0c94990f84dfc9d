"""Bundled scenes show the physics that they stand for: some of them, the others in `slow/test_bundled_scenes.py`."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

import softcat_sym as sc
from softcat_sym.scene.laws import LAWS

Checked = list[tuple[str, float, float, float]]
"""What was looked at, found, expected, and the largest difference in parts of what is expected."""
Check = Callable[[sc.Run], Checked]


@cache
def run(name: str, *changes: str) -> sc.Run:
    """A bundled scene run once on twenty cells, without an estimate; the same run is not made twice."""
    done = sc.simulate(sc.load_scene(name, ["numerics.cells=20", "numerics.estimate=false", *changes]))
    assert done.outcome is sc.Outcome.solved, done.summary["message"]
    return done


def final(done: sc.Run) -> float:
    return float(done.data.midpoint.values[-1])


def at_cells(done: sc.Run, name: str, frame: int = -1) -> np.ndarray[Any, Any]:
    return np.asarray(done.data[name].values[frame])


def beam_viscometer(done: sc.Run) -> Checked:
    """ASTM C598, and what shear adds to three-point bending: 12 E I/(kappa G A L^2) with E = 3 G."""
    part, g = done.scene.filament, done.scene.load.gravity
    second_moment, mu = part.thickness**4 / 12, done.scene.material.viscosity / 3
    mass = done.scene.load.point_mass + part.density * part.thickness**2 * part.span / 1.6
    per_minute = g * part.span**3 / (2.4 * second_moment * mu) * mass
    shear = 1 + 3.6 * (part.thickness / part.span) ** 2
    return [("sag after an hour [m]", -final(done), 60 * per_minute * shear, 5e-3)]


def cold_honey(done: sc.Run) -> Checked:
    """sigma = 3 mu d log(s)/dt in the middle of the thread."""
    data, frame, cell = done.data, 120, 20
    rate = np.gradient(np.log(data.stretch.values[:, cell]), data.time.values)[frame]
    stress = float(data.stress_mean.values[frame, cell])
    return [("mean stress at midspan [Pa]", stress, done.scene.material.viscosity * rate, 2e-3)]


def curled_rod(done: sc.Run) -> Checked:
    """It starts as the arc of its own curvature."""
    part = done.scene.filament
    rise = (1 - math.cos(part.curvature * part.span)) / part.curvature
    return [("tip at the start [m]", float(at_cells(done, "y", 0)[-1]), rise, 1e-3)]


def drawn_blob(done: sc.Run) -> Checked:
    """The right end comes to its place; while it goes, T = eta A0 v/(s^2 L)."""
    part, frame = done.scene.filament, 50
    speed = 0.040 / 0.5
    stretch = 1 + speed * float(done.data.time.values[frame]) / part.span
    area = math.pi * part.thickness**2 / 4
    tension = done.scene.material.viscosity * area * speed / (stretch**2 * part.span)
    x = at_cells(done, "x")
    return [
        ("distance of the ends [m]", float(x[-1] - x[0]), 0.050, 1e-9),
        ("tension on the way [N]", float(at_cells(done, "tension", frame).mean()), tension, 0.02),
    ]


def polyethylene_melt(done: sc.Run) -> Checked:
    """Boltzmann's integral over the strain of the middle, exact for a strain that is linear between frames."""
    data, cell = done.data, 20
    steps, strain = np.diff(data.time.values), np.diff(np.log(data.stretch.values[:, cell]))
    total = 0.0
    for mode in done.scene.material.modes:
        stress, tau = 0.0, mode.viscosity / mode.youngs_modulus
        for step, gain in zip(steps, strain, strict=True):
            kept = math.exp(-step / tau)
            stress = stress * kept + mode.viscosity * gain / step * (1 - kept)
        total += stress
    return [("mean stress at midspan [Pa]", float(data.stress_mean.values[-1, cell]), total, 2e-3)]


def judge(*checks: Check) -> None:
    """What each scene stands for; and that it keeps its energy."""
    missed = []
    for check in checks:
        name = check.__name__.replace("_", "-")
        done = run(name)
        residual = ("energy residual", done.summary["energy_residual"], 0.0, done.scene.run.accuracy)
        for what, found, expected, tolerance in (*check(done), residual):
            if abs(found - expected) > tolerance * (abs(expected) if what != "energy residual" else 1):
                missed.append((name, what, found, expected, tolerance))
    assert not missed


def test_scenes_show_their_physics_and_keep_their_energy() -> None:
    judge(beam_viscometer, cold_honey, curled_rod)


def test_every_law_section_end_and_start_has_a_scene() -> None:
    scenes = [sc.load_scene(name) for name in sc.bundled_names()]
    assert len({scene.title for scene in scenes}) == len(scenes)
    # Of the laws of polymer chains one stands for all, and the custom law for all that are formulas.
    alike = {one.name for one in LAWS.values() if one.has_formula and not one.lists}
    assert {scene.material.law for scene in scenes} >= set(LAWS) - alike - {"fene-p", "giesekus", "ptt"}
    assert {scene.filament.section for scene in scenes} == {"rectangle", "circle", "sheet"}
    assert {scene.ends.right for scene in scenes} == {"clamped", "pinned", "free"}
    for table, keys in {
        "ends": ("drop", "left_angle", "motion"),
        "filament": ("rest_length", "profile", "curvature"),
        "initial": ("P", "C"),
        "load": ("point_mass",),
    }.items():
        for key in keys:
            assert any(getattr(getattr(scene, table), key) for scene in scenes), key
    assert any(scene.initial.stretch != 1 for scene in scenes)
