"""Numerical choices, only to overrule the program's own."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from softcat_sym.scene.kinds import Choice, Flag, Number, Whole
from softcat_sym.scene.part import Part

Solver = Literal["cvodes", "idas", "rosenbrock"]
Backend = Literal["auto", "interpreted", "compiled"]


class Numerics(Part):
    """Overrules; None means that the program chooses."""

    table_name: ClassVar[str] = "numerics"

    cells: Annotated[int | None, Whole(4, 100_000)] = None
    """N, cells per half span; chosen by the program unless given."""
    grading: Annotated[float | None, Number(above=0, below=1000)] = None
    """Length of the cells at midspan over that at the clamps, 1: all equal; chosen by the program unless given."""
    order: Annotated[int | None, Whole(1, 20)] = None
    """k, order of the plastic strain through the thickness; chosen by the program unless given."""
    fibres: Annotated[int | None, Whole(2, 1000)] = None
    """Fibres through the thickness; chosen by the program unless given."""
    solver: Annotated[Solver | None, Choice(("cvodes", "idas", "rosenbrock"))] = None
    """Integrator; chosen by the program unless given."""
    rtol: Annotated[float | None, Number(above=0, below=1)] = None
    """Relative tolerance of the integrator; chosen by the program unless given."""
    backend: Annotated[Backend, Choice(("auto", "interpreted", "compiled"))] = "auto"
    """Interpreted by CasADi, or compiled from generated C; auto: compiled where there is a C compiler."""
    estimate: Annotated[bool, Flag()] = True
    """Whether the error is estimated on other grids, and the run refined until it is below run.accuracy."""
