"""Signals and full disks: a command ends with one line and its own status, no child and no half file left behind."""

from __future__ import annotations

import errno
import os
import signal
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from softcat_sym import cache, store
from softcat_sym.files import fill_atomically, replace_atomically, write_results, written_together
from softcat_sym.interrupts import ended_like_ctrl_c
from softcat_sym.solvers.compiled import CModel
from tests.common.commands import ended, hanging, is_gone, until
from tests.common.commands import softcat as started
from tests.common.in_process import Softcat, sets
from tests.common.tiny_disk import files_in, remount, tiny_disk


@pytest.mark.parametrize(("number", "status"), [(signal.SIGTERM, 143), (signal.SIGHUP, 129), (signal.SIGINT, 130)])
def test_a_signal_is_heard_as_ctrl_c(number: signal.Signals, status: int) -> None:
    found = signal.getsignal(number)
    # As in a terminal: a session without one, or nohup, ignores SIGHUP, and so would all that begins in it.
    before = signal.default_int_handler if number is signal.SIGINT else signal.SIG_DFL
    signal.signal(number, before)
    try:
        with ended_like_ctrl_c() as ending:
            with pytest.raises(KeyboardInterrupt):
                signal.raise_signal(number)
            assert ending.status == status
        assert signal.getsignal(number) is before
    finally:
        signal.signal(number, found)


@pytest.mark.compiled
def test_what_casadi_swallows_is_heard_before_a_compiler_is_waited_for() -> None:
    def model() -> Any:
        with suppress(KeyboardInterrupt):  # as CasADi does while it looks at its arguments
            signal.raise_signal(signal.SIGINT)
        return SimpleNamespace(text="")

    found = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            CModel(model)
    finally:
        signal.signal(signal.SIGINT, found)


@pytest.mark.compiled
@pytest.mark.parametrize("compiling", ["the runtime", "the model"])
@pytest.mark.slow
def test_sigterm_ends_the_compiler_and_removes_its_folder(
    compiling: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The runtime is compiled beside the writing of the model, so that this may or may not be done with by then.
    when = "'filament.c' in sys.argv" if compiling == "the model" else "'-shared' in sys.argv"
    note = hanging(tmp_path / "cc", when)
    monkeypatch.setenv("CC", str(tmp_path / "cc"))
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    with started("run", "arrested-overdamped", "-q", "-o", str(tmp_path / "out")) as process:
        until(note.exists, process)
        assert ended(process, signal.SIGTERM) == (143, "", "softcat: interrupted; nothing was written\n")
    assert is_gone(note)
    kept = [Path(name) for name in files_in(tmp_path / "cache")]
    texts = [path for path in kept if path.parent.name == cache.TEXTS]
    assert kept == texts
    # One is what the compiler has said of itself.
    assert len(texts) == 2 if compiling == "the model" else len(texts) <= 2
    assert all(store.recall(path.name, cache.TEXTS) is not None for path in texts)  # only what is whole is recalled
    assert not (tmp_path / "out").exists()


SCENE = "arrested-overdamped"
QUICK = sets("numerics.cells=10", "run.frames=21", "numerics.estimate=false", "numerics.backend=interpreted")


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
    write_results(tmp_path, {"old": b"new", "new": b"newer"})
    assert files_in(tmp_path) == {"old": b"new", "new": b"newer"}
    (tmp_path / "b").mkdir()
    with pytest.raises(IsADirectoryError):
        write_results(tmp_path, {"a": b"1", "b": b"2"})
    assert not (tmp_path / "a").exists()
    with pytest.raises(OSError, match="No space"), written_together():
        write_results(tmp_path / "c" / "d", {"e": b"1"})
        fill_atomically(tmp_path / "third", full)
    assert not (tmp_path / "c").exists(), "nor are folders left in which nothing is"


def test_a_disk_that_is_only_read_is_refused_before_the_run(softcat: Softcat, tmp_path: Path) -> None:
    """Root may write wherever it likes, except where nobody may."""
    with tiny_disk(tmp_path / "disk", 100) as disk:
        remount(disk, "ro")
        for command in ("run", "generate"):
            done = softcat(command, SCENE, "-o", str(disk / "out"), "-q", *QUICK[:2])
            assert (done.status, done.err) == (2, f"softcat: cannot write the results: {disk} cannot be written\n")
