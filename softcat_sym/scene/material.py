"""The material: its law, its tensile constants, and the shear data they may come from."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal, get_args

from pydantic import Field, ValidationInfo, ValidatorFunctionWrapHandler, field_validator

from softcat_sym.scene.kinds import Choice, Empty, Number, Quantity, Text, refusal
from softcat_sym.scene.part import Part

Law = Literal[
    "elastic",
    "maxwell",
    "newtonian",
    "kelvin-voigt",
    "standard-linear",
    "multimode-maxwell",
    "bingham",
    "power-law",
    "herschel-bulkley",
    "custom",
]

# What each law is made of; a constant that a law does not use is refused, never ignored.
CONSTANTS: dict[str, tuple[str, ...]] = {
    "elastic": ("youngs_modulus",),
    "maxwell": ("youngs_modulus", "viscosity"),
    "bingham": ("youngs_modulus", "viscosity", "yield_stress"),
}

# von Mises: the tensile value is this many times the shear one (THEORY 3).
FROM_SHEAR = {
    "viscosity": ("shear_viscosity", 3.0, "3 x shear_viscosity (Trouton)"),
    "yield_stress": ("shear_yield_stress", math.sqrt(3.0), "sqrt(3) x shear_yield_stress (von Mises)"),
}

_VISCOSITY = Quantity("viscosity", "13.84 kPa*s")
_STRESS = Quantity("stress", "9.32 kPa")
ShearViscosity = Annotated[float | None, _VISCOSITY]
ShearStress = Annotated[float | None, _STRESS]


class Material(Part):
    """A law and its constants, all tensile; SI.

    Attributes
    ----------
    law : str
        Name of the law.
    youngs_modulus : float or None
        E [Pa].
    viscosity : float or None
        Extensional viscosity eta [Pa s].
    yield_stress : float or None
        Tensile yield stress sY [Pa].
    poisson : float
        Poisson's ratio, used by shear only.
    shear_viscosity, shear_yield_stress : float or None
        What the tensile value was converted from, if it was; not part of the physics. See `notes`.

    Notes
    -----
    A constant that the law does not use is None.
    """

    table_name: ClassVar[str] = "material"

    law: Annotated[Law, Choice(get_args(Law))]
    youngs_modulus: ShearStress = Field(default=None, validate_default=True)
    shear_viscosity: ShearViscosity = Field(default=None, exclude=True, repr=False)
    viscosity: ShearViscosity = Field(default=None, validate_default=True)
    shear_yield_stress: ShearStress = Field(default=None, exclude=True, repr=False)
    yield_stress: ShearStress = Field(default=None, validate_default=True)
    shear_consistency: Annotated[tuple[()] | None, Empty()] = Field(default=None, exclude=True, repr=False)
    index: Annotated[float, Number(above=0)] = 1.0
    poisson: Annotated[float, Number(above=-1, below=0.5)] = 0.45
    second_modulus: Annotated[float | None, Quantity("stress", "1 MPa")] = None
    modes: Annotated[tuple[()], Empty()] = ()
    flow: Annotated[str, Text()] = ""
    parameters: Annotated[tuple[()], Empty()] = ()

    @field_validator("youngs_modulus", "viscosity", "yield_stress", mode="wrap")
    @classmethod
    def _as_the_law_needs(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> float | None:
        name = str(info.field_name)
        shear_name, factor, _ = FROM_SHEAR.get(name, ("", 0.0, ""))
        # None: not given. Absent: given, and already found faulty.
        shear = info.data.get(shear_name, math.nan) if shear_name else None
        if value is not None and shear is not None:
            raise refusal(f"given twice, here and as {shear_name}", "one of the two")
        result = handler(value) if value is not None else None if shear is None else factor * shear
        if result == math.inf:
            raise refusal(f"{factor:g} times {shear_name} is not finite", "a smaller value")
        _check_against_law(name, info.data.get("law"), result)
        return result

    @property
    def notes(self) -> tuple[str, ...]:
        """What was converted from shear data, in words."""
        return tuple(
            f"{name} = {words}: {getattr(self, name):.6g} {unit} from {shear:.6g} {unit}"
            for name, (shear_name, _, words) in FROM_SHEAR.items()
            for unit in ["Pa" if name == "yield_stress" else "Pa s"]
            if (shear := getattr(self, shear_name)) is not None
        )


def _check_against_law(name: str, law: str | None, value: float | None) -> None:
    if law not in CONSTANTS:
        return
    if value is None and name in CONSTANTS[law]:
        kind = _VISCOSITY if name == "viscosity" else _STRESS
        raise refusal(f"missing: the law '{law}' needs it", kind.accepted)
    if value is not None and name not in CONSTANTS[law]:
        laws = ", ".join(other for other, constants in CONSTANTS.items() if name in constants)
        verb = {"yield_stress": "yield", "viscosity": "flow"}.get(name, "use it")
        raise refusal(f"given, but the law '{law}' does not {verb}", f"leaving it out, or one of the laws {laws}")
