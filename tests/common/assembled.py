"""Assembled filaments on small grids, ready to be solved or evaluated at random states."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization import assembly
from softcat_sym.discretization.assembly import choose_grid, choose_theory
from softcat_sym.discretization.graph import Graph, Recorded, Theory
from softcat_sym.discretization.grid import Grid, half_span, whole_span
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.discretization.supports import FilamentBody
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.physics.section_equations import FilamentEquations, derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.ends import CLAMPED, PINNED, SYMMETRY
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.settings import Settings, choose_settings
from softcat_sym.solvers.solution import Silence, Solution
from softcat_sym.solvers.solve import Prepared, prepare

FILAMENT = {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"}
MATERIALS: dict[str, dict[str, Any]] = {
    "elastic": {"law": "elastic", "youngs_modulus": "4 MPa"},
    "maxwell": {"law": "maxwell", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s"},
    "bingham": {"law": "bingham", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s", "yield_stress": "9.32 kPa"},
}
GRIDS = {
    "half": half_span(6, CLAMPED),
    "half pinned": half_span(5, PINNED),
    "whole": whole_span(3, CLAMPED, PINNED),
    "graded": Grid(np.array([0.0, 0.13, 0.3, 0.42, 0.47, 0.5]), SYMMETRY, CLAMPED),
}

KIRCHHOFF = Theory("filament", None)


@cache
def scene_of(law: str = "bingham", ramp: str = "0.1 s", section: str = "rectangle", closure: str = "material") -> Scene:
    """A scene of one law, with the published effects."""
    run = {"duration": "0.5 s", "closure": closure, "effects": "paper"}
    filament = {**FILAMENT, "section": section}
    return Scene.model_validate({"filament": filament, "material": MATERIALS[law], "load": {"ramp": ramp}, "run": run})


@cache
def short_scene(
    law: str = "bingham", frames: int = 9, cells: int = 5, duration: str = "0.1 s", ramp: str = "0.04 s"
) -> Scene:
    """A scene that does something within its short time, on few cells; what yields does so early."""
    changes = {"material.yield_stress": "1.96 kPa"} if law == "bingham" else {}
    run = {"run.duration": duration, "run.frames": frames}
    return scene_of(law, ramp).replace({**changes, **run, "numerics.cells": cells, "numerics.estimate": False})


def without(scene: Scene, *names: str) -> Scene:
    """The scene without some of its effects."""
    return scene.replace({"run.effects": [name for name in choose_effects(scene).names if name not in names]})


def assemble(
    equations: FilamentEquations,
    grid: Grid,
    effects: tuple[str, ...],
    theory: Theory = KIRCHHOFF,
    body: FilamentBody | None = None,
) -> Graph:
    """Evaluate the filament of one cell's equations on a grid."""
    recorded = Recorded(equations.formulation, grid, theory, body or FilamentBody())
    return assembly.graph_of(recorded, effects, recorded.program.signature)


def build(scene: Scene, grid: Grid = GRIDS["half"], absent: tuple[str, ...] = ()) -> Graph:
    """Assemble the scene's filament, without some of its effects."""
    effects = choose_effects(without(scene, *absent) if absent else scene)
    equations = derive(effects.terms(), SECTIONS[scene.filament.section], scene.run.closure)
    return assemble(equations, grid, effects.names, choose_theory(scene, equations.terms))


def graph_of(scene: Scene) -> Graph:
    """The scene's filament on its own grid."""
    return build(scene, choose_grid(scene))


def settings_of(scene: Scene, **changes: Any) -> Settings:
    """The settings chosen for the scene, some of them overruled."""
    return replace(choose_settings(scene, choose_effects(scene)), **changes)


def prepared(scene: Scene, **changes: Any) -> Prepared:
    """Ready to solve, interpreted."""
    return prepare(scene, graph_of(scene), settings_of(scene, **changes))


def parameters(scene: Scene, graph: Graph) -> Floats:
    """The scene's values of the graph's parameters."""
    return graph.vector(parameter_values(scene))


def random_state(graph: Graph, seed: int, size: float = 0.02) -> tuple[Floats, Floats]:
    """A state (x, z) some way off the straight filament: stretched, turned, moving and yielded."""
    generator = np.random.default_rng(seed)
    x = graph.start + size * generator.normal(size=graph.start.shape)
    z = graph.straight + size * generator.normal(size=graph.straight.shape)
    return x, z


def value(function: ca.Function, *inputs: Any) -> tuple[Floats, ...]:
    """Outputs as flat arrays."""
    outputs = function.call([ca.DM(i) for i in inputs])
    return tuple(np.asarray(output, dtype=float).ravel() for output in outputs)


def energy_of(graph: Graph, names: tuple[str, ...]) -> ca.SX:
    """Sum of energies [J per unit undeformed area] as an expression of the graph's own symbols."""
    observables = graph.symbolic.observables
    out = dict(zip(observables.name_out(), observables(*graph.symbolic.inputs), strict=True))
    return sum((out[name] for name in names), ca.SX(0))


def place(name: str) -> tuple[str, int]:
    """Kind and number in a state's name such as ``y[3] at X/L = 0.25``."""
    kind, rest = name.split("[", 1)
    return kind, int(rest.split("]", 1)[0])


def midpoint(run: Prepared, states: Floats) -> Floats:
    """y/L at X = 0 of the given states (x, or z without inertia)."""
    names = run.graph.algebraic.names if run.graph.is_dae else run.graph.differential.names
    (row,) = [k for k, name in enumerate(names) if name.startswith("y[0]")]
    return np.asarray(states)[row]


def largest_difference(run: Prepared, one: Solution, other: Solution) -> float:
    """Of any unknown at any time, over the largest value of its kind."""
    worst = 0.0
    for found, wanted, layout in ((one.x, other.x, run.graph.differential), (one.z, other.z, run.graph.algebraic)):
        rows = np.array(layout.kinds)
        for kind in dict.fromkeys(layout.kinds):
            size = np.max(np.abs(wanted[rows == kind]))
            worst = max(worst, float(np.max(np.abs(found - wanted)[rows == kind]) / max(size, 1e-12)))
    return worst


@dataclass
class Listener(Silence):
    """Remembers what a run reports."""

    times: list[float] = field(default_factory=list)
    steps: list[float | None] = field(default_factory=list)

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note."""
        self.times.append(simulated_time)
        self.steps.append(step_size)
