"""Texts and rounded numbers of a fit and of a comparison of laws."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from softcat_sym.fitting.result import FEATURES, Fit, FittedParameter
from softcat_sym.plotting.units import LENGTHS, STRESSES, Unit, length_unit, significant, time_unit, typeset

if TYPE_CHECKING:
    from softcat_sym.fitting.closed_form import ClosedForm, Determined
    from softcat_sym.fitting.collapse_test import GapResult
    from softcat_sym.fitting.features import Features, Floats, Reading
    from softcat_sym.fitting.model_selection import LawComparison, Ranked
    from softcat_sym.fitting.posterior import Posterior
    from softcat_sym.fitting.resolution import Moved

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


def display_unit(symbol: str, largest: float) -> Unit:
    """Choose a prefix for values up to `largest` [SI] of a parameter with this SI unit; most units have none."""
    families: dict[str, tuple[Unit, ...]] = {
        "Pa": STRESSES,
        "m": LENGTHS,
        "s": (Unit("µs", 1e-6), Unit("ms", 1e-3), Unit("s", 1.0)),
        "Pa*s": tuple(Unit(f"{unit.symbol}·s", unit.size) for unit in STRESSES),
    }
    units = families.get(symbol, (Unit(typeset(symbol), 1.0),))
    reached = [unit for unit in units if abs(largest) >= unit.size * (1 - 1e-9)]
    return reached[-1] if reached else units[0]


def parameter_texts(one: FittedParameter) -> tuple[str, str, str, str, str]:
    """Name with unit, value with standard error, 95 % interval, verdict, the scene's value.

    A parameter that is not identified has no number, and a value on a bound is marked as such. The unit suits the value
    or its error, whichever is larger.
    """
    unit = display_unit(one.unit, max(abs(one.best), one.std or 0.0))
    value = NONE
    if one.value is not None:
        own = one.value / unit.size
        value = significant(own) if one.std is None else with_error(own, one.std / unit.size)
        value = f"{significant(own)} (bound)" if one.verdict == "at a bound" else value
    name = one.name if one.unit == "1" else f"{one.name} [{unit.symbol}]"
    return name, value, _interval(one, unit), one.verdict, significant(one.typical / unit.size)


def _interval(one: FittedParameter, unit: Unit) -> str:
    """The 95 % interval: from one number to another, with one end, or none."""
    low, high = (None if end is None else end / unit.size for end in one.ci95)
    if high is None:
        return NONE if low is None else f"> {significant(low)}"
    if low is None:
        return f"< {significant(high)}"
    # Ends that differ by more than a factor of ten are rounded separately.
    if low > 0 and high > 10 * low:
        return f"{significant(low)} to {significant(high)}"
    error = 0.25 * (high - low) if one.std is None else one.std / unit.size
    return f"{rounded(low, error)} to {rounded(high, error)}"


def noise_text(fit: Fit) -> str:
    """Standard deviation of a reading, and whether it is stated or estimated."""
    amount = length_unit(fit.noise).text(fit.noise)
    return f"{amount} a reading, {'as stated' if fit.noise_known else 'estimated from the residuals'}"


def residuals_text(fit: Fit) -> str:
    """Whether the residuals are white, by which tests."""
    tests = ", ".join(f"{one.name} p = {one.p_value:.2g}" for one in fit.checks.tests)
    return f"{fit.checks.verdict} ({tests or 'fewer than 20 consecutive ones, or all zero'})"


def starts_text(fit: Fit) -> str:
    """Number of starts that reached the best fit."""
    text = f"{fit.starts.reached_best} of {len(fit.starts.results)} reached the best fit"
    return f"{text}; at {fit.starts.rejected} more the model has no answer" if fit.starts.rejected else text


def camera_text(name: str, one: tuple[float, float, float]) -> str:
    """Fitted value of a camera's parameter, and its prior standard deviation."""
    value, error, known = one
    unit = next((unit for key, unit in (("sag", "m"), ("time", "s"), ("tilt", "rad")) if key in name), "")
    return f"{with_error(value, error)} {unit}".rstrip() + f" (known to {significant(known)})"


def resolution_text(moved: Moved) -> str:
    """Cells, fibres and tolerance, and the shift of the parameters by them."""
    at, share = moved.at, moved.shares.total
    fibres = f", {at.fibres} fibres" if at.fibres else ""
    return f"{at.cells} cells{fibres}, tolerance {at.rtol:.1g}: moves the parameters by {share:.2g} standard errors"


def basis(fit: Fit) -> list[tuple[str, str]]:
    """Diagnostics of a fit: headings and texts."""
    return [
        ("noise", noise_text(fit)),
        ("residuals", residuals_text(fit)),
        ("starts", starts_text(fit)),
        *((name, camera_text(name, one)) for name, one in fit.camera.items()),
        ("theory", f"may be wrong by {fit.theory:.2g} of the height" if fit.theory else "assumed to be exact"),
        *(("resolution", resolution_text(one)) for one in (fit.resolution,) if one is not None),
        *(("corrected", text) for text in fit.notes),
        *(("repeated", text) for text in fit.repeats),
        ("effects", ", ".join(fit.effects)),
        ("solver", fit.backend),
        ("effort", f"{fit.seconds:.2g} s; {fit.evaluations} evaluations from all starts"),
    ]


def posterior_texts(posterior: Posterior) -> list[tuple[str, str]]:
    """Outcome of a posterior, and the 95 % interval of every parameter between its quantiles."""
    rows = [("posterior", f"{posterior.outcome.word}: {posterior.outcome.value}; {posterior.message}")]
    for prior in posterior.priors:
        one = posterior.parameters[prior.free.name]
        unit = display_unit(prior.free.unit, abs(one["median"]))
        low, middle, high = (
            significant(value / unit.size) for value in (one["eti95"][0], one["median"], one["eti95"][1])
        )
        sign = "" if unit.symbol == "1" else f" {unit.symbol}"
        drawn = f"95 % of the draws {low} to {high}, {posterior.verdict(prior.free)}"
        rows.append((prior.free.name, f"{middle}{sign}, {drawn}; prior {prior.text}"))
    return rows


def feature_texts(
    time: Floats, heights: Floats, features: Features | None, closed: ClosedForm | None
) -> list[tuple[str, str]]:
    """Features of a film, read without a model, and constants by the closed form: name and value, or why not."""
    if features is None:
        return [("features", "none: the film is too short, or gravity is not steady (load.shake)")]
    clock, ruler = time_unit(float(time[-1])), length_unit(float(abs(heights).max()))
    units = (clock, clock, Unit("rad/s", 1.0), Unit("s⁻¹", 1.0), ruler, Unit("", 1.0))
    rows = zip(FEATURES.items(), units, strict=True)
    found = [(words, reading_text(getattr(features, name), unit)) for (name, (words, _)), unit in rows]
    pairs = [] if closed is None else [("E", closed.youngs_modulus, "Pa"), ("eta", closed.viscosity, "Pa*s")]
    return found + [(f"{name} by the closed form", determined_text(one, unit)) for name, one, unit in pairs]


def determined_text(one: Determined, symbol: str) -> str:
    """A constant by the closed form with its 95 % interval, or why it is not known."""
    if one.value is None or one.interval is None or one.log_error is None:
        return f"not known: {one.reason}"
    unit = display_unit(symbol, one.value)
    value, low, high = (
        rounded(x / unit.size, one.value * one.log_error / unit.size) for x in (one.value, *one.interval)
    )
    return f"{value} {unit.symbol} ({low} to {high})"


def reading_text(one: Reading, unit: Unit) -> str:
    """One feature with its error, or why it was not read."""
    if one.value is None or one.error is None:
        return f"not read: {one.reason}"
    return f"{with_error(one.value / unit.size, one.error / unit.size)} {unit.symbol}".rstrip()


GAP_HEADINGS = ("gap", "sag", "drop", "collapsed", "remaining", "steepest", "closed formula", "over the fit")
"""Headings of the columns of :func:`gap_texts`."""


def gap_texts(one: GapResult) -> tuple[str, ...]:
    """Row of the table of a collapse test: one gap, its collapse factor in both senses, and the closed formula."""
    lengths = [length_unit(abs(value)).text(value) if value else "0" for value in (one.span, one.sag, one.drop)]
    shares = [NONE if share is None else f"{100 * share:.3g} %" for share in (one.collapsed, one.remaining)]
    stress = NONE if one.closed_form is None else display_unit("Pa", one.closed_form).text(one.closed_form)
    ratio = NONE if one.ratio is None else significant(one.ratio)
    return (*lengths, *shares, f"{math.degrees(one.angle):.3g}°", stress, ratio)


LAW_HEADINGS = ("law", "constants", "criterion", "BIC", "above the best", "weight", "residuals", "rms")
"""Headings of the columns of :func:`law_texts`."""


def law_texts(found: LawComparison, row: Ranked) -> tuple[str, ...]:
    """One row of the table in words; a law that could not be fitted has no numbers."""
    law = row.law
    if law.failure:
        return (law.name, str(law.unknowns), NONE, NONE, NONE, NONE, "no fit", NONE)
    one = found.fits[law.name]
    values = (row.criterion, row.bic, row.difference)
    texts = [f"{value:.1f}" if math.isfinite(value) else "infinite" for value in values]
    numbers = (*(text.replace("-", "\N{MINUS SIGN}") for text in texts), f"{row.weight:.2f}")
    rms = length_unit(one.residual_std).text(one.residual_std)
    return (law.name, str(law.unknowns), *numbers, one.checks.verdict, rms)


def law_remarks(found: LawComparison) -> list[str]:
    """Remarks below the table: values of every law, restarts, failures."""
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
    remarks += [f"{law} was started again from the optimum of {other}" for law, other in found.restarted.items()]
    return remarks + [f"no fit of {law}: {reason}" for law, reason in found.failures.items()]
