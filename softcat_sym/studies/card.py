"""The sag card: one page on a spanning filament, for people who print such filaments."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from softcat_sym.design.critical_span import LIMITS, CriticalSpan, critical_span, read_limit
from softcat_sym.drawing import Drawable
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.estimates.quasi_static_sag import load_factor
from softcat_sym.estimates.scaling import (
    pull_of_surface,
    weight_stress,
)
from softcat_sym.results.run import Run
from softcat_sym.scene.reading import as_scene
from softcat_sym.scene.scene import Scene, is_held, undeformed_area
from softcat_sym.scene.units import NotAQuantity
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.solution import Progress, Silence
from softcat_sym.studies.card_rules import (
    LEAVING_OUT,
    MEASURES,
    RULES,
    SAG,
    Descent,
    Rule,
    Variants,
    applied_to,
    blamed,
    certificate_of,
    descent_of,
)

if TYPE_CHECKING:
    from softcat_sym.scene.reading import Changes, SceneLike

OVER_PILLARS = 2.5
"""Length of a strand over the gap below it. An elastic one lifts off behind its edges over 0.53 gaps on either side."""


def on_pillars(scene: Scene, edge: str) -> tuple[Scene, str]:
    """The scene whose strand lies on two pillars with edges of a radius, its own span apart; and what that means."""
    span = scene.filament.span
    gap = {"pillars.gap": f"{span!r} m", "pillars.edge": edge, "filament.span": f"{OVER_PILLARS * span!r} m"}
    return scene.replace(gap), "the strand lies on pillars, clamped so far behind their edges that it is flat there"


@dataclass(frozen=True, slots=True)
class SurfaceHold:
    """Effect of surface tension."""

    pull: float  # Gam = gamma P/(2 A) [Pa]: a yield stress read from an arrested sag is too large by this
    share: float | None  # Share of the weight that it carries at the end of the run; None with a free end
    sag_without: float | None  # Final sag of the run without surface tension [m]; None if that run has no answer
    outcome_without: str
    span_without: float | None  # Longest span without surface tension [m]; None if it was not found or not searched
    span_added: float | None  # Increase of the longest span by surface tension [m]
    span_text: str  # Why there is no longest span; empty otherwise


Span = tuple[CriticalSpan | None, str]


def surface_hold(
    run: Run, longest: CriticalSpan | None, seek: Callable[[Scene], Span], progress: Progress
) -> SurfaceHold | None:
    """Run the filament without its surface tension, and search its longest span; None without surface tension."""
    scene = run.scene
    if not pull_of_surface(scene):
        return None
    bare = without_surface(scene)
    progress.stage("without surface tension")
    other = recalled(without_estimate(bare), progress)
    is_success = other.outcome.is_success
    found, why = seek(bare)
    return SurfaceHold(
        pull=pull_of_surface(scene),
        share=share_of_weight(run) if is_held(scene) and scene.load.gravity > 0 else None,
        sag_without=MEASURES[SAG](other) if is_success else None,
        outcome_without=other.outcome.name,
        span_without=None if found is None else found.span,
        span_added=None if found is None or longest is None else longest.span - found.span,
        span_text=why,
    )


def without_surface(scene: Scene) -> Scene:
    """The scene without surface tension."""
    listed = scene.run.effects
    gone: dict[str, object] = {"surroundings.surface_tension": "0 N/m"}
    if not isinstance(listed, str):
        gone["run.effects"] = [name for name in listed if name not in LEAVING_OUT["surface"]]
    return scene.replace(gone)


def share_of_weight(run: Run) -> float:
    """8 Q_c f/(q L^2) of the mean axial force of the surface, at the end."""
    last, scene = run.data.isel(time=-1), run.scene
    lengths = np.diff(run.data["X_node"].values)
    surface = float(np.average((last["axial_force"] - last["tension"]).values, weights=lengths))
    load = weight_stress(scene) * load_factor(scene) * undeformed_area(scene)
    return 8 * surface * MEASURES[SAG](run) / scene.filament.span / load


@dataclass(frozen=True, eq=False)
class Card(Drawable):
    """Content of the page on a spanning filament.

    Attributes
    ----------
    name : str
        Name of the scene; may be empty.
    scene : Scene
        The filament.
    run : Run
        The run of the filament, with an error estimate.
    descent : Descent or None
        The descent in time; None if the run has a single frame.
    certificate : dict or None
        Whether and why the filament is at rest; None if the run has a single frame.
    rules : tuple of Rule
        Rules of the field, each with its error.
    limit : str
        Largest sag allowed, as it was given.
    span : CriticalSpan or None
        The longest span with a sag below the limit, and its exponents; None where none was found.
    span_text : str
        Why no longest span was found; empty otherwise.
    surface : SurfaceHold or None
        Effect of surface tension; None without surface tension.
    notes : tuple of str
        Sentences on assumptions and conversions.
    pending : tuple of str
        What is not computed yet, or was not when the card was interrupted.
    """

    name: str
    scene: Scene
    run: Run
    descent: Descent | None
    certificate: dict[str, Any] | None
    rules: tuple[Rule, ...]
    limit: str
    span: CriticalSpan | None
    span_text: str
    surface: SurfaceHold | None
    notes: tuple[str, ...]
    pending: tuple[str, ...] = ()

    @property
    def summary(self) -> Mapping[str, Any]:
        """Summary of the run."""
        return self.run.summary

    @property
    def incomplete(self) -> str:
        """Sentence on what is missing."""
        return f"Incomplete, as it was interrupted: without {', '.join(self.pending)}"

    @property
    def error_estimate(self) -> float | None:
        """Estimated error of the midpoint over the largest midpoint; None if it was not estimated."""
        total = (self.summary.get("error_estimate") or {}).get("total")
        return None if total is None else float(total)

    @property
    def regime(self) -> str:
        """Regime that the run shows; empty if the run is not reliable."""
        return str(self.summary.get("regime") or "")

    def to_dict(self) -> dict[str, Any]:
        """Content of ``card.json``, in SI.

        ``surface_tension`` (null without any) holds: ``pull`` gamma P/(2 A) [Pa], ``share`` of the weight that it
        carries at the end, ``sag_without`` [m] and ``outcome_without`` of the same run without it, ``span_without`` and
        ``span_added`` [m], ``span_text`` if there is none.
        """
        span, summary = self.span, self.summary
        return {
            "name": self.name,
            "title": self.scene.title,
            "outcome": self.run.outcome.name,
            "message": summary.get("message") or "",
            "regime": self.regime or None,
            "error_estimate": self.error_estimate,
            "descent": None if self.descent is None else asdict(self.descent),
            "certificate": self.certificate,
            "rules": [{**asdict(rule), "error": rule.error, "holds": rule.holds} for rule in self.rules],
            "longest_span": {
                "limit": self.limit,
                "span_m": None if span is None else span.span,
                "sag_m": None if span is None else span.sag,
                "breaks": span is not None and span.breaks,
                "exponents": {} if span is None else dict(span.gradient),
                "notes": [self.span_text] if span is None else [],
            },
            "surface_tension": None if self.surface is None else asdict(self.surface),
            "effects": list(summary.get("effects") or ()),
            "notes": [*self.notes, *([self.incomplete] if self.pending else [])],
            "warnings": list(summary.get("warnings") or ()),
        }

    def to_frame(self) -> pd.DataFrame:
        """One row a rule, in SI; predictions that do not apply are missing."""
        frame = pd.DataFrame([{**asdict(rule), "error": rule.error} for rule in self.rules])
        names = {"name": "rule", "bare": "error_bare", "text": "what_makes_it_fail"}
        columns = ["rule", "source", "quantity", "unit", "predicted", "solver", "error", "error_bare"]
        return frame.rename(columns=names).reindex(columns=[*columns, "what_makes_it_fail"])

    def __repr__(self) -> str:
        return f"Card {self.name}, longest span {self.span_text or 'not asked'}\n{self.run!r}"


SPAN, SURFACE, CAUSES = "the longest span", "what surface tension holds", "what makes rules fail"
"""Parts of a card that take their time, in the order in which they are computed."""

LIMIT = "5 %"
"""Default of the largest sag over span."""


def card(
    scene: SceneLike,
    sag: object = None,
    *,
    name: str = "",
    progress: Progress | None = None,
    span: bool = True,
    notes: tuple[str, ...] = (),
    on_update: Callable[[Card], None] = lambda _: None,
    changes: Changes = (),
) -> Card:
    """Make the sag card of a filament.

    The filament is run with an error estimate. Each rule of the field is compared with the run; where a rule errs by
    more than 5 %, the run is repeated without the effects that the rule neglects, then with each of them alone, and the
    card names those that explain the error. Then the longest span with a sag below a limit is searched; for a filament
    with surface tension also the longest span without it. Finished runs come from the store.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The filament.
    sag : str or float, optional
        Largest sag allowed: a length with its unit, or a fraction of the span such as ``"5 %"``, the default.
    name, notes : str, tuple of str
        Name of the scene, and assumptions, for the page.
    progress : Progress, optional
        Receiver of progress reports; each run begins a stage.
    span : bool
        Whether to search the longest span, which takes a large part of the time.
    on_update : callable
        Given the card as far as it is, whenever more of it is known: first with the run and all that the rules predict.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.

    Raises
    ------
    SceneError
        If the scene cannot have the effects that it names, or the limit is neither a length nor a fraction.
    SoftcatError
        If `sag` is given and no span reaches it, or all do.
    KeyboardInterrupt
        On Ctrl-C.
    """
    scene, progress = as_scene(scene, changes), progress or Silence()
    limit = LIMIT if sag is None else sag
    check_limit(limit)
    progress.stage("the filament itself")
    run = recalled(scene, progress)
    descent = descent_of(run)
    moves, unsought = descent is not None, (None, "not sought")
    rules, variants = tuple(applied_to(run, field) for field in RULES if moves), Variants(run, progress)
    if run.outcome.is_success:
        # What a run has shown by itself is said at once.
        pairs = zip(rules, RULES, strict=moves)
        rules = tuple(rule if rule.fails else blamed(rule, field, variants) for rule, field in pairs)
    failing = [number for number, rule in enumerate(rules) if rule.fails and run.outcome.is_success]
    parts = {SPAN: span, SURFACE: moves and pull_of_surface(scene) > 0, CAUSES: failing}
    certificate = None if descent is None else certificate_of(run, descent)
    pending = tuple(part for part, asked in parts.items() if asked)
    texts = (*notes, *scene.notes, *filter(None, [scene.material.assumed]))
    found = Card(name, scene, run, descent, certificate, rules, str(limit), *unsought, None, texts, pending)
    on_update(found)
    if span:
        longest, why = _longest_span(scene, limit, progress, given=sag is not None)
        found = _with(found, SPAN, on_update, span=longest, span_text=why)
    if moves:
        seek = partial(_longest_span, limit=limit, progress=progress, given=False, exponents=False)
        surface = surface_hold(run, found.span, seek if span else lambda _: unsought, progress)
        found = _with(found, SURFACE, on_update, surface=surface)
    for number in failing:
        rules = found.rules
        rules = (*rules[:number], blamed(rules[number], RULES[number], variants), *rules[number + 1 :])
        found = _with(found, CAUSES if number == failing[-1] else "", on_update, rules=rules)
    return found


def check_limit(sag: object) -> None:
    """Refuse what is no limit of the sag."""
    try:
        read_limit(sag)
    except NotAQuantity as error:
        raise SceneError([Fault("sag", str(error), LIMITS)]) from None


def _with(card: Card, part: str, on_update: Callable[[Card], None], **more: Any) -> Card:
    """The card with what was computed, of which is told; a part may not be pending any more."""
    found = replace(card, pending=tuple(one for one in card.pending if one != part), **more)
    on_update(found)
    return found


def _longest_span(scene: Scene, limit: object, progress: Progress, *, given: bool, exponents: bool = True) -> Span:
    """The longest span, searched from the one that is foreseen; with a default limit, the reason if there is none."""
    progress.stage("the longest span")
    try:
        return critical_span(scene, limit, progress=progress, exponents=exponents), ""
    except SoftcatError as error:
        if given or isinstance(error, SceneError):
            raise
        return None, str(error)
