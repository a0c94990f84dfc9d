"""Effect of surface tension on a spanning filament: its sag and its longest span without surface tension."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from softcat_sym.design.critical_span import CriticalSpan, read_limit
from softcat_sym.estimates.quasi_static_sag import load_factor
from softcat_sym.estimates.scaling import pull_of_surface, weight_stress
from softcat_sym.estimates.span import Limit, with_span
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene, is_held, undeformed_area
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.solution import Progress
from softcat_sym.studies.card_rules import LEAVING_OUT, MEASURES, RULES, SAG, RuleOfTheField, unusual


@dataclass(frozen=True, slots=True)
class SurfaceHold:
    """Effect of surface tension, and the longest span by rules of the field, which neglect it."""

    pull: float  # Gam = gamma P/(2 A) [Pa]: a yield stress read from an arrested sag is too large by this
    share: float | None  # Share of the weight that it carries at the end of the run; None with a free end
    sag_without: float | None  # Final sag of the run without surface tension [m]; None if that run has no answer
    outcome_without: str
    span_without: float | None  # Longest span without surface tension [m]; None if it was not found or not searched
    span_added: float | None  # Increase of the longest span by surface tension [m]
    span_text: str  # Why there is no longest span; empty otherwise
    rule_spans: Mapping[str, float]  # The longest span by each rule of the field for a sag, by its key [m]


Span = tuple[CriticalSpan | None, str]


def surface_hold(
    run: Run, limit: object, longest: CriticalSpan | None, seek: Callable[[Scene], Span], progress: Progress
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
        rule_spans=rule_spans(other, read_limit(limit)) if is_success else {},
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


_POINTS, _FACTOR, _THICK, _BEYOND = 60, 30.0, 1.05, 50.0


def rule_spans(run: Run, limit: Limit) -> dict[str, float]:
    """The longest span for a limit by every rule of the field that predicts a sag, by its key."""
    if unusual(run.scene):
        return {}
    found = ((field.key, _span_by(field, run, limit)) for field in RULES if field.quantity == SAG)
    return {key: span for key, span in found if span is not None}


def _span_by(field: RuleOfTheField, run: Run, limit: Limit) -> float | None:
    """The smallest span at which a rule says that the sag reaches the limit."""
    own = run.scene.filament.span

    def excess(span: float) -> float:
        predicted = field.predict(with_span(run.scene, span), run)
        return _BEYOND if isinstance(predicted, str) else min(_BEYOND, limit.excess(span, predicted))

    spans = np.geomspace(_THICK * run.scene.filament.thickness, own * _FACTOR, _POINTS).tolist()
    if excess(spans[0]) >= 0:
        return None
    above = next((span for span in spans if excess(span) >= 0), None)
    if above is None:
        return None
    return float(brentq(excess, spans[spans.index(above) - 1], above, rtol=1e-6))
