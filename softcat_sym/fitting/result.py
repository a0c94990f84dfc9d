"""Result of a fit: outcome, parameters with intervals, films beside their models, and the content of its files."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy import stats

from softcat_sym import drawing
from softcat_sym.fitting.closed_form import ClosedForm
from softcat_sym.fitting.features import Features
from softcat_sym.fitting.free_parameters import FreeParameter
from softcat_sym.fitting.identifiability import (
    Combination,
    Information,
    ResidualChecks,
)
from softcat_sym.fitting.inference import ParameterVerdict, Profile, Word, judged
from softcat_sym.fitting.least_squares import Floats, MultiStartResult
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.problem import FilamentProblem, FilmReadings
from softcat_sym.fitting.resolution import Moved
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.table_reader import counted

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class FitOutcome(Enum):
    """End of a fit; ``name`` with blanks for underscores goes into ``fit.json``."""

    solved = "the model fits within its noise; every free parameter is identified, to less than a factor of two"
    not_identified = (
        "the model fits, but the data do not tell every parameter to a factor of two: read the verdicts and the "
        "combinations, fix what is known otherwise, or film what softcat's experiment design proposes"
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
        "take these readings out of the file, and fit again"
    )
    discretization_error = (
        "grid, fibres and time steps move the constants by more than a third of their standard errors, on the finest "
        "grid that the scene leaves to the program: the intervals are widened by as much; leave numerics.cells, fibres "
        "and rtol out of the scene, or give finer ones"
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
        """The name with blanks, for files and terminals."""
        return self.name.replace("_", " ")


@dataclass(frozen=True)
class FittedParameter:
    """One parameter, in SI."""

    name: str  # Of the free parameter
    unit: str  # SI
    value: float | None  # None where the parameter is not identified
    best: float  # Value at the optimum, identified or not
    std: float | None  # Standard error, to first order; None with the value
    ci95: tuple[float | None, float | None]  # 95 % interval; None where it does not end
    verdict: Word  # ``"poorly determined"`` where the ends of the interval differ by a factor of two or more
    reason: str  # Why it is not identified; empty if it is
    typical: float  # Value in the scene
    bounds: tuple[float, float]  # Of the fit

    discretization: float = 0.0
    """Error by grid, fibres and time steps [its unit]; the interval includes it where it matters."""

    def to_dict(self) -> dict[str, Any]:
        """Its entry in ``fit.json``."""
        keys = ("value", "std", "ci95", "verdict", "reason", "unit", "best", "typical", "bounds", "discretization")
        return {key: getattr(self, key) for key in keys}


@dataclass(frozen=True, eq=False)
class FittedFilm:
    """One film beside its model."""

    time: Floats  # shape (n,); [s]: readings of the midpoint, then of points of whole shapes
    place: Floats  # shape (n,); x of a point of a shape from halfway between the supports [m]; NaN for other readings
    measured: Floats
    model: Floats
    residuals: Floats  # shape (n,); (model - measured) over the noise
    # Features that are read without a model; None if the film is too short, or gravity is shaken.
    features: Features | None
    closed: ClosedForm | None  # Constants that they give, if the theory holds for the scene
    name: str  # File or number

    @classmethod
    def of(
        cls, film: FilmReadings, q: Floats, unit: float, features: Features | None, closed: ClosedForm | None, name: str
    ) -> FittedFilm:
        """Compare a film with its model and the errors of camera and theory that it shows.

        `unit` is the noise over the film's standard errors.
        """
        values = film.values(q)
        model = values + film.systematic_part(values)
        residuals = (model - film.data) / (unit * film.std)
        return cls(film.time, film.place, film.data, model, residuals, features, closed, name)

    def part(self, chosen: NDArray[np.bool_]) -> FittedFilm:
        """The film with some of its readings."""
        keys = ("time", "place", "measured", "model", "residuals")
        return replace(self, **{key: getattr(self, key)[chosen] for key in keys})

    @property
    def of_midpoint(self) -> NDArray[np.bool_]:
        """Which readings are of the midpoint, shape (n,)."""
        return np.isnan(self.place)

    @property
    def of_shape(self) -> NDArray[np.bool_]:
        """Which readings are points of whole shapes, shape (n,)."""
        return ~np.isnan(self.place)


@dataclass(frozen=True, eq=False)
class Fit(drawing.Drawable):
    """Result of a fit to measurements.

    Attributes
    ----------
    scene : Scene
        As given.
    fitted_scene : Scene
        The scene with the best values.
    measurements : Measurements
        Measurements as corrected, with notes.
    parameters : dict of str to FittedParameter
        The free parameters.
    correlation : ndarray, shape (k, k)
        Correlation of the parameters' estimates, in their order.
    combinations : tuple of str
        Products of powers that are identified where single parameters are not, with value and interval.
    noise : float
        Standard deviation of a reading [m]: as stated, or estimated from the residuals.
    noise_known : bool
        Whether the noise is stated.
    outcome : FitOutcome
        Whether the numbers can be used, and what to do if not.
    films : tuple of FittedFilm
        Data, model and residuals.
    checks : ResidualChecks
        Whether the residuals are white.
    starts : MultiStartResult
        Results of all starts.
    profiles : tuple of Profile
        Of every parameter in its order; empty if they were not requested.
    information : Information
        Fisher information at the optimum.
    problem : FilamentProblem
        The problem that was solved; q are its unknowns.
    effects : tuple of str
        Effects in force.
    backend : str
        The backend that integrated, with the reason.
    repeats : tuple of str
        Why the fit or its profiles were repeated: more effects, a better optimum, another one nearly as good.
    seconds : float
        Duration after compiling, without the final run of the best fit.
    camera : dict of str to (float, float, float)
        For each parameter of the camera: value, standard error, and prior standard deviation; SI.
    theory : float
        Assumed standard deviation of the theory's error, over the height of the midpoint; 0 if it is not included.
    resolution : Moved
        Final cells, fibres and tolerance, and by how much they move the constants.
    late : bool
        Whether the time limit passed before all steps of the fit.
    priors : mapping of str to str
        Priors that a posterior of this fit has; the fit is without them.
    message : str
        Why a run of the fitted filament fails; empty if it does not.
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
    priors: Mapping[str, str]
    message: str = ""

    def plot(self, what: str = "curves") -> Figure:
        """Draw ``curves``, ``profiles``, ``correlation`` or ``starts`` of the fit."""
        return drawing.plot(self, what)

    def __repr__(self) -> str:
        lines = [f"Fit {self.scene.title!r}: {self.outcome.name}"]
        for name, one in self.parameters.items():
            value = f"{one.value:.4g}" if one.value is not None else "not known"
            error = f" +- {one.std:.2g}" if one.std is not None else ""
            lines.append(f"{name} = {value}{error} {one.unit}: {one.verdict}")
        return "\n  ".join(lines)

    @property
    def notes(self) -> list[str]:
        """Corrections that were made to the measurements, film by film where there are several."""
        several = len(self.films) > 1
        pairs = zip(self.films, self.measurements.series, strict=True)
        return [f"{film.name}: {note}" if several else note for film, series in pairs for note in series.notes]

    @property
    def squares(self) -> float:
        """Sum of the squared whitened residuals: chi^2 where the noise is known, otherwise [m^2]."""
        residuals = self.starts.best.residuals
        return float(residuals @ residuals) * (1.0 if self.noise_known else self.problem.unit**2)

    @property
    def outlying(self) -> list[tuple[str, float]]:
        """Readings far outside the noise of the others: film and time [s]."""
        return [(film.name, float(time)) for film in self.films for time in film.time[far_out(film.residuals)]]

    @property
    def residual_std(self) -> float:
        """Root mean square of model less measurement over all readings [m]."""
        left = np.concatenate([film.model - film.measured for film in self.films])
        return float(np.sqrt(np.mean(left**2)))

    @property
    def evaluations(self) -> int:
        """Number of evaluations of the model, from all starts."""
        return sum(result.optimum.evaluations for result in self.starts.results)

    @property
    def warnings(self) -> list[str]:
        """Warnings about the numbers, besides the outcome."""
        found, size, starts = [], self.checks.size, self.starts
        if size is not None and size.p_value < SIGNIFICANT:
            found.append(
                f"the residuals are larger than the stated errors (chi-square {size.value:.0f} for "
                f"{sum(film.time.size for film in self.films)} readings, p = {size.p_value:.2g}): the intervals are "
                "too narrow"
            )
        if self.late and self.outcome.converged:
            found.append("the time limit passed before the profiles: intervals are from the curvature alone")
        found += [] if self.problem.flow is None else self.problem.flow.warnings
        if self.outcome is not FitOutcome.outliers and (far := self.outlying):
            found.append(f"{counted(len(far), 'reading')} far outside the noise, first at {far[0][1]:.4g} s")
        if self.problem.noise.correlation:
            together = f"{self.problem.noise.correlation:.2f}"
            found.append(f"neighbouring readings are correlated by {together}, which widens the intervals")
        if starts.reached_best == 1 and len(starts.results) > 2:
            found.append("only one start reached the best fit: there may be a better one; use more starts")
        for one in self.profiles:
            if one.unconverged:
                found.append(f"profile of {one.name}: {one.unconverged} of {one.q.size} points did not converge")
            if one.better is not None:
                found.append(f"profile of {one.name}: it found a better optimum; start nearer to it")
        return found

    def to_dict(self) -> dict[str, Any]:
        """Content of ``fit.json``: plain SI."""
        checks, problem, series, moved = self.checks, self.problem, self.measurements.series, self.resolution
        # Cells, tolerance and fibres, each with the largest shift of a constant in standard errors.
        shares = {} if moved is None else {"cells": "space", "rtol": "time", "fibres": "section"}
        resolution = {
            name: {"value": getattr(moved.at, name), "standard_errors": getattr(moved.shares, share)}
            for name, share in shares.items()
            if moved is not None
        }
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
            "resolution": resolution or None,
            "outliers": [{"film": film, "time_s": time} for film, time in self.outlying],
            "flow_curve": self._flow_curve(),
            "late": self.late,
            "residuals": {
                "verdict": checks.verdict,
                "tests": [vars(test) for test in checks.tests],
                "autocorrelation": checks.autocorrelation,
                "chi_square": None if checks.size is None else vars(checks.size),
            },
            "features": [
                {
                    "film": film.name,
                    **features_dict(film.features),
                    "closed_form": None if film.closed is None else film.closed.to_dict(),
                }
                for film in self.films
            ],
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
        """Test of the flow curve against the films, with measured and fitted stresses at its rates."""
        best, flow = self.starts.best, self.problem.flow
        test = self.problem.contradiction(best.residuals, best.jacobian)
        if flow is None or test is None:
            return None
        stress = {"measured_Pa": flow.curve.shear_stress.tolist(), "model_Pa": flow.stress(best.q).tolist()}
        return {"shear_rate_1_s": flow.curve.shear_rate.tolist(), **stress, "contradiction": vars(test)}

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
        """Content of ``fit.csv``: data, model [m] and residuals of all films; a midpoint has no place."""
        columns = {"time_s": "time", "x_m": "place", "measured_m": "measured", "model_m": "model"}
        columns |= {"residual": "residuals", "film": "name"}
        rows = [
            pd.DataFrame({column: getattr(film, key) for column, key in columns.items()}, range(film.time.size))
            for film in self.films
        ]
        frame = pd.concat(rows, ignore_index=True)
        return frame.drop(columns="x_m") if frame["x_m"].isna().all() else frame


FEATURES = {
    "t_high": ("start of the 1/3 law t_high", "s"),
    "frequency": ("frequency R", "rad_s"),
    "decay": ("decay rate d", "1_s"),
    "sag": ("sag H while it rings", "m"),
    "prefactor": ("prefactor B of the 1/3 law", ""),
}
"""Features of a film: attributes of `Features`, their names for readers, and the units in names of keys."""

MODULUS = "material.youngs_modulus"
_INNER = 0.85
_INNER_STD = float(stats.truncnorm.std(*stats.norm.interval(_INNER)))
MIN_READINGS = 20
"""Smallest number of readings whose distribution is tested."""
SIGNIFICANT = 0.01
"""p-value below which a test gives a warning."""
_OF_CAMERA = ("value", "std", "known_to")
_OF_A_START = ("value", "converged", "status", "iterations", "evaluations")


def features_dict(features: Features | None) -> dict[str, Any]:
    """Entries of the features of a film in ``fit.json``."""
    readings = {} if features is None else {name: getattr(features, name) for name in FEATURES}
    return {
        "_".join(filter(None, (name, FEATURES[name][1]))): {"value": one.value, "std": one.error, "reason": one.reason}
        for name, one in readings.items()
    }


def combination_text(combination: Combination, problem: FilamentProblem) -> str:
    """A combination as text, with value and 95 % interval, in SI if it is a product."""
    parts = [free for name in combination.names for free in problem.free if free.name == name]
    if not all(free.logarithmic for free in parts):
        low, high = combination.interval
        return f"{combination.text} = {combination.value:.4g} ({low:.4g} to {high:.4g}) in scaled unknowns"
    value, low, high = combination.product([free.typical for free in parts])
    if not np.isfinite(value):
        return f"{combination.text}: known to {combination.standard_error:.1%}"
    return f"{combination.text} = {value:.4g} ({low:.4g} to {high:.4g}), SI"


def far_out(residuals: Floats) -> NDArray[np.bool_]:
    """Flag the residuals so far out that noise alone would produce one in one film of several hundred.

    The scale is the root mean square of the smaller 85 % of the residuals, which up to 15 % of outliers hardly change.
    """
    count = residuals.size
    if count < MIN_READINGS:
        return np.zeros(count, dtype=bool)
    limit = float(stats.norm.isf(0.5e-3 / count))
    inner = np.sort(np.abs(residuals))[: math.ceil(_INNER * count)]
    scale = max(float(np.sqrt(np.mean(inner**2))) / _INNER_STD, 1e-9)
    return np.asarray(np.abs(residuals) > limit * scale)


def fitted_parameter(
    free: FreeParameter,
    verdict: ParameterVerdict,
    shift: float = 0.0,
    *,
    widened: bool = False,
    stiffness_error: float = 0.0,
    quantile: float = 1.96,
) -> FittedParameter:
    """Convert a verdict on q to the parameter; with `widened`, its interval includes the shift.

    A theory that errs in every frequency errs in the stiffness by twice as much, which no film tells from Young's
    modulus: its interval and standard error include that standard deviation too.
    """
    margin = shift if widened else 0.0
    if free.constant == MODULUS and stiffness_error:
        verdict = _with_error(verdict, stiffness_error, quantile)
    ends = [None if q is None else q + sign * margin for q, sign in ((verdict.lower, -1), (verdict.upper, 1))]
    verdict = judged(replace(verdict, lower=ends[0], upper=ends[1]), free.logarithmic)
    low, high = (None if q is None else free.value(q) for q in ends)
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


def _with_error(verdict: ParameterVerdict, error: float, quantile: float) -> ParameterVerdict:
    """A verdict with one more independent error of q."""
    ends = [
        None if end is None else verdict.best + sign * math.hypot(end - verdict.best, quantile * error)
        for end, sign in ((verdict.lower, -1), (verdict.upper, 1))
    ]
    former = verdict.standard_error
    std = None if former is None else math.hypot(former, error)
    return replace(verdict, lower=ends[0], upper=ends[1], standard_error=std)
