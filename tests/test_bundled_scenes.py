"""The bundled scenes of every law, section, end and start: each runs, and each shows the physics that it stands for."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

import softcat_sym as sc
from softcat_sym.scene.laws import LAWS
from tests.common import curves

Checked = list[tuple[str, float, float, float]]
"""What was looked at, found, expected, and the largest difference in parts of what is expected."""
Check = Callable[[sc.Run], Checked]
TRIED = np.linspace(0.7, 1.3, 601)
"""Frequencies of a string, over the one expected."""
WITHOUT_INERTIA = ["bending", "finite-stretch", "thinning", "large-rotation", "shear"]


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


def bread_dough(done: sc.Run) -> Checked:
    """Index 0.3: a fifth more weight on the same shape makes it flow 1.2^(1/0.3) = 1.84 times as fast."""

    def speed(one: sc.Run) -> float:
        midpoint = one.data.midpoint.values
        return float(midpoint[100] - midpoint[180:].mean())

    heavier = run("bread-dough", "load.gravity=11.77 m/s^2")
    return [("speed with 1.2 g, over that with g", speed(heavier) / speed(done), 1.2 ** (1 / 0.3), 0.3)]


def cold_honey(done: sc.Run) -> Checked:
    """sigma = 3 mu d log(s)/dt in the middle of the thread."""
    data, frame, cell = done.data, 120, 20
    rate = np.gradient(np.log(data.stretch.values[:, cell]), data.time.values)[frame]
    stress = float(data.stress_mean.values[frame, cell])
    return [("mean stress at midspan [Pa]", stress, done.scene.material.viscosity * rate, 2e-3)]


def cooked_spaghetti(done: sc.Run) -> Checked:
    """Peirce's heavy elastica, which does not shear: 1 % is left to that and to the last of the swinging."""
    part, E = done.scene.filament, done.scene.material.youngs_modulus
    area = math.pi * part.thickness**2 / 4
    section = curves.uniform(E * area, E * area * part.thickness**2 / 16)
    weight = part.density * done.scene.load.gravity * area
    X = np.linspace(0, part.span, 41)
    shape = curves.held(section, weight, part.span, part.span, X, ("clamped", 0.0), ("free", 0.0))
    y = at_cells(done, "y")
    return [("tip [m]", float(y[-1]), float(shape.y[-1]), 0.01), ("lowest node", float(y.argmin()), 40, 0)]


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


def gelatin_strand(done: sc.Run) -> Checked:
    """It comes to rest as the elastic beam."""
    table = tomllib.loads(done.scene.to_toml())
    table["material"] = {"law": "elastic", "youngs_modulus": table["material"]["youngs_modulus"]}
    table["run"] |= {"effects": WITHOUT_INERTIA, "frames": 2}
    rest = sc.simulate(sc.Scene.model_validate(table))
    return [("sag at the end [m]", -final(done), -final(rest), 2e-3)]


def hot_glue_string(done: sc.Run) -> Checked:
    """It starts as its profile, 1 to 0.6; all of it carries the same pull, which stretches the thin half more."""
    thickness, stretch = at_cells(done, "thickness", 0), at_cells(done, "stretch")
    thin, thick = np.log(stretch[20:]).mean(), np.log(stretch[:20]).mean()
    return [
        ("thin over thick end", float(thickness[-1] / thickness[0]), 0.605 / 0.995, 2e-2),
        ("thin half strains more", float(thin > 1.1 * thick), 1, 0),
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


def putty_arch(done: sc.Run) -> Checked:
    """It leaves the grips at 15 degrees, stands above the line at first and hangs below it in the end."""
    x, y = at_cells(done, "x", 0), at_cells(done, "y", 0)
    midpoint = done.data.midpoint.values
    # of the parabola through the first three nodes
    first = np.polyfit(x[:3] - x[0], y[:3] - y[0], 2)[1]
    return [
        ("slope at the left grip", float(first), math.tan(math.radians(15)), 0.04),
        ("above, then below", float(midpoint[0] > 1e-3 and midpoint[-1] < -1e-3), 1, 0),
    ]


def rubber_strand(done: sc.Run) -> Checked:
    """The elastic cable of its long-time modulus."""
    part, E = done.scene.filament, done.scene.material.youngs_modulus
    cable = (3 * part.density * done.scene.load.gravity * part.span**4 / (64 * E)) ** (1 / 3)
    return [("sag at the end [m]", -float(done.data.midpoint.values[-20:].mean()), cable, 0.03)]


def slack_taffy(done: sc.Run) -> Checked:
    """It starts as the elastic catenary of its rest length, but for its stiff ends, and grows."""
    length, part = 0.3, done.scene.filament
    stress = part.density * done.scene.load.gravity
    X = np.linspace(0, length, 41)
    stretch = curves.true_strain_stretch(done.scene.material.youngs_modulus / stress)
    chain = curves.hanging_string(stretch, 1.0, length, part.span, X)
    drawn = [float(np.hypot(np.diff(at_cells(done, "x", k)), np.diff(at_cells(done, "y", k))).sum()) for k in (0, -1)]
    exact = float(np.hypot(np.diff(chain.x), np.diff(chain.y)).sum())
    return [
        ("length at the start [m]", drawn[0], exact, 2e-3),
        ("sag at the start [m]", -float(done.data.midpoint.values[0]), -float(chain.y[20]), 0.04),
        ("grows longer", float(drawn[1] > 1.05 * drawn[0]), 1, 0),
    ]


def slime_slope(done: sc.Run) -> Checked:
    """Supports at their heights, the deepest point on the side of the lower one."""
    x, y = at_cells(done, "x"), at_cells(done, "y")
    return [
        ("drop [m]", float(y[0] - y[-1]), 0.030, 1e-9),
        ("deepest right of midspan", float(x[y.argmin()] > x.mean() + 0.1 * 0.080), 1, 0),
    ]


def stretched_rubber_band(done: sc.Run) -> Checked:
    """A string of tension E log(1.25): 2 L/c between two visits to the top."""
    part, E = done.scene.filament, done.scene.material.youngs_modulus
    period = 2 * part.span / math.sqrt(E * math.log(1.25) / part.density)
    time, height = done.data.time.values, done.data.midpoint.values
    spectrum = [abs(np.sum((height - height.mean()) * np.exp(-2j * np.pi * time * k / period))) for k in TRIED]
    return [("frequency over c/(2 L)", float(TRIED[int(np.argmax(spectrum))]), 1, 0.03)]


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
    judge(
        beam_viscometer,
        bread_dough,
        cold_honey,
        cooked_spaghetti,
        curled_rod,
        drawn_blob,
        gelatin_strand,
        hot_glue_string,
        polyethylene_melt,
        putty_arch,
        rubber_strand,
        slack_taffy,
        slime_slope,
        stretched_rubber_band,
    )


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
