"""Unknowns of a filament, and where they stand: slots of its sites, blocks of a grid, the order of a state vector."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Numbers = npt.NDArray[np.int64]

PER_FIBRE = "#"
"""In the name of what stands for all fibres: the place of the fibre's number."""

PLACES, SPEEDS = ("x", "y", "z"), ("u", "v", "w")
"""Position of a node and its velocity."""
TURN, SPIN = ("q0", "q1", "q2", "q3"), ("o1", "o2", "o3")
"""Quaternion of its section in three dimensions, and the spin where a viscous stress asks for it."""

WARMING = "warming"
"""The state of nodes that is their temperature over that at the start, less one."""

WORK_OF_AGEING, HEAT_LOST = "work_ageing", "heat_lost"
"""What the energy stored at a held strain gains as constants of the material change, and what shrinking does; heat
that is given away."""

WORK_OF_NOZZLE, LOST_AT_EXIT = "work_nozzle", "energy_exit"
"""Work of a nozzle on the strand that it guides; energy lost where fresh material is loaded at once."""

PER = "per_"
INVERTED = "cell", "node", "mass"
"""Lengths and mass of a site whose inverses a run is given too, under names that begin with `PER`."""


@dataclass(frozen=True)
class SiteRange:
    """Sites of a field, whatever their number: from `first` to the last but `behind`; or one site alone."""

    first: int  # Site at which the field begins; of a single one counted from the last if negative (-1 is the last)
    behind: int  # Sites left out at the end of the row
    alone: bool = False  # Whether it is `first` only


NODES, CELLS, INNER = SiteRange(0, 0), SiteRange(0, 1), SiteRange(1, 1)
"""All nodes, all cells, the nodes between two cells."""


@dataclass(frozen=True)
class Slot:
    """One unknown of every site."""

    name: str  # ``x``, ``y``, ``u``, ``v``, ``psi``, ``omega``, or a plastic state
    on: str  # ``node``, ``cell``, or ``whole`` where the filament has it once
    held: tuple[bool, bool]  # Whether the first and the last of its sites hold it
    differential: bool  # Whether it has a rate, or balances something
    rate: str  # Name of the unknown that is its rate, or an empty text
    section: bool  # Whether it belongs to the section of one cell

    @property
    def where(self) -> SiteRange:
        """The sites at which it is unknown."""
        if self.on == "whole":
            return SiteRange(0, 0, alone=True)
        return SiteRange(int(self.held[0]), int(self.held[1]) + (self.on == "cell"))


@dataclass(frozen=True)
class Shown:
    """A field that a run stores."""

    name: str
    first: int  # Sites before the first and behind the last one that have it
    behind: int
    summed: bool  # Whether what is stored is the sum over the sites


@dataclass(frozen=True)
class Signature:
    """What a filament computes, by name: all that is known of its program without expressions."""

    slots: tuple[Slot, ...]  # Unknowns of a site, plastic states last
    parameters: tuple[str, ...]  # Numbers that a run is given, as a whole and for each site
    places: tuple[str, ...]
    powers: tuple[str, ...]  # What is integrated beside the unknowns: groups of fields, of which some may be empty
    shown: tuple[Shown, ...]
    # What each plastic state is of a plastic strain a_0 + a_1 zeta; a_1 over the fibre's zeta where it has one.
    profiles: Mapping[str, tuple[float, float]]


@dataclass(frozen=True)
class Block:
    """One kind of unknown on some nodes or cells."""

    name: str  # What it is, for messages
    places: tuple[int, ...]  # Node or cell numbers that carry it
    positions: Floats  # X/L of those places
    start: Floats  # Values in the straight, relaxed filament at rest


class Layout:
    """A state vector made of blocks, ordered by position along the filament."""

    def __init__(self, blocks: Sequence[Block]) -> None:
        self.blocks = tuple(blocks)
        where = np.concatenate([b.positions for b in blocks]) if blocks else np.zeros(0)
        order = np.argsort(where, kind="stable")
        self.order: list[int] = order.tolist()
        self._rank: list[int] = np.argsort(order, kind="stable").tolist()
        kinds = [b.name for b in blocks for _ in b.places]
        self.kinds = tuple(kinds[i] for i in self.order)
        places = [place for b in blocks for place in b.places]
        self.places = tuple(places[i] for i in self.order)
        self.where = where[order]
        values = np.concatenate([b.start for b in blocks]) if blocks else np.zeros(0)
        self.start = values[order]

    def __len__(self) -> int:
        return len(self.order)

    @property
    def unknowns(self) -> list[tuple[str, int]]:
        """Kind of each component, and the number of its node or cell."""
        return list(zip(self.kinds, self.places, strict=True))

    @property
    def names(self) -> tuple[str, ...]:
        """What each component is and where, for messages."""
        parts = zip(self.kinds, self.places, self.where.tolist(), strict=True)
        return tuple(f"{kind}[{place}] at X/L = {at:.4g}" for kind, place, at in parts)

    def split(self, vector: Any) -> dict[str, Any]:
        """The values of each block, by its name, of a state vector."""
        offsets = np.cumsum([0, *(len(b.places) for b in self.blocks)]).tolist()
        stacked = vector[self._rank] if self._rank else vector
        return {b.name: stacked[offsets[k] : offsets[k + 1]] for k, b in enumerate(self.blocks)}
