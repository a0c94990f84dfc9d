"""Scenes of any law, section and ends in SI numbers, on equal cells, and what their runs give."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

import softcat_sym as sc

Array = npt.NDArray[np.float64]

GEOMETRY = ("bending", "finite-stretch", "thinning", "large-rotation")
STRING = ("finite-stretch", "thinning", "large-rotation")
FLOW = {
    "elastic": (),
    "newtonian": ("viscous-stress",),
    "kelvin-voigt": ("viscous-stress",),
    "bingham": ("viscous-flow", "yielding"),
    "herschel-bulkley": ("viscous-flow", "yielding"),
}
"""Effects of each law; ``viscous-flow`` for the others."""


def flow_of(law: str) -> tuple[str, ...]:
    """Effects by which a law flows."""
    return FLOW.get(law, ("viscous-flow",))


def scene(
    material: Mapping[str, Any],
    filament: Mapping[str, Any],
    *,
    effects: str | tuple[str, ...],
    ends: Mapping[str, Any] | None = None,
    initial: Mapping[str, Any] | None = None,
    load: Mapping[str, Any] | None = None,
    run: Mapping[str, Any] | None = None,
    cells: int = 20,
    rtol: float | None = None,
) -> sc.Scene:
    """A scene in SI numbers, run without an estimate; 1 m, 1000 kg/m^3, 10 m/s^2, 1 s and 2 frames if not given."""
    return sc.Scene.from_dict(
        {
            "filament": {"span": 1.0, "density": 1000.0, **filament},
            "material": dict(material),
            "ends": dict(ends or {}),
            "initial": dict(initial or {}),
            "load": {"gravity": 10.0, **(load or {})},
            "run": {"duration": 1.0, "frames": 2, **(run or {})}
            | {"effects": effects if isinstance(effects, str) else list(effects)},
            "numerics": {"cells": cells, "grading": 1.0, "estimate": False} | ({} if rtol is None else {"rtol": rtol}),
        }
    )


def solved(asked: sc.Scene) -> xr.Dataset:
    """Data of a run that succeeded."""
    done = sc.simulate(asked)
    assert done.outcome is sc.Outcome.solved, f"{done.outcome.name}: {done.summary['message']}"
    return done.data


def limit_of(coarse: Any, fine: Any) -> Any:
    """Limit of a second-order sequence from a grid and one twice as fine."""
    return fine + (fine - coarse) / 3
