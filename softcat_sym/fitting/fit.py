"""Fit of material constants to films of falling filaments: all stages of it, with the result in SI."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypedDict

import numpy as np

from softcat_sym.effects.effect_sets import everything, named
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.fitting import STARTS
from softcat_sym.fitting.closed_form import ClosedForm, constants_of, features_of
from softcat_sym.fitting.features import Features
from softcat_sym.fitting.flow_curve import FlowCurve, read_flow_curve
from softcat_sym.fitting.free_parameters import with_values
from softcat_sym.fitting.identifiability import ResidualChecks, check_residuals
from softcat_sym.fitting.inference import Inference, infer, information_at
from softcat_sym.fitting.least_squares import (
    METHODS,
    OUT_OF_TIME,
    STUCK,
    Floats,
    Method,
    Optimum,
    minimise,
    multi_start,
    polished,
)
from softcat_sym.fitting.measurements import Measurements, Series
from softcat_sym.fitting.plausibility import Films, own_scene, taken
from softcat_sym.fitting.priors import read_priors
from softcat_sym.fitting.problem import FilamentProblem
from softcat_sym.fitting.resolution import SHARE, Moved, beside_optimum, finer, first_look, moved
from softcat_sym.fitting.result import (
    MIN_READINGS,
    SIGNIFICANT,
    Fit,
    FitOutcome,
    FittedFilm,
    combination_text,
    far_out,
    fitted_parameter,
)
from softcat_sym.interrupts import TimeLimitError, until
from softcat_sym.scene.reading import Changes, SceneLike, as_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Progress, Silence, counting

MAX_STARTS = 10_000
"""Largest number of starts; one start takes at least a tenth of a second."""

# A search ends if the next step would lower chi^2 by less: a twentieth of a standard error; after an update of the
# covariance a tenth.
_GAIN, _GAIN_OF_UPDATE = 3e-3, 1e-2
# Evaluations with derivatives that an optimum with all its rounds and a profile typically take.
_PER_OPTIMUM, _PER_PROFILE = 14, 12
# Largest mean square residual of a fit within the noise.
_MAX_MEAN_SQUARE = 1.5
# Share of outliers that biases a fit, and the smallest residual of such an outlier over the smallest noise.
_MAX_OUTLIERS, _MIN_OUTLIER = 0.005, 10.0
# Longest correlation time of noise, as a share of a film.
_MAX_CORRELATION_TIME = 0.05
_RESTARTED = "a profile found a better optimum, and the fit was repeated from there"
_ALTERNATIVE = "another optimum fits nearly as well, and the intervals include what fits around it"


class FitOptions(TypedDict, total=False):
    """Options of :func:`fit`, which a fit of another kind passes on to it."""

    bounds: Mapping[str, tuple[object, object]] | None
    starts: int
    profiles: bool
    backend: str
    rtol: float | None
    seed: int
    method: Method
    calibrated: bool
    discrepancy: bool
    time_limit: float | None
    flow_curve: FlowCurve | str | os.PathLike[str] | None
    priors: Mapping[str, str] | None
    progress: Progress | None


@dataclass(frozen=True)
class _Task:
    """What is fitted to what, and how."""

    films: Measurements
    features: list[Features | None]  # Of each film, and the constants that they give
    closed: list[ClosedForm | None]
    free: tuple[str, ...]
    options: FitOptions
    curve: FlowCurve | None
    deadline: float
    progress: Progress

    @property
    def search(self) -> dict[str, Any]:
        """Options of every search for an optimum."""
        return {"method": self.options["method"], "gain": _GAIN}

    def problem(self, scene: Scene) -> FilamentProblem:
        """The problem; with more effects if a parameter depends on some that a film's own values do not call for.

        Those that any of the films calls for are tried first, then every effect that applies.
        """
        try:
            return self._built(scene)
        except SceneError:
            if scene.run.effects != "auto":
                raise
            of_films = {name for film in self.films.series for name in choose_effects(own_scene(film, scene)).names}
            for names in (sorted(of_films), everything(scene, ())):
                try:
                    return self._built(scene.replace({"run.effects": list(names)}))
                except SceneError:
                    continue
            raise

    def _built(self, scene: Scene) -> FilamentProblem:
        options = self.options
        return FilamentProblem(
            scene if options["rtol"] is not None else first_look(scene),
            self.films,
            self.free,
            options["bounds"],
            options["backend"],
            options["rtol"],
            camera=not options["calibrated"],
            theory=options["discrepancy"],
            flow_curve=self.curve,
            deadline=self.deadline,
        )


def fit(
    measurements: Films,
    scene: SceneLike,
    free: Sequence[str],
    *,
    bounds: Mapping[str, tuple[object, object]] | None = None,
    starts: int = STARTS,
    profiles: bool = True,
    backend: str = "auto",
    rtol: float | None = None,
    seed: int = 0,
    method: Method = "least-squares",
    calibrated: bool = False,
    discrepancy: bool = True,
    time_limit: float | None = None,
    flow_curve: FlowCurve | str | os.PathLike[str] | None = None,
    priors: Mapping[str, str] | None = None,
    progress: Progress | None = None,
    changes: Changes = (),
) -> Fit:
    """Fit parameters of a scene to films of its falling filament, by weighted least squares of the midpoint.

    The likelihood includes the noise of the readings and the correlation of neighbouring readings, both estimated where
    no errors are stated; the scale, clock, zero and tilt of the camera, with the priors of
    :data:`softcat_sym.fitting.problem.CAMERA`; and the theory's error as measured against finite elements
    (:func:`softcat_sym.fitting.likelihood.discrepancy`). The fit refines cells, fibres and tolerance until they move
    the parameters by less than a third of their standard errors.

    With ``run.effects = "auto"`` the fit chooses effects for the scene's values, and repeats where the fitted values
    call for more. Finally it runs the best-fitting filament once and checks that run like any other.

    Parameters
    ----------
    measurements : Measurements, path or sequence of paths
        One film for each filament; files as :func:`softcat_sym.fitting.read_measurements` takes them.
    scene, free : Scene (or its name, path or dict), sequence of str
        The scene, with rough values of the free parameters; and their names, such as ``["youngs_modulus",
        "viscosity"]``: see :func:`softcat_sym.fitting.free_parameters.free_parameters`.
    bounds : mapping of str to (low, high), optional
        In SI, or text with units; by default a factor of a thousand to either side.
    starts, seed : int
        Number and seed of starts from a Latin hypercube of the bounds, beside the scene's own values and those of the
        closed form.
    backend, rtol : str, float, optional
        ``"auto"``, ``"compiled"`` or ``"interpreted"``; the integrator's relative tolerance.
    profiles, progress : bool, Progress, optional
        Whether intervals come from profile likelihoods, or from the curvature alone; receiver of progress reports.
    method : str
        ``"least-squares"`` (SciPy), or ``"ipopt"``: the same likelihood and derivatives, a few times the evaluations.
    calibrated, discrepancy : bool
        Whether the camera's parameters are known exactly; whether the likelihood includes the theory's error.
    time_limit : float, optional
        Seconds after which the fit returns the best result so far, and says so.
    flow_curve : FlowCurve or path, optional
        Flow curve of the same material from a rheometer. Its readings are further residuals, weighted by their stated
        errors or by their scatter about the best fit of the same law.
    priors : mapping of str to str, optional
        For a posterior drawn afterwards (:func:`softcat_sym.fitting.posterior.posterior_of`), which has them from the
        fit. The fit itself is without priors, but refuses what is no prior before it begins.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.

    Returns
    -------
    Fit
        Parameters with intervals and verdicts, tests of the residuals, and an outcome.

    Raises
    ------
    SoftcatError
        If the measurements cannot be used, the scene has no such parameter, or the model has no answer at any start.
    """
    if not 0 <= starts <= MAX_STARTS:
        raise SoftcatError(f"{starts} starts; accepted: 0 to {MAX_STARTS}")
    if method not in METHODS:
        raise SoftcatError(f"no method {method!r}; accepted: {', '.join(METHODS)}")
    if time_limit is not None and not time_limit > 0:
        raise SoftcatError(f"a time limit of {time_limit!r} s; accepted: a positive number")
    scene = as_scene(scene, changes)
    films = taken(measurements, scene)
    options: FitOptions = {
        "bounds": bounds,
        "starts": starts,
        "profiles": profiles,
        "backend": backend,
        "rtol": rtol,
        "seed": seed,
        "method": method,
        "calibrated": calibrated,
        "discrepancy": discrepancy,
        "priors": priors or {},
    }
    features = [features_of(film, own_scene(film, scene)) for film in films.series]
    task = _Task(
        films,
        features,
        [_closed_form(film, seen, own_scene(film, scene)) for film, seen in zip(films.series, features, strict=True)],
        tuple(free),
        options,
        read_flow_curve(flow_curve) if isinstance(flow_curve, (str, os.PathLike)) else flow_curve,
        deadline=math.inf if time_limit is None else time.monotonic() + time_limit,
        progress=progress or Silence(),
    )
    found = _fit(scene, scene, task)
    more = _missing_effects(found) if scene.run.effects == "auto" else []
    try:
        if more and time.monotonic() < task.deadline:
            again = _fit(scene.replace({"run.effects": sorted({*found.effects, *more})}), scene, task)
            found = replace(again, repeats=(f"the fitted values call for {', '.join(more)}", *again.repeats))
        task.progress.stage("run of the best fit")
        with until(task.deadline):
            return _with_run_outcome(found)
    except TimeLimitError:
        return replace(found, late=True)


def _with_run_outcome(found: Fit) -> Fit:
    """The fit, with another outcome if a run of the best-fitting filament of a film fails.

    Residuals show neither a neck that depends on the grid nor a loss of energy.
    """
    if not found.outcome.converged:
        return found
    failed, messages = list[Outcome](), []
    for number, film in enumerate(found.problem.films, start=1):
        scene = film.run_scene(found.starts.best.q)[0].model_copy(update={"numerics": found.scene.numerics})
        try:
            run = recalled(without_estimate(scene))
            end, message = run.outcome, str(run.summary["message"])
        except SceneError as refusal:
            end, message = Outcome.no_equilibrium, str(refusal)
        if not end.is_success:
            failed.append(end)
            messages.append(f"{film.name or f'film {number}'}: {message}" if len(found.films) > 1 else message)
    if not failed:
        return found
    # The numbers of a localised run depend on the grid; lost energy is a doubt about one run's arithmetic only.
    gravest = {Outcome.localised: 2, Outcome.energy_drift: 0}
    ended = max(failed, key=lambda end: gravest.get(end, 1))
    outcome = FitOutcome.localised if ended is Outcome.localised else FitOutcome.run_in_doubt
    if ended is Outcome.energy_drift and found.outcome is not FitOutcome.solved:
        # Energy drift concerns the integration of one run only: the fit's own outcome matters more.
        outcome = found.outcome
    message = "; ".join(messages) or ended.value
    return replace(found, outcome=outcome, message=f"{ended.name.replace('_', ' ')}: {message}")


# Corrections of the modulus to match a frequency, which scales with a power of it between 1/3 and 1/2.
_TUNINGS = 2
# Relative error of a frequency beyond which values of the modulus are tried instead, at these logarithmic distances.
_CLEAR, _SCAN = 0.03, np.linspace(-1.0, 1.0, 21)
_UNTIL_GRID = 2  # Rounds that update the noise before the resolution is checked
# Updates that renew the errors of camera and theory, beside the noise.
_RENEWALS = 2
ROUNDS = 8
"""Maximum number of successive optima, between which noise, theory error and resolution are updated."""


def _fit(scene: Scene, given: Scene, task: _Task) -> Fit:
    """Fit once, with the effects that the scene's own values call for."""
    problem, options = task.problem(scene), task.options
    priors = options["priors"] or {}
    read_priors(priors, problem.free)
    begin = time.perf_counter()
    first = _initial_guesses(problem, scene, task)
    started = time.perf_counter()
    problem.linearised(problem.typical)
    one = time.perf_counter() - started
    evaluations = _PER_OPTIMUM + (_PER_PROFILE * len(problem.free) if options["profiles"] else 0)
    task.progress.doing(f"about {one * evaluations:.2g} s for {len(problem.free)} unknowns")
    starts = multi_start(
        problem,
        first,
        count=options["starts"],
        seed=options["seed"],
        enough=lambda best: _fits_within_noise(problem, best),
        on_progress=counting(task.progress, "starts"),
        **task.search,
    )
    # A stuck search with a lower loss may converge with smaller time steps.
    able = [one for one in starts.results if one.optimum.converged or one.optimum.status == STUCK]
    front = min(able or starts.results[:1], key=lambda one: one.optimum.value)
    problem, best, resolution = _refined(problem, front.optimum, scene, task)
    others = [one for one in starts.results if one is not front]
    starts = replace(starts, results=(replace(front, optimum=best), *others))
    of_profiles = counting(task.progress, "profiles")
    inferred = infer(problem, starts, profiles=options["profiles"], on_progress=of_profiles, **task.search)
    best, known = inferred.starts.best, inferred.information
    unit = known.noise
    fitted = [
        FittedFilm.of(film, best.q, unit, seen, closed, name=film.name or f"film {number}")
        for number, (film, seen, closed) in enumerate(
            zip(problem.films, task.features, task.closed, strict=True), start=1
        )
    ]
    left = [part / unit for part in problem.by_film(best.residuals)]
    # Residuals below what cameras tell need no cause, unless the theory is taken for exact.
    least = options["discrepancy"] and not problem.noise_known and problem.noise.deviation <= problem.least_noise
    checks = check_residuals([] if least else left, len(problem.free), noise_known=problem.noise_known)
    spent = time.perf_counter() - begin
    task.progress.stage("done")
    theory = max(film.theory_error for film in problem.films)
    shifts = np.zeros(len(problem.free)) if resolution is None else resolution.total
    shift = 0.0 if resolution is None else resolution.shares.total
    # A scene cannot hold the values of single films.
    shared = [(free, free.value(float(x))) for free, x in zip(problem.free, best.q, strict=True) if free.film is None]
    return Fit(
        scene=given,
        fitted_scene=with_values(given, [free for free, _ in shared], [value for _, value in shared]),
        measurements=task.films,
        parameters={
            free.name: fitted_parameter(
                free, verdict, float(change), widened=shift > SHARE, stiffness_error=2 * theory, quantile=known.quantile
            )
            for free, verdict, change in zip(problem.free, inferred.verdicts, shifts, strict=True)
        },
        correlation=known.correlation,
        combinations=tuple(combination_text(one, problem) for one in known.combinations),
        noise=unit * problem.unit,
        noise_known=problem.noise_known,
        outcome=_outcome(problem, inferred, checks, fitted, shift=shift),
        films=tuple(fitted),
        checks=checks,
        starts=inferred.starts,
        profiles=inferred.profiles,
        information=known,
        problem=problem,
        effects=problem.films[0].model.effects,
        backend=problem.films[0].model.backend,
        repeats=(_RESTARTED,) * inferred.restarts + (_ALTERNATIVE,) * inferred.alternatives,
        seconds=spent,
        camera=problem.camera_at(best.q, known.covariance),
        theory=theory,
        resolution=resolution,
        priors=priors,
        late=inferred.late or time.monotonic() > task.deadline,
    )


def _refined(
    problem: FilamentProblem, best: Optimum, scene: Scene, task: _Task
) -> tuple[FilamentProblem, Optimum, Moved | None]:
    """Repeat the fit from its optimum until noise, theory error and resolution are those of that optimum."""
    resolution, fine, spent = None, task.options["rtol"] is not None, best.evaluations
    # Whether the optimum has moved, so that its noise may be another.
    is_new = True
    for number in range(ROUNDS):
        again = None
        try:
            if best.converged and is_new and (fine or number < _UNTIL_GRID):
                # The discretization error looks like correlated noise: the correlation waits for the final resolution.
                again = problem.updated(best.q, correlated=fine, renewed=number < _RENEWALS)
            elif (best.converged or best.status == STUCK) and not fine:
                task.progress.stage("grid, fibres and time steps")
                resolution = _moved_in_time(problem, best)
                at = None if resolution is None else finer(resolution, scene)
                fine = at is None
                if at is not None:
                    again = problem.at(at)
                elif best.converged:
                    again = problem.updated(best.q, renewed=False)
            if again is None:
                break
            found = minimise(again, best.q, **{**task.search, "gain": _GAIN_OF_UPDATE})
        except TimeLimitError:
            break
        is_new = not np.array_equal(found.q, best.q)
        problem, best, spent = again, found, spent + found.evaluations - 1
    best = replace(best, evaluations=spent)
    if best.status == STUCK and best.offset < 1:
        # Within a standard error of the optimum, which adds to the error by time steps.
        resolution = _moved_in_time(problem, best)
        best = replace(best, converged=resolution is not None)
    # After the time limit there is none left to evaluate the model where it was not yet.
    return problem, best if time.monotonic() > task.deadline else polished(problem, best), resolution


def _moved_in_time(problem: FilamentProblem, best: Optimum) -> Moved | None:
    """By how much the grid moves the optimum; None after the time limit."""
    known = information_at(problem, best)
    try:
        with until(problem.deadline):
            found = moved(problem, best, known)
    except TimeLimitError:
        return None
    # A search that is stuck does not see the optimum for the integration error.
    return beside_optimum(found, best.offset, known) if best.status == STUCK else found


def _fits_within_noise(problem: FilamentProblem, best: Optimum) -> bool:
    """Whether the residuals at an optimum are within the noise, so that no other optimum can be much better."""
    data = best.residuals
    return data.size >= MIN_READINGS and float(data @ data) < _MAX_MEAN_SQUARE * data.size


def _outcome(
    problem: FilamentProblem,
    inferred: Inference,
    checks: ResidualChecks,
    films: Sequence[FittedFilm],
    *,
    shift: float,  # Discretization error of the parameters, in standard errors
) -> FitOutcome:
    best, words = inferred.starts.best, {one.word for one in inferred.verdicts}
    if not best.converged:
        late = best.status == OUT_OF_TIME or time.monotonic() > problem.deadline
        return FitOutcome.out_of_time if late else FitOutcome.not_converged
    # A grid that moves the constants by more than the noise also leaves a pattern, and residuals far out.
    if shift > 1:
        return FitOutcome.discretization_error
    # A residual below the resolution of cameras is no outlier, however small the noise of the other readings.
    smallest = max(1.0, _MIN_OUTLIER * problem.least_noise / problem.unit)
    parts = [film.residuals for film in films]
    outliers = sum(int((far_out(part) & (np.abs(part) > smallest)).sum()) for part in parts)
    if outliers > _MAX_OUTLIERS * sum(part.size for part in parts):
        return FitOutcome.outliers
    against = problem.contradiction(best.residuals, best.jacobian)
    if against is not None and against.p_value < SIGNIFICANT:
        return FitOutcome.contradiction
    # A theory error that is allowed for but absent makes neighbouring residuals anticorrelated: only a positive
    # correlation indicates a model error.
    alike = not problem.systematic or (checks.autocorrelation or 0.0) > 0
    # The film may show larger errors of theory and camera than are allowed for.
    beyond = problem.excess(best.residuals) < SIGNIFICANT
    # Residuals that are correlated over a long part of a film show a model error, not noise.
    correlation, frames = problem.noise.correlation, min(film.data.size for film in problem.films)
    for_long = correlation > 0 and -1 / np.log(correlation) > _MAX_CORRELATION_TIME * frames
    if (checks.verdict == "not white" and alike) or beyond or for_long:
        return FitOutcome.model_error
    if "at a bound" in words:
        return FitOutcome.at_a_bound
    if shift > SHARE:
        return FitOutcome.discretization_error
    return FitOutcome.solved if words == {"identified"} else FitOutcome.not_identified


def _missing_effects(found: Fit) -> list[str]:
    """Effects that the fitted values call for and the fit did not include."""
    try:
        names = choose_effects(found.fitted_scene).names
    except SceneError:
        return []
    return [effect.name for effect in named(*names) if effect.name not in found.effects and not effect.dear]


def _closed_form(film: Series, features: Features | None, scene: Scene) -> ClosedForm | None:
    """Constants that the features of a film give, if they give any."""
    try:
        return None if features is None else constants_of(film, features, scene)
    except SoftcatError:
        return None


def _initial_guesses(problem: FilamentProblem, scene: Scene, task: _Task) -> list[Floats]:
    """Initial guesses: one tuned to the frequency of a ringing film, those of the closed form, the scene's own."""
    own, starts = np.clip(problem.typical, problem.lower, problem.upper), list[Floats]()
    tuned = _tuned_to_frequency(problem, scene, task.features, own)
    if tuned is not None:
        starts.append(tuned)
    for one in filter(None, task.closed):
        q = own.copy()
        for k, free in enumerate(problem.free):
            value = getattr(one, free.name).value if free.name in ("youngs_modulus", "viscosity") else None
            if value is not None:
                q[k] = np.clip(free.scaled(value), problem.lower[k], problem.upper[k])
        starts.append(q)
    return [*starts, own]


def _tuned_to_frequency(
    problem: FilamentProblem, scene: Scene, features: Sequence[Features | None], start: Floats
) -> Floats | None:
    """Initial guess whose modulus reproduces a measured frequency: a fit that is off by a period is an optimum, too."""
    names, pairs = [free.name for free in problem.free], zip(problem.films, features, strict=True)
    ringing = [(film, seen.frequency) for film, seen in pairs if seen is not None and seen.frequency.value]
    if "youngs_modulus" not in names or not ringing:
        return None
    column, (film, measured), q = names.index("youngs_modulus"), ringing[0], start.copy()
    bounds, frequency = (problem.lower[column], problem.upper[column]), measured.value or math.nan
    if (measured.error or 0.0) > _CLEAR * frequency:
        # Values that are closer to each other than the optima of a film that rings for long.
        trials = np.repeat(start[None, :], _SCAN.size, axis=0)
        trials[:, column] = np.clip(start[column] + _SCAN, *bounds)
        squares = [float(np.sum(problem.residuals(one) ** 2)) for one in trials]
        return np.asarray(trials[int(np.argmin(np.where(np.isfinite(squares), squares, np.inf)))])
    for _ in range(_TUNINGS):
        count, heights = film.series.time.size, film.values(q)
        if not np.isfinite(heights).all():
            return None
        shown = replace(film.series, midpoint=heights[:count], std=film.std[:count])
        own = features_of(shown, own_scene(film.series, scene))
        if own is None or own.frequency.value is None:
            return None
        q[column] = np.clip(q[column] + 2 * math.log(frequency / own.frequency.value), *bounds)
    return q
