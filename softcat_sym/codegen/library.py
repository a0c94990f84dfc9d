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
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from softcat_sym.codegen import compiler
from softcat_sym.codegen.compiler import TO_INSTALL, Compiler, find_compiler, processor, run, split_variable
from softcat_sym.errors import SoftcatError
from softcat_sym.files import replace_atomically

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


MOST = 256
"""Texts that are kept; beyond it those go that were not used for longest. One takes some 20 kB."""

_ENDING = ".text"


def texts_folder() -> Path:
    """The folder of kept texts, in the cache; it may not exist yet."""
    return compiler.cache_folder() / "texts"


def recall(key: str) -> str | None:
    """The text of a key, if it is there, still what was kept, and nobody else could have put it there."""
    folder = texts_folder()
    if compiler.distrust(folder):
        return None
    path = folder / f"{key}{_ENDING}"
    try:
        content = path.read_bytes()
    except OSError:
        return None
    digest, packed = content[:64], content[64:]
    if digest.decode(errors="replace") != _digest(key, packed):
        return None
    with contextlib.suppress(OSError):  # a cache that is only read is as good
        os.utime(path)
    return zlib.decompress(packed).decode()


def keep(key: str, text: str) -> None:
    """Keep a text; where that is impossible, it will be written again."""
    folder, packed = texts_folder(), zlib.compress(text.encode(), 1)
    with contextlib.suppress(OSError):
        compiler.make(folder)
        replace_atomically(folder / f"{key}{_ENDING}", _digest(key, packed).encode() + packed)
        for path in kept_texts()[MOST:]:
            path.unlink(missing_ok=True)


def kept_texts() -> list[Path]:
    """Files of all texts, the last used first."""
    used = []
    for path in texts_folder().glob(f"*{_ENDING}"):
        with contextlib.suppress(OSError):  # another process dropped it
            used.append((path.stat().st_mtime, path))
    return [path for _, path in sorted(used, reverse=True)]


def _digest(key: str, content: bytes) -> str:
    """Hash of a content under its key, so that one in the place of another is found out, too."""
    return hashlib.sha256(key.encode() + content).hexdigest()


LIBRARY = "library.so"
_DIGEST, _ABOUT = "library.sha256", "about.txt"
_NAME = re.compile(r"[0-9a-f]{64}")
_PASSING = re.compile(r"\.(?:[0-9a-f]{64}\.[0-9a-f]{8}|compilers\.[0-9a-f]{8}\.part\.json)")
_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)

GRACE = 60.0
"""Seconds for which a library that was asked for is not dropped: another process may be about to load it."""


@dataclass(frozen=True, slots=True)
class CacheEntry:
    """One compiled library."""

    key: str  # Hash of sources, compiler, flags, versions and, where a flag asks for it, processor
    path: Path  # The library
    size: int  # Bytes on disk
    modified: float  # When it was compiled [s since 1970]
    used: float  # When it was last asked for [s since 1970]
    about: str  # What it was compiled from, and by what


def find(key: str) -> Path | None:
    """The library of a key, if it is there, still what was compiled, and nobody else could have put it there."""
    native = compiler.libraries()
    return None if compiler.distrust(native) else _find(native / key)


def _find(place: Path) -> Path | None:
    try:
        content = (place / LIBRARY).read_bytes()
        wanted = (place / _DIGEST).read_text(encoding="ascii", errors="replace").strip()
    except OSError:
        return None
    if _digest(place.name, content) != wanted:
        return None
    # A cache that is only read, such as one that came with a container, is as good.
    with contextlib.suppress(OSError):
        os.utime(place / _DIGEST)
    return place / LIBRARY


def store(key: str, build: Callable[[Path], object], about: str = "") -> Path:
    """Let `build` make the library in a folder of its own, then move that into place.

    Several processes may do so at once: the first to finish is kept, the others find it and drop theirs. Then what was
    used least recently is dropped until the cache keeps its limit.
    """
    native, limit = compiler.libraries(), cache_limit()
    try:
        passing = _begin(native, key)
    except OSError as error:
        native = _elsewhere(native, error)
        found = _find(native / key)
        if found is not None:
            return found
        passing = _begin(native, key)
    try:
        with compiler.locked(passing):
            build(passing)
            digest = _digest(key, (passing / LIBRARY).read_bytes())
            (passing / _ABOUT).write_text(about + "\n", encoding="utf-8")
            (passing / _DIGEST).write_text(digest + "\n", encoding="ascii")
            library = _move(passing, native / key)
    except OSError as error:
        raise _unwritable(native, error) from error
    finally:
        shutil.rmtree(passing, ignore_errors=True)
    _trim(native, limit, key)
    return library


def _elsewhere(native: Path, error: OSError) -> Path:
    """The temporary folder that is used where the usual one cannot be.

    A folder that the user named is taken or refused, never replaced by another; a full disk is no reason to move.
    """
    if os.environ.get("SOFTCAT_CACHE") or error.errno in _FULL:
        raise _unwritable(native, error) from error
    return compiler.temporary(native, error.strerror or str(error))


def _begin(native: Path, key: str) -> Path:
    compiler.make(native)
    passing = native / f".{key}.{secrets.token_hex(4)}"
    passing.mkdir(mode=0o700)
    return passing


def _unwritable(native: Path, error: OSError) -> SoftcatError:
    full = "free some space, or set SOFTCAT_CACHE to a folder elsewhere"
    advice = full if error.errno in _FULL else compiler.ADVICE
    reason = error.strerror or error
    return SoftcatError(f"cannot write the cache of compiled libraries in {native}: {reason}; {advice}")


def _move(passing: Path, place: Path) -> Path:
    # A folder cannot replace one that is not empty: another process was faster, or what is there is damaged.
    for left in reversed(range(8)):
        try:
            passing.rename(place)
        except OSError:
            found = _find(place)
            if found is not None:
                return found
            if not left:
                raise
            _discard(place)
        else:
            break
    return place / LIBRARY


def _discard(place: Path) -> None:
    """Remove an entry; its name is free at once, even while its files are being deleted."""
    aside = place.with_name(f".{place.name}.{secrets.token_hex(4)}")
    try:
        place.rename(aside)
    except FileNotFoundError:
        return  # another process removed it
    _remove(aside)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def _trim(native: Path, limit: int, stored: str) -> None:
    """Drop what was used least recently until the rest keeps the limit, and what killed processes left behind.

    A library that a process has loaded stays usable after its file is gone.
    """
    with contextlib.suppress(OSError):  # what was asked for is there: housekeeping can wait for the next time
        entries, now = _entries(native), time.time()
        total = sum(entry.size for entry in entries)
        for entry in sorted(entries, key=lambda entry: entry.used):
            if total <= limit:
                break
            if entry.key != stored and now - _used(entry.path.parent) > GRACE:
                _discard(entry.path.parent)
                total -= entry.size
        for path in _leftovers(native):
            if now - path.stat().st_mtime > GRACE:
                _remove(path)


def cache_entries() -> tuple[CacheEntry, ...]:
    """Every library in the cache, the last used first; compilations under way are left out."""
    return tuple(sorted(_entries(compiler.libraries()), key=lambda entry: (-entry.used, entry.key)))


def clear_cache() -> int:
    """Delete every compiled library and kept text, what is known of compilers, and what killed processes left behind.

    Compilations under way are let alone, and so is whatever else lies in the folder. Programs that have loaded a
    library go on.
    """
    native, freed = compiler.libraries(), 0
    if reason := compiler.distrust(native):
        raise SoftcatError(f"the cache is not cleared: {reason}")
    try:
        names = sorted(native.iterdir()) if native.is_dir() else []
        entries = [path for path in names if _NAME.fullmatch(path.name)]
        files = [path for path in (native / compiler.COMPILERS, *kept_texts()) if path.is_file()]
        for path in (*entries, *_leftovers(native), *files, native / compiler.ZIG):
            freed += _size(path)
            (_discard if path in entries else _remove)(path)
    except OSError as error:
        raise SoftcatError(f"cannot clear {native}: {error.strerror or error}") from error
    return freed


def _leftovers(native: Path) -> list[Path]:
    """What compilations and deletions left whose process is gone."""
    found = [path for path in native.iterdir() if _PASSING.fullmatch(path.name)] if native.is_dir() else []
    return [path for path in found if not compiler.in_use(path)]


def _entries(native: Path) -> list[CacheEntry]:
    names = [path for path in native.iterdir() if _NAME.fullmatch(path.name)] if native.is_dir() else []
    found = []
    for path in names:
        with contextlib.suppress(OSError):  # dropped by another process meanwhile, or without its library
            modified, about = (path / LIBRARY).stat().st_mtime, path / _ABOUT
            words = about.read_text(encoding="utf-8", errors="replace").strip() if about.is_file() else ""
            found.append(CacheEntry(path.name, path / LIBRARY, _size(path), modified, _used(path), words))
    return found


def _used(place: Path) -> float:
    digest = place / _DIGEST
    return (digest if digest.is_file() else place / LIBRARY).stat().st_mtime


def _size(path: Path) -> int:
    total = 0
    with contextlib.suppress(FileNotFoundError, NotADirectoryError):  # another process is deleting it, too
        for file in path.rglob("*") if path.is_dir() else [path]:
            total += file.stat().st_size if file.is_file() else 0
    return total


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
    # A library that is loaded cannot be deleted on Windows.
    with tempfile.TemporaryDirectory(prefix="softcat_sym-", ignore_cleanup_errors=True) as passing:
        place = Path(passing) / "check"
        place.mkdir()
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
        done = run(command, _PATIENCE, folder)
    except subprocess.TimeoutExpired as error:
        raise SoftcatError(
            f"{compiler.path} ({compiler.version}) did not finish within {_PATIENCE:.0f} s and was stopped"
        ) from error
    if done.returncode != 0 or not (folder / LIBRARY).is_file():
        raise SoftcatError(_refusal(compiler, command, done))
    for name in sources:
        (folder / name).unlink()


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
    if _NO_SPACE.search(said):
        advice = "the disk is full: free some space, or set SOFTCAT_CACHE to a folder elsewhere"
    called = " ".join(command)
    return f"{compiler.path} ({compiler.version}) cannot compile the C sources:\n{said}\n  with: {called}\n{advice}"
