"""The right-hand side of any graph as plain CasADi functions in C, with loops where cells are alike."""

from __future__ import annotations

import itertools
import os
import re
import tempfile
import textwrap
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.codegen.c_printer import CSource
from softcat_sym.discretization.graph import Graph

RHS, JACOBIAN, POWERS = "softcat_rhs", "softcat_jacobian", "softcat_powers"
ARGUMENTS = ("t", "x", "z", "p")

_VERSIONS = (("softcat_sym", "softcat_sym"), ("CasADi", "casadi"), ("SymPy", "sympy"))
_LEAF = -1

_UNUSED = re.compile(r"^(?:CASADI_SYMBOL_EXPORT|static) [^;\n]*\(((?!void\))[^()\n]+)\) ?\{", re.MULTILINE)
"""The first line of a function with parameters, as CasADi writes it."""

_HEADING = """\
Right-hand side of a filament, as CasADi functions of (t, x, z, p), for an integrator of your own:
  {rhs}: ode [{nx}] = dx/dt, alg [{nz}] = 0
  {jacobian}: ode_t, ode_x, ode_z, alg_t, alg_x, alg_z, sparse by columns
  {powers}: powers [3], plastic, of the changing load, of the necking gradient
t, x [{nx}] and z [{nz}] are dimensionless: lengths in rest lengths, time in units of the parameter time_scale.
Each NAME has NAME_n_in, NAME_sparsity_in and their like, and NAME_work for the sizes of the work vectors:
  int NAME(const double **arg, double **res, long long int *iw, double *w, int mem)
jac_{rhs} and jac_{powers} are the Jacobians in the form in which CasADi looks for them.

p [{np}], in SI units: {parameters}
Effects: {effects}
Generated, do not edit: {versions}"""


def rhs_source(graph: Graph) -> CSource:
    """The right-hand side, its sparse Jacobian and the powers, for users who bring their own integrator."""
    dynamics = Dynamics(graph)
    generator = ca.CodeGenerator(RHS, {"with_header": True})
    functions = [dynamics.rhs, dynamics.jacobian, dynamics.powers]
    for function in (*functions, *(function.jacobian() for function in (dynamics.rhs, dynamics.powers))):
        generator.add(function)
    with tempfile.TemporaryDirectory() as folder:
        generator.generate(f"{folder}{os.sep}")
        texts = {file: (Path(folder) / file).read_text(encoding="utf-8") for file in (f"{RHS}.c", f"{RHS}.h")}
    heading = _HEADING.format(
        rhs=RHS,
        jacobian=JACOBIAN,
        powers=POWERS,
        nx=graph.x.numel(),
        nz=graph.z.numel(),
        np=graph.p.numel(),
        parameters=", ".join(graph.parameters),
        effects=", ".join(graph.effects),
        versions=", ".join(f"{name} {version(package)}" for name, package in _VERSIONS),
    )
    wrapped = [textwrap.wrap(line, 96, subsequent_indent="    ") or [""] for line in heading.splitlines()]
    top = "\n".join(["/*", *(f" * {line}".rstrip() for lines in wrapped for line in lines), " */", ""])
    return CSource({file: top + _UNUSED.sub(_used, text) for file, text in texts.items()})


def _used(found: re.Match[str]) -> str:
    """A function that names each of its parameters, so that compilers do not warn of those that it has no use for."""
    names = [re.findall(r"\w+", parameter)[-1] for parameter in found[1].split(",")]
    return found[0] + "".join(f" (void){name};" for name in names)


@dataclass(frozen=True)
class Dynamics:
    """Right-hand side, Jacobian and powers of a graph as CasADi functions of (t, x, z, p), loops found again."""

    graph: Graph

    @cached_property
    def places(self) -> tuple[list[int], list[int]]:
        """The place of each differential and algebraic unknown: a node and the cell behind it count as one."""
        along = [[round(float(at), 12) for at in where] for where in (self.graph.x_where, self.graph.z_where)]
        rank = {at: n // 2 for n, at in enumerate(sorted({*along[0], *along[1]}))}
        return [rank[at] for at in along[0]], [rank[at] for at in along[1]]

    @cached_property
    def jacobian(self) -> ca.Function:
        """Blocks ``ode_t`` ... ``alg_z``, sparse."""
        return self._slopes(
            JACOBIAN, {"ode": (self.graph.ode, self.places[0]), "alg": (self.graph.alg, self.places[1])}
        )

    @cached_property
    def rhs(self) -> ca.Function:
        """(t, x, z, p) to (ode, alg), dense; its Jacobian is :attr:`jacobian`."""
        outputs = [ca.densify(self.graph.ode), ca.densify(self.graph.alg)]
        return _with_jacobian(self._rolled(RHS, outputs, ("ode", "alg"), self.places), self.jacobian)

    @cached_property
    def local_powers(self) -> ca.Function:
        """(t, x, z, p) to the three kinds of power, place by place: the sums would fill a row of every Jacobian."""
        powers = ca.densify(ca.vertcat(*self.graph.powers))
        plain = self._rolled("softcat_local_powers", [powers], ("powers",), [self._power_places])
        return _with_jacobian(plain, self._local_slopes)

    @cached_property
    def powers(self) -> ca.Function:
        """(t, x, z, p) to the powers of the whole filament, shape (3,)."""
        graph = self.graph
        sizes = (part.numel() for part in (graph.t, graph.x, graph.z, graph.p))
        inputs = [ca.MX.sym(name, size) for name, size in zip(ARGUMENTS, sizes, strict=True)]
        ends = [0, *itertools.accumulate(power.numel() for power in graph.powers)]
        total = [
            ca.vertcat(*(ca.sum1(local[low:high, :]) for low, high in itertools.pairwise(ends)))
            for local in (self.local_powers(*inputs), *self._local_slopes(*inputs))
        ]
        slopes = ca.Function("softcat_slopes", inputs, total[1:])
        return _with_jacobian(ca.Function(POWERS, inputs, [ca.densify(total[0])], list(ARGUMENTS), ["powers"]), slopes)

    @cached_property
    def _local_slopes(self) -> ca.Function:
        powers = ca.vertcat(*self.graph.powers)
        return self._slopes("softcat_local_slopes", {"powers": (powers, self._power_places)})

    @cached_property
    def _power_places(self) -> list[int]:
        """The first place that each power depends on."""
        graph, powers = self.graph, ca.vertcat(*self.graph.powers)
        where = [*self.places[0], *self.places[1]]
        found = [len(where)] * powers.numel()
        rows, columns = ca.jacobian_sparsity(powers, ca.vertcat(graph.x, graph.z)).get_triplet()
        for row, column in zip(rows, columns, strict=True):
            found[row] = min(found[row], where[column])
        return found

    def _slopes(self, name: str, outputs: dict[str, tuple[ca.SX, list[int]]]) -> ca.Function:
        """Blocks of derivatives by t, x and z of outputs with their places."""
        by = {"t": self.graph.t, "x": self.graph.x, "z": self.graph.z}
        blocks = [ca.jacobian(of, unknown) for of, _ in outputs.values() for unknown in by.values()]
        where = [places for _, places in outputs.values() for _ in by]
        rows = [[at[row] for row in block.sparsity().row()] for at, block in zip(where, blocks, strict=True)]
        return self._rolled(name, blocks, [f"{of}_{letter}" for of in outputs for letter in by], rows)

    def _rolled(
        self, name: str, outputs: list[ca.SX], names: Sequence[str], places: Sequence[Sequence[int]]
    ) -> ca.Function:
        inputs = [self.graph.t, self.graph.x, self.graph.z, self.graph.p]
        return rolled(ca.Function(name, inputs, outputs, list(ARGUMENTS), list(names)), places)


def _with_jacobian(plain: ca.Function, slopes: ca.Function) -> ca.Function:
    """A function of (t, x, z, p) that CasADi differentiates by `slopes`: for each output its blocks by t, x and z."""
    inputs: list[Any] = plain.mx_in()
    found: list[Any] = list(slopes.call(inputs))
    of, by = plain.name_out(), plain.name_in()
    blocks: list[Any] = []
    for number in range(plain.n_out()):
        blocks += [*found[3 * number : 3 * number + 3], ca.MX(plain.size1_out(number), plain.size1_in(3))]
    values: list[Any] = [ca.MX.sym(f"out_{name}", ca.Sparsity(plain.size1_out(name), 1)) for name in of]
    jacobian = ca.Function(
        f"jac_{plain.name()}",
        [*inputs, *values],
        blocks,
        [*by, *(f"out_{name}" for name in of)],
        [f"jac_{one}_{other}" for one in of for other in by],
        {"never_inline": True},
    )
    options: dict[str, Any] = {
        "custom_jacobian": jacobian,
        # By parameters no integrator asks for derivatives, and they would double the text.
        "is_diff_in": [True, True, True, False],
        "enable_forward": False,
        "enable_reverse": False,
        "never_inline": True,
    }
    return ca.Function(plain.name(), inputs, plain.call(inputs), by, of, options)


@dataclass(frozen=True)
class _Tape:
    """Straight-line code, operation by operation."""

    operations: list[int]  # CasADi's number of each operation; ``_LEAF`` for inputs and constants
    operands: list[tuple[int, ...]]  # Which earlier ones it takes
    leaves: dict[int, tuple[int, int] | float]  # Input and entry of it, or the constant, by position
    results: list[list[int]]  # The entries of every output

    @classmethod
    def of(cls, function: ca.Function) -> _Tape:
        """Record a function."""
        tape = cls([], [], {}, [[-1] * function.nnz_out(i) for i in range(function.n_out())])
        held: dict[int, int] = {}  # CasADi writes over work that nobody needs any more
        for k in range(function.n_instructions()):
            kind, read, written = (getattr(function, f"instruction_{part}")(k) for part in ("id", "input", "output"))
            if kind == ca.OP_OUTPUT:
                tape.results[written[0]][written[1]] = held[read[0]]
                continue
            here = len(tape.operations)
            leaf = kind in (ca.OP_INPUT, ca.OP_CONST)
            if leaf:
                constant = kind == ca.OP_CONST
                tape.leaves[here] = float(function.instruction_constant(k)) if constant else (read[0], read[1])
            tape.operations.append(_LEAF if leaf else kind)
            tape.operands.append(() if leaf else tuple(held[slot] for slot in read))
            held[written[0]] = here
        return tape

    def kind(self, k: int) -> str:
        """What kind of leaf: a value of another cluster, a constant, or an entry of an input."""
        leaf = self.leaves.get(k)
        if leaf is None:
            return "value"
        return "constant" if isinstance(leaf, float) else f"input {leaf[0]}"


@dataclass
class _Cluster:
    """Operations needed by the same places, in order."""

    level: int  # Clusters of a lower level come first
    # Kind of a leaf, or CasADi's number of an operation and the positions of its operands in this list.
    code: list[tuple[str | int, tuple[int, ...]]] = field(default_factory=list)
    leaves: list[int] = field(default_factory=list)  # Where on the tape each leaf is found
    roots: list[int] = field(default_factory=list)  # Where on the tape the values are that others need
    chosen: tuple[int, ...] = ()  # Positions of these in `code`

    @property
    def signature(self) -> Hashable:
        """Equal for clusters that are calls of one function, and can be done at the same time."""
        return self.level, tuple(self.code), self.chosen

    def fill(self, tape: _Tape, roots: list[int], inside: frozenset[int]) -> None:
        """Write the code depth first, so that it does not depend on where it stood."""
        local: dict[int, int] = {}
        stack = list(reversed(roots))
        while stack:
            k = stack[-1]
            missing = [a for a in tape.operands[k] if a not in local] if k in inside and k not in local else []
            if missing:
                stack.extend(reversed(missing))
                continue
            stack.pop()
            if k in local:
                continue
            local[k] = len(self.code)
            if k in inside:
                self.code.append((tape.operations[k], tuple(local[a] for a in tape.operands[k])))
            else:
                self.code.append((tape.kind(k), ()))
                self.leaves.append(k)
        self.roots, self.chosen = roots, tuple(local[root] for root in roots)


def _clusters(tape: _Tape, places: Sequence[Sequence[Hashable]]) -> list[_Cluster]:
    """All clusters, each behind those that it needs."""
    count = len(tape.operations)
    users, needed, numbers = [0] * count, [False] * count, dict[Hashable, int]()
    for nodes, where in zip(tape.results, places, strict=True):
        for node, place in zip(nodes, where, strict=True):
            users[node] |= 1 << numbers.setdefault(place, len(numbers))
            needed[node] = True
    for k in reversed(range(count)):
        for operand in tape.operands[k]:
            users[operand] |= users[k]
    members: dict[int, list[int]] = {}
    for k in range(count):
        if tape.operations[k] != _LEAF and users[k]:
            members.setdefault(users[k], []).append(k)
            for operand in tape.operands[k]:
                needed[operand] = needed[operand] or users[operand] != users[k]
    found: dict[int, _Cluster] = {}
    # Whatever a cluster needs is needed by more places than itself.
    for user in sorted(members, key=lambda mask: -mask.bit_count()):
        operands = {a for k in members[user] for a in tape.operands[k] if tape.operations[a] != _LEAF}
        others = {users[a] for a in operands} - {user}
        found[user] = _Cluster(1 + max((found[other].level for other in others), default=0))
        found[user].fill(tape, [k for k in members[user] if needed[k]], frozenset(members[user]))
    return sorted(found.values(), key=lambda cluster: cluster.level)


class _Writer:
    """Writes calls of functions over many clusters as one MX graph."""

    def __init__(self, function: ca.Function, tape: _Tape) -> None:
        self._name, self._tape = function.name(), tape
        self.inputs = [ca.MX.sym(function.name_in(i), function.sparsity_in(i)) for i in range(function.n_in())]
        self._values: list[ca.MX] = []
        self._places: dict[int, int] = {}

    def call(self, clusters: list[_Cluster]) -> None:
        """Compute the values of clusters that have the same signature."""
        first, count = clusters[0], len(clusters)
        columns = iter([cluster.leaves[i] for cluster in clusters] for i in range(len(first.leaves)))
        expressions: list[ca.SX] = []
        sources: dict[str, tuple[list[ca.SX], list[list[int]]]] = {}
        for what, operands in first.code:
            if isinstance(what, str):
                expressions.append(self._argument(what, next(columns), sources))
            else:
                operation = ca.SX.unary if len(operands) == 1 else ca.SX.binary
                expressions.append(operation(what, *(expressions[i] for i in operands)))
        symbols = [ca.vertcat(*names) for names, _ in sources.values()]
        results = ca.densify(ca.vertcat(*(expressions[i] for i in first.chosen)))
        function = ca.Function(f"{self._name}_{len(self._values)}", symbols, [results])
        arguments = [self._gather(kind, rows, count) for kind, (_, rows) in sources.items()]
        out = function.map(count)(*arguments) if count > 1 else function(*arguments)
        for root in (root for cluster in clusters for root in cluster.roots):
            self._places[root] = len(self._places)
        self._values.append(ca.vec(out))

    def _argument(self, kind: str, column: list[int], sources: dict[str, tuple[list[ca.SX], list[list[int]]]]) -> ca.SX:
        """A symbol for a leaf that differs from cluster to cluster; a number where it is the same constant in all."""
        first = self._tape.leaves.get(column[0])
        if isinstance(first, float) and all(self._tape.leaves[k] == first for k in column):
            return ca.SX(first)
        symbols, rows = sources.setdefault(kind, ([], []))
        symbols.append(ca.SX.sym("a"))
        rows.append(column)
        return symbols[-1]

    def _gather(self, kind: str, rows: list[list[int]], count: int) -> ca.MX:
        """Arguments of the calls, shape (len(rows), count)."""
        nodes, leaves = [row[i] for i in range(count) for row in rows], self._tape.leaves
        if kind == "constant":
            return ca.MX(ca.DM(np.array([leaves[k] for k in nodes]).reshape(count, len(rows)).T))
        if kind == "value":
            chosen = ca.vertcat(*self._values)[[self._places[k] for k in nodes]]
        else:
            entries = [leaf[1] for leaf in (leaves[k] for k in nodes) if isinstance(leaf, tuple)]
            chosen = self.inputs[int(kind.split()[1])].nz[entries]
        return ca.reshape(chosen, len(rows), count)

    def output(self, sparsity: ca.Sparsity, nodes: list[int]) -> ca.MX:
        """Values gathered into an output."""
        beside: list[ca.MX] = []
        places: list[int] = []
        for k in nodes:
            if k not in self._places:
                leaf = self._tape.leaves[k]
                beside.append(self.inputs[leaf[0]].nz[leaf[1]] if isinstance(leaf, tuple) else ca.MX(leaf))
            places.append(self._places.get(k, len(self._places) + len(beside) - 1))
        return ca.MX(sparsity, ca.vertcat(*self._values, *beside)[places]) if nodes else ca.MX(sparsity)


def rolled(function: ca.Function, places: Sequence[Sequence[Hashable]]) -> ca.Function:
    """The same function, with what it does alike at many places written once."""
    tape = _Tape.of(function)
    alike: dict[Hashable, list[_Cluster]] = {}
    for cluster in _clusters(tape, places):
        alike.setdefault(cluster.signature, []).append(cluster)
    writer = _Writer(function, tape)
    for clusters in alike.values():
        writer.call(clusters)
    outputs = [writer.output(function.sparsity_out(i), nodes) for i, nodes in enumerate(tape.results)]
    return ca.Function(function.name(), writer.inputs, outputs, function.name_in(), function.name_out())
