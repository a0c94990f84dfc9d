"""Numerical choices, only to overrule the program's own."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from softcat_sym.scene.kinds import Choice, Flag, Number, Whole
from softcat_sym.scene.part import Part

Solver = Literal["cvodes", "idas", "rosenbrock"]
Backend = Literal["auto", "interpreted", "compiled"]


class Numerics(Part):
    """Overrules; None means that the program chooses.

    Attributes
    ----------
    cells : int or None
        N, cells per half span.
    grading : float or None
        Length of the cells at midspan over that of the cells at the clamps; 1 makes all equal.
    order : int or None
        k, order of the plastic strain through the thickness.
    fibres : int or None
        Fibres through the thickness.
    solver : str or None
        Name of the integrator.
    rtol : float or None
        Its relative tolerance.
    backend : str
        ``"auto"``, ``"interpreted"`` or ``"compiled"``.
    estimate : bool
        Whether the error is estimated, by companions of the run on a coarser grid, and the run refined until it is
        below ``run.accuracy``.
    """

    table_name: ClassVar[str] = "numerics"

    cells: Annotated[int | None, Whole(4, 100_000)] = None
    grading: Annotated[float | None, Number(above=0, below=1000)] = None
    order: Annotated[int | None, Whole(1, 20)] = None
    fibres: Annotated[int | None, Whole(2, 1000)] = None
    solver: Annotated[Solver | None, Choice(("cvodes", "idas", "rosenbrock"))] = None
    rtol: Annotated[float | None, Number(above=0, below=1)] = None
    backend: Annotated[Backend, Choice(("auto", "interpreted", "compiled"))] = "auto"
    estimate: Annotated[bool, Flag()] = True
