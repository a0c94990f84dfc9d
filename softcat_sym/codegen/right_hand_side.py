"""The right-hand side of any graph as plain CasADi functions in C, with loops where cells are alike."""

from __future__ import annotations

import os
import re
import tempfile
import textwrap
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

import casadi as ca

from softcat_sym.codegen.c_text import CSource
from softcat_sym.codegen.loops import Chain, Entry, differentiated, entry_name, levels_of, needed
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.stencil import DERIVATIVE, PARAMETER, STAGED, TIME, Column, Field, Leaf, Spread
from softcat_sym.discretization.symbolic import gathered
from softcat_sym.discretization.unknowns import Layout
from softcat_sym.errors import PrintingError
from softcat_sym.store import version

RHS, JACOBIAN, POWERS = "softcat_rhs", "softcat_jacobian", "softcat_powers"
ARGUMENTS = ("t", "x", "z", "p")

_VERSIONS = (("softcat_sym", "softcat_sym"), ("CasADi", "casadi"), ("SymPy", "sympy"))
_UNUSED = re.compile(r"^(?:CASADI_SYMBOL_EXPORT|static) [^;\n]*\(((?!void\))[^()\n]+)\) ?\{", re.MULTILINE)
"""The first line of a function with parameters, as CasADi writes it."""

_HEADING = """\
Right-hand side of a filament, as CasADi functions of (t, x, z, p), for an integrator of your own:
  {rhs}: ode [{nx}] = dx/dt, alg [{nz}] = 0
  {jacobian}: ode_t, ode_x, ode_z, alg_t, alg_x, alg_z, sparse by columns
  {powers}: powers, plastic, of the changing load, of the necking gradient, of each effect that dissipates
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


class Dynamics:
    """Right-hand side, Jacobian and powers of a graph as CasADi functions of (t, x, z, p), as loops over sites."""

    def __init__(self, graph: Graph) -> None:
        if any(one.summed for one in graph.program.fields):
            raise PrintingError("a filament whose sites all read one sum, that of small deflections, is no loop")
        self.graph, self.program, self._count = graph, graph.program, graph.grid.cells + 1
        sizes = (part.numel() for part in (graph.t, graph.x, graph.z, graph.p))
        self._inputs = [ca.MX.sym(name, size) for name, size in zip(ARGUMENTS, sizes, strict=True)]
        self._powers = [one for power in self.program.powers.values() for one in power]

    def _spread(self) -> Spread:
        t, x, z, p = self._inputs
        parameters = {Leaf(PARAMETER, name): p[k] for k, name in enumerate(self.graph.parameters)}
        return self.graph.symbolic.spread(x, z, {**parameters, Leaf(TIME, "t"): t})

    def _values(self, of: Sequence[Field]) -> dict[str, Any]:
        """Fields at all of their sites, in as few loops as there can be."""
        leaves, spread = self.program.leaves, self._spread()
        for loops in levels_of(leaves, [*needed(leaves, self.program.fields, of), *of]):
            pieces: dict[str, list[Column]] = {}
            for loop in loops:
                first, columns = spread.at(loop.where, loop.values)
                for name, column in zip(loop.names, columns, strict=True):
                    pieces.setdefault(name, []).append((first, column))
            spread.know(STAGED, pieces)
        return {one.name: spread.known(STAGED, one.name) for one in of}

    def _blocks(
        self, of: Sequence[Field], rows: Sequence[Mapping[str, Sequence[int]]], sizes: Sequence[int]
    ) -> list[Any]:
        """Derivatives by time, differential and algebraic unknowns of each group of fields whose rows are numbered."""
        leaves, spread = self.program.leaves, self._spread()
        chain, outputs = Chain(leaves, by_time=True), {one.name for one in of}
        levels = levels_of(leaves, [*needed(leaves, self.program.fields, of), *of])
        slopes: dict[tuple[str, Entry], list[Column]] = {}
        for level in levels:
            values: dict[str, list[Column]] = {}
            stored: dict[str, list[Column]] = {}
            for loop, found in differentiated(chain, level):
                names = [
                    (name, entry)
                    for name in loop.names
                    for entry in (found[name] if name in outputs else chain.stored(name))
                ]
                plain = [name for name in loop.names if name not in outputs]
                expressions = [value for name, value in zip(loop.names, loop.values, strict=True) if name in plain]
                expressions += [found[name].get(entry, ca.SX(0)) for name, entry in names]
                if not expressions:
                    continue
                first, columns = spread.at(loop.where, expressions)
                for name, column in zip(plain, columns, strict=False):
                    values.setdefault(name, []).append((first, column))
                for (name, entry), column in zip(names, columns[len(plain) :], strict=True):
                    if name in outputs:
                        slopes.setdefault((name, entry), []).append((first, column))
                    else:
                        stored.setdefault(entry_name(name, entry), []).append((first, column))
            spread.know(STAGED, values)
            spread.know(DERIVATIVE, stored)
        layouts = None, self.graph.moving, self.graph.still
        return [
            self._block(slopes, numbers, size, by) for numbers, size in zip(rows, sizes, strict=True) for by in layouts
        ]

    def _block(
        self,
        slopes: Mapping[tuple[str, Entry], Sequence[Column]],
        rows: Mapping[str, Sequence[int]],
        size: int,
        by: Layout | None,
    ) -> ca.MX:
        """One sparse block: by the unknowns of a layout, or by the time."""
        columns: dict[tuple[str, int], int] = {("t", 0): 0}
        if by is not None:
            columns = {place: k for k, place in enumerate(zip(by.kinds, by.places, strict=True))}
        found, values = list[tuple[int, int]](), list[Any]()
        for (name, (unknown, distance)), pieces in slopes.items():
            if name not in rows:
                continue
            for first, column in pieces:
                sites = range(first, first + column.numel())
                at = [columns.get((unknown, 0 if unknown == "t" else site + distance)) for site in sites]
                chosen = [k for k, number in enumerate(at) if number is not None]
                if chosen:
                    values.append(column if len(chosen) == len(at) else column[chosen])
                    found += [(at[k] or 0, rows[name][sites[k]]) for k in chosen]
        shape = size, 1 if by is None else len(by)
        if not values:
            return ca.MX(*shape)
        # By columns; what several sites give to one entry, as to a sum, is added.
        entries = sorted(set(found))
        number = {entry: k for k, entry in enumerate(entries)}
        at_entry = [number[entry] for entry in found]
        pattern = ca.Sparsity.triplet(*shape, [row for _, row in entries], [column for column, _ in entries])
        if len(entries) == len(found):
            order = [0] * len(found)
            for k, entry in enumerate(at_entry):
                order[entry] = k
            return ca.MX(pattern, ca.vertcat(*values)[order])
        gathered = ca.Sparsity.triplet(len(entries), len(found), at_entry, list(range(len(found))))
        return ca.MX(pattern, ca.mtimes(ca.DM(gathered, 1), ca.vertcat(*values)))

    def _rows_of(self, layout: Layout) -> dict[str, list[int]]:
        number = {place: k for k, place in enumerate(zip(layout.kinds, layout.places, strict=True))}
        kinds = set(layout.kinds)
        return {f"f_{name}": [number.get((name, site), -1) for site in range(self._count)] for name in kinds}

    @cached_property
    def jacobian(self) -> ca.Function:
        """Blocks ``ode_t`` ... ``alg_z``, sparse."""
        layouts = self.graph.moving, self.graph.still
        rows, sizes = [self._rows_of(layout) for layout in layouts], [len(layout) for layout in layouts]
        names = [f"{of}_{by}" for of in ("ode", "alg") for by in ARGUMENTS[:3]]
        return ca.Function(
            JACOBIAN, self._inputs, self._blocks(self.program.rates, rows, sizes), list(ARGUMENTS), names
        )

    @cached_property
    def rhs(self) -> ca.Function:
        """(t, x, z, p) to (ode, alg), dense; its Jacobian is :attr:`jacobian`."""
        values = self._values(self.program.rates)
        rates = {slot.name: values[f"f_{slot.name}"] for slot in self.program.slots}
        outputs = [ca.densify(ca.MX(gathered(layout, rates))) for layout in (self.graph.moving, self.graph.still)]
        return _with_jacobian(ca.Function(RHS, self._inputs, outputs, list(ARGUMENTS), ["ode", "alg"]), self.jacobian)

    @cached_property
    def powers(self) -> ca.Function:
        """(t, x, z, p) to the powers of the whole filament, shape (powers,)."""
        values, powers = self._values(self._powers), self.program.powers.values()
        total = [sum((ca.sum1(values[one.name]) for one in power), ca.MX(0)) for power in powers]
        rows = {one.name: [k] * self._count for k, power in enumerate(powers) for one in power}
        slopes = ca.Function("softcat_slopes", self._inputs, self._blocks(self._powers, [rows], [len(powers)]))
        plain = ca.Function(POWERS, self._inputs, [ca.densify(ca.vertcat(*total))], list(ARGUMENTS), ["powers"])
        return _with_jacobian(plain, slopes)


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
