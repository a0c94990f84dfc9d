"""Fields become loops: what all sites compute alike, what the ends do otherwise, and in which order."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.leaves import STAGED, Leaf, Leaves
from softcat_sym.codegen.recording import CELLS, Item
from softcat_sym.errors import PrintingError
from softcat_sym.graph.section_rule import EACH

_MARGIN = 3
"""Sites at either end that may differ from all others."""

_SEED, _POINTS, _SAME = 20261121, 8, 1e-12


@dataclass(frozen=True)
class Where:
    """Sites of a loop, whatever the number of sites: from `first` to the last but `behind`; or one site alone.

    Attributes
    ----------
    first : int
        Site at which the loop begins; of a single one counted from the last if negative (-1 is the last).
    behind : int
        Sites left out at the end of the row.
    alone : bool
        Whether it is `first` only.
    """

    first: int
    behind: int
    alone: bool = False


@dataclass(frozen=True)
class Loop:
    """Fields that the same sites compute in one go, as seen from each of them.

    Attributes
    ----------
    where : Where
        The sites.
    names : tuple of str
        The fields.
    values : tuple of casadi.SX
        What each is, of leaves whose sites are distances.
    """

    where: Where
    names: tuple[str, ...]
    values: tuple[ca.SX, ...]


@dataclass(frozen=True)
class _Shaped:
    """An item as seen from its sites: alike in the middle, with exceptions at the ends."""

    item: Item
    where: Where
    value: ca.SX
    exceptions: Mapping[int, ca.SX]
    reads: tuple[Leaf, ...]


def _shaped(leaves: Leaves, items: Sequence[Item]) -> list[_Shaped]:
    """Items as their sites see them.

    Raises
    ------
    PrintingError
        If the sites in the middle do not all compute the same.
    """
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
    """The loops that compute items in their order; those that can share one do.

    Parameters
    ----------
    leaves : Leaves
        Symbols.
    items : sequence of Item
        Each made of leaves and of earlier items.

    Raises
    ------
    PrintingError
        If the sites in the middle do not all compute the same.
    """
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
    shares = shares and not (leaf.name in totals or one.item.name in totals or EACH in one.item.name)
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
