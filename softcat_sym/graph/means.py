"""Means between nodes and cells."""

from __future__ import annotations

import casadi as ca

from softcat_sym.graph.grid import Grid


def to_cells(on_nodes: ca.SX) -> ca.SX:
    """Two-point mean of a node quantity, shape (cells,)."""
    return (on_nodes[:-1] + on_nodes[1:]) / 2


def to_nodes(grid: Grid, on_cells: ca.SX) -> ca.SX:
    """Mean of a cell quantity over the length that each node answers for, shape (cells + 1,)."""
    length, whole = grid.cell_length / 2, grid.node_length
    behind = ca.vertcat(ca.DM(length / whole[:-1]) * on_cells, 0)
    return behind + ca.vertcat(0, ca.DM(length / whole[1:]) * on_cells)
