"""The cache of compiled libraries: a folder an entry, named by the hash of what made it, complete or absent."""

from __future__ import annotations

import hashlib
import os
import re
import secrets
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from softcat_sym.errors import SoftcatError

LIBRARY = "library.so"
_DIGEST = "library.sha256"
_NAME = re.compile(r"[0-9a-f]{64}")
_PASSING = re.compile(r"\.[0-9a-f]{64}\.[0-9a-f]{8}")


@dataclass(frozen=True, slots=True)
class CacheEntry:
    """One compiled library.

    Attributes
    ----------
    key : str
        Hash of sources, compiler, flags and processor.
    path : pathlib.Path
        The library.
    size : int
        Bytes on disk.
    modified : float
        When it was compiled [s since 1970].
    """

    key: str
    path: Path
    size: int
    modified: float


def cache_folder() -> Path:
    """SOFTCAT_CACHE, else ``softcat_sym`` in XDG_CACHE_HOME, else in ``~/.cache``; it may not exist yet."""
    chosen, shared = os.environ.get("SOFTCAT_CACHE"), os.environ.get("XDG_CACHE_HOME")
    if chosen:
        return Path(chosen).expanduser()
    return (Path(shared) if shared else Path.home() / ".cache") / "softcat_sym"


def find(key: str) -> Path | None:
    """The library of a key, if it is there and still what was compiled."""
    folder = _libraries() / key
    try:
        content = (folder / LIBRARY).read_bytes()
        wanted = (folder / _DIGEST).read_text(encoding="ascii", errors="replace").strip()
    except OSError:
        return None
    return folder / LIBRARY if hashlib.sha256(content).hexdigest() == wanted else None


def store(key: str, build: Callable[[Path], object]) -> Path:
    """Let `build` make the library in a folder of its own, then move that into place.

    Several processes may do so at once: the first to finish is kept, the others find it and drop theirs.

    Parameters
    ----------
    key : str
        Hash under which it is found again.
    build : callable
        Given an empty folder, writes ``library.so`` into it.

    Returns
    -------
    pathlib.Path
        The library in its place.

    Raises
    ------
    SoftcatError
        If the cache cannot be written. What `build` raises passes through; nothing is left behind.
    """
    place = _libraries() / key
    passing = place.with_name(f".{key}.{secrets.token_hex(4)}")
    try:
        passing.mkdir(parents=True, mode=0o700)
        build(passing)
        digest = hashlib.sha256((passing / LIBRARY).read_bytes()).hexdigest()
        (passing / _DIGEST).write_text(digest + "\n", encoding="ascii")
        return _move(passing, key)
    except OSError as error:
        raise SoftcatError(
            f"cannot write the cache of compiled libraries in {place.parent}: {error.strerror or error}; "
            "set SOFTCAT_CACHE to a folder that can be written"
        ) from error
    finally:
        shutil.rmtree(passing, ignore_errors=True)


def _move(passing: Path, key: str) -> Path:
    place = _libraries() / key
    # A folder cannot replace one that is not empty: another process was faster, or what is there is damaged.
    for _ in range(8):
        try:
            passing.rename(place)
        except OSError:
            found = find(key)
            if found is not None:
                return found
            if not place.exists():
                raise
            _discard(place)
        else:
            return place / LIBRARY
    raise SoftcatError(f"{place} is damaged and cannot be replaced; delete it")


def _discard(place: Path) -> None:
    """Remove an entry; its name is free at once, even while its files are being deleted."""
    aside = place.with_name(f".{place.name}.{secrets.token_hex(4)}")
    try:
        place.rename(aside)
    except FileNotFoundError:
        return  # another process removed it
    shutil.rmtree(aside, ignore_errors=True)


def cache_entries() -> tuple[CacheEntry, ...]:
    """Every library in the cache, the latest first; compilations under way are left out."""
    folder = _libraries()
    names = [path for path in folder.iterdir() if _NAME.fullmatch(path.name)] if folder.is_dir() else []
    found = [_entry(path) for path in names if (path / LIBRARY).is_file()]
    return tuple(sorted(found, key=lambda entry: (-entry.modified, entry.key)))


def clear_cache() -> int:
    """Delete every compiled library, and what broken-off compilations left.

    Returns
    -------
    int
        Bytes freed. Nothing but entries of the cache is touched, whatever else lies in its folder.

    Raises
    ------
    OSError
        If the folder cannot be written.
    """
    folder, freed = _libraries(), 0
    for path in sorted(folder.iterdir()) if folder.is_dir() else ():
        if _NAME.fullmatch(path.name) or _PASSING.fullmatch(path.name):
            freed += _size(path)
            _discard(path) if _NAME.fullmatch(path.name) else shutil.rmtree(path, ignore_errors=True)
    return freed


def _libraries() -> Path:
    return cache_folder() / "native"


def _entry(folder: Path) -> CacheEntry:
    library = folder / LIBRARY
    return CacheEntry(folder.name, library, _size(folder), library.stat().st_mtime)


def _size(folder: Path) -> int:
    return sum(path.stat().st_size for path in folder.iterdir() if path.is_file())
