"""From films of falling filaments to their material: the whole line of a fit."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Protocol

import numpy as np

from softcat_sym.effects import REGISTRY, choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.inverse.closed_form.inversion import closed_form
from softcat_sym.inverse.defaults import MOST_STARTS, STARTS
from softcat_sym.inverse.estimation.inference import infer
from softcat_sym.inverse.estimation.least_squares import LINEAR, Floats, Loss
from softcat_sym.inverse.estimation.multi_start import multi_start
from softcat_sym.inverse.estimation.optimise import Optimum
from softcat_sym.inverse.estimation.residual_checks import ResidualChecks, check_residuals
from softcat_sym.inverse.estimation.verdicts import Verdict
from softcat_sym.inverse.features import Features, read_features
from softcat_sym.inverse.features.features import FEWEST
from softcat_sym.inverse.filament_problem import FilamentProblem
from softcat_sym.inverse.fit_outcome import FitOutcome
from softcat_sym.inverse.fitted import Fit, FittedFilm, fitted_parameter, told
from softcat_sym.inverse.fitted_run import judged_runs
from softcat_sym.inverse.forward.substituting import with_values
from softcat_sym.inverse.measurements.films import Films, taken
from softcat_sym.inverse.measurements.plausibility import own_scene
from softcat_sym.inverse.measurements.series import Measurements, Series
from softcat_sym.scene import Scene, SceneLike, as_scene, rest_length
from softcat_sym.solve import Outcome

ASIDE = "rotary-inertia"
"""What "everything" leaves aside: followed through hinges it takes many times as long."""

# Of a normal distribution, over the median of magnitudes; the floor is for data that are met exactly.
_MEDIAN_TO_DEVIATION, _LEAST_NOISE = 1.4826, 1e-9

_RESTARTED = "a profile met a better optimum on the way, and the fit began again from there"


class FitProgress(Protocol):
    """Whoever wants to know how far a fit has come."""

    def stage(self, name: str, done: int, total: int) -> None:
        """Hear of a stage."""


class NoProgress:
    """Nobody."""

    def stage(self, name: str, done: int, total: int) -> None:
        """Say nothing."""


@dataclass(frozen=True)
class _Asked:
    """How a fit is to be done."""

    free: tuple[str, ...]
    bounds: Mapping[str, tuple[object, object]] | None
    loss: Loss
    starts: int
    profiles: bool
    backend: str
    rtol: float | None
    seed: int
    progress: FitProgress


def fit(
    measurements: Films,
    scene: SceneLike,
    free: Sequence[str],
    *,
    bounds: Mapping[str, tuple[object, object]] | None = None,
    loss: Loss = LINEAR,
    starts: int = STARTS,
    profiles: bool = True,
    backend: str = "auto",
    rtol: float | None = None,
    seed: int = 0,
    progress: FitProgress | None = None,
) -> Fit:
    """Find the parameters with which a filament falls as it was filmed, by weighted least squares of its midpoint.

    With ``run.effects = "auto"`` the physics is chosen for the scene's values, and the fit is repeated where the fitted
    values call for more. In the end the filament that fits best is run once and judged as any run is.

    Parameters
    ----------
    measurements : Measurements, path or sequence of paths
        One film for each filament; files as :func:`softcat_sym.inverse.read_measurements` takes them.
    scene, free : Scene (or its name, path or dict), sequence of str
        What is known, with rough values of what is not; and what is not, such as ``["youngs_modulus", "viscosity"]``:
        see :func:`softcat_sym.inverse.forward.free.free_parameters`.
    bounds : mapping of str to (low, high), optional
        In SI, or text with units; by default a factor of a thousand to either side.
    loss : Loss
        Such as ``Loss("soft-l1", scale)`` or ``"cauchy"``, for outliers; the scale in standard errors, stated or found.
    starts, seed : int
        Of a Latin hypercube of the bounds, beside the scene's own values and those of the closed form.
    backend, rtol : str, float, optional
        ``"auto"``, ``"compiled"`` or ``"interpreted"``; the integrator's relative tolerance.
    profiles, progress : bool, FitProgress, optional
        Whether intervals come from profile likelihoods, or from the curvature alone; told how far it is.

    Returns
    -------
    Fit
        With intervals, verdicts, what the residuals say and an outcome.

    Raises
    ------
    SoftcatError
        If the measurements cannot be used, the scene has no such parameter, or the model no answer at any start.
    """
    if not 0 <= starts <= MOST_STARTS:
        raise SoftcatError(f"{starts} starts; accepted: 0 to {MOST_STARTS}")
    scene = as_scene(scene)
    seen = taken(measurements, scene)
    asked = _Asked(tuple(free), bounds, loss, starts, profiles, backend, rtol, seed, progress or NoProgress())
    return _with_all_effects(scene, seen, asked)


def _with_all_effects(scene: Scene, seen: Measurements, asked: _Asked) -> Fit:
    """The fit, and once more where its values call for effects that it did not have."""
    features = [_features(one, own_scene(one, scene)) for one in seen.series]
    found = _fit(scene, scene, seen, features, asked)
    more = _called_for(found) if scene.run.effects == "auto" else []
    if more:
        wider = _with_effects(scene, sorted({*found.effects, *more}))
        again = _fit(wider, scene, seen, features, asked)
        found = replace(again, repeats=(f"the fitted values call for {', '.join(more)}", *again.repeats))
    asked.progress.stage("the run of what fits best", 0, 1)
    return _trusted(found)


def _trusted(found: Fit) -> Fit:
    """The fit, with another outcome where the run of what fits best is no answer."""
    if not found.outcome.converged:
        return found
    ended, complaint = judged_runs(found.problem, found.starts.best.q)
    if ended.is_success:
        return found
    outcome = FitOutcome.localised if ended is Outcome.localised else FitOutcome.run_in_doubt
    if ended is Outcome.energy_drift and found.outcome is not FitOutcome.solved:
        # The lesser doubt: of one run's arithmetic, not of the filament.
        outcome = found.outcome
    return replace(found, outcome=outcome, complaint=f"{ended.name.replace('_', ' ')}: {complaint or ended.value}")


def _fit(scene: Scene, given: Scene, seen: Measurements, features: Sequence[Features | None], asked: _Asked) -> Fit:
    """One fit with the effects that the scene's own values call for."""
    problem = _problem(scene, seen, asked)
    begin = time.perf_counter()
    first = _first(problem, scene, features)
    loss = _scaled(asked.loss, problem, first)
    of_starts, of_profiles = (partial(asked.progress.stage, name) for name in ("starts", "profiles"))
    falls = multi_start(problem, first, count=asked.starts, seed=asked.seed, loss=loss, told=of_starts)
    inferred = infer(problem, falls, loss, profiles=asked.profiles, told=of_profiles)
    best, known = inferred.starts.best, inferred.information
    reading = known.spread.reading
    parts = [part / reading if reading > 0 else part for part in problem.by_film(best.residuals)]
    checks = check_residuals(parts, len(problem.names), noise_known=problem.noise_known)
    films = _films(problem, best, parts, features)
    spent = time.perf_counter() - begin
    asked.progress.stage("done", 1, 1)
    values = [one.value(float(q)) for one, q in zip(problem.free, best.q, strict=True)]
    return Fit(
        scene=given,
        fitted_scene=with_values(given, problem.free, values),
        measurements=seen,
        parameters={one.name: fitted_parameter(one, v) for one, v in zip(problem.free, inferred.verdicts, strict=True)},
        correlation=known.correlation,
        combinations=tuple(told(one, problem) for one in known.combinations),
        noise=reading * problem.unit,
        noise_known=problem.noise_known,
        outcome=_outcome(best, inferred.verdicts, checks),
        films=films,
        checks=checks,
        starts=inferred.starts,
        profiles=inferred.profiles,
        information=known,
        problem=problem,
        effects=problem.films[0].model.effects,
        backend=problem.films[0].model.backend,
        repeats=(_RESTARTED,) * inferred.restarts,
        seconds=spent,
    )


def _problem(scene: Scene, seen: Measurements, asked: _Asked) -> FilamentProblem:
    """The problem; with all physics that applies where the scene's own values leave out what a parameter belongs to."""
    try:
        return FilamentProblem(scene, seen, asked.free, asked.bounds, asked.backend, asked.rtol)
    except SceneError as refusal:
        if scene.run.effects != "auto" or "makes no difference" not in str(refusal):
            raise
    everything = [effect.name for effect in REGISTRY if effect.applies(scene) and effect.name != ASIDE]
    return FilamentProblem(_with_effects(scene, everything), seen, asked.free, asked.bounds, asked.backend, asked.rtol)


def _with_effects(scene: Scene, names: Sequence[str]) -> Scene:
    return scene.replace({"run.effects": list(names)})


def _called_for(found: Fit) -> list[str]:
    """Effects that the fitted values call for and the fit did not have."""
    try:
        wanted = choose_effects(found.fitted_scene).names
    except SceneError:
        return []
    return [name for name in wanted if name not in found.effects and name != ASIDE]


def _scaled(loss: Loss, problem: FilamentProblem, given: Sequence[Floats]) -> Loss:
    """The loss with its scale in the problem's unit of residuals, where that is not their standard error."""
    if loss.kind == "linear" or problem.noise_known:
        return loss
    wanted, at = LINEAR, given
    # Least squares follow outliers, the median of what they leave hardly; the second round is robust itself.
    for _ in range(2):
        best = multi_start(problem, at, loss=wanted).best
        deviation = _MEDIAN_TO_DEVIATION * float(np.median(np.abs(best.residuals)))
        wanted, at = Loss(loss.kind, loss.scale * max(deviation, _LEAST_NOISE)), [best.q]
    return wanted


def _features(series: Series, scene: Scene) -> Features | None:
    # The closed form and its features are those of a steady weight.
    if np.count_nonzero(series.time > 0) < FEWEST or not scene.load.gravity > 0 or scene.load.shake > 0:
        return None
    return read_features(series.time, series.midpoint, series.std, scene.load.gravity, rest_length(scene))


def _first(problem: FilamentProblem, scene: Scene, features: Sequence[Features | None]) -> list[Floats]:
    """The scene's own values, and those of the closed form where a film has one."""
    starts = [np.clip(problem.typical, problem.lower, problem.upper)]
    for one in features:
        if one is None or scene.material.law not in ("maxwell", "newtonian"):
            continue
        guess = closed_form(one, scene.filament.density).first_guess
        if guess is None:
            continue
        known = {"youngs_modulus": guess.youngs_modulus, "viscosity": guess.viscosity}
        q = starts[0].copy()
        for k, free in enumerate(problem.free):
            if free.name in known:
                q[k] = np.clip(free.scaled(known[free.name]), problem.lower[k], problem.upper[k])
        starts.append(q)
    return starts


def _films(
    problem: FilamentProblem, best: Optimum, residuals: Sequence[Floats], features: Sequence[Features | None]
) -> tuple[FittedFilm, ...]:
    curves = problem.curves(best.q)
    return tuple(
        FittedFilm(
            time=film.time,
            place=film.place,
            measured=film.data,
            model=curve,
            residuals=part,
            features=seen,
            name=film.series.path.name if film.series.path else f"film {number}",
        )
        for number, (film, curve, part, seen) in enumerate(
            zip(problem.films, curves, residuals, features, strict=True), start=1
        )
    )


def _outcome(best: Optimum, judged: Sequence[Verdict], checks: ResidualChecks) -> FitOutcome:
    words = {one.word for one in judged}
    if not best.converged:
        return FitOutcome.not_converged
    if checks.verdict == "not white":
        return FitOutcome.model_error
    if "at a bound" in words:
        return FitOutcome.at_a_bound
    return FitOutcome.solved if words == {"identified"} else FitOutcome.not_identified
