"""What must hold in every success, whatever the scene."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import xarray as xr

from softcat_sym.results.fields import min_energy
from softcat_sym.results.run import Run
from softcat_sym.scene import scene as geometry
from softcat_sym.scene.scene import Scene

_STORED = tuple(f"energy_{kind}" for kind in ("kinetic", "elastic", "potential", "dissipated", "gradient", "surface"))

PLACE = 1e-6
"""How far a support may be from its place, over the span: what algebraic constraints and steps leave open."""

BACK = 1e-2
"""How much of the largest energy dissipation may seem to lose between two frames, over the tolerance of the steps: what
sums the power to a high order has weights of both signs."""


def messages(trajectory: Run) -> list[str]:
    """What does not hold; empty if all does."""
    checks = (_times, _bounds, _supports, _energy, _dissipation, _symmetry)
    scene = trajectory.scene
    return [*_numbers(trajectory)] or [text for check in checks for text in check(scene, trajectory)]


def is_balanced(scene: Scene, trajectory: Run) -> bool:
    """Whether energy is to be conserved: with the material closure, of a run that is carried through time.

    Not by a list with finite stretch and without thinning: its section swells with the stretch, and stores energy that
    no force knows (`test_properties.py` shows it).
    """
    effects = set(trajectory.summary["effects"])
    carried = {"inertia", "viscous-flow", "viscous-stress"} & effects
    swells = "finite-stretch" in effects and "thinning" not in effects
    return scene.run.closure == "material" and scene.model == "filament" and bool(carried) and not swells


def is_mirrored(scene: Scene) -> bool:
    """Whether left and right must mirror each other: a motion that goes nowhere does not change that."""
    idle = all(row[1:] == (0.0, 0.0) for row in scene.ends.motion)
    return idle and geometry.is_symmetric(scene.replace({"ends.motion": "hold"}))


def _numbers(trajectory: Run) -> Iterator[str]:
    for name, values in trajectory.data.variables.items():
        if not np.all(np.isfinite(values)) and not str(name).startswith("core_"):
            yield f"{name} is not finite"
    for name in ("midpoint_final_m", "time_final_s", "energy_residual"):
        if not np.isfinite(trajectory.summary[name]):
            yield f"{name} in the summary is not finite"


def _times(scene: Scene, trajectory: Run) -> Iterator[str]:
    asked = np.linspace(0, scene.run.duration, scene.run.frames)
    time = trajectory.data["time"].values
    if time.shape != asked.shape or not np.allclose(time, asked, rtol=1e-9, atol=1e-9 * scene.run.duration):
        yield f"frames at {time} s"


def _bounds(scene: Scene, trajectory: Run) -> Iterator[str]:
    data = trajectory.data
    for name in ("stretch", "thickness"):
        if float(data[name].min()) <= 0:
            yield f"a {name} of {float(data[name].min()):.3g}"
    for name in ("energy_kinetic", "energy_elastic"):
        if float(data[name].min()) < -1e-9 * _largest_energy(data):
            yield f"a negative {name}"
    if "yielded_fraction" in data and not -1e-9 <= float(data["yielded_fraction"].min()) <= 1 + 1e-9:
        yield "a yielded fraction outside 0 and 1"


def _supports(scene: Scene, trajectory: Run) -> Iterator[str]:
    """Held ends are where they were put: the left one at (-L/2, 0), the right one on its path."""
    data, span = trajectory.data, scene.filament.span
    ends, time = scene.ends, trajectory.data["time"].values
    rows = np.array(ends.motion or [(0.0, 0.0, 0.0)])
    right = (span / 2 + np.interp(time, rows[:, 0], rows[:, 1]), -ends.drop + np.interp(time, rows[:, 0], rows[:, 2]))
    held = {"left": (0, np.full(time.shape, -span / 2), np.zeros(time.shape)), "right": (-1, *right)}
    for side, (node, x, y) in held.items():
        if getattr(ends, side) == "free":
            continue
        off = np.hypot(data["x"].values[:, node] - x, data["y"].values[:, node] - y).max() / span
        if off > PLACE:
            yield f"the {side} support is off its place by {off:.2g} of the span"


def _energy(scene: Scene, trajectory: Run) -> Iterator[str]:
    if not is_balanced(scene, trajectory):
        return
    data = trajectory.data
    balance = sum(data[name].values for name in _STORED) - data["work_external"].values
    off, scale = np.max(np.abs(balance - balance[0])), _largest_energy(data)
    if off > scene.run.accuracy * max(scale, min_energy(scene)):
        reported = trajectory.summary["energy_residual"]
        yield f"an energy residual of {off / scale:.2g}, reported {reported:.2g}"


def _dissipation(scene: Scene, trajectory: Run) -> Iterator[str]:
    if not is_balanced(scene, trajectory):
        return
    lost = -np.diff(trajectory.data["energy_dissipated"].values).min() / max(_largest_energy(trajectory.data), 1e-300)
    if lost > BACK * trajectory.summary["rtol"]:
        yield f"dissipation falls by {lost:.2g} of the largest energy"


def _symmetry(scene: Scene, trajectory: Run) -> Iterator[str]:
    if not is_mirrored(scene):
        return
    x, y = trajectory.data["x"].values, trajectory.data["y"].values
    off = max(np.abs(x + x[:, ::-1]).max(), np.abs(y - y[:, ::-1]).max()) / max(np.abs(y).max(), 1e-300)
    if off > scene.run.accuracy:
        yield f"left and right differ by {off:.2g} of the sag"


def _largest_energy(data: xr.Dataset) -> float:
    return max(float(np.abs(data[name].values).max()) for name in (*_STORED, "work_external"))
