"""Two things at once: both are done at the end, and neither outlives the other's fault."""

from __future__ import annotations

import threading
import time
from pathlib import Path

import pytest

from softcat_sym.codegen.compiler import beside
from softcat_sym.codegen.library import compile_library
from softcat_sym.errors import SoftcatError

from .compilers import ANSWER, left_in
from .test_process import gone, hang, read_pids


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def test_they_run_at_the_same_time() -> None:
    meeting = threading.Barrier(2, timeout=30)
    with beside(meeting.wait):
        meeting.wait()


def test_what_it_raises_is_raised_at_the_end_of_the_block() -> None:
    done = []

    def refused() -> None:
        raise SoftcatError("refused")

    with pytest.raises(SoftcatError, match="refused"), beside(refused):
        done.append(True)
    assert done


@pytest.mark.parametrize("fault", [KeyboardInterrupt, ValueError])
def test_a_fault_of_the_block_ends_the_compiler(
    fault: type[BaseException], cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pids = hang(tmp_path, monkeypatch)
    threads = threading.active_count()
    with pytest.raises(fault), beside(lambda: compile_library(ANSWER)):
        read_pids(pids)
        raise fault
    assert gone(read_pids(pids))
    assert left_in(cache / "native") == []
    assert threading.active_count() == threads


def test_a_compiler_that_starts_after_the_fault_is_ended_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    hang(tmp_path, monkeypatch)
    failed, began = threading.Event(), time.monotonic()

    def late() -> None:
        failed.wait(30)
        compile_library(ANSWER)

    with pytest.raises(ValueError, match="a fault"), beside(late):
        threading.Timer(0.1, failed.set).start()
        raise ValueError("a fault")
    assert time.monotonic() - began < 100, "it sleeps for 300 s"
