"""``softcat phase`` interrupted and gone on from."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from softcat_sym.studies import phase_runs
from tests.cli.in_process import Softcat, sets

QUICK = ["--plane", "G-V", "--resolution", "4", "--workers", "1", *sets("numerics.cells=6", "run.frames=21")]


def test_an_interrupted_diagram_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    softcat, whole, broken = Softcat(monkeypatch, capsys), tmp_path / "whole", tmp_path / "broken"
    assert softcat("phase", "-q", "-o", str(whole), *QUICK).status == 0
    one, ran = phase_runs._one, list[object]()

    def stopping(*given: object) -> object:
        ran.append(1)
        if len(ran) == 20:
            raise KeyboardInterrupt
        return one(*given)  # type: ignore[arg-type]

    monkeypatch.setattr(phase_runs, "_one", stopping)
    done = softcat("phase", "-q", "-o", str(broken), *QUICK)
    assert (done.status, done.out) == (130, "")
    assert "1 finished block is in" in done.err and "--resume" in done.err
    assert softcat("phase", "-q", "-o", str(broken), *QUICK).status == 2
    ran.extend([1] * 100)
    before = len(ran)
    assert softcat("phase", "-q", "-o", str(broken), *QUICK, "--resume").status == 0
    with (whole / "phase_runs.csv").open(newline="") as stream:
        rows = len(list(csv.reader(stream))) - 1
    # Sixteen were finished; the descent of the paper is run anyway.
    assert len(ran) - before == rows - 16 + 1
    for name in ("phase_runs.csv", "phase_boundaries.csv"):
        assert (broken / name).read_bytes() == (whole / name).read_bytes()
    assert not (broken / "parts").exists()
