"""Texts and rounded numbers of a fit and of a comparison of laws."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from softcat_sym.drawing import TextTable
from softcat_sym.fitting.result import FEATURES, Fit, FittedFilm, FittedParameter
from softcat_sym.plotting.units import LENGTHS, STRESSES, Unit, length_unit, significant, time_unit, typeset

if TYPE_CHECKING:
    from softcat_sym.fitting.closed_form import ClosedForm, Determined
    from softcat_sym.fitting.collapse_test import CollapseTest
    from softcat_sym.fitting.features import Features, Floats, Reading
    from softcat_sym.fitting.model_selection import LawComparison, Ranked
    from softcat_sym.fitting.posterior import Posterior

Rows = list[tuple[str, str]]

NONE = "–"


def rounded(value: float, error: float | None) -> str:
    """Write a number to the second significant digit of its error; without an error, with three digits."""
    if error is None or not 0 < error < math.inf or not math.isfinite(value):
        return significant(value)
    places = 1 - math.floor(math.log10(float(f"{error:.1e}")))
    # Never more than a double holds, never less than one digit.
    exponent = math.floor(math.log10(abs(value))) if value else 0
    if -4 <= exponent < 6:
        text = f"{round(value, places):.{min(max(places, 0), 15)}f}"
    else:
        text = f"{value:.{min(max(places + exponent, 0), 15)}e}"
        text = text.replace("e+0", "e").replace("e-0", "e-").replace("+", "")
    return text.replace("-", "\N{MINUS SIGN}", 1) if text.startswith("-") else text


def with_error(value: float, error: float) -> str:
    """Write a number and its standard error to the same digit."""
    return f"{rounded(value, error)} ± {rounded(error, error)}"


_UNITS: dict[str, tuple[Unit, ...]] = {
    "Pa": STRESSES,
    "m": LENGTHS,
    "s": (Unit("µs", 1e-6), Unit("ms", 1e-3), Unit("s", 1.0)),
    "Pa*s": tuple(Unit(f"{unit.symbol}·s", unit.size) for unit in STRESSES),
}


def display_unit(symbol: str, largest: float) -> Unit:
    """Choose a prefix for values up to `largest` [SI] of a parameter with this SI unit; most units have none."""
    units = _UNITS.get(symbol, (Unit(typeset(symbol), 1.0),))
    reached = [unit for unit in units if abs(largest) >= unit.size * (1 - 1e-9)]
    return reached[-1] if reached else units[0]


def parameter_texts(one: FittedParameter) -> tuple[str, str, str, str, str]:
    """Name with unit, value with standard error, 95 % interval, verdict, the scene's value.

    A parameter that is not identified has no number, and a value on a bound is marked as such. The unit suits the value
    or its error, whichever is larger.
    """
    unit = display_unit(one.unit, max(abs(one.best), one.std or 0.0))
    low, high = (None if end is None else end / unit.size for end in one.ci95)
    error = None if one.std is None else one.std / unit.size
    value = NONE
    if one.value is not None:
        own = one.value / unit.size
        value = significant(own) if error is None else with_error(own, error)
        value = f"{significant(own)} (bound)" if one.verdict == "at a bound" else value
    if high is None:
        interval = NONE if low is None else f"> {significant(low)}"
    elif low is None:
        interval = f"< {significant(high)}"
    elif low > 0 and high > 10 * low:  # Ends that differ so much are rounded separately.
        interval = f"{significant(low)} to {significant(high)}"
    else:
        error = 0.25 * (high - low) if error is None else error
        interval = f"{rounded(low, error)} to {rounded(high, error)}"
    name = one.name if one.unit == "1" else f"{one.name} [{unit.symbol}]"
    return name, value, interval, one.verdict, significant(one.typical / unit.size)


def parameter_table(fit: Fit) -> TextTable:
    """Every parameter, those that are not identified marked."""
    parameters = list(fit.parameters.values())
    kinds = ["" if one.verdict == "identified" else "yellow" for one in parameters]
    headings = ("parameter", "value ± std", "95 % interval", "verdict", "scene's")
    return TextTable(headings, [parameter_texts(one) for one in parameters], (1, 2, 4), kinds, "Parameters")


def noise_text(fit: Fit) -> str:
    """Standard deviation of a reading, and whether it is stated or estimated."""
    amount = length_unit(fit.noise).text(fit.noise)
    return f"{amount} a reading, {'as stated' if fit.noise_known else 'estimated from the residuals'}"


def starts_text(fit: Fit) -> str:
    """Number of starts that reached the best fit."""
    text = f"{fit.starts.reached_best} of {len(fit.starts.results)} reached the best fit"
    return f"{text}; at {fit.starts.rejected} more the model has no answer" if fit.starts.rejected else text


def basis(fit: Fit) -> Rows:
    """Diagnostics of a fit: headings and texts."""
    tests = ", ".join(f"{one.name} p = {one.p_value:.2g}" for one in fit.checks.tests)
    rows = [
        ("noise", noise_text(fit)),
        ("residuals", f"{fit.checks.verdict} ({tests or 'fewer than 20 consecutive ones, or all zero'})"),
        ("starts", starts_text(fit)),
    ]
    for name, (value, error, known) in fit.camera.items():
        unit = next((unit for key, unit in (("sag", "m"), ("time", "s"), ("tilt", "rad")) if key in name), "")
        rows.append((name, f"{with_error(value, error)} {unit}".rstrip() + f" (known to {significant(known)})"))
    theory = f"may be wrong by {fit.theory:.2g} of the height" if fit.theory else "assumed to be exact"
    rows.append(("theory", theory))
    if fit.resolution is not None:
        at, share = fit.resolution.at, fit.resolution.shares.total
        grid = f"{at.cells} cells{f', {at.fibres} fibres' if at.fibres else ''}, tolerance {at.rtol:.1g}"
        rows.append(("resolution", f"{grid}: moves the parameters by {share:.2g} standard errors"))
    rows += [("corrected", text) for text in fit.notes] + [("repeated", text) for text in fit.repeats]
    effort = f"{fit.seconds:.2g} s; {fit.evaluations} evaluations from all starts"
    return [*rows, ("effects", ", ".join(fit.effects)), ("solver", fit.backend), ("effort", effort)]


def posterior_texts(posterior: Posterior | None) -> Rows:
    """Outcome of a posterior, and the 95 % interval of every parameter between its quantiles."""
    if posterior is None:
        return []
    rows = [("posterior", f"{posterior.outcome.word}: {posterior.outcome.value}; {posterior.message}")]
    for prior in posterior.priors:
        one = posterior.parameters[prior.free.name]
        unit = display_unit(prior.free.unit, abs(one["median"]))
        low, high, middle = (significant(value / unit.size) for value in (*one["eti95"], one["median"]))
        sign = "" if unit.symbol == "1" else f" {unit.symbol}"
        drawn = f"95 % of the draws {low} to {high}, {posterior.verdict(prior.free)}"
        rows.append((prior.free.name, f"{middle}{sign}, {drawn}; prior {prior.text}"))
    return rows


def film_features(film: FittedFilm) -> Rows:
    """Features of one film of a fit, and constants by the closed form."""
    part = film.part(film.of_midpoint)
    return feature_texts(part.time, part.measured, film.features, film.closed)


def feature_texts(time: Floats, heights: Floats, features: Features | None, closed: ClosedForm | None) -> Rows:
    """Features of a film, read without a model, and constants by the closed form: name and value, or why not."""
    if features is None:
        return [("features", "none: the film is too short, or gravity is not steady (load.shake)")]
    clock, ruler = time_unit(float(time[-1])), length_unit(float(abs(heights).max()))
    units = (clock, Unit("rad/s", 1.0), Unit("s⁻¹", 1.0), ruler, Unit("", 1.0))

    def read(one: Reading, unit: Unit) -> str:
        if one.value is None or one.error is None:
            return f"not read: {one.reason}"
        return f"{with_error(one.value / unit.size, one.error / unit.size)} {unit.symbol}".rstrip()

    def determined(one: Determined, symbol: str) -> str:
        if one.value is None or one.interval is None or one.log_error is None:
            return f"not known: {one.reason}"
        unit = display_unit(symbol, one.value)
        error = one.value * one.log_error / unit.size
        value, low, high = (rounded(x / unit.size, error) for x in (one.value, *one.interval))
        return f"{value} {unit.symbol} ({low} to {high})"

    named = zip(FEATURES.items(), units, strict=True)
    found = [(words, read(getattr(features, name), unit)) for (name, (words, _)), unit in named]
    pairs = [] if closed is None else [("E", closed.youngs_modulus, "Pa"), ("eta", closed.viscosity, "Pa*s")]
    return found + [(f"{name} by the closed form", determined(one, unit)) for name, one, unit in pairs]


def gap_table(test: CollapseTest) -> TextTable:
    """Every gap of a collapse test: its collapse factor in both senses, and the closed formula."""
    rows = []
    for one in test.results:
        lengths = [length_unit(abs(value)).text(value) if value else "0" for value in (one.span, one.sag, one.drop)]
        shares = [NONE if share is None else f"{100 * share:.3g} %" for share in (one.collapsed, one.remaining)]
        stress = NONE if one.closed_form is None else display_unit("Pa", one.closed_form).text(one.closed_form)
        ratio = NONE if one.ratio is None else significant(one.ratio)
        rows.append((*lengths, *shares, f"{math.degrees(one.angle):.3g}°", stress, ratio))
    headings = ("gap", "sag", "drop", "collapsed", "remaining", "steepest", "closed formula", "over the fit")
    return TextTable(headings, rows, range(8), title="Collapse test: every gap")


def law_table(found: LawComparison) -> TextTable:
    """The ranking of several laws; one that could not be fitted has no numbers."""
    rows = [(row.law.name, str(row.law.unknowns), *_law_numbers(found, row)) for row in found.choice.table]
    kinds = ["" if row.law.name in found.choice.close else "dim" for row in found.choice.table]
    headings = ("law", "constants", "criterion", "BIC", "above the best", "weight", "residuals", "rms")
    return TextTable(headings, rows, (1, 2, 3, 4, 5, 7), kinds, f"Which law: {found.sentence}")


def _law_numbers(found: LawComparison, row: Ranked) -> list[str]:
    if row.law.failure:
        return [NONE, NONE, NONE, NONE, "no fit", NONE]
    one, values = found.fits[row.law.name], (row.criterion, row.bic, row.difference)
    texts = [f"{value:.1f}" if math.isfinite(value) else "infinite" for value in values]
    rms = length_unit(one.residual_std).text(one.residual_std)
    return [*(text.replace("-", "\N{MINUS SIGN}") for text in texts), f"{row.weight:.2f}", one.checks.verdict, rms]


def law_remarks(found: LawComparison) -> list[str]:
    """Remarks below the table: values of every law, failures."""
    remarks = []
    for row in found.choice.table:
        if row.law.name in found.fits:
            values = []
            for one in found.fits[row.law.name].parameters.values():
                name, value, *_ = parameter_texts(one)
                label, _, unit = name.partition(" [")
                text = f"{label} {value} {unit.rstrip(']')}".rstrip()
                values.append(f"{one.name} {one.verdict}" if one.value is None else text)
            remarks.append(f"{row.law.name}: {', '.join(values)}")
    return remarks + [f"no fit of {law}: {reason}" for law, reason in found.failures.items()]
