"""From films of falling filaments to their material: the whole line of a fit, and what it says in SI."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy import stats

from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.lists import everything, named
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.fitting.closed_form import closed_form
from softcat_sym.fitting.defaults import MAX_STARTS, STARTS
from softcat_sym.fitting.features import FEWEST, Features, read_features
from softcat_sym.fitting.flow_curve import FlowCurve, read_flow_curve
from softcat_sym.fitting.free_parameters import TIME_OFFSET, FreeParameter, with_values
from softcat_sym.fitting.identifiability import (
    Combination,
    Information,
    ResidualChecks,
    check_residuals,
    information,
)
from softcat_sym.fitting.inference import Inference, ParameterVerdict, Profile, Word, infer
from softcat_sym.fitting.least_squares import (
    LINEAR,
    OUT_OF_TIME,
    STUCK,
    Floats,
    Loss,
    Method,
    MultiStartResult,
    Optimum,
    TimeLimitError,
    minimise,
    multi_start,
)
from softcat_sym.fitting.measurements import Measurements, Series
from softcat_sym.fitting.plausibility import Films, own_scene, taken
from softcat_sym.fitting.problem import CAMERA, FilamentProblem
from softcat_sym.fitting.resolution import SHARE, Moved, beside_optimum, finer, first_look, moved, tighter
from softcat_sym.scene.csv_reader import counted
from softcat_sym.scene.parts import Numerics
from softcat_sym.scene.reading import SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Progress, Silence, counting

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def judged_runs(problem: FilamentProblem, q: Floats, numerics: Numerics) -> tuple[Outcome, str]:
    """Run every film's filament for as long as it was filmed, as a run of the given scene would, and judge it.

    Residuals show neither a neck that the grid decides nor lost energy.
    """
    worst, messages = Outcome.solved, []
    for number, film in enumerate(problem.films, start=1):
        begin = sum(problem.free[k].value(float(q[k])) for k in film.columns if problem.free[k].path == TIME_OFFSET)
        duration = float(film.time.max()) - begin
        if not duration > 0:
            continue
        scene = film.model.scene(q[list(film.columns)]).model_copy(update={"numerics": numerics})
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
    contradiction = (
        "films and flow curve ask for different constants, beyond the noise of both: do not use the numbers before it "
        "is known which of them is of another material, temperature or age, or whether the law holds in both"
    )
    model_error = (
        "the data show something that the model misses, beyond what the theory is known to err by, so that the "
        "intervals are too narrow; try another law, more effects, or name what else is not known of the camera"
    )
    outliers = (
        "some readings lie far outside the noise of the others, and pull the constants: do not use the numbers; "
        "repeat with --loss soft-l1, or take them out"
    )
    discretization_error = (
        "grid, fibres and time steps move the constants by more than a third of their standard errors, and the finest "
        "that the program chooses by itself are no remedy: the intervals are widened by as much; give numerics.cells, "
        "numerics.fibres and numerics.rtol for less"
    )
    out_of_time = (
        "the time limit came before an optimum was found: the numbers are the best so far; give a longer --time-limit"
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
        "no optimum was reached: do not use the numbers; give nearer starting values in the scene, or bounds"
    )

    @property
    def converged(self) -> bool:
        """Whether an optimum was found."""
        return self not in (FitOutcome.not_converged, FitOutcome.out_of_time)

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

    discretization: float = 0.0
    """By which grid, fibres and time steps may falsify it [its unit]; in the interval where that matters."""

    def to_dict(self) -> dict[str, Any]:
        """Its entry in ``fit.json``."""
        keys = ("value", "std", "ci95", "verdict", "reason", "unit", "best", "typical", "bounds", "discretization")
        return {key: getattr(self, key) for key in keys}


@dataclass(frozen=True, eq=False)
class FittedFilm:
    """One film beside its model."""

    time: Floats  # shape (n,); [s], [m], [m]: of the midpoint, then of points of whole shapes
    place: Floats  # shape (n,); Distance of a point of a shape from halfway between the supports [m]; NaN of a midpoint
    measured: Floats
    model: Floats
    residuals: Floats  # shape (n,); (model - measured) over the noise
    is_force: NDArray[np.bool_]  # shape (n,); Which readings are forces of a support [N]
    # What it shows without a model; None of a film that is too short, or under shaken gravity.
    features: Features | None
    name: str  # File or number

    def part(self, chosen: NDArray[np.bool_]) -> FittedFilm:
        """Some of its readings."""
        keys = ("time", "place", "measured", "model", "residuals", "is_force")
        return replace(self, **{key: getattr(self, key)[chosen] for key in keys})

    @property
    def of_midpoint(self) -> NDArray[np.bool_]:
        """Which readings are of the midpoint, shape (n,)."""
        return np.isnan(self.place) & ~self.is_force

    @property
    def of_shape(self) -> NDArray[np.bool_]:
        """Which readings are points of whole shapes, shape (n,)."""
        return ~np.isnan(self.place)


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
    camera : dict of str to (float, float, float)
        Of the camera's own numbers: value, standard error, and the standard error known beforehand; SI.
    theory : float
        Standard deviation of the theory's error that is allowed for, over the height of the midpoint; 0 if none is.
    resolution : Moved
        Cells, fibres and tolerance it ended with, and how far they move the constants.
    late : bool
        Whether the time limit came before all was looked at.
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
    camera: dict[str, tuple[float, float, float]]
    theory: float
    resolution: Moved | None
    late: bool
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
        """Sum of the squared residuals, those of priors included: chi^2 where the noise is known, otherwise [m^2]."""
        residuals = self.starts.best.residuals
        return float(residuals @ residuals) * (1.0 if self.noise_known else self.problem.unit**2)

    @property
    def outlying(self) -> list[tuple[str, float]]:
        """Readings far outside the noise of the others: film and time [s]."""
        return [(film.name, float(time)) for film in self.films for time in film.time[far_out(film.residuals)]]

    @property
    def residual_std(self) -> float:
        """Root mean square of model less measurement over all readings [m]."""
        left = np.concatenate([(film.model - film.measured)[~film.is_force] for film in self.films])
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
        if self.late and self.outcome.converged:
            found.append("the time limit came before the profiles: intervals are from the curvature alone")
        found += [] if self.problem.flow is None else self.problem.flow.warnings
        if self.outcome is not FitOutcome.outliers and (far := self.outlying):
            found.append(f"{counted(len(far), 'reading')} far outside the noise, first at {far[0][1]:.4g} s")
        if self.problem.noise.correlation:
            together = f"{self.problem.noise.correlation:.2f}"
            found.append(f"neighbouring readings are correlated by {together}, which widens the intervals")
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
            "noise_correlation": self.problem.noise.correlation,
            "camera": {name: dict(zip(_OF_CAMERA, one, strict=True)) for name, one in self.camera.items()},
            "theory_error": self.theory,
            "resolution": None if self.resolution is None else self._resolution(self.resolution),
            "outliers": [{"film": film, "time_s": time} for film, time in self.outlying],
            "flow_curve": self._flow_curve(),
            "late": self.late,
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

    def _flow_curve(self) -> dict[str, Any] | None:
        """Whether a flow curve has the films' constants, and what the fit says at its rates."""
        best, flow = self.starts.best, self.problem.flow
        test = self.problem.contradiction(best.residuals, best.jacobian)
        if flow is None or test is None:
            return None
        stress = {"measured_Pa": flow.curve.shear_stress.tolist(), "model_Pa": flow.stress(best.q).tolist()}
        return {"shear_rate_1_s": flow.curve.shear_rate.tolist(), **stress, "contradiction": vars(test)}

    def _resolution(self, moved: Moved) -> dict[str, Any]:
        """Cells, fibres, tolerance; and by how many standard errors each moves the constants at the most."""
        shares = {"cells": moved.shares.space, "rtol": moved.shares.time, "fibres": moved.shares.section}
        return {name: {"value": getattr(moved.at, name), "standard_errors": share} for name, share in shares.items()}

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
        columns |= {"residual": "residuals", "film": "name", "is_force": "is_force"}
        rows = [
            pd.DataFrame({column: getattr(film, key) for column, key in columns.items()}, range(film.time.size))
            for film in self.films
        ]
        frame = pd.concat(rows, ignore_index=True)
        # Of a film without forces, or without shapes, as before.
        empty = {"x_m": frame["x_m"].isna().all(), "is_force": not frame["is_force"].any()}
        return frame.drop(columns=[name for name, is_empty in empty.items() if is_empty])


FEATURES = {
    "t_low": ("end of free fall t_low", "s"),
    "t_high": ("start of the 1/3 law t_high", "s"),
    "frequency": ("frequency R", "rad_s"),
    "decay": ("decay rate d", "1_s"),
    "sag": ("sag H while it rings", "m"),
    "prefactor": ("prefactor B of the 1/3 law", ""),
}
"""What a film shows without a model: attributes of its features, what they are called, units in names of keys."""

# By which chi^2 would still fall in a step that is not worth making: a twentieth of a standard error.
_GAIN = 3e-3
# Evaluations with derivatives that an optimum and a profile take, the rounds after the first among them.
_PER_OPTIMUM, _PER_PROFILE = 14, 12
# Readings below which nothing is said of their distribution; mean square residual that is taken for noise; share of
# outliers that pull a fit; how far off they are at least, in the least that is taken for noise; share of a film over
# which noise may be correlated.
_FEW, _AS_NOISE, _WILD, _FAR_OFF, _LONG = 20, 1.5, 0.005, 10.0, 0.05
_OF_CAMERA = ("value", "std", "known_to")
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
    camera: bool
    theory: bool
    flow_curve: FlowCurve | None
    deadline: float
    progress: Progress

    def problem(self, scene: Scene, films: Measurements) -> FilamentProblem:
        """The problem; with all physics that applies where a parameter needs more than the scene's values call for."""
        try:
            return self._made(scene, films)
        except SceneError as refusal:
            if scene.run.effects != "auto":
                raise
            try:
                return self._made(_with_effects(scene, everything(scene, ())), films)
            except SceneError:
                raise refusal from None

    def _made(self, scene: Scene, films: Measurements) -> FilamentProblem:
        how = (self.free, self.bounds, self.backend, self.rtol)
        scene = scene if self.rtol is not None else first_look(scene)
        given: dict[str, Any] = {"camera": self.camera, "theory": self.theory, "flow_curve": self.flow_curve}
        made = FilamentProblem(scene, films, *how, **given)
        made.deadline = self.deadline
        return made


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
    calibrated: bool = False,
    discrepancy: bool = True,
    time_limit: float | None = None,
    flow_curve: FlowCurve | str | os.PathLike[str] | None = None,
    progress: Progress | None = None,
) -> Fit:
    """Find the parameters with which a filament falls as it was filmed, by weighted least squares of its midpoint.

    The likelihood knows of the noise of the readings and of the correlation of neighbours, both estimated where no
    errors are stated; of the scale, clock, zero and tilt of the camera, about as well as
    :data:`softcat_sym.fitting.problem.CAMERA` says; and of the theory's own error, as it was measured against finite
    elements (:func:`softcat_sym.fitting.discrepancy.discrepancy`). Cells, fibres and tolerance are refined until they
    move the parameters by less than a third of their standard errors.

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
    calibrated, discrepancy : bool
        Whether the camera's own numbers are known exactly; whether the theory's error is allowed for.
    time_limit : float, optional
        Seconds after which the fit ends with what it has, and says so.
    flow_curve : FlowCurve or path, optional
        Of the same material in a rheometer: its readings enter as further residuals, weighted by stated errors or by
        their scatter about the best of the same law.

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
    if time_limit is not None and not time_limit > 0:
        raise SoftcatError(f"a time limit of {time_limit!r} s; accepted: a positive number")
    scene = as_scene(scene)
    films = taken(measurements, scene)
    deadline = math.inf if time_limit is None else time.monotonic() + time_limit
    how = (tuple(free), bounds, loss, starts, profiles, backend, rtol, seed, method, not calibrated, discrepancy)
    curve = read_flow_curve(flow_curve) if isinstance(flow_curve, (str, os.PathLike)) else flow_curve
    request = _Request(*how, curve, deadline, progress or Silence())
    features = [_features(film, own_scene(film, scene)) for film in films.series]
    found = _fit(scene, scene, films, features, request)
    more = _called_for(found) if scene.run.effects == "auto" else []
    if more and time.monotonic() < deadline:
        wider = _with_effects(scene, sorted({*found.effects, *more}))
        again = _fit(wider, scene, films, features, request)
        found = replace(again, repeats=(f"the fitted values call for {', '.join(more)}", *again.repeats))
    if time.monotonic() > deadline:
        return found
    request.progress.stage("the run of what fits best")
    return _trusted(found)


def _trusted(found: Fit) -> Fit:
    """The fit, with another outcome where the run of what fits best is no answer."""
    if not found.outcome.converged:
        return found
    ended, message = judged_runs(found.problem, found.starts.best.q, found.scene.numerics)
    if ended.is_success:
        return found
    outcome = FitOutcome.localised if ended is Outcome.localised else FitOutcome.run_in_doubt
    if ended is Outcome.energy_drift and found.outcome is not FitOutcome.solved:
        # The lesser doubt: of one run's arithmetic, not of the filament.
        outcome = found.outcome
    return replace(found, outcome=outcome, message=f"{ended.name.replace('_', ' ')}: {message or ended.value}")


_TUNINGS = 2  # The frequency goes with a power of the modulus between 1/3 and 1/2
_UNTIL_GRID = 2  # Rounds for the noise before the resolution is looked at
ROUNDS = 8
"""Optima at most that are sought from one another, as noise, the theory's error and the resolution become known."""


def _fit(
    scene: Scene, given: Scene, films: Measurements, features: Sequence[Features | None], request: _Request
) -> Fit:
    """One fit with the effects that the scene's own values call for."""
    problem = request.problem(scene, films)
    begin = time.perf_counter()
    first, loss = _first(problem, scene, features), request.loss
    how: dict[str, Any] = {"loss": loss, "method": request.method, "gain": _GAIN}
    _foretell(problem, request)
    starts = multi_start(
        problem,
        first,
        count=request.starts,
        seed=request.seed,
        asked=problem.asked,
        enough=lambda best: _as_noise(problem, best),
        on_progress=counting(request.progress, "starts"),
        **how,
    )
    # What is stuck in the integrator's own noise, but lower, is worth smaller steps.
    able = [one for one in starts.results if one.optimum.converged or one.optimum.status == STUCK]
    front = min(able or starts.results[:1], key=lambda one: one.optimum.value)
    problem, best, resolution = _settled(problem, front.optimum, scene, request, how)
    others = [one for one in starts.results if one is not front]
    starts = replace(starts, results=(replace(front, optimum=best), *others))
    of_profiles = counting(request.progress, "profiles")
    inferred = infer(problem, starts, profiles=request.profiles, on_progress=of_profiles, **how)
    best, known = inferred.starts.best, inferred.information
    reading = known.spread.reading
    curves, unit = problem.curves(best.q), reading if reading > 0 else 1.0
    parts = [(curve - film.data) / (unit * film.std) for film, curve in zip(problem.films, curves, strict=True)]
    left = parts
    if loss.kind == "linear":
        left = [part / unit for part in problem.innovations(best.residuals, best.jacobian)]
    least = not problem.noise_known and problem.noise.deviation <= problem.least_noise
    checks = check_residuals([] if least else left, problem.asked, noise_known=problem.noise_known)
    fitted = []
    for number, curve in enumerate(curves):
        film = problem.films[number]
        own = film.time, film.place, film.data, curve, parts[number], film.is_force, features[number]
        fitted.append(FittedFilm(*own, name=film.name or f"film {number + 1}"))
    spent = time.perf_counter() - begin
    request.progress.stage("done")
    asked = problem.free[: problem.asked]
    shifts = np.zeros(problem.asked) if resolution is None else resolution.total
    coarse = resolution is not None and resolution.shares.total > SHARE
    parameters = {
        free.name: fitted_parameter(free, verdict, float(shift), widened=coarse)
        for free, verdict, shift in zip(asked, inferred.verdicts, shifts, strict=True)
    }
    return Fit(
        scene=given,
        fitted_scene=with_values(given, *_shared(problem, best.q)),
        measurements=films,
        parameters=parameters,
        correlation=known.correlation,
        combinations=tuple(combination_text(one, problem) for one in known.combinations),
        noise=reading * problem.unit,
        noise_known=problem.noise_known,
        outcome=_outcome(problem, inferred, checks, parts, coarse=coarse, loss=loss),
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
        camera=_of_camera(problem, best),
        theory=max((film.theory_size for film in problem.films), default=0.0),
        resolution=resolution,
        late=inferred.late or time.monotonic() > request.deadline,
    )


def _shared(problem: FilamentProblem, q: Floats) -> tuple[list[FreeParameter], list[float]]:
    """What all films have in common, and its values: a scene has no place for what single films have."""
    pairs = [(free, free.value(float(x))) for free, x in zip(problem.free[: problem.asked], q, strict=False)]
    kept = [(free, value) for free, value in pairs if free.film is None]
    return [free for free, _ in kept], [value for _, value in kept]


def _settled(
    problem: FilamentProblem, best: Optimum, scene: Scene, request: _Request, how: Mapping[str, Any]
) -> tuple[FilamentProblem, Optimum, Moved | None]:
    """Fit again from the optimum until its noise and the theory's error are its own, and its resolution suffices."""
    resolution, fine, spent = None, request.rtol is not None, best.evaluations
    again: tuple[FilamentProblem, Floats] | None
    for number in range(ROUNDS):
        again = None
        if best.status == STUCK and request.rtol is None:
            again = problem.at(tighter(problem), best.q)
        elif best.converged:
            now = problem.noise_at(best.residuals, best.jacobian, how["loss"])
            # What cells err by looks like correlation, and is no noise.
            alone = now if fine else replace(now, correlation=problem.noise.correlation)
            if not problem.has(alone, best.q) and (fine or number < _UNTIL_GRID):
                again = problem.settled(best.q, alone)
            elif not fine:
                request.progress.stage("grid, fibres and time steps")
                resolution = moved(problem, best, _information(problem, best, how["loss"]))
                at = finer(resolution, scene)
                fine = at is None
                if at is not None:
                    again = problem.at(at, best.q)
                elif not problem.has(now, best.q):
                    again = problem.settled(best.q, now)
        if again is None:
            break
        try:
            problem, best = again[0], minimise(*again, **how)
        except TimeLimitError:
            break
        spent += best.evaluations
    return problem, *_near_enough(problem, replace(best, evaluations=spent), resolution, how["loss"])


def _near_enough(
    problem: FilamentProblem, best: Optimum, resolution: Moved | None, loss: Loss
) -> tuple[Optimum, Moved | None]:
    """Values within a standard error of an optimum that their own noise hides: how near becomes part of the error."""
    if best.status != STUCK or best.offset >= 1:
        return best, resolution
    known = _information(problem, best, loss)
    near = beside_optimum(resolution or moved(problem, best, known), best.offset, known)
    return replace(best, converged=True), near


def _information(problem: FilamentProblem, best: Optimum, loss: Loss) -> Information:
    asked = problem.asked
    box, flags = (problem.lower[:asked], problem.upper[:asked]), problem.logarithmic[:asked]
    given = problem.names[:asked], best.q[:asked], best.residuals, best.jacobian, box
    how: dict[str, Any] = {"noise_known": problem.noise_known, "readings": problem.readings, "loss": loss}
    return information(*given, **how, logarithmic=flags)


def _foretell(problem: FilamentProblem, request: _Request) -> None:
    """Say about how long the fit will take, by one evaluation."""
    begin = time.perf_counter()
    problem.linearised(problem.typical)
    one = time.perf_counter() - begin
    profiles = _PER_PROFILE * problem.asked if request.profiles else 0
    request.progress.doing(f"about {one * (_PER_OPTIMUM + profiles):.2g} s for {problem.asked} unknowns")


def _as_noise(problem: FilamentProblem, best: Optimum) -> bool:
    """Whether an optimum leaves no more than the noise, so that none can be much better."""
    data = best.residuals[: problem.readings]
    return data.size >= _FEW and float(data @ data) < _AS_NOISE * data.size


def _of_camera(problem: FilamentProblem, best: Optimum) -> dict[str, tuple[float, float, float]]:
    """Value, standard error and the one known beforehand of the camera's own numbers."""
    covariance = np.linalg.pinv(best.jacobian.T @ best.jacobian)
    return {
        free.name: (
            free.value(float(q)),
            abs(free.slope(float(q))) * float(np.sqrt(variance)),
            abs(free.slope(free.scaled(free.typical))) * free.prior,
        )
        for free, q, variance in zip(problem.free, best.q, np.diag(covariance), strict=True)
        if free.path in CAMERA and np.isfinite(free.prior)
    }


def far_out(residuals: Floats) -> NDArray[np.bool_]:
    """Which residuals lie so far outside the others that noise would hardly do it once in a thousand films."""
    count = residuals.size
    limit = float(stats.norm.isf(0.5e-3 / max(count, 1)))
    found: NDArray[np.bool_] = (np.abs(residuals) > limit * noise_scale(residuals)) & (count >= _FEW)
    return found


def fitted_parameter(
    free: FreeParameter, verdict: ParameterVerdict, shift: float = 0.0, *, widened: bool = False
) -> FittedParameter:
    """Turn a verdict on q into one on the parameter, its interval widened by the shift if that is asked for."""
    more = shift if widened else 0.0
    low, high = (
        None if q is None else free.value(q + sign * more) for q, sign in ((verdict.lower, -1), (verdict.upper, 1))
    )
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
        discretization=abs(free.slope(verdict.best)) * shift,
    )


def _outcome(
    problem: FilamentProblem,
    inferred: Inference,
    checks: ResidualChecks,
    parts: Sequence[Floats],
    *,
    coarse: bool,
    loss: Loss,
) -> FitOutcome:
    best, words = inferred.starts.best, {one.word for one in inferred.verdicts}
    if not best.converged:
        late = best.status == OUT_OF_TIME or time.monotonic() > problem.deadline
        return FitOutcome.out_of_time if late else FitOutcome.not_converged
    # A reading that lies off by less than cameras tell pulls nothing, however small the noise of the others.
    pulls = max(1.0, _FAR_OFF * problem.least_noise / problem.unit)
    wild = sum(int((far_out(part) & (np.abs(part) > pulls)).sum()) for part in parts)
    if loss.kind == "linear" and wild > _WILD * sum(part.size for part in parts):
        return FitOutcome.outliers
    against = problem.contradiction(best.residuals, best.jacobian)
    if against is not None and against.p_value < _SMALL:
        return FitOutcome.contradiction
    # An error that is allowed for, but is not there, makes neighbours differ: only their likeness says what is missed.
    alike = best.residuals.size == problem.readings or (checks.autocorrelation or 0.0) > 0
    if (checks.verdict == "not white" and alike) or _beyond_theory(problem, best) or _correlated_for_long(problem):
        return FitOutcome.model_error
    if "at a bound" in words:
        return FitOutcome.at_a_bound
    if coarse:
        return FitOutcome.discretization_error
    return FitOutcome.solved if words == {"identified"} else FitOutcome.not_identified


def _beyond_theory(problem: FilamentProblem, best: Optimum) -> bool:
    """Whether the theory errs by more than it was measured to, or the camera is off by more than it may be."""
    known = best.residuals[problem.readings :]
    return bool(known.size) and float(stats.chi2.sf(float(known @ known), known.size)) < _SMALL


def _correlated_for_long(problem: FilamentProblem) -> bool:
    """Whether what a camera's noise is correlated by lasts for so much of a film that it is the model's error."""
    correlation, frames = problem.noise.correlation, min(film.data.size for film in problem.films)
    return correlation > 0 and -1 / np.log(correlation) > _LONG * frames


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


def _features(series: Series, scene: Scene) -> Features | None:
    # The closed form and its features are those of a steady weight.
    if np.count_nonzero(series.time > 0) < FEWEST or not scene.load.gravity > 0 or scene.load.shake > 0:
        return None
    return read_features(series.time, series.midpoint, series.std, scene.load.gravity, rest_length(scene))


def _first(problem: FilamentProblem, scene: Scene, features: Sequence[Features | None]) -> list[Floats]:
    """What is in tune with a film that rings, the closed form's values where it has one, and the scene's own."""
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
    tuned = _in_tune(problem, scene, features, starts[0])
    return [*([] if tuned is None else [tuned]), *starts[:0:-1], starts[0]]


def _in_tune(
    problem: FilamentProblem, scene: Scene, features: Sequence[Features | None], start: Floats
) -> Floats | None:
    """The start with a modulus that makes a film ring as it was seen to: fits a period off are optima, too."""
    column = next((k for k, free in enumerate(problem.free[: problem.asked]) if free.name == "youngs_modulus"), None)
    number = next((k for k, one in enumerate(features) if one is not None and one.frequency.value), None)
    if column is None or number is None:
        return None
    film, seen, q = problem.films[number], features[number], start.copy()
    for _ in range(_TUNINGS):
        count = film.series.time.size
        curve = replace(film.series, midpoint=film.heights(q)[:count], std=film.std[:count])
        own = _features(curve, own_scene(film.series, scene)) if np.isfinite(curve.midpoint).all() else None
        if own is None or own.frequency.value is None or seen is None or seen.frequency.value is None:
            return None
        step = 2 * math.log(seen.frequency.value / own.frequency.value)
        q[column] = np.clip(q[column] + step, problem.lower[column], problem.upper[column])
    return q
