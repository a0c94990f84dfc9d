"""Compiling C sources into a shared library, and loading it."""

from __future__ import annotations

import ctypes
import functools
import hashlib
import json
import os
import re
import signal
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from softcat_sym.errors import SoftcatError
from softcat_sym.native import cache
from softcat_sym.native.compiler import Compiler, find_compiler, processor, split_variable
from softcat_sym.native.limit import cache_limit
from softcat_sym.native.process import run

# Without errno and traps a logarithm whose value nobody reads is dropped, and a square root is one instruction;
# neither flag changes a number, as -ffast-math would. Nor does this name a processor: the loop of the finite elements
# gains only a twentieth by -march=native.
OPTIMISED: tuple[str, ...] = ("-O3", "-fno-math-errno", "-fno-trapping-math")

# For what is compiled once a scene: a third of the time to compile, for a twentieth more to run. No number changes.
SOON: tuple[str, ...] = ("-O1", *OPTIMISED[1:])

# What gcc takes longest for in such a text is handing out registers, loop by loop: a third of its time, for nothing.
_SOON_GNU = ("-fira-region=one",)

_ALWAYS = ("-std=c99", "-fPIC", "-shared")
_ADVICE = "install gcc or clang, or set CC to a C compiler"
_MARKS = re.compile(r"error|undefined|failed|no space|killed", re.IGNORECASE)
_FULL = re.compile(r"no space left|file size limit|file too large|quota exceeded", re.IGNORECASE)
_SHOWN = 6
_PATIENCE = 600.0  # s; generated C takes seconds, so that a compiler still at work after minutes hangs


def compile_library(
    sources: Mapping[str, str],
    *,
    flags: Sequence[str] = OPTIMISED,
    units: Sequence[str] | None = None,
    versions: Mapping[str, str] | None = None,
) -> Path:
    """The shared library of these sources, compiled now or found in the cache.

    Parameters
    ----------
    sources : mapping of str to str
        C text by file name; an ``#include`` finds the others by these names.
    flags : sequence of str
        Compiler flags beside ``-std=c99 -fPIC -shared``. After them come those of the variable SOFTCAT_CFLAGS, such as
        ``-march=native``.
    units : sequence of str, optional
        The sources that are compiled on their own; by default every name that ends in ``.c``.
    versions : mapping of str to str, optional
        Versions by name of what made the sources: other versions, another entry of the cache.

    Returns
    -------
    pathlib.Path
        The library, in the cache. It is safe from being dropped for a minute, within which it should be loaded.

    Raises
    ------
    SoftcatError
        If there is no compiler, the compiler refuses the sources (with its first errors), does not end within ten
        minutes or is killed, a variable makes no sense, or the cache cannot be written.
    """
    cache_limit()  # nonsense in the variable is refused whether or not anything has to be compiled
    compiler = find_compiler()
    if compiler is None:
        named = os.environ.get("CC")
        found = f"CC is {named!r}, which is no C compiler that runs" if named else "no C compiler that runs was found"
        raise SoftcatError(f"{found}; {_ADVICE}")
    own = _SOON_GNU if flags == SOON and compiler.name.startswith("gcc") else ()
    whole = (*flags, *own, *split_variable("SOFTCAT_CFLAGS"))
    chosen = tuple(units) if units is not None else tuple(name for name in sorted(sources) if name.endswith(".c"))
    key = _key(sources, chosen, compiler, whole, versions or {})
    about = f"{' '.join(chosen)} by {compiler.name}, {' '.join(whole)}"
    build = functools.partial(_build, sources, chosen, compiler, whole)
    return cache.find(key) or cache.store(key, build, about)


def load(path: Path, *symbols: str) -> ctypes.CDLL:
    """Load a compiled library that has these symbols.

    Raises
    ------
    SoftcatError
        If the file is missing, no library of this machine, or lacks a symbol, as flags of CC or SOFTCAT_CFLAGS make it.
    """
    again = "look at CC and SOFTCAT_CFLAGS; softcat cache --clear, and compile again"
    try:
        library = ctypes.CDLL(str(path))
    except OSError as error:
        raise SoftcatError(f"cannot load {path}: {error}; {again}") from error
    if lacking := [name for name in symbols if not hasattr(library, name)]:
        raise SoftcatError(f"{path} lacks {', '.join(lacking)}, which its C sources define; {again}")
    return library


def _key(
    sources: Mapping[str, str],
    units: Sequence[str],
    compiler: Compiler,
    flags: Sequence[str],
    versions: Mapping[str, str],
) -> str:
    parts = {
        "compiler": [*compiler.command, compiler.version],
        "processor": processor(compiler, [*compiler.command[1:], *flags]),
        "flags": [*_ALWAYS, *flags],
        "units": list(units),
        "sources": {name: hashlib.sha256(text.encode()).hexdigest() for name, text in sources.items()},
        "versions": dict(versions),
    }
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def _build(
    sources: Mapping[str, str], units: Sequence[str], compiler: Compiler, flags: Sequence[str], folder: Path
) -> None:
    for name, text in sources.items():
        (folder / name).write_text(text, encoding="utf-8")
    command = [*compiler.command, *_ALWAYS, *flags, "-o", cache.LIBRARY, *units, "-lm"]
    try:
        done = run(command, _PATIENCE, folder)
    except subprocess.TimeoutExpired as error:
        raise SoftcatError(
            f"{compiler.path} ({compiler.version}) did not finish within {_PATIENCE:.0f} s and was stopped"
        ) from error
    if done.returncode != 0 or not (folder / cache.LIBRARY).is_file():
        raise SoftcatError(_refusal(compiler, command, done))
    for name in sources:
        (folder / name).unlink()


def _refusal(compiler: Compiler, command: Sequence[str], done: subprocess.CompletedProcess[str]) -> str:
    lines = [line for line in (done.stderr + done.stdout).splitlines() if line.strip()]
    # Fall back on everything: not every compiler marks what matters.
    errors = [line for line in lines if _MARKS.search(line)] or lines
    advice = _ADVICE
    if done.returncode < 0:
        ended = signal.strsignal(-done.returncode) or "unknown"
        errors.insert(0, f"(killed by signal {-done.returncode}: {ended})")
        advice = "if memory ran out, free some and try again"
    said = "\n".join(f"  {line}" for line in errors[:_SHOWN]) or f"  (nothing; exit status {done.returncode})"
    if _FULL.search(said):
        advice = "the disk is full: free some space, or set SOFTCAT_CACHE to a folder elsewhere"
    called = " ".join(command)
    return f"{compiler.path} ({compiler.version}) cannot compile the C sources:\n{said}\n  with: {called}\n{advice}"
