"""Bundled scenes that are not run every time, and the energy balance of all thirty."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest

import softcat_sym as sc
from tests.common.table import show
from tests.test_bundled_scenes import SLOW_CHECKS, judge

pytestmark = pytest.mark.slow


def test_scenes_show_their_physics() -> None:
    judge(SLOW_CHECKS)


def test_every_scene_as_it_stands_keeps_its_energy_and_is_saved_as_it_was_read(tmp_path: Path) -> None:
    rows, missed = [], []
    for name in sc.bundled_names():
        scene = sc.load_scene(name, {"numerics.estimate": False})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            run = sc.simulate(scene)
        residual, accuracy = run.summary["energy_residual"], run.scene.run.accuracy
        rows.append([name, run.outcome.name, f"{residual:.1e}", f"{accuracy:g}"])
        print(*rows[-1], flush=True)
        run.save(tmp_path / name)
        read = sc.open_run(tmp_path / name).scene, sc.load_scene(tmp_path / name / "scene.toml")
        expected = sc.Outcome.localised if name == "edge-of-rupture" else sc.Outcome.solved
        if run.outcome is not expected or not residual < accuracy or read != (scene, scene):
            missed.append(name)
    show("energy residual of the bundled scenes", ("scene", "outcome", "residual", "accuracy"), rows)
    assert not missed
