"""What a program may want of a fit: ``fit.json`` and ``fit.csv``."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from softcat_sym.report.fit_words import FEATURES, corrections, reading_of, warnings

if TYPE_CHECKING:
    from softcat_sym.inverse.estimation.multi_start import Fall
    from softcat_sym.inverse.estimation.profiles import Profile
    from softcat_sym.inverse.estimation.residual_checks import Statistic
    from softcat_sym.inverse.fitted import Fit, FittedFilm, FittedParameter

# Of the readings' names in fit.json: SI units; B has none.
_FEATURE_UNITS = {"t_low": "s", "t_high": "s", "frequency": "rad_s", "decay": "1_s", "sag": "m", "prefactor": ""}


def fit_document(fit: Fit) -> dict[str, Any]:
    """Everything of a fit that a program may want, as JSON takes it: plain SI, null for what is not a number.

    Parameters
    ----------
    fit : Fit
        As from :func:`softcat_sym.fit`.
    """
    checks = fit.checks
    found: dict[str, Any] = {
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
        "features": [{"film": film.name, **_features(film)} for film in fit.films],
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
    plain: dict[str, Any] = _plain(found)
    return plain


def fit_json(fit: Fit, more: Mapping[str, Any] | None = None) -> bytes:
    """Write the document, with further entries behind its own."""
    document = {**fit_document(fit), **_plain(dict(more or {}))}
    return (json.dumps(document, indent=2, allow_nan=False, ensure_ascii=False) + "\n").encode()


def fit_csv(fit: Fit) -> bytes:
    """Tabulate data and model [m] and their difference over the noise, film by film; numbers read back exactly."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    shapes = not all(film.of_midpoint.all() for film in fit.films)
    writer.writerow(("time_s", *(["x_m"] if shapes else []), "measured_m", "model_m", "residual", "film"))
    for film in fit.films:
        columns = (film.time, *([film.place] if shapes else []), film.measured, film.model, film.residuals)
        for row in zip(*(column.tolist() for column in columns), strict=True):
            # An empty place is that of the midpoint.
            writer.writerow((*("" if value != value else repr(value) for value in row), film.name))
    return text.getvalue().encode()


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


def _features(film: FittedFilm) -> dict[str, Any]:
    if film.features is None:
        return {}
    found = {}
    for name in FEATURES:
        one = reading_of(film.features, name)
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


def _plain(value: Any) -> Any:
    """Numbers that JSON does not know become null."""
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    if isinstance(value, list):
        return [_plain(one) for one in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
