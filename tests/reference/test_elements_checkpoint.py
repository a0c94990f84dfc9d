"""Checkpoints: resumed runs are bit-identical, foreign and damaged files are refused, Ctrl-C leaves a good one."""

from __future__ import annotations

import signal
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.reference.element_loop import Clamp, Mesh
from softcat_sym.reference.elements import ElementRun, run_elements
from tests.reference.strips import shortened

SCENE = shortened(sc.load_scene("continual-descent"), 12.0, 4)
MESH = Mesh(16, 2)


class Stop:
    """Interrupts a run at its n-th report, as the terminal does."""

    def __init__(self, at: int) -> None:
        self.at, self.reports = at, 0

    def update(self, simulated_time: float, step_size: float | None) -> None:
        del simulated_time, step_size
        self.reports += 1
        if self.reports == self.at:
            signal.raise_signal(signal.SIGINT)


@pytest.fixture(scope="module")
def straight() -> ElementRun:
    return run_elements(SCENE, MESH)


def same(one: ElementRun, other: ElementRun) -> bool:
    """Bit for bit, but for the wall time."""
    names = [field.name for field in fields(one) if field.name != "wall"]
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in names)


@pytest.mark.parametrize("chunk", [200_000, 999])
def test_an_interrupted_run_resumes_to_the_same_bits(
    straight: ElementRun, tmp_path: Path, chunk: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("softcat_sym.reference.elements._CHUNK", chunk)
    path = tmp_path / "run.npz"
    for at in (1, 2, 5):
        with pytest.raises(KeyboardInterrupt):
            run_elements(SCENE, MESH, checkpoint=path, progress=Stop(at))
        assert [file.name for file in tmp_path.iterdir()] == ["run.npz"]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    resumed = run_elements(SCENE, MESH, checkpoint=path)
    assert same(resumed, straight)
    assert resumed.wall > 0


def test_checkpoints_are_written_as_the_run_goes_on(tmp_path: Path, straight: ElementRun) -> None:
    path, seen = tmp_path / "run.npz", []

    class Look:
        def update(self, simulated_time: float, step_size: float | None) -> None:
            del simulated_time, step_size
            seen.append(path.exists() and path.stat().st_mtime_ns)

    assert same(run_elements(SCENE, MESH, checkpoint=path, checkpoint_every=0.0, progress=Look()), straight)
    assert len({*seen}) > 3


def test_a_finished_run_is_read_at_once(tmp_path: Path, straight: ElementRun) -> None:
    path = tmp_path / "run.npz"
    first = run_elements(SCENE, MESH, checkpoint=path)
    written, never = path.read_bytes(), Stop(1)
    again = run_elements(SCENE, MESH, checkpoint=path, progress=never)
    assert never.reports == 0
    assert same(again, first) and same(again, straight)
    assert path.read_bytes() == written


def test_a_checkpoint_of_another_problem_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "run.npz"
    run_elements(SCENE, MESH, checkpoint=path)
    heavier = SCENE.replace({"load.gravity": "9.9 m/s^2"})
    with pytest.raises(SoftcatError, match="another problem"):
        run_elements(heavier, MESH, checkpoint=path)
    with pytest.raises(SoftcatError, match="another problem"):
        run_elements(SCENE, Mesh(16, 2, grading=2.0), checkpoint=path)
    with pytest.raises(SoftcatError, match="another problem"):
        run_elements(SCENE, MESH, clamp=Clamp.FIXED, checkpoint=path)
    with pytest.raises(SoftcatError, match="another problem"):
        run_elements(SCENE, MESH, step_factor=0.5, checkpoint=path)


@pytest.mark.parametrize("content", [b"", b"not an archive", None])
def test_a_damaged_checkpoint_is_refused(tmp_path: Path, content: bytes | None) -> None:
    path = tmp_path / "run.npz"
    run_elements(SCENE, MESH, checkpoint=path)
    path.write_bytes(path.read_bytes()[:-2000] if content is None else content)
    with pytest.raises(SoftcatError, match="no checkpoint of elements"):
        run_elements(SCENE, MESH, checkpoint=path)


def test_a_place_that_is_not_there_is_refused_before_the_run(tmp_path: Path) -> None:
    with pytest.raises(SoftcatError, match="no folder"):
        run_elements(SCENE, MESH, checkpoint=tmp_path / "missing" / "run.npz")
