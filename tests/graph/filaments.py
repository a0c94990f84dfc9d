"""Assembled filaments on small grids, their parameters, and random states."""

from __future__ import annotations

from functools import cache
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.assembly import assemble
from softcat_sym.discretization.graph import Graph, parameter_values
from softcat_sym.discretization.grid import End, Floats, Grid, half_span
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.scene import Scene

_MATERIALS: dict[str, dict[str, Any]] = {
    "elastic": {"law": "elastic", "youngs_modulus": "4 MPa"},
    "maxwell": {"law": "maxwell", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s"},
    "bingham": {"law": "bingham", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s", "yield_stress": "9.32 kPa"},
}


@cache
def scene_of(law: str = "bingham", ramp: str = "0.1 s", section: str = "rectangle", closure: str = "material") -> Scene:
    """A scene of one law, with the published effects."""
    return Scene.model_validate(
        {
            "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3", "section": section},
            "material": dict(_MATERIALS[law]),
            "load": {"ramp": ramp},
            "run": {"duration": "0.5 s", "closure": closure, "effects": "paper"},
        }
    )


SMALL_GRID = half_span(6, End.CLAMPED)


def build(scene: Scene, grid: Grid = SMALL_GRID, without: tuple[str, ...] = ()) -> Graph:
    """Assemble the scene's filament, without some of its effects."""
    effects = choose_effects(scene)
    if without:
        names = [name for name in effects.names if name not in without]
        effects = choose_effects(scene.replace({"run.effects": names}))
    equations = derive(effects.terms(), SECTIONS[scene.filament.section], scene.run.closure)
    return assemble(equations, grid, effects.names)


def parameters(scene: Scene, graph: Graph) -> Floats:
    """The scene's values of the graph's parameters."""
    return graph.vector(parameter_values(scene))


def random_state(graph: Graph, seed: int, size: float = 0.02) -> tuple[Floats, Floats]:
    """A state (x, z) some way off the straight filament: stretched, turned, moving and yielded."""
    generator = np.random.default_rng(seed)
    x = graph.start + size * generator.normal(size=graph.start.shape)
    z = graph.straight + size * generator.normal(size=graph.straight.shape)
    return x, z


def rhs(graph: Graph) -> ca.Function:
    """(t, x, z, p) to (ode, alg, quad)."""
    return ca.Function("rhs", [graph.t, graph.x, graph.z, graph.p], [graph.ode, graph.alg, graph.quad])


def value(function: ca.Function, *inputs: Any) -> tuple[Floats, ...]:
    """Outputs as flat arrays."""
    outputs = function.call([ca.DM(i) for i in inputs])
    return tuple(np.asarray(output, dtype=float).ravel() for output in outputs)


def energy_of(graph: Graph, names: tuple[str, ...]) -> ca.SX:
    """Sum of energies [J per unit undeformed area] as an expression of the graph's own symbols."""
    out = graph.observables(time=graph.t, state=graph.x, algebraic=graph.z, parameters=graph.p)
    return sum((out[name] for name in names), ca.SX(0))


def place(name: str) -> tuple[str, int]:
    """Kind and number in a state's name such as ``y[3] at X/L = 0.25``."""
    kind, rest = name.split("[", 1)
    return kind, int(rest.split("]", 1)[0])
