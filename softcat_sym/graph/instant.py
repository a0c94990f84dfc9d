"""The filament at one instant: its fields, and what they mean for momentum, power and energy."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import Inputs, gravity_at
from softcat_sym.graph.discretisation import Discretisation, Fields, Recall, Setting
from softcat_sym.graph.parameters import TIME_SCALE
from softcat_sym.printing import CellFunction


@dataclass(frozen=True)
class Instant:
    """The filament at one instant: fields, velocities in rest lengths per time scale, and the scales (SI) of both."""

    fields: Fields
    setting: Setting
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


@dataclass(frozen=True)
class When:
    """Time in units of the time scale, and the mass of each node over density, undeformed area and rest length."""

    time: ca.SX
    mass: ca.SX


def instant(
    equations: FilamentEquations, theory: Discretisation, setting: Setting, given: Inputs, state: Recall, when: When
) -> Instant:
    """Evaluate the filament.

    Parameters
    ----------
    equations : FilamentEquations
        One cell.
    theory : Discretisation
        Which unknowns the grid carries.
    setting : Setting
        Parameters and grid.
    given : Inputs
        The parameters by name.
    state : Recall
        The unknowns.
    when : When
        Time and masses.
    """
    values, zeros = setting.values, ca.SX(setting.grid.cells + 1, 1)
    gravity, gravity_rate = gravity_at(equations.terms, values, when.time * given.named[TIME_SCALE])
    turning = ca.SX(0)
    if equations.resolved is not None:
        per_area = {"I": equations.resolved.rotary_inertia.subs(sy.A0, 1)}
        turning = ca.SX(CellFunction(per_area, (sy.rho, sy.h0))({sy.rho: values[sy.rho], sy.h0: values[sy.h0]})["I"])
    return Instant(
        fields=theory.evaluate(equations, setting, state),
        setting=setting,
        moves=equations.terms.inertia,
        spins=equations.terms.rotary_inertia,
        # Held nodes count with no velocity of their own: it is given, and does not change while they move.
        u=state.field("u", zeros),
        v=state.field("v", zeros),
        omega=state.field("omega", zeros),
        mass=when.mass,
        gravity=gravity,
        gravity_rate=gravity_rate,
        rotary_inertia=turning,
        density=values[sy.rho],
        span=values[sy.L_0],
        time_scale=given.named[TIME_SCALE],
    )


def rates_of(now: Instant) -> dict[str, ca.SX]:
    """Rates of all unknowns in units of rest length and time scale; momentum is divided by the mass of each node.

    An algebraic unknown is where its momentum would not change.
    """
    fields, unit = now.fields, now.time_scale**2 / now.span
    per_mass = 1 / now.mass * (unit / (now.density * now.span))
    net = tuple(ca.vertcat(force, 0) - ca.vertcat(0, force) for force in (fields.force_x, fields.force_y))
    turning = ca.SX(now.setting.grid.cells + 1, 1)
    if fields.torque is not None:
        per_inertia = 1 / now.setting.lengths.node * (now.time_scale**2 / (now.rotary_inertia * now.span))
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


def balances_of(now: Instant, rates: dict[str, ca.SX]) -> dict[str, ca.SX]:
    """What must vanish for each algebraic unknown, a position or a velocity: the rate of its momentum.

    A torque is divided by the mass and the square of the span, not by the rotary inertia: sparse factorisations do not
    scale rows, and one that is thousands of times larger than the others blurs them.
    """
    turning = rates["omega"] * (now.rotary_inertia / (now.density * now.span**2))
    return {"x": rates["u"], "y": rates["v"], "u": rates["u"], "v": rates["v"], "psi": turning, "omega": turning}


def powers_of(now: Instant) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Plastic power, power of the changing load and of the gradient, place by place, in units of `energy_scale`."""
    fields = now.fields
    scale: ca.SX = now.time_scale / energy_scale(now.density, now.span, now.time_scale)
    lifted = (now.mass * (now.span * now.density * now.gravity_rate * scale)) * fields.y
    lifted[-1] += _support_power(now) * scale
    steepened = ca.SX(1, 1)
    if fields.double_force is not None:
        per_length = 1 / now.setting.lengths.cell
        slope, speed = ((ca.diff(a) * per_length, ca.diff(b) * per_length) for a, b in _pairs(now))
        stretching = (slope[0] * speed[0] + slope[1] * speed[1]) / fields.stretch
        steepened = fields.double_force * ca.diff(stretching) * (scale / now.time_scale)
    nothing = ca.SX(1, 1)
    powers = (fields.dissipation * scale, lifted, steepened)
    return tuple(nothing if power.is_zero() else power for power in powers)  # type: ignore[return-value]


def _support_power(now: Instant) -> ca.SX:
    """Power of the right support over the rest length [Pa/s]: its force carries the last cell and its own share."""
    fields, at = now.fields, now.setting.supports
    weight = now.mass[-1] * now.density * now.gravity * now.span
    return fields.force_x[-1] * at.right_u + (fields.force_y[-1] + weight) * at.right_v


def _pairs(now: Instant) -> tuple[tuple[ca.SX, ca.SX], tuple[ca.SX, ca.SX]]:
    return (now.fields.x, now.fields.y), (now.u, now.v)


def energy_scale(density: Any, span: Any, time_scale: Any) -> Any:
    """Unit of the quadratures [Pa]: density times the square of span over time scale.

    An integrator that controls the quadratures measures them with the tolerances of the unknowns, so they have the same
    size whatever the units of the scene.
    """
    return density * (span / time_scale) ** 2


def observables_of(now: Instant) -> dict[str, ca.SX]:
    """What a trajectory shows, in SI and per unit undeformed area."""
    span, fields = now.span, now.fields
    speed = span / now.time_scale
    node = now.mass
    # Velocities that are unknown for the sake of a viscous stress alone carry no energy.
    moving = now.moves * ca.dot(node, now.u**2 + now.v**2) * speed**2 * now.density / 2
    turning = now.spins * ca.dot(now.setting.lengths.node, now.omega**2) * now.rotary_inertia / (2 * now.time_scale**2)
    surface = fields.surface_energy if fields.surface_energy is not None else ca.SX(1, 1)
    double_force = fields.double_force if fields.double_force is not None else ca.SX(now.setting.grid.cells - 1, 1)
    return {
        "x": fields.x * span,
        "y": fields.y * span,
        "stretch": fields.stretch,
        **fields.observables,
        "double_force": double_force,
        "energy_kinetic": (moving + turning) * span,
        "energy_elastic": fields.elastic_energy * span,
        "energy_surface": surface * span,
        "energy_potential": ca.dot(node, fields.y) * span * now.density * now.gravity * span,
    }
