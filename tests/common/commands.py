"""The ``softcat`` command in a process of its own, to be sent signals; and programs that stand in for its children."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

PATIENCE = 120.0
"""Seconds that a busy machine is given."""

_MAIN = "import sys\nsys.argv[0] = 'softcat'\nfrom softcat_sym.cli import main\nmain()\n"


@contextmanager
def softcat(*arguments: str, ignoring: bool = False) -> Iterator[subprocess.Popen[str]]:
    """Start the command; `ignoring` as in the background of a script."""
    code = _MAIN
    before = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\nimport os, sys\n"
    command = [sys.executable, "-c", code, *arguments]
    if ignoring:
        # What is ignored stays so in the program that takes one's place.
        command = [sys.executable, "-c", before + "os.execv(sys.argv[1], sys.argv[1:])", *command]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        yield process
    finally:
        process.kill()
        process.communicate()


def until(happens: Callable[[], object], process: subprocess.Popen[str]) -> None:
    """Wait until something happens while a process runs.

    Raises
    ------
    AssertionError
        If the process ends before, or nothing happens for long.
    """
    end = time.monotonic() + PATIENCE
    while not happens():
        if process.poll() is not None:
            out, err = process.communicate()
            raise AssertionError(f"it ended before, with {process.returncode}: {out}{err}")
        assert time.monotonic() < end, "nothing happened"
        time.sleep(0.02)


def hanging(program: Path, when: str = "True") -> Path:
    """A program that writes down its number and its folder, and hangs; the file where it does so.

    Parameters
    ----------
    program : pathlib.Path
        Where it goes.
    when : str
        In which case, in Python; otherwise it says that it is version 1.
    """
    note = program.with_suffix(".note")
    program.parent.mkdir(parents=True, exist_ok=True)
    program.write_text(
        f"#!{sys.executable}\nimport os, pathlib, sys, time\nif not ({when}):\n    print('version 1'); sys.exit()\n"
        f"note = pathlib.Path({str(note)!r})\n"
        "note.with_suffix('.part').write_text(f'{os.getpid()} {os.getcwd()}')\n"
        "note.with_suffix('.part').rename(note)\ntime.sleep(300)\n"
    )
    program.chmod(0o755)
    return note


def is_gone(note: Path, patience: float = 10.0) -> bool:
    """Whether a hanging program has ended, or does so soon: a busy system takes a moment to bury what is killed."""
    number, folder = note.read_text().split(maxsplit=1)
    end = time.monotonic() + patience
    while time.monotonic() <= end:
        try:
            os.kill(int(number), 0)
        except ProcessLookupError:
            return not Path(folder).exists()
        time.sleep(0.02)
    return False


def ended(process: subprocess.Popen[str], number: signal.Signals) -> tuple[int, str, str]:
    """Send a signal; exit status and what was said."""
    process.send_signal(number)
    out, err = process.communicate(timeout=PATIENCE)
    return process.returncode, out, err
