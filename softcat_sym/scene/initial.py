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
        Stretch before the load acts.
    relaxed : bool
        Whether that stretch is free of stress.
    P, C : tuple of float
        The plastic state itself.
    """

    table_name: ClassVar[str] = "initial"

    stretch: Annotated[float, Number(above=0)] = 1.0
    relaxed: Annotated[bool, Flag()] = True
    P: Annotated[tuple[float, ...], Numbers()] = ()
    C: Annotated[tuple[float, ...], Numbers()] = ()
