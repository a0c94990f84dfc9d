"""Equilibria that are not straight, followed from the straight filament."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.supports import DROP, LEFT_ANGLE, RIGHT_ANGLE, SPAN
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.scaling_estimates import elastic_sag
from softcat_sym.scene.scene import Scene, chord_angle, distance, is_held, is_slack, rest_length
from softcat_sym.solvers.start import Newton, with_plastic_strain

_MAX_STEP, _MIN_STEP = 0.25, 1 / 512  # of a continuation


class Search(Protocol):
    """Newton's method from several guesses."""

    def search(self, time: float, x: Floats, p: Floats, guesses: Iterable[Floats]) -> Floats | None:
        """Equilibrium reached from the first guess that leads to one; None if none does."""
        ...


@dataclass(frozen=True)
class _InC:
    """Newton's method in C, at t = 0."""

    graph: Graph
    newton: Newton

    def search(self, time: float, x: Floats, p: Floats, guesses: Iterable[Floats]) -> Floats | None:
        """As of `Search`."""
        del time
        return next((z for guess in guesses if (z := self.newton(self.graph, x, p, guess)) is not None), None)


def balanced(
    scene: Scene, graph: Graph, p: Floats, straight: Floats, newton: Newton | None, *, is_straight: bool
) -> Floats | None:
    """Algebraic positions in equilibrium at t = 0: in C if that leads there, else by CasADi, which knows folds, too."""
    if newton is not None and graph.terms.bending and not is_slack(scene):
        z = _balanced(scene, graph, p, straight, _InC(graph, newton), is_straight=is_straight)
        if z is not None:
            return z
    # Imported here: what is found in C does without CasADi.
    from softcat_sym.solvers.equilibrium import Equilibrium

    return _balanced(scene, graph, p, straight, Equilibrium(graph), is_straight=is_straight)


def _balanced(
    scene: Scene, graph: Graph, p: Floats, straight: Floats, equilibrium: Search, *, is_straight: bool
) -> Floats | None:
    """Algebraic positions in equilibrium, followed from the straight filament where that is not one.

    With its weight from the beginning; if that leads nowhere, with a weight that grows, which needs bending: a string
    without weight has no stiffness.
    """
    bends = graph.terms.bending
    heavy = _Stage(scene, graph, p, weightless=False)
    if is_straight:
        x = with_plastic_strain(graph.start, graph, scene, 1.0)
        z = equilibrium.search(0.0, x, p, sagging_guesses(graph, straight, elastic_sag(scene)))
    else:
        z = _followed(heavy, equilibrium, straight)
    if z is None and bends:
        z = _followed(_Stage(scene, graph, p, weightless=True), equilibrium, straight)
    if z is None or not bends or not is_slack(scene) or not graph.conserves_energy:
        return z
    # A bar that its supports push together is in equilibrium while straight, but not at rest.
    from softcat_sym.solvers.settling import settled

    x, constants = heavy.at(1.0)
    return equilibrium.search(0.0, x, constants, [settled(graph, x, constants, z, straight)])


def sagging_guesses(graph: Graph, straight: Floats, sag: float) -> list[Floats]:
    """Parabolas around the sag (over span) expected, and the straight filament."""
    parabola = np.where(np.isin(graph.z_kinds, "y"), -(1 - 4 * graph.z_where**2), 0.0)
    return [straight + depth * parabola for depth in (sag, sag / 4, 0.0, 3 * sag)]


def _followed(stage: _Stage, equilibrium: Search, straight: Floats) -> Floats | None:
    """Equilibrium at the end of a continuation, or None where it breaks off."""
    graph = stage.graph
    falls = graph.terms.bending and graph.conserves_energy and not isinstance(equilibrium, _InC)
    apart = np.where(np.isin(graph.z_kinds, ("x", "y")), straight * stage.apart, straight)
    guesses = sagging_guesses(graph, apart, elastic_sag(stage.scene))
    z = stage.search(equilibrium, 0.0, guesses[::-1] if stage.weightless else guesses)
    reached, step, slope = 0.0, _MAX_STEP, np.zeros_like(straight)
    while z is not None and reached < 1.0:
        further = stage.search(equilibrium, min(1.0, reached + step), [z + step * slope, z])
        if further is not None:
            now = min(1.0, reached + step)
            z, slope, reached, step = further, (further - z) / (now - reached), now, min(2 * step, _MAX_STEP)
        elif step >= _MIN_STEP:
            step /= 2
        elif falls:
            # The branch ends at a fold, as of an arch too heavy to stand: the filament snaps into what lies below.
            from softcat_sym.solvers.settling import snapped

            reached, step, slope = min(1.0, reached + _MIN_STEP), _MAX_STEP, np.zeros_like(z)
            x, constants = stage.at(reached)
            z = stage.search(equilibrium, reached, [snapped(graph, 0.0, x, constants, z)])
        else:
            return None
    return z


@dataclass(frozen=True)
class _Stage:
    """Parameters and plastic state between those of a straight filament (0) and those of the scene (1)."""

    scene: Scene
    graph: Graph
    p: Floats
    weightless: bool

    @property
    def apart(self) -> float:
        """Distance at which the filament is straight, over the one requested."""
        return rest_length(self.scene) / distance(self.scene) if is_slack(self.scene) else 1.0

    def at(self, share: float) -> tuple[Floats, Floats]:
        """Plastic state and parameters."""
        begins = {"curvature": 0.0}
        if is_held(self.scene):
            # A filament with a free end points from the beginning where its clamp does.
            begins |= dict.fromkeys((LEFT_ANGLE, RIGHT_ANGLE), chord_angle(self.scene))
        values = dict(zip(self.graph.parameters, self.p.tolist(), strict=True))
        if self.weightless:
            begins["gravity"] = 0.0
        # A clamp that is level needs no parameter, and then cannot be turned either.
        begins |= {name: values.get(name, 0.0) * self.apart for name in (SPAN, DROP)}
        mixed = {name: share * value + (1 - share) * begins.get(name, value) for name, value in values.items()}
        x = with_plastic_strain(self.graph.start, self.graph, self.scene, share)
        return x, np.array([mixed[name] for name in self.graph.parameters])

    def search(self, equilibrium: Search, share: float, guesses: list[Floats]) -> Floats | None:
        """Equilibrium at a share; of a string without bending only one that hangs, as it cannot be pushed."""
        x, constants = self.at(share)
        for guess in guesses:
            z = equilibrium.search(0.0, x, constants, [guess])
            if z is not None and (self.graph.terms.bending or self._hangs(x, z, constants)):
                return z
        return None

    def _hangs(self, x: Floats, z: Floats, constants: Floats) -> bool:
        observed = self.graph.symbolic.observables(time=0.0, state=x, algebraic=z, parameters=constants)
        return float(np.min(np.asarray(observed["tension"]))) >= 0
