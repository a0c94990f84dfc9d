"""Picture of local strains over a phase plane: at the clamp and at midspan, against the paper's 23 %."""

from __future__ import annotations

from collections.abc import Callable
from textwrap import fill
from typing import TYPE_CHECKING, Final

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.phase_diagram import draw_tints, finish, look_of
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.studies.phase import PAPER_STRAIN, PhaseDiagram, PhaseSheet
from softcat_sym.studies.phase_runs import PhaseRun

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_LEFT, _GAP, _PANEL, _TALL, _TOP, _BOTTOM, _BAR = 0.62, 0.35, 2.6, 2.6, 0.65, 1.25, 0.12
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
    from matplotlib.colors import LogNorm

    height = _TOP + _TALL + _BOTTOM
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        answers = [point.run for point in sheet.points if point.run.regime is not None]
        others = [point.run for point in sheet.points if point.run.regime is None]
        scale = LogNorm(_LOW, _HIGH)
        for column, (words, strain) in enumerate(_PLACES):
            axes = axes_in_inches(figure, _LEFT + column * (_PANEL + _GAP), _BOTTOM, _PANEL, _TALL)
            draw_tints(axes, sheet)
            strains = np.clip([strain(run) for run in answers], _LOW, _HIGH)
            edges = [style.BLACK if value > PAPER_STRAIN else "none" for value in strains]
            x, y = _places(sheet, answers)
            drawn = axes.scatter(
                x, y, c=strains, s=12, norm=scale, cmap="viridis_r", edgecolors=edges, linewidths=0.7, zorder=2
            )
            x, y = _places(sheet, others)
            axes.scatter(x, y, marker="x", s=9, c=look_of("localised").colour, linewidths=0.6, zorder=2)
            finish(axes, sheet)
            axes.set_title(words, fontsize=9)
            if column:
                axes.set_ylabel("")
                axes.tick_params(labelleft=False)
        bar = axes_in_inches(figure, _LEFT + 2 * _PANEL + _GAP + 0.15, _BOTTOM, _BAR, _TALL)
        figure.colorbar(drawn, cax=bar, format=lambda value, _: f"{value:g}").set_label("strain")
        bar.axhline(PAPER_STRAIN, color=style.BLACK, linewidth=1.2)
        left = 0.2 / style.WIDTH
        other = "δ" if sheet.plane.y.key == "delta" else "V"
        title = f"Local strain over G and {other}"
        figure.text(left, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold")
        text = fill(strain_caption(diagram), 128)
        figure.text(left, (_BOTTOM - 0.55) / height, text, va="top", fontsize=7.5, parse_math=False)
    return figure


def _places(sheet: PhaseSheet, runs: list[PhaseRun]) -> tuple[list[float], list[float]]:
    return [run.place.G for run in runs], [getattr(run.place, sheet.plane.y.key) for run in runs]
