"""Equilibria that are not straight: followed from the straight filament, and settled where they are unstable."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.supports import DROP, LEFT_ANGLE, RIGHT_ANGLE, SPAN
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.scaling_estimates import elastic_sag
from softcat_sym.scene.scene import Scene, chord_angle, distance, is_held, is_slack, rest_length
from softcat_sym.solvers.equilibrium import Equilibrium, Stiffness
from softcat_sym.solvers.initial_state import sagging_guesses
from softcat_sym.solvers.start import with_plastic_strain

_NUDGE = 1e-3  # of a span
_LARGEST = 0.05  # change of a position in one step, in spans
_GROWTH, _SHRINKAGE = 2.0, 0.25
_SETTLED = 1e-11
_SETTLING_ITERATIONS = 400
_SETTLING_ROUNDING = 1e-13

_MAX_STEP, _MIN_STEP = 0.25, 1 / 512  # of a continuation


def settled(graph: Graph, x: Floats, p: Floats, z: Floats, straight: Floats) -> Floats:
    """The minimum of the energy that a nudged equilibrium creeps into; the same where it is one already.

    An arch that stands may be such a minimum, too: it is turned over first, so that what hangs is found.

    Linearly implicit steps along dz/dtau = alg, the forces over the masses: each must lower the energy, so that none
    steps back onto a saddle.
    """
    slope, nudge = _Slope(graph, x, p), _nudge(graph)

    def turned_over(shape: Floats) -> Floats:
        """The shape on the other side of the line between the supports."""
        return np.where(np.isin(graph.z_kinds, ("y", "psi")), 2 * straight - shape, shape)

    low = slope.descended(min((z, turned_over(z)), key=slope.energy) - nudge)
    # What leaves a straight bar may rise as well as hang.
    other = slope.descended(turned_over(low) - nudge)
    return min((low, other), key=slope.energy)


def snapped(graph: Graph, time: float, x: Floats, p: Floats, z: Floats) -> Floats:
    """The minimum of the energy that a shape out of balance, nudged, creeps into: beyond a fold of its equilibria."""
    return _Slope(graph, x, p, time).descended(z - _nudge(graph))


def _nudge(graph: Graph) -> Floats:
    """Downwards, and a little more on one side."""
    weight, size = np.abs(graph.z_where) / 0.5, np.where(np.isin(graph.z_kinds, "y"), _NUDGE, 0.0)
    return np.asarray(size * (1 - weight**2) * (1 + 0.1 * np.sign(graph.z_where)))


class _Slope:
    """Energy of the filament, and implicit steps down its slope."""

    def __init__(self, graph: Graph, x: Floats, p: Floats, time: float = 0.0) -> None:
        self._x, self._p, self._time, self._observables = x, p, time, graph.symbolic.observables
        pace = ca.SX.sym("pace")
        matrix = ca.SX.eye(len(graph.straight)) / pace - ca.jacobian(graph.alg, graph.z)
        self._system = ca.Function("system", [graph.t, graph.x, graph.z, graph.p, pace], [graph.alg, matrix])
        self._stiffness = Stiffness(self._system.sparsity_out(1))

    def energy(self, z: Floats) -> float:
        """All stored energy per undeformed area."""
        observed = self._observables(time=self._time, state=self._x, algebraic=z, parameters=self._p)
        names = (name for name in observed if name.startswith("energy_") and name != "energy_kinetic")
        return sum(float(observed[name]) for name in names)

    def descended(self, start: Floats) -> Floats:
        """The minimum that a shape creeps into.

        The first step is as short as that of an explicit method: what is stiff comes to rest before the steps are so
        long that they would end on a saddle.
        """
        _, matrix = self._system(self._time, self._x, start, self._p, 1.0)
        pace = 1 / float(np.max(np.abs(np.diag(np.asarray(matrix)))))
        best, lowest = start, self.energy(start)
        for _ in range(_SETTLING_ITERATIONS):
            force, matrix = self._system(self._time, self._x, best, self._p, pace)
            step = self._stiffness.factorise(matrix).step(force)
            if step is None:
                pace *= _SHRINKAGE
                continue
            size = float(np.max(np.abs(step)))
            if size < _SETTLED and pace > 1:
                return best + step
            energy = self.energy(best + step)
            if size > _LARGEST or not energy <= lowest + _SETTLING_ROUNDING * abs(lowest):
                pace *= _SHRINKAGE
                continue
            best, lowest, pace = best + step, energy, pace * _GROWTH
        return best


def balanced(scene: Scene, graph: Graph, p: Floats, straight: Floats, *, is_straight: bool) -> Floats | None:
    """Algebraic positions in equilibrium at t = 0, followed from the straight filament where that is not one.

    With its weight from the beginning; if that leads nowhere, with a weight that grows, which needs bending: a string
    without weight has no stiffness.
    """
    equilibrium, bends = Equilibrium(graph), graph.terms.bending
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
    x, constants = heavy.at(1.0)
    return equilibrium.search(0.0, x, constants, [settled(graph, x, constants, z, straight)])


def _followed(stage: _Stage, equilibrium: Equilibrium, straight: Floats) -> Floats | None:
    """Equilibrium at the end of a continuation, or None where it breaks off."""
    graph = stage.graph
    falls = graph.terms.bending and graph.conserves_energy
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

    def search(self, equilibrium: Equilibrium, share: float, guesses: list[Floats]) -> Floats | None:
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
