"""A filament of a few cells with its grid as symbols, taken apart into fields that one site after another computes."""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca
import numpy as np

from softcat_sym.codegen.leaves import FIBRE, PARAMETER, PLACE, STAGED, TIME, UNKNOWN, Leaf, Leaves
from softcat_sym.codegen.reciprocals import INVERTED, PER
from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.assembly import inputs_for, layouts_of
from softcat_sym.graph.body import Body
from softcat_sym.graph.discretisation import Discretisation, Setting, Unknowns
from softcat_sym.graph.grid import End, Grid
from softcat_sym.graph.instant import When, balances_of, instant, powers_of, rates_of
from softcat_sym.graph.layout import Block
from softcat_sym.graph.lengths import Lengths
from softcat_sym.graph.parameters import POINT_MASS, TIME_SCALE
from softcat_sym.graph.profile import Profile
from softcat_sym.graph.supports import held

CELLS = 12
"""Of the filament that is taken apart: enough for sites in the middle that see neither end."""

POWERS = "plastic", "load", "gradient"
"""What is integrated beside the unknowns."""

_RATES = {"x": "u", "y": "v", "psi": "omega"}


@dataclass(frozen=True)
class Item:
    """A field: one expression at each of its sites.

    Attributes
    ----------
    name : str
        What it is.
    sites : range
        Where it is.
    values : tuple of casadi.SX
        At these sites.
    """

    name: str
    sites: range
    values: tuple[ca.SX, ...]


@dataclass(frozen=True)
class Slot:
    """One unknown of every site.

    Attributes
    ----------
    name : str
        ``x``, ``y``, ``u``, ``v``, ``psi``, ``a_0``, ...
    differential : bool
        Whether it has a rate, or balances something.
    rate : str
        Name of the unknown that is its rate, or an empty text.
    section : bool
        Whether it belongs to the section of one cell.
    sites : range
        Where it is unknown.
    """

    name: str
    differential: bool
    rate: str
    section: bool
    sites: range


@dataclass(frozen=True)
class Recording:
    """A filament taken apart.

    Attributes
    ----------
    leaves : Leaves
        Symbols of all that is given.
    slots : tuple of Slot
        Unknowns of a site, those of sections last.
    staged : tuple of Item
        Fields that other sites read, each made of earlier ones.
    rates : tuple of Item
        What becomes of each slot: its rate, or what it balances.
    powers : tuple of tuple of Item
        Plastic power, power of the load and of the necking gradient, each a sum over the sites of its items.
    parameters, places : tuple of str
        Numbers that a run is given, as a whole and for each site.
    """

    leaves: Leaves
    slots: tuple[Slot, ...]
    staged: tuple[Item, ...]
    rates: tuple[Item, ...]
    powers: tuple[tuple[Item, ...], ...]
    parameters: tuple[str, ...]
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
    """Take the filament apart.

    Parameters
    ----------
    equations : FilamentEquations
        One cell.
    theory : Discretisation
        Which unknowns the grid carries; where it has fibres, one stands for all.
    ends : pair of End
        What holds the first and the last node.
    body : Body
        Supports, whether there is a profile, and a point mass.
    """
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
    supports = held(body.supports, given.named, values[sy.L_0], time * scale)
    nodes, cells = range(CELLS + 1), range(CELLS)
    profile = body.profile
    if profile.nodes is not None:
        profile = Profile(leaves.column(PLACE, "h_node", nodes), leaves.column(PLACE, "h_cell", cells))
    lengths = Lengths(*(leaves.column(PLACE, n, s) for n, s in (("X", nodes), ("cell", cells), ("node", nodes))))
    mass = leaves.column(PLACE, "mass", nodes)
    if body.weighted:
        mass += leaves.column(PLACE, "hung", nodes) * (given.named[POINT_MASS] / (values[sy.rho] * values[sy.L_0]))
    setting = Setting(values, grid, profile, supports, scale, lengths, recorder.stage, recorder.total)
    now = instant(equations, theory, setting, given, recorder, When(time, mass))
    rates = rates_of(now)
    balances = balances_of(now, rates)
    moving = {block.name for block in layouts.moving.blocks}
    slots = _slots(unknowns, blocks, moving, in_sections=equations.resolved is not None)
    made = tuple(
        Item(f"f_{one.name}", one.sites, _made(one, leaves, rates if one.differential else balances)) for one in slots
    )
    powers = tuple(_split(name, power) for name, power in zip(POWERS, powers_of(now), strict=True))
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
