"""The numbers of a scene that a fit may free, and why the others may not be."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from numbers import Real

from softcat_sym.effects.forecast import expected_sag
from softcat_sym.effects.prediction import pull_of_surface
from softcat_sym.errors import Fault
from softcat_sym.graph.parameters import time_scale
from softcat_sym.scene import Scene, distance, is_slack, is_symmetric, rest_length
from softcat_sym.scene.faults import did_you_mean
from softcat_sym.scene.kinds import Kind, Quantity, refusal
from softcat_sym.scene.laws import CONSTANTS, kind_of_constant
from softcat_sym.scene.model import known_keys
from softcat_sym.scene.shear_data import FROM_SHEAR, INDEXED, tensile_name
from softcat_sym.scene.units import SI_UNITS, NotAQuantity, same_dimension, shown, si_unit, to_si, to_si_of_any

TIME_OFFSET, INITIAL_SAG = "time_offset", "initial_sag"

_FACTOR = 1e3
_INDEX = (0.02, 5.0)
_POISSON = (-0.99, 0.495)
_ANGLE = 0.999 * math.pi
_ANY_SIGN = 10.0
_LENGTHS = ("span", "thickness", "width", "rest_length")
_SIGNED = (("filament", "curvature"), ("ends", "drop"), ("ends", "left_angle"), ("ends", "right_angle"))


@dataclass(frozen=True)
class Candidate:
    """A number that may be free, or would be if it were not for the `trouble`.

    Attributes
    ----------
    name, path, unit : str
        Leaf, dotted path, SI unit.
    typical, scale : float
        SI.
    logarithmic : bool
        Whether it is positive by nature.
    bounds, limits : (float, float)
        By default, and the widest that make sense; SI.
    constant : str
        What it determines: shear data and the tensile constant that follows from them are the same.
    trouble, remedy : str
        Why it cannot be free in this scene, and what would help; empty if it can.
    """

    name: str
    path: str
    unit: str
    typical: float
    scale: float
    logarithmic: bool
    bounds: tuple[float, float]
    limits: tuple[float, float]
    constant: str = ""
    trouble: str = ""
    remedy: str = ""

    def read(self, value: object) -> float:
        """Read a bound: a number in SI, or text with a unit.

        Raises
        ------
        PydanticCustomError
            A `refusal`.
        """
        if isinstance(value, (int, float, Real)) and not isinstance(value, bool):
            number = float(value)
            if not math.isfinite(number):
                raise refusal(f"{shown(value)} is not finite", "a finite number")
            return number
        accepted = f"a number in {self.unit}, or text with a unit" if self.unit else "a number without a unit"
        try:
            if self.unit.count("^") and self.path.startswith("material."):
                # A consistency, whose dimension has no name.
                return to_si(value, "quantity", self.unit)
            number, dimension = to_si_of_any(value)
            if not same_dimension(dimension, to_si_of_any(f"1 {self.unit}" if self.unit else 1.0)[1]):
                raise refusal(f"{shown(value)} is not in {self.unit or 'plain numbers'}", accepted)
        except NotAQuantity as found:
            raise refusal(str(found), accepted) from None
        return number


def candidates(scene: Scene) -> tuple[Candidate, ...]:
    """List every number of a scene, and of its measurement, that may be free."""
    return (*_of_material(scene), *_of_filament(scene), *_of_surroundings(scene), *_of_measurement(scene))


def _positive(
    path: str, unit: str, value: float, limits: tuple[float, float] = (0.0, math.inf), constant: str = ""
) -> Candidate:
    name = path.rpartition(".")[2]
    low = limits[0] if limits[0] > 0 else 0.0
    if value <= 0:
        found = "zero in the scene, so that nothing says how large it may be, and its physics is left out"
        return Candidate(
            name, path, unit, value, 1.0, True, (0, 0), limits, path, found, f"a rough {path} in the scene"
        )
    bounds = (max(value / _FACTOR, low), min(value * _FACTOR, limits[1]))
    return Candidate(name, path, unit, value, value, True, bounds, limits, constant or path)


def _signed(path: str, unit: str, value: float, scale: float, bounds: tuple[float, float]) -> Candidate:
    name = path.rpartition(".")[2]
    return Candidate(name, path, unit, value, scale, False, bounds, (-math.inf, math.inf), path)


def _of_material(scene: Scene) -> Iterator[Candidate]:
    material = scene.material
    for name in CONSTANTS[material.law]:
        value = getattr(material, name)
        kind = kind_of_constant(name, material.law, material.index)
        path = f"material.{name}"
        yield _positive(path, _unit(kind), value)
        for rule in FROM_SHEAR:
            if rule.constant == name and rule.suits(material.law):
                shear = getattr(material, rule.shear)
                begins = value / rule.factor(material.index, material.poisson) if shear is None else shear
                yield _positive(f"material.{rule.shear}", _unit(kind), begins, constant=path)
    if material.solid_viscosity is not None:
        yield _positive("material.solid_viscosity", "Pa*s", material.solid_viscosity)
    if material.law in INDEXED:
        yield _positive("material.index", "", material.index, _INDEX)
    poisson = _signed("material.poisson", "", material.poisson, 1.0, _POISSON)
    yield Candidate(**{**vars(poisson), "limits": _POISSON})
    for number, mode in enumerate(material.modes, start=1):
        for name, unit in (("youngs_modulus", "Pa"), ("viscosity", "Pa*s")):
            one = _positive(f"material.mode_{number}_{name}", unit, getattr(mode, name))
            yield one
    for parameter in material.parameters:
        path, unit = f"material.parameters.{parameter.name}", si_unit(parameter.dimension)
        if parameter.value > 0:
            yield _positive(path, unit, parameter.value)
        else:
            size = abs(parameter.value) or 1.0
            yield _signed(path, unit, parameter.value, size, (-_ANY_SIGN * size, _ANY_SIGN * size))


def _of_filament(scene: Scene) -> Iterator[Candidate]:
    filament, slack = scene.filament, is_slack(scene)
    across = distance(scene)
    span = (filament.thickness * (1 + 1e-9), math.inf)
    if filament.rest_length is not None:
        # Beyond this the filament would be slack, or no longer so: it would begin in another way.
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
        remedy = "a rough filament.rest_length in the scene, longer or shorter than that"
        yield Candidate(
            "rest_length", "filament.rest_length", "m", length, length, True, (0, 0), limits, "", found, remedy
        )
    yield _positive("filament.thickness", "m", filament.thickness, (0.0, filament.span * (1 - 1e-9)))
    if filament.section == "rectangle" or filament.width != filament.thickness:
        yield _positive("filament.width", "m", filament.width)
    yield _positive("filament.density", "kg/m^3", filament.density)


def _of_surroundings(scene: Scene) -> Iterator[Candidate]:
    load = scene.load
    yield _positive("load.gravity", "m/s^2", load.gravity)
    yield _positive("load.ramp", "s", load.ramp)
    yield _positive("load.shake", "", load.shake)
    yield _positive("load.shake_frequency", "Hz", load.shake_frequency)
    yield _positive("load.point_mass", "kg", load.point_mass)
    yield _surface_tension(scene)
    yield _stretch(scene)
    for table, name in _SIGNED:
        value, path = float(getattr(getattr(scene, table), name)), f"{table}.{name}"
        turned = name.endswith("angle")
        unit = "rad" if turned else "m" if name == "drop" else "1/m"
        size = abs(value) or 1.0
        bounds = (-_ANGLE, _ANGLE) if turned else (-_ANY_SIGN * size, _ANY_SIGN * size)
        plain = _signed(path, unit, value, 1.0 if turned else size, bounds)
        if value == 0:
            found, remedy = "zero in the scene, so that its physics is left out", f"a rough {path} in the scene"
            yield Candidate(**{**vars(plain), "trouble": found, "remedy": remedy})
        elif turned and is_symmetric(scene):
            found = "half of a symmetric filament is computed, whose clamps turn alike"
            yield Candidate(**{**vars(plain), "trouble": found, "remedy": "clamps at different angles in the scene"})
        else:
            yield plain


def _surface_tension(scene: Scene) -> Candidate:
    plain = _positive("surroundings.surface_tension", "N/m", scene.surroundings.surface_tension)
    if plain.trouble or pull_of_surface(scene) > 0:
        return plain
    found, remedy = "left out by run.effects or run.closure", "surface-tension in run.effects, and the material closure"
    return Candidate(**{**vars(plain), "trouble": found, "remedy": remedy})


def _stretch(scene: Scene) -> Candidate:
    stretch = scene.initial.stretch
    limits = (0.05, 20.0)
    if not scene.initial.relaxed:
        limits = (1 + 1e-9, math.e) if stretch > 1 else (0.05, 1 - 1e-9)
    plain = _positive("initial.stretch", "", stretch, limits)
    if scene.filament.rest_length is not None:
        found, remedy = "filament.rest_length is given, and says how long it is", "rest_length"
    elif stretch == 1:
        found, remedy = "1 in the scene: neither stretched nor slack", "a rough initial.stretch in the scene"
    else:
        return plain
    return Candidate(**{**vars(plain), "trouble": found, "remedy": remedy})


def _of_measurement(scene: Scene) -> Iterator[Candidate]:
    unit = time_scale(scene)
    span, duration = scene.filament.span, scene.run.duration
    sag = max(expected_sag(scene) * span, 1e-6 * span)
    infinite = (-math.inf, math.inf)
    yield Candidate(TIME_OFFSET, TIME_OFFSET, "s", 0.0, unit, False, (-duration, duration), infinite, TIME_OFFSET)
    yield Candidate(INITIAL_SAG, INITIAL_SAG, "m", 0.0, sag, False, (-span, span), infinite, INITIAL_SAG)


def why_not_free(scene: Scene, name: str, known: Mapping[str, Candidate]) -> Fault:
    """Say why a name cannot be free: no such constant of the law, no number, or no such name."""
    where, leaf = f"free {name}", name.rpartition(".")[2]
    law, usable = scene.material.law, ", ".join(dict.fromkeys(one.name for one in known.values() if not one.trouble))
    constants = {constant for row in CONSTANTS.values() for constant in row} | {"index"}
    if (tensile_name(leaf) or leaf) in constants and name in (leaf, f"material.{leaf}"):
        return Fault(where, f"the law '{law}' has no {leaf}{_other_shear(leaf, known)}", usable)
    tables = [table for table, keys in known_keys().items() if leaf in keys and name in (leaf, f"{table}.{leaf}")]
    if tables and tables != ["groups"]:
        return Fault(where, "no number that the motion of a filament could tell", usable)
    return Fault(where, f"unknown{did_you_mean(leaf, [one.name for one in known.values()])}", usable)


def _other_shear(leaf: str, known: Mapping[str, Candidate]) -> str:
    """The name that the shear datum has for this law."""
    same = {rule.shear for rule in FROM_SHEAR if rule.constant == tensile_name(leaf)} & set(known)
    return f" (did you mean '{next(iter(same))}'?)" if same else ""


def _unit(kind: Kind) -> str:
    return kind.unit or SI_UNITS[kind.dimension] if isinstance(kind, Quantity) else ""
