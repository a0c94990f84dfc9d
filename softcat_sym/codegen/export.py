"""All files of the compiled solver, as a user takes them away; and C from any graph by CasADi itself."""

from __future__ import annotations

import itertools
import json
import os
import re
import tempfile
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib import resources
from importlib.metadata import version
from pathlib import Path
from typing import Any

import casadi as ca

from softcat_sym.codegen.c_printer import VERSIONS, CSource
from softcat_sym.codegen.interface import DEFAULT_NAME, Description, header_text, prefix_of, source_text, symbol_of
from softcat_sym.codegen.loops import rolled
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats
from softcat_sym.errors import SoftcatError


def manifest_text(described: Description, name: str, command: str, source: CSource) -> str:
    """The manifest."""
    return json.dumps(manifest(described, name, command, source), indent=1, ensure_ascii=False) + "\n"


def manifest(described: Description, name: str, command: str, source: CSource) -> dict[str, Any]:
    """What the manifest says, before it is text."""
    scene, model = described.scene, described.model
    return {
        "generated": f"do not edit; written by: {command}",
        "title": described.title,
        "structure": _structure(described),
        "parameters": [
            {"name": one.name, "unit": one.unit, "bound": one.bound, "value": one.value, "meaning": one.meaning}
            for one in described.parameters
        ],
        "unknowns": [
            {
                "name": slot.name,
                "on": "cells" if on_cells else "nodes",
                "kind": "differential" if slot.differential else "algebraic",
                "rate": slot.rate,
                "section": slot.section,
            }
            for slot, on_cells in zip(model.slots, described.on_cells, strict=True)
        ],
        "work": list(model.powers),
        "sizes": {
            "unknowns_per_site": len(model.slots),
            "jacobian_entries_per_site": len(model.entries),
            "numbers_per_site": list(model.places),
            "bytes_of_text": source.size,
        },
        "defaults": {
            "cells": described.cells,
            "grading": described.grading,
            "relative": described.relative,
            "absolute": described.absolute,
            "duration_s": scene.run.duration,
            "frames": scene.run.frames,
        },
        "prefix": prefix_of(name),
        "versions": dict(VERSIONS),
        "sha256": source.digest,
    }


def _structure(described: Description) -> dict[str, Any]:
    """What one build cannot change."""
    scene, structure = described.scene, described.structure
    supports = structure.body.supports
    return {
        "digest": described.digest,
        "effects": list(described.effects.names),
        "law": scene.material.law,
        "section": scene.filament.section,
        "closure": scene.run.closure,
        "theory": structure.theory.label.split(" ")[0],
        "ends": [end.name.lower().replace("symmetry", "plane of symmetry") for end in structure.ends],
        "supports": {"points_of_path": supports.rows, "parameters": list(supports.parameters)},
        "profile": structure.body.profile.nodes is not None,
        "point_mass": structure.body.weighted,
    }


START = "start.csv"


def parameter_text(described: Description, command: str, *, has_start: bool) -> str:
    """Lines ``name = number unit  # comment``, in SI units, of all that a run is asked."""
    run, free = described.scene.run, ("curvature", "drop", "_angle", "_dx", "_dy")
    lines = [f"# {' '.join(described.title.split())}", f"# Written by: {command}. Edit freely: name = number unit.", ""]
    for one in described.parameters:
        bound = {"positive": "> 0", "not-negative": ">= 0", "poisson": "-1 < nu < 1/2"}.get(one.bound, "")
        said = "; ".join(part for part in (one.meaning, bound) if part and not one.name.endswith(free))
        lines.append(
            _line(f"{one.name} = {one.value!r}{'' if one.unit == '1' else f' {one.unit}'}", said or one.meaning)
        )
    lines += ["", _line(f"cells = {described.cells}", f"per half span, {described.min_cells} or more")]
    lines.append(_line(f"grading = {described.grading!r}", "longest cell over the shortest"))
    lines.append(_line(f"duration = {run.duration!r} s", ""))
    lines.append(_line(f"frames = {run.frames}", "times, evenly spaced from 0"))
    lines.append(_line(f"relative = {described.relative!r}", "tolerance of a step"))
    lines.append(_line(f"absolute = {described.absolute!r}", "tolerance of a step, in rest lengths"))
    if has_start:
        lines.append(_line(f"start = {START}", "shape to begin from, at rest with the parameters above only"))
    return "\n".join(lines) + "\n"


def _line(text: str, said: str) -> str:
    return f"{text:40}  # {said}" if said else text


def start_text(described: Description, nodes: Floats, state: Floats) -> str:
    """A starting shape as CSV: X of the nodes [rest lengths] and all unknowns, dimensionless."""
    names = [slot.name for slot in described.model.slots]
    rows = [",".join(repr(float(value)) for value in (x, *row)) for x, row in zip(nodes, state, strict=True)]
    return "\n".join([",".join(["X", *names]), *rows]) + "\n"


_VERSIONS = (("softcat_sym", "softcat_sym"), ("CasADi", "casadi"), ("SymPy", "sympy"))

_UNUSED = re.compile(r"^(?:CASADI_SYMBOL_EXPORT|static) [^;\n]*\(((?!void\))[^()\n]+)\) ?\{", re.MULTILINE)
"""The first line of a function with parameters, as CasADi writes it."""

RHS, JACOBIAN, GENERAL_POWERS = "softcat_rhs", "softcat_jacobian", "softcat_powers"
SOLVER = "softcat_rosenbrock"
ARGUMENTS = ("t", "x", "z", "p")

# No derivatives with respect to parameters: no integrator asks for them, and they would double the text.
_DIFFERENTIABLE = [True, True, True, False]
_BLOCKS = tuple(f"{of}_{by}" for of in ("ode", "alg") for by in ("t", "x", "z"))

_RHS_SAYS = """\
Right-hand side of a filament, as CasADi functions of (t, x, z, p), for an integrator of your own:
  {rhs}: ode [{nx}] = dx/dt, alg [{nz}] = 0
  {jacobian}: ode_t, ode_x, ode_z, alg_t, alg_x, alg_z, sparse by columns
  {powers}: powers [3], plastic, of the changing load, of the necking gradient
t, x [{nx}] and z [{nz}] are dimensionless: lengths in rest lengths, time in units of the parameter time_scale.
Each NAME has NAME_n_in, NAME_sparsity_in and their like, and NAME_work for the sizes of the work vectors:
  int NAME(const double **arg, double **res, long long int *iw, double *w, int mem)
jac_{rhs} and jac_{powers} are the Jacobians in the form in which CasADi looks for them.
"""
_SOLVER_SAYS = """\
A filament carried over {intervals} equal output intervals by CasADi's Rosenbrock method (rtol {rtol!r}, atol {atol!r}):
  {solver}(x0 [{nx}], z0 [{nz}], p [{np}], start, interval)
    -> xf [{nx} x {frames}], zf [{nz} x {frames}], qf [3 x {frames}], by columns: at start + k interval, k = 0, 1, ...
x0 and z0 must be consistent. Time is in units of the parameter time_scale, lengths in rest lengths; qf holds the work
done since start: plastic, of the changing load, of the necking gradient. It returns nonzero if it gives up.
"""


@dataclass(frozen=True)
class Dynamics:
    """Right-hand side, Jacobian and powers of a graph as CasADi functions of (t, x, z, p), loops found again."""

    graph: Graph

    @cached_property
    def places(self) -> tuple[list[int], list[int]]:
        """The place of each differential and algebraic unknown: a node and the cell behind it count as one."""
        graph = self.graph
        along = [[round(float(where), 12) for where in wheres] for wheres in (graph.x_where, graph.z_where)]
        rank = {where: n // 2 for n, where in enumerate(sorted({*along[0], *along[1]}))}
        return [rank[where] for where in along[0]], [rank[where] for where in along[1]]

    @cached_property
    def jacobian(self) -> ca.Function:
        """Blocks ``ode_t`` ... ``alg_z``, sparse."""
        graph = self.graph
        blocks = [ca.jacobian(of, by) for of in (graph.ode, graph.alg) for by in (graph.t, graph.x, graph.z)]
        places = [self.places[n // 3] for n in range(len(blocks))]
        chosen = [[where[row] for row in block.sparsity().row()] for where, block in zip(places, blocks, strict=True)]
        return self._rolled(JACOBIAN, blocks, _BLOCKS, chosen)

    @cached_property
    def rhs(self) -> ca.Function:
        """(t, x, z, p) to (ode, alg), dense; its Jacobian is :attr:`jacobian`."""
        graph = self.graph
        plain = self._rolled(RHS, [ca.densify(graph.ode), ca.densify(graph.alg)], ("ode", "alg"), self.places)
        return _with_jacobian(plain, self.jacobian)

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
        t, x, z, p = (
            ca.MX.sym(n, s.numel()) for n, s in zip(ARGUMENTS, (graph.t, graph.x, graph.z, graph.p), strict=True)
        )
        total = [self.total(local) for local in (self.local_powers(t, x, z, p), *self._local_slopes(t, x, z, p))]
        slopes = ca.Function("softcat_slopes", [t, x, z, p], total[1:])
        plain = ca.Function(GENERAL_POWERS, [t, x, z, p], [ca.densify(total[0])], list(ARGUMENTS), ["powers"])
        return _with_jacobian(plain, slopes)

    def total(self, local: ca.MX) -> ca.MX:
        """Sums of each kind of power over all places, shape (3, columns)."""
        ends = [0, *itertools.accumulate(power.numel() for power in self.graph.powers)]
        return ca.vertcat(*(ca.sum1(local[low:high, :]) for low, high in itertools.pairwise(ends)))

    @cached_property
    def _local_slopes(self) -> ca.Function:
        graph, powers = self.graph, ca.vertcat(*self.graph.powers)
        blocks = [ca.jacobian(powers, by) for by in (graph.t, graph.x, graph.z)]
        rows = [[self._power_places[row] for row in block.sparsity().row()] for block in blocks]
        return self._rolled("softcat_local_slopes", blocks, ("powers_t", "powers_x", "powers_z"), rows)

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

    def _rolled(
        self, name: str, outputs: list[ca.SX], names: Sequence[str], places: Sequence[Sequence[int]]
    ) -> ca.Function:
        inputs = [self.graph.t, self.graph.x, self.graph.z, self.graph.p]
        return rolled(ca.Function(name, inputs, outputs, list(ARGUMENTS), list(names)), places)


def rhs_source(graph: Graph) -> CSource:
    """The right-hand side, its sparse Jacobian and the powers, for users who bring their own integrator."""
    dynamics = Dynamics(graph)
    functions = [dynamics.rhs, dynamics.jacobian, dynamics.powers]
    functions += [function.jacobian() for function in (dynamics.rhs, dynamics.powers)]
    says = _RHS_SAYS.format(rhs=RHS, jacobian=JACOBIAN, powers=GENERAL_POWERS, nx=graph.x.numel(), nz=graph.z.numel())
    return _generated(RHS, functions, graph, says)


def solver_source(graph: Graph, frames: int, options: Mapping[str, Any]) -> CSource:
    """The whole solver: CasADi's ``rosenbrock`` with everything that it calls."""
    says = _SOLVER_SAYS.format(
        solver=SOLVER,
        nx=graph.x.numel(),
        nz=graph.z.numel(),
        np=graph.p.numel(),
        frames=frames,
        intervals=frames - 1,
        rtol=options.get("reltol"),
        atol=options.get("abstol"),
    )
    return _generated(SOLVER, [rosenbrock(graph, frames, options)], graph, says)


def rosenbrock(graph: Graph, frames: int, options: Mapping[str, Any]) -> ca.Function:
    """The solver of :func:`solver_source`, interpreted: (x0, z0, p, start, interval) to (xf, zf, qf)."""
    dynamics = Dynamics(graph)
    x, z, p = (ca.MX.sym(name, of.numel()) for name, of in (("x", graph.x), ("z", graph.z), ("p", graph.p)))
    tau, start, interval = (ca.MX.sym(name) for name in ("tau", "start", "interval"))
    now = (start + interval * tau, x, z, p)
    ode, alg = dynamics.rhs(*now)
    given = ca.vertcat(p, start, interval)
    dae = {"t": tau, "x": x, "p": given, "ode": ode * interval, "quad": dynamics.local_powers(*now) * interval}
    if graph.is_dae:
        dae |= {"z": z, "alg": alg}
    run = ca.integrator("run", "rosenbrock", dae, 0, list(range(frames)), dict(options))
    out = run(x0=x, z0=z, p=given)
    results = [out["xf"], out["zf"], dynamics.total(out["qf"])]
    return ca.Function(
        SOLVER, [x, z, p, start, interval], results, ["x0", "z0", "p", "start", "interval"], ["xf", "zf", "qf"]
    )


def _with_jacobian(plain: ca.Function, slopes: ca.Function) -> ca.Function:
    """A function of (t, x, z, p) that CasADi differentiates by `slopes`: for each output its blocks by t, x and z."""
    inputs: list[Any] = plain.mx_in()
    blocks: list[Any] = []
    found: list[Any] = list(slopes.call(inputs))
    for number in range(plain.n_out()):
        size = plain.size1_out(number)
        blocks += [*found[3 * number : 3 * number + 3], ca.MX(size, plain.size1_in(3))]
    of, by = plain.name_out(), plain.name_in()
    values: list[Any] = [ca.MX.sym(f"out_{name}", ca.Sparsity(plain.size1_out(name), 1)) for name in of]
    names = [f"jac_{one}_{other}" for one in of for other in by]
    jacobian = ca.Function(
        f"jac_{plain.name()}",
        [*inputs, *values],
        blocks,
        [*by, *(f"out_{name}" for name in of)],
        names,
        {"never_inline": True},
    )
    options: dict[str, Any] = {
        "custom_jacobian": jacobian,
        "is_diff_in": _DIFFERENTIABLE,
        "enable_forward": False,
        "enable_reverse": False,
        "never_inline": True,
    }
    return ca.Function(plain.name(), inputs, plain.call(inputs), by, of, options)


def _generated(name: str, functions: Sequence[ca.Function], graph: Graph, says: str) -> CSource:
    generator = ca.CodeGenerator(name, {"with_header": True})
    for function in functions:
        generator.add(function)
    with tempfile.TemporaryDirectory() as folder:
        generator.generate(f"{folder}{os.sep}")
        texts = {file: (Path(folder) / file).read_text(encoding="utf-8") for file in (f"{name}.c", f"{name}.h")}
    top = _comment(
        f"{says}\n"
        f"p [{graph.p.numel()}], in SI units: {', '.join(graph.parameters)}\n"
        f"Effects: {', '.join(graph.effects)}\n"
        f"Generated, do not edit: " + ", ".join(f"{name} {version(package)}" for name, package in _VERSIONS)
    )
    return CSource({file: top + _UNUSED.sub(_used, text) for file, text in texts.items()})


def _used(found: re.Match[str]) -> str:
    """A function that names each of its parameters, so that compilers do not warn of those that it has no use for."""
    names = [re.findall(r"\w+", parameter)[-1] for parameter in found[1].split(",")]
    return found[0] + "".join(f" (void){name};" for name in names)


def _comment(text: str) -> str:
    lines = [line for part in text.splitlines() for line in textwrap.wrap(part, 96, subsequent_indent="    ") or [""]]
    return "\n".join(["/*", *(f" * {line}".rstrip() for line in lines), " */", ""])


_NAME = re.compile(r"[a-z][a-z0-9_]{0,39}")
_TAKEN = frozenset({"main", "all", "run", "clean"})
_TEMPLATES = ("main.c", "Makefile", "CMakeLists.txt", "README.md")


def check_name(name: str) -> str:
    """The name, if files and functions may have it."""
    if not _NAME.fullmatch(name) or name in _TAKEN or name.startswith("softcat"):
        raise SoftcatError(
            f"name {name!r}: take up to 40 small letters, digits and underscores, a letter first, and not "
            f"{', '.join(sorted(_TAKEN))} nor anything that begins with softcat"
        )
    return name


def model_files(described: Description, name: str, command: str) -> dict[str, str]:
    """The generated C with its header and manifest, by file name."""
    source = CSource(
        {f"{name}.c": source_text(described, name, command), f"{name}.h": header_text(described, name, command)}
    )
    return {**source.files, "manifest.json": manifest_text(described, name, command, source)}


def runtime_files() -> dict[str, str]:
    """The C that is the same for all filaments, by file name."""
    folder = resources.files("softcat_sym.codegen")
    files = [file for part in ("runtime", "templates") for file in (folder / part).iterdir()]
    chosen = [file for file in files if file.name.startswith("softcat_") and file.name[-2:] in (".c", ".h")]
    return {file.name: file.read_text(encoding="utf-8") for file in sorted(chosen, key=lambda file: file.name)}


def program_files(described: Description, name: str, command: str, *, rhs: bool) -> dict[str, str]:
    """A program around the generated C, and how to build it, by file name."""
    folder = resources.files("softcat_sym.codegen") / "templates"
    texts = {file: (folder / file).read_text(encoding="utf-8") for file in _TEMPLATES}
    if name != DEFAULT_NAME:
        texts["main.c"] = (
            texts["main.c"]
            .replace(f"{DEFAULT_NAME}.h", f"{name}.h")
            .replace(f"softcat_{DEFAULT_NAME}_structure", symbol_of(name, "structure"))
            .replace(f"{DEFAULT_NAME} PARAMETERS", f"{name} PARAMETERS")
        )
    filled = {
        "@NAME@": name,
        "@PREFIX@": prefix_of(name),
        "@BIG@": prefix_of(name).upper(),
        "@TITLE@": " ".join(described.title.split()),
        "@COMMAND@": command,
        "@EFFECTS@": ", ".join(described.effects.names),
        "@RHS@": _RHS if rhs else "",
    }
    for file in _TEMPLATES[1:]:
        for mark, text in filled.items():
            texts[file] = texts[file].replace(mark, text)
    return texts


_RHS = """
## Your own integrator

`softcat_rhs.c` and `softcat_rhs.h` are the same filament as plain CasADi functions: right-hand side, sparse Jacobian
and powers, on the grid of the scene. They need nothing else here; their comment says what goes in and out.
"""
