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
    """The table ``[groups]``; dimensionless. It vanishes when the scene is resolved.

    Attributes
    ----------
    delta : float
        Thickness over span, h0/L.
    law : str
        Name of the law.
    G, V, eps_Y, E_star, tau, B : float or None
        rho g L/sY, eta/(rho sqrt(g L^3)), sY/E [3.9, 3.10], E/(rho g L), V/E_star, 1/(2 V). With an index
        V is K/(rho g L (L/g)^(n/2)).
    n : float
        Index of a power law.
    ramp, duration : float or None
        In units of `time_unit`.
    time_unit : str
        ``"gravity"``: sqrt(L/g); ``"elastic"``: L sqrt(rho/E).
    """

    table_name: ClassVar[str] = "groups"

    delta: Annotated[float, Number(above=0, below=1)]
    law: Annotated[Law, Choice(get_args(Law))]
    G: Positive = None
    V: Positive = None
    eps_Y: Positive = None
    E_star: Positive = None
    tau: Positive = None
    B: Positive = None
    n: Annotated[float, Number(above=0)] = 1.0
    ramp: Annotated[float | None, Number(above=0, closed=True)] = None
    duration: Positive = None
    time_unit: Annotated[TimeUnit, Choice(("gravity", "elastic"))] = "gravity"

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
