"""The filament: balance of momentum of its nodes, its powers, and what a run stores of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from softcat_sym.discretization.cell import (
    Builder,
    Mechanics,
    Program,
    Sided,
    necking_power,
    ordered,
    printed,
    program_of,
)
from softcat_sym.discretization.heat import Heating, heating
from softcat_sym.discretization.kirchhoff import kirchhoff
from softcat_sym.discretization.outer_forces import Outer, outer_forces
from softcat_sym.discretization.parameters import energy_scale
from softcat_sym.discretization.sampling import Sampling
from softcat_sym.discretization.shearing import shearing
from softcat_sym.discretization.small_deflection import SmallDeflection
from softcat_sym.discretization.spatial import spatial_filament
from softcat_sym.discretization.stencil import UNKNOWN, Field, Neighbours
from softcat_sym.discretization.supports import POINT_MASS, Body
from softcat_sym.discretization.unknowns import CELLS, HEAT_LOST, INNER, NODES, WORK_OF_AGEING, Slot, Where
from softcat_sym.physics import symbols
from softcat_sym.physics.filament import FilamentEquations
from softcat_sym.scene.ends import Support


def build(
    equations: FilamentEquations,
    model: str,
    ends: tuple[Support, Support],
    body: Body,
    rule: Sampling | None,
) -> Program | SmallDeflection:
    """A filament of these equations between two ends, as fields; `rule` samples a section that is resolved."""
    if model == "small-deflection":
        return SmallDeflection(equations, ends, body)
    b = Builder(equations, ends, body)
    if rule is not None and rule.is_spatial:
        return spatial_filament(b, rule)
    mechanics = shearing(b, rule) if rule is not None and equations.resolved is not None else kirchhoff(b)
    return _balanced(b, mechanics)


def _balanced(b: Builder, of: Mechanics) -> Program:
    """Rates of all unknowns, powers and observables, in units of rest length and time scale."""
    span, scale = b.span, b.scale
    load = {**b.values, symbols.t: b.time * scale}
    gravity, gravity_rate = printed(b.equations.load, load), printed(b.equations.load_rate, load)
    mass = b.place("mass")[0]
    if b.body.weighted:
        mass += b.place("hung")[0] * (b.named[POINT_MASS] / (b.density * span))
    unit = scale**2 / span
    per_mass = 1 / mass * (unit / (b.density * span))
    rotary = ca.SX(0)
    if b.equations.resolved is not None:
        rotary = printed(b.equations.resolved.rotary_inertia, b.values)

    outer, heat = outer_forces(b, of), heating(b, of)
    of.energies |= outer.energies
    fixed = per_mass, gravity * unit, rotary
    massive = _Massive(of.force, outer, mass * b.density * span, gravity, unit) if outer.adds_mass else None
    slots = ordered(b.slots)
    rates = tuple(
        massive.rate(slot, b.slots) if massive and slot.name in ("u", "v") else _rate(b, of, outer, slot, fixed)
        for slot in slots
    )
    support = _support(b, of, outer, mass, gravity)
    powers = _powers(b, of, outer, heat, mass, gravity_rate, support)
    shown = _observables(b, of, outer, mass, gravity, rotary) | heat.shown
    linear = {name: (1.0, 0.0) if name.startswith("a_0") else (0.0, 1.0) for name in b.slots if name.startswith("a_")}
    pulled = tuple(Field(f"support_{way}", _AT_RIGHT, one) for way, one in zip("xy", support, strict=True))
    # Where only slopes are in motion nothing balances along x, and one tension may be that of all cells.
    return program_of(b, rates, powers, shown, of.profiles or linear, pulled if b.equations.terms.stretches else ())


def _rate(b: Builder, of: Mechanics, outer: Outer, slot: Slot, fixed: tuple[ca.SX, ca.SX, ca.SX]) -> Field:
    """Rate of an unknown, or what must vanish for an algebraic one: the rate of its momentum.

    A torque is divided by the mass and the square of the span, not by the rotary inertia: sparse factorisations do not
    scale rows, and one that is thousands of times larger than the others blurs them.
    """
    per_mass, weight, rotary = fixed
    name = f"f_{slot.name}"
    if slot.rate:
        return Field(name, slot.where, Neighbours(b.leaves, UNKNOWN, slot.rate)[0])
    if slot.name in b.rates:
        return b.rates[slot.name]
    if slot.name in of.plastic:
        return Field(name, slot.where, of.plastic[slot.name] * b.scale)
    if slot.name in ("psi", "omega"):
        inertia = rotary if slot.differential else b.density * b.span**2
        acting, factor, minus = _torque(b, of, outer), 1 / b.node[0] * (b.scale**2 / (inertia * b.span)), ca.SX(0)
    else:
        way = int(slot.name in ("y", "v"))
        acting, factor = _net(of.force[way], outer, way), per_mass
        minus = weight if way else ca.SX(0)
    if acting is None:
        raise ValueError(f"{slot.name}: nothing turns the sections of this filament")
    # Nodes beside which there is a cell on one side only are written out by themselves.
    sides = zip((0, -1), ((None, 0), (-1, None)), slot.held, strict=True)
    ends = {site: acting(*cells) * factor - minus for site, cells, is_held in sides if not is_held}
    return Field(name, INNER, acting(-1, 0) * factor - minus, ends)


def _torque(b: Builder, of: Mechanics, outer: Outer) -> Sided | None:
    """What the cells beside a node and the spring of an end do to the angle of its section [Pa m]."""
    turning = of.torque
    if turning is None or not outer.springs:
        return turning

    def acting(before: int | None, behind: int | None) -> ca.SX:
        springs = (slope for one in outer.springs if one.acts(before, behind) for slope in one.by_turn)
        return ca.SX(turning(before, behind) - b.span * sum(springs, ca.SX(0)))

    return acting


def _net(force: Neighbours, outer: Outer, way: int) -> Sided:
    """What the forces of the cells beside a node leave, with those from outside."""

    def acting(before: int | None, behind: int | None) -> ca.SX:
        nothing = ca.SX(0)
        inner = (nothing if behind is None else force[behind]) - (nothing if before is None else force[before])
        return inner + outer.at(way, before, behind)

    return acting


@dataclass(frozen=True)
class _Massive:
    """Accelerations of nodes whose mass differs with the direction: two components of a node, solved together."""

    force: tuple[Neighbours, Neighbours]  # Internal [Pa]
    outer: Outer
    mass: ca.SX  # Of the node alone [kg/m^2]
    gravity: ca.SX
    unit: ca.SX  # Dimensionless acceleration over that in SI

    def rate(self, slot: Slot, slots: Mapping[str, Slot]) -> Field:
        """Acceleration of one component; where the other is held, its force is the support's."""
        way = int(slot.name == "v")
        other = slots["u" if way else "v"].held if {"u", "v"} <= set(slots) else (True, True)

        def acting(before: int | None, behind: int | None, *, alone: bool) -> ca.SX:
            along, across = (_net(self.force[k], self.outer, k)(before, behind) for k in (0, 1))
            across -= self.mass * self.gravity
            xx, xy, yy = self.outer.mass(before, behind)
            xx, yy = xx + self.mass, yy + self.mass
            if alone:
                return self.unit * (across / yy if way else along / xx)
            solved = xx * across - xy * along if way else yy * along - xy * across
            return self.unit * solved / (xx * yy - xy**2)

        always = {"u", "v"} - set(slots) != set()
        sides = zip((0, -1), ((None, 0), (-1, None)), slot.held, other, strict=True)
        ends = {site: acting(*cells, alone=held) for site, cells, is_held, held in sides if not is_held}
        return Field(f"f_{slot.name}", INNER, acting(-1, 0, alone=always), ends)


_AT_RIGHT = Where(-1, 0, alone=True)


def _support(b: Builder, of: Mechanics, outer: Outer, mass: ca.SX, gravity: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Force of the right support: it carries the last cell and its own share, or pulls by its spring."""
    for spring in outer.springs:
        if spring.site and not b.last.holds_height:
            return spring.pull[0], spring.pull[1]
    pushed = [outer.at(way, -1, None) for way in (0, 1)]
    return of.force[0][-1] - pushed[0], of.force[1][-1] + mass * b.density * gravity * b.span - pushed[1]


def _powers(
    b: Builder,
    of: Mechanics,
    outer: Outer,
    heat: Heating,
    mass: ca.SX,
    gravity_rate: ca.SX,
    support: tuple[ca.SX, ca.SX],
) -> dict[str, list[Field]]:
    """Plastic power, power of the changing load, of the gradient and of what effects dissipate, site by site.

    In `energy_scale` units; what is integrated beside the unknowns.
    """
    span, at = b.span, b.supports
    scale = b.scale / energy_scale(b.density, span, b.scale)
    lifted = mass * (span * b.density * gravity_rate * scale)
    moved = (support[0] * at.right_u + support[1] * at.right_v) * scale
    load = [Field("power_load_0", NODES, lifted * of.y[0])]
    if not moved.is_zero():
        load.append(Field("power_load_1", _AT_RIGHT, moved))
    load += [one.times(scale) for one in outer.power]
    gradient: list[Field] = []
    if of.double_force is not None:
        power = necking_power(b, of.double_force, (of.x, of.y), of.moved or (of.u, of.v), of.stretch)
        gradient = [Field("power_gradient_0", INNER, power * (scale / b.scale))]
    plastic = [one.times(scale, f"power_plastic_{k}") for k, one in enumerate(of.dissipation)]
    lost = {name: [one.times(scale) for one in fields] for name, fields in outer.dissipation.items()}
    softened = [one.times(scale) for one in heat.softening]
    groups = {"plastic": plastic, "load": load, "gradient": gradient, **lost}
    groups |= {"energy_softening": softened} if softened else {}
    groups |= {HEAT_LOST: heat.lost} if heat.lost else {}
    if b.equations.clocks:
        groups[WORK_OF_AGEING] = [one.times(scale, f"power_ageing_{k}") for k, one in enumerate(of.ageing)]
    return groups


def _observables(
    b: Builder, of: Mechanics, outer: Outer, mass: ca.SX, gravity: ca.SX, rotary: ca.SX
) -> dict[str, Field | tuple[Field, ...]]:
    """What a run stores, in SI and per unit undeformed area."""
    span, terms = b.span, b.equations.terms
    # Velocities that are unknown for the sake of a viscous stress alone carry no energy.
    speed = span / b.scale
    kinetic = []
    if terms.inertia:
        moving = mass * (of.u[0] ** 2 + of.v[0] ** 2) * speed**2 * b.density / 2
        kinetic.append(Field("moving", NODES, moving * span))
        kinetic += [one.times(span) for one in outer.kinetic]
    if terms.rotary_inertia:
        turning = b.node[0] * of.omega[0] ** 2 * rotary / (2 * b.scale**2)
        kinetic.append(Field("turning", NODES, turning * span))
    stored = {f"energy_{name}": tuple(one.times(span, name) for one in fields) for name, fields in of.energies.items()}
    double_force = ca.SX(0) if of.double_force is None else of.double_force[0]
    return {
        "x": Field("x", NODES, of.x[0] * span),
        "y": Field("y", NODES, of.y[0] * span),
        "stretch": Field("stretch", CELLS, of.stretch[0]),
        **{name: Field(name, CELLS, ca.SX(value)) for name, value in of.shown.items()},
        "double_force": Field("double_force", INNER, double_force),
        "energy_kinetic": tuple(kinetic),
        **stored,
        "energy_potential": (Field("weight", NODES, mass * of.y[0] * span * b.density * gravity * span),),
    }
