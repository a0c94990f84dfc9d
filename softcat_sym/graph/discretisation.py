"""What a theory must say to become a graph: its unknowns on the grid, and the fields that they imply."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import casadi as ca

from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import CellPrinter
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.layout import Block, Layout


@dataclass(frozen=True)
class Unknowns:
    """Blocks of unknowns.

    Attributes
    ----------
    positions : tuple of Block
        Named ``x``, ``y``: differential with inertia, algebraic without.
    velocities : tuple of Block
        Named ``u``, ``v``: only with inertia.
    plastic : tuple of Block
        Named ``a_0``, ``a_1``: only where the law flows.
    """

    positions: tuple[Block, ...]
    velocities: tuple[Block, ...]
    plastic: tuple[Block, ...]


@dataclass(frozen=True)
class Places:
    """Section quantities where the filament is cut: on all cells, or on all nodes."""

    stretch: ca.SX
    stress_mean: ca.SX
    stress_bending: ca.SX
    flow: Mapping[str, ca.SX]


@dataclass(frozen=True)
class Fields:
    """Everything the filament is at one instant; positions in spans, the rest in SI units per unit undeformed area."""

    x: ca.SX
    y: ca.SX
    turning: ca.SX
    cells: Places
    nodes: Places
    tension: ca.SX
    moment: ca.SX
    relative_thickness: ca.SX
    force_x: ca.SX
    force_y: ca.SX


@dataclass(frozen=True)
class Discretisation:
    """A theory on a grid.

    Attributes
    ----------
    unknowns : callable
        Equations and grid to the unknowns.
    evaluate : callable
        Cell printer, grid, span, layout of the positions and layout of the plastic states to the fields.
    """

    unknowns: Callable[[FilamentEquations, Grid], Unknowns]
    evaluate: Callable[[CellPrinter, Grid, ca.SX, Layout, Layout], Fields]
