"""Studies that are killed, and begun again by the same command: only what is missing is run, to the same files."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.common.filmed import CHEAP, write_film

pytestmark = pytest.mark.slow

SETS = [word for change in CHEAP for word in ("--set", change)]
QUICK = ["--set", "numerics.cells=6", "--set", "run.frames=21"]
FREE = ["--free", "yield_stress", "--free", "viscosity", "--starts", "0"]
COMMANDS = {
    "sweep": ["sweep", "arrested-overdamped", "--vary", "groups.G=0.1:0.5:25", "--workers", "1", *QUICK],
    "fit": ["fit", "FILM", "--scene", "continual-descent", *SETS, *FREE],
}
FILES = {
    "sweep": ("sweep.csv", "scene.toml"),
    "fit": ("fit.csv", "fit.png", "scene.toml"),
}
TIMED = ("wall_s", "seconds", "processor_s")

# Kills itself, as nothing can be told about, before a result of that number would be kept; counts what it keeps.
KILLED = """
import os, signal, sys
from softcat_sym import store
from softcat_sym.cli import main
keep, kept, at = store.keep, [], int(os.environ["KILLED_AT"])
def keeping(key, content, kind="results"):
    if kind != "results":
        return keep(key, content, kind)
    if len(kept) == at:
        os.kill(os.getpid(), signal.SIGKILL)
    kept.append(key)
    open(os.environ["COUNTED"], "a").write(key + "\\n")
    keep(key, content)
store.keep = keeping
sys.argv[0] = "softcat"
main()
"""


def command(words: list[str], output: Path, cache: Path, at: int) -> tuple[int, list[str]]:
    """Exit status of a command that is killed at a result, and the keys of the results that it kept."""
    counted = output.with_suffix(".keys")
    counted.write_text("")
    environment = {**os.environ, "SOFTCAT_CACHE": str(cache), "KILLED_AT": str(at), "COUNTED": str(counted)}
    given = [sys.executable, "-c", KILLED, *words, "-q", "-o", str(output)]
    done = subprocess.run(given, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode in (0, -signal.SIGKILL), done.stderr
    return done.returncode, counted.read_text().split()


def numbers(path: Path) -> Any:
    """A table without what no two runs share: wall times."""
    lines = [line.split(",") for line in path.read_text().splitlines()]
    kept = [k for k, name in enumerate(lines[0]) if name not in TIMED]
    return [[line[k] for k in kept] for line in lines]


@pytest.mark.parametrize("study", COMMANDS)
def test_what_was_killed_half_way_goes_on(study: str, tmp_path: Path) -> None:
    words = [str(write_film(tmp_path / "film.csv")) if word == "FILM" else word for word in COMMANDS[study]]
    status, keys = command(words, tmp_path / "whole", tmp_path / "a", -1)
    assert status == 0 and len(keys) == len(set(keys)) > 2
    half = len(keys) // 2
    broken = tmp_path / "broken"
    status, before = command(words, broken, tmp_path / "b", half)
    # Threads finish in any order.
    assert status == -signal.SIGKILL and len(before) == half and set(before) < set(keys)
    assert not broken.exists() or not list(broken.iterdir())
    status, after = command(words, broken, tmp_path / "b", -1)
    assert status == 0 and set(keys) - set(before) <= set(after) < set(keys)
    assert command(words, broken, tmp_path / "b", -1) == (0, [])
    assert set(command([*words, "--fresh"], broken, tmp_path / "b", -1)[1]) == set(keys)
    for name in FILES[study]:
        if name.endswith(".csv"):
            assert numbers(broken / name) == numbers(tmp_path / "whole" / name)
        else:
            assert (broken / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()
