"""``softcat accuracy`` as a user meets it: files, refusals, interruption and resumption."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from tests.cli.in_process import Softcat, sets

SHORT = ("run.effects=paper", "run.duration=0.05 s", "run.frames=6")
ASKED = ("--cells", "10,20", "--rtol", "1e-2,1e-4", "--limit", "20", "--warm-only")
FILES = {"accuracy.csv", "accuracy.json", "accuracy.png", "scene.toml"}


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "200")
    return Softcat(monkeypatch, capsys)


@pytest.mark.slow  # a reference on 160 cells, and processes that import all of the package
@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
def test_files_and_what_they_hold(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "deep" / "out"
    programs = [word for key in ("compiled-rodas5p", "cvodes", "compiled-rk4") for word in ("--program", key)]
    done = softcat("accuracy", "continual-descent", "-o", str(output), *ASKED, *programs, *sets(*SHORT))
    assert (done.status, done.err) == (0, "")
    assert {path.name for path in output.iterdir()} == FILES
    assert "Rodas5P, compiled" in done.out
    assert (output / "accuracy.png").read_bytes().startswith(b"\x89PNG")
    assert sc.load_scene(output / "scene.toml") == sc.load_scene("continual-descent", list(SHORT))
    found = json.loads((output / "accuracy.json").read_text())
    assert 0 < found["reference"]["floor"] < 1e-4
    assert [program["key"] for program in found["programs"]] == ["compiled-rodas5p", "cvodes", "compiled-rk4"]
    # Every program converges to the one reference: on 20 cells a quarter of the error of 10.
    for program in found["programs"]:
        best = {n: min(run["error"] for run in program["runs"] if run["cells"] == n) for n in (10, 20)}
        assert best[20] < 0.5 * best[10] < 0.05
    with (output / "accuracy.csv").open(newline="") as stream:
        table = list(csv.DictReader(stream))
    assert len(table) == sum(len(program["runs"]) for program in found["programs"])
    assert [float(line["error"]) for line in table] == [r["error"] for p in found["programs"] for r in p["runs"]]
    for level in found["knees"]:
        if level["best"] is not None:
            assert level["best"]["error"] <= level["error"]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--cells", "ten"), "--cells"),
        (("--cells", "10.5"), "whole numbers"),
        (("--cells", "2"), "from 4 to 2000"),
        (("--rtol", "1e-3,2"), "--rtol"),
        (("--program", "euler"), "compiled-rodas5p"),
        (("--limit", "0"), "--limit"),
        (("--set", "material.colour=red"), "material.colour"),
    ],
)
def test_faults_are_said_and_nothing_is_written(
    options: tuple[str, ...], said: str, softcat: Softcat, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    done = softcat("accuracy", "continual-descent", "-o", str(output), *options)
    assert done.status == 2
    assert said in done.err
    assert not output.exists()


def test_a_place_that_cannot_be_written_is_refused_at_once(softcat: Softcat, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    done = softcat("accuracy", "continual-descent", "-o", str(tmp_path / "file" / "out"))
    assert done.status == 2
    assert "not a directory" in done.err
