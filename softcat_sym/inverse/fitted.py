"""What a fit says of its parameters, in SI."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from softcat_sym.inverse.estimation.combinations import Combination
from softcat_sym.inverse.estimation.fisher import Information
from softcat_sym.inverse.estimation.least_squares import Floats
from softcat_sym.inverse.estimation.multi_start import Waterfall
from softcat_sym.inverse.estimation.profiles import Profile
from softcat_sym.inverse.estimation.residual_checks import ResidualChecks
from softcat_sym.inverse.estimation.verdicts import Verdict, Word
from softcat_sym.inverse.features import Features
from softcat_sym.inverse.filament_problem import FilamentProblem
from softcat_sym.inverse.fit_outcome import FitOutcome
from softcat_sym.inverse.forward.free import FreeParameter
from softcat_sym.inverse.measurements.series import Measurements
from softcat_sym.scene import Scene


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


def fitted_parameter(free: FreeParameter, verdict: Verdict) -> FittedParameter:
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


@dataclass(frozen=True, eq=False)
class FittedFilm:
    """One film beside its model.

    Attributes
    ----------
    time, measured, model : ndarray, shape (n,)
        [s], [m], [m]: of the midpoint, then of points of whole shapes.
    place : ndarray, shape (n,)
        Distance of a point of a shape from halfway between the supports [m]; NaN of a midpoint.
    residuals : ndarray, shape (n,)
        (model - measured) over the noise.
    features : Features or None
        What it shows without a model; None of a film that is too short, or under shaken gravity.
    name : str
        File or number.
    """

    time: Floats
    place: Floats
    measured: Floats
    model: Floats
    residuals: Floats
    features: Features | None
    name: str

    def part(self, chosen: NDArray[np.bool_]) -> FittedFilm:
        """Some of its readings."""
        picked = (getattr(self, key)[chosen] for key in ("time", "place", "measured", "model", "residuals"))
        time, place, measured, model, residuals = picked
        return FittedFilm(time, place, measured, model, residuals, self.features, self.name)

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
    starts : Waterfall
        Where every start ended.
    profiles : tuple of Profile
        Of every parameter in its order; empty if they were not asked for.
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
    complaint : str
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
    starts: Waterfall
    profiles: tuple[Profile, ...]
    information: Information
    problem: FilamentProblem
    effects: tuple[str, ...]
    backend: str
    repeats: tuple[str, ...]
    seconds: float
    complaint: str = ""

    @property
    def notes(self) -> tuple[str, ...]:
        """Corrections that were made to the measurements."""
        return tuple(note for one in self.measurements.series for note in one.notes)

    @property
    def squares(self) -> float:
        """Sum of the squared residuals in units of the problem."""
        residuals = self.starts.best.residuals
        return float(residuals @ residuals)


def told(combination: Combination, problem: FilamentProblem) -> str:
    """One sentence on a combination, with value and 95 % interval in SI where it is a product."""
    free = {one.name: one for one in problem.free}
    parts = [free[name] for name in combination.names]
    if not all(one.logarithmic for one in parts):
        low, high = combination.interval
        return f"{combination.text} = {combination.value:.4g} ({low:.4g} to {high:.4g}) in scaled unknowns"
    value, low, high = combination.product([one.typical for one in parts])
    if not np.isfinite(value):
        return f"{combination.text}: known to {combination.standard_error:.1%}"
    return f"{combination.text} = {value:.4g} ({low:.4g} to {high:.4g}), SI"
