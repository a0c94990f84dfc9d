"""The dimensionless block: a scene given by its groups instead of its constants (THEORY 5)."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal, get_args

from pydantic import ValidationInfo, ValidatorFunctionWrapHandler, field_validator

from softcat_sym.scene.kinds import Choice, Number, refusal
from softcat_sym.scene.laws import GROUPED, Law
from softcat_sym.scene.part import Part
from softcat_sym.scene.shear_data import INDEXED

TimeUnit = Literal["gravity", "elastic"]
_GROUPED = f"one of the laws {', '.join(GROUPED)}"
Positive = Annotated[float | None, Number(above=0)]


class GroupBlock(Part):
    """The table ``[groups]``; dimensionless. It vanishes when the scene is resolved."""

    table_name: ClassVar[str] = "groups"

    delta: Annotated[float, Number(above=0, below=1)]
    """Thickness over span, h0/L."""
    law: Annotated[Law, Choice(get_args(Law))]
    """How the material answers to stress."""
    G: Positive = None
    """Gravity over yield stress, rho g L/sY."""
    V: Positive = None
    """Viscosity, eta/(rho sqrt(g L^3)); with an index K/(rho g L (L/g)^(n/2))."""
    eps_Y: Positive = None
    """Yield strain, sY/E."""
    E_star: Positive = None
    """Young's modulus over the weight, E/(rho g L)."""
    tau: Positive = None
    """Relaxation time over that of a fall, V/E_star."""
    B: Positive = None
    """1/(2 V)."""
    n: Annotated[float, Number(above=0)] = 1.0
    """Index of a law that has one."""
    ramp: Annotated[float | None, Number(above=0, closed=True)] = None
    """Time in which gravity grows, in units of groups.time_unit."""
    duration: Positive = None
    """Simulated time, in units of groups.time_unit."""
    time_unit: Annotated[TimeUnit, Choice(("gravity", "elastic"))] = "gravity"
    """Unit of groups.ramp and groups.duration; gravity: sqrt(L/g), elastic: L sqrt(rho/E)."""

    @field_validator("law", mode="wrap")
    @classmethod
    def _few_enough_constants(cls, value: Any, handler: ValidatorFunctionWrapHandler) -> Any:
        law = handler(value)
        if law not in GROUPED:
            raise refusal(f"the law '{law}' has more constants than groups", f"give physical values; or {_GROUPED}")
        return law

    @field_validator("n", mode="wrap")
    @classmethod
    def _of_laws_with_an_index(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        n, law = handler(value), info.data.get("law")
        if n != 1 and law is not None and law not in INDEXED:
            raise refusal(f"given, but the law '{law}' has no index", f"leaving it out, or {' or '.join(INDEXED)}")
        return n

    @field_validator("time_unit", mode="wrap")
    @classmethod
    def _of_laws_with_a_modulus(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        unit = handler(value)
        if unit == "elastic" and info.data.get("law") == "newtonian":
            raise refusal("'elastic', but the law 'newtonian' has no Young's modulus", "gravity")
        return unit
