"""Straight threads under their surface alone: the discretised graph, its linear modes, and runs from a state of ours.

Units: radius, density and surface tension are one, so that Gam is one and time is in sqrt(rho R^3/gamma).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym import Run, Scene
from softcat_sym.effects.selection import choose_effects
from softcat_sym.results.run import judge
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence, Start
from tests.common.filaments import Array

EFFECTS = ("inertia", "extensibility", "bending", "finite-stretch", "thinning", "large-rotation", "surface-tension")


INVISCID: Mapping[str, Any] = {"law": "elastic", "youngs_modulus": 1.0}
"""Of :func:`growth` alone, which is given the modulus zero beside."""


def newtonian(viscosity: float) -> dict[str, Any]:
    """Tensile viscosity in sqrt(rho gamma R)."""
    return {"law": "newtonian", "viscosity": viscosity}


def thread(length: float, cells: int, material: Mapping[str, Any], *, inertia: bool = True, **more: Any) -> Scene:
    """A weightless round thread between clamps, on equal cells; `cells` of them on half of it."""
    effects = [*EFFECTS[0 if inertia else 1 :], *(["viscous-stress"] if material["law"] == "newtonian" else [])]
    numerics = {"cells": cells, "grading": 1.0, "backend": "interpreted", "estimate": False, "rtol": 1e-7}
    tables: dict[str, Any] = {
        "filament": {"span": length, "thickness": 2.0, "section": "circle", "density": 1.0},
        "material": material,
        "load": {"gravity": 0.0},
        "surroundings": {"surface_tension": 1.0},
        "run": {"duration": 1.0, "frames": 41, "effects": effects},
        "numerics": numerics,
    }
    return Scene(**{key: {**tables.get(key, {}), **more.get(key, {})} for key in {**tables, **more}})


def growth(scene: Scene, waves: int, **parameters: float) -> complex:
    """Rate at which a wave of the stretch grows, `waves` of them on the length, of the linearised graph."""
    prepared = build(scene, choose_effects(scene), None, None)
    graph = prepared.graph
    p = np.array([parameters.get(name, value) for name, value in zip(graph.parameters, prepared.p, strict=True)])
    ode = ca.Function(
        "ode",
        [graph.symbolic.t, graph.symbolic.x, graph.symbolic.p],
        [ca.jacobian(graph.symbolic.ode, graph.symbolic.x)],
    )
    assert prepared.start is not None
    matrix = np.array(ode(0, prepared.start.x, p))
    along = np.flatnonzero(np.isin(graph.differential.kinds, ("x", "u")))
    rates, modes = np.linalg.eig(matrix[np.ix_(along, along)])
    kinds, where = np.array(graph.differential.kinds)[along], np.array(graph.differential.where)[along]
    shape = np.where(kinds == "x", np.sin(2 * np.pi * waves * where), 0.0)
    likeness = np.abs(modes.T @ shape) / np.linalg.norm(np.where(kinds == "x", 1, 0)[:, None] * modes, axis=0)
    found = rates[likeness > (1 - 1e-6) * np.max(likeness)]
    return complex(found[np.argmax(found.real)]) / prepared.scale


def evolve(scene: Scene, stretch: Callable[[Array], Array]) -> Run:
    """A run from rest, of a thread that has been stretched: by so much, its mean one, of X in its length."""
    effects = choose_effects(scene)
    prepared = build(scene, effects, None, None)
    graph = prepared.graph
    assert prepared.start is not None
    X, x = graph.grid.nodes, prepared.start.x.copy()
    at = (X[1:] + X[:-1]) / 2
    placed = X[0] + np.concatenate([[0.0], np.cumsum(stretch(at) * np.diff(X))])
    for n, (kind, where) in enumerate(zip(graph.differential.kinds, graph.differential.where, strict=True)):
        if kind == "x":
            x[n] = np.interp(where, X, placed)
    moved = type(prepared)(**{**vars(prepared), "start": Start(x, prepared.start.z)})
    return judge(scene, effects, moved, moved.solve(Silence()), {})
