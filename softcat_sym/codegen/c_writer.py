"""Functions of one C file, and where everything lies in the arrays that they work on."""

from __future__ import annotations

import re
from collections.abc import Sequence

import casadi as ca

from softcat_sym.codegen.c_printer import Target, When, statements
from softcat_sym.codegen.instructions import code_of
from softcat_sym.codegen.leaves import DERIVATIVE, FIBRE, PARAMETER, PLACE, STAGED, SUM, UNKNOWN, Leaf
from softcat_sym.codegen.reciprocals import with_reciprocals
from softcat_sym.codegen.recording import Recording
from softcat_sym.codegen.stencil import Where
from softcat_sym.graph.section_rule import EACH

_ARGUMENTS = (
    ("t", "double "),
    ("p", "const double *"),
    ("g", "const double *"),
    ("y", "const double *"),
    ("w", "double *"),
    ("f", "double *"),
    ("e", "double *"),
    ("q", "double *"),
    ("s", "double *"),
)


class Writer:
    """Functions of one C file, and where everything lies in its arrays."""

    def __init__(self, recording: Recording) -> None:
        self._leaves = recording.leaves
        self.slots = Row("SLOTS", [slot.name for slot in recording.slots])
        self._place = {name: k for k, name in enumerate(recording.places)}
        self._parameter = {name: k for k, name in enumerate(recording.parameters)}
        self._scratch: dict[str, int] = {}
        self._scratch_each: dict[str, int] = {}
        self.functions: list[str] = []
        self.moves_in_time = False

    @property
    def scratch(self) -> tuple[int, int]:
        """Doubles per site, and per site and fibre."""
        return len(self._scratch), len(self._scratch_each)

    def is_field(self, name: str) -> bool:
        """Whether it is a staged field, not a rate or a power."""
        return not name.startswith(("f_", "power_"))

    def field(self, name: str) -> Target:
        """A field at the site that is looked at."""
        return Target(self._stored(name, 0), each=EACH in name)

    def _stored(self, name: str, site: int) -> str:
        if EACH in name:
            number = self._scratch_each.setdefault(name, len(self._scratch_each))
            return f"each{number}[FIBRES * {f'(i {_signed(site)})' if site else 'i'} + k]"
        number = self._scratch.setdefault(name, len(self._scratch))
        return f"w{number}[i{f' {_signed(site)}' if site else ''}]"

    def leaf(self, leaf: Leaf) -> str:
        """C text of a leaf as seen from site i."""
        if leaf.kind == PARAMETER:
            return f"p[{self._parameter[leaf.name]}]"
        if leaf.kind == UNKNOWN:
            return f"y[{self.slots.at(leaf.name, leaf.site)}]"
        if leaf.kind == PLACE:
            return f"g[{at(len(self._place), leaf.site, self._place[leaf.name])}]"
        if leaf.kind in (STAGED, DERIVATIVE):
            return self._stored(leaf.name, leaf.site)
        if leaf.kind == FIBRE:
            return f"{leaf.name}[k]"
        if leaf.kind == SUM:
            return f"sum{leaf.name}"
        self.moves_in_time = True
        return "t"

    def function(self, name: str, where: Where, values: Sequence[ca.SX], targets: Sequence[Target]) -> str:
        """Write a function that computes values at its sites; the call of it."""
        sums = [leaf for leaf in self._leaves.within(ca.vertcat(*values)) if leaf.kind == SUM]
        values = [*values, *(self._leaves.summed(leaf) for leaf in sums)]
        targets = [*targets, *(Target(self.leaf(leaf), each=True, adds=True) for leaf in sums)]
        leaves = self._leaves.within(ca.vertcat(*values))
        plain = code_of([self._leaves.symbol(leaf) for leaf in leaves], list(values))
        code, leaves = with_reciprocals(plain, leaves)
        inputs = [self.leaf(leaf) for leaf in leaves]
        found = statements(code, inputs, [_known(leaf) for leaf in leaves], targets)
        within = found[When.SITE]
        if found[When.FIBRE]:
            within = [f"double {self.leaf(leaf)} = 0.0;" for leaf in sums] + within
            within += ["for (int k = 0; k < FIBRES; k++) {", *(f"    {one}" for one in found[When.FIBRE]), "}"]
        within = within + found[When.AFTER]
        before = found[When.BEFORE]
        body = "\n".join([*before, *within])
        letters = [(c, kind) for c, kind in _ARGUMENTS if re.search(rf"\b{c}\b", body) or (c == "w" and _STORED(body))]
        lines = [f"static void {name}(int n{''.join(f', {kind}{c}' for c, kind in letters)})", "{"]
        rows = sorted({int(row) for row in re.findall(r"\bw(\d+)\[", body)})
        lines += [f"    double *restrict w{row} = w{f' + {row} * n' if row else ''};" for row in rows]
        rows = sorted({int(row) for row in re.findall(r"\beach(\d+)\[", body)})
        lines += [
            f"    double *restrict each{row} = w + (SCRATCH{f' + {row} * FIBRES' if row else ''}) * n;" for row in rows
        ]
        lines += [f"    {line}" for line in before]
        if where.alone:
            lines.append(f"    const int i = {where.first if where.first >= 0 else f'n - {-where.first}'};")
            lines += [f"    {line}" for line in within] + ["    (void)n;"]
        else:
            end = f"n - {where.behind}" if where.behind else "n"
            lines.append(f"    for (int i = {where.first}; i < {end}; i++) {{")
            lines += [f"        {line}" for line in within] + ["    }"]
        self.functions.append("\n".join([*lines, "}"]))
        return f"    {name}(n{''.join(f', {c}' for c, _ in letters)});"


_STORED = re.compile(r"\b(?:w|each)\d+\[").search


def _known(leaf: Leaf) -> When:
    if leaf.is_each:
        return When.FIBRE
    if leaf.kind == SUM:
        return When.AFTER
    return When.SITE if leaf.is_local else When.BEFORE


class Row:
    """Numbers of a site: those that it has once first, then those of its fibres, kind by kind.

    Parameters
    ----------
    size : str
        C name of their number.
    names : sequence of str
        What they are.
    """

    def __init__(self, size: str, names: Sequence[str]) -> None:
        self.plain, self.each = ([n for n in names if (EACH in n) is each] for each in (False, True))
        self._size = size

    @property
    def count(self) -> str:
        """How many there are."""
        return self._size if self.each else str(len(self.plain))

    def at(self, name: str, distance: int = 0) -> str:
        """Index of a number of the site at a distance from site i."""
        if not self.each:
            return at(len(self.plain), distance, self.plain.index(name))
        site = f"(i {_signed(distance)})" if distance else "i"
        if EACH not in name:
            return f"{self._size} * {site} + {self.plain.index(name)}"
        kind = self.each.index(name)
        return f"{self._size} * {site} + {len(self.plain)}{f' + {kind} * FIBRES' if kind else ''} + k"


def _signed(distance: int) -> str:
    return f"{'+' if distance > 0 else '-'} {abs(distance)}"


def times(number: int, letter: str) -> str:
    """Beginning of the index of a row of numbers: so many times as long as the letter says."""
    return {0: "", 1: f"{letter} + "}.get(number, f"{number} * {letter} + ")


def at(size: int, distance: int, number: int) -> str:
    """Index of a number of a site at a distance from site i."""
    shift = size * distance + number
    return f"{size} * i{f' {_signed(shift)}' if shift else ''}"
