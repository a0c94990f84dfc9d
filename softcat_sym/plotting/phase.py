"""Phase diagrams: pictures, tables, files and the terminal."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from rich.console import Console
from rich.table import Table

from softcat_sym.discretization.grid import Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.files import Quoted, csv_bytes, write_results
from softcat_sym.plotting.terminal import text_table
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME, TURNED_BACK
from softcat_sym.studies.phase import (
    DESCENT_TIME,
    NO_YIELD,
    OVERDAMPED,
    PAPER_STRAIN,
    UNDERDAMPED,
    PhaseDiagram,
    PhaseSheet,
)
from softcat_sym.studies.phase_runs import ARREST_FLOW_TIME as FLOW_TIME
from softcat_sym.studies.phase_runs import (
    CLAMP_REGION,
    CLAMPS_ONLY,
    DESCENDING,
    ELASTIC_TIME,
    PASSED,
    WEIGHT_TIME,
    PhaseRun,
)

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

_LINES: Final[dict[str, tuple[float, list[float]]]] = {
    "paper": (0, []),
    "exact": (0, [5, 2]),
    "estimate": (0, [1, 1.2]),
}
"""Offset and dashes."""
AXES: Final = {"G": "G = ρ g L / σʏ", "V": "V = η / (ρ √(g L³))", "delta": "δ = h₀ / L"}


class _Look(NamedTuple):
    marker: str
    colour: str
    tint: str
    words: str
    hollow: bool = False


LOOKS: Final[dict[str, _Look]] = {
    NO_YIELD: _Look("o", style.BLUE, "#dcebf5", "no yield"),
    UNDERDAMPED: _Look("^", style.GREEN, "#dcf1ea", "arrested, underdamped"),
    OVERDAMPED: _Look("s", style.ORANGE, "#fbf0d6", "arrested, overdamped"),
    CLAMPS_ONLY: _Look("v", style.VERMILLION, "#fdeee5", "descending at its clamps", hollow=True),
    DESCENDING: _Look("v", style.VERMILLION, "#f8d3bf", "descending"),
    "localised": _Look("x", style.BLACK, "#e4e4e4", "no answer: localised"),
}
_FAILED: Final = _Look("+", style.PURPLE, "#f5f5f5", "no answer: other")


def look_of(mark: str) -> _Look:
    """Shape and colours of a mark; outcomes that are no answer, and rare, share one."""
    return LOOKS.get(mark, _FAILED)


def caption(diagram: PhaseDiagram, sheet: PhaseSheet) -> str:
    """What is shown, how it was decided, and what refinement saved."""
    effects = diagram.scene.run.effects
    physics = effects if isinstance(effects, str) else ", ".join(effects)
    return (
        f"Each mark is a run ({physics} physics, {sheet.held(diagram.scene)}), each tint the regime between runs. "
        f"{len(sheet.points)} of the {sheet.nodes} nodes of a {sheet.lattice.cells} x {sheet.lattice.cells} "
        f"lattice were run, refined where neighbours differ: {sheet.saved} were saved "
        f"({sheet.saved / sheet.nodes:.0%}). "
        f"Arrested: the plastic rate is below {ARREST_RATE:g} σʏ/η in every fibre over the last tenth of the run; "
        f"hollow: so it is but within {CLAMP_REGION:g} L of the ends; only the clamps flow on. A run that is no answer "
        f"has no regime; one that first falls past {PASSED:g} L is judged by how it does so."
    )


def phase_figure(diagram: PhaseDiagram, sheet: PhaseSheet) -> Figure:
    """Draw one plane."""
    title = f"Regimes over G and {'δ' if sheet.plane.y.key == 'delta' else 'V'}"
    with style.styled():
        figure, body = style.sheet(title, height=4.4, notes=caption(diagram, sheet), columns=128)
        axes = body.subplots()
        draw_tints(axes, sheet)
        _draw_runs(axes, sheet)
        _draw_lines(axes, sheet)
        finish(axes, sheet)
        _key(axes, sheet)
    return figure


def edges_of(values: Floats) -> Floats:
    """Edges of the pixels around lattice values in equal steps of the logarithm, cut at the ends."""
    middles = np.sqrt(values[1:] * values[:-1])
    return np.concatenate([values[:1], middles, values[-1:]])


def draw_tints(axes: Axes, sheet: PhaseSheet) -> None:
    """Tint every node by its mark."""
    labels = sheet.labels
    tints = list(dict.fromkeys(look_of(str(mark)).tint for mark in np.unique(labels)))
    numbers = np.vectorize(lambda mark: tints.index(look_of(str(mark)).tint))(labels)
    colours = ListedColormap(tints)
    axes.pcolormesh(
        edges_of(sheet.x), edges_of(sheet.y), numbers.T, cmap=colours, vmin=-0.5, vmax=len(tints) - 0.5, zorder=0
    )


def finish(axes: Axes, sheet: PhaseSheet) -> None:
    """Logarithmic axes with the names of the groups."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(sheet.plane.x.low, sheet.plane.x.high)
    axes.set_ylim(sheet.plane.y.low, sheet.plane.y.high)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(lambda value, _: f"{value:g}")
        axis.set_minor_formatter(lambda *_: "")
    axes.set_xlabel(AXES["G"])
    axes.set_ylabel(AXES[sheet.plane.y.key])


def _draw_runs(axes: Axes, sheet: PhaseSheet) -> None:
    for look in (*LOOKS.values(), _FAILED):
        runs = [point.run for point in sheet.points if look_of(point.run.mark) is look]
        if not runs:
            continue
        x, y = np.array([(run.place.G, getattr(run.place, sheet.plane.y.key)) for run in runs]).T
        face = "white" if look.hollow else look.colour
        edge = None if look.marker in "x+" else look.colour
        axes.scatter(x, y, s=8, marker=look.marker, c=face, edgecolors=edge, linewidths=0.6, zorder=2, clip_on=False)


def _draw_lines(axes: Axes, sheet: PhaseSheet) -> None:
    """Lines, each with its number; the numbers climb, so that neighbours do not meet."""
    for number, line in enumerate(sheet.lines, start=1):
        axes.plot(line.G, line.other, color=style.BLACK, linestyle=_LINES[line.source], linewidth=1.1, zorder=3)
        there = np.flatnonzero(np.isfinite(line.G) & (line.G > sheet.plane.x.low) & (line.G < sheet.plane.x.high))
        if not len(there):
            continue
        k = there[int((0.96 - 0.085 * (number - 1)) * (len(there) - 1))]
        box = {"boxstyle": "circle,pad=0.18", "facecolor": "white", "edgecolor": style.BLACK, "linewidth": 0.6}
        place = (float(line.G[k]), float(line.other[k]))
        axes.annotate(str(number), place, ha="center", va="center", fontsize=6, bbox=box, zorder=4)


def _key(axes: Axes, sheet: PhaseSheet) -> None:
    """Marks with their numbers of runs, and the numbered lines, at the right."""
    handles = []
    for look in (*LOOKS.values(), _FAILED):
        count = sum(look_of(point.run.mark) is look for point in sheet.points)
        if count:
            face = "white" if look.hollow else look.colour
            marker: dict[str, Any] = {
                "marker": look.marker,
                "color": look.colour,
                "markerfacecolor": face,
                "markersize": 4.5,
            }
            handles.append(Line2D([], [], linestyle="", label=f"{look.words} ({count})", **marker))
    regimes = axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.03, 1.01), title="runs", fontsize=7.5)
    regimes.set_alignment("left")
    axes.add_artist(regimes)
    lines = [Line2D([], [], color=style.BLACK, linestyle=_LINES[line.source], linewidth=1.1) for line in sheet.lines]
    words = [f"{n}  {line.name}\n    {line.source}, {line.equation}" for n, line in enumerate(sheet.lines, start=1)]
    formulas = axes.legend(
        lines, words, loc="lower left", bbox_to_anchor=(1.03, -0.02), title="lines", fontsize=7, labelspacing=0.45
    )
    formulas.set_alignment("left")


_LOW, _HIGH = 1e-3, 3.0
_PLACES: Final[tuple[tuple[str, Callable[[PhaseRun], float]], ...]] = (
    ("at the clamp", lambda run: run.clamp.largest),
    ("at midspan", lambda run: run.midspan.largest),
)


def strain_caption(diagram: PhaseDiagram) -> str:
    """What is shown, and the paper's continual descent."""
    run = diagram.descent
    clamp, midspan = run.clamp, run.midspan
    state = f"at t~ = 460 (G 1.9, V 26, δ 0.03; {run.outcome}, sag {run.sag:.3f} L)"
    return (
        "True axial strain of the most stretched fibre at the end of each run, in the cell next to the clamp and in "
        f"the one at midspan. Outlined: over {PAPER_STRAIN:.0%}. Crosses: no answer. The paper's continual descent "
        f'{state}, where it finds "over 23 %" near the clamp: here {clamp.largest:.0%} in the outer fibre and '
        f"{clamp.centreline:.0%} of the centreline at the clamp, {midspan.largest:.0%} and {midspan.centreline:.0%} at "
        "midspan."
    )


def strain_figure(diagram: PhaseDiagram, sheet: PhaseSheet) -> Figure:
    """Draw two maps of one plane: every run at its place, coloured by a strain."""
    title = f"Local strain over G and {'δ' if sheet.plane.y.key == 'delta' else 'V'}"
    answers = [point.run for point in sheet.points if point.run.regime is not None]
    others = [point.run for point in sheet.points if point.run.regime is None]
    with style.styled():
        figure, body = style.sheet(title, height=3.3, notes=strain_caption(diagram), columns=128)
        panels = body.subplots(1, 2, sharey=True)
        for axes, (words, strain) in zip(panels, _PLACES, strict=True):
            draw_tints(axes, sheet)
            strains = np.clip([strain(run) for run in answers], _LOW, _HIGH)
            look: dict[str, Any] = {"norm": LogNorm(_LOW, _HIGH), "cmap": "viridis_r", "linewidths": 0.7, "zorder": 2}
            edges = [style.BLACK if value > PAPER_STRAIN else "none" for value in strains]
            drawn = axes.scatter(*_places(sheet, answers), c=strains, s=12, edgecolors=edges, **look)
            colour = look_of("localised").colour
            axes.scatter(*_places(sheet, others), marker="x", s=9, c=colour, linewidths=0.6, zorder=2)
            finish(axes, sheet)
            axes.set_title(words, fontsize=9)
            axes.label_outer()
        bar = body.colorbar(drawn, ax=panels, format=lambda value, _: f"{value:g}", label="strain", pad=0.02, aspect=22)
        bar.ax.axhline(PAPER_STRAIN, color=style.BLACK, linewidth=1.2)
    return figure


def _places(sheet: PhaseSheet, runs: list[PhaseRun]) -> tuple[list[float], list[float]]:
    return [run.place.G for run in runs], [getattr(run.place, sheet.plane.y.key) for run in runs]


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
    title = f"boundaries over {sheet.plane.name}: G of the runs against the lines"
    return text_table(HEADER, boundary_rows(sheet), title=title, right=(3,), padding=(0, 1, 0, 0))


def print_phase_diagram(diagram: PhaseDiagram, console: Console | None = None) -> None:
    """Print a table and a sentence for each plane, and the strains of the paper's continual descent."""
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
    rows = (
        (sheet.plane.name, *_cells(point.run))
        for sheet in diagram.sheets
        for point in sorted(sheet.points, key=lambda one: (one.j, one.i))
    )
    return csv_bytes(COLUMNS, rows)


def lines_csv(diagram: PhaseDiagram) -> bytes:
    """The lines of the formulas, a row for each of their points."""
    rows = []
    for sheet in diagram.sheets:
        for line in sheet.lines:
            about = (sheet.plane.name, Quoted(line.name), line.kind, line.source, Quoted(line.equation))
            pairs = zip(line.other.tolist(), line.G.tolist(), strict=True)
            rows += [(*about, sheet.plane.y.key, other, G) for other, G in pairs]
    return csv_bytes(("plane", "line", "boundary", "source", "equation", "other", "other_value", "G"), rows)


def boundaries_csv(diagram: PhaseDiagram) -> bytes:
    """Where the runs go from one regime to another, a row for each crossing of a lattice row."""
    rows = (
        (sheet.plane.name, one.kind, sheet.plane.y.key, one.other, one.G_low, one.G_high)
        for sheet in diagram.sheets
        for one in sheet.crossings
    )
    return csv_bytes(("plane", "boundary", "other", "other_value", "G_low", "G_high"), rows)


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
    """Write ``phase.json``, ``scene.toml``, three tables and two pictures for each plane."""
    contents: dict[str, object] = {
        "phase.json": document(diagram),
        "scene.toml": diagram.scene.to_toml(),
        "phase_runs.csv": runs_csv(diagram),
        "phase_boundaries.csv": boundaries_csv(diagram),
        "phase_lines.csv": lines_csv(diagram),
    }
    for sheet in diagram.sheets:
        contents[f"phase_{sheet.plane.name}.png"] = phase_figure(diagram, sheet)
        contents[f"phase_{sheet.plane.name}_strain.png"] = strain_figure(diagram, sheet)
    return write_results(directory, contents)


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


def _cells(run: PhaseRun) -> tuple[object, ...]:
    place, clamp, midspan = run.place, run.clamp, run.midspan
    strains = (clamp.largest, clamp.centreline, midspan.largest, midspan.centreline)
    return (
        *(place.G, place.V, place.delta, run.regime, run.outcome, run.mark, run.duration, run.drawn_out),
        *(run.sag, run.rate, run.span_rate, *strains, run.steps, run.runs),
        Quoted(run.message) if run.message else None,
    )
