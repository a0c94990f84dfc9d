"""The whole line: Scene -> Effects -> Equations -> Graph -> Solver -> Trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from softcat_sym.graph import Graph
    from softcat_sym.scene import Scene
    from softcat_sym.solve import Progress
    from softcat_sym.trajectory import Trajectory


def simulate(scene: Scene, progress: Progress | None = None) -> Trajectory:
    """Run a filament.

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
    """
    # Imported here, so that `import softcat_sym` stays light.
    from softcat_sym.clock import Clock
    from softcat_sym.effects import choose_effects
    from softcat_sym.equations.filament import derive
    from softcat_sym.equations.section import SECTIONS
    from softcat_sym.graph import assemble
    from softcat_sym.graph.choosing import choose_body, choose_grid, choose_theory
    from softcat_sym.solve import Silence, choose_settings, prepare
    from softcat_sym.trajectory import judge

    clock = Clock()
    effects = choose_effects(scene)
    equations = derive(effects.terms(), SECTIONS[scene.filament.section], scene.run.closure)
    grid = choose_grid(scene)
    graph = assemble(equations, grid, effects.names, choose_theory(scene, equations), choose_body(scene, grid))

    def statics() -> Graph:
        still = derive(effects.at_rest(), SECTIONS[scene.filament.section], scene.run.closure)
        return assemble(still, grid, effects.names, choose_theory(scene, still), choose_body(scene, grid))

    prepared = prepare(scene, graph, choose_settings(scene, effects), statics)
    clock.lap("build")
    solution = prepared.solve(progress or Silence())
    clock.lap("solve")
    return judge(scene, effects, prepared, solution, clock.laps())
