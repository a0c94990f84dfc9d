"""The points of a section, in the plane and in space: their stresses and flows, and their sums over a cell."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.casadi_printer import CellFunction, printed
from softcat_sym.discretization.cell import (
    Builder,
    Values,
    branch_name,
    chain_state,
    derivatives,
    shown_chains,
)
from softcat_sym.discretization.section_rule import POINT, SectionRule
from softcat_sym.discretization.stencil import FIBRE, Leaf
from softcat_sym.discretization.unknowns import Slot
from softcat_sym.physics import hardening_rule, polymer_chains, reissner, spatial, symbols
from softcat_sym.physics.bulk import sigma_eq
from softcat_sym.physics.clocks import Clock, State, speed
from softcat_sym.physics.polymer_chains import ChainResponse
from softcat_sym.physics.reissner import FibreBranch, SampledSection

_NO_STRESS = 1e-12
"""Equivalent stress, in Young's moduli, below which a point counts as unstressed: it is divided by."""


@dataclass(frozen=True)
class SectionSums:
    """Sums over the points of a section, and what a run shows of them."""

    means: dict[Any, ca.SX]  # By their symbols
    energy: ca.SX
    dissipation: ca.SX
    ageing: ca.SX  # Rate of the energy at a strain that is held, and work of shrinking
    softening: ca.SX  # What a kelvin adds to the energy at a strain that is held [1/K]
    plastic: dict[str, ca.SX]  # Rates of the plastic states [1/s]
    profiles: dict[str, tuple[float, float]]  # What each state is of a plastic strain that is linear in zeta
    shown: dict[str, ca.SX]


def one_of(rule: SectionRule) -> SectionRule:
    """A point that stands for all of a rule, for code that loops over points."""
    return SectionRule.of_points({name: (ca.SX.sym(name),) for name in rule.tables}, stands_for_all=True)


def sampled(b: Builder, section: SampledSection, rule: SectionRule, values: Values) -> SectionSums:
    """Stress and flow at the points of a section, and their sums."""
    if rule.stands_for_all:
        for name, (symbol,) in rule.tables.items():
            b.leaves.adopt(symbol, Leaf(FIBRE, name))
    places = [{_PLACES[name]: ca.SX(one) for name, one in place.items() if name != "weight"} for place in rule.places]
    points = [_Point(b, section, {**values, **place}) for place in places]
    plastic: dict[str, ca.SX] = {}
    profiles: dict[str, tuple[float, float]] = {}
    followed = [(clock, clock.state) for clock in b.equations.clocks if clock.state is not None]
    clocks = [(state, _follow_clock(b, rule, points, clock, state)) for clock, state in followed]
    for number, branch in enumerate(section.branches):
        plastic |= _add_branch(b, section, branch, rule, points, number)
        if branch.flow is not None:
            profiles |= _profiles(rule, _names(rule, "axial", number))
    for state, names in clocks:
        rates = [printed(state.rate, {**point.values, speed: point.speed}) for point in points]
        plastic |= _projected(rule, names, rates)
    if b.equations.chains is not None:
        plastic |= _add_chains(b, section, b.equations.chains, rule, points)
        for one in b.equations.chains.states:
            profiles |= _profiles(rule, [f"{chain_state(one)}_{label}" for label in rule.labels], one.power)
    for point in points:
        point.resist()
    return _summed(b, section, rule, points, plastic, profiles, [state for state, _ in clocks])


_PLACES = {symbol.name: symbol for symbol in (symbols.zeta, *spatial.POINT)}
"""Symbols of the place of a point, by the names that rules have for them."""


def _summed(
    b: Builder,
    section: SampledSection,
    rule: SectionRule,
    points: Sequence[_Point],
    plastic: dict[str, ca.SX],
    profiles: dict[str, tuple[float, float]],
    states: Sequence[State],
) -> SectionSums:
    weights = [place["weight"] for place in rule.places]

    def mean(name: str, values: Iterable[ca.SX], levers: Iterable[Any] | None = None) -> ca.SX:
        total = sum((value * weight for weight, value in zip(levers or weights, values, strict=True)), ca.SX(0))
        return b.total(name, total) if rule.stands_for_all else ca.SX(total)

    conjugate = (reissner.sigma_c, *(kind.stress for kind in section.kinds))
    stressed = [{**point.values, **dict(zip(conjugate, point.stress, strict=True))} for point in points]
    shown: dict[str, ca.SX] = {}
    for label, point in zip(rule.point_labels, points, strict=True):
        found = {"yields": point.yields, "speed": point.speed, **shown_chains(point.conformation)}
        found |= {} if rule.is_spatial else {"axial": point.stress[0]}
        found |= {state.name: point.values[state.shown] for state in states}
        if any(branch.hardening is not None for branch in section.branches):
            found["backstress"] = point.backstress
        shown |= {f"{POINT}{name}_{label}": value for name, value in found.items()}
    return SectionSums(
        means={
            symbol: mean(
                name,
                [printed(of_point, given) for given in stressed],
                [weight * printed(lever, given) for weight, given in zip(weights, stressed, strict=True)],
            )
            for name, (symbol, of_point, lever) in section.means.items()
        },
        energy=mean("energy", [point.energy for point in points]),
        dissipation=mean("dissipation", [point.dissipation for point in points]),
        ageing=mean("ageing", [point.ageing for point in points]) if b.equations.clocks else ca.SX(0),
        softening=mean("softening", [point.softening for point in points]) if b.thermal else ca.SX(0),
        plastic=plastic,
        profiles=profiles,
        shown=shown,
    )


def _names(rule: SectionRule, kind: str, branch: int) -> list[str]:
    """The states of one kind, of a branch."""
    return [branch_name(f"{kind}_{label}", branch) for label in rule.labels]


def _recalled(b: Builder, rule: SectionRule, names: Sequence[str]) -> list[ca.SX]:
    """What states of these names make at every point."""
    states = [b.unknown(Slot(name, "cell", (False, False), True, "", section=True))[0] for name in names]
    return [_dot(row, states) for row in rule.recall]


def _projected(rule: SectionRule, names: Sequence[str], rates: Sequence[ca.SX]) -> dict[str, ca.SX]:
    """Rates of states of these names, of the rates at every point."""
    return dict(zip(names, (_dot(row, rates) for row in rule.project), strict=True))


def _dot(weights: Iterable[float], values: Sequence[ca.SX]) -> ca.SX:
    return sum((weight * value for weight, value in zip(weights, values, strict=True) if weight), ca.SX(0))


def _profiles(rule: SectionRule, names: Sequence[str], power: float = 1.0) -> dict[str, tuple[float, float]]:
    """What states of these names are of a strain that is linear through the thickness; of one fibre over its zeta."""
    mean, linear = rule.project @ np.ones(rule.points), rule.project @ rule.across
    return {name: (power * float(m), power * float(z)) for name, m, z in zip(names, mean, linear, strict=True)}


def _follow_clock(b: Builder, rule: SectionRule, points: Sequence[_Point], clock: Clock, state: State) -> list[str]:
    """What a clock makes of the constants at every point, by its state there; the names of its states."""
    names = [f"{clock.name}_{label}" for label in rule.labels]
    for point, here in zip(points, _recalled(b, rule, names), strict=True):
        stated = {**point.values, state.symbol: here}
        point.values |= {symbol: printed(value, stated) for symbol, value in clock.replaces}
        point.values[state.shown] = printed(state.value, stated)
    return names


def _add_chains(
    b: Builder, section: SampledSection, chains: ChainResponse, rule: SectionRule, points: Sequence[_Point]
) -> dict[str, ca.SX]:
    """Polymer chains at every point of a section; rates of their states."""
    names = [[f"{chain_state(one)}_{label}" for label in rule.labels] for one in chains.states]
    taken = [_recalled(b, rule, row) for row in names]
    for number, point in enumerate(points):
        point.carry(section, chains, [row[number] for row in taken])
    found: dict[str, ca.SX] = {}
    for number, row in enumerate(names if chains.relaxes else ()):
        rates = [point.relaxing[number] for point in points]
        found |= _follow(rule, points, row, rates, [point.released[number] for point in points])
    return found


def _add_branch(
    b: Builder, section: SampledSection, branch: FibreBranch, rule: SectionRule, points: Sequence[_Point], number: int
) -> dict[str, ca.SX]:
    """A spring of every point, with its flow and its backstress; rates of their states."""
    across = ("shear2", "shear3") if rule.is_spatial else ("shear",)[: len(section.kinds)]
    names = [_names(rule, kind, number) for kind in ("axial", *across)]
    back = [_names(rule, kind, number) for kind in ("back", "back_shear")[: len(names) if branch.hardening else 0]]
    for row, symbol in zip(back, (hardening_rule.axial, hardening_rule.shear), strict=False):
        for point, state in zip(points, _recalled(b, rule, row), strict=True):
            point.values[symbol] = state
    nothing = [ca.SX(0)] * rule.points
    plastic = [nothing if branch.flow is None else _recalled(b, rule, row) for row in names]
    for point, *states in zip(points, *plastic, strict=True):
        point.add(branch, states)
    found: dict[str, ca.SX] = {}
    for k, row in enumerate(names if branch.flow is not None else ()):
        found |= _follow(
            rule, points, row, *([getattr(p, of)[number][k] for p in points] for of in ("rates", "drives"))
        )
    for k, row in enumerate(back):
        found |= _projected(rule, row, [point.back_rates[k] for point in points])
    return found


def _follow(
    rule: SectionRule, points: Sequence[_Point], names: Sequence[str], rates: Sequence[ca.SX], drives: Sequence[ca.SX]
) -> dict[str, ca.SX]:
    """Rates of states; what these do not follow of the rates at the points costs no energy."""
    found = _projected(rule, names, rates)
    if not rule.is_of_fibres:
        for point, row, rate, drive in zip(points, rule.recall, rates, drives, strict=True):
            point.dissipation += drive * (_dot(row, list(found.values())) - rate)
    return found


class _Point:
    """One point of a section: its stress is the derivative of its stored energy, its flow is driven by it."""

    def __init__(self, b: Builder, section: SampledSection, values: dict[Any, Any]) -> None:
        self.section, self.values = section, values
        self.strain = [printed(one, values) for one in section.point_strains]
        self.stress = [ca.SX(0)] * len(self.strain)  # Conjugate to the strains
        self.energy = self.dissipation = self.ageing = self.softening = ca.SX(0)
        self.speed = self.yields = self.backstress = ca.SX(0)
        self.rate, self.by_temperature = b.rate, b.by_temperature
        self.rates: list[list[ca.SX]] = []  # Of each branch
        self.drives: list[list[ca.SX]] = []  # What the rates of the plastic state are conjugate to
        self.back_rates: list[ca.SX] = []
        self.relaxing: list[ca.SX] = []  # Rates of the states of chains, and what these are conjugate to
        self.released: list[ca.SX] = []
        self.conformation: list[ca.SX] = []
        self.flows = False

    def add(self, branch: FibreBranch, plastic: Sequence[ca.SX]) -> None:
        """A spring with its flow rule."""
        spring, kinds, values = branch.spring, self.section.kinds, dict(self.values)
        for names, expressions in (
            ((reissner.eps, *(kind.total for kind in kinds)), self.strain),
            ((reissner.eps_p, *(kind.plastic for kind in kinds)), plastic),
        ):
            values |= dict(zip(names, expressions, strict=True))
        for names, formulas in (
            ((reissner.eps_e, *(kind.elastic for kind in kinds)), spring.elastic),
            ((symbols.sigma, *(kind.stress for kind in kinds)), spring.stress),
            (tuple(kind.drive for kind in kinds), spring.driving),
            ((reissner.sigma_c,), (spring.conjugate,)),
        ):
            for symbol, formula in zip(names, formulas, strict=True):
                values[symbol] = printed(formula, values)
        self._press([values[reissner.sigma_c], *(values[kind.stress] for kind in kinds)])
        stored = printed(spring.stored, values)
        self.energy += stored
        self.ageing += self.rate(stored)
        self.softening += self.by_temperature(stored)
        self.drives.append([values[reissner.sigma_c], *(values[kind.drive] for kind in kinds)])
        if branch.flow is None:
            self.rates.append([ca.SX(0)] * len(self.stress))
            return
        # Compared before the root is taken, whose derivative is infinite where nothing is stressed.
        floor = (_NO_STRESS * printed(branch.modulus, values)) ** 2
        values[sigma_eq] = ca.sqrt(ca.fmax(printed(branch.flow.equivalent**2, values), floor))
        named = {name: getattr(branch.flow, name) for name in ("axial_rate", "speed", "dissipation", "yields")}
        named |= {f"shear_rate_{k}": rate for k, rate in enumerate(branch.flow.shear_rate)}
        flow = CellFunction(named, tuple(values))(values)
        sheared = [ca.SX(flow[f"shear_rate_{k}"]) for k in range(len(kinds))]
        self.rates.append([ca.SX(flow["axial_rate"]), *sheared])
        if branch.hardening is not None:
            # The backstress stores energy, and follows the flow.
            self.back_rates = [printed(rate, values) for rate in branch.hardening.rates]
            self.backstress = printed(branch.hardening.stress, values)
            self.energy += printed(branch.hardening.stored, values)
        self.dissipation += flow["dissipation"]
        self.speed = ca.fmax(self.speed, flow["speed"]) if self.flows else ca.SX(flow["speed"])
        self.yields = ca.fmax(self.yields, flow["yields"]) if self.flows else ca.SX(flow["yields"])
        self.flows = True

    def _press(self, stress: Sequence[ca.SX]) -> None:
        self.stress = [one + two for one, two in zip(self.stress, stress, strict=True)]

    def carry(self, section: SampledSection, chains: ChainResponse, taken: Sequence[ca.SX]) -> None:
        """Polymer chains: a stress along the fibre."""
        values = {**self.values, **dict(zip((one.taken for one in chains.states), taken, strict=True))}
        values |= {polymer_chains.strain: self.strain[0] - printed(section.relaxed, values)}
        self._press(derivatives(chains.stored, (polymer_chains.strain,), values))
        self.energy += printed(chains.stored, values)
        self.conformation = [printed(extension, values) for extension in chains.extensions]
        if not chains.relaxes:
            return
        self.relaxing = [printed(chains.of_states(rate), values) for rate in chains.rates]
        self.released = [-one for one in derivatives(chains.stored, [d.taken for d in chains.states], values)]
        self.dissipation += printed(chains.of_states(chains.dissipation), values)
        self.speed, self.yields = ca.fabs(self.relaxing[0]) / 2, ca.SX(1)

    def resist(self) -> None:
        """The viscous stress beside the springs: the derivative of its Rayleigh potential."""
        viscous, kinds = self.section.viscous, self.section.kinds
        if viscous is None:
            return
        by = (reissner.eps_t, *(kind.rate for kind in kinds))
        rates = [printed(rate, self.values) for rate in viscous.strain_rates]
        values = {**self.values, **dict(zip(by, rates, strict=True))}
        values |= dict(zip((kind.total for kind in kinds), self.strain[1:], strict=True))
        stress = derivatives(viscous.rayleigh, by, values)
        self._press(stress)
        self.ageing -= stress[0] * printed(viscous.natural_rate, values)
        self.dissipation += 2 * printed(viscous.rayleigh, values)
        if not self.section.branches and not self.relaxing:
            self.speed, self.yields = ca.fabs(rates[0]), ca.SX(1)
