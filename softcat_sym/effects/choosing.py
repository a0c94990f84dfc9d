"""Which effects are in force for a scene, and why."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import dataclass, replace

from softcat_sym.effects.bending import BENDING
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.effects.finite_stretch import FINITE_STRETCH
from softcat_sym.effects.gravity_ramp import GRAVITY_RAMP
from softcat_sym.effects.inertia import INERTIA
from softcat_sym.effects.large_rotation import LARGE_ROTATION
from softcat_sym.effects.law import law_in
from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.outrunning import outrunning_faults
from softcat_sym.effects.rotary_inertia import ROTARY_INERTIA
from softcat_sym.effects.shear import SHEAR
from softcat_sym.effects.thinning import THINNING
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.viscous_stress import VISCOUS_STRESS
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.equations.filament import Terms
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene

REGISTRY: tuple[Effect, ...] = (
    INERTIA,
    BENDING,
    FINITE_STRETCH,
    THINNING,
    LARGE_ROTATION,
    VISCOUS_FLOW,
    VISCOUS_STRESS,
    YIELDING,
    GRAVITY_RAMP,
    SHEAR,
    FIBRES,
    NECKING_GRADIENT,
    ROTARY_INERTIA,
)


@dataclass(frozen=True, slots=True)
class Effects:
    """The physics of one run.

    Attributes
    ----------
    in_force : tuple of Effect
        In the order of the registry.
    reasons : mapping of str to str
        Why each is in force.
    left_out : mapping of str to float
        Estimate of each effect that the scene has but the run does not.
    bare : Terms
        The filament of this material and shape without any effect.
    """

    in_force: tuple[Effect, ...]
    reasons: Mapping[str, str]
    left_out: Mapping[str, float]
    bare: Terms

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the effects in force."""
        return tuple(effect.name for effect in self.in_force)

    def terms(self) -> Terms:
        """The terms that these effects pick."""
        terms = self.bare
        for effect in self.in_force:
            terms = effect.contribute(terms)
        return terms

    def at_rest(self) -> Terms:
        """The terms of the same filament at rest under its whole weight: nothing that depends on a rate."""
        bare = Terms()
        return replace(
            self.terms(),
            inertia=False,
            rotary_inertia=False,
            viscous=False,
            gravity=bare.gravity,
            gravity_rate=bare.gravity_rate,
        )


def choose_effects(scene: Scene) -> Effects:
    """Choose the effects of a scene: those it names, the paper's list, or what its estimates call for.

    The printed closure belongs to the published theory: with it, ``auto`` is the paper's list.

    Raises
    ------
    SceneError
        If it names an effect that is unknown, that its law, load or closure cannot have, or that needs another one.
    """
    asked = scene.run.effects
    _refuse_law(scene)
    if isinstance(asked, str):
        published = asked == "paper" or scene.run.closure == "printed"
        why = {e.name: _why(e, scene, published=published) for e in REGISTRY if e.applies(scene)}
    else:
        _refuse(scene, (*asked, *_implied(scene, asked)))
        why = {effect.name: "named in run.effects" if effect.name in asked else "" for effect in REGISTRY}
    for name in _implied(scene, asked):
        why[name] = why[name] or "numerics.fibres or numerics.order asks for it"
    chosen = tuple(effect for effect in REGISTRY if why.get(effect.name))
    _refuse_closure(scene, chosen)
    reasons = {effect.name: f"{why[effect.name]}; {effect.estimate(scene)}" for effect in chosen}
    left_out = {e.name: e.estimate(scene).value for e in REGISTRY if e.applies(scene) and e not in chosen}
    _refuse_without_stress(scene, chosen)
    outrun = outrunning_faults(scene) if INERTIA in chosen else []
    if outrun:
        raise SceneError(outrun)
    return Effects(chosen, reasons, left_out, Terms(law=law_in(scene), curved=scene.filament.curvature != 0))


def _refuse_without_stress(scene: Scene, chosen: tuple[Effect, ...]) -> None:
    """A Newtonian fluid has no other stress than its viscous one."""
    if not law_in(scene).branches and VISCOUS_STRESS not in chosen:
        found = f"without {VISCOUS_STRESS.name!r}, but the law {scene.material.law!r} has no other stress"
        raise SceneError([Fault("run.effects", found, f"add {VISCOUS_STRESS.name!r}")])


def _why(effect: Effect, scene: Scene, *, published: bool) -> str:
    """Why an effect that applies is in force; empty if it is not."""
    if effect.in_paper:
        return "in the paper's list"
    called_for = not published and effect.called_for(scene, effect.estimate(scene).value)
    return "called for by its estimate" if called_for else ""


def _implied(scene: Scene, asked: str | tuple[str, ...]) -> tuple[str, ...]:
    """Effects that another key asks for: a number of fibres, or an order beyond the paper's, wants them resolved.

    Raises
    ------
    SceneError
        If they cannot be.
    """
    numerics = scene.numerics
    if numerics.fibres is None and (numerics.order or 0) <= 1:
        return ()
    if not FIBRES.applies(scene):
        key = "fibres" if numerics.fibres is not None else "order"
        found = f"{getattr(numerics, key)}, but {FIBRES.without_it}"
        raise SceneError([Fault(f"numerics.{key}", found, "leaving it out")])
    return () if FIBRES.name in asked else (FIBRES.name,)


def _refuse_closure(scene: Scene, chosen: tuple[Effect, ...]) -> None:
    """The printed closure is a plastic state linear through the thickness of a filament that does not shear."""
    beyond = [effect.name for effect in chosen if not effect.in_paper]
    if scene.run.closure == "printed" and beyond:
        found = f"'printed' with {', '.join(beyond)}"
        accepted = "'material', or the published effects without numerics.fibres and with numerics.order = 1"
        raise SceneError([Fault("run.closure", found, accepted)])


def _refuse_law(scene: Scene) -> None:
    """The small-deflection model has one plastic stretch for the whole filament, which only a linear law allows."""
    if scene.model == "small-deflection" and YIELDING.applies(scene):
        raise SceneError(
            [Fault("material.law", f"{scene.material.law!r} with model 'small-deflection'", "elastic or maxwell")]
        )


def _refuse(scene: Scene, asked: tuple[str, ...]) -> None:
    known = {effect.name: effect for effect in REGISTRY}
    faults: list[Fault] = []
    for name in asked:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f"did you mean {near[0]!r}? " if near else ""
            faults.append(Fault("run.effects", f"unknown effect {name!r}", f"{hint}one of {', '.join(known)}"))
            continue
        effect = known[name]
        if not effect.applies(scene):
            faults.append(Fault("run.effects", f"{name!r} cannot be had: {effect.without_it}", f"leave {name!r} out"))
        faults += [
            Fault("run.effects", f"{name!r} without {need!r}", f"add {need!r} or leave {name!r} out")
            for need in effect.needs
            if need not in asked
        ]
    if faults:
        raise SceneError(faults)
