"""How far a run is from the truth: over the largest midpoint, at every frame where the truth is a history."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import numpy.typing as npt

import softcat_sym as sc
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.simulate import without_estimate

Array = npt.NDArray[np.float64]
Judge = Callable[[Trajectory], float]


def heights(run: Trajectory) -> Array:
    """Midpoint over span."""
    return np.asarray(run.data["midpoint"]) / run.scene.filament.span


def times(run: Trajectory) -> Array:
    """In sqrt(L/g)."""
    return np.asarray(run.data["time"]) / np.sqrt(run.scene.filament.span / run.scene.load.gravity)


def ends_at(sag: float) -> Judge:
    """Error of the last midpoint against a sag over the span."""
    return lambda run: abs(heights(run)[-1] + sag) / sag


def follows(history: Callable[[Array], Array]) -> Judge:
    """Largest error against heights over the span at times in sqrt(L/g)."""

    def error(run: Trajectory) -> float:
        return _apart(heights(run), history(times(run)))

    return error


def moves_like(other: sc.Scene) -> Judge:
    """Largest difference from a limiting case, or from the same scene by another way; its run must be a success."""

    def error(run: Trajectory) -> float:
        return _apart(heights(run), _answer(other))

    return error


def ends_like(other: sc.Scene) -> Judge:
    """Difference of the last midpoint from that of another scene."""

    def error(run: Trajectory) -> float:
        return _apart(heights(run)[-1:], _answer(other)[-1:])

    return error


def refined(run: Trajectory) -> float:
    """Error by Richardson, second order, from half as many cells and fibres more at a tenth of the tolerance."""
    at = run.summary["resolution"]
    finer = {"cells": 3 * at["cells"] // 2, "rtol": run.summary["rtol"] / 10}
    if at["fibres"]:
        finer["fibres"] = 3 * at["fibres"] // 4 * 2
    scene = without_estimate(run.scene.replace({f"numerics.{name}": value for name, value in finer.items()}))
    again = sc.simulate(scene.replace({"run.effects": list(run.summary["effects"])}))
    assert again.outcome.is_success, f"the finer run: {again.outcome.name}, {again.summary['message']}"
    return _apart(heights(run), heights(again)) / (1 - (2 / 3) ** 2)


def _apart(ours: Array, truth: Array) -> float:
    if len(ours) != len(truth):
        return float("inf")
    return float(np.max(np.abs(ours - truth)) / np.max(np.abs(truth)))


@cache
def _answer(scene: sc.Scene) -> Array:
    run = sc.simulate(scene)
    assert run.outcome.is_success, f"the limiting case: {run.outcome.name}, {run.summary['message']}"
    return heights(run)
