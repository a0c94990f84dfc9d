"""The filament: how far it spans, how thick it is, what it weighs."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, ValidationInfo, ValidatorFunctionWrapHandler, field_validator

from softcat_sym.scene.kinds import Choice, Numbers, Quantity, refusal
from softcat_sym.scene.part import Part
from softcat_sym.scene.units import shown

Section = Literal["rectangle", "circle", "sheet"]
Length = Annotated[float, Quantity("length", "6 mm")]


class Filament(Part):
    """Geometry and density; lengths in m, density in kg/m^3."""

    table_name: ClassVar[str] = "filament"

    span: Annotated[float, Quantity("length", "0.2 m")]
    """Horizontal distance between the supports, L."""
    rest_length: Annotated[float | None, Quantity("length", "0.21 m")] = None
    """Length of the reference configuration; the distance between the supports over initial.stretch unless given."""
    thickness: Length
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

    @field_validator("thickness", mode="wrap")
    @classmethod
    def _thinner_than_long(cls, value: Any, handler: ValidatorFunctionWrapHandler, info: ValidationInfo) -> Any:
        thickness = handler(value)
        span = info.data.get("span")
        if span is not None and thickness >= span:
            raise refusal(f"{shown(value)} is not less than the span", f"a thickness below the span, {span:g} m")
        return thickness

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

    def follows(self) -> dict[str, str]:
        """Name the values that only repeat another, and need not be written: ``{field: the other}``."""
        return {"width": "thickness"} if self.width == self.thickness else {}
