"""Finished blocks in a folder, one file each: what an interrupted study goes on from."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from softcat_sym.errors import SoftcatError
from softcat_sym.files import made, replace_atomically

FOLDER = "parts"
_MANIFEST, _PATTERN, _CHECK = "manifest.json", "part-*.bin", 32


class KeptBlocks:
    """A folder with a manifest that tells whose it is, and a file for each finished block.

    Parameters
    ----------
    directory : pathlib.Path
        Where the results go; the folder is ``parts`` in it, made when the first block is kept.
    digest : str
        Hash of all that decides the results.
    about : mapping
        What a reader of the manifest is told beside it.
    resume : bool
        Whether to go on from what is there.

    Raises
    ------
    SoftcatError
        If something unfinished is there that is another's, or that is not to be resumed. Nothing is touched.
    """

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
        """Write a block whole or not at all.

        Raises
        ------
        OSError
            If it cannot be written.
        """
        with made(self.folder):
            if not (self.folder / _MANIFEST).exists():
                manifest = {"plan": self._digest, **self._about}
                replace_atomically(self.folder / _MANIFEST, (json.dumps(manifest, indent=2) + "\n").encode())
            replace_atomically(self._path(number), hashlib.sha256(content).digest() + content)

    def drop(self, number: int) -> None:
        """Remove a block that is not needed any more.

        Raises
        ------
        OSError
            If it cannot be removed.
        """
        self._path(number).unlink(missing_ok=True)

    def clear(self) -> None:
        """Remove the folder: the results are there. Files of others in it are let alone.

        Raises
        ------
        OSError
            If a file cannot be removed.
        """
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
