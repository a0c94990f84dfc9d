"""``softcat generate`` as a user meets it: what it says, and what it refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.common.in_process import Softcat, sets

BAD: list[tuple[list[str], str]] = [
    (["no-such-scene"], "no-such-scene"),
    (["no-yield", *sets("material.yeild_stress=5 kPa")], "yield_stress"),
    (["maxwell-slow", *sets("model=small-deflection")], "small-deflection"),
    (["no-yield", *sets("run.effects=['flying']")], "flying"),
    (["no-yield", "--name", "../up"], "small letters"),
    (["no-yield", "--name", ".."], "small letters"),
    (["no-yield", "--web", "--name", ".."], "neither a dot nor a dash"),
    (["no-yield", "--web", "--name", "../up"], "without folders"),
    ([], "SCENE"),
    (["no-yield", "--bundled"], "not both"),
    (["--bundled", *sets("numerics.cells=12")], "--bundled"),
]


def test_it_writes_and_says_how_to_go_on_and_bad_input_writes_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    softcat, output = Softcat(monkeypatch, capsys), tmp_path / "out"
    for arguments, named in BAD:
        done = softcat("generate", *arguments, "-o", str(output))
        assert done.status == 2 and named in done.err, (arguments, done.err)
        assert not output.exists(), arguments
    done = softcat("generate", "no-yield", "-o", str(output), *sets("numerics.cells=12"))
    assert (done.status, done.err) == (0, "") and "next: make -C" in done.out
    assert "cells = 12" in (output / "parameters.txt").read_text()
    quiet = softcat("generate", "no-yield", "-o", str(output), "--quiet", "--name", "beam", "--rhs")
    assert (quiet.status, quiet.out) == (0, "") and "numerics.cells 12 -> none" in quiet.err
    assert {"beam.c", "softcat_rhs.c"} <= {path.name for path in output.iterdir()}
    (tmp_path / "file").write_text("mine")
    done = softcat("generate", "no-yield", "-o", str(tmp_path / "file" / "below"))
    assert done.status == 2 and "not a directory" in done.err
    (tmp_path / "taken" / "filament.c").mkdir(parents=True)
    done = softcat("generate", "no-yield", "-o", str(tmp_path / "taken"))
    assert done.status == 2 and "cannot write" in done.err
    assert not [path for path in (tmp_path / "taken").iterdir() if ".part" in path.name]
