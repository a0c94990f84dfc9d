"""A filament of a few cells with its grid as symbols, recorded as instructions and taken apart into fields."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

import casadi as ca
import numpy as np

from softcat_sym.discretization.assembly import (
    Body,
    Instant,
    inputs_for,
    layouts_of,
)
from softcat_sym.discretization.graph import POINT_MASS, TIME_SCALE, Discretisation, Setting, Unknowns
from softcat_sym.discretization.grid import Block, End, Grid, Lengths
from softcat_sym.discretization.section_rule import PER_FIBRE
from softcat_sym.discretization.supports import Profile, held
from softcat_sym.errors import PrintingError
from softcat_sym.physics import symbols
from softcat_sym.physics.filament import FilamentEquations

_NAMES = {getattr(ca, name): name for name in dir(ca) if name.startswith("OP_")}


@dataclass(frozen=True)
class Instruction:
    """One elementary operation."""

    operation: str  # CasADi's name without ``OP_``; ``INPUT`` and ``CONST`` for what is given
    arguments: tuple[int, ...]  # Numbers of earlier instructions; of an input its number
    value: float = 0.0  # Of a constant


@dataclass(frozen=True)
class Code:
    """Instructions, and which of them are the results."""

    instructions: tuple[Instruction, ...]  # In the order of evaluation
    results: tuple[int, ...]  # Number of the instruction that gives each output; -1 for a zero


def code_of(inputs: list[ca.SX], outputs: list[ca.SX]) -> Code:
    """Instructions that compute scalars from scalars, equal ones shared."""
    shared = ca.cse([ca.densify(ca.SX(output)) for output in outputs])
    try:
        function = ca.Function("code", [ca.vertcat(*inputs)], [ca.vertcat(*shared)])
    except RuntimeError as error:
        raise PrintingError(f"an expression of the generated code has a symbol that is no input: {error}") from error
    found: list[Instruction] = []
    at: dict[int, int] = {}
    known: dict[Instruction, int] = {}
    results = [-1] * len(outputs)

    def add(instruction: Instruction) -> int:
        if instruction not in known:
            known[instruction] = len(found)
            found.append(instruction)
        return known[instruction]

    for k in range(function.n_instructions()):
        name = _NAMES[function.instruction_id(k)].removeprefix("OP_")
        read, written = function.instruction_input(k), function.instruction_output(k)
        if name == "OUTPUT":
            results[written[1]] = at[read[0]]
        elif name == "INPUT":
            at[written[0]] = add(Instruction("INPUT", (read[1],)))
        elif name == "CONST":
            at[written[0]] = add(Instruction("CONST", (), float(function.instruction_constant(k))))
        else:
            at[written[0]] = add(Instruction(name, tuple(at[place] for place in read)))
    return Code(tuple(found), tuple(results))


UNKNOWN, STAGED, PLACE, DERIVATIVE, PARAMETER, TIME = "unknown", "staged", "place", "derivative", "parameter", "time"
FIBRE, SUM = "fibre", "sum"
"""Where a fibre is and what it counts for; a sum over the fibres of a cell."""


@dataclass(frozen=True, order=True)
class Leaf:
    """One input of an expression."""

    kind: str  # One of the eight kinds above
    name: str  # Which unknown, field, length, entry or parameter
    site: int = 0  # Where: a site, or the distance from the site that is being looked at; zero for what has no place

    @property
    def is_local(self) -> bool:
        """Whether it belongs to a site."""
        return self.kind not in (PARAMETER, TIME, FIBRE)

    @property
    def is_each(self) -> bool:
        """Whether it differs from fibre to fibre."""
        return self.kind == FIBRE or PER_FIBRE in self.name

    def seen_from(self, site: int) -> Leaf:
        """The same with the distance in place of the site."""
        return Leaf(self.kind, self.name, self.site - site) if self.is_local else self


class Leaves:
    """The CasADi symbols of leaves, each made once."""

    def __init__(self) -> None:
        self._symbols: dict[Leaf, ca.SX] = {}
        self._leaves: dict[str, Leaf] = {}
        self.totals: set[str] = set()
        self._summed: dict[str, ca.SX] = {}

    def symbol(self, leaf: Leaf) -> ca.SX:
        """The symbol of a leaf."""
        if leaf not in self._symbols:
            name = f"{leaf.kind}:{leaf.name}@{leaf.site}"
            self._symbols[leaf], self._leaves[name] = ca.SX.sym(name), leaf
        return self._symbols[leaf]

    def sum_of(self, value: ca.SX) -> ca.SX:
        """A symbol for the sum over the fibres of what is given for one that stands for all."""
        if value.is_zero():
            return ca.SX(0)
        leaf = Leaf(SUM, str(len(self._summed)))
        self._summed[leaf.name] = value
        return self.symbol(leaf)

    def summed(self, leaf: Leaf) -> ca.SX:
        """What a sum is of."""
        return self._summed[leaf.name]

    def column(self, kind: str, name: str, sites: range) -> ca.SX:
        """The symbols of a field, one below the other."""
        return ca.vertcat(*(self.symbol(Leaf(kind, name, site)) for site in sites))

    def within(self, expression: ca.SX) -> list[Leaf]:
        """The leaves of an expression, sorted."""
        return sorted(self._leaves[symbol.name()] for symbol in ca.symvar(expression))

    def adopt(self, symbol: ca.SX, leaf: Leaf) -> None:
        """Let a symbol that was made elsewhere stand for a leaf."""
        self._symbols[leaf], self._leaves[symbol.name()] = symbol, leaf

    def moved(self, expression: ca.SX, site: int) -> ca.SX:
        """The expression as seen from a site."""
        leaves = [leaf for leaf in self.within(expression) if leaf.is_local]
        if not leaves or site == 0:
            return expression
        old = ca.vertcat(*(self.symbol(leaf) for leaf in leaves))
        new = ca.vertcat(*(self.symbol(leaf.seen_from(site)) for leaf in leaves))
        return ca.substitute(expression, old, new)


PER = "per_"
INVERTED = "cell", "node", "mass"
"""Lengths and mass of a site whose inverses a run is given too, under names that begin with `PER`."""


def with_reciprocals(code: Code, leaves: Sequence[Leaf]) -> tuple[Code, list[Leaf]]:
    """The same results with fewer divisions, and what they are made of."""
    divisors = Counter(one.arguments[-1] for one in code.instructions if one.operation in ("DIV", "INV"))
    inputs, found = list(leaves), list[Instruction]()
    known: dict[Instruction, int] = {}
    number: dict[int, int] = {}
    alike: dict[int, bool] = {}

    def add(instruction: Instruction, *, uniform: bool) -> int:
        if instruction not in known:
            known[instruction] = len(found)
            alike[len(found)] = uniform
            found.append(instruction)
        return known[instruction]

    def inverse(divisor: int) -> int:
        one = found[divisor]
        if one.operation == "CONST":
            return add(Instruction("CONST", (), 1 / one.value), uniform=True)
        if _is_inverted(one, inputs):
            leaf = inputs[one.arguments[0]]
            other = Leaf(PLACE, PER + leaf.name, leaf.site)
            if other not in inputs:
                inputs.append(other)
            return add(Instruction("INPUT", (inputs.index(other),)), uniform=False)
        return add(Instruction("INV", (divisor,)), uniform=alike[divisor])

    for k, one in enumerate(code.instructions):
        if one.operation == "INPUT":
            number[k] = add(one, uniform=not inputs[one.arguments[0]].is_local)
            continue
        arguments = tuple(number[argument] for argument in one.arguments)
        uniform = all(alike[argument] for argument in arguments)
        if one.operation in ("DIV", "INV") and _pays(found, inputs, alike, arguments, divisors[one.arguments[-1]]):
            over = inverse(arguments[-1])
            number[k] = (
                over if one.operation == "INV" else add(Instruction("MUL", (arguments[0], over)), uniform=uniform)
            )
        else:
            number[k] = add(Instruction(one.operation, arguments, one.value), uniform=uniform)
    return Code(tuple(found), tuple(number[r] if r >= 0 else -1 for r in code.results)), inputs


def _pays(
    found: Sequence[Instruction],
    inputs: Sequence[Leaf],
    alike: dict[int, bool],
    arguments: Sequence[int],
    times: int,
) -> bool:
    """Whether the divisor is better inverted."""
    divisor = found[arguments[-1]]
    if divisor.operation == "CONST":
        return math.isfinite(divisor.value) and divisor.value != 0
    if _is_inverted(divisor, inputs):
        return True
    if alike[arguments[-1]]:
        return not all(alike[argument] for argument in arguments)
    return times > 1


def _is_inverted(one: Instruction, inputs: Sequence[Leaf]) -> bool:
    if one.operation != "INPUT":
        return False
    leaf = inputs[one.arguments[0]]
    return leaf.kind == PLACE and leaf.name in INVERTED


CELLS = 12
"""Of the filament that is taken apart: enough for sites in the middle that see neither end."""

POWERS = "plastic", "load", "gradient"
"""What is integrated beside the unknowns."""

_RATES = {"x": "u", "y": "v", "psi": "omega"}


@dataclass(frozen=True)
class Item:
    """A field: one expression at each of its sites."""

    name: str  # What it is
    sites: range  # Where it is
    values: tuple[ca.SX, ...]  # At these sites


@dataclass(frozen=True)
class Slot:
    """One unknown of every site."""

    name: str  # ``x``, ``y``, ``u``, ``v``, ``psi``, ``a_0``,
    differential: bool  # Whether it has a rate, or balances something
    rate: str  # Name of the unknown that is its rate, or an empty text
    section: bool  # Whether it belongs to the section of one cell
    sites: range  # Where it is unknown


@dataclass(frozen=True)
class Recording:
    """A filament taken apart."""

    leaves: Leaves  # Symbols of all that is given
    slots: tuple[Slot, ...]  # Unknowns of a site, those of sections last
    staged: tuple[Item, ...]  # Fields that other sites read, each made of earlier ones
    rates: tuple[Item, ...]  # What becomes of each slot: its rate, or what it balances
    # Plastic power, power of the load and of the necking gradient, each a sum over the sites of its items.
    powers: tuple[tuple[Item, ...], ...]
    parameters: tuple[str, ...]  # Numbers that a run is given, as a whole and for each site
    places: tuple[str, ...]


@dataclass
class _Recorder:
    """Stands for the unknowns, and puts symbols in the place of staged fields."""

    leaves: Leaves
    blocks: dict[str, Block]
    staged: list[Item] = field(default_factory=list)
    _fields: dict[tuple[str, str], ca.SX] = field(default_factory=dict)

    def field(self, name: str, full: ca.SX) -> ca.SX:
        """The unknown, with whatever is held where it is no unknown."""
        if name not in self.blocks:
            return full
        key = (name, str(full))
        if key not in self._fields:
            places, value = self.blocks[name].places, ca.SX(full)
            for place in places:
                value[place] = self.leaves.symbol(Leaf(UNKNOWN, name, place))
            number = sum(known == name for known, _ in self._fields)
            label = name if number == 0 else f"{name}_held{number + 1}"
            self._fields[key] = value if len(places) == value.numel() else self.stage(label, value)
        return self._fields[key]

    def total(self, name: str, value: ca.SX) -> ca.SX:
        """The sum of the field over the fibres, as symbols."""
        self.leaves.totals.add(name)
        return self.stage(name, value)

    def stage(self, name: str, value: ca.SX) -> ca.SX:
        """The field, as symbols."""
        dense = ca.densify(value)
        sites = _sites(dense.numel())
        self.staged.append(Item(name, sites, tuple(dense[k] for k in range(dense.numel()))))
        return self.leaves.column(STAGED, name, sites)


def _sites(count: int) -> range:
    """Where a field of so many values is: on cells, on nodes or on inner nodes."""
    return {CELLS: range(CELLS), CELLS + 1: range(CELLS + 1), CELLS - 1: range(1, CELLS)}[count]


def record(equations: FilamentEquations, theory: Discretisation, ends: tuple[End, End], body: Body) -> Recording:
    """Take the filament apart."""
    leaves, half = Leaves(), ends[0] is End.SYMMETRY
    grid = Grid(np.linspace(0.0 if half else -0.5, 0.5, CELLS + 1), *ends)
    if theory.fibres is not None:
        one, theory = theory.fibres.one, theory.fibres.theory
        for symbol, name in ((one.zeta, "zeta"), (one.weight, "weight")):
            leaves.adopt(symbol, Leaf(FIBRE, name))
    given = inputs_for(equations, theory, body)
    for name, symbol in given.named.items():
        leaves.adopt(symbol, Leaf(PARAMETER, name))
    time = leaves.symbol(Leaf(TIME, "t"))
    unknowns = theory.unknowns(equations, grid)
    layouts = layouts_of(equations, unknowns)
    blocks = {block.name: block for layout in (layouts.moving, layouts.still) for block in layout.blocks}
    recorder = _Recorder(leaves, blocks)
    scale, values = given.named[TIME_SCALE], given.symbols
    supports = held(body.supports, given.named, values[symbols.L_0], time * scale)
    nodes, cells = range(CELLS + 1), range(CELLS)
    profile = body.profile
    if profile.nodes is not None:
        profile = Profile(leaves.column(PLACE, "h_node", nodes), leaves.column(PLACE, "h_cell", cells))
    lengths = Lengths(*(leaves.column(PLACE, n, s) for n, s in (("X", nodes), ("cell", cells), ("node", nodes))))
    mass = leaves.column(PLACE, "mass", nodes)
    if body.weighted:
        mass += leaves.column(PLACE, "hung", nodes) * (
            given.named[POINT_MASS] / (values[symbols.rho] * values[symbols.L_0])
        )
    setting = Setting(values, grid, profile, supports, scale, lengths, recorder.stage, recorder.total)
    now = Instant(equations, theory, setting, given, recorder, time, mass)
    rates = now.rates()
    balances = now.balances(rates)
    moving = {block.name for block in layouts.moving.blocks}
    slots = _slots(unknowns, blocks, moving, in_sections=equations.resolved is not None)
    made = tuple(
        Item(f"f_{one.name}", one.sites, _made(one, leaves, rates if one.differential else balances)) for one in slots
    )
    powers = tuple(_split(name, power) for name, power in zip(POWERS, now.powers(), strict=True))
    return Recording(leaves, slots, tuple(recorder.staged), made, powers, tuple(given.named), place_names(body))


def place_names(body: Body) -> tuple[str, ...]:
    """The geometry of a site that this body needs."""
    profile = ("h_node", "h_cell") if body.profile.nodes is not None else ()
    return ("X", *INVERTED, *(PER + name for name in INVERTED), *profile, *(("hung",) if body.weighted else ()))


def _slots(unknowns: Unknowns, blocks: dict[str, Block], moving: set[str], *, in_sections: bool) -> tuple[Slot, ...]:
    plastic = {block.name for block in unknowns.plastic}
    names = [name for name in blocks if name not in plastic] + [name for name in blocks if name in plastic]
    found = []
    for name in names:
        places = blocks[name].places
        sites = range(places[0], places[-1] + 1)
        rate = _RATES.get(name, "")
        rate = rate if name in moving and rate in blocks else ""
        found.append(Slot(name, name in moving, rate, in_sections and name in plastic, sites))
    return tuple(found)


def _made(slot: Slot, leaves: Leaves, values: dict[str, ca.SX]) -> tuple[ca.SX, ...]:
    if slot.rate:
        return tuple(leaves.symbol(Leaf(UNKNOWN, slot.rate, site)) for site in slot.sites)
    return tuple(ca.SX(values[slot.name][site]) for site in slot.sites)


def _split(name: str, power: ca.SX) -> tuple[Item, ...]:
    """The power of cells and of nodes apart."""
    if power.is_zero():
        return ()
    dense, count = ca.densify(power), power.numel()
    parts = [dense] if count <= CELLS + 1 else [dense[:CELLS], dense[CELLS:]]
    return tuple(
        Item(f"power_{name}_{k}", _sites(part.numel()), tuple(part[j] for j in range(part.numel())))
        for k, part in enumerate(parts)
    )
