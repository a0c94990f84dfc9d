"""A run, repeated with what it calls for: effects that matter, another dimension, up to its fall or its break."""

from __future__ import annotations

from dataclasses import asdict, replace

import numpy as np

from softcat_sym.effects.selection import Effects, choose_effects
from softcat_sym.error_control.control import frames_of_first, refine_to_accuracy
from softcat_sym.error_control.estimate import LOOSER, Resolution
from softcat_sym.progress import Stopwatch
from softcat_sym.results.breaking import Break, break_at_end, break_frame, first_break, refuse_broken, unbreakable
from softcat_sym.results.out_of_plane_stability import OutOfPlaneInstability, perturbed_3d_scene
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.single_run import run_once, settling_time_of
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Progress, Silence

_REPEATS = 2

MAX_BREAK_SEARCH, BREAK_LOAD_TOLERANCE = 6, 1e-4
"""Runs in which the instant of a break is sought, and how close to one its load is to be."""

_LONGER = 1.25
"""Times the instant of a break: how far a coarser run is followed, which may break later."""


def run_until_consistent(scene: Scene, progress: Progress, finished: list[Run]) -> Run:
    """Run, estimate, and repeat with what the finished run calls for."""
    clock, shown, repeats = Stopwatch(), dict[str, str](), list[str]()
    while True:
        effects, ends, until = choose_effects(scene, shown), None, scene
        if scene.run.until == "settled":
            ends = settling_time_of(scene, effects, progress)
            clock.lap("estimate")
            until = scene if ends is None else scene.replace({"run.duration": f"{ends!r} s"})
        run = run_once(until, until, effects, clock, progress, frames_of_first(until, effects))
        finished.append(run)
        aside = _in_space(scene, run, progress, finished)
        if aside is not None:
            return aside
        end = None
        if run.outcome is Outcome.broken:
            run, end = _up_to_its_break(run, effects, clock, progress)
        falls = run.outcome is Outcome.descends
        if falls:
            # Again, with frames spaced evenly up to where it ended.
            clock.set_aside()
            progress.stage("again, up to its fall")
            brief = run.scene.replace({"run.duration": f"{run.summary['descends']['time_s']!r} s"})
            run = _descended(run_once(brief, brief, effects, clock, progress), brief)
        last = len(repeats) == _REPEATS or not run.missing_effect
        if last and scene.numerics.estimate:
            run = refine_to_accuracy(run, effects, clock, progress)
            aside = _in_space(scene, run, progress, finished)
            if aside is not None:
                return aside
        # A refined run may show more.
        if not run.missing_effect or len(repeats) == _REPEATS:
            answer = _repeated(run, repeats).revised({"settled_s": ends}, scene=scene)
            if falls:
                return _descended(answer, scene)
            return answer if end is None else _broken(answer, scene, until, end, effects)
        clock.set_aside()
        progress.stage(f"again, with {', '.join(run.missing_effect)}")
        shown |= run.missing_effect
        repeats.append("; ".join(f"{name}: {why}" for name, why in run.missing_effect.items()))


def _repeated(run: Run, repeats: list[str]) -> Run:
    """The same run as the last of several: each text says what the run before had overlooked."""
    warnings = [*run.summary["warnings"]]
    if len(repeats) > 1:
        warnings.append(f"repeated {len(repeats)} times: an estimate is wrong for this scene, please report it")
    message = "; ".join(f"{name}: {how}" for name, how in run.missing_effect.items())
    changes = {"repeats": repeats, "warnings": warnings}
    return run.revised(changes, Outcome.missing_effect if message else None, message)


def _in_space(scene: Scene, run: Run, progress: Progress, finished: list[Run]) -> Run | None:
    """The run in three dimensions, where the planar one would not stay in its plane and nobody asked that it does."""
    found = run.summary["sideways"]
    moved = perturbed_3d_scene(scene) if found else None
    if moved is None:
        return None
    progress.stage("again, in three dimensions: it is unstable sideways")
    finished.clear()
    spatial, planar = run_until_consistent(moved, progress, finished), OutOfPlaneInstability(**found)
    changes = {"sideways": found, "dimensions_reason": f"in its plane it is {planar.found}"}
    return spatial.revised({**changes, "warnings": [*spatial.summary["warnings"], planar.followed]})


def _descended(run: Run, scene: Scene) -> Run:
    """The answer to a scene whose filament falls for ever: up to when, how far and how fast."""
    time, midpoint = run.fields["time"], run.fields["midpoint"]
    rate = float(np.gradient(midpoint, time, edge_order=2)[-1])
    end = {"time_s": float(time[-1]), "midpoint_m": float(midpoint[-1]), "rate_m_per_s": rate}
    message = (
        f"it falls for ever: the run ends after {time[-1]:.4g} s, with the midpoint at {midpoint[-1]:.4g} m, "
        f"moving at {rate:.4g} m/s"
    )
    changes = {"descends": end, "midpoint_settled_m": None, "midpoint_settled_why": "it falls for ever"}
    return replace(run, outcome=Outcome.solved).revised(changes, Outcome.descends, message, scene)


def _up_to_its_break(run: Run, effects: Effects, clock: Stopwatch, progress: Progress) -> tuple[Run, Break]:
    """Follow a filament that breaks again, with its frames spaced evenly up to then.

    The instant is interpolated between frames, and moved by the rate of the load until that is what it bears.
    """
    scene, end = run.scene, first_break(run.scene, run.fields)
    if end is None or break_frame(scene, run.fields) == 0:
        refuse_broken(scene)
    for _ in range(MAX_BREAK_SEARCH):
        if end.time_s <= 0:
            refuse_broken(scene)
        clock.set_aside()
        progress.stage("again, up to its break")
        brief = unbreakable(scene).replace({"run.duration": f"{end.time_s!r} s"})
        run = run_once(brief, brief, effects, clock, progress, frames_of_first(brief, effects))
        if not run.outcome.is_success:
            break
        end, load = break_at_end(scene, run.fields, end.rate_per_s)
        if abs(load - 1) <= BREAK_LOAD_TOLERANCE:
            break
    return run, end


def _broken(answer: Run, scene: Scene, until: Scene, end: Break, effects: Effects) -> Run:
    """The answer of a filament that breaks, at the end that is its load, with the error of the instant.

    It is how much sooner or later the filament breaks on half the cells, in longer steps: as much as the answer errs if
    its error halves with the cells, and three times as much if that falls with their square. Where the coarser filament
    does not break, the instant is as uncertain as it is late.
    """
    end, load = break_at_end(scene, answer.fields, end.rate_per_s)
    if answer.outcome.is_success and answer.summary["error_estimate"] is not None:
        at = Resolution(**answer.summary["resolution"])
        longer = until.replace({"run.duration": f"{min(until.run.duration, _LONGER * end.time_s)!r} s"})
        beside = replace(at, cells=max(1, at.cells // 2), rtol=min(LOOSER * at.rtol, 0.5)).of(longer)
        run = run_once(beside, beside, effects, Stopwatch(), Silence(), frames_of_first(beside, effects))
        found = first_break(beside, run.fields)
        end = replace(end, time_error_s=end.time_s if found is None else abs(found.time_s - end.time_s))
    changes = {"broken": asdict(end), "midpoint_settled_m": None, "midpoint_settled_why": "it breaks"}
    outcome, message = Outcome.broken, end.text
    if abs(load - 1) > scene.run.accuracy:
        outcome, message = Outcome.inaccurate, f"{end.text}, but bears {load:.3g} of its limit then"
    return answer.revised(changes, outcome, message, scene)
