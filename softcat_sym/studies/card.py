"""The sag card: everything a printer asks of a spanning filament, on one page."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING

from softcat_sym.effects.scaling_estimates import effective_viscosity_at, weight_stress, yield_stress_of
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.scene.material import CONSTANTS
from softcat_sym.scene.reading import as_scene
from softcat_sym.scene.scene import Scene, gravity_time
from softcat_sym.simulate import recalled
from softcat_sym.solvers.solution import Progress, Silence
from softcat_sym.studies.card_rules import (
    MEASURES,
    RULES,
    Card,
    Rule,
    RuleOfTheField,
    Solver,
    Told,
    blamed,
    certificate_of,
    descent_of,
    unusual,
)

if TYPE_CHECKING:
    from softcat_sym.design.critical_span import CriticalSpan
    from softcat_sym.fitting.flow_curve import FlowCurveFit
    from softcat_sym.results.trajectory import Trajectory
    from softcat_sym.scene.reading import SceneLike

TITLE = "Filament"
GEOMETRY = {"density": "filament.density", "span": "filament.span", "diameter": "filament.thickness"}
"""Flags that every filament needs, and where they go."""

MATERIAL = {
    "law": "material.law",
    "youngs-modulus": "material.youngs_modulus",
    "viscosity": "material.viscosity",
    "yield-stress": "material.yield_stress",
    "index": "material.index",
    "shear-viscosity": "material.shear_viscosity",
    "shear-consistency": "material.shear_consistency",
    "shear-yield-stress": "material.shear_yield_stress",
}
"""Flags of the material, and where they go."""

OTHERS = {"ends": "", "duration": "run.duration", "flow-curve": ""}
"""What may be said beside."""

_EXAMPLES = {
    "density": '"1900 kg/m^3"',
    "span": '"2 mm"',
    "diameter": '"250 um"',
    "law": '"bingham"',
    "youngs-modulus": '"300 kPa", some three times the storage modulus G\' of an ink',
}
_SWINGS, _FLOWS = 20.0, 5.0
_ACCURACY = 0.02
_RAMP = 1.0


def scene_from_flags(flags: Mapping[str, str | None], changes: Sequence[str] = ()) -> tuple[Scene, tuple[str, ...]]:
    """Make a scene of a round filament that is let go within sqrt(L/g)."""
    given = {name: text for name, text in flags.items() if text is not None}
    curve = given.get("flow-curve")
    _refuse(given, curve)
    notes: list[str] = []
    table: dict[str, dict[str, object]] = {"filament": {"section": "circle"}, "material": {}, "run": {}}
    for name, path in {**GEOMETRY, **MATERIAL}.items():
        if name in given and not (curve and name == "law"):
            part, key = path.split(".")
            table[part][key] = _number(given[name]) if name == "index" else given[name]
    if curve is not None:
        fitted, told = _from_curve(curve, given.get("law"))
        table["material"] |= fitted
        notes.append(told)
    kind = given.get("ends", "clamped")
    table["ends"] = {"left": kind, "right": kind}
    table["run"] = {"duration": given.get("duration", "1 s"), "accuracy": _ACCURACY}
    scene = Scene.model_validate({"title": _title(given), **table})
    if changes:
        scene = _changed(scene, changes)
    return _timed(scene, given, changes, notes)


def _refuse(given: Mapping[str, str], curve: str | None) -> None:
    needed = [*GEOMETRY, *(["youngs-modulus"] if curve else ["law"])]
    faults = []
    for name in needed:
        if name not in given:
            why = "missing" if name != "youngs-modulus" else "missing: a flow curve says nothing about the modulus"
            faults.append(Fault(f"--{name}", why, _EXAMPLES[name]))
    if curve:
        own = [name for name in MATERIAL if name in given and name not in ("law", "youngs-modulus")]
        faults += [Fault(f"--{name}", "given twice, here and by --flow-curve", "one of the two") for name in own]
    elif "law" in given and given["law"] in CONSTANTS:
        has = {name.removeprefix("shear-").replace("consistency", "viscosity").replace("-", "_") for name in given}
        lacking = [name for name in CONSTANTS[given["law"]] if name not in has]
        flagged = {name: name.replace("_", "-") for name in lacking}
        faults += [
            Fault(f"--{flag}", f"missing: the law '{given['law']}' needs it", "a value with its unit")
            for name, flag in flagged.items()
            if flag in MATERIAL
        ]
    if faults:
        raise SceneError(faults)


def _from_curve(curve: str, law: str | None) -> tuple[dict[str, object], str]:
    from softcat_sym.fitting.flow_curve import fit_flow_curve

    fit: FlowCurveFit = fit_flow_curve(curve)
    fitted: dict[str, object] = {path.removeprefix("material."): value for path, value in fit.overrides(law).items()}
    best = fit.candidate(law)
    told = f"{best.law} fitted to {curve}, {100 * best.relative_rms:.2g} % rms; shear data are converted to tension"
    return fitted, told


def _changed(scene: Scene, changes: Sequence[str]) -> Scene:
    from softcat_sym.scene.toml import read_overrides

    read, faults = read_overrides(changes)
    if faults:
        raise SceneError(faults)
    return scene.replace({change.path: change.value for change in read})


def _timed(
    scene: Scene, given: Mapping[str, str], changes: Sequence[str], notes: list[str]
) -> tuple[Scene, tuple[str, ...]]:
    """Duration and ramp, where neither is given."""
    own = {change.split("=")[0].strip() for change in changes}
    swing, late = gravity_time(scene), {}
    if not swing > 0:
        return scene, tuple(notes)
    if "load.ramp" not in own:
        late["load.ramp"] = f"{_RAMP * swing!r} s"
    if "duration" not in given and "run.duration" not in own:
        weight = weight_stress(scene)
        stress = yield_stress_of(scene) or weight
        viscosity = effective_viscosity_at(scene, stress) or 0.0
        slow = (_FLOWS if yield_stress_of(scene) else 1.0) * viscosity / stress
        duration = float(f"{_SWINGS * swing + slow:.3g}")
        late["run.duration"] = f"{duration!r} s"
        notes.append(f"duration {duration:g} s: 20 sqrt(L/g) and the time of flow; --duration gives another")
    return scene.replace(late), tuple(notes)


def _number(text: str) -> object:
    try:
        return float(text)
    except ValueError:
        return text


def _title(given: Mapping[str, str]) -> str:
    what = given.get("law") or "ink"
    return f"{what}, {given['diameter']} across {given['span']}"


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
        run = recalled(scene, listener)
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
    """Lay a rule beside a run."""
    predicted = unusual(run.scene) or own.predict(run.scene, run)
    says, why = (None, f"does not apply: {predicted}") if isinstance(predicted, str) else (predicted, "")
    return Rule(own.key, own.name, own.source, own.quantity, own.unit, says, MEASURES[own.quantity](run), text=why)


def _check_limit(limit: object) -> None:
    """Refuse a limit that is none before anything is run."""
    from softcat_sym.design.critical_span import LIMITS, read_limit
    from softcat_sym.scene.units import NotAQuantity

    try:
        read_limit(limit)
    except NotAQuantity as found:
        raise SceneError([Fault("sag", str(found), LIMITS)]) from None


def _longest_span(scene: Scene, limit: object, told: Told | None, *, given: bool) -> tuple[CriticalSpan | None, str]:
    """The critical span near the scene's own, or farther away; why there is none, if a default limit has none."""
    from softcat_sym.design.critical_span import critical_span

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
