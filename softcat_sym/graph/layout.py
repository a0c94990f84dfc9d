"""Where each unknown sits in the state vector: sorted along the filament, so that matrices are banded."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from softcat_sym.graph.grid import Floats, Grid


@dataclass(frozen=True)
class Block:
    """One kind of unknown on some nodes or cells.

    Attributes
    ----------
    name : str
        What it is, for messages.
    places : tuple of int
        Node or cell numbers that carry it.
    positions : ndarray
        X/L of those places.
    start : ndarray
        Values in the straight, relaxed filament at rest.
    """

    name: str
    places: tuple[int, ...]
    positions: Floats
    start: Floats


def block(name: str, places: Iterable[int], positions: Floats, start: Floats) -> Block:
    """The unknowns `name` at `places`, given positions and starting values of all nodes (or cells)."""
    chosen = tuple(places)
    index = list(chosen)
    return Block(name, chosen, positions[index], start[index])


class Layout:
    """A state vector made of blocks, ordered by position along the filament.

    Parameters
    ----------
    symbol : str
        Name of the CasADi vector.
    blocks : sequence of Block
        What it holds.
    """

    def __init__(self, symbol: str, blocks: Sequence[Block]) -> None:
        self.blocks = tuple(blocks)
        where = np.concatenate([b.positions for b in blocks]) if blocks else np.zeros(0)
        self._order = np.argsort(where, kind="stable")
        rank = np.argsort(self._order, kind="stable")
        self.vector = ca.SX.sym(symbol, len(where))
        stacked = self.vector[rank.tolist()] if len(where) else self.vector
        offsets = np.cumsum([0, *(len(b.places) for b in blocks)]).tolist()
        self._parts = {b.name: stacked[offsets[k] : offsets[k + 1]] for k, b in enumerate(blocks)}
        labels = [
            f"{b.name}[{place}] at X/L = {at:.4g}"
            for b in blocks
            for place, at in zip(b.places, b.positions, strict=True)
        ]
        self.names = tuple(labels[i] for i in self._order)
        kinds = [b.name for b in blocks for _ in b.places]
        self.kinds = tuple(kinds[i] for i in self._order)
        places = [place for b in blocks for place in b.places]
        self.places = tuple(places[i] for i in self._order)
        self.where = where[self._order]
        values = np.concatenate([b.start for b in blocks]) if blocks else np.zeros(0)
        self.start = values[self._order]

    def field(self, name: str, full: ca.SX) -> ca.SX:
        """The values `full` of all nodes (or cells), with the unknown ones replaced by the state's."""
        result = ca.SX(full)
        for chosen in self.blocks:
            if chosen.name == name:
                for k, place in enumerate(chosen.places):
                    result[place] = self._parts[name][k]
        return result

    def gather(self, fields: dict[str, ca.SX]) -> ca.SX:
        """Stack fields of all nodes (or cells) into the order of the state vector, keeping the unknown places."""
        if not self.blocks:
            return ca.SX(0, 1)
        stacked = ca.vertcat(*(fields[b.name][list(b.places)] for b in self.blocks))
        return stacked[self._order.tolist()]


def node_block(name: str, places: Iterable[int], grid: Grid, start: Floats) -> Block:
    """Unknowns on nodes."""
    return block(name, places, grid.nodes, start)


def cell_block(name: str, grid: Grid) -> Block:
    """Unknowns on all cells, zero at the start."""
    return block(name, range(grid.cells), grid.centres, np.zeros(grid.cells))
