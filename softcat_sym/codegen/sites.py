"""Between a Graph's vectors and the rows of sites that the C model works on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.reciprocals import INVERTED, PER
from softcat_sym.codegen.recording import Slot
from softcat_sym.graph import Graph
from softcat_sym.graph.body import Body
from softcat_sym.graph.grid import Floats
from softcat_sym.graph.profile import node_mass


@dataclass(frozen=True)
class Sites:
    """Where the unknowns of a graph are in the rows of sites.

    Attributes
    ----------
    shape : (int, int)
        Sites and slots.
    x, z : ndarray of int
        Flat index of each differential and each algebraic unknown.
    """

    shape: tuple[int, int]
    x: npt.NDArray[np.int64]
    z: npt.NDArray[np.int64]

    def state(self, x: Floats, z: Floats) -> Floats:
        """Rows of sites, zero where nothing is unknown."""
        flat = np.zeros(self.shape[0] * self.shape[1])
        flat[self.x], flat[self.z] = x, z
        return flat.reshape(self.shape)

    def vectors(self, states: Floats) -> tuple[Floats, Floats]:
        """Differential and algebraic unknowns, (nx, frames) and (nz, frames), of states (frames, sites, slots)."""
        flat = states.reshape(len(states), -1)
        return flat[:, self.x].T.copy(), flat[:, self.z].T.copy()


def sites_of(graph: Graph, slots: tuple[Slot, ...]) -> Sites:
    """Match the unknowns of a graph with the slots of its model."""
    number = {slot.name: k for k, slot in enumerate(slots)}
    pairs = ((graph.x_kinds, graph.x_places), (graph.z_kinds, graph.z_places))
    x, z = (
        np.array([place * len(slots) + number[kind] for kind, place in zip(kinds, places, strict=True)], dtype=np.int64)
        for kinds, places in pairs
    )
    return Sites((graph.grid.cells + 1, len(slots)), x, z)


def places_of(graph: Graph, body: Body, power: int, names: tuple[str, ...]) -> Floats:
    """Geometry of each site, shape (sites, names); what the last site's missing cell would have is one.

    Parameters
    ----------
    graph : Graph
        With its grid.
    body : Body
        Profile and point mass.
    power : int
        With which the area of the section goes with its thickness.
    names : tuple of str
        From :func:`softcat_sym.codegen.recording.place_names`.
    """
    grid, profile = graph.grid, body.profile
    middle = np.zeros(grid.cells + 1)
    middle[int(np.argmin(np.abs(grid.nodes)))] = 0.5 if grid.is_half else 1.0
    known = {
        "X": grid.nodes,
        "cell": np.append(grid.cell_length, 1.0),
        "node": grid.node_length,
        "mass": node_mass(grid, profile, power),
        "hung": middle,
    }
    if profile.nodes is not None and profile.cells is not None:
        known |= {"h_node": np.asarray(profile.nodes), "h_cell": np.append(np.asarray(profile.cells), 1.0)}
    known |= {PER + name: 1 / known[name] for name in INVERTED}
    return np.ascontiguousarray(np.stack([known[name] for name in names], axis=1))
