"""Integrations that are interrupted go on from their checkpoints, to the answer of those that are not."""

from __future__ import annotations

import errno
import os
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.single_run import build
from softcat_sym.solvers import checkpoint, compiled
from softcat_sym.solvers.checkpoint import Checkpoints, Resumable
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Reached, Silence, Solution, at_start

RTOL = 1e-7
SMALL = {"numerics.cells": 24, "numerics.rtol": RTOL, "run.frames": 81, "numerics.estimate": False}
pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")


def prepared(name: str, changes: Mapping[str, object]) -> Prepared:
    scene = sc.load_scene(name, {**SMALL, **changes})
    return build(scene, choose_effects(scene))


class Interrupting(Silence):
    """Presses Ctrl-C once a time is reached [s]."""

    def __init__(self, at: float) -> None:
        self._at = at

    def update(self, simulated_time: float, step_size: float | None) -> None:
        del step_size
        if simulated_time >= self._at:
            raise KeyboardInterrupt


@pytest.fixture(autouse=True)
def looks_often(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "_LOOK", 0.001)


def interrupted(run: Prepared, folder: Path, share: float, *, resume: bool) -> int:
    """Begin a run, or go on with it, and interrupt it; frames that are kept then."""
    states = Checkpoints(folder, b"owner", resume=resume, every=0.0)
    at = share * float(run.times[-1]) * run.scale
    with pytest.raises(KeyboardInterrupt):
        run.solve(Resumable(Interrupting(at), states))
    assert states.kept
    (file,) = folder.glob("*.npz")
    with np.load(file) as kept:
        return int(kept["x"].shape[1])


def resumed(run: Prepared, folder: Path, owner: bytes = b"owner") -> tuple[Solution, int]:
    """Let a run go on to its end; the answer, and whether it went on from somewhere."""
    states = Checkpoints(folder, owner, resume=True, every=1e9)
    return run.solve(Resumable(Silence(), states)), states.resumed


SLOW = pytest.mark.slow


@pytest.mark.parametrize(
    ("name", "backend"),
    [
        ("continual-descent", "compiled"),
        ("continual-descent", "interpreted"),
        ("drawn-blob", "compiled"),
        pytest.param("drawn-blob", "interpreted", marks=SLOW),
        pytest.param("polyethylene-melt", "compiled", marks=SLOW),
        pytest.param("polyethylene-melt", "interpreted", marks=SLOW),
    ],
)
def test_interrupted_twice_it_comes_to_the_same_answer(name: str, backend: str, tmp_path: Path) -> None:
    solver = {} if backend == "compiled" else {"numerics.solver": "rosenbrock", "numerics.cells": 12}
    run = prepared(name, {"numerics.backend": backend, **solver})
    whole = run.solve(Silence())
    first = interrupted(run, tmp_path, 0.2, resume=False)
    second = interrupted(run, tmp_path, 0.6, resume=True)
    assert 1 < first < second < run.times.size
    found, times = resumed(run, tmp_path)
    assert times == 1
    assert found.outcome is whole.outcome
    np.testing.assert_array_equal(found.time, whole.time)
    for got, wanted in ((found.x, whole.x), (found.z, whole.z), (found.quad, whole.quad)):
        if wanted.size and np.any(wanted):
            # Ten times the tolerance of a step: both runs err by a few of them.
            assert np.max(np.abs(got - wanted)) < 10 * RTOL * np.max(np.abs(wanted))


def test_no_state_ends_on_a_kink() -> None:
    """There algebraic unknowns are those of before it, from which nothing can go on."""
    times, kinks = np.array([0.0, 1.0, 2.0, 3.0]), np.array([0.5, 2.0])
    run = SimpleNamespace(times=times, kinks=kinks)
    room = SimpleNamespace(states=np.zeros((4, 1, 2)), work=np.zeros((4, 3)), status=SimpleNamespace(steps=9))
    sites = SimpleNamespace(vectors=lambda states: (states[:, :, 0].T, states[:, :, 1].T))
    known = at_start(np.zeros(1), np.zeros(1))
    under_way = compiled._UnderWay(SimpleNamespace(sites=sites), run, room, known)  # type: ignore[arg-type]
    assert [under_way.reached(time).frames for time in (0.0, 1.0, 1.9, 2.0, 2.5, 3.0)] == [1, 2, 2, 3, 3, 4]
    assert [under_way.to_go_on_from(time).frames for time in (0.0, 1.0, 1.9, 2.0, 2.5, 3.0)] == [1, 2, 2, 2, 2, 4]


def test_a_finished_integration_is_not_repeated(tmp_path: Path) -> None:
    run = prepared("continual-descent", {})
    whole = run.solve(Resumable(Silence(), Checkpoints(tmp_path, b"owner", every=0.0)))

    class Deaf(Silence):
        def update(self, simulated_time: float, step_size: float | None) -> None:
            raise AssertionError("it integrates")

    again = run.solve(Resumable(Deaf(), Checkpoints(tmp_path, b"owner", resume=True)))
    for name in ("time", "x", "z", "quad", "steps", "outcome"):
        np.testing.assert_array_equal(getattr(again, name), getattr(whole, name))


@pytest.mark.parametrize(
    "change",
    [
        {"numerics.cells": 25},
        {"numerics.rtol": 2 * RTOL},
        {"run.frames": 82},
        {"material.viscosity": "301 Pa*s"},
        {"run.effects": "paper"},
    ],
    ids=lambda change: next(iter(change)),
)
def test_no_state_is_taken_for_that_of_another_integration(change: dict[str, object], tmp_path: Path) -> None:
    interrupted(prepared("continual-descent", {}), tmp_path, 0.5, resume=False)
    assert resumed(prepared("continual-descent", {}), tmp_path)[1] == 1
    other = prepared("continual-descent", change)
    found, times = resumed(other, tmp_path)
    assert times == 0
    np.testing.assert_array_equal(found.x, other.solve(Silence()).x)


def test_without_being_asked_it_begins_anew(tmp_path: Path) -> None:
    run = prepared("continual-descent", {})
    interrupted(run, tmp_path, 0.5, resume=False)
    states = Checkpoints(tmp_path, b"owner")
    found = run.solve(Resumable(Silence(), states))
    assert states.resumed == 0
    np.testing.assert_array_equal(found.x, run.solve(Silence()).x)


def test_the_folder_of_another_run_is_refused(tmp_path: Path) -> None:
    run = prepared("continual-descent", {})
    interrupted(run, tmp_path, 0.5, resume=False)
    with pytest.raises(SoftcatError, match="another scene or version of this program; leave out --resume"):
        Checkpoints(tmp_path, b"someone else", resume=True)


@pytest.mark.parametrize("damage", ["cut", "text", "empty", "another's"])
def test_a_damaged_state_is_named(damage: str, tmp_path: Path) -> None:
    run = prepared("continual-descent", {})
    interrupted(run, tmp_path, 0.5, resume=False)
    (file,) = tmp_path.glob("*.npz")
    content = file.read_bytes()
    if damage == "another's":
        np.savez(file, key=np.array("other"), x=np.zeros((1, 2)))
    else:
        file.write_bytes({"cut": content[: len(content) // 2], "text": b"nonsense", "empty": b""}[damage])
    with pytest.raises(SoftcatError, match=rf"{file.name} is no checkpoint .*delete it, or leave out --resume"):
        resumed(run, tmp_path)


def test_a_short_run_keeps_nothing_and_hashes_nothing(tmp_path: Path) -> None:
    def identity() -> list[bytes]:
        raise AssertionError("nobody is to ask")

    folder = tmp_path / "states"
    place = Checkpoints(folder, b"owner").of(identity)
    for say in (place.offer, place.leave, place.finish):
        say(lambda: pytest.fail("nobody is to gather frames"))
    assert not folder.exists()


def test_a_full_disk_is_told_and_does_not_end_the_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(checkpoint, "fill_atomically", full)
    states = Checkpoints(tmp_path / "states", b"owner", every=0.0)
    found = prepared("continual-descent", {}).solve(Resumable(Silence(), states))
    assert found.outcome.is_success
    assert not states.kept
    assert "No space left on device" in states.trouble
    assert list(tmp_path.iterdir()) == []


def test_it_clears_only_what_is_its_own(tmp_path: Path) -> None:
    states = Checkpoints(tmp_path / "states", b"owner")
    states.clear()
    states.keep(lambda: [b"key"], Reached(np.zeros((2, 3)), np.zeros((0, 3)), np.zeros((3, 3)), 7))
    assert len(list((tmp_path / "states").iterdir())) == 1
    states.clear()
    assert not (tmp_path / "states").exists()
    states.keep(lambda: [b"key"], Reached(np.zeros((2, 3)), np.zeros((0, 3)), np.zeros((3, 3)), 7))
    (tmp_path / "states" / "mine.txt").write_text("mine")
    states.clear()
    assert [path.name for path in (tmp_path / "states").iterdir()] == ["mine.txt"]
