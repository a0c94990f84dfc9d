"""Initial state of a run: at rest, straight or in the elastic shape that the ends impose, and stable."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.supports import DROP, LEFT_ANGLE, RIGHT_ANGLE, SPAN
from softcat_sym.discretization.unknowns import Floats, Layout
from softcat_sym.estimates.scaling import elastic_sag
from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.feed import nozzle_path, stub_length
from softcat_sym.scene.natural_curve import is_curved
from softcat_sym.scene.scene import (
    Scene,
    chord_angle,
    distance,
    force_free_stretch,
    is_held,
    is_slack,
    is_turned,
    rest_length,
    straight_angle,
    stress_free_length,
)
from softcat_sym.solvers.solution import Newton, Start, with_plastic_strain

# A compiled run in a plane needs neither CasADi nor SciPy, which takes half a second to load.
with lazy_imports():
    from softcat_sym.solvers import equilibrium, spatial_start

_POSITIONS = ("x", "y", "psi")


def starting_state(
    scene: Scene, graph: Graph, p: Floats, statics: Callable[[], Graph] | None, newton: Newton | None = None
) -> Start | None:
    """Initial state at rest; None if no equilibrium is found."""
    if is_spatial(scene):
        return spatial_start.spatial_start(scene, graph, p, statics, newton or equilibrium.newton_of_graph)
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
        found = equilibrium.newton_of_graph(graph, x, p, straight)
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


_MAX_STEP, _MIN_STEP = 0.25, 1 / 512  # Steps of a continuation from 0 to 1


Search = Callable[[Floats, Floats, Iterable[Floats]], Floats | None]
"""Equilibrium at t = 0 of plastic states and parameters, from the first guess that leads to one by Newton's method."""


def balanced(
    scene: Scene, graph: Graph, p: Floats, straight: Floats, newton: Newton | None, *, is_straight: bool
) -> Floats | None:
    """Algebraic positions in equilibrium at t = 0: in C if it converges, otherwise by CasADi, which passes folds."""
    if newton is not None and graph.terms.bending and not is_slack(scene):

        def in_c(x: Floats, constants: Floats, guesses: Iterable[Floats]) -> Floats | None:
            return next((z for guess in guesses if (z := newton(graph, x, constants, guess)) is not None), None)

        z = _balanced(_Stage(scene, graph, p, in_c, passes_folds=False), straight, is_straight=is_straight)
        if z is not None:
            return z
    search = partial(equilibrium.Equilibrium(graph).search, 0.0)
    return _balanced(_Stage(scene, graph, p, search, passes_folds=True), straight, is_straight=is_straight)


def _balanced(heavy: _Stage, straight: Floats, *, is_straight: bool) -> Floats | None:
    """Algebraic positions in equilibrium, by continuation if the straight filament is not in equilibrium.

    The first continuation has the whole weight; if it fails, the second one starts without weight. It needs bending, as
    a string without weight has no stiffness.
    """
    scene, graph, bends = heavy.scene, heavy.graph, heavy.graph.terms.bending
    if is_straight:
        x = with_plastic_strain(graph.start, graph, scene, 1.0)
        z = heavy.search(x, heavy.p, sagging_guesses(graph, straight, elastic_sag(scene)))
    else:
        z = _followed(heavy, straight)
    if z is None and bends:
        z = _followed(replace(heavy, weightless=True), straight)
    if z is None or not bends or not is_slack(scene) or not graph.conserves_energy:
        return z
    # The straight equilibrium of a compressed bar may be unstable.
    x, constants = heavy.at(1.0)
    return heavy.search(x, constants, [equilibrium.settled(graph, x, constants, z, straight)])


def sagging_guesses(graph: Graph, straight: Floats, sag: float) -> list[Floats]:
    """Parabolas with sags about the expected one (over span), and the straight filament."""
    parabola = np.where(np.isin(graph.algebraic.kinds, "y"), -(1 - 4 * graph.algebraic.where**2), 0.0)
    return [straight + depth * parabola for depth in (sag, sag / 4, 0.0, 3 * sag)]


def _followed(stage: _Stage, straight: Floats) -> Floats | None:
    """Equilibrium at the end of a continuation; None if the continuation fails."""
    graph = stage.graph
    falls = graph.terms.bending and graph.conserves_energy and stage.passes_folds
    apart = np.where(np.isin(graph.algebraic.kinds, ("x", "y")), straight * stage.apart, straight)
    guesses = sagging_guesses(graph, apart, elastic_sag(stage.scene))
    z = stage.find(0.0, guesses[::-1] if stage.weightless else guesses)
    reached, step, slope = 0.0, _MAX_STEP, np.zeros_like(straight)
    while z is not None and reached < 1.0:
        further = stage.find(min(1.0, reached + step), [z + step * slope, z])
        if further is not None:
            now = min(1.0, reached + step)
            z, slope, reached, step = further, (further - z) / (now - reached), now, min(2 * step, _MAX_STEP)
        elif step >= _MIN_STEP:
            step /= 2
        elif falls:
            # The branch ends at a fold, as for an arch that is too heavy: the filament snaps to a lower equilibrium.
            reached, step, slope = min(1.0, reached + _MIN_STEP), _MAX_STEP, np.zeros_like(z)
            x, constants = stage.at(reached)
            z = stage.find(reached, [equilibrium.snapped(graph, 0.0, x, constants, z)])
        else:
            return None
    return z


@dataclass(frozen=True)
class _Stage:
    """Parameters and plastic state between those of a straight filament (0) and those of the scene (1)."""

    scene: Scene
    graph: Graph
    p: Floats
    search: Search
    passes_folds: bool  # Whether it may leave a branch of equilibria that ends
    weightless: bool = False

    @property
    def apart(self) -> float:
        """Distance of the ends at which the filament is straight, over the scene's."""
        return rest_length(self.scene) / distance(self.scene) if is_slack(self.scene) else 1.0

    def at(self, share: float) -> tuple[Floats, Floats]:
        """Plastic state and parameters."""
        begins = {"curvature": 0.0}
        if is_held(self.scene):
            # A filament with a free end has the direction of its clamp from the beginning.
            begins |= dict.fromkeys((LEFT_ANGLE, RIGHT_ANGLE), chord_angle(self.scene))
        values = dict(zip(self.graph.parameters, self.p.tolist(), strict=True))
        if self.weightless:
            begins["gravity"] = 0.0
        # A level clamp has no parameter, and is not rotated.
        begins |= {name: values.get(name, 0.0) * self.apart for name in (SPAN, DROP)}
        mixed = {name: share * value + (1 - share) * begins.get(name, value) for name, value in values.items()}
        x = with_plastic_strain(self.graph.start, self.graph, self.scene, share)
        return x, np.array([mixed[name] for name in self.graph.parameters])

    def find(self, share: float, guesses: list[Floats]) -> Floats | None:
        """Equilibrium at a share; for a string without bending only one in tension."""
        x, constants = self.at(share)
        for guess in guesses:
            z = self.search(x, constants, [guess])
            if z is None:
                continue
            if self.graph.terms.bending:
                return z
            observed = self.graph.symbolic.observables(time=0.0, state=x, algebraic=z, parameters=constants)
            if float(np.min(np.asarray(observed["tension"]))) >= 0:
                return z
        return None
