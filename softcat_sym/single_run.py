"""One run: Equations -> Graph -> Solver -> Run, with given effects at a given resolution."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from softcat_sym.discretization.assembly import choose_cells
from softcat_sym.effects.selection import Effects
from softcat_sym.progress import Stopwatch
from softcat_sym.results.breaking import break_frame, breakable
from softcat_sym.results.fields import dense_fields, node_positions, whole_span_fields
from softcat_sym.results.motion import settling_time
from softcat_sym.results.observed import DISPLACEMENT, Watched
from softcat_sym.results.run import Run, judge
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import choose_backend, settings_for
from softcat_sym.solvers.solution import Interrupted, Progress, Silence, Solution
from softcat_sym.solvers.solve import Prepared, assembled, prepare

_MIN_CELLS = 8

TRIES, TIGHTER = 3, 30.0
"""Runs that end by a step too long for them, and how much tighter each is than the one before."""

STEP_SIZE_OUTCOMES = (Outcome.energy_drift, Outcome.non_finite)
"""Outcomes that shorter steps may cure."""


def build(scene: Scene, effects: Effects, clock: Stopwatch | None = None, progress: Progress | None = None) -> Prepared:
    """Equations -> Graph -> Solver of a scene with given effects; whatever `solve` still needs is ready."""
    listener = progress or Silence()
    listener.doing("building")
    backend = choose_backend(scene, effects)
    settings = settings_for(scene, effects, compiled=backend.compiled)
    filament = assembled(scene, effects, backend)
    if clock is not None and backend.compiled:
        clock.lap("build")
    if backend.compiled:
        listener.doing("compiling")
    if filament.code is not None and clock is not None:
        clock.lap("compile")
    return prepare(scene, filament.graph, settings, filament)


def run_once(
    scene: Scene,
    resolved: Scene,
    effects: Effects,
    clock: Stopwatch,
    progress: Progress,
    times: int = 0,
    watched: Watched | None = None,
) -> Run:
    """Integrate once, and judge the answer; what is to be compared of it is `watched`, or what it shows is largest."""
    times = max(times, scene.run.frames)
    stride = (times - 1) // (scene.run.frames - 1)
    tried = resolved if stride == 1 else resolved.replace({"run.frames": times})
    for left in reversed(range(TRIES)):
        prepared = build(tried, effects, clock, progress)
        clock.lap("build")
        progress.doing("solving" if left == TRIES - 1 else "solving again, in shorter steps")
        try:
            every = solution = prepared.solve(progress)
        except Interrupted as stopped:
            part = _thinned(stopped.part(), prepared, stride)
            raise Interrupted(partial(judge, scene, effects, prepared, part, clock.laps())) from None
        clock.lap("solve")
        progress.doing("checking the answer")
        try:
            # What rings may break between two frames.
            if stride > 1 and not _breaks(scene, prepared, solution):
                solution = _thinned(solution, prepared, stride)
            trajectory = judge(scene, effects, prepared, solution, clock.laps())
        except KeyboardInterrupt:
            part = _thinned(every.integrated(prepared.scale), prepared, stride)
            raise Interrupted(partial(judge, scene, effects, prepared, part, clock.laps())) from None
        # CasADi's Rosenbrock method does not say whether a stage was undefined.
        undefined = trajectory.outcome is Outcome.no_convergence and not prepared.backend.compiled
        too_long = undefined or trajectory.outcome in STEP_SIZE_OUTCOMES
        if not too_long or scene.numerics.rtol is not None or not left:
            break
        # Flow that relaxes within a step is right at its end, but not the work inside; and a stage far outside what is
        # elastic may be undefined, where the step is too long: both ask for shorter ones.
        tried = tried.replace({"numerics.rtol": prepared.settings.rtol / TIGHTER})
    watched = trajectory.watched.where(watched)
    series = watched.series(scene, prepared, every) if trajectory.outcome.is_success else {}
    fields = trajectory.fields
    if series and len(every.time) > len(solution.time):
        fields = {**fields, **dense_fields(scene, prepared, every)}
    watched = watched.between_frames(series, stride)
    displacement, scale = trajectory.summary["displacement"], watched.scale[DISPLACEMENT]
    displacement = displacement | {
        "scale_m": scale,
        "largest_m": displacement["largest_m"] + scale - displacement["scale_m"],
    }
    summary = trajectory.summary | {"displacement": displacement}
    return replace(trajectory, fields=fields, watched=watched, series=series, summary=summary)


def _breaks(scene: Scene, prepared: Prepared, solution: Solution) -> bool:
    """Whether a filament reaches what it bears at any of the output times."""
    nodes, cells = node_positions(prepared.graph, rest_length(scene))
    return breakable(scene) and (
        break_frame(scene, whole_span_fields(scene, prepared, solution) | {"X_node": nodes, "X_cell": cells})
        is not None
    )


def _thinned(solution: Solution, prepared: Prepared, stride: int) -> Solution:
    """The solution at the frames that the scene asks for."""
    if stride == 1:
        return solution
    frames = (len(prepared.times) - 1) // stride + 1
    return solution.every(stride, np.linspace(0.0, float(prepared.times[-1]), frames))


def settling_time_of(scene: Scene, effects: Effects, progress: Progress) -> float | None:
    """When a filament has settled [s], found on half the cells: its frames are spaced evenly up to then."""
    coarse = scene.replace({"numerics.cells": max(_MIN_CELLS, choose_cells(scene, effects) // 2)})
    return settling_time(coarse, effects, build(coarse, effects), progress)
