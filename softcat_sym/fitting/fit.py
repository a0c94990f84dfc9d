"""From films of falling filaments to their material: the whole line of a fit, and what it says in SI."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.lists import everything, named
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.fitting.closed_form import closed_form
from softcat_sym.fitting.defaults import MAX_STARTS, STARTS
from softcat_sym.fitting.features import FEWEST, Features, read_features
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import TIME_OFFSET, FreeParameter, Unknowns, free_parameters, with_values
from softcat_sym.fitting.identifiability import Combination, Information, ResidualChecks, check_residuals
from softcat_sym.fitting.inference import ParameterVerdict, Profile, Word, infer
from softcat_sym.fitting.least_squares import LINEAR, Floats, Loss, Method, MultiStartResult, multi_start
from softcat_sym.fitting.measurements import Measurements, Series
from softcat_sym.fitting.plausibility import Films, own_scene, taken
from softcat_sym.scene.reading import SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Progress, Silence, counting

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False)
class Filmed:
    """One series, the model of its filament, and which unknowns of the problem that model has."""

    series: Series  # What was measured
    model: ForwardModel  # What it is compared with
    columns: tuple[int, ...]  # For each unknown of the model its number in the problem
    time: Floats  # shape (n,); Of every reading [s]: those of the midpoint, then the points of whole shapes
    place: Floats  # shape (n,); Distance of a point of a shape from halfway between the supports [m]; NaN of a midpoint
    data: Floats  # shape (n,); Heights [m]
    std: Floats  # shape (n,); By which residuals are divided [m]

    @property
    def name(self) -> str:
        """Its file; empty if it has none."""
        return self.series.path.name if self.series.path else ""

    def heights(self, q: Floats) -> Floats:
        """What the model says at every reading [m], shape (n,), of the unknowns of the whole problem."""
        own, shapes = q[list(self.columns)], self.series.shapes
        parts = [self.model.midpoints(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x)[0])
        return np.concatenate(parts)

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """The same with derivatives by the unknowns of the whole problem, shape (n, k)."""
        own, shapes = q[list(self.columns)], self.series.shapes
        parts = [self.model.with_derivatives(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x))
        slopes = np.zeros((self.data.size, q.size))
        slopes[:, list(self.columns)] = np.concatenate([part[1] for part in parts])
        return np.concatenate([part[0] for part in parts]), slopes


class FilamentProblem(Unknowns):
    """(model - measured)/standard error of all readings: a problem of least squares.

    Every filament shares the unknowns of the material; each camera has its own `time_offset` and `initial_sag`, with
    the number of the film behind their names where there are several.
    """

    def __init__(
        self,
        scene: Scene,
        measurements: Measurements,
        names: Sequence[str],
        bounds: Mapping[str, tuple[object, object]] | None = None,
        backend: str = "auto",
        rtol: float | None = None,
    ) -> None:
        common, series = free_parameters(scene, names, bounds), measurements.series
        # A film that has a free parameter's value of its own leaves nothing to fit there.
        faults = [
            Fault(f"free {free.name}", f"set by {film.path or 'a series'} itself", "free it, or set it, not both")
            for free in common
            for film in series
            if free.path in film.overrides
        ]
        if faults:
            raise SceneError(faults)
        self.free, columns = _unknowns(common, len(series))
        readings = [_readings(film) for film in series]
        self.noise_known = all(std is not None for *_, std in readings)
        unit = max(float(np.max(np.abs(data))) for *_, data, _ in readings)
        self.films = tuple(
            Filmed(
                series=film,
                model=ForwardModel(own_scene(film, scene), common, film.time, backend, rtol),
                columns=places,
                time=time,
                place=place,
                data=data,
                std=std if self.noise_known and std is not None else np.full(data.size, unit),
            )
            for film, places, (time, place, data, std) in zip(series, columns, readings, strict=True)
        )

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        """Which unknowns are logarithms."""
        return tuple(free.logarithmic for free in self.free)

    @property
    def unit(self) -> float:
        """What a residual of one is [m]; where the errors are known they differ, and it is their mean."""
        return float(np.mean(np.concatenate([film.std for film in self.films])))

    def curves(self, q: Floats) -> list[Floats]:
        """What the model says at the readings of each film [m]."""
        return [film.heights(q) for film in self.films]

    def residuals(self, q: Floats) -> Floats:
        """(model - datum)/standard error of all films, shape (m,); NaN where the model has no answer."""
        pairs = zip(self.films, self.curves(q), strict=True)
        return np.concatenate([(found - film.data) / film.std for film, found in pairs])

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals, shape (m,), and their derivatives, shape (m, k)."""
        residuals, rows = [], []
        for film in self.films:
            found, slopes = film.linearised(q)
            residuals.append((found - film.data) / film.std)
            rows.append(slopes / film.std[:, None])
        return np.concatenate(residuals), np.concatenate(rows)

    def by_film(self, values: Floats) -> list[Floats]:
        """Split what all films have, shape (m,), into one array for each."""
        ends = np.cumsum([film.data.size for film in self.films])[:-1]
        return [np.asarray(part) for part in np.split(values, ends)]

    def values(self, q: Floats) -> dict[str, float]:
        """The unknowns in SI."""
        return {free.name: free.value(float(x)) for free, x in zip(self.free, q, strict=True)}


def _readings(series: Series) -> tuple[Floats, Floats, Floats, Floats | None]:
    """Times [s], places [m], heights [m] and, where all are stated, standard errors [m]: midpoints, then shapes."""
    shapes, midpoint = series.shapes, np.full(series.time.size, np.nan)
    if shapes is None:
        return series.time, midpoint, series.midpoint, series.std
    if not series.time.size:
        return shapes.time, shapes.x, shapes.y, shapes.std
    known = None if series.std is None or shapes.std is None else np.concatenate([series.std, shapes.std])
    pairs = (series.time, shapes.time), (midpoint, shapes.x), (series.midpoint, shapes.y)
    time, place, data = (np.concatenate(pair) for pair in pairs)
    return time, place, data, known


def _unknowns(common: tuple[FreeParameter, ...], films: int) -> tuple[tuple[FreeParameter, ...], list[tuple[int, ...]]]:
    """All unknowns, and for each film the numbers of its own."""
    unknowns: list[FreeParameter] = []
    columns: list[list[int]] = [[] for _ in range(films)]
    for free in common:
        for k in range(films):
            if k == 0 or free.of_measurement:
                alone = films == 1 or not free.of_measurement
                unknowns.append(free if alone else replace(free, name=f"{free.name}_{k + 1}"))
            columns[k].append(len(unknowns) - 1)
    return tuple(unknowns), [tuple(numbers) for numbers in columns]


def judged_runs(problem: FilamentProblem, q: Floats) -> tuple[Outcome, str]:
    """Run every film's filament for as long as it was filmed, and judge it.

    Residuals show neither a neck that the grid decides nor lost energy.
    """
    worst, messages = Outcome.solved, []
    for number, film in enumerate(problem.films, start=1):
        begin = sum(problem.free[k].value(float(q[k])) for k in film.columns if problem.free[k].path == TIME_OFFSET)
        duration = float(film.time.max()) - begin
        if not duration > 0:
            continue
        scene = film.model.scene(q[list(film.columns)])
        scene = scene.replace({"run.effects": list(film.model.effects), "run.duration": f"{duration!r} s"})
        try:
            run = recalled(without_estimate(scene))
            outcome, message = run.outcome, str(run.summary["message"])
        except SceneError as refusal:
            outcome, message = Outcome.no_equilibrium, str(refusal)
        if not outcome.is_success:
            messages.append(f"{film.name or f'film {number}'}: {message}" if len(problem.films) > 1 else message)
            worst = worst if worst is Outcome.localised else outcome
    return worst, "; ".join(messages)


class FitOutcome(Enum):
    """End of a fit; ``name`` with blanks for underscores goes into ``fit.json``."""

    solved = "the model fits within its noise; every free parameter is identified"
    not_identified = (
        "the model fits, but the data do not tell every parameter: read the verdicts and the combinations, fix what is "
        "known otherwise, or film what softcat's experiment design proposes"
    )
    at_a_bound = "the best fit lies on a bound that the data push against: widen the bound, or doubt the law"
    model_error = (
        "the residuals are not white noise: the model misses something that the data show, so that the intervals, "
        "which know of noise only, are too narrow; try another law, more effects, or free time_offset and initial_sag"
    )
    localised = (
        "in the filament that fits best strain gathers in one cell, and the midpoint that was fitted changes with the "
        "grid: do not use the numbers; take the effect necking-gradient in, or film a shorter or thicker filament"
    )
    run_in_doubt = (
        "a run of the filament that fits best is not to be trusted: do not use the numbers before `softcat run` of the "
        "fitted scene ends as solved; its advice says what to change"
    )
    not_converged = (
        "IPOPT did not reach an optimum: do not use the numbers; give nearer starting values in the scene, or bounds"
    )

    @property
    def converged(self) -> bool:
        """Whether an optimum was found."""
        return self is not FitOutcome.not_converged

    @property
    def word(self) -> str:
        """As files and terminals say it."""
        return self.name.replace("_", " ")


@dataclass(frozen=True)
class FittedParameter:
    """One parameter.

    Attributes
    ----------
    name, unit : str
        As it was named; SI.
    value : float or None
        None where it is not identified: no number stands alone for what the data do not tell.
    best : float
        Where the optimum lies, whatever that is worth.
    std : float or None
        Standard error, to first order; None with the value.
    ci95 : (float or None, float or None)
        95 % interval; None where it does not end.
    verdict : str
        ``"identified"``, ``"one-sided"``, ``"not identified"`` or ``"at a bound"``.
    reason : str
        Why it is not identified; empty if it is.
    typical : float
        What the scene says.
    bounds : (float, float)
        Within which it was sought.
    """

    name: str
    unit: str
    value: float | None
    best: float
    std: float | None
    ci95: tuple[float | None, float | None]
    verdict: Word
    reason: str
    typical: float
    bounds: tuple[float, float]

    def to_dict(self) -> dict[str, Any]:
        """Its entry in ``fit.json``."""
        keys = ("value", "std", "ci95", "verdict", "reason", "unit", "best", "typical", "bounds")
        return {key: getattr(self, key) for key in keys}


@dataclass(frozen=True, eq=False)
class FittedFilm:
    """One film beside its model."""

    time: Floats  # shape (n,); [s], [m], [m]: of the midpoint, then of points of whole shapes
    place: Floats  # shape (n,); Distance of a point of a shape from halfway between the supports [m]; NaN of a midpoint
    measured: Floats
    model: Floats
    residuals: Floats  # shape (n,); (model - measured) over the noise
    # What it shows without a model; None of a film that is too short, or under shaken gravity.
    features: Features | None
    name: str  # File or number

    def part(self, chosen: NDArray[np.bool_]) -> FittedFilm:
        """Some of its readings."""
        keys = ("time", "place", "measured", "model", "residuals")
        return replace(self, **{key: getattr(self, key)[chosen] for key in keys})

    @property
    def of_midpoint(self) -> NDArray[np.bool_]:
        """Which readings are of the midpoint, shape (n,)."""
        return np.isnan(self.place)


@dataclass(frozen=True, eq=False)
class Fit:
    """What the measurements say about the material.

    Attributes
    ----------
    scene : Scene
        As given.
    fitted_scene : Scene
        With the best values.
    measurements : Measurements
        With the corrections that were made, noted.
    parameters : dict of str to FittedParameter
        What was free.
    correlation : ndarray, shape (k, k)
        Of the parameters' estimates, in their order.
    combinations : tuple of str
        Products of powers that are identified where single parameters are not, with value and interval.
    noise : float
        Standard deviation of a reading [m]: as stated, or estimated from the residuals.
    noise_known : bool
        Which of the two.
    outcome : FitOutcome
        What it is worth.
    films : tuple of FittedFilm
        Data, model and residuals.
    checks : ResidualChecks
        Whether the residuals are white.
    starts : MultiStartResult
        Where every start ended.
    profiles : tuple of Profile
        Of every parameter in its order; empty if they were not requested.
    information : Information
        Fisher's, at the optimum.
    problem : FilamentProblem
        What was solved; q are its unknowns.
    effects : tuple of str
        Physics in force.
    backend : str
        What integrated, and why.
    repeats : tuple of str
        Why the fit was repeated with more effects.
    seconds : float
        What it took after compiling, without the run that judges it.
    message : str
        What speaks against a run of the fitted filament; empty if nothing does.
    """

    scene: Scene
    fitted_scene: Scene
    measurements: Measurements
    parameters: dict[str, FittedParameter]
    correlation: Floats
    combinations: tuple[str, ...]
    noise: float
    noise_known: bool
    outcome: FitOutcome
    films: tuple[FittedFilm, ...]
    checks: ResidualChecks
    starts: MultiStartResult
    profiles: tuple[Profile, ...]
    information: Information
    problem: FilamentProblem
    effects: tuple[str, ...]
    backend: str
    repeats: tuple[str, ...]
    seconds: float
    message: str = ""

    def plot(self, what: str = "curves") -> Figure:
        """Draw one picture of the fit.

        Parameters
        ----------
        what : str
            ``curves``, ``profiles``, ``correlation`` or ``starts``.

        Raises
        ------
        SoftcatError
            If there is no such picture.
        """
        from softcat_sym.plotting.fit_figures import FIGURES
        from softcat_sym.plotting.notebook import drawn

        return drawn(FIGURES, what, self)

    def figures(self) -> dict[str, Figure]:
        """Pictures of the fit, by the names of their files."""
        from softcat_sym.plotting.fit import captioned_figures

        return {name: figure for name, (_, figure) in captioned_figures(self).items()}

    def __repr__(self) -> str:
        lines = [f"Fit {self.scene.title!r}: {self.outcome.name}"]
        for name, one in self.parameters.items():
            value = f"{one.value:.4g}" if one.value is not None else "not known"
            error = f" +- {one.std:.2g}" if one.std is not None else ""
            lines.append(f"{name} = {value}{error} {one.unit}: {one.verdict}")
        return "\n  ".join(lines)

    def _repr_html_(self) -> str:
        from softcat_sym.plotting.notebook import html

        return html(repr(self), self.plot())

    @property
    def notes(self) -> list[str]:
        """Corrections that were made to the measurements, film by film where there are several."""
        several = len(self.films) > 1
        pairs = zip(self.films, self.measurements.series, strict=True)
        return [f"{film.name}: {note}" if several else note for film, series in pairs for note in series.notes]

    @property
    def squares(self) -> float:
        """Sum of the squared residuals in units of the problem."""
        residuals = self.starts.best.residuals
        return float(residuals @ residuals)

    @property
    def residual_std(self) -> float:
        """Root mean square of model less measurement over all readings [m]."""
        left = np.concatenate([film.model - film.measured for film in self.films])
        return float(np.sqrt(np.mean(left**2)))

    @property
    def evaluations(self) -> int:
        """Of the model, from all starts."""
        return sum(result.optimum.evaluations for result in self.starts.results)

    @property
    def warnings(self) -> list[str]:
        """What a reader has to know before using the numbers, besides the outcome."""
        found, size, starts = [], self.checks.size, self.starts
        if size is not None and size.p_value < _SMALL:
            found.append(
                f"the residuals are larger than the stated errors (chi-square {size.value:.0f} for "
                f"{sum(film.time.size for film in self.films)} readings, p = {size.p_value:.2g}): the intervals are "
                "too narrow"
            )
        if starts.reached_best == 1 and len(starts.results) > 2:
            found.append("only one start reached the best fit: there may be a better one, ask for more starts")
        for one in self.profiles:
            if one.unconverged:
                found.append(f"profile of {one.name}: {one.unconverged} of {one.q.size} points are uncertain")
            if one.better is not None:
                found.append(f"profile of {one.name}: it met a still better optimum; start nearer to it")
        return found

    def to_dict(self) -> dict[str, Any]:
        """Content of ``fit.json``: plain SI."""
        checks, problem, series = self.checks, self.problem, self.measurements.series
        starts = [
            {
                "start": problem.values(result.start),
                "end": problem.values(result.optimum.q),
                "cluster": result.cluster,
                **{key: getattr(result.optimum, key) for key in _OF_A_START},
            }
            for result in self.starts.results
        ]
        return {
            "outcome": self.outcome.word,
            "advice": self.outcome.value,
            "parameters": {name: one.to_dict() for name, one in self.parameters.items()},
            "correlation": self.correlation.tolist(),
            "combinations": list(self.combinations),
            "noise_m": self.noise,
            "noise_known": self.noise_known,
            "residuals": {
                "verdict": checks.verdict,
                "tests": [vars(test) for test in checks.tests],
                "autocorrelation": checks.autocorrelation,
                "chi_square": None if checks.size is None else vars(checks.size),
            },
            "features": [{"film": film.name, **_features_dict(film.features)} for film in self.films],
            "films": [
                {"name": film.name, "path": None if one.path is None else str(one.path), "readings": film.time.size}
                for film, one in zip(self.films, series, strict=True)
            ],
            "starts": {
                "count": len(starts),
                "reached_best": self.starts.reached_best,
                "no_answer": self.starts.rejected,
                "falls": starts,
            },
            "profiles": {one.name: self._profile(one) for one in self.profiles},
            "effects": list(self.effects),
            "backend": self.backend,
            "notes": self.notes,
            "warnings": self.warnings,
            "repeats": list(self.repeats),
            "seconds": self.seconds,
            "evaluations": self.evaluations,
        }

    def _profile(self, one: Profile) -> dict[str, Any]:
        free = next(free for free in self.problem.free if free.name == one.name)
        return {
            "value": [free.value(q) for q in one.q.tolist()],
            "increase": one.increase.tolist(),
            "threshold": one.threshold,
            "ends": {"lower": one.lower.flag, "upper": one.upper.flag},
            "held_back": {"lower": list(one.lower.held_back), "upper": list(one.upper.held_back)},
        }

    def to_frame(self) -> pd.DataFrame:
        """Content of ``fit.csv``: data, model [m] and residuals of all films; of a midpoint without a place."""
        columns = {"time_s": "time", "x_m": "place", "measured_m": "measured", "model_m": "model"}
        columns |= {"residual": "residuals", "film": "name"}
        rows = [
            pd.DataFrame({column: getattr(film, key) for column, key in columns.items()}, range(film.time.size))
            for film in self.films
        ]
        frame = pd.concat(rows, ignore_index=True)
        return frame.drop(columns="x_m") if frame["x_m"].isna().all() else frame


FEATURES = {
    "t_low": ("end of free fall t_low", "s"),
    "t_high": ("start of the 1/3 law t_high", "s"),
    "frequency": ("frequency R", "rad_s"),
    "decay": ("decay rate d", "1_s"),
    "sag": ("sag H while it rings", "m"),
    "prefactor": ("prefactor B of the 1/3 law", ""),
}
"""What a film shows without a model: attributes of its features, what they are called, units in names of keys."""

_OF_A_START = ("value", "converged", "status", "iterations", "evaluations")
# p-value from which on a test is worth a warning.
_SMALL = 0.01


def _features_dict(features: Features | None) -> dict[str, Any]:
    readings = {} if features is None else {name: getattr(features, name) for name in FEATURES}
    return {
        "_".join(filter(None, (name, FEATURES[name][1]))): {"value": one.value, "std": one.error, "reason": one.reason}
        for name, one in readings.items()
    }


def combination_text(combination: Combination, problem: FilamentProblem) -> str:
    """One sentence on a combination, with value and 95 % interval in SI where it is a product."""
    parts = [free for name in combination.names for free in problem.free if free.name == name]
    if not all(free.logarithmic for free in parts):
        low, high = combination.interval
        return f"{combination.text} = {combination.value:.4g} ({low:.4g} to {high:.4g}) in scaled unknowns"
    value, low, high = combination.product([free.typical for free in parts])
    if not np.isfinite(value):
        return f"{combination.text}: known to {combination.standard_error:.1%}"
    return f"{combination.text} = {value:.4g} ({low:.4g} to {high:.4g}), SI"


_RESTARTED = "a profile met a better optimum on the way, and the fit began again from there"


@dataclass(frozen=True)
class _Request:
    """How a fit is to be done."""

    free: tuple[str, ...]
    bounds: Mapping[str, tuple[object, object]] | None
    loss: Loss
    starts: int
    profiles: bool
    backend: str
    rtol: float | None
    seed: int
    method: Method
    progress: Progress

    def problem(self, scene: Scene, films: Measurements) -> FilamentProblem:
        """The problem; with all physics that applies where a parameter needs more than the scene's values call for."""
        try:
            return FilamentProblem(scene, films, self.free, self.bounds, self.backend, self.rtol)
        except SceneError as refusal:
            if scene.run.effects != "auto":
                raise
            try:
                wider = _with_effects(scene, everything(scene, ()))
                return FilamentProblem(wider, films, self.free, self.bounds, self.backend, self.rtol)
            except SceneError:
                raise refusal from None


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
    method: Method = "gauss-newton",
    progress: Progress | None = None,
) -> Fit:
    """Find the parameters with which a filament falls as it was filmed, by weighted least squares of its midpoint.

    With ``run.effects = "auto"`` the physics is chosen for the scene's values, and the fit is repeated where the fitted
    values call for more. In the end the filament that fits best is run once and judged as any run is.

    Parameters
    ----------
    measurements : Measurements, path or sequence of paths
        One film for each filament; files as :func:`softcat_sym.fitting.read_measurements` takes them.
    scene, free : Scene (or its name, path or dict), sequence of str
        What is known, with rough values of what is not; and what is not, such as ``["youngs_modulus", "viscosity"]``:
        see :func:`softcat_sym.fitting.free_parameters.free_parameters`.
    bounds : mapping of str to (low, high), optional
        In SI, or text with units; by default a factor of a thousand to either side.
    loss : Loss
        Such as ``Loss("soft-l1", scale)`` or ``"cauchy"``, for outliers; the scale in standard errors, stated or found.
    starts, seed : int
        Of a Latin hypercube of the bounds, beside the scene's own values and those of the closed form.
    backend, rtol : str, float, optional
        ``"auto"``, ``"compiled"`` or ``"interpreted"``; the integrator's relative tolerance.
    profiles, progress : bool, Progress, optional
        Whether intervals come from profile likelihoods, or from the curvature alone; hears how far it is.
    method : str
        ``"gauss-newton"``, or ``"ipopt"`` for IPOPT from every start.

    Returns
    -------
    Fit
        With intervals, verdicts, what the residuals say and an outcome.

    Raises
    ------
    SoftcatError
        If the measurements cannot be used, the scene has no such parameter, or the model no answer at any start.
    """
    if not 0 <= starts <= MAX_STARTS:
        raise SoftcatError(f"{starts} starts; accepted: 0 to {MAX_STARTS}")
    scene = as_scene(scene)
    films = taken(measurements, scene)
    request = _Request(tuple(free), bounds, loss, starts, profiles, backend, rtol, seed, method, progress or Silence())
    features = [_features(film, own_scene(film, scene)) for film in films.series]
    found = _fit(scene, scene, films, features, request)
    more = _called_for(found) if scene.run.effects == "auto" else []
    if more:
        wider = _with_effects(scene, sorted({*found.effects, *more}))
        again = _fit(wider, scene, films, features, request)
        found = replace(again, repeats=(f"the fitted values call for {', '.join(more)}", *again.repeats))
    request.progress.stage("the run of what fits best")
    return _trusted(found)


def _trusted(found: Fit) -> Fit:
    """The fit, with another outcome where the run of what fits best is no answer."""
    if not found.outcome.converged:
        return found
    ended, message = judged_runs(found.problem, found.starts.best.q)
    if ended.is_success:
        return found
    outcome = FitOutcome.localised if ended is Outcome.localised else FitOutcome.run_in_doubt
    if ended is Outcome.energy_drift and found.outcome is not FitOutcome.solved:
        # The lesser doubt: of one run's arithmetic, not of the filament.
        outcome = found.outcome
    return replace(found, outcome=outcome, message=f"{ended.name.replace('_', ' ')}: {message or ended.value}")


def _fit(
    scene: Scene, given: Scene, films: Measurements, features: Sequence[Features | None], request: _Request
) -> Fit:
    """One fit with the effects that the scene's own values call for."""
    problem = request.problem(scene, films)
    begin = time.perf_counter()
    first = _first(problem, scene, features)
    loss = _scaled(request.loss, problem, first, request.method)
    how: dict[str, Any] = {"loss": loss, "method": request.method}
    starts = multi_start(
        problem, first, count=request.starts, seed=request.seed, on_progress=counting(request.progress, "starts"), **how
    )
    of_profiles = counting(request.progress, "profiles")
    inferred = infer(problem, starts, profiles=request.profiles, on_progress=of_profiles, **how)
    best, known = inferred.starts.best, inferred.information
    reading = known.spread.reading
    parts = [part / reading if reading > 0 else part for part in problem.by_film(best.residuals)]
    checks = check_residuals(parts, len(problem.names), noise_known=problem.noise_known)
    fitted = []
    for number, curve in enumerate(problem.curves(best.q)):
        film = problem.films[number]
        own = film.time, film.place, film.data, curve, parts[number], features[number]
        fitted.append(FittedFilm(*own, name=film.name or f"film {number + 1}"))
    spent = time.perf_counter() - begin
    request.progress.stage("done")
    return Fit(
        scene=given,
        fitted_scene=with_values(given, problem.free, list(problem.values(best.q).values())),
        measurements=films,
        parameters={
            free.name: fitted_parameter(free, verdict)
            for free, verdict in zip(problem.free, inferred.verdicts, strict=True)
        },
        correlation=known.correlation,
        combinations=tuple(combination_text(one, problem) for one in known.combinations),
        noise=reading * problem.unit,
        noise_known=problem.noise_known,
        outcome=_outcome({one.word for one in inferred.verdicts}, checks, converged=best.converged),
        films=tuple(fitted),
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


def fitted_parameter(free: FreeParameter, verdict: ParameterVerdict) -> FittedParameter:
    """Turn a verdict on q into one on the parameter."""
    low, high = (None if q is None else free.value(q) for q in (verdict.lower, verdict.upper))
    return FittedParameter(
        name=free.name,
        unit=free.unit,
        value=None if verdict.value is None else free.value(verdict.value),
        best=free.value(verdict.best),
        std=None if verdict.standard_error is None else abs(free.slope(verdict.best)) * verdict.standard_error,
        ci95=(low, high),
        verdict=verdict.word,
        reason=verdict.reason,
        typical=free.typical,
        bounds=free.bounds,
    )


def _outcome(words: set[Word], checks: ResidualChecks, *, converged: bool) -> FitOutcome:
    if not converged:
        return FitOutcome.not_converged
    if checks.verdict == "not white":
        return FitOutcome.model_error
    if "at a bound" in words:
        return FitOutcome.at_a_bound
    return FitOutcome.solved if words == {"identified"} else FitOutcome.not_identified


def _with_effects(scene: Scene, names: Sequence[str]) -> Scene:
    return scene.replace({"run.effects": list(names)})


def _called_for(found: Fit) -> list[str]:
    """Effects that the fitted values call for and the fit did not have."""
    try:
        names = choose_effects(found.fitted_scene).names
    except SceneError:
        return []
    return [effect.name for effect in named(*names) if effect.name not in found.effects and not effect.dear]


def noise_scale(residuals: Floats) -> float:
    """Standard deviation of residuals by the median of their magnitudes, which outliers hardly move."""
    return max(1.4826 * float(np.median(np.abs(residuals))), 1e-9)


def _scaled(loss: Loss, problem: FilamentProblem, given: Sequence[Floats], method: Method) -> Loss:
    """The loss with its scale in the problem's unit of residuals, where that is not their standard error."""
    if loss.kind == "linear" or problem.noise_known:
        return loss
    scaled, at = LINEAR, given
    # Least squares follow outliers, the median of what they leave hardly; the second round is robust itself.
    for _ in range(2):
        best = multi_start(problem, at, loss=scaled, method=method).best
        scaled, at = Loss(loss.kind, loss.scale * noise_scale(best.residuals)), [best.q]
    return scaled


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
        q = starts[0].copy()
        for k, free in enumerate(problem.free):
            if free.name in ("youngs_modulus", "viscosity"):
                q[k] = np.clip(free.scaled(getattr(guess, free.name)), problem.lower[k], problem.upper[k])
        starts.append(q)
    return starts
