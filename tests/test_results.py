"""A run's fields, its files and the store: what the contract says, whole span, SI units, and back to the last bit."""

from __future__ import annotations

import errno
import json
import os
from pathlib import Path
from typing import NoReturn

import numpy as np
import pint
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym import store
from softcat_sym.effects.selection import choose_effects
from softcat_sym.results.fields import mirrored
from softcat_sym.results.run import open_run, run_form
from softcat_sym.simulate import recalled
from softcat_sym.solvers import settings
from softcat_sym.solvers.outcome import Outcome
from tests.common.runs import run, scene_of

CONTRACT = {
    **dict.fromkeys(("x", "y"), ("m", "node")),
    **dict.fromkeys(("stretch", "shear", "yielded_fraction"), ("1", "cell")),
    **dict.fromkeys(("tension", "shear_force"), ("N", "cell")),
    **{"curvature": ("1/m", "cell"), "moment": ("N*m", "cell"), "plastic_rate": ("1/s", "cell"), "midpoint": ("m", "")},
    **dict.fromkeys(("energy_kinetic", "energy_elastic", "energy_potential", "energy_dissipated"), ("J", "")),
    "work_external": ("J", ""),
}
FILES = ["scene.toml", "summary.json", "trajectory.nc"]


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("run") / "deep" / "er"
    assert sorted(path.name for path in run().save(folder)) == FILES
    return folder


def reread(folder: Path) -> xr.Dataset:
    with xr.open_dataset(folder / "trajectory.nc", engine="h5netcdf") as data:
        return data.load()


def test_dimensions_coordinates_units_and_types_are_the_contract_s(saved: Path) -> None:
    data, registry = reread(saved), pint.UnitRegistry()  # type: ignore[var-annotated]
    assert dict(data.sizes) == {"time": 13, "node": 13, "cell": 12}
    assert set(data.coords) == {"time", "X_node", "X_cell"}
    assert [data[name].attrs["units"] for name in ("time", "X_node", "X_cell")] == ["s", "m", "m"]
    np.testing.assert_allclose(data["time"], np.linspace(0, 0.12, 13), rtol=1e-12)
    nodes = data["X_node"].values
    np.testing.assert_allclose(nodes, -nodes[::-1], atol=1e-16)
    np.testing.assert_allclose(nodes[[0, 6, 12]], [-0.1, 0, 0.1], atol=1e-16)
    assert np.all(np.diff(nodes[:7], 2) > 0), "shorter towards the clamps"
    np.testing.assert_allclose(data["X_cell"], (nodes[1:] + nodes[:-1]) / 2, atol=1e-16)
    for name, (unit, place) in CONTRACT.items():
        assert data[name].dims == (("time", place) if place else ("time",)), name
        assert (data[name].attrs["units"], bool(data[name].attrs["long_name"])) == (unit, True), name
        assert np.all(np.isfinite(data[name])), name
    # Pint symbols, which xarray leaves alone.
    for name in data.variables:
        registry.parse_units(data[name].attrs["units"])
        assert data[name].dtype == np.float64, name


def test_values_attributes_and_scene_survive_to_the_last_bit(saved: Path, tmp_path: Path) -> None:
    assert sorted(path.name for path in saved.iterdir()) == FILES
    data = reread(saved)
    xr.testing.assert_identical(data, run().data)
    assert data.attrs["title"] == "A short one"
    assert set(json.loads(data.attrs["effects"])) == set(choose_effects(run().scene).names)
    assert {"softcat_sym", "casadi", "sympy", "numpy"} <= set(json.loads(data.attrs["versions"]))
    assert "Soft catenaries" in data.attrs["references"]
    assert set(json.loads(data.attrs["wall_s"])) >= {"build", "solve"}
    (tmp_path / "again.toml").write_text(data.attrs["scene"], encoding="utf-8")
    for path in (tmp_path / "again.toml", saved / "scene.toml"):
        assert sc.load_scene(path) == run().scene
    again = open_run(saved)
    assert (again.summary, again.scene, again.outcome) == (run().summary, run().scene, run().outcome)
    xr.testing.assert_identical(again.data, run().data)


def test_saving_replaces_whole_files_that_others_can_read_or_leaves_the_old_ones(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "trajectory.nc").write_text("old")

    def half(self: Path, mode: str) -> NoReturn:
        handle = os.open(self, os.O_CREAT | os.O_WRONLY)
        os.write(handle, b"new, but not all of it")
        os.close(handle)
        raise OSError(errno.ENOSPC, "disk full")

    def busy(self: Path, target: Path) -> NoReturn:
        raise OSError("busy")

    for name, fault, message in (("open", half, "disk full"), ("replace", busy, "busy")):
        with monkeypatch.context() as broken:
            broken.setattr(Path, name, fault)
            with pytest.raises(OSError, match=message):
                run().save(tmp_path)
        assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("trajectory.nc", "old")]
    for _ in range(2):
        assert all(path.stat().st_mode & 0o444 == 0o444 for path in run().save(tmp_path))
    assert (reread(tmp_path).sizes["time"], len(list(tmp_path.iterdir()))) == (13, 3)
    with pytest.raises(OSError, match=r"summary\.json"):
        run().save(tmp_path / "summary.json" / "out")


def test_a_failed_run_is_written_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as few:
        few.setattr(settings, "_STEPS_PER_FRAME", 2)
        failed = sc.simulate(scene_of(numerics={"solver": "cvodes"}, run={"effects": "paper"}))
    failed.save(tmp_path)
    summary = json.loads((tmp_path / "summary.json").read_text(encoding="utf-8"))
    assert summary["outcome"] == "step_limit" == failed.outcome.name
    assert summary["advice"] == Outcome.step_limit.value
    assert "stopped after t" in summary["message"]
    assert reread(tmp_path).sizes["time"] == len(failed.data["time"]) < 13
    assert summary["time_final_s"] == float(failed.data["time"][-1])
    names = [
        name
        for name in choose_effects(scene_of(run={"effects": "paper"})).names
        if name not in ("inertia", "bending")
    ]  # fmt: skip
    nowhere = sc.simulate(scene_of(run={"effects": names}))
    assert nowhere.outcome is Outcome.no_equilibrium
    nowhere.save(tmp_path)
    assert reread(tmp_path).sizes["time"] == 1


HALF = np.array([[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]])
CELLS = ("stretch", "curvature", "shear", "tension", "moment", "shear_force", "yielded_fraction", "plastic_rate",
         "thickness", "stress_mean", "stress_bending")  # fmt: skip


def test_the_half_is_mirrored_about_the_midspan() -> None:
    np.testing.assert_array_equal(mirrored("y", HALF), [[2, 1, 0, 1, 2], [5, 4, 3, 4, 5]])
    np.testing.assert_array_equal(mirrored("x", HALF), [[-2, -1, 0, 1, 2], [-5, -4, 3, 4, 5]])
    np.testing.assert_array_equal(mirrored("stretch", HALF), [[2, 1, 0, 0, 1, 2], [5, 4, 3, 3, 4, 5]])
    np.testing.assert_array_equal(mirrored("shear_force", HALF[:1]), [[-2, -1, 0, 0, 1, 2]])
    for name in ["x", "y", *CELLS]:
        values = run().data[name].values
        np.testing.assert_array_equal(values[:, ::-1], (-1 if name in ("x", "shear", "shear_force") else 1) * values)
    # Gravity still pulls down on the left half, and the transverse force changes sign.
    lopsided = run("bingham", "pinned").data
    assert np.all(np.diff(lopsided["x"].values, axis=1) > 0)
    assert lopsided["shear_force"].values[-1, 0] * lopsided["shear_force"].values[-1, -1] < 0


def test_stretch_thickness_stress_and_energy_belong_together() -> None:
    paper, data = sc.simulate(scene_of(run={"effects": "paper"})).data, run().data
    lengths = np.hypot(np.diff(paper["x"], axis=1), np.diff(paper["y"], axis=1)) / np.diff(paper["X_node"])
    np.testing.assert_allclose(paper["stretch"], lengths, rtol=1e-12)
    np.testing.assert_allclose(paper["thickness"], 0.006 / np.sqrt(lengths), rtol=1e-12)
    np.testing.assert_array_equal(paper["shear"], 0.0)
    # A sheared section thins with the stretch along its normal.
    assert float(np.max(np.abs(data["shear"]))) > 1e-4
    normal = data["stretch"].values / np.hypot(1, data["shear"].values)
    np.testing.assert_allclose(data["thickness"], 0.006 / np.sqrt(normal), rtol=1e-12)
    area = data["thickness"].values ** 2
    np.testing.assert_allclose(data["tension"], area * data["stress_mean"], rtol=1e-12, atol=1e-12)
    second = area * data["thickness"].values / 6
    np.testing.assert_allclose(data["moment"], second * data["stress_bending"], rtol=1e-12, atol=1e-12)
    half = 1900 * 0.006**2 * np.diff(data["X_node"].values) / 2
    weights = np.append(half, 0) + np.append(0, half)
    work = 9.81 * float(np.sum(weights * data["y"].values[-1]))
    assert float(data["energy_potential"][-1]) == pytest.approx(work, rel=1e-12)


def test_a_run_is_recalled_to_the_last_bit_under_any_title(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = sc.load_scene("cold-honey", ["numerics.cells=4", "run.frames=4", "run.duration=0.02 s"])
    first = recalled(scene)
    monkeypatch.setattr("softcat_sym.error_control.consistency.run_until_consistent", None)
    again = recalled(scene.replace({"title": "another"}))
    assert again.summary == first.summary | {"title": "another"}
    assert (again.data.attrs["title"], again.scene.title) == ("another", "another")
    assert again.data.identical(first.data.assign_attrs(again.data.attrs))
    assert run_form(scene).write(first) == run_form(scene).write(recalled(scene))
    with store.fresh(), pytest.raises(TypeError):
        recalled(scene)
