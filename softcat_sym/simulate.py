"""The whole line: Scene -> Effects -> Equations -> Graph -> Solver -> Trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from softcat_sym.clock import Clock
    from softcat_sym.effects import Effects
    from softcat_sym.scene import Scene
    from softcat_sym.solve import Prepared, Progress
    from softcat_sym.trajectory import Trajectory

_REPEATS = 2


def simulate(scene: Scene, progress: Progress | None = None) -> Trajectory:
    """Run a filament.

    Where the program chooses the effects, the finished run is asked whether what was left out mattered; if it did, the
    run is repeated with that in.

    Parameters
    ----------
    scene : Scene
        What is asked, from :func:`softcat_sym.load_scene` or ``Scene.model_validate``.
    progress : Progress, optional
        Told about simulated time and step size while the integration runs.

    Returns
    -------
    Trajectory
        ``.data`` is an :class:`xarray.Dataset`, ``.summary`` what ``summary.json`` holds, ``.outcome`` the verdict: a
        run that fails or localises returns what it has, with an outcome that is not a success.

    Raises
    ------
    SceneError
        If the scene names effects that it cannot have.
    KeyboardInterrupt
        If the user stops it, wherever in CasADi that happens.
    """
    # Imported here, so that `import softcat_sym` stays light.
    from softcat_sym.clock import Clock
    from softcat_sym.effects import choose_effects
    from softcat_sym.solve import Silence, watched

    clock, listener = Clock(), progress or Silence()
    shown: dict[str, str] = {}
    repeats: list[str] = []
    with watched() as interrupts:
        try:
            trajectory = _run(scene, choose_effects(scene), clock, listener)
            while trajectory.overlooked and len(repeats) < _REPEATS:
                clock.set_aside()
                shown |= trajectory.overlooked
                repeats.append("; ".join(f"{name}: {why}" for name, why in trajectory.overlooked.items()))
                trajectory = _run(scene, choose_effects(scene, shown), clock, listener)
        finally:
            interrupts.check()
    return trajectory.repeated(repeats)


def build(scene: Scene, effects: Effects, clock: Clock | None = None) -> Prepared:
    """Equations -> Graph -> Solver of a scene with given effects; whatever `solve` still needs is ready.

    Parameters
    ----------
    scene : Scene
        What is asked.
    effects : Effects
        From :func:`softcat_sym.effects.choose_effects`.
    clock : Clock
        Told what the compilation took.
    """
    from softcat_sym.solve import choose_backend, prepare, settings_for
    from softcat_sym.solve.assembled import assembled

    backend = choose_backend(scene, effects)
    settings = settings_for(scene, effects, compiled=backend.compiled)
    filament = assembled(scene, effects)
    if clock is not None and backend.compiled:
        clock.lap("build")
    code = filament.code(backend, settings)
    if clock is not None and backend.compiled:
        clock.lap("compile")
    return prepare(scene, filament.graph, settings, filament.at_rest, (backend, code))


def _run(scene: Scene, effects: Effects, clock: Clock, progress: Progress) -> Trajectory:
    """Integrate once with these effects, and judge the answer."""
    from softcat_sym.trajectory import judge

    prepared = build(scene, effects, clock)
    clock.lap("build")
    solution = prepared.solve(progress)
    clock.lap("solve")
    return judge(scene, effects, prepared, solution, clock.laps())
