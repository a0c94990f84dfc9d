"""Assembly of a shear-free filament (the paper's kinematics) on the staggered grid.

Stretch, tension and axial plastic strain live on cells; turning, moment and bending plastic strain on nodes. Forces are
the exact derivatives of the discrete energy. The flow rule couples both through two-point means of the stress
resultants T and M, never of the strains, whose means have checkerboard modes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import CellPrinter
from softcat_sym.graph.discretisation import Discretisation, Fields, State, Unknowns
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.layout import Block, cell_block, node_block
from softcat_sym.graph.linear_section import Places, section_fields
from softcat_sym.graph.means import to_cells, to_nodes
from softcat_sym.graph.neck_force import neck_double_force, neck_tension


def unknowns(equations: FilamentEquations, grid: Grid) -> Unknowns:
    """Positions and velocities of free nodes; a_0 of every cell, a_1 of every node that carries a moment."""
    free_x, free_y = free_nodes(grid)
    zeros = np.zeros(grid.cells + 1)
    plastic: list[Block] = []
    if equations.response.means is not None:
        plastic.append(cell_block("a_0", grid))
        if equations.terms.bending:
            plastic.append(node_block("a_1", bending_nodes(grid), grid, zeros))
    return Unknowns(
        positions=(node_block("x", free_x, grid, grid.nodes), node_block("y", free_y, grid, zeros)),
        velocities=(node_block("u", free_x, grid, zeros), node_block("v", free_y, grid, zeros)),
        plastic=tuple(plastic),
    )


def evaluate(equations: FilamentEquations, values: Mapping[sy.Symbol, Any], grid: Grid, state: State) -> Fields:
    """Evaluate the whole filament."""
    cell, span = CellPrinter(equations, values), values[sy.L]
    zeros = ca.SX(grid.cells + 1, 1)
    x, y = state.field("x", ca.SX(grid.nodes)), state.field("y", zeros)
    a_0, a_1 = state.field("a_0", ca.SX(grid.cells, 1)), state.field("a_1", zeros)
    per_length = ca.DM(1 / grid.cell_length)
    per_span = 1 / span
    slope = (ca.diff(x) * per_length, ca.diff(y) * per_length)
    turning = turning_angles(cell, grid, slope) * (ca.DM(1 / grid.node_length) * per_span)
    s = cell.stretch(slope)
    s_node = to_nodes(grid, s)
    sigma_0 = cell.section("stress_mean", {sy.s: s, sy.a_0: a_0})
    sigma_1 = cell.section("stress_bending", {sy.s: s_node, sy.theta_X: turning, sy.a_1: a_1})
    tension = cell.section("tension", {sy.s: s, sy.sigma_0: sigma_0})
    moment = cell.section("moment", {sy.s: s_node, sy.sigma_1: sigma_1})
    correction = cell.section("axial_correction", {sy.s: s_node, sy.theta_X: turning, sy.M: moment})
    sigma_0_node = cell.section("stress_of_tension", {sy.s: s_node, sy.T: to_nodes(grid, tension)})
    sigma_1_cell = cell.section("stress_of_moment", {sy.s: s, sy.M: to_cells(moment)})
    axial = tension + to_cells(correction)
    double_force = None
    if equations.neck is not None:
        double_force = neck_double_force(equations.neck, values, grid, s, tension)
        axial += neck_tension(grid, double_force)
    force = cell.force(slope, s, axial, ca.diff(moment) * (per_length * per_span))
    cells = Places(s, turning, sigma_0, sigma_1_cell, cell.flow(s, sigma_0, sigma_1_cell))
    nodes = Places(s_node, turning, sigma_0_node, sigma_1, cell.flow(s_node, sigma_0_node, sigma_1))
    shown = {
        "tension": tension,
        "moment": to_cells(moment),
        "shear_force": ca.diff(moment) * (per_length * per_span) / s,
        "relative_thickness": cell.section("relative_thickness", {sy.s: s}),
    }
    return section_fields(grid, x, y, force, cells, nodes, shown, double_force)


def turning_angles(cell: CellPrinter, grid: Grid, slope: tuple[ca.SX, ca.SX]) -> ca.SX:
    """Angle turned at every node, shape (cells + 1,); an end that holds the angle turns against the horizontal."""
    if not cell.equations.terms.bending:
        return ca.SX(grid.cells + 1, 1)
    level = (ca.SX(1), ca.SX(0))
    first = cell.turning(level, (slope[0][0], slope[1][0])) if grid.first.holds_angle else ca.SX(0)
    last = cell.turning((slope[0][-1], slope[1][-1]), level) if grid.last.holds_angle else ca.SX(0)
    inner = cell.turning((slope[0][:-1], slope[1][:-1]), (slope[0][1:], slope[1][1:]))
    return ca.vertcat(first, inner, last)


def bending_nodes(grid: Grid) -> list[int]:
    """Nodes that carry a moment, and with it a bending plastic strain."""
    inner = list(range(1, grid.cells))
    first = [0] if grid.first.holds_angle else []
    last = [grid.cells] if grid.last.holds_angle else []
    return [*first, *inner, *last]


def free_nodes(grid: Grid) -> tuple[list[int], list[int]]:
    """Nodes whose x, and nodes whose y, is unknown."""
    inner = list(range(1, grid.cells))
    first = [0] if not grid.first.holds_height else []
    last = [grid.cells] if not grid.last.holds_height else []
    return inner, [*first, *inner, *last]


def expressions(equations: FilamentEquations) -> Iterable[Any]:
    """Whatever is printed of these equations, besides the balance."""
    response, neck = equations.response, equations.neck
    printed = [*response.relations_per_area().values(), *response.flow_per_area().values()]
    return [*printed, neck.double_force()] if neck is not None else printed


KIRCHHOFF = Discretisation(unknowns, evaluate, expressions)
