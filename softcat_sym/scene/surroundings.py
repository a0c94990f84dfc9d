"""What surrounds the filament."""

from __future__ import annotations

from typing import Annotated, ClassVar

from softcat_sym.scene.kinds import Quantity
from softcat_sym.scene.part import Part


class Surroundings(Part):
    """The medium around the filament; SI."""

    table_name: ClassVar[str] = "surroundings"

    surface_tension: Annotated[float, Quantity("surface tension", "21 mN/m", "non-negative")] = 0.0
    """Surface tension Gamma between the filament and what surrounds it."""
