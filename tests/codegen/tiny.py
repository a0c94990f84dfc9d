"""A filament of two unknowns a site, small enough to be written out for any number of sites."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import casadi as ca

from softcat_sym.codegen.recording import (
    CELLS,
    PARAMETER,
    PLACE,
    STAGED,
    TIME,
    UNKNOWN,
    Item,
    Leaf,
    Leaves,
    Recording,
    Slot,
)

NODES, ON_CELLS = range(CELLS + 1), range(CELLS)
PARAMETERS, PLACES = ("p",), ("cell", "per_cell")


def item(name: str, sites: range, value: Callable[[int], ca.SX]) -> Item:
    """A field from what it is at a site."""
    return Item(name, sites, tuple(value(site) for site in sites))


class Tiny:
    """Symbols of a filament by name and site."""

    def __init__(self) -> None:
        self.leaves = Leaves()

    def __call__(self, kind: str, name: str, site: int = 0) -> ca.SX:
        return self.leaves.symbol(Leaf(kind, name, site))

    def y(self, site: int) -> ca.SX:
        return self(UNKNOWN, "y", site)

    def field(self, name: str, site: int) -> ca.SX:
        return self(STAGED, name, site)


def recording() -> Recording:
    """The filament of `written_out`, taken apart."""
    s = Tiny()
    p, t = s(PARAMETER, "p"), s(TIME, "t")

    def b(i: int) -> ca.SX:
        return s(UNKNOWN, "b", i)

    def turn(i: int) -> ca.SX:
        if i == 0:
            return s.field("slope", 0) ** 2
        if i == CELLS:
            return p * ca.sin(s.field("slope", CELLS - 1))
        return s.field("slope", i) * s.field("slope", i - 1)

    def rate(i: int) -> ca.SX:
        if i == 0:
            return 2 * s.field("force", 0)
        return -s.field("force", i - 1) + (s.field("force", i) + t if i < CELLS else -s.y(i))

    staged = (
        item("gap", ON_CELLS, lambda i: s.y(i + 1) - s.y(i)),
        item("slope", ON_CELLS, lambda i: s.field("gap", i) / s(PLACE, "cell", i) + p * b(i)),
        item("turn", NODES, turn),
        item(
            "force",
            ON_CELLS,
            lambda i: ca.exp(s.field("slope", i)) * b(i) + s.field("turn", i) - s.field("turn", i + 1),
        ),
        item("unused", NODES, lambda i: ca.log(s.y(i))),
        item("heat", ON_CELLS, lambda i: b(i) * s.field("force", i)),
    )
    rates = (
        item("f_y", NODES, rate),
        item("f_b", ON_CELLS, lambda i: s.field("turn", i) * s.field("gap", i) - b(i)),
    )
    powers = (
        (item("power_plastic_0", ON_CELLS, lambda i: s.field("heat", i) ** 2),),
        (
            item("power_load_0", NODES, lambda i: s.field("turn", i) * s.y(i)),
            item("power_load_1", ON_CELLS, lambda i: t * s.field("gap", i)),
        ),
        (item("power_gradient_0", ON_CELLS, lambda i: p * s.field("heat", i)),),
    )
    slots = Slot("y", True, "", False, NODES), Slot("b", True, "", False, ON_CELLS)
    return Recording(s.leaves, slots, staged, rates, powers, PARAMETERS, PLACES)


def written_out(
    y: Sequence[ca.SX], b: Sequence[ca.SX], cell: Sequence[float], p: float, t: float
) -> tuple[list[ca.SX], ...]:
    """Rates of y, rates of b and powers of a filament of any number of sites; b has one less."""
    cells = len(b)
    gap = [y[i + 1] - y[i] for i in range(cells)]
    slope = [gap[i] / cell[i] + p * b[i] for i in range(cells)]
    turn = [slope[0] ** 2, *(slope[i] * slope[i - 1] for i in range(1, cells)), p * ca.sin(slope[-1])]
    force = [ca.exp(slope[i]) * b[i] + turn[i] - turn[i + 1] for i in range(cells)]
    inner = [force[i] - force[i - 1] + t for i in range(1, cells)]
    f_y = [2 * force[0], *inner, -force[-1] - y[-1]]
    f_b = [turn[i] * gap[i] - b[i] for i in range(cells)]
    heat = [b[i] * force[i] for i in range(cells)]
    load = sum(turn[i] * y[i] for i in range(cells + 1)) + sum(t * one for one in gap)
    return f_y, f_b, [sum(one**2 for one in heat), load, sum(p * one for one in heat)]
