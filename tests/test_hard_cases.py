"""Hard cases: a right answer or an honest refusal, never a wrong answer returned as success; each keeps invariants."""

from __future__ import annotations

import casadi as ca
import numpy as np
import numpy.typing as npt
import pytest

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SceneError
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import undeformed_area
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence
from tests.common.hard_cases import CASES, Case, asked
from tests.common.time_limit import within

Array = npt.NDArray[np.float64]

REACTIONS = 0.05
"""Of the weight: forces in the end cells are rebuilt from means over cells in which moment and curvature are steepest
(a falling fluid: 0.024 on 40 cells, 0.008 on 160), and time integrals from frames."""

_MIN_FRAMES, _ROUGH = 20, 0.3


def violations(run: Run) -> dict[str, str]:
    """What a run breaks, and by how much; empty for a sound one."""
    checks = {
        "finite": _not_finite(run),
        "energy": _open_balance(run),
        "plastic work": _work_given_back(run),
        "reactions": _unbalanced(run),
    }
    return {name: text for name, text in checks.items() if text}


def _not_finite(run: Run) -> str:
    return ", ".join(str(name) for name, values in run.data.items() if not np.all(np.isfinite(values)))


def _open_balance(run: Run) -> str:
    residual = run.summary["energy_residual"]
    audited = run.scene.run.closure == "material" and "inertia" in run.summary["effects"]
    return f"{residual:.2g}" if audited and residual > run.scene.run.accuracy else ""


def _work_given_back(run: Run) -> str:
    """Plastic work never decreases: what dissipates never gives back. Up to the integrator's own error."""
    if run.scene.run.closure != "material" or run.scene.material.spec.is_solid:
        return ""
    work = np.asarray(run.data["energy_dissipated"])
    largest = float(np.max(np.abs(work)))
    drop = -float(np.min(np.diff(work), initial=0.0))
    # Of the audit too: what is lost may be a trace of what is stored.
    stored = max(float(np.max(np.abs(run.data[name]))) for name in ("energy_elastic", "energy_potential"))
    return f"{drop / largest:.2g}" if drop > run.summary["rtol"] * max(largest, stored) else ""


def _unbalanced(run: Run) -> str:
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


def _masses(run: Run) -> Array:
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


def _weight(run: Run) -> Array:
    time, ramp = np.asarray(run.data["time"]), run.scene.load.ramp
    u = np.clip(time / ramp, 0, 1) if ramp > 0 and "gravity-ramp" in run.summary["effects"] else np.ones_like(time)
    load = run.scene.load
    shaken = 1 + load.shake * np.sin(2 * np.pi * load.shake_frequency * time)
    return shaken * u**3 * (10 - 15 * u + 6 * u**2) * run.scene.load.gravity * float(np.sum(_masses(run)))


def _reactions(run: Run) -> Array:
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


RUN, JUDGE = 60.0, 120.0
"""Seconds of the processor that the run of a case may take, and its judge."""


@pytest.mark.parametrize(
    "case", [pytest.param(case, id=case.title, marks=() if case.fast else pytest.mark.slow) for case in CASES]
)
def test_hard_case(case: Case) -> None:
    try:
        with within(RUN):
            run = sc.simulate(case.scene())
    except SceneError as refusal:
        outcome, said = "SceneError", str(refusal)
    else:
        outcome, said = run.outcome.name, f"{run.summary['message']}; {run.summary['advice']}"
        if run.outcome.is_success:
            assert case.judge is not None, "must be refused"
            assert not violations(run)
            with within(JUDGE):
                error = case.judge(run)
            assert error < case.allowed, "a wrong answer returned as success"
            return
    assert outcome in case.refusals, f"must be answered: {outcome}: {said}"
    assert case.says in said


SCENES = {
    "maxwell": asked("maxwell", E=1e3, V=30, T=10, frames=11, numerics={"cells": 20, "rtol": 1e-7}),
    "bingham": asked("bingham", E=1e3, V=30, G=1, T=10, ramp=1, frames=11, numerics={"cells": 20, "rtol": 1e-7}),
    "slack": asked(
        "maxwell", E=1e4, V=1e3, T=5, frames=11, filament={"rest_length": 1.5}, numerics={"cells": 20, "rtol": 1e-7}
    ),
}


@pytest.mark.parametrize("name", ["maxwell", pytest.param("bingham", marks=pytest.mark.slow), "slack"])
def test_every_cell_dissipates_at_every_moment(name: str) -> None:
    """The power that flow takes, cell by cell and not only in all, is never negative."""
    scene = SCENES[name]
    prepared = build(scene, choose_effects(scene))
    solution = prepared.solve(Silence())
    assert solution.outcome.is_success
    graph = prepared.graph
    power = ca.Function("power", [graph.t, graph.x, graph.z, graph.p], [graph.symbolic.powers[0]])
    cells = np.array(
        [
            np.asarray(power(t, x, z, prepared.p)).ravel()
            for t, x, z in zip(solution.time, solution.x.T, solution.z.T, strict=True)
        ]
    )
    assert cells.size >= 10 * 20
    assert cells.max() > 0
    assert cells.min() >= 0
