"""Small filaments, prepared to be solved."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import numpy as np

from softcat_sym.discretization.assembly import assemble, choose_grid
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.run import Prepared, prepare
from softcat_sym.solvers.settings import Settings, choose_settings
from softcat_sym.solvers.solution import Silence

_MATERIALS: dict[str, dict[str, Any]] = {
    "elastic": {"law": "elastic", "youngs_modulus": "4 MPa"},
    "maxwell": {"law": "maxwell", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s"},
    "bingham": {"law": "bingham", "youngs_modulus": "4 MPa", "viscosity": "13.84 kPa*s", "yield_stress": "1.96 kPa"},
}


@cache
def scene_of(
    law: str = "bingham", frames: int = 9, cells: int = 5, duration: str = "0.1 s", ramp: str = "0.04 s"
) -> Scene:
    """A scene of one law that does something within its short time, with the published effects."""
    return Scene.model_validate(
        {
            "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
            "material": dict(_MATERIALS[law]),
            "load": {"ramp": ramp},
            "run": {"duration": duration, "frames": frames, "effects": "paper"},
            "numerics": {"cells": cells, "estimate": False},
        }
    )


def without(scene: Scene, *names: str) -> Scene:
    """The scene without some of its effects."""
    return scene.replace({"run.effects": [name for name in choose_effects(scene).names if name not in names]})


def graph_of(scene: Scene) -> Graph:
    """Its filament."""
    effects = choose_effects(scene)
    return assemble(
        derive(effects.terms(), SECTIONS[scene.filament.section], scene.run.closure), choose_grid(scene), effects.names
    )


def settings_of(scene: Scene, **changes: Any) -> Settings:
    """The settings chosen for the scene, some of them overruled."""
    return replace(choose_settings(scene, choose_effects(scene)), **changes)


def prepared(scene: Scene, **changes: Any) -> Prepared:
    """Ready to solve."""
    return prepare(scene, graph_of(scene), settings_of(scene, **changes))


def midpoint(run: Prepared, states: Floats) -> Floats:
    """y/L at X = 0 of the given states (x, or z without inertia)."""
    names = run.graph.algebraic_names if run.graph.is_dae else run.graph.state_names
    (row,) = [k for k, name in enumerate(names) if name.startswith("y[0]")]
    return np.asarray(states)[row]


@dataclass
class Listener(Silence):
    """Remembers what a run tells."""

    times: list[float] = field(default_factory=list)
    steps: list[float | None] = field(default_factory=list)

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note."""
        self.times.append(simulated_time)
        self.steps.append(step_size)
