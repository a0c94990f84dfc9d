"""Selection of a law: several are fitted to the same films, and ranked by information criteria."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Unpack

import numpy as np
import pandas as pd
from scipy.optimize import minimize_scalar

from softcat_sym.effects.registry import REGISTRY
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.fitting.criterion import CRITERION, charge, charges
from softcat_sym.fitting.fit import FitOptions, fit
from softcat_sym.fitting.flow_curve import REPLACED
from softcat_sym.fitting.free_parameters import candidates
from softcat_sym.fitting.identifiability import SIGNIFICANCE
from softcat_sym.fitting.least_squares import OUT_OF_TIME, Floats
from softcat_sym.fitting.measurements import Measurements, read_measurements
from softcat_sym.fitting.plausibility import Films, checked
from softcat_sym.fitting.priors import read_priors
from softcat_sym.fitting.problem import FilmReadings
from softcat_sym.fitting.result import Fit
from softcat_sym.scene.laws import LAWS, kind_of_constant, spec_of
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import did_you_mean

CLOSE = 10.0
"""Difference of the criterion above which a law is ruled out (Burnham and Anderson 2002, section 2.6) if the penalty of
a constant is 2; the difference is proportional to that penalty."""

CANNOT = "cannot tell"

# Mean squares below this are rounding errors, and do not decide between laws.
_ROUNDING = 1e-18


@dataclass(frozen=True)
class FittedLaw:
    """Data of a fit for the comparison."""

    name: str  # The law
    unknowns: int  # Number of fitted unknowns
    squares: float  # As :func:`squares_of` has them: chi^2 + log det C where the noise is known
    failure: str = ""  # Why there is no fit; empty if there is one


@dataclass(frozen=True)
class Ranked:
    """A law in the table."""

    law: FittedLaw  # The fit
    # `CRITERION`, by which the laws are ranked, and those of Akaike (1974) and Schwarz (1978); up to a common constant.
    # All are infinite for a fit that failed.
    criterion: float
    aic: float
    bic: float
    difference: float  # Of the criterion, less its least value; infinite for a fit that failed
    weight: float  # exp(-difference/2), normalised: Akaike weight


@dataclass(frozen=True)
class ModelChoice:
    """The table, the best law first, those that failed last."""

    table: tuple[Ranked, ...]  # All laws
    close: tuple[str, ...]  # The best law, and those that are not ruled out
    wider: tuple[str, ...]  # Laws that contain the best, and gain nothing by it: no test can rule them out
    verdict: str  # The name of the best law, or `CANNOT` if others are not ruled out
    reason: str = ""  # Why there is no verdict; empty if there is one


def choose_model(laws: Sequence[FittedLaw], points: int, *, noise_known: bool, independent: float = 1.0) -> ModelChoice:
    """Rank laws that were fitted to the same data.

    If the noise is known, the squares are chi^2 and the criterion is chi^2 + 2 k, Akaike's. Otherwise it is
    :data:`softcat_sym.fitting.criterion.CRITERION`, and AIC and BIC count the variance as one more constant.
    `independent` is the share of the data that are independent of each other; differences count by this share. The best
    law is the verdict if all laws were fitted, and every other is ruled out (see `CLOSE`) or contains the best and
    gains less by its further constants than half their penalty.
    """
    if not laws:
        raise SoftcatError("no law is given to choose from; accepted: one or more fitted laws")
    rows = sorted(
        ((*_criteria(law, points, noise_known=noise_known), law) for law in laws),
        key=lambda row: (bool(row[-1].failure), row[0], row[-1].unknowns),
    )
    least, best = rows[0][0], rows[0][-1]
    differences = [math.inf if math.isinf(row[0]) else row[0] - least for row in rows]
    weights = [math.exp(-0.5 * difference) for difference in differences]
    total = sum(weights) or 1.0
    table = tuple(
        Ranked(law, criterion, aic, bic, difference, weight / total)
        for (criterion, aic, bic, law), difference, weight in zip(rows, differences, weights, strict=True)
    )
    close = [best.name] * math.isfinite(least)
    wider: list[str] = []
    penalties = {law.name: charges(points, law.unknowns, noise_known=noise_known) for law in laws}
    for row in table[1:]:
        one, unknowns = row.law, max(row.law.unknowns, best.unknowns)
        limit = CLOSE / 2 * charge(points, unknowns, noise_known=noise_known) / independent
        enough = _contains(one.name, best.name) and 2 * row.difference > penalties[one.name] - penalties[best.name]
        if row.difference < limit:
            (wider if enough else close).append(one.name)
    reason = _undecided(table, close, points)
    return ModelChoice(table, tuple(close), tuple(wider), CANNOT if reason else best.name, reason)


def _contains(wider: str, narrower: str) -> bool:
    inside = spec_of(wider).contains
    return narrower in inside or any(_contains(one, narrower) for one in inside)


def _undecided(table: Sequence[Ranked], close: Sequence[str], points: int) -> str:
    """Why there is no verdict; empty if there is one."""
    failed = [row.law.name for row in table if row.law.failure]
    undetermined = [row.law.name for row in table if math.isinf(row.criterion) and not row.law.failure]
    objections = [
        (close[1:], "{} not ruled out"),
        (undetermined, f"{points} data are too few for {{}}"),
        (failed, "no fit of {}"),
    ]
    found = [words.format(", ".join(names)) for names, words in objections if names]
    return f"{table[0].law.name} ranks first, but {'; '.join(found)}" if found else ""


def _criteria(law: FittedLaw, points: int, *, noise_known: bool) -> tuple[float, float, float]:
    if law.failure:
        return math.inf, math.inf, math.inf
    constants = law.unknowns + (not noise_known)
    misfit = law.squares if noise_known else points * math.log(max(law.squares / points, _ROUNDING))
    criterion = misfit + charges(points, law.unknowns, noise_known=noise_known)
    return criterion, misfit + 2 * constants, misfit + constants * math.log(points)


_STIFFER = 50.0
"""Young's modulus of a flowing law over the modulus that alone explains the sag, so that most of the sag is flow."""

_SOONER = 0.1
"""Viscosity of a law with a final sag over the viscosity that alone explains the duration: the filament stops early."""

# Without a sag or without weight: a sag of a tenth of the span, and a weight rho g L of 1 kPa.
_SAG, _WEIGHT = 0.1, 1e3


def rough_constants(scene: Scene, films: Measurements, law: str) -> dict[str, float]:
    """Guess constants such that each alone would explain the largest sag.

    A string of modulus E sags under its weight by w with E = (3/64) rho g L (L/w)^3, a clamped beam with E = rho
    g L^4/(32 h^2 w) (THEORY, small slopes); both share the load. The viscosity is that modulus times the duration, the
    yield stress the tension rho g L^2/(8 w).
    """
    span, thickness = scene.filament.span, scene.filament.thickness
    weight = scene.filament.density * scene.load.gravity * span or _WEIGHT
    seen = [(one.time, one.midpoint) for one in films.series if one.time.size]
    seen += [(one.shapes.time, one.shapes.y) for one in films.series if one.shapes is not None]
    longest = max((float(np.max(time)) for time, _ in seen), default=0.0) or scene.run.duration
    sag = max((float(np.max(np.abs(height))) for _, height in seen), default=0.0) / span or _SAG
    as_string, as_beam = 3 / 64 * weight / sag**3, weight * span**2 / (32 * sag * thickness**2)
    modulus = 1 / (1 / as_string + 1 / as_beam)
    spec = LAWS[law]
    held = spec.is_solid or spec.yields
    return {
        "youngs_modulus": modulus * (_STIFFER if spec.flows else 1.0),
        "second_modulus": modulus,
        "yield_stress": weight / (8 * sag),
        "viscosity": modulus * longest * (_SOONER if held else 1.0),
    }


FITTED = tuple(one.name for one in LAWS.values() if one.constants and not one.lists and not one.has_chains)
"""Laws with a fixed set of constants that a sag determines roughly; a film cannot separate polymer and solvent."""


def constants_of(law: str) -> tuple[str, ...]:
    """Names of all constants of one of :data:`FITTED`, its index included."""
    return (*LAWS[law].constants, *(("index",) if LAWS[law].has_index else ()))


def scene_of_law(scene: Scene, law: str, films: Measurements) -> Scene:
    """Give a scene another law, with the scene's own constants where it has them and rough ones otherwise."""
    material, spec, rough = scene.material, LAWS[law], rough_constants(scene, films, law)
    index = material.index if spec.has_index else 1.0
    # A consistency is not a viscosity, and the rough value holds only for an index of one.
    same = material.spec.has_index == spec.has_index or material.index == 1
    changes: dict[str, object] = {f"material.{name}": None for name in REPLACED}
    changes["material.law"] = law
    if law not in FITTED or "youngs_modulus" not in spec.constants:
        changes["material.youngs_modulus"] = None
    for name in spec.constants:
        own = getattr(material, name)
        keeps = own is not None and (name != "viscosity" or same)
        changes[f"material.{name}"] = kind_of_constant(name, law, index).write(own if keeps else rough[name])
    if spec.has_index:
        changes["material.index"] = index
    if isinstance(scene.run.effects, str):
        return scene.replace(changes)
    freed = scene.replace({**changes, "run.effects": "auto"})
    return freed.replace({"run.effects": _effects(scene, freed, scene.run.effects)})


def _effects(former: Scene, scene: Scene, listed: Sequence[str]) -> list[str]:
    """The listed effects that apply to the new law, and published effects that apply to the new law only."""
    able = {one.name: one for one in REGISTRY if one.applies(scene)}
    own = [name for name, one in able.items() if one.in_paper and not one.applies(former)]
    kept = [name for name in listed if name in able]
    names = [*kept, *(name for name in own if name not in kept)]
    while lacking := [name for name in names if not {*able[name].needs} <= {*names}]:
        names = [name for name in names if name not in lacking]
    return names


@dataclass(frozen=True, eq=False)
class LawComparison:
    """Fits of several laws to the same films, and their ranking."""

    fits: dict[str, Fit]  # Of the laws that could be fitted
    failures: dict[str, str]  # Why the others could not be fitted
    choice: ModelChoice  # Their ranking; its verdict is a law, or ``"cannot tell"``

    @property
    def best(self) -> Fit:
        """The fit of the law that ranks first, even where the verdict is ``"cannot tell"``."""
        return self.fits[self.choice.table[0].law.name]

    @property
    def sentence(self) -> str:
        """The verdict in words."""
        if self.choice.verdict == CANNOT:
            return f"{CANNOT}: {self.choice.reason}"
        doubts = (
            [f"nothing gained by the further constants of {', '.join(self.choice.wider)}"] if self.choice.wider else []
        )
        if self.best.checks.verdict == "not white":
            doubts.append("its residuals are not white")
        if not self.best.outcome.converged:
            doubts.append("its fit did not reach its optimum")
        return "; ".join([f"the films speak for {self.choice.verdict}", *doubts])

    def to_dict(self) -> dict[str, Any]:
        """Entry of the laws in ``fit.json``, in SI; infinite where there are too few readings, or no fit."""
        return {
            "verdict": self.choice.verdict,
            "sentence": self.sentence,
            "criterion": CRITERION,
            "close": list(self.choice.close),
            "wider": list(self.choice.wider),
            "table": [self._row(row) for row in self.choice.table],
        }

    def _row(self, row: Ranked) -> dict[str, Any]:
        one, law = self.fits.get(row.law.name), row.law
        return {
            "law": law.name,
            "constants": law.unknowns,
            "squares": None if one is None else one.squares,
            **{key: getattr(row, key) for key in ("criterion", "aic", "bic", "difference", "weight")},
            "residual_std_m": None if one is None else one.residual_std,
            "residuals": None if one is None else one.checks.verdict,
            "outcome": None if one is None else one.outcome.word,
            "failure": " ".join(law.failure.split()),
            "effects": [] if one is None else list(one.effects),
            "parameters": {} if one is None else {name: each.to_dict() for name, each in one.parameters.items()},
        }

    def to_frame(self) -> pd.DataFrame:
        """Content of ``laws.csv``: the ranking, the best law first; unknown values are missing."""
        frame = pd.DataFrame([self._row(row) for row in self.choice.table]).drop(columns=["effects", "parameters"])
        frame.insert(0, "rank", range(1, len(frame) + 1))
        return frame.replace([math.inf, -math.inf], math.nan)


def compared(laws: Sequence[str], fits: Mapping[str, Fit], failures: Mapping[str, str], besides: int) -> LawComparison:
    """Rank fits of the same films."""
    if not fits:
        raise SoftcatError("none of the laws can be fitted:\n" + "\n".join(f"  {k}: {v}" for k, v in failures.items()))
    table = _ranked(laws, fits, failures, besides).table
    best, above = table[0].law.name, {row.law.name: row.difference for row in table}

    def predicted_decrease(one: Fit) -> float:
        """Decrease of the criterion in the next step, to first order; infinite of a fit without the time to search."""
        return math.inf if one.starts.best.status == OUT_OF_TIME else one.starts.best.offset**2

    # A search that did not converge could only improve. That cannot harm the best law's rank; nor does it help a law
    # that would be ruled out even after the decrease that its derivatives predict.
    unreached = {
        law: one.outcome.value
        for law, one in fits.items()
        if not one.outcome.converged and law != best and above[law] < CLOSE + predicted_decrease(one)
    }
    failed = {**failures, **unreached}
    reached = {law: one for law, one in fits.items() if law not in unreached}
    return LawComparison(reached, failed, _ranked(laws, reached, failed, besides, judge=fits[best]))


def _ranked(
    laws: Sequence[str], fits: Mapping[str, Fit], failures: Mapping[str, str], besides: int, judge: Fit | None = None
) -> ModelChoice:
    """Rank fits, with the noise that the residuals of the best one show.

    Stated errors that are too small are replaced by estimated ones, and readings with a correlation r of neighbours
    count as (1 - r)/(1 + r) independent readings each.
    """
    first = next(iter(fits.values()))
    known, independent = first.noise_known, 1.0
    if judge is not None:
        checks = judge.checks
        known = known and not (checks.size and checks.size.p_value < SIGNIFICANCE)
        if checks.verdict == "not white" and (r := checks.autocorrelation or 0.0) > 0:
            independent = (1 - r) / (1 + r)
    squares = squares_of(fits, known=known)
    rows = [
        FittedLaw(law, len(fits[law].problem.free), squares[law])
        if law in fits
        else FittedLaw(law, len(constants_of(law)) + besides, 0.0, failures[law])
        for law in laws
    ]
    return choose_model(rows, first.starts.best.residuals.size, noise_known=known, independent=independent)


_NOISIER = 3.0
"""By how much more than any of the laws found the noise may be."""


def squares_of(fits: Mapping[str, Fit], *, known: bool) -> dict[str, float]:
    """The squares of every fit, those of -2 log L, in a common unit, as :class:`FittedLaw` has them.

    Every law is allowed the same error of the theory, the largest that any of them has: otherwise a law that may err
    more would fit better, or pay for it where it need not.
    """
    units = [1.0 if known else one.problem.unit for one in fits.values()]
    widest = [
        max(films, key=lambda film: film.theory_error)
        for films in zip(*(one.problem.films for one in fits.values()), strict=True)
    ]
    unit = float(np.mean(np.concatenate([film.std for film in widest])))
    limits = 1.0 if known else min(units) / unit, 1.0 if known else _NOISIER * max(units) / unit
    count = next(iter(fits.values())).starts.best.residuals.size
    values = {name: _misfit(one, widest, limits) for name, one in fits.items()}
    return values if known else {name: count * math.exp(value / count) for name, value in values.items()}


def _misfit(one: Fit, widest: Sequence[FilmReadings], limits: tuple[float, float]) -> float:
    """-2 log L with given covariances of the theory's error, for the best standard deviation of the noise in limits.

    In units of the standard deviations of the films whose covariances are given, and without the constant.
    """
    q, problem = one.starts.best.q, one.problem
    sizes, along = list[Floats](), list[Floats]()
    for film, wide in zip(problem.films, widest, strict=True):
        residual = (film.values(q) - film.data) / wide.std
        size, vectors = np.linalg.eigh(wide.covariance.systematic / np.outer(wide.std, wide.std))
        sizes.append(np.maximum(size, 0.0))
        along.append((vectors.T @ residual) ** 2)
    size, squares = np.concatenate(sizes), np.concatenate(along)
    known = 0.0 if problem.flow is None else float(np.sum(problem.flow.residuals(q) ** 2))

    def value(log_noise: float) -> float:
        variance = math.exp(2 * log_noise)
        return float(np.sum(np.log(variance + size) + squares / (variance + size)))

    low, high = (math.log(limit) for limit in limits)
    return known + (minimize_scalar(value, bounds=(low, high), method="bounded").fun if low < high else value(low))


def _fitted(films: Measurements, scene: Scene, also_free: Sequence[str], options: FitOptions) -> Fit:
    """Fit all constants of the scene's own law, with their bounds and priors among those of all laws."""
    names = [*constants_of(scene.material.law), *also_free]
    leaves = {name.rpartition(".")[2] for name in names}
    bounds = {name: one for name, one in (options.get("bounds") or {}).items() if name.rpartition(".")[2] in leaves}
    priors = {name: one for name, one in (options.get("priors") or {}).items() if name.rpartition(".")[2] in leaves}
    own: FitOptions = {**options, "bounds": bounds, "priors": priors}
    # Films without corrections: a fit makes and notes its own.
    return fit(films, scene, names, **own)


def fit_law(
    measurements: Films, scene: Scene, law: str, *, also_free: Sequence[str] = (), **options: Unpack[FitOptions]
) -> Fit:
    """Fit every constant of one law, which may differ from the scene's; the arguments are those of :func:`fit_laws`."""
    _refuse([law], also_free, options, fewest=1)
    read = measurements if isinstance(measurements, Measurements) else read_measurements(measurements)
    return _fitted(read, scene_of_law(scene, law, checked(read, scene)), also_free, options)


def fit_laws(
    measurements: Films,
    scene: Scene,
    laws: Sequence[str],
    *,
    also_free: Sequence[str] = (),
    **options: Unpack[FitOptions],
) -> LawComparison:
    """Fit every constant of several laws, and compare them by :data:`softcat_sym.fitting.criterion.CRITERION`.

    Parameters
    ----------
    measurements : Measurements, path or sequence of paths
        As for :func:`softcat_sym.fitting.fit`.
    scene : Scene
        The filament; the constants of its material are starting values of every law that has them.
    laws : sequence of str
        Two or more of :data:`FITTED`.
    also_free : sequence of str
        Further free parameters, such as ``["time_offset"]``.
    **options
        As for :func:`softcat_sym.fitting.fit`; each law takes bounds and priors of its own constants, and the time
        limit.
        With ``profiles``, by default not, the law that ranks first is fitted again, with profile likelihoods.

    Raises
    ------
    SoftcatError
        If a law is unknown or named twice, or none can be fitted.
    """
    _refuse(laws, also_free, options)
    read = measurements if isinstance(measurements, Measurements) else read_measurements(measurements)
    seen, progress = checked(read, scene), options.get("progress")
    for law in laws:
        # A fit that refuses a prior is a law that cannot be fitted; this refuses the prior before any is.
        own = {one.name: one for one in candidates(scene_of_law(scene, law, seen)) if not one.trouble}
        priors = {name: text for name, text in (options.get("priors") or {}).items() if name in own}
        read_priors(priors, [own[name] for name in priors])
    quick: FitOptions = {**options, "profiles": False, "progress": None}
    fits: dict[str, Fit] = {}
    failures: dict[str, str] = {}
    for number, law in enumerate(laws):
        if progress is not None:
            progress.stage(law)
            progress.reach(number / len(laws), f"{number + 1} of {len(laws)}")
        try:
            fits[law] = _fitted(read, scene_of_law(scene, law, seen), also_free, quick)
        except SoftcatError as error:
            failures[law] = str(error)
    found = compared(laws, fits, failures, len(also_free))
    if not options.get("profiles"):
        return found
    # The best law is fitted again with profiles, from the scene of its best fit.
    name = found.choice.table[0].law.name
    best = _fitted(read, found.best.scene, also_free, {**options, "profiles": True})
    return replace(found, fits={**found.fits, name: best})


def _refuse(laws: Sequence[str], also_free: Sequence[str], options: FitOptions, fewest: int = 2) -> None:
    faults = [
        Fault(f"law {law}", f"cannot be fitted{did_you_mean(law, FITTED)}", ", ".join(FITTED))
        for law in laws
        if law not in FITTED
    ]
    if len(set(laws)) < len(laws):
        faults.append(Fault("laws", "one is named twice", "each once"))
    if len(laws) < fewest:
        faults.append(Fault("laws", "nothing to compare", "two laws or more"))
    if not faults:
        constants = {name for law in laws for name in constants_of(law)}
        own = [name for name in also_free if name.rpartition(".")[2] in constants]
        accepted = "names that are not constants of a law, such as time_offset or density"
        faults += [Fault(f"free {name}", "a constant of a law is free without being named", accepted) for name in own]
        known = {*constants, *(name.rpartition(".")[2] for name in also_free)}
        named = {"bounds": options.get("bounds") or {}, "prior": options.get("priors") or {}}
        faults += [
            Fault(f"{what} of {name}", "not free in any law", ", ".join(sorted(known)))
            for what, names in named.items()
            for name in names
            if name.rpartition(".")[2] not in known
        ]
    if faults:
        raise SceneError(faults)
