"""Functions of one C file, and where everything lies in the arrays that they work on."""

from __future__ import annotations

import re
from collections.abc import Sequence

import casadi as ca

from softcat_sym.codegen.c_printer import statements
from softcat_sym.codegen.instructions import code_of
from softcat_sym.codegen.leaves import DERIVATIVE, PARAMETER, PLACE, STAGED, UNKNOWN, Leaf
from softcat_sym.codegen.reciprocals import with_reciprocals
from softcat_sym.codegen.recording import Recording
from softcat_sym.codegen.stencil import Where

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
        self._recording = recording
        self._leaves = recording.leaves
        self._slot = {slot.name: k for k, slot in enumerate(recording.slots)}
        self._place = {name: k for k, name in enumerate(recording.places)}
        self._parameter = {name: k for k, name in enumerate(recording.parameters)}
        self._scratch: dict[str, int] = {}
        self.functions: list[str] = []
        self.moves_in_time = False

    @property
    def scratch(self) -> int:
        """Doubles per site."""
        return len(self._scratch)

    def is_field(self, name: str) -> bool:
        """Whether it is a staged field, not a rate or a power."""
        return not name.startswith(("f_", "power_"))

    def field(self, name: str) -> str:
        """C text of a field at the site that is looked at."""
        number = self._scratch.setdefault(name, len(self._scratch))
        return f"w{number}[i]"

    def leaf(self, leaf: Leaf) -> str:
        """C text of a leaf as seen from site i."""
        if leaf.kind == PARAMETER:
            return f"p[{self._parameter[leaf.name]}]"
        if leaf.kind == UNKNOWN:
            return f"y[{at(len(self._slot), leaf.site, self._slot[leaf.name])}]"
        if leaf.kind == PLACE:
            return f"g[{at(len(self._place), leaf.site, self._place[leaf.name])}]"
        if leaf.kind in (STAGED, DERIVATIVE):
            number = self._scratch.setdefault(leaf.name, len(self._scratch))
            return f"w{number}[i{f' {chr(43) if leaf.site > 0 else chr(45)} {abs(leaf.site)}' if leaf.site else ''}]"
        self.moves_in_time = True
        return "t"

    def function(self, name: str, where: Where, values: Sequence[ca.SX], targets: Sequence[str]) -> str:
        """Write a function that computes values at its sites; the call of it."""
        leaves = self._leaves.within(ca.vertcat(*values))
        plain = code_of([self._leaves.symbol(leaf) for leaf in leaves], list(values))
        code, leaves = with_reciprocals(plain, leaves)
        inputs = [self.leaf(leaf) for leaf in leaves]
        before, within = statements(code, inputs, [not leaf.is_local for leaf in leaves], targets)
        body = "\n".join([*before, *within])
        letters = [(c, kind) for c, kind in _ARGUMENTS if re.search(rf"\b{c}\b", body) or (c == "w" and "w" in body)]
        lines = [f"static void {name}(int n{''.join(f', {kind}{c}' for c, kind in letters)})", "{"]
        rows = sorted({int(row) for row in re.findall(r"\bw(\d+)\[", body)})
        lines += [f"    double *restrict w{row} = w{f' + {row} * n' if row else ''};" for row in rows]
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


def times(number: int, letter: str) -> str:
    """Beginning of the index of a row of numbers: so many times as long as the letter says."""
    return {0: "", 1: f"{letter} + "}.get(number, f"{number} * {letter} + ")


def at(size: int, distance: int, number: int) -> str:
    """Index of a number of a site at a distance from site i."""
    shift = size * distance + number
    return f"{size} * i{f' {chr(43) if shift > 0 else chr(45)} {abs(shift)}' if shift else ''}"
