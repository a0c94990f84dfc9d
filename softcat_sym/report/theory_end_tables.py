"""Where the theory ends, as tables (CSV) and as one JSON document."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from softcat_sym.report.compare_tables import document as comparison_document
from softcat_sym.study import theory_end_error
from softcat_sym.study.discrepancy import moments
from softcat_sym.study.theory_end_limit import Limit

if TYPE_CHECKING:
    from softcat_sym.reference import ElementRun
    from softcat_sym.study.compare import FilamentRow
    from softcat_sym.study.theory_end import Measured, TheoryEnd

LIMIT_DEFINITION = (
    "fit of e0 + a delta (+ b delta^2 from five values on) to the errors; leaving_out: largest change of e0 when one "
    "value is left out; mesh: change of e0 when the coarser elements judge; order: power of delta between the two "
    "thinnest filaments"
)


def key_of(name: str) -> str:
    """A theory's name as a key: ``published_material_closure``."""
    return name.replace(",", "").replace(" ", "_")


def moment_names(end: TheoryEnd) -> tuple[str, ...]:
    """What the errors of :class:`RelativeError` belong to: ``t = 46``, ..., ``mean``, ``largest``."""
    run = end.measured[0].comparison.elements
    times = (run.time[frame] / run.elastic_time for frame in moments(len(run.time)))
    return (*(f"t = {time:.4g}" for time in times), "mean", "largest")


def errors_csv(end: TheoryEnd) -> bytes:
    """A row for each value and theory; the elements' own rows are those of the coarser against the finer."""
    names = [name.replace(" = ", "_") for name in moment_names(end)]
    header = ["value", "theory", "outcome", "regime", "midpoint_final_over_span", *names, "grid"]
    rows: list[Sequence[object]] = []
    for one in end.measured:
        span = one.comparison.scene.filament.span
        for run, error in ((one.comparison.elements, None), (one.coarse, one.mesh)):
            values = [None] * len(names) if error is None else error.values
            rows.append([one.value, mesh_name(run), "", "", run.midpoint[-1] / span, *values, None])
        for theory in one.theories:
            summary, last = theory.row.trajectory.summary, theory.row.midpoint[-1] / span
            told = [theory.row.name.replace(",", ""), summary["outcome"], summary["regime"] or ""]
            rows.append([one.value, *told, last, *theory.error.values, theory.grid])
    rows += [[lost.value, "", "not run", "", None, *[None] * len(names), None] for lost in end.unmeasured]
    return _csv(header, rows)


def limits_csv(end: TheoryEnd) -> bytes:
    """A row for each theory and moment that has a limit."""
    header = ["theory", "moment", "intercept", "uncertainty", "leaving_out", "mesh", "slope", "order"]
    rows: list[Sequence[object]] = []
    for name, limits in end.limits.items():
        for moment, limit in zip(moment_names(end), limits, strict=True):
            if limit is not None:
                parts = (limit.intercept, limit.uncertainty, limit.leaving_out, limit.mesh, limit.coefficients[1])
                rows.append([name.replace(",", ""), moment, *parts, limit.order])
    return _csv(header, rows)


def cost_rows(one: Measured) -> Iterator[tuple[str, int, int, float, float | None, float]]:
    """Who, unknowns, steps, seconds of the solve and in all, largest error; the elements' seconds are of their steps.

    The finer elements come first, with the error that their coarser companions have against them; the coarser have the
    same.
    """
    for run in (one.comparison.elements, one.coarse):
        yield mesh_name(run), run.dofs, run.steps, run.wall, None, one.mesh.largest
    for theory in one.theories:
        summary = theory.row.trajectory.summary
        wall = summary["wall_s"]
        yield theory.row.name, theory.row.dofs, summary["steps"], wall["solve"], wall["total"], theory.error.largest


def cost_csv(end: TheoryEnd) -> bytes:
    """A row for each value and run, with the ratios of the finer elements over it."""
    header = ["value", "run", "dofs", "steps", "solve_s", "total_s", "largest_error"]
    header += ["dofs_ratio", "steps_ratio", "solve_ratio"]
    rows: list[Sequence[object]] = []
    for one in end.measured:
        run = one.comparison.elements
        for name, dofs, steps, solve, total, error in cost_rows(one):
            ratios = (_over(run.dofs, dofs), _over(run.steps, steps), _over(run.wall, solve))
            rows.append([one.value, name.replace(",", ""), dofs, steps, solve, total, error, *ratios])
    return _csv(header, rows)


def document(end: TheoryEnd) -> dict[str, Any]:
    """What ``compare.json`` holds of a varied scene; every number finite or null.

    Each of ``values`` holds what a comparison of that scene alone would, and beside it the errors of this study.
    """
    found = {
        "title": end.scene.title,
        "vary": end.variation.path,
        "definition": theory_end_error.DEFINITION,
        "moments": list(moment_names(end)),
        "values": [_value(one) for one in end.measured],
        "not_run": [{"value": lost.value, "reason": lost.reason} for lost in end.unmeasured],
        "slender_limit": {
            "definition": LIMIT_DEFINITION,
            **{key_of(name): [_limit(limit) for limit in limits] for name, limits in end.limits.items()},
        }
        if end.limits
        else None,
    }
    return dict(_finite(found))


def mesh_name(run: ElementRun) -> str:
    """``elements 32 x 4``, with the grading if there is one."""
    mesh = run.mesh
    graded = f" graded {mesh.grading:g}" if mesh.grading != 1 else ""
    return f"elements {mesh.along} x {mesh.through}{graded}"


def _value(one: Measured) -> dict[str, Any]:
    coarse = one.coarse
    return {
        "value": one.value,
        **comparison_document(one.comparison),
        "mesh_grading": one.comparison.elements.mesh.grading,
        "elements_coarser": {
            "along": coarse.mesh.along,
            "through": coarse.mesh.through,
            "midpoint_final_m": float(coarse.midpoint[-1]),
            "wall_s": coarse.wall,
            "dofs": coarse.dofs,
            "steps": coarse.steps,
            "errors": list(one.mesh.values),
        },
        "theory_errors": {
            key_of(theory.row.name): {
                "errors": list(theory.error.values),
                "trusted": theory.error.trusted,
                "grid": theory.grid,
                **_ratios(one.comparison.elements, theory.row),
            }
            for theory in one.theories
        },
    }


def _ratios(run: ElementRun, row: FilamentRow) -> dict[str, float]:
    summary = row.trajectory.summary
    return {
        "dofs_ratio": _over(run.dofs, row.dofs),
        "steps_ratio": _over(run.steps, summary["steps"]),
        "solve_ratio": _over(run.wall, summary["wall_s"]["solve"]),
    }


def _limit(limit: Limit | None) -> dict[str, Any] | None:
    if limit is None:
        return None
    return {
        "intercept": limit.intercept,
        "uncertainty": limit.uncertainty,
        "leaving_out": limit.leaving_out,
        "mesh": limit.mesh,
        "coefficients": list(limit.coefficients),
        "order": limit.order,
    }


def _over(one: float, other: float) -> float:
    return one / other if other else math.nan


def _finite(value: Any) -> Any:
    """The same with null in place of what JSON cannot say."""
    if isinstance(value, Mapping):
        return {name: _finite(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(part) for part in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _csv(header: Sequence[str], rows: Sequence[Sequence[object]]) -> bytes:
    """Rows under a header; every number reads back exactly, what is not there is empty."""
    lines = [",".join(header), *(",".join(_cell(cell) for cell in row) for row in rows)]
    return "\n".join([*lines, ""]).encode()


def _cell(value: object) -> str:
    if isinstance(value, float):
        # NumPy's own floats print their type with repr.
        return repr(float(value)) if math.isfinite(value) else ""
    return "" if value is None else str(value)
