"""A sweep whose members are the rows of a CSV file; its header names the keys."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from pathlib import Path

from softcat_sym.ensemble.table import is_number, kind_of
from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.inverse.csv_text import cells_of, counted, data_lines, number_in, refusal, text_of
from softcat_sym.scene import Scene
from softcat_sym.scene.kinds import Quantity
from softcat_sym.scene.overriding import read_overrides
from softcat_sym.scene.units import NotAQuantity, shown, to_si_of_any
from softcat_sym.study.sweep.axes import SweepAxis

_KIND = "table of a sweep"
_FORM = "a header of dotted keys, groups.G,material.yield_stress [kPa], and a row of values for each member"
_HEADER = re.compile(r"([A-Za-z_][\w-]*(?:\.[A-Za-z_][\w-]*)*)\s*(?:[\[(]\s*([^\])]*?)\s*[\])])?")


def read_table(scene: Scene, path: str | Path) -> tuple[SweepAxis, ...]:
    """Read the members of a sweep.

    Parameters
    ----------
    scene : Scene
        Whose keys are varied.
    path : str or pathlib.Path
        A CSV file; a unit for the plain numbers of a column may stand behind its key, in brackets. Lines that begin
        with # are comments.

    Returns
    -------
    tuple of SweepAxis
        Equally long columns.

    Raises
    ------
    SoftcatError
        With its faults, and their lines.
    """
    file = Path(path)
    lines = data_lines(text_of(file, _KIND, _FORM))
    if not lines:
        raise refusal(_KIND, file, [Fault("", "empty", _FORM)])
    header = _header(file, *lines[0])
    if len(lines) == 1:
        raise refusal(_KIND, file, [Fault("", "no rows below the header", _FORM)])
    faults: list[Fault] = []
    rows: list[list[object]] = []
    for number, line in lines[1:]:
        row, wrong = _row(scene, header, cells_of(line))
        rows.append(row)
        faults += [Fault(f"line {number}{fault.path}", fault.found, fault.accepted) for fault in wrong]
    if faults:
        raise refusal(_KIND, file, faults)
    columns = zip(*rows, strict=True)
    return tuple(SweepAxis(key, tuple(column)) for (key, _), column in zip(header, columns, strict=True))


def _row(scene: Scene, header: Sequence[tuple[str, str]], cells: Sequence[str]) -> tuple[list[object], list[Fault]]:
    """The values of a row, and what is wrong with them."""
    if len(cells) != len(header):
        found = f"{counted(len(cells), 'value')}, but the header has {counted(len(header), 'key')}"
        return [], [Fault("", found, "a value for each key")]
    row: list[object] = []
    faults: list[Fault] = []
    for (key, unit), cell in zip(header, cells, strict=True):
        value = _value(key, unit, cell)
        needed = "" if unit or not is_number(value) else _unit_needed(scene, key)
        if needed:
            value = Fault(key, f"{shown(cell)} has no unit", f"a unit, or in the header: {key} [{needed}]")
        if isinstance(value, Fault):
            faults.append(Fault(f", {key}", value.found, value.accepted))
        row.append(value)
    return row, faults


def _header(file: Path, number: int, line: str) -> list[tuple[str, str]]:
    """Keys and units.

    Raises
    ------
    SoftcatError
        If the line holds anything else, or a key twice.
    """
    found: list[tuple[str, str]] = []
    faults: list[Fault] = []
    for cell in cells_of(line):
        match = _HEADER.fullmatch(cell)
        if match is None or ("." not in match[1] and match[1] != "model"):
            faults.append(Fault(f"line {number}", f"{shown(cell)} is no dotted key", _FORM))
        elif match[1] in {key for key, _ in found}:
            faults.append(Fault(f"line {number}", f"{match[1]} stands there twice", "each key once"))
        else:
            found.append((match[1], match[2] or ""))
            faults += _unit_faults(f"line {number}, {match[1]}", match[2] or "1")
    if faults:
        raise refusal(_KIND, file, faults)
    return found


def _unit_faults(where: str, unit: str) -> list[Fault]:
    """What is wrong with the unit of a column that nobody knows."""
    try:
        to_si_of_any(f"1 {unit}" if unit != "1" else 1)
    except NotAQuantity as found:
        return [Fault(where, str(found), "a unit, such as [mm]")]
    return []


def _value(key: str, unit: str, cell: str) -> object:
    """What a cell holds, or what is wrong with it."""
    if not cell:
        return Fault(key, "an empty cell", "a value")
    number = number_in(cell)
    if number is None:
        overrides, faults = read_overrides([f"{key}={cell}"])
        return faults[0] if faults else overrides[0].value
    if not math.isfinite(number):
        return Fault(key, f"{shown(cell)} is not finite", "a finite number")
    if unit and unit != "1":
        return f"{cell} {unit}"
    return int(cell) if re.fullmatch(r"[+-]?\d+", cell) else number


def _unit_needed(scene: Scene, key: str) -> str:
    """An example of the unit that a key needs; an empty text if it needs none."""
    kind = kind_of(scene, {}, key)
    return kind.example.split()[-1] if isinstance(kind, Quantity) else ""


def columns_of(axes: Sequence[SweepAxis]) -> int:
    """How many rows columns have.

    Raises
    ------
    SoftcatError
        If they are not equally long.
    """
    lengths = {axis.key: len(axis.values) for axis in axes}
    if len(set(lengths.values())) > 1:
        found = ", ".join(f"{key} has {count}" for key, count in lengths.items())
        raise SoftcatError(f"axes of unequal lengths cannot be zipped: {found}; give each as many values, or take grid")
    return next(iter(lengths.values()))
