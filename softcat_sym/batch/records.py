"""Records of finished members, flat rows of numbers, texts and small arrays: a table, stored in blocks."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
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
_MISSING: Mapping[type, object] = {str: "", int: 0}

Record = Mapping[str, Any]
Table = dict[str, npt.NDArray[Any]]
"""A column of values by name, shape (members, ...)."""


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


Columns = Mapping[str, RecordColumn]


def table_of(records: Sequence[Record], columns: Columns, sizes: Mapping[str, int]) -> Table:
    """Join records; a column that a record does not have is NaN, or an empty text; `sizes` are those of dimensions."""
    table = Table()
    for name, column in columns.items():
        missing, shape = _MISSING.get(column.dtype, np.nan), tuple(sizes[dim] for dim in column.dims)
        values = [record.get(name, missing) for record in records]
        table[name] = np.array([np.broadcast_to(value, shape) for value in values] if shape else values, column.dtype)
    return table


def variables_of(table: Table, columns: Columns) -> dict[str, Any]:
    """Variables of a table, as :class:`xarray.Dataset` takes them."""
    return {name: (("member", *column.dims), table[name], column.attrs) for name, column in columns.items()}


def versions() -> dict[str, str]:
    """Versions of this program, and of what it calculates with, for the files of a study."""
    return {name: store.version(name) for name in _VERSIONS}


@dataclass(frozen=True)
class Batch:
    """Rows to run, in blocks, of which each is stored when all of its members are finished."""

    rows: Sequence[Row]
    block_size: int
    key: Callable[[Sequence[Row]], str]  # Key of the table of a block in the store
    columns: Columns
    sizes: Mapping[str, int]  # Of the dimensions of the columns

    def block(self, number: int) -> Sequence[Row]:
        """The rows of a block."""
        return self.rows[number * self.block_size : (number + 1) * self.block_size]

    def stored(self) -> dict[int, Table]:
        """The tables of finished blocks, by number."""
        numbers = range(-(-len(self.rows) // self.block_size))
        contents = ((number, store.recall(self.key(self.block(number)))) for number in numbers)
        return {number: store.unpacked(content) for number, content in contents if content is not None}

    def run(
        self,
        tables: dict[int, Table],
        work: Callable[[Row], Record],
        pool: RunPool,
        chunk: int,
        progress: MembersProgress | None,
    ) -> Table:
        """Run the blocks that are not among these tables; the whole table."""
        missing = [n for n in range(-(-len(self.rows) // self.block_size)) if n not in tables]
        rows = [row for number in missing for row in self.block(number)]
        results = pool.map_members(work, rows, chunk)
        unfinished: dict[int, dict[int, Record | Lost]] = {number: {} for number in missing}
        for place, result in counted(results, len(self.rows), len(self.rows) - len(rows), progress):
            # The last block may be shorter; no other comes after it.
            number = missing[place // self.block_size]
            unfinished[number][place] = result
            if len(unfinished[number]) == len(self.block(number)):
                tables[number] = self._keep(number, [one for _, one in sorted(unfinished.pop(number).items())])
        return {name: np.concatenate([tables[n][name] for n in sorted(tables)]) for name in self.columns}

    def _keep(self, number: int, results: Sequence[Record | Lost]) -> Table:
        """The table of a finished block, stored unless workers died."""
        records = [{"outcome": LOST, "message": one.message} if isinstance(one, Lost) else one for one in results]
        table = table_of(records, self.columns, self.sizes)
        if not any(isinstance(one, Lost) for one in results):
            store.keep(self.key(self.block(number)), store.packed(table))
        return table
