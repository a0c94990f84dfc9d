"""Exact derivatives of fields with respect to the unknowns around each site, from loop to loop by the chain rule."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import casadi as ca

from softcat_sym.codegen.leaves import DERIVATIVE, STAGED, SUM, UNKNOWN, Leaf, Leaves
from softcat_sym.codegen.stencil import Loop

Entry = tuple[str, int]
"""An unknown and the distance of its site."""


@dataclass
class Chain:
    """Derivatives of the fields of earlier loops.

    Attributes
    ----------
    leaves : Leaves
        Symbols.
    patterns : dict of str to list of Entry
        With respect to which unknowns each field has a derivative, at any of its sites.
    constants : dict of (str, Entry) to float
        Those that are the same number at all sites.
    """

    leaves: Leaves
    patterns: dict[str, list[Entry]] = field(default_factory=dict)
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
