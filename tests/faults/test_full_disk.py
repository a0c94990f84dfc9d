"""Disks that are full or only read: one clear line, exit status 2, old files as they were, nothing half-written."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import numpy as np
import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically, made, replace_atomically, write_all, written_together
from softcat_sym.reference.element_loop import write_checkpoint
from tests.cli.in_process import Softcat, sets

from .tiny_disk import files_in, remount, tiny_disk

SCENE = "arrested-overdamped"
QUICK = sets("numerics.cells=10", "run.frames=21", "numerics.estimate=false", "numerics.backend=interpreted")


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def test_what_is_written_together_is_there_together_or_not_at_all(tmp_path: Path) -> None:
    old, new = tmp_path / "old", tmp_path / "new"
    old.write_bytes(b"old")

    def full(_: Path) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with pytest.raises(OSError, match=r"No space left on device: .*third") as raised, written_together():
        replace_atomically(old, b"new")
        replace_atomically(new, b"new")
        assert old.read_bytes() == b"old", "not before all is written"
        fill_atomically(tmp_path / "third", full)
    assert raised.value.filename == str(tmp_path / "third")
    assert files_in(tmp_path) == {"old": b"old"}
    write_all(tmp_path, {"old": b"new", "new": b"newer"})
    assert files_in(tmp_path) == {"old": b"new", "new": b"newer"}


def test_a_place_that_is_a_folder_stops_all_of_them(tmp_path: Path) -> None:
    (tmp_path / "b").mkdir()
    with pytest.raises(IsADirectoryError):
        write_all(tmp_path, {"a": b"1", "b": b"2"})
    assert files_in(tmp_path) == {}


def test_a_folder_into_which_nothing_came_goes_again(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), made(tmp_path / "deep" / "er"):
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(KeyboardInterrupt), made(tmp_path):
        raise KeyboardInterrupt
    assert tmp_path.is_dir(), "what was there stays"


def test_a_run_on_a_full_disk_says_so_and_leaves_the_old_files(softcat: Softcat, tmp_path: Path) -> None:
    with tiny_disk(tmp_path / "disk", 1000) as disk:
        output = disk / "out"
        assert softcat("run", SCENE, "-o", str(output), "-q", *QUICK).status == 0
        before = files_in(disk)
        for room in (4, 128):
            (disk / "fill").write_bytes(b"")
            space = os.statvfs(disk)
            (disk / "fill").write_bytes(bytes(space.f_bavail * space.f_frsize - 1000 * room))
            done = softcat("run", SCENE, "-o", str(output), "-q", *QUICK)
            assert (done.status, done.out) == (2, "")
            assert done.err == f"softcat: cannot write the results: No space left on device ({output})\n"
            (disk / "fill").unlink()
            assert files_in(disk) == before


@pytest.mark.parametrize("room", [0, 60])
def test_c_on_a_full_disk_is_not_half_a_product(softcat: Softcat, tmp_path: Path, room: int) -> None:
    with tiny_disk(tmp_path / "disk", 100) as disk:
        (disk / "fill").write_bytes(bytes(1000 * (100 - room)))
        done = softcat("generate", SCENE, "-o", str(disk / "out"), "-q", *QUICK[:2])
        assert (done.status, done.out) == (2, "")
        assert done.err.startswith("softcat: cannot write the results: No space left on device")
        assert [path.name for path in disk.iterdir()] == ["fill"]


def test_a_disk_that_is_only_read_is_refused_before_the_run(softcat: Softcat, tmp_path: Path) -> None:
    """Root may write wherever it likes, except where nobody may."""
    with tiny_disk(tmp_path / "disk", 100) as disk:
        remount(disk, "ro")
        for command in ("run", "generate"):
            done = softcat(command, SCENE, "-o", str(disk / "out"), "-q", *QUICK[:2])
            assert (done.status, done.err) == (2, f"softcat: cannot write the results: {disk} cannot be written\n")


def test_the_checkpoint_of_elements_is_whole_or_the_old_one(tmp_path: Path) -> None:
    with tiny_disk(tmp_path / "disk", 40) as disk:
        path = disk / "elements.npz"
        write_checkpoint(path, "key", {"x": np.zeros(100)})
        before = files_in(disk)
        with pytest.raises(SoftcatError, match=r"cannot write the checkpoint .*No space left on device"):
            write_checkpoint(path, "key", {"x": np.zeros(10_000)})
        assert files_in(disk) == before
