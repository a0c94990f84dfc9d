"""The initial state of a run."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.estimates.initial_stress import initial_strain
from softcat_sym.scene.scene import Scene, force_free_stretch


@dataclass(frozen=True)
class Start:
    """Differential and algebraic states at t = 0."""

    x: Floats
    z: Floats


Newton = Callable[[Graph, Floats, Floats, Floats], Floats | None]
"""Algebraic unknowns in balance at t = 0, from a graph, its differential unknowns, parameters and a guess."""


def with_plastic_strain(x: Floats, graph: Graph, scene: Scene, share: float) -> Floats:
    """The state with a share of the scene's initial plastic strain."""
    where = graph.differential.where
    # Values are equally spaced from left to right; a single value holds for the whole filament.
    mean, bending = (
        np.interp(where, np.linspace(-0.5, 0.5, len(values)), values) if values else np.zeros(len(where))
        for values in (initial_strain(scene), scene.initial.C)
    )
    mean = mean + math.log(force_free_stretch(scene))
    result = np.array(x, dtype=float)
    kinds = np.array(graph.differential.kinds)
    for kind, weight in graph.profiles.items():
        here = kinds == kind
        result[here] = share * (weight[0] * mean[here] + weight[1] * bending[here])
    return result
