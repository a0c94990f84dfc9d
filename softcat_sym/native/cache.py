"""The cache of compiled libraries: a folder an entry, named by the hash of what made it, complete or absent."""

from __future__ import annotations

import contextlib
import errno
import hashlib
import os
import re
import secrets
import shutil
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from softcat_sym.errors import SoftcatError
from softcat_sym.native import folder as folders
from softcat_sym.native.limit import cache_limit
from softcat_sym.native.texts import clear_texts

LIBRARY = "library.so"
_DIGEST, _ABOUT = "library.sha256", "about.txt"
_NAME = re.compile(r"[0-9a-f]{64}")
_PASSING = re.compile(r"\.(?:[0-9a-f]{64}\.[0-9a-f]{8}|compilers\.[0-9a-f]{8}\.part\.json)")
_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)

GRACE = 60.0
"""Seconds for which a library that was asked for is not dropped: another process may be about to load it."""


@dataclass(frozen=True, slots=True)
class CacheEntry:
    """One compiled library.

    Attributes
    ----------
    key : str
        Hash of sources, compiler, flags, versions and, where a flag asks for it, processor.
    path : pathlib.Path
        The library.
    size : int
        Bytes on disk.
    modified : float
        When it was compiled [s since 1970].
    used : float
        When it was last asked for [s since 1970].
    about : str
        What it was compiled from, and by what.
    """

    key: str
    path: Path
    size: int
    modified: float
    used: float
    about: str


def find(key: str) -> Path | None:
    """The library of a key, if it is there, still what was compiled, and nobody else could have put it there."""
    native = folders.libraries()
    return None if folders.distrust(native) else _find(native / key)


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


def _digest(key: str, content: bytes) -> str:
    """Hash of a library under its key, so that one in the place of another is found out, too."""
    return hashlib.sha256(key.encode() + content).hexdigest()


def store(key: str, build: Callable[[Path], object], about: str = "") -> Path:
    """Let `build` make the library in a folder of its own, then move that into place.

    Several processes may do so at once: the first to finish is kept, the others find it and drop theirs. Then what was
    used least recently is dropped until the cache keeps its limit.

    Parameters
    ----------
    key : str
        Hash under which it is found again.
    build : callable
        Given a folder, writes ``library.so`` into it.
    about : str
        A line on what it is.

    Returns
    -------
    pathlib.Path
        The library in its place. Where the usual cache cannot be used that is in a temporary folder, with a warning.

    Raises
    ------
    SoftcatError
        If the folder that SOFTCAT_CACHE names cannot be used, or the disk is full. What `build` raises passes through;
        nothing is left behind.
    """
    native, limit = folders.libraries(), cache_limit()
    try:
        passing = _begin(native, key)
    except OSError as error:
        native = _elsewhere(native, error)
        found = _find(native / key)
        if found is not None:
            return found
        passing = _begin(native, key)
    try:
        with folders.locked(passing):
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
    return folders.temporary(native, error.strerror or str(error))


def _begin(native: Path, key: str) -> Path:
    folders.make(native)
    passing = native / f".{key}.{secrets.token_hex(4)}"
    passing.mkdir(mode=0o700)
    return passing


def _unwritable(native: Path, error: OSError) -> SoftcatError:
    advice = "free some space" if error.errno in _FULL else folders.ADVICE
    other = ", or set SOFTCAT_CACHE to a folder elsewhere" if error.errno in _FULL else ""
    return SoftcatError(
        f"cannot write the cache of compiled libraries in {native}: {error.strerror or error}; {advice}{other}"
    )


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
    return tuple(sorted(_entries(folders.libraries()), key=lambda entry: (-entry.used, entry.key)))


def clear_cache() -> int:
    """Delete every compiled library and kept text, what is known of compilers, and what killed processes left behind.

    Compilations under way are let alone, and so is whatever else lies in the folder. Programs that have loaded a
    library go on.

    Returns
    -------
    int
        Bytes freed.

    Raises
    ------
    SoftcatError
        If the folder is not this user's own, or cannot be written.
    """
    native, freed = folders.libraries(), 0
    if reason := folders.distrust(native):
        raise SoftcatError(f"the cache is not cleared: {reason}")
    try:
        names = sorted(native.iterdir()) if native.is_dir() else []
        for path in [path for path in names if _NAME.fullmatch(path.name)]:
            freed += _size(path)
            _discard(path)
        for path in _leftovers(native):
            freed += _size(path)
            _remove(path)
        compilers = native / folders.COMPILERS
        if compilers.is_file():
            freed += _size(compilers)
            compilers.unlink(missing_ok=True)
        freed += clear_texts()
    except OSError as error:
        raise SoftcatError(f"cannot clear {native}: {error.strerror or error}") from error
    return freed


def _leftovers(native: Path) -> list[Path]:
    """What compilations and deletions left whose process is gone."""
    found = [path for path in native.iterdir() if _PASSING.fullmatch(path.name)] if native.is_dir() else []
    return [path for path in found if not folders.in_use(path)]


def _entries(native: Path) -> list[CacheEntry]:
    names = [path for path in native.iterdir() if _NAME.fullmatch(path.name)] if native.is_dir() else []
    found = []
    for path in names:
        with contextlib.suppress(OSError):  # dropped by another process meanwhile, or without its library
            modified, about = (path / LIBRARY).stat().st_mtime, path / _ABOUT
            said = about.read_text(encoding="utf-8", errors="replace").strip() if about.is_file() else ""
            found.append(CacheEntry(path.name, path / LIBRARY, _size(path), modified, _used(path), said))
    return found


def _used(place: Path) -> float:
    digest = place / _DIGEST
    return (digest if digest.is_file() else place / LIBRARY).stat().st_mtime


def _size(path: Path) -> int:
    total = 0
    with contextlib.suppress(FileNotFoundError, NotADirectoryError):  # another process is deleting it, too
        for file in path.iterdir() if path.is_dir() else [path]:
            total += file.stat().st_size if file.is_file() else 0
    return total
