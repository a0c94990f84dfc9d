"""The folder that compiled libraries are kept in: where it is, and whether code may be loaded from it."""

from __future__ import annotations

import atexit
import contextlib
import functools
import os
import shutil
import sys
import tempfile
import time
import warnings
from collections.abc import Iterator
from pathlib import Path

from softcat_sym.errors import SoftcatError

ADVICE = "set SOFTCAT_CACHE to a folder of your own that can be written"
COMPILERS = "compilers.json"
"""What is known of compilers, beside the libraries."""

_LOCK, _MOMENT = "lock", 5.0


def cache_folder() -> Path:
    """SOFTCAT_CACHE, else ``softcat_sym`` in XDG_CACHE_HOME, else in ``~/.cache``; it may not exist yet.

    Raises
    ------
    SoftcatError
        If SOFTCAT_CACHE begins with the home of a user who does not exist.
    """
    chosen, shared = os.environ.get("SOFTCAT_CACHE"), os.environ.get("XDG_CACHE_HOME")
    if chosen:
        try:
            return Path(chosen).expanduser().absolute()
        except RuntimeError as error:
            raise SoftcatError(f"SOFTCAT_CACHE is {chosen!r}: {error}") from error
    if shared:
        return Path(shared).absolute() / "softcat_sym"
    try:
        return Path.home() / ".cache" / "softcat_sym"
    except RuntimeError:  # a user without a home, as in some containers
        return Path(tempfile.gettempdir()) / f"softcat_sym-{os.getuid() if sys.platform != 'win32' else 'user'}"


def libraries() -> Path:
    """The folder of compiled libraries, in the cache; it may not exist yet."""
    return cache_folder() / "native"


def distrust(folder: Path) -> str:
    """Why no code may be loaded from a folder; empty where it is the user's own, or not there.

    Whoever can write there could put a library in, with its digest, that this user would then run. That nobody else
    can is asked of this one folder: who can rename what lies above it can still not fill it in this user's name.
    """
    if sys.platform == "win32":
        return ""
    try:
        status = folder.stat()
    except OSError:
        return ""
    if status.st_uid not in (os.geteuid(), 0):
        return f"{folder} belongs to another user, who could put code there"
    if status.st_mode & 0o022:
        return f"{folder} can be written by others, who could put code there (chmod go-w takes that away)"
    return ""


def make(folder: Path) -> None:
    """Make a folder that only this user can write, with the folders above it.

    Raises
    ------
    OSError
        If it cannot be made, or what is there is not to be trusted.
    """
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if reason := distrust(folder):
        raise PermissionError(reason)


@functools.cache
def temporary(instead_of: Path, reason: str) -> Path:
    """A folder of this process that is gone with it, for libraries that cannot be kept; the user is warned, once."""
    warnings.warn(
        f"compiled libraries cannot be kept in {instead_of}: {reason}; every process compiles its own. To keep them, "
        f"{ADVICE}",
        stacklevel=2,
    )
    made = Path(tempfile.mkdtemp(prefix="softcat_sym-"))
    atexit.register(shutil.rmtree, made, ignore_errors=True)
    return made


@contextlib.contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Mark a folder as in use by this process; the mark is gone when the process is, however it ends."""
    begun = folder / f"{_LOCK}.begun"
    with begun.open("w") as stream:
        if sys.platform != "win32":
            import fcntl

            # Some network file systems know no locks: clearing the cache then also takes what is under way.
            with contextlib.suppress(OSError):
                fcntl.flock(stream, fcntl.LOCK_EX)
        begun.rename(folder / _LOCK)  # so that it is never seen without the lock
        yield


def in_use(folder: Path) -> bool:
    """Whether a process holds the folder :func:`locked`."""
    if sys.platform == "win32":
        return False
    import fcntl

    try:
        with (folder / _LOCK).open("r+") as stream:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    except FileNotFoundError:
        # Made a moment ago, and about to be locked; or what is left of one.
        try:
            return time.time() - folder.stat().st_mtime < _MOMENT
        except FileNotFoundError:
            return False
    except OSError:
        return False
    return False
