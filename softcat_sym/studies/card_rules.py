"""What a sag card holds, the field's rules for a spanning filament, and which effect makes a rule fail."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.effects.law import is_solid
from softcat_sym.effects.scaling_estimates import (
    beam_of,
    effective_viscosity,
    gravity_number_of,
    static_modulus,
    weight_stress,
    yield_stress_of,
)
from softcat_sym.errors import SoftcatError
from softcat_sym.physics import closed_forms, regimes
from softcat_sym.physics.laws import K, n
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.physics.symbols import E, L, eta, g, h0, rho, t
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME, TURNED_BACK, turned_back
from softcat_sym.scene.scene import Scene, undeformed_area
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.studies.pricing import dependants, ordered, with_effects

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from softcat_sym.design.critical_span import CriticalSpan
    from softcat_sym.results.trajectory import Trajectory

HOLDS = 0.05
"""A rule holds if it is off by no more than this."""


@dataclass(frozen=True, slots=True)
class Descent:
    """How far and how fast a filament sagged; lengths in m, times in s."""

    final: float  # Sag of the midpoint at the end of the run
    largest: float  # At any time
    # From when on it stays within 1 % of the final sag; None if it still moves in the last tenth of the run.
    settled: float | None
    to_90: float | None  # When it first reaches 90 % of the final sag; None if it ends above its supports
    rise: float  # How far it came back up after it had been lower, over the largest sag
    damping: str  # ``"overdamped"`` or ``"underdamped"``: whether it came back up by more than 5 %
    stretch: float  # Largest stretch at the end, and where, X/L from -1/2 to 1/2
    stretch_at: float


@dataclass(frozen=True, slots=True)
class Certificate:
    """Why the filament is, or is not, at rest."""

    arrested: bool | None  # None for a law without a yield stress
    gravity_number: float | None  # G of the scene, from which a fibre yields, and above which no catenary rests: 1.3255
    first_yield: float | None
    threshold: float | None
    stress: float | None  # Largest fibre stress at the end over the yield stress
    yielding: float | None  # Share of the filament that still yields at the end
    # Largest plastic rate in the last tenth of the run, over sigma_Y/eta; below 0.5 counts as arrested.
    rate: float | None
    drift: float  # Change of the sag in the last tenth of the run, over the final sag
    text: str  # In words


@dataclass(frozen=True, slots=True)
class Blame:
    """One thing that a rule leaves out, and how far it alone puts the rule off."""

    cause: str  # In words
    # Rule over solver minus one, of a filament with this cause and nothing else of what the rule leaves out.
    error: float


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule of the field beside the solver's answer."""

    key: str  # Short name, name and where it comes from
    name: str
    source: str
    quantity: str  # What it predicts, and in which unit
    unit: str
    predicted: float | None  # None where it does not apply
    solver: float  # The same of the run
    # Error against the solver without anything that the rule leaves out; None where that was not run.
    bare: float | None = None
    blames: tuple[Blame, ...] = ()  # Which effects make it fail, the strongest first
    text: str = ""  # Why it fails or does not apply, in a sentence

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

    def plot(self) -> Figure:
        """Draw the final shape, the descent and the rules beside it."""
        from softcat_sym.plotting.card import card_figure

        return card_figure(self)

    def _repr_html_(self) -> str:
        from softcat_sym.plotting.notebook import html

        return html(f"Card {self.name}, longest span {self.span_text or 'not asked'}\n{self.run!r}", self.plot())

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
            "message": self.run.summary.get("message") or "",
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


Floats = npt.NDArray[np.float64]

_STILL = 0.01


def descent_of(run: Trajectory) -> Descent | None:
    """Measure the descent of the midpoint; None if the run holds a single frame."""
    time, sag = run.data["time"].values, -run.data["midpoint"].values
    if len(time) < 2 or not np.all(np.isfinite(sag)):
        return None
    final = float(sag[-1])
    stretch = run.data["stretch"].values[-1]
    most = int(np.argmax(stretch))
    rise = turned_back(-sag)
    return Descent(
        final=final,
        largest=float(np.max(sag)),
        settled=_settled(time, sag),
        to_90=_first_at(time, sag, 0.9 * final) if final > 0 else None,
        rise=rise,
        damping="underdamped" if rise > TURNED_BACK else "overdamped",
        stretch=float(stretch[most]),
        stretch_at=float(run.data["X_cell"].values[most]) / run.scene.filament.span,
    )


def certificate_of(run: Trajectory, descent: Descent) -> Certificate:
    """Gather what says that it has stopped, or that it has not."""
    scene, data = run.scene, run.data
    sag = -data["midpoint"].values
    begin = min(len(sag) - 1, int((1 - ARREST_TIME) * (len(sag) - 1)))
    drift = float(np.ptp(sag[begin:]) / abs(descent.final)) if descent.final else 0.0
    limit, names = yield_stress_of(scene), tuple(run.summary["effects"])
    if limit is None:
        text = "no yield stress: only elasticity stops it" if not _flows(names) else "no yield stress: it never stops"
        return Certificate(None, None, None, None, None, None, None, drift, text)
    expected = expected_regime(scene, names)
    viscosity = effective_viscosity(scene)
    rate = float(np.max(data["plastic_rate"].values[begin:]))
    length = np.diff(data["X_node"].values)
    regime = str(run.summary.get("regime") or "")
    arrested = regime == "no-yield" or regime.startswith("arrested")
    found = Certificate(
        arrested=arrested,
        gravity_number=expected.gravity_number,
        first_yield=expected.first_yield,
        threshold=expected.arrest_exact,
        stress=largest_fibre_stress(run, -1) / limit,
        yielding=float(np.average(data["yielded_fraction"].values[-1], weights=length)),
        rate=rate * viscosity / limit if viscosity else None,
        drift=drift,
        text="",
    )
    return _worded(found, regime)


def _worded(found: Certificate, regime: str) -> Certificate:
    """The certificate in words."""
    if regime == "no-yield":
        return replace(found, text="no fibre ever yields: what it sags is elastic")
    rate = "" if found.rate is None else f"plastic rate {found.rate:.2g} sigma_Y/eta (limit {ARREST_RATE:g})"
    share = f"{100 * (found.yielding or 0.0):.2g} % still yields"
    if not regime:
        return replace(found, arrested=None, text=f"the run is not to be trusted; {rate}")
    return replace(found, text="; ".join(part for part in (rate, share) if part))


def _flows(names: tuple[str, ...]) -> bool:
    return "viscous-flow" in names


def _settled(time: Floats, sag: Floats) -> float | None:
    away = np.flatnonzero(np.abs(sag - sag[-1]) > _STILL * abs(sag[-1]))
    if away.size == 0:
        return float(time[0])
    first = int(away[-1]) + 1
    return float(time[first]) if time[first] <= time[0] + (1 - ARREST_TIME) * (time[-1] - time[0]) else None


def _first_at(time: Floats, sag: Floats, level: float) -> float:
    """When the sag first reaches a level, linear between frames."""
    after = int(np.argmax(sag >= level))
    if after == 0:
        return float(time[0])
    low, high = float(sag[after - 1]), float(sag[after])
    return float(time[after - 1] + (level - low) / (high - low) * (time[after] - time[after - 1]))


def largest_fibre_stress(run: Trajectory, frame: int | None = None) -> float:
    """Largest fibre stress of a frame, of the whole run by default [Pa].

    Of a section linear through the thickness it is |sigma_0| + |sigma_1|. A section that yields carries its
    yield stress and what flow adds to it, sigma_Y + K rate^n.
    """
    picked = slice(None) if frame is None else [frame]
    data, material = run.data.isel(time=picked), run.scene.material
    linear = np.abs(data["stress_mean"].values) + np.abs(data["stress_bending"].values)
    limit = yield_stress_of(run.scene)
    if limit is None or material.viscosity is None or "yielding" not in run.summary["effects"]:
        return float(np.max(linear))
    flowing = limit + material.viscosity * data["plastic_rate"].values ** material.index
    return float(np.max(np.where(data["yielded_fraction"].values > 0, flowing, np.minimum(linear, limit))))


def support_pull(run: Trajectory) -> float:
    """Force of the left support at the end over the area of the undeformed section [Pa]."""
    last = run.data.isel(time=-1, cell=0)
    along = last["axial_force"] if "axial_force" in last else last["tension"]
    return float(np.hypot(along, last["shear_force"])) / undeformed_area(run.scene)


SAG, FIBRE, SUPPORT = "final sag", "largest fibre stress", "pull of the support"

MEASURES: dict[str, Callable[[Trajectory], float]] = {
    SAG: lambda run: -float(run.data["midpoint"].values[-1]),
    FIBRE: largest_fibre_stress,
    SUPPORT: support_pull,
}
"""What the solver says, by quantity."""


Prediction = float | str
"""What a rule predicts, in SI; or, in words, why it does not apply."""


@dataclass(frozen=True, slots=True)
class RuleOfTheField:
    """A rule before it is applied."""

    key: str  # See :class:`softcat_sym.studies.card_rules.Rule`
    name: str
    source: str
    quantity: str
    predict: Callable[[Scene, Trajectory], Prediction]  # Of the scene and its run
    neglects: tuple[str, ...]  # Keys of causes that the rule leaves out
    ends: str = ""  # How it takes the ends to be held; empty for as they are, or for none of its business

    @property
    def unit(self) -> str:
        """Of what it predicts."""
        return "m" if self.quantity == SAG else "Pa"


def unusual(scene: Scene) -> str:
    """Why no rule of the field applies to the scene; empty where they do."""
    ends, filament = scene.ends, scene.filament
    held = {ends.left, ends.right}
    checks = (
        ("free" in held, "an end is free"),
        (ends.drop != 0 or bool(ends.motion), "the supports are not level, or move"),
        (ends.left_angle != 0 or ends.right_angle != 0, "a clamp is turned"),
        (bool(filament.profile), "its thickness varies"),
        (filament.curvature != 0, "it is curved by nature"),
        (filament.rest_length is not None, "it starts slack or stretched"),
        (scene.load.point_mass > 0, "a weight hangs at its middle"),
        (bool(scene.initial.P) or bool(scene.initial.C) or scene.initial.stretch != 1, "it starts stressed"),
        (scene.load.gravity == 0, "there is no gravity"),
        (scene.load.shake > 0, "it is shaken"),
    )
    return next((why for found, why in checks if found), "")


def _value(expression: object, scene: Scene, **more: float) -> float:
    filament = scene.filament
    known = {rho: filament.density, g: scene.load.gravity, L: filament.span, h0: filament.thickness}
    named = {"E": E, "eta": eta, "t": t, "K": K, "n": n}
    known |= {named[name]: value for name, value in more.items()}
    return float(expression.subs(known))  # type: ignore[attr-defined]


def _no_modulus(scene: Scene) -> str:
    return f"the law '{scene.material.law}' has no modulus"


def _no_viscosity(scene: Scene) -> str:
    return "a solid does not flow" if is_solid(scene) else "its flow rule has no viscosity"


def _viscosity(scene: Scene) -> float | None:
    """Of a law that has one [Pa s], or [Pa s^n]."""
    return None if is_solid(scene) or scene.material.law == "custom" else effective_viscosity(scene) or None


_NEVER_FLOWS = "no fibre yields, so that nothing flows"


def _rigid(scene: Scene, run: Trajectory) -> bool:
    """Whether a filament that could yield never did."""
    return yield_stress_of(scene) is not None and not bool((run.data["yielded_fraction"].values > 0).any())


def _elapsed(scene: Scene, run: Trajectory) -> float:
    """Time since the load came on, at half its ramp [s]."""
    return max(float(run.data["time"].values[-1]) - scene.load.ramp / 2, 0.0)


def _beam(beam: regimes.Beam) -> Callable[[Scene, Trajectory], Prediction]:
    def predict(scene: Scene, run: Trajectory) -> Prediction:
        del run
        modulus = static_modulus(scene)
        if modulus is None:
            return _no_modulus(scene)
        return _value(closed_forms.beam_sag(SECTIONS[scene.filament.section], beam), scene, E=modulus)

    return predict


def _cable(scene: Scene, run: Trajectory) -> Prediction:
    del run
    modulus = static_modulus(scene)
    return _no_modulus(scene) if modulus is None else _value(closed_forms.elastic_string_sag(), scene, E=modulus)


def _viscous_beam(scene: Scene, run: Trajectory) -> Prediction:
    viscosity = _viscosity(scene)
    if viscosity is None:
        return _no_viscosity(scene)
    if _rigid(scene, run):
        return _NEVER_FLOWS
    if scene.material.index != 1:
        return "its viscosity changes with the rate of flow"
    sag = closed_forms.viscous_beam_sag(SECTIONS[scene.filament.section], beam_of(scene))
    return _value(sag, scene, eta=viscosity, t=_elapsed(scene, run))


def _viscous_string(scene: Scene, run: Trajectory) -> Prediction:
    viscosity, time = _viscosity(scene), _elapsed(scene, run)
    if viscosity is None:
        return _no_viscosity(scene)
    if _rigid(scene, run):
        return _NEVER_FLOWS
    if scene.material.index != 1:
        constants = {"K": scene.material.viscosity or 0.0, "n": scene.material.index}
        return _value(closed_forms.power_law_string_sag(), scene, t=time, **constants)
    return _value(closed_forms.viscous_string_sag(), scene, eta=viscosity, t=time)


def _stopping(*, exact: bool) -> Callable[[Scene, Trajectory], Prediction]:
    def predict(scene: Scene, run: Trajectory) -> Prediction:
        gravity_number = gravity_number_of(scene)
        if gravity_number is None:
            return "no yield stress"
        expected = expected_regime(scene, tuple(run.summary["effects"]))
        depth = expected.stopping_depth_exact if exact else expected.stopping_depth_paper
        threshold = expected.arrest_exact if exact else expected.arrest_paper
        if gravity_number >= (threshold or 0.0):
            return f"G = {gravity_number:.3g} is above {threshold:.4g}: no catenary rests"
        if _rigid(scene, run):
            return _NEVER_FLOWS
        return (depth or 0.0) * scene.filament.span

    return predict


def _first_yield(scene: Scene, run: Trajectory) -> Prediction:
    del run
    if yield_stress_of(scene) is None:
        return "no yield stress"
    return _value(closed_forms.largest_bending_stress(SECTIONS[scene.filament.section], beam_of(scene)), scene)


def _catenary(*, exact: bool) -> Callable[[Scene, Trajectory], Prediction]:
    def predict(scene: Scene, run: Trajectory) -> Prediction:
        sag = MEASURES[SAG](run)
        if not sag > 0:
            return "it does not hang below its supports"
        if exact:
            return weight_stress(scene) * float(closed_forms.catenary_stress(sag / scene.filament.span))
        return float(_with_sag(regimes.SHALLOW_STRESS.right, sag, scene))

    return predict


def _with_sag(expression: object, sag: float, scene: Scene) -> float:
    return _value(expression.subs(regimes.H, sag), scene)  # type: ignore[attr-defined]


_BENT = ("ends", "flow", "stretching", "shear", "inertia", "surface")
_TAUT = ("flow", "bending", "slopes", "inertia", "surface")
_HUNG = ("bending", "elasticity", "inertia")
_CREEPS = ("yield stress", "stretching", "elasticity", "shear", "inertia", "surface")
_DRAWN = ("yield stress", "bending", "slopes", "surface")
_CARRIED = ("bending", "slopes", "inertia")

RULES: tuple[RuleOfTheField, ...] = (
    RuleOfTheField(
        "smay-pinned", "Smay 2002, pinned beam", "5 q L^4/(384 E I)", SAG, _beam(regimes.PINNED), _BENT, "pinned"
    ),
    RuleOfTheField("beam-clamped", "clamped beam", "q L^4/(384 E I)", SAG, _beam(regimes.CLAMPED), _BENT, "clamped"),
    RuleOfTheField("elastic-cable", "elastic cable", "(3 rho g L^4/(64 E))^(1/3)", SAG, _cable, _TAUT),
    RuleOfTheField("viscous-beam", "viscous beam", "Trouton 1906", SAG, _viscous_beam, _CREEPS),
    RuleOfTheField("viscous-string", "viscous string", "[2.20]", SAG, _viscous_string, _DRAWN),
    RuleOfTheField("stop-shallow", "catenary at yield", "[3.13]", SAG, _stopping(exact=False), _HUNG),
    RuleOfTheField("stop-exact", "catenary at yield, exact", "[3.12], exact", SAG, _stopping(exact=True), _HUNG),
    RuleOfTheField(
        "first-yield",
        "stress of the bent beam",
        "[3.11]",
        FIBRE,
        _first_yield,
        ("flow", "stretching", "shear", "inertia", "surface"),
    ),
    RuleOfTheField("catenary-stress", "catenary stress", "before [3.12]", SUPPORT, _catenary(exact=False), _CARRIED),
    RuleOfTheField(
        "catenary-stress-exact", "catenary stress, exact", "before [3.12]", SUPPORT, _catenary(exact=True), _CARRIED
    ),
)
"""In the order of the card."""


def smay_modulus_needed(scene: Scene) -> float:
    """G' [Pa] that Smay's criterion asks of the scene: a sag of 5 % of the diameter between pins."""
    return _value(closed_forms.smay_modulus(), scene)


_STIFFER = 100.0
_SAID = 2

_NEEDS = {"shear": "stretching"}
"""Causes that cannot be put back without another, which then counts for itself: a beam that shears also stretches."""

LEAVING_OUT: Mapping[str, tuple[str, ...]] = {
    # At rest without flow: a filament that can lose nothing would swing for ever.
    "flow": ("viscous-flow", "viscous-stress", "inertia"),
    "yield stress": ("yielding",),
    "stretching": ("extensibility",),
    "bending": ("bending",),
    "shear": ("shear",),
    "inertia": ("inertia",),
    "surface": ("surface-tension",),
    "slopes": ("large-rotation", "finite-stretch", "thinning"),
    "elasticity": (),
    "ends": (),
}
"""Effects that go, by cause; stiffness and ends are changed instead."""

WORDS: Mapping[str, str] = {
    "flow": "flow",
    "yield stress": "yield stress",
    "stretching": "tension",
    "bending": "bending",
    "shear": "shear",
    "inertia": "inertia",
    "surface": "surface tension",
    "slopes": "finite strain and slope",
    "elasticity": "elasticity",
    "ends": "hold of the ends",
}

Told = Callable[[str], None]


class Solver:
    """Runs of one filament with causes left out, each made once."""

    def __init__(self, run: Trajectory, told: Told | None = None) -> None:
        self._run, self._told = run, told
        self._names = tuple(run.summary["effects"])
        self._known: dict[tuple[frozenset[str], str], Trajectory | None] = {}

    def in_force(self, cause: str, ends: str) -> bool:
        """Whether there is something to leave out."""
        scene = self._run.scene
        if cause == "ends":
            return bool(ends) and {scene.ends.left, scene.ends.right} != {ends}
        if cause == "elasticity":
            return scene.material.youngs_modulus is not None
        return LEAVING_OUT[cause][0] in self._names

    def without(self, causes: frozenset[str], ends: str) -> Trajectory | None:
        """The run without them; None where it cannot be had or is not to be trusted."""
        key = (causes, ends if "ends" in causes else "")
        if key not in self._known:
            if self._told is not None:
                self._told(f"without {', '.join(sorted(WORDS[cause] for cause in causes))}")
            self._known[key] = self._variant(causes, ends)
        return self._known[key]

    def _variant(self, causes: frozenset[str], ends: str) -> Trajectory | None:
        try:
            run = recalled(without_estimate(self._changed(causes, ends)))
        except SoftcatError:
            return None
        return run if run.outcome.is_success else None

    def _changed(self, causes: frozenset[str], ends: str) -> Scene:
        gone = {effect for cause in causes for effect in LEAVING_OUT[cause]} & set(self._names)
        for effect in tuple(gone):
            gone |= set(dependants(effect, self._names))
        kept, changes = self._at_rest(set(self._names) - gone, gone)
        if "bending" in gone:
            # A beam that was run without tension has nothing else to hang by.
            kept.add("extensibility")
        scene = with_effects(self._run.scene, ordered(kept))
        if scene.numerics.cells is None:
            changes["numerics.cells"] = (self._run.summary.get("resolution") or {}).get("cells")
        if "ends" in causes:
            changes |= {"ends.left": ends, "ends.right": ends}
        if "elasticity" in causes:
            changes["material.youngs_modulus"] = f"{_STIFFER * (scene.material.youngs_modulus or 0.0)!r} Pa"
        return scene.replace(changes)

    def _at_rest(self, kept: set[str], gone: set[str]) -> tuple[set[str], dict[str, object]]:
        """A string without inertia has no shape before there is weight: it is loaded from the start, or slowly."""
        if "bending" not in gone or "inertia" in kept:
            return kept, {}
        if "viscous-flow" not in kept:
            return kept - {"gravity-ramp", "viscous-stress"}, {}
        scene = self._run.scene
        slow = max(scene.load.ramp, scene.run.duration / 2)
        return kept | {"inertia", "gravity-ramp"}, {"load.ramp": f"{slow!r} s"}


def blamed(rule: Rule, own: RuleOfTheField, solver: Solver) -> Rule:
    """Find what makes a rule fail, and say it.

    First the solver is run without anything that the rule leaves out: there they must agree. Then each effect is put
    back alone; what takes the two apart is to blame, and by how much is said.
    """
    if rule.error is None:
        return rule
    if rule.holds:
        return replace(rule, text="holds")
    neglected = [cause for cause in own.neglects if solver.in_force(cause, own.ends)]
    bare = _error(own, solver, frozenset(neglected))
    if bare is None:
        return replace(rule, text="cannot be told: without what it leaves out the filament has no answer")
    alone = {cause: _alone(own, solver, frozenset(neglected), cause, bare) for cause in neglected}
    known = [Blame(WORDS[cause], error) for cause, error in alone.items() if error is not None]
    apart = [one for one in known if abs(one.error) > HOLDS and abs(one.error - bare) > HOLDS * max(1.0, 1 + bare)]
    blames = tuple(sorted(apart, key=lambda one: -_off(one.error)))
    failed = [WORDS[cause] for cause, error in alone.items() if error is None]
    return replace(rule, bare=bare, blames=blames, text=_sentence(blames, failed, bare, rule.error))


def _alone(own: RuleOfTheField, solver: Solver, neglected: frozenset[str], cause: str, bare: float) -> float | None:
    """Error with one cause put back; of one that brings another along, its factor beyond that of the other."""
    needed = _NEEDS.get(cause)
    if needed not in neglected:
        return _error(own, solver, neglected - {cause})
    both, other = _error(own, solver, neglected - {cause, needed}), _error(own, solver, neglected - {needed})
    return None if both is None or other is None else (1 + both) / (1 + other) * (1 + bare) - 1


def _error(own: RuleOfTheField, solver: Solver, causes: frozenset[str]) -> float | None:
    """Rule over solver minus one, of the filament without some causes."""
    run = solver.without(causes, own.ends)
    if run is None:
        return None
    predicted = own.predict(run.scene, run)
    said = MEASURES[own.quantity](run)
    return None if isinstance(predicted, str) or not said > 0 else predicted / said - 1


def _off(error: float) -> float:
    """Size of an error, the same for a factor and for its reciprocal."""
    return abs(math.log1p(error)) if error > -1 else math.inf


def _sentence(blames: tuple[Blame, ...], failed: list[str], bare: float, error: float) -> str:
    """The strongest causes, each with what it does alone; said so where none alone does half of it."""
    said = [f"{one.cause} ({percent(one.error)})" for one in blames[:_SAID]]
    if not said:
        return "no single effect: several together" if not failed else f"perhaps {', '.join(failed)}: no answer with it"
    rest = f"; else {percent(bare)}" if abs(bare) > HOLDS else ""
    weak = "only together: " if len(said) + len(failed) > 1 and _off(blames[0].error) < _off(error) / 2 else ""
    return weak + ", ".join(said) + rest


def percent(error: float) -> str:
    """A relative error in words: ``+3.2 %``, or a factor where it is large."""
    if error >= 9:
        return f"× {1 + error:.0f}" if error < 9999 else f"× {1 + error:.1e}"
    return f"{100 * error:+.{1 if abs(error) < 0.0995 else 0}f} %".replace("-", "\N{MINUS SIGN}")
