"""Writing a file whole or not at all."""

from __future__ import annotations

import secrets
from collections.abc import Callable, Mapping
from pathlib import Path


def replace_atomically(path: Path, content: bytes) -> Path:
    """Write a file next to its place, then move it there; a reader sees the old file or the new one.

    Parameters
    ----------
    path : pathlib.Path
        Where the file goes; its folder exists.
    content : bytes
        What it holds.

    Returns
    -------
    pathlib.Path
        The path.

    Raises
    ------
    OSError
        If the folder cannot be written or the place is taken by a folder. Nothing is left behind.
    """

    def fill(passing: Path) -> None:
        with passing.open("xb") as stream:
            stream.write(content)

    return fill_atomically(path, fill)


def write_all(directory: str | Path, contents: Mapping[str, bytes]) -> list[Path]:
    """Write several files into a folder, which is made if missing, each as :func:`replace_atomically` does.

    Raises
    ------
    OSError
        If the folder cannot be made or written.
    """
    folder = Path(directory)
    folder.mkdir(parents=True, exist_ok=True)
    return [replace_atomically(folder / name, content) for name, content in contents.items()]


def fill_atomically(path: Path, fill: Callable[[Path], object]) -> Path:
    """Let `fill` write a file next to its place, then move it there.

    Parameters
    ----------
    path : pathlib.Path
        Where the file goes; its folder exists.
    fill : callable
        Given the path of the file to write, which does not exist yet.

    Raises
    ------
    OSError
        As :func:`replace_atomically`.
    """
    # A name of its own keeps two runs into one folder apart. Not tempfile: its files are readable by their owner only.
    passing = path.with_name(f".{path.stem}.{secrets.token_hex(4)}.part{path.suffix}")
    try:
        fill(passing)
        passing.replace(path)
    finally:
        passing.unlink(missing_ok=True)
    return path
