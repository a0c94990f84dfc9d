"""What a sag card holds."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from softcat_sym.inverse.design import CriticalSpan
    from softcat_sym.scene import Scene
    from softcat_sym.trajectory import Trajectory

HOLDS = 0.05
"""A rule holds if it is off by no more than this."""


@dataclass(frozen=True, slots=True)
class Descent:
    """How far and how fast a filament sagged; lengths in m, times in s.

    Attributes
    ----------
    final : float
        Sag of the midpoint at the end of the run.
    largest : float
        At any time.
    settled : float or None
        From when on it stays within 1 % of the final sag; None if it still moves in the last tenth of the run.
    to_90 : float or None
        When it first reaches 90 % of the final sag; None if it ends above its supports.
    rise : float
        How far it came back up after it had been lower, over the largest sag.
    damping : str
        ``"overdamped"`` or ``"underdamped"``: whether it came back up by more than 5 %.
    stretch, stretch_at : float
        Largest stretch at the end, and where, X/L from -1/2 to 1/2.
    """

    final: float
    largest: float
    settled: float | None
    to_90: float | None
    rise: float
    damping: str
    stretch: float
    stretch_at: float


@dataclass(frozen=True, slots=True)
class Certificate:
    """Why the filament is, or is not, at rest.

    Attributes
    ----------
    arrested : bool or None
        None for a law without a yield stress.
    gravity_number, first_yield, threshold : float or None
        G of the scene, from which a fibre yields, and above which no catenary rests: 1.3255.
    stress : float or None
        Largest fibre stress at the end over the yield stress.
    yielding : float or None
        Share of the filament that still yields at the end.
    rate : float or None
        Largest plastic rate in the last tenth of the run, over sigma_Y/eta; below 0.5 counts as arrested.
    drift : float
        Change of the sag in the last tenth of the run, over the final sag.
    text : str
        In words.
    """

    arrested: bool | None
    gravity_number: float | None
    first_yield: float | None
    threshold: float | None
    stress: float | None
    yielding: float | None
    rate: float | None
    drift: float
    text: str


@dataclass(frozen=True, slots=True)
class Blame:
    """One thing that a rule leaves out, and how far it alone puts the rule off.

    Attributes
    ----------
    cause : str
        In words.
    error : float
        Rule over solver minus one, of a filament with this cause and nothing else of what the rule leaves out.
    """

    cause: str
    error: float


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule of the field beside the solver's answer.

    Attributes
    ----------
    key, name, source : str
        Short name, name and where it comes from.
    quantity, unit : str
        What it predicts, and in which unit.
    predicted : float or None
        None where it does not apply.
    solver : float
        The same of the run.
    bare : float or None
        Error against the solver without anything that the rule leaves out; None where that was not run.
    blames : tuple of Blame
        Which effects make it fail, the strongest first.
    text : str
        Why it fails or does not apply, in a sentence.
    """

    key: str
    name: str
    source: str
    quantity: str
    unit: str
    predicted: float | None
    solver: float
    bare: float | None = None
    blames: tuple[Blame, ...] = ()
    text: str = ""

    @property
    def error(self) -> float | None:
        """Rule over solver minus one; None where there is nothing to compare."""
        if self.predicted is None or not self.solver > 0 or not math.isfinite(self.predicted):
            return None
        return self.predicted / self.solver - 1

    @property
    def holds(self) -> bool:
        """Whether it is off by no more than :data:`HOLDS`."""
        return self.error is not None and abs(self.error) <= HOLDS


@dataclass(frozen=True, eq=False)
class Card:
    """All that one page says about a spanning filament.

    Attributes
    ----------
    name : str
        What was asked for: the name of a scene, or empty.
    scene : Scene
        The filament.
    run : Trajectory
        Its run, with an error estimate.
    descent : Descent or None
        None if the run has no frame to show.
    certificate : Certificate or None
        Likewise.
    rules : tuple of Rule
        The field's.
    limit : str
        What the filament may sag, as it was given.
    span : CriticalSpan or None
        The longest span that sags less, and its exponents; None where none was found.
    span_text : str
        Why not; empty otherwise.
    notes : tuple of str
        What was assumed or converted.
    """

    name: str
    scene: Scene
    run: Trajectory
    descent: Descent | None
    certificate: Certificate | None
    rules: tuple[Rule, ...]
    limit: str
    span: CriticalSpan | None
    span_text: str
    notes: tuple[str, ...]

    @property
    def summary(self) -> Mapping[str, Any]:
        """Of the run."""
        return self.run.summary

    @property
    def error_estimate(self) -> float | None:
        """Of the midpoint over the largest midpoint; None where nothing has estimated it."""
        estimate = self.run.summary.get("error_estimate") or {}
        total = estimate.get("total")
        return None if total is None else float(total)

    @property
    def regime(self) -> str:
        """As the run shows it; empty where the run is not to be trusted."""
        return str(self.run.summary.get("regime") or "")

    def as_dict(self) -> dict[str, Any]:
        """The same as nested dictionaries and lists, in SI, fit for JSON; numbers that are not finite are None."""
        span = self.span
        found = {
            "name": self.name,
            "title": self.scene.title,
            "outcome": self.run.outcome.name,
            "complaint": self.run.summary.get("complaint") or "",
            "regime": self.regime or None,
            "error_estimate": self.error_estimate,
            "descent": None if self.descent is None else dataclasses.asdict(self.descent),
            "certificate": None if self.certificate is None else dataclasses.asdict(self.certificate),
            "rules": [{**dataclasses.asdict(rule), "error": rule.error, "holds": rule.holds} for rule in self.rules],
            "longest_span": {
                "limit": self.limit,
                "span_m": None if span is None else span.span,
                "sag_m": None if span is None else span.sag,
                "exponents": {} if span is None else dict(span.gradient),
                "notes": [self.span_text] if span is None else list(span.notes),
            },
            "effects": list(self.run.summary.get("effects") or ()),
            "notes": list(self.notes),
            "warnings": list(self.run.summary.get("warnings") or ()),
        }
        plain: dict[str, Any] = _finite(found)
        return plain


def _finite(value: Any) -> Any:
    """Numbers that JSON does not know become null."""
    if isinstance(value, dict):
        return {key: _finite(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(one) for one in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
