"""What is written is what the contract says, and reads back as it was."""

from __future__ import annotations

import errno
import json
import math
import os
import re
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
import pint
import pytest
import xarray as xr

from softcat_sym import load_scene, simulate
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.results import files
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import Outcome

from .runs import run, scene_of

CONTRACT = {
    "x": ("m", "node"),
    "y": ("m", "node"),
    "stretch": ("1", "cell"),
    "curvature": ("1/m", "cell"),
    "shear": ("1", "cell"),
    "tension": ("N", "cell"),
    "moment": ("N*m", "cell"),
    "shear_force": ("N", "cell"),
    "yielded_fraction": ("1", "cell"),
    "plastic_rate": ("1/s", "cell"),
    "midpoint": ("m", ""),
    "energy_kinetic": ("J", ""),
    "energy_elastic": ("J", ""),
    "energy_potential": ("J", ""),
    "energy_dissipated": ("J", ""),
    "work_external": ("J", ""),
}
SUMMARY = {
    "outcome",
    "advice",
    "regime",
    "midpoint_final_m",
    "error_estimate",
    "energy_residual",
    "effects",
    "left_out",
    "cells",
    "solver",
    "backend",
    "wall_s",
}


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("run") / "deep" / "er"
    written = run().save(folder)
    assert sorted(path.name for path in written) == ["scene.toml", "summary.json", "trajectory.nc"]
    return folder


def reread(folder: Path) -> xr.Dataset:
    with xr.open_dataset(folder / "trajectory.nc", engine="h5netcdf") as data:
        return data.load()


def test_nothing_but_the_three_files(saved: Path) -> None:
    assert sorted(path.name for path in saved.iterdir()) == ["scene.toml", "summary.json", "trajectory.nc"]


def test_dimensions_and_coordinates(saved: Path) -> None:
    data = reread(saved)
    assert dict(data.sizes) == {"time": 13, "node": 13, "cell": 12}
    assert set(data.coords) == {"time", "X_node", "X_cell"}
    assert data["time"].dtype == np.float64
    assert data["time"].attrs["units"] == "s"
    np.testing.assert_allclose(data["time"], np.linspace(0, 0.12, 13), rtol=1e-12)
    nodes = data["X_node"].values
    np.testing.assert_allclose(nodes, -nodes[::-1], atol=1e-16)
    np.testing.assert_allclose(nodes[[0, 6, 12]], [-0.1, 0, 0.1], atol=1e-16)
    # shorter towards the clamps
    assert np.all(np.diff(nodes[:7], 2) > 0)
    np.testing.assert_allclose(data["X_cell"], (data["X_node"].values[1:] + data["X_node"].values[:-1]) / 2, atol=1e-16)
    assert data["X_node"].attrs["units"] == data["X_cell"].attrs["units"] == "m"


@pytest.mark.parametrize("name", CONTRACT)
def test_variables_with_their_units(saved: Path, name: str) -> None:
    unit, place = CONTRACT[name]
    variable = reread(saved)[name]
    assert variable.dims == (("time", place) if place else ("time",))
    assert variable.dtype == np.float64
    assert variable.attrs["units"] == unit
    assert variable.attrs["long_name"]
    assert np.all(np.isfinite(variable))


def test_every_unit_is_a_pint_symbol_that_xarray_leaves_alone(saved: Path) -> None:
    registry: Any = pint.UnitRegistry()
    data = reread(saved)
    for name in data.variables:
        registry.parse_units(data[name].attrs["units"])
        assert data[name].dtype == np.float64, name


def test_values_survive_to_the_last_bit(saved: Path) -> None:
    xr.testing.assert_identical(reread(saved), run().data)


def test_attributes(saved: Path) -> None:
    attrs = reread(saved).attrs
    assert attrs["title"] == "A short one"
    assert set(json.loads(attrs["effects"])) == set(choose_effects(run().scene).names)
    assert {"softcat_sym", "casadi", "sympy", "numpy"} <= set(json.loads(attrs["versions"]))
    assert "Soft catenaries" in attrs["references"]


def test_stage_times_are_an_attribute(saved: Path) -> None:
    """Scene, effects with reasons, versions, stage times, references: the attributes of the contract."""
    stages = [value for name, value in reread(saved).attrs.items() if re.search("wall|stage", name)]
    assert len(stages) == 1
    assert {"build", "solve"} <= set(json.loads(stages[0]))


def test_the_scene_in_the_file_is_the_scene_that_ran(saved: Path, tmp_path: Path) -> None:
    copy = tmp_path / "again.toml"
    copy.write_text(reread(saved).attrs["scene"], encoding="utf-8")
    assert load_scene(str(copy)) == run().scene
    assert load_scene(str(saved / "scene.toml")) == run().scene


def test_the_summary(saved: Path) -> None:
    summary = json.loads((saved / "summary.json").read_text(encoding="utf-8"))
    assert set(summary) >= SUMMARY
    assert summary == json.loads(json.dumps(run().summary))
    assert summary["outcome"] == "solved"
    assert summary["advice"] == Outcome.solved.value
    assert summary["midpoint_final_m"] == float(run().data["midpoint"][-1]) < 0
    assert summary["error_estimate"] is None
    assert 0 <= summary["energy_residual"] < 1e-3
    assert summary["cells"] == 6
    assert summary["backend"] in ("compiled", "interpreted")
    assert summary["solver"] in ("cvodes", "idas", "rosenbrock")
    assert set(summary["wall_s"]) == {"build", "compile", "solve", "estimate", "write", "total"}
    stages = [value for name, value in summary["wall_s"].items() if name != "total"]
    assert summary["wall_s"]["total"] == pytest.approx(math.fsum(stages))
    assert summary["effects"] == dict(choose_effects(run().scene).reasons)
    assert set(summary["left_out"]) == {"rotary-inertia"}


def test_cells_of_a_lopsided_run_are_counted_per_half() -> None:
    lopsided = run("bingham", "pinned")
    assert lopsided.summary["cells"] == 6
    assert dict(lopsided.data.sizes) == {"time": 13, "node": 13, "cell": 12}


def test_what_a_list_leaves_out_is_in_the_summary() -> None:
    published = choose_effects(scene_of(run={"effects": "paper"}))
    names = [name for name in published.names if name not in ("thinning", "large-rotation")]
    summary = simulate(scene_of(run={"effects": names})).summary
    assert set(summary["effects"]) == set(names)
    assert set(summary["left_out"]) == {"thinning", "large-rotation", *published.left_out}
    assert all(value > 0 for value in summary["left_out"].values())


def test_saving_again_replaces(tmp_path: Path) -> None:
    (tmp_path / "trajectory.nc").write_text("old")
    run().save(tmp_path)
    run().save(tmp_path)
    assert dict(reread(tmp_path).sizes)["time"] == 13
    assert len(list(tmp_path.iterdir())) == 3


def test_files_can_be_read_by_others(tmp_path: Path) -> None:
    for path in run().save(tmp_path):
        assert path.stat().st_mode & 0o444 == 0o444


def test_a_failure_while_writing_leaves_what_was_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target = tmp_path / "trajectory.nc"
    target.write_text("old")

    def half(self: Path, mode: str) -> NoReturn:
        handle = os.open(self, os.O_CREAT | os.O_WRONLY)
        os.write(handle, b"new, but not all of it")
        os.close(handle)
        raise OSError(errno.ENOSPC, "disk full")

    finished = run()
    with monkeypatch.context() as full:
        full.setattr(Path, "open", half)
        with pytest.raises(OSError, match="disk full"):
            finished.save(tmp_path)
    assert target.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["trajectory.nc"]


def test_a_failure_at_the_last_moment_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(self: Path, target: Path) -> None:
        raise OSError("busy")

    monkeypatch.setattr(Path, "replace", refuse)
    with pytest.raises(OSError, match="busy"):
        files.write_summary({"a": 1}, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_numbers_that_json_has_not_are_no_summary(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="JSON"):
        files.write_summary({"a": float("nan")}, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_directory_that_cannot_be(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(OSError, match="file"):
        run().save(tmp_path / "file" / "out")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_read_only_directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Root may write anywhere: the refusal is the operating system's, acted."""

    def refuse(*arguments: object, **options: object) -> None:
        raise PermissionError("read-only file system")

    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(PermissionError, match="read-only"):
        files.write_summary({"a": 1}, tmp_path)
    assert list(tmp_path.iterdir()) == []


def broken(monkeypatch: pytest.MonkeyPatch) -> Trajectory:
    from softcat_sym.solvers import settings

    monkeypatch.setattr(settings, "_STEPS_PER_FRAME", 2)
    return simulate(scene_of(numerics={"solver": "cvodes"}, run={"effects": "paper"}))


def test_a_failed_run_is_written_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    failed = broken(monkeypatch)
    failed.save(tmp_path)
    summary = json.loads((tmp_path / "summary.json").read_text(encoding="utf-8"))
    assert summary["outcome"] == "step_limit" == failed.outcome.name
    assert summary["advice"] == Outcome.step_limit.value
    assert "stopped after t" in summary["message"]
    assert reread(tmp_path).sizes["time"] == len(failed.data["time"]) < 13
    assert summary["time_final_s"] == float(failed.data["time"][-1])


def test_a_run_that_finds_no_equilibrium_is_written_too(tmp_path: Path) -> None:
    published = choose_effects(scene_of(run={"effects": "paper"}))
    names = [name for name in published.names if name not in ("inertia", "bending")]
    failed = simulate(scene_of(run={"effects": names}))
    assert failed.outcome is Outcome.no_equilibrium
    failed.save(tmp_path)
    assert reread(tmp_path).sizes["time"] == 1


def test_what_was_converted_from_shear_data_is_said() -> None:
    given = {"law": "herschel-bulkley", "youngs_modulus": "1 MPa", "shear_yield_stress": "200 Pa", "index": 0.5}
    table = scene_of(run={"effects": "paper"}).given()
    scene = Scene.model_validate({**table, "material": {**given, "shear_consistency": "100 Pa*s^0.5"}})
    said = " ".join(simulate(scene).summary["converted"])
    assert "sqrt(3)" in said
    assert f"{scene.material.viscosity:.6g}" in said
    assert scene.material.viscosity == pytest.approx(3**0.75 * 100)
