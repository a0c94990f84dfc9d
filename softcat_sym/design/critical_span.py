"""The largest span whose sag stays below a limit, and how it moves with material, thickness and density."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from scipy.optimize import brentq

from softcat_sym import store
from softcat_sym.design.information import (
    DURATION,
    FRAME_RATE,
    SPAN,
    THICKNESS,
    ReadingNoise,
    Trial,
    read_positive,
    read_share,
)
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.estimates.span import (
    CLEAR,
    FACTOR,
    Limit,
    crossings,
    foreseen_log_span,
    steps_to_limit,
    with_span,
)
from softcat_sym.fitting.free_parameters import FreeParameter, candidates, free_parameters, with_values
from softcat_sym.fitting.identifiability import is_identified, two_sided_quantile
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.results.breaking import breakable
from softcat_sym.scene.reading import as_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import NotAQuantity, length_text, shown
from softcat_sym.simulate import identity_of, recalled, simulated, without_estimate
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Progress, Silence

if TYPE_CHECKING:
    from softcat_sym.scene.reading import Changes, SceneLike


_STEP = 0.05
"""Of the logarithms of span and constants, from which exponents are found."""


@dataclass(frozen=True)
class Sag:
    """A finished run."""

    value: float  # Largest distance of the midpoint from the supports' level [m]; infinite without an answer
    effects: tuple[str, ...]  # In force
    note: str  # Why there is no answer; empty if there is


_SAG = store.json_form(asdict, lambda found: Sag(found["value"], tuple(found["effects"]), found["note"]))


def sag_of_run(scene: Scene) -> Sag:
    """Run a filament as the program chooses to, and measure its sag."""

    def measured() -> Sag:
        run = simulated(without_estimate(scene))
        names, midpoint = tuple(run.summary["effects"]), run.fields["midpoint"]
        if not run.outcome.is_success:
            return Sag(np.inf, names, run.outcome.name)
        return Sag(_largest(np.abs(midpoint)), names, "")

    return store.stored(store.key_of("sag", identity_of(scene)), measured, _SAG)


def _sag_at(scene: Scene, span: float) -> Sag:
    """The sag of another span [m], without an answer where the scene cannot have it."""
    try:
        return sag_of_run(with_span(scene, span))
    except SceneError as error:
        return Sag(math.inf, (), "; ".join(map(str, error.faults)))


def exponents_of(scene: Scene, limit: Limit, effects: tuple[str, ...], paths: Sequence[str]) -> dict[str, float]:
    """D log span/d log parameter where the sag reaches the limit, with the same effects; empty where it has no slope.

    By implicit differentiation, -(d log sag/d log parameter) over the slope of the excess, in central differences of
    whole runs: far enough apart that fibres which yield one after the other do not show.
    """
    frozen = scene.replace({"run.effects": list(effects)})

    def slope(one: FreeParameter) -> float:
        low, high = (sag_of_run(with_values(frozen, [one], [one.value(step)])).value for step in (-_STEP, _STEP))
        return math.log(high / low) / (2 * _STEP) if math.isfinite(low) and math.isfinite(high) else math.nan

    by_span, *by_parameter = map(slope, free_parameters(frozen, [SPAN, *paths]))
    slope_of_limit = limit.slope(by_span)
    if not slope_of_limit > 0 or not all(map(math.isfinite, by_parameter)):
        return {}
    return {path: round(-value / slope_of_limit, 4) + 0.0 for path, value in zip(paths, by_parameter, strict=True)}


def _largest(depth: Floats) -> float:
    """Largest of depths at even times, by the parabola about it."""
    k = int(np.argmax(depth))
    if not 0 < k < len(depth) - 1:
        return float(depth[k])
    before, here, after = depth[k - 1 : k + 2]
    curvature = before - 2 * here + after
    return float(here - (before - after) ** 2 / (8 * curvature) if curvature < 0 else here)


LIMITS = 'a positive length such as "2 mm", or a fraction of the span such as "5 %"'
"""Limits of the sag that are accepted."""


def read_limit(value: object) -> Limit:
    """Read a length with its unit, or a fraction of the span: a number, or text such as ``"5 %"``."""
    share = read_share(value)
    if share is not None:
        return Limit(share, of_span=True)
    return Limit(read_positive(value, "length", "m"), of_span=isinstance(value, (int, float, Real)))


_CALLED = {SPAN: "span", THICKNESS: "thickness", FRAME_RATE: "frame rate", DURATION: "duration"}
_WORTH = 1.05


def percent(error: float) -> str:
    """A relative standard error for reading, and whether it identifies a parameter, as a fit would say."""
    if not math.isfinite(error):
        return "not determined"
    half = two_sided_quantile(None) * error
    return f"{100 * error:.2g} %" + ("" if is_identified(-half, half) else " (poorly determined)")


def sentences(
    best: Trial,
    given: Trial,
    at_bounds: Mapping[str, str],
    noise: ReadingNoise,
    counted: tuple[str, ...],
    max_sag: Limit | None,
) -> tuple[str, ...]:
    """Say what to film, what it will tell, what the scene as given would, and which bounds bind."""
    film = (
        f"Film a span of {length_text(best.span)}, {length_text(best.thickness)} thick, for {best.duration:.3g} s at "
        f"{best.frame_rate:.4g} frames a second: {best.frames} frames."
    )
    listed = ", ".join(f"{name.rpartition('.')[2]} {percent(best.errors[name])}" for name in counted)
    amount = length_text(noise.of(best.sag)) + (f" ({100 * noise.value:.3g} % of the sag)" if noise.of_sag else "")
    found = [film, f"Relative standard errors to expect with {amount} of noise a reading: {listed}."]
    allowed = math.inf if max_sag is None else max_sag.at(best.span)
    limited = "" if math.isinf(allowed) else f", of {length_text(allowed)} that are allowed"
    found.append(f"It sags {length_text(best.sag)} while it is filmed{limited}.")
    found.append(_compared(best, given))
    if given.sag > allowed:
        found.append(f"The scene as given sags {length_text(given.sag)}, which is more than allowed.")
    bound = [f"{_CALLED[path]} at its {edge} bound" for path, edge in at_bounds.items() if path in _CALLED]
    if "max_frames" in at_bounds:
        bound.append("as many frames as the camera keeps")
    if bound:
        found.append(f"What limits it: {', '.join(bound)}.")
    found.append("These are the least errors that any fit can have, if the law is right and the noise is white.")
    return tuple(found)


def _compared(best: Trial, given: Trial) -> str:
    if not math.isfinite(given.worst):
        why = f" ({given.note})" if given.note else ""
        return f"The scene as given would not determine them all{why}."
    gain = given.worst / best.worst
    same = f"{percent(given.worst)} at worst, with {given.frames} frames"
    if gain < _WORTH:
        return f"The scene as given is as good: {same}."
    return f"The scene as given would leave {same}: {gain:.3g} times more."


_COARSE, _FINE = 2e-3, 2e-4  # of log span
_JUMP = 1.0  # of log sag over the limit, that no continuous sag leaves within the bracket
_THICK = 1.05


@dataclass(frozen=True, eq=False)
class CriticalSpan:
    """The largest safe span."""

    span: float  # [m]; at which the sag reaches the limit
    sag: float  # There, which is the limit [m]
    gradient: Mapping[str, float]  # d log span/d log parameter, by path: an exponent. Zero for what makes no difference
    scan: tuple[tuple[float, float], ...]  # Span and sag [m]; infinite where the run has no answer
    effects: tuple[str, ...]  # In force at the critical span
    limit: Limit  # Of the sag
    breaks: bool = False  # Whether a longer one breaks before it sags so much
    error: float | None = None  # Of the span [m], by the error of the sag there; None where it was not estimated
    limited_by: str = ""  # What keeps a longer one from the limit, in words; empty where it was not sought

    def to_dict(self) -> dict[str, Any]:
        """What JSON holds of it, in SI; the gradient is of logarithms."""
        return {
            "span_m": self.span,
            "error_m": self.error,
            "sag_m": self.sag,
            "limited_by": self.limited_by,
            "gradient": dict(self.gradient),
            "effects": list(self.effects),
            "breaks": self.breaks,
            "text": list(self.text),
        }

    def to_frame(self) -> pd.DataFrame:
        """The scan [m], the critical span among it; an empty sag is no answer."""
        rows = [(span, sag, "scanned") for span, sag in self.scan] + [(self.span, self.sag, "critical")]
        return pd.DataFrame(sorted(rows), columns=["span_m", "sag_m", "what"]).replace(math.inf, math.nan)

    @property
    def text(self) -> tuple[str, ...]:
        """Plain sentences."""
        if self.error is not None:
            number, unit = length_text(self.span, 4).split()
            error = self.error / self.span * float(number)
            return (f"longest span {number} {unit} +- {error:.1g} {unit}", self.limited_by)
        if self.breaks:
            return (f"A span of {length_text(self.span)} sags {length_text(self.sag)}; a longer one breaks.",)
        strongest = sorted(self.gradient.items(), key=lambda pair: -abs(pair[1]))
        listed = ", ".join(f"{path.rpartition('.')[2]}^{power:.3g}" for path, power in strongest if abs(power) > 5e-3)
        head = f"The sag reaches {length_text(self.sag)} at a span of {length_text(self.span)}."
        return (head, f"About there the critical span goes as {listed}.")


def critical_span(
    scene: Scene,
    limit: object,
    within: tuple[object, object] | None = None,
    progress: Progress | None = None,
    *,
    exponents: bool = True,
) -> CriticalSpan:
    """Find the largest span that sags less than a limit: a length with its unit, or a fraction of the span.

    Whole runs begin at the span that the forecast gives, step until the sag has crossed the limit, and close in on it.
    Without `exponents`, which take most of the time, the span is known to 0.2 %, with them to 0.02 %.

    Spans lie `within` two, by default thirty times smaller and larger than the scene's own. SoftcatError if all spans
    sag less than the limit, or even the smallest sags more.
    """
    allowed, bounds = _read(scene, limit, within)
    runs, progress = dict[float, Sag](), progress or Silence()

    def at(x: float) -> Sag:
        if x not in runs:
            progress.doing(f"sag of a span of {length_text(math.exp(x))}")
            runs[x] = _sag_at(scene, math.exp(x))
        return runs[x]

    def left(x: float) -> float:
        # Of an infinite sag the sign is enough.
        return float(np.clip(allowed.excess(math.exp(x), at(x).value), -CLEAR, CLEAR))

    ends = math.log(bounds[0]), math.log(bounds[1])
    logs, excess = steps_to_limit(left, allowed, foreseen_log_span(scene, allowed, ends), ends)
    _refuse_without_crossing(allowed, bounds, [math.exp(x) for x in logs], [at(x) for x in logs], excess)
    first, tolerance = crossings(excess)[0], _FINE if exponents else _COARSE
    near = brentq(left, logs[first], logs[first + 1], xtol=tolerance, rtol=tolerance)
    margin = 2 * tolerance * (1 + abs(near))  # What the root finder leaves open
    span, sag, effects, gradient = math.exp(near), allowed.at(math.exp(near)), at(near).effects, dict[str, float]()
    shorter = at(near - margin) if breakable(scene) and at(near + margin).note == Outcome.broken.name else None
    breaks = shorter is not None and math.isfinite(shorter.value)
    if shorter is not None and breaks:
        span, sag, effects = math.exp(near - margin), shorter.value, shorter.effects
    elif not abs(left(near)) < _JUMP:
        found_text = f"the sag jumps past the limit at a span of {length_text(span)}"
        raise SoftcatError(f"{found_text}: the filament ruptures, or has no answer, before it sags so much")
    elif exponents:
        gradient = exponents_of(with_span(scene, span), allowed, effects, _parameters(scene))
    scan = tuple((math.exp(x), runs[x].value) for x in sorted(runs))
    return CriticalSpan(span, sag, gradient, scan, effects, allowed, breaks)


def longest_span(
    scene: SceneLike, max_sag: object = "5 %", progress: Progress | None = None, *, changes: Changes = ()
) -> CriticalSpan:
    """Find the longest span of a filament whose sag stays below a limit, with its error and what limits it.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The filament; its own span is where the search begins, and says nothing else.
    max_sag : str or float
        Largest sag allowed during the run: a length with its unit, or a fraction of the span such as ``"5 %"``.
    progress : Progress, optional
        Receiver of progress reports.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"material.yield_stress": "200 Pa"}``.

    Returns
    -------
    CriticalSpan
        `span` and `error` [m]. The error is that of the sag at this span, as companion runs estimate it, over the slope
        of the sag by the span, and what the search leaves open (0.2 %).

    Raises
    ------
    SceneError
        If the limit is neither a length nor a fraction, or the scene cannot have the effects that it names.
    SoftcatError
        If no span between a thirtieth and thirty times the scene's own reaches the limit, if all of them sag more, or
        if the answer at the longest one cannot be trusted.
    """
    scene, progress = as_scene(scene, changes), progress or Silence()
    found, allowed = critical_span(scene, max_sag, progress=progress, exponents=False), read_limit(max_sag)
    progress.doing(f"the error at a span of {length_text(found.span)}")
    run = recalled(with_span(scene, found.span), progress)
    total = (run.summary["error_estimate"] or {}).get("total")
    if not run.outcome.is_success or total is None:
        raise SoftcatError(f"a span of {length_text(found.span)} is no answer: {run.outcome.name}: {run.outcome.value}")
    known = [(math.log(span), allowed.excess(span, sag)) for span, sag in found.scan if 0 < sag < math.inf]
    (x0, y0), (x1, y1) = sorted(sorted(known, key=lambda pair: abs(pair[1]))[:2])
    error = found.span * (_COARSE + (total * (x1 - x0) / (y1 - y0) if y1 > y0 else math.inf))
    if found.breaks:
        why = f"a longer one breaks; at this span it sags {length_text(found.sag)}"
    else:
        why = f"a longer one sags more than {length_text(allowed.at(found.span))} ({run.summary['regime']})"
    return replace(found, error=error, limited_by=why)


def _read(scene: Scene, limit: object, within: tuple[object, object] | None) -> tuple[Limit, tuple[float, float]]:
    faults = []
    allowed, bounds = Limit(math.nan, of_span=False), (math.nan, math.nan)
    try:
        allowed = read_limit(limit)
    except NotAQuantity as found:
        faults.append(Fault("limit", str(found), LIMITS))
    if scene.pillars.present:
        faults.append(Fault("pillars", "given, whose gap no search varies", "softcat sweep over pillars.gap"))
    span, least = scene.filament.span, _THICK * scene.filament.thickness
    try:
        pair = within or (span / FACTOR, span * FACTOR)
        low, high = (read_positive(bound, "length", "m") for bound in pair)
        bounds = (max(low, least), high)
        if not bounds[0] < high:
            faults.append(Fault(f"within {SPAN}", f"{bounds[0]:g} m to {high:g} m", "spans above the thickness"))
    except (NotAQuantity, ValueError) as found:
        faults.append(Fault(f"within {SPAN}", shown(str(found)), 'a pair of lengths such as ("2 mm", "50 mm")'))
    if faults:
        raise SceneError(faults)
    return allowed, bounds


def _refuse_without_crossing(
    allowed: Limit, bounds: tuple[float, float], spans: list[float], scanned: list[Sag], excess: list[float]
) -> None:
    low, high = map(length_text, bounds)
    if excess[0] >= 0:
        sag = scanned[0].value
        how = f"sags {length_text(sag)}" if math.isfinite(sag) else f"fails ({scanned[0].note})"
        raise SoftcatError(f"even a span of {length_text(spans[0])} {how}: give smaller spans, or a limit above that")
    if not crossings(excess):
        span, most = max(zip(spans, scanned, strict=True), key=lambda pair: pair[1].value / allowed.at(pair[0]))
        raise SoftcatError(
            f"no span from {low} to {high} reaches the limit: at {length_text(span)} it sags "
            f"{length_text(most.value)}, against {length_text(allowed.at(span))}; give larger spans or a smaller "
            "limit"
        )


def _parameters(scene: Scene) -> tuple[str, ...]:
    """Every constant of material and surroundings once, thickness, width if it is one's own, and density."""
    paths: dict[str, str] = {}
    for one in candidates(scene):
        geometric = one.path in ("filament.thickness", "filament.width", "filament.density")
        if (one.path.startswith(("material.", "surroundings.")) or geometric) and one.logarithmic and not one.trouble:
            paths.setdefault(one.constant, one.path)
    return tuple(paths.values())
