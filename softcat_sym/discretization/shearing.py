"""A filament that shears (geometrically exact in the plane), its section resolved point by point."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.casadi_printer import CellFunction
from softcat_sym.discretization.cell import (
    Builder,
    Mechanics,
    Pair,
    Values,
    branch_name,
    chain_state,
    derivatives,
    mean_of_nodes,
    neck_force,
    positions,
    printed,
    shown_chains,
    surface_force,
    velocities,
)
from softcat_sym.discretization.sampling import OneFibre, Sampling, point_labels
from softcat_sym.discretization.section_rule import POINT, SectionRule
from softcat_sym.discretization.stencil import FIBRE, Field, Leaf, Neighbours, Same
from softcat_sym.discretization.unknowns import CELLS, Floats, Slot
from softcat_sym.physics import backstress, conformation, reissner, symbols
from softcat_sym.physics.bulk import sigma_eq
from softcat_sym.physics.clocks import State
from softcat_sym.physics.conformation import ChainResponse
from softcat_sym.physics.reissner import FibreBranch, FibreHardening, ResolvedSection
from softcat_sym.physics.structure import speed


@dataclass
class Fibres:
    """Sums over the section of a cell, and what a run shows of its fibres."""

    profiles: dict[str, tuple[float, float]]
    axial: ca.SX = field(default_factory=ca.SX)  # Means of the axial stress, of that times zeta, of the shear stress
    axial_zeta: ca.SX = field(default_factory=ca.SX)
    shear: ca.SX = field(default_factory=ca.SX)
    energy: ca.SX = field(default_factory=ca.SX)
    dissipation: ca.SX = field(default_factory=ca.SX)
    ageing: ca.SX = field(default_factory=ca.SX)  # Rate of the energy at a strain that is held, and work of shrinking
    softening: ca.SX = field(default_factory=ca.SX)  # What a kelvin adds to the energy at a strain that is held [1/K]
    plastic: dict[str, ca.SX] = field(default_factory=dict)  # Rates of the plastic states [1/s]
    shown: dict[str, ca.SX] = field(default_factory=dict)


def shearing(b: Builder, rule: Sampling) -> Mechanics:
    """A filament that shears (geometrically exact in the plane), its section resolved point by point.

    Positions and section angle live on nodes, the whole section on cells: a two-node element with one point along the
    filament, so that it neither locks in shear nor has a spurious mode.
    """
    resolved = b.equations.resolved
    if resolved is None:
        raise ValueError("the section is not resolved: neither shear nor fibres are in force")
    x, y = positions(b)
    u, v, *moved = velocities(b)
    psi, omega = angles(b)
    slope_x, slope_y = ((r[1] - r[0]) / b.length[0] for r in (x, y))
    at = {symbols.x_X: slope_x, symbols.y_X: slope_y, reissner.psi: mean_of_nodes(psi)}
    strains = [*(printed(one, at) for one in resolved.strains), (psi[1] - psi[0]) / b.length[0] / b.span]
    rates = [ca.SX(0)] * 3
    if resolved.viscous is not None:
        speed = [(r[1] - r[0]) / b.length[0] / b.scale for r in moved]
        moving = {symbols.x_Xt: speed[0], symbols.y_Xt: speed[1], reissner.psi_t: mean_of_nodes(omega) / b.scale}
        rates = [printed(one, {**at, **moving}) for one in resolved.strain_rates]
        rates.append((omega[1] - omega[0]) / b.scale / b.length[0] / b.span)
    if isinstance(rule, OneFibre):
        # What all fibres see is looked up.
        names = ("Lam", "Gam", "k")
        strains = [b.stage(name, CELLS, one)[0] for name, one in zip(names, strains, strict=True)]
        rates = [b.stage(f"{name}_t", CELLS, one)[0] for name, one in zip(names, rates, strict=True)]
    by = (reissner.Lam, reissner.Gam, reissner.k)
    values = {**b.values, symbols.h0: b.h_cell, **dict(zip(by, strains, strict=True))}
    values |= dict(zip((reissner.Lam_t, reissner.Gam_t, reissner.k_t), rates, strict=True))
    fibres = sampled(b, resolved, rule, values)
    values |= {reissner.sigma_mean: fibres.axial, reissner.sigma_zeta: fibres.axial_zeta}
    values |= {reissner.tau_mean: fibres.shear}
    # Stresses to the conjugates of the cell's strains, and these to forces on its nodes, each by virtual power.
    n_1, n_2, couple = (b.area_cell * one for one in derivatives(resolved.cell.power, by, values))
    turned_by = b.stage("couple", CELLS, couple)
    at |= {reissner.n_1: n_1, reissner.n_2: n_2}
    power = reissner.n_1 * resolved.strains[0] + reissner.n_2 * resolved.strains[1]
    force_x, force_y, turn = derivatives(power, (symbols.x_X, symbols.y_X, reissner.psi), at)
    turned = b.stage("turning_half", CELLS, -b.length[0] * b.span * turn / 2)
    section = {
        name: b.area_cell * printed(one, values)
        for name, one in (("tension", resolved.cell.tension), ("moment", resolved.cell.moment))
    }
    section["shear_force"] = b.area_cell * printed(resolved.cell.shear_force, values)
    # Along the tangent of the centreline, not along the normal of the section: conjugate to its stretch.
    stretch = b.stage("stretch", CELLS, ca.sqrt(slope_x**2 + slope_y**2))
    pull, surface = surface_force(b, stretch)
    tension = b.stage("tension", CELLS, section["tension"]) if b.equations.neck is not None else Same()
    double_force, necked = neck_force(b, stretch, tension)
    along = (pull + necked) / stretch[0]
    force = (
        b.stage("force_x", CELLS, force_x + along * slope_x),
        b.stage("force_y", CELLS, force_y + along * slope_y),
    )

    def torque(before: int | None, behind: int | None) -> ca.SX:
        """Change of the couple and the moment of the forces about a node [Pa m]."""
        ahead = ca.SX(0) if behind is None else turned_by[behind] + turned[behind]
        return ahead if before is None else ahead - turned_by[before] + turned[before]

    shown = {
        **section,
        "relative_thickness": printed(resolved.relative_thickness, values) * b.relative * b.thinned,
        "curvature": strains[2] / strains[0],
        "shear": strains[1] / strains[0],
        **fibres.shown,
        **({"axial_force": (force[0][0] * slope_x + force[1][0] * slope_y) / stretch[0]} if surface else {}),
    }
    volume = b.length[0] * b.area_cell
    return Mechanics(
        x,
        y,
        u,
        v,
        stretch,
        force,
        fibres.plastic,
        {"elastic": [Field("elastic", CELLS, volume * fibres.energy)], "surface": surface},
        [Field("power_plastic", CELLS, volume * fibres.dissipation)],
        shown,
        psi,
        omega,
        torque,
        double_force,
        fibres.profiles,
        moved=(moved[0], moved[1]),
        ageing=_aged(b, volume, fibres, surface),
        softening=_softened(b, volume, fibres, surface),
    )


def _aged(b: Builder, volume: ca.SX, fibres: Fibres, surface: list[Field]) -> list[Field]:
    """What clocks do to the energies; that of the fibres may be a sum, which says nothing of the time."""
    if not b.equations.clocks:
        return []
    of_fibres = b.rate(volume) * fibres.energy + volume * fibres.ageing
    return [Field("fibres_aged", CELLS, of_fibres), *map(b.aged, surface)]


def _softened(b: Builder, volume: ca.SX, fibres: Fibres, surface: list[Field]) -> list[Field]:
    """What a kelvin adds to the energies."""
    if not b.thermal:
        return []
    of_fibres = b.by_temperature(volume) * fibres.energy + volume * fibres.softening
    return [Field("fibres_softened", CELLS, of_fibres), *map(b.softened, surface)]


def angles(b: Builder) -> tuple[Neighbours, Neighbours]:
    """Section angles of all nodes and their rates, which an end that holds the angle gives."""
    viscous, terms = b.equations.law.viscosity is not None, b.equations.terms
    turns, rotary = terms.rotary_inertia or viscous, terms.rotary_inertia and terms.inertia
    psi = b.unknown(
        Slot("psi", "node", b.bends, turns, "omega" if turns else "", section=False),
        0 if b.half else b.supports.left_angle,
        b.supports.right_angle,
    )
    omega = b.unknown(Slot("omega", "node", b.bends, rotary, "", section=False)) if turns else Same()
    return psi, omega


_NO_STRESS = 1e-12
"""Equivalent stress, in Young's moduli, below which a point counts as unstressed: it is divided by."""


def sampled(b: Builder, resolved: ResolvedSection, rule: Sampling, values: Values) -> Fibres:
    """Stress and flow at the points of a section, and their sums."""
    if isinstance(rule, OneFibre):
        # The one fibre that stands for all has the place and the weight of a fibre.
        b.leaves.adopt(rule.zeta, Leaf(FIBRE, "zeta"))
        b.leaves.adopt(rule.weight, Leaf(FIBRE, "weight"))
    fibres = [_Fibre(b, resolved, {**values, symbols.zeta: ca.SX(zeta)}) for zeta, _ in rule.places]
    found = Fibres(profiles=_profiles(rule, resolved))
    followed = [_Followed(clock.name, clock.replaces, clock.state) for clock in b.equations.clocks if clock.state]
    for clock in followed:
        clock.set(b, rule, fibres)
    for j, branch in enumerate(resolved.branches):
        found.plastic |= _add_branch(b, resolved, branch, rule, fibres, j)
    for clock in followed:
        found.plastic |= clock.rates(rule, fibres)
    if b.equations.chains is not None:
        _add_chains(b, b.equations.chains, rule, fibres, found)
    for fibre in fibres if resolved.viscous is not None else ():
        fibre.resist()
    _sum_up(b, rule, fibres, found)
    for label, fibre in zip(point_labels(rule), fibres, strict=True):
        shown = {"yields": fibre.yields, "speed": fibre.speed, "axial": fibre.axial, **shown_chains(fibre.conformation)}
        shown |= {clock.state.name: fibre.values[clock.state.shown] for clock in followed}
        if any(branch.hardening is not None for branch in resolved.branches):
            shown["backstress"] = fibre.backstress
        found.shown |= {f"{POINT}{name}_{label}": value for name, value in shown.items()}
    return found


def _sum_up(b: Builder, rule: Sampling, fibres: Sequence[_Fibre], found: Fibres) -> None:
    """Means over the section."""

    def mean(name: str, *, linear: bool = False) -> ca.SX:
        pairs: list[tuple[_Fibre, Any]] = list(zip(fibres, rule.places, strict=True))
        total = sum((getattr(f, name) * (weight * zeta if linear else weight) for f, (zeta, weight) in pairs), ca.SX(0))
        return b.total(f"{name}_zeta" if linear else name, total) if isinstance(rule, OneFibre) else ca.SX(total)

    found.axial, found.axial_zeta, found.shear = mean("axial"), mean("axial", linear=True), mean("shear")
    found.energy, found.dissipation = mean("energy"), mean("dissipation")
    if b.equations.clocks:
        found.ageing = mean("ageing")
    if b.thermal:
        found.softening = mean("softening")


@dataclass(frozen=True)
class _Followed:
    """A clock with a state at every point of a section."""

    name: str
    replaces: tuple[tuple[Any, Any], ...]
    state: State

    def set(self, b: Builder, rule: Sampling, fibres: Sequence[_Fibre]) -> None:
        """What it makes of the constants at every point, by its state there."""
        for fibre, now in zip(fibres, _recalled(b, rule, _names(rule, self.name)), strict=True):
            stated = {**fibre.values, self.state.symbol: now}
            fibre.values |= {symbol: printed(value, stated) for symbol, value in self.replaces}
            fibre.values[self.state.shown] = printed(self.state.value, stated)

    def rates(self, rule: Sampling, fibres: Sequence[_Fibre]) -> dict[str, ca.SX]:
        """Rates of its states, of the flow at every point."""
        rates = [printed(self.state.rate, {**fibre.values, speed: fibre.speed}) for fibre in fibres]
        return _projected(rule, _names(rule, self.name), rates)


def _add_chains(b: Builder, chains: ChainResponse, rule: Sampling, fibres: Sequence[_Fibre], found: Fibres) -> None:
    """Polymer chains at every point of a section."""
    names = [_names(rule, chain_state(one)) for one in chains.states]
    taken = [_recalled(b, rule, group) for group in names]
    for number, fibre in enumerate(fibres):
        fibre.carry(chains, [points[number] for points in taken])
    for number, (one, group) in enumerate(zip(chains.states, names, strict=True)):
        found.plastic |= _projected(
            rule, group, [fibre.relaxing[number] for fibre in fibres], fibres, [f.released[number] for f in fibres]
        )
        linear = zip(group, *_linear_parts(rule), strict=True)
        found.profiles |= {name: (one.power * float(m), one.power * float(z)) for name, m, z in linear}


def _add_branch(
    b: Builder, resolved: ResolvedSection, branch: FibreBranch, rule: Sampling, fibres: Sequence[_Fibre], number: int
) -> dict[str, ca.SX]:
    """A spring of every point, with its flow and its backstress; rates of their states."""
    backs: dict[str, Any] = {"back": backstress.axial, "back_shear": backstress.shear} if branch.hardening else {}
    if not resolved.shears:
        backs.pop("back_shear", None)
    for kind, symbol in backs.items():
        for fibre, value in zip(fibres, _recalled(b, rule, _names(rule, kind, number)), strict=True):
            fibre.values[symbol] = value
    plastic = [[ca.SX(0)] * rule.points] * 2
    if branch.flow is not None:
        kinds = ("axial", "shear")[: 1 + resolved.shears]
        plastic[: len(kinds)] = [_recalled(b, rule, _names(rule, kind, number)) for kind in kinds]
    for fibre, axial, shear in zip(fibres, *plastic, strict=True):
        fibre.add(branch, (axial, shear))
    found: dict[str, ca.SX] = {}
    for k, kind in enumerate(("axial", "shear")):
        rates, drives = [one.rates[number][k] for one in fibres], [one.drives[number][k] for one in fibres]
        found |= _projected(rule, _names(rule, kind, number), rates, fibres, drives)
    found = {name: rate for name, rate in found.items() if name in b.slots}
    for k, kind in enumerate(backs):
        found |= _projected(rule, _names(rule, kind, number), [fibre.back_rates[k] for fibre in fibres])
    return found


def _names(rule: Sampling, kind: str, branch: int = 0) -> list[str]:
    """Of the states of one kind."""
    return [branch_name(f"{kind}_{label}", branch) for label in rule.labels]


def _recalled(b: Builder, rule: Sampling, names: Sequence[str]) -> list[ca.SX]:
    """What states of these names stand for at every point."""
    states = [b.unknown(Slot(name, "cell", (False, False), True, "", section=True))[0] for name in names]
    return [_dot(row, states) for row in rule.recall]


def _projected(
    rule: Sampling,
    names: Sequence[str],
    rates: Sequence[ca.SX],
    fibres: Sequence[_Fibre] = (),
    conjugates: Sequence[ca.SX] = (),
) -> dict[str, ca.SX]:
    """Rates of states; what these do not follow of the rates at the points costs no energy."""
    projected = [_dot(row, rates) for row in rule.project]
    if isinstance(rule, SectionRule) and not rule.is_of_fibres:
        for fibre, conjugate, row, rate in zip(fibres, conjugates, rule.recall, rates, strict=False):
            fibre.dissipation += conjugate * (_dot(row, projected) - rate)
    return dict(zip(names, projected, strict=True))


def _profiles(rule: Sampling, resolved: ResolvedSection) -> dict[str, tuple[float, float]]:
    """What each axial state is of a plastic strain that is linear through the thickness."""
    mean, linear = _linear_parts(rule)
    names = [_names(rule, "axial", j) for j, branch in enumerate(resolved.branches) if branch.flow is not None]
    return {name: (float(mean[n]), float(linear[n])) for group in names for n, name in enumerate(group)}


def _linear_parts(rule: Sampling) -> tuple[Floats, Floats]:
    """Amplitudes of 1 and of zeta in each state; of one fibre that stands for all, over its zeta."""
    if isinstance(rule, OneFibre):
        return np.ones(1), np.ones(1)
    return rule.project @ np.ones(rule.points), rule.project @ rule.zeta


def _dot(weights: Iterable[float], values: Sequence[ca.SX]) -> ca.SX:
    total = ca.SX(0)
    for weight, value in zip(weights, values, strict=True):
        if weight:
            total += weight * value
    return total


class _Fibre:
    """One point of a section: its stress is the derivative of its stored energy, its flow is driven by it."""

    def __init__(self, b: Builder, resolved: ResolvedSection, values: dict[Any, Any]) -> None:
        self.moduli = [branch.modulus for branch in b.equations.law.branches]
        self.resolved, self.values = resolved, values
        self.strain = (printed(resolved.cell.axial_strain, values), printed(resolved.cell.shear_strain, values))
        self.axial = self.shear = self.energy = self.dissipation = self.speed = self.yields = ca.SX(0)
        self.ageing, self.rate = ca.SX(0), b.rate
        self.softening, self.by_temperature = ca.SX(0), b.by_temperature
        self.rates: list[Pair] = []
        self.drives: list[Pair] = []  # What the rates of the plastic state are conjugate to
        self.back_rates: Pair = (ca.SX(0), ca.SX(0))
        self.backstress = ca.SX(0)  # Along the fibre
        self.relaxing: list[ca.SX] = []  # Rates of the states of chains, and what these are conjugate to
        self.released: list[ca.SX] = []
        self.conformation: list[ca.SX] = []
        self.flows = False

    def add(self, branch: FibreBranch, plastic: Pair) -> None:
        """A spring with its flow rule."""
        spring, elastic = branch.spring, (reissner.eps_e, reissner.gamma_e)
        values = {**self.values, **dict(zip((reissner.eps, reissner.gamma), self.strain, strict=True))}
        values |= {reissner.eps_p: plastic[0], reissner.gamma_p: plastic[1]}
        for symbol, strain in zip(elastic, spring.elastic, strict=True):
            values[symbol] = printed(strain, values)
        for symbol, stress in zip((symbols.sigma, reissner.tau_f), spring.stress, strict=True):
            values[symbol] = printed(stress, values)
        values[reissner.tau_d] = printed(spring.driving, values)
        values[reissner.sigma_c] = conjugate = printed(spring.conjugate, values)
        self.axial, self.shear = self.axial + conjugate, self.shear + values[reissner.tau_f]
        stored = printed(spring.stored, values)
        self.energy += stored
        self.ageing += self.rate(stored)
        self.softening += self.by_temperature(stored)
        self.drives.append((conjugate, values[reissner.tau_d]))
        if branch.flow is None:
            self.rates.append((ca.SX(0), ca.SX(0)))
            return
        modulus = printed(self.moduli[len(self.rates)], values)
        # Compared before the root is taken, whose derivative is infinite where nothing is stressed.
        square = printed(branch.flow.equivalent**2, values)
        values[sigma_eq] = ca.sqrt(ca.fmax(square, (_NO_STRESS * modulus) ** 2))
        flow = CellFunction(
            {
                name: getattr(branch.flow, name)
                for name in ("axial_rate", "shear_rate", "speed", "dissipation", "yields")
            },
            tuple(values),
        )(values)
        self.rates.append((ca.SX(flow["axial_rate"]), ca.SX(flow["shear_rate"])))
        if branch.hardening is not None:
            self.harden(branch.hardening, values)
        self.dissipation += flow["dissipation"]
        self.speed = ca.fmax(self.speed, flow["speed"]) if self.flows else ca.SX(flow["speed"])
        self.yields = ca.fmax(self.yields, flow["yields"]) if self.flows else ca.SX(flow["yields"])
        self.flows = True

    def harden(self, hardening: FibreHardening, values: Values) -> None:
        """The backstress of what flows: it stores energy, and follows the flow."""
        axial, shear = (printed(rate, values) for rate in hardening.rates)
        self.back_rates = axial, shear
        self.backstress = printed(hardening.stress, values)
        self.energy += printed(hardening.stored, values)

    def carry(self, chains: ChainResponse, taken: Sequence[ca.SX]) -> None:
        """Polymer chains: a stress along the fibre, and a stiffness that keeps the section square to the centreline."""
        values = {**self.values, **dict(zip((one.taken for one in chains.states), taken, strict=True))}
        values |= {conformation.strain: self.strain[0] - printed(self.resolved.relaxed, values)}
        values |= {reissner.gamma: self.strain[1]}
        square = conformation.modulus() * reissner.gamma**2 / 2
        by = (conformation.strain, reissner.gamma)
        sigma, tau = derivatives(chains.stored + square, by, values)
        self.axial, self.shear = self.axial + sigma, self.shear + tau
        self.energy += printed(chains.stored + square, values)
        self.conformation = [printed(extension, values) for extension in chains.extensions]
        if not chains.relaxes:
            return
        self.relaxing = [printed(chains.of_states(rate), values) for rate in chains.rates]
        self.released = [-one for one in derivatives(chains.stored, [d.taken for d in chains.states], values)]
        self.dissipation += printed(chains.of_states(chains.dissipation), values)
        self.speed, self.yields = ca.fabs(self.relaxing[0]) / 2, ca.SX(1)

    def resist(self) -> None:
        """The viscous stress beside the springs: the derivative of its Rayleigh potential."""
        viscous = self.resolved.viscous
        if viscous is None:
            raise ValueError("this law has no viscous stress")
        rates = {
            symbol: printed(rate, self.values)
            for symbol, rate in zip((reissner.eps_t, reissner.gamma_t), viscous.strain_rates, strict=True)
        }
        values = {**self.values, **rates, reissner.gamma: self.strain[1]}
        sigma, tau = derivatives(viscous.rayleigh, tuple(rates), values)
        self.axial, self.shear = self.axial + sigma, self.shear + tau
        self.ageing -= sigma * printed(viscous.natural_rate, values)
        self.dissipation += 2 * printed(viscous.rayleigh, values)
        if not self.moduli and not self.relaxing:
            self.speed, self.yields = ca.fabs(rates[reissner.eps_t]), ca.SX(1)
