"""Whether the filament that fits best may be trusted: one run of each, judged as any run is."""

from __future__ import annotations

from softcat_sym.errors import SceneError
from softcat_sym.inverse.estimation.least_squares import Floats
from softcat_sym.inverse.filament_problem import FilamentProblem, Filmed
from softcat_sym.inverse.forward.free import TIME_OFFSET
from softcat_sym.scene import Scene
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.solve import Outcome


def judged_runs(problem: FilamentProblem, q: Floats) -> tuple[Outcome, str]:
    """Run every film's filament for as long as it was filmed, and judge it.

    Residuals show neither a neck that the grid decides nor lost energy.

    Parameters
    ----------
    problem : FilamentProblem
        What was fitted.
    q : ndarray, shape (k,)
        Its optimum.

    Returns
    -------
    Outcome, str
        The worst of the films, a localised one before all others, and what speaks against it; empty if nothing does.
    """
    worst, told = Outcome.solved, []
    for number, film in enumerate(problem.films, start=1):
        outcome, complaint = _judged(film, _run_scene(problem, film, q))
        if outcome.is_success:
            continue
        name = film.series.path.name if film.series.path else f"film {number}"
        told.append(f"{name}: {complaint}" if len(problem.films) > 1 else complaint)
        worst = worst if worst is Outcome.localised else outcome
    return worst, "; ".join(told)


def _judged(film: Filmed, scene: Scene | None) -> tuple[Outcome, str]:
    if scene is None:
        return Outcome.solved, ""
    try:
        run = simulated(without_estimate(scene))
    except SceneError as refusal:
        return Outcome.no_equilibrium, str(refusal)
    return run.outcome, str(run.summary["complaint"])


def _run_scene(problem: FilamentProblem, film: Filmed, q: Floats) -> Scene | None:
    """The film's own scene with the fitted values and the effects of the fit; None if nothing moves while it lasts."""
    begin = sum(problem.free[k].value(float(q[k])) for k in film.columns if problem.free[k].path == TIME_OFFSET)
    duration = float(film.time.max()) - begin
    if not duration > 0:
        return None
    scene = film.model.scene(q[list(film.columns)])
    return scene.replace({"run.effects": list(film.model.effects), "run.duration": f"{duration!r} s"})
