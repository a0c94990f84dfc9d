"""The true error of a run: against the same physics on finer cells, more fibres and shorter steps."""

from __future__ import annotations

import numpy as np

import softcat_sym as sc
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.error_control.control import periods_of
from softcat_sym.error_control.estimate import Judge
from softcat_sym.simulate import without_estimate

FINER, MORE_FIBRES, TIGHTER = 2, 2, 10
"""Of the reference: its own errors, by second order, are a quarter of those of the run."""


def true_error(scene: sc.Scene, run: sc.Run) -> tuple[float, str]:
    """Error of a run by a finer one, measured as the estimate is; or why there is none.

    A ringing that the frames do not show is compared at as many times as the estimate was.
    """
    periods, midpoint = periods_of(run), run.data.midpoint.values if run.heights is None else run.heights
    reference = sc.simulate(_finer(scene, run).replace({"run.frames": len(midpoint)}))
    if not reference.outcome.is_success:
        return np.nan, f"reference: {reference.outcome.name}"
    exact = reference.data.midpoint.values
    return Judge.of(exact, periods, scene.run.accuracy).between(midpoint, exact).size, ""


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
