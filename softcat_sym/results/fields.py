"""Fields of a run over the whole span in SI units, with its energy audit, as an xarray Dataset."""

from __future__ import annotations

import importlib.metadata
import json
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import xarray as xr

from softcat_sym.discretization.assembly import energy_scale
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import Effects
from softcat_sym.effects.scaling_estimates import instant_modulus
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.scene import Scene, rest_length, undeformed_area
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Solution


@dataclass(frozen=True, slots=True)
class Variable:
    """One variable of ``trajectory.nc``."""

    name: str  # As in the file
    place: str  # ``node``, ``cell`` or empty for one number a frame
    unit: str  # Pint symbol
    meaning: str  # ``long_name`` in the file
    per_area: bool = False  # Whether the graph computes it per unit undeformed area


VARIABLES: tuple[Variable, ...] = (
    Variable("x", "node", "m", "horizontal position of the centreline, 0 at midspan"),
    Variable("y", "node", "m", "height of the centreline above the left support"),
    Variable("stretch", "cell", "1", "stretch of the centreline"),
    Variable("curvature", "cell", "1/m", "curvature theta_s of the centreline, k/Lam of a filament that shears"),
    Variable("shear", "cell", "1", "shear strain of the section"),
    Variable("tension", "cell", "N", "tension T = A <sigma>", per_area=True),
    Variable("axial_force", "cell", "N", "force along the centreline, tension and surface tension", per_area=True),
    Variable("moment", "cell", "N*m", "bending moment M", per_area=True),
    Variable(
        "shear_force", "cell", "N", "transverse force N = M_X/s, A <tau> of a filament that shears", per_area=True
    ),
    Variable("yielded_fraction", "cell", "1", "share of the section that flows"),
    Variable("plastic_rate", "cell", "1/s", "largest plastic strain rate over the section"),
    Variable("thickness", "cell", "m", "thickness of the section"),
    Variable("stress_mean", "cell", "Pa", "section mean sigma_0 of the axial stress"),
    Variable(
        "stress_bending",
        "cell",
        "Pa",
        "sigma_1 = <sigma zeta>/<zeta^2>: the axial stress nearest to sigma_0 + sigma_1 zeta",
    ),
    Variable("core_low", "cell", "1", "zeta below which fibres yield, of a section resolved fibre by fibre"),
    Variable("core_high", "cell", "1", "zeta above which fibres yield, of a section resolved fibre by fibre"),
    Variable("energy_kinetic", "", "J", "kinetic energy", per_area=True),
    Variable("energy_elastic", "", "J", "elastic energy", per_area=True),
    Variable("energy_surface", "", "J", "surface tension times the growth of the area since t = 0", per_area=True),
    Variable("energy_potential", "", "J", "potential energy of the weight, 0 when straight", per_area=True),
    Variable("energy_dissipated", "", "J", "plastic work since t = 0", per_area=True),
    Variable("energy_gradient", "", "J", "work against the necking gradient since t = 0", per_area=True),
    Variable("work_external", "", "J", "work of the changing load since t = 0", per_area=True),
)

ENERGIES = tuple(v.name for v in VARIABLES if v.unit == "J")

_ODD = frozenset({"x", "shear", "shear_force"})
_NODE = frozenset({"x", "y"})


def mirrored(name: str, values: Floats) -> Floats:
    """Whole-span field from its right half."""
    sign = -1.0 if name in _ODD else 1.0
    left = sign * values[:, ::-1]
    return np.concatenate([left[:, :-1] if name in _NODE else left, values], axis=1)


def midpoint_heights(graph: Graph, solution: Solution) -> Floats:
    """Height of X = 0 over the rest length, negative down."""
    middle = int(np.argmin(np.abs(graph.grid.nodes)))
    for kinds, places, values in (
        (graph.x_kinds, graph.x_places, solution.x),
        (graph.z_kinds, graph.z_places, solution.z),
    ):
        for kind, place, row in zip(kinds, places, values, strict=True):
            if kind == "y" and place == middle:
                return np.asarray(row, dtype=float)
    raise SoftcatError("the filament has no node at midspan")


_NO_STRAIN = 1e-6


def whole_span_fields(scene: Scene, prepared: Prepared, solution: Solution) -> dict[str, Floats]:
    """Every variable of the trajectory that this theory has, whole span, whole filament."""
    graph, span = prepared.graph, rest_length(scene)
    observed = graph.observe(solution.time, solution.x, solution.z, prepared.p)
    unit = energy_scale(scene.filament.density, span, prepared.scale) * span
    observed["energy_dissipated"] = solution.quad[0][:, None] * unit
    observed["work_external"] = solution.quad[1][:, None] * unit
    observed["energy_gradient"] = _gradient_energy(graph, observed, solution.quad[2] * unit, span)[:, None]
    observed["energy_surface"] = observed["energy_surface"] - observed["energy_surface"][:1]
    observed["thickness"] = observed["relative_thickness"] * scene.filament.thickness
    area = undeformed_area(scene)
    known = [v for v in VARIABLES if v.name in observed]
    return {v.name: _whole(graph, v.name, observed[v.name] * (area if v.per_area else 1.0)) for v in known}


def min_energy(scene: Scene) -> float:
    """Elastic energy of the whole filament at a strain of a millionth [J]: below it there is nothing to audit."""
    modulus = instant_modulus(scene) or 0.0
    return modulus * undeformed_area(scene) * rest_length(scene) * _NO_STRAIN**2


def _gradient_energy(graph: Graph, observed: dict[str, Floats], integrated: Floats, span: float) -> Floats:
    """Work against the necking gradient [J/m^2]: integrated with the motion, or summed over frames without inertia.

    Positions that are algebraic have no velocity that a quadrature could use.
    """
    if graph.has_velocities:
        return integrated
    change = np.diff(np.diff(observed["stretch"], axis=1), axis=0)
    force = observed["double_force"]
    steps = np.sum((force[1:] + force[:-1]) / 2 * change, axis=1) * span
    return np.concatenate([[0.0], np.cumsum(steps)])


def _whole(graph: Graph, name: str, values: Floats) -> Floats:
    if name in ENERGIES:
        return values[:, 0] * (2.0 if graph.grid.is_half else 1.0)
    return mirrored(name, values) if graph.grid.is_half else values


def node_positions(graph: Graph, span: float) -> tuple[Floats, Floats]:
    """Material coordinates [m] of nodes and cells over the whole span, X = 0 at midspan."""
    nodes, cells = graph.grid.nodes * span, graph.grid.centres * span
    if not graph.grid.is_half:
        return nodes, cells
    return np.concatenate([-nodes[:0:-1], nodes]), np.concatenate([-cells[::-1], cells])


_STORED = (
    "energy_kinetic",
    "energy_elastic",
    "energy_surface",
    "energy_potential",
    "energy_dissipated",
    "energy_gradient",
)


def energy_residual(fields: Mapping[str, Floats], least: float = 0.0) -> float:
    """Largest imbalance over the run, relative to the largest energy in it."""
    balance = sum(fields[name] for name in _STORED) - fields["work_external"]
    scale = max(float(np.max(np.abs(fields[name]))) for name in (*_STORED, "work_external"))
    scale = max(scale, least)
    return float(np.max(np.abs(balance - balance[0]))) / scale if scale > 0 else 0.0


REFERENCES = (
    "K. Kamrin and L. Mahadevan, Soft catenaries, J. Fluid Mech. (2012)",
    "J. A. E. Andersson et al., CasADi, Math. Prog. Comp. 11, 1-36 (2019)",
    "A. C. Hindmarsh et al., SUNDIALS, ACM Trans. Math. Softw. 31, 363-396 (2005)",
    "A. Meurer et al., SymPy, PeerJ Comput. Sci. 3, e103 (2017)",
)
_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")


def dataset_of(
    scene: Scene, effects: Effects, time: Floats, places: tuple[Floats, Floats], fields: Mapping[str, Floats]
) -> xr.Dataset:
    """Build the Dataset of ``trajectory.nc``."""
    nodes, cells = places
    variables = {
        v.name: (
            (("time", v.place) if v.place else ("time",)),
            fields[v.name],
            {"units": v.unit, "long_name": v.meaning},
        )
        for v in VARIABLES
        if v.name in fields
    }
    middle = fields["y"][:, fields["y"].shape[1] // 2]
    note = {"units": "m", "long_name": "height of the midpoint X = 0, negative down"}
    return xr.Dataset(
        {**variables, "midpoint": (("time",), middle, note)},
        coords={
            "time": ("time", time, {"units": "s", "long_name": "time"}),
            "X_node": ("node", nodes, {"units": "m", "long_name": "material coordinate of nodes"}),
            "X_cell": ("cell", cells, {"units": "m", "long_name": "material coordinate of cells"}),
        },
        attrs={
            "title": scene.title,
            "scene": scene.to_toml(),
            "effects": json.dumps(dict(effects.reasons)),
            "versions": json.dumps({name: importlib.metadata.version(name) for name in _VERSIONS}),
            "references": "; ".join(REFERENCES),
        },
    )
