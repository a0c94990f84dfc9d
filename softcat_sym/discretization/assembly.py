"""Equations and a grid become a Graph: the theory that a scene calls for, and the filament at one instant."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.casadi_printer import CellFunction
from softcat_sym.discretization.cell_printer import Inputs, gravity_at, parameter_inputs
from softcat_sym.discretization.graph import (
    POINT_MASS,
    TIME_SCALE,
    Discretisation,
    Expressions,
    Graph,
    Recall,
    Setting,
    State,
    Unknowns,
)
from softcat_sym.discretization.grid import (
    Block,
    End,
    Grid,
    Layout,
    choose_grading,
    half_span,
    lengths_of,
    may_yield,
    towards_middle,
    whole_span,
)
from softcat_sym.discretization.kirchhoff import KIRCHHOFF, SMALL_DEFLECTION
from softcat_sym.discretization.reissner import reissner
from softcat_sym.discretization.section_rule import SectionRule, fibre_rule, order_rule
from softcat_sym.discretization.supports import Profile, Supports, held, node_mass
from softcat_sym.effects.bending import BENDING
from softcat_sym.effects.choosing import Effects, choose_effects
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.effects.scaling_estimates import first_yield_gravity_number, gravity_number_of
from softcat_sym.effects.shear import SHEAR
from softcat_sym.physics import symbols
from softcat_sym.physics.filament import FilamentEquations
from softcat_sym.scene.scene import Scene, is_symmetric, rest_length


@dataclass(frozen=True)
class Body:
    """What of the filament's body and its supports a graph has to know, beyond equations and grid."""

    supports: Supports = field(default_factory=Supports)  # Where they are and how they move
    profile: Profile = field(default_factory=Profile)  # How the section varies along the filament
    weighted: bool = False  # Whether a mass hangs at midspan

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the numbers that it needs."""
        return (*self.supports.parameters, *((POINT_MASS,) if self.weighted else ()))


_THEORIES = {"filament": KIRCHHOFF, "small-deflection": SMALL_DEFLECTION}
_ENDS = {"clamped": End.CLAMPED, "pinned": End.PINNED, "free": End.FREE}

DEFAULT_CELLS = 40
"""Cells per half span: where the whole section is on the cell, and of the published theory away from clamps."""

CLAMPED_CELLS = 80
"""Cells per half span of the published theory between clamps, at an accuracy of a thousandth: its moment, and with it
the largest error, is at the clamp. The error falls as the square, so that fewer do where less is asked."""

_THOUSANDTH = 1e-3

LINEAR_FIBRES = 2
"""Points that follow a linear profile exactly."""

DEFAULT_FIBRES = 8
"""Points through the thickness where fibres yield in turn."""

HINGE_FIBRES = 16
"""Where hinges carry much of the load: while they turn the midpoint is 5 % off with 8, 2 % with 12, 0.4 % with 16."""

_MAX_OF_FIRST_YIELD = 4.0
"""Weight, in that of first yield, beyond which tension carries it: a rectangle collapses at 2, a circle at 2.3."""

DEFAULT_PROJECTION = 24
"""Points that project a flow rule on polynomials: it has kinks."""


def choose_cells(scene: Scene, effects: Effects | None = None) -> int:
    """Cells per half span: as many as the scene says, otherwise what its theory, ends and accuracy need."""
    if scene.numerics.cells is not None:
        return scene.numerics.cells
    names = (effects or choose_effects(scene)).names
    bent_ends = BENDING.name in names and "clamped" in (scene.ends.left, scene.ends.right)
    if {SHEAR.name, FIBRES.name} & set(names) or not bent_ends:
        return DEFAULT_CELLS
    fewer = CLAMPED_CELLS * math.sqrt(_THOUSANDTH / scene.run.accuracy)
    return int(min(CLAMPED_CELLS, max(DEFAULT_CELLS, round(fewer))))


def choose_fibres(scene: Scene) -> int:
    """Points through the thickness where fibres yield in turn: as many as the scene says, or as its hinges need."""
    if scene.numerics.fibres is not None:
        return scene.numerics.fibres
    return HINGE_FIBRES if _hinges_carry(scene) else DEFAULT_FIBRES


def _hinges_carry(scene: Scene) -> bool:
    """Whether much of the load is carried by hinges that yield in bending: not far beyond collapse."""
    gravity_number = gravity_number_of(scene)
    near = gravity_number is not None and gravity_number < _MAX_OF_FIRST_YIELD * first_yield_gravity_number(scene)
    return near and "clamped" in (scene.ends.left, scene.ends.right) and may_yield(scene)


def choose_grid(scene: Scene, effects: Effects | None = None) -> Grid:
    """Cells graded towards the clamps, unless the scene says how; half the span when it is symmetric."""
    cells = choose_cells(scene, effects)
    grading = scene.numerics.grading or choose_grading(scene, cells, effects)
    left, right = _ENDS[scene.ends.left], _ENDS[scene.ends.right]
    middle = towards_middle(scene, effects)
    if is_symmetric(scene):
        return half_span(cells, right, grading, middle=middle)
    return whole_span(cells, left, right, grading, middle=middle)


def choose_body(scene: Scene, grid: Grid) -> Body:
    """Supports, profile and point mass, as far as they are not plain."""
    ends = scene.ends
    supports = Supports(
        apart=not math.isclose(rest_length(scene), scene.filament.span, rel_tol=1e-14),
        lowered=ends.drop != 0,
        # A clamp across the chord is turned into its place from there.
        left_turned=ends.left_angle != 0 or (ends.left == "clamped" and ends.drop != 0),
        right_turned=ends.right_angle != 0 or (ends.right == "clamped" and ends.drop != 0),
        rows=len(ends.motion),
    )
    return Body(supports, Profile.sampled(scene.filament.profile, grid), weighted=scene.load.point_mass > 0)


def choose_theory(scene: Scene, equations: FilamentEquations) -> Discretisation:
    """The discretisation of the scene's model and effects."""
    if equations.resolved is not None:
        return reissner(choose_rule(scene, equations))
    return _THEORIES[scene.model]


def choose_rule(scene: Scene, equations: FilamentEquations) -> SectionRule:
    """Points through the thickness: two for a linear law, which they follow exactly, more where fibres yield in turn.

    ``numerics.order`` asks for amplitudes of polynomials instead of fibres.
    """
    numerics, shape = scene.numerics, equations.shape
    if numerics.order is not None:
        return order_rule(shape, numerics.order, DEFAULT_PROJECTION)
    fibres = choose_fibres(scene) if equations.terms.resolved else numerics.fibres or LINEAR_FIBRES
    return fibre_rule(shape, fibres, halves=equations.terms.resolved and _hinges_carry(scene))


class Instant:
    """The filament at one instant; unknowns are in rest lengths and time scales, what it consists of in SI."""

    def __init__(
        self,
        equations: FilamentEquations,
        theory: Discretisation,
        setting: Setting,
        given: Inputs,
        state: Recall,
        time: ca.SX,
        mass: ca.SX,
    ) -> None:
        values, zeros = setting.values, ca.SX(setting.grid.cells + 1, 1)
        self.terms, self.setting = equations.terms, setting
        self.mass = mass  # Of each node over density, undeformed area and rest length
        self.density, self.span, self.time_scale = values[symbols.rho], values[symbols.L_0], given.named[TIME_SCALE]
        self.gravity, self.gravity_rate = gravity_at(equations.terms, values, time * self.time_scale)
        self.rotary_inertia = ca.SX(0)
        if equations.resolved is not None:
            per_area = {"I": equations.resolved.rotary_inertia.subs(symbols.A0, 1)}
            known = {symbol: values[symbol] for symbol in (symbols.rho, symbols.h0)}
            self.rotary_inertia = ca.SX(CellFunction(per_area, tuple(known))(known)["I"])
        self.fields = theory.evaluate(equations, setting, state)
        # Held nodes count with no velocity of their own: it is given, and does not change while they move.
        self.u, self.v, self.omega = (state.field(name, zeros) for name in ("u", "v", "omega"))

    def rates(self) -> dict[str, ca.SX]:
        """Rates of all unknowns in units of rest length and time scale; momentum is divided by the mass of each node.

        An algebraic unknown is where its momentum would not change.
        """
        fields, unit = self.fields, self.time_scale**2 / self.span
        per_mass = 1 / self.mass * (unit / (self.density * self.span))
        net = tuple(ca.vertcat(force, 0) - ca.vertcat(0, force) for force in (fields.force_x, fields.force_y))
        turning = ca.SX(self.setting.grid.cells + 1, 1)
        if fields.torque is not None:
            per_inertia = 1 / self.setting.lengths.node * (self.time_scale**2 / (self.rotary_inertia * self.span))
            turning = fields.torque * per_inertia
        return {
            "x": self.u,
            "y": self.v,
            "u": net[0] * per_mass,
            "v": net[1] * per_mass - self.gravity * unit,
            "psi": self.omega,
            "omega": turning,
            **{name: rate * self.time_scale for name, rate in fields.plastic_rates.items()},
        }

    def balances(self, rates: dict[str, ca.SX]) -> dict[str, ca.SX]:
        """What must vanish for each algebraic unknown, a position or a velocity: the rate of its momentum.

        A torque is divided by the mass and the square of the span, not by the rotary inertia: sparse factorisations do
        not scale rows, and one that is thousands of times larger than the others blurs them.
        """
        turning = rates["omega"] * (self.rotary_inertia / (self.density * self.span**2))
        return {"x": rates["u"], "y": rates["v"], "u": rates["u"], "v": rates["v"], "psi": turning, "omega": turning}

    def powers(self) -> tuple[ca.SX, ca.SX, ca.SX]:
        """Plastic power, power of the changing load and of the gradient, place by place, in `energy_scale` units."""
        fields, at = self.fields, self.setting.supports
        scale: ca.SX = self.time_scale / energy_scale(self.density, self.span, self.time_scale)
        lifted = (self.mass * (self.span * self.density * self.gravity_rate * scale)) * fields.y
        # The force on the right support carries the last cell and its own share.
        weight = self.mass[-1] * self.density * self.gravity * self.span
        lifted[-1] += (fields.force_x[-1] * at.right_u + (fields.force_y[-1] + weight) * at.right_v) * scale
        steepened = ca.SX(1, 1)
        if fields.double_force is not None:
            per_length = 1 / self.setting.lengths.cell
            pairs = ((fields.x, fields.y), (self.u, self.v))
            slope, speed = ((ca.diff(a) * per_length, ca.diff(b) * per_length) for a, b in pairs)
            stretching = (slope[0] * speed[0] + slope[1] * speed[1]) / fields.stretch
            steepened = fields.double_force * ca.diff(stretching) * (scale / self.time_scale)
        plastic, load, gradient = (
            ca.SX(1, 1) if power.is_zero() else power for power in (fields.dissipation * scale, lifted, steepened)
        )
        return plastic, load, gradient

    def observables(self) -> dict[str, ca.SX]:
        """What a trajectory shows, in SI and per unit undeformed area."""
        span, fields, lengths = self.span, self.fields, self.setting.lengths
        # Velocities that are unknown for the sake of a viscous stress alone carry no energy.
        speed, moves, spins = span / self.time_scale, self.terms.inertia, self.terms.rotary_inertia
        moving = moves * ca.dot(self.mass, self.u**2 + self.v**2) * speed**2 * self.density / 2
        turning = spins * ca.dot(lengths.node, self.omega**2) * self.rotary_inertia / (2 * self.time_scale**2)
        surface, double_force = fields.surface_energy, fields.double_force
        return {
            "x": fields.x * span,
            "y": fields.y * span,
            "stretch": fields.stretch,
            **fields.observables,
            "double_force": ca.SX(self.setting.grid.cells - 1, 1) if double_force is None else double_force,
            "energy_kinetic": (moving + turning) * span,
            "energy_elastic": fields.elastic_energy * span,
            "energy_surface": (ca.SX(1, 1) if surface is None else surface) * span,
            "energy_potential": ca.dot(self.mass, fields.y) * span * self.density * self.gravity * span,
        }


def energy_scale(density: Any, span: Any, time_scale: Any) -> Any:
    """Unit of the quadratures [Pa]: density times the square of span over time scale.

    An integrator that controls the quadratures measures them with the tolerances of the unknowns, so they have the same
    size whatever the units of the scene.
    """
    return density * (span / time_scale) ** 2


def assemble(
    equations: FilamentEquations,
    grid: Grid,
    effects: tuple[str, ...],
    theory: Discretisation = KIRCHHOFF,
    body: Body | None = None,
) -> Graph:
    """Assemble the filament of one cell's equations on a grid."""
    body = body or Body()
    given = inputs_for(equations, theory, body)
    time, unknowns = ca.SX.sym("t"), theory.unknowns(equations, grid)
    state = layouts_of(equations, unknowns)
    scale, values = given.named[TIME_SCALE], given.symbols
    supports = held(body.supports, given.named, values[symbols.L_0], time * scale)
    setting = Setting(values, grid, body.profile, supports, scale, lengths_of(grid))
    mass = ca.SX(node_mass(grid, body.profile, equations.shape.area_power))
    if body.weighted:
        hung = given.named[POINT_MASS] / (values[symbols.rho] * values[symbols.L_0])
        mass[int(np.argmin(np.abs(grid.nodes)))] += hung / 2 if grid.is_half else hung

    def write() -> Expressions:
        now = Instant(equations, theory, setting, given, state, time, mass)
        rates = now.rates()
        found = state.moving.gather(rates), state.still.gather(now.balances(rates))
        return Expressions(found, now.powers(), now.observables())

    moving, still = state.moving, state.still
    return Graph(
        grid=grid,
        effects=effects,
        conserves_energy=equations.conserves_energy,
        parameters=tuple(given.named),
        t=time,
        x=moving.vector,
        z=still.vector,
        p=given.vector,
        write=write,
        state_names=moving.names,
        algebraic_names=still.names,
        start=moving.start,
        straight=still.start,
        x_kinds=moving.kinds,
        z_kinds=still.kinds,
        x_where=moving.where,
        z_where=still.where,
        x_places=moving.places,
        z_places=still.places,
        profiles=dict(unknowns.profiles),
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
