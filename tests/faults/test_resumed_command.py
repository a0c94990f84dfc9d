"""``softcat run --resume``: stopped twice, by whatever signal, it comes to the answer of a run that was not."""

from __future__ import annotations

import json
import signal
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from softcat_sym.codegen.compiler import find_compiler

from .commands import PATIENCE, ended, softcat, until
from .tiny_disk import files_in

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler"),
]
RTOL = 1e-8
LONG = ("--set", "numerics.cells=400", "--set", f"numerics.rtol={RTOL}", "--set", "numerics.estimate=false")


def completed(*arguments: str) -> str:
    with softcat(*arguments) as process:
        out, err = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0, err
    return out


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    output = tmp_path_factory.mktemp("whole")
    completed("run", "continual-descent", "-o", str(output), *LONG)
    return output


@pytest.mark.parametrize(
    ("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGKILL, -signal.SIGKILL)]
)
def test_it_goes_on_to_the_same_answer(number: signal.Signals, status: int, whole: Path, tmp_path: Path) -> None:
    output = tmp_path / "out"
    asked = ("run", "continual-descent", "-o", str(output), *LONG)
    states = output / "checkpoint"
    frames = [1]
    for more in ((), ("--resume",)):
        with softcat(*asked, *more, often=True) as process:
            # Until there is more than before.
            until(lambda: _frames(states) > frames[-1] + 10, process)
            left, _, err = ended(process, number)
        assert left == status
        if number is not signal.SIGKILL:
            kept = f"what was reached is in {states}: the same command with --resume goes on from there"
            assert err == f"softcat: interrupted; {kept}\n"
        assert {path.name for path in output.iterdir()} == {"checkpoint"}
        frames.append(_frames(states))
    assert f"went on from {states}" in completed(*asked, "--resume")
    assert set(files_in(output)) == set(files_in(whole)), "and the states are gone"
    answers = []
    for folder in (whole, output):
        with xr.open_dataset(folder / "trajectory.nc") as data:
            answers.append(data.load())
        assert json.loads((folder / "summary.json").read_text())["outcome"] == "solved"
    assert set(answers[0].variables) == set(answers[1].variables)
    for name in ("midpoint", "x", "y"):
        one, two = (np.asarray(answer[name]) for answer in answers)
        assert np.max(np.abs(one - two)) < 10 * RTOL * np.max(np.abs(one)), name


def test_another_scene_is_refused(whole: Path, tmp_path: Path) -> None:
    output = tmp_path / "out"
    with softcat("run", "continual-descent", "-o", str(output), *LONG, often=True) as process:
        until(lambda: _frames(output / "checkpoint") > 1, process)
        ended(process, signal.SIGTERM)
    before = files_in(output)
    with softcat("run", "continual-descent", "-o", str(output), *LONG, "--resume", "--set", "run.frames=99") as process:
        _, err = process.communicate(timeout=PATIENCE)
    assert process.returncode == 2
    assert "is the checkpoint of another scene or version of this program; leave out --resume" in err
    assert files_in(output) == before


def _frames(states: Path) -> int:
    """Of the longest state that is kept."""
    found = [0]
    for path in states.glob("[!.]*.npz"):
        with np.load(path) as state:
            found.append(int(state["x"].shape[1]))
    return max(found)
