"""A filament in three dimensions at rest: its equilibria, and the stiffness of one in places and turns of its nodes."""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

import softcat_sym as sc
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.single_run import build
from softcat_sym.solvers.equilibrium import Equilibrium

ELASTIC_ROD = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear"]
"""Effects of an elastic rod in space, without inertia."""

PLACES, TURN = ("x", "y", "z"), ("q0", "q1", "q2", "q3")
FREE = 6
"""Ways of a node: three places [rest lengths] and three turns about its own axes [rad]."""


class Statics:
    """An elastic rod of a scene without inertia."""

    def __init__(self, scene: sc.Scene) -> None:
        scene = scene.replace({"numerics.backend": "interpreted", "run.effects": ELASTIC_ROD, "run.dimensions": 3})
        self.scene = scene
        self.prepared = build(scene, choose_effects(scene))
        self.graph = self.prepared.graph
        if not self.graph.positions_are_algebraic or self.graph.symbolic.x.numel():
            raise ValueError("a rod at rest has no states that move")
        g = self.graph
        self._equilibrium = Equilibrium(g)
        alg = ca.densify(g.symbolic.balances[1])
        self._jacobian = ca.Function("jacobian", g.symbolic.inputs, [ca.jacobian(alg, g.symbolic.z)])
        self._nothing = np.zeros(0)
        places = g.algebraic.unknowns
        self._at = {one: number for number, one in enumerate(places)}
        self.nodes = sorted({place for kind, place in places if kind == "x"})
        turning = {place for kind, place in places if kind == "q0"}
        if turning != set(self.nodes):
            raise ValueError("the ends are held altogether, or not at all")
        half = g.grid.cell_length / 2
        self._mass = np.append(half, 0.0) + np.append(0.0, half)

    @property
    def start(self) -> Floats:
        """Equilibrium at t = 0."""
        start = self.prepared.start
        if start is None:
            raise ValueError("no equilibrium at the start")
        return start.z

    def at(self, kind: str, node: int) -> int:
        """Number of an unknown of a node."""
        return self._at[kind, node]

    def p(self, **changes: float) -> Floats:
        """The scene's numbers, some of them changed."""
        values = dict(zip(self.graph.parameters, self.prepared.p.tolist(), strict=True))
        unknown = set(changes) - set(values)
        if unknown:
            raise KeyError(f"no such numbers: {unknown}")
        return np.array([(values | changes)[name] for name in self.graph.parameters])

    def guess(self, places: Floats, turns: Floats) -> Floats:
        """State of nodes at given places [rest lengths] with given quaternions, held nodes included in the arrays."""
        z = np.array(self.graph.straight)
        for (kind, place), number in self._at.items():
            values = places[place, PLACES.index(kind)] if kind in PLACES else turns[place, TURN.index(kind)]
            z[number] = values
        return z

    def equilibrium(self, seconds: float, z: Floats, p: Floats) -> Floats:
        """From a guess."""
        found = self._equilibrium.search(seconds / self.prepared.scale, self._nothing, p, [z])
        if found is None:
            raise ArithmeticError("no equilibrium is reached from there")
        return found

    def stiffness(self, seconds: float, z: Floats, p: Floats) -> Floats:
        """Symmetric stiffness of the free nodes, six ways each, in energies `self.unit`; z is an equilibrium."""
        J = np.asarray(self._jacobian(seconds / self.prepared.scale, self._nothing, z, p).full())
        size = FREE * len(self.nodes)
        K, rows, T = np.zeros((size, size)), np.zeros((size, len(z))), np.zeros((len(z), size))
        for n, node in enumerate(self.nodes):
            mass = self._mass[node]
            for k, kind in enumerate((*PLACES, *TURN[1:])):
                rows[FREE * n + k] = -mass * J[self._at[kind, node]]
            for k, kind in enumerate(PLACES):
                T[self._at[kind, node], FREE * n + k] = 1.0
            w, x, y, s = (z[self._at[kind, node]] for kind in TURN)
            turned = np.array([[-x, -y, -s], [w, -s, y], [s, w, -x], [-y, x, w]]) / 2
            for k, kind in enumerate(TURN):
                T[self._at[kind, node], FREE * n + 3 : FREE * n + FREE] = turned[k]
        K = rows @ T
        asymmetry = np.abs(K - K.T).max() / np.abs(K).max()
        if asymmetry > 1e-6:
            raise ArithmeticError(f"a stiffness that is not symmetric to {asymmetry:g}: no equilibrium")
        return (K + K.T) / 2

    @property
    def unit(self) -> float:
        """Energy of the stiffness [J]: density times area times length cubed over the square of the time scale."""
        filament, values = self.scene.filament, dict(zip(self.graph.parameters, self.prepared.p.tolist(), strict=True))
        area = (
            np.pi / 4 * filament.thickness**2 if filament.section == "circle" else filament.thickness * filament.width
        )
        return float(filament.density * area * values["rest_length"] ** 3 / self.prepared.scale**2)

    def fields(self, seconds: float, z: Floats, p: Floats) -> Mapping[str, Floats]:
        """What a run would store of a state, one frame of it."""
        shown = self.graph.observe(np.array([seconds / self.prepared.scale]), np.zeros((0, 1)), z[:, None], p)
        return {name: values[0] for name, values in shown.items()}


def lowest(K: Floats) -> float:
    """Lowest eigenvalue; its sign does not depend on how turns are weighed against places."""
    return float(np.linalg.eigvalsh(K)[0])
