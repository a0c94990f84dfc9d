"""Rules of the field for a spanning filament against the solver, and the effects that explain their errors."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from softcat_sym.effects.effect_sets import dependants, ordered, string_of, terms_of, with_effects
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.errors import SoftcatError
from softcat_sym.estimates.expected_regime import TURNS_BACK, expected_regime
from softcat_sym.estimates.scaling import (
    beam_of,
    buoyant_share,
    effective_viscosity,
    gravity_number_of,
    gravity_of,
    static_modulus,
    weight_stress,
    yield_stress_of,
)
from softcat_sym.physics import beams, closed_forms, regimes
from softcat_sym.physics.constitutive_laws import K, n
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.physics.symbols import E, L, eta, g, h0, rho, t
from softcat_sym.results.breaking import unbreakable
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME, time_of_rest, time_to_share
from softcat_sym.results.run import Run
from softcat_sym.scene.history import values_at
from softcat_sym.scene.natural_curve import is_curved
from softcat_sym.scene.scene import Scene, is_held, undeformed_area
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.solution import Progress

Floats = npt.NDArray[np.float64]

HOLDS = 0.05
"""Largest relative error of a rule that holds."""


@dataclass(frozen=True, slots=True)
class Descent:
    """Sag of a filament and its time course; lengths in m, times in s."""

    final: float  # Sag of the midpoint at the end of the run
    largest: float  # Largest sag of the midpoint
    settled: float | None  # Time from which it stays within 1 % of the final sag; None if it moves in the last tenth
    to_90: float | None  # Time at which it first reaches 90 % of the final sag; None if it ends above its supports
    rise: float  # Largest rise of the midpoint after a lower position, over the largest sag
    damping: str  # ``"overdamped"``, or ``"underdamped"`` if the rise is more than 5 %
    stretch: float  # Largest stretch at the end
    stretch_at: float  # X/L of the largest stretch, from -1/2 to 1/2


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule of the field against the solver."""

    key: str
    name: str
    source: str
    quantity: str  # The predicted quantity
    unit: str
    predicted: float | None  # None where the rule does not apply
    solver: float
    bare: float | None = None  # Error against the solver without any effect that the rule neglects, if it was run
    # Neglected effects that explain the error, the strongest first: `cause` in words, and `error` of the rule against
    # a filament with this neglected effect alone.
    blames: tuple[dict[str, Any], ...] = ()
    text: str = ""  # Why the rule fails or does not apply

    @property
    def error(self) -> float | None:
        """Prediction over the solver's value, minus one; None where there is nothing to compare."""
        if self.predicted is None or not self.solver > 0 or not math.isfinite(self.predicted):
            return None
        return self.predicted / self.solver - 1

    @property
    def holds(self) -> bool:
        """Whether the magnitude of the error is at most :data:`HOLDS`."""
        return self.error is not None and abs(self.error) <= HOLDS

    @property
    def fails(self) -> bool:
        """Whether the magnitude of the error is larger, so that something is to blame."""
        return self.error is not None and not self.holds


def descent_of(run: Run) -> Descent | None:
    """Measure the descent of the midpoint; None if the run holds a single frame."""
    time, sag = run.data["time"].values, -run.data["midpoint"].values
    if len(time) < 2 or not np.all(np.isfinite(sag)):
        return None
    final, stretch = float(sag[-1]), run.data["stretch"].values[-1]
    at, rise = int(np.argmax(stretch)), float(run.summary["rebound"])
    return Descent(
        final=final,
        largest=-float(run.summary["midpoint_lowest_m"]),
        settled=time_of_rest(time, sag),
        to_90=time_to_share(time, sag) if final > 0 else None,
        rise=rise,
        damping="underdamped" if rise > TURNS_BACK else "overdamped",
        stretch=float(stretch[at]),
        stretch_at=float(run.data["X_cell"].values[at]) / run.scene.filament.span,
    )


def certificate_of(run: Run, descent: Descent) -> dict[str, Any]:
    """Numbers that show whether the filament has stopped; None where the law has no such number.

    They are: G of the scene, G of first yield, and G above which no catenary is in equilibrium; at the end the largest
    fibre stress over the yield stress, and the yielding share; over the last tenth the largest plastic rate over
    sigma_Y/eta (arrested below 0.5), and the change of the sag over the final sag.
    """
    scene, data, names = run.scene, run.data, tuple(run.summary["effects"])
    sag, regime = -data["midpoint"].values, str(run.summary.get("regime") or "")
    begin = min(len(sag) - 1, int((1 - ARREST_TIME) * (len(sag) - 1)))
    drift = float(np.ptp(sag[begin:]) / abs(descent.final)) if descent.final else 0.0
    keys = ("arrested", "gravity_number", "first_yield", "threshold", "stress", "yielding", "rate")
    # The material at the end of the run decides whether the filament has stopped.
    scene = scene.at(scene.run.duration)
    limit = yield_stress_of(scene)
    if limit is None:
        stops = "it never stops" if run.terms.flows else "only elasticity stops it"
        return {**dict.fromkeys(keys), "drift": drift, "text": f"no yield stress: {stops}"}
    expected, viscosity = expected_regime(scene, names), effective_viscosity(scene)
    rate = float(np.max(data["plastic_rate"].values[begin:])) * viscosity / limit if viscosity else None
    yielding = float(np.average(data["yielded_fraction"].values[-1], weights=np.diff(data["X_node"].values)))
    flow = "" if rate is None else f"plastic rate {rate:.2g} sigma_Y/eta (limit {ARREST_RATE:g})"
    if regime == "no-yield":
        text = "no fibre ever yields: the sag is elastic"
    elif regime:
        text = "; ".join(filter(None, (flow, f"{100 * yielding:.2g} % still yields")))
    else:
        text = f"the run is not to be trusted; {flow}"
    arrested = (regime == "no-yield" or regime.startswith("arrested")) if regime else None
    numbers = (expected.gravity_number, expected.first_yield, expected.arrest_exact)
    at_end = (largest_fibre_stress(run, -1) / limit, yielding, rate)
    return {**dict(zip(keys, (arrested, *numbers, *at_end), strict=True)), "drift": drift, "text": text}


def largest_fibre_stress(run: Run, frame: int | None = None) -> float:
    """Largest fibre stress of a frame, by default of the whole run [Pa].

    For a stress that is linear through the thickness it is |sigma_0| + |sigma_1|. A yielding section has the flow
    stress sigma_Y + K rate^n.
    """
    data, material = run.data.isel(time=slice(None) if frame is None else [frame]), run.scene.material
    time = data["time"].values
    linear = np.abs(data["stress_mean"].values) + np.abs(data["stress_bending"].values)
    limit = yield_stress_of(run.scene)
    if limit is None or material.viscosity is None or not run.terms.yields:
        return float(np.max(linear))
    limits, consistency = (values_at(one, time)[:, None] for one in (limit, material.viscosity))
    flowing = limits + consistency * data["plastic_rate"].values ** material.index
    return float(np.max(np.where(data["yielded_fraction"].values > 0, flowing, np.minimum(linear, limits))))


def support_pull(run: Run) -> float:
    """Force of the left support at the end over the area of the undeformed section [Pa]."""
    last = run.data.isel(time=-1, cell=0)
    along = last["axial_force"] if "axial_force" in last else last["tension"]
    return float(np.hypot(along, last["shear_force"])) / undeformed_area(run.scene)


SAG, FIBRE, SUPPORT = "final sag", "largest fibre stress", "pull of the support"

MEASURES: dict[str, Callable[[Run], float]] = {
    SAG: lambda run: -float(run.data["midpoint"].values[-1]),
    FIBRE: largest_fibre_stress,
    SUPPORT: support_pull,
}
"""Values of the solver, by quantity."""

Prediction = float | str
"""Prediction of a rule in SI, or the reason why it does not apply."""


@dataclass(frozen=True, slots=True)
class RuleOfTheField:
    """A rule before it is applied."""

    key: str
    name: str
    source: str
    quantity: str
    predict: Callable[[Scene, Run], Prediction]
    neglects: tuple[str, ...]  # Keys of causes that the rule neglects
    ends: str = ""  # End condition that the rule assumes; empty for the scene's own, or where it does not matter


def unusual(scene: Scene) -> str:
    """Why no rule of the field applies to the scene; empty if rules apply."""
    ends, filament = scene.ends, scene.filament
    checks = {
        "an end is free": not is_held(scene),
        "an end gives way": any(support.has_springs for support in ends.supports),
        "the supports are not level, or move": ends.drop != 0 or bool(ends.motion),
        "a clamp is turned": ends.left_angle != 0 or ends.right_angle != 0,
        "its thickness varies": bool(filament.profile),
        "it is curved by nature": is_curved(scene),
        "it starts slack or stretched": filament.rest_length is not None,
        "a weight hangs at its middle": scene.load.point_mass > 0,
        "it starts stressed": bool(scene.initial.P) or bool(scene.initial.C) or scene.initial.stretch != 1,
        "there is no gravity": scene.load.gravity == 0,
        "it is shaken": scene.load.shake > 0,
        "it floats up": buoyant_share(scene) >= 1,
    }
    return next((why for why, found in checks.items() if found), "")


def _value(expression: Any, scene: Scene, more: Mapping[Any, float] | None = None) -> float:
    filament = scene.filament
    known = {rho: filament.density, g: gravity_of(scene), L: filament.span, h0: filament.thickness}
    return float(expression.subs({**known, **(more or {})}))


def _elastic(sag: Callable[[Scene], Any], scene: Scene, run: Run | None = None) -> Prediction:
    """Prediction of an elastic sag, which needs no run."""
    del run
    modulus = static_modulus(scene)
    if modulus is None:
        return f"the law '{scene.material.law}' has no modulus"
    return _value(sag(scene), scene, {E: modulus})


_NEVER_FLOWS = "no fibre yields, so that nothing flows"


def _rigid(scene: Scene, run: Run) -> bool:
    """Whether a filament with a yield stress never yielded."""
    return yield_stress_of(scene) is not None and not bool((run.data["yielded_fraction"].values > 0).any())


def _viscous(shape: str, scene: Scene, run: Run) -> Prediction:
    """Prediction of a viscous sag, of a beam or of a string; time is counted from half the ramp of the load."""
    material, spec = scene.material, scene.material.spec
    viscosity = None if spec.is_solid or spec.has_formula else effective_viscosity(scene) or None
    if viscosity is None:
        return "a solid does not flow" if spec.is_solid else "its flow rule has no viscosity"
    if _rigid(scene, run):
        return _NEVER_FLOWS
    time = max(float(run.data["time"].values[-1]) - scene.load.ramp / 2, 0.0)
    known = {t: time, eta: viscosity, K: material.viscosity or 0.0, n: material.index}
    if shape == "beam" and material.index != 1:
        return "its viscosity changes with the rate of flow"
    if shape == "beam":
        beam = beam_of(scene)
        return _value(closed_forms.viscous_beam_sag(SECTIONS[scene.filament.section], beam), scene, known)
    string = closed_forms.viscous_string_sag() if material.index == 1 else closed_forms.power_law_string_sag()
    return _value(string, scene, known)


def _stopping(exact: bool, scene: Scene, run: Run) -> Prediction:
    """Prediction of the sag at which a catenary's stress equals the yield stress."""
    gravity_number = gravity_number_of(scene)
    if gravity_number is None:
        return "no yield stress"
    expected = expected_regime(scene, tuple(run.summary["effects"]))
    threshold = expected.arrest_exact if exact else expected.arrest_paper
    if gravity_number >= (threshold or 0.0):
        return f"G = {gravity_number:.3g} is above {threshold:.4g}: no catenary rests"
    if _rigid(scene, run):
        return _NEVER_FLOWS
    depth = expected.stopping_depth_exact if exact else expected.stopping_depth_paper
    return (depth or 0.0) * scene.filament.span


def _first_yield(scene: Scene, run: Run) -> Prediction:
    del run
    if yield_stress_of(scene) is None:
        return "no yield stress"
    beam = beam_of(scene)
    return _value(closed_forms.largest_bending_stress(SECTIONS[scene.filament.section], beam), scene)


def _catenary(exact: bool, scene: Scene, run: Run) -> Prediction:
    """Prediction of the stress of a catenary with the sag of the run."""
    sag = MEASURES[SAG](run)
    if not sag > 0:
        return "it does not hang below its supports"
    if exact:
        return weight_stress(scene) * float(closed_forms.catenary_stress(sag / scene.filament.span))
    return _value(regimes.SHALLOW_STRESS.right, scene, {regimes.H: sag})


def _beam(beam: beams.Beam, scene: Scene) -> Any:
    return closed_forms.beam_sag(SECTIONS[scene.filament.section], beam)


_pinned = partial(_elastic, partial(_beam, beams.PINNED))
_clamped = partial(_elastic, partial(_beam, beams.CLAMPED))
_cable = partial(_elastic, lambda scene: closed_forms.elastic_string_sag())

_BENT = ("ends", "flow", "stretching", "shear", "inertia", "surface", "bath")
_TAUT = ("flow", "bending", "slopes", "inertia", "surface", "bath")
_HUNG = ("bending", "elasticity", "inertia", "bath")
_CREEPS = ("yield stress", "stretching", "elasticity", "shear", "inertia", "surface", "bath")
_DRAWN = ("yield stress", "bending", "slopes", "surface", "bath")
_CARRIED = ("bending", "slopes", "inertia", "bath")
_YIELDS = ("flow", "stretching", "shear", "inertia", "surface", "bath")
_STOPS, _STOPS_EXACT = partial(_stopping, False), partial(_stopping, True)
_PULLS, _PULLS_EXACT = partial(_catenary, False), partial(_catenary, True)

RULES: tuple[RuleOfTheField, ...] = (
    RuleOfTheField("smay-pinned", "Smay 2002, pinned beam", "5 q L^4/(384 E I)", SAG, _pinned, _BENT, "pinned"),
    RuleOfTheField("beam-clamped", "clamped beam", "q L^4/(384 E I)", SAG, _clamped, _BENT, "clamped"),
    RuleOfTheField("elastic-cable", "elastic cable", "(3 rho g L^4/(64 E))^(1/3)", SAG, _cable, _TAUT),
    RuleOfTheField("viscous-beam", "viscous beam", "Trouton 1906", SAG, partial(_viscous, "beam"), _CREEPS),
    RuleOfTheField("viscous-string", "viscous string", "[2.20]", SAG, partial(_viscous, "string"), _DRAWN),
    RuleOfTheField("stop-shallow", "catenary at yield", "[3.13]", SAG, _STOPS, _HUNG),
    RuleOfTheField("stop-exact", "catenary at yield, exact", "[3.12], exact", SAG, _STOPS_EXACT, _HUNG),
    RuleOfTheField("first-yield", "stress of the bent beam", "[3.11]", FIBRE, _first_yield, _YIELDS),
    RuleOfTheField("catenary-stress", "catenary stress", "before [3.12]", SUPPORT, _PULLS, _CARRIED),
    RuleOfTheField("catenary-stress-exact", "catenary stress, exact", "before [3.12]", SUPPORT, _PULLS_EXACT, _CARRIED),
)
"""All rules, in the order of the card."""


def _changing(scene: Scene, field: RuleOfTheField) -> str:
    """Why a rule does not apply to a changing material; empty for a pull, which does not depend on its constants."""
    return "the material changes in time" if scene.material.changes and field.quantity != SUPPORT else ""


def applied_to(run: Run, field: RuleOfTheField) -> Rule:
    """Apply a rule to the scene of a run, and compare it with the run."""
    predicted = unusual(run.scene) or _changing(run.scene, field) or field.predict(run.scene, run)
    value, text = (None, f"does not apply: {predicted}") if isinstance(predicted, str) else (predicted, "")
    unit = "m" if field.quantity == SAG else "Pa"
    return Rule(
        field.key, field.name, field.source, field.quantity, unit, value, MEASURES[field.quantity](run), text=text
    )


def elastic_sags(scene: Scene) -> dict[str, float]:
    """Sags of beams and of a cable by the rules that need no run, by name [m]; empty where they do not apply."""
    names = {"pinned beam": _pinned, "clamped beam": _clamped, "elastic cable": _cable}
    if unusual(scene) or scene.material.changes or static_modulus(scene) is None:
        return {}
    return {name: float(predict(scene)) for name, predict in names.items()}


def smay_modulus_needed(scene: Scene) -> float:
    """G' [Pa] that Smay's criterion requires for the scene: a sag of 5 % of the diameter between pins."""
    return _value(closed_forms.smay_modulus(), scene)


_STIFFER = 100.0

_EQUILIBRIA = 101
"""Frames of a row of equilibria: enough for its energy balance, which is what more of them would change."""

_NEEDS = {"shear": "stretching"}
"""Causes that cannot act without another, whose own part is divided out: a beam with shear also stretches."""

# Effects to remove, by cause; for elasticity and ends, the modulus and the end conditions are changed instead.
_CAUSES = (
    *("flow", "yield stress", "stretching", "bending", "shear", "inertia", "surface", "slopes"),
    *("bath", "elasticity", "ends"),
)
LEAVING_OUT: Mapping[str, tuple[str, ...]] = {
    cause: tuple(effect.name for effect in REGISTRY if cause in effect.causes) for cause in _CAUSES
}
WORDS: Mapping[str, str] = {name: name for name in LEAVING_OUT} | {
    "stretching": "tension",
    "surface": "surface tension",
    "slopes": "finite strain and slope",
    "bath": "drag of the bath",
    "ends": "hold of the ends",
}


class Variants:
    """Runs of one filament with causes left out; finished ones come from the store."""

    def __init__(self, run: Run, progress: Progress) -> None:
        self._run, self._progress = run, progress
        self._names = frozenset(run.summary["effects"])
        self._runs: dict[tuple[frozenset[str], str], Run | None] = {}

    def in_force(self, cause: str, ends: str) -> bool:
        """Whether a cause acts in the run and can be left out."""
        scene = self._run.scene
        if cause == "ends":
            return bool(ends) and {scene.ends.left, scene.ends.right} != {ends}
        if cause == "elasticity":
            return scene.material.youngs_modulus is not None
        return any(effect.name in self._names for effect in REGISTRY if effect.causes[:1] == (cause,))

    def without(self, causes: frozenset[str], ends: str) -> Run | None:
        """The run without some causes; None if the scene cannot be run or the run is not reliable."""
        key = (causes, ends if "ends" in causes else "")
        if key not in self._runs:
            self._progress.stage(f"without {', '.join(sorted(WORDS[cause] for cause in causes))}")
            try:
                run = recalled(without_estimate(self._scene(causes, ends)), self._progress)
            except SoftcatError:
                self._runs[key] = None
            else:
                self._runs[key] = run if run.outcome.is_success else None
        return self._runs[key]

    def _scene(self, causes: frozenset[str], ends: str) -> Scene:
        gone = {effect for cause in causes for effect in LEAVING_OUT[cause]} & self._names
        for effect in tuple(gone):
            gone |= set(dependants(effect, self._names))
        effects, scene = set(self._names) - gone, unbreakable(self._run.scene)
        changes: dict[str, object] = {}
        if self._run.terms.bending and not terms_of(scene, effects).bending:
            effects, slowly = string_of(scene, effects)
            if slowly:
                changes["load.ramp"] = f"{max(scene.load.ramp, scene.run.duration / 2)!r} s"
        scene = with_effects(scene, ordered(effects))
        if not terms_of(scene, effects).integrates:
            changes["run.frames"] = min(scene.run.frames, _EQUILIBRIA)
        if scene.numerics.cells is None:
            changes["numerics.cells"] = (self._run.summary.get("resolution") or {}).get("cells")
        if "ends" in causes:
            changes |= {"ends.left": ends, "ends.right": ends}
        if "elasticity" in causes:
            changes["material.youngs_modulus"] = f"{_STIFFER * (scene.material.youngs_modulus or 0.0)!r} Pa"
        return scene.replace(changes)


def blamed(rule: Rule, field: RuleOfTheField, variants: Variants) -> Rule:
    """Find the effects that explain the error of a rule.

    First the solver runs without any effect that the rule neglects: there the two must agree. Then each effect is put
    back alone; an effect that makes the two differ explains the error, and the difference is reported.
    """
    if rule.error is None or not rule.fails:
        return replace(rule, text="holds") if rule.holds else rule

    def error_without(causes: frozenset[str]) -> float | None:
        run = variants.without(causes, field.ends)
        if run is None:
            return None
        predicted, value = field.predict(run.scene, run), MEASURES[field.quantity](run)
        return None if isinstance(predicted, str) or not value > 0 else predicted / value - 1

    neglected = frozenset(cause for cause in field.neglects if variants.in_force(cause, field.ends))
    bare = error_without(neglected)
    if bare is None:
        return replace(rule, text="unknown: without the neglected effects the filament has no answer")
    alone: dict[str, float | None] = {}
    for cause in (cause for cause in field.neglects if cause in neglected):
        needed = _NEEDS.get(cause)
        if needed not in neglected:
            alone[cause] = error_without(neglected - {cause})
            continue
        # For a cause that needs another, its factor relative to that of the other.
        both, other = error_without(neglected - {cause, needed}), error_without(neglected - {needed})
        alone[cause] = None if both is None or other is None else (1 + both) / (1 + other) * (1 + bare) - 1
    blames: list[dict[str, Any]] = [
        {"cause": WORDS[cause], "error": error}
        for cause, error in alone.items()
        if error is not None and abs(error) > HOLDS and abs(error - bare) > HOLDS * max(1.0, 1 + bare)
    ]
    blames.sort(key=lambda blame: -_off(blame["error"]))
    failed = [WORDS[cause] for cause, error in alone.items() if error is None]
    return replace(rule, bare=bare, blames=tuple(blames), text=_sentence(blames, failed, bare, rule.error))


def _off(error: float) -> float:
    """Magnitude of an error, the same for a factor and for its reciprocal."""
    return abs(math.log1p(error)) if error > -1 else math.inf


def _sentence(blames: list[dict[str, Any]], failed: list[str], bare: float, error: float) -> str:
    """Text with the two strongest causes, each with its error alone, marked if none alone makes half of the error."""
    if not blames:
        return "no single effect: several together" if not failed else f"perhaps {', '.join(failed)}: no answer with it"
    weak = len(blames[:2]) + len(failed) > 1 and _off(blames[0]["error"]) < _off(error) / 2
    listed = ", ".join(f"{blame['cause']} ({percent(blame['error'])})" for blame in blames[:2])
    return f"{'only together: ' if weak else ''}{listed}{f'; else {percent(bare)}' if abs(bare) > HOLDS else ''}"


def percent(error: float) -> str:
    """A relative error in words: ``+3.2 %``, or a factor where it is large."""
    if error >= 9:
        return f"× {1 + error:.0f}" if error < 9999 else f"× {1 + error:.1e}"
    return f"{100 * error:+.{1 if abs(error) < 0.0995 else 0}f} %".replace("-", "\N{MINUS SIGN}")
