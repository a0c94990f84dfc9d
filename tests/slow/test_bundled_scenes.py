"""Bundled scenes that are not run every time, and the energy balance of all."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.table import show
from tests.test_bundled_scenes import Checked, at_cells, final, judge, run

pytestmark = pytest.mark.slow


def hardly_bent(done: sc.Run) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    """Mean stress and plastic rate, at the end, of the cells that hardly bend."""
    mean, bending, rate = (at_cells(done, name) for name in ("stress_mean", "stress_bending", "plastic_rate"))
    straight = np.abs(bending) < 0.1 * mean
    return mean[straight], rate[straight]


def drying_ink(done: sc.Run) -> Checked:
    """Tension -E P at the start; without the initial state nothing yields."""
    part, material = done.scene.filament, done.scene.material
    pull = 0.003 * material.youngs_modulus * math.pi * part.thickness**2 / 4
    idle = run("drying-ink", "initial.P=[0.0]", "initial.C=[0.0]")
    return [
        ("tension at the start [N]", float(at_cells(done, "tension", 0).mean()), pull, 1e-6),
        ("has yielded", float(done.data.yielded_fraction.values.max() > 0.1), 1, 0),
        ("yields without P and C", float(idle.data.yielded_fraction.values.max()), 0, 0),
    ]


def oobleck(done: sc.Run) -> Checked:
    """Where it hardly bends, stress is K rate^1.5; it sags less than the fluid of index one."""
    mean, rate = hardly_bent(done)
    of_rate = (mean / done.scene.material.viscosity) ** (1 / 1.5)
    newtonian = run("oobleck", "material.index=1", "material.shear_consistency=60 Pa*s")
    return [
        ("rate over (stress/K)^(2/3)", float((rate / of_rate).mean()), 1, 0.05),
        ("sags less than with n = 1", float(final(done) > 0.8 * final(newtonian)), 1, 0),
    ]


def thermoforming_sheet(done: sc.Run) -> Checked:
    """It keeps its width: 4/3 more viscous than the strip, so (3/4)^(1/3) of its sag."""
    strip = run("thermoforming-sheet", "filament.section=rectangle")
    late = [one.data.midpoint.values[-60:].mean() for one in (done, strip)]
    return [("sag over that of a strip", float(late[0] / late[1]), 0.75 ** (1 / 3), 0.015)]


def toothpaste(done: sc.Run) -> Checked:
    """Yields, then stops; a paste of ten times the strength does not yield."""
    midpoint = done.data.midpoint.values
    strong = run("toothpaste", "material.shear_yield_stress=2 kPa")
    return [
        ("last quarter's sag over the one before", float(midpoint[-50:].mean() / midpoint[-100:-50].mean()), 1, 0.02),
        ("has yielded", float(done.data.yielded_fraction.values.max() > 0.02), 1, 0),
        ("a strong paste yields", float(strong.data.yielded_fraction.values.max()), 0, 0),
    ]


def transient_gel(done: sc.Run) -> Checked:
    """Where it hardly bends the rate is sinh(sigma/s0)/t0; the fluid of its viscosity at rest, s0 t0, flows less."""
    mean, rate = hardly_bent(done)
    eyring = np.sinh(mean / 500) / 60
    linear = run("transient-gel", "material.flow=sigma/s0/t0")
    return [
        ("rate over Eyring's", float((rate / eyring).mean()), 1, 0.1),
        ("flows more than linearly", float(final(done) < 1.1 * final(linear)), 1, 0),
    ]


def test_scenes_show_their_physics() -> None:
    judge(drying_ink, oobleck, thermoforming_sheet, toothpaste, transient_gel)


def test_every_scene_as_it_stands_keeps_its_energy_and_is_saved_as_it_was_read(tmp_path: Path) -> None:
    rows, missed = [], []
    for name in sc.bundled_names():
        scene = sc.load_scene(name, {"numerics.estimate": False})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            done = sc.simulate(scene)
        residual, accuracy = done.summary["energy_residual"], scene.run.accuracy
        rows.append([name, done.outcome.name, f"{residual:.1e}", f"{accuracy:g}"])
        print(*rows[-1], flush=True)
        done.save(tmp_path / name)
        read = sc.open_run(tmp_path / name).scene, sc.load_scene(tmp_path / name / "scene.toml")
        expected = sc.Outcome.localised if name == "edge-of-rupture" else sc.Outcome.solved
        if done.outcome is not expected or not residual < accuracy or read != (scene, scene):
            missed.append(name)
    show("energy residual of the bundled scenes", ("scene", "outcome", "residual", "accuracy"), rows)
    assert not missed
