"""Means between nodes and cells."""

from __future__ import annotations

import casadi as ca

from softcat_sym.graph.lengths import Lengths


def to_cells(on_nodes: ca.SX) -> ca.SX:
    """Two-point mean of a node quantity, shape (cells,)."""
    return (on_nodes[:-1] + on_nodes[1:]) / 2


def to_nodes(lengths: Lengths, on_cells: ca.SX) -> ca.SX:
    """Mean of a cell quantity over the length that each node answers for, shape (cells + 1,)."""
    length, whole = lengths.cell / 2, lengths.node
    behind = ca.vertcat(length / whole[:-1] * on_cells, 0)
    return ca.SX(behind + ca.vertcat(0, length / whole[1:] * on_cells))
