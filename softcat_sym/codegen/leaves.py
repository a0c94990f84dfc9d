"""What the expressions of a filament are made of: unknowns, staged fields, geometry and parameters, each with its site.

Site i of a filament is its node i and the cell to the right of it.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

UNKNOWN, STAGED, PLACE, DERIVATIVE, PARAMETER, TIME = "unknown", "staged", "place", "derivative", "parameter", "time"


@dataclass(frozen=True, order=True)
class Leaf:
    """One input of an expression.

    Attributes
    ----------
    kind : str
        One of the six kinds above.
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
        return self.kind not in (PARAMETER, TIME)

    def seen_from(self, site: int) -> Leaf:
        """The same with the distance in place of the site."""
        return Leaf(self.kind, self.name, self.site - site) if self.is_local else self


class Leaves:
    """The CasADi symbols of leaves, each made once."""

    def __init__(self) -> None:
        self._symbols: dict[Leaf, ca.SX] = {}
        self._leaves: dict[str, Leaf] = {}

    def symbol(self, leaf: Leaf) -> ca.SX:
        """The symbol of a leaf."""
        if leaf not in self._symbols:
            name = f"{leaf.kind}:{leaf.name}@{leaf.site}"
            self._symbols[leaf], self._leaves[name] = ca.SX.sym(name), leaf
        return self._symbols[leaf]

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
