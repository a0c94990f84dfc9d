"""Equations and a grid become a Graph: which unknowns are differential, which algebraic, and what they balance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import gravity_at, parameter_symbols
from softcat_sym.graph.discretisation import Discretisation, Fields, State, Unknowns
from softcat_sym.graph.graph import Graph
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.kirchhoff import KIRCHHOFF
from softcat_sym.graph.layout import Layout
from softcat_sym.printing import CellFunction


@dataclass(frozen=True)
class _Instant:
    """The filament at one instant: fields, velocities in spans per time scale, and the scales (SI) of both."""

    fields: Fields
    u: ca.SX
    v: ca.SX
    omega: ca.SX
    gravity: ca.SX
    gravity_rate: ca.SX
    rotary_inertia: ca.SX
    density: ca.SX
    span: ca.SX
    time_scale: ca.SX


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
        An ODE, or an index-1 DAE: positions are algebraic without inertia, section angles without rotary inertia.
    """
    values, names, p = parameter_symbols([*theory.expressions(equations), *_loads(equations)])
    time_scale = p[len(names) - 1]
    time = ca.SX.sym("t")
    state = _layouts(equations, theory.unknowns(equations, grid))
    now = _instant(equations, theory.evaluate(equations, values, grid, state), state, values, time, time_scale)
    rates = _rates(now, grid)
    ode, alg = _tidy(state.moving.gather(rates), state.still.gather(_balances(now, rates)))
    plastic_powers, load_powers, gradient_powers = _tidy(*_powers(now, grid))
    return Graph(
        grid=grid,
        effects=effects,
        conserves_energy=equations.conserves_energy,
        parameters=tuple(names),
        t=time,
        x=state.moving.vector,
        z=state.still.vector,
        p=p,
        ode=ode,
        alg=alg,
        plastic_powers=plastic_powers,
        load_powers=load_powers,
        gradient_powers=gradient_powers,
        state_names=state.moving.names,
        algebraic_names=state.still.names,
        observables=_function([time, state.moving.vector, state.still.vector, p], _observables(now, grid)),
        start=state.moving.start,
        straight=state.still.start,
    )


def _loads(equations: FilamentEquations) -> list[Any]:
    terms, resolved = equations.terms, equations.resolved
    turning = [resolved.rotary_inertia] if resolved is not None else []
    return [terms.gravity, terms.gravity_rate, *turning]


def _function(inputs: list[ca.SX], outputs: dict[str, ca.SX]) -> ca.Function:
    names = ["time", "state", "algebraic", "parameters"]
    return ca.Function("observables", inputs, _tidy(*outputs.values()), names, list(outputs))


def _tidy(*expressions: ca.SX) -> list[ca.SX]:
    """Dense, with common subexpressions shared between them; integrators refuse structural zeros in an output."""
    return list(ca.cse([ca.densify(expression) for expression in expressions]))


def _layouts(equations: FilamentEquations, unknowns: Unknowns) -> State:
    """Differential are the plastic states, with inertia the positions, with rotary inertia the angles."""
    positions, angles, plastic = unknowns.positions, unknowns.angles, unknowns.plastic
    if not equations.terms.inertia:
        return State(Layout("x", plastic), Layout("z", [*positions, *angles]))
    if unknowns.spins:
        turning = (*angles, *unknowns.spins)
        return State(Layout("x", [*positions, *unknowns.velocities, *turning, *plastic]), Layout("z", []))
    return State(Layout("x", [*positions, *unknowns.velocities, *plastic]), Layout("z", angles))


def _instant(
    equations: FilamentEquations,
    fields: Fields,
    state: State,
    values: dict[sy.Symbol, ca.SX],
    time: ca.SX,
    time_scale: ca.SX,
) -> _Instant:
    zeros = ca.SX(*fields.y.shape)
    gravity, gravity_rate = gravity_at(equations.terms, values, time * time_scale)
    turning = ca.SX(0)
    if equations.resolved is not None:
        per_area = {"I": equations.resolved.rotary_inertia.subs(sy.A0, 1)}
        turning = ca.SX(CellFunction(per_area, (sy.rho, sy.h0))({sy.rho: values[sy.rho], sy.h0: values[sy.h0]})["I"])
    return _Instant(
        fields=fields,
        u=state.field("u", zeros),
        v=state.field("v", zeros),
        omega=state.field("omega", zeros),
        gravity=gravity,
        gravity_rate=gravity_rate,
        rotary_inertia=turning,
        density=values[sy.rho],
        span=values[sy.L],
        time_scale=time_scale,
    )


def _rates(now: _Instant, grid: Grid) -> dict[str, ca.SX]:
    """Rates of all unknowns in units of span and time scale; momentum is divided by the mass of each node.

    An algebraic unknown is where its momentum would not change.
    """
    fields, unit = now.fields, now.time_scale**2 / now.span
    per_mass = ca.DM(1 / grid.node_length) * (unit / (now.density * now.span))
    net = tuple(ca.vertcat(force, 0) - ca.vertcat(0, force) for force in (fields.force_x, fields.force_y))
    turning = ca.SX(grid.cells + 1, 1)
    if fields.torque is not None:
        per_inertia = ca.DM(1 / grid.node_length) * (now.time_scale**2 / (now.rotary_inertia * now.span))
        turning = fields.torque * per_inertia
    return {
        "x": now.u,
        "y": now.v,
        "u": net[0] * per_mass,
        "v": net[1] * per_mass - now.gravity * unit,
        "psi": now.omega,
        "omega": turning,
        **{name: rate * now.time_scale for name, rate in fields.plastic_rates.items()},
    }


def _balances(now: _Instant, rates: dict[str, ca.SX]) -> dict[str, ca.SX]:
    """What must vanish for each algebraic unknown: the rate of its momentum.

    A torque is divided by the mass and the square of the span, not by the rotary inertia: sparse factorisations do not
    scale rows, and one that is thousands of times larger than the others blurs them.
    """
    turning = rates["omega"] * (now.rotary_inertia / (now.density * now.span**2))
    return {"x": rates["u"], "y": rates["v"], "psi": turning}


def _powers(now: _Instant, grid: Grid) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Plastic power, power of the changing load and of the gradient, place by place, in units of `energy_scale`."""
    fields = now.fields
    scale: ca.SX = now.time_scale / energy_scale(now.density, now.span, now.time_scale)
    lifted = (ca.DM(grid.node_length) * (now.span * now.density * now.gravity_rate * scale)) * fields.y
    steepened = ca.SX(1, 1)
    if fields.double_force is not None:
        per_length = ca.DM(1 / grid.cell_length)
        slope, speed = ((ca.diff(a) * per_length, ca.diff(b) * per_length) for a, b in _pairs(now))
        stretching = (slope[0] * speed[0] + slope[1] * speed[1]) / fields.stretch
        steepened = fields.double_force * ca.diff(stretching) * (scale / now.time_scale)
    nothing = ca.SX(1, 1)
    powers = (fields.dissipation * scale, lifted, steepened)
    return tuple(nothing if power.is_zero() else power for power in powers)  # type: ignore[return-value]


def _pairs(now: _Instant) -> tuple[tuple[ca.SX, ca.SX], tuple[ca.SX, ca.SX]]:
    return (now.fields.x, now.fields.y), (now.u, now.v)


def energy_scale(density: Any, span: Any, time_scale: Any) -> Any:
    """Unit of the quadratures [Pa]: density times the square of span over time scale.

    An integrator that controls the quadratures measures them with the tolerances of the unknowns, so they have the same
    size whatever the units of the scene.
    """
    return density * (span / time_scale) ** 2


def _observables(now: _Instant, grid: Grid) -> dict[str, ca.SX]:
    span, fields = now.span, now.fields
    speed = span / now.time_scale
    node = ca.DM(grid.node_length)
    moving = ca.dot(node, now.u**2 + now.v**2) * speed**2 * now.density / 2
    turning = ca.dot(node, now.omega**2) * now.rotary_inertia / (2 * now.time_scale**2)
    double_force = fields.double_force if fields.double_force is not None else ca.SX(grid.cells - 1, 1)
    return {
        "x": fields.x * span,
        "y": fields.y * span,
        "stretch": fields.stretch,
        **fields.observables,
        "double_force": double_force,
        "energy_kinetic": (moving + turning) * span,
        "energy_elastic": fields.elastic_energy * span,
        "energy_potential": ca.dot(node, fields.y) * span * now.density * now.gravity * span,
    }
