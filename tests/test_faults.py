"""Signals and full disks: a command ends with one line and its own status, no child and no half file left behind."""

from __future__ import annotations

import errno
import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from softcat_sym import cache, store
from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically, new_folder, replace_atomically, write_results, written_together
from softcat_sym.interrupts import ended_like_ctrl_c, interrupts_go_to
from softcat_sym.reference.element_loop import write_checkpoint
from softcat_sym.solvers.compiled import CModel
from tests.common.commands import ended, hanging, is_gone, until
from tests.common.commands import softcat as started
from tests.common.in_process import Softcat, sets
from tests.common.tiny_disk import files_in, remount, tiny_disk

SHORT = ("--set", "groups.duration=10", "--set", "run.frames=11", "--set", "numerics.cells=10", "--mesh", "6x2")


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


def test_a_signal_that_is_ignored_or_handled_in_another_way_stays_so() -> None:
    heard: list[int] = []
    for handler in (signal.SIG_IGN, lambda number, _: heard.append(number)):
        before = signal.signal(signal.SIGTERM, handler)
        try:
            with ended_like_ctrl_c() as ending:
                signal.raise_signal(signal.SIGTERM)
            assert ending.number is None
        finally:
            signal.signal(signal.SIGTERM, before)
    assert heard == [signal.SIGTERM]


def test_whoever_puts_ctrl_c_off_puts_sigterm_off() -> None:
    heard: list[int] = []
    with ended_like_ctrl_c(), interrupts_go_to(lambda number, _: heard.append(number)):
        signal.raise_signal(signal.SIGTERM)
    assert heard == [signal.SIGINT]


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


IGNORING = """
import signal, softcat_sym.cli, softcat_sym.simulate
from softcat_sym.interrupts import ended_like_ctrl_c
assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
signal.signal(signal.SIGINT, signal.SIG_IGN)
with ended_like_ctrl_c() as ending:
    signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    try:
        signal.raise_signal(signal.SIGTERM)
    except KeyboardInterrupt:
        print(ending.status)
assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
"""


def test_where_ctrl_c_is_ignored_it_stays_so_and_the_library_installs_nothing() -> None:
    done = subprocess.run([sys.executable, "-c", IGNORING], capture_output=True, text=True, check=True)
    assert done.stdout == "143\n"


@pytest.mark.parametrize("ignoring", [False, True], ids=["foreground", "background"])
@pytest.mark.slow
def test_sigterm_ends_calculix_and_removes_its_folder(
    ignoring: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    note = hanging(tmp_path / "bin" / "ccx")
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}")
    output = tmp_path / "out"
    asked = ("compare", "continual-descent", "-o", str(output), "--engine", "calculix", "-q", *SHORT)
    with started(*asked, ignoring=ignoring) as process:
        until(note.exists, process)
        assert not is_gone(note, 0.0)
        said = "softcat: interrupted; the same command resumes from what was finished\n"
        assert ended(process, signal.SIGTERM) == (143, "", said)
    assert is_gone(note)
    assert not output.exists()


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


def test_a_folder_into_which_nothing_came_goes_again(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), new_folder(tmp_path / "deep" / "er"):
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(KeyboardInterrupt), new_folder(tmp_path):
        raise KeyboardInterrupt
    assert tmp_path.is_dir(), "what was there stays"


@pytest.mark.slow
def test_a_run_on_a_full_disk_says_so_and_leaves_the_old_files(softcat: Softcat, tmp_path: Path) -> None:
    with tiny_disk(tmp_path / "disk", 1000) as disk:
        output = disk / "out"
        assert softcat("run", SCENE, "-o", str(output), "-q", *QUICK).status == 0
        before = files_in(disk)
        for room in (4, 64):
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


@pytest.mark.parametrize(
    "words", [("run",), ("sweep", "--vary", "filament.span=4:5 mm:3"), ("card",)], ids=lambda w: w[0]
)
def test_a_full_cache_ends_every_command_with_its_reason(
    softcat: Softcat, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, words: tuple[str, ...]
) -> None:
    """It is no failure of a member: the first that finds no room ends all."""
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "library.so")

    monkeypatch.setattr("softcat_sym.codegen.library._build", full)
    place = tmp_path / "cache" / "native"
    done = softcat(words[0], "ink-bridge", *words[1:], *QUICK[:2], "-q", "-o", str(tmp_path / "out"))
    assert (done.status, done.out, (tmp_path / "out").exists()) == (2, "", False)
    assert done.err == (
        f"softcat: cannot write the cache of compiled libraries in {place}: No space left on device; "
        "free some space, or set SOFTCAT_CACHE to a folder elsewhere\n"
    )


def test_a_disk_that_is_only_read_is_refused_before_the_run(softcat: Softcat, tmp_path: Path) -> None:
    """Root may write wherever it likes, except where nobody may."""
    with tiny_disk(tmp_path / "disk", 100) as disk:
        remount(disk, "ro")
        for command in ("run", "generate"):
            done = softcat(command, SCENE, "-o", str(disk / "out"), "-q", *QUICK[:2])
            assert (done.status, done.err) == (2, f"softcat: cannot write the results: {disk} cannot be written\n")


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # older NumPy leaves the archive open
def test_the_checkpoint_of_elements_is_whole_or_the_old_one(tmp_path: Path) -> None:
    with tiny_disk(tmp_path / "disk", 40) as disk:
        path = disk / "elements.npz"
        write_checkpoint(path, "key", {"x": np.zeros(100)})
        before = files_in(disk)
        with pytest.raises(SoftcatError, match=r"cannot write the checkpoint .*No space left on device"):
            write_checkpoint(path, "key", {"x": np.zeros(10_000)})
        assert files_in(disk) == before
