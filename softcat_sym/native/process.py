"""Running a compiler: nothing of it outlives a time limit or Ctrl-C."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator, Sequence
from contextvars import ContextVar
from pathlib import Path
from types import FrameType

from softcat_sym.interrupts import interrupts_go_to


def run(command: Sequence[str], seconds: float, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run a command to its end, and take what it says.

    Parameters
    ----------
    command : sequence of str
        The executable and its arguments.
    seconds : float
        How long it may take.
    folder : pathlib.Path, optional
        Where it runs and puts its temporary files.

    Returns
    -------
    subprocess.CompletedProcess
        Its status (negative: the signal that ended it) and what it printed.

    Raises
    ------
    OSError
        If it cannot be started.
    subprocess.TimeoutExpired
        If it takes longer. As with Ctrl-C, it is then dead, and so is every process that it started.
    """
    interrupt = _Interrupt()
    with (
        interrupts_go_to(interrupt.note),
        subprocess.Popen(
            command,
            cwd=folder,
            env=_surroundings(folder),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
            # A group of its own: a compiler is a driver whose passes would live on if only the driver were killed.
            start_new_session=True,
        ) as process,
    ):
        try:
            if (processes := _processes.get()) is not None:
                processes.add(process)
            interrupt.pass_on()
            out, err = process.communicate(timeout=seconds)
        except BaseException:
            _kill_group(process)
            raise
    return subprocess.CompletedProcess(command, process.returncode, out, err)


def _surroundings(folder: Path | None) -> dict[str, str]:
    """In the C locale messages are in English, where the word "error" marks the lines that matter."""
    return {**os.environ, "LC_ALL": "C", **({"TMPDIR": str(folder)} if folder is not None else {})}


class Processes:
    """Those that a thread runs, which another thread may kill."""

    def __init__(self) -> None:
        self._killed, self._lock = False, threading.Lock()
        self._running: list[subprocess.Popen[str]] = []

    def add(self, process: subprocess.Popen[str]) -> None:
        """One that was started just now: it is killed at once if the others have been."""
        with self._lock:
            self._running.append(process)
            if self._killed:
                _kill_group(process)

    def kill(self) -> None:
        """End all, with what they have started, and whatever is added later."""
        with self._lock:
            self._killed = True
            for process in self._running:
                if process.returncode is None:
                    _kill_group(process)


_processes: ContextVar[Processes | None] = ContextVar("processes", default=None)


@contextlib.contextmanager
def kill_on(processes: Processes) -> Iterator[None]:
    """Add what :func:`run` starts in this thread meanwhile, so that it can be killed from another."""
    before = _processes.set(processes)
    try:
        yield
    finally:
        _processes.reset(before)


class _Interrupt:
    """Ctrl-C, held back while a process is being started: raised then, it would leave one that nobody knows of."""

    def __init__(self) -> None:
        self._pending = self._passed_on = False

    def note(self, number: int, frame: FrameType | None) -> None:
        """Handle SIGINT."""
        self._pending = True
        if self._passed_on:
            signal.default_int_handler(number, frame)

    def pass_on(self) -> None:
        """Raise what was held back, and from now on whatever comes."""
        self._passed_on = True
        if self._pending:
            raise KeyboardInterrupt


def _kill_group(process: subprocess.Popen[str]) -> None:
    if sys.platform == "win32":
        process.kill()
    else:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
