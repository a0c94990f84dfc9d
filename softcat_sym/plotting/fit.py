"""A fit, or a comparison of laws, in words, as a page, on the terminal and as files."""

from __future__ import annotations

import base64
import csv
import io
import json
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from importlib import resources
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING, Any

import numpy as np
from rich import box
from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from softcat_sym.files import write_all
from softcat_sym.fitting.fit import FitOutcome
from softcat_sym.plotting.fit_figures import (
    correlation_figure,
    curves_figure,
    features_figure,
    laws_figure,
    profiles_figure,
    starts_figure,
)
from softcat_sym.plotting.style import png
from softcat_sym.plotting.units import LENGTHS, STRESSES, Unit, length_unit, significant, time_unit

if TYPE_CHECKING:
    from softcat_sym.fitting.features import Features, Reading
    from softcat_sym.fitting.fit import Fit, FittedFilm, FittedParameter
    from softcat_sym.fitting.identifiability import Statistic
    from softcat_sym.fitting.inference import Profile
    from softcat_sym.fitting.least_squares import Fall
    from softcat_sym.fitting.model_selection import LawComparison, Ranked

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
    return [(words, _reading(reading_of(features, name), unit)) for (name, words), unit in rows]


FEATURES = {
    "t_low": "end of free fall t_low",
    "t_high": "start of the 1/3 law t_high",
    "frequency": "frequency R",
    "decay": "decay rate d",
    "sag": "sag H while it rings",
    "prefactor": "prefactor B of the 1/3 law",
}
"""Attributes of the features, and what they are called."""


def reading_of(features: Features, name: str) -> Reading:
    """One of `FEATURES`."""
    return {
        "t_low": features.t_low,
        "t_high": features.t_high,
        "frequency": features.frequency,
        "decay": features.decay,
        "sag": features.sag,
        "prefactor": features.prefactor,
    }[name]


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


def _words_features(film: FittedFilm) -> dict[str, Any]:
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


def _written(value: Any) -> str:
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    return value if isinstance(value, str) else repr(value)


PAGE_HEADINGS = ("parameter", "value ± std", "95 % interval", "verdict", "scene's")
"""Of the columns of :func:`softcat_sym.plotting.fit.parameter_texts`."""


def fit_rows(fit: Fit) -> list[tuple[str, str]]:
    """Put into words what stands below the table of parameters."""
    rows = [("outcome", f"{fit.outcome.word}: {fit.outcome.value}")]
    rows += [(one.name, one.reason) for one in fit.parameters.values() if one.reason]
    rows += [("identified", text) for text in fit.combinations]
    rows += [("warning", text) for text in warnings(fit)]
    rows += [("corrected", text) for text in corrections(fit)]
    rows += [("repeated", text) for text in fit.repeats]
    rows += [("noise", noise_text(fit)), ("residuals", residuals_text(fit)), ("starts", starts_text(fit))]
    for film in fit.films:
        if len(fit.films) > 1:
            rows.append(("film", film.name))
        rows += feature_texts(film)
    return rows


def parameter_table(fit: Fit) -> Table:
    """Lay the parameters out as a table."""
    table = Table(
        title=Text(fit.scene.title or "Filament", style="bold"),
        title_justify="left",
        box=box.SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
    )
    for k, name in enumerate(PAGE_HEADINGS):
        table.add_column(Text(name), justify="left" if k in (0, 3) else "right", overflow="fold")
    for one in fit.parameters.values():
        style = "" if one.verdict == "identified" else "yellow"
        table.add_row(*(Text(text, style=style) for text in parameter_texts(one)))
    return table


def laws_table(found: LawComparison) -> Table:
    """Lay several laws out as a table, the best first, those that are out of the question dim."""
    title = Text(f"Which law: {found.sentence}", style="bold")
    table = Table(title=title, title_justify="left", box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0))
    for k, name in enumerate(LAW_HEADINGS):
        table.add_column(Text(name), justify="left" if k in (0, 6) else "right", overflow="fold")
    for row in found.choice.table:
        style = "" if row.law.name in found.choice.close else "dim"
        table.add_row(*(Text(text, style=style) for text in law_texts(found, row)))
    return table


def print_laws(found: LawComparison, console: Console | None = None) -> None:
    """Print the ranking of several laws, the verdict, and what each law's constants are."""
    screen = console or Console()
    screen.print(laws_table(found))
    for text in law_remarks(found):
        screen.print(Padding(Text(text), (0, 0, 0, 1)))
    screen.print()


def print_fit(fit: Fit, console: Console | None = None) -> None:
    """Print parameters, outcome and what they rest on."""
    screen = console or Console()
    screen.print(parameter_table(fit))
    below = Table(box=None, show_header=False, padding=(0, 1, 0, 0))
    below.add_column(style="dim", overflow="fold")
    below.add_column(overflow="fold")
    styles = {"outcome": "bold", "warning": "yellow"}
    for name, text in fit_rows(fit):
        below.add_row(Text(name), Text(text, style=styles.get(name, "")))
    screen.print(below)


_NUMBERS = (1, 2, 4)
"""Columns of the table of parameters that are numbers."""


def fit_page(
    fit: Fit, pictures: Mapping[str, tuple[str, bytes]], command: str = "", laws: LawComparison | None = None
) -> bytes:
    """Write a page that needs no other file."""
    folder = resources.files("softcat_sym.plotting") / "templates"
    template = Template((folder / "fit.html").read_text(encoding="utf-8"))
    films = ", ".join(film.name for film in fit.films)
    readings = sum(film.time.size for film in fit.films)
    outcome = fit.outcome.word
    page = template.substitute(
        title=escape(f"{fit.scene.title or 'Filament'}: fit"),
        subtitle=escape(f"{films} · {readings} readings of the midpoint"),
        doubtful="" if fit.outcome is FitOutcome.solved else " doubtful",
        outcome=escape(_capital(outcome)),
        advice=escape(f"{_capital(fit.outcome.value)}."),
        laws="" if laws is None else _laws(laws),
        parameters=_parameters(fit),
        remarks=_listed([*fit.combinations, *(f"Warning: {text}" for text in warnings(fit))]),
        basis=_rows(_basis(fit)),
        features="\n".join(_page_features(fit)),
        pictures="\n".join(_picture(name, *one) for name, one in pictures.items()),
        command=f"<h2>The same again</h2>\n<pre>{escape(command)}</pre>" if command else "",
    )
    return page.encode()


def _parameters(fit: Fit) -> str:
    marks = [' class="number"' if k in _NUMBERS else "" for k in range(len(PAGE_HEADINGS))]
    lines = ["<table>", _line("th", PAGE_HEADINGS, marks)]
    for one in fit.parameters.values():
        row = _line("td", parameter_texts(one), marks)
        lines.append(row if one.verdict == "identified" else row.replace("<tr>", '<tr class="doubtful">', 1))
    reasons = [f"{one.name}: {one.reason}" for one in fit.parameters.values() if one.reason]
    return "\n".join([*lines, "</table>", _listed(reasons)])


def _laws(found: LawComparison) -> str:
    marks = [' class="number"' if 0 < k < 6 or k == 7 else "" for k in range(len(LAW_HEADINGS))]
    lines = ["<h2>Which law</h2>", f"<p><strong>{escape(_capital(found.sentence))}.</strong></p>"]
    lines += ["<table>", _line("th", LAW_HEADINGS, marks)]
    for row in found.choice.table:
        line = _line("td", law_texts(found, row), marks)
        close = row.law.name in found.choice.close
        lines.append(line if close else line.replace("<tr>", '<tr class="doubtful">', 1))
    return "\n".join([*lines, "</table>", _listed(law_remarks(found))])


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _line(tag: str, texts: Sequence[str], marks: Sequence[str]) -> str:
    cells = (f"<{tag}{mark}>{escape(text)}</{tag}>" for text, mark in zip(texts, marks, strict=True))
    return f"<tr>{''.join(cells)}</tr>"


def _basis(fit: Fit) -> Iterable[tuple[str, str]]:
    yield "noise", noise_text(fit)
    yield "residuals", residuals_text(fit)
    yield "starts", starts_text(fit)
    yield from (("corrected", text) for text in corrections(fit))
    yield from (("repeated", text) for text in fit.repeats)
    yield "effects", ", ".join(fit.effects)
    yield "solver", fit.backend
    evaluations = sum(one.optimum.evaluations for one in fit.starts.falls)
    yield "effort", f"{fit.seconds:.2g} s; {evaluations} evaluations with derivatives from all starts"


def _page_features(fit: Fit) -> Iterable[str]:
    for film in fit.films:
        if len(fit.films) > 1:
            yield f"<h3>{escape(film.name)}</h3>"
        yield _rows(feature_texts(film))


def _rows(rows: Iterable[tuple[str, str]]) -> str:
    return "\n".join(["<table>", *(_line("td", row, ("", "")) for row in rows), "</table>"])


def _listed(texts: Sequence[str]) -> str:
    if not texts:
        return ""
    return "\n".join(["<ul>", *(f"<li>{escape(text)}</li>" for text in texts), "</ul>"])


def _picture(name: str, what: str, content: bytes) -> str:
    data = base64.b64encode(content).decode()
    return (
        f'<figure id="{escape(name.removesuffix(".png"))}"><img src="data:image/png;base64,{data}" '
        f'alt="{escape(what)}"><figcaption class="grey">{escape(what)}</figcaption></figure>'
    )


# Files that not every fit has: those of an earlier fit in the same folder would belong to no document there.
_SOMETIMES = re.compile(r"(features(_\d+)?|profiles|correlation|laws)\.png|laws\.csv")


def write_fit(fit: Fit, directory: str | Path, command: str = "", laws: LawComparison | None = None) -> list[Path]:
    """Write ``fit.json``, ``scene.toml``, ``fit.csv``, the pictures and ``fit.html``, and ``laws.csv`` of several.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    pictures = fit_pictures(fit)
    more = {}
    if laws is not None:
        pictures["laws.png"] = ("what every law leaves unexplained, the best law first", png(laws_figure(laws)))
        more["laws"] = laws_document(laws)
    contents = {
        "fit.json": fit_json(fit, more),
        "scene.toml": fitted_toml(fit),
        "fit.csv": fit_csv(fit),
        **({} if laws is None else {"laws.csv": laws_csv(laws)}),
        **{name: content for name, (_, content) in pictures.items()},
        "fit.html": fit_page(fit, pictures, command, laws),
    }
    written = write_all(directory, contents)
    for path in Path(directory).iterdir():
        if _SOMETIMES.fullmatch(path.name) and path.name not in contents:
            path.unlink()
    return written


def fit_pictures(fit: Fit) -> dict[str, tuple[str, bytes]]:
    """Draw what there is to draw."""
    found = {"fit.png": ("data, model with its 95 % band, and residuals", png(curves_figure(fit)))}
    if fit.profiles:
        found["profiles.png"] = ("profile likelihoods with the 95 % threshold", png(profiles_figure(fit)))
    if len(fit.problem.free) > 1:
        found["correlation.png"] = ("joint 95 % regions and correlations", png(correlation_figure(fit)))
    found["starts.png"] = ("where every start began and ended", png(starts_figure(fit)))
    for number, film in enumerate(fit.films, start=1):
        if film.features is None:
            continue
        name = "features.png" if number == 1 else f"features_{number}.png"
        seen = film.part(film.of_midpoint)
        figure = features_figure(seen.time, seen.measured, film.features, film.name)
        found[name] = (f"features read from {film.name}", png(figure))
    return found


def fitted_toml(fit: Fit) -> bytes:
    """Write the fitted scene, with the fit's outcome and what it does not know as a comment."""
    lines = [f"# Fitted: {fit.outcome.word}."]
    lines += [f"# {one.name}: {one.verdict}; {one.reason}" for one in fit.parameters.values() if one.reason]
    return ("\n".join(lines) + "\n" + fit.fitted_scene.to_toml()).encode()
