"""The elements on their own: beam theory, energies, steps, meshes, and what they cost."""

from __future__ import annotations

import math
import os
import time
from itertools import pairwise

import numpy as np
import pytest

from softcat_sym.reference.element_loop import Mesh
from softcat_sym.reference.elements import ElementRun, run_elements
from softcat_sym.scene.scene import Scene, elastic_time
from tests.common.elements import INSTANTS, curve, digits, elements, mean, midpoints, name_of, plane
from tests.common.strips import timoshenko_frequency, timoshenko_sag
from tests.common.table import show
from tests.test_elements import harmonic

MESHES = (Mesh(32, 2), Mesh(64, 4), Mesh(96, 6))
SCENES = ("no-yield", "arrested-overdamped", "arrested-underdamped", "continual-descent")

REISSNER = 5 / 6
_PERIODS = 3


def cowper(poisson: float) -> float:
    return 10 * (1 + poisson) / (12 + 11 * poisson)


def under_a_small_load() -> Scene:
    """A hundredth of the gravity, at once: the sag is 0.4 % of the thickness, so that no tension arises."""
    changes: dict[str, object] = {"load.gravity": "0.0981 m/s^2", "load.ramp": "0 s", "run.frames": 601}
    scene = plane("no-yield", changes)
    period = 2 * math.pi / timoshenko_frequency(0.03, REISSNER, scene.material.poisson)
    return scene.replace({"run.duration": f"{float(_PERIODS * period * elastic_time(scene))!r} s"})


@pytest.mark.slow
def test_sag_and_first_period_are_those_of_timoshenkos_beam() -> None:
    scene = under_a_small_load()
    delta, nu = scene.filament.thickness / scene.filament.span, scene.material.poisson
    assert scene.material.youngs_modulus is not None
    load = scene.filament.density * scene.load.gravity * scene.filament.span / scene.material.youngs_modulus
    rows, errors = [], []
    for mesh in (MESHES[0], MESHES[1], Mesh(64, 4, grading=3.0)):
        swing, frequency = harmonic(*curve(scene, elements(scene, mesh)), timoshenko_frequency(delta, REISSNER, nu))
        found = []
        for kappa in (REISSNER, cowper(nu)):
            found.append(-swing / timoshenko_sag(delta, load, kappa, nu) - 1)
            found.append(timoshenko_frequency(delta, kappa, nu) / frequency - 1)
        rows.append([name_of(mesh), *(f"{100 * error:+.3f} %" for error in found)])
        errors += found[:2]
    header = ["mesh", "sag, kappa = 5/6", "period, kappa = 5/6", "sag, Cowper's kappa", "period, Cowper's kappa"]
    show("Clamped strip, delta = 0.03, nu = 0.45: elements over Timoshenko", header, rows)
    # What is left is the clamp, which beams take for rigid across; 32 x 2 equal elements do not resolve it.
    assert max(np.abs(errors[2:])) < 5e-3
    assert max(np.abs(errors)) < 6e-3


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_half_the_step_changes_nothing(name: str) -> None:
    scene = plane(name)
    whole, half = (elements(scene, MESHES[0], step_factor=factor) for factor in (1.0, 0.5))
    change = np.max(np.abs(curve(scene, whole)[1] - curve(scene, half)[1]))
    rows = [["energy error over work", f"{whole.energy_error:.1e}", f"{half.energy_error:.1e}"]]
    rows += [["steps", str(whole.steps), str(half.steps)], ["largest change of midpoint/L", "", f"{change:.1e}"]]
    show(f"{name}, {name_of(MESHES[0])}, t~ = 0 to 460", ["", "step", "half the step"], rows)
    assert half.energy_error < whole.energy_error < 1e-4
    assert change < 1e-5


def row(scene: Scene, run: ElementRun) -> list[str]:
    return [
        name_of(run.mesh),
        *digits(midpoints(scene, run)),
        f"{mean(scene, run):.5f}",
        f"{run.clamp_strain_largest[-1]:.3f}",
        f"{run.energy_error:.0e}",
    ]


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_meshes_converge(name: str) -> None:
    scene = plane(name)
    runs = [elements(scene, mesh) for mesh in MESHES]
    header = ["mesh", *(f"t~ = {t:g}" for t in INSTANTS), "mean", "clamp strain", "energy error"]
    show(f"{name}: midpoint/L of the elements", header, [row(scene, run) for run in runs])
    # Of what rings, points tell the phase; means tell the sag.
    first, second = (abs(mean(scene, fine) / mean(scene, coarse) - 1) for coarse, fine in pairwise(runs))
    print(f"difference of the means: {first:.2%}, then {second:.2%}")
    assert max(run.energy_error for run in runs) < 1e-4
    # At first order, that of the corner of a clamp, the ratio is 3.
    assert second < first / 2


@pytest.mark.slow
def test_a_scene_takes_less_than_90_seconds_on_one_core() -> None:
    """The dearest one, without the cache; seconds of the processor, so that neighbours on the machine count little."""
    scene, mesh = plane("continual-descent"), Mesh(64, 4)
    began, wall = time.process_time(), time.perf_counter()
    run = run_elements(scene, mesh)
    seconds, wall = time.process_time() - began, time.perf_counter() - wall
    nanoseconds = 1e9 * seconds / run.steps / (mesh.along * mesh.through)
    show(
        "continual-descent to t~ = 460 on one core",
        ["mesh", "dofs", "steps", "processor s", "wall s", "ns a step and element", "load of the machine"],
        [
            [
                name_of(mesh),
                run.dofs,
                run.steps,
                f"{seconds:.1f}",
                f"{wall:.1f}",
                f"{nanoseconds:.0f}",
                f"{os.getloadavg()[0]:.1f} on {os.cpu_count()} cores",
            ]
        ],
    )
    assert seconds < 90
