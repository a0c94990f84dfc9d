"""Finished blocks in a folder, one file each: what an interrupted study goes on from."""

from __future__ import annotations

import hashlib
import json
import time
import zlib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from softcat_sym.errors import SoftcatError
from softcat_sym.files import made, replace_atomically

FOLDER = "parts"
_MANIFEST, _PATTERN, _CHECK = "manifest.json", "part-*.bin", 32


class KeptBlocks:
    """A folder with a manifest that tells whose it is, and a file for each finished block."""

    def __init__(self, directory: Path, digest: str, about: Mapping[str, Any], *, resume: bool) -> None:
        self.directory, self.folder = directory, directory / FOLDER
        self._digest, self._about = digest, dict(about)
        owner = _owner(self.folder / _MANIFEST)
        if owner is not None and owner != digest:
            raise SoftcatError(
                f"{self.folder} holds what is finished of another plan (scene, values, options, or version differ): "
                "give the command that began it with --resume, remove that folder, or name another DIR"
            )
        if owner is not None and not resume:
            raise SoftcatError(
                f"{self.folder} holds what is finished of this very plan: add --resume to go on from there, or remove "
                "that folder to begin anew"
            )

    def numbers(self) -> set[int]:
        """Of the blocks that are there, unharmed or not."""
        return {int(path.stem.removeprefix("part-")) for path in self.folder.glob(_PATTERN)}

    def sound(self) -> set[int]:
        """Of the blocks that are there and can be read."""
        return {number for number in self.numbers() if self.read(number) is not None}

    def read(self, number: int) -> bytes | None:
        """What a file holds; None if it is not there or harmed."""
        try:
            content = self._path(number).read_bytes()
        except FileNotFoundError:
            return None
        check, held = content[:_CHECK], content[_CHECK:]
        return held if check == hashlib.sha256(held).digest() else None

    def keep(self, number: int, content: bytes) -> None:
        """Write a block whole or not at all."""
        with made(self.folder):
            if not (self.folder / _MANIFEST).exists():
                manifest = {"plan": self._digest, **self._about}
                replace_atomically(self.folder / _MANIFEST, (json.dumps(manifest, indent=2) + "\n").encode())
            replace_atomically(self._path(number), hashlib.sha256(content).digest() + content)

    def drop(self, number: int) -> None:
        """Remove a block that is not needed any more."""
        self._path(number).unlink(missing_ok=True)

    def clear(self) -> None:
        """Remove the folder: the results are there. Files of others in it are let alone."""
        if not self.folder.is_dir():
            return
        # The manifest last: what is left after an interruption still tells whose it is.
        _unlink(self.folder.glob(_PATTERN))
        _unlink([self.folder / _MANIFEST])
        if not any(self.folder.iterdir()):
            self.folder.rmdir()

    def _path(self, number: int) -> Path:
        return self.folder / f"part-{number:06d}.bin"


def kept_text(directory: Path) -> str:
    """What an interruption has left, and how to go on; an empty text if there is nothing."""
    folder = directory / FOLDER
    count = sum(1 for _ in folder.glob(_PATTERN))
    if not count or not (folder / _MANIFEST).exists():
        return ""
    what = "1 finished block is" if count == 1 else f"{count} finished blocks are"
    return f"{what} in {folder}: the same command with --resume goes on from there"


def _owner(manifest: Path) -> str | None:
    """Whose parts there are; None if there are none."""
    try:
        told = json.loads(manifest.read_text(encoding="utf-8"))
    except (FileNotFoundError, NotADirectoryError):
        return None
    except ValueError:
        return ""
    return str(told.get("plan", "")) if isinstance(told, dict) else ""


def _unlink(paths: Iterable[Path]) -> None:
    for path in paths:
        path.unlink(missing_ok=True)


EVERY = 1.0
"""Seconds between two files: what an end by force can cost. Ctrl-C costs nothing, see :meth:`KeptResults.flush`."""

_KEY, _LENGTH = 64, 8
_QUICKLY = 1


class KeptResults:
    """Results in a folder, from which an interrupted command goes on; many to a file, so that files are few.

    A full disk is told, and ends nothing: from then on nothing more is kept.
    """

    def __init__(self, blocks: KeptBlocks, every: float = EVERY) -> None:
        self._blocks, self._every = blocks, every
        self.found, self.trouble = 0, ""
        self._files: dict[str, int] = {}
        self._next, self._serial = 0, 0
        self._waiting: dict[str, tuple[int, bytes]] = {}
        self._begun: dict[int, int] = {}  # of every file of ours, the serial number of its first result
        self._idle: set[int] = set()
        self._open: tuple[int, dict[str, bytes]] = (-1, {})
        self._written = time.monotonic()
        for number in sorted(blocks.numbers()):
            self._files |= dict.fromkeys(self._read(number), number)
            self._next = number + 1

    def find(self, key: str) -> bytes | None:
        """Return what was kept under a key, None if nothing was, or if it was harmed."""
        if key in self._waiting:
            content: bytes | None = self._waiting[key][1]
        else:
            content = self._read(self._files[key]).get(key) if key in self._files else None
        self.found += content is not None
        return None if content is None else zlib.decompress(content)

    def mark(self) -> int:
        """Return a number for this moment."""
        return self._serial

    def keep(self, key: str, content: bytes, since: int) -> None:
        """Keep a result; what was kept since a moment was part of it, and is not needed any more."""
        if self.trouble:
            return
        self._waiting = {name: one for name, one in self._waiting.items() if one[0] < since}
        self._idle |= {number for number, first in self._begun.items() if first >= since}
        self._waiting[key] = (self._serial, zlib.compress(content, _QUICKLY))
        self._serial += 1
        if time.monotonic() - self._written >= self._every:
            self.flush()

    def flush(self) -> None:
        """Write what waits, then remove what it has made idle."""
        self._written = time.monotonic()
        if not self._waiting or self.trouble:
            return
        parts = [_part(key, content) for key, (_, content) in self._waiting.items()]
        try:
            self._blocks.keep(self._next, b"".join(parts))
            for number in self._idle:
                self._blocks.drop(number)
        except OSError as error:
            self.trouble = f"cannot keep what is finished in {self._blocks.folder}: {error.strerror or error}"
            return
        self._files = {key: number for key, number in self._files.items() if number not in self._idle}
        self._begun = {number: first for number, first in self._begun.items() if number not in self._idle}
        self._files |= dict.fromkeys(self._waiting, self._next)
        self._begun[self._next] = min(serial for serial, _ in self._waiting.values())
        self._waiting, self._idle, self._next = {}, set(), self._next + 1

    def clear(self) -> None:
        """Remove the folder: what was asked is there."""
        self._waiting = {}
        self._blocks.clear()

    def _read(self, number: int) -> dict[str, bytes]:
        """Results of a file, the last one read at hand."""
        if self._open[0] != number:
            self._open = (number, dict(_parts(self._blocks.read(number) or b"")))
        return self._open[1]


def _part(key: str, content: bytes) -> bytes:
    return key.encode() + len(content).to_bytes(_LENGTH, "little") + content


def _parts(content: bytes) -> Iterator[tuple[str, bytes]]:
    at = 0
    while at < len(content):
        begin = at + _KEY + _LENGTH
        end = begin + int.from_bytes(content[begin - _LENGTH : begin], "little")
        yield content[at : at + _KEY].decode(), content[begin:end]
        at = end
