"""Temperatures of the nodes: what is dissipated around a node heats it, its surface and its neighbours take heat away.

A node has the heat capacity of the material it answers for; cells give half of what they dissipate to each of their
nodes, so that no heat is lost between them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import casadi as ca

from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.cell import Builder, Mechanics, Sided
from softcat_sym.discretization.stencil import Field, Neighbours, Same
from softcat_sym.discretization.unknowns import CELLS, NODES, WARMING
from softcat_sym.physics import heat as sy
from softcat_sym.physics import symbols
from softcat_sym.physics.heat import Heat
from softcat_sym.physics.necking import aspect


@dataclass
class Heating:
    """What a run shows of the heat, and what is integrated beside the unknowns; nothing without a temperature."""

    shown: dict[str, Field | tuple[Field, ...]] = field(default_factory=dict)
    lost: list[Field] = field(default_factory=list)
    softening: list[Field] = field(default_factory=list)  # Elastic power that a falling modulus sets free [Pa/s]


def heating(b: Builder, of: Mechanics) -> Heating:
    """The rate of every node's temperature, and the balance of heat."""
    heat = b.equations.heat
    if heat is None:
        return Heating()
    mass, start = b.place("mass")[0] if b.exit is None else b.borne[0], b.values[sy.initial]
    capacity = (mass if b.exit is None else b.exit.mass[0]) * b.density * b.values[sy.heat_capacity]
    made, lost = _shared(b, "heat_made", of.dissipation), _lost(b, of, heat)
    conducted = _conducted(b, of, heat)
    # Energy that a kelvin more takes from around a node: less where the modulus falls, or where what is pulled expands.
    softened = _shared(b, "softening_of", of.softening if heat.stiffens else [])

    def rate(before: int | None, behind: int | None) -> ca.SX:
        gained = made(before, behind) - lost[0] + conducted(before, behind)
        fresh = ca.SX(0) if b.exit is None else b.exit.fresh * b.warming[0]
        return ca.SX((gained / (start * (capacity + softened(before, behind))) - fresh) * b.scale)

    # Read again where the modulus gives elastic energy back.
    name = f"f_{WARMING}"
    b.rates[WARMING] = Field(name, NODES, b.nodes("warming_rate", rate)[0])
    found = Heating()
    unit = b.density * b.values[sy.heat_capacity] * start
    if heat.coefficient != 0:
        found.lost = [Field("power_heat_lost", NODES, lost[0] * b.scale / unit)]
    if heat.stiffens:
        weight, warming = b.nodes("softened", softened), b.rates[WARMING].value
        found.softening = [Field("power_softening", NODES, -weight[0] * warming * start / b.scale)]
    found.shown = {
        "temperature": Field("temperature", NODES, b.kelvin(b.warming[0])),
        "heat_stored": (Field("heat_stored", NODES, mass * unit * b.warming[0] * b.span),),
    }
    return found


def _shared(b: Builder, name: str, fields: Sequence[Field]) -> Sided:
    """Sum at a node of fields of cells, half of each, and of nodes."""
    cells, nodes = list[Neighbours](), list[Neighbours]()
    for k, one in enumerate(fields):
        staged = b.stage(f"{name}_{k}", one.where, one.value, one.ends)
        # Of the nodes that carry a moment a field says what the others have.
        (cells if one.where == CELLS and not one.ends else nodes).append(staged)

    def build(before: int | None, behind: int | None) -> ca.SX:
        own = sum((one[0] for one in nodes), ca.SX(0))
        sites = [site for site in (before, behind) if site is not None]
        return own + sum((one[site] / 2 for one in cells for site in sites), ca.SX(0))

    return build


def _lost(b: Builder, of: Mechanics, heat: Heat) -> Neighbours:
    """Heat that passes the surface of a node, over the rest length and the undeformed area [Pa/s]."""
    if heat.coefficient == 0:
        return Same()
    stretch = b.nodes("stretch_of_a_node", b.averaged(of.stretch))
    around = _around(b, heat)
    values = {**b.values_node, symbols.s: stretch[0], symbols.h0: b.h_node, sy.around: around[0]}
    if b.body.profile.nodes is not None:
        # Along a profile the width stays.
        values[aspect] = b.values[aspect] / b.place("h_node")[0]
    coefficient = heat.coefficient if b.equations.terms.thins else heat.thick().coefficient
    flux = printed(coefficient, values) * (values[sy.temperature] - around[0])
    surface = printed(b.equations.exchange, values) * b.borne[0] * b.area_node
    return b.stage("heat_lost", NODES, flux * surface)


def _around(b: Builder, heat: Heat) -> Neighbours:
    """Temperature around the nodes; of one that the end of the furnace divides the mean."""
    now = printed(heat.ambient, {**b.values, symbols.t: b.time * b.scale})
    if not heat.partial:
        return Same(now)
    away = b.values[sy.outside]
    low, high = (b.values[one] / b.span - 0.5 for one in (sy.begin, sy.end))

    def build(before: int | None, behind: int | None) -> ca.SX:
        left = b.X[0] if before is None else b.X[0] - b.length[before] / 2
        right = b.X[0] if behind is None else b.X[0] + b.length[behind] / 2
        within = ca.fmax(ca.fmin(right, high) - ca.fmax(left, low), 0) / b.node[0]
        return ca.SX(away + within * (now - away))

    return b.nodes("temperature_around", build)


def _conducted(b: Builder, of: Mechanics, heat: Heat) -> Sided:
    """What a node gains from its neighbours, over the rest length and the undeformed area [Pa/s]."""
    if not heat.conducts:
        return lambda *_: ca.SX(0)
    stretch = of.stretch[0]
    area = printed(b.equations.response.area / symbols.A0, {**b.values, symbols.s: stretch})
    through = b.values[sy.conductivity] * b.area_cell * area / stretch
    rise = (b.warming[1] - b.warming[0]) * b.values[sy.initial] / b.length[0] / b.span**2
    flux = b.stage("heat_flux", CELLS, through * rise)

    def build(before: int | None, behind: int | None) -> ca.SX:
        ahead = ca.SX(0) if behind is None else flux[behind]
        return ahead if before is None else ahead - flux[before]

    return build
