"""The paper's figure 3(a): regimes that runs show, with the lines of the paper and of the exact formulas."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import NullFormatter

from softcat_sym.physics.regimes import arrest_threshold_exact
from softcat_sym.plotting import style
from softcat_sym.plotting.figure_files import facts, printed, table
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.scene.scene import groups_of
from softcat_sym.studies.phase_runs import CLAMPS_ONLY

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.discretization.grid import Floats
    from softcat_sym.studies.phase import PhaseDiagram, PhaseSheet

_WIDTH, _LEFT, _RIGHT, _GAP = 9.6, 0.72, 0.15, 0.75
_PANEL, _TOP, _BOTTOM = 3.6, 0.35, 2.3

_REGIMES = {
    "no-yield": ("no yielding", "#f4f4f0"),
    "arrested-underdamped": ("arrested, underdamped", "#bfe3f5"),
    "arrested-overdamped": ("arrested, overdamped", "#a5dcc6"),
    CLAMPS_ONLY: ("descent, fast at the clamps alone", "#fce6d6"),
    "descending": ("continual descent", "#f4b98f"),
}
_NONE = ("no answer, localised", "#9a9a9a")
_LINES: dict[str, dict[str, Any]] = {
    "paper": {"color": style.BLACK, "linewidth": 1.4, "linestyle": (0, (5, 2))},
    "exact": {"color": style.BLUE, "linewidth": 1.3},
    "estimate": {"color": style.PURPLE, "linewidth": 1.2, "linestyle": (0, (1.5, 1.2))},
}
_NAMES = {
    "paper": "the paper: G = 2δ, G = √2",
    "exact": "exact: sudden load (left), slow load with tension, catenary",
    "estimate": "estimates: first yield with this ramp, spring-back of 5 %",
}
_AXES = {"delta": "δ = h0 / L", "V": "V = η / (ρ √(g L³))", "G": "G = ρ g L / σY"}

# The paper's parameters in figure 3(b): G, V.
_PAPER = ((0.01, 26.0), (0.4, 26.0), (0.4, 0.4), (1.9, 26.0))

CAPTION = (
    "Figure 3(a). Regimes by what each run shows, paper's physics, gravity switched on over t~ = 10, each filament "
    "watched until it has shown whether it stops. Left: V = {V:.3g}; right: delta = {delta:.3g}; span, density and "
    "modulus are the paper's. Crosses: its parameter sets. Dots: {runs} runs, {nodes} lattice nodes; {saved} of them "
    "needed no run. Arrested: in the last tenth of the run no fibre flows faster than sigma_Y/(2 eta). "
    "First yield: (3.11) is a beam's under a slow load. The load that is suddenly there swings the beam to twice that "
    "sag, which at worst halves G; with this ramp the runs yield at {yields:.2f} of 2 delta in the median. The most "
    "slender are carried by their tension, which (3.11) leaves out, and yield later. "
    "Arrest: (3.12) and the exact G = 1.3255 are a catenary's at rest. A filament has hinges at its clamps too, and "
    "falls past its rest with speed: some fibre flows on from {descends:.2f} of sqrt 2 in the median. In the light "
    "tint that is so within L/10 of the clamps alone; the rest of it flows at {below:.2f} sigma_Y/eta in the median "
    "where G < 1.3255, at {above:.2f} where it is larger (left). "
    "Right: with less viscosity the overshoot is deeper, and a neck at the clamp is drawn out for which the published "
    "physics has no limit (grey); the paper's underdamped set is there."
)


def caption(diagram: PhaseDiagram) -> str:
    """The caption, every number from the runs."""
    groups, first = groups_of(diagram.scene), diagram.sheets[0]
    threshold = float(arrest_threshold_exact())
    clamps = [point.run for point in first.points if point.run.mark == CLAMPS_ONLY]
    below = [run.span_rate for run in clamps if run.place.G < threshold]
    above = [run.span_rate for run in clamps if run.place.G >= threshold]
    return CAPTION.format(
        V=groups.V,
        delta=groups.delta,
        runs=sum(sheet.runs for sheet in diagram.sheets),
        saved=sum(sheet.saved for sheet in diagram.sheets),
        nodes=sum(sheet.nodes for sheet in diagram.sheets),
        yields=1 + _median(first, "first yield"),
        descends=1 + _median(first, "arrest"),
        below=np.median(below) if below else np.nan,
        above=np.median(above) if above else np.nan,
    )


def _median(sheet: PhaseSheet, kind: str) -> float:
    """Median distance of a simulated boundary from the paper's line, as a share of it."""
    of = (each for each in sheet.distances if each.kind == kind and each.line.source == "paper")
    return next((each.median for each in of), float("nan"))


def phase_figure(diagram: PhaseDiagram) -> Figure:
    """Draw the planes beside each other."""
    count = len(diagram.sheets)
    width = (_WIDTH - _LEFT - _RIGHT - (count - 1) * _GAP) / count
    height = _TOP + _PANEL + _BOTTOM
    with style.styled():
        figure = new_figure(_WIDTH, height)
        for k, sheet in enumerate(diagram.sheets):
            axes = axes_in_inches(figure, _LEFT + k * (width + _GAP), _BOTTOM, width, _PANEL)
            _draw(axes, diagram, sheet)
        _explain(figure, diagram)
    return figure


def _draw(axes: Axes, diagram: PhaseDiagram, sheet: PhaseSheet) -> None:
    marks = list(_REGIMES)
    numbers = np.vectorize(lambda mark: marks.index(mark) if mark in marks else len(marks))(sheet.labels)
    colours = ListedColormap([colour for _, colour in (*_REGIMES.values(), _NONE)])
    edges = (_edges(sheet.x), _edges(sheet.y))
    axes.pcolormesh(*edges, numbers.T, cmap=colours, vmin=-0.5, vmax=len(marks) + 0.5, rasterized=True)
    run = np.array([(sheet.x[point.i], sheet.y[point.j]) for point in sheet.points])
    axes.plot(*run.T, ".", color=style.BLACK, markersize=1.6, alpha=0.35, markeredgewidth=0)
    for line in sheet.lines:
        axes.plot(line.G, line.other, **_LINES[line.source])
    for G, V in _PAPER:
        other = V if sheet.plane.y.key == "V" else groups_of(diagram.scene).delta
        if sheet.plane.y.key == "V" or np.isclose(V, groups_of(diagram.scene).V or np.nan):
            axes.plot(G, other, "x", color=style.BLACK, markersize=6, markeredgewidth=1.4, clip_on=False)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(sheet.x[0], sheet.x[-1])
    axes.set_ylim(sheet.y[0], sheet.y[-1])
    axes.set_xlabel(_AXES[sheet.plane.x.key])
    axes.set_ylabel(_AXES[sheet.plane.y.key])
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter(NullFormatter())
    held = ("δ", groups_of(diagram.scene).delta) if sheet.plane.y.key == "V" else ("V", groups_of(diagram.scene).V)
    axes.set_title(f"{held[0]} = {held[1]:.3g}", fontsize=9)
    style.lighten(axes)


def _edges(values: Floats) -> Floats:
    """Boundaries between lattice values, half a step beyond the first and the last."""
    log = np.log(values)
    middle = (log[1:] + log[:-1]) / 2
    return np.asarray(np.exp(np.concatenate([[2 * log[0] - middle[0]], middle, [2 * log[-1] - middle[-1]]])))


def _explain(figure: Figure, diagram: PhaseDiagram) -> None:
    width, height = figure.get_size_inches()
    patches = [Patch(facecolor=c, edgecolor=style.GREY, linewidth=0.4, label=n) for n, c in (*_REGIMES.values(), _NONE)]
    lines = [Line2D([], [], label=_NAMES[source], **line) for source, line in _LINES.items()]
    for handles, down, size in ((patches, 0.5, 7.2), (lines, 0.7, 7.2)):
        place = (_LEFT / width, (_BOTTOM - down) / height)
        settings: dict[str, Any] = {"borderaxespad": 0.0, "fontsize": size, "columnspacing": 1.2, "handlelength": 2.0}
        figure.legend(handles=handles, loc="upper left", bbox_to_anchor=place, ncols=len(handles), **settings)
    text = fill(caption(diagram), 158)
    figure.text(_LEFT / width, (_BOTTOM - 0.98) / height, text, va="top", fontsize=7.2, parse_math=False)


def phase_files(diagram: PhaseDiagram) -> dict[str, bytes]:
    """Picture, data and facts of figure 3(a), by file name."""
    names = ("plane", "G", "V", "delta", "regime", "outcome", "sag_over_L", "largest_rate_over_sY_by_eta")
    return {
        **printed("figure3a", phase_figure(diagram)),
        "figure3a-runs.csv": table(names, _runs(diagram)),
        "figure3a-lines.csv": table(("plane", "line", "source", "equation", "other", "G"), _lines(diagram)),
        "figure3a.json": facts({"caption": caption(diagram), "planes": [_facts(sheet) for sheet in diagram.sheets]}),
    }


def _runs(diagram: PhaseDiagram) -> Iterator[tuple[object, ...]]:
    for sheet in diagram.sheets:
        for point in sheet.points:
            run = point.run
            place = (run.place.G, run.place.V, run.place.delta)
            yield (sheet.plane.name, *place, run.regime or "none", run.outcome, run.sag, run.rate)


def _lines(diagram: PhaseDiagram) -> Iterator[tuple[object, ...]]:
    for sheet in diagram.sheets:
        for line in sheet.lines:
            about = (text.replace(",", " with") for text in (line.name, line.source, line.equation))
            about_line = tuple(about)
            for other, G in zip(line.other.tolist(), line.G.tolist(), strict=True):
                yield (sheet.plane.name, *about_line, other, G)


def _facts(sheet: PhaseSheet) -> dict[str, Any]:
    return {
        "plane": sheet.plane.name,
        "runs": sheet.runs,
        "lattice_nodes": sheet.nodes,
        "nodes_never_run": sheet.saved,
        "regimes": sheet.counts,
        "boundary_over_formula": [
            {
                "boundary": each.kind,
                "line": each.line.name,
                "source": each.line.source,
                "rows": each.rows,
                "median": 1 + each.median,
                "least": 1 + each.least,
                "most": 1 + each.most,
            }
            for each in sheet.distances
        ],
    }
