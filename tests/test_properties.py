"""Whole scenes drawn at random: every answer is right as far as invariants can tell, or an honest refusal.

The ranges stand in ``common/random_scenes.py`` and were fixed, like the seed, before any scene was run.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.scene import Scene
from tests.common.random_scenes import SEED, random_scenes
from tests.common.scene_runs import is_balanced, messages
from tests.common.table import show
from tests.common.time_limit import within

LIMIT = 60.0
"""Seconds of the processor for one scene."""
UNANSWERED = 0.05
"""Share of scenes that may be refused or end without success."""


def check(scenes: list[Scene], folder: Path) -> None:
    """Run scenes, each read as it was written; print what was not answered and why; assert what was promised."""
    silent = []
    for scene in scenes:
        (folder / "scene.toml").write_text(scene.to_toml(), encoding="utf-8")
        assert sc.load_scene(folder / "scene.toml") == scene
        try:
            with within(LIMIT):
                run = sc.simulate(scene)
        except SoftcatError as refusal:
            silent.append([scene.material.law, "refused", str(refusal)])
            continue
        if run.outcome.is_success:
            assert not messages(run), scene.to_toml()
        else:
            silent.append([scene.material.law, run.outcome.name, run.summary["message"]])
    show(f"without an answer, of {len(scenes)}", ("law", "outcome", "why"), silent)
    assert len(silent) <= max(1, UNANSWERED * len(scenes))


def test_a_few_scenes_keep_every_property(tmp_path: Path) -> None:
    coarse = {"numerics.cells": 8, "numerics.estimate": False, "run.frames": 21, "run.accuracy": 1e-2}
    check([scene.replace(coarse) for scene in random_scenes(4, SEED + 2)], tmp_path)


@pytest.mark.slow
def test_many_scenes_keep_every_property(tmp_path: Path) -> None:
    check(random_scenes(16, SEED + 3), tmp_path)


TABLE: dict[str, Any] = {
    "filament": {"span": "0.2 m", "thickness": "8 mm", "density": "1900 kg/m^3"},
    "material": {"law": "maxwell", "youngs_modulus": "2 MPa", "viscosity": "0.2 MPa*s"},
    "ends": {"motion": [["0 s", "0 m", "0 m"]]},
    "run": {"duration": "0.3 s", "frames": 4, "accuracy": 0.01},
    "numerics": {"cells": 8, "backend": "interpreted", "estimate": False},
}


def spoiled(data: xr.Dataset) -> Iterator[tuple[str, xr.Dataset]]:
    """What is to be said of the data, each with one thing in it broken."""
    for message, name, place, change in (
        ("moment is not finite", "moment", (2, 3), lambda _: np.nan),
        ("a stretch of 0", "stretch", (1, 0), lambda _: 0.0),
        ("the left support is off", "y", (3, 0), lambda y: y + 1e-6),
        ("the right support is off", "x", (2, -1), lambda x: x - 1e-6),
        ("an energy residual of", "energy_elastic", 2, lambda e: e + 0.02 * float(abs(data.energy_potential).max())),
        ("dissipation falls", "energy_dissipated", 3, lambda _: data.energy_dissipated.values[2] * (1 - 1e-3)),
        ("left and right differ", "y", (3, 4), lambda y: 1.05 * y),
    ):
        broken = data.copy(deep=True)
        broken[name][place] = change(float(broken[name][place]))
        yield message, broken
    yield "frames at", data.assign_coords(time=data.time * 1.01)


def test_what_is_broken_is_noticed() -> None:
    run = sc.simulate(Scene.model_validate(TABLE))
    assert run.outcome.is_success
    assert messages(run) == []
    for message, data in spoiled(run.data):
        fields = {str(name): variable.values for name, variable in data.variables.items()}
        assert any(message in text for text in messages(replace(run, fields=fields))), message


@pytest.mark.parametrize("thinning", [True, False])
def test_energy_is_audited_where_forces_and_store_belong_together(thinning: bool) -> None:
    """A cantilever whose section swells misses the same energy at any tolerance; one that thins misses none."""
    effects = ["inertia", "bending", "extensibility", "finite-stretch", "large-rotation", "viscous-stress"]
    table = TABLE | {
        "filament": {"span": "0.2 m", "thickness": "8 mm", "density": "1900 kg/m^3"},
        "material": {"law": "kelvin-voigt", "youngs_modulus": "0.2 MPa", "viscosity": "400 Pa*s"},
        "ends": {"left": "clamped", "right": "free"},
        "run": TABLE["run"]
        | {"effects": [*effects, *(["thinning"] if thinning else [])], "duration": "1 s", "accuracy": 1e-3},
    }
    residuals = []
    for rtol in (1e-6, 1e-8):
        changed = table | {"numerics": TABLE["numerics"] | {"rtol": rtol, "backend": "compiled"}}
        found = sc.simulate(Scene.model_validate(changed))
        residuals.append(found.summary["energy_residual"])
        assert is_balanced(found.scene, found) is thinning
        warned = any(warning.startswith("the energy residual") for warning in found.summary["warnings"])
        assert warned is not thinning
    if thinning:
        assert residuals[1] < 1e-9
    else:
        assert residuals[1] == pytest.approx(residuals[0], rel=0.1)
        assert residuals[1] > 1e-3
