"""Phase diagrams: pictures, tables, files and the terminal."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, Final, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report, TextTable
from softcat_sym.plotting import style
from softcat_sym.plotting.style import log_axes, styled
from softcat_sym.studies.phase import NO_YIELD, OVERDAMPED, UNDERDAMPED, PhaseDiagram, PhaseSheet
from softcat_sym.studies.phase_runs import CLAMPS_ONLY, DESCENDING, PhaseRun

_LINES: Final[dict[str, tuple[float, list[float]]]] = {
    "paper": (0, []),
    "exact": (0, [5, 2]),
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


def _drawers(diagram: PhaseDiagram) -> Mapping[str, Callable[[], Figure]]:
    """Names of the pictures of regimes over each plane, and what draws each."""
    return {sheet.plane.name: partial(phase_figure, diagram, sheet) for sheet in diagram.sheets}


drawing.plot.register(PhaseDiagram, lambda of, what="": drawing.figure_by_name(_drawers(of), what))


@styled()
def phase_figure(diagram: PhaseDiagram, sheet: PhaseSheet) -> Figure:
    """Draw one plane."""
    title = f"Regimes over G and {'δ' if sheet.plane.y.key == 'delta' else 'V'}"
    figure, body = style.sheet(title, height=4.4, notes=diagram.caption(sheet), columns=128)
    axes = body.subplots()
    draw_tints(axes, sheet)
    runs, lines = _draw_runs(axes, sheet), _draw_lines(axes, sheet)
    finish(axes, sheet)
    upper: dict[str, Any] = {"loc": "upper left", "bbox_to_anchor": (1.03, 1.01), "fontsize": 7.5, "markerscale": 1.6}
    lower: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (1.03, -0.02), "fontsize": 7, "labelspacing": 0.45}
    axes.add_artist(axes.legend(handles=runs, title="runs", alignment="left", **upper))
    axes.legend(handles=lines, title="lines", alignment="left", **lower)
    return figure


def draw_tints(axes: Axes, sheet: PhaseSheet) -> None:
    """Tint every node by its mark."""
    labels = sheet.lattice.labels
    tints = list(dict.fromkeys(look_of(str(mark)).tint for mark in np.unique(labels)))
    numbers = np.vectorize(lambda mark: tints.index(look_of(str(mark)).tint))(labels)
    colours = ListedColormap(tints)
    edges = [style.pixel_edges(values, is_log=True) for values in (sheet.x, sheet.y)]
    axes.pcolormesh(*edges, numbers.T, cmap=colours, vmin=-0.5, vmax=len(tints) - 0.5, zorder=0)


def finish(axes: Axes, sheet: PhaseSheet) -> None:
    """Logarithmic axes with the names of the groups."""
    x, y = sheet.plane.x, sheet.plane.y
    log_axes(axes, xlim=(x.low, x.high), ylim=(y.low, y.high), xlabel=AXES["G"], ylabel=AXES[y.key])
    axes.spines[:].set_visible(True)


def _places(sheet: PhaseSheet, runs: Sequence[PhaseRun]) -> tuple[list[float], list[float]]:
    return [run.place.G for run in runs], [getattr(run.place, sheet.plane.y.key) for run in runs]


def _draw_runs(axes: Axes, sheet: PhaseSheet) -> list[Any]:
    """Marks of the runs, with how many there are of each kind."""
    drawn = []
    for look in (*LOOKS.values(), _FAILED):
        runs = [point.run for point in sheet.points if look_of(point.run.mark) is look]
        if runs:
            edge = None if look.marker in "x+" else look.colour
            mark: dict[str, Any] = {"c": "white" if look.hollow else look.colour, "edgecolors": edge, "linewidths": 0.6}
            mark |= {"marker": look.marker, "label": f"{look.words} ({len(runs)})"}
            drawn.append(axes.scatter(*_places(sheet, runs), s=8, zorder=2, clip_on=False, **mark))
    return drawn


def _draw_lines(axes: Axes, sheet: PhaseSheet) -> list[Any]:
    """Lines, each with its number; the numbers climb, so that neighbours do not meet."""
    drawn = []
    for number, line in enumerate(sheet.lines, start=1):
        label = f"{number}  {line.name}\n    {line.source}, {line.equation}"
        look: dict[str, Any] = {"color": style.BLACK, "linestyle": _LINES[line.source], "linewidth": 1.1}
        drawn += axes.plot(line.G, line.other, zorder=3, label=label, **look)
        there = np.flatnonzero(np.isfinite(line.G) & (line.G > sheet.plane.x.low) & (line.G < sheet.plane.x.high))
        if len(there):
            k = there[int((0.96 - 0.085 * (number - 1)) * (len(there) - 1))]
            box = {"boxstyle": "circle,pad=0.18", "facecolor": "white", "edgecolor": style.BLACK, "linewidth": 0.6}
            place = (float(line.G[k]), float(line.other[k]))
            axes.annotate(str(number), place, ha="center", va="center", fontsize=6, bbox=box, zorder=4)
    return drawn


_HEADER = ("boundary of the runs", "against the line", "source", "rows", "off by")


@drawing.report.register(PhaseDiagram)
def phase_report(diagram: PhaseDiagram) -> Report:
    """A table and a sentence for each plane."""
    shown: list[Any] = []
    for sheet in diagram.sheets:
        rows = []
        for one in sheet.distances:
            median, least, most = (f"{100 * share:+.0f}" for share in (one.median, one.least, one.most))
            rows.append((one.kind, one.line.name, one.line.source, str(one.rows), f"{median} % ({least} to {most})"))
        title = f"boundaries over {sheet.plane.name}: G of the runs against the lines"
        again = sheet.runs - len(sheet.points)
        saved = (
            f"{sheet.plane.name}: {len(sheet.points)} of {sheet.nodes} filaments run"
            f"{f', {again} of them twice' if again else ''}; refinement saved {sheet.lattice.saved} "
            f"({sheet.lattice.saved / sheet.nodes:.0%}); {sheet.wall:.1f} s, {sheet.processor:.1f} s of processor time"
            f". {', '.join(f'{count} {mark}' for mark, count in sheet.counts.items())}."
        )
        shown += [TextTable(_HEADER, rows, right=(3,), title=title), Text(saved)]
    tables = {"runs": diagram.to_frame, "boundaries": diagram.boundaries, "lines": diagram.lines}
    files = {
        "phase.json": diagram.to_dict,
        "scene.toml": diagram.scene.to_toml,
        **{f"phase_{name}.csv": table for name, table in tables.items()},
        **{f"phase_{name}.png": draw for name, draw in _drawers(diagram).items()},
    }
    return Report(files, shown)
