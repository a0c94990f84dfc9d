"""The cache in the user's own folder: entries that are written once, each named by a hash of all that decides it.

An entry is a file, or a folder of files, that is made beside its place and then renamed. Only what this user (or root)
alone can have put there is read, only what has such a name is deleted, and no link is ever followed.
"""

from __future__ import annotations

import atexit
import contextlib
import errno
import functools
import hashlib
import os
import re
import secrets
import shutil
import stat
import sys
import tempfile
import time
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import platformdirs

from softcat_sym.errors import SoftcatError

LIBRARIES, TEXTS, RESULTS, ZIG = KINDS = "native", "texts", "results", "zig"
"""Compiled libraries; texts that decide what is compiled; results of studies; what zig compiles for itself."""

ADVICE = "set SOFTCAT_CACHE to a folder of your own that can be written"

FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
"""Errors of a disk without space, which is no reason to keep things elsewhere."""

GRACE = 60.0
"""Seconds for which an entry that was asked for is not dropped: another process may be about to load it."""

_LARGEST = 10**9  # bytes of an entry that is read
_NAME = re.compile(r"[0-9a-f]{64}")
_PASSING = re.compile(r"\.[0-9a-f]{64}\.[0-9a-f]{8}")
_ABANDONED = 3600.0  # s, after which nobody works any more on what has a passing name; a compiler has ten minutes


def cache_folder() -> Path:
    """SOFTCAT_CACHE, else the user's folder of caches on this system, without links; it may not exist yet."""
    if chosen := os.environ.get("SOFTCAT_CACHE"):
        try:
            return _without_links(Path(chosen).expanduser().absolute())
        except RuntimeError as error:
            raise SoftcatError(f"SOFTCAT_CACHE is {chosen!r}: {error}") from error
    usual = Path(tempfile.gettempdir()) / f"softcat_sym-{os.getuid() if sys.platform != 'win32' else 'user'}"
    # A user without a home, as in some containers: platformdirs raises, or (before 4.4) leaves the tilde.
    with contextlib.suppress(RuntimeError):
        usual = Path(platformdirs.user_cache_dir("softcat_sym", appauthor=False)).expanduser()
    return _without_links(usual.absolute())


@functools.lru_cache(maxsize=8)
def _without_links(path: Path) -> Path:
    # Looked up once: who may lead a link elsewhere shall not choose, in the middle of a run, among the user's folders.
    return Path(os.path.realpath(path))


def folder(kind: str) -> Path:
    """The folder of a kind of entries in the cache; it may not exist yet."""
    return cache_folder() / kind


def distrust(place: Path) -> str:
    """Why another user may have made a file or folder, or could fill it; empty if this one and root alone can.

    As OpenSSH does with keys, it asks this of every folder above, too. Those may be open to all if they are sticky, as
    that of temporary files is: what is in them is renamed by its owner only. It is to be given a place without links.
    """
    above = (_fault(folder, may_be_sticky=True) for folder in place.parents)
    return _fault(place) or next(filter(None, above), "")


def _fault(place: Path, *, may_be_sticky: bool = False) -> str:
    """The same of a file or folder by itself."""
    try:
        status = place.lstat()
    except OSError:  # it is not there yet
        return ""
    if not (stat.S_ISDIR(status.st_mode) or stat.S_ISREG(status.st_mode)):
        return f"{place} is neither a file nor a folder itself"
    if not _is_own(status):
        return f"{place} belongs to another user, who could put code there"
    if sys.platform != "win32" and status.st_mode & 0o022 and not (may_be_sticky and status.st_mode & stat.S_ISVTX):
        return f"{place} can be written by others, who could put code there (chmod go-w takes that away)"
    return ""


def _is_own(status: os.stat_result) -> bool:
    return sys.platform == "win32" or status.st_uid in (os.geteuid(), 0)


def problem(kind: str) -> str:
    """Why the folder of a kind, which is made if missing, cannot be used; empty if it can. OSError on a full disk."""
    place = folder(kind)
    inside = f"{place}{os.sep}"  # which a file has not
    if (reason := distrust(place)) or os.access(inside, os.W_OK):
        return reason
    try:
        for missing in reversed((place, *place.parents)):
            if not missing.exists():
                missing.mkdir(mode=0o700, exist_ok=True)
    except OSError as error:
        if error.errno in FULL:
            raise
        return error.strerror or str(error)
    return distrust(place) or ("" if os.access(inside, os.W_OK) else "it cannot be written")


def folders(kind: str) -> list[Path]:
    """Where entries of a kind may be found; the last of these folders takes new ones.

    It is that of the user's cache, or else one of this process alone, beside a cache that can only be read.
    """
    usual, reason = folder(kind), problem(kind)
    if not reason:
        return [usual]
    own = _private(cache_folder(), reason) / kind
    own.mkdir(mode=0o700, exist_ok=True)
    return [usual, own] if usual.is_dir() and not distrust(usual) else [own]


@functools.cache
def _private(instead_of: Path, reason: str) -> Path:
    """A folder of this process that is gone with it; the user is warned, once."""
    warnings.warn(
        f"nothing is kept in {instead_of}: {reason}; every process compiles its own libraries. To keep them, {ADVICE}",
        stacklevel=3,
    )
    made = Path(os.path.realpath(tempfile.mkdtemp(prefix="softcat_sym-")))
    atexit.register(shutil.rmtree, made, ignore_errors=True)
    if found := distrust(made):
        raise SoftcatError(f"code cannot be kept safe: {found}; set TMPDIR to a folder of your own")
    return made


def digest(key: str, content: bytes) -> str:
    """Hash of what is kept under a key, so that one in the place of another is found out, too."""
    return hashlib.sha256(key.encode() + content).hexdigest()


def content_of(file: Path) -> bytes:
    """A file of the cache, cut where it is too large; OSError where it is not there, or not of this user alone."""
    if reason := _fault(file):
        raise PermissionError(errno.EPERM, reason)
    with file.open("rb") as stream:
        return stream.read(_LARGEST)


def touch(entry: Path) -> None:
    """Note that an entry was used; a cache that is only read is as good."""
    with contextlib.suppress(OSError):
        os.utime(entry)


@contextlib.contextmanager
def passing(within: Path, key: str) -> Iterator[Path]:
    """The path of something in the making; what is there at the end goes."""
    place = within / f".{key}.{secrets.token_hex(4)}"
    try:
        yield place
    finally:
        if place.is_symlink() or not place.is_dir():
            place.unlink(missing_ok=True)
        else:
            shutil.rmtree(place, ignore_errors=True)  # which removes links, not what they lead to


def remove(entry: Path) -> None:
    """Remove an entry; its name is free at once, even while the files of a folder are being deleted."""
    # Another process may have removed it.
    with passing(entry.parent, entry.name.strip(".")[:64]) as aside, contextlib.suppress(FileNotFoundError):
        entry.rename(aside)


@dataclass(frozen=True, slots=True)
class CacheEntry:
    """What is kept under a key."""

    path: Path
    size: int  # Bytes on disk
    used: float  # When it was last asked for [s since 1970]


def entries(kind: str) -> list[CacheEntry]:
    """Every entry of a kind, the last used first; what is being made, and all that others put there, is left out."""
    return sorted(_named(kind, _NAME), key=lambda entry: -entry.used)


def _named(kind: str, names: re.Pattern[str]) -> list[CacheEntry]:
    found, is_folder = [], kind in (LIBRARIES, ZIG)
    is_kept_as = stat.S_ISDIR if is_folder else stat.S_ISREG
    for place in folders(kind):
        for one in os.scandir(place):
            with contextlib.suppress(OSError):  # another process dropped it
                status = one.stat(follow_symlinks=False)
                if not (names.fullmatch(one.name) and _is_own(status) and is_kept_as(status.st_mode)):
                    continue
                files = Path(one.path).rglob("*") if is_folder else [Path(one.path)]
                size = sum(file.lstat().st_size for file in files if not file.is_dir())
                found.append(CacheEntry(Path(one.path), size, status.st_mtime))
    return found


def trim(kind: str, limit: int, stored: str) -> None:
    """Drop what was used least recently until the rest keeps the limit, and what killed processes left behind.

    A library that a process has loaded stays usable after its file is gone.
    """
    with contextlib.suppress(OSError):  # what was asked for is there: housekeeping can wait for the next time
        found, now = entries(kind), time.time()
        total = sum(entry.size for entry in found)
        for entry in reversed(found):
            if total <= limit:
                break
            if entry.path.name != stored and now - entry.used > GRACE:
                remove(entry.path)
                total -= entry.size
        for entry in _abandoned(kind):
            remove(entry.path)


def _abandoned(kind: str) -> list[CacheEntry]:
    return [entry for entry in _named(kind, _PASSING) if time.time() - entry.used > _ABANDONED]


def clear(*kinds: str) -> dict[str, list[CacheEntry]]:
    """Delete every entry of these kinds and what killed processes left behind, nothing else; return them by kind."""
    if reason := next(filter(None, (distrust(folder(kind)) for kind in kinds)), ""):
        raise SoftcatError(f"the cache is not cleared: {reason}")
    found = {kind: [*entries(kind), *_abandoned(kind)] for kind in kinds}
    try:
        for entry in (entry for of_kind in found.values() for entry in of_kind):
            remove(entry.path)
    except OSError as error:
        raise SoftcatError(f"cannot clear {cache_folder()}: {error.strerror or error}") from error
    return found
