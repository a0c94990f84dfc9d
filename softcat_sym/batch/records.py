"""Records of finished members, flat rows of numbers, texts and small arrays: stored in blocks, written as xarray."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from softcat_sym import store
from softcat_sym.batch.executor import Lost, MembersProgress, RunPool, counted
from softcat_sym.batch.members import Row

LOST = "lost"
"""Outcome of a member whose workers died."""

_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")

_CHUNK_MEMBERS, _CHUNK_BYTES = 256, 100_000
"""Most members of a chunk of a file, and most bytes of it before it is packed."""

_MISSING: Mapping[type, object] = {str: "", int: 0}

Record = Mapping[str, Any]
Table = npt.NDArray[Any]
"""A structured array with a field for each column."""


@dataclass(frozen=True)
class RecordColumn:
    """What records hold under a name."""

    units: str  # Empty for texts and counts
    meaning: str
    dims: tuple[str, ...] = ()  # Besides ``member``
    dtype: type = float  # ``str`` for texts

    @property
    def attrs(self) -> dict[str, str]:
        """Attributes of the variable."""
        return {"long_name": self.meaning} | ({"units": self.units} if self.units else {})


def table_of(records: Sequence[Record], columns: Mapping[str, RecordColumn], sizes: Mapping[str, int]) -> Table:
    """Join records; a column that a record does not have is NaN, or an empty text."""
    values = {
        name: [record.get(name, _MISSING.get(column.dtype, np.nan)) for record in records]
        for name, column in columns.items()
    }
    kinds = [
        (name, f"U{max(1, *map(len, values[name]))}")
        if column.dtype is str
        else (name, column.dtype, tuple(sizes[dim] for dim in column.dims))
        for name, column in columns.items()
    ]
    table = np.empty(len(records), kinds)
    for name, column in values.items():
        for number, value in enumerate(column):
            table[name][number] = value
    return table


def versions() -> dict[str, str]:
    """Versions of this program, and of what it calculates with, for the files of a study."""
    return {name: store.version(name) for name in _VERSIONS}


Variables = Mapping[str, tuple[tuple[str, ...], npt.NDArray[Any], Mapping[str, Any]]]
"""Dimensions, values and attributes by name, as :class:`xarray.Dataset` takes them."""


def variables_of(table: Table, columns: Mapping[str, RecordColumn]) -> dict[str, Any]:
    """Variables of a table."""
    return {name: (("member", *column.dims), table[name], column.attrs) for name, column in columns.items()}


def append(file: Any, variables: Variables, start: int, members: int) -> None:
    """Write members from `start` on into an open netCDF file that has room for all; the first call makes its variables.

    xarray itself writes a file from the whole of a dataset, which may be larger than the memory.
    """
    import h5py

    text = h5py.string_dtype()
    for name, (dims, values, attrs) in variables.items():
        if name not in file.variables:
            sizes = (members, *values.shape[1:]) if dims[0] == "member" else values.shape
            for dim, size in zip(dims, sizes, strict=True):
                if dim not in file.dimensions:
                    file.dimensions[dim] = size
            is_text, shape = values.dtype.kind == "U", values.shape[1:]
            at_once = max(1, min(members, _CHUNK_MEMBERS, _CHUNK_BYTES // (values.itemsize * int(np.prod(shape)))))
            packing = {} if is_text else {"compression": "gzip", "compression_opts": 4, "shuffle": True}
            options = {"chunks": (at_once, *shape), **packing} if dims[0] == "member" else {}
            made = file.create_variable(name, dims, dtype=text if is_text else values.dtype, **options)
            made.attrs.update(attrs)
        place = slice(start, start + len(values)) if dims[0] == "member" else ...
        file.variables[name][place] = values.astype(object) if values.dtype.kind == "U" else values


@dataclass(frozen=True)
class Batch:
    """Rows in blocks, of which each is stored when all of its members are finished."""

    members: int  # Number of rows
    block_size: int  # Of the last block at most
    rows: Callable[[int], Sequence[Row]]  # Rows of a block
    key: Callable[[Sequence[Row]], str]  # Key of their table in the store
    columns: Mapping[str, RecordColumn]
    sizes: Mapping[str, int]  # Of the dimensions of the columns

    @property
    def blocks(self) -> int:
        """Number of blocks."""
        return math.ceil(self.members / self.block_size)

    def size(self, number: int) -> int:
        """Number of members of a block."""
        return min(self.block_size, self.members - number * self.block_size)

    def recalled(self) -> Iterator[tuple[int, bytes]]:
        """Blocks that the store has, packed."""
        for number in range(self.blocks):
            content = store.recall(self.key(self.rows(number)))
            if content is not None:
                yield number, content

    def run(
        self,
        missing: Sequence[int],
        work: Callable[[Row], Record],
        pool: RunPool,
        chunk: int,
        progress: MembersProgress | None,
    ) -> Iterator[tuple[int, bytes]]:
        """Run missing blocks, and store each as soon as it is finished, unless workers died."""
        unfinished = defaultdict[int, dict[int, Record | Lost]](dict)
        rows = (row for number in missing for row in self.rows(number))
        before = self.members - sum(map(self.size, missing))
        results = pool.map_members(work, rows, chunk)
        for place, result in counted(results, self.members, before, progress):
            # The last block may be shorter; no other comes after it.
            number = missing[place // self.block_size]
            block = unfinished[number]
            block[place] = result
            if len(block) < self.size(number):
                continue
            del unfinished[number]
            records = [block[place] for place in sorted(block)]
            content = self.packed(
                [{"outcome": LOST, "message": one.message} if isinstance(one, Lost) else one for one in records]
            )
            if not any(isinstance(one, Lost) for one in records):
                store.keep(self.key(self.rows(number)), content)
            yield number, content

    def packed(self, records: Sequence[Record]) -> bytes:
        """The table of some records as bytes."""
        return store.packed({"records": table_of(records, self.columns, self.sizes)})


def unpacked(content: bytes) -> Table:
    """Read what :meth:`Batch.packed` wrote."""
    return store.unpacked(content)["records"]
