"""Texts kept between processes beside the compiled libraries: what took long to write, under the hash of its causes."""

from __future__ import annotations

import contextlib
import hashlib
import os
import zlib
from pathlib import Path

from softcat_sym.files import replace_atomically
from softcat_sym.native import folder as folders

MOST = 256
"""Texts that are kept; beyond it those go that were not used for longest. One takes some 20 kB."""

_ENDING = ".text"


def texts_folder() -> Path:
    """The folder of kept texts, in the cache; it may not exist yet."""
    return folders.cache_folder() / "texts"


def recall(key: str) -> str | None:
    """The text of a key, if it is there, still what was kept, and nobody else could have put it there."""
    folder = texts_folder()
    if folders.distrust(folder):
        return None
    path = folder / f"{key}{_ENDING}"
    try:
        content = path.read_bytes()
    except OSError:
        return None
    digest, packed = content[:64], content[64:]
    if digest != _digest(key, packed):
        return None
    with contextlib.suppress(OSError):  # a cache that is only read is as good
        os.utime(path)
    return zlib.decompress(packed).decode()


def keep(key: str, text: str) -> None:
    """Keep a text; where that is impossible, it will be written again.

    Parameters
    ----------
    key : str
        Hash of all that the text depends on.
    text : str
        What :func:`recall` will return.
    """
    folder, packed = texts_folder(), zlib.compress(text.encode(), 1)
    with contextlib.suppress(OSError):
        folders.make(folder)
        replace_atomically(folder / f"{key}{_ENDING}", _digest(key, packed) + packed)
        for path in kept_texts()[MOST:]:
            path.unlink(missing_ok=True)


def kept_texts() -> list[Path]:
    """Files of all texts, the last used first."""
    used = []
    for path in texts_folder().glob(f"*{_ENDING}"):
        with contextlib.suppress(OSError):  # another process dropped it
            used.append((path.stat().st_mtime, path))
    return [path for _, path in sorted(used, reverse=True)]


def clear_texts() -> int:
    """Delete every text, and say how many bytes that freed.

    Raises
    ------
    OSError
        If one cannot be deleted.
    """
    freed = 0
    for path in kept_texts():
        with contextlib.suppress(FileNotFoundError):
            freed += path.stat().st_size
            path.unlink()
    return freed


def _digest(key: str, packed: bytes) -> bytes:
    """Hash of a text under its key, so that one in the place of another is found out, too."""
    return hashlib.sha256(key.encode() + packed).hexdigest().encode()
