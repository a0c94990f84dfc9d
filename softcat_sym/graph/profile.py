"""A section that varies along the filament: thickness and area on the places of the grid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.equations import symbols as sy
from softcat_sym.graph.grid import Floats, Grid


@dataclass(frozen=True)
class Profile:
    """Relative thickness, one where it is the scene's.

    Attributes
    ----------
    nodes, cells : ndarray, casadi.SX or None
        At the nodes and in the middle of the cells, as symbols where the grid is an input; None for a filament that is
        the same everywhere, which then leaves nothing of this in the graph.
    """

    nodes: Floats | ca.SX | None = None
    cells: Floats | ca.SX | None = None

    @classmethod
    def sampled(cls, values: tuple[float, ...], grid: Grid) -> Profile:
        """The profile on a grid, linear between the given values at equal distances from left to right."""
        if not values:
            return cls()
        at = np.linspace(-0.5, 0.5, len(values))
        return cls(np.interp(grid.nodes, at, values), np.interp(grid.centres, at, values))


@dataclass(frozen=True)
class Outline:
    """Undeformed thickness [m] and relative area on cells and on nodes; numbers where nothing varies.

    Attributes
    ----------
    h_cells, h_nodes : casadi value
        Thickness.
    area_cells, area_nodes : casadi value
        Area over that of the scene's thickness.
    relative : casadi value
        Thickness of the cells over the scene's.
    """

    h_cells: Any
    h_nodes: Any
    area_cells: Any
    area_nodes: Any
    relative: Any


def outline(profile: Profile, power: int, values: Mapping[sy.Symbol, Any]) -> Outline:
    """The outline of a filament whose area goes with a power of its thickness."""
    h = values.get(sy.h0)
    if profile.nodes is None or profile.cells is None or h is None:
        return Outline(h, h, 1.0, 1.0, 1.0)
    cells, nodes = as_values(profile.cells), as_values(profile.nodes)
    return Outline(h * cells, h * nodes, cells**power, nodes**power, cells)


def as_values(values: Floats | ca.SX) -> Any:
    """Numbers or symbols as CasADi has them."""
    return values if isinstance(values, ca.SX) else ca.DM(values)


def node_mass(grid: Grid, profile: Profile, power: int) -> Floats:
    """Mass that each node answers for, over density, undeformed area and rest length, shape (cells + 1,)."""
    half = grid.cell_length / 2
    if profile.cells is not None:
        half = half * np.asarray(profile.cells) ** power
    behind: Floats = np.concatenate([half, [0.0]])
    before: Floats = np.concatenate([[0.0], half])
    return behind + before
