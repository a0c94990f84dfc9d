"""A filament as fields on its sites, each an expression of what lies at and beside a site.

Site i is a node and the cell behind it. What a cell or a joint computes is written once, of leaves whose places are
distances; the interpreter evaluates it at every site of a grid, and C loops over the sites.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.unknowns import PER_FIBRE, Shown, SiteRange

UNKNOWN, STAGED, PLACE, DERIVATIVE, PARAMETER, TIME = "unknown", "staged", "place", "derivative", "parameter", "time"
FIBRE, SUM = "fibre", "sum"
"""Where a fibre is and what it counts for; a sum over the fibres of a cell."""


@dataclass(frozen=True, order=True)
class Leaf:
    """One input of an expression."""

    kind: str  # One of the kinds above
    name: str  # Which unknown, field, length, derivative or parameter
    site: int = 0  # Distance of its site from the one that is looked at; zero for what has no place

    @property
    def is_local(self) -> bool:
        """Whether it belongs to a site."""
        return self.kind not in (PARAMETER, TIME, FIBRE)

    @property
    def is_each(self) -> bool:
        """Whether it differs from fibre to fibre."""
        return self.kind == FIBRE or PER_FIBRE in self.name


class Leaves:
    """The CasADi symbols of leaves, each made once."""

    def __init__(self) -> None:
        self._symbols: dict[Leaf, ca.SX] = {}
        self._leaves: dict[str, Leaf] = {}
        self.totals: set[str] = set()  # Fields that are sums over the fibres
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

    def within(self, expression: ca.SX) -> list[Leaf]:
        """The leaves of an expression, sorted."""
        return sorted(self._leaves[symbol.name()] for symbol in ca.symvar(ca.SX(expression)))

    def adopt(self, symbol: ca.SX, leaf: Leaf) -> None:
        """Let a symbol that was made elsewhere stand for a leaf."""
        self._symbols[leaf], self._leaves[symbol.name()] = symbol, leaf


@dataclass(frozen=True)
class Field:
    """What sites compute alike, and what single sites at the ends compute otherwise."""

    name: str
    where: SiteRange  # The sites that compute `value`
    value: ca.SX  # Of leaves whose sites are distances
    ends: Mapping[int, ca.SX] = field(default_factory=dict)  # By site, from the last if negative

    @property
    def values(self) -> tuple[ca.SX, ...]:
        """All of its expressions."""
        return (self.value, *self.ends.values())

    def mapped(self, name: str, change: Callable[[ca.SX], ca.SX]) -> Field:
        """What becomes of it at every site, under another name."""
        return Field(name, self.where, change(self.value), {at: change(value) for at, value in self.ends.items()})

    def times(self, factor: ca.SX, name: str = "") -> Field:
        """The same field in another unit, and by another name."""
        return self.mapped(name or self.name, lambda value: value * factor)

    def sites(self, count: int) -> list[int]:
        """Its sites where there are so many."""
        first = self.where.first % count
        last = first + 1 if self.where.alone else count - self.where.behind
        return sorted({*range(first, last), *(site % count for site in self.ends)})

    @property
    def shown(self) -> Shown:
        """The sites whose values a run stores."""
        first, behind = (0 if at in self.ends else n for at, n in ((0, self.where.first), (-1, self.where.behind)))
        return Shown(self.name, first, behind, summed=False)


class Neighbours:
    """A field as its sites read it: ``field[1]`` is its value one site further."""

    def __init__(self, leaves: Leaves, kind: str, name: str) -> None:
        self._leaves, self._kind, self._name = leaves, kind, name

    def __getitem__(self, distance: int) -> ca.SX:
        return self._leaves.symbol(Leaf(self._kind, self._name, distance))


class Same(Neighbours):
    """A value that all sites share."""

    def __init__(self, value: Any = 0) -> None:
        self._value = ca.SX(value)

    def __getitem__(self, distance: int) -> ca.SX:
        return self._value


Column = tuple[int, Any]
"""Site at which the values of a field begin, and the values."""


class Spread:
    """Fields at every site of a grid."""

    def __init__(
        self,
        leaves: Leaves,
        sites: int,
        places: Mapping[str, Any],
        unknowns: Mapping[str, Column],
        shared: Mapping[Leaf, Any],
    ) -> None:
        self._leaves, self._sites = leaves, sites
        self._known: dict[tuple[str, str], Column] = {
            **{(PLACE, name): (0, ca.DM(np.asarray(values))) for name, values in places.items()},
            **{(UNKNOWN, name): column for name, column in unknowns.items()},
        }
        self._shared = shared  # What no site has for itself: parameters and the time

    def take(self, one: Field) -> None:
        """Evaluate a field that later ones may read."""
        self._known[STAGED, one.name] = (0 if 0 in one.ends else one.where.first), self.values(one)

    def values(self, one: Field) -> Any:
        """A field at all of its sites, one below the other."""
        ends = ((SiteRange(site, 0, alone=True), value) for site, value in one.ends.items())
        pieces = [(one.where, one.value), *ends]
        found = sorted((self._column(where, value) for where, value in pieces), key=lambda piece: piece[0])
        return ca.vertcat(*(column for _, column in found))

    def _column(self, where: SiteRange, value: ca.SX) -> Column:
        """An expression at some sites."""
        first = where.first % self._sites
        count = 1 if where.alone else max(0, self._sites - where.behind - first)
        leaves = self._leaves.within(value)
        if not leaves or not count:
            return first, ca.repmat(ca.DM(float(value)) if not leaves else ca.DM(0), count, 1)
        function = ca.Function("at_a_site", [self._leaves.symbol(leaf) for leaf in leaves], [ca.densify(value)])
        arguments = [self._row(leaf, first, first + count) for leaf in leaves]
        return first, (function.map(count) if count > 1 else function)(*arguments).T

    def _row(self, leaf: Leaf, first: int, last: int) -> Any:
        if leaf in self._shared:
            return ca.repmat(self._shared[leaf], 1, last - first)
        begin, column = self._known[leaf.kind, leaf.name]
        low = first + leaf.site - begin
        if low < 0 or low + last - first > column.numel():
            raise ValueError(f"{leaf.name} is read at site {first + leaf.site}, where it is not")
        return ca.reshape(column[low : low + last - first], 1, last - first)


@dataclass(frozen=True)
class Evaluated:
    """What a filament is in terms of its unknowns, before common subexpressions are shared."""

    rates: Mapping[str, ca.SX]  # Of each unknown: its rate, or what it balances
    powers: tuple[ca.SX, ...]  # In the order of the signature
    observables: Mapping[str, ca.SX]  # What a trajectory shows
    support: tuple[ca.SX, ...]  # Force of the right support
