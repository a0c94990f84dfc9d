"""Where the unknowns of a filament stand in the rows of sites that C works on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats, Slot


@dataclass(frozen=True)
class Sites:
    """Where the unknowns of a graph are in the rows of sites."""

    shape: tuple[int, int]  # Sites and slots
    x: npt.NDArray[np.int64]  # Flat index of each differential and each algebraic unknown
    z: npt.NDArray[np.int64]

    def state(self, x: Floats, z: Floats) -> Floats:
        """Rows of sites, zero where nothing is unknown."""
        flat = np.zeros(self.shape[0] * self.shape[1])
        flat[self.x], flat[self.z] = x, z
        return flat.reshape(self.shape)

    def states(self, x: Floats, z: Floats) -> Floats:
        """Rows of sites at several times, shape (frames, sites, slots), of columns of unknowns."""
        flat = np.zeros((x.shape[1], self.shape[0] * self.shape[1]))
        flat[:, self.x], flat[:, self.z] = x.T, z.T
        return flat.reshape(-1, *self.shape)

    def of(self, row: int) -> tuple[int, int]:
        """Site and slot of an unknown by its row, differential ones first."""
        site, slot = divmod(int(np.append(self.x, self.z)[row]), self.shape[1])
        return site, slot

    def vectors(self, states: Floats) -> tuple[Floats, Floats]:
        """Differential and algebraic unknowns, (nx, frames) and (nz, frames), of states (frames, sites, slots)."""
        flat = states.reshape(len(states), -1)
        return flat[:, self.x].T, flat[:, self.z].T


def sites_of(graph: Graph, slots: tuple[Slot, ...]) -> Sites:
    """Match the unknowns of a graph with the slots of its model."""
    number = {slot.name: k for k, slot in enumerate(slots)}
    x, z = (
        np.array([place * len(slots) + number[kind] for kind, place in layout.unknowns], dtype=np.int64)
        for layout in (graph.differential, graph.algebraic)
    )
    return Sites((graph.grid.cells + 1, len(slots)), x, z)


def places_in_rows(graph: Graph) -> Floats:
    """Geometry of each site, shape (sites, places)."""
    return np.ascontiguousarray(np.stack([graph.places[name] for name in graph.signature.places], axis=1))
