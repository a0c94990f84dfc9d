"""``softcat phase`` as a user meets it: files, numbers in them, refusals."""

from __future__ import annotations

import csv
import json
from collections import Counter
from pathlib import Path

import pytest

import softcat_sym as sc
from tests.cli.in_process import Softcat

FILES = {
    "phase.json", "scene.toml", "phase_runs.csv", "phase_boundaries.csv", "phase_lines.csv",
    "phase_G-V.png", "phase_G-V_strain.png",
}  # fmt: skip


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


def test_files_and_what_they_hold(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("phase", "-o", str(tmp_path / "out"), "--plane", "G-V", "--resolution", "4")
    assert done.status == 0, done.err
    out = tmp_path / "out"
    assert {path.name for path in out.iterdir()} == FILES
    told = json.loads((out / "phase.json").read_text())
    plane = told["planes"]["G-V"]
    assert plane["nodes"] == plane["nodes_run"] + plane["nodes_saved"] == 25
    with (out / "phase_runs.csv").open() as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == plane["nodes_run"]
    assert Counter(row["mark"] for row in rows) == plane["marks"]
    assert sum(int(row["runs"]) for row in rows) == plane["runs"]
    for row in rows:
        assert bool(row["regime"]) is (row["outcome"] == "solved")
        assert row["regime"] or row["message"]
    assert {"localised", "no-yield", "descending"} <= set(plane["marks"])
    assert f"{plane['nodes_saved']} of" in plane["caption"] or "were saved" in plane["caption"]
    assert "refinement saved" in done.out
    assert '"over 23 %"' in done.out
    assert sc.load_scene(str(out / "scene.toml")).run.effects == "paper"
    for name in FILES:
        if name.endswith(".png"):
            assert (out / name).read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--plane", "G-tau"), "G-delta, G-V"),
        (("--resolution", "2"), "4 to 640"),
        (("maxwell-slow",), "material.law"),
        (("--workers", "0"), "workers"),
    ],
)
def test_refusals_write_nothing(softcat: Softcat, tmp_path: Path, arguments: tuple[str, ...], message: str) -> None:
    done = softcat("phase", *arguments, "-o", str(tmp_path / "out"))
    assert done.status == 2
    assert message in done.err
    assert not (tmp_path / "out").exists()
