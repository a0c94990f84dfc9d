"""Centrelines of elements and filament laid on one another at several times, and their distance below."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.lines import Line2D

from softcat_sym.discretization.grid import Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.compare_axes import LEFT, clock_of, elements_name, plain_numbers
from softcat_sym.plotting.style import HEADING, Unit, axes_in_inches, head, length_unit, new_figure
from softcat_sym.studies.compare import moments

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.studies.compare import Comparison

_RIGHT, _BOTTOM, _GAP, _BELOW, _LEGEND = 1.25, 0.55, 0.55, 1.5, 0.42
_LOWEST, _TALLEST = 1.1, 4.5
_COLOURS = (style.SKY, style.GREEN, style.ORANGE, style.VERMILLION)


@dataclass(frozen=True)
class ShapePair:
    """Half a centreline, 0 <= X <= L/2, of elements and filament at one time."""

    time: float  # [s]
    X: Floats  # shape (columns,); Material positions [m]
    elements: Floats  # shape (columns, 2); Where they are [m]
    filament: Floats

    @property
    def distance(self) -> Floats:
        """Distance between the two places of each material point [m]."""
        return np.asarray(np.linalg.norm(self.filament - self.elements, axis=1))


def shape_pairs(comparison: Comparison) -> list[ShapePair]:
    """Both centrelines at the moments of the error table that the filament reached."""
    run, data = comparison.elements, comparison.filament.trajectory.data
    nodes, reached = data["X_node"].values, data.sizes["time"]
    return [
        ShapePair(
            float(run.time[frame]),
            run.X,
            np.column_stack([run.x[frame], run.y[frame]]),
            np.column_stack([np.interp(run.X, nodes, data[name].values[frame]) for name in ("x", "y")]),
        )
        for frame in sorted({*moments(len(run.time))})
        if frame < reached
    ]


def shapes_figure(comparison: Comparison) -> Figure:
    """Draw centrelines above, the distance of equal material points below."""
    pairs, span = shape_pairs(comparison), comparison.scene.filament.span
    deepest = max((float(np.abs(pair.elements[:, 1]).max()) for pair in pairs), default=0.0) or 0.01 * span
    width = style.WIDTH - LEFT - _RIGHT
    true = 1.12 * deepest / (1.04 * span) * width
    tall = min(max(true, _LOWEST), _TALLEST)
    height = _BOTTOM + _BELOW + _GAP + tall + _LEGEND + HEADING
    ruler = length_unit(span)
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        head(figure, "centrelines", comparison.filament.trajectory.summary, comparison.scene, LEFT)
        above = axes_in_inches(figure, LEFT, _BOTTOM + _BELOW + _GAP, width, tall)
        below = axes_in_inches(figure, LEFT, _BOTTOM, width, _BELOW)
        _centrelines(above, pairs, comparison, ruler)
        above.set_xlim(*(float(ruler.of(side * 0.52 * span)) for side in (-1, 1)))
        above.set_ylim(float(ruler.of(-1.08 * deepest)), float(ruler.of(0.04 * deepest)))
        scale = "" if abs(tall / true - 1) < 1e-9 else f"; vertical scale × {tall / true:.3g}"
        above.set_xlabel(f"x [{ruler.symbol}]{scale}", labelpad=1.0)
        above.set_ylabel(f"y [{ruler.symbol}]")
        style.lighten(above)
        _distances(below, pairs, span)
        _explain(figure, comparison, height - HEADING)
    return figure


def _centrelines(axes: Axes, pairs: list[ShapePair], comparison: Comparison, ruler: Unit) -> None:
    clock = clock_of(comparison)
    for pair, colour in zip(pairs, _COLOURS, strict=False):
        for side in (-1, 1):
            x, y = ruler.of(pair.filament).T
            label = f"t = {clock.text(pair.time)}" if side > 0 else None
            axes.plot(side * x, y, color=colour, linewidth=2.4, label=label, solid_capstyle="butt")
            x, y = ruler.of(pair.elements).T
            axes.plot(side * x, y, color=style.BLACK, linewidth=0.9, linestyle=(0, (4, 3)), zorder=3)
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, handlelength=1.4)


def _distances(axes: Axes, pairs: list[ShapePair], span: float) -> None:
    for pair, colour in zip(pairs, _COLOURS, strict=False):
        axes.plot(pair.X / span, 100 * pair.distance / span, color=colour, linewidth=1.3)
    axes.set_xlim(0.0, 0.5)
    largest = max((float(pair.distance.max()) for pair in pairs), default=0.0)
    axes.set_ylim(0.0, 115 * largest / span or 1.0)
    axes.set_xlabel("X / L, midspan to clamp")
    axes.set_ylabel("distance / L [%]")
    axes.grid(True)
    plain_numbers(axes)
    style.lighten(axes)


def _explain(figure: Figure, comparison: Comparison, top: float) -> None:
    height = figure.get_size_inches()[1]
    figure.legend(
        handles=[
            Line2D([], [], color=style.GREY, linewidth=2.4, label="filament (coloured by time)"),
            Line2D([], [], color=style.BLACK, linewidth=0.9, linestyle=(0, (4, 3)), label=elements_name(comparison)),
        ],
        loc="upper left",
        bbox_to_anchor=(LEFT / style.WIDTH, top / height),
        ncols=2,
        borderaxespad=0.0,
    )
