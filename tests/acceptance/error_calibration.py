"""Estimated errors beside true ones: a run against the same physics on finer cells, more fibres and shorter steps."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

import softcat_sym as sc
from softcat_sym.effects import choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.graph.grading import choose_grading
from softcat_sym.simulate import without_estimate

from .kept_answers import fingerprint, kept

FINER, MORE_FIBRES, TIGHTER = 2, 2, 10
"""Of the reference: its own errors, by second order, are a quarter of those of the run."""

SOURCES = ("accuracy", "scene", "equations", "effects", "graph", "codegen", "solve", "trajectory", "simulate.py")


@dataclass(frozen=True)
class Calibrated:
    """A scene at an accuracy, its estimated error and its true one.

    Attributes
    ----------
    name : str
        Of the scene.
    accuracy : float
        Asked.
    outcome : str
        Of the run.
    why_not : str
        Why there is nothing to compare; empty if there is.
    true : float
        Largest difference from the reference over the run, relative to the largest midpoint.
    estimate : dict
        As in the summary.
    resolution : dict
        Of the run.
    seconds, estimating : float
        Of its solution, and of all that estimating it took.
    """

    name: str
    accuracy: float
    outcome: str
    why_not: str
    true: float
    estimate: dict[str, float | None]
    resolution: dict[str, Any]
    seconds: float
    estimating: float

    @property
    def ratio(self) -> float:
        """True error over the estimate."""
        total = self.estimate["total"]
        return self.true / total if total else np.inf


def calibrations(scenes: Sequence[tuple[str, sc.Scene]]) -> Iterator[Calibrated]:
    """Calibrate scenes; answers are kept, so that an interrupted study goes on."""
    for name, scene in scenes:
        text = scene.to_toml()
        found = kept((name, text), fingerprint(SOURCES, __file__), lambda text=text, name=name: _asdict(name, text))
        yield Calibrated(**found)


def _asdict(name: str, text: str) -> dict[str, Any]:
    return asdict(calibrated(name, sc.Scene.model_validate(tomllib.loads(text))))


def calibrated(name: str, scene: sc.Scene) -> Calibrated:
    """Run a scene as a user would, and its reference."""
    try:
        run = sc.simulate(scene)
    except SoftcatError as refusal:
        return Calibrated(name, scene.run.accuracy, "refused", str(refusal)[:200], np.nan, {}, {}, 0.0, 0.0)
    told = run.summary
    wall = told["wall_s"]
    common = (told["error_estimate"] or {}, told["resolution"] or {}, wall["solve"], wall["estimate"])
    if not run.outcome.is_success or (told["error_estimate"] or {}).get("total") is None:
        return Calibrated(name, scene.run.accuracy, run.outcome.name, told["complaint"] or "?", np.nan, *common)
    best = sc.simulate(_finer(scene, told))
    if not best.outcome.is_success:
        why = f"reference: {best.outcome.name}"
        return Calibrated(name, scene.run.accuracy, run.outcome.name, why, np.nan, *common)
    found, wanted = run.data.midpoint.values, best.data.midpoint.values
    true = float(np.max(np.abs(found - wanted)) / np.max(np.abs(wanted)))
    return Calibrated(name, scene.run.accuracy, run.outcome.name, "", true, *common)


def _grading(scene: sc.Scene, effects: tuple[str, ...], at: dict[str, Any], cells: int) -> float:
    """That of the run, but for cells at a hinge, which may not become much shorter than the thickness."""
    named = without_estimate(scene.replace({"run.effects": list(effects)})) if scene.run.effects == "auto" else scene
    return min(at["grading"], choose_grading(named, cells, choose_effects(named)))


def _finer(scene: sc.Scene, told: dict[str, Any]) -> sc.Scene:
    """The reference of a run: the physics that was in force, resolved further in every direction."""
    at = told["resolution"]
    cells = FINER * at["cells"]
    changes: dict[str, object] = {
        "numerics.cells": cells,
        "numerics.grading": _grading(scene, tuple(told["effects"]), at, cells),
        "numerics.rtol": at["rtol"] / TIGHTER,
    }
    if scene.run.effects == "auto":
        changes["run.effects"] = list(told["effects"])
    if at["order"] is not None:
        changes["numerics.order"] = MORE_FIBRES * at["order"]
    elif at["fibres"] is not None:
        changes["numerics.fibres"] = MORE_FIBRES * at["fibres"]
    return without_estimate(scene.replace(changes))
