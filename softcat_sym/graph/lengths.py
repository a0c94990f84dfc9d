"""Lengths of the places of a grid, as the equations meet them: numbers, or symbols where the grid is an input."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.graph.grid import Grid


@dataclass(frozen=True)
class Lengths:
    """In rest lengths.

    Attributes
    ----------
    nodes : casadi value, shape (cells + 1,)
        X of the nodes.
    cell : casadi value, shape (cells,)
        Length of each cell.
    node : casadi value, shape (cells + 1,)
        Length that each node answers for.
    """

    nodes: Any
    cell: Any
    node: Any


def lengths_of(grid: Grid) -> Lengths:
    """The numbers of a grid."""
    return Lengths(ca.DM(grid.nodes), ca.DM(grid.cell_length), ca.DM(grid.node_length))
