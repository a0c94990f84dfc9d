"""Results of many kinds in the folder of finished blocks, each under a hash of what decides it."""

from __future__ import annotations

import time
import zlib
from collections.abc import Iterator

from softcat_sym.study.blocks.kept import KeptBlocks

EVERY = 1.0
"""Seconds between two files: what an end by force can cost. Ctrl-C costs nothing, see :meth:`KeptResults.flush`."""

_KEY, _LENGTH = 64, 8
_QUICKLY = 1


class KeptResults:
    """Results in a folder, from which an interrupted command goes on; many to a file, so that files are few.

    A full disk is told, and ends nothing: from then on nothing more is kept.

    Parameters
    ----------
    blocks : KeptBlocks
        The folder.
    every : float
        Seconds between two files.

    Attributes
    ----------
    found : int
        How many results were there.
    trouble : str
        Why no more could be kept, if so.
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
