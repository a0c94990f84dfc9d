"""The looking itself: what is broken is seen, whether in an answer, by an exception, by a hang or by a dead process."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.scene import Scene
from tests.limited_process import LimitedProcess

from . import scene_runs
from .invariants import is_balanced, messages
from .limited import answer_within, serve

TABLE: dict[str, Any] = {
    "filament": {"span": "0.2 m", "thickness": "8 mm", "density": "1900 kg/m^3"},
    "material": {"law": "maxwell", "youngs_modulus": "2 MPa", "viscosity": "0.2 MPa*s"},
    "ends": {"motion": [["0 s", "0 m", "0 m"]]},
    "run": {"duration": "0.3 s", "frames": 4, "accuracy": 0.01},
    "numerics": {"cells": 8, "backend": "interpreted", "estimate": False},
}


@pytest.fixture(scope="module")
def run() -> Trajectory:
    return sc.simulate(Scene.model_validate(TABLE))


def test_a_good_run_has_no_complaints(run: Trajectory) -> None:
    assert run.outcome.is_success
    assert messages(run) == []


def infinite(data: xr.Dataset) -> None:
    data["moment"][2, 3] = np.nan


def late(data: xr.Dataset) -> None:
    data["time"] = data["time"] * 1.01


def collapsed(data: xr.Dataset) -> None:
    data["stretch"][1, 0] = 0.0


def off_the_left(data: xr.Dataset) -> None:
    data["y"][3, 0] += 1e-6


def off_the_right(data: xr.Dataset) -> None:
    data["x"][2, -1] -= 1e-6


def created(data: xr.Dataset) -> None:
    data["energy_elastic"][2] += 0.02 * float(abs(data["energy_potential"]).max())


def undissipated(data: xr.Dataset) -> None:
    data["energy_dissipated"][3] = data["energy_dissipated"][2] * (1 - 1e-3)


def leaning(data: xr.Dataset) -> None:
    data["y"][3, 4] *= 1.05


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (infinite, "moment is not finite"),
        (late, "frames at"),
        (collapsed, "a stretch of 0"),
        (off_the_left, "the left support is off"),
        (off_the_right, "the right support is off"),
        (created, "an energy residual of"),
        (undissipated, "dissipation falls"),
        (leaning, "left and right differ"),
    ],
)
def test_what_is_broken_is_seen(run: Trajectory, spoil: Callable[[xr.Dataset], None], says: str) -> None:
    data = run.data.copy(deep=True)
    spoil(data)
    fields = {str(name): variable.values for name, variable in data.variables.items()}
    assert any(says in text for text in messages(dataclasses.replace(run, fields=fields)))


def test_a_foreign_exception_and_an_untrue_file_are_seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(scene: Scene) -> Trajectory:
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(scene_runs.sc, "simulate", fails)
    assert scene_runs.answer(TABLE, str(tmp_path)).broken == ("ZeroDivisionError: by zero",)
    other = Scene.model_validate({**TABLE, "title": "other"})
    monkeypatch.setattr(scene_runs.sc, "load_scene", lambda path: other)
    assert scene_runs._there_and_back(Scene.model_validate(TABLE), str(tmp_path))


def test_a_refusal_is_no_fault(tmp_path: Path) -> None:
    table = {**TABLE, "run": {"duration": "1 s", "effects": ["yielding"]}}
    found = scene_runs.answer(table, str(tmp_path))
    assert (found.outcome, found.broken) == (scene_runs.REFUSED, ())
    assert "run.effects" in found.reason


@pytest.mark.slow
def test_a_hang_and_a_death_are_seen_and_the_next_scene_is_answered() -> None:
    one = LimitedProcess(serve)
    try:
        assert answer_within(one.ask, TABLE, 0.01).broken == ("no answer within 0.01 s",)
        one._process.kill()
        one._process.join()
        assert answer_within(one.ask, TABLE, 60.0).broken == ("the process died with -9",)
        found = answer_within(one.ask, TABLE, 60.0)
        assert (found.outcome, found.broken) == ("solved", ())
    finally:
        one.close()


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
        changed = table | {"numerics": TABLE["numerics"] | {"rtol": rtol}}
        found = sc.simulate(Scene.model_validate(changed))
        residuals.append(found.summary["energy_residual"])
        assert is_balanced(found.scene, found) is thinning
        warned = any(warning.startswith("the energy residual") for warning in found.summary["warnings"])
        assert warned is not thinning
    if thinning:
        assert residuals[1] < 1e-6
    else:
        assert residuals[1] == pytest.approx(residuals[0], rel=0.1)
        assert residuals[1] > 1e-3
