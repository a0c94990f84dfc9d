"""Writing files whole or not at all, one by one or all together; and reading what a user names without end."""

from __future__ import annotations

import errno
import json
import math
import os
import secrets
import select
import stat
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from contextvars import ContextVar
from dataclasses import fields, is_dataclass
from enum import Enum
from importlib import import_module
from pathlib import Path
from typing import Any

_waiting: ContextVar[tuple[dict[Path, Path], set[Path]] | None] = ContextVar("waiting", default=None)
"""Files that are written but not in their place yet, with their places, and folders that were made for them."""

_PATIENCE = 5.0  # s, for whoever writes into a pipe to begin


def read_limited(path: str | os.PathLike[str], size: int) -> bytes:
    """Read the first `size` bytes of a file, or of a pipe such as a shell's ``<(command)``."""

    def opener(name: str, flags: int) -> int:
        # Otherwise opening a pipe waits for a writer, for ever.
        return os.open(name, flags | getattr(os, "O_NONBLOCK", 0))

    with open(path, "rb", opener=opener) as file:
        if stat.S_ISFIFO(os.fstat(file.fileno()).st_mode) and hasattr(os, "set_blocking"):
            if not select.select([file], [], [], _PATIENCE)[0]:
                raise OSError(errno.ETIMEDOUT, f"a pipe into which nobody has written for {_PATIENCE:.0f} s")
            os.set_blocking(file.fileno(), True)
        return file.read(size)


def replace_atomically(path: Path, content: bytes) -> Path:
    """Write a file next to its place, then move it there; a reader sees the old file or the new one."""

    def fill(passing: Path) -> None:
        with passing.open("xb") as stream:
            stream.write(content)

    return fill_atomically(path, fill)


def write_results(directory: str | Path, contents: Mapping[str, object]) -> list[Path]:
    """Write figures as PNG, frames as CSV, documents as JSON, texts and bytes as they are, :func:`written_together`.

    Folders that are missing are made. A content may be a function that makes it; everything is made before anything is
    written. What is None is left out.
    """
    made_now = ((name, content() if callable(content) else content) for name, content in contents.items())
    encoded = {Path(directory) / name: _encoded(content) for name, content in made_now if content is not None}
    with ExitStack() as folders, written_together():
        for folder in dict.fromkeys(path.parent for path in encoded):
            folders.enter_context(new_folder(folder))
        return [replace_atomically(path, content) for path, content in encoded.items()]


def _encoded(content: Any) -> bytes:
    if isinstance(content, bytes):
        return content
    if isinstance(content, str):
        return content.encode()
    if hasattr(content, "savefig"):
        return figure_bytes(content)
    if hasattr(content, "to_csv"):
        table: str = content.to_csv(index=False, lineterminator="\n")
        return table.encode()
    return json_bytes(content)


def figure_bytes(figure: Any) -> bytes:
    """Draw a figure of Matplotlib as PNG, in the style of this package."""
    content: bytes = import_module("softcat_sym.plotting.style").png(figure)
    return content


def json_bytes(content: object, *, is_ascii: bool = True) -> bytes:
    """A document, dataclasses and arrays in it as JSON has them; what is not finite is null."""
    return (json.dumps(finite(content), indent=2, allow_nan=False, ensure_ascii=is_ascii) + "\n").encode()


def finite(value: Any) -> Any:
    """The same in JSON's types, with None in place of numbers that JSON cannot say."""
    if isinstance(value, Mapping):
        return {name: finite(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [finite(part) for part in value]
    if is_dataclass(value):
        return {part.name: finite(getattr(value, part.name)) for part in fields(value)}
    if isinstance(value, Enum) and not isinstance(value, str):
        return value.name
    if hasattr(value, "tolist"):  # an array or number of NumPy
        return finite(value.tolist())
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    return None if isinstance(value, float) and not math.isfinite(value) else value


@contextmanager
def new_folder(directory: str | Path) -> Iterator[Path]:
    """Make a folder and those above it, if they are missing; if then nothing comes into them, they go again."""
    folder = Path(directory)
    missing = [place for place in (folder, *folder.parents) if not place.exists()]
    if waiting := _waiting.get():
        waiting[1].update(missing)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        yield folder
    except BaseException:
        for place in missing:
            with suppress(OSError):  # there is something in it, or it was never made
                place.rmdir()
        raise


@contextmanager
def named(path: Path) -> Iterator[None]:
    """Let an error of the system that names no file, as that of a full disk, name this one."""
    try:
        yield
    except OSError as error:
        if error.errno is not None and error.filename is None:
            error.filename = str(path)
        raise


@contextmanager
def written_together() -> Iterator[None]:
    """Move what is written meanwhile into place only when all of it is: a full disk then leaves the old files alone."""
    if _waiting.get() is not None:
        yield
        return
    waiting, folders = dict[Path, Path](), set[Path]()
    before = _waiting.set((waiting, folders))
    try:
        yield
        for path in waiting.values():
            if path.is_dir():
                raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
        for passing, path in waiting.items():
            passing.replace(path)
    finally:
        _waiting.reset(before)
        for passing in waiting:
            passing.unlink(missing_ok=True)
        for place in sorted(folders, reverse=True):  # those inside first
            with suppress(OSError):  # there is something in it
                place.rmdir()


def fill_atomically(path: Path, fill: Callable[[Path], object]) -> Path:
    """Let `fill` write a file next to its place, then move it there; within :func:`written_together`, later."""
    # A name of its own keeps two runs into one folder apart. Not tempfile: its files are readable by their owner only.
    passing = path.with_name(f".{path.stem}.{secrets.token_hex(4)}.part{path.suffix}")
    waiting, kept = _waiting.get(), False
    try:
        with named(path):
            fill(passing)
        if waiting is None:
            passing.replace(path)
        else:
            waiting[0][passing] = path
            kept = True
    finally:
        if not kept:
            passing.unlink(missing_ok=True)
    return path
