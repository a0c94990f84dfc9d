"""What the expressions of a filament are made of: unknowns, staged fields, geometry and parameters, each with its site.

Site i of a filament is its node i and the cell to the right of it.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from softcat_sym.graph.section_rule import EACH

UNKNOWN, STAGED, PLACE, DERIVATIVE, PARAMETER, TIME = "unknown", "staged", "place", "derivative", "parameter", "time"
FIBRE, SUM = "fibre", "sum"
"""Where a fibre is and what it counts for; a sum over the fibres of a cell."""


@dataclass(frozen=True, order=True)
class Leaf:
    """One input of an expression.

    Attributes
    ----------
    kind : str
        One of the eight kinds above.
    name : str
        Which unknown, field, length, entry or parameter.
    site : int
        Where: a site, or the distance from the site that is being looked at; zero for what has no place.
    """

    kind: str
    name: str
    site: int = 0

    @property
    def is_local(self) -> bool:
        """Whether it belongs to a site."""
        return self.kind not in (PARAMETER, TIME, FIBRE)

    @property
    def is_each(self) -> bool:
        """Whether it differs from fibre to fibre."""
        return self.kind == FIBRE or EACH in self.name

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
