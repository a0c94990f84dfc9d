"""Assembly of a shear-free filament (the paper's kinematics) on the staggered grid.

Stretch, tension and axial plastic strain live on cells; turning, moment and bending plastic strain on nodes. Forces are
the exact derivatives of the discrete energy. The flow rule couples both through two-point means of the stress
resultants T and M, never of the strains, whose means have checkerboard modes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.parameters import CATALOGUE, SPAN, TIME_SCALE
from softcat_sym.printing import CellFunction

_INPUTS = tuple(parameter.symbol for parameter in CATALOGUE)


@dataclass(frozen=True)
class Places:
    """Section quantities where the filament is cut: on all cells, or on all nodes."""

    stretch: ca.SX
    stress_mean: ca.SX
    stress_bending: ca.SX
    flow: Mapping[str, ca.SX]


@dataclass(frozen=True)
class Fields:
    """Everything the filament is at one instant, as CasADi vectors in SI units per unit undeformed area."""

    turning: ca.SX
    cells: Places
    nodes: Places
    tension: ca.SX
    moment: ca.SX
    relative_thickness: ca.SX
    force_x: ca.SX
    force_y: ca.SX


class CellPrinter:
    """The expressions of one cell, ready to be evaluated on vectors of cells, nodes or half cells."""

    def __init__(self, equations: FilamentEquations, values: Mapping[sy.Symbol, Any]) -> None:
        self._values = dict(values)
        self.equations = equations
        terms, response = equations.terms, equations.response
        self._stretch = CellFunction({"s": terms.centreline.stretch}, (sy.x_X, sy.y_X))
        self._turning = CellFunction(
            {"turning": terms.centreline.turning}, (sy.x_X_before, sy.y_X_before, sy.x_X, sy.y_X)
        )
        self._force = CellFunction(
            {"x": equations.force.horizontal, "y": equations.force.vertical}, (sy.x_X, sy.y_X, sy.s, sy.Q, sy.M_X)
        )
        self._gravity = CellFunction({"g": terms.gravity, "rate": terms.gravity_rate}, (sy.t, *_INPUTS))
        places = (sy.s, sy.theta_X, sy.a_0, sy.a_1, sy.sigma_0, sy.sigma_1, sy.T, sy.M, *_INPUTS)
        self._section = {
            name: CellFunction({name: relation}, places) for name, relation in response.relations_per_area().items()
        }
        self._flow = CellFunction(response.flow_per_area(), (sy.s, sy.sigma_0, sy.sigma_1, *_INPUTS))

    def stretch(self, slope: tuple[ca.SX, ca.SX]) -> ca.SX:
        """Stretch of cells with tangent r_X."""
        return ca.SX(self._stretch({sy.x_X: slope[0], sy.y_X: slope[1]})["s"])

    def turning(self, before: tuple[ca.SX, ca.SX], behind: tuple[ca.SX, ca.SX]) -> ca.SX:
        """Angle between neighbouring tangents."""
        values = {sy.x_X_before: before[0], sy.y_X_before: before[1], sy.x_X: behind[0], sy.y_X: behind[1]}
        return ca.SX(self._turning(values)["turning"])

    def force(self, slope: tuple[ca.SX, ca.SX], s: ca.SX, axial: ca.SX, moment_change: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Internal force of cells (2.1, 2.2)."""
        values = {sy.x_X: slope[0], sy.y_X: slope[1], sy.s: s, sy.Q: axial, sy.M_X: moment_change}
        out = self._force(values)
        return out["x"], out["y"]

    def gravity(self, time: ca.SX) -> tuple[ca.SX, ca.SX]:
        """g(t) and its rate."""
        out = self._gravity({**self._values, sy.t: time})
        return out["g"], out["rate"]

    def section(self, name: str, values: Mapping[sy.Symbol, ca.SX]) -> ca.SX:
        """One of the section's relations, named as in :class:`SectionEquations`, on vectors of cells or nodes."""
        size = max(value.numel() for value in values.values())
        return ca.SX(self._section[name]({**self._values, **values})[name]) * ca.SX.ones(size)

    def flow(self, s: ca.SX, sigma_0: ca.SX, sigma_1: ca.SX) -> dict[str, ca.SX]:
        """Plastic rates, energies and yielded fraction where the stress is sigma_0 + sigma_1 zeta."""
        out = self._flow({**self._values, sy.s: s, sy.sigma_0: sigma_0, sy.sigma_1: sigma_1})
        return {name: ca.SX(value) * ca.SX.ones(s.numel()) for name, value in out.items()}


def filament_fields(
    cell: CellPrinter, grid: Grid, span: ca.SX, nodes: tuple[ca.SX, ca.SX], plastic: tuple[ca.SX, ca.SX]
) -> Fields:
    """Evaluate the whole filament.

    Parameters
    ----------
    cell : CellPrinter
        The expressions of one cell.
    grid : Grid
        Where they hold.
    span : casadi.SX
        Length that makes the grid dimensional.
    nodes : pair of casadi.SX, shape (cells + 1,)
        x/L and y/L of the nodes.
    plastic : pair of casadi.SX, shapes (cells,) and (cells + 1,)
        a_0 of the cells and a_1 of the nodes.
    """
    per_length = ca.DM(1 / grid.cell_length)
    per_span = 1 / span
    slope = (ca.diff(nodes[0]) * per_length, ca.diff(nodes[1]) * per_length)
    turning = _turning(cell, grid, slope) * (ca.DM(1 / grid.node_length) * per_span)
    a_0, a_1 = plastic
    s = cell.stretch(slope)
    s_node = to_nodes(grid, s)
    sigma_0 = cell.section("stress_mean", {sy.s: s, sy.a_0: a_0})
    sigma_1 = cell.section("stress_bending", {sy.s: s_node, sy.theta_X: turning, sy.a_1: a_1})
    tension = cell.section("tension", {sy.s: s, sy.sigma_0: sigma_0})
    moment = cell.section("moment", {sy.s: s_node, sy.sigma_1: sigma_1})
    correction = cell.section("axial_correction", {sy.s: s_node, sy.theta_X: turning, sy.M: moment})
    sigma_0_node = cell.section("stress_of_tension", {sy.s: s_node, sy.T: to_nodes(grid, tension)})
    sigma_1_cell = cell.section("stress_of_moment", {sy.s: s, sy.M: to_cells(moment)})
    force_x, force_y = cell.force(slope, s, tension + to_cells(correction), ca.diff(moment) * (per_length * per_span))
    return Fields(
        turning=turning,
        cells=Places(s, sigma_0, sigma_1_cell, cell.flow(s, sigma_0, sigma_1_cell)),
        nodes=Places(s_node, sigma_0_node, sigma_1, cell.flow(s_node, sigma_0_node, sigma_1)),
        tension=tension,
        moment=moment,
        relative_thickness=cell.section("relative_thickness", {sy.s: s}),
        force_x=force_x,
        force_y=force_y,
    )


def to_cells(on_nodes: ca.SX) -> ca.SX:
    """Two-point mean of a node quantity, shape (cells,)."""
    return (on_nodes[:-1] + on_nodes[1:]) / 2


def to_nodes(grid: Grid, on_cells: ca.SX) -> ca.SX:
    """Mean of a cell quantity over the length that each node answers for, shape (cells + 1,)."""
    length, whole = grid.cell_length / 2, grid.node_length
    behind = ca.vertcat(ca.DM(length / whole[:-1]) * on_cells, 0)
    return behind + ca.vertcat(0, ca.DM(length / whole[1:]) * on_cells)


def _turning(cell: CellPrinter, grid: Grid, slope: tuple[ca.SX, ca.SX]) -> ca.SX:
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


def parameter_symbols(equations: FilamentEquations) -> tuple[dict[sy.Symbol, ca.SX], list[str], ca.SX]:
    """Only the parameters that occur in these equations become inputs, besides the scales of length and time."""
    used = _occurring(equations)
    chosen = [parameter for parameter in CATALOGUE if parameter.symbol in used or parameter.name == SPAN]
    inputs = {parameter.symbol: ca.SX.sym(parameter.name) for parameter in chosen}
    scale = ca.SX.sym(TIME_SCALE)
    names = [parameter.name for parameter in chosen] + [TIME_SCALE]
    return inputs, names, ca.vertcat(*inputs.values(), scale)


def _occurring(equations: FilamentEquations) -> set[sy.Symbol]:
    terms = equations.terms
    printed = {**equations.response.relations_per_area(), **equations.response.flow_per_area()}
    found = set().union(*(e.free_symbols for e in printed.values()), terms.gravity.free_symbols)
    return found | {sy.rho}
