"""C sources become shared libraries, compiled once and kept in a cache under the hash of all that made them."""

from __future__ import annotations

import contextlib
import ctypes
import errno
import functools
import hashlib
import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from softcat_sym import cache
from softcat_sym.codegen.compiler import TO_INSTALL, Compiler, find_compiler, processor, run, split_variable
from softcat_sym.errors import SoftcatError

VARIABLE = "SOFTCAT_CACHE_LIMIT"
_DEFAULT = "512 MB"
_BYTES = {
    **{"": 1, "b": 1, "kb": 10**3, "mb": 10**6, "gb": 10**9, "tb": 10**12},
    **{"kib": 2**10, "mib": 2**20, "gib": 2**30, "tib": 2**40},
}
_SIZE = re.compile(r"\s*(\d{1,18}(?:\.\d{1,18})?)\s*([a-z]*)\s*", re.ASCII | re.IGNORECASE)


def cache_limit() -> int:
    """Bytes that compiled libraries may take together: SOFTCAT_CACHE_LIMIT, else 512 MB."""
    text = os.environ.get(VARIABLE) or _DEFAULT
    found = _SIZE.fullmatch(text)
    factor = _BYTES.get(found[2].lower()) if found else None
    if found is None or factor is None:
        raise SoftcatError(
            f"{VARIABLE} is {text!r}; accepted: a number of bytes, or a size such as '500 MB' or '2 GiB'"
        )
    return int(float(found[1]) * factor)


def size_text(size: float) -> str:
    """A size in bytes as people read it: ``1.3 MB``; powers of ten."""
    for unit, factor in (("GB", 10**9), ("MB", 10**6), ("kB", 10**3)):
        if size >= factor:
            return f"{size / factor:.1f} {unit}"
    return f"{size:.0f} B"


LIBRARY, _ABOUT = "library.so", "about.txt"
_ZIG = hashlib.sha256(b"zig").hexdigest()


def about(entry: Path) -> tuple[str, str]:
    """Digest of a library of the cache, and what it was compiled from, and by what; empty where that is not there."""
    lines = [""]
    with contextlib.suppress(OSError):
        lines += cache.content_of(entry / _ABOUT).decode(errors="replace").splitlines()
    return lines[1] if len(lines) > 1 else "", " ".join(lines[2:])


def find(key: str) -> Path | None:
    """The library of a key, if it is there, still what was compiled, and nobody else can have put it there."""
    for folder in cache.folders(cache.LIBRARIES):
        entry = folder / key
        with contextlib.suppress(OSError):
            if not cache.distrust(entry) and about(entry)[0] == cache.digest(key, cache.content_of(entry / LIBRARY)):
                cache.touch(entry)
                return entry / LIBRARY
    return None


def store(key: str, build: Callable[[Path], object], made_from: str = "") -> Path:
    """Let `build` make the library in a folder of its own, then rename that to its key.

    Several processes may do so at once: the first to finish is kept, the others find it and drop theirs. Then what was
    used least recently is dropped until the cache keeps its limit.
    """
    limit = cache_limit()
    try:
        folder = cache.folders(cache.LIBRARIES)[-1]
        with cache.passing(folder, key) as passing:
            passing.mkdir(mode=0o700)
            build(passing)
            library = passing / LIBRARY
            library.chmod(0o700)
            digest = cache.digest(key, library.read_bytes())
            (passing / _ABOUT).write_text(f"{digest}\n{made_from}\n", encoding="utf-8")
            (passing / _ABOUT).chmod(0o600)
            try:
                passing.rename(folder / key)
            except OSError:  # what is there is another process's, or harmed, or none of ours
                if (found := find(key)) is not None:
                    return found
                cache.remove(folder / key)
                passing.rename(folder / key)
    except OSError as error:
        # It stays an error of the system: no fault of a scene, which would be one failed member of a sweep.
        full = "free some space, or set SOFTCAT_CACHE to a folder elsewhere"
        advice, place = full if error.errno in cache.FULL else cache.ADVICE, cache.folder(cache.LIBRARIES)
        error.add_note(f"cannot write the cache of compiled libraries in {place}: {error.strerror or error}; {advice}")
        raise
    cache.trim(cache.LIBRARIES, limit, key)
    return folder / key / LIBRARY


# Without errno and traps a logarithm whose value nobody reads is dropped, and a square root is one instruction;
# neither flag changes a number, as -ffast-math would. Nor does this name a processor: the loop of the finite elements
# gains only a twentieth by -march=native.
OPTIMISED: tuple[str, ...] = ("-O3", "-fno-math-errno", "-fno-trapping-math")

# For what is compiled once a scene: a third of the time to compile, for a twentieth more to run. No number changes.
SOON: tuple[str, ...] = ("-O1", *OPTIMISED[1:])

# For what a whole solve is spent in: as quick as -O3, for two thirds of the time to compile.
STEADY: tuple[str, ...] = ("-O2", *OPTIMISED[1:])

# What gcc does for nothing: in the text of a scene it hands out registers loop by loop for a third of its time, in that
# of the runtime it looks for jumps and ranges for a fifth.
_GNU = {SOON: ("-fira-region=one",), STEADY: ("-fno-tree-dominator-opts", "-fno-tree-vrp")}

_WINDOWS = sys.platform == "win32"
# Code on Windows is position-independent anyway.
_ALWAYS = ("-std=c99", "-shared") if _WINDOWS else ("-std=c99", "-fPIC", "-shared")
# A library that needs another one of MinGW's is not loaded there: Python looks for it beside the library only.
_MINGW = ("-static-libgcc",) if _WINDOWS else ()
_MARKS = re.compile(r"error|undefined|failed|no space|killed", re.IGNORECASE)
_NO_SPACE = re.compile(r"no space left|file size limit|file too large|quota exceeded", re.IGNORECASE)
_SHOWN = 6
_PATIENCE = 600.0  # s; generated C takes seconds, so that a compiler still at work after minutes hangs


def compile_library(
    sources: Mapping[str, str],
    *,
    flags: Sequence[str] = OPTIMISED,
    units: Sequence[str] | None = None,
    versions: Mapping[str, str] | None = None,
) -> Path:
    """The shared library of these sources, compiled now or found in the cache."""
    cache_limit()  # nonsense in the variable is refused whether or not anything has to be compiled
    compiler = find_compiler()
    if compiler is None:
        named = os.environ.get("CC")
        found = f"CC is {named!r}, which is no C compiler that runs" if named else "no C compiler that runs was found"
        raise SoftcatError(f"{found}; {TO_INSTALL}")
    return compiled_by(compiler, sources, _ALWAYS, _whole(compiler, flags), units=units, versions=versions)


def _whole(compiler: Compiler, flags: Sequence[str]) -> tuple[str, ...]:
    """Flags with those of gcc alone, and those that the user adds."""
    own = (*_GNU.get(tuple(flags), ()), *_MINGW) if compiler.name.startswith("gcc") else ()
    return (*flags, *own, *split_variable("SOFTCAT_CFLAGS"))


def compiled_by(
    compiler: Compiler,
    sources: Mapping[str, str],
    always: Sequence[str],
    flags: Sequence[str],
    *,
    units: Sequence[str] | None = None,
    versions: Mapping[str, str] | None = None,
) -> Path:
    """What a compiler makes of these sources, now or found in the cache, by flags besides those it always has."""
    chosen = tuple(units) if units is not None else tuple(name for name in sorted(sources) if name.endswith(".c"))
    parts = {
        "compiler": [*compiler.command, compiler.version],
        "processor": processor(compiler, [*compiler.command[1:], *flags]),
        "flags": [*always, *flags],
        "units": list(chosen),
        "sources": {name: hashlib.sha256(text.encode()).hexdigest() for name, text in sources.items()},
        "versions": dict(versions or {}),
    }
    key = hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()
    about = f"{' '.join(chosen)} by {compiler.name}, {' '.join(flags)}"
    return find(key) or store(key, functools.partial(_build, sources, chosen, compiler, [*always, *flags]), about)


def check_compiler(compiler: Compiler) -> None:
    """Refuse a compiler that cannot make a library of one function, or whose library does not give what C says."""
    flags = [*_ALWAYS, *_whole(compiler, SOON)]
    source = {"check.c": "#include <math.h>\ndouble softcat_check(double x) { return 2.0 * sqrt(x); }\n"}
    with cache.passing(cache.folders(cache.LIBRARIES)[-1], hashlib.sha256(b"check").hexdigest()) as place:
        place.mkdir(mode=0o700)
        _build(source, list(source), compiler, flags, place)
        check = load(place / LIBRARY, "softcat_check").softcat_check
    check.argtypes, check.restype = [ctypes.c_double], ctypes.c_double
    if (found := check(9.0)) != 6.0:
        raise SoftcatError(f"{compiler.path} ({compiler.version}) makes 2 sqrt(9) = {found!r}, which is 6")


def load(path: Path, *symbols: str) -> ctypes.CDLL:
    """Load a compiled library that has these symbols."""
    again = "look at CC and SOFTCAT_CFLAGS; softcat cache --clear, and compile again"
    try:
        library = ctypes.CDLL(str(path))
    except OSError as error:
        raise SoftcatError(f"cannot load {path}: {error}; {again}") from error
    if lacking := [name for name in symbols if not hasattr(library, name)]:
        raise SoftcatError(f"{path} lacks {', '.join(lacking)}, which its C sources define; {again}")
    return library


def _build(
    sources: Mapping[str, str], units: Sequence[str], compiler: Compiler, flags: Sequence[str], folder: Path
) -> None:
    for name, text in sources.items():
        (folder / name).write_text(text, encoding="utf-8")
    command = [*compiler.command, *flags, "-o", LIBRARY, *units, "-lm"]
    try:
        done = run(command, _PATIENCE, folder, _zig())
    except subprocess.TimeoutExpired as error:
        raise SoftcatError(
            f"{compiler.path} ({compiler.version}) did not finish within {_PATIENCE:.0f} s and was stopped"
        ) from error
    if done.returncode != 0 and _NO_SPACE.search(done.stderr + done.stdout):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(folder))
    if done.returncode != 0 or not (folder / LIBRARY).is_file():
        raise SoftcatError(_refusal(compiler, command, done))
    for name in sources:
        (folder / name).unlink()


def _zig() -> Path:
    """Where zig keeps the libraries of C that it has compiled for itself, an entry of the cache; made if missing."""
    place = cache.folders(cache.ZIG)[-1] / _ZIG
    if cache.distrust(place):
        cache.remove(place)
    place.mkdir(mode=0o700, exist_ok=True)
    return place


def _refusal(compiler: Compiler, command: Sequence[str], done: subprocess.CompletedProcess[str]) -> str:
    lines = [line for line in (done.stderr + done.stdout).splitlines() if line.strip()]
    # Fall back on everything: not every compiler marks what matters.
    errors = [line for line in lines if _MARKS.search(line)] or lines
    advice = TO_INSTALL
    if done.returncode < 0:
        ended = signal.strsignal(-done.returncode) or "unknown"
        errors.insert(0, f"(killed by signal {-done.returncode}: {ended})")
        advice = "if memory ran out, or the disk is full, free some and try again"
    said = "\n".join(f"  {line}" for line in errors[:_SHOWN]) or f"  (nothing; exit status {done.returncode})"
    called = " ".join(command)
    return f"{compiler.path} ({compiler.version}) cannot compile the C sources:\n{said}\n  with: {called}\n{advice}"
