"""The state the filament starts from."""

from __future__ import annotations

from typing import Annotated, ClassVar

from softcat_sym.scene.kinds import Flag, Number, Numbers
from softcat_sym.scene.part import Part


class Initial(Part):
    """State at the first instant; dimensionless.

    Attributes
    ----------
    stretch : float
        Stretch before the load acts, s0; the rest length is the distance over it unless given.
    relaxed : bool
        Whether that stretch is free of stress: a plastic strain log(s0) everywhere.
    P, C : tuple of float
        Mean plastic strain P/A0, and bending plastic strain at the surface, C/(A0 (h0/2) <zeta^2>), at equally spaced
        material points from left to right; one value stands for everywhere.
    """

    table_name: ClassVar[str] = "initial"

    stretch: Annotated[float, Number(above=0)] = 1.0
    relaxed: Annotated[bool, Flag()] = True
    P: Annotated[tuple[float, ...], Numbers()] = ()
    C: Annotated[tuple[float, ...], Numbers()] = ()
