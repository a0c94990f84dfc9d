"""Equations and a grid become a Graph: which unknowns are differential, which algebraic, and what they balance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.body import Body, node_masses
from softcat_sym.graph.cell_printer import Inputs, gravity_at, parameter_inputs
from softcat_sym.graph.discretisation import Discretisation, Fields, Setting, State, Unknowns
from softcat_sym.graph.graph import Graph
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.kirchhoff import KIRCHHOFF
from softcat_sym.graph.layout import Block, Layout
from softcat_sym.graph.parameters import TIME_SCALE
from softcat_sym.graph.supports import Held, held
from softcat_sym.printing import CellFunction


@dataclass(frozen=True)
class _Instant:
    """The filament at one instant: fields, velocities in rest lengths per time scale, and the scales (SI) of both."""

    fields: Fields
    supports: Held
    moves: bool
    spins: bool
    u: ca.SX
    v: ca.SX
    omega: ca.SX
    mass: ca.SX
    gravity: ca.SX
    gravity_rate: ca.SX
    rotary_inertia: ca.SX
    density: ca.SX
    span: ca.SX
    time_scale: ca.SX


def assemble(
    equations: FilamentEquations,
    grid: Grid,
    effects: tuple[str, ...],
    theory: Discretisation = KIRCHHOFF,
    body: Body | None = None,
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
    body : Body
        Supports, profile and point mass.

    Returns
    -------
    Graph
        An ODE, or an index-1 DAE: without inertia the positions are algebraic, or the velocities where the stress is
        viscous; section angles likewise without rotary inertia.
    """
    body = body or Body()
    printed = [*theory.expressions(equations), *_loads(equations)]
    given = parameter_inputs(printed, equations.law.constants, body.parameters)
    time, unknowns = ca.SX.sym("t"), theory.unknowns(equations, grid)
    state = _layouts(equations, unknowns)
    now = _instant(equations, theory, grid, body, given, state, time)
    return _graph_of(equations, effects, given, state, time, now, dict(unknowns.profiles), grid)


def _graph_of(
    equations: FilamentEquations,
    effects: tuple[str, ...],
    given: Inputs,
    state: State,
    time: ca.SX,
    now: _Instant,
    profiles: dict[str, tuple[float, float]],
    grid: Grid,
) -> Graph:
    rates = _rates(now, grid)
    ode, alg = _tidy(state.moving.gather(rates), state.still.gather(_balances(now, rates)))
    plastic_powers, load_powers, gradient_powers = _tidy(*_powers(now, grid))
    return Graph(
        grid=grid,
        effects=effects,
        conserves_energy=equations.conserves_energy,
        parameters=tuple(given.named),
        t=time,
        x=state.moving.vector,
        z=state.still.vector,
        p=given.vector,
        ode=ode,
        alg=alg,
        plastic_powers=plastic_powers,
        load_powers=load_powers,
        gradient_powers=gradient_powers,
        state_names=state.moving.names,
        algebraic_names=state.still.names,
        observables=_function([time, state.moving.vector, state.still.vector, given.vector], _observables(now, grid)),
        start=state.moving.start,
        straight=state.still.start,
        x_kinds=state.moving.kinds,
        z_kinds=state.still.kinds,
        x_where=state.moving.where,
        z_where=state.still.where,
        profiles=profiles,
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
    """Differential and algebraic unknowns.

    Plastic states are differential, and so are positions and angles that have a rate among the unknowns: velocities
    with inertia or a viscous stress, spins with rotary inertia or a viscous stress. A rate whose inertia is left out is
    algebraic; so is a position or an angle without a rate.
    """
    viscous = equations.law.viscosity is not None
    inertia, rotary = equations.terms.inertia, equations.terms.rotary_inertia and equations.terms.inertia
    moving: list[Block] = []
    still: list[Block] = []
    (moving if inertia or viscous else still).extend(unknowns.positions)
    if inertia or viscous:
        (moving if inertia else still).extend(unknowns.velocities)
    (moving if unknowns.spins else still).extend(unknowns.angles)
    (moving if rotary else still).extend(unknowns.spins)
    return State(Layout("x", [*moving, *unknowns.plastic]), Layout("z", still))


def _instant(
    equations: FilamentEquations,
    theory: Discretisation,
    grid: Grid,
    body: Body,
    given: Inputs,
    state: State,
    time: ca.SX,
) -> _Instant:
    values, time_scale = given.symbols, given.named[TIME_SCALE]
    seconds, zeros = time * time_scale, ca.SX(grid.cells + 1, 1)
    supports = held(body.supports, given.named, values[sy.L_0], seconds)
    gravity, gravity_rate = gravity_at(equations.terms, values, seconds)
    turning = ca.SX(0)
    if equations.resolved is not None:
        per_area = {"I": equations.resolved.rotary_inertia.subs(sy.A0, 1)}
        turning = ca.SX(CellFunction(per_area, (sy.rho, sy.h0))({sy.rho: values[sy.rho], sy.h0: values[sy.h0]})["I"])
    return _Instant(
        fields=theory.evaluate(equations, Setting(values, grid, body.profile, supports, time_scale), state),
        supports=supports,
        moves=equations.terms.inertia,
        spins=equations.terms.rotary_inertia,
        # Held nodes count with no velocity of their own: it is given, and does not change while they move.
        u=state.field("u", zeros),
        v=state.field("v", zeros),
        omega=state.field("omega", zeros),
        mass=node_masses(equations, grid, body, given),
        gravity=gravity,
        gravity_rate=gravity_rate,
        rotary_inertia=turning,
        density=values[sy.rho],
        span=values[sy.L_0],
        time_scale=time_scale,
    )


def _rates(now: _Instant, grid: Grid) -> dict[str, ca.SX]:
    """Rates of all unknowns in units of rest length and time scale; momentum is divided by the mass of each node.

    An algebraic unknown is where its momentum would not change.
    """
    fields, unit = now.fields, now.time_scale**2 / now.span
    per_mass = 1 / now.mass * (unit / (now.density * now.span))
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
    """What must vanish for each algebraic unknown, a position or a velocity: the rate of its momentum.

    A torque is divided by the mass and the square of the span, not by the rotary inertia: sparse factorisations do not
    scale rows, and one that is thousands of times larger than the others blurs them.
    """
    turning = rates["omega"] * (now.rotary_inertia / (now.density * now.span**2))
    return {"x": rates["u"], "y": rates["v"], "u": rates["u"], "v": rates["v"], "psi": turning, "omega": turning}


def _powers(now: _Instant, grid: Grid) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Plastic power, power of the changing load and of the gradient, place by place, in units of `energy_scale`."""
    fields = now.fields
    scale: ca.SX = now.time_scale / energy_scale(now.density, now.span, now.time_scale)
    lifted = (now.mass * (now.span * now.density * now.gravity_rate * scale)) * fields.y
    lifted[-1] += _support_power(now) * scale
    steepened = ca.SX(1, 1)
    if fields.double_force is not None:
        per_length = ca.DM(1 / grid.cell_length)
        slope, speed = ((ca.diff(a) * per_length, ca.diff(b) * per_length) for a, b in _pairs(now))
        stretching = (slope[0] * speed[0] + slope[1] * speed[1]) / fields.stretch
        steepened = fields.double_force * ca.diff(stretching) * (scale / now.time_scale)
    nothing = ca.SX(1, 1)
    powers = (fields.dissipation * scale, lifted, steepened)
    return tuple(nothing if power.is_zero() else power for power in powers)  # type: ignore[return-value]


def _support_power(now: _Instant) -> ca.SX:
    """Power of the right support over the rest length [Pa/s]: its force carries the last cell and its own share."""
    fields, at = now.fields, now.supports
    weight = now.mass[-1] * now.density * now.gravity * now.span
    return fields.force_x[-1] * at.right_u + (fields.force_y[-1] + weight) * at.right_v


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
    node = now.mass
    # Velocities that are unknown for the sake of a viscous stress alone carry no energy.
    moving = now.moves * ca.dot(node, now.u**2 + now.v**2) * speed**2 * now.density / 2
    turning = now.spins * ca.dot(ca.DM(grid.node_length), now.omega**2) * now.rotary_inertia / (2 * now.time_scale**2)
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
