"""Equations and a grid become a Graph: which unknowns are differential, which algebraic, and what they balance."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.equations.symbols import L, rho
from softcat_sym.graph.graph import Graph
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.kirchhoff import (
    CellPrinter,
    Fields,
    bending_nodes,
    filament_fields,
    free_nodes,
    parameter_symbols,
    to_cells,
)
from softcat_sym.graph.layout import Block, Layout, cell_block, node_block


@dataclass(frozen=True)
class _Instant:
    """The filament at one instant: nodes in units of the span, their velocity, and the fields they imply (SI)."""

    x: ca.SX
    y: ca.SX
    u: ca.SX
    v: ca.SX
    fields: Fields
    net_force: tuple[ca.SX, ...]
    gravity: ca.SX
    gravity_rate: ca.SX


def assemble(equations: FilamentEquations, grid: Grid, effects: tuple[str, ...]) -> Graph:
    """Assemble the filament of one cell's equations on a grid.

    Parameters
    ----------
    equations : FilamentEquations
        One cell, from :func:`softcat_sym.equations.filament.derive`.
    grid : Grid
        Half or whole span.
    effects : tuple of str
        Names of the effects in force, carried along.

    Returns
    -------
    Graph
        An ODE if inertia is in force, otherwise an index-1 DAE whose algebraic unknowns are the positions.
    """
    values, names, p = parameter_symbols(equations)
    time_scale = p[len(names) - 1]
    time = ca.SX.sym("t")
    moving, still = _layouts(equations, grid)
    cell = CellPrinter(equations, values)
    now = _instant(cell, grid, time * time_scale, values, (moving, still))
    rates = _rates(now, grid, time_scale, values)
    outputs = _observables(now, grid, time_scale, values)
    ode, alg = _tidy(moving.gather(rates), still.gather({"x": rates["u"], "y": rates["v"]}))
    (quad,) = _tidy(_powers(now, grid, time_scale, values))
    return Graph(
        grid=grid,
        effects=effects,
        conserves_energy=equations.conserves_energy,
        parameters=tuple(names),
        t=time,
        x=moving.vector,
        z=still.vector,
        p=p,
        ode=ode,
        alg=alg,
        quad=quad,
        state_names=moving.names,
        algebraic_names=still.names,
        observables=ca.Function(
            "observables",
            [time, moving.vector, still.vector, p],
            _tidy(*outputs.values()),
            ["time", "state", "algebraic", "parameters"],
            list(outputs),
        ),
        start=moving.start,
        straight=still.start,
    )


def _tidy(*expressions: ca.SX) -> list[ca.SX]:
    """Dense, with common subexpressions shared between them; integrators refuse structural zeros in an output."""
    return list(ca.cse([ca.densify(expression) for expression in expressions]))


def _layouts(equations: FilamentEquations, grid: Grid) -> tuple[Layout, Layout]:
    free_x, free_y = free_nodes(grid)
    zeros = np.zeros(grid.cells + 1)
    positions = [node_block("x", free_x, grid, grid.nodes), node_block("y", free_y, grid, zeros)]
    velocities = [node_block("u", free_x, grid, zeros), node_block("v", free_y, grid, zeros)]
    plastic: list[Block] = []
    if equations.response.means is not None:
        plastic.append(cell_block("a_0", grid))
        if equations.terms.bending:
            plastic.append(node_block("a_1", bending_nodes(grid), grid, zeros))
    if equations.terms.inertia:
        return Layout("x", [*positions, *velocities, *plastic]), Layout("z", [])
    return Layout("x", plastic), Layout("z", positions)


def _instant(
    cell: CellPrinter, grid: Grid, time: ca.SX, values: dict[object, ca.SX], layouts: tuple[Layout, Layout]
) -> _Instant:
    moving, still = layouts
    places = moving if cell.equations.terms.inertia else still
    zeros = ca.SX(grid.cells + 1, 1)
    x, y = places.field("x", ca.SX(grid.nodes)), places.field("y", zeros)
    plastic = (moving.field("a_0", ca.SX(grid.cells, 1)), moving.field("a_1", zeros))
    fields = filament_fields(cell, grid, values[L], (x, y), plastic)
    gravity, gravity_rate = cell.gravity(time)
    net = tuple(ca.vertcat(force, 0) - ca.vertcat(0, force) for force in (fields.force_x, fields.force_y))
    return _Instant(x, y, moving.field("u", zeros), moving.field("v", zeros), fields, net, gravity, ca.SX(gravity_rate))


def _rates(now: _Instant, grid: Grid, time_scale: ca.SX, values: dict[object, ca.SX]) -> dict[str, ca.SX]:
    """Rates of all unknowns in units of span and time scale; momentum is divided by the mass of each node."""
    unit = time_scale**2 / values[L]
    per_mass = ca.DM(1 / grid.node_length) * (unit / (values[rho] * values[L]))
    return {
        "x": now.u,
        "y": now.v,
        "u": now.net_force[0] * per_mass,
        "v": now.net_force[1] * per_mass - now.gravity * unit,
        "a_0": now.fields.cells.flow["rate_mean"] * time_scale,
        "a_1": now.fields.nodes.flow["rate_bending"] * time_scale,
    }


def _powers(now: _Instant, grid: Grid, time_scale: ca.SX, values: dict[object, ca.SX]) -> ca.SX:
    """Plastic power and power of the changing load, per unit undeformed area and span, per unit of scaled time."""
    dissipated = _sum(now.fields, grid, "dissipation_mean", "dissipation_bending")
    lifted = ca.dot(ca.DM(grid.node_length), now.y) * values[L] * values[rho] * now.gravity_rate
    return ca.vertcat(dissipated, lifted) * time_scale


def _sum(fields: Fields, grid: Grid, of_cells: str, of_nodes: str) -> ca.SX:
    """Integral over the grid of a cell quantity plus a node quantity."""
    on_cells = ca.dot(ca.DM(grid.cell_length), fields.cells.flow[of_cells])
    return on_cells + ca.dot(ca.DM(grid.node_length), fields.nodes.flow[of_nodes])


def _observables(now: _Instant, grid: Grid, time_scale: ca.SX, values: dict[object, ca.SX]) -> dict[str, ca.SX]:
    span, fields = values[L], now.fields
    cells, nodes = fields.cells, fields.nodes
    speed = span / time_scale
    node, length = ca.DM(grid.node_length), ca.DM(grid.cell_length)
    along = ca.diff(fields.moment) / (span * length * cells.stretch)
    return {
        "x": now.x * span,
        "y": now.y * span,
        "stretch": cells.stretch,
        "curvature": to_cells(fields.turning / nodes.stretch),
        "tension": fields.tension,
        "moment": to_cells(fields.moment),
        "shear_force": along,
        "yielded_fraction": to_cells(nodes.flow["yielded_fraction"]),
        "plastic_rate": to_cells(nodes.flow["plastic_rate"]),
        "relative_thickness": fields.relative_thickness,
        "stress_mean": cells.stress_mean,
        "stress_bending": cells.stress_bending,
        "energy_kinetic": ca.dot(node, now.u**2 + now.v**2) * speed**2 * values[rho] / 2 * span,
        "energy_elastic": _sum(fields, grid, "elastic_mean", "elastic_bending") * span,
        "energy_potential": ca.dot(node, now.y) * span * values[rho] * now.gravity * span,
    }
