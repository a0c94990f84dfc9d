"""Small deflections of an elastic or Maxwell filament between level ends: (2.13) to (2.19), from SymPy to an ODE.

SymPy states the equations, CasADi evaluates them on all nodes at once (the stretch is one number of the filament, so
that a cell says nothing by itself), and CVODES or another of its integrators solves y_t = v, v_t = ...
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np
import sympy as sp

from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.parameters import AREA, REST_LENGTH, TIME_SCALE, energy_scale
from softcat_sym.discretization.stencil import Evaluated
from softcat_sym.discretization.supports import POINT_MASS, FilamentBody
from softcat_sym.discretization.unknowns import WORK_OF_AGEING, Signature, Slot
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.constitutive_laws import growth_of
from softcat_sym.physics.section_equations import FilamentEquations
from softcat_sym.physics.section_response import shrunk
from softcat_sym.scene.ends import Support

zeta_squared, GROWTH = sp.Symbol("zeta_squared", positive=True), growth_of(sy.E)
I = sy.A0 * sy.h0**2 * zeta_squared / 4  # noqa: E741  # The paper's name

ELONGATION = sy.y_X**2 / 2  # (2.13)
T = sy.E * sy.A0 * (sy.s - 1 - sy.n_0 - sy.a_0)  # (2.15), with P = A_0 a_0; n_0 and n_1 are natural strains
M = -sy.E * I * (sy.theta_X + 2 * (sy.n_1 + sy.a_1) / sy.h0)  # (2.15), with C = 2 I a_1/h_0
F_y = sy.T * sy.y_X + sy.M_X  # Its change along X is the left side of (2.14)
SIGMA_0, SIGMA_1 = sy.T / sy.A0, sy.M * sy.h0 / (2 * I)  # (2.23)
FLOW, JOINING = 1 / sy.eta, GROWTH / sy.E  # P_t = T/eta, C_t = M/eta (2.12), and of springs without stress that join
STRETCHING, BENDING = sy.T**2 / (2 * sy.E * sy.A0), sy.M**2 / (2 * sy.E * I)


@dataclass(frozen=True)
class SmallDeflection:
    """The filament between two ends; unknowns are y over the rest length, its rate, a_0 once, and a_1 of nodes."""

    equations: FilamentEquations
    ends: tuple[Support, Support]
    body: FilamentBody
    support: tuple[()] = ()  # Nothing balances along x: the force of a support is not known

    @cached_property
    def signature(self) -> Signature:
        """Unknowns, numbers that a run is given, and what is integrated beside the unknowns."""
        equations, terms, (first, last) = self.equations, self.equations.terms, self.ends
        held, turns = (first.holds_height, last.holds_height), (not first.holds_angle, not last.holds_angle)
        moves = terms.inertia or terms.drags or terms.adds_mass
        slots = [Slot("y", "node", held, moves, "v" if moves else "", section=False)]
        slots += [Slot("v", "node", held, terms.inertia, "", section=False)] * moves
        if equations.law.branches[0].has_state:
            slots += [Slot("a_0", "whole", (False, False), True, "", section=False)]
            slots += [Slot("a_1", "node", turns, True, "", section=False)] * terms.bending
        unused = {sy.sigma_Y} if terms.flows else {sy.sigma_Y, sy.eta}
        rows = [name for name, symbol in equations.symbols.items() if symbol not in unused]
        powers = ["plastic", "load", "gradient", *(one.label for one in equations.densities if one.dissipation != 0)]
        powers += [WORK_OF_AGEING] * bool(equations.clocks)
        parameters, profiles = (*rows, AREA, *self.body.parameters, TIME_SCALE), {"a_0": (1.0, 0.0), "a_1": (0.0, 1.0)}
        return Signature(tuple(slots), parameters, (), tuple(powers), (), profiles)

    def evaluate(
        self, time: ca.SX, unknowns: Mapping[str, ca.SX], named: Mapping[str, ca.SX], places: Mapping[str, Any]
    ) -> Evaluated:
        """Rates of the unknowns, powers and what a run stores, per undeformed area; X and y over the rest length."""
        equations, terms, (left, right) = self.equations, self.equations.terms, self.ends
        node, X, cell, nodes = places["node"], places["X"], places["cell"][:-1], len(places["node"])
        span, scale, rho = named[REST_LENGTH], named[TIME_SCALE], named["density"]
        given: dict[Any, Any] = {one: named[name] for name, one in equations.symbols.items() if name in named}
        given |= {sy.t: time * scale, sy.A0: 1.0}
        given |= dict.fromkeys((sy.n_0, sy.n_1, GROWTH), 0.0) | {zeta_squared: float(equations.shape.zeta_squared)}
        for clock in equations.clocks:
            given |= {symbol: printed(value, given) for symbol, value in clock.replaces}
        if terms.shrinks:
            area, thinner = (printed(factor, given) for factor in shrunk(equations.shape))
            given |= {sy.A0: area, sy.h0: given[sy.h0] * thinner}

        free, bent = slice(int(left.holds_height), nodes - right.holds_height), np.ones(nodes, dtype=bool)
        bent[[0, -1]] = left.holds_angle, right.holds_angle  # Against a level clamp, or its own mirror image
        joints = np.flatnonzero(bent).tolist()
        y, v, a_1 = (ca.SX.zeros(nodes) for _ in range(3))
        for known, name, inside in ((y, "y", free), (v, "v", free), (a_1, "a_1", joints)):
            known[inside] = unknowns.get(name, 0)
        slope = ca.diff(y) / cell
        elongation = printed(ELONGATION, {sy.y_X: slope})
        s = 1 + ca.dot(cell, elongation) / sum(cell)  # (2.17)
        turning = ca.DM(1.0 * bent) * (ca.vertcat(slope, 0) - ca.vertcat(0, slope)) / node / span
        given |= {sy.s: s, sy.theta_X: turning, sy.a_0: unknowns.get("a_0", 0.0), sy.a_1: a_1}
        given |= {sy.T: printed(T, given), sy.M: ca.DM(1.0 * bent * terms.bending) * printed(M, given)}
        sigma_0, sigma_1 = printed(SIGMA_0, given), printed(SIGMA_1, given)
        fluidity = printed(FLOW, given) if terms.flows else 0
        softness = fluidity + printed(JOINING, given)
        surface = sp.S.Zero if equations.surface is None else sy.A0 * equations.surface.energy()
        T_all, M_X = given[sy.T] + printed(sp.diff(surface, sy.s), given), ca.diff(given[sy.M]) / cell / span
        force = printed(F_y, {sy.T: T_all, sy.y_X: slope, sy.M_X: M_X})
        gravity, gravity_rate = printed(equations.load, given), printed(equations.load_rate, given)

        def in_cells(nodes: ca.SX) -> ca.SX:
            return (nodes[1:] + nodes[:-1]) / 2

        def of_effect(density: sp.Expr) -> ca.SX:
            """A density that an effect adds, of each cell: half of it at either of its nodes."""
            at = {sy.x_X: s - elongation, sy.y_X: slope, sy.x_t: 0.0, sy.x_Xt: 0.0, sy.y_Xt: ca.diff(v) / cell / scale}
            at |= {sy.g_t: gravity, sy.A0: named[AREA] * given[sy.A0]}
            ends = ({one: value[here] for one, value in moving.items()} for here in (slice(0, -1), slice(1, None)))
            return ca.SX(sum(cell / (2 * named[AREA]) * printed(density, given | at | end) for end in ends))

        x = X + ca.vertcat(0, ca.cumsum(cell * (s - 1 - elongation)))
        moving = {sy.x: x * span, sy.y: y * span, sy.X: ca.DM(X) * span, sy.y_t: v * span / scale}
        added = [density.level for density in equations.densities]
        stored = {one.label: of_effect(one.stored) for one in added if one.stored != 0}
        lost = {one.label: of_effect(one.dissipation) for one in added if one.dissipation != 0}
        kinetic = sum((ca.sum1(of_effect(one.kinetic)) for one in added), ca.SX(0))

        mass = places["mass"] * rho * span + (places["hung"] * named[POINT_MASS] if self.body.weighted else 0)
        inertia, speed, nothing = mass[free], unknowns.get("v"), ca.SX(0)
        net = (ca.vertcat(force, 0) - ca.vertcat(0, force) - mass * gravity)[free]
        net -= ca.gradient(sum(map(ca.sum1, stored.values()), nothing), unknowns["y"])
        if speed is not None:
            net -= scale * ca.gradient(sum(map(ca.sum1, lost.values()), nothing), speed)
            inertia += ca.jtimes(ca.gradient(kinetic, speed), speed, ca.SX.ones(speed.shape)) * scale**2 / span
        falling = net / inertia * scale**2 / span  # (2.14)
        rates = {"y": falling if speed is None else speed, "v": falling}
        rates |= {"a_0": softness * sigma_0 * scale, "a_1": (softness * sigma_1 * scale)[joints]}  # (2.12)

        elastic = ca.vertcat(cell * printed(STRETCHING, given), node * printed(BENDING, given))
        of_surface = cell * printed(surface, given)
        bending = node * given[sy.A0] * given[zeta_squared] * sigma_1**2
        powers = {
            "plastic": softness * ca.vertcat(cell * given[sy.T] * sigma_0, bending),
            "load": ca.vertcat(mass * gravity_rate * y, *(ca.jtimes(one, time, 1) / scale for one in stored.values())),
            "gradient": ca.SX(1, 1),
            WORK_OF_AGEING: ca.jtimes(ca.vertcat(elastic, of_surface), time, 1) / scale,
            **({} if speed is None else {name: ca.jtimes(one, speed, speed) for name, one in lost.items()}),
        }
        unit, every = scale / energy_scale(rho, span, scale), ca.SX.ones(nodes - 1)
        shown = {
            "x": x * span,
            "y": y * span,
            "stretch": s * every,
            "shear_force": M_X / s,
            "relative_thickness": every,
            "tension": given[sy.T] * every,
            "moment": in_cells(given[sy.M]),
            "curvature": in_cells(turning) / s,
            "shear": 0 * every,
            "yielded_fraction": terms.flows * every,
            "plastic_rate": fluidity * in_cells(ca.fabs(sigma_0) + ca.fabs(sigma_1)),
            "stress_mean": sigma_0 * every,
            "stress_bending": in_cells(sigma_1),
            **({} if equations.surface is None else {"axial_force": T_all * every}),
            "double_force": ca.SX.zeros(nodes - 2),
            "energy_kinetic": terms.inertia * (ca.sum1(mass * v**2) * (span / scale) ** 2 / 2 + kinetic * span),
            "energy_elastic": ca.sum1(elastic) * span,
            "energy_surface": ca.sum1(of_surface) * span,
            **{f"energy_{name}": ca.sum1(one) * span for name, one in stored.items()},
            "energy_potential": ca.sum1(mass * y) * gravity * span,
        }
        spent = (powers[name] * unit for name in self.signature.powers)
        return Evaluated(rates, tuple(ca.SX(1, 1) if one.is_zero() else one for one in spent), shown, ())
