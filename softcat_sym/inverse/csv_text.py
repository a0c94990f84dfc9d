"""Text of a CSV file that a person or an instrument wrote: opening it, its numbers, and how its faults are listed."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.files import read_at_most

_LONGEST = 1 << 24
_FAULTS_SHOWN = 8


def text_of(file: Path, kind: str, accepted: str) -> str:
    """Read a file of UTF-8 text, with or without a byte order mark.

    Parameters
    ----------
    file : pathlib.Path
        Where it is.
    kind : str
        What it should be, with which a refusal starts: ``"flow curve"``.
    accepted : str
        What would be accepted.

    Returns
    -------
    str
        The whole text.

    Raises
    ------
    SoftcatError
        If it is not there, cannot be read, is longer than 16 MiB, or is not text.
    """

    def refused(found: str, where: str = "", instead: str = accepted) -> SoftcatError:
        return refusal(kind, file, [Fault(where, found, instead)])

    try:
        content = read_at_most(file, _LONGEST + 1)
    except FileNotFoundError:
        raise refused("no such file") from None
    except IsADirectoryError:
        raise refused("a directory, not a file") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise refused(f"cannot be read: {reason}") from None
    if len(content) > _LONGEST:
        raise refused(f"longer than 16 MiB, which no {kind} is")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise refused("not UTF-8 text", f"line {line}", "CSV in UTF-8") from None
    if "\0" in text:
        raise refused("not text")
    return text


def data_lines(text: str) -> list[tuple[int, str]]:
    """Number the lines from 1 and keep those that are neither empty nor comments."""
    lines = enumerate(text.splitlines(), start=1)
    return [(number, line) for number, line in lines if line.strip() and not line.lstrip().startswith("#")]


def cells_of(line: str, separator: str = ",") -> list[str]:
    """Split one line into its cells.

    Line by line, since no cell of such a table goes on to the next line, and a stray quote then spoils one row only.
    """
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=separator), [])]
    except csv.Error:
        # A cell of more than 128 KiB, or a stray carriage return: no number either way.
        return [line]


def number_in(text: str) -> float | None:
    """Return the number that a cell holds, perhaps not finite; None if it holds none."""
    # Python reads 1_000 as a thousand; in a table it is a slip.
    if "_" in text:
        return None
    try:
        return float(text)
    except ValueError:
        return None


def counted(count: int, noun: str) -> str:
    """Write a number of things, such as ``1 fault`` or ``2 faults``."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def refusal(kind: str, path: Path | None, faults: Sequence[Fault]) -> SoftcatError:
    """Build the error that lists what is wrong with a file, the first faults in full and the others counted."""
    more = len(faults) - _FAULTS_SHOWN
    listed = [f"  {fault}" for fault in faults[:_FAULTS_SHOWN]] + ([f"  and {more} more"] if more > 0 else [])
    head = f"{kind} {path}" if path else kind
    return SoftcatError("\n".join([f"{head}: {counted(len(faults), 'fault')}", *listed]))
