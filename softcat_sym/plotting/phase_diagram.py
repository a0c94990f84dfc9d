"""Picture of a phase plane: what runs show, by shape and colour, under the lines of the formulas."""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.results.motion import ARREST_RATE
from softcat_sym.studies.phase import NO_YIELD, OVERDAMPED, UNDERDAMPED, PhaseDiagram, PhaseSheet
from softcat_sym.studies.phase_runs import CLAMP_REGION, CLAMPS_ONLY, DESCENDING, PASSED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LEFT, _BOTTOM, _PANEL, _TALL, _TOP = 0.62, 1.32, 4.25, 3.85, 0.45
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
    height = _TOP + _TALL + _BOTTOM
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        axes = axes_in_inches(figure, _LEFT, _BOTTOM, _PANEL, _TALL)
        draw_tints(axes, sheet)
        _draw_runs(axes, sheet)
        _draw_lines(axes, sheet)
        finish(axes, sheet)
        _key(axes, sheet)
        left = 0.2 / style.WIDTH
        title = f"Regimes over G and {'δ' if sheet.plane.y.key == 'delta' else 'V'}"
        figure.text(left, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold")
        text = fill(caption(diagram, sheet), 128)
        figure.text(left, (_BOTTOM - 0.55) / height, text, va="top", fontsize=7.5, parse_math=False)
    return figure


def edges_of(values: Floats) -> Floats:
    """Edges of the pixels around lattice values in equal steps of the logarithm, cut at the ends."""
    middles = np.sqrt(values[1:] * values[:-1])
    return np.concatenate([values[:1], middles, values[-1:]])


def draw_tints(axes: Axes, sheet: PhaseSheet) -> None:
    """Tint every node by its mark."""
    from matplotlib.colors import ListedColormap

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
    from matplotlib.lines import Line2D

    marks = {point.run.mark for point in sheet.points}
    looks = [look for look in (*LOOKS.values(), _FAILED) if look in {look_of(mark) for mark in marks}]
    handles = []
    for look in looks:
        count = sum(look_of(point.run.mark) is look for point in sheet.points)
        face = "white" if look.hollow else look.colour
        handles.append(
            Line2D(
                [],
                [],
                linestyle="",
                marker=look.marker,
                color=look.colour,
                markerfacecolor=face,
                markersize=4.5,
                label=f"{look.words} ({count})",
            )
        )
    regimes = axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.03, 1.01), title="runs", fontsize=7.5)
    regimes.set_alignment("left")
    axes.add_artist(regimes)
    lines = [Line2D([], [], color=style.BLACK, linestyle=_LINES[line.source], linewidth=1.1) for line in sheet.lines]
    words = [f"{n}  {line.name}\n    {line.source}, {line.equation}" for n, line in enumerate(sheet.lines, start=1)]
    formulas = axes.legend(
        lines, words, loc="lower left", bbox_to_anchor=(1.03, -0.02), title="lines", fontsize=7, labelspacing=0.45
    )
    formulas.set_alignment("left")
