"""The state the filament starts from."""

from __future__ import annotations

from typing import Annotated, ClassVar

from softcat_sym.scene.kinds import Flag, Number, Numbers
from softcat_sym.scene.part import Part


class Initial(Part):
    """State at the first instant; dimensionless."""

    table_name: ClassVar[str] = "initial"

    stretch: Annotated[float, Number(above=0)] = 1.0
    """Stretch before the load acts, s0."""
    relaxed: Annotated[bool, Flag()] = True
    """Whether that stretch is free of stress, a plastic strain log(s0) everywhere, or elastic."""
    P: Annotated[tuple[float, ...], Numbers()] = ()
    """Mean plastic strain P/A0 at equally spaced material points from left to right; one value: everywhere."""
    C: Annotated[tuple[float, ...], Numbers()] = ()
    """Bending plastic strain at the surface, C/(A0 (h0/2) <zeta^2>), likewise."""
