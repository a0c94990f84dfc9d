"""The field's rules for a spanning filament: what each predicts, what it is compared with, and what it leaves out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.effects.law import is_solid
from softcat_sym.effects.prediction import (
    beam_of,
    effective_viscosity,
    gravity_number_of,
    static_modulus,
    weight_stress,
    yield_stress_of,
)
from softcat_sym.equations import regimes, spanning, strings
from softcat_sym.equations.laws.power_law import K, n
from softcat_sym.equations.section import SECTIONS
from softcat_sym.equations.symbols import E, L, eta, g, h0, rho, t
from softcat_sym.scene import Scene
from softcat_sym.study.card.descent import largest_fibre_stress, support_pull

if TYPE_CHECKING:
    from softcat_sym.trajectory import Trajectory

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
    """A rule before it is applied.

    Attributes
    ----------
    key, name, source, quantity : str
        See :class:`softcat_sym.study.card.contents.Rule`.
    predict : callable
        Of the scene and its run.
    neglects : tuple of str
        Keys of causes that the rule leaves out.
    ends : str
        How it takes the ends to be held; empty for as they are, or for none of its business.
    """

    key: str
    name: str
    source: str
    quantity: str
    predict: Callable[[Scene, Trajectory], Prediction]
    neglects: tuple[str, ...]
    ends: str = ""

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
        return _value(spanning.beam_sag(SECTIONS[scene.filament.section], beam), scene, E=modulus)

    return predict


def _cable(scene: Scene, run: Trajectory) -> Prediction:
    del run
    modulus = static_modulus(scene)
    return _no_modulus(scene) if modulus is None else _value(strings.elastic_string_sag(), scene, E=modulus)


def _viscous_beam(scene: Scene, run: Trajectory) -> Prediction:
    viscosity = _viscosity(scene)
    if viscosity is None:
        return _no_viscosity(scene)
    if _rigid(scene, run):
        return _NEVER_FLOWS
    if scene.material.index != 1:
        return "its viscosity changes with the rate of flow"
    sag = spanning.viscous_beam_sag(SECTIONS[scene.filament.section], beam_of(scene))
    return _value(sag, scene, eta=viscosity, t=_elapsed(scene, run))


def _viscous_string(scene: Scene, run: Trajectory) -> Prediction:
    viscosity, time = _viscosity(scene), _elapsed(scene, run)
    if viscosity is None:
        return _no_viscosity(scene)
    if _rigid(scene, run):
        return _NEVER_FLOWS
    if scene.material.index != 1:
        constants = {"K": scene.material.viscosity or 0.0, "n": scene.material.index}
        return _value(strings.power_law_string_sag(), scene, t=time, **constants)
    return _value(strings.viscous_string_sag(), scene, eta=viscosity, t=time)


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
    return _value(spanning.largest_bending_stress(SECTIONS[scene.filament.section], beam_of(scene)), scene)


def _catenary(*, exact: bool) -> Callable[[Scene, Trajectory], Prediction]:
    def predict(scene: Scene, run: Trajectory) -> Prediction:
        sag = MEASURES[SAG](run)
        if not sag > 0:
            return "it does not hang below its supports"
        if exact:
            return weight_stress(scene) * float(spanning.catenary_stress(sag / scene.filament.span))
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
    return _value(spanning.smay_modulus(), scene)
