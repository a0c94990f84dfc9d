"""Assembly of a shear-free filament (the paper's kinematics) on the staggered grid.

Stretch, tension and axial plastic strain live on cells; turning, moment and bending plastic strain on nodes. Forces are
the exact derivatives of the discrete energy.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import CellPrinter, Pair
from softcat_sym.graph.discretisation import Discretisation, Fields, Recall, Setting, Unknowns
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.layout import Block, cell_block, node_block
from softcat_sym.graph.linear_section import Strained, plastic_names, section_fields, stress_section
from softcat_sym.graph.means import to_cells, to_nodes
from softcat_sym.graph.neck_force import neck_double_force, neck_tension
from softcat_sym.graph.surface_force import surface_force


def unknowns(equations: FilamentEquations, grid: Grid) -> Unknowns:
    """Positions and velocities of free nodes; a_0 of every cell, a_1 of every node that carries a moment.

    A filament that does not stretch has neither x nor a_0: its nodes stay above the places where they start.
    """
    free_x, free_y = free_nodes(grid)
    zeros = np.zeros(grid.cells + 1)
    plastic: list[Block] = []
    stretches = equations.terms.stretches
    for axial, bending in plastic_names(equations):
        if stretches:
            plastic.append(cell_block(axial, grid))
        if equations.terms.bending:
            plastic.append(node_block(bending, bending_nodes(grid), grid, zeros))
    along = (node_block("x", free_x, grid, grid.nodes),) if stretches else ()
    along_speed = (node_block("u", free_x, grid, zeros),) if stretches else ()
    return Unknowns(
        positions=(*along, node_block("y", free_y, grid, zeros)),
        velocities=(*along_speed, node_block("v", free_y, grid, zeros)),
        plastic=tuple(plastic),
        profiles=linear_profiles(equations),
    )


def linear_profiles(equations: FilamentEquations) -> dict[str, tuple[float, float]]:
    """What each kind of plastic state is of a linear plastic strain."""
    names = plastic_names(equations)
    means = {axial: (1.0, 0.0) for axial, _ in names} if equations.terms.stretches else {}
    return means | {bending: (0.0, 1.0) for _, bending in names}


def evaluate(equations: FilamentEquations, setting: Setting, state: Recall) -> Fields:
    """Evaluate the whole filament."""
    cell, grid = CellPrinter(equations, setting.values), setting.grid
    x, y = setting.positions(state)
    x = x if equations.terms.stretches else unstretched_places(setting)
    stage, lengths = setting.stage, setting.lengths
    per_length, per_span = 1 / lengths.cell, 1 / setting.values[sy.L_0]
    slope = (stage("slope_x", ca.diff(x) * per_length), stage("slope_y", ca.diff(y) * per_length))
    s = stage("s", cell.stretch(slope)) if equations.terms.stretches else ca.SX.ones(grid.cells, 1)
    s_node, turned_by = stage("s_node", to_nodes(lengths, s)), stage("turning", turning(cell, setting, slope))
    strained = Strained(s, s_node, turned_by, *_rates(cell, setting, state, slope))
    section = stress_section(cell, setting, state.field, strained)
    turned = {sy.s: strained.stretch_node, sy.theta_X: strained.turning, sy.M: section.moment}
    axial = section.tension + to_cells(stage("axial_correction", cell.section("axial_correction", turned)))
    surface_energy = None
    if equations.surface is not None:
        pull, surface_energy = surface_force(equations.surface, setting, section.outline, s)
        axial += pull
    double_force = None
    if equations.neck is not None:
        double_force = neck_double_force(equations.neck, setting, s, section.tension)
        axial += neck_tension(lengths, double_force)
    transverse = ca.diff(section.moment) * (per_length * per_span)
    shown = {
        **({"axial_force": axial} if surface_energy is not None else {}),
        "shear_force": transverse / s,
        "relative_thickness": cell.section("relative_thickness", {sy.s: s}) * section.outline.relative,
    }
    force_x, force_y = cell.force(slope, s, axial, transverse)
    force = stage("force_x", force_x), stage("force_y", force_y)
    fields = section_fields(setting, (x, y), force, section, shown)
    return replace(fields, double_force=double_force, surface_energy=surface_energy)


def unstretched_places(setting: Setting) -> ca.SX:
    """Places of nodes that stay above those where a straight, level filament has them, in rest lengths."""
    grid, nodes = setting.grid, ca.SX(setting.lengths.nodes)
    if grid.first.holds_height:
        return nodes + (setting.supports.left_x - nodes[0])
    return nodes + (setting.supports.right_x - nodes[-1])


def turning(cell: CellPrinter, setting: Setting, slope: Pair) -> ca.SX:
    """theta_X at every node [1/m]; an end that holds the angle turns against its clamp."""
    grid = setting.grid
    if not cell.equations.terms.bending:
        return ca.SX(grid.cells + 1, 1)
    before, behind = clamp_tangents(setting)
    first = cell.turning(before, (slope[0][0], slope[1][0])) if grid.first.holds_angle else ca.SX(0)
    last = cell.turning((slope[0][-1], slope[1][-1]), behind) if grid.last.holds_angle else ca.SX(0)
    inner = cell.turning((slope[0][:-1], slope[1][:-1]), (slope[0][1:], slope[1][1:]))
    return ca.SX(ca.vertcat(first, inner, last) * (1 / setting.lengths.node / setting.values[sy.L_0]))


def clamp_tangents(setting: Setting) -> tuple[Pair, Pair]:
    """Directions that the ends hold: a clamp its own, a plane of symmetry the level one."""
    left, right = setting.supports.left_angle, setting.supports.right_angle
    if setting.grid.is_half:
        return (ca.SX(1), ca.SX(0)), (ca.cos(right), ca.sin(right))
    return (ca.cos(left), ca.sin(left)), (ca.cos(right), ca.sin(right))


def _rates(cell: CellPrinter, setting: Setting, state: Recall, slope: Pair) -> Pair:
    """Rates of stretch and turning [1/s], where the stress depends on them."""
    grid = setting.grid
    if cell.equations.response.viscous is None:
        return ca.SX(grid.cells, 1), ca.SX(grid.cells + 1, 1)
    per_length, stage = 1 / setting.lengths.cell, setting.stage
    u, v = setting.velocities(state)
    speed = (stage("speed_x", ca.diff(u) * per_length), stage("speed_y", ca.diff(v) * per_length))
    stretches = cell.equations.terms.stretches
    stretching = stage("stretching", cell.stretch_rate(slope, speed)) if stretches else ca.SX(grid.cells, 1)
    if not cell.equations.terms.bending:
        return stretching, ca.SX(grid.cells + 1, 1)
    at_rest = (ca.SX(0), ca.SX(0))
    before, behind = clamp_tangents(setting)
    starts, ends = ((a[0][0], a[1][0]) for a in (slope, speed)), ((a[0][-1], a[1][-1]) for a in (slope, speed))
    (slope_0, speed_0), (slope_1, speed_1) = starts, ends
    first = cell.turning_rate((before, slope_0), (at_rest, speed_0)) if grid.first.holds_angle else ca.SX(0)
    last = cell.turning_rate((slope_1, behind), (speed_1, at_rest)) if grid.last.holds_angle else ca.SX(0)
    left = tuple((a[0][:-1], a[1][:-1]) for a in (slope, speed))
    right = tuple((a[0][1:], a[1][1:]) for a in (slope, speed))
    inner = cell.turning_rate((left[0], right[0]), (left[1], right[1]))
    per_node = 1 / setting.lengths.node / setting.values[sy.L_0]
    return stretching, stage("turning_rate", ca.vertcat(first, inner, last) * per_node)


def bending_nodes(grid: Grid) -> list[int]:
    """Nodes that carry a moment, and with it a bending plastic strain."""
    inner = list(range(1, grid.cells))
    first = [0] if grid.first.holds_angle else []
    last = [grid.cells] if grid.last.holds_angle else []
    return [*first, *inner, *last]


def free_nodes(grid: Grid) -> tuple[list[int], list[int]]:
    """Nodes whose x, and nodes whose y, is unknown."""
    inner, ends = list(range(1, grid.cells)), ((0, grid.first), (grid.cells, grid.last))
    free_x = {node for node, end in ends if not end.holds_x}
    free_y = {node for node, end in ends if not end.holds_height}
    return sorted({*inner, *free_x}), sorted({*inner, *free_y})


def expressions(equations: FilamentEquations) -> Iterable[Any]:
    """Whatever is printed of these equations, besides the balance."""
    return [*equations.response.expressions(), *beyond_the_section(equations)]


def beyond_the_section(equations: FilamentEquations) -> Iterable[Any]:
    """What neck and surface add to the axial force."""
    neck, surface = equations.neck, equations.surface
    return [*([neck.double_force()] if neck else []), *([surface.energy()] if surface else [])]


KIRCHHOFF = Discretisation("kirchhoff", unknowns, evaluate, expressions)
