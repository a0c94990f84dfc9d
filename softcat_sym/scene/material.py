"""The material: its law, its tensile constants, and the shear data they may come from."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from keyword import iskeyword
from typing import Annotated, Any, cast

from pydantic import Field, ValidationInfo, field_validator, model_validator
from pydantic_core import PydanticCustomError

from softcat_sym.scene import formula as formulas
from softcat_sym.scene.formula import Formula, parse_formula
from softcat_sym.scene.history import Changing, ChangingNumber, ChangingQuantity, History, scaled, value_at
from softcat_sym.scene.laws import CONSTANTS, LAWS, LawSpec, kind_of_constant, laws_with, spec_of
from softcat_sym.scene.parts import LINE, Part
from softcat_sym.scene.thixotropy import STRUCTURE, Thixotropy
from softcat_sym.scene.units import (
    STRESS,
    TEXT,
    Choice,
    Dimension,
    Kind,
    NotAQuantity,
    Number,
    Quantity,
    Record,
    Refused,
    Values,
    read_each,
    refusal,
    refusals,
    same_dimension,
    shown,
    si_unit,
    to_si_of_any,
    with_unit,
)

# Names that already mean something where the parameters of a rule become numbers of the computation.
RESERVED = frozenset(
    (
        *("span", "thickness", "density", "gravity", "ramp", "shake", "shake_frequency", "youngs_modulus"),
        *("viscosity", "yield_stress", "index", "poisson", "aspect", "time_scale", "second_modulus", "rest_length"),
        *(formulas.STRESS_NAME, *formulas.FORMULA_CONSTANTS, *formulas.FUNCTIONS),
    )
)

_MOST = 50


@dataclass(frozen=True, slots=True)
class Mode:
    """A spring in line with a dashpot."""

    youngs_modulus: Annotated[float, ChangingQuantity("stress", "1 MPa")]  # [Pa]
    viscosity: Annotated[float, ChangingQuantity("viscosity", "2 kPa*s")]  # [Pa s], extensional


@dataclass(frozen=True, slots=True)
class NamedConstant:
    """A named constant of a flow rule, SI."""

    name: str
    value: float
    dimension: Dimension


_SOME_MODES = 'a list of modes, at most 50, such as [{youngs_modulus = "1 MPa", viscosity = "2 kPa*s"}]'
MODE = Record(Mode, _SOME_MODES)
MODES = Values(MODE, _SOME_MODES, most=_MOST)


class _Parameters(Kind):
    """A table of named constants of any unit."""

    def check(self, value: Any) -> tuple[NamedConstant, ...]:
        if isinstance(value, tuple) and all(isinstance(item, NamedConstant) for item in value):
            return value
        if value in ("", []):
            return ()
        if len(self.table(value)) > _MOST:
            raise refusal(f"{len(value)} parameters", f"at most {_MOST} parameters")
        read = read_each("parameters", ((str(name), self._parameter, (name, one)) for name, one in value.items()))
        return tuple(sorted(read.values(), key=lambda parameter: parameter.name))

    def _parameter(self, name: object, given: object) -> NamedConstant:
        if not isinstance(name, str) or not (name.isascii() and name.isidentifier()) or iskeyword(name):
            raise refusal(f"{shown(name)} is no name", "letters, digits and _, not starting with a digit")
        if name in RESERVED or name.startswith("_"):
            raise refusal(f"the name {name!r} already means something", "another name")
        try:
            value, dimension = to_si_of_any(given)
        except NotAQuantity as found:
            raise refusal(str(found), 'a bare number, or text with a number and a unit, such as "1 kPa"') from None
        return NamedConstant(name, value + 0.0, dimension)

    def write(self, value: tuple[NamedConstant, ...]) -> object:
        units = {one: si_unit(one.dimension) for one in value}
        return {one.name: with_unit(one.value, unit) if unit else one.value for one, unit in units.items()}


PARAMETERS = _Parameters('a table of named constants, such as {s0 = "1 kPa", t0 = "2 s", m = 3}')


class _EffectTables(Kind):
    """The tables ``[effects.NAME]``: named constants of effects that other packages register."""

    def check(self, value: Any) -> tuple[EffectTable, ...]:
        if isinstance(value, tuple) and all(isinstance(item, tuple) for item in value):
            return value

        def read(table: object) -> tuple[NamedConstant, ...]:
            return tuple(PARAMETERS.read(self.table(table)))

        reads = ((str(name), read, (one,)) for name, one in self.table(value).items())
        return tuple(sorted(read_each("effects", reads).items()))

    def write(self, value: tuple[EffectTable, ...]) -> object:
        return {name: PARAMETERS.write(table) for name, table in value}


EFFECT_TABLES = _EffectTables(
    'tables of named constants, such as [effects.elastic-foundation] with stiffness = "1 kPa"'
)
EffectTable = tuple[str, tuple[NamedConstant, ...]]
"""An effect's name and its constants."""


def constant_in_c(path: str) -> str:
    """Name among the numbers of a run, as C has it, of a constant of a scene's own law or of an effect from outside."""
    return path.removeprefix("material.parameters.").removeprefix("effects.").replace("-", "_").replace(".", "_")


@dataclass(frozen=True, slots=True)
class Conversion:
    """One tensile constant from one shear datum, by von Mises' equivalence; Trouton's 3 of a Newtonian fluid."""

    constant: str
    shear: str
    indexed: bool | None  # Whether the law must have an index; None if that does not matter
    words: str

    def suits(self, law: str | None) -> bool:
        """Tell whether a law takes this datum."""
        return self.indexed is None or self.indexed == spec_of(law).has_index

    def factor(self, index: float, poisson: float) -> float:
        """Return the tensile value over the shear one; infinite where it overflows."""
        if self.constant in ("viscosity", "solvent_viscosity"):
            return power(3.0, (index + 1) / 2) if self.indexed else 3.0
        return 2 * (1 + poisson) if self.constant == "youngs_modulus" else math.sqrt(3.0)


def power(base: float, exponent: float) -> float:
    """Raise a positive number to a power; infinite where it overflows."""
    try:
        return math.pow(base, exponent)
    except OverflowError:
        return math.inf


FROM_SHEAR = (
    Conversion("viscosity", "shear_viscosity", False, "times 3"),
    Conversion("viscosity", "shear_consistency", True, "times 3^((n+1)/2)"),
    Conversion("viscosity", "consistency", True, "times 3^((n+1)/2)"),
    Conversion("yield_stress", "shear_yield_stress", None, "times sqrt(3)"),
    Conversion("youngs_modulus", "storage_modulus", None, "times 2 (1 + poisson)"),
    Conversion("solvent_viscosity", "shear_solvent_viscosity", None, "times 3"),
)

_SAME = (
    {"youngs_modulus", "storage_modulus"},
    {"viscosity", "shear_viscosity", "shear_consistency", "consistency"},
    {"yield_stress", "shear_yield_stress"},
    {"solvent_viscosity", "shear_solvent_viscosity"},
    {"loss_tangent", "loss_modulus", "solid_viscosity"},
)
"""Keys of [material] of which a scene has one at most."""


def poisson_in_shear(law: str | None, poisson: float) -> float:
    """Return Poisson's ratio between a shear modulus and Young's: 1/2 of polymer chains, which keep their volume."""
    return 0.5 if spec_of(law).has_chains else poisson


def shear_names(constant: str) -> tuple[str, ...]:
    """Name the shear data that a tensile constant may come from."""
    return tuple(conversion.shear for conversion in FROM_SHEAR if conversion.constant == constant)


def physical_path(path: str) -> str:
    """Name the key that a value given in another way stands for: ``filament.thickness`` for the diameter."""
    table, _, key = path.partition(".")
    if path == "filament.diameter":
        return "filament.thickness"
    return f"material.{tensile_name(key) or key}" if table == "material" else path


_SAME_THICKNESS = ({"thickness", "diameter"}, *({one, line} for one in ("thickness", "diameter") for line in LINE))


def twins(path: str) -> tuple[str, ...]:
    """Name the other keys that say the same as this one, by their dotted paths."""
    table, _, key = path.partition(".")
    same = {"filament": _SAME_THICKNESS, "material": _SAME}.get(table, ())
    return tuple(f"{table}.{other}" for keys in same if key in keys for other in sorted(keys - {key}))


def tensile_name(shear: str) -> str:
    """Name the tensile constant that a shear datum gives; empty if it is none."""
    return next((conversion.constant for conversion in FROM_SHEAR if conversion.shear == shear), "")


def check_against_law(name: str, law: str | None, value: object, accepted: str) -> None:
    """Refuse a constant or list that the law needs and has not, or has and does not use; `law` None: faulty itself."""
    if law is None:
        return
    laws = laws_with(name)
    used, missing = law in laws, value is None or value in ((), "")
    if missing and used and name != "parameters":
        raise refusal(f"missing: the law '{law}' needs it", accepted)
    if not missing and not used:
        verb = {"yield_stress": "yield", "viscosity": "flow"}.get(name, "use it")
        accepted = f"leaving it out, or one of the laws {', '.join(laws)}"
        raise refusal(f"given, but the law '{law}' does not {verb}", accepted)


def _named(has: str) -> str:
    """Name the laws that have a property."""
    return ", ".join(one.name for one in LAWS.values() if getattr(one, has))


def structure_faults(structure: Thixotropy, data: Mapping[str, Any]) -> Iterator[Refused]:
    """What of a structure the other constants of the material leave no room for."""
    law = data["law"]
    if not LAWS[law].has_structure:
        found = f"given, but the law '{law}' has no flow that it would change"
        yield (), refusal(found, f"one of the laws {_named('has_structure')}")
        return
    for name in ("yield_stress", "viscosity"):
        for end in ("structured", "destroyed"):
            if getattr(structure, f"{end}_{name}") is None:
                continue
            if data.get(name) is None or (name == "viscosity" and spec_of(law).has_index):
                found = f"given, but the law '{law}' has no {name.replace('_', ' ')}"
                yield (f"{end}_{name}",), refusal(found, "leaving it out")
            elif isinstance(data[name], History):
                found = f"given, but material.{name} changes in time by itself"
                yield (f"{end}_{name}",), refusal(found, "one of the two")
    limit = data.get("yield_stress")
    yield from _ends_and_start(structure, limit if isinstance(limit, float) else None)


def _ends_and_start(structure: Thixotropy, limit: float | None) -> Iterator[Refused]:
    """Yield stresses on either side of that at the beginning, and where lambda begins."""
    high, low = structure.structured_yield_stress, structure.destroyed_yield_stress
    if limit is not None:
        if high is not None and high < limit:
            yield ("structured_yield_stress",), refusal(f"{high:g} Pa", f"at least material.yield_stress, {limit:g} Pa")
        if low is not None and low > limit:
            yield ("destroyed_yield_stress",), refusal(f"{low:g} Pa", f"at most material.yield_stress, {limit:g} Pa")
        if high is not None and high == (limit if low is None else low):
            yield ("structured_yield_stress",), refusal("the same as the destroyed one", "a larger one")
    start = structure.start(limit)
    if structure.growth == "saturating" and start > 1:
        yield ("initial",), refusal(f"{start:g}", "at most 1, built up")
    if structure.structured_viscosity is not None and start == 1:
        found = "given, but the material is built up at the beginning"
        yield ("structured_viscosity",), refusal(found, "destroyed_viscosity")
    if structure.destroyed_viscosity is not None and start == 0:
        found = "given, but the material is destroyed at the beginning"
        yield ("destroyed_viscosity",), refusal(found, "structured_viscosity")


def stress_scales(parameters: tuple[NamedConstant, ...], youngs_modulus: float | None) -> tuple[float, ...]:
    """Return the stresses that the parameters of a flow rule set, and the modulus; positive [Pa]."""
    sizes = [abs(parameter.value) for parameter in parameters if same_dimension(parameter.dimension, STRESS)]
    return tuple(size for size in (*sizes, youngs_modulus) if size)


def check_own_law(formula: Formula, parameters: tuple[NamedConstant, ...], youngs_modulus: float | None) -> None:
    """Refuse unknown symbols, unused parameters, units that do not fit, and rules that no material has."""
    known = {parameter.name: parameter for parameter in parameters}
    faults: list[Refused] = [
        (("flow",), refusal(f"unknown symbol '{name}'", f"sigma, pi, and the parameters: {', '.join(known) or 'none'}"))
        for name in sorted(formula.names - set(known))
    ]
    faults += [
        (("parameters", name), refusal("not used by material.flow", "leaving it out"))
        for name in known
        if name not in formula.names
    ]
    if not formula.names - set(known):
        values = {name: parameter.value for name, parameter in known.items()}
        try:
            formulas.check_units(formula, {name: one.dimension for name, one in known.items()}, values)
            formulas.check_rule(formula, values, stress_scales(parameters, youngs_modulus))
        except PydanticCustomError as error:
            faults.append((("flow",), error))
    if faults:
        raise refusals("material", faults)


Viscosity = Annotated[float | None, CONSTANTS["viscosity"]]
Stress = Annotated[float | None, CONSTANTS["yield_stress"]]
Solvent = Annotated[float | None, Quantity("viscosity", "1 mPa*s", "non-negative")]
_AS_THE_LAW_NEEDS = Field(default=None, validate_default=True)
_IN_SHEAR = Field(default=None, exclude=True, repr=False)
POISSON = 0.45
"""Poisson's ratio unless a scene states one."""


class Material(Part, table="material"):
    """A law and its constants, all tensile; SI.

    A constant that the law does not use is None.
    """

    law: Annotated[str, Choice(tuple(LAWS))]
    """Constitutive law: how the material answers to stress."""
    # Before the consistency, whose unit depends on it.
    index: Annotated[float, Number(above=0)] = 1.0
    """n of a law with an index: stress grows as the n-th power of the strain rate."""
    poisson: Annotated[float, Number(above=-1, below=0.5)] = POISSON
    """Poisson's ratio, used by shear, by sheets and by storage_modulus."""
    storage_modulus: Stress = _IN_SHEAR
    """G' as a rheometer measures it below yield; youngs_modulus is 2 (1 + poisson) times it."""
    youngs_modulus: Stress = _AS_THE_LAW_NEEDS
    """Young's modulus E, three times an ink's storage modulus; of standard-linear the spring that always acts."""
    second_modulus: Stress = _AS_THE_LAW_NEEDS
    """Spring in line with the dashpot of standard-linear."""
    shear_viscosity: Viscosity = _IN_SHEAR
    """Viscosity as a rheometer measures it, three times as much in tension; instead of viscosity."""
    shear_consistency: Viscosity = _IN_SHEAR
    """K of a law with an index from a rheometer, 3^((n+1)/2) times as much in tension; instead of viscosity."""
    consistency: Viscosity = _IN_SHEAR
    """The same as shear_consistency."""
    viscosity: Viscosity = _AS_THE_LAW_NEEDS
    """Extensional viscosity eta; of a law with an index the tensile consistency K, in Pa*s^n."""
    shear_yield_stress: Stress = _IN_SHEAR
    """Yield stress as a rheometer measures it, sqrt(3) times as much in tension; instead of yield_stress."""
    yield_stress: Stress = _AS_THE_LAW_NEEDS
    """Tensile stress below which nothing flows, sY."""
    relaxation_time: Annotated[float | None, CONSTANTS["relaxation_time"]] = _AS_THE_LAW_NEEDS
    """Time in which the polymer chains of a law of them forget a strain; their tensile viscosity is E times it."""
    shear_solvent_viscosity: Solvent = _IN_SHEAR
    """Viscosity of the solvent as a rheometer measures it, three times as much in tension."""
    solvent_viscosity: Annotated[float | None, CONSTANTS["solvent_viscosity"]] = _AS_THE_LAW_NEEDS
    """Extensional viscosity of the solvent beside the chains; 0 for chains alone (upper-convected Maxwell)."""
    finite_extensibility: Annotated[float | None, CONSTANTS["finite_extensibility"]] = _AS_THE_LAW_NEEDS
    """L^2 of fene-p: trace of the conformation, 3 at rest, of chains drawn out straight."""
    mobility: Annotated[float | None, CONSTANTS["mobility"]] = _AS_THE_LAW_NEEDS
    """Mobility factor alpha of giesekus: how much less drag there is along stretched chains."""
    ptt_epsilon: Annotated[float | None, CONSTANTS["ptt_epsilon"]] = _AS_THE_LAW_NEEDS
    """Factor epsilon of ptt, linear: chains relax 1 + epsilon (tr A - 3) times as fast."""
    loss_modulus: Annotated[float | None, Quantity("stress", "9.32 kPa")] = _IN_SHEAR
    """G'' below yield, beside storage_modulus: loss_tangent is their ratio."""
    loss_tangent: Annotated[float, Number(above=0, closed=True)] = Field(default=0.0, validate_default=True)
    """Loss below yield, G''/G', at the first natural frequency of the strand."""
    solid_viscosity: Annotated[float | None, Quantity("viscosity", "1.2 Pa*s")] = None
    """Tensile viscosity beside spring and flow; instead of loss_tangent."""
    structure: Annotated[Thixotropy | None, STRUCTURE] = None
    """How the material builds up at rest and breaks down in flow: a table [material.structure]."""
    hardening_modulus: Annotated[float | None, Quantity("stress", "2 kPa")] = None
    """C of a backstress C A (kinematic hardening), tensile: three times that of a rheometer in shear."""
    hardening_recovery: Annotated[float, Number(above=0, closed=True)] = 0.0
    """q of its dynamic recovery, A_t = rate - q A |rate|, per tensile strain: sqrt(3) times that in shear."""
    breaking_strain: Annotated[float | None, Number(above=0)] = None
    """True (Hencky) strain, log of its stretch, at which the outer fibre breaks in tension; the run ends there."""
    breaking_stress: Annotated[float | None, Quantity("stress", "20 kPa")] = None
    """True stress at which the outer fibre breaks in tension; the run ends there."""
    modes: Annotated[tuple[Mode, ...], MODES] = Field(default=(), validate_default=True)
    """Springs in line with dashpots, side by side, of multimode-maxwell."""
    natural_strain: Annotated[float, ChangingNumber(-1.0, 1.0)] = 0.0
    """Strain without stress, mean over the thickness, negative where it shrinks; or a history that starts from 0."""
    natural_strain_difference: Annotated[float, ChangingNumber(-1.0, 1.0)] = 0.0
    """Natural strain at the top less that at the bottom: negative where the top shrinks more; or a history of it."""
    flow: Annotated[str, TEXT] = Field(default="", validate_default=True)
    """Rate of strain phi(sigma) of a custom law, of the stress sigma and of material.parameters."""
    parameters: Annotated[tuple[NamedConstant, ...], PARAMETERS] = Field(default=(), validate_default=True)
    """Named constants of a custom law."""

    @field_validator("index", "poisson")
    @classmethod
    def _of_laws_that_use_it(cls, value: float, info: ValidationInfo) -> float:
        law, is_index = info.data.get("law"), info.field_name == "index"
        if law is not None and is_index and value != 1 and not spec_of(law).has_index:
            accepted = f"leaving it out, or one of {_named('has_index')}"
            raise refusal(f"{value:g}, but the law '{law}' has no index", accepted)
        if not is_index and value != POISSON and spec_of(law).has_chains:
            raise refusal(f"{value:g}, but the chains of the law '{law}' keep their volume", "leaving it out")
        return value

    @field_validator("shear_viscosity", "shear_consistency", "consistency", mode="plain")
    @classmethod
    def _of_the_right_law(cls, value: Any, info: ValidationInfo) -> Any:
        name, law = str(info.field_name), info.data.get("law")
        if value is None:
            return None
        if law is not None and not next(rule for rule in FROM_SHEAR if rule.shear == name).suits(law):
            other = "shear_consistency" if spec_of(law).has_index else "shear_viscosity"
            raise refusal(f"given, but the law '{law}' has no {name.removeprefix('shear_')} in shear", other)
        if name == "consistency" and _is_given("shear_consistency", info):
            raise _given_twice("shear_consistency")
        return _read(name, value, info)

    @field_validator(*CONSTANTS, mode="plain")
    @classmethod
    def _as_the_law_needs(cls, value: Any, info: ValidationInfo) -> float | None:
        name, law = str(info.field_name), info.data.get("law")
        given = [conversion for conversion in FROM_SHEAR if conversion.constant == name]
        given = [conversion for conversion in given if _is_given(conversion.shear, info)]
        result = None
        if value is not None:
            if given:
                raise _given_twice(given[0].shear)
            result = _read(name, value, info)
        elif given:
            # NaN never escapes: without a sound ratio there is a fault, and with a fault there is no material.
            poisson = poisson_in_shear(law, info.data.get("poisson", math.nan))
            factor = given[0].factor(info.data.get("index", 1.0), poisson)
            datum = info.data.get(given[0].shear, math.nan)
            result = scaled(datum, factor)
            if float(result) == math.inf:
                raise refusal(f"{factor:g} times {given[0].shear} is not finite", "a smaller value")
        check_against_law(name, law, result, kind_of_constant(name, law, info.data.get("index", 1.0)).accepted)
        return result

    @field_validator("loss_modulus")
    @classmethod
    def _beside_a_storage_modulus(cls, value: float | None, info: ValidationInfo) -> float | None:
        if value is not None and not (_is_given("storage_modulus", info) or _is_given("youngs_modulus", info)):
            found = "given without material.storage_modulus: their ratio is the loss tangent"
            raise refusal(found, "both moduli in shear, or material.loss_tangent")
        return value

    @field_validator("loss_tangent", "solid_viscosity")
    @classmethod
    def _loss_of_a_spring(cls, loss: float | None, info: ValidationInfo) -> float | None:
        data, is_tangent = info.data, info.field_name == "loss_tangent"
        modulus = data.get("loss_modulus", math.nan)
        if loss and (data.get("loss_tangent") or (is_tangent and modulus is not None)):
            raise _given_twice("loss_tangent" if modulus is None else "loss_modulus")
        if is_tangent and modulus is not None:
            # G' of a Young's modulus that was given itself.
            own = (data.get("youngs_modulus") or math.nan) / (2 * (1 + data.get("poisson", math.nan)))
            loss = modulus / (data.get("storage_modulus") or own)
        if loss and (law := data.get("law")) and (why := LAWS[law].loss_refused):
            others = ", ".join(one.name for one in LAWS.values() if not one.loss_refused)
            raise refusal(f"given, but the law '{law}' {why}", f"leaving it out, or one of the laws {others}")
        return loss

    @field_validator("natural_strain", "natural_strain_difference")
    @classmethod
    def _none_at_the_start(cls, strain: float) -> float:
        if float(strain) != 0:
            found = f"{float(strain):g} at t = 0, at which the material is without stress as it stands"
            constant = "filament.rest_length or filament.curvature for what never changes"
            raise refusal(found, f'a history from 0, such as "-0.05*(1 - exp(-t/60 s))"; {constant}')
        return strain

    @field_validator("modes", "flow", "parameters")
    @classmethod
    def _of_the_law_made_of_it(cls, value: Any, info: ValidationInfo) -> Any:
        name = str(info.field_name)
        example = {"modes": MODES.accepted, "flow": 'a formula, such as "sinh(sigma/s0)/t0"'}.get(name, "")
        check_against_law(name, info.data.get("law"), value, example)
        if name == "flow" and value:
            parse_formula(value)
        return value

    @field_validator("structure")
    @classmethod
    def _of_a_law_that_flows(cls, value: Thixotropy | None, info: ValidationInfo) -> Thixotropy | None:
        if value is not None and "law" in info.data and (faults := list(structure_faults(value, info.data))):
            raise refusals("structure", faults)
        return value

    @field_validator("hardening_modulus", "hardening_recovery")
    @classmethod
    def _of_a_law_that_hardens(cls, number: float | None, info: ValidationInfo) -> float | None:
        law, is_modulus = info.data.get("law"), info.field_name == "hardening_modulus"
        if number and law and not is_modulus and info.data.get("hardening_modulus", math.nan) is None:
            raise refusal("given without material.hardening_modulus: no backstress recovers", "both, or neither")
        if number and law and is_modulus and not LAWS[law].yields:
            found = f"given, but the law '{law}' has no yield stress of its own that would harden"
            raise refusal(found, f"leaving it out, or one of the laws {_named('yields')}")
        return number

    @model_validator(mode="after")
    def _make_sense_of_the_own_law(self) -> Material:
        if self.flow:
            check_own_law(parse_formula(self.flow), self.parameters, self.youngs_modulus)
        return self

    def kinds(self) -> Mapping[str, Kind]:
        """Return how each value is written; a consistency in its own unit."""
        names = ("viscosity", "shear_consistency", "consistency")
        own = {name: kind_of_constant(name, self.law, self.index) for name in names}
        return {**super().kinds(), **own}

    @property
    def spec(self) -> LawSpec:
        """Properties of the law."""
        return LAWS[self.law]

    @property
    def has_loss(self) -> bool:
        """Whether a viscous stress acts beside spring and flow."""
        return self.loss_tangent > 0 or self.solid_viscosity is not None

    @property
    def formula(self) -> Formula | None:
        """The flow rule as a tree, of a law that has a formula; None for other laws."""
        return parse_formula(self.flow or self.spec.flow) if self.spec.has_formula else None

    @property
    def threshold(self) -> float:
        """Stress below which nothing flows [Pa]; 0 if there is none."""
        if not self.flow:
            return self.yield_stress or 0.0
        values = tuple((parameter.name, parameter.value) for parameter in self.parameters)
        return formulas.threshold(self.flow, values, stress_scales(self.parameters, self.youngs_modulus))

    def values(self) -> dict[str, float]:
        """Return every constant that the law has by its leaf name, SI.

        Modes are ``mode_1_youngs_modulus`` and so on; the parameters of a custom law go by the user's names, and its
        threshold, if there is one, is ``yield_stress``.
        """
        found = {name: value for name in CONSTANTS if (value := getattr(self, name)) is not None}
        if self.spec.has_index:
            found["index"] = self.index
        for number, mode in enumerate(self.modes, start=1):
            found[f"mode_{number}_youngs_modulus"] = mode.youngs_modulus
            found[f"mode_{number}_viscosity"] = mode.viscosity
        found |= {parameter.name: parameter.value for parameter in self.parameters}
        if self.flow and self.threshold > 0:
            found["yield_stress"] = self.threshold
        return found

    def histories(self) -> dict[str, History]:
        """Return the constants of the law that change in time, by the names of `values`."""
        return {name: value for name, value in self.values().items() if isinstance(value, History)}

    def natural_strains(self) -> dict[str, History]:
        """Return the strains without stress that change in time, by their keys."""
        given = {name: getattr(self, name) for name in ("natural_strain", "natural_strain_difference")}
        return {name: value for name, value in given.items() if isinstance(value, History)}

    @property
    def changes(self) -> bool:
        """Whether anything about it changes in time."""
        return bool(self.natural_strains()) or bool(self.histories())

    def faults_of_histories(self, duration: float) -> Iterator[tuple[str, str, str]]:
        """List what histories are at some time of a run, and what this constant must not be: path, found, accepted."""
        given = [(name, getattr(self, name), kind) for name, kind in self.kinds().items()]
        for number, mode in enumerate(self.modes, start=1):
            given += [(f"modes.{number}.{name}", getattr(mode, name), kind) for name, kind in MODE.kinds.items()]
        for path, value, kind in given:
            if isinstance(kind, Changing) and isinstance(value, History) and (found := value.refused(kind, duration)):
                yield f"{self.table_name}.{path}", found, f"{kind.accepted}, at every time of the run"

    def at(self, time: float) -> Material:
        """Return the material as it is at a time [s], and stays: of constants only."""
        names = (*CONSTANTS, *(rule.shear for rule in FROM_SHEAR))
        given = {name: value for name in names if isinstance(value := getattr(self, name), History)}
        update: dict[str, Any] = {name: value_at(value, time) for name, value in given.items()}
        update["modes"] = tuple(
            Mode(value_at(mode.youngs_modulus, time), value_at(mode.viscosity, time)) for mode in self.modes
        )
        return self.model_copy(update={**update, "natural_strain": 0.0, "natural_strain_difference": 0.0})

    @property
    def assumed(self) -> str:
        """Which constants of a flow are taken as those of extension, in words; empty if none is."""
        stated = [rule for rule in FROM_SHEAR if rule.suits(self.law) and getattr(self, rule.constant)]
        if {rule.constant for rule in stated} == {"youngs_modulus"}:
            return ""
        sheared = {rule.constant for rule in stated if getattr(self, rule.shear) is not None}
        names = {rule.constant: rule.shear for rule in reversed(stated) if rule.constant not in sheared}
        if not names:
            return ""
        return f"{', '.join(names)} taken as extensional; in shear, as of a rheometer: {', '.join(names.values())}"

    @property
    def notes(self) -> tuple[str, ...]:
        """What was converted from shear data, in words and numbers."""
        notes = []
        for rule in FROM_SHEAR:
            shear, tensile = getattr(self, rule.shear), getattr(self, rule.constant)
            if shear is None:
                continue
            kind = kind_of_constant(rule.constant, self.law, self.index)
            unit = kind.unit.replace("*", " ")
            poisson = poisson_in_shear(self.law, self.poisson)
            words = rule.words.replace("n+1", f"{self.index:g}+1").replace("poisson", f"{poisson:g}")
            words += " at the start, and so at all times" if isinstance(shear, History) else ""
            if rule.constant == "youngs_modulus":
                notes.append(f"storage modulus {shear:.6g} Pa = Young's modulus {tensile:.6g} Pa, {words}")
            else:
                what = rule.shear.removeprefix("shear_").replace("_", " ")
                notes.append(f"{what} {shear:.6g} {unit} in shear = {tensile:.6g} {unit} in tension, {words}")
        if self.loss_modulus is not None:
            storage = self.loss_modulus / self.loss_tangent
            ratio = f"loss modulus {self.loss_modulus:.6g} Pa over storage modulus {storage:.6g} Pa"
            notes.append(f"{ratio} = loss tangent {self.loss_tangent:.6g}")
        return tuple(notes)


def _given_twice(other: str) -> PydanticCustomError:
    return refusal(f"given twice, here and as material.{other}", "one of the two")


def _is_given(name: str, info: ValidationInfo) -> bool:
    """None: not given. Absent: given, and already found faulty."""
    return info.data.get(name, math.nan) is not None


def _read(name: str, value: object, info: ValidationInfo) -> float:
    law = info.data.get("law")
    of_the_index = name in ("viscosity", "shear_consistency", "consistency")
    if of_the_index and (law is None or spec_of(law).has_index) and "index" not in info.data:
        # There is a fault already, and without an index no unit to compare with.
        return math.nan
    return cast(float, kind_of_constant(name, law, info.data.get("index", 1.0)).read(value))
