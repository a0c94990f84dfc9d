"""The C of a filament on one grid, dressed as plain CasADi functions for users who bring their own integrator."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.c_model import Model
from softcat_sym.codegen.c_text import VERSIONS, CSource, c_array, number
from softcat_sym.codegen.export import runtime_files
from softcat_sym.codegen.interface import comment, rendered
from softcat_sym.codegen.sites import places_in_rows, sites_of
from softcat_sym.discretization.graph import Graph

RHS, JACOBIAN, POWERS = "softcat_rhs", "softcat_jacobian", "softcat_powers"
ARGUMENTS = ("t", "x", "z", "p")
Indices = npt.NDArray[np.int64]

_END = "-1"
"""Of a table of places, which C does not let be empty."""

_HEADING = """\
Right-hand side of a filament, as CasADi functions of (t, x, z, p), for your own integrator:
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


def rhs_source(graph: Graph, model: Model) -> CSource:
    """The right-hand side of a filament, its sparse Jacobian and the powers, from the C text of its model."""
    sites, count = sites_of(graph, model.slots), {"powers": len(graph.powers)}
    at = {"x": sites.x, "z": sites.z}
    count |= {name: len(places) for name, places in at.items()} | {"p": len(graph.parameters)}
    outputs = {"ode": "x", "alg": "z", "powers": "powers"}
    patterns = {name: ca.Sparsity.dense(size, 1) for name, size in {"t": 1, **count}.items()}
    tables, blocks = [c_array("double", "places", [number(float(one)) for one in places_in_rows(graph).ravel()])], {}
    for name, places in at.items():
        tables.append(c_array("int", f"{name}_at", [*map(str, places), _END]))
        patterns[f"powers_{name}"] = ca.Sparsity.dense(count["powers"], count[name])
    for of, rows in outputs.items():
        patterns |= {f"{of}_p": ca.Sparsity(count[rows], count["p"]), f"out_{of}": ca.Sparsity(count[rows], 1)}
        for by in at if of != "powers" else ():
            patterns[f"{of}_{by}"], entries = _block(model, sites.shape, at[rows], at[by])
            tables.append(c_array("int", f"{of}_{by}", [*map(str, entries), _END]))
            blocks[f"{of}_{by}"] = len(entries)
    for name, one in patterns.items():
        # As CasADi reads it: its size, where each column begins, and the rows.
        compressed = map(str, (*one.shape, *one.colind(), *one.row()))
        tables.append(c_array("casadi_int", f"pattern_{name}", list(compressed)))

    def slopes(of: str, names: Sequence[str], prefix: str = "") -> list[tuple[str, str]]:
        return [(f"{prefix}{of}_{by}", outputs[of] if by == "t" else f"{of}_{by}") for by in names]

    inputs, functions = [(name, name) for name in ARGUMENTS], list[dict[str, object]]()
    found = [one for of in ("ode", "alg") for one in slopes(of, ARGUMENTS[:3])]
    functions.append({"name": JACOBIAN, "inputs": inputs, "outputs": found})
    for name, of_it in ((RHS, ("ode", "alg")), (POWERS, ("powers",))):
        functions.append({"name": name, "inputs": inputs, "outputs": [(of, outputs[of]) for of in of_it]})
        values = inputs + [(f"out_{of}", f"out_{of}") for of in of_it]
        found = [one for of in of_it for one in slopes(of, ARGUMENTS, "jac_")]
        functions.append({"name": f"jac_{name}", "inputs": values, "outputs": found})
    lines = _HEADING.format(
        **{"rhs": RHS, "jacobian": JACOBIAN, "powers": POWERS},
        **{"nx": count["x"], "nz": count["z"], "np": count["p"]},
        parameters=", ".join(graph.parameters),
        effects=", ".join(graph.effects),
        versions=", ".join(f"{package} {version}" for package, version in VERSIONS.items()),
    ).splitlines()
    text = model.text.replace('#include "softcat_model.h"', runtime_files()["softcat_model.h"].rstrip())
    given = {"heading": comment(lines), "functions": functions}
    source = rendered(
        "rhs.c.jinja",
        model=text.replace("const softcat_model softcat_filament_model", "static const softcat_model model"),
        tables=tables,
        blocks=blocks,
        **{"sites": sites.shape[0], "slots": sites.shape[1], "entries": len(model.entries)},
        **{"nx": count["x"], "nz": count["z"], "powers": count["powers"], "scratch": model.sizes["scratch"]},
        **given,
    )
    return CSource({f"{RHS}.c": source, f"{RHS}.h": rendered("rhs.h.jinja", **given)})


def _block(model: Model, shape: tuple[int, int], rows: Indices, columns: Indices) -> tuple[ca.Sparsity, list[int]]:
    """Pattern of the derivatives of some unknowns' rates by some unknowns, and where each is among the entries."""
    slot = {one.name: k for k, one in enumerate(model.slots)}
    row_of, column_of = ({int(place): k for k, place in enumerate(places)} for places in (rows, columns))
    found = list[tuple[int, int, int]]()
    for site in range(shape[0]):
        for entry, (row, column, distance) in enumerate(model.entries):
            places = site * shape[1] + slot[row], (site + distance) * shape[1] + slot[column]
            if places[0] in row_of and places[1] in column_of and 0 <= site + distance < shape[0]:
                found.append((column_of[places[1]], row_of[places[0]], site * len(model.entries) + entry))
    found.sort()
    pattern = ca.Sparsity.triplet(len(rows), len(columns), [row for _, row, _ in found], [c for c, _, _ in found])
    return pattern, [entry for _, _, entry in found]
