"""``softcat sweep`` as a user meets it: files, pictures, refusals, interruption, and going on."""

from __future__ import annotations

import csv
import json
import signal
from pathlib import Path

import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.studies import sweep as work
from tests.cli.in_process import Softcat, sets

QUICK = sets("run.effects=paper", "numerics.cells=6", "run.frames=21")
FILES = {"sweep.nc", "sweep.csv", "sweep.json", "scene.toml", "sweep.png"}
PNG = b"\x89PNG"


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "120")
    return Softcat(monkeypatch, capsys)


def varied(*texts: str) -> list[str]:
    return [word for text in texts for word in ("--vary", text)]


def test_files_and_what_they_hold(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "deep" / "out"
    values = varied("material.yield_stress=4:40 kPa:3:log", "groups.V=20,-1")
    done = softcat("sweep", "arrested-overdamped", "-o", str(output), *values, *QUICK, "--shapes", "--workers", "1")
    assert (done.status, done.err) == (0, "")
    assert {path.name for path in output.iterdir()} == FILES | {"sliders.html"}
    assert all(word in done.out for word in ("3 x 2 grid", "refused", "3 (50%)", "1 thread", "peak memory", "sweep.nc"))
    assert (output / "sweep.png").read_bytes().startswith(PNG)
    assert sc.load_scene(output / "scene.toml") == sc.load_scene("arrested-overdamped", QUICK[1::2])
    data = xr.load_dataset(output / "sweep.nc", engine="h5netcdf")
    assert dict(data.sizes) == {"member": 6, "frame": 21, "shape_frame": 21, "shape_node": 41}
    assert data["material.yield_stress"].attrs == {"varied": 1, "scale": "log", "units": "Pa"}
    assert data["material.yield_stress"].values == pytest.approx([4e3, 4e3, 12649.1106407, 12649.1106407, 4e4, 4e4])
    found = json.loads((output / "sweep.json").read_text())
    assert found["outcomes"] == {"refused": 3, "solved": 3}
    assert (found["plan"]["members"], found["plan"]["mode"], found["place"]) == (6, "grid", "embedded, 1 thread")
    assert found["peak_memory_MB"] > 1 and found["versions"]["softcat_sym"]
    with (output / "sweep.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["outcome"] for row in rows] == data.outcome.values.tolist()
    assert [row["regime"] for row in rows] == data.regime.values.tolist()
    assert float(rows[2]["sag_largest [m]"]) == float(data.sag_largest[2])
    assert rows[1]["sag_largest [m]"] == "" and "no positive number" in rows[1]["message"]
    assert "<script" in (output / "sliders.html").read_text()


@pytest.mark.parametrize(
    "arguments",
    [
        varied("groups.G=0.02:2:5:log"),
        [
            *varied("groups.G=0.3:0.5", "groups.V=10:30", "filament.density=1000:2000 kg/m^3"),
            "--mode=lhs",
            "--samples=4",
        ],
        varied("material.law=bingham,maxwell"),
        [*varied("groups.G=0.3,0.4", "groups.V=20,30"), "--mode=zip"],
        varied("groups.G=0.4,0.400001"),
    ],
    ids=["line", "pairs", "words", "zip", "hardly"],
)
def test_a_picture_of_each_sort(arguments: list[str], softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("sweep", "arrested-overdamped", "-q", "-o", str(tmp_path), *arguments, *QUICK)
    assert (done.status, done.out, done.err) == (0, "", "")
    assert {path.name for path in tmp_path.iterdir()} == FILES


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "say what varies"),
        ([*varied("groups.G=1,2"), "--from-csv", "x.csv"], "and not by both"),
        (["--from-csv", "none.csv"], "no such file"),
        (varied("groups.G=1:2:1"), "at least 2 values"),
        (varied("groups.G=-1:2:9:log"), "not positive"),
        (varied("material.yeild_stress=1 kPa,2 kPa"), "did you mean 'yield_stress'"),
        (varied("material.yield_stress=1,2"), "has no unit"),
        (varied("material.yield_stress=1:2 furlongs:3"), "not a stress"),
        ([*varied("groups.G=1,2,3", "groups.V=1,2"), "--mode", "zip"], "unequal lengths"),
        (varied("groups.G=1,2", "groups.G=3,4"), "varied twice"),
        ([*varied("groups.G=1,2"), "--mode", "spiral"], "grid, zip, lhs"),
        ([*varied("groups.G=1,2"), "--local-cluster", "0"], "1 or more"),
        ([*varied("groups.G=1,2"), "--workers", "0"], "1 or more"),
        ([*varied("groups.G=1,2"), "--scheduler", "here"], "no address of a Dask scheduler"),
        (varied("filament.span=-1 m,-2 m"), "every one of the 2 members is refused"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: list[str], said: str, softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = softcat("sweep", "arrested-overdamped", *arguments, "-o", "out")
    assert (done.status, done.out) == (2, "")
    assert said in done.err
    assert not any(tmp_path.iterdir())


def test_a_directory_must_be_one(softcat: Softcat, tmp_path: Path) -> None:
    taken = tmp_path / "taken"
    taken.write_text("a file")
    done = softcat("sweep", "arrested-overdamped", *varied("groups.G=1,2"), "-o", str(taken))
    assert (done.status, done.out) == (2, "")
    assert f"{taken} is not a directory" in done.err
    assert taken.read_text() == "a file"


def test_no_answer_at_all_exits_1_and_still_writes(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(*_: object) -> None:
        raise RuntimeError("burst")

    monkeypatch.setattr(work, "judged", failing)
    done = softcat("sweep", "arrested-overdamped", "-q", "-o", str(tmp_path), *varied("groups.G=0.3,0.4"), *QUICK)
    assert (done.status, done.out) == (1, "")
    assert "no member is an answer" in done.err
    assert {path.name for path in tmp_path.iterdir()} == FILES


def test_an_interruption_says_how_to_go_on(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked = ("sweep", "arrested-overdamped", "-q", "-o", str(tmp_path / "out"), *varied("groups.G=0.1:0.5:25"), *QUICK)
    judged, ran = work.judged, list[object]()

    def stopping(*given: object) -> object:
        ran.append(1)
        if len(ran) == 15:
            raise KeyboardInterrupt
        return judged(*given)  # type: ignore[arg-type]

    monkeypatch.setattr(work, "judged", stopping)
    done = softcat(*asked, "--workers", "1")
    assert (done.status, done.out) == (130, "")
    assert "the same command goes on from what was finished" in done.err
    assert not (tmp_path / "out").exists()
    ran.extend([1] * 100)
    before = len(ran)
    assert softcat(*asked).status == 0
    assert len(ran) == before + 15
    assert {path.name for path in (tmp_path / "out").iterdir()} == FILES
    assert softcat(*asked).status == 0
    assert len(ran) == before + 15
    assert softcat(*asked, "--fresh").status == 0
    assert len(ran) == before + 15 + 25


def test_nothing_is_written_if_it_is_stopped_before_a_block_is_finished(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(*_: object) -> None:
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr("softcat_sym.ensemble.executor.Embedded.run", stopped)
    output = tmp_path / "out"
    done = softcat("sweep", "arrested-overdamped", "-o", str(output), *varied("groups.G=0.3,0.4"), *QUICK)
    assert (done.status, done.out) == (130, "")
    assert not output.exists()
