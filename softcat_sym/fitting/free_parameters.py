"""Free parameters of a scene and of its measurement: names, units, bounds, and scenes with other values of them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from numbers import Real
from typing import Any, TypeVar, cast

import numpy as np
from pydantic_core import PydanticCustomError

from softcat_sym.discretization.parameters import time_scale
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import Fault, SceneError
from softcat_sym.estimates.forecast import expected_sag
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.history import History, is_history, scaled
from softcat_sym.scene.laws import CONSTANTS, kind_of_constant
from softcat_sym.scene.material import FROM_SHEAR, Material, poisson_in_shear, tensile_name
from softcat_sym.scene.natural_curve import has_shape
from softcat_sym.scene.parts import LINE, Filament, Part, kinds_of
from softcat_sym.scene.scene import Scene, distance, is_slack, is_symmetric, known_keys, refuse_settled, rest_length
from softcat_sym.scene.tables import frozen_below
from softcat_sym.scene.temperature_table import Temperature
from softcat_sym.scene.thixotropy import Thixotropy
from softcat_sym.scene.units import (
    Kind,
    NotAQuantity,
    Number,
    Quantity,
    did_you_mean,
    refusal,
    same_dimension,
    shown,
    si_unit,
    to_si,
    to_si_of_any,
)

TIME_OFFSET, INITIAL_SAG = "time_offset", "initial_sag"
OF_CAMERA = (TIME_OFFSET, INITIAL_SAG)

_FACTOR, _ROUNDING = 1e3, 1e-12
_INDEX = (0.02, 5.0)
_POISSON = (-0.99, 0.495)
_ANGLE = 0.999 * math.pi
_ANY_SIGN = 10.0
_SIGNED = (("filament", "curvature"), ("ends", "drop"), ("ends", "left_angle"), ("ends", "right_angle"))
_OF_SHAPE = ("span", "rest_length", "curvature", "twist", "drop", "left_angle", "right_angle", "stretch")


@dataclass(frozen=True, slots=True)
class FreeParameter:
    """A number that may be free, unless there is some `trouble`; one unknown of a fit."""

    name: str  # Leaf name, as in tables and reports
    path: str  # Dotted path in the scene; the name itself for parameters of the measurement
    unit: str  # SI; ``"1"`` for a pure number
    typical: float  # Value in the scene; zero for parameters of the measurement
    logarithmic: bool  # Whether it is positive by nature: q = log(value/typical); otherwise q = value/scale
    scale: float  # Positive, SI
    bounds: tuple[float, float]  # Of the value, SI
    film: int | None = None  # Number of the only film that has it, from 1; None if all films share it
    limits: tuple[float, float] = (-math.inf, math.inf)  # The widest bounds that make sense; SI
    constant: str = ""  # The constant that it determines: the same for shear data and for the tensile constant
    trouble: str = ""  # Why it cannot be free in this scene, and what would help; empty if it can
    remedy: str = ""

    @property
    def of_measurement(self) -> bool:
        """Whether it is a parameter of the camera, not of the filament."""
        return self.path in OF_CAMERA

    @property
    def lower(self) -> float:
        """Lower bound of q."""
        return self.scaled(self.bounds[0])

    @property
    def upper(self) -> float:
        """Upper bound of q."""
        return self.scaled(self.bounds[1])

    def scaled(self, value: float) -> float:
        """Turn a value [SI] into q."""
        return math.log(value / self.typical) if self.logarithmic else value / self.scale

    def value(self, q: float) -> float:
        """Turn q into a value [SI]; infinite where it overflows."""
        if not self.logarithmic:
            return q * self.scale
        try:
            return self.typical * math.exp(q)
        except OverflowError:
            return math.inf

    def slope(self, q: float) -> float:
        """Return d value/dq [SI]."""
        return self.value(q) if self.logarithmic else self.scale

    def read(self, value: object) -> float:
        """Read a bound: a number in SI, or text with a unit."""
        if isinstance(value, (int, float, Real)) and not isinstance(value, bool):
            number = float(value)
            if not math.isfinite(number):
                raise refusal(f"{shown(value)} is not finite", "a finite number")
            return number
        is_pure = self.unit == "1"
        accepted = "a number without a unit" if is_pure else f"a number in {self.unit}, or text with a unit"
        if self.path.startswith("temperature."):
            # These units contain kelvin and mole.
            return float(kinds_of(Temperature)[self.name].read(value))
        try:
            if self.unit.count("^") and self.path.startswith("material."):
                # A consistency, whose dimension has no name.
                return to_si(value, "quantity", self.unit)
            number, dimension = to_si_of_any(value)
            if not same_dimension(dimension, to_si_of_any(1.0 if is_pure else f"1 {self.unit}")[1]):
                raise refusal(f"{shown(value)} is not in {'plain numbers' if is_pure else self.unit}", accepted)
        except NotAQuantity as found:
            raise refusal(str(found), accepted) from None
        return number

    def bounded(self, low: float, high: float) -> FreeParameter:
        """The parameter with other bounds; a refusal where they make no sense."""
        unit = self.unit
        if not low < high:
            raise refusal(f"{low:g} is not below {high:g} {unit}", "the lower one first")
        if self.logarithmic and low <= 0:
            raise refusal(f"{low:g} {unit}, but {self.name} is positive", "a lower bound above zero")
        least, most = self.limits
        if low < least * (1 - math.copysign(_ROUNDING, least)) or high > most * (1 + _ROUNDING):
            raise refusal(f"{low:g} to {high:g} {unit}", f"within {least:.6g} to {most:.6g} {unit}")
        if not low <= self.typical <= high and not self.of_measurement:
            found = f"{low:g} to {high:g} {unit} does not hold the scene's own {self.typical:g}"
            raise refusal(found, f"bounds around it, or another {self.path} in the scene")
        return replace(self, bounds=(low, high))


def candidates(scene: Scene) -> tuple[FreeParameter, ...]:
    """List every number of a scene, and of its measurement, that may be free."""
    of_scene = (*_of_material(scene), *_of_filament(scene), *_of_surroundings(scene), *_of_temperature(scene))
    # A given curve is sampled once: what it depends on cannot be free.
    curve = "filament.shape" if has_shape(scene) else "initial.centreline" if scene.initial.centreline else ""
    found, remedy = f"{curve} fixes the initial shape for all values", "a known one"
    fixed = (
        replace(one, trouble=found, remedy=remedy) if curve and one.name in _OF_SHAPE and not one.trouble else one
        for one in of_scene
    )
    return (*fixed, *_of_measurement(scene))


_ANY = (0.0, math.inf)


def _positive(
    path: str, unit: str, value: float, limits: tuple[float, float] = _ANY, constant: str = ""
) -> FreeParameter:
    name, low, constant = path.rpartition(".")[2], max(limits[0], 0.0), constant or path
    if value <= 0:
        found = "zero in the scene, so that its magnitude is unknown, and its physics is left out"
        unknown = FreeParameter(name, path, unit, value, True, 1.0, (0, 0), limits=limits, constant=path)
        return replace(unknown, trouble=found, remedy=f"a rough {path} in the scene")
    bounds = (max(value / _FACTOR, low), min(value * _FACTOR, limits[1]))
    return FreeParameter(name, path, unit, value, True, value, bounds, limits=limits, constant=constant)


def _signed(path: str, unit: str, value: float, scale: float, bounds: tuple[float, float]) -> FreeParameter:
    return FreeParameter(path.rpartition(".")[2], path, unit, value, False, scale, bounds, constant=path)


def _of_any_sign(path: str, unit: str, value: float) -> FreeParameter:
    """A number whose magnitude in the scene sets its scale and its bounds."""
    size = abs(value) or 1.0
    return _signed(path, unit, value, size, (-_ANY_SIGN * size, _ANY_SIGN * size))


def _of_history(path: str, unit: str, value: float) -> Iterator[FreeParameter]:
    """Values of a table, or quantities of a formula, counted from 1."""
    if isinstance(value, History):
        for number, (size, of) in enumerate(value.quantities(unit), start=1):
            yield _positive(f"{path}_{number}", of or "1", size)


def _of_law(material: Material) -> Iterator[FreeParameter]:
    for name in material.spec.constants:
        value = getattr(material, name)
        kind = kind_of_constant(name, material.law, material.index)
        path = f"material.{name}"
        limits = (max(kind.above, 0.0), kind.below) if isinstance(kind, Number) else _ANY
        yield _positive(path, _unit(kind), float(value), limits)
        given = {rule.shear: getattr(material, rule.shear) for rule in FROM_SHEAR if rule.constant == name}
        given = {shear: datum for shear, datum in given.items() if datum is not None} or {name: value}
        yield from (one for key, datum in given.items() for one in _of_history(f"material.{key}", _unit(kind), datum))
        for rule in FROM_SHEAR:
            if rule.constant == name and rule.suits(material.law):
                shear = getattr(material, rule.shear)
                factor = rule.factor(material.index, poisson_in_shear(material.law, material.poisson))
                begins = value / factor if shear is None else float(shear)
                yield _positive(f"material.{rule.shear}", _unit(kind), begins, constant=path)


def _of_material(scene: Scene) -> Iterator[FreeParameter]:
    material = scene.material
    yield from _of_law(material)
    if material.solid_viscosity is not None:
        yield _positive("material.solid_viscosity", "Pa*s", material.solid_viscosity)
    elif material.loss_modulus is None:
        yield _positive("material.loss_tangent", "1", material.loss_tangent)
    if material.spec.has_index:
        yield _positive("material.index", "1", material.index, _INDEX)
    if not material.spec.has_chains:
        yield replace(_signed("material.poisson", "1", material.poisson, 1.0, _POISSON), limits=_POISSON)
    for number, mode in enumerate(material.modes, start=1):
        for name, unit in (("youngs_modulus", "Pa"), ("viscosity", "Pa*s")):
            yield _positive(f"material.mode_{number}_{name}", unit, getattr(mode, name))
    for path, parameter in scene.named_constants().items():
        of = _positive if parameter.value > 0 else _of_any_sign
        yield of(path, si_unit(parameter.dimension) or "1", parameter.value)


def _of_filament(scene: Scene) -> Iterator[FreeParameter]:
    filament, slack = scene.filament, is_slack(scene)
    across = distance(scene)
    span = (filament.thickness * (1 + 1e-9), math.inf)
    if filament.rest_length is not None:
        # Beyond this span a taut filament would be slack, or a slack one taut, with an initial shape of another kind.
        edge = math.sqrt(max(0.0, filament.rest_length**2 - scene.ends.drop**2))
        span = (span[0], edge * (1 - 1e-9)) if slack else (max(span[0], edge), edge * math.e)
    yield _positive("filament.span", "m", filament.span, span)
    length = rest_length(scene)
    given = filament.rest_length is not None and not math.isclose(length, across, rel_tol=1e-9)
    limits = (across * (1 + 1e-9), 10 * across) if slack else (across / math.e, across * (1 - 1e-9))
    if given:
        yield _positive("filament.rest_length", "m", length, limits)
    else:
        found = "as long as the supports are apart: a longer filament hangs in its weight from the start, a shorter not"
        yield replace(
            _positive("filament.rest_length", "m", length, limits),
            trouble=found,
            remedy="a rough filament.rest_length in the scene, longer or shorter than that",
        )
    yield _positive("filament.thickness", "m", filament.thickness, (0.0, filament.span * (1 - 1e-9)))
    if filament.section == "rectangle" or filament.width != filament.thickness:
        yield _positive("filament.width", "m", filament.width)
    yield _positive("filament.density", "kg/m^3", filament.density)


def _of_surroundings(scene: Scene) -> Iterator[FreeParameter]:
    load = scene.load
    yield _positive("load.gravity", "m/s^2", load.gravity)
    yield _positive("load.ramp", "s", load.ramp)
    yield _positive("load.shake", "1", load.shake)
    yield _positive("load.shake_frequency", "Hz", load.shake_frequency)
    yield _positive("load.point_mass", "kg", load.point_mass)
    yield _positive("load.tip_mass", "kg", load.tip_mass)
    for name, stiffness in scene.ends.springs.items():
        yield _positive(f"ends.{name}", "N*m/rad" if "rotational" in name else "N/m", stiffness)
    yield _positive("surroundings.surface_tension", "N/m", scene.surroundings.surface_tension)
    for name, unit in (("density", "kg/m^3"), ("viscosity", "Pa*s")):
        bath = _positive(f"surroundings.{name}", unit, getattr(scene.surroundings, name))
        yield replace(bath, name=f"bath_{name}")
    yield _stretch(scene)
    for table, name in (*_SIGNED, *((("filament", "twist"),) if is_spatial(scene) else ())):
        value, path = float(getattr(getattr(scene, table), name)), f"{table}.{name}"
        turned = name.endswith("angle")
        if turned:
            one = _signed(path, "rad", value, 1.0, (-_ANGLE, _ANGLE))
        else:
            one = _of_any_sign(path, "m" if name == "drop" else "1/m", value)
        if value == 0:
            found, remedy = "zero in the scene, so that its physics is left out", f"a rough {path} in the scene"
            one = replace(one, trouble=found, remedy=remedy)
        elif turned and is_symmetric(scene):
            found = "only half of a symmetric filament is computed, whose clamps have equal angles"
            one = replace(one, trouble=found, remedy="clamps at different angles in the scene")
        yield one


_KELVIN = ("initial", "ambient", "outside", "reference", "T_0")


def _of_temperature(scene: Scene) -> Iterator[FreeParameter]:
    heat = scene.temperature
    if not heat.present:
        return
    for name, kind in kinds_of(type(heat)).items():
        value, path = getattr(heat, name), f"temperature.{name}"
        if value is None or not isinstance(kind, (Quantity, Number)):
            continue
        unit = _unit(kind)
        if name in _KELVIN or is_history(value):
            # Beyond these a law of the viscosity has no value.
            ends = name == "T_0" and frozen_below(scene) is None
            most = heat.extremes(scene.run.duration)[0] * (1 - 1e-9) if ends else math.inf
            bounds, number = (float(value) / 1.5, min(1.5 * float(value), most)), float(value)
            one = replace(_signed(path, unit, number, number / 10, bounds), limits=(0.0, most))
            if is_history(value):
                found, remedy = "a table of times in the scene, no number", f"one temperature as {path}"
                one = replace(one, trouble=found, remedy=remedy)
        else:
            one = (_positive if value >= 0 and name != "A" else _of_any_sign)(path, unit, value)
        yield one


def _stretch(scene: Scene) -> FreeParameter:
    stretch = scene.initial.stretch
    limits = (0.05, 20.0)
    if not scene.initial.relaxed:
        limits = (1 + 1e-9, math.e) if stretch > 1 else (0.05, 1 - 1e-9)
    plain = _positive("initial.stretch", "1", stretch, limits)
    if scene.filament.rest_length is not None:
        found, remedy = "filament.rest_length is given, and determines the length", "rest_length"
    elif stretch == 1:
        found, remedy = "1 in the scene: neither stretched nor slack", "a rough initial.stretch in the scene"
    else:
        return plain
    return replace(plain, trouble=found, remedy=remedy)


def _of_measurement(scene: Scene) -> Iterator[FreeParameter]:
    unit = time_scale(scene)
    span, duration = scene.filament.span, scene.run.duration
    sag = max(expected_sag(scene) * span, 1e-6 * span)
    yield _signed(TIME_OFFSET, "s", 0.0, unit, (-duration, duration))
    yield _signed(INITIAL_SAG, "m", 0.0, sag, (-span, span))


def why_not_free(scene: Scene, name: str, known: Mapping[str, FreeParameter]) -> Fault:
    """Say why a name cannot be free: no such constant of the law, no number, or no such name."""
    where, leaf = f"free {name}", name.rpartition(".")[2]
    law, usable = scene.material.law, ", ".join(dict.fromkeys(one.name for one in known.values() if not one.trouble))
    if (tensile_name(leaf) or leaf) in (*CONSTANTS, "index") and name in (leaf, f"material.{leaf}"):
        # The name that the shear datum has for this law.
        other = next(iter({rule.shear for rule in FROM_SHEAR if rule.constant == tensile_name(leaf)} & set(known)), "")
        hint = f" (did you mean '{other}'?)" if other else ""
        return Fault(where, f"the law '{law}' has no {leaf}{hint}", usable)
    tables = [table for table, keys in known_keys().items() if leaf in keys and name in (leaf, f"{table}.{leaf}")]
    if tables and tables != ["groups"]:
        return Fault(where, "not a number that the motion of a filament depends on", usable)
    return Fault(where, f"unknown{did_you_mean(leaf, [one.name for one in known.values()])}", usable)


def _unit(kind: Kind) -> str:
    return kind.unit or "1"


Bounds = Mapping[str, tuple[object, object]]


def free_parameters(scene: Scene, names: Sequence[str], bounds: Bounds | None = None) -> tuple[FreeParameter, ...]:
    """Find the free parameters of a scene by their names."""
    refuse_settled(scene, "the filament is compared at the times of its measurements")
    found, faults = _found(scene, names)
    bounds = bounds or {}
    known = {key for one in found for key in (one.name, one.path)}
    accepted = ", ".join(one.name for one in found) or "names that are free"
    faults += [Fault(f"bounds of {name}", "not free", accepted) for name in bounds if name not in known]
    for number, one in enumerate(found):
        pair = bounds.get(one.name, bounds.get(one.path))
        if pair is None:
            continue
        try:
            low, high = (one.read(bound) for bound in pair)
            found[number] = one.bounded(low, high)
        except PydanticCustomError as error:
            context = error.context or {}
            faults.append(Fault(f"bounds of {one.name}", str(context["found"]), str(context["accepted"])))
    if faults:
        raise SceneError(faults)
    return tuple(found)


def _found(scene: Scene, names: Sequence[str]) -> tuple[list[FreeParameter], list[Fault]]:
    """Parameters with these names, and a fault for every name without one."""
    known = candidates(scene)
    by_name = {one.name: one for one in known} | {one.path: one for one in known}
    found: list[FreeParameter] = []
    faults: list[Fault] = []
    if not names:
        faults.append(Fault("free", "nothing is free", "one name or more, such as youngs_modulus"))
    for name in names:
        one = by_name.get(name)
        if one is None:
            faults.append(why_not_free(scene, name, by_name))
            continue
        same = next((other for other in found if other.path == one.path or other.constant == one.constant), None)
        if one.trouble:
            faults.append(Fault(f"free {name}", one.trouble, one.remedy))
        elif same is not None:
            clash = "named twice" if same.path == one.path else f"the same constant as {same.name}"
            faults.append(Fault(f"free {name}", clash, "each constant once"))
        else:
            found.append(one)
    return found, faults


class Unknowns:
    """Names, bounds and typical values of q."""

    free: tuple[FreeParameter, ...]  # The k unknowns

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the k unknowns."""
        return tuple(one.name for one in self.free)

    @property
    def lower(self) -> Floats:
        """Lower bounds of q, shape (k,)."""
        return np.array([one.lower for one in self.free])

    @property
    def upper(self) -> Floats:
        """Upper bounds of q, shape (k,)."""
        return np.array([one.upper for one in self.free])

    @property
    def typical(self) -> Floats:
        """The unknowns at the scene's own values, shape (k,)."""
        return np.array([one.scaled(one.typical) for one in self.free])


AnyPart = TypeVar("AnyPart", bound=Part)


def with_values(scene: Scene, free: Sequence[FreeParameter], values: Sequence[float]) -> Scene:
    """Return the scene with other values of its free parameters.

    Dependent values are derived again, as in :meth:`softcat_sym.Scene.replace`: a width that was not given is the
    thickness, tensile constants follow from shear data and the index. Parameters of the measurement are ignored.
    """
    tables: dict[str, dict[str, float]] = {}
    for one, value in zip(free, values, strict=True):
        if not one.of_measurement:
            table, _, key = one.path.partition(".")
            tables.setdefault(table, {})[key] = float(value)
    update: dict[str, object] = {}
    for table, changes in tables.items():
        if table == "material":
            update[table] = _material(scene.material, changes)
        elif table == "effects":
            update[table] = tuple(
                (name, tuple(replace(one, value=changes.get(f"{name}.{one.name}", one.value)) for one in constants))
                for name, constants in scene.effects
            )
        elif table == "filament":
            update[table] = _filament(scene.filament, changes)
        else:
            update[table] = getattr(scene, table).model_copy(update=changes)
    return scene.model_copy(update=update)


def _filament(filament: Filament, changes: dict[str, float]) -> Filament:
    follows = filament.section == "circle" or "width" not in filament.model_fields_set
    if "thickness" not in changes or "width" in changes or not follows:
        return filament.model_copy(update=changes)
    return _copied(filament, changes, {"width": changes["thickness"], **dict.fromkeys(("diameter", *LINE))})


_NUMBERED = re.compile(r"(.+)_(\d+)")


def _with_histories(material: Material, changes: dict[str, float]) -> dict[str, float]:
    """The changes with whole histories: a history is scaled to its new initial value, or single numbers change."""
    found = dict(changes)
    for key, value in changes.items():
        whole, numbered = getattr(material, key, None), _NUMBERED.fullmatch(key)
        if isinstance(whole, History):
            found[key] = whole.scaled(value / float(whole))
        elif numbered and isinstance(getattr(material, numbered[1], None), History):
            del found[key]
            here = found.get(numbered[1], getattr(material, numbered[1]))
            found[numbered[1]] = here.with_quantity(int(numbered[2]) - 1, value)
    return found


def _material(material: Material, changes: dict[str, float]) -> Material:
    changes = _with_histories(material, changes)
    given: dict[str, object] = {}
    follows = _following(material, changes)
    modes, parameters = list(material.modes), {one.name: one for one in material.parameters}
    for key, value in changes.items():
        if key.startswith("mode_"):
            _, number, name = key.split("_", 2)
            old = getattr(modes[int(number) - 1], name)
            changed = {name: scaled(old, value / float(old)) if isinstance(old, History) else value}
            modes[int(number) - 1] = replace(modes[int(number) - 1], **changed)
        elif key.startswith("parameters."):
            name = key.partition(".")[2]
            parameters[name] = replace(parameters[name], value=value)
        elif key.startswith("structure.") and material.structure is not None:
            whole = cast("Thixotropy", given.get("structure", material.structure))
            one: dict[str, Any] = {key.partition(".")[2]: value}
            given["structure"] = replace(whole, **one)
        else:
            given[key] = value
    if modes:
        given["modes"] = tuple(modes)
    if parameters:
        given["parameters"] = tuple(parameters.values())
    return _copied(material, given, follows)


def _following(material: Material, changes: dict[str, float]) -> dict[str, object]:
    """Values that follow from shear data and other constants when some values change."""
    follows: dict[str, object] = {}
    index = changes.get("index", material.index)
    poisson = poisson_in_shear(material.law, changes.get("poisson", material.poisson))
    for rule in FROM_SHEAR:
        if not rule.suits(material.law):
            continue
        others = {one.shear for one in FROM_SHEAR if one.constant == rule.constant} - {rule.shear}
        if rule.constant in changes or others & set(changes):
            # Otherwise the constant would be given twice.
            follows[rule.shear] = None
            continue
        shear = changes.get(rule.shear, getattr(material, rule.shear))
        if shear is not None:
            follows[rule.constant] = scaled(shear, rule.factor(index, poisson))
    if material.loss_modulus is not None:
        modulus = follows.get("youngs_modulus") or changes.get("youngs_modulus", material.youngs_modulus)
        follows["loss_tangent"] = material.loss_modulus * 2 * (1 + poisson) / cast("float", modulus)
    return follows


def _copied(part: AnyPart, given: Mapping[str, object], follows: Mapping[str, object]) -> AnyPart:
    """A copy with some given values, and with others that follow from them."""
    result = part.model_copy(update={**given, **follows})
    # Derived values do not count as given, so that they are derived again after further changes.
    result.model_fields_set.difference_update(follows)
    return result
