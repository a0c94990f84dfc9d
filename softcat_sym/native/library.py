"""Compiling C sources into a shared library, and loading it."""

from __future__ import annotations

import ctypes
import functools
import hashlib
import os
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from softcat_sym.errors import SoftcatError
from softcat_sym.native import cache
from softcat_sym.native.compiler import THIS_PROCESSOR, Compiler, find_compiler

# Without errno and traps a logarithm whose value nobody reads is dropped, and a square root is one instruction;
# neither flag changes a number, as -ffast-math would.
OPTIMISED: tuple[str, ...] = ("-O3", THIS_PROCESSOR, "-fno-math-errno", "-fno-trapping-math")

_ALWAYS = ("-std=c99", "-fPIC", "-shared")
_ADVICE = "install gcc or clang, or set CC to a C compiler"
_SHOWN = 6


def compile_library(
    sources: Mapping[str, str], *, flags: Sequence[str] = OPTIMISED, units: Sequence[str] | None = None
) -> Path:
    """The shared library of these sources, compiled now or found in the cache.

    Parameters
    ----------
    sources : mapping of str to str
        C text by file name; an ``#include`` finds the others by these names.
    flags : sequence of str
        Compiler flags beside ``-std=c99 -fPIC -shared``; ``-march=native`` is left out where it is refused.
    units : sequence of str, optional
        The sources that are compiled on their own; by default every name that ends in ``.c``.

    Returns
    -------
    pathlib.Path
        The library, in the cache.

    Raises
    ------
    SoftcatError
        If there is no compiler, the compiler refuses the sources (with its first errors), or the cache cannot be
        written.
    """
    compiler = find_compiler()
    if compiler is None:
        named = os.environ.get("CC")
        found = f"CC is {named!r}, which is no C compiler that runs" if named else "no C compiler that runs was found"
        raise SoftcatError(f"{found}; {_ADVICE}")
    accepted = tuple(flag for flag in flags if flag != THIS_PROCESSOR or compiler.processor)
    chosen = tuple(units) if units is not None else tuple(name for name in sorted(sources) if name.endswith(".c"))
    key = _key(sources, chosen, compiler, accepted)
    return cache.find(key) or cache.store(key, functools.partial(_build, sources, chosen, compiler, accepted))


def load(path: Path) -> ctypes.CDLL:
    """Load a compiled library.

    Raises
    ------
    SoftcatError
        If the file is missing or no library of this machine.
    """
    try:
        return ctypes.CDLL(str(path))
    except OSError as error:
        raise SoftcatError(f"cannot load {path}: {error}; delete it and compile again") from error


def _key(sources: Mapping[str, str], units: Sequence[str], compiler: Compiler, flags: Sequence[str]) -> str:
    parts = ["compiler", *compiler.command, compiler.version, "flags", *_ALWAYS, *flags, "units", *units, "sources"]
    for name in sorted(sources):
        parts += [name, sources[name]]
    if THIS_PROCESSOR in flags:
        parts += ["processor", compiler.processor]
    # With its length before it, no part can pass for the end of the one before.
    return hashlib.sha256("".join(f"{len(part)}:{part}" for part in parts).encode()).hexdigest()


def _build(
    sources: Mapping[str, str], units: Sequence[str], compiler: Compiler, flags: Sequence[str], folder: Path
) -> None:
    for name, text in sources.items():
        (folder / name).write_text(text, encoding="utf-8")
    command = [*compiler.command, *_ALWAYS, *flags, "-o", cache.LIBRARY, *units, "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, errors="replace")
    if done.returncode != 0 or not (folder / cache.LIBRARY).is_file():
        raise SoftcatError(_refusal(compiler, command, done))
    for name in sources:
        (folder / name).unlink()


def _refusal(compiler: Compiler, command: Sequence[str], done: subprocess.CompletedProcess[str]) -> str:
    lines = [line for line in (done.stderr + done.stdout).splitlines() if line.strip()]
    # Fall back on everything: a missing header or a linker says "fatal error:" or "undefined reference".
    errors = [line for line in lines if "error" in line or "undefined" in line] or lines
    said = "\n".join(f"  {line}" for line in errors[:_SHOWN]) or f"  (nothing; exit status {done.returncode})"
    called = " ".join(command)
    return f"{compiler.path} ({compiler.version}) cannot compile the C sources:\n{said}\n  with: {called}\n{_ADVICE}"
