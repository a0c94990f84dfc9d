"""Several laws beside the same films, in words, for programs and as a table."""

from __future__ import annotations

import csv
import io
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.plotting.fit_words import NONE, parameter_document, parameter_texts
from softcat_sym.plotting.style import length_unit

if TYPE_CHECKING:
    from softcat_sym.fitting.fit import Fit, FittedParameter
    from softcat_sym.fitting.model_selection import LawComparison, Ranked

HEADINGS = ("law", "constants", "AICc", "BIC", "above the best", "weight", "residuals", "rms")
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


def remarks(found: LawComparison) -> list[str]:
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
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    columns = ("law", "constants", "squares", "aic", "aicc", "bic", "difference", "weight", "residual_std_m")
    words = ("residuals", "outcome", "failure")
    writer.writerow(("rank", *columns, *words))
    for rank, row in enumerate(found.choice.table, start=1):
        entry = _entry(found, row)
        numbers = [_written(entry[name]) for name in columns]
        writer.writerow((rank, *numbers, *(" ".join(str(entry[name] or "").split()) for name in words)))
    return text.getvalue().encode()


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
    return "" if one is None else ", ".join(_value(p) for p in one.parameters.values())


def _value(one: FittedParameter) -> str:
    name, value, *_ = parameter_texts(one)
    if one.value is None:
        return f"{one.name} {one.verdict}"
    label, _, unit = name.partition(" [")
    return f"{label} {value} {unit.rstrip(']')}".rstrip()


def _number(value: float) -> str:
    if not math.isfinite(value):
        return "infinite"
    return f"{value:.1f}".replace("-", "\N{MINUS SIGN}")


def _written(value: Any) -> str:
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    return value if isinstance(value, str) else repr(value)
