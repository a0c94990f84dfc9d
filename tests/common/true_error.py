"""The true error of a run: against the same physics on finer cells, more fibres and shorter steps."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.interpolate import CubicSpline

import softcat_sym as sc
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.effects.selection import choose_effects
from softcat_sym.error_control.control import periods_of
from softcat_sym.error_control.estimate import Judge
from softcat_sym.results.observed import DISPLACEMENT, Series
from softcat_sym.scene.scene import rest_length
from softcat_sym.simulate import without_estimate

FINER, MORE_FIBRES, TIGHTER = 2, 2, 10
"""Of the reference: its own errors, by second order, are a quarter of those of the run."""


def true_error(scene: sc.Scene, run: sc.Run) -> tuple[float, str]:
    """Error of a run by a finer one, measured as the estimate is; or why there is none.

    A ringing that the frames do not show is compared at as many times as the estimate was.
    """
    sizes, why_not = true_errors(scene, run)
    return sizes.get(DISPLACEMENT, np.nan), why_not


def true_errors(scene: sc.Scene, run: sc.Run) -> tuple[Mapping[str, float], str]:
    """Errors of all that a run is compared by, relative to the largest of each; none if there is no reference."""
    reference = sc.simulate(_finer(scene, run).replace({"run.frames": len(run.series[DISPLACEMENT])}))
    if not reference.outcome.is_success:
        return {}, f"reference: {reference.outcome.name}"
    exact = _series(reference, run)
    return Judge.of(exact, run.watched, periods_of(run), scene.run.accuracy).between(run.series, exact).sizes, ""


def _series(reference: sc.Run, run: sc.Run) -> Series:
    """What a run is compared by, of the fields of another."""
    fields, length, found = reference.fields, rest_length(run.scene), dict[str, np.ndarray]()

    def at(name: str, places: str, where: float) -> np.ndarray:
        return np.asarray(CubicSpline(fields[places] / length, fields[name], axis=1)(where))

    columns = run.series[DISPLACEMENT].shape[1]
    for name, where in run.watched.at.items():
        if name == DISPLACEMENT:
            nodes = dict.fromkeys((0.0, where))
            rows = [at(axis, "X_node", node) for node in nodes for axis in "xyz" if axis in fields]
            # The middle of a symmetric filament moves only up and down, and is compared so.
            found[name] = np.stack(rows[-columns:], axis=-1)
        elif name == "turn":
            found[name] = 2 * at("quaternion", "X_node", where)
        else:
            field, places = ("z", "X_node") if name == "sideways" else ("torque", "X_cell")
            found[name] = at(field, places, where)[:, None]
    return found


def _finer(scene: sc.Scene, run: sc.Run) -> sc.Scene:
    """The physics that was in force, resolved further in every direction, run once."""
    at = run.summary["resolution"]
    changes: dict[str, object] = {"numerics.cells": FINER * at["cells"], "numerics.rtol": at["rtol"] / TIGHTER}
    if scene.run.effects == "auto":
        changes["run.effects"] = list(run.summary["effects"])
    name = "order" if at["order"] is not None else "fibres"
    if at[name] is not None:
        changes[f"numerics.{name}"] = at[name] and MORE_FIBRES * at[name]
    finer = without_estimate(scene.replace(changes))
    # The grading of the run, but for cells at a hinge, which may not become much shorter than the thickness.
    effects = {"run.effects": list(run.summary["effects"])}
    named = without_estimate(scene.replace(effects)) if scene.run.effects == "auto" else scene
    grading = min(at["grading"], choose_grading(named, FINER * at["cells"], choose_effects(named)))
    return finer.replace({"numerics.grading": grading})
