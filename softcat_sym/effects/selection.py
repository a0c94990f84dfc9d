"""Choice of the effects in force for a scene, with reasons; refusal of invalid lists of effects."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from softcat_sym.effects.bending import BENDING
from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate
from softcat_sym.effects.extensibility import EXTENSIBILITY
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.effects.gravity_shaking import GRAVITY_SHAKING
from softcat_sym.effects.inertia import INERTIA
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.shear import SHEAR
from softcat_sym.effects.surface_tension import SURFACE_TENSION
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.errors import Fault, SceneError
from softcat_sym.estimates.forecast import expected_sag, forecast
from softcat_sym.estimates.scaling import law_in
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.natural_curve import is_curved
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import same_dimension, si_unit

Chosen = tuple[Effect, ...]


def _of_closure(scene: Scene, chosen: Chosen) -> Iterator[Fault]:
    """The printed closure, a plastic state linear through the thickness, has no effects beyond the paper."""
    beyond = [effect.name for effect in chosen if not effect.in_paper]
    if scene.run.closure == "printed" and beyond:
        key = _fibre_key(scene)
        requested = getattr(scene.numerics, key)
        found = f"'printed' with numerics.{key} = {requested}" if requested else f"'printed' with {', '.join(beyond)}"
        accepted = "'material', or the published effects without numerics.fibres and with numerics.order = 1"
        yield Fault("run.closure", found, accepted)


def _of_chains(scene: Scene, chosen: Chosen) -> Iterator[Fault]:
    """Polymer chains need fibres in bending, as their stress is not linear through the thickness."""
    law = f"the law {scene.material.law!r}"
    if not scene.material.spec.has_chains:
        return
    if scene.run.closure == "printed":
        yield Fault("run.closure", f"'printed', which has no polymer chains, with {law}", "'material'")
    elif BENDING in chosen and FIBRES not in chosen:
        found = f"{BENDING.name!r} without {FIBRES.name!r}, but the stress of {law} is not linear through the thickness"
        accepted = f"'auto', or a list with {FIBRES.name!r} and what that needs, or one without {BENDING.name!r}"
        yield Fault("run.effects", found, accepted)


def _of_omissions(scene: Scene, chosen: Chosen) -> Iterator[Fault]:
    """A scene that leaves out indispensable effects: one fault for each reason."""
    left_out = dict[str, list[str]]()
    for effect in REGISTRY:
        if effect not in chosen and effect.applies(scene) and (why := effect.indispensable(scene)):
            left_out.setdefault(why, []).append(effect.name)
    for why, names in left_out.items():
        yield Fault("run.effects", f"without {_joined(names)}, but {why}", f"add {_joined(names)}")


def refuse_together(scene: Scene, chosen: Chosen) -> None:
    """Refuse effects that a scene cannot have together, or with which its filament is unstable."""
    unstable = (fault for effect in chosen for fault in effect.faults(scene))
    for kind in (_of_chains(scene, chosen), _of_closure(scene, chosen), _of_omissions(scene, chosen), unstable):
        if faults := list(kind):
            raise SceneError(faults)


def _fibre_key(scene: Scene) -> str:
    """Key of [numerics] that asks for fibres."""
    return "fibres" if scene.numerics.fibres is not None else "order"


def implied_extensibility(scene: Scene, requested: Collection[str]) -> dict[str, str]:
    """Why a list that does not name extensibility includes it anyway; empty if it does not."""
    name = EXTENSIBILITY.name
    if name in requested or not EXTENSIBILITY.applies(scene):
        return {}
    needed = EXTENSIBILITY.indispensable(scene)
    if needed or any(name in effect.needs for effect in REGISTRY if effect.name in requested):
        return {name: needed or "needed by effects that are named"}
    return {} if BENDING.name in requested else {name: "without bending nothing else carries the load"}


def refuse_tables(scene: Scene) -> None:
    """Refuse tables ``[effects.NAME]`` without such an effect, and missing, unknown or wrongly measured constants."""
    known = {effect.name: effect for effect in REGISTRY if effect.constants}
    faults = []
    for name, table in scene.effects:
        path = f"effects.{name}"
        if name not in known:
            accepted = f"an effect with constants: {', '.join(known)}" if known else "an effect that is registered"
            faults.append(Fault(path, "no effect of this name has constants", accepted))
            continue
        requested, given = {one.name: one for one in known[name].constants}, {one.name: one for one in table}
        accepted = ", ".join(f"{one.name} [{one.unit}]" for one in requested.values())
        faults += [
            Fault(f"{path}.{key}", "missing", f"{one.meaning} [{one.unit}]")
            for key, one in requested.items()
            if key not in given
        ]
        for key, one in given.items():
            if key not in requested:
                faults.append(Fault(f"{path}.{key}", f"{name!r} has no such constant", accepted))
            elif not same_dimension(one.dimension, requested[key].dimension):
                found = f"in {si_unit(one.dimension) or 'plain numbers'}"
                faults.append(Fault(f"{path}.{key}", found, f"a value in {requested[key].unit}"))
    if faults:
        raise SceneError(faults)


def why_not(effect: Effect, scene: Scene) -> str:
    """Why a scene cannot have an effect: the model if it excludes the effect, otherwise the law or the load."""
    if SMALL_MODEL not in effect.without_it:
        return effect.without_it
    small = scene.model == "small-deflection"
    return SMALL_MODEL if small else effect.without_it.removesuffix(f", or {SMALL_MODEL}")


def refuse(scene: Scene, requested: Iterable[str]) -> None:
    """Refuse names that are unknown, that the scene cannot have, or that need another effect: one fault each."""
    known, named = {effect.name: effect for effect in REGISTRY}, tuple(requested)
    whole = [name for name in ("auto", "paper") if name in named]
    if whole:
        # Needs of the other names are not checked, as the word may stand for them.
        accepted = f"{whole[0]!r} by itself, or a list of {', '.join(known)}"
        raise SceneError([Fault("run.effects", f"{whole[0]!r} within a list", accepted)])
    faults: list[Fault] = []
    for name in named:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f" (did you mean {near[0]!r}?)" if near else ""
            faults.append(Fault("run.effects", f"unknown effect {name!r}{hint}", f"one of {', '.join(known)}"))
        elif not known[name].applies(scene):
            found = f"{name!r} cannot be had: {why_not(known[name], scene)}"
            faults.append(Fault("run.effects", found, f"leave {name!r} out"))
        elif missing := _missing(scene, known[name], named, known):
            faults.append(_incomplete(scene, name, _joined(missing)))
    if faults:
        raise SceneError(faults)


def _missing(scene: Scene, effect: Effect, named: Collection[str], known: Mapping[str, Effect]) -> list[str]:
    """Unnamed effects that an effect needs, directly or not, and that the scene can have; in the registry's order."""
    found: set[str] = set()
    wanted = set(effect.needs)
    while wanted := wanted - {*named, *found}:
        found |= wanted
        wanted = {need for one in wanted for need in known[one].needs}
    # Extensibility is added automatically.
    able = {name for name in found if known[name].applies(scene)} - {EXTENSIBILITY.name}
    return [name for name in known if name in able]


def _joined(names: list[str]) -> str:
    *first, last = map(repr, names)
    return f"{', '.join(first)} and {last}" if first else last


def _incomplete(scene: Scene, name: str, missing: str) -> Fault:
    if name in scene.run.effects:
        return Fault("run.effects", f"{name!r} without {missing}", f"add {missing}, or leave {name!r} out")
    key = _fibre_key(scene)
    found = f"{getattr(scene.numerics, key)} resolves fibres, but without {missing}"
    return Fault(f"numerics.{key}", found, f"{missing} in run.effects too, or numerics.{key} left out")


SHARE = 1 / 3
"""Share of the requested accuracy above which an estimate calls for its effect: several omitted effects add up."""

BY_ESTIMATE = ""
"""Reason of an effect that is in force only because of its estimate."""


@dataclass(frozen=True, slots=True)
class Decision:
    """Decision about one effect."""

    effect: Effect  # The effect
    in_force: bool  # Whether the run includes it
    estimate: Estimate | None  # Expected change without it; None if the scene cannot have it
    reason: str  # Why it is in force or not; empty if the estimate decides

    @property
    def why(self) -> str:
        """Reason with the estimate: ``sag about 12 um; without it 61 um``."""
        if self.estimate is None or (self.reason and self.estimate.value == 0):
            return self.reason
        return f"{self.reason} ({self.estimate})" if self.reason else str(self.estimate)


@dataclass(frozen=True)
class Effects:
    """The physics of one run."""

    decisions: tuple[Decision, ...]  # One for every effect, in the order of the registry
    bare: Terms  # The filament of this material and shape without any effect
    scene: Scene  # The scene of the run

    @property
    def in_force(self) -> tuple[Effect, ...]:
        """The effects in force."""
        return tuple(decision.effect for decision in self.decisions if decision.in_force)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the effects in force."""
        return tuple(effect.name for effect in self.in_force)

    @property
    def reasons(self) -> dict[str, str]:
        """Reason of each effect in force, with its estimate."""
        return {decision.effect.name: decision.why for decision in self.decisions if decision.in_force}

    @property
    def left_out(self) -> dict[str, float]:
        """Estimate of each effect that the scene can have but the run does not include."""
        return {
            decision.effect.name: decision.estimate.value
            for decision in self.decisions
            if not decision.in_force and decision.estimate is not None
        }

    def terms(self) -> Terms:
        """The terms that these effects select."""
        return self._terms

    @cached_property
    def _terms(self) -> Terms:
        terms = self.bare
        for effect in self.in_force:
            terms = effect.added_to(terms, self.scene)
        return terms

    def at_rest(self) -> Terms:
        """The terms of the filament at rest under its whole weight, without those that depend on a rate."""
        found = self.terms()
        return replace(
            found,
            inertia=False,
            rotary_inertia=False,
            viscous=False,
            damped=False,
            ramped=False,
            shaken=False,
            drag="",
            added_mass=False,
            touches=tuple(replace(one, resists=False) for one in found.touches),
            densities=tuple(one.at_rest for one in found.densities),
        )


def choose_effects(scene: Scene, shown: Mapping[str, str] | None = None) -> Effects:
    """Choose the effects of a scene: those it names, the paper's list, or those that its estimates call for.

    The printed closure and the small-deflection model belong to the published theory: with them ``auto`` is the paper's
    list.
    """
    refuse_tables(scene)
    # Estimate of each effect that applies, by its name. For a material that changes in time, the largest of its
    # beginning, middle and end.
    stages, sag = [(one, forecast(one)) for one in scene.stages()], expected_sag(scene) * scene.filament.span
    estimates = {
        effect.name: max((effect.estimate(*stage) for stage in stages), key=lambda found: found.value).seen(sag)
        for effect in REGISTRY
        if effect.applies(scene)
    }
    reasons = _reasons(scene, estimates, shown or {})
    chosen = tuple(effect for effect in REGISTRY if effect.name in reasons)
    refuse_together(scene, chosen)
    decisions = tuple(_decision(effect, scene, estimates.get(effect.name), reasons) for effect in REGISTRY)
    return Effects(decisions, bare(scene), scene)


def bare(scene: Scene) -> Terms:
    """The filament of this material and shape without any effect; the small-deflection model has its own tension."""
    stretches = scene.model == "small-deflection"
    return Terms(law=law_in(scene), curved=is_curved(scene), stretches=stretches)


def _decision(effect: Effect, scene: Scene, estimate: Estimate | None, reasons: Mapping[str, str]) -> Decision:
    if estimate is None:
        return Decision(effect, False, None, f"cannot be had: {why_not(effect, scene)}")
    if effect.name in reasons:
        return Decision(effect, True, estimate, reasons[effect.name])
    if not isinstance(scene.run.effects, str):
        why = "not named in run.effects"
    elif _is_published(scene):
        why = "not in the paper's list"
    elif estimate.value <= SHARE * scene.run.accuracy:
        why = "worth less than a third of the requested accuracy"
    else:
        why = effect.saved(scene)
    return Decision(effect, False, estimate, why)


def _reasons(scene: Scene, estimates: Mapping[str, Estimate], shown: Mapping[str, str]) -> dict[str, str]:
    """Reasons of the effects in force, by name."""
    requested = scene.run.effects
    if not isinstance(requested, str):
        implied = _implied(scene, requested)
        implied |= implied_extensibility(scene, (*requested, *implied))
        refuse(scene, (*requested, *implied))
        return dict.fromkeys(requested, "named in run.effects") | implied
    if _is_published(scene):
        reasons = {e.name: "in the paper's list" for e in REGISTRY if e.in_paper and e.applies(scene)}
        if requested == "auto" and scene.run.closure != "printed":
            # The small-deflection model includes the pull of the surface as an additional tension.
            reasons |= _called_for(scene, estimates, (SURFACE_TENSION,))
        reasons |= {e.name: why for e in (GRAVITY_SHAKING,) if e.applies(scene) and (why := e.indispensable(scene))}
        return _implied(scene, reasons) | reasons
    return _completed(scene, _called_for(scene, estimates) | dict(shown) | _implied(scene, ()))


def _is_published(scene: Scene) -> bool:
    return scene.run.effects == "paper" or scene.run.closure == "printed" or scene.model == "small-deflection"


def _called_for(scene: Scene, estimates: Mapping[str, Estimate], among: Iterable[Effect] = REGISTRY) -> dict[str, str]:
    """Effects that ``auto`` chooses: indispensable ones, and those that their estimates call for; with reasons."""
    reasons = {}
    for effect in among:
        if effect.name not in estimates:
            continue
        needed = effect.indispensable(scene)
        if needed:
            reasons[effect.name] = needed
        elif not effect.saved(scene) and estimates[effect.name].value > SHARE * scene.run.accuracy:
            reasons[effect.name] = BY_ESTIMATE
    return reasons


def _completed(scene: Scene, reasons: dict[str, str]) -> dict[str, str]:
    """The effects, with those that speed up the run and those that other effects need; with reasons."""
    complete = dict(reasons)
    for effect in REGISTRY:
        # An effect that would add inertia does not speed up the run.
        dear = INERTIA.name in effect.needs and INERTIA.name not in complete
        if effect.name not in complete and not dear and effect.applies(scene) and (why := effect.eases(scene)):
            complete[effect.name] = why
    if BENDING.name in complete and scene.material.spec.has_chains:
        complete.setdefault(FIBRES.name, "the stress of polymer chains is not linear through the thickness")
    if FIBRES.name in complete and SHEAR.applies(scene):
        complete.setdefault(SHEAR.name, "fibres are resolved on sections that shear")
    for effect in reversed(REGISTRY):
        if effect.name in complete:
            for need in effect.needs:
                complete.setdefault(need, f"needed by {effect.name}")
    flow = complete.get(VISCOUS_FLOW.name, BY_ESTIMATE)
    if flow != BY_ESTIMATE and YIELDING.applies(scene):
        complete.setdefault(YIELDING.name, "the yield stress holds sections that do not flow")
    return complete


def _implied(scene: Scene, requested: Iterable[str]) -> dict[str, str]:
    """Effects that another key requires: numerics.fibres, or an order beyond the paper's, requires fibres."""
    numerics = scene.numerics
    if numerics.fibres is None and (numerics.order or 0) <= 1:
        return {}
    if not FIBRES.applies(scene):
        key = "fibres" if numerics.fibres is not None else "order"
        found = f"{getattr(numerics, key)}, but {why_not(FIBRES, scene)}"
        accepted = "leaving it out" if key == "fibres" else "1, or leaving it out"
        raise SceneError([Fault(f"numerics.{key}", found, accepted)])
    return {} if FIBRES.name in requested else {FIBRES.name: "asked for by numerics.fibres or numerics.order"}
