"""Scenes in SI numbers, and runs of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from softcat_sym import simulate
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene

Array = npt.NDArray[np.float64]

GEOMETRY = ("bending", "finite-stretch", "thinning", "large-rotation")
"""Everything but inertia, flow and the ramp."""


def scene(
    *,
    thickness: float,
    E: float,
    span: float = 1.0,
    density: float = 1000.0,
    gravity: float = 10.0,
    section: str = "rectangle",
    eta: float | None = None,
    yield_stress: float | None = None,
    ends: tuple[str, str] = ("clamped", "clamped"),
    ramp: float = 0.0,
    duration: float = 1.0,
    frames: int = 2,
    effects: str | tuple[str, ...] = "paper",
    closure: str = "material",
    accuracy: float = 1e-3,
    cells: int = 40,
    grading: float = 1.0,
    rtol: float | None = None,
    solver: str | None = None,
) -> Scene:
    """A scene of SI numbers on equal cells, run once; the law follows from the constants that are given."""
    law = "elastic" if eta is None else "maxwell" if yield_stress is None else "bingham"
    constants = {"youngs_modulus": E, "viscosity": eta, "yield_stress": yield_stress}
    numerics = {"cells": cells, "grading": grading, "rtol": rtol, "solver": solver}
    run = {"duration": duration, "frames": frames, "accuracy": accuracy, "closure": closure}
    return Scene.from_dict(
        {
            "filament": {"span": span, "thickness": thickness, "section": section, "density": density},
            "material": {"law": law} | {name: value for name, value in constants.items() if value is not None},
            "ends": {"left": ends[0], "right": ends[1]},
            "load": {"gravity": gravity, "ramp": ramp},
            "run": run | {"effects": effects if isinstance(effects, str) else list(effects)},
            "numerics": {"estimate": False} | {key: value for key, value in numerics.items() if value is not None},
        }
    )


def run(asked: Scene) -> Run:
    """Run a scene."""
    return simulate(asked)


def sag(trajectory: Run) -> float:
    """Final depth of the midpoint [m]."""
    assert trajectory.outcome.is_success, trajectory.summary["message"]
    return -float(trajectory.data["midpoint"][-1])


def extrapolated(coarse: float, fine: float) -> float:
    """Limit of a second-order sequence from a grid and one twice as fine."""
    return fine + (fine - coarse) / 3


PAPER = {"delta": 0.03, "span": 0.2, "density": 1900.0, "gravity": 9.81, "E": 4e6}
"""The paper's filament (section 3), SI."""

ELASTIC_TIME = PAPER["span"] * (PAPER["density"] / PAPER["E"]) ** 0.5
"""Its unit of time L sqrt(rho/E) [s]."""


def paper_scene(G: float, V: float, duration: float, ramp: float = 10.0, **changes: Any) -> Scene:
    """One of the paper's Bingham scenes; duration and ramp in units of L sqrt(rho/E)."""
    span, density, gravity = PAPER["span"], PAPER["density"], PAPER["gravity"]
    return scene(
        thickness=PAPER["delta"] * span,
        span=span,
        density=density,
        gravity=gravity,
        E=PAPER["E"],
        yield_stress=density * gravity * span / G,
        eta=V * density * (gravity * span**3) ** 0.5,
        ramp=ramp * ELASTIC_TIME,
        duration=duration * ELASTIC_TIME,
        **changes,
    )


def upward_crossings(t: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Times at which y rises through zero, by linear interpolation."""
    before = np.flatnonzero((y[:-1] <= 0) & (y[1:] > 0))
    return t[before] + (t[before + 1] - t[before]) * y[before] / (y[before] - y[before + 1])
