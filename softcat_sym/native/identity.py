"""What compilers said when they were asked for their version, kept on disk: a cache hit starts no process."""

from __future__ import annotations

import contextlib
import json
import shutil
import time
from collections.abc import Sequence
from pathlib import Path

from softcat_sym.files import replace_atomically
from softcat_sym.native import folder as folders

_DAY = 86400.0
_KEPT = 32


def fingerprint(command: Sequence[str]) -> str:
    """Path, size and time of change of every executable that a command names: ``ccache gcc`` names two."""
    found = [path for word in command if not word.startswith("-") and (path := shutil.which(word)) is not None]
    return json.dumps([(path, (status := Path(path).stat()).st_size, status.st_mtime_ns) for path in found])


def recall(command: Sequence[str], files: str) -> str | None:
    """What a compiler said before, if its files are the same.

    A wrapper's file does not change with the compiler behind it, so what was said counts for a day.
    """
    known = _read().get(json.dumps(list(command)))
    try:
        if known is not None and known["files"] == files and 0 <= time.time() - float(str(known["time"])) < _DAY:
            return str(known["version"])
    except (KeyError, TypeError, ValueError):
        return None
    return None


def remember(command: Sequence[str], files: str, version: str) -> None:
    """Keep what a compiler said; where that is impossible, it will be asked again."""
    known = dict(list(_read().items())[-_KEPT:])
    known[json.dumps(list(command))] = {"files": files, "version": version, "time": time.time()}
    native = folders.libraries()
    with contextlib.suppress(OSError):
        folders.make(native)
        replace_atomically(native / folders.COMPILERS, json.dumps(known, indent=1).encode())


def _read() -> dict[str, dict[str, object]]:
    native = folders.libraries()
    if folders.distrust(native):
        return {}
    try:
        known = json.loads((native / folders.COMPILERS).read_bytes())
    except (OSError, ValueError):
        return {}
    return {key: value for key, value in known.items() if isinstance(value, dict)} if isinstance(known, dict) else {}
