"""Continuation of equilibria from the straight filament to the scene's."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.supports import DROP, LEFT_ANGLE, RIGHT_ANGLE, SPAN
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.estimates.scaling import elastic_sag
from softcat_sym.scene.scene import Scene, chord_angle, distance, is_held, is_slack, rest_length
from softcat_sym.solvers.start import Newton, with_plastic_strain

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
    # Imported here, as equilibria in C do not need CasADi.
    from softcat_sym.solvers.equilibrium import Equilibrium

    search = partial(Equilibrium(graph).search, 0.0)
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
    from softcat_sym.solvers.settling import settled

    x, constants = heavy.at(1.0)
    return heavy.search(x, constants, [settled(graph, x, constants, z, straight)])


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
            from softcat_sym.solvers.settling import snapped

            reached, step, slope = min(1.0, reached + _MIN_STEP), _MAX_STEP, np.zeros_like(z)
            x, constants = stage.at(reached)
            z = stage.find(reached, [snapped(graph, 0.0, x, constants, z)])
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
