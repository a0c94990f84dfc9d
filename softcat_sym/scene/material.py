"""The material: its law, its tensile constants, and the shear data they may come from."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, get_args

from pydantic import Field, ValidationInfo, ValidatorFunctionWrapHandler, field_validator, model_validator

from softcat_sym.scene.constituents import Mode, Modes, Parameter, Parameters
from softcat_sym.scene.flow_rule import threshold
from softcat_sym.scene.formula import Formula, parse_formula
from softcat_sym.scene.kinds import Choice, Kind, Number, Quantity, Text, refusal
from softcat_sym.scene.laws import OF_THE_INDEX, Law, check_against_law, check_loss, kind_of_constant
from softcat_sym.scene.own_law import check_own_law, stress_scales
from softcat_sym.scene.part import Part
from softcat_sym.scene.shear_data import FROM_SHEAR, INDEXED, Conversion
from softcat_sym.scene.units import shown

_VISCOSITY = Quantity("viscosity", "13.84 kPa*s")
_STRESS = Quantity("stress", "9.32 kPa")
Viscosity = Annotated[float | None, _VISCOSITY]
Stress = Annotated[float | None, _STRESS]
_SOLID_VISCOSITY = Quantity("viscosity", "1.2 Pa*s")
POISSON = 0.45
"""Poisson's ratio unless a scene states one."""

_CONSTANTS = ("youngs_modulus", "second_modulus", "viscosity", "yield_stress")


class Material(Part):
    """A law and its constants, all tensile; SI.

    Notes
    -----
    A constant that the law does not use is None.
    """

    table_name: ClassVar[str] = "material"

    law: Annotated[Law, Choice(get_args(Law))]
    """How the material answers to stress."""
    # Before the consistency, whose unit depends on it.
    index: Annotated[float, Number(above=0)] = 1.0
    """n of a law with an index: stress grows as the n-th power of the strain rate."""
    poisson: Annotated[float, Number(above=-1, below=0.5)] = POISSON
    """Poisson's ratio, used by shear, by sheets and by storage_modulus."""
    storage_modulus: Stress = Field(default=None, exclude=True, repr=False)
    """G' as a rheometer measures it below yield; youngs_modulus is 2 (1 + poisson) times it."""
    youngs_modulus: Stress = Field(default=None, validate_default=True)
    """Young's modulus E, three times an ink's storage modulus; of standard-linear the spring that always acts."""
    second_modulus: Stress = Field(default=None, validate_default=True)
    """Spring in line with the dashpot of standard-linear."""
    shear_viscosity: Viscosity = Field(default=None, exclude=True, repr=False)
    """Viscosity as a rheometer measures it, three times as much in tension; instead of viscosity."""
    shear_consistency: Viscosity = Field(default=None, exclude=True, repr=False)
    """K of a law with an index from a rheometer, 3^((n+1)/2) times as much in tension; instead of viscosity."""
    consistency: Viscosity = Field(default=None, exclude=True, repr=False)
    """The same as shear_consistency."""
    viscosity: Viscosity = Field(default=None, validate_default=True)
    """Extensional viscosity eta; of a law with an index the tensile consistency K, in Pa*s^n."""
    shear_yield_stress: Stress = Field(default=None, exclude=True, repr=False)
    """Yield stress as a rheometer measures it, sqrt(3) times as much in tension; instead of yield_stress."""
    yield_stress: Stress = Field(default=None, validate_default=True)
    """Tensile stress below which nothing flows, sY."""
    loss_modulus: Stress = Field(default=None, exclude=True, repr=False)
    """G'' below yield, beside storage_modulus: loss_tangent is their ratio."""
    loss_tangent: Annotated[float, Number(above=0, closed=True)] = Field(default=0.0, validate_default=True)
    """Loss below yield, G''/G', at the first natural frequency of the strand."""
    solid_viscosity: Annotated[float | None, _SOLID_VISCOSITY] = None
    """Tensile viscosity beside spring and flow; instead of loss_tangent."""
    modes: Annotated[tuple[Mode, ...], Modes()] = Field(default=(), validate_default=True)
    """Springs in line with dashpots, side by side, of multimode-maxwell."""
    flow: Annotated[str, Text()] = Field(default="", validate_default=True)
    """Rate of strain phi(sigma) of a custom law, of the stress sigma and of material.parameters."""
    parameters: Annotated[tuple[Parameter, ...], Parameters()] = Field(default=(), validate_default=True)
    """Named constants of a custom law."""

    @field_validator("index", mode="wrap")
    @classmethod
    def _of_laws_with_an_index(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        index, law = handler(value), info.data.get("law")
        if index != 1 and law is not None and law not in INDEXED:
            laws = ", ".join(INDEXED)
            raise refusal(f"{shown(value)}, but the law '{law}' has no index", f"leaving it out, or one of {laws}")
        return index

    @field_validator("shear_viscosity", "shear_consistency", "consistency", mode="wrap")
    @classmethod
    def _of_the_right_law(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        name, law = str(info.field_name), info.data.get("law")
        if value is None:
            return None
        conversion = next(one for one in FROM_SHEAR if one.shear == name)
        if law is not None and not conversion.suits(law):
            other = "shear_consistency" if law in INDEXED else "shear_viscosity"
            raise refusal(f"given, but the law '{law}' has no {name.removeprefix('shear_')} in shear", other)
        if name == "consistency" and _is_given("shear_consistency", info):
            raise refusal("given twice, here and as material.shear_consistency", "one of the two")
        return _read(name, value, info)

    @field_validator("youngs_modulus", "second_modulus", "viscosity", "yield_stress", mode="wrap")
    @classmethod
    def _as_the_law_needs(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> float | None:
        name, law = str(info.field_name), info.data.get("law")
        given = [one for one in FROM_SHEAR if one.constant == name and _is_given(one.shear, info)]
        if value is not None and given:
            raise refusal(f"given twice, here and as material.{given[0].shear}", "one of the two")
        result = None
        if value is not None:
            result = _read(name, value, info)
        elif given:
            result = _converted(given[0], info)
        check_against_law(name, law, result, kind_of_constant(name, law, info.data.get("index", 1.0)).accepted)
        return result

    @field_validator("loss_modulus", mode="wrap")
    @classmethod
    def _beside_a_storage_modulus(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        if value is not None and not (_is_given("storage_modulus", info) or _is_given("youngs_modulus", info)):
            raise refusal(
                "given without material.storage_modulus: their ratio is the loss tangent",
                "both moduli in shear, or material.loss_tangent",
            )
        return handler(value)

    @field_validator("loss_tangent", mode="wrap")
    @classmethod
    def _loss_of_a_spring(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        tangent, modulus = handler(value), info.data.get("loss_modulus", math.nan)
        if modulus is not None:
            if tangent != 0:
                raise refusal("given twice, here and as material.loss_modulus", "one of the two")
            # G' of a Young's modulus that was given itself.
            own = (info.data.get("youngs_modulus") or math.nan) / (2 * (1 + info.data.get("poisson", math.nan)))
            tangent = modulus / (info.data.get("storage_modulus") or own)
        if tangent != 0:
            check_loss(info.data.get("law"))
        return tangent

    @field_validator("solid_viscosity", mode="wrap")
    @classmethod
    def _given_once(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        viscosity = handler(value)
        if viscosity is None:
            return None
        if info.data.get("loss_tangent", 0.0) != 0:
            other = "loss_tangent" if info.data.get("loss_modulus") is None else "loss_modulus"
            raise refusal(f"given twice, here and as material.{other}", "one of the two")
        check_loss(info.data.get("law"))
        return viscosity

    @field_validator("modes", "flow", "parameters", mode="wrap")
    @classmethod
    def _of_the_law_made_of_it(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        result, name = handler(value), str(info.field_name)
        example = {"modes": Modes().accepted, "flow": 'a formula, such as "sinh(sigma/s0)/t0"'}.get(name, "")
        check_against_law(name, info.data.get("law"), result, example)
        if name == "flow" and result:
            parse_formula(result)
        return result

    @model_validator(mode="after")
    def _make_sense_of_the_own_law(self) -> Material:
        if self.law == "custom":
            check_own_law(parse_formula(self.flow), self.parameters, self.youngs_modulus)
        return self

    def kinds(self) -> dict[str, Kind]:
        """Return how each value is written; a consistency in its own unit."""
        names = ("viscosity", "shear_consistency", "consistency")
        own = {name: kind_of_constant(name, self.law, self.index) for name in names}
        return super().kinds() | own

    @property
    def has_loss(self) -> bool:
        """Whether a viscous stress acts beside spring and flow."""
        return self.loss_tangent > 0 or self.solid_viscosity is not None

    @property
    def formula(self) -> Formula | None:
        """The flow rule of a custom law, as a tree; None for other laws."""
        return parse_formula(self.flow) if self.flow else None

    @property
    def threshold(self) -> float:
        """Stress below which nothing flows [Pa]; 0 if there is none."""
        if self.law != "custom":
            return self.yield_stress or 0.0
        values = tuple((parameter.name, parameter.value) for parameter in self.parameters)
        return threshold(self.flow, values, stress_scales(self.parameters, self.youngs_modulus))

    def values(self) -> dict[str, float]:
        """Return every constant of the law by its leaf name; SI.

        Returns
        -------
        dict of str to float
            Without what the law does not have. Modes are ``mode_1_youngs_modulus`` and so on; the parameters of a
            custom law go by the user's names, and its threshold, if there is one, is ``yield_stress``.
        """
        found = {name: value for name in _CONSTANTS if (value := getattr(self, name)) is not None}
        if self.law in INDEXED:
            found["index"] = self.index
        for number, mode in enumerate(self.modes, start=1):
            found[f"mode_{number}_youngs_modulus"] = mode.youngs_modulus
            found[f"mode_{number}_viscosity"] = mode.viscosity
        found |= {parameter.name: parameter.value for parameter in self.parameters}
        if self.law == "custom" and self.threshold > 0:
            found["yield_stress"] = self.threshold
        return found

    @property
    def notes(self) -> tuple[str, ...]:
        """What was converted from shear data, in words and numbers."""
        notes = []
        for one in FROM_SHEAR:
            shear = getattr(self, one.shear)
            if shear is not None:
                unit = kind_of_constant(one.constant, self.law, self.index).unit or "Pa s"
                unit = "Pa" if one.constant in ("yield_stress", "youngs_modulus") else unit.replace("*", " ")
                words, tensile = one.words.replace("n+1", f"{self.index:g}+1"), getattr(self, one.constant)
                what = one.shear.removeprefix("shear_").replace("_", " ")
                if one.constant == "youngs_modulus":
                    words = words.replace("poisson", f"{self.poisson:g}")
                    notes.append(f"storage modulus {shear:.6g} Pa = Young's modulus {tensile:.6g} Pa, {words}")
                else:
                    notes.append(f"{what} {shear:.6g} {unit} in shear = {tensile:.6g} {unit} in tension, {words}")
        if self.loss_modulus is not None:
            storage = self.loss_modulus / self.loss_tangent
            ratio = f"loss modulus {self.loss_modulus:.6g} Pa over storage modulus {storage:.6g} Pa"
            notes.append(f"{ratio} = loss tangent {self.loss_tangent:.6g}")
        return tuple(notes)


def _is_given(name: str, info: ValidationInfo) -> bool:
    """None: not given. Absent: given, and already found faulty."""
    return info.data.get(name, math.nan) is not None


def _read(name: str, value: object, info: ValidationInfo) -> float:
    law = info.data.get("law")
    if (
        (law is None or law in INDEXED)
        and "index" not in info.data
        and name in OF_THE_INDEX
        and name != "shear_viscosity"
    ):
        # There is a fault already, and without an index no unit to compare with.
        return math.nan
    return kind_of_constant(name, law, info.data.get("index", 1.0)).read(value)


def _converted(conversion: Conversion, info: ValidationInfo) -> float:
    # NaN never escapes: without a sound ratio there is a fault, and with a fault there is no material.
    factor = conversion.factor(info.data.get("index", 1.0), info.data.get("poisson", math.nan))
    result = factor * info.data.get(conversion.shear, math.nan)
    if result == math.inf:
        raise refusal(f"{factor:g} times {conversion.shear} is not finite", "a smaller value")
    return float(result)
