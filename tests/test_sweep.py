"""Sweeps: axes and tables, rows that are single runs, failures as rows, files, and finished members never run again."""

from __future__ import annotations

import csv
import json
import math
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym import cache
from softcat_sym.batch import worker
from softcat_sym.batch.members import Member
from softcat_sym.batch.plan import SweepPlan, plan_sweep
from softcat_sym.errors import SoftcatError
from softcat_sym.results.motion import time_to_share
from softcat_sym.solvers.compiled import CModel
from tests.common.in_process import Softcat, sets

QUICK = {"run.effects": "paper", "numerics.cells": 6, "run.frames": 21, "numerics.estimate": False}
SCENE = sc.load_scene("arrested-overdamped", QUICK)
OPTIONS = sets(*(f"{key}={str(value).lower()}" for key, value in QUICK.items()))
FILES = {"sweep.nc", "sweep.csv", "sweep.json", "scene.toml", "sweep.png"}


class Listener:
    """Notes its updates; after so many members it stops the sweep."""

    def __init__(self, stop: int = 10**9) -> None:
        self.updates: list[tuple[int, int, float]] = []
        self._stop = stop

    def update(self, done: int, members: int, left: float) -> None:
        self.updates.append((done, members, left))
        if done >= self._stop:
            raise KeyboardInterrupt


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "120")
    return Softcat(monkeypatch, capsys)


def plan(*texts: str, mode: str = "grid", samples: int | None = None, seed: int = 0) -> SweepPlan:
    return plan_sweep(SCENE, texts, mode, samples=samples, seed=seed)


def varied(*texts: str) -> list[str]:
    return [word for text in texts for word in ("--vary", text)]


def stored(directory: Path) -> xr.Dataset:
    """What is in the store, but for the time that it took."""
    return xr.load_dataset(directory / "sweep.nc", engine="h5netcdf").drop_vars("wall_s")


def test_values_of_an_axis() -> None:
    for text, values in (
        ("groups.G=0.01:1:3:log", (0.01, 0.1, 1.0)),
        ("groups.G=1:2:3", (1.0, 1.5, 2.0)),
        ("material.yield_stress=5:20 kPa:4", (5e3, 1e4, 1.5e4, 2e4)),
        ('material.yield_stress="5 kPa":"20000 Pa":4', (5e3, 1e4, 1.5e4, 2e4)),
        ("numerics.cells=10:40:4", (10, 20, 30, 40)),
        ("material.yield_stress=5 kPa,200 Pa", ("5 kPa", "200 Pa")),
        ('material.yield_stress="5 kPa", "200 Pa"', ("5 kPa", "200 Pa")),
        ("filament.span=4,5,6 mm", ("4 mm", "5 mm", "6 mm")),
        ("material.law=bingham,maxwell", ("bingham", "maxwell")),
        ('run.effects=["inertia"],["inertia", "bending"]', (["inertia"], ["inertia", "bending"])),
    ):
        (axis,) = plan(text).axes
        assert axis.values == values, text
        assert axis.scale == ("log" if text.endswith("log") else "lin")


def test_a_latin_hypercube_has_one_sample_in_each_part_of_each_axis() -> None:
    texts = ("groups.G=0.01:1:log", "filament.span=4:12 mm", "numerics.cells=10,20")
    found, other = (plan(*texts, mode="lhs", samples=50, seed=seed) for seed in (3, 4))
    rows = found.rows
    G, span = (np.array([float(str(row[key])) for row in rows]) for key in ("groups.G", "filament.span"))
    np.testing.assert_array_equal(np.sort(np.floor(50 * np.log(G / 0.01) / np.log(100))), np.arange(50))
    np.testing.assert_array_equal(np.sort(np.floor(50 * (span - 4e-3) / 8e-3)), np.arange(50))
    assert sorted(row["numerics.cells"] for row in rows) == [10] * 25 + [20] * 25  # type: ignore[type-var]
    # Of two independent permutations of fifty, Student's t = r sqrt(48/(1 - r^2)) is beyond 6.7 once in 5e7.
    assert abs(float(np.corrcoef(np.log(G), span)[0, 1])) < 0.7
    assert other.rows[0] != found.rows[0] and other.digest != found.digest


def test_a_table_and_its_faults(tmp_path: Path) -> None:
    file = tmp_path / "members.csv"
    file.write_text("# of mine\ngroups.G, filament.span [mm], material.law\n0.5, 4, bingham\n1, 5, bingham\n")
    found = plan_sweep(SCENE, file)
    assert (found.mode, found.members) == ("table", 2)
    assert found.rows[0] == {"groups.G": 0.5, "filament.span": "4 mm", "material.law": "bingham"}
    for text, message in (
        ("", "holds no data"),
        ("filament.span [mm],material.law\nabc,bingham\n", "line 2, filament.span: .abc. is not a number"),
        ("groups.G,groups.V\n", "no rows"),
        ("0.5,26\n0.6,27\n", "'0.5' is no dotted key"),
        ("groups.G,groups.G\n1,2\n", "groups.G stands there twice"),
        ("groups.G,groups.V\n1\n", "line 2, groups.V: an empty cell"),
        ("groups.G,groups.V\n1,\n", "line 2, groups.V: an empty cell"),
        ("groups.G\nNaN\n", "is not finite"),
        ("filament.span [bananas]\n4\n", "line 1, filament.span: unknown unit 'bananas'"),
        ("filament.span\n4\n", "'4' has no unit.*filament.span"),
    ):
        file.write_text(text)
        with pytest.raises(SoftcatError, match=message):
            plan_sweep(SCENE, file)
    with pytest.raises(SoftcatError, match="no such file"):
        plan_sweep(SCENE, tmp_path / "none.csv")


def test_bad_input_is_one_message_and_leaves_nothing(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(CModel, "integrate", lambda *_: pytest.fail("something ran"))
    pair = varied("groups.G=1,2")
    for arguments, message in (
        ([], "say what varies"),
        ([*pair, "--from-csv", "x.csv"], "and not by both"),
        (["--from-csv", "none.csv"], "no such file"),
        (varied("groups.G"), "'groups.G' varies nothing"),
        (varied("groups.G=1:2:1"), "at least 2 values"),
        (varied("groups.G=0:2:5:log"), "logarithmic, and not positive"),
        (varied("groups.G=1:1:5"), "are the same"),
        (varied("groups.G=1:2"), "is no range"),
        (varied("groups.G=1:nan:5"), "is not finite"),
        (varied("groups.G=a:b:5"), "no plain numbers"),
        (varied("groups.G=1,,2"), "an empty value"),
        (varied("groups.G=1,1"), "1 is named twice"),
        (varied("groups.G=1:2:5", "groups.G=3,4"), "varied twice"),
        (varied("groups.G=1:2:9999", "groups.V=1:2:9999"), "accepted: up to 1000000"),
        (varied("groups.Q=1,2"), "every one of the 2 members is refused"),
        (varied("nonsense.G=1,2"), "unknown"),
        (varied("material.yeild_stress=1 kPa,2 kPa"), "did you mean 'yield_stress'"),
        (varied("material.yield_stress=1,2"), "has no unit"),
        (varied("material.yield_stress=1:2 furlongs:3"), "not a stress"),
        (varied("filament.span=1 mm,2 kg"), "'kg' is a mass"),
        (varied("filament.span=-1 m,-2 m"), "every one of the 2 members is refused"),
        (varied("numerics.cells=10:12:7"), "does not give 7 whole numbers"),
        (varied("run.frames=11,21"), "members share their frames"),
        ([*varied("groups.G=1,2,3", "groups.V=4,5"), "--mode", "zip"], "groups.G has 3, groups.V has 2"),
        ([*pair, "--mode", "spiral"], "grid, zip, lhs"),
        ([*pair, "--mode", "lhs"], "needs a number"),
        ([*pair, "--samples", "10"], "samples are for a Latin hypercube"),
        ([*pair, "--workers", "0"], "1 or more"),
    ):
        done = softcat("sweep", "arrested-overdamped", *arguments, "-o", "out")
        assert (done.status, done.out) == (2, ""), arguments
        assert message in done.err, arguments
        assert not any(tmp_path.iterdir())
    Path("taken").write_text("a file")
    done = softcat("sweep", "arrested-overdamped", *pair, "-o", "taken")
    assert (done.status, done.out) == (2, "") and "taken is not a directory" in done.err
    assert Path("taken").read_text() == "a file"


@pytest.mark.compiled
def test_members_are_as_accurate_as_the_middle_one_was_made(softcat: Softcat, tmp_path: Path) -> None:
    """On the first guess, 40 cells, this rod errs by more than is asked; each member is compared with one of 320."""
    rod = sc.load_scene("glass-rod", {"run.accuracy": 1e-4, "run.frames": 11})
    viscosities = [2.5e12, 3e12, 3.5e12]
    done = sc.sweep(rod, {"material.viscosity": viscosities}, tmp_path / "python")
    middle = sc.simulate(rod.replace({"material.viscosity": "3e12 Pa*s"}))
    at, data = middle.summary["resolution"], done.data
    assert done.centre.cells == at["cells"] > 40 and done.centre.error == middle.summary["error_estimate"]["total"]
    np.testing.assert_allclose(data.midpoint[1], middle.data.midpoint, rtol=1e-9)
    assert set(data.cells.values) == {at["cells"]} and json.loads(data.attrs["centre"])["error"] == done.centre.error
    many = sc.simulate_many(rod, {"material.viscosity": viscosities}).data
    np.testing.assert_allclose(many.midpoint, data.midpoint, rtol=1e-9)
    assert json.loads(many.attrs["centre"])["cells"] == at["cells"]
    for viscosity, heights in zip(viscosities, data.midpoint.values, strict=True):
        one = rod.replace({"material.viscosity": f"{viscosity} Pa*s", "numerics.estimate": False})
        fine = sc.simulate(one.replace({"numerics.cells": 320, "numerics.rtol": 1e-7})).data.midpoint.values
        guess, asked = sc.simulate(one).data.midpoint.values, 1e-4 * np.max(np.abs(fine))
        assert np.max(np.abs(heights - fine)) < asked < np.max(np.abs(guess - fine))
    # What the scene says stays, and nothing is run for it; each is estimated on request.
    own = sc.simulate_many(rod.replace({"numerics.cells": 10, "numerics.rtol": 1e-5}), {"material.viscosity": [3e12]})
    assert (own.data.cells, own.data.rtol) == (10, 1e-5) and "numerics says all" in own.data.attrs["centre"]
    each = sc.sweep(rod, {"material.viscosity": [3e12]}, estimate=True).data
    assert each.cells == at["cells"] and each.error_estimate == done.centre.error
    options = [*sets("run.accuracy=1e-4", "run.frames=11"), *varied("material.viscosity=2.5e12:3.5e12 Pa*s:3")]
    printed = softcat("sweep", "glass-rod", *options, "-o", str(tmp_path / "out"))
    assert f"{at['cells']} cells" in printed.out and "(0.0001 asked)" in printed.out


def test_rows_are_those_of_simulate(tmp_path: Path) -> None:
    vary = {"groups.G": [0.02, 0.4, 1.9], "material.viscosity": ["9 kPa*s", 14e3]}
    done = sc.sweep(SCENE, vary, tmp_path)
    data = done.data
    assert (len(done), data.sizes["member"]) == (6, 6)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["sweep.csv", "sweep.nc"]
    assert data["groups.G"].values.tolist() == [0.02, 0.02, 0.4, 0.4, 1.9, 1.9]
    assert data["material.viscosity"].values.tolist() == [9e3, 14e3] * 3
    assert data["material.viscosity"].attrs == {"varied": 1, "scale": "lin", "units": "Pa*s"}
    stress = SCENE.filament.density * SCENE.load.gravity * SCENE.filament.span
    for member in range(6):
        row = data.isel(member=member)
        changes = {
            "material.yield_stress": f"{stress / float(row['groups.G'])!r} Pa",
            "material.viscosity": f"{float(row['material.viscosity'])!r} Pa*s",
        }
        single = sc.simulate(SCENE.replace(changes))
        np.testing.assert_allclose(row.midpoint.values, single.data.midpoint.values, rtol=1e-12, atol=1e-15)
        assert (str(row.outcome.values), str(row.regime.values)) == ("solved", single.summary["regime"])
        assert float(row.midpoint_final) == pytest.approx(single.summary["midpoint_final_m"], rel=1e-12)
        assert float(row.sag_over_span) == pytest.approx(-single.summary["midpoint_lowest_m"] / 0.2, rel=1e-12)
        assert float(row.largest_stretch) == pytest.approx(single.data.stretch.values.max(), rel=1e-12)
        assert float(row.energy_residual) == pytest.approx(single.summary["energy_residual"], rel=1e-9)


def test_time_to_a_share_of_an_exponential() -> None:
    """1 - exp(-t) reaches nine tenths at ln 10; between frames by a straight line."""
    time = np.linspace(0, 20, 20001)
    assert time_to_share(time, -np.expm1(-time)) == pytest.approx(math.log(10), rel=1e-5)
    assert time_to_share(np.array([0.0, 1.0]), np.array([0.0, 5.0])) == pytest.approx(0.9)
    assert math.isnan(time_to_share(time, np.zeros_like(time)))


def test_failures_and_runs_that_are_no_answer_are_rows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    descent = sc.load_scene("continual-descent", QUICK)
    vary = {"groups.G": [0.4, 4.0], "groups.V": [30.0, 1.0], "run.duration": [0.1, 1.0]}
    data = sc.sweep(descent, vary, tmp_path, mode="zip").data
    assert data.outcome.values.tolist() == ["solved", "descends"]
    assert str(data.message.values[1]) and str(data.regime.values[1]) == ""
    for name in ("midpoint", "sag_over_span", "midpoint_final", "largest_stretch"):
        assert np.isfinite(data[name].values[0]).all() and np.isnan(data[name].values[1]).all()
    assert data.duration.values.tolist() == [0.1, 1.0] and data.span.values.tolist() == [0.2, 0.2]
    judged = worker.judged

    def failing(member: Member, *others: object) -> object:
        if member.scene.material.yield_stress == 5e3:
            raise RuntimeError("a pipe\nhas burst")
        return judged(member, *others)  # type: ignore[arg-type]

    monkeypatch.setattr(worker, "judged", failing)
    vary = {"material.yield_stress": [4e3, -1.0, 5e3], "run.duration": [0.5, 0.5, 0.5]}
    done = sc.sweep(SCENE, vary, tmp_path, mode="zip")
    assert done.data.outcome.values.tolist() == ["solved", "refused", "failed"]
    assert done.data.message.values.tolist()[2] == "a pipe has burst"
    assert "material.yield_stress: '-1.0 Pa' is negative" in str(done.data.message.values[1])
    assert np.isnan(done.data.midpoint.values).all(axis=1).tolist() == [False, True, True]
    assert done.outcomes == {"solved": 1, "refused": 1, "failed": 1}


@pytest.mark.slow
def test_an_interrupted_sweep_resumes_where_it_was(
    tmp_path: Path, results_of_studies: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    brief = SCENE.replace({"run.duration": "0.2 s"})
    vary = {"groups.G": "0.05:0.5:35:log"}
    whole, broken = tmp_path / "whole", tmp_path / "broken"
    sc.sweep(brief, vary, whole)
    cache.clear(cache.RESULTS)
    with pytest.raises(KeyboardInterrupt):
        sc.sweep(brief, vary, broken, workers=1, progress=Listener(25))
    assert not broken.exists()
    # Of the two blocks that were finished one is harmed.
    harmed = max(results_of_studies.iterdir(), key=lambda path: path.stat().st_mtime_ns)
    harmed.write_bytes(harmed.read_bytes()[:-7])
    listener, ran = Listener(), list[object]()
    integrate = CModel.integrate
    monkeypatch.setattr(CModel, "integrate", lambda *given: ran.append(1) or integrate(*given))
    done = sc.sweep(brief, vary, broken, progress=listener)
    # The one block that was there and sound is not run again.
    assert (len(ran), done.resumed) == (25, 10)
    assert [update[0] for update in listener.updates] == list(range(11, 36))
    assert listener.updates[-1][2] == 0.0 < listener.updates[0][2]
    assert stored(broken).identical(stored(whole))
    assert sorted(path.name for path in broken.iterdir()) == ["sweep.csv", "sweep.nc"]
    ran.clear()
    again = sc.sweep(brief, vary, broken)
    assert (len(ran), again.resumed, again.outcomes) == (0, 35, done.outcomes)


def test_any_executor_runs_the_members() -> None:
    vary = {"groups.G": [0.3, 0.35, 0.4]}
    with ThreadPoolExecutor(2) as executor:
        there = sc.sweep(SCENE, vary, executor=executor, fresh=True)
        assert executor.submit(int, "1").result() == 1, "it outlives the sweep"
        with pytest.raises(SoftcatError, match="threads is for runs in this process"):
            sc.sweep(SCENE, vary, executor=executor, workers=2)
    here = sc.sweep(SCENE, vary, workers=1, fresh=True)
    assert (there.place, here.place) == ("ThreadPoolExecutor", "embedded, 1 thread")
    assert there.data.drop_vars("wall_s").identical(here.data.drop_vars("wall_s"))


def test_files_and_what_they_hold(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "deep" / "out"
    values = varied("material.yield_stress=4:40 kPa:3:log", "groups.V=20,-1")
    done = softcat("sweep", "arrested-overdamped", "-o", str(output), *values, *OPTIONS, "--workers", "1")
    assert (done.status, done.err) == (0, "")
    assert {path.name for path in output.iterdir()} == FILES
    assert all(word in done.out for word in ("3 x 2 grid", "refused", "3 (50%)", "1 thread", "sweep.nc"))
    assert (output / "sweep.png").read_bytes().startswith(b"\x89PNG")
    assert sc.load_scene(output / "scene.toml") == sc.load_scene("arrested-overdamped", OPTIONS[1::2])
    data = xr.load_dataset(output / "sweep.nc", engine="h5netcdf")
    assert dict(data.sizes) == {"member": 6, "frame": 21}
    assert data["material.yield_stress"].attrs == {"varied": 1, "scale": "log", "units": "Pa"}
    assert data["material.yield_stress"].values == pytest.approx([4e3, 4e3, 12649.1106407, 12649.1106407, 4e4, 4e4])
    found = json.loads((output / "sweep.json").read_text())
    assert found["outcomes"] == {"refused": 3, "solved": 3}
    assert (found["plan"]["members"], found["plan"]["mode"], found["place"]) == (6, "grid", "embedded, 1 thread")
    assert found["versions"]["softcat_sym"]
    with (output / "sweep.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["outcome"] for row in rows] == data.outcome.values.tolist()
    assert [row["regime"] for row in rows] == data.regime.values.tolist()
    assert float(rows[2]["sag_largest [m]"]) == float(data.sag_largest[2])
    assert rows[1]["sag_largest [m]"] == "" and "no positive number" in rows[1]["message"]
