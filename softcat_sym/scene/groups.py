"""The dimensionless block: a scene given by its groups instead of its constants (THEORY 5)."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal, get_args

from softcat_sym.scene.kinds import Choice, Number
from softcat_sym.scene.material import Law
from softcat_sym.scene.part import Part

TimeUnit = Literal["gravity", "elastic"]
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
        rho g L/sY, eta/(rho sqrt(g L^3)), sY/E [3.9, 3.10], E/(rho g L), V/E_star, 1/(2 V).
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
