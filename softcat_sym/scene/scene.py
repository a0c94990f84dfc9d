"""The scene: all that is asked, in plain SI values, whether its parts go together, and its dimensionless groups."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from pydantic import ModelWrapValidatorHandler, ValidationInfo, model_validator
from pydantic_core import ValidationError

from softcat_sym.drawing import html
from softcat_sym.errors import Fault, SceneError
from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.dimensions import dimension_rules, is_spatial
from softcat_sym.scene.ends import Hold, Support, end_rules
from softcat_sym.scene.feed import exit_angle, extrusion_rules, laid_at, laid_length
from softcat_sym.scene.groups import GroupBlock, resolve_groups
from softcat_sym.scene.laws import LAWS
from softcat_sym.scene.material import NamedConstant, power
from softcat_sym.scene.natural_curve import has_shape, natural_curve, shape_rules
from softcat_sym.scene.parts import DOWN, Numerics, Part, Rule, dotted, if_given, kinds_of
from softcat_sym.scene.tables import (
    Tables,
    bodies_of,
    body_rules,
    farthest,
    frozen_note,
    motion_rules,
    temperature_rules,
)
from softcat_sym.scene.toml import Override, apply, toml_of, toml_value
from softcat_sym.scene.units import fault_of, in_si, shown

# Most scenes do without SciPy, which takes a while to load.
with lazy_imports():
    from scipy import special

_ROUNDING = 1e-12


def distance(scene: Scene) -> float:
    """Return the straight distance between the supports at the start [m]."""
    return math.hypot(scene.filament.span, scene.ends.drop)


def rest_length(scene: Scene) -> float:
    """Return the length of the reference configuration, to which the undeformed section belongs [m].

    As given, or the distance over the initial stretch, or that of its natural shape.
    """
    if has_shape(scene):
        return natural_curve(scene).length
    if scene.extrusion.present:
        return laid_length(scene)
    given = scene.filament.rest_length
    return distance(scene) / (scene.initial.stretch * surface_stretch(scene)) if given is None else given


def stress_free_length(scene: Scene) -> float:
    """Return the length at which the filament starts without axial force [m], longer by a relaxed initial stretch."""
    return rest_length(scene) * force_free_stretch(scene)


def force_free_stretch(scene: Scene) -> float:
    """Return the stretch at which the filament starts without axial force."""
    return (scene.initial.stretch if scene.initial.relaxed else 1.0) * surface_stretch(scene)


def surface_stretch(scene: Scene) -> float:
    """Return the stretch at which a solid balances a surface that was always there; 1 for one that acts at once.

    E log(s)/s + Gam s^-1/2 = 0, of a sheet E/(1 - nu^2) log(s)/s + Gam = 0.
    """
    filament, material = scene.filament, scene.material
    if scene.initial.surface == "fresh" or not material.spec.is_solid or material.youngs_modulus is None:
        return 1.0
    pull = scene.surroundings.surface_tension / material.youngs_modulus
    if filament.section == "sheet":
        return math.exp(-special.lambertw(2 * pull / filament.thickness * (1 - material.poisson**2)).real)
    return math.exp(-2 * special.lambertw(pull * (1 / filament.thickness + 1 / filament.width) / 2).real)


def is_held(scene: Scene) -> bool:
    """Tell whether neither end is free."""
    return not any(support.is_free for support in scene.ends.supports)


def carries_moment(scene: Scene) -> bool:
    """Tell whether an end resists a turn of its section."""
    return any(support.carries_moment for support in scene.ends.supports)


def loaded_from(scene: Scene) -> float:
    """Time from which neither the load nor a support changes [s]."""
    laid = laid_at(scene) if scene.extrusion.present else 0.0
    return float(max(scene.load.ramp, laid, *(row[0] for row in ((0.0,), *scene.ends.motion, *scene.ends.right_twist))))


def is_slack(scene: Scene) -> bool:
    """Tell whether both ends are held and the filament is longer without stress than they are apart.

    One that begins on a given curve, in its natural shape, or in a nozzle need not hang in its weight.
    """
    hangs = is_held(scene) and not (scene.initial.centreline or has_shape(scene) or scene.extrusion.present)
    return hangs and stress_free_length(scene) > distance(scene) * (1 + _ROUNDING)


def is_symmetric(scene: Scene) -> bool:
    """Tell whether left and right mirror each other at all times; in three dimensions the whole span is followed."""
    ends, heated = scene.ends, scene.temperature.heated
    mirrored = math.isclose(ends.left_angle, -ends.right_angle, rel_tol=_ROUNDING, abs_tol=_ROUNDING)
    along = (scene.filament.profile, scene.initial.P, scene.initial.C)
    return (
        len(set(ends.supports)) == 1
        and not is_spatial(scene)
        and is_held(scene)
        and not any(support.has_springs for support in ends.supports)  # The stiffness of one may be varied alone
        and mirrored
        and ends.drop == 0
        and not (ends.motion or scene.extrusion.present)
        and not any(body.speed_along for body in bodies_of(scene))
        and (not heated or math.isclose(sum(heated), rest_length(scene), rel_tol=_ROUNDING))
        and all(values == values[::-1] for values in along)
    )


def chord_angle(scene: Scene) -> float:
    """Return the angle of the line from the left support to the right one, of a laid strand to its nozzle [rad]."""
    if scene.extrusion.present:
        return exit_angle(scene)
    return math.atan2(-scene.ends.drop, scene.filament.span) + 0.0  # level is 0, not -0


def straight_angle(scene: Scene) -> float:
    """Return the angle of the straight filament: of its chord, or of its only support, which a pin has level [rad]."""
    if is_held(scene) or scene.extrusion.present:
        return chord_angle(scene)
    ((_, support, angle),) = (side for side in scene.ends.sides if not side[1].is_free)
    return angle if support.carries_moment else 0.0


def is_turned(scene: Scene) -> bool:
    """Tell whether an end that resists a turn is turned against the line between the supports."""
    along = chord_angle(scene)
    return any(
        one.carries_moment and not math.isclose(angle, along, abs_tol=1e-12) for _, one, angle in _clampable(scene)
    )


def _clampable(scene: Scene) -> tuple[tuple[str, Support, float], ...]:
    """Sides whose angle the table [ends] says: a nozzle has its own."""
    return scene.ends.sides[:1] if scene.extrusion.present else scene.ends.sides


def undeformed_area(scene: Scene) -> float:
    """Return A0 [m^2] where the relative thickness is 1."""
    return scene.filament.area


# Beyond, the two supports are one point.
_LONGEST = 1000
_ANGLE_ROUNDING = 1e-9


def faults_between_parts(scene: Scene) -> list[Fault]:
    """List everything that does not go together."""
    if faults := [Fault(*words) for broken, *words in shape_rules(scene) if broken]:
        return faults  # Without a shape it has no length
    if faults := [Fault(*words) for broken, *words in extrusion_rules(scene) if broken]:
        return faults  # Nor without a feed
    checks = (motion_rules, _of_lengths, _of_slack, _of_initial_state, _of_surface, temperature_rules)
    others = (_of_newtonian, _of_small_deflection, _of_load_and_loss, dimension_rules, body_rules)
    rules = (*end_rules(scene.ends), *(rule for check in (*checks, *others) for rule in check(scene)))
    of_histories = (Fault(*words) for words in scene.material.faults_of_histories(scene.run.duration))
    return [*(Fault(*words) for broken, *words in rules if broken), *of_histories]


def refuse_settled(scene: Scene, why: str) -> None:
    """Refuse a run that ends when it has settled, where several answers are compared at the same times."""
    if scene.run.until == "settled":
        raise SceneError([Fault("run.until", f"'settled', but {why}", "duration")])


def _of_load_and_loss(scene: Scene) -> Iterator[Rule]:
    """What is shaken does not rest; a loss below yield is a stress that only the filament's material closure has."""
    load, material, numerics = scene.load, scene.material, scene.numerics
    shakes, turns, out = load.shake > 0, load.shake_frequency > 0, "leaving it out"
    found = f"'settled', but load.shake is {load.shake:g}: what is shaken does not come to rest"
    yield shakes and scene.run.until == "settled", "run.until", found, "duration"
    found = f"zero or missing, but load.shake is {load.shake:g}"
    yield shakes and not turns, "load.shake_frequency", found, 'a frequency, such as "5 Hz", or no load.shake'
    found = f"zero or missing, but load.shake_frequency is {load.shake_frequency:g} Hz"
    yield turns and not shakes, "load.shake", found, "a number without a unit, such as 0.3, or no load.shake_frequency"
    if material.has_loss:
        given = (key for key in ("loss_modulus", "loss_tangent", "solid_viscosity") if getattr(material, key))
        path = f"material.{next(given)}"
        found, accepted = "given with model 'small-deflection'", f'{out}, or model = "filament"'
        yield scene.model == "small-deflection", path, found, accepted
        found = "given with run.closure = 'printed', whose section has no viscous stress beside its flow"
        yield scene.run.closure == "printed", path, found, f'{out}, or run.closure = "material"'
    for side, support, _ in scene.ends.sides:
        # The printed closure has no section angles, which a rotational spring turns.
        found = f"'printed', but a rotational spring holds the {side} end"
        yield scene.run.closure == "printed" and support.angle is Hold.SPRING, "run.closure", found, "material"
    found = f"{numerics.order}, but numerics.fibres is {numerics.fibres}: polynomials stand in the place of fibres"
    yield None not in (numerics.order, numerics.fibres), "numerics.order", found, "one of the two"


def _of_lengths(scene: Scene) -> Iterator[Rule]:
    """The force A0 E log(s)/s of a true-strain bar is greatest at s = e: beyond it no weight is carried stably."""
    length, reach = rest_length(scene), farthest(scene)
    limit = math.e * length * (1 + _ROUNDING)
    # By what stretches it: a motion if that is why, else the length, however it was given.
    path = "initial.stretch" if scene.filament.rest_length is None else "filament.rest_length"
    path = path if distance(scene) > limit else "ends.motion"
    found = (
        f"the supports are up to {reach:.4g} m apart, {reach / length:.4g} times the rest length {length:.4g} m: "
        "beyond what the filament can follow; an elastic filament of true strain is strongest at stretch e = 2.718"
    )
    held = all(support.holds_x and support.holds_height for support in scene.ends.supports)
    broken = scene.material.spec.is_solid and held and reach > limit
    yield broken, path, found, f"at most {math.e:.4g} times, {math.e * length:.4g} m"
    end = max(scene.temperature.heated, default=0.0) if scene.temperature.present else 0.0
    found = f"to {end:.4g} m, but the filament is {length:.4g} m long"
    yield end > length * (1 + 1e-9), "temperature.heated", found, f"places from 0 to {length:.4g} m"


def _of_slack(scene: Scene) -> Iterator[Rule]:
    if not is_slack(scene):
        return
    length, apart, load = rest_length(scene), distance(scene), scene.load
    found, accepted = f"{length:.4g} m, {length / apart:.4g} times the distance of the supports", f"at most {_LONGEST}"
    yield length > _LONGEST * apart, "filament.rest_length", found, f"{accepted} times, {_LONGEST * apart:.4g} m"
    slack = f"but the filament is slack ({length:.4g} m over {apart:.4g} m)"
    found = f"'newtonian', {slack}: a fluid has no shape to start from"
    yield not scene.material.spec.is_elastic, "material.law", found, "maxwell"
    found = f"{load.ramp:g} s, {slack}: a slack filament hangs in its weight from the start"
    yield load.ramp > 0, "load.ramp", found, "leaving it out"
    found = f"zero, {slack}: nothing tells what shape it has"
    yield load.gravity == 0, "load.gravity", found, "a positive acceleration"
    found = f"{list(load.direction)}, {slack}: it begins hanging straight down"
    yield load.direction != DOWN, "load.direction", found, "leaving it out"
    yield from if_given(scene, f"given, {slack}: it begins in its plane", "leaving it out", "filament.twist")
    yield from if_given(scene, f"given, {slack}", "leaving it out, or a taut filament", "initial.P", "initial.C")


def _of_initial_state(scene: Scene) -> Iterator[Rule]:
    initial, law, given = scene.initial, scene.material.law, scene.filament.rest_length
    spec = scene.material.spec
    found = f"true with a stretch, but the law '{law}' does not flow"
    broken, accepted = initial.relaxed and initial.stretch != 1, "false; or filament.rest_length instead of the stretch"
    yield spec.is_solid and broken, "initial.relaxed", found, accepted
    follows = distance(scene) / initial.stretch
    differs = given is not None and not math.isclose(given, follows, rel_tol=_ROUNDING)
    found, accepted = f"{initial.stretch:g}, but filament.rest_length is {given} m", f"one of the two, or {follows!r} m"
    yield differs and not initial.relaxed and initial.stretch != 1, "initial.stretch", found, accepted
    if spec.is_solid or not spec.flows:
        found = f"given, but the law '{law}' has no plastic strain"
        yield from if_given(scene, found, "leaving it out", "initial.P", "initial.C")


def _of_surface(scene: Scene) -> Iterator[Rule]:
    """A surface that was always there says by itself what stress the filament starts with."""
    if scene.initial.surface == "fresh":
        return
    initial, filament, law, path = scene.initial, scene.filament, scene.material.law, "initial.surface"
    relaxed, fresh = "'relaxed'", '"fresh"'
    bare = scene.surroundings.surface_tension == 0
    yield bare, path, f"{relaxed}, but there is no surface tension", f"{fresh}, or surroundings.surface_tension"
    for key, given in (
        ("initial.P", initial.P),
        ("initial.stretch", initial.stretch != 1),
        ("filament.rest_length", filament.rest_length is not None),
    ):
        yield given, path, f"{relaxed}, but {key} says too what stress there is", f"{fresh}, or no {key}"
    solid = scene.material.spec.is_solid
    found = f"{relaxed}, but a filament of the law '{law}' never rests under its surface: it has no yield stress"
    yield not solid and scene.material.threshold == 0, path, found, fresh
    found = f"{relaxed}, but an elastic filament with a profile has no one stretch at which its surface is balanced"
    yield solid and filament.profile, path, found, f"{fresh}, or no filament.profile"


def _of_newtonian(scene: Scene) -> Iterator[Rule]:
    if scene.material.spec.is_elastic:
        return
    no_shape, chord = "a newtonian filament has no elastic shape to start from", chord_angle(scene)
    accepted = "leaving it out, or the law 'maxwell'"
    yield from if_given(scene, f"given, but {no_shape}", accepted, "filament.curvature", "filament.twist")
    for side, support, angle in _clampable(scene):
        off = f"a clamp at {math.degrees(angle):.4g} deg off the line between the supports"
        found = f"{off}, at {math.degrees(chord):.4g} deg: {no_shape}"
        broken = is_held(scene) and support.carries_moment and abs(angle - chord) > _ANGLE_ROUNDING
        yield broken, f"ends.{side}_angle", found, f"\"{chord!r} rad\", a pinned end, or the law 'maxwell'"


def _of_small_deflection(scene: Scene) -> Iterator[Rule]:
    if scene.model != "small-deflection":
        return
    small, laws = "with model 'small-deflection'", [one.name for one in LAWS.values() if one.suits_small_deflections]
    law = scene.material.law
    yield law not in laws, "material.law", f"{law!r} {small}", " or ".join(laws)
    keys = [f"filament.{key}" for key in ("rest_length", "profile", "curvature")]
    keys += [f"ends.{key}" for key in ("drop", "left_angle", "right_angle", "motion")]
    keys += [f"initial.{key}" for key in ("stretch", "P", "C", "surface")]
    yield from if_given(scene, f"given {small}", 'leaving it out, or model = "filament"', *keys)
    sheet = scene.filament.section == "sheet"
    yield sheet, "filament.section", f"'sheet' {small}", "rectangle, circle"
    for side, support, _ in scene.ends.sides:
        yield support.has_springs or support.is_free, f"ends.{side}", f"{support.name!r} {small}", "clamped, pinned"


def why_interpreted(scene: Scene) -> str | None:
    """Why a model has no C; None where it has."""
    one_tension = "the tension of the small-deflection model is one number for all cells, not a row of sites"
    return one_tension if scene.model == "small-deflection" else None


LATE = "late overrides"


class Scene(Tables):
    """All that is asked of one run; frozen, every value plain SI.

    Build one with `load_scene`, from keywords, one a table of the scene file (``Scene(filament={"span": 0.2, ...},
    material={...}, run={...})``), or with `from_dict`. A quantity is a number in SI, text with a unit, or a pint
    quantity; ``Scene.model_validate`` reads tables as a scene file has them, whose quantities always have their units.

    Attributes
    ----------
    title : str
        Title for pictures and tables.
    model : str
        ``"filament"``.
    filament, material, ends, load, initial, surroundings, temperature, floor, pillars, run, numerics : Part
        The tables of the scene file, under the file's own names.

    Raises
    ------
    SceneError
        With every fault at once.
    """

    def __init__(self, **tables: Any) -> None:
        super().__init__(**_from_python(tables))

    # By this mark pydantic does not pass through `__init__` when it validates a scene file.
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    @classmethod
    def from_dict(cls, tables: Mapping[str, Any]) -> Scene:
        """Build a scene from nested dicts, its keys those of the scene file.

        Parameters
        ----------
        tables : mapping
            ``{"filament": {"span": 0.2, "thickness": "6 mm", ...}, "material": {...}, "run": {...}}``: a quantity is a
            number in SI, text with a unit, or a pint quantity.

        Raises
        ------
        SceneError
            With every fault at once.
        """
        return cls.model_validate(_from_python(tables))

    @model_validator(mode="wrap")
    @classmethod
    def _list_every_fault(cls, data: Any, handler: ModelWrapValidatorHandler[Scene], info: ValidationInfo) -> Scene:
        if isinstance(data, Scene):
            return data
        if not isinstance(data, Mapping):
            raise SceneError([Fault("", f"{shown(data)} is not a table", "a mapping of tables, as in a scene file")])
        parts = {key: value.given() if isinstance(value, Part) else value for key, value in data.items()}
        resolved = resolve_groups(
            {key: dict(part) if isinstance(part, Mapping) else part for key, part in parts.items()}
        )
        late: tuple[Override, ...] = (info.context or {}).get(LATE, ())
        faults = [*resolved.faults, *apply(late, resolved.table)]
        for required in ("filament", "material", "run"):
            # So that each missing key is named, and not only its table.
            resolved.table.setdefault(required, {})
        try:
            scene = handler(resolved.table)
        except ValidationError as error:
            found = [fault_of(one, known_keys(), _accepted()) for one in error.errors()]
            own = [fault for fault in found if not resolved.excuses(fault)]
            faults += own if own or faults else found
            raise SceneError(faults) from None
        faults += faults_between_parts(scene)
        if faults:
            raise SceneError(faults)
        return scene

    @property
    def notes(self) -> tuple[str, ...]:
        """What was converted from other names or data, in all tables."""
        return (*self.filament.notes, *self.material.notes, *filter(None, [frozen_note(self)]))

    def named_constants(self) -> dict[str, NamedConstant]:
        """Constants that only this scene has, by their paths: of its own law, and of effects from outside."""
        own = {f"material.parameters.{one.name}": one for one in self.material.parameters}
        if (structure := self.material.structure) is not None:
            own |= {f"material.structure.{name}": NamedConstant(name, *one) for name, one in structure.numbers.items()}
        if (modulus := self.material.hardening_modulus) is not None:
            own["material.hardening_modulus"] = NamedConstant("hardening_modulus", modulus, (1, -1, -2))
            own["material.hardening_recovery"] = NamedConstant(
                "hardening_recovery", self.material.hardening_recovery, (0, 0, 0)
            )
        return own | {f"effects.{effect}.{one.name}": one for effect, table in self.effects for one in table}

    def given(self) -> dict[str, object]:
        """Return the raw table as it was asked for, after `groups` were resolved."""
        table = super().given()
        for name in type(self).model_fields:
            part = getattr(self, name)
            if isinstance(part, Part):
                table[name] = part.given()
        return table

    def at(self, time: float) -> Scene:
        """The same scene of a material that is at all times as it is at this one [s]."""
        return self.model_copy(update={"material": self.material.at(time)}) if self.material.changes else self

    def stages(self) -> tuple[Scene, ...]:
        """Return the scene, and those of materials that stay as this one is halfway through the run and at its end.

        Nothing but the scene where the material does not change.
        """
        if not self.material.changes:
            return (self,)
        return self, *(self.at(share * self.run.duration) for share in (0.5, 1.0))

    def without_numerics(self) -> Scene:
        """The same scene at the program's own resolution: what does not depend on it is computed once."""
        return self.model_copy(update={"numerics": Numerics()})

    def replace(self, changes: Mapping[str, object]) -> Scene:
        """Return a scene with some values changed, validated anew.

        Parameters
        ----------
        changes : mapping of str to object
            ``{"numerics.cells": 40, "material.yield_stress": "5 kPa"}``; None takes a key out.

        Returns
        -------
        Scene
            What follows from a changed value (a width that was not given, say) follows again.

        Raises
        ------
        SceneError
            With every fault at once.
        """
        table = self.given()
        faults = [
            Fault(path, "a resolved scene has no groups", "load_scene(name, overrides), or physical values")
            for path in changes
            if path.split(".")[0] == "groups"
        ]
        faults += apply([Override(path, value) for path, value in changes.items()], table)
        if faults:
            raise SceneError(faults)
        return Scene.model_validate(table)

    def differences(self, other: Scene) -> dict[str, tuple[str, str]]:
        """Values of this scene and of another one, as in a file, by the paths of those that differ."""
        found = dict[str, tuple[str, str]]()
        for table in parts_of_scene():
            one, two = getattr(self, table), getattr(other, table)
            kinds, values = one.kinds(), two.physics()
            for name, value in one.physics().items():
                if value != values[name] and name in kinds:
                    pair = (value, values[name])
                    before, now = ("none" if each is None else toml_value(kinds[name].write(each)) for each in pair)
                    found[f"{table}.{name}"] = (before, now)
        return found

    def _repr_html_(self) -> str:
        return html(self.to_toml())

    def to_toml(self) -> str:
        """Write the scene as TOML in physical form with units; reading it again gives an equal scene."""
        return toml_of(self)


def _from_python(tables: Any) -> Any:
    """Mark the bare numbers that stand for quantities as SI; of `material.parameters` they are pure numbers."""
    if not isinstance(tables, Mapping):
        return tables
    marked = dict(tables)
    for name, part in parts_of_scene().items():
        table = tables.get(name)
        if isinstance(table, Mapping):
            kinds = kinds_of(part)
            marked[name] = {
                key: in_si(value) if key in kinds and kinds[key].si else value for key, value in table.items()
            }
    return marked


@cache
def known_keys() -> dict[str, tuple[str, ...]]:
    """Return the keys of every table; ``""`` is the file itself."""
    tables = {"": (*Scene.model_fields, "groups")} | {
        name: tuple(part.model_fields) for name, part in parts_of_scene().items()
    }
    # Last, so that a misplaced key is sent to its physical table first.
    return tables | {"groups": tuple(GroupBlock.model_fields)}


@cache
def _accepted() -> dict[str, str]:
    parts: dict[str, type[Part]] = {"": Scene, **parts_of_scene()}
    kinds = ((table, name, kind) for table, part in parts.items() for name, kind in kinds_of(part).items())
    return {dotted(table, name): kind.accepted for table, name, kind in kinds}


def parts_of_scene() -> dict[str, type[Part]]:
    """Return the tables of the scene file by name, but for ``groups``."""
    annotations = {name: info.annotation for name, info in Scene.model_fields.items()}
    return {name: part for name, part in annotations.items() if isinstance(part, type) and issubclass(part, Part)}


@dataclass(frozen=True, slots=True)
class Groups:
    """Dimensionless groups of a scene; None where the law has no such constant."""

    delta: float  # Thickness over span
    E_star: float | None  # E/(rho g L)
    G: float | None  # rho g L/sY [3.10]; of a custom law with the stress below which nothing flows
    V: float | None  # eta/(rho sqrt(g L^3)) [3.10]; with an index K/(rho g L (L/g)^(n/2))
    eps_Y: float | None  # sY/E [3.9]
    tau_star: float | None  # V/E_star: relaxation time in units of sqrt(L/g), where the index is 1
    B: float | None  # 1/(2 V)


def gravity_time(scene: Scene) -> float:
    """Return sqrt(L/g)."""
    gravity = scene.load.gravity
    return math.sqrt(scene.filament.span / gravity) if gravity > 0 else math.inf


def elastic_time(scene: Scene) -> float:
    """Return L sqrt(rho/E)."""
    modulus = _modulus(scene)
    return scene.filament.span * math.sqrt(scene.filament.density / modulus) if modulus is not None else 0.0


def _modulus(scene: Scene) -> float | None:
    """E [Pa]; of parallel modes their sum, of a standard linear solid the spring that always acts."""
    modes = scene.material.modes
    return sum(mode.youngs_modulus for mode in modes) if modes else scene.material.youngs_modulus


def _viscosity(scene: Scene) -> float | None:
    """Eta [Pa s], or K [Pa s^n]; of parallel modes their sum, of polymer chains E lambda and the solvent's."""
    material = scene.material
    if material.spec.has_chains:
        return (material.youngs_modulus or 0.0) * (material.relaxation_time or 0.0) + (
            material.solvent_viscosity or 0.0
        )
    return sum(mode.viscosity for mode in material.modes) if material.modes else material.viscosity


def groups_of(scene: Scene) -> Groups:
    """Compute the dimensionless groups [3.9, 3.10]."""
    filament, material = scene.filament, scene.material
    modulus, viscosity, yields_at = _modulus(scene), _viscosity(scene), material.threshold or None
    gravity, n = scene.load.gravity, material.index
    stress = filament.density * gravity * filament.span
    # Scale of a viscosity, rho g L (L/g)^(n/2), written so that it has a limit without gravity.
    impulse = filament.density * math.sqrt(gravity * filament.span * filament.span * filament.span)
    if n != 1:
        impulse = stress * power(filament.span / gravity, n / 2) if gravity > 0 else 0.0
    slowness = None if viscosity is None or modulus is None else viscosity / modulus
    return Groups(
        delta=filament.thickness / filament.span,
        E_star=None if modulus is None else _ratio(modulus, stress),
        G=None if yields_at is None else stress / yields_at,
        V=None if viscosity is None else _ratio(viscosity, impulse),
        eps_Y=None if yields_at is None or modulus is None else yields_at / modulus,
        tau_star=None if slowness is None else _ratio(slowness, power(gravity_time(scene), material.index)),
        B=None if viscosity is None else impulse / (2 * viscosity),
    )


def _ratio(value: float, scale: float) -> float:
    return value / scale if scale > 0 else math.inf
