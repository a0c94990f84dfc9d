"""Studies that are killed, and begun again by the same command: only what is missing is run, to the same files."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym import store
from softcat_sym.results.files import trajectory_form
from softcat_sym.simulate import identity_of, recalled
from tests.inverse.filmed import CHEAP, write_film

SETS = [word for change in CHEAP for word in ("--set", change)]
QUICK = ["--set", "numerics.cells=6", "--set", "run.frames=21"]
BODY = ["--density", "1000 kg/m^3", "--span", "10 cm", "--diameter", "1 mm", "--duration", "1 s"]
OIL = ["--law", "newtonian", "--viscosity", "1 MPa*s", "--sag", "0.1 mm"]
FREE = ["--free", "yield_stress", "--free", "viscosity", "--starts", "0"]
COMMANDS = {
    "sweep": ["sweep", "arrested-overdamped", "--vary", "groups.G=0.1:0.5:25", "--workers", "1", *QUICK],
    "phase": ["phase", "--plane", "G-V", "--resolution", "4", "--workers", "1", *QUICK],
    "fit": ["fit", "FILM", "--scene", "continual-descent", *SETS, *FREE],
    "card": ["card", *BODY, *OIL, *QUICK],
}
FILES = {
    "sweep": ("sweep.csv", "scene.toml"),
    "phase": ("phase_runs.csv", "phase_boundaries.csv"),
    "fit": ("fit.csv", "fit.png", "scene.toml"),
    "card": ("card.csv", "card.png", "scene.toml"),
}
TIMED = ("wall_s", "seconds", "processor_s")

# Kills itself, as nothing can be told about, before a result of that number would be kept; counts what it keeps.
KILLED = """
import os, signal, sys
from softcat_sym import store
from softcat_sym.cli import main
keep, kept, at = store.keep, [], int(os.environ["KILLED_AT"])
def keeping(key, content):
    if len(kept) == at:
        os.kill(os.getpid(), signal.SIGKILL)
    kept.append(key)
    open(os.environ["COUNTED"], "a").write(key + "\\n")
    keep(key, content)
store.keep = keeping
import softcat_sym.studies.phase_runs
softcat_sym.studies.phase_runs.keep = keeping
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


@pytest.mark.slow
@pytest.mark.parametrize("study", list(COMMANDS))
def test_what_was_killed_half_way_goes_on(study: str, tmp_path: Path) -> None:
    words = [str(write_film(tmp_path / "film.csv")) if word == "FILM" else word for word in COMMANDS[study]]
    status, keys = command(words, tmp_path / "whole", tmp_path / "a", -1)
    assert status == 0 and len(keys) == len(set(keys)) > 2
    half = len(keys) // 2
    broken = tmp_path / "broken"
    assert command(words, broken, tmp_path / "b", half) == (-signal.SIGKILL, keys[:half])
    assert not broken.exists() or not list(broken.iterdir())
    assert command(words, broken, tmp_path / "b", -1) == (0, keys[half:])
    assert command(words, broken, tmp_path / "b", -1) == (0, [])
    assert set(command([*words, "--fresh"], broken, tmp_path / "b", -1)[1]) == set(keys)
    for name in FILES[study]:
        if name.endswith(".csv"):
            assert numbers(broken / name) == numbers(tmp_path / "whole" / name)
        else:
            assert (broken / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()


def test_a_run_is_recalled_to_the_last_bit_under_any_title(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = sc.load_scene("cold-honey", ["numerics.cells=4", "run.frames=4", "run.duration=0.02 s"])
    first = recalled(scene)
    monkeypatch.setattr(sys.modules["softcat_sym.simulate"], "_with_all_that_matters", None)
    again = recalled(scene.replace({"title": "another"}))
    assert again.summary == first.summary | {"title": "another"}
    assert (again.data.attrs["title"], again.scene.title) == ("another", "another")
    assert again.data.identical(first.data.assign_attrs(again.data.attrs))
    assert trajectory_form(scene).write(first) == trajectory_form(scene).write(recalled(scene))
    with store.fresh(), pytest.raises(TypeError):
        recalled(scene)


def test_what_decides_a_run_decides_its_key() -> None:
    scene = sc.load_scene("cold-honey")
    keys = {store.key_of("run", identity_of(scene.replace(one))) for one in ({}, {"run.frames": 7}, {"title": "x"})}
    assert len(keys) == 2
    parts: tuple[object, ...] = (1, 1.5, "1", [1], b"1", np.ones(1), np.ones(1, int), np.ones((1, 1)), None)
    assert len({store.key_of("run", part) for part in parts}) == len(parts)
    assert store.key_of("run", 1) != store.key_of("sag", 1)
    with pytest.raises(TypeError, match="no part of a key: object"):
        store.key_of("run", object())


def test_what_is_harmed_or_in_another_place_is_not_there(results_of_studies: Path) -> None:
    key, other = store.key_of("one"), store.key_of("other")
    assert store.recall(key) is None
    store.keep(key, b"content" * 100)
    assert store.recall(key) == b"content" * 100
    path = results_of_studies / key
    path.rename(results_of_studies / other)
    assert store.recall(other) is None
    store.keep(key, b"content")
    for content in (b"", path.read_bytes()[:-1], bytes(100)):
        path.write_bytes(content)
        assert store.recall(key) is None
    assert store.clear() > 0 and store.entries() == []


def test_the_limit_is_kept(results_of_studies: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(store, "LIMIT", 100)
    for number in range(5):
        store.keep(f"ff{number}", b"content")
        os.utime(results_of_studies / f"ff{number}", (number, number))
    store.keep("00", b"content")
    left = {path.name for path, _ in store.entries()}
    assert "00" in left and "ff4" in left and "ff0" not in left


def test_a_full_disk_ends_no_study(results_of_studies: Path) -> None:
    results_of_studies.write_text("no folder")
    store.keep("00", b"content")
    assert store.recall("00") is None
    results_of_studies.unlink()


def test_numbers_that_json_does_not_know_come_back() -> None:
    form = store.json_form(list, list)
    found = form.read(form.write([float("inf"), 0.1, None]))
    assert json.dumps(found) == json.dumps([float("inf"), 0.1, None])
