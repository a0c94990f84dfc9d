"""A compiler that hangs is stopped with all it started; killed processes leave nothing that is taken for a library."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from softcat_sym.codegen import compiler as asking
from softcat_sym.codegen import library
from softcat_sym.codegen.library import cache_entries, clear_cache, compile_library, load
from softcat_sym.errors import SoftcatError

from .compilers import ANSWER, COMPILE, compiler, left_in


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def hang(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A compiler whose pass hangs; the file will hold the process ids of driver and pass."""
    pids = tmp_path / "pids"
    compiler(tmp_path, monkeypatch, f"echo half > library.so; sleep 300 & echo $$ $! > {pids}; wait")
    return pids


def read_pids(path: Path) -> list[int]:
    for _ in range(400):
        if path.exists() and path.read_text().endswith("\n"):
            return [int(word) for word in path.read_text().split()]
        time.sleep(0.05)
    raise AssertionError("the compiler was not called")


def running(pid: int) -> bool:
    """Whether a process runs: one that is dead but not yet reaped does not."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    state = Path(f"/proc/{pid}/stat")
    return not state.exists() or state.read_text().rsplit(")", 1)[1].split()[0] != "Z"


def gone(pids: list[int]) -> bool:
    for _ in range(100):
        if not any(map(running, pids)):
            return True
        time.sleep(0.05)
    return False


def test_a_compiler_that_hangs_is_stopped_with_its_passes(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pids = hang(tmp_path, monkeypatch)
    monkeypatch.setattr(library, "_PATIENCE", 0.5)
    with pytest.raises(SoftcatError, match="did not finish within"):
        compile_library(ANSWER)
    assert gone(read_pids(pids))
    assert left_in(cache / "native") == []


def test_an_interrupt_stops_the_compiler_and_leaves_nothing(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = hang(tmp_path, monkeypatch)
    process = subprocess.Popen([sys.executable, "-c", COMPILE], stderr=subprocess.PIPE, text=True)
    pids = read_pids(path)
    process.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in process.communicate(timeout=30)[1]
    assert gone(pids)
    assert left_in(cache / "native") == []


def test_a_killed_process_leaves_nothing_that_is_taken_for_a_library(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = hang(tmp_path, monkeypatch)
    process = subprocess.Popen([sys.executable, "-c", COMPILE])
    driver, hanging = read_pids(path)
    (leftover,) = left_in(cache / "native")
    clear_cache()
    assert left_in(cache / "native") == [leftover], "what is under way is let alone"
    process.kill()
    process.wait(timeout=30)
    os.killpg(driver, signal.SIGKILL)
    assert gone([driver, hanging])
    assert cache_entries() == ()
    monkeypatch.delenv("CC")
    assert load(compile_library(ANSWER)).answer() == 42
    assert len(cache_entries()) == 1
    assert leftover in left_in(cache / "native")
    clear_cache()
    assert not list((cache / "native").iterdir())


def test_an_interrupt_while_the_compiler_starts_is_not_lost_and_stops_it(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pids = hang(tmp_path, monkeypatch)
    start = subprocess.Popen.__init__

    def interrupted(self: subprocess.Popen[str], *arguments: object, **options: object) -> None:
        start(self, *arguments, **options)  # type: ignore[call-overload]
        if "-shared" in str(arguments):
            read_pids(pids)
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.1)

    monkeypatch.setattr(subprocess.Popen, "__init__", interrupted)
    with pytest.raises(KeyboardInterrupt):
        compile_library(ANSWER)
    assert gone(read_pids(pids))
    assert left_in(cache / "native") == []


def test_a_compiler_that_hangs_when_asked_who_it_is_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    script = tmp_path / "cc"
    script.write_text("#!/bin/sh\nsleep 300\n")
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    monkeypatch.setattr(asking, "_PATIENCE", 0.3)
    with pytest.raises(SoftcatError, match="no C compiler that runs"):
        compile_library(ANSWER)
