"""The filament: how far it spans, how thick it is, what it weighs."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, ValidationInfo, ValidatorFunctionWrapHandler, field_validator, model_validator

from softcat_sym.scene.kinds import Choice, Numbers, Quantity, refusal
from softcat_sym.scene.part import Part
from softcat_sym.scene.units import shown

Section = Literal["rectangle", "circle", "sheet"]
_THICKNESS = Quantity("length", "6 mm")
Length = Annotated[float, _THICKNESS]


class Filament(Part):
    """Geometry and density; lengths in m, density in kg/m^3."""

    table_name: ClassVar[str] = "filament"

    span: Annotated[float, Quantity("length", "0.2 m")]
    """Horizontal distance between the supports, L."""
    rest_length: Annotated[float | None, Quantity("length", "0.21 m")] = None
    """Length of the reference configuration; the distance between the supports over initial.stretch unless given."""
    diameter: Annotated[float | None, Quantity("length", "6 mm")] = Field(default=None, exclude=True, repr=False)
    """Diameter of a circle, which the section then is; instead of thickness."""
    thickness: Length = Field(default=None, validate_default=True)
    """h0, in the plane of bending; the diameter of a circle."""
    section: Annotated[Section, Choice(("rectangle", "circle", "sheet"))] = "rectangle"
    """Shape of the cross-section."""
    width: Length = Field(default=None, validate_default=True)
    """D0, across the plane of bending; the thickness unless given."""
    density: Annotated[float, Quantity("density", "1900 kg/m^3")]
    """Mass per volume, rho."""
    profile: Annotated[tuple[float, ...], Numbers(above=0, least=2)] = ()
    """Relative thickness at equally spaced points from left to right, linear between them; empty: 1."""
    curvature: Annotated[float, Quantity("curvature", "0 1/m", "any")] = 0.0
    """Natural curvature."""

    @model_validator(mode="before")
    @classmethod
    def _round_if_it_has_a_diameter(cls, data: Any) -> Any:
        return {"section": "circle", **data} if isinstance(data, dict) and data.get("diameter") is not None else data

    @field_validator("thickness", mode="wrap")
    @classmethod
    def _thinner_than_long(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        diameter = info.data.get("diameter", math.nan)
        if value is None and diameter is None:
            raise refusal("missing", f"{_THICKNESS.accepted}, or filament.diameter")
        if value is not None and diameter is not None:
            raise refusal("given twice, here and as filament.diameter", "one of the two")
        thickness = diameter if value is None else handler(value)
        span = info.data.get("span")
        if span is not None and thickness >= span:
            found = shown(value) if diameter is None else f"the diameter, {diameter:g} m,"
            raise refusal(f"{found} is not less than the span", f"a thickness below the span, {span:g} m")
        return thickness

    @field_validator("section", mode="wrap")
    @classmethod
    def _round_where_it_has_a_diameter(
        cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo
    ) -> Any:
        section = handler(value)
        if section != "circle" and info.data.get("diameter") is not None:
            raise refusal(
                f"{shown(value)}, but filament.diameter is given",
                "circle, or filament.thickness instead of filament.diameter",
            )
        return section

    @field_validator("width", mode="wrap")
    @classmethod
    def _follow_thickness(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        # NaN never escapes: without a thickness there is a fault, and with a fault there is no filament.
        thickness = info.data.get("thickness", math.nan)
        if value is None:
            return thickness
        width = handler(value)
        if info.data.get("section") == "circle" and math.isfinite(thickness) and width != thickness:
            raise refusal("a circle has no width of its own", "leaving it out; the diameter is filament.thickness")
        return width

    @property
    def notes(self) -> tuple[str, ...]:
        """What was given under another name, in words and numbers."""
        return () if self.diameter is None else (f"thickness = diameter of a circle: {self.thickness:.6g} m",)

    def follows(self) -> dict[str, str]:
        """Name the values that only repeat another, and need not be written: ``{field: the other}``."""
        return {"width": "thickness"} if self.width == self.thickness else {}
