"""``softcat draw``, and the films and styles of ``softcat run``: the same pictures without solving, or a refusal."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import xarray as xr
from PIL import Image

import softcat_sym as sc
from softcat_sym.plotting.run import write_run
from softcat_sym.results.files import open_run
from tests.cli.in_process import Softcat

QUICK = ("numerics.cells=10", "run.frames=21", "numerics.estimate=false")
PICTURES = {"midpoint.png", "shapes.png", "energy.png", "space-time.png", "midpoint.csv"}


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


@pytest.fixture(scope="module")
def stored(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A finished run."""
    folder = tmp_path_factory.mktemp("stored")
    write_run(sc.simulate(sc.load_scene("arrested-overdamped", QUICK)), folder)
    return folder


def test_a_run_drawn_again_is_the_same_to_the_byte(softcat: Softcat, stored: Path, tmp_path: Path) -> None:
    done = softcat("draw", str(stored), "-o", str(tmp_path))
    assert done.status in (0, None), done.err
    assert {path.name for path in tmp_path.iterdir()} == PICTURES | {"summary.json", "scene.toml"}
    for path in tmp_path.iterdir():
        assert path.read_bytes() == (stored / path.name).read_bytes(), path.name


def test_a_film_of_a_stored_run(softcat: Softcat, stored: Path, tmp_path: Path) -> None:
    asked = ("--animate", "ink.gif", "--animate-seconds", "0.8", "-q")
    done = softcat("draw", str(stored / "trajectory.nc"), "-o", str(tmp_path), *asked)
    assert done.status in (0, None), done.err
    with Image.open(tmp_path / "ink.gif") as film:
        assert film.n_frames == 10


def test_a_run_writes_its_film_and_its_style(softcat: Softcat, tmp_path: Path) -> None:
    sets = [word for change in QUICK for word in ("--set", change)]
    film = ("--animate", "gif", "--animate-seconds", "0.4", "--style", "publication")
    done = softcat("run", "arrested-overdamped", "-o", str(tmp_path), *sets, *film)
    assert done.status in (0, None), done.err
    assert {"film.gif", "shapes.pdf", "space-time.pdf", "trajectory.nc"} <= {path.name for path in tmp_path.iterdir()}
    assert "film.gif, " in done.out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--animate", "film.avi"), "accepted: gif, mp4"),
        (("--animate", "../film.gif"), "it goes into DIR"),
        (("--animate", "gif", "--animate-seconds", "-3"), "more than 0"),
        (("--style", "fancy"), "accepted: screen, publication"),
    ],
)
def test_what_cannot_be_drawn_is_refused_before_anything_is_solved(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...], said: str
) -> None:
    def solve(*asked: object) -> None:
        raise AssertionError("solved")

    # By name the package offers the function, not the module.
    monkeypatch.setattr(sys.modules["softcat_sym.simulate"], "simulated", solve)
    done = softcat("run", "arrested-overdamped", "-o", str(tmp_path / "out"), *arguments)
    assert done.status == 2
    assert said in done.err
    assert not (tmp_path / "out").exists()


def test_what_is_no_trajectory_is_refused(softcat: Softcat, stored: Path, tmp_path: Path) -> None:
    with xr.open_dataset(stored / "trajectory.nc", engine="h5netcdf") as opened:
        data = opened.load()
    (tmp_path / "text.nc").write_text("garbage")
    (tmp_path / "short.nc").write_bytes((stored / "trajectory.nc").read_bytes()[:20000])
    data.drop_vars("thickness").to_netcdf(tmp_path / "thin.nc", engine="h5netcdf")
    data.assign_attrs(scene="[filament").to_netcdf(tmp_path / "scene.nc", engine="h5netcdf")
    data.assign(y=data.y.where(data.time < 1)).to_netcdf(tmp_path / "nan.nc", engine="h5netcdf")
    data.isel(time=slice(0, 0)).to_netcdf(tmp_path / "empty.nc", engine="h5netcdf")
    for name, said in {
        "missing.nc": "no such file",
        "text.nc": "cannot be read as netCDF4",
        "short.nc": "cannot be read as netCDF4",
        "thin.nc": "it lacks thickness",
        "scene.nc": "its scene cannot be read",
        "nan.nc": "y is not finite everywhere",
        "empty.nc": "it lacks frames",
    }.items():
        done = softcat("draw", str(tmp_path / name), "-o", str(tmp_path / "out"))
        assert (done.status, said in done.err) == (2, True), (name, done.err)
    assert not (tmp_path / "out").exists()


def test_a_film_that_cannot_be_written_takes_the_pictures_with_it(
    softcat: Softcat, stored: Path, tmp_path: Path
) -> None:
    (tmp_path / "film.gif").mkdir()
    done = softcat("draw", str(stored), "-o", str(tmp_path), "--animate", "gif", "--animate-seconds", "0.2")
    assert done.status == 2
    assert [path.name for path in tmp_path.iterdir()] == ["film.gif"]


def test_a_summary_of_another_run_is_not_believed(stored: Path, tmp_path: Path) -> None:
    (tmp_path / "trajectory.nc").write_bytes((stored / "trajectory.nc").read_bytes())
    (tmp_path / "summary.json").write_text('{"outcome": "solved", "regime": "viscous", "midpoint_final_m": -1.0}')
    run = open_run(tmp_path)
    assert run.summary == {"title": "Yields, flows slowly and stops", "outcome": "solved"}
    assert run.scene == sc.load_scene(stored / "scene.toml")


@pytest.mark.slow
def test_interrupted_while_drawing_the_run_stays_whole(tmp_path: Path) -> None:
    program = str(Path(sys.executable).with_name("softcat"))
    sets = [word for change in QUICK for word in ("--set", change)]
    film = ("--animate", "gif", "--animate-seconds", "120")
    command = [program, "run", "arrested-overdamped", "-o", str(tmp_path), *sets, *film]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        end = time.monotonic() + 60
        while not list(tmp_path.glob(".film.*")):
            assert time.monotonic() < end
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "its film is not: softcat draw" in said
    assert {path.name for path in tmp_path.iterdir()} == PICTURES | {"trajectory.nc", "summary.json", "scene.toml"}
