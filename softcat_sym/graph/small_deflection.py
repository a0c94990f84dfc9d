"""Assembly of the small-deflection model (2.13)-(2.19) on the same grid and with the same section.

Axial inertia is dropped, so the tension is the same everywhere (T_X = 0) and so are the axial strain and its plastic
part: one number each for the whole filament. The two memory integrals of (2.18) are the stresses that a_0 and a_1
relax.
"""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import CellPrinter
from softcat_sym.graph.discretisation import Discretisation, Fields, Recall, Setting, Unknowns
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.kirchhoff import bending_nodes, expressions, free_nodes, linear_profiles, turning
from softcat_sym.graph.layout import Block, block, node_block
from softcat_sym.graph.linear_section import Strained, plastic_names, section_fields, stress_section
from softcat_sym.graph.surface_force import surface_force


def unknowns(equations: FilamentEquations, grid: Grid) -> Unknowns:
    """Heights and their velocities; one a_0 for the filament, a_1 of every node that carries a moment."""
    _, free_y = free_nodes(grid)
    zeros = np.zeros(grid.cells + 1)
    plastic: list[Block] = []
    for axial, bending in plastic_names(equations):
        plastic.append(block(axial, (0,), grid.centres, np.zeros(grid.cells)))
        if equations.terms.bending:
            plastic.append(node_block(bending, bending_nodes(grid), grid, zeros))
    return Unknowns(
        positions=(node_block("y", free_y, grid, zeros),),
        velocities=(node_block("v", free_y, grid, zeros),),
        plastic=tuple(plastic),
        profiles=linear_profiles(equations),
    )


def evaluate(equations: FilamentEquations, setting: Setting, state: Recall) -> Fields:
    """Evaluate the whole filament from its heights."""
    cell, grid = CellPrinter(equations, setting.values), setting.grid
    zeros, every = ca.SX(grid.cells + 1, 1), ca.SX.ones(grid.cells, 1)
    length, per_span = setting.lengths.cell, 1 / setting.values[sy.L_0]
    per_length = 1 / length
    y = state.field("y", zeros)
    slope = (every, ca.diff(y) * per_length)
    # Elongation of each cell at x_X = 1; what the mean has beyond it is the horizontal displacement U (2.13).
    lengthening = cell.stretch(slope) - 1
    elongation = ca.dot(length, lengthening) / float(np.sum(grid.cell_length))
    displacement = ca.vertcat(0, ca.cumsum(length * (elongation - lengthening)))
    s, s_node = (1 + elongation) * every, (1 + elongation) * ca.SX.ones(grid.cells + 1, 1)
    strained = Strained(s, s_node, turning(cell, setting, slope), ca.SX(grid.cells, 1), zeros)

    def recall(name: str, full: ca.SX) -> ca.SX:
        values = state.field(name, full)
        # One axial plastic strain for all: every cell has that of the first.
        return values[0] * every if name.startswith("a_0") else values

    section = stress_section(cell, setting, recall, strained)
    transverse = ca.diff(section.moment) * (per_length * per_span)
    axial, surface_energy = section.tension, None
    if equations.surface is not None:
        pull, surface_energy = surface_force(equations.surface, setting, section.outline, s)
        axial += pull
    _, force_y = cell.force(slope, s, axial, transverse)
    shown = {"shear_force": transverse / s, "relative_thickness": every}
    shown |= {"axial_force": axial} if surface_energy is not None else {}
    places, force = (ca.SX(grid.nodes) + displacement, y), (ca.SX(grid.cells, 1), force_y)
    return replace(section_fields(setting, places, force, section, shown), surface_energy=surface_energy)


SMALL_DEFLECTION = Discretisation("small-deflection", unknowns, evaluate, expressions)
