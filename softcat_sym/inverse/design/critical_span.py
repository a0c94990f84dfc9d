"""The largest span whose sag stays below a limit, and how it moves with material, thickness and density."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.inverse.design.bracketing import crossings, illinois
from softcat_sym.inverse.design.polishing import LIMITS, Limit, polished, read_limit
from softcat_sym.inverse.design.sag import FrozenSag, Sag, sag_of_run, with_span
from softcat_sym.inverse.design.variables import SPAN, read_positive
from softcat_sym.inverse.design.wording import length_text
from softcat_sym.inverse.forward.free_candidates import candidates
from softcat_sym.scene import Scene
from softcat_sym.scene.units import NotAQuantity, shown

_FACTOR = 30.0
_RATIO = 1.8  # of neighbouring spans in the scan
_FEWEST = 4
_COARSE = 2e-3
_JUMP = 1.0  # of log sag over the limit, that no continuous sag leaves within the bracket
_THICK = 1.05

Told = Callable[[float, float], None]


@dataclass(frozen=True, eq=False)
class CriticalSpan:
    """The largest safe span.

    Attributes
    ----------
    span : float
        [m]; the smallest at which the sag reaches the limit: every span that was scanned below it sags less.
    sag : float
        There, which is the limit [m].
    gradient : mapping of str to float
        d log span/d log parameter, by path: an exponent. Zero for what makes no difference.
    crossings : tuple of (float, float)
        Neighbouring spans of the scan [m] between which the sag crosses the limit, either way.
    scan : tuple of (float, float)
        Span and sag [m]; infinite where the run has no answer.
    effects : tuple of str
        In force at the critical span.
    notes : tuple of str
        What to know beside the numbers.
    """

    span: float
    sag: float
    gradient: Mapping[str, float]
    crossings: tuple[tuple[float, float], ...]
    scan: tuple[tuple[float, float], ...]
    effects: tuple[str, ...]
    notes: tuple[str, ...]

    @property
    def text(self) -> tuple[str, ...]:
        """Plain sentences."""
        strongest = sorted(self.gradient.items(), key=lambda pair: -abs(pair[1]))
        listed = ", ".join(f"{path.rpartition('.')[2]}^{power:.3g}" for path, power in strongest if abs(power) > 5e-3)
        head = f"The sag reaches {length_text(self.sag)} at a span of {length_text(self.span)}."
        return (head, f"About there the critical span goes as {listed}.", *self.notes)


def critical_span(
    scene: Scene,
    limit: object,
    time: object = None,
    within: tuple[object, object] | None = None,
    told: Told | None = None,
) -> CriticalSpan:
    """Find the largest span that sags less than a limit.

    Spans are scanned by whole runs, the first crossing is closed in by them, and the root is polished with the effects
    that are in force there; the gradient follows by implicit differentiation, -(d sag/d p)/(d sag/d span), from the
    sensitivities of the discrete solution at the root.

    Parameters
    ----------
    scene : Scene
        All but the span.
    limit : str or float
        A length with its unit, or a fraction of the span: a number, or ``"5 %"``.
    time : str or float, optional
        At which the sag is meant [s]; by default the largest until the end of the run.
    within : (low, high), optional
        Spans, as text or in m. By default the scene's own, thirty times smaller and larger.
    told : callable, optional
        Told every span and sag [m] of the scan.

    Raises
    ------
    SceneError
        If the limit, the time or the bounds make no sense.
    SoftcatError
        If all spans sag less than the limit, or even the smallest sags more.
    """
    read, allowed, bounds = _read(scene, limit, time, within)
    return _closed_in(read, allowed, bounds, at_end=time is not None, told=told)


def _closed_in(
    scene: Scene, allowed: Limit, bounds: tuple[float, float], *, at_end: bool, told: Told | None
) -> CriticalSpan:
    """Scan, close in and polish."""

    def run(span: float) -> Sag:
        return sag_of_run(with_span(scene, span), at_end=at_end)

    count = math.ceil(math.log(bounds[1] / bounds[0]) / math.log(_RATIO)) + 1
    spans = np.geomspace(*bounds, max(count, _FEWEST)).tolist()
    scanned: list[Sag] = []
    for span in spans:
        scanned.append(run(span))
        if told is not None:
            told(span, scanned[-1].value)
    excess = [allowed.excess(span, one.value) for span, one in zip(spans, scanned, strict=True)]
    _refuse_without_crossing(allowed, spans, scanned, excess)
    found = crossings(excess)
    first = found[0]
    ends = [(math.log(spans[i]), excess[i]) for i in (first, first + 1)]
    near, left = illinois(lambda x: allowed.excess(math.exp(x), run(math.exp(x)).value), ends[0], ends[1], _COARSE)
    if not abs(left) < _JUMP:
        found_text = f"the sag jumps past the limit at a span of {length_text(math.exp(near))}"
        raise SoftcatError(f"{found_text}: the filament ruptures, or has no answer, before it sags so much")
    effects, paths = run(math.exp(near)).effects, _parameters(scene)
    frozen = FrozenSag(with_span(scene, math.exp(near)), effects, paths, at_end=at_end)
    root = polished(frozen, allowed, math.exp(near))
    notes = root.notes
    if len(found) > 1:
        notes = (*notes, f"The sag crosses the limit {len(found)} times within the scan; this is the smallest span.")
    return CriticalSpan(
        span=root.span,
        sag=root.sag,
        gradient={path: root.gradient.get(path, 0.0) for path in paths},
        crossings=tuple((spans[i], spans[i + 1]) for i in found),
        scan=tuple((span, one.value) for span, one in zip(spans, scanned, strict=True)),
        effects=effects,
        notes=notes,
    )


def _read(
    scene: Scene, limit: object, time: object, within: tuple[object, object] | None
) -> tuple[Scene, Limit, tuple[float, float]]:
    faults = []
    allowed, bounds = Limit(math.nan, of_span=False), (math.nan, math.nan)
    try:
        allowed = read_limit(limit)
    except NotAQuantity as found:
        faults.append(Fault("limit", str(found), LIMITS))
    if time is not None:
        try:
            scene = scene.replace({"run.duration": f"{read_positive(time, 'time', 's')!r} s"})
        except NotAQuantity as found:
            faults.append(Fault("time", str(found), 'a positive time such as "10 s"'))
    span, least = scene.filament.span, _THICK * scene.filament.thickness
    try:
        pair = within or (span / _FACTOR, span * _FACTOR)
        low, high = (read_positive(bound, "length", "m") for bound in pair)
        bounds = (max(low, least), high)
        if not bounds[0] < high:
            faults.append(Fault(f"within {SPAN}", f"{bounds[0]:g} m to {high:g} m", "spans above the thickness"))
    except (NotAQuantity, ValueError) as found:
        faults.append(Fault(f"within {SPAN}", shown(str(found)), 'a pair of lengths such as ("2 mm", "50 mm")'))
    if faults:
        raise SceneError(faults)
    return scene, allowed, bounds


def _refuse_without_crossing(allowed: Limit, spans: list[float], scanned: list[Sag], excess: list[float]) -> None:
    low, high = length_text(spans[0]), length_text(spans[-1])
    if excess[0] >= 0:
        how = f"sags {length_text(scanned[0].value)}" if math.isfinite(excess[0]) else f"fails ({scanned[0].note})"
        raise SoftcatError(f"even a span of {low} {how}: give smaller spans, or a limit above that")
    if not crossings(excess):
        most = max(zip(spans, scanned, strict=True), key=lambda pair: pair[1].value / allowed.at(pair[0]))
        raise SoftcatError(
            f"no span from {low} to {high} reaches the limit: at {length_text(most[0])} it sags "
            f"{length_text(most[1].value)}, against {length_text(allowed.at(most[0]))}; give larger spans or a smaller "
            "limit"
        )


def _parameters(scene: Scene) -> tuple[str, ...]:
    """Every constant of the material once, thickness, width if it is one's own, and density."""
    paths: dict[str, str] = {}
    for one in candidates(scene):
        geometric = one.path in ("filament.thickness", "filament.width", "filament.density")
        if (one.path.startswith("material.") or geometric) and one.logarithmic and not one.trouble:
            paths.setdefault(one.constant, one.path)
    return tuple(paths.values())
