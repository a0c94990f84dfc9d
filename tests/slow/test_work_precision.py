"""What accuracy costs: a measurement that takes too long is ended, and what the command writes."""

from __future__ import annotations

import csv
import json
from contextlib import closing
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.studies.integrators import THIS_PROGRAM, Task
from softcat_sym.studies.work_precision import Budget, Worker
from tests.common.in_process import Softcat, sets

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]

NAME = "continual-descent"


def test_what_takes_too_long_is_ended_and_the_next_begins_anew() -> None:
    scene, quick = sc.load_scene(NAME, {"run.effects": "paper", "numerics.estimate": False}), Task("cvodes", 10, 1.0)
    with closing(Worker(scene, Budget(300.0, lambda what, share: None))) as worker:
        # Over ten thousand steps of 640 cells: more than a minute.
        long = worker.measure(Task("cvodes", 640, 30.0, rtol=1e-11), 1.0)
        assert long.message == "stopped after 1 s" and long.stopped and long.midpoint == ()
        assert not worker.measure(quick, 60.0).message


def test_files_and_what_they_hold(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    short = ("run.effects=paper", "run.duration=0.05 s", "run.frames=6")
    done = Softcat(monkeypatch, capsys)("accuracy", NAME, "-o", str(tmp_path), "--limit", "200", *sets(*short))
    assert done.status == 0 and "At an error of" in done.out
    assert {path.name for path in tmp_path.iterdir()} == {f"accuracy.{kind}" for kind in ("csv", "json", "png")} | {
        "scene.toml"
    }
    found = json.loads((tmp_path / "accuracy.json").read_text())
    assert 0 < found["reference"]["floor"] < 1e-4
    assert [program["key"] for program in found["programs"]] == [THIS_PROGRAM, "idas", "scipy-radau"]
    # Every program converges to the one reference: on 20 cells a quarter of the error of 10.
    for program in found["programs"]:
        sound = [run for run in program["runs"] if run["error"] is not None]
        best = {n: min(run["error"] for run in sound if run["cells"] == n) for n in (10, 20)}
        assert best[20] < 0.5 * best[10] < 0.05
    table = list(csv.DictReader((tmp_path / "accuracy.csv").read_text().splitlines()))
    errors = [run["error"] for p in found["programs"] for run in p["runs"]]
    assert [float(line["error"]) if line["error"] else None for line in table] == errors
    assert all(knee["best"] is None or knee["best"]["error"] <= knee["error"] for knee in found["knees"])
