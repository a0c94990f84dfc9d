"""The parts of a sweep joined into one netCDF file and one table, a part at a time in memory."""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically
from softcat_sym.study.blocks import KeptBlocks
from softcat_sym.study.sweep.columns import VariedColumn, columns_of
from softcat_sym.study.sweep.part_file import NUMBERS, TEXTS, Columns, unpacked
from softcat_sym.study.sweep.plan import SHAPE_FRAMES, SHAPE_NODES, SweepPlan

STORE, TABLE = "sweep.nc", "sweep.csv"

_ABOUT: Final[Mapping[str, tuple[str, str]]] = {
    "outcome": ("", "how the run ended; refused: no sound scene; failed: the program; lost: its worker died"),
    "regime": ("", "what the run shows; empty if it is no answer"),
    "message": ("", "why it is no answer"),
    "midpoint_final": ("m", "height of midspan at the end, negative down"),
    "sag_largest": ("m", "largest sag of midspan, positive down"),
    "sag_over_span": ("1", "largest sag of midspan over the span"),
    "time_to_90": ("s", "when the sag first reaches 90 % of its last value"),
    "largest_stretch": ("1", "largest stretch of the centreline, anywhere and ever"),
    "energy_residual": ("1", "imbalance of energy over the largest energy"),
    "wall_s": ("s", "wall time, beside other members"),
    "span": ("m", "span of the filament"),
    "thickness": ("m", "thickness of the undeformed filament"),
    "duration": ("s", "duration of the run"),
}
_SHAPES: Final = (("x", "m", "across"), ("y", "m", "height"), ("stretch", "1", "stretch of the centreline"))
_CHUNK = 256


@dataclass
class Counts:
    """How members ended.

    Attributes
    ----------
    outcomes, regimes : Counter
        Members of each.
    """

    outcomes: Counter[str] = field(default_factory=Counter)
    regimes: Counter[str] = field(default_factory=Counter)

    def add(self, part: Columns) -> None:
        """Count the members of a part."""
        self.outcomes.update(part["outcome"].tolist())
        self.regimes.update(regime for regime in part["regime"].tolist() if regime)


def parts_of(plan: SweepPlan, kept: KeptBlocks) -> Iterator[tuple[int, Columns]]:
    """The first member and the columns of each part, varied values included, in order.

    Raises
    ------
    SoftcatError
        If a part is not there or harmed.
    """
    varied = columns_of(plan)
    for number in range(plan.blocks):
        content = kept.read(number)
        if content is None:
            raise SoftcatError(f"a part of the sweep in {kept.folder} is gone; the same command with --resume mends it")
        rows = plan.block(number).items
        part = unpacked(content)
        for column in varied:
            values = [row[column.key] for row in rows]
            part[column.key] = np.array(list(map(str, values))) if column.is_text else column.numbers(values)
        yield number * plan.block_size, part


def write_store(plan: SweepPlan, kept: KeptBlocks, directory: Path) -> Counts:
    """Join the parts into ``sweep.nc``.

    Raises
    ------
    OSError
        If it cannot be written. Nothing is left behind.
    SoftcatError
        As :func:`parts_of`.
    """
    counts = Counts()

    def fill(passing: Path) -> None:
        import h5netcdf

        with h5netcdf.File(passing, "w") as file:
            _make(file, plan)
            for start, part in parts_of(plan, kept):
                _put(file, plan, start, part)
                counts.add(part)

    fill_atomically(directory / STORE, fill)
    return counts


def counts_of(plan: SweepPlan, directory: Path) -> Counts | None:
    """How the members of a finished sweep ended; None if there is no store of this plan."""
    import h5netcdf

    try:
        with h5netcdf.File(directory / STORE, "r") as file:
            if file.attrs.get("plan") != plan.digest:
                return None
            counts = Counts()
            for start in range(0, plan.members, _CHUNK):
                rows = slice(start, start + _CHUNK)
                counts.add({name: np.asarray(file.variables[name][rows]).astype(str) for name in TEXTS})
            return counts
    except (OSError, KeyError):
        return None


def write_table(plan: SweepPlan, kept: KeptBlocks, directory: Path) -> None:
    """Write ``sweep.csv``: a row for each member.

    Raises
    ------
    OSError
        If it cannot be written.
    """

    def fill(passing: Path) -> None:
        with passing.open("x", newline="", encoding="utf-8") as stream:
            writer = csv.writer(stream, lineterminator="\n")
            writer.writerow(["member", *(_headed(column) for column in columns_of(plan)), *map(_named, _ABOUT)])
            for start, part in parts_of(plan, kept):
                columns = [part[name].tolist() for name in (*plan.keys, *_ABOUT)]
                for k, row in enumerate(zip(*columns, strict=True)):
                    writer.writerow([start + k, *map(_cell, row)])

    fill_atomically(directory / TABLE, fill)


def _cell(value: object) -> str:
    """A value of the table; an empty cell where there is none."""
    if isinstance(value, float):
        return repr(value) if value == value else ""
    return str(value)


def _headed(column: VariedColumn) -> str:
    return column.key if column.units in ("", "1") else f"{column.key} [{column.units}]"


def _named(name: str) -> str:
    unit = _ABOUT[name][0]
    return name if unit in ("", "1") or name.endswith("_s") else f"{name} [{unit}]"


def _make(file: Any, plan: SweepPlan) -> None:
    """Dimensions and empty variables."""
    import h5py

    frames, members = plan.scene.run.frames, plan.members
    file.dimensions = {"member": members, "frame": frames}
    if plan.shapes:
        file.dimensions["shape_frame"], file.dimensions["shape_node"] = SHAPE_FRAMES, SHAPE_NODES
    file.attrs.update(
        {"title": plan.scene.title, "scene": plan.scene.to_toml(), "section": plan.scene.filament.section}
        | {"plan": plan.digest, "mode": plan.mode}
    )
    packing = {"compression": "gzip", "compression_opts": 4, "shuffle": True}
    text = h5py.string_dtype()
    few = min(members, _CHUNK)

    def make(name: str, dims: tuple[str, ...], dtype: Any, chunks: tuple[int, ...], attrs: dict[str, Any]) -> None:
        packed = {} if dtype is text else packing
        file.create_variable(name, dims, dtype=dtype, chunks=chunks, **packed).attrs.update(attrs)

    share = {"units": "1", "long_name": "time over the duration of the member"}
    file.create_variable("frame", ("frame",), data=np.linspace(0.0, 1.0, frames)).attrs.update(share)
    for column in columns_of(plan):
        about: dict[str, Any] = {"varied": 1, "scale": column.scale} | ({"units": column.units} if column.units else {})
        make(column.key, ("member",), text if column.is_text else float, (few,), about)
    for name, (unit, meaning) in _ABOUT.items():
        about = {"long_name": meaning} | ({"units": unit} if unit else {})
        make(name, ("member",), text if name in TEXTS else float, (few,), about)
    whole = {"units": "m", "long_name": "height of midspan, negative down; NaN where there is no answer"}
    make("midpoint", ("member", "frame"), float, (min(members, 64), frames), whole)
    for name, unit, meaning in _SHAPES if plan.shapes else ():
        size = (min(members, 16), SHAPE_FRAMES, SHAPE_NODES)
        about = {"units": unit, "long_name": f"{meaning}, at equal steps of time and material"}
        make(name, ("member", "shape_frame", "shape_node"), np.float32, size, about)


def _put(file: Any, plan: SweepPlan, start: int, part: Columns) -> None:
    """A part into its rows."""
    count = len(part["outcome"])
    rows = slice(start, start + count)
    for name in (*plan.keys, *TEXTS, *NUMBERS):
        values: npt.NDArray[Any] = part[name]
        file.variables[name][rows] = values.astype(object) if values.dtype.kind == "U" else values
    file.variables["midpoint"][rows] = part["midpoint"]
    if plan.shapes:
        nothing = np.full((count, len(_SHAPES), SHAPE_FRAMES, SHAPE_NODES), np.nan, dtype=np.float32)
        shapes = part.get("shapes", nothing)
        for k, (name, _, _) in enumerate(_SHAPES):
            file.variables[name][rows] = shapes[:, k]
