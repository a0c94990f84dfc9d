"""The C compiler of this machine: where it is, what it calls itself, and what it takes this processor for."""

from __future__ import annotations

import functools
import hashlib
import os
import shlex
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

_USUAL = ("cc", "gcc", "clang")
THIS_PROCESSOR = "-march=native"


@dataclass(frozen=True, slots=True)
class Compiler:
    """A C compiler that runs.

    Attributes
    ----------
    command : tuple of str
        How it is called: its path first, then what the variable CC says besides.
    version : str
        First line of what ``--version`` prints.
    processor : str
        Hash of the macros it defines under ``-march=native``, which name the instruction sets of this processor;
        empty where it refuses that flag.
    """

    command: tuple[str, ...]
    version: str
    processor: str

    @property
    def path(self) -> Path:
        """The executable."""
        return Path(self.command[0])


def find_compiler() -> Compiler | None:
    """The compiler that the variable CC names (with its flags), else the first of cc, gcc, clang on the PATH.

    Returns
    -------
    Compiler or None
        None where there is none, or where CC names something that does not run: another is never taken in its place.
    """
    named = shlex.split(os.environ.get("CC", ""))
    for command in [named] if named else [[name] for name in _USUAL]:
        path = shutil.which(command[0])
        if path is not None:
            found = _examine((path, *command[1:]), Path(path).stat().st_mtime_ns)
            if found is not None:
                return found
    return None


@functools.lru_cache(maxsize=8)
def _examine(command: tuple[str, ...], changed: int) -> Compiler | None:
    """Ask a compiler who it is, once a process as long as its file does not change."""
    del changed
    version = _output(*command, "--version")
    if version is None or not version.strip():
        return None
    macros = _output(*command, THIS_PROCESSOR, "-dM", "-E", "-x", "c", os.devnull)
    processor = hashlib.sha256(macros.encode()).hexdigest()[:16] if macros else ""
    return Compiler(command, version.splitlines()[0].strip(), processor)


def _output(*command: str) -> str | None:
    """What a command prints, or None where it fails."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, errors="replace")
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None
