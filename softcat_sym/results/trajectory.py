"""What a run returns: the trajectory, judged."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import Effects
from softcat_sym.effects.free_vibration import damping_note, ringing
from softcat_sym.results.fields import energy_residual, min_energy, node_positions, whole_span_fields
from softcat_sym.results.motion import SEEN, frames_a_period, regime_of, ringing_at_last, rings_on, seen, too_few_frames
from softcat_sym.results.verdict import measures, missing_effect, rupture_frame, saved, verdict, warnings_of
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Silence, Solution

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Trajectory:
    """A finished run.

    Attributes
    ----------
    scene : Scene
        What was asked.
    data : xarray.Dataset
        Dims ``time``, ``node``, ``cell``; variables in SI units with ``units`` attributes.
    summary : dict
        What ``summary.json`` holds.
    outcome : Outcome
        Whether the answer may be used, and otherwise what to do.
    missing_effect : dict of str to str
        Effects that ``auto`` has left out and that the run shows to matter, and how; empty in what `simulate` returns
        with success.
    heights : ndarray or None
        Midpoint at more times than the frames [m], evenly spaced, where these do not show its ringing.
    """

    scene: Scene
    data: xr.Dataset
    summary: dict[str, Any]
    outcome: Outcome
    missing_effect: dict[str, str]
    heights: Floats | None = field(default=None, compare=False)

    def __repr__(self) -> str:
        told, sizes = self.summary, self.data.sizes
        midpoint = float(self.data["midpoint"].values[-1])
        share = (told.get("error_estimate") or {}).get("total")
        error = "not estimated" if share is None else f"{100 * share:.2g} % of the largest"
        notes = [f"warnings: {len(told['warnings'])}"] if told.get("warnings") else []
        lines = (
            f"Trajectory {self.scene.title!r}: {', '.join([self.outcome.name, *notes])}",
            f"midpoint {midpoint:.4g} m at {float(self.data['time'].values[-1]):.4g} s; error {error}",
            f"regime {told.get('regime') or 'none'}",
            f"effects {', '.join(told.get('effects') or ['not told'])}",
            f".data: {', '.join(f'{name} {count}' for name, count in sizes.items())}; .summary, .scene, .outcome",
        )
        return "\n  ".join(lines)

    def repeated(self, repeats: list[str]) -> Trajectory:
        """The same run as the last of several: each text says what the run before had overlooked."""
        warnings = [*self.summary["warnings"]]
        if len(repeats) > 1:
            warnings.append(f"repeated {len(repeats)} times: an estimate is wrong for this scene, please report it")
        outcome = self.outcome
        if self.missing_effect and outcome.is_success:
            outcome = Outcome.missing_effect
        changed: dict[str, Any] = {"repeats": repeats, "warnings": warnings}
        changed |= {"outcome": outcome.name, "advice": outcome.value}
        if outcome is not self.outcome:
            message = "; ".join(f"{name}: {how}" for name, how in self.missing_effect.items())
            changed |= {"message": message, "regime": None}
        self.data.attrs["outcome"] = outcome.name
        return replace(self, summary=self.summary | changed, outcome=outcome)

    def settled(self, scene: Scene, time: float | None) -> Trajectory:
        """The same run as the answer to a scene that asked to stop when nothing moves any more, and when that was."""
        self.data.attrs["scene"] = scene.to_toml()
        return replace(self, scene=scene, summary=self.summary | {"settled_s": time})

    def estimated(self, told: Mapping[str, Any], warnings: Sequence[str], missed: str) -> Trajectory:
        """The same run with what its companions tell about its error.

        Parameters
        ----------
        told : mapping
            ``error_estimate``, ``resolution``, ``refinements`` and ``wall_s`` of the summary.
        warnings : sequence of str
            What could not be estimated, and what the user fixed that misses the accuracy.
        missed : str
            By how much the accuracy was missed although everything was tried; empty if it was not.
        """
        outcome = Outcome.inaccurate if missed and self.outcome.is_success else self.outcome
        changed: dict[str, Any] = {**told, "outcome": outcome.name, "advice": outcome.value}
        changed["warnings"] = [*self.summary["warnings"], *warnings]
        if outcome is not self.outcome:
            changed |= {"message": missed, "regime": None}
        self.data.attrs |= {"outcome": outcome.name, "wall_s": json.dumps(told["wall_s"])}
        return replace(self, summary=self.summary | changed, outcome=outcome)

    def plot(self, what: str = "midpoint") -> Figure:
        """Draw one picture of the run.

        Parameters
        ----------
        what : str
            ``midpoint``, ``shapes``, ``energy`` or ``space-time``.

        Raises
        ------
        SoftcatError
            If there is no such picture.
        """
        from softcat_sym.plotting.notebook import drawn
        from softcat_sym.plotting.run import FIGURES

        return drawn(FIGURES, what, self.data, self.summary, self.scene)

    def _repr_html_(self) -> str:
        from softcat_sym.plotting.notebook import html

        return html(repr(self), self.plot())

    def save(self, directory: str | Path) -> list[Path]:
        """Write ``trajectory.nc``, ``summary.json`` and ``scene.toml``; files of the same name are replaced whole.

        Raises
        ------
        OSError
            If the directory cannot be made or written.
        """
        from softcat_sym.results.files import write_scene, write_summary, write_trajectory

        folder = Path(directory)
        folder.mkdir(parents=True, exist_ok=True)
        return [
            write_trajectory(self.data, folder),
            write_summary(self.summary, folder),
            write_scene(self.scene.to_toml(), folder),
        ]


def judge(scene: Scene, effects: Effects, prepared: Prepared, solution: Solution, wall: dict[str, float]) -> Trajectory:
    """Turn a raw solution into a Trajectory, and decide whether it may be trusted."""
    from softcat_sym.results.fields import dataset_of

    fields = whole_span_fields(scene, prepared, solution)
    places, time = node_positions(prepared.graph, rest_length(scene)), solution.time * prepared.scale
    residual = energy_residual(fields, min_energy(scene))
    # A sequence of equilibria is exact frame by frame: there the imbalance only tells how far apart the frames are.
    carried = residual if prepared.integration is not None else 0.0
    audited = carried if prepared.graph.conserves_energy else 0.0
    outcome, message = verdict(scene, effects, solution, fields, places[0], audited)
    if outcome is Outcome.ruptured:
        # The run ends there: what follows is no filament.
        sound = max(1, rupture_frame(scene, fields["stretch"]) or 0)
        time, fields = time[:sound], {name: values[:sound] for name, values in fields.items()}
    data = dataset_of(scene, effects, time, places, fields)
    midpoint = fields["y"][:, fields["y"].shape[1] // 2]
    largest = float(np.max(np.abs(midpoint)))
    rings, why = ringing_at_last(scene, effects, prepared, solution, Silence())
    motion = replace(seen(scene, effects, time, places, fields), rings_on=rings_on(scene, rings, largest))
    measured = measures(scene, effects, motion)
    per_period = frames_a_period(time, midpoint, ringing(scene).frequency)
    fades = rings is not None and rings["amplitude"] < SEEN * largest
    warnings = [
        *warnings_of(scene, effects, motion.capillary, places[0], fields, carried),
        *(too_few_frames(time, per_period) if outcome.is_success and not fades else []),
    ]
    summary = {
        "schema": 2,
        "title": scene.title,
        "outcome": outcome.name,
        "advice": outcome.value,
        "message": message,
        # An answer that is not to be trusted has no regime.
        "regime": regime_of(scene, effects, fields, midpoint) if outcome.is_success else None,
        "accuracy": scene.run.accuracy,
        "midpoint_final_m": float(midpoint[-1]),
        "midpoint_largest_m": largest,
        "midpoint_last_fifth_m": float(midpoint[-1] - np.interp(0.8 * time[-1], time, midpoint)),
        "frames_a_period": per_period,
        "midpoint_settled_m": rings,
        "midpoint_settled_why": why,
        "time_final_s": float(time[-1]),
        "settled_s": None,
        "error_estimate": None,
        "resolution": None,
        "refinements": [],
        "energy_residual": residual,
        "effects": dict(effects.reasons),
        "left_out": dict(effects.left_out),
        "checked": {name: measure.value for name, measure in measured.items()},
        "repeats": [],
        "closure": scene.run.closure,
        **_numerics(prepared, solution),
        "converted": [*scene.notes, *filter(None, [damping_note(scene)])],
        "warnings": [*warnings, *saved(scene, effects, measured)],
        "wall_s": wall,
    }
    data.attrs |= {"outcome": outcome.name, "wall_s": json.dumps(wall)}
    return Trajectory(scene, data, summary, outcome, missing_effect(scene, effects, measured, outcome))


def _numerics(prepared: Prepared, solution: Solution) -> dict[str, Any]:
    """What the summary tells of grid and integrator."""
    grid, settings = prepared.graph.grid, prepared.settings
    return {
        "cells": grid.cells if grid.is_half else grid.cells // 2,
        "solver": settings.solver,
        "solver_reason": settings.reason,
        "rtol": settings.rtol,
        "steps": solution.steps,
        "backend": "compiled" if prepared.backend.compiled else "interpreted",
        "backend_reason": prepared.backend.reason,
    }
