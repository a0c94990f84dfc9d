"""``softcat generate`` as a user meets it: what it says, and what it refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from .in_process import Softcat, sets


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def test_it_writes_and_says_how_to_go_on(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("generate", "no-yield", "-o", str(tmp_path), *sets("numerics.cells=12"))
    assert (done.status, done.err) == (0, "")
    assert "next: make -C" in done.out
    assert "cells = 12" in (tmp_path / "parameters.txt").read_text()
    quiet = softcat("generate", "no-yield", "-o", str(tmp_path), "--quiet", "--name", "beam", "--rhs")
    assert (quiet.status, quiet.out, quiet.err) == (0, "", "")
    assert {"beam.c", "softcat_rhs.c"} <= {path.name for path in tmp_path.iterdir()}


BAD = {
    "no such scene": (["no-such-scene"], "no-such-scene"),
    "no such key": (["no-yield", *sets("material.yeild_stress=5 kPa")], "yield_stress"),
    "unit": (["no-yield", *sets("filament.thickness=5 s")], "filament.thickness"),
    "cells": (["no-yield", *sets("numerics.cells=0")], "numerics.cells"),
    "model": (["maxwell-slow", *sets("model=small-deflection")], "small-deflection"),
    "effects": (["no-yield", *sets("run.effects=['flying']")], "flying"),
    "name": (["no-yield", "--name", "../up"], "small letters"),
    "no scene": ([], "SCENE"),
    "both": (["no-yield", "--bundled"], "not both"),
    "bundled and set": (["--bundled", *sets("numerics.cells=12")], "--bundled"),
    "option": (["no-yield", "--fly"], "--fly"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_exits_2_and_writes_nothing(case: str, softcat: Softcat, tmp_path: Path) -> None:
    arguments, said = BAD[case]
    done = softcat("generate", *arguments, "-o", str(tmp_path / "out"))
    assert done.status == 2
    assert said in done.err
    assert not (tmp_path / "out").exists()


def test_a_place_that_cannot_be_written_is_refused(softcat: Softcat, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    for place in (tmp_path / "file", tmp_path / "file" / "below"):
        done = softcat("generate", "no-yield", "-o", str(place))
        assert done.status == 2 and "not a directory" in done.err
    (tmp_path / "out" / "filament.c").mkdir(parents=True)
    done = softcat("generate", "no-yield", "-o", str(tmp_path / "out"))
    assert done.status == 2 and "cannot write" in done.err
    assert not [path for path in (tmp_path / "out").iterdir() if ".part" in path.name]
