"""The raw solution becomes fields over the whole span, in SI units."""

from __future__ import annotations

import numpy as np

from softcat_sym.effects.prediction import instant_modulus
from softcat_sym.graph import Graph, energy_scale
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, rest_length, undeformed_area
from softcat_sym.solve import Prepared, Solution
from softcat_sym.trajectory.mirror import mirrored
from softcat_sym.trajectory.variables import ENERGIES, VARIABLES

_NO_STRAIN = 1e-6


def whole_span_fields(scene: Scene, prepared: Prepared, solution: Solution) -> dict[str, Floats]:
    """Every variable of the trajectory that this theory has, whole span, whole filament.

    Returns
    -------
    dict of str to ndarray
        (frames, nodes), (frames, cells) or (frames,).
    """
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


def least_energy(scene: Scene) -> float:
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
