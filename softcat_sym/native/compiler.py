"""The C compiler of this machine: where it is, what it calls itself, and what it takes this processor for."""

from __future__ import annotations

import functools
import hashlib
import os
import re
import shlex
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from softcat_sym.errors import SoftcatError
from softcat_sym.native import identity
from softcat_sym.native.process import run

_USUAL = ("cc", "gcc", "clang")
_PATIENCE = 10.0  # s, for a compiler to say its version, which takes a tenth of one


@dataclass(frozen=True, slots=True)
class Compiler:
    """A C compiler that runs.

    Attributes
    ----------
    command : tuple of str
        How it is called: its path first, then what the variable CC says besides.
    version : str
        First line of what ``--version`` prints.
    """

    command: tuple[str, ...]
    version: str

    @property
    def path(self) -> Path:
        """The executable."""
        return Path(self.command[0])

    @property
    def name(self) -> str:
        """In short, for summaries: ``gcc 12.2.0``."""
        # GNU: "cc (Debian 12.2.0-14+deb12u1) 12.2.0", whatever name it was called by; others: "clang version 17.0.6".
        gnu = re.match(r"(\S+) \(.*?\) (\d+(?:\.\d+)+)", self.version)
        if gnu is not None:
            return f"gcc {gnu[2]}"
        number = re.search(r"\d+(?:\.\d+)+", self.version)
        kind = "clang" if "clang" in self.version else self.version.split()[0]
        return f"{kind} {number[0]}" if number is not None else kind


def compiler_name() -> str:
    """In short what :func:`find_compiler` finds, such as ``gcc 12.2.0``; empty where there is none."""
    found = find_compiler()
    return "" if found is None else found.name


def find_compiler() -> Compiler | None:
    """The compiler that the variable CC names (with its flags), else the first of cc, gcc, clang on the PATH.

    It is asked for its version once: as long as its file stays the same, what it said is read from the cache.

    Returns
    -------
    Compiler or None
        None where there is none, or where CC names something that does not run: another is never taken in its place.

    Raises
    ------
    SoftcatError
        If quotes are not closed in CC.
    """
    named = split_variable("CC")
    for command in [named] if named else [[name] for name in _USUAL]:
        path = shutil.which(command[0])
        if path is not None:
            # Absolute, since it will be called from another folder.
            whole = (str(Path(path).absolute()), *command[1:])
            found = _examine(whole, identity.fingerprint(whole))
            if found is not None:
                return found
    return None


def split_variable(name: str) -> list[str]:
    """The words of an environment variable, as a shell would split them."""
    text = os.environ.get(name, "")
    try:
        return shlex.split(text)
    except ValueError as error:
        raise SoftcatError(f"{name} is {text!r}: {error}") from error


@functools.lru_cache(maxsize=8)
def _examine(command: tuple[str, ...], files: str) -> Compiler | None:
    """What a compiler is, looked up once a process as long as its files do not change."""
    version = identity.recall(command, files)
    if not version:
        said = _output(*command, "--version")
        if said is None or not said.strip():
            return None
        version = said.strip().splitlines()[0].strip()
        identity.remember(command, files, version)
    return Compiler(command, version)


def processor(compiler: Compiler, flags: Sequence[str]) -> str:
    """Hash of what flags such as ``-march=native`` make of this processor; empty where no flag asks for it.

    It hashes the macros that the compiler defines under these flags, which name the instruction sets. Not kept on disk:
    machines with different processors may share a home.
    """
    asked = tuple(flag for flag in flags if flag.startswith("-m") and flag.endswith("=native"))
    return _processor(compiler, asked) if asked else ""


@functools.lru_cache(maxsize=8)
def _processor(compiler: Compiler, flags: tuple[str, ...]) -> str:
    macros = _output(*compiler.command, *flags, "-dM", "-E", "-x", "c", os.devnull)
    return hashlib.sha256(macros.encode()).hexdigest()[:16] if macros else "unknown"


def _output(*command: str) -> str | None:
    """What a command prints, or None where it fails."""
    try:
        done = run(command, _PATIENCE)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout if done.returncode == 0 else None
