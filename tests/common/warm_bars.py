"""Bars with a temperature, held straight between clamps without weight, and the run of one."""

from __future__ import annotations

from typing import Any

import softcat_sym as sc
from softcat_sym.results.run import Run

BAR = ("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "temperature")
FLOWING = (*BAR, "viscous-flow")
RHO, CAPACITY, DIAMETER, SPAN = 1000.0, 1500.0, 1e-3, 0.05


def bar(heat: dict[str, Any], *effects: str, duration: float = 2.0, **tables: dict[str, Any]) -> sc.Scene:
    """A bar of an elastic or Maxwell material in SI; further tables override."""
    law = "maxwell" if "viscous-flow" in effects else "elastic"
    table: dict[str, Any] = {
        "filament": {"span": SPAN, "diameter": DIAMETER, "density": RHO},
        "material": {"law": law, "youngs_modulus": 1e6, **({"viscosity": 1e6} if law == "maxwell" else {})},
        "load": {"gravity": 0.0},
        "temperature": {"initial": 350.0, "heat_capacity": CAPACITY, **heat},
        "run": {"duration": duration, "frames": 11, "effects": list(effects or BAR)},
        "numerics": {"cells": 6, "grading": 1.0, "rtol": 1e-8, "estimate": False, "backend": "interpreted"},
    }
    for name, values in tables.items():
        table.setdefault(name, {}).update(values)
    return sc.Scene.from_dict(without_gaps(table))


def without_gaps(tables: dict[str, Any]) -> dict[str, Any]:
    """The tables without the keys that are an ellipsis."""
    return {
        name: {key: one for key, one in table.items() if one is not ...} if isinstance(table, dict) else table
        for name, table in tables.items()
    }


def run(scene: sc.Scene, **changes: object) -> Run:
    """The run of a scene, some of whose values are changed."""
    return sc.simulate(scene.replace({name.replace("__", "."): value for name, value in changes.items()}))
