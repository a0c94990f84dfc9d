"""Files and table of a comparison with CalculiX."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.files import write_all
from softcat_sym.report.calculix_picture import calculix_figure
from softcat_sym.report.canvas import png
from softcat_sym.study.discrepancy import late, moments

if TYPE_CHECKING:
    from rich.table import Table

    from softcat_sym.graph.grid import Floats
    from softcat_sym.reference.calculix_deck import Deck
    from softcat_sym.scene import Scene
    from softcat_sym.study.calculix import CalculixComparison, CalculixRow

FOLDER = "calculix"
"""Where deck and print-outs go, in the folder of a comparison."""

_DEFINITION = (
    "(ours - CalculiX)/max |CalculiX| of the midpoint's height: positive where ours sags less; mean: over the frames "
    "of the last 6/7 of the duration; largest: in magnitude, over all frames"
)


def write_deck(scene: Scene, deck: Deck, directory: str | Path) -> list[Path]:
    """Write ``scene.toml`` and ``calculix/deck.inp``.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
    """
    folder = Path(directory)
    written = write_all(folder / FOLDER, {"deck.inp": deck.text.encode("ascii")})
    return [*written, *write_all(folder, {"scene.toml": scene.to_toml().encode()})]


def write_calculix_comparison(comparison: CalculixComparison, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``compare_midpoint.png`` and ``.csv``, ``scene.toml``, and ``calculix/`` with the deck.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
    """
    folder = Path(directory)
    contents = {
        "compare.json": (json.dumps(document(comparison), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": comparison.scene.to_toml().encode(),
        "compare_midpoint.png": png(calculix_figure(comparison)),
        "compare_midpoint.csv": _midpoint_csv(comparison),
    }
    return [*write_all(folder, contents), *write_all(folder / FOLDER, comparison.calculix.files)]


def document(comparison: CalculixComparison) -> dict[str, Any]:
    """What ``compare.json`` holds; every number finite or null."""
    run, summary = comparison.calculix, comparison.trajectory.summary
    times = [float(run.time[frame]) for frame in moments(len(run.time))]
    return {
        "title": comparison.scene.title,
        "engine": "calculix",
        "outcome": summary["outcome"],
        "advice": summary["advice"],
        "complaint": summary["complaint"],
        "warnings": list(comparison.warnings),
        "calculix": {
            **_midpoints(run.time, run.midpoint),
            "wall_s": run.wall,
            "dofs": run.dofs,
            "steps": run.steps,
            "along": run.mesh.along,
            "through": run.mesh.through,
            "clamp": run.clamp.name.lower(),
        },
        **{
            row.name: {
                **_midpoints(run.time, row.midpoint),
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
            **{row.name: _errors(row) for row in comparison.rows},
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


def _midpoints(time: Floats, midpoint: Floats) -> dict[str, float | None]:
    return {"midpoint_final_m": _or_null(midpoint[-1]), "midpoint_mean_m": _or_null(np.mean(midpoint[late(time)]))}


def _errors(row: CalculixRow) -> dict[str, Any]:
    found = row.discrepancy
    return {"at": [_or_null(v) for v in found.at], "mean": _or_null(found.mean), "largest": _or_null(found.largest)}


def _or_null(value: float | np.floating[Any]) -> float | None:
    return float(value) if math.isfinite(value) else None
