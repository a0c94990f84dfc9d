"""The material: its law, its tensile constants, and the shear data they may come from."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, get_args

from pydantic import Field, ValidationInfo, ValidatorFunctionWrapHandler, field_validator, model_validator

from softcat_sym.scene.constituents import Mode, Modes, Parameter, Parameters
from softcat_sym.scene.flow_rule import threshold
from softcat_sym.scene.formula import Formula, parse_formula
from softcat_sym.scene.kinds import Choice, Kind, Number, Quantity, Text, refusal
from softcat_sym.scene.laws import Law, check_against_law, kind_of_constant
from softcat_sym.scene.own_law import check_own_law, stress_scales
from softcat_sym.scene.part import Part
from softcat_sym.scene.shear_data import FROM_SHEAR, INDEXED, Conversion
from softcat_sym.scene.units import shown

_VISCOSITY = Quantity("viscosity", "13.84 kPa*s")
_STRESS = Quantity("stress", "9.32 kPa")
Viscosity = Annotated[float | None, _VISCOSITY]
Stress = Annotated[float | None, _STRESS]
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
    youngs_modulus: Stress = Field(default=None, validate_default=True)
    """Young's modulus E, three times an ink's storage modulus; of standard-linear the spring that always acts."""
    second_modulus: Stress = Field(default=None, validate_default=True)
    """Spring in line with the dashpot of standard-linear."""
    shear_viscosity: Viscosity = Field(default=None, exclude=True, repr=False)
    """Viscosity as a rheometer measures it, three times as much in tension; instead of viscosity."""
    shear_consistency: Viscosity = Field(default=None, exclude=True, repr=False)
    """K of a law with an index from a rheometer, 3^((n+1)/2) times as much in tension; instead of viscosity."""
    viscosity: Viscosity = Field(default=None, validate_default=True)
    """Extensional viscosity eta; of a law with an index the tensile consistency K, in Pa*s^n."""
    shear_yield_stress: Stress = Field(default=None, exclude=True, repr=False)
    """Yield stress as a rheometer measures it, sqrt(3) times as much in tension; instead of yield_stress."""
    yield_stress: Stress = Field(default=None, validate_default=True)
    """Tensile stress below which nothing flows, sY."""
    poisson: Annotated[float, Number(above=-1, below=0.5)] = 0.45
    """Poisson's ratio, used by shear and by sheets."""
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

    @field_validator("shear_viscosity", "shear_consistency", mode="wrap")
    @classmethod
    def _of_the_right_law(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        name, law = str(info.field_name), info.data.get("law")
        if value is None:
            return None
        conversion = next(one for one in FROM_SHEAR if one.shear == name)
        if law is not None and not conversion.suits(law):
            other = "shear_consistency" if law in INDEXED else "shear_viscosity"
            raise refusal(f"given, but the law '{law}' has no {name.removeprefix('shear_')} in shear", other)
        return _read(name, value, info)

    @field_validator("youngs_modulus", "second_modulus", "viscosity", "yield_stress", mode="wrap")
    @classmethod
    def _as_the_law_needs(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> float | None:
        name, law = str(info.field_name), info.data.get("law")
        given = [one for one in FROM_SHEAR if one.constant == name and _is_given(one.shear, info)]
        if value is not None and given:
            raise refusal(f"given twice, here and as {given[0].shear}", "one of the two")
        result = None
        if value is not None:
            result = _read(name, value, info)
        elif given:
            result = _converted(given[0], info)
        check_against_law(name, law, result, kind_of_constant(name, law, info.data.get("index", 1.0)).accepted)
        return result

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
        own = {name: kind_of_constant(name, self.law, self.index) for name in ("viscosity", "shear_consistency")}
        return super().kinds() | own

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
                unit = "Pa" if one.constant == "yield_stress" else unit.replace("*", " ")
                words, tensile = one.words.replace("n+1", f"{self.index:g}+1"), getattr(self, one.constant)
                what = one.shear.removeprefix("shear_").replace("_", " ")
                notes.append(f"{what} {shear:.6g} {unit} in shear = {tensile:.6g} {unit} in tension, {words}")
        return tuple(notes)


def _is_given(name: str, info: ValidationInfo) -> bool:
    """None: not given. Absent: given, and already found faulty."""
    return info.data.get(name, math.nan) is not None


def _read(name: str, value: object, info: ValidationInfo) -> float:
    law = info.data.get("law")
    if (law is None or law in INDEXED) and "index" not in info.data and name in ("viscosity", "shear_consistency"):
        # There is a fault already, and without an index no unit to compare with.
        return math.nan
    return kind_of_constant(name, law, info.data.get("index", 1.0)).read(value)


def _converted(conversion: Conversion, info: ValidationInfo) -> float:
    factor = conversion.factor(info.data.get("index", 1.0))
    result = factor * info.data.get(conversion.shear, math.nan)
    if result == math.inf:
        raise refusal(f"{factor:g} times {conversion.shear} is not finite", "a smaller value")
    return float(result)
