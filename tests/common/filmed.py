"""A film that this package made itself, with noise: cheap to fit, and its material is known."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

import softcat_sym as sc
from tests.common.draws import draws

NAME = "continual-descent"
CHEAP = ("run.effects=paper", "numerics.cells=10")
NOISE = 5e-4


def scene() -> sc.Scene:
    return sc.load_scene(NAME, list(CHEAP))


TRUTH = {"yield_stress": float(scene().material.yield_stress or 0), "viscosity": float(scene().material.viscosity or 0)}


@cache
def film(frames: int = 60, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """Times [s] and midpoints [m]."""
    data = sc.simulate(scene().replace({"run.frames": 601})).data
    time = np.linspace(0, float(data.time[-1]), frames + 1)[1:]
    height = np.interp(time, data.time.values, data.midpoint.values)
    return time, height + NOISE * draws(seed).standard_normal(frames)


def write_film(path: Path, *, std: bool = False) -> Path:
    """As a tracker writes it."""
    time, height = film()
    rows = [f"{t:.9g},{y:.9g}" + (f",{NOISE:g}" if std else "") for t, y in zip(time, height, strict=True)]
    path.write_text("\n".join(["time_s,midpoint_m" + (",midpoint_std_m" if std else ""), *rows]) + "\n")
    return path
