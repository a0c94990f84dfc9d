"""Equations and a grid become a Graph: which unknowns are differential, which algebraic, and what they balance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.equations.symbols import L, rho
from softcat_sym.graph.cell_printer import CellPrinter, parameter_symbols
from softcat_sym.graph.discretisation import Discretisation, Fields, Unknowns
from softcat_sym.graph.graph import Graph
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.kirchhoff import KIRCHHOFF, to_cells
from softcat_sym.graph.layout import Layout


@dataclass(frozen=True)
class _Instant:
    """The filament at one instant: the fields, velocities in spans per time scale, and what acts on the nodes (SI)."""

    fields: Fields
    u: ca.SX
    v: ca.SX
    net_force: tuple[ca.SX, ...]
    gravity: ca.SX
    gravity_rate: ca.SX


def assemble(
    equations: FilamentEquations, grid: Grid, effects: tuple[str, ...], theory: Discretisation = KIRCHHOFF
) -> Graph:
    """Assemble the filament of one cell's equations on a grid.

    Parameters
    ----------
    equations : FilamentEquations
        One cell, from :func:`softcat_sym.equations.filament.derive`.
    grid : Grid
        Half or whole span.
    effects : tuple of str
        Names of the effects in force, carried along.
    theory : Discretisation
        Which unknowns the grid carries.

    Returns
    -------
    Graph
        An ODE if inertia is in force, otherwise an index-1 DAE whose algebraic unknowns are the positions.
    """
    values, names, p = parameter_symbols(equations)
    time_scale = p[len(names) - 1]
    time = ca.SX.sym("t")
    moving, still = _layouts(equations, theory.unknowns(equations, grid))
    cell = CellPrinter(equations, values)
    fields = theory.evaluate(cell, grid, values[L], moving if equations.terms.inertia else still, moving)
    now = _instant(cell, fields, time * time_scale, moving)
    rates = _rates(now, grid, time_scale, values)
    ode, alg = _tidy(moving.gather(rates), still.gather({"x": rates["u"], "y": rates["v"]}))
    plastic_powers, load_powers = _tidy(*_powers(now, grid, time_scale, values))
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
        plastic_powers=plastic_powers,
        load_powers=load_powers,
        state_names=moving.names,
        algebraic_names=still.names,
        observables=_function([time, moving.vector, still.vector, p], _observables(now, grid, time_scale, values)),
        start=moving.start,
        straight=still.start,
    )


def _function(inputs: list[ca.SX], outputs: dict[str, ca.SX]) -> ca.Function:
    names = ["time", "state", "algebraic", "parameters"]
    return ca.Function("observables", inputs, _tidy(*outputs.values()), names, list(outputs))


def _tidy(*expressions: ca.SX) -> list[ca.SX]:
    """Dense, with common subexpressions shared between them; integrators refuse structural zeros in an output."""
    return list(ca.cse([ca.densify(expression) for expression in expressions]))


def _layouts(equations: FilamentEquations, unknowns: Unknowns) -> tuple[Layout, Layout]:
    if equations.terms.inertia:
        return Layout("x", [*unknowns.positions, *unknowns.velocities, *unknowns.plastic]), Layout("z", [])
    return Layout("x", unknowns.plastic), Layout("z", unknowns.positions)


def _instant(cell: CellPrinter, fields: Fields, time: ca.SX, moving: Layout) -> _Instant:
    zeros = ca.SX(*fields.y.shape)
    gravity, gravity_rate = cell.gravity(time)
    net = tuple(ca.vertcat(force, 0) - ca.vertcat(0, force) for force in (fields.force_x, fields.force_y))
    return _Instant(fields, moving.field("u", zeros), moving.field("v", zeros), net, gravity, ca.SX(gravity_rate))


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


def _powers(now: _Instant, grid: Grid, time_scale: ca.SX, values: dict[object, ca.SX]) -> tuple[ca.SX, ca.SX]:
    """Plastic power and power of the changing load, place by place, in units of :func:`energy_scale`."""
    scale: ca.SX = time_scale / energy_scale(values[rho], values[L], time_scale)
    cells, nodes = now.fields.cells.flow["dissipation_mean"], now.fields.nodes.flow["dissipation_bending"]
    dissipated = ca.vertcat((ca.DM(grid.cell_length) * scale) * cells, (ca.DM(grid.node_length) * scale) * nodes)
    lifted = (ca.DM(grid.node_length) * (values[L] * values[rho] * now.gravity_rate * scale)) * now.fields.y
    nothing = ca.SX(1, 1)
    return nothing if dissipated.is_zero() else dissipated, nothing if lifted.is_zero() else lifted


def energy_scale(density: Any, span: Any, time_scale: Any) -> Any:
    """Unit of the quadratures [Pa]: density times the square of span over time scale.

    An integrator that controls the quadratures measures them with the tolerances of the unknowns, so they have the same
    size whatever the units of the scene.
    """
    return density * (span / time_scale) ** 2


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
        "x": fields.x * span,
        "y": fields.y * span,
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
        "energy_potential": ca.dot(node, fields.y) * span * values[rho] * now.gravity * span,
    }
