"""``softcat run`` as a user meets it: files, exit status, overrides, interruption, a place that cannot be written."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import xarray as xr

import softcat_sym as sc

from .in_process import Softcat

SOFTCAT = str(Path(sys.executable).with_name("softcat"))
QUICK = ("--set", "numerics.cells=10", "--set", "run.frames=21")
ONCE = (*QUICK, "--set", "numerics.estimate=false")
PICTURES = {"midpoint.png", "shapes.png", "energy.png", "space-time.png"}
FILES = {"trajectory.nc", "summary.json", "scene.toml", "midpoint.csv"} | PICTURES


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def test_run_writes_its_files_and_tells_the_regime(tmp_path: Path) -> None:
    output = tmp_path / "deep" / "out"
    command = [SOFTCAT, "run", "arrested-overdamped", "-o", str(output), *QUICK]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert {path.name for path in output.iterdir()} == FILES
    assert "arrested-overdamped" in done.stdout
    assert all(line.startswith("softcat: ") for line in done.stderr.splitlines()), "what goes on, and nothing else"
    summary = json.loads((output / "summary.json").read_text())
    assert summary["outcome"] == "solved"
    assert summary["cells"] == 10
    assert set(summary["wall_s"]) == {"build", "compile", "solve", "estimate", "write", "total"}
    with xr.open_dataset(output / "trajectory.nc") as data:
        assert dict(data.sizes) == {"time": 21, "node": 21, "cell": 20}
        assert data.midpoint.values[-1] == pytest.approx(summary["midpoint_final_m"])
        assert data.time.dtype.kind == "f"


def test_the_screen_is_short_and_in_full_where_asked(softcat: Softcat, tmp_path: Path) -> None:
    title = "title=[red]ink[/] at [5 mm]"
    asked = ("run", "arrested-overdamped", "-o", str(tmp_path / "out"), "--set", title)
    short, full = (softcat(*asked, *QUICK, *more) for more in ((), ("-v",)))
    lines = short.out.splitlines()
    assert lines[:2] == ["[red]ink[/] at [5 mm]", "outcome  solved"]
    assert re.fullmatch(r"sag      13\.\d mm ± [\d.]+ %, 6\.\d % of the span", lines[2])
    assert len(lines) <= 12 and max(map(len, lines)) <= 80 + len(str(tmp_path))
    assert f"files    {tmp_path / 'out'} (8: trajectory.nc, summary.json, ...)" in " ".join(map(str.strip, lines))
    reasons = json.loads((tmp_path / "out" / "summary.json").read_text())["effects"]
    assert re.fullmatch(r"worth about \d+ % of the sag", reasons["inertia"])
    for said in (f"inertia: on, {reasons['inertia']}", "left out", "wall time", "energy", *FILES):
        assert said in full.out
        assert said in FILES or said not in short.out
    assert "\x1b" not in short.out + short.err, "no colour in a pipe"


def test_a_refused_answer_is_stamped_where_it_is_told(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("run", "edge-of-rupture", "-o", str(tmp_path), "--set", "run.effects=paper", *ONCE)
    assert done.status == 1
    assert done.out.startswith("NOT TO BE TRUSTED (localised): ")
    table = (tmp_path / "midpoint.csv").read_text().splitlines()
    assert table[0] == "time_s,midpoint_m,refused"
    assert all(line.endswith(",localised") for line in table[1:])


def test_the_resolved_scene_runs_to_the_same_answer(softcat: Softcat, tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    assert softcat("run", "ink-bridge", "-o", str(first), "-q", *ONCE).status == 0
    assert softcat("run", str(first / "scene.toml"), "-o", str(second), "-q").status == 0
    one, two = (json.loads((folder / "summary.json").read_text()) for folder in (first, second))
    assert one["midpoint_final_m"] == two["midpoint_final_m"]
    assert sc.load_scene(first / "scene.toml") == sc.load_scene(second / "scene.toml")


def test_overrides_reach_the_run(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("run", "arrested-overdamped", "-o", str(tmp_path), "-q", "--set", "run.closure=printed", *ONCE)
    assert done.status == 0
    assert done.out == ""
    assert json.loads((tmp_path / "summary.json").read_text())["closure"] == "printed"
    bad = softcat("run", "arrested-overdamped", "-o", str(tmp_path), "--set", "material.yeild_stress=5 kPa")
    assert bad.status == 2
    assert "yield_stress" in bad.err


def test_an_answer_not_to_be_trusted_exits_1_and_still_writes(softcat: Softcat, tmp_path: Path) -> None:
    published = ("--set", "run.effects=paper")
    done = softcat("run", "edge-of-rupture", "-o", str(tmp_path), "-q", *published, *QUICK)
    assert done.status == 1
    assert done.err.startswith("softcat: localised")
    assert {path.name for path in tmp_path.iterdir()} == FILES
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert summary["outcome"] == "localised"
    assert summary["regime"] is None
    assert summary["advice"] == sc.Outcome.localised.value


def test_a_place_that_cannot_be_written_is_refused_before_the_run(softcat: Softcat, tmp_path: Path) -> None:
    taken = tmp_path / "taken"
    taken.write_text("a file")
    for output in (taken, taken / "below"):
        done = softcat("run", "arrested-overdamped", "-o", str(output), *QUICK)
        assert done.status == 2
        assert "not a directory" in done.err
    assert taken.read_text() == "a file"


def test_an_interrupted_run_writes_nothing_but_its_state(tmp_path: Path) -> None:
    output = tmp_path / "out"
    command = [
        SOFTCAT,
        "run",
        "no-yield",
        "-o",
        str(output),
        "--set",
        "numerics.cells=1000",
        "--set",
        "numerics.rtol=1e-10",
    ]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        time.sleep(6)
        process.send_signal(signal.SIGINT)
        _, message = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "interrupted" in message
    assert "Traceback" not in message
    assert not output.exists()


def test_help_and_scenes_and_version(softcat: Softcat) -> None:
    assert "run" in softcat("--help").out
    listing = softcat("scenes").out.splitlines()
    assert [line.split()[0] for line in listing if line[:1].strip()] == list(sc.bundled_names())
    assert softcat("--version").out.startswith("softcat ")
    assert softcat("fly").status == 2


def test_the_small_deflection_model_runs_from_a_scene(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("run", "maxwell-slow", "-o", str(tmp_path), "-q", "--set", "model=small-deflection", *ONCE)
    assert done.status == 0, done.err
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert set(summary["effects"]) == {"inertia", "bending", "viscous-flow"}
    bad = softcat("run", "arrested-overdamped", "-o", str(tmp_path / "bad"), "--set", "model=small-deflection")
    assert bad.status == 2
    assert "material.law" in bad.err
    assert not (tmp_path / "bad").exists()
