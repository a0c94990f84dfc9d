"""Fields become loops over sites, with exact derivatives: what all compute alike, and what the ends do otherwise."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import casadi as ca

from softcat_sym.discretization.stencil import DERIVATIVE, STAGED, SUM, TIME, UNKNOWN, Field, Leaf, Leaves
from softcat_sym.discretization.unknowns import PER_FIBRE, SiteRange


@dataclass(frozen=True)
class Loop:
    """Fields that the same sites compute in one go, as seen from each of them."""

    where: SiteRange  # The sites
    names: tuple[str, ...]  # The fields
    values: tuple[ca.SX, ...]  # What each is, of leaves whose sites are distances


def needed(leaves: Leaves, staged: Sequence[Field], read_by: Iterable[Field]) -> tuple[Field, ...]:
    """The staged fields that some fields are made of, directly or not."""
    by_name = {one.name: one for one in staged}
    found: set[str] = set()
    waiting = [value for one in read_by for value in one.values]
    while waiting:
        names = {leaf.name for leaf in leaves.within(waiting.pop()) if leaf.kind == STAGED} - found
        found |= names
        waiting += [value for name in names for value in by_name[name].values]
    return tuple(one for one in staged if one.name in found)


def levels_of(leaves: Leaves, fields: Sequence[Field]) -> list[list[Loop]]:
    """Loops, each level of which reads earlier ones only."""
    by_name = {one.name: one for one in fields}
    level: dict[str, int] = {}
    for one in fields:
        reads = leaves.within(one.value)
        level[one.name] = max((_after(one, leaf, by_name, level, leaves.totals) for leaf in reads), default=0)
        if one.ends:
            # Alone, so that what the ends do otherwise stays short.
            level[one.name] += 1
    levels: list[list[Loop]] = []
    for stage in sorted(set(level.values())):
        found: list[Loop] = []
        here = [one for one in fields if level[one.name] == stage]
        plain, special = [one for one in here if not one.ends], [one for one in here if one.ends]
        for where in dict.fromkeys(one.where for one in plain):
            found.append(_together(leaves, where, [one for one in plain if one.where == where]))
        for where in dict.fromkeys(one.where for one in special):
            found.append(_loop(leaves, where, {one.name: one.value for one in special if one.where == where}))
        for site in sorted({site for one in special for site in one.ends}):
            values = {one.name: one.ends[site] for one in special if site in one.ends}
            found.append(_loop(leaves, SiteRange(site, 0, alone=True), values))
        levels.append(found)
    return levels


def _after(
    one: Field, leaf: Leaf, by_name: Mapping[str, Field], level: Mapping[str, int], totals: Collection[str]
) -> int:
    """The level that a field must have for one of the leaves that it reads."""
    if leaf.kind != STAGED or leaf.name not in by_name:
        return 0
    other = by_name[leaf.name]
    shares = leaf.site == 0 and other.where == one.where and not other.ends and not one.ends
    # What is done for every fibre looks up what is the same for all of them.
    shares = shares and not (leaf.name in totals or one.name in totals or PER_FIBRE in one.name)
    return level[leaf.name] if shares else level[leaf.name] + 1


def _together(leaves: Leaves, where: SiteRange, group: Sequence[Field]) -> Loop:
    """One loop: fields of the same site are written out where they are used."""
    values: dict[str, ca.SX] = {}
    known: list[tuple[ca.SX, ca.SX]] = []
    for one in group:
        value = one.value
        for symbol, meaning in reversed(known):
            value = ca.substitute(value, symbol, meaning)
        values[one.name] = value
        known.append((leaves.symbol(Leaf(STAGED, one.name, 0)), value))
    return _loop(leaves, where, values)


def _loop(leaves: Leaves, where: SiteRange, values: Mapping[str, ca.SX]) -> Loop:
    """A loop over sites; what its fields sum over the fibres is a symbol in it."""
    summed = (leaves.sum_of(value) if name in leaves.totals else value for name, value in values.items())
    return Loop(where, tuple(values), tuple(summed))


Entry = tuple[str, int]
"""An unknown and the distance of its site."""


@dataclass
class Chain:
    """Derivatives of the fields of earlier loops."""

    leaves: Leaves  # Symbols
    by_time: bool = False  # Whether the time counts as one more unknown
    by_unknowns: bool = True
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
        if leaf.kind == TIME:
            return self.by_time
        if leaf.kind == UNKNOWN:
            return self.by_unknowns
        return leaf.kind == SUM or (leaf.kind == STAGED and bool(self.patterns.get(leaf.name)))

    def _changes(self, leaf: Leaf) -> list[tuple[Entry, ca.SX]]:
        """What moves a leaf, and how much."""
        if leaf.kind in (UNKNOWN, TIME):
            return [((leaf.name, leaf.site), ca.SX(1))]
        if leaf.kind == SUM:
            return self._changes_of_sum(leaf)
        found = []
        for entry in self.patterns[leaf.name]:
            known = self.constants.get((leaf.name, entry))
            symbol = self.leaves.symbol(Leaf(DERIVATIVE, entry_name(leaf.name, entry), leaf.site))
            place = entry if entry[0] == "t" else (entry[0], entry[1] + leaf.site)
            found.append((place, symbol if known is None else ca.SX(known)))
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


def differentiated(chain: Chain, level: Sequence[Loop]) -> list[tuple[Loop, dict[str, dict[Entry, ca.SX]]]]:
    """Loops of one level with the derivatives of their fields."""
    found = [chain.of(loop) for loop in level]
    chain.learn(level, found)
    return list(zip(level, found, strict=True))


def entry_name(name: str, entry: Entry) -> str:
    """Name of the derivative of a field with respect to an unknown."""
    return f"{name}/{entry[0]}{entry[1]:+d}"
