"""A sweep's rows are single runs; what fails is a row; what was finished is never run again."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym import store
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.solvers.compiled import CModel
from softcat_sym.studies import sweep as work
from softcat_sym.studies.phase import SETTINGS, phase_diagram
from softcat_sym.studies.sweep import time_to_share

QUICK = {"run.effects": "paper", "numerics.cells": 6, "run.frames": 21, "numerics.estimate": False}
SCENE = sc.load_scene("arrested-overdamped", QUICK)


class Listener:
    """Notes what it is told; after so many members it stops the sweep."""

    def __init__(self, stop: int = 10**9) -> None:
        self.told: list[tuple[int, int, float]] = []
        self._stop = stop

    def update(self, done: int, members: int, left: float) -> None:
        self.told.append((done, members, left))
        if done >= self._stop:
            raise KeyboardInterrupt


def stored(directory: Path) -> xr.Dataset:
    """What is in the store, but for the time that it took."""
    return xr.load_dataset(directory / "sweep.nc", engine="h5netcdf").drop_vars("wall_s")


def test_rows_are_those_of_simulate(tmp_path: Path) -> None:
    vary = {"groups.G": [0.02, 0.4, 1.9], "material.viscosity": ["9 kPa*s", 14e3]}
    done = sc.sweep(SCENE, vary, tmp_path, shapes=True)
    data = done.data
    assert (len(done), data.sizes["member"], done.path) == (6, 6, tmp_path / "sweep.nc")
    assert data["groups.G"].values.tolist() == [0.02, 0.02, 0.4, 0.4, 1.9, 1.9]
    assert data["material.viscosity"].values.tolist() == [9e3, 14e3] * 3
    assert data["material.viscosity"].attrs == {"varied": 1, "scale": "lin", "units": "Pa*s"}
    stress = SCENE.filament.density * SCENE.load.gravity * SCENE.filament.span
    for member in range(6):
        row = data.isel(member=member)
        single = sc.simulate(
            SCENE.replace(
                {
                    "material.yield_stress": f"{stress / float(row['groups.G'])!r} Pa",
                    "material.viscosity": f"{float(row['material.viscosity'])!r} Pa*s",
                }
            )
        )
        np.testing.assert_allclose(row.midpoint.values, single.data.midpoint.values, rtol=1e-12, atol=1e-15)
        assert (str(row.outcome.values), str(row.regime.values)) == ("solved", single.summary["regime"])
        assert float(row.midpoint_final) == pytest.approx(single.summary["midpoint_final_m"], rel=1e-12)
        assert float(row.sag_over_span) == pytest.approx(-single.data.midpoint.values.min() / 0.2, rel=1e-12)
        assert float(row.largest_stretch) == pytest.approx(single.data.stretch.values.max(), rel=1e-12)
        assert float(row.energy_residual) == pytest.approx(single.summary["energy_residual"], rel=1e-9)
        nodes = np.linspace(-0.1, 0.1, 41)
        for name, at in (("x", single.data.X_node), ("y", single.data.X_node), ("stretch", single.data.X_cell)):
            last = np.interp(nodes, at.values, single.data[name].values[-1])
            np.testing.assert_allclose(row[name].values[-1], last, rtol=1e-6, atol=1e-7)
            middle = np.interp(nodes, at.values, single.data[name].values[10])
            np.testing.assert_allclose(row[name].values[10], middle, rtol=1e-6, atol=1e-7)


def test_time_to_a_share_of_an_exponential() -> None:
    """1 - exp(-t) reaches nine tenths at ln 10; between frames by a straight line."""
    time = np.linspace(0, 20, 20001)
    assert time_to_share(time, -np.expm1(-time)) == pytest.approx(math.log(10), rel=1e-5)
    assert time_to_share(np.array([0.0, 1.0]), np.array([0.0, 5.0])) == pytest.approx(0.9)
    assert math.isnan(time_to_share(time, np.zeros_like(time)))


def test_each_member_by_simulate_if_estimates_are_asked_for(tmp_path: Path) -> None:
    scene = sc.load_scene("cold-honey", {"numerics.cells": 6, "run.frames": 6, "run.duration": "0.1 s"})
    scene = scene.replace({"run.accuracy": 0.1})
    done = sc.sweep(scene, {"filament.density": [1400.0, -1.0]}, tmp_path, estimate=True)
    single = sc.simulate(scene.replace({"filament.density": "1400 kg/m^3"}))
    assert single.summary["error_estimate"] is not None
    np.testing.assert_array_equal(done.data.midpoint.values[0], single.data.midpoint.values)
    assert done.data.outcome.values.tolist() == [single.outcome.name, "refused"]


def test_a_member_that_a_single_run_would_repeat_is_repeated() -> None:
    asked = {"run.accuracy": 0.1, "run.frames": 21, "numerics.estimate": False}
    band = sc.load_scene("stretched-rubber-band", asked)
    found = sc.sweep(band, {"load.gravity": [5.0, 9.81]}).data
    for gravity, midpoint in zip(found["load.gravity"].values, found["midpoint_final"].values, strict=True):
        single = sc.simulate(band.replace({"load.gravity": f"{gravity} m/s^2"}))
        assert "shear" in single.summary["repeats"][0]
        assert midpoint == pytest.approx(single.summary["midpoint_final_m"], rel=1e-9)


def test_failures_are_rows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(run: Callable[..., object]) -> Callable[..., object]:
        def judged(member: work.Member, *others: object) -> object:
            if member.scene.material.yield_stress == 5e3:
                raise RuntimeError("a pipe\nhas burst")
            return run(member, *others)

        return judged

    monkeypatch.setattr(work, "judged", failing(work.judged))
    vary = {"material.yield_stress": [4e3, -1.0, 5e3], "run.duration": [0.5, 0.5, 0.5]}
    done = sc.sweep(SCENE, vary, tmp_path, mode="zip")
    assert done.data.outcome.values.tolist() == ["solved", "refused", "failed"]
    assert done.data.message.values.tolist()[2] == "a pipe has burst"
    assert "material.yield_stress: '-1.0 Pa' is negative" in str(done.data.message.values[1])
    assert np.isnan(done.data.midpoint.values).all(axis=1).tolist() == [False, True, True]
    assert dict(done.counts.outcomes) == {"solved": 1, "refused": 1, "failed": 1}


def test_a_run_that_is_no_answer_has_no_numbers(tmp_path: Path) -> None:
    scene = sc.load_scene("continual-descent", QUICK)
    vary = {"groups.G": [0.4, 4.0], "groups.V": [30.0, 1.0], "run.duration": [0.1, 1.0]}
    data = sc.sweep(scene, vary, tmp_path, mode="zip", shapes=True).data
    assert data.outcome.values.tolist() == ["solved", "localised"]
    assert "carries" in str(data.message.values[1]) and str(data.regime.values[1]) == ""
    for name in ("midpoint", "sag_over_span", "midpoint_final", "largest_stretch", "x", "y", "stretch"):
        assert np.isfinite(data[name].values[0]).all() and np.isnan(data[name].values[1]).all()
    assert data.duration.values.tolist() == [0.1, 1.0] and data.span.values.tolist() == [0.2, 0.2]


def test_what_makes_no_sense_at_all_is_refused_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(CModel, "integrate", lambda *_: pytest.fail("something ran"))
    for vary, said in (
        ({"material.yeild_stress": ["1 kPa", "2 kPa"]}, "unknown key .did you mean 'yield_stress'"),
        ({"nonsense.G": [1, 2]}, "unknown"),
        ({"groups.Q": [1.0, 2.0]}, "every one of the 2 members is refused.*groups.Q: no group"),
        ({"filament.span": [-1.0, -2.0, -3.0]}, "every one of the 3 members is refused.*is negative"),
    ):
        with pytest.raises(SceneError, match=said):
            sc.sweep(SCENE, vary, tmp_path / "out")
    for options, said in (
        ({"local_cluster": 0}, "1 or more"),
        ({"local_cluster": 2, "scheduler": "tcp://a:1"}, "not both"),
        ({"local_cluster": 2, "workers": 2}, "threads is for runs in this process"),
        ({"workers": 0}, "1 or more"),
        ({"scheduler": "nonsense"}, "no address of a Dask scheduler"),
    ):
        with pytest.raises(SoftcatError, match=said):
            sc.sweep(SCENE, {"groups.G": [0.3, 0.4]}, tmp_path / "out", **options)  # type: ignore[arg-type]
    assert not (tmp_path / "out").exists()


def test_an_interrupted_sweep_goes_on_where_it_was(
    tmp_path: Path, results_of_studies: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    vary = {"groups.G": "0.05:0.5:35:log"}
    whole, broken = tmp_path / "whole", tmp_path / "broken"
    sc.sweep(SCENE, vary, whole, shapes=True)
    store.clear()
    with pytest.raises(KeyboardInterrupt):
        sc.sweep(SCENE, vary, broken, shapes=True, progress=Listener(25))
    assert not broken.exists()
    # Of the two blocks that were finished one is harmed.
    harmed = max(results_of_studies.iterdir(), key=lambda path: path.stat().st_mtime_ns)
    harmed.write_bytes(harmed.read_bytes()[:-7])
    listener, ran = Listener(), list[object]()
    integrate = CModel.integrate
    monkeypatch.setattr(CModel, "integrate", lambda *given: ran.append(1) or integrate(*given))
    done = sc.sweep(SCENE, vary, broken, shapes=True, progress=listener)
    # The one block that was there and sound is not run again.
    assert (len(ran), done.resumed) == (25, 10)
    assert [told[0] for told in listener.told] == list(range(11, 36))
    assert listener.told[-1][2] == 0.0 < listener.told[0][2]
    assert stored(broken).identical(stored(whole))
    assert sorted(path.name for path in broken.iterdir()) == ["sweep.csv", "sweep.nc"]
    ran.clear()
    again = sc.sweep(SCENE, vary, broken, shapes=True)
    assert (len(ran), again.resumed, again.counts) == (0, 35, done.counts)


def test_without_a_directory_the_data_stay_in_memory() -> None:
    done = sc.sweep(SCENE, ["material.law=bingham,maxwell"])
    assert not done.path.exists()
    assert done.data["material.law"].values.tolist() == ["bingham", "maxwell"]
    assert [str(one) for one in done.data.outcome.values] == ["solved", "refused"]


def test_a_phase_diagram_goes_on_from_its_finished_runs(results_of_studies: Path) -> None:
    scene = sc.load_scene("arrested-overdamped", [*SETTINGS, "numerics.cells=10", "run.frames=41"])
    with pytest.raises(KeyboardInterrupt):
        phase_diagram(scene, ["G-V"], 4, workers=1, progress=Listener(20))
    assert len(list(results_of_studies.iterdir())) == 16
    listener = Listener()
    resumed = phase_diagram(scene.replace({"title": "the same"}), ["G-V"], 4, workers=1, progress=listener)
    assert listener.told[0][0] == 17
    with store.fresh():
        fresh = phase_diagram(scene, ["G-V"], 4, workers=1)
    assert resumed.sheets[0].points == fresh.sheets[0].points


PEAKS = """
import subprocess, sys
if len(sys.argv) == 1:
    large = b"x" * 800_000_000
    del large
    sys.exit(subprocess.run([sys.executable, "-c", sys.orig_argv[2], "child"]).returncode)
from softcat_sym.studies.sweep import peak_memory
before = peak_memory()
large = b"x" * 200_000_000
del large
print(before, peak_memory())
"""


def test_peak_memory_is_that_of_the_process_not_of_the_one_that_started_it() -> None:
    done = subprocess.run([sys.executable, "-c", PEAKS], capture_output=True, text=True, check=True)
    before, after = map(float, done.stdout.split())
    assert 1 < before < 700
    assert after > before + 100
