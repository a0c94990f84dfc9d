"""A fit, or a comparison of laws, in words and rounded numbers, as JSON and CSV."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.plotting.units import LENGTHS, STRESSES, Unit, length_unit, significant, time_unit

if TYPE_CHECKING:
    from softcat_sym.fitting.features import Reading
    from softcat_sym.fitting.fit import Fit, FittedFilm, FittedParameter
    from softcat_sym.fitting.identifiability import Statistic
    from softcat_sym.fitting.inference import Profile
    from softcat_sym.fitting.least_squares import Fall
    from softcat_sym.fitting.model_selection import LawComparison, Ranked

from softcat_sym.plotting.files import csv_bytes, json_bytes

NONE = "–"
SMALL = 0.01
"""p-value from which on a test is worth a warning."""


def rounded(value: float, error: float | None) -> str:
    """Write a number to the second significant digit of its error; with three of its own without one."""
    if error is None or not 0 < error < math.inf or not math.isfinite(value):
        return significant(value)
    places = 1 - math.floor(math.log10(float(f"{error:.1e}")))
    # Never more than a double holds, never less than one digit.
    exponent = math.floor(math.log10(abs(value))) if value else 0
    if -4 <= exponent < 6:
        text = f"{round(value, places):.{min(max(places, 0), 15)}f}"
    else:
        text = (
            f"{value:.{min(max(places + exponent, 0), 15)}e}".replace("e+0", "e").replace("e-0", "e-").replace("+", "")
        )
    return text.replace("-", "\N{MINUS SIGN}", 1) if text.startswith("-") else text


def display_unit(symbol: str, largest: float) -> Unit:
    """Choose a prefix for values up to `largest` [SI] of a parameter with this SI unit; most units have none."""
    families: dict[str, tuple[Unit, ...]] = {
        "Pa": STRESSES,
        "m": LENGTHS,
        "s": (Unit("µs", 1e-6), Unit("ms", 1e-3), Unit("s", 1.0)),
        "Pa*s": tuple(Unit(f"{unit.symbol}·s", unit.size) for unit in STRESSES),
    }
    units = families.get(symbol, (Unit(symbol, 1.0),))
    reached = [unit for unit in units if abs(largest) >= unit.size * (1 - 1e-9)]
    return reached[-1] if reached else units[0]


def parameter_texts(one: FittedParameter) -> tuple[str, str, str, str, str]:
    """Name with unit, value with standard error, 95 % interval, verdict, the scene's value; no number for no knowledge.

    A value on a bound is marked as such.
    """
    # A time offset of zero is told in the unit of its error.
    unit = display_unit(one.unit, max(abs(one.best), one.std or 0.0))
    name = one.name if one.unit == "1" else f"{one.name} [{unit.symbol}]"
    return name, _words_value(one, unit), interval_text(one, unit), one.verdict, significant(one.typical / unit.size)


def _words_value(one: FittedParameter, unit: Unit) -> str:
    if one.value is None:
        return NONE
    value = one.value / unit.size
    if one.verdict == "at a bound":
        return f"{significant(value)} (bound)"
    return significant(value) if one.std is None else with_error(value, one.std / unit.size)


def with_error(value: float, error: float) -> str:
    """Write a number and its standard error to the same digit."""
    return f"{rounded(value, error)} ± {rounded(error, error)}"


def interval_text(one: FittedParameter, unit: Unit) -> str:
    """Write the 95 % interval in a unit: from one number to another, with one end, or none."""
    low, high = (None if end is None else end / unit.size for end in one.ci95)
    if high is None:
        return NONE if low is None else f"> {significant(low)}"
    if low is None:
        return f"< {significant(high)}"
    # Where the ends are powers of ten apart, each has its own digits.
    if low > 0 and high > 10 * low:
        return f"{significant(low)} to {significant(high)}"
    error = 0.25 * (high - low) if one.std is None else one.std / unit.size
    return f"{rounded(low, error)} to {rounded(high, error)}"


def noise_text(fit: Fit) -> str:
    """How large the scatter of a reading is, and how that is known."""
    amount = length_unit(fit.noise).text(fit.noise)
    return f"{amount} a reading, {'as stated' if fit.noise_known else 'estimated from the residuals'}"


def residuals_text(fit: Fit) -> str:
    """Whether the residuals are white, by which tests."""
    checks = fit.checks
    tests = ", ".join(f"{one.name} p {probability(one.p_value)}" for one in checks.tests)
    return f"{checks.verdict} ({tests})" if tests else f"{checks.verdict}: fewer than 20 in a row, or none that differ"


def probability(p: float) -> str:
    """Write what p is, with two digits; a tiny one is tiny."""
    return "< 1e-6" if p < 1e-6 else f"= {p:.2g}"


def starts_text(fit: Fit) -> str:
    """How many starts reached the best fit."""
    falls = len(fit.starts.falls)
    text = f"{fit.starts.reached_best} of {falls} reached the best fit"
    return f"{text}; at {fit.starts.rejected} more the model has no answer" if fit.starts.rejected else text


def warnings(fit: Fit) -> list[str]:
    """What a reader has to know before using the numbers, besides the outcome."""
    found = []
    size = fit.checks.size
    if size is not None and size.p_value < SMALL:
        found.append(
            f"the residuals are larger than the stated errors (chi-square {size.value:.0f} for {_points(fit)} "
            f"readings, p {probability(size.p_value)}): the intervals are too narrow"
        )
    if fit.starts.reached_best == 1 and len(fit.starts.falls) > 2:
        found.append("only one start reached the best fit: there may be a better one, ask for more starts")
    for one in fit.profiles:
        if one.unconverged:
            found.append(f"profile of {one.name}: {one.unconverged} of {one.q.size} points are uncertain")
        if one.better is not None:
            found.append(f"profile of {one.name}: it met a still better optimum; start nearer to it")
    return found


def corrections(fit: Fit) -> list[str]:
    """What was corrected in the measurements, film by film where there are several."""
    several = len(fit.films) > 1
    pairs = zip(fit.films, fit.measurements.series, strict=True)
    return [f"{film.name}: {note}" if several else note for film, series in pairs for note in series.notes]


def feature_texts(film: FittedFilm) -> list[tuple[str, str]]:
    """What a film shows without a model: name and value, or the reason why it cannot be read."""
    features = film.features
    if features is None:
        return [("features", "none: the film is too short, or gravity is not steady (load.shake)")]
    clock, ruler = time_unit(float(film.time[-1])), length_unit(float(abs(film.measured).max()))
    plain = Unit("", 1.0)
    units = (clock, clock, Unit("rad/s", 1.0), Unit("1/s", 1.0), ruler, plain)
    rows = zip(FEATURES.items(), units, strict=True)
    return [(words, _reading(getattr(features, name), unit)) for (name, words), unit in rows]


FEATURES = {
    "t_low": "end of free fall t_low",
    "t_high": "start of the 1/3 law t_high",
    "frequency": "frequency R",
    "decay": "decay rate d",
    "sag": "sag H while it rings",
    "prefactor": "prefactor B of the 1/3 law",
}
"""Attributes of the features, and what they are called."""


def _reading(one: Reading, unit: Unit) -> str:
    if one.value is None or one.error is None:
        return f"not read: {one.reason}"
    return f"{with_error(one.value / unit.size, one.error / unit.size)} {unit.symbol}".rstrip()


def _points(fit: Fit) -> int:
    return sum(film.time.size for film in fit.films)


# Of the readings' names in fit.json: SI units; B has none.
_FEATURE_UNITS = {"t_low": "s", "t_high": "s", "frequency": "rad_s", "decay": "1_s", "sag": "m", "prefactor": ""}


def fit_document(fit: Fit) -> dict[str, Any]:
    """Everything of a fit that a program may want, as JSON takes it: plain SI, null for what is not a number."""
    checks = fit.checks
    return {
        "outcome": fit.outcome.word,
        "advice": fit.outcome.value,
        "parameters": {name: parameter_document(one) for name, one in fit.parameters.items()},
        "correlation": fit.correlation.tolist(),
        "combinations": list(fit.combinations),
        "noise_m": fit.noise,
        "noise_known": fit.noise_known,
        "residuals": {
            "verdict": checks.verdict,
            "tests": [_statistic(one) for one in checks.tests],
            "autocorrelation": checks.autocorrelation,
            "chi_square": None if checks.size is None else _statistic(checks.size),
        },
        "features": [{"film": film.name, **_words_features(film)} for film in fit.films],
        "films": [
            {"name": film.name, "path": None if series.path is None else str(series.path), "readings": film.time.size}
            for film, series in zip(fit.films, fit.measurements.series, strict=True)
        ],
        "starts": _starts(fit),
        "profiles": {one.name: _profile(one, fit) for one in fit.profiles},
        "effects": list(fit.effects),
        "backend": fit.backend,
        "notes": corrections(fit),
        "warnings": warnings(fit),
        "repeats": list(fit.repeats),
        "seconds": fit.seconds,
        "evaluations": sum(one.optimum.evaluations for one in fit.starts.falls),
    }


def fit_json(fit: Fit, more: Mapping[str, Any] | None = None) -> bytes:
    """Write the document, with further entries behind its own."""
    return json_bytes({**fit_document(fit), **(more or {})}, is_ascii=False)


def fit_csv(fit: Fit) -> bytes:
    """Tabulate data and model [m] and their difference over the noise, film by film; numbers read back exactly."""
    shapes = not all(film.of_midpoint.all() for film in fit.films)
    rows: list[tuple[object, ...]] = []
    for film in fit.films:
        # An empty place is that of the midpoint.
        columns = (film.time, *([film.place] if shapes else []), film.measured, film.model, film.residuals)
        rows += [(*row, film.name) for row in zip(*(column.tolist() for column in columns), strict=True)]
    return csv_bytes(("time_s", *(["x_m"] if shapes else []), "measured_m", "model_m", "residual", "film"), rows)


def parameter_document(one: FittedParameter) -> dict[str, Any]:
    """One parameter with its interval and verdict, in SI."""
    return {
        "value": one.value,
        "std": one.std,
        "ci95": list(one.ci95),
        "verdict": one.verdict,
        "reason": one.reason,
        "unit": one.unit,
        "best": one.best,
        "typical": one.typical,
        "bounds": list(one.bounds),
    }


def _statistic(one: Statistic) -> dict[str, Any]:
    return {"name": one.name, "value": one.value, "p_value": one.p_value}


def _words_features(film: FittedFilm) -> dict[str, Any]:
    if film.features is None:
        return {}
    found = {}
    for name in FEATURES:
        one = getattr(film.features, name)
        unit = _FEATURE_UNITS[name]
        key = f"{name}_{unit}" if unit else name
        found[key] = {"value": one.value, "std": one.error, "reason": one.reason}
    return found


def _starts(fit: Fit) -> dict[str, Any]:
    free = fit.problem.free

    def values(q: list[float]) -> dict[str, float]:
        return {one.name: one.value(x) for one, x in zip(free, q, strict=True)}

    def told(one: Fall) -> dict[str, Any]:
        ended = one.optimum
        return {
            "start": values(one.start.tolist()),
            "end": values(ended.q.tolist()),
            "value": ended.value,
            "cluster": one.cluster,
            "converged": ended.converged,
            "status": ended.status,
            "iterations": ended.iterations,
            "evaluations": ended.evaluations,
        }

    return {
        "count": len(fit.starts.falls),
        "reached_best": fit.starts.reached_best,
        "no_answer": fit.starts.rejected,
        "falls": [told(one) for one in fit.starts.falls],
    }


def _profile(one: Profile, fit: Fit) -> dict[str, Any]:
    free = next(free for free in fit.problem.free if free.name == one.name)
    return {
        "value": [free.value(q) for q in one.q.tolist()],
        "increase": one.increase.tolist(),
        "threshold": one.threshold,
        "ends": {"lower": one.lower.flag, "upper": one.upper.flag},
        "held_back": {"lower": list(one.lower.held_back), "upper": list(one.upper.held_back)},
    }


LAW_HEADINGS = ("law", "constants", "AICc", "BIC", "above the best", "weight", "residuals", "rms")
"""Of the columns of :func:`law_texts`."""


def law_texts(found: LawComparison, row: Ranked) -> tuple[str, ...]:
    """One row of the table in words; a law that could not be fitted has no numbers."""
    law = row.law
    if law.failure:
        return (law.name, str(law.unknowns), NONE, NONE, NONE, NONE, "no fit", NONE)
    one = found.fits[law.name]
    spread = residual_std(one)
    numbers = (_number(row.aicc), _number(row.bic), _number(row.difference), f"{row.weight:.2f}")
    return (law.name, str(law.unknowns), *numbers, one.checks.verdict, length_unit(spread).text(spread))


def law_remarks(found: LawComparison) -> list[str]:
    """What to know beside the table: values of every law, failures, restarts."""
    said = [f"{row.law.name}: {values}" for row in found.choice.table if (values := _values(found, row))]
    said += [f"{law} was started again from the optimum of {other}" for law, other in found.restarted.items()]
    said += [f"no fit of {law}: {reason}" for law, reason in found.failures.items()]
    return said


def laws_document(found: LawComparison) -> dict[str, Any]:
    """What a program may want of the comparison, in SI; infinite where there are too few readings, or no fit."""
    return {
        "verdict": found.choice.verdict,
        "sentence": found.sentence,
        "criterion": found.choice.criterion,
        "close": list(found.choice.close),
        "restarted": dict(found.restarted),
        "table": [_entry(found, row) for row in found.choice.table],
    }


def laws_csv(found: LawComparison) -> bytes:
    """Tabulate the ranking, the best law first; places of what is not known are empty."""
    columns = ("law", "constants", "squares", "aic", "aicc", "bic", "difference", "weight", "residual_std_m")
    words = ("residuals", "outcome", "failure")
    rows = []
    for rank, row in enumerate(found.choice.table, start=1):
        entry = _entry(found, row)
        rows.append((rank, *(entry[k] for k in columns), *(" ".join(str(entry[k] or "").split()) for k in words)))
    return csv_bytes(("rank", *columns, *words), rows)


def _entry(found: LawComparison, row: Ranked) -> dict[str, Any]:
    one = found.fits.get(row.law.name)
    return {
        "law": row.law.name,
        "constants": row.law.unknowns,
        "squares": None if one is None else row.law.squares,
        "aic": row.aic,
        "aicc": row.aicc,
        "bic": row.bic,
        "difference": row.difference,
        "weight": row.weight,
        "residual_std_m": None if one is None else residual_std(one),
        "residuals": None if one is None else one.checks.verdict,
        "outcome": None if one is None else one.outcome.word,
        "failure": row.law.failure,
        "effects": [] if one is None else list(one.effects),
        "parameters": {} if one is None else {name: parameter_document(p) for name, p in one.parameters.items()},
    }


def residual_std(one: Fit) -> float:
    """Root mean square of model less measurement over all readings [m]."""
    left = np.concatenate([film.model - film.measured for film in one.films])
    return float(np.sqrt(np.mean(left**2)))


def _values(found: LawComparison, row: Ranked) -> str:
    """The fitted values of a law in words."""
    one = found.fits.get(row.law.name)
    return "" if one is None else ", ".join(_laws_value(p) for p in one.parameters.values())


def _laws_value(one: FittedParameter) -> str:
    name, value, *_ = parameter_texts(one)
    if one.value is None:
        return f"{one.name} {one.verdict}"
    label, _, unit = name.partition(" [")
    return f"{label} {value} {unit.rstrip(']')}".rstrip()


def _number(value: float) -> str:
    if not math.isfinite(value):
        return "infinite"
    return f"{value:.1f}".replace("-", "\N{MINUS SIGN}")
