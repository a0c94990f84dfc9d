"""One filament prepared twice: compiled and interpreted, by the same kind of method and with the same tolerance."""

from __future__ import annotations

from typing import Any

import numpy as np

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.scene.scene import Scene
from softcat_sym.single_run import build
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Solution

from .filaments import scene_of, without

_SMALL = {"numerics.cells": 4, "run.frames": 7}
_FIBRES = [
    *("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow"),
    *("yielding", "gravity-ramp", "shear", "fibres", "necking-gradient"),
]
MOTION = [["0 s", "0 mm", "0 mm"], ["0.3 s", "20 mm", "0 mm"], ["0.6 s", "30 mm", "5 mm"]]


def kinds() -> dict[str, Scene]:
    """Filaments with differential and algebraic unknowns, sections, moving supports, profiles and free ends."""

    def small(name: str, **changes: Any) -> Scene:
        return sc.load_scene(name, {**_SMALL, **{key.replace("__", "."): value for key, value in changes.items()}})

    return {
        "elastic": scene_of("elastic"),
        "maxwell": scene_of("maxwell"),
        "bingham": scene_of("bingham"),
        "no inertia": without(scene_of("bingham"), "inertia"),
        "fibres": small("arrested-overdamped", run__effects=_FIBRES, numerics__fibres=3, groups__duration=20.0),
        "viscous stress, moving support": small("drawn-blob", ends__motion=MOTION, run__duration="1 s"),
        "profile, free end": small("curled-rod", filament__profile=[1.5, 1, 0.5], run__duration="0.3 s"),
        "point mass, no inertia": small("beam-viscometer"),
        "supports apart": small("slime-slope", run__duration="0.2 s"),
    }


def prepared(scene: Scene, backend: str = "compiled", **numerics: Any) -> Prepared:
    """Ready to be solved by the Rosenbrock method."""
    changes = {"backend": backend, "solver": "rosenbrock", **numerics}
    asked = scene.replace({f"numerics.{key}": value for key, value in changes.items()})
    return build(asked, choose_effects(asked))


def largest_difference(run: Prepared, one: Solution, other: Solution) -> float:
    """Of any unknown at any time, over the largest value of its kind."""
    worst = 0.0
    for found, wanted, kinds_of in ((one.x, other.x, run.graph.x_kinds), (one.z, other.z, run.graph.z_kinds)):
        rows = np.array(kinds_of)
        for kind in dict.fromkeys(kinds_of):
            size = np.max(np.abs(wanted[rows == kind]))
            worst = max(worst, float(np.max(np.abs(found - wanted)[rows == kind]) / max(size, 1e-12)))
    return worst
