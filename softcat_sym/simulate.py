"""The whole line: Scene -> Effects -> Equations -> Graph -> Solver -> Run."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

from softcat_sym.lazy import lazy_imports

if TYPE_CHECKING:
    from collections.abc import Callable

    from softcat_sym.results.run import Run
    from softcat_sym.scene.reading import Changes, SceneLike
    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.solution import Progress

# So that `import softcat_sym` stays light.
with lazy_imports():
    from softcat_sym import errors, store
    from softcat_sym.codegen import compiler
    from softcat_sym.effects import selection
    from softcat_sym.error_control import consistency
    from softcat_sym.results import run as finished_runs
    from softcat_sym.scene import reading
    from softcat_sym.solvers import outcome, run_cost, solution

_SOMETHING = 2
"""Frames from which an interrupted run shows something."""


def simulate(scene: SceneLike, changes: Changes = (), *, progress: Progress | None = None) -> Run:
    """Run a filament.

    Where the program chooses the effects, it checks on the finished run whether an effect that was left out mattered;
    if one did, the run is repeated with it. Then the error is estimated from companion runs, above all on a coarser
    grid, and the run is refined until the estimate is below ``run.accuracy``; ``numerics.estimate = false`` leaves this
    out.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The scene, the name of a bundled one, the path of a TOML file, or nested tables as a file holds them.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.
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

    def warn(text: str) -> None:
        warnings.warn(text, errors.SoftcatWarning, stacklevel=3)

    run = simulated(reading.as_scene(scene, changes), progress, warn)
    for text in run.summary["warnings"]:
        warnings.warn(text, errors.SoftcatWarning, stacklevel=2)
    return run


def simulated(scene: Scene, progress: Progress | None = None, announce: Callable[[str], None] | None = None) -> Run:
    """Run a filament as :func:`simulate` does, with warnings in the summary only; `announce` is told a high price."""
    finished = list["Run"]()
    try:
        with solution.watched():
            if announce is not None:
                price = run_cost.run_cost(scene, selection.choose_effects(scene))
                if price.is_announced:
                    announce(f"this run takes long: it {price.text}")
            return consistency.run_until_consistent(scene, progress or solution.Silence(), finished)
    except KeyboardInterrupt as stopped:
        if not finished and not isinstance(stopped, solution.Interrupted):
            raise
        # Judged here, where no interrupt is noted any more.
        run = finished[-1] if finished else stopped.part()  # type: ignore[attr-defined]
        if len(run.fields["time"]) < _SOMETHING:
            raise
        message = "it was interrupted before its error was known"
        raise solution.Interrupted(lambda: run.revised({}, outcome.Outcome.interrupted, message, scene)) from None


def identity_of(scene: Scene) -> tuple[str, list[str], list[str]]:
    """Return what decides a run, for the key of its result: the scene as resolved (no title), and who compiles it."""
    compiled_by = [] if scene.numerics.backend == "interpreted" else compiler.build_identity()
    return scene.model_copy(update={"title": ""}).to_toml(), list(scene.notes), compiled_by


def recalled(scene: Scene, progress: Progress | None = None) -> Run:
    """Run a filament for a study: as :func:`simulated`, but taken from the store if it was run before."""
    key = store.key_of("run", identity_of(scene))
    return store.stored(key, lambda: simulated(scene, progress), finished_runs.run_form(scene))


def without_estimate(scene: Scene) -> Scene:
    """The same scene, run once and at the program's first guess: for runs whose error something else bounds."""
    return scene.replace({"numerics.estimate": False})
