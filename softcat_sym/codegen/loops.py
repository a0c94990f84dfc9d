"""Fields become loops over sites, with exact derivatives: what all compute alike, and what the ends do otherwise."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import casadi as ca
import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.recording import (
    CELLS,
    DERIVATIVE,
    INVERTED,
    PER,
    STAGED,
    SUM,
    UNKNOWN,
    Item,
    Leaf,
    Leaves,
    Slot,
)
from softcat_sym.discretization.assembly import Body
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats
from softcat_sym.discretization.section_rule import PER_FIBRE
from softcat_sym.discretization.supports import node_mass
from softcat_sym.errors import PrintingError

_MARGIN = 3
"""Sites at either end that may differ from all others."""

_SEED, _POINTS, _SAME = 20261121, 8, 1e-12


@dataclass(frozen=True)
class Where:
    """Sites of a loop, whatever the number of sites: from `first` to the last but `behind`; or one site alone."""

    first: int  # Site at which the loop begins; of a single one counted from the last if negative (-1 is the last)
    behind: int  # Sites left out at the end of the row
    alone: bool = False  # Whether it is `first` only


@dataclass(frozen=True)
class Loop:
    """Fields that the same sites compute in one go, as seen from each of them."""

    where: Where  # The sites
    names: tuple[str, ...]  # The fields
    values: tuple[ca.SX, ...]  # What each is, of leaves whose sites are distances


@dataclass(frozen=True)
class _Shaped:
    """An item as seen from its sites: alike in the middle, with exceptions at the ends."""

    item: Item
    where: Where
    value: ca.SX
    exceptions: Mapping[int, ca.SX]
    reads: tuple[Leaf, ...]


def _shaped(leaves: Leaves, items: Sequence[Item]) -> list[_Shaped]:
    """Items as their sites see them."""
    found = []
    for item, alike in zip(items, _alike(leaves, items), strict=True):
        middle, sites = CELLS // 2, [site for site, same in zip(item.sites, alike, strict=True) if same]
        first, last = sites[0], sites[-1]
        if sites != list(range(first, last + 1)) or first > _MARGIN or CELLS - last > _MARGIN:
            raise PrintingError(f"{item.name} is not computed alike by the sites in the middle of the filament")
        seen = {s: v for s, v, same in zip(item.sites, item.values, alike, strict=True) if s == middle or not same}
        value = leaves.moved(seen.pop(middle), middle)
        ends = {site if site < middle else site - CELLS - 1: leaves.moved(v, site) for site, v in seen.items()}
        found.append(_Shaped(item, Where(first, CELLS - last), value, ends, tuple(leaves.within(value))))
    return found


def _alike(leaves: Leaves, items: Sequence[Item]) -> list[list[bool]]:
    """Whether each site of each item computes what the middle one does.

    Both are evaluated at the same random points: numbers are given to what a site sees at a distance, so that two
    sites that compute the same get the same results.
    """
    everything = ca.vertcat(*(value for item in items for value in item.values))
    inputs = leaves.within(everything)
    function = ca.Function("items", [ca.vertcat(*(leaves.symbol(leaf) for leaf in inputs))], [everything])
    generator = np.random.default_rng(_SEED)
    known: dict[Leaf, npt.NDArray[np.float64]] = {}

    def numbers(leaf: Leaf) -> npt.NDArray[np.float64]:
        if leaf not in known:
            known[leaf] = generator.uniform(0.3, 1.7, _POINTS)
        return known[leaf]

    results = {}
    for site in range(CELLS + 1):
        values = np.array([numbers(leaf.seen_from(site)) for leaf in inputs])
        results[site] = np.asarray(function(values)) if len(inputs) else np.asarray(function.call([ca.DM(0, 1)])[0])
    middle, start, found = CELLS // 2, 0, []
    for item in items:
        wanted = results[middle][start + item.sites.index(middle)]
        found.append(
            [
                np.allclose(results[site][start + k], wanted, rtol=_SAME, atol=0, equal_nan=True)
                for k, site in enumerate(item.sites)
            ]
        )
        start += len(item.sites)
    return found


def needed(leaves: Leaves, staged: Sequence[Item], items: Iterable[Item]) -> tuple[Item, ...]:
    """The staged fields that some items are made of, directly or not."""
    by_name = {item.name: item for item in staged}
    found: set[str] = set()
    waiting = [value for item in items for value in item.values]
    while waiting:
        names = {leaf.name for leaf in leaves.within(waiting.pop()) if leaf.kind == STAGED} - found
        found |= names
        waiting += [value for name in names for value in by_name[name].values]
    return tuple(item for item in staged if item.name in found)


def loops_of(leaves: Leaves, items: Sequence[Item]) -> tuple[Loop, ...]:
    """The loops that compute items in their order; those that can share one do."""
    shaped = _shaped(leaves, items)
    by_name = {one.item.name: one for one in shaped}
    level: dict[str, int] = {}
    for one in shaped:
        level[one.item.name] = max((_after(one, leaf, by_name, level, leaves.totals) for leaf in one.reads), default=0)
        if one.exceptions:
            # Alone, so that what the ends do otherwise stays short.
            level[one.item.name] += 1
    found: list[Loop] = []
    for stage in sorted(set(level.values())):
        here = [one for one in shaped if level[one.item.name] == stage]
        plain = [one for one in here if not one.exceptions]
        for where in dict.fromkeys(one.where for one in plain):
            found.append(_together(leaves, where, [one for one in plain if one.where == where]))
        special = [one for one in here if one.exceptions]
        for where in dict.fromkeys(one.where for one in special):
            group = [one for one in special if one.where == where]
            found.append(_loop(leaves, where, {o.item.name: o.value for o in group}))
        for site in sorted({site for one in special for site in one.exceptions}):
            at = [one for one in special if site in one.exceptions]
            found.append(_loop(leaves, Where(site, 0, alone=True), {o.item.name: o.exceptions[site] for o in at}))
    return tuple(found)


def _after(
    one: _Shaped, leaf: Leaf, by_name: Mapping[str, _Shaped], level: Mapping[str, int], totals: Collection[str]
) -> int:
    """The level that an item must have for one of the leaves that it reads."""
    if leaf.kind != STAGED or leaf.name not in by_name:
        return 0
    other = by_name[leaf.name]
    shares = leaf.site == 0 and other.where == one.where and not other.exceptions and not one.exceptions
    # What is done for every fibre looks up what is the same for all of them.
    shares = shares and not (leaf.name in totals or one.item.name in totals or PER_FIBRE in one.item.name)
    return level[leaf.name] if shares else level[leaf.name] + 1


def _together(leaves: Leaves, where: Where, group: Sequence[_Shaped]) -> Loop:
    """One loop: fields of the same site are written out where they are used."""
    values: dict[str, ca.SX] = {}
    known: list[tuple[ca.SX, ca.SX]] = []
    for one in group:
        value = one.value
        for symbol, meaning in reversed(known):
            value = ca.substitute(value, symbol, meaning)
        values[one.item.name] = value
        known.append((leaves.symbol(Leaf(STAGED, one.item.name, 0)), value))
    return _loop(leaves, where, values)


def _loop(leaves: Leaves, where: Where, values: Mapping[str, ca.SX]) -> Loop:
    """A loop over sites; what its fields sum over the fibres is a symbol in it."""
    summed = (leaves.sum_of(value) if name in leaves.totals else value for name, value in values.items())
    return Loop(where, tuple(values), tuple(summed))


Entry = tuple[str, int]
"""An unknown and the distance of its site."""


@dataclass
class Chain:
    """Derivatives of the fields of earlier loops."""

    leaves: Leaves  # Symbols
    # With respect to which unknowns each field has a derivative, at any of its sites.
    patterns: dict[str, list[Entry]] = field(default_factory=dict)
    # Those that are the same number at all sites.
    constants: dict[tuple[str, Entry], float] = field(default_factory=dict)

    def of(self, loop: Loop) -> dict[str, dict[Entry, ca.SX]]:
        """Derivatives of the fields of a loop with respect to the unknowns, as seen from its sites."""
        value = ca.vertcat(*loop.values)
        reads = [leaf for leaf in self.leaves.within(value) if self._moves(leaf)]
        found: dict[str, dict[Entry, ca.SX]] = {name: {} for name in loop.names}
        if not reads:
            return found
        partial = ca.jacobian(value, ca.vertcat(*(self.leaves.symbol(leaf) for leaf in reads)))
        rows, columns = partial.sparsity().get_triplet()
        for row, column in zip(rows, columns, strict=True):
            derivatives = found[loop.names[row]]
            for entry, change in self._changes(reads[column]):
                derivatives[entry] = derivatives.get(entry, ca.SX(0)) + partial[row, column] * change
        return {name: {e: d for e, d in sorted(one.items()) if not d.is_zero()} for name, one in found.items()}

    def _moves(self, leaf: Leaf) -> bool:
        return leaf.kind in (UNKNOWN, SUM) or (leaf.kind == STAGED and bool(self.patterns.get(leaf.name)))

    def _changes(self, leaf: Leaf) -> list[tuple[Entry, ca.SX]]:
        """What moves a leaf, and how much."""
        if leaf.kind == UNKNOWN:
            return [((leaf.name, leaf.site), ca.SX(1))]
        if leaf.kind == SUM:
            return self._changes_of_sum(leaf)
        found = []
        for entry in self.patterns[leaf.name]:
            known = self.constants.get((leaf.name, entry))
            symbol = self.leaves.symbol(Leaf(DERIVATIVE, entry_name(leaf.name, entry), leaf.site))
            found.append(((entry[0], entry[1] + leaf.site), symbol if known is None else ca.SX(known)))
        return found

    def _changes_of_sum(self, leaf: Leaf) -> list[tuple[Entry, ca.SX]]:
        """What moves a sum over fibres: what all of them see, and the state of each."""
        value = self.leaves.summed(leaf)
        reads = [read for read in self.leaves.within(value) if self._moves(read)]
        partial = ca.jacobian(value, ca.vertcat(*(self.leaves.symbol(read) for read in reads)))
        found = []
        for read, column in zip(reads, ca.horzsplit(partial), strict=True):
            slope = column if read.is_each else self.leaves.sum_of(column)
            found += [(entry, slope * change) for entry, change in self._changes(read)]
        return found

    def learn(self, loops: Sequence[Loop], derivatives: Sequence[Mapping[str, Mapping[Entry, ca.SX]]]) -> None:
        """Take in the fields of loops that belong together: those of all sites in the middle, and of the ends."""
        for loop, one in zip(loops, derivatives, strict=True):
            for name in loop.names:
                pattern = self.patterns.setdefault(name, [])
                pattern += [entry for entry in one[name] if entry not in pattern]
        pairs = list(zip(loops, derivatives, strict=True))
        for name, one in [(name, one) for loop, one in pairs if not loop.where.alone for name in loop.names]:
            ends = [other[name] for loop, other in pairs if loop.where.alone and name in loop.names]
            for entry, value in one[name].items():
                # What is missing at an end there is held, and so is what it would be multiplied with.
                alike = all(entry not in end or ca.is_equal(end[entry], value) for end in ends)
                if value.is_constant() and alike and set(self.patterns[name]) == set(one[name]):
                    self.constants[name, entry] = float(value)

    def stored(self, name: str) -> list[Entry]:
        """The derivatives of a field that differ from site to site."""
        return [entry for entry in self.patterns[name] if (name, entry) not in self.constants]


def entry_name(name: str, entry: Entry) -> str:
    """Name of the derivative of a field with respect to an unknown."""
    return f"{name}/{entry[0]}{entry[1]:+d}"


@dataclass(frozen=True)
class Sites:
    """Where the unknowns of a graph are in the rows of sites."""

    shape: tuple[int, int]  # Sites and slots
    x: npt.NDArray[np.int64]  # Flat index of each differential and each algebraic unknown
    z: npt.NDArray[np.int64]

    def state(self, x: Floats, z: Floats) -> Floats:
        """Rows of sites, zero where nothing is unknown."""
        flat = np.zeros(self.shape[0] * self.shape[1])
        flat[self.x], flat[self.z] = x, z
        return flat.reshape(self.shape)

    def vectors(self, states: Floats) -> tuple[Floats, Floats]:
        """Differential and algebraic unknowns, (nx, frames) and (nz, frames), of states (frames, sites, slots)."""
        flat = states.reshape(len(states), -1)
        return flat[:, self.x].T.copy(), flat[:, self.z].T.copy()


def sites_of(graph: Graph, slots: tuple[Slot, ...]) -> Sites:
    """Match the unknowns of a graph with the slots of its model."""
    number = {slot.name: k for k, slot in enumerate(slots)}
    pairs = ((graph.x_kinds, graph.x_places), (graph.z_kinds, graph.z_places))
    x, z = (
        np.array([place * len(slots) + number[kind] for kind, place in zip(kinds, places, strict=True)], dtype=np.int64)
        for kinds, places in pairs
    )
    return Sites((graph.grid.cells + 1, len(slots)), x, z)


def places_of(graph: Graph, body: Body, power: int, names: tuple[str, ...]) -> Floats:
    """Geometry of each site, shape (sites, names); what the last site's missing cell would have is one."""
    grid, profile = graph.grid, body.profile
    middle = np.zeros(grid.cells + 1)
    middle[int(np.argmin(np.abs(grid.nodes)))] = 0.5 if grid.is_half else 1.0
    known = {
        "X": grid.nodes,
        "cell": np.append(grid.cell_length, 1.0),
        "node": grid.node_length,
        "mass": node_mass(grid, profile, power),
        "hung": middle,
    }
    if profile.nodes is not None and profile.cells is not None:
        known |= {"h_node": np.asarray(profile.nodes), "h_cell": np.append(np.asarray(profile.cells), 1.0)}
    known |= {PER + name: 1 / known[name] for name in INVERTED}
    return np.ascontiguousarray(np.stack([known[name] for name in names], axis=1))
