"""Initial state of a filament in three dimensions: natural shape, straight between its ends, or on a given curve."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.interpolate import make_interp_spline
from scipy.spatial.transform import Rotation

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.natural_shape import shaped
from softcat_sym.discretization.supports import LEFT_ANGLE, RIGHT_ANGLE, TIP_FORCE, TIP_TORQUE
from softcat_sym.discretization.unknowns import PLACES, TURN, Floats, Layout
from softcat_sym.scene.natural_curve import carried, continuous, has_shape, is_curved
from softcat_sym.scene.scene import (
    Scene,
    chord_angle,
    distance,
    force_free_stretch,
    is_held,
    is_turned,
    rest_length,
    straight_angle,
    stress_free_length,
)
from softcat_sym.solvers.solution import Newton, Start, with_plastic_strain

_LEAST = 1 / 4096
"""Smallest step of a continuation, as a share of the load."""
_LOADS = ("gravity", *TIP_FORCE, *TIP_TORQUE)
_GROWING = (*_LOADS, LEFT_ANGLE, RIGHT_ANGLE, "curvature", "twist")
"""Parameters that grow in a continuation; for a filament held at both ends also its angles and curvatures."""


def spatial_start(
    scene: Scene, graph: Graph, p: Floats, statics: Callable[[], Graph] | None, newton: Newton
) -> Start | None:
    """Initial state at rest; None if no equilibrium is found.

    A stressed shape is computed with a section of few points, which suffices before any flow; the small remaining
    difference is solved with the section of the run.
    """
    shape = natural_shape(scene, graph)
    if graph.positions_are_algebraic or (is_held(scene) and _is_forced(scene)):
        rest = statics() if statics is not None else graph
        if not rest.positions_are_algebraic:
            return None
        values = dict(zip(graph.parameters, p.tolist(), strict=True))
        if not graph.positions_are_algebraic:
            values["gravity"] = 0.0
        constants = np.array([values[name] for name in rest.parameters])
        straight = _placed(rest.algebraic, shape)
        guess = Start(with_plastic_strain(rest.start, rest, scene, 1.0), straight)
        bent = _loaded(newton, rest, guess, constants, _GROWING if is_held(scene) else _LOADS)
        if bent is None:
            return None
        found = zip(rest.algebraic.unknowns, bent, strict=True)
        shape = {**shape, **{unknown: float(value) for unknown, value in found if unknown in shape}}
    x = with_plastic_strain(_placed(graph.differential, shape), graph, scene, 1.0)
    start = Start(x, _placed(graph.algebraic, shape))
    if not graph.is_dae:
        return start
    settled = newton(graph, start.x, p, start.z)
    return None if settled is None else Start(x, settled)


Shape = dict[tuple[str, int], float]
"""Positions and quaternions of the nodes, by name and number."""


def natural_shape(scene: Scene, graph: Graph) -> Shape:
    """Shape without load: straight between two held ends; with one held end, by natural twist and curvature.

    The latter is integrated node by node with the rotation at the middle of each cell, so that no cell is strained. The
    scene's shape or centreline has priority.
    """
    nodes, grown = graph.grid.nodes, force_free_stretch(scene)
    ends, filament, length = scene.ends, scene.filament, rest_length(scene)
    run, fall = filament.span / length, ends.drop / length
    if has_shape(scene):
        places, turns, _ = shaped(scene, nodes)
        places += np.array([-run / 2, 0.0, 0.0])
    elif scene.initial.centreline:
        places, turns = _given(scene, nodes)
        places += np.array([-run / 2, 0.0, 0.0])
    elif is_held(scene):
        along = chord_angle(scene)
        places = np.column_stack([run * nodes, -fall / 2 - fall * nodes, 0 * nodes])
        turns = np.tile(_in_plane(along), (len(nodes), 1))
    else:
        from_left = ends.supports[1].is_free
        # Without stress, Lam^-3/2 kappa is the natural curvature.
        kappa = np.array([filament.twist, 0.0, filament.curvature]) * grown**1.5 * length
        places, turns = _integrated(nodes, kappa, grown, straight_angle(scene), from_left)
        places += np.array([-run / 2, 0.0, 0.0]) if from_left else np.array([run / 2, -fall, 0.0])
    found = {(name, n): float(value) for k, name in enumerate(PLACES) for n, value in enumerate(places[:, k])}
    return found | {(name, n): float(value) for k, name in enumerate(TURN) for n, value in enumerate(turns[:, k])}


def _given(scene: Scene, nodes: Floats) -> tuple[Floats, Floats]:
    """Positions over the rest length on the scene's curve, and sections perpendicular to it without twist."""
    points = np.array(scene.initial.centreline) / rest_length(scene)
    curve = make_interp_spline(np.linspace(-0.5, 0.5, len(points)), points, k=min(3, len(points) - 1))
    first = Rotation.from_euler("z", scene.ends.left_angle)
    return curve(nodes), continuous(carried(first, curve(nodes, 1)))


def _integrated(nodes: Floats, kappa: Floats, stretch: float, angle: float, from_left: bool) -> tuple[Floats, Floats]:
    """Positions and quaternions of a curve of constant twist and curvature, from the held end."""
    held = 0 if from_left else -1
    start, along = Rotation.from_euler("z", angle), nodes - nodes[held]
    middle = start * Rotation.from_rotvec(np.outer((along[1:] + along[:-1]) / 2, kappa))
    steps = stretch * np.diff(nodes)[:, None] * middle.apply([1.0, 0.0, 0.0])
    places = np.vstack([np.zeros(3), np.cumsum(steps, axis=0)])
    turns = continuous(start * Rotation.from_rotvec(np.outer(along, kappa)))
    return places - places[held], turns * np.sign(turns[held] @ _in_plane(angle))


def _in_plane(angle: float) -> Floats:
    """Quaternion of a turn in the plane."""
    return np.array([math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2)])


def _placed(layout: Layout, shape: Shape) -> Floats:
    return np.array([shape.get(one, value) for one, value in zip(layout.unknowns, layout.start, strict=True)])


def _is_forced(scene: Scene) -> bool:
    """Whether the straight filament between its ends is stressed without weight, so that its shape must be solved."""
    gives = any(support.has_springs for support in scene.ends.supports)
    pulled = gives and not math.isclose(stress_free_length(scene), distance(scene), rel_tol=1e-12)
    bent = not has_shape(scene) and (is_turned(scene) or is_curved(scene) or pulled)
    return not scene.initial.centreline and (bent or len(set(scene.initial.P)) > 1)


def _loaded(newton: Newton, graph: Graph, guess: Start, p: Floats, named: tuple[str, ...]) -> Floats | None:
    """Equilibrium under growing parameters, from an equilibrium at zero values of these."""
    reached, step, z = 0.0, 1.0, guess.z
    grows = np.array([name in named for name in graph.parameters])
    while reached < 1.0:
        share = min(1.0, reached + step)
        found = newton(graph, guess.x, np.where(grows, share * p, p), z)
        if found is None:
            step /= 4
            if step < _LEAST:
                return None
            continue
        z, reached, step = found, share, 2 * step
    return z
