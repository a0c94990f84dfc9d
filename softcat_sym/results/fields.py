"""Fields of a run over the whole span in SI units, with its energy audit."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any, Final, NamedTuple

import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.parameters import energy_scale, heat_unit
from softcat_sym.discretization.unknowns import (
    LOST_AT_EXIT,
    PLACES,
    TURN,
    WORK_OF_AGEING,
    WORK_OF_NOZZLE,
    Floats,
)
from softcat_sym.estimates.scaling import instant_modulus
from softcat_sym.scene.feed import exit_angle, extruded, nozzle_path
from softcat_sym.scene.natural_curve import has_shape
from softcat_sym.scene.scene import Scene, is_held, rest_length, undeformed_area
from softcat_sym.scene.tables import right_places
from softcat_sym.solvers.outcome import refused
from softcat_sym.solvers.solution import Solution
from softcat_sym.solvers.solve import Prepared


class Variable(NamedTuple):
    """One variable of ``trajectory.nc``."""

    dims: tuple[str, ...]
    unit: str  # Pint symbol
    meaning: str  # ``long_name`` in the file
    per_area: bool = False  # Whether the graph computes it per unit undeformed area


_NODE, _CELL, _FRAME = ("time", "node"), ("time", "cell"), ("time",)

VARIABLES: Final[Mapping[str, Variable]] = {
    "time": Variable(("time",), "s", "time"),
    "X_node": Variable(("node",), "m", "material coordinate of nodes"),
    "X_cell": Variable(("cell",), "m", "material coordinate of cells"),
    "x": Variable(_NODE, "m", "horizontal position of the centreline, 0 at midspan"),
    "y": Variable(_NODE, "m", "height of the centreline above the left support"),
    "z": Variable(_NODE, "m", "position of the centreline out of the plane of gravity and span"),
    "quaternion": Variable(
        ("time", "node", "component"), "1", "turn of the section from the axes x, y, z; scalar first"
    ),
    "structure": Variable(_CELL, "1", "structure parameter, mean over the section"),
    "backstress": Variable(_CELL, "Pa", "axial backstress, mean over the section"),
    "temperature": Variable(_NODE, "K", "temperature of the section"),
    "stretch": Variable(_CELL, "1", "stretch of the centreline"),
    "curvature": Variable(_CELL, "1/m", "curvature theta_s of the centreline, k/Lam of a filament that shears"),
    "curvature_2": Variable(_CELL, "1/m", "curvature k_2/Lam about the second axis of the section"),
    "twist": Variable(_CELL, "1/m", "twist k_1 of the section per material length"),
    "shear": Variable(_CELL, "1", "shear strain of the section"),
    "shear_3": Variable(_CELL, "1", "shear strain along the third axis of the section"),
    "tension": Variable(_CELL, "N", "tension T = A <sigma>", True),
    "axial_force": Variable(_CELL, "N", "force along the centreline, tension and surface tension", True),
    "moment": Variable(_CELL, "N*m", "bending moment M", True),
    "moment_2": Variable(_CELL, "N*m", "bending moment m_2 about the second axis of the section", True),
    "torque": Variable(_CELL, "N*m", "torque m_1 about the normal of the section", True),
    "shear_force_3": Variable(_CELL, "N", "transverse force along the third axis of the section", True),
    "shear_force": Variable(_CELL, "N", "transverse force N = M_X/s, A <tau> of a filament that shears", True),
    "yielded_fraction": Variable(_CELL, "1", "share of the section that flows"),
    "plastic_rate": Variable(_CELL, "1/s", "largest plastic strain rate over the section"),
    "thickness": Variable(_CELL, "m", "thickness of the section"),
    "stress_mean": Variable(_CELL, "Pa", "section mean sigma_0 of the axial stress"),
    "stress_bending": Variable(
        _CELL, "Pa", "sigma_1 = <sigma zeta>/<zeta^2>: the axial stress nearest to sigma_0 + sigma_1 zeta"
    ),
    "conformation_along": Variable(_CELL, "1", "section mean of the conformation of polymer chains along the fibres"),
    "conformation_across": Variable(_CELL, "1", "section mean of the conformation of polymer chains across the fibres"),
    "core_low": Variable(_CELL, "1", "zeta below which fibres yield, of a section resolved fibre by fibre"),
    "core_high": Variable(_CELL, "1", "zeta above which fibres yield, of a section resolved fibre by fibre"),
    "contact_pressure": Variable(_NODE, "N/m", "force of floor and pillars per rest length, along their normals"),
    "contact_length": Variable(_FRAME, "m", "rest length that lies on floor or pillars"),
    "contact_length_blur": Variable(_FRAME, "m", "length over which either end of a contact is blurred"),
    "contact_force": Variable(_FRAME, "N", "sum of the contact pressure"),
    "penetration_max": Variable(_FRAME, "m", "largest depth to which the filament sinks into floor or pillars"),
    "exposed": Variable(_CELL, "1", "share of the cell that has come out of the nozzle"),
    "age": Variable(
        _CELL,
        "s",
        "time since the middle of the cell came out of the nozzle; 0 before, and in the stub that of the run",
    ),
    "extruded_length": Variable(_FRAME, "m", "rest length that has come out of the nozzle"),
    "emplaced_length": Variable(_FRAME, "m", "length of the stub and of the path of the nozzle"),
    "nozzle_force_x": Variable(_FRAME, "N", "force of the nozzle on the strand to the right", True),
    "nozzle_force_y": Variable(_FRAME, "N", "force of the nozzle on the strand, upwards", True),
    "energy_kinetic": Variable(_FRAME, "J", "kinetic energy", True),
    "energy_elastic": Variable(_FRAME, "J", "elastic energy", True),
    "energy_surface": Variable(_FRAME, "J", "surface tension times the growth of the area since t = 0", True),
    "energy_potential": Variable(_FRAME, "J", "potential energy of the weight, 0 when straight", True),
    "energy_dissipated": Variable(_FRAME, "J", "plastic work since t = 0", True),
    "energy_gradient": Variable(_FRAME, "J", "work against the necking gradient since t = 0", True),
    "energy_softening": Variable(
        _FRAME, "J", "stored energy turned into heat, by softening and expansion, since t = 0", True
    ),
    "heat_stored": Variable(_FRAME, "J", "heat that the filament holds more than at t = 0", True),
    "heat_lost": Variable(_FRAME, "J", "heat given to the surroundings since t = 0", True),
    "work_external": Variable(_FRAME, "J", "work of the changing load since t = 0", True),
    WORK_OF_NOZZLE: Variable(_FRAME, "J", "work of the nozzle on the strand since t = 0", True),
    LOST_AT_EXIT: Variable(_FRAME, "J", "energy lost where fresh material is loaded at the exit, since t = 0", True),
    WORK_OF_AGEING: Variable(
        _FRAME, "J", "what a changing material gives to the energy stored at a strain that is held, since t = 0", True
    ),
    "midpoint": Variable(_FRAME, "m", "height of the midpoint X = 0, negative down"),
}

COORDINATES: Final = ("time", "X_node", "X_cell")

DENSE: Final = "dense_"
"""Begins the names of what is stored of the whole filament at more times than the frames."""

_MOST_DENSE: Final = 1000
"""Times from the beginning on, and as many over the whole run, at which it is."""
_ENERGY, _WORK, LOST = "energy_", "work_", "energy_dissipated_"
_OWN_POWERS = 3  # Plastic, of the load, of the necking gradient; then of the effects that dissipate
_ODD = frozenset({"x", "shear", "shear_force"})


def variable_of(name: str) -> Variable:
    """What a variable is: one above, the energy that the densities of an effect store or lose, or it at more times."""
    if name.startswith(DENSE):
        return variable_of(name.removeprefix(DENSE))._replace(dims=(f"{DENSE}time",))
    if name in VARIABLES or not name.startswith(_ENERGY):
        return VARIABLES[name]
    if name.startswith(LOST):
        return Variable(_FRAME, "J", f"dissipated by {name.removeprefix(LOST).replace('_', '-')} since t = 0", True)
    return Variable(_FRAME, "J", f"energy stored by {name.removeprefix(_ENERGY).replace('_', '-')} since t = 0", True)


def variables_of(names: Iterable[str]) -> dict[str, Variable]:
    """The variables among the names of fields, in the order of a file."""
    found = set(names)
    listed = [name for name in VARIABLES if name in found]
    more = [name for name in names if name not in listed and name.startswith((_ENERGY, DENSE))]
    return {name: variable_of(name) for name in (*listed, *more)}


def audit_of(names: Iterable[str]) -> dict[str, float]:
    """Names of all energies and works among those of fields, with their signs in the balance."""
    found = (name for name in variables_of(names) if name.startswith((_ENERGY, _WORK)))
    return {name: -1.0 if name.startswith(_WORK) else 1.0 for name in found}


def energy_label(name: str) -> str:
    """What a picture calls a column of the audit: ``surface``, ``external work``."""
    words = name.replace("_", " ").replace("dissipated ", "dissipated by ")
    return words.removeprefix("energy ") if name.startswith(_ENERGY) else f"{words.removeprefix('work ')} work"


def energies_of(names: Iterable[str]) -> tuple[str, ...]:
    """Names of the energies among those of fields: kinetic, stored and dissipated."""
    return tuple(name for name in names if name.startswith(_ENERGY))


def is_loss(name: str) -> bool:
    """Whether an energy is what was dissipated."""
    return name.startswith("energy_dissipated")


def is_odd(name: str) -> bool:
    """Whether a field changes its sign in the mirror image of a half."""
    return name in _ODD


def mirrored(name: str, values: Floats, unit: float = 1.0) -> Floats:
    """Whole-span field from its right half, in so many of its units."""
    sign, middle = -1.0 if is_odd(name) else 1.0, int(variable_of(name).dims == _NODE)
    left = values.shape[1] - middle
    whole = np.empty((len(values), left + values.shape[1]))
    np.multiply(values, unit, out=whole[:, left:])
    np.multiply(values[:, ::-1][:, :left], sign * unit, out=whole[:, :left])
    return whole


def midpoint_heights(graph: Graph, solution: Solution) -> Floats:
    """Height of X = 0 over the rest length, negative down."""
    return solution.row(graph.midpoint_row("y"))


def unknown_at(graph: Graph, solution: Solution, name: str, where: float) -> Floats:
    """An unknown of the nodes at X/L_0, shape (frames,); between nodes as a cubic through the four nearest has it."""
    kinds = np.array((*graph.differential.kinds, *graph.algebraic.kinds))
    rows = np.flatnonzero(kinds == name)
    places = np.concatenate([graph.differential.where, graph.algebraic.where])[rows]
    order = np.argsort(places)
    near, weights = cubic_weights(places[order], where)
    states = (solution.row(row) for row in rows[order][near])
    return np.asarray(sum(weight * state for weight, state in zip(weights, states, strict=True) if weight), dtype=float)


def cubic_weights(places: Floats, where: float) -> tuple[slice, Floats]:
    """Which of increasing places are the four nearest, and their weights in Lagrange's polynomial; one at a place."""
    first = int(np.clip(np.searchsorted(places, where) - 2, 0, max(0, len(places) - 4)))
    near = places[first : first + 4]
    apart = near[:, None] - near + np.eye(len(near))
    return slice(first, first + 4), np.prod((where - near + np.diag(near - where + 1)) / apart, axis=1)


def displacements(
    scene: Scene, time: Floats, fields: Mapping[str, Floats], nodes: Floats, graph: Graph | None = None
) -> Floats:
    """How far nodes are [m] from where they stand without load, shape (frames, nodes, axes).

    A filament that is straight between two supports stands on the line between them, wherever the right one is moved
    to, also if it hangs slack from them at the start; any other one is carried along by that motion. Without a graph
    it is loaded only after the start.
    """
    names = [name for name in PLACES if name in fields]
    places, share = np.stack([fields[name] for name in names], axis=-1), (nodes - nodes[0]) / (nodes[-1] - nodes[0])
    if scene.extrusion.present:
        return np.asarray(places - _as_laid(scene, time, nodes))
    unloaded = None if graph is None else _unloaded_places(scene, graph)
    stands = places[:1] if unloaded is None else unloaded
    right = np.array([(*place, 0.0)[: len(names)] for place in right_places(scene)])
    if is_held(scene) and not has_shape(scene) and not scene.initial.centreline:
        stands = share[:, None] * right[0] - np.eye(len(names))[0] * scene.filament.span / 2
    when = [0.0, *(row[0] for row in scene.ends.motion)]
    moved = np.stack([np.interp(time, when, path - path[0]) for path in right.T], axis=-1)
    return np.asarray(places - stands - share[:, None] * moved[:, None, :])


def _as_laid(scene: Scene, time: Floats, nodes: Floats) -> Floats:
    """Places of the nodes of a weightless strand: in the nozzle, or on the chord to it; from a free end in its line."""
    rows, from_left = np.array(nozzle_path(scene)), nodes - nodes[0]
    tip = np.stack([np.interp(time, rows[:, 0], rows[:, way]) for way in (1, 2)], axis=-1)[:, None, :]
    out = np.array([extruded(scene, float(now)) for now in time])[:, None, None]
    angle, held = exit_angle(scene), not scene.ends.supports[0].is_free
    beyond = (from_left[:, None] - out) * np.array([math.cos(angle), math.sin(angle)])
    chord = tip * (from_left[:, None] / out) if held else tip + beyond
    straight = np.where(from_left[:, None] < out, chord, tip + beyond)
    return np.asarray(straight - np.array([scene.filament.span / 2, 0.0]))


_CARRIED, _TURNED, _ROUNDED = 1e-3, 1e-2, 1e-12
"""Of how far a node travels, whatever carries it along, of how far its surface turns, and of a span."""


def least_displacement(scene: Scene, fields: Mapping[str, Floats]) -> float:
    """Displacement [m] that is as good as none, of what is only carried along, or turned about itself."""
    places = [fields[name] for name in PLACES if name in fields]
    if scene.extrusion.present:
        return _ROUNDED * scene.filament.span
    travelled = float(np.sqrt(np.max(sum((each - each[0]) ** 2 for each in places))))
    turned = float(np.max(turn_of(fields))) * scene.filament.thickness / 2 if "quaternion" in fields else 0.0
    return max(_ROUNDED * scene.filament.span, _CARRIED * travelled, _TURNED * turned)


def turn_of(fields: Mapping[str, Floats]) -> Floats:
    """How far sections have turned since the start: 2 |q - q_0|, the angle if it is small, and 4 after a whole turn."""
    q = fields["quaternion"]
    return np.asarray(2 * np.sqrt(np.sum((q - q[:1]) ** 2, axis=-1)))


def _unloaded_places(scene: Scene, graph: Graph) -> Floats | None:
    """Places of the nodes without load [m]; None of a filament that starts there, and of one on its chord."""
    if not graph.positions_are_algebraic or (is_held(scene) and not has_shape(scene)):
        return None
    # Imported here, as a run in a plane does not need SciPy, which takes half a second to load.
    from softcat_sym.solvers.spatial_start import natural_shape

    shape, axes = natural_shape(scene, graph), PLACES if "z" in graph.algebraic.kinds else PLACES[:2]
    nodes = range(len(graph.grid.nodes))
    return np.array([[shape[axis, node] for axis in axes] for node in nodes]) * rest_length(scene)


def whole_span_fields(scene: Scene, prepared: Prepared, solution: Solution, *, along: bool = True) -> dict[str, Floats]:
    """Every variable of the trajectory that this theory has, whole span, whole filament; or none `along` it."""
    graph, span, solution = prepared.graph, rest_length(scene), solution.whole
    observed = prepared.observe(solution)
    unit = energy_scale(scene.filament.density, span, prepared.scale) * span
    plastic, load, gradient, *lost = solution.quad * unit
    if "q0" in observed:
        observed["quaternion"] = np.stack([observed.pop(name) for name in TURN], axis=-1)
    if "o1" not in (*graph.differential.kinds, *graph.algebraic.kinds):
        # Turns that are algebraic have no rate that a quadrature could use: the work is summed over frames.
        load = load + _work_of_torque(scene, observed)
    observed["energy_dissipated"], observed["work_external"] = plastic[:, None], load[:, None]
    for name, loss in zip(graph.powers[_OWN_POWERS:], lost, strict=True):
        observed[name if name in VARIABLES else f"{LOST}{name}"] = loss[:, None]
    if "heat_stored" in observed:
        heat = scene.temperature
        lost_unit = heat_unit(scene.filament.density, heat.heat_capacity or 0.0, heat.initial or 0.0)  # [J/m^3]
        observed["heat_lost"] = observed.get("heat_lost", 0 * plastic[:, None]) * lost_unit * span / unit
    against_gradient = gradient
    if not graph.has_velocities:
        # Positions that are algebraic have no velocity that a quadrature could use: the work is summed over frames.
        change, force = np.diff(np.diff(observed["stretch"], axis=1), axis=0), observed["double_force"]
        steps = np.sum((force[1:] + force[:-1]) / 2 * change, axis=1) * span
        against_gradient = np.concatenate([[0.0], np.cumsum(steps)])
    observed["energy_gradient"] = against_gradient[:, None]
    added = [name for name in energies_of(observed) if name not in VARIABLES]
    for name in ("energy_surface", *added):
        observed[name] = observed[name] - observed[name][:1]
    observed["thickness"] = observed["relative_thickness"] * scene.filament.thickness
    area, halves = undeformed_area(scene), 2.0 if graph.grid.is_half else 1.0
    fields = {}
    for name in (*VARIABLES, *added):
        variable = variable_of(name)
        if name not in observed or not (along or variable.dims == _FRAME):
            continue
        values, unit = observed[name], area if variable.per_area else 1.0
        if variable.dims == _FRAME:
            fields[name] = values[:, 0] * (unit * halves)
        else:
            fields[name] = mirrored(name, values, unit) if graph.grid.is_half else values * unit
    return fields


def dense_fields(scene: Scene, prepared: Prepared, solution: Solution) -> dict[str, Floats]:
    """Midpoint and energies at the output times between frames, of what swings faster than these show."""
    count = len(solution.time)
    first, every = np.arange(min(count, _MOST_DENSE)), np.arange(0, count, -(-count // _MOST_DENSE))
    some = solution.only(np.union1d(first, np.append(every, count - 1)).tolist())
    midpoint = midpoint_heights(prepared.graph, some) * rest_length(scene)
    dense = {"time": some.time * prepared.scale, "midpoint": midpoint}
    dense |= whole_span_fields(scene, prepared, some, along=False)
    return {f"{DENSE}{name}": values for name, values in dense.items()}


def _work_of_torque(scene: Scene, observed: Mapping[str, Floats]) -> Floats | float:
    """Work of the dead torque on the free end per undeformed area: a turn has no potential."""
    if not any(scene.load.tip_torque):
        return 0.0
    # Imported here: a run in its plane does without SciPy, which takes half a second to load.
    from scipy.spatial.transform import Rotation

    turns = Rotation.from_quat(np.roll(observed["quaternion"][:, -1], -1, axis=1))
    steps = (turns[1:] * turns[:-1].inv()).as_rotvec()
    work = np.concatenate([[0.0], np.cumsum(steps @ np.array(scene.load.tip_torque))])
    return np.asarray(work / undeformed_area(scene))


def node_positions(graph: Graph, span: float) -> tuple[Floats, Floats]:
    """Material coordinates [m] of nodes and cells over the whole span, X = 0 at midspan."""
    nodes, cells = graph.grid.nodes * span, graph.grid.centres * span
    if not graph.grid.is_half:
        return nodes, cells
    return np.concatenate([-nodes[:0:-1], nodes]), np.concatenate([-cells[::-1], cells])


def min_energy(scene: Scene) -> float:
    """Elastic energy of the whole filament at a strain of a millionth [J]: below it there is nothing to audit."""
    modulus = instant_modulus(scene) or 0.0
    return modulus * undeformed_area(scene) * rest_length(scene) * 1e-6**2


def energy_imbalance(fields: Mapping[str, Floats]) -> tuple[Floats, float]:
    """Sum of all energies less the works, less its first value; and the largest of them all."""
    values = {name: np.asarray(fields[name], dtype=float) for name in audit_of(fields)}
    total = np.sum([sign * values[name] for name, sign in audit_of(fields).items()], axis=0)
    return total - total[0], max(float(np.abs(value).max()) for value in values.values())


def energy_residual(fields: Mapping[str, Floats], least: float = 0.0) -> float:
    """Largest imbalance over the run, relative to the largest energy in it; of a filament with heat also of that."""
    imbalance, largest = energy_imbalance(fields)
    scale = max(largest, least)
    mechanical = float(np.max(np.abs(imbalance))) / scale if scale > 0 else 0.0
    return max(mechanical, heat_residual(fields))


_MADE: Final = ("energy_dissipated", "energy_softening")
"""Energies that turn into heat of the filament; what drag dissipates heats the surroundings."""


def heat_residual(fields: Mapping[str, Floats]) -> float:
    """Heat that is held and given away, less what was made of energy: largest over the run, over the largest of all."""
    if "heat_stored" not in fields:
        return 0.0
    signs = dict.fromkeys(("heat_stored", "heat_lost"), 1.0) | dict.fromkeys(_MADE, -1.0)
    values = {name: sign * np.asarray(fields[name], dtype=float) for name, sign in signs.items() if name in fields}
    imbalance = np.sum(list(values.values()), axis=0)
    scale = max(float(np.abs(value).max()) for value in values.values())
    return float(np.max(np.abs(imbalance - imbalance[0]))) / scale if scale > 0 else 0.0


def midpoint_table(data: Mapping[Any, Any], summary: Mapping[str, Any]) -> dict[str, Iterable[object]]:
    """Columns of ``midpoint.csv``; what is refused says so in every row."""
    times, outcome = np.asarray(data["time"], dtype=float), refused(summary)
    stamped = {"refused": [outcome] * len(times)} if outcome else {}
    return {"time_s": times, "midpoint_m": np.asarray(data["midpoint"], dtype=float), **stamped}
