"""Loops found again in straight-line code: what every cell computes alike becomes one function, mapped over the cells.

An assembled graph has no cells left, only operations. Two operations belong together where the same places need their
results; what belongs together is a cluster, and clusters that do the same with other numbers are calls of one function.
No operation is done twice and none in another order, so that the results are the same to the last bit, while text and
compile time hardly depend on the number of cells.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field

import casadi as ca
import numpy as np

_LEAF = -1


@dataclass(frozen=True)
class _Tape:
    """Straight-line code, operation by operation.

    Attributes
    ----------
    operations : list of int
        CasADi's number of each operation; ``_LEAF`` for inputs and constants.
    operands : list of tuple of int
        Which earlier ones it takes.
    leaves : dict
        Input and entry of it, or the constant (a float), by position.
    results : list of list of int
        The entries of every output.
    """

    operations: list[int]
    operands: list[tuple[int, ...]]
    leaves: dict[int, tuple[int, int] | float]
    results: list[list[int]]

    def is_leaf(self, k: int) -> bool:
        """Whether nothing is computed there."""
        return self.operations[k] == _LEAF


def _record(function: ca.Function) -> _Tape:
    tape = _Tape([], [], {}, [[-1] * function.nnz_out(i) for i in range(function.n_out())])
    held: dict[int, int] = {}  # CasADi writes over work that nobody needs any more
    for k in range(function.n_instructions()):
        kind, taken, given = function.instruction_id(k), function.instruction_input(k), function.instruction_output(k)
        if kind == ca.OP_OUTPUT:
            tape.results[given[0]][given[1]] = held[taken[0]]
            continue
        here = len(tape.operations)
        leaf = kind in (ca.OP_INPUT, ca.OP_CONST)
        if leaf:
            tape.leaves[here] = (taken[0], taken[1]) if kind == ca.OP_INPUT else float(function.instruction_constant(k))
        tape.operations.append(_LEAF if leaf else kind)
        tape.operands.append(() if leaf else tuple(held[slot] for slot in taken))
        held[given[0]] = here
    return tape


@dataclass
class _Cluster:
    """Operations needed by the same places, in order.

    Attributes
    ----------
    level : int
        Clusters of a lower level come first.
    code : list of (str or int, tuple of int)
        Kind of a leaf, or CasADi's number of an operation and the positions of its operands in this list.
    leaves : list of int
        Where on the tape each leaf is found.
    roots : list of int
        Where on the tape the values are that others need.
    chosen : tuple of int
        Positions of these in `code`.
    """

    level: int
    code: list[tuple[str | int, tuple[int, ...]]] = field(default_factory=list)
    leaves: list[int] = field(default_factory=list)
    roots: list[int] = field(default_factory=list)
    chosen: tuple[int, ...] = ()

    @property
    def signature(self) -> Hashable:
        """Equal for clusters that are calls of one function, and can be done at the same time."""
        return self.level, tuple(self.code), self.chosen


def _clusters(tape: _Tape, places: Sequence[Sequence[Hashable]]) -> list[_Cluster]:
    """All clusters, each behind those that it needs."""
    count = len(tape.operations)
    users, seen, numbers = [0] * count, [False] * count, dict[Hashable, int]()
    for nodes, where in zip(tape.results, places, strict=True):
        for node, place in zip(nodes, where, strict=True):
            users[node] |= 1 << numbers.setdefault(place, len(numbers))
            seen[node] = True
    for k in reversed(range(count)):
        for operand in tape.operands[k]:
            users[operand] |= users[k]
    members: dict[int, list[int]] = {}
    for k in range(count):
        if not tape.is_leaf(k) and users[k]:
            members.setdefault(users[k], []).append(k)
            for operand in tape.operands[k]:
                seen[operand] = seen[operand] or users[operand] != users[k]
    found: dict[int, _Cluster] = {}
    # Whatever a cluster needs is needed by more places than itself.
    for user in sorted(members, key=lambda mask: -mask.bit_count()):
        needed = {users[a] for k in members[user] for a in tape.operands[k] if not tape.is_leaf(a)} - {user}
        cluster = _Cluster(1 + max((found[other].level for other in needed), default=0))
        _fill(cluster, tape, [k for k in members[user] if seen[k]], frozenset(members[user]))
        found[user] = cluster
    return sorted(found.values(), key=lambda cluster: cluster.level)


def _fill(cluster: _Cluster, tape: _Tape, roots: list[int], inside: frozenset[int]) -> None:
    """Write the code of a cluster depth first, so that it does not depend on where it stood."""
    local: dict[int, int] = {}
    for root in roots:
        stack = [root]
        while stack:
            k = stack[-1]
            missing = [a for a in tape.operands[k] if a not in local] if k in inside else []
            if k not in local and missing:
                stack.extend(reversed(missing))
                continue
            stack.pop()
            if k in local:
                continue
            local[k] = len(cluster.code)
            if k not in inside:
                cluster.code.append((_tag(tape, k), ()))
                cluster.leaves.append(k)
            else:
                cluster.code.append((tape.operations[k], tuple(local[a] for a in tape.operands[k])))
    cluster.roots = roots
    cluster.chosen = tuple(local[root] for root in roots)


def _tag(tape: _Tape, k: int) -> str:
    """What kind of leaf: a value of another cluster, a constant, or an entry of an input."""
    leaf = tape.leaves.get(k)
    if leaf is None:
        return "value"
    return "constant" if isinstance(leaf, float) else f"input {leaf[0]}"


class _Writer:
    """Writes calls of functions over many clusters as one MX graph."""

    def __init__(self, function: ca.Function, tape: _Tape) -> None:
        self._name, self._tape = function.name(), tape
        self.inputs = [ca.MX.sym(function.name_in(i), function.sparsity_in(i)) for i in range(function.n_in())]
        self._values: list[ca.MX] = []
        self._places: dict[int, int] = {}
        self._size = self._calls = 0

    def call(self, clusters: list[_Cluster]) -> None:
        """Compute the values of clusters that have the same signature."""
        columns = [[cluster.leaves[i] for cluster in clusters] for i in range(len(clusters[0].leaves))]
        expressions: list[ca.SX] = []
        sources: dict[str, tuple[list[ca.SX], list[list[int]]]] = {}
        leaf = 0
        for what, operands in clusters[0].code:
            if isinstance(what, str):
                expressions.append(self._argument(what, columns[leaf], sources))
                leaf += 1
            else:
                taken = [expressions[i] for i in operands]
                expressions.append(ca.SX.unary(what, *taken) if len(taken) == 1 else ca.SX.binary(what, *taken))
        symbols = [ca.vertcat(*names) for names, _ in sources.values()]
        results = ca.vertcat(*(expressions[i] for i in clusters[0].chosen))
        function = ca.Function(f"{self._name}_{self._calls}", symbols, [ca.densify(results)])
        arguments = [self._gather(kind, rows, len(clusters)) for kind, (_, rows) in sources.items()]
        out = function.map(len(clusters))(*arguments) if len(clusters) > 1 else function(*arguments)
        for root in (root for cluster in clusters for root in cluster.roots):
            self._places[root] = self._size
            self._size += 1
        self._values.append(ca.vec(out))
        self._calls += 1

    def _argument(self, tag: str, column: list[int], sources: dict[str, tuple[list[ca.SX], list[list[int]]]]) -> ca.SX:
        """A symbol for a leaf that differs from cluster to cluster; a number where it is the same constant in all."""
        first = self._tape.leaves.get(column[0])
        if isinstance(first, float) and all(self._tape.leaves[k] == first for k in column):
            return ca.SX(first)
        symbols, rows = sources.setdefault(tag, ([], []))
        symbols.append(ca.SX.sym("a"))
        rows.append(column)
        return symbols[-1]

    def _gather(self, kind: str, rows: list[list[int]], count: int) -> ca.MX:
        """Arguments of the calls, shape (len(rows), count)."""
        nodes = [row[i] for i in range(count) for row in rows]
        if kind == "constant":
            return ca.MX(ca.DM(np.array([self._tape.leaves[k] for k in nodes]).reshape(count, len(rows)).T))
        if kind == "value":
            chosen = ca.vertcat(*self._values)[[self._places[k] for k in nodes]]
        else:
            number = int(kind.split()[1])
            chosen = self.inputs[number].nz[[self._entry(k) for k in nodes]]
        return ca.reshape(chosen, len(rows), count)

    def _entry(self, k: int) -> int:
        leaf = self._tape.leaves[k]
        return leaf[1] if isinstance(leaf, tuple) else 0

    def output(self, sparsity: ca.Sparsity, nodes: list[int]) -> ca.MX:
        """Values gathered into an output."""
        beside: list[ca.MX] = []
        places: list[int] = []
        for k in nodes:
            if k in self._places:
                places.append(self._places[k])
                continue
            leaf = self._tape.leaves[k]
            beside.append(self.inputs[leaf[0]].nz[leaf[1]] if isinstance(leaf, tuple) else ca.MX(leaf))
            places.append(self._size + len(beside) - 1)
        return ca.MX(sparsity, ca.vertcat(*self._values, *beside)[places]) if nodes else ca.MX(sparsity)


def rolled(function: ca.Function, places: Sequence[Sequence[Hashable]]) -> ca.Function:
    """The same function, with what it does alike at many places written once.

    Parameters
    ----------
    function : casadi.Function
        Of SX: straight-line code.
    places : sequence of sequence
        For every structural nonzero of every output, the place along the filament that it belongs to.

    Returns
    -------
    casadi.Function
        Of MX, with the same inputs and outputs, equal to the last bit.

    Raises
    ------
    ValueError
        If there are not as many places as nonzeros.
    """
    tape = _record(function)
    alike: dict[Hashable, list[_Cluster]] = {}
    for cluster in _clusters(tape, places):
        alike.setdefault(cluster.signature, []).append(cluster)
    writer = _Writer(function, tape)
    for clusters in alike.values():
        writer.call(clusters)
    outputs = [writer.output(function.sparsity_out(i), nodes) for i, nodes in enumerate(tape.results)]
    return ca.Function(function.name(), writer.inputs, outputs, function.name_in(), function.name_out())
