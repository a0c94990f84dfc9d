"""The whole line: Scene -> Effects -> Equations -> Graph -> Solver -> Run."""

from __future__ import annotations

import warnings
from dataclasses import asdict, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from softcat_sym.effects.choosing import Effects
    from softcat_sym.progress import Clock
    from softcat_sym.results.breaking import Break
    from softcat_sym.results.run import Run
    from softcat_sym.scene.reading import SceneLike
    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.solution import Progress

_REPEATS = 2

_SOMETHING = 2
"""Frames from which an interrupted run shows something."""

_BREAKS, _BORNE = 6, 1e-4
"""Runs in which the instant of a break is sought, and how close to one its load is to be."""

_LONGER = 1.25
"""Times the instant of a break: how far a coarser run is followed, which may break later."""


def simulate(scene: SceneLike, progress: Progress | None = None) -> Run:
    """Run a filament.

    Where the program chooses the effects, it checks on the finished run whether an effect that was left out mattered;
    if one did, the run is repeated with it. Then the error is estimated from companion runs, above all on a coarser
    grid, and the run is refined until the estimate is below ``run.accuracy``; ``numerics.estimate = false`` leaves this
    out.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The scene, the name of a bundled one, the path of a TOML file, or nested tables as a file holds them.
    progress : Progress, optional
        Told which stage begins, and the simulated time while an integration runs.

    Returns
    -------
    Run
        ``.data`` is an :class:`xarray.Dataset`, ``.summary`` what ``summary.json`` holds, ``.outcome`` the verdict: a
        run that fails or localises returns what it has, with an outcome that is not a success.

    Raises
    ------
    SceneError
        If the scene names effects that it cannot have.
    KeyboardInterrupt
        If the user stops it, wherever in CasADi that happens; with a method ``part`` that returns the run as far as it
        came, where it came so far.

    Warns
    -----
    SoftcatWarning
        Before it begins, if it is going to take more than a minute of the processor; and of what speaks against the
        answer, as ``.summary["warnings"]`` has it.
    """
    from softcat_sym.errors import SoftcatWarning
    from softcat_sym.scene.reading import as_scene

    def warn(text: str) -> None:
        warnings.warn(text, SoftcatWarning, stacklevel=3)

    run = simulated(as_scene(scene), progress, warn)
    for text in run.summary["warnings"]:
        warnings.warn(text, SoftcatWarning, stacklevel=2)
    return run


def simulated(scene: Scene, progress: Progress | None = None, announce: Callable[[str], None] | None = None) -> Run:
    """Run a filament as :func:`simulate` does, with warnings in the summary only; `announce` is told a high price."""
    # Imported here, so that `import softcat_sym` stays light.
    from softcat_sym.effects.choosing import choose_effects
    from softcat_sym.solvers.outcome import Outcome
    from softcat_sym.solvers.run_cost import run_cost
    from softcat_sym.solvers.solution import Interrupted, Silence, watched

    finished = list["Run"]()
    try:
        with watched():
            if announce is not None and (price := run_cost(scene, choose_effects(scene))).is_announced:
                announce(f"this run takes long: it {price.text}")
            return _with_all_that_matters(scene, progress or Silence(), finished)
    except KeyboardInterrupt as stopped:
        if not finished and not isinstance(stopped, Interrupted):
            raise
        # Judged here, where no interrupt is noted any more.
        run = finished[-1] if finished else stopped.part()  # type: ignore[attr-defined]
        if len(run.fields["time"]) < _SOMETHING:
            raise
        message = "it was interrupted before its error was known"
        raise Interrupted(lambda: run.revised({}, Outcome.interrupted, message, scene)) from None


def _with_all_that_matters(scene: Scene, progress: Progress, finished: list[Run]) -> Run:
    """Run, estimate, and repeat with what the finished run calls for."""
    from softcat_sym.effects.choosing import choose_effects
    from softcat_sym.error_control.control import as_accurate_as_asked, frames_of_first
    from softcat_sym.progress import Clock
    from softcat_sym.single_run import rest_of, run_once
    from softcat_sym.solvers.outcome import Outcome

    clock, shown, repeats = Clock(), dict[str, str](), list[str]()
    while True:
        effects, ends, until = choose_effects(scene, shown), None, scene
        if scene.run.until == "settled":
            ends = rest_of(scene, effects, progress)
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
            run = _up_to_its_fall(run, effects, clock, progress)
        last = len(repeats) == _REPEATS or not run.missing_effect
        if last and scene.numerics.estimate:
            run = as_accurate_as_asked(run, effects, clock, progress)
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
    from softcat_sym.solvers.outcome import Outcome

    warnings = [*run.summary["warnings"]]
    if len(repeats) > 1:
        warnings.append(f"repeated {len(repeats)} times: an estimate is wrong for this scene, please report it")
    message = "; ".join(f"{name}: {how}" for name, how in run.missing_effect.items())
    changes = {"repeats": repeats, "warnings": warnings}
    return run.revised(changes, Outcome.missing_effect if message else None, message)


def _in_space(scene: Scene, run: Run, progress: Progress, finished: list[Run]) -> Run | None:
    """The run in three dimensions, where the planar one would not stay in its plane and nobody asked that it does."""
    from softcat_sym.results.sideways import Sideways, seeded

    found = run.summary["sideways"]
    moved = seeded(scene) if found else None
    if moved is None:
        return None
    progress.stage("again, in three dimensions: it is unstable sideways")
    finished.clear()
    spatial, planar = _with_all_that_matters(moved, progress, finished), Sideways(**found)
    changes = {"sideways": found, "dimensions_reason": f"in its plane it is {planar.found}"}
    return spatial.revised({**changes, "warnings": [*spatial.summary["warnings"], planar.followed]})


def _up_to_its_fall(run: Run, effects: Effects, clock: Clock, progress: Progress) -> Run:
    """Follow a filament that falls for ever again, with its frames spaced evenly up to where its run ended."""
    from softcat_sym.single_run import run_once

    clock.set_aside()
    progress.stage("again, up to its fall")
    brief = run.scene.replace({"run.duration": f"{run.summary['descends']['time_s']!r} s"})
    return _descended(run_once(brief, brief, effects, clock, progress), brief)


def _descended(run: Run, scene: Scene) -> Run:
    """The answer to a scene whose filament falls for ever: up to when, how far and how fast."""
    import numpy as np

    from softcat_sym.solvers.outcome import Outcome

    time, midpoint = run.fields["time"], run.fields["midpoint"]
    rate = float(np.gradient(midpoint, time, edge_order=2)[-1])
    end = {"time_s": float(time[-1]), "midpoint_m": float(midpoint[-1]), "rate_m_per_s": rate}
    message = (
        f"it falls for ever: the run ends after {time[-1]:.4g} s, with the midpoint at {midpoint[-1]:.4g} m, "
        f"moving at {rate:.4g} m/s"
    )
    changes = {"descends": end, "midpoint_settled_m": None, "midpoint_settled_why": "it falls for ever"}
    return replace(run, outcome=Outcome.solved).revised(changes, Outcome.descends, message, scene)


def _up_to_its_break(run: Run, effects: Effects, clock: Clock, progress: Progress) -> tuple[Run, Break]:
    """Follow a filament that breaks again, with its frames spaced evenly up to then.

    The instant is interpolated between frames, and moved by the rate of the load until that is what it bears.
    """
    from softcat_sym.error_control.control import frames_of_first
    from softcat_sym.results.breaking import break_at_end, break_frame, first_break, refuse_broken, unbreakable
    from softcat_sym.single_run import run_once

    scene, end = run.scene, first_break(run.scene, run.fields)
    if end is None or break_frame(scene, run.fields) == 0:
        refuse_broken(scene)
    for _ in range(_BREAKS):
        clock.set_aside()
        progress.stage("again, up to its break")
        brief = unbreakable(scene).replace({"run.duration": f"{end.time_s!r} s"})
        run = run_once(brief, brief, effects, clock, progress, frames_of_first(brief, effects))
        if not run.outcome.is_success:
            break
        end, load = break_at_end(scene, run.fields, end.rate_per_s)
        if abs(load - 1) <= _BORNE:
            break
    return run, end


def _broken(answer: Run, scene: Scene, until: Scene, end: Break, effects: Effects) -> Run:
    """The answer of a filament that breaks, at the end that is its load, with the error of the instant."""
    from softcat_sym.results.breaking import break_at_end
    from softcat_sym.solvers.outcome import Outcome

    end, load = break_at_end(scene, answer.fields, end.rate_per_s)
    end = replace(end, time_error_s=_time_error(answer, until, end, effects))
    changes = {"broken": asdict(end), "midpoint_settled_m": None, "midpoint_settled_why": "it breaks"}
    outcome, message = Outcome.broken, end.text
    if abs(load - 1) > scene.run.accuracy:
        outcome, message = Outcome.inaccurate, f"{end.text}, but bears {load:.3g} of its limit then"
    return answer.revised(changes, outcome, message, scene)


def _time_error(answer: Run, until: Scene, end: Break, effects: Effects) -> float | None:
    """How much sooner or later a filament breaks on half the cells, in longer steps; None where nothing is estimated.

    The answer errs by so much if its error halves with the cells, and by a third of it if that falls with their square.
    Where the coarser filament does not break, the instant is as uncertain as it is late.
    """
    from softcat_sym.error_control.control import frames_of_first
    from softcat_sym.error_control.estimate import LOOSER, Resolution
    from softcat_sym.progress import Clock
    from softcat_sym.results.breaking import first_break
    from softcat_sym.single_run import run_once
    from softcat_sym.solvers.solution import Silence

    if not answer.outcome.is_success or answer.summary["error_estimate"] is None:
        return None
    at = Resolution(**answer.summary["resolution"])
    longer = until.replace({"run.duration": f"{min(until.run.duration, _LONGER * end.time_s)!r} s"})
    beside = replace(at, cells=max(1, at.cells // 2), rtol=min(LOOSER * at.rtol, 0.5)).of(longer)
    found = first_break(
        beside, run_once(beside, beside, effects, Clock(), Silence(), frames_of_first(beside, effects)).fields
    )
    return end.time_s if found is None else abs(found.time_s - end.time_s)


def identity_of(scene: Scene) -> tuple[str, list[str], list[str]]:
    """Return what decides a run, for the key of its result: the scene as resolved (no title), and who compiles it."""
    from softcat_sym.codegen.compiler import build_identity

    compiled_by = [] if scene.numerics.backend == "interpreted" else build_identity()
    return scene.model_copy(update={"title": ""}).to_toml(), list(scene.notes), compiled_by


def recalled(scene: Scene, progress: Progress | None = None) -> Run:
    """Run a filament for a study: as :func:`simulated`, but taken from the store if it was run before."""
    from softcat_sym import store
    from softcat_sym.results.run import run_form

    key = store.key_of("run", identity_of(scene))
    return store.stored(key, lambda: simulated(scene, progress), run_form(scene))


def without_estimate(scene: Scene) -> Scene:
    """The same scene, run once and at the program's first guess: for runs whose error something else bounds."""
    return scene.replace({"numerics.estimate": False})
