"""What every run must keep, whatever its scene: checked on the stored fields alone."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.material import SOLIDS
from softcat_sym.scene.scene import undeformed_area

Array = npt.NDArray[np.float64]

REACTIONS = 0.05
"""Of the weight: forces in the end cells are rebuilt from means over cells in which moment and curvature are steepest
(a falling fluid: 0.024 on 40 cells, 0.008 on 160), and time integrals from frames."""

_MIN_FRAMES, _ROUGH = 20, 0.3


def violations(run: Trajectory) -> dict[str, str]:
    """What a run breaks, and by how much; empty for a sound one."""
    checks = {
        "finite": _not_finite(run),
        "energy": _open_balance(run),
        "plastic work": _work_given_back(run),
        "reactions": _unbalanced(run),
    }
    return {name: text for name, text in checks.items() if text}


def _not_finite(run: Trajectory) -> str:
    return ", ".join(str(name) for name, values in run.data.items() if not np.all(np.isfinite(values)))


def _open_balance(run: Trajectory) -> str:
    residual = run.summary["energy_residual"]
    audited = run.scene.run.closure == "material" and "inertia" in run.summary["effects"]
    return f"{residual:.2g}" if audited and residual > run.scene.run.accuracy else ""


def _work_given_back(run: Trajectory) -> str:
    """Plastic work never decreases: what dissipates never gives back. Up to the integrator's own error."""
    if run.scene.run.closure != "material" or run.scene.material.law in SOLIDS:
        return ""
    work = np.asarray(run.data["energy_dissipated"])
    largest = float(np.max(np.abs(work)))
    drop = -float(np.min(np.diff(work), initial=0.0))
    # Of the audit too: what is lost may be a trace of what is stored.
    stored = max(float(np.max(np.abs(run.data[name]))) for name in ("energy_elastic", "energy_potential"))
    return f"{drop / largest:.2g}" if drop > run.summary["rtol"] * max(largest, stored) else ""


def _unbalanced(run: Trajectory) -> str:
    """The supports carry weight plus inertia: int w (R - W) dt = int w'' sum m y dt, with w = sin^4(pi t/T).

    Frame by frame without inertia. Not asked of what rings faster than the frames show.
    """
    if run.scene.model != "filament" or (
        "bending" in run.summary["effects"] and "large-rotation" not in run.summary["effects"]
    ):
        return ""
    time, y = np.asarray(run.data["time"]), np.asarray(run.data["y"])
    mass, reaction, weight = _masses(run), _reactions(run), _weight(run)
    scale = run.scene.load.gravity * float(np.sum(mass)) + run.scene.load.gravity * run.scene.load.point_mass
    if "inertia" not in run.summary["effects"]:
        # At the first instant of a load that comes at once a viscous stress may be all there is.
        error = np.max(np.abs(reaction - weight)[1:]) / scale
        return f"{error:.2g}" if error > REACTIONS else ""
    middle = y[:, y.shape[1] // 2]
    rough = np.sum(np.abs(np.diff(middle, 2))) > _ROUGH * np.sum(np.abs(np.diff(middle)))
    if len(time) < _MIN_FRAMES or rough or run.scene.ends.motion:
        return ""
    phase = np.pi * time / time[-1]
    window = np.sin(phase) ** 4
    curved = (np.pi / time[-1]) ** 2 * (12 * np.sin(phase) ** 2 * np.cos(phase) ** 2 - 4 * np.sin(phase) ** 4)
    left = np.trapezoid(window * (reaction - weight), time)
    right = np.trapezoid(curved * (y @ mass), time)
    error = abs(left - right) / (scale * np.trapezoid(window, time))
    return f"{error:.2g}" if error > REACTIONS else ""


def _masses(run: Trajectory) -> Array:
    """Of the nodes [kg]; an uneven filament has the area of its thickness where it is not stretched."""
    filament, nodes = run.scene.filament, np.asarray(run.data["X_node"])
    cells = np.diff(nodes) * filament.density * undeformed_area(run.scene)
    if filament.profile:
        at = np.asarray(run.data["X_cell"]) / (nodes[-1] - nodes[0])
        relative = np.interp(at, np.linspace(-0.5, 0.5, len(filament.profile)), filament.profile)
        cells = cells * relative ** (2 if filament.section == "circle" else 1)
    halves = np.concatenate([[0.0], cells / 2]) + np.concatenate([cells / 2, [0.0]])
    halves[len(halves) // 2] += run.scene.load.point_mass
    return halves


def _weight(run: Trajectory) -> Array:
    time, ramp = np.asarray(run.data["time"]), run.scene.load.ramp
    u = np.clip(time / ramp, 0, 1) if ramp > 0 and "gravity-ramp" in run.summary["effects"] else np.ones_like(time)
    load = run.scene.load
    shaken = 1 + load.shake * np.sin(2 * np.pi * load.shake_frequency * time)
    return shaken * u**3 * (10 - 15 * u + 6 * u**2) * run.scene.load.gravity * float(np.sum(_masses(run)))


def _reactions(run: Trajectory) -> Array:
    """Upward force of both supports [N]: that in the end cells, and the weight of the half cells beside the supports.

    A section that shears carries T and S along its own director, which lags behind the centreline by the shear strain;
    otherwise the axial force is T + (3/2) M theta_s.
    """
    data, effects = run.data, run.summary["effects"]
    dx, dy = np.diff(data["x"], axis=1), np.diff(data["y"], axis=1)
    angle = np.arctan2(dy, dx)
    axial, across = np.asarray(data["tension"]), np.asarray(data["shear_force"])
    if "shear" in effects:
        angle = angle - np.arctan(np.asarray(data["shear"]))
    if run.scene.run.closure == "material":
        axial = axial + 1.5 * np.asarray(data["moment"]) * np.asarray(data["curvature"])
    force = axial * np.sin(angle) + across * np.cos(angle)
    mass = _masses(run)
    share = _weight(run) / np.sum(mass)
    free = {"left": run.scene.ends.left == "free", "right": run.scene.ends.right == "free"}
    left = 0.0 if free["left"] else -force[:, 0] + share * mass[0]
    right = 0.0 if free["right"] else force[:, -1] + share * mass[-1]
    return np.asarray(left + right)
