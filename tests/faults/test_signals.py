"""SIGTERM ends a command as Ctrl-C does: one line, its own status, no child and no file left behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.library import recall
from softcat_sym.interrupts import ended_like_ctrl_c, interrupts_go_to
from softcat_sym.solvers.compiled import CModel

from .commands import ended, hanging, is_gone, softcat, until
from .tiny_disk import files_in

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


def test_a_signal_that_is_ignored_stays_so() -> None:
    found = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with ended_like_ctrl_c() as ending:
            signal.raise_signal(signal.SIGHUP)
        assert ending.number is None
    finally:
        signal.signal(signal.SIGHUP, found)


def test_whoever_puts_ctrl_c_off_puts_sigterm_off() -> None:
    heard: list[int] = []
    with ended_like_ctrl_c(), interrupts_go_to(lambda number, _: heard.append(number)):
        signal.raise_signal(signal.SIGTERM)
    assert heard == [signal.SIGINT]


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
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


def test_a_signal_handled_in_another_way_stays_so() -> None:
    heard: list[int] = []
    before = signal.signal(signal.SIGTERM, lambda number, _: heard.append(number))
    try:
        with ended_like_ctrl_c() as ending:
            signal.raise_signal(signal.SIGTERM)
        assert (heard, ending.number) == ([signal.SIGTERM], None)
    finally:
        signal.signal(signal.SIGTERM, before)


def test_outside_the_main_thread_nothing_is_installed() -> None:
    seen: list[object] = []

    def work() -> None:
        with ended_like_ctrl_c():
            seen.append(signal.getsignal(signal.SIGTERM))

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert seen == [signal.SIG_DFL]


def test_the_library_installs_nothing() -> None:
    code = "import signal, softcat_sym.cli, softcat_sym.simulate\nprint(signal.getsignal(signal.SIGTERM).name)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "SIG_DFL\n"


IGNORING = """
import os, signal
from softcat_sym.interrupts import ended_like_ctrl_c
signal.signal(signal.SIGINT, signal.SIG_IGN)
with ended_like_ctrl_c() as ending:
    signal.raise_signal(signal.SIGINT)
    print("not heard")
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    try:
        signal.raise_signal(signal.SIGTERM)
    except KeyboardInterrupt:
        print(ending.status)
assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
"""


def test_where_ctrl_c_is_ignored_it_stays_so_and_sigterm_is_heard() -> None:
    done = subprocess.run([sys.executable, "-c", IGNORING], capture_output=True, text=True, check=True)
    assert done.stdout == "not heard\n143\n"


@pytest.mark.parametrize("ignoring", [False, True], ids=["foreground", "background"])
def test_sigterm_ends_calculix_and_removes_its_folder(
    ignoring: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    note = hanging(tmp_path / "bin" / "ccx")
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}")
    output = tmp_path / "out"
    asked = ("compare", "continual-descent", "-o", str(output), "--engine", "calculix", *SHORT)
    with softcat(*asked, ignoring=ignoring) as process:
        until(note.exists, process)
        assert not is_gone(note, 0.0)
        said = "softcat: interrupted; the same command goes on from what was finished\n"
        assert ended(process, signal.SIGTERM) == (143, "", said)
    assert is_gone(note)
    assert not output.exists()


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("compiling", ["the runtime", "the model"])
def test_sigterm_ends_the_compiler_and_removes_its_folder(
    compiling: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The runtime is compiled beside the writing of the model, so that this may or may not be done with by then.
    when = "'filament.c' in sys.argv" if compiling == "the model" else "'-shared' in sys.argv"
    note = hanging(tmp_path / "cc", when)
    monkeypatch.setenv("CC", str(tmp_path / "cc"))
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    with softcat("run", "arrested-overdamped", "-o", str(tmp_path / "out")) as process:
        until(note.exists, process)
        assert ended(process, signal.SIGTERM) == (143, "", "softcat: interrupted; nothing was written\n")
    assert is_gone(note)
    kept = [Path(name) for name in files_in(tmp_path / "cache") if not name.endswith("compilers.json")]
    texts = [path for path in kept if path.parent.name == "texts" and path.suffix == ".text"]
    assert kept == texts
    assert len(texts) == 1 if compiling == "the model" else len(texts) <= 1
    assert all(recall(path.stem) is not None for path in texts)  # only what is whole is recalled
    assert not (tmp_path / "out").exists()


def test_a_killed_calculix_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    note = hanging(tmp_path / "bin" / "ccx")
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}")
    asked = ("compare", "continual-descent", "-o", str(tmp_path / "out"), "--engine", "calculix", *SHORT)
    with softcat(*asked) as process:
        until(note.exists, process)
        os.kill(int(note.read_text().split()[0]), signal.SIGKILL)
        _, message = process.communicate(timeout=60)
    assert process.returncode == 2
    assert message.startswith("softcat: CalculiX gave up: killed by signal 9: Killed (after 0 s of simulated time)")
    assert message.count("\n") == 1
    assert is_gone(note)
    assert not (tmp_path / "out").exists()
