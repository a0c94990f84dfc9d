"""A comparison as tables (CSV) and as one JSON document."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.graph.grid import Floats
from softcat_sym.report.compare_rate import rate_fields
from softcat_sym.report.compare_shapes import shape_pairs
from softcat_sym.study import clamp_strain, discrepancy

if TYPE_CHECKING:
    from softcat_sym.study.compare import Comparison, FilamentRow


def midpoint_csv(comparison: Comparison) -> bytes:
    """Midpoints [m] of all, frame by frame; empty after a run has ended early."""
    columns = {"time_s": comparison.elements.time, "elements_m": comparison.elements.midpoint}
    return _csv(columns | {f"{_key(row)}_m": row.midpoint for row in comparison.filaments})


def clamp_csv(comparison: Comparison) -> bytes:
    """Mean and largest axial true strain at the clamp, of all, frame by frame."""
    rows = [("elements", comparison.clamp_strain)] + [(_key(row), row.clamp_strain) for row in comparison.filaments]
    strains = {f"{name}_{which}": getattr(strain, which) for name, strain in rows for which in ("mean", "largest")}
    return _csv({"time_s": comparison.elements.time, **strains})


def errors_csv(comparison: Comparison) -> bytes:
    """The error table: a column for each theory; a row for each moment, the mean and the largest error."""
    frames = discrepancy.moments(len(comparison.elements.time))
    what = [*("error" for _ in frames), "mean error", "largest error"]
    time = [*(float(comparison.elements.time[frame]) for frame in frames), math.nan, math.nan]
    found = {_key(row): row.discrepancy for row in comparison.filaments}
    return _csv({"what": what, "time_s": time, **{key: [*d.at, d.mean, d.largest] for key, d in found.items()}})


def shapes_csv(comparison: Comparison) -> bytes:
    """Half centrelines of elements and filament at the moments of the error table [m]."""
    pairs = shape_pairs(comparison)
    places = {"X_m": [pair.X for pair in pairs]}
    for who in ("elements", "filament"):
        places |= {f"{who}_{axis}_m": [getattr(pair, who)[:, k] for pair in pairs] for k, axis in enumerate("xy")}
    time = [np.full(len(pair.X), pair.time) for pair in pairs]
    return _csv({name: np.concatenate(parts) for name, parts in {"time_s": time, **places}.items()})


def rate_csv(comparison: Comparison) -> bytes:
    """Plastic shear rate [1/s] of the elements at their Gauss points, at the moments that are drawn."""
    fields = rate_fields(comparison.elements, comparison.scene.filament.thickness)
    parts = {
        "time_s": [np.full(field.rate.size, field.time) for field in fields],
        "X_m": [field.X.ravel() for field in fields],
        "Y_m": [field.Y.ravel() for field in fields],
        "plastic_shear_rate_per_s": [field.rate.ravel() for field in fields],
    }
    return _csv({name: np.concatenate(values) for name, values in parts.items()})


def document(comparison: Comparison) -> dict[str, Any]:
    """What ``compare.json`` holds; every number finite or null.

    ``elements`` and each filament state ``midpoint_final_m``, ``midpoint_mean_m`` (over the last 6/7), ``wall_s`` and
    ``dofs``.
    """
    own, run = comparison.filament, comparison.elements
    summary = own.trajectory.summary
    frames = discrepancy.moments(len(run.time))
    times = [float(run.time[frame]) for frame in frames]
    found = {
        "title": comparison.scene.title,
        "outcome": summary["outcome"],
        "advice": summary["advice"],
        "complaint": summary["complaint"],
        "warnings": list(comparison.warnings),
        "elements": {
            **_midpoints(run.time, run.midpoint),
            "wall_s": run.wall,
            "dofs": run.dofs,
            "along": run.mesh.along,
            "through": run.mesh.through,
            "clamp": run.clamp.name.lower(),
            "steps": run.steps,
            "energy_error": run.energy_error,
        },
        **{_key(row): _filament(row, run.time) for row in comparison.filaments},
        "errors": {
            "definition": discrepancy.DEFINITION,
            "time_s": times,
            "time_elastic": [time / run.elastic_time for time in times],
            **{_key(row): _errors(row) for row in comparison.filaments},
        },
        "clamp_strain_final": {
            "definition": clamp_strain.DEFINITION,
            "elements": _last(comparison.clamp_strain),
            **{_key(row): _last(row.clamp_strain) for row in comparison.filaments},
        },
    }
    return dict(_finite(found))


def _key(row: FilamentRow) -> str:
    return row.name.replace(",", "").replace(" ", "_")


def _midpoints(time: Floats, midpoint: Floats) -> dict[str, float]:
    return {"midpoint_final_m": float(midpoint[-1]), "midpoint_mean_m": float(midpoint[discrepancy.late(time)].mean())}


def _filament(row: FilamentRow, time: Floats) -> dict[str, Any]:
    summary = row.trajectory.summary
    names = ("outcome", "complaint", "regime", "closure", "cells", "solver", "steps", "energy_residual")
    return {
        **_midpoints(time, row.midpoint),
        "wall_s": summary["wall_s"]["total"],
        "solve_s": summary["wall_s"]["solve"],
        "dofs": row.dofs,
        "effects": list(summary["effects"]),
        **{name: summary[name] for name in names},
    }


def _errors(row: FilamentRow) -> dict[str, Any]:
    return {"at": list(row.discrepancy.at), "mean": row.discrepancy.mean, "largest": row.discrepancy.largest}


def _last(strain: clamp_strain.ClampStrain) -> dict[str, float]:
    return {"mean": float(strain.mean[-1]), "largest": float(strain.largest[-1])}


def _finite(value: Any) -> Any:
    """The same with null in place of what JSON cannot say."""
    if isinstance(value, Mapping):
        return {name: _finite(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(part) for part in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _csv(columns: Mapping[str, Sequence[str] | Iterable[float] | Floats]) -> bytes:
    """Columns under their names; every number reads back exactly, what is not there is empty."""
    lists = [values.tolist() if isinstance(values, np.ndarray) else list(values) for values in columns.values()]
    rows = [",".join(_cell(value) for value in row) for row in zip(*lists, strict=True)]
    return "\n".join([",".join(columns), *rows, ""]).encode()


def _cell(value: object) -> str:
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else ""
    return str(value)
