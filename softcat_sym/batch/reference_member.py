"""The resolution that the members of a study share: that with which the run of the middle one ends, estimated."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from typing import Any

from softcat_sym.batch.members import Member, Row
from softcat_sym.batch.records import RecordColumn
from softcat_sym.discretization.assembly import choose_cells, choose_fibres
from softcat_sym.errors import SoftcatError
from softcat_sym.results.run import Run
from softcat_sym.simulate import recalled
from softcat_sym.solvers.settings import settings_for
from softcat_sym.solvers.solve import Prepared

RESOLUTION = {
    "cells": RecordColumn("1", "cells per half span"),
    "fibres": RecordColumn("1", "fibres of the section; NaN where it is not resolved by them"),
    "rtol": RecordColumn("1", "relative tolerance of the integrator"),
    "error_estimate": RecordColumn(
        "1", "estimated error of the midpoint over its largest; NaN where it was not estimated"
    ),
}
"""What is stored of a member's resolution."""

_GIVEN = ("cells", "rtol", "fibres", "order")


@dataclass(frozen=True)
class ReferenceMember:
    """The middle member of a study, run as :func:`softcat_sym.simulate` runs it."""

    row: Row  # What it changes in the scene
    cells: int | None = None  # With which it ended; None where nothing was found, and each member is on its own
    fibres: int | None = None
    rtol: float | None = None
    tighter: float = 1.0  # Share of the first guess that `rtol` is, at most one
    error: float | None = None  # Estimated, of its midpoint over its largest
    accuracy: float | None = None  # That was asked
    why_not: str = ""  # Why nothing was found

    def refine(self, member: Member) -> Member:
        """A member at this resolution, or at its own first guess where that is finer; what its scene says stays."""
        scene, numerics = member.scene, member.scene.numerics
        if self.cells is None:
            return member
        changes: dict[str, Any] = {}
        if numerics.cells is None:
            changes["cells"] = max(self.cells, choose_cells(scene, member.effects))
        by_itself = numerics.fibres is None and numerics.order is None and member.effects.terms().resolved
        if by_itself and self.fibres is not None:
            changes["fibres"] = max(self.fibres, choose_fibres(scene))
        if numerics.rtol is None and self.tighter < 1:
            changes["rtol"] = self.tighter * first_guess(member)
        if not changes:
            return member
        return replace(member, scene=scene.model_copy(update={"numerics": numerics.model_copy(update=changes)}))

    def __str__(self) -> str:
        """What was found, for a line of a table."""
        if self.cells is None:
            return f"each member's first guess: {self.why_not}"
        numbers = f"{self.cells} cells" + (f", {self.fibres} fibres" if self.fibres else "") + f", rtol {self.rtol:.2g}"
        error = "not found" if self.error is None else f"{self.error:.2g}"
        shown = {key: f"{value:.4g}" if isinstance(value, float) else value for key, value in self.row.items()}
        where = ", ".join(f"{key} = {value}" for key, value in shown.items())
        return f"{numbers} or finer; estimated error {error} ({self.accuracy:g} asked) at {where}"

    def to_dict(self) -> dict[str, Any]:
        """For the record."""
        return {name: value for name, value in asdict(self).items() if value not in (None, "")}


def first_guess(member: Member) -> float:
    """Relative tolerance of a member's first run."""
    return settings_for(member.scene, member.effects, compiled=member.backend.compiled).rtol


def reference_member(member: Member, row: Row) -> ReferenceMember:
    """Run the middle member and estimate its error, unless that is in the store."""
    scene = member.scene
    given = [getattr(scene.numerics, name) is not None for name in _GIVEN]
    if not scene.numerics.estimate:
        return ReferenceMember(row, why_not="numerics.estimate is false")
    if given[0] and given[1] and (given[2] or given[3] or not member.effects.terms().resolved):
        return ReferenceMember(row, why_not="numerics says all of it")
    try:
        run = recalled(scene)
    except (SoftcatError, ArithmeticError, RuntimeError, ValueError) as error:
        return ReferenceMember(row, why_not=f"the middle one fails, {' '.join(str(error).split())}")
    if run.scene.run.dimensions != scene.run.dimensions:
        return ReferenceMember(row, why_not="the middle one leaves its plane")
    at, errors = run.summary["resolution"], run.summary["error_estimate"] or {}
    if not run.outcome.is_success or not at:
        return ReferenceMember(row, why_not=f"the middle one has no answer, {run.outcome.value}")
    tighter = min(1.0, at["rtol"] / first_guess(member))
    found = {name: at[name] for name in ("cells", "fibres", "rtol")}
    return ReferenceMember(row, **found, tighter=tighter, error=errors.get("total"), accuracy=scene.run.accuracy)


def resolution_of(member: Member, prepared: Prepared) -> dict[str, float]:
    """Cells, fibres and tolerance of a run; NaN where no fibres resolve the section."""
    grid, by_fibres = prepared.graph.grid, member.effects.terms().resolved and member.scene.numerics.order is None
    return {
        "cells": grid.cells if grid.is_half else grid.cells // 2,
        "fibres": choose_fibres(member.scene) if by_fibres else math.nan,
        "rtol": prepared.settings.rtol,
    }


def resolution_of_run(run: Run) -> dict[str, float]:
    """The same of a run by :func:`softcat_sym.simulate`, and the error that was estimated."""
    summary, at, errors = run.summary, run.summary["resolution"] or {}, run.summary["error_estimate"] or {}
    found = {"cells": summary["cells"], "fibres": at.get("fibres"), "rtol": summary["rtol"]}
    found["error_estimate"] = errors.get("total")
    return {name: math.nan if value is None else value for name, value in found.items()}
