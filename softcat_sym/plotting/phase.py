"""All files of a phase diagram, and what is printed after it."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from softcat_sym.files import write_all
from softcat_sym.plotting.phase_diagram import caption, phase_figure
from softcat_sym.plotting.phase_strains import strain_caption, strain_figure
from softcat_sym.plotting.style import png
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME, TURNED_BACK
from softcat_sym.studies.phase import DESCENT_TIME, PAPER_STRAIN, PhaseDiagram, PhaseSheet
from softcat_sym.studies.phase_runs import ARREST_FLOW_TIME as FLOW_TIME
from softcat_sym.studies.phase_runs import CLAMP_REGION, ELASTIC_TIME, PASSED, WEIGHT_TIME, PhaseRun

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.scene.scene import Scene

HEADER = ("boundary of the runs", "against the line", "source", "rows", "off by")


def saved_text(sheet: PhaseSheet) -> str:
    """Runs, lattice, saving and time in a sentence."""
    marks = ", ".join(f"{count} {mark}" for mark, count in sheet.counts.items())
    again = sheet.runs - len(sheet.points)
    twice = f", {again} of them twice" if again else ""
    return (
        f"{sheet.plane.name}: {len(sheet.points)} of {sheet.nodes} filaments run{twice}; refinement saved "
        f"{sheet.saved} ({sheet.saved / sheet.nodes:.0%}); {sheet.wall:.1f} s, "
        f"{sheet.processor:.1f} s of processor time. {marks}."
    )


def boundary_rows(sheet: PhaseSheet) -> list[tuple[str, ...]]:
    """Below `HEADER`: G of the runs over that of the line, less one: median of the rows, least and most."""
    return [
        (
            one.kind,
            one.line.name,
            one.line.source,
            str(one.rows),
            f"{100 * one.median:+.0f} % ({100 * one.least:+.0f} to {100 * one.most:+.0f})",
        )
        for one in sheet.distances
    ]


def boundary_table(sheet: PhaseSheet) -> Table:
    """The rows as a table for the terminal."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(
        title=Text(f"boundaries over {sheet.plane.name}: G of the runs against the lines", style="bold"),
        title_justify="left",
        box=box.SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
    )
    for k, name in enumerate(HEADER):
        table.add_column(Text(name), justify="right" if k == 3 else "left")
    for row in boundary_rows(sheet):
        table.add_row(*(Text(cell) for cell in row))
    return table


def print_phase_diagram(diagram: PhaseDiagram, console: Console | None = None) -> None:
    """Print a table and a sentence for each plane, and the strains of the paper's continual descent."""
    from rich.console import Console

    out = console or Console()
    for sheet in diagram.sheets:
        out.print(boundary_table(sheet))
        out.print(saved_text(sheet), markup=False, highlight=False)
    out.print(strain_caption(diagram), markup=False, highlight=False)


COLUMNS = (
    "plane", "G", "V", "delta", "regime", "outcome", "mark", "duration_s", "drawn_out_within_s", "sag_over_span",
    "rate", "span_rate", "clamp_strain", "clamp_strain_centreline", "midspan_strain", "midspan_strain_centreline",
    "steps", "runs", "message",
)  # fmt: skip
"""Rates are the largest of the last tenth of the run over sigma_Y/eta; strains are those of the outer fibre."""


def runs_csv(diagram: PhaseDiagram) -> bytes:
    """One row for each filament of each plane, answers or not."""
    lines = [",".join(COLUMNS) + "\n"]
    for sheet in diagram.sheets:
        for point in sorted(sheet.points, key=lambda one: (one.j, one.i)):
            lines.append(",".join([sheet.plane.name, *_cells(point.run)]) + "\n")
    return "".join(lines).encode()


def lines_csv(diagram: PhaseDiagram) -> bytes:
    """The lines of the formulas, a row for each of their points."""
    rows = ["plane,line,boundary,source,equation,other,other_value,G\n"]
    for sheet in diagram.sheets:
        for line in sheet.lines:
            head = f'{sheet.plane.name},"{line.name}",{line.kind},{line.source},"{line.equation}",{sheet.plane.y.key}'
            pairs = zip(line.other.tolist(), line.G.tolist(), strict=True)
            rows += [f"{head},{other!r},{_number(G)}\n" for other, G in pairs]
    return "".join(rows).encode()


def boundaries_csv(diagram: PhaseDiagram) -> bytes:
    """Where the runs go from one regime to another, a row for each crossing of a lattice row."""
    rows = ["plane,boundary,other,other_value,G_low,G_high\n"]
    for sheet in diagram.sheets:
        rows += [
            f"{sheet.plane.name},{one.kind},{sheet.plane.y.key},{one.other!r},{one.G_low!r},{one.G_high!r}\n"
            for one in sheet.crossings
        ]
    return "".join(rows).encode()


def document(diagram: PhaseDiagram) -> dict[str, Any]:
    """What ``phase.json`` holds."""
    descent = diagram.descent
    return {
        "title": diagram.scene.title,
        "definitions": {
            "arrested": f"plastic rate below {ARREST_RATE:g} sigma_Y/eta in every fibre over the last "
            f"{ARREST_TIME:.0%} of the run",
            "underdamped": f"the midpoint turned back by more than {TURNED_BACK:.0%} of its largest sag",
            "descending-at-clamps": f"descending, but arrested further than {CLAMP_REGION:g} L from the ends",
            "no answer": f"localised or failed; repeated until the sag passes {PASSED:g} L if it does so",
            "duration": f"ramp + ({ELASTIC_TIME:g} + V min({WEIGHT_TIME:g}, {FLOW_TIME:g} G)) sqrt(L/g)",
        },
        "planes": {sheet.plane.name: _sheet(diagram.scene, diagram, sheet) for sheet in diagram.sheets},
        "continual_descent": {
            "groups": {"G": descent.place.G, "V": descent.place.V, "delta": descent.place.delta},
            "time_over_L_sqrt_rho_E": DESCENT_TIME,
            "outcome": descent.outcome,
            "regime": descent.regime,
            "sag_over_span": descent.sag,
            "paper_local_strain_over": PAPER_STRAIN,
            "clamp_strain": descent.clamp.largest,
            "clamp_strain_centreline": descent.clamp.centreline,
            "midspan_strain": descent.midspan.largest,
            "midspan_strain_centreline": descent.midspan.centreline,
            "caption": strain_caption(diagram),
        },
        "workers": diagram.workers,
    }


def write_phase_diagram(diagram: PhaseDiagram, directory: str | Path) -> list[Path]:
    """Write ``phase.json``, ``scene.toml``, three tables and two pictures for each plane.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    contents = {
        "phase.json": (json.dumps(document(diagram), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": diagram.scene.to_toml().encode(),
        "phase_runs.csv": runs_csv(diagram),
        "phase_boundaries.csv": boundaries_csv(diagram),
        "phase_lines.csv": lines_csv(diagram),
    }
    for sheet in diagram.sheets:
        contents[f"phase_{sheet.plane.name}.png"] = png(phase_figure(diagram, sheet))
        contents[f"phase_{sheet.plane.name}_strain.png"] = png(strain_figure(diagram, sheet))
    return write_all(directory, contents)


def _sheet(scene: Scene, diagram: PhaseDiagram, sheet: PhaseSheet) -> dict[str, Any]:
    return {
        "resolution": sheet.lattice.cells,
        "held": sheet.held(scene),
        "nodes": sheet.nodes,
        "nodes_run": len(sheet.points),
        "nodes_saved": sheet.saved,
        "runs": sheet.runs,
        "wall_s": sheet.wall,
        "processor_s": sheet.processor,
        "marks": sheet.counts,
        "boundaries": [
            {
                "boundary": one.kind,
                "line": one.line.name,
                "source": one.line.source,
                "equation": one.line.equation,
                "rows": one.rows,
                "median": one.median,
                "least": one.least,
                "most": one.most,
            }
            for one in sheet.distances
        ],
        "caption": caption(diagram, sheet),
    }


def _cells(run: PhaseRun) -> list[str]:
    place, clamp, midspan = run.place, run.clamp, run.midspan
    numbers = (run.sag, run.rate, run.span_rate, clamp.largest, clamp.centreline, midspan.largest, midspan.centreline)
    drawn_out = "" if run.drawn_out is None else repr(run.drawn_out)
    message = run.message.replace('"', "'")
    return [
        *(repr(value) for value in (place.G, place.V, place.delta)),
        run.regime or "",
        run.outcome,
        run.mark,
        repr(run.duration),
        drawn_out,
        *(_number(value) for value in numbers),
        str(run.steps),
        str(run.runs),
        f'"{message}"' if message else "",
    ]


def _number(value: float) -> str:
    return repr(float(value)) if math.isfinite(value) else ""
