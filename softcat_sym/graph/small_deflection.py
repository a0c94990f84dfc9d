"""Assembly of the small-deflection model (2.13)-(2.19) on the same grid and with the same section.

Axial inertia is dropped, so the tension is the same everywhere (T_X = 0) and so are the axial strain and its plastic
part: one number each for the whole filament. The two memory integrals of (2.18) are the stresses that a_0 and a_1
relax.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import CellPrinter
from softcat_sym.graph.discretisation import Discretisation, Fields, State, Unknowns
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.kirchhoff import bending_nodes, expressions, free_nodes, turning_angles
from softcat_sym.graph.layout import Block, block, node_block
from softcat_sym.graph.linear_section import Places, section_fields
from softcat_sym.graph.means import to_cells


def unknowns(equations: FilamentEquations, grid: Grid) -> Unknowns:
    """Heights and their velocities; one a_0 for the filament, a_1 of every node that carries a moment."""
    _, free_y = free_nodes(grid)
    zeros = np.zeros(grid.cells + 1)
    plastic: list[Block] = []
    if equations.response.means is not None:
        plastic.append(block("a_0", (0,), grid.centres, np.zeros(grid.cells)))
        if equations.terms.bending:
            plastic.append(node_block("a_1", bending_nodes(grid), grid, zeros))
    return Unknowns(
        positions=(node_block("y", free_y, grid, zeros),),
        velocities=(node_block("v", free_y, grid, zeros),),
        plastic=tuple(plastic),
    )


def evaluate(equations: FilamentEquations, values: Mapping[sy.Symbol, Any], grid: Grid, state: State) -> Fields:
    """Evaluate the whole filament from its heights."""
    cell, span = CellPrinter(equations, values), values[sy.L]
    zeros, every = ca.SX(grid.cells + 1, 1), ca.SX.ones(grid.cells, 1)
    length, per_length, per_span = ca.DM(grid.cell_length), ca.DM(1 / grid.cell_length), 1 / span
    y = state.field("y", zeros)
    slope = (every, ca.diff(y) * per_length)
    # Elongation of each cell at x_X = 1; what the mean has beyond it is the horizontal displacement U (2.13).
    lengthening = cell.stretch(slope) - 1
    elongation = ca.dot(length, lengthening) / float(np.sum(grid.cell_length))
    displacement = ca.vertcat(0, ca.cumsum(length * (elongation - lengthening)))
    s, s_node = (1 + elongation) * every, (1 + elongation) * ca.SX.ones(grid.cells + 1, 1)
    a_0, a_1 = state.field("a_0", ca.SX(1, 1)), state.field("a_1", zeros)
    turning = turning_angles(cell, grid, slope) * (ca.DM(1 / grid.node_length) * per_span)
    sigma_0 = cell.section("stress_mean", {sy.s: 1 + elongation, sy.a_0: a_0})
    sigma_1 = cell.section("stress_bending", {sy.s: s_node, sy.theta_X: turning, sy.a_1: a_1})
    tension = cell.section("tension", {sy.s: s, sy.sigma_0: sigma_0 * every})
    moment = cell.section("moment", {sy.s: s_node, sy.sigma_1: sigma_1})
    sigma_1_cell = cell.section("stress_of_moment", {sy.s: s, sy.M: to_cells(moment)})
    _, force_y = cell.force(slope, s, tension, ca.diff(moment) * (per_length * per_span))
    everywhere = sigma_0 * ca.SX.ones(grid.cells + 1, 1)
    stress = sigma_0 * every
    cells = Places(s, turning, stress, sigma_1_cell, cell.flow(s, stress, sigma_1_cell))
    nodes = Places(s_node, turning, everywhere, sigma_1, cell.flow(s_node, everywhere, sigma_1))
    shown = {
        "tension": tension,
        "moment": to_cells(moment),
        "shear_force": ca.diff(moment) * (per_length * per_span) / s,
        "relative_thickness": every,
    }
    force = (ca.SX(grid.cells, 1), force_y)
    return section_fields(grid, ca.SX(grid.nodes) + displacement, y, force, cells, nodes, shown)


SMALL_DEFLECTION = Discretisation(unknowns, evaluate, expressions)
