"""The sag card: one run, the rules of the field beside it, and the longest span."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING

from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.scene import as_scene
from softcat_sym.simulate import simulated
from softcat_sym.solve import Progress, Silence
from softcat_sym.study.card.causes import Solver, Told, blamed
from softcat_sym.study.card.contents import Card, Rule
from softcat_sym.study.card.descent import certificate_of, descent_of
from softcat_sym.study.card.rules import MEASURES, RULES, RuleOfTheField, unusual

if TYPE_CHECKING:
    from softcat_sym.inverse.design import CriticalSpan
    from softcat_sym.scene import Scene, SceneLike
    from softcat_sym.trajectory import Trajectory

LIMIT = "5 %"
"""Sag over span that is allowed unless another is given."""

_NEAR, _FAR = 3.0, 30.0
"""Factors of the span between which the longest one is sought: first near, then far."""

Listening = Callable[[str], AbstractContextManager[Progress]]


def card(
    scene: SceneLike,
    sag: object = None,
    *,
    name: str = "",
    listening: Listening | None = None,
    told: Told | None = None,
    span: bool = True,
    notes: tuple[str, ...] = (),
) -> Card:
    """Make the sag card of a filament.

    The filament is run with an error estimate. Each rule of the field is laid beside the run; where it is off by more
    than 5 %, the run is repeated without what the rule leaves out, one effect after another, and what brings the two
    together is named. Then the longest span that sags less than a limit is sought.

    Parameters
    ----------
    scene : Scene, str, path or dict
        What is asked.
    sag : str or float, optional
        What the filament may sag: a length with its unit, or a fraction of the span such as ``"5 %"``, the default.
    name, notes : str, tuple of str
        Of the scene, and what was assumed, for the page.
    listening, told : callable, optional
        Called before the run, returns a context whose value is told how far it is; told which short run begins.
    span : bool
        Whether to seek the longest span, which takes a good part of the time.

    Raises
    ------
    SceneError
        If the scene cannot have the effects that it names, or the limit is no length and no fraction.
    SoftcatError
        If `sag` is given and no span reaches it, or all do.
    KeyboardInterrupt
        On Ctrl-C.
    """
    scene = as_scene(scene)
    limit = LIMIT if sag is None else sag
    _check_limit(limit)
    with (listening or _nobody)("the filament itself") as listener:
        run = simulated(scene, listener)
    descent = descent_of(run)
    longest, why = _longest_span(scene, limit, told, given=sag is not None) if span else (None, "not sought")
    certificate = None if descent is None else certificate_of(run, descent)
    rules = _rules(run, told) if descent is not None else ()
    notes = (*notes, *scene.notes)
    return Card(name, scene, run, descent, certificate, rules, str(limit), longest, why, notes)


def _rules(run: Trajectory, told: Told | None) -> tuple[Rule, ...]:
    """Every rule; causes only of a run that may be trusted."""
    solver = Solver(run, told)
    applied = [(own, applied_to(run, own)) for own in RULES]
    if not run.outcome.is_success:
        return tuple(rule for _, rule in applied)
    return tuple(blamed(rule, own, solver) for own, rule in applied)


def applied_to(run: Trajectory, own: RuleOfTheField) -> Rule:
    """Lay a rule beside a run.

    Parameters
    ----------
    run : Trajectory
        With two frames at least.
    own : RuleOfTheField
        The rule.
    """
    predicted = unusual(run.scene) or own.predict(run.scene, run)
    says, why = (None, f"does not apply: {predicted}") if isinstance(predicted, str) else (predicted, "")
    return Rule(own.key, own.name, own.source, own.quantity, own.unit, says, MEASURES[own.quantity](run), text=why)


def _check_limit(limit: object) -> None:
    """Refuse a limit that is none before anything is run."""
    from softcat_sym.inverse.design.polishing import LIMITS, read_limit
    from softcat_sym.scene.units import NotAQuantity

    try:
        read_limit(limit)
    except NotAQuantity as found:
        raise SceneError([Fault("sag", str(found), LIMITS)]) from None


def _longest_span(scene: Scene, limit: object, told: Told | None, *, given: bool) -> tuple[CriticalSpan | None, str]:
    """The critical span near the scene's own, or farther away; why there is none, if a default limit has none."""
    from softcat_sym.inverse.design import critical_span

    def heard(span: float, _: float) -> None:
        if told is not None:
            told(f"sag of a span of {span:.3g} m")

    if told is not None:
        told("the longest span")
    own = scene.filament.span
    for factor in (_NEAR, _FAR):
        try:
            return critical_span(scene, limit, within=(own / factor, own * factor), told=heard), ""
        except SoftcatError as error:
            # Other spans may make no sense at all: of a moving support, say.
            if factor == _FAR or isinstance(error, SceneError):
                if given:
                    raise
                return None, str(error)
    return None, ""


def _nobody(what: str) -> AbstractContextManager[Progress]:
    del what
    return nullcontext(Silence())
