"""Equations and a grid become a Graph: which unknowns are differential, which algebraic, and what they balance."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.body import Body, node_masses
from softcat_sym.graph.cell_printer import Inputs, parameter_inputs
from softcat_sym.graph.discretisation import Discretisation, Setting, State, Unknowns
from softcat_sym.graph.graph import Expressions, Graph
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.instant import When, balances_of, instant, observables_of, powers_of, rates_of
from softcat_sym.graph.kirchhoff import KIRCHHOFF
from softcat_sym.graph.layout import Block, Layout
from softcat_sym.graph.lengths import lengths_of
from softcat_sym.graph.parameters import TIME_SCALE
from softcat_sym.graph.supports import held


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
    given = inputs_for(equations, theory, body)
    time, unknowns = ca.SX.sym("t"), theory.unknowns(equations, grid)
    state = layouts_of(equations, unknowns)
    scale, values = given.named[TIME_SCALE], given.symbols
    supports = held(body.supports, given.named, values[sy.L_0], time * scale)
    setting = Setting(values, grid, body.profile, supports, scale, lengths_of(grid))
    when = When(time, node_masses(equations, grid, body, given))

    def write() -> Expressions:
        now = instant(equations, theory, setting, given, state, when)
        rates = rates_of(now)
        found = state.moving.gather(rates), state.still.gather(balances_of(now, rates))
        return Expressions(found, powers_of(now), observables_of(now))

    return _graph_of(equations, effects, given, state, time, write, dict(unknowns.profiles), grid)


def _graph_of(
    equations: FilamentEquations,
    effects: tuple[str, ...],
    given: Inputs,
    state: State,
    time: ca.SX,
    write: Callable[[], Expressions],
    profiles: dict[str, tuple[float, float]],
    grid: Grid,
) -> Graph:
    return Graph(
        grid=grid,
        effects=effects,
        conserves_energy=equations.conserves_energy,
        parameters=tuple(given.named),
        t=time,
        x=state.moving.vector,
        z=state.still.vector,
        p=given.vector,
        write=write,
        state_names=state.moving.names,
        algebraic_names=state.still.names,
        start=state.moving.start,
        straight=state.still.start,
        x_kinds=state.moving.kinds,
        z_kinds=state.still.kinds,
        x_where=state.moving.where,
        z_where=state.still.where,
        x_places=state.moving.places,
        z_places=state.still.places,
        profiles=profiles,
    )


def inputs_for(equations: FilamentEquations, theory: Discretisation, body: Body) -> Inputs:
    """The parameters that occur in a filament's equations, loads and supports."""
    terms, resolved = equations.terms, equations.resolved
    turning = [resolved.rotary_inertia] if resolved is not None else []
    printed = [*theory.expressions(equations), terms.load, terms.load_rate, *turning]
    return parameter_inputs(printed, equations.law.constants, body.parameters)


def layouts_of(equations: FilamentEquations, unknowns: Unknowns) -> State:
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
