"""A comparison with finite elements as tables, on the terminal, and as files."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.files import write_all
from softcat_sym.plotting import style
from softcat_sym.plotting.compare_axes import LEFT, RIGHT, elements_name, legend_row, plain_numbers
from softcat_sym.plotting.compare_clamp import clamp_figure
from softcat_sym.plotting.compare_midpoint import midpoint_figure
from softcat_sym.plotting.compare_rate import rate_fields, rate_figure
from softcat_sym.plotting.compare_shapes import shape_pairs, shapes_figure
from softcat_sym.plotting.style import (
    HEADING,
    axes_in_inches,
    head,
    length_unit,
    new_figure,
    png,
    significant,
    time_unit,
)
from softcat_sym.studies import compare
from softcat_sym.studies.compare import SHARES, late, moments

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.reference.calculix import Deck
    from softcat_sym.scene.scene import Scene
    from softcat_sym.studies.compare import CalculixComparison, CalculixRow, Comparison, FilamentRow


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
    frames = compare.moments(len(comparison.elements.time))
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
    frames = compare.moments(len(run.time))
    times = [float(run.time[frame]) for frame in frames]
    found = {
        "title": comparison.scene.title,
        "outcome": summary["outcome"],
        "advice": summary["advice"],
        "message": summary["message"],
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
            "definition": compare.DEFINITION,
            "time_s": times,
            "time_elastic": [time / run.elastic_time for time in times],
            **{_key(row): _errors(row) for row in comparison.filaments},
        },
        "clamp_strain_final": {
            "definition": compare.CLAMP_STRAIN_DEFINITION,
            "elements": _last(comparison.clamp_strain),
            **{_key(row): _last(row.clamp_strain) for row in comparison.filaments},
        },
    }
    return dict(_finite(found))


def _key(row: FilamentRow) -> str:
    return row.name.replace(",", "").replace(" ", "_")


def _midpoints(time: Floats, midpoint: Floats) -> dict[str, float]:
    return {"midpoint_final_m": float(midpoint[-1]), "midpoint_mean_m": float(midpoint[compare.late(time)].mean())}


def _filament(row: FilamentRow, time: Floats) -> dict[str, Any]:
    summary = row.trajectory.summary
    names = ("outcome", "message", "regime", "closure", "cells", "solver", "steps", "energy_residual")
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


def _last(strain: compare.ClampStrain) -> dict[str, float]:
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


def comparison_columns(comparison: Comparison) -> list[tuple[str, ...]]:
    """One column for the elements, one for each filament, as texts below the names in `row_names`."""
    span, run = comparison.scene.filament.span, comparison.elements
    none = ("",) * (len(SHARES) + 2)
    columns = [
        (elements_name(comparison), _ratio(run.midpoint[-1] / span), *none, str(run.dofs), significant(run.wall))
    ]
    for row in comparison.filaments:
        found = row.discrepancy
        errors = (_percent(error) for error in (*found.at, found.mean, found.largest))
        wall = significant(row.trajectory.summary["wall_s"]["total"])
        columns.append((row.name, _ratio(row.midpoint[-1] / span), *errors, str(row.dofs), wall))
    return columns


def row_names(comparison: Comparison) -> tuple[str, ...]:
    """What stands left of the columns; the first is the name of the column."""
    run = comparison.elements
    times = (run.time[frame] / run.elastic_time for frame in moments(len(run.time)))
    errors = (f"error at t = {time:.4g}" for time in times)
    return ("", "final midpoint / L", *errors, "mean error", "largest error", "unknowns", "wall time [s]")


def comparison_table(comparison: Comparison) -> Table:
    """Lay the columns out below the names of the theories."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    note = "errors in %: (filament − elements)/max |elements|, midpoint; t in L √(ρ/E)"
    table = Table(
        title=Text(comparison.scene.title or "Filament", style="bold"),
        title_justify="left",
        caption=Text(note, style="dim"),
        caption_justify="left",
        box=box.SIMPLE_HEAD,
    )
    columns = [row_names(comparison), *comparison_columns(comparison)]
    for column in columns:
        name = column[0].replace("elements ", "elements\n").replace(", ", ",\n").replace(" closure", "\nclosure")
        table.add_column(Text(name), justify="left" if column is columns[0] else "right", no_wrap=True)
    for row in list(zip(*columns, strict=True))[1:]:
        table.add_row(*(Text(text) for text in row))
    return table


def remarks(comparison: Comparison) -> list[str]:
    """What a reader must know beside the numbers: each run that is not to be trusted, and every warning."""
    rows = ((row.name, row.trajectory) for row in comparison.filaments)
    bad = [f"{name}: {run.outcome.name}; {run.outcome.value}" for name, run in rows if not run.outcome.is_success]
    return [*bad, *(f"warning: {text}" for text in comparison.warnings)]


def print_comparison(comparison: Comparison, console: Console | None = None) -> None:
    """Print the table and the remarks."""
    from rich.console import Console
    from rich.text import Text

    screen = console or Console()
    screen.print(comparison_table(comparison))
    for text in remarks(comparison):
        screen.print(Text(text))


def _ratio(value: float) -> str:
    return f"{value:.5f}" if math.isfinite(value) else "–"


def _percent(error: float) -> str:
    if not math.isfinite(error):
        return "–"
    return f"{100 * error:+.2f}" if abs(error) < 1 else f"{100 * error:+.3g}"


def write_comparison(comparison: Comparison, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``scene.toml``, four pictures and their tables.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    contents = {
        "compare.json": (json.dumps(document(comparison), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": comparison.scene.to_toml().encode(),
        "compare_midpoint.png": png(midpoint_figure(comparison)),
        "compare_shapes.png": png(shapes_figure(comparison)),
        "compare_plastic_rate.png": png(rate_figure(comparison)),
        "compare_clamp_strain.png": png(clamp_figure(comparison)),
        "compare_errors.csv": errors_csv(comparison),
        "compare_midpoint.csv": midpoint_csv(comparison),
        "compare_shapes.csv": shapes_csv(comparison),
        "compare_plastic_rate.csv": rate_csv(comparison),
        "compare_clamp_strain.csv": clamp_csv(comparison),
    }
    return write_all(directory, contents)


_HEIGHT, _BOTTOM, _GAP, _RESIDUAL, _ABOVE, _ROOM = 5.6, 0.55, 0.2, 1.5, 0.72, 1.15

_REFERENCE: dict[str, Any] = {"color": style.BLACK, "linewidth": 2.6, "alpha": 0.45}
_LINES: dict[str, dict[str, Any]] = {
    "filament": {"color": style.BLUE, "linewidth": 1.3},
    "elements": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
}


def calculix_figure(comparison: CalculixComparison) -> Figure:
    """Draw midpoints above, (ours - CalculiX)/max |CalculiX| below."""
    run, span = comparison.calculix, comparison.scene.filament.span
    clock = time_unit(float(run.time[-1]))
    ruler = length_unit(float(np.abs(run.midpoint).max()), span)
    time = clock.of(run.time)
    with style.styled():
        figure = new_figure(style.WIDTH, _HEIGHT)
        head(figure, "midpoint, ours against CalculiX", comparison.trajectory.summary, comparison.scene, LEFT)
        width, bottom = style.WIDTH - LEFT - RIGHT, _BOTTOM + _RESIDUAL + _GAP
        above = axes_in_inches(figure, LEFT, bottom, width, _HEIGHT - HEADING - _ABOVE - bottom)
        below = axes_in_inches(figure, LEFT, _BOTTOM, width, _RESIDUAL)
        name = f"CalculiX {run.mesh.along} × {run.mesh.through}"
        above.plot(time, ruler.of(run.midpoint), label=name, **_REFERENCE)
        below.axhline(0.0, color=style.GREY, linewidth=0.6)
        for row in comparison.rows:
            above.plot(time, ruler.of(row.midpoint), label=row.name, **_LINES[row.name])
            below.plot(time, 100 * row.discrepancy.error, **_LINES[row.name])
        far = 2 * float(ruler.of(np.abs(run.midpoint).max())) or 1.0
        low, high = above.get_ylim()
        above.set_ylim(max(low, -far), min(high, far))
        known = np.nan_to_num([100 * row.discrepancy.largest for row in comparison.rows])
        shown = float(known.max()) or 1.0
        below.set_ylim(-_ROOM * shown, _ROOM * shown)
        above.set_ylabel(f"midpoint height [{ruler.symbol}]")
        below.set_ylabel("(ours − CalculiX)\n/ max |CalculiX| [%]", fontsize=8.0)
        for axes in (above, below):
            axes.set_xlim(0.0, float(time[-1]))
            axes.grid(True)
            style.lighten(axes)
            plain_numbers(axes)
        above.tick_params(labelbottom=False)
        below.set_xlabel(f"time [{clock.symbol}]")
        factor = clock.size / run.elastic_time
        top = above.secondary_xaxis(
            "top", functions=(lambda t: np.asarray(t) * factor, lambda t: np.asarray(t) / factor)
        )
        top.set_xlabel("time in L √(ρ/E)")
        legend_row(figure, above, _HEIGHT - HEADING)
    return figure


FOLDER = "calculix"
"""Where deck and print-outs go, in the folder of a comparison."""

_DEFINITION = (
    "(ours - CalculiX)/max |CalculiX| of the midpoint's height: positive where ours sags less; mean: over the frames "
    "of the last 6/7 of the duration; largest: in magnitude, over all frames"
)


def write_deck(scene: Scene, deck: Deck, directory: str | Path) -> list[Path]:
    """Write ``scene.toml`` and ``calculix/deck.inp``."""
    folder = Path(directory)
    written = write_all(folder / FOLDER, {"deck.inp": deck.text.encode("ascii")})
    return [*written, *write_all(folder, {"scene.toml": scene.to_toml().encode()})]


def write_calculix_comparison(comparison: CalculixComparison, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``compare_midpoint.png`` and ``.csv``, ``scene.toml``, and ``calculix/`` with the deck.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    folder = Path(directory)
    contents = {
        "compare.json": (json.dumps(calculix_document(comparison), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": comparison.scene.to_toml().encode(),
        "compare_midpoint.png": png(calculix_figure(comparison)),
        "compare_midpoint.csv": _midpoint_csv(comparison),
    }
    return [*write_all(folder, contents), *write_all(folder / FOLDER, comparison.calculix.files)]


def calculix_document(comparison: CalculixComparison) -> dict[str, Any]:
    """What ``compare.json`` holds; every number finite or null."""
    run, summary = comparison.calculix, comparison.trajectory.summary
    times = [float(run.time[frame]) for frame in moments(len(run.time))]
    return {
        "title": comparison.scene.title,
        "engine": "calculix",
        "outcome": summary["outcome"],
        "advice": summary["advice"],
        "message": summary["message"],
        "warnings": list(comparison.warnings),
        "calculix": {
            **_calculix_midpoints(run.time, run.midpoint),
            "wall_s": run.wall,
            "dofs": run.dofs,
            "steps": run.steps,
            "along": run.mesh.along,
            "through": run.mesh.through,
            "clamp": run.clamp.name.lower(),
        },
        **{
            row.name: {
                **_calculix_midpoints(run.time, row.midpoint),
                "wall_s": row.wall,
                "dofs": row.dofs,
                "steps": row.steps,
            }
            for row in comparison.rows
        },
        "errors": {
            "definition": _DEFINITION,
            "time_s": times,
            "time_elastic": [time / run.elastic_time for time in times],
            **{row.name: _calculix_errors(row) for row in comparison.rows},
        },
    }


def calculix_table(comparison: CalculixComparison) -> Table:
    """The table that is printed: CalculiX and ours side by side."""
    from rich import box
    from rich.table import Table

    run, span = comparison.calculix, comparison.scene.filament.span
    frames = moments(len(run.time))
    note = "errors in %: (ours − CalculiX)/max |CalculiX|, midpoint; t in L √(ρ/E)"
    table = Table(box=box.SIMPLE, caption=note, caption_justify="left")
    table.add_column("")
    for name in (f"CalculiX {run.mesh.along} × {run.mesh.through}", *(row.name for row in comparison.rows)):
        table.add_column(name, justify="right")
    rows = comparison.rows
    table.add_row("final midpoint / L", *(f"{y[-1] / span:.5f}" for y in (run.midpoint, *(r.midpoint for r in rows))))
    for k, frame in enumerate(frames):
        at = f"error at t = {run.time[frame] / run.elastic_time:.4g}"
        table.add_row(at, "", *(f"{100 * row.discrepancy.at[k]:+.2f}" for row in rows))
    table.add_row("mean error", "", *(f"{100 * row.discrepancy.mean:+.2f}" for row in rows))
    table.add_row("largest error", "", *(f"{100 * row.discrepancy.largest:.2f}" for row in rows))
    table.add_row("unknowns", str(run.dofs), *(str(row.dofs) for row in rows))
    table.add_row("steps", str(run.steps), *(str(row.steps) for row in rows))
    table.add_row("wall time [s]", f"{run.wall:.3g}", *(f"{row.wall:.3g}" for row in rows))
    return table


def _midpoint_csv(comparison: CalculixComparison) -> bytes:
    """Midpoints [m], frame by frame; empty after a run has ended early."""
    run = comparison.calculix
    columns = [run.time, run.midpoint, *(row.midpoint for row in comparison.rows)]
    names = ["time_s", "calculix_m", *(f"{row.name}_m" for row in comparison.rows)]
    lines = [",".join(repr(float(v)) if math.isfinite(v) else "" for v in row) for row in zip(*columns, strict=True)]
    return "\n".join([",".join(names), *lines, ""]).encode()


def _calculix_midpoints(time: Floats, midpoint: Floats) -> dict[str, float | None]:
    return {"midpoint_final_m": _or_null(midpoint[-1]), "midpoint_mean_m": _or_null(np.mean(midpoint[late(time)]))}


def _calculix_errors(row: CalculixRow) -> dict[str, Any]:
    found = row.discrepancy
    return {"at": [_or_null(v) for v in found.at], "mean": _or_null(found.mean), "largest": _or_null(found.largest)}


def _or_null(value: float | np.floating[Any]) -> float | None:
    return float(value) if math.isfinite(value) else None
