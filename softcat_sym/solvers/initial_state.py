"""Initial state of a run: at rest, straight or in the elastic shape that the ends impose, and stable."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats, Layout
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.extrusion import nozzle_path, stub_length
from softcat_sym.scene.natural_curve import is_curved
from softcat_sym.scene.scene import (
    Scene,
    distance,
    force_free_stretch,
    is_held,
    is_slack,
    is_turned,
    rest_length,
    straight_angle,
    stress_free_length,
)
from softcat_sym.solvers.continuation import balanced
from softcat_sym.solvers.start import Newton, Start, with_plastic_strain

_POSITIONS = ("x", "y", "psi")


def starting_state(
    scene: Scene, graph: Graph, p: Floats, statics: Callable[[], Graph] | None, newton: Newton | None = None
) -> Start | None:
    """Initial state at rest; None if no equilibrium is found."""
    if is_spatial(scene):
        # Imported here, as a run in a plane does not need SciPy, which takes half a second to load.
        from softcat_sym.solvers.spatial_start import spatial_start

        return spatial_start(scene, graph, p, statics, newton or _interpreted_newton())
    x = with_plastic_strain(_with_positions(graph.differential, scene), graph, scene, 1.0)
    straight = _with_positions(graph.algebraic, scene)
    if graph.positions_are_algebraic:
        z = balanced(scene, graph, p, straight, newton, is_straight=is_straight(scene))
        return None if z is None else Start(x, z)
    if not is_straight(scene):
        rest = statics() if statics is not None else graph
        shape = _shape_at_rest(scene, graph, rest, p, newton)
        if shape is None:
            return None
        x, straight = _moved(x, graph.differential, rest, shape), _moved(straight, graph.algebraic, rest, shape)
    if not graph.is_dae:
        return Start(x, straight)
    found = newton(graph, x, p, straight) if newton is not None else None
    if found is None:
        found = _interpreted_newton()(graph, x, p, straight)
    return None if found is None else Start(x, found)


def _shape_at_rest(scene: Scene, graph: Graph, rest: Graph, p: Floats, newton: Newton | None) -> Floats | None:
    """Positions in equilibrium of an initially bent or stretched filament; without weight, unless it is slack."""
    if not rest.positions_are_algebraic:
        return None
    values = dict(zip(graph.parameters, p.tolist(), strict=True))
    values["gravity"] = values["gravity"] if is_slack(scene) else 0.0
    constants = np.array([values[name] for name in rest.parameters])
    straight = _with_positions(rest.algebraic, scene)
    return balanced(scene, rest, constants, straight, newton, is_straight=False)


def _interpreted_newton() -> Newton:
    # Imported here, as compiled runs do not need CasADi.
    from softcat_sym.solvers.equilibrium import newton_of_graph

    return newton_of_graph


def is_straight(scene: Scene) -> bool:
    """Whether the straight filament between the ends is in equilibrium without weight."""
    initial, held = scene.initial, is_held(scene)
    # A Newtonian fluid has no elastic stress after stretching.
    pulled = held and scene.material.spec.is_elastic and not scene.extrusion.present
    pulled = pulled and not math.isclose(stress_free_length(scene), distance(scene), rel_tol=1e-12)
    gives = any(support.has_springs for support in scene.ends.supports)
    uneven = len(set(initial.P)) > 1 or (pulled and (gives or bool(scene.filament.profile)))
    bent = is_curved(scene) or any(initial.C) or bool(initial.centreline)
    return not ((is_turned(scene) and held) or is_slack(scene) or uneven or bent)


def _with_positions(layout: Layout, scene: Scene) -> Floats:
    """The state of the straight filament: along the chord, or from its only support in its direction."""
    ends, filament, where = scene.ends, scene.filament, layout.where
    length, along = rest_length(scene), straight_angle(scene)
    run, fall = filament.span / length, ends.drop / length
    grown = force_free_stretch(scene)
    middle, left, drop = 0.0, -run / 2, fall
    if not is_held(scene):
        from_left = ends.supports[1].is_free
        run, fall = grown * math.cos(along), -grown * math.sin(along)
        middle, drop = (left + run / 2, fall) if from_left else (-left - run / 2, 2 * drop - fall)
    if scene.extrusion.present:
        place = nozzle_path(scene)[0][1:]
        out = stub_length(scene) / length - 0.5
        run, fall, drop = math.cos(along), -math.sin(along), 0.0
        middle, drop = left + place[0] / length - run * out, -2 * (place[1] / length + fall * out)
    lines = {"x": middle + run * where, "y": -drop / 2 - fall * where, "psi": np.full(len(where), along)}
    result, names = np.array(layout.start, dtype=float), np.array(layout.kinds)
    for name, line in lines.items():
        result[names == name] = line[names == name]
    return result


def _moved(state: Floats, layout: Layout, rest: Graph, shape: Floats) -> Floats:
    """The state with the positions and angles of a shape at rest."""
    known = dict(zip(_kinds_and_places(rest.algebraic), shape, strict=True))
    old = zip(_kinds_and_places(layout), state, strict=True)
    return np.array([known.get(one, value) if one[0] in _POSITIONS else value for one, value in old])


def _kinds_and_places(layout: Layout) -> list[tuple[str, float]]:
    return [(kind, round(at, 12)) for kind, at in zip(layout.kinds, layout.where.tolist(), strict=True)]
