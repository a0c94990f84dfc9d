"""Where every start began, where it ended, and how good that is."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.fit_panels import headed, parameter_axis, plain
from softcat_sym.plotting.fit_words import starts_text
from softcat_sym.plotting.style import HEADING, axes_in_inches

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.fitting.fit import Fit

_LEFT, _RIGHT, _BOTTOM, _ACROSS, _BETWEEN = 0.6, 0.25, 0.75, 0.25, 0.75
_STEP, _LEAST = 0.22, 1.2
_MOST = 4
"""Panels in a row."""

_COLORS = (style.VERMILLION, style.BLUE, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)
# Ratio of the worst value to the best from which on the axis is logarithmic.
_FAR = 3.0


def starts_figure(fit: Fit) -> Figure:
    """Draw a line for each start, the best on top: what is left of the misfit, and each parameter's way."""
    panels = 1 + len(fit.problem.free)
    across = min(panels, _MOST)
    rows = -(-panels // across)
    tall = max(_LEAST, _STEP * (len(fit.starts.falls) + 1))
    height = HEADING + rows * tall + (rows - 1) * _BETWEEN + _BOTTOM + 0.05
    wide = (style.WIDTH - _LEFT - _RIGHT - (across - 1) * _ACROSS) / across
    with style.styled():
        figure = headed(fit, f"starts: {starts_text(fit)}", height, _LEFT)
        for k in range(panels):
            row, column = divmod(k, across)
            foot = _BOTTOM + (rows - 1 - row) * (tall + _BETWEEN)
            axes = axes_in_inches(figure, _LEFT + column * (wide + _ACROSS), foot, wide, tall)
            if k == 0:
                _draw_values(axes, fit)
            else:
                _draw_way(axes, fit, k - 1)
            _ranks(axes, len(fit.starts.falls), labelled=column == 0)
        _legend(figure, fit)
    return figure


def _color(cluster: int) -> str:
    return _COLORS[cluster] if cluster < len(_COLORS) else style.GREY


def _face(converged: bool, color: str) -> str:
    return color if converged else "white"


def _draw_values(axes: Axes, fit: Fit) -> None:
    from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator

    values = fit.starts.values
    least = float(values.min())
    # A fit that meets exact data has nothing left to compare with.
    shares = values / least if least > 0 else values
    for rank, (fall, share) in enumerate(zip(fit.starts.falls, shares.tolist(), strict=True), start=1):
        color = _color(fall.cluster)
        face = _face(fall.optimum.converged, color)
        axes.plot([share], [rank], "o", color=color, markerfacecolor=face, markersize=5)
    far = float(shares.max())
    if least > 0 and far > _FAR:
        axes.set_xscale("log")
        axes.set_xlim(0.7, 1.5 * far)
        decades = np.log10(far)
        axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if decades < 1 else (1.0,), numticks=5))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_minor_formatter(NullFormatter())
    else:
        room = max(0.08 * (far - float(shares.min())), 0.02 * abs(far), 1e-300)
        axes.set_xlim(float(shares.min()) - room, far + room)
        axes.xaxis.set_major_locator(MaxNLocator(3))
    axes.xaxis.set_major_formatter(FuncFormatter(plain))
    axes.set_xlabel("misfit / least misfit" if least > 0 else "misfit", fontsize=8)


def _draw_way(axes: Axes, fit: Fit, index: int) -> None:
    free = fit.problem.free[index]
    ways = [(free.value(float(one.start[index])), free.value(float(one.optimum.q[index]))) for one in fit.starts.falls]
    unit = parameter_axis(axes, free, np.array(ways).ravel(), ways[0][1])
    for rank, (fall, (start, end)) in enumerate(zip(fit.starts.falls, ways, strict=True), start=1):
        color = _color(fall.cluster)
        begin, finish = float(unit.of(start)), float(unit.of(end))
        axes.plot([begin, finish], [rank, rank], color=color, linewidth=0.9, alpha=0.6)
        axes.plot([begin], [rank], "|", color=color, markersize=7)
        axes.plot(
            [finish], [rank], "o", color=color, markerfacecolor=_face(fall.optimum.converged, color), markersize=5
        )


def _ranks(axes: Axes, count: int, *, labelled: bool) -> None:
    from matplotlib.ticker import MaxNLocator

    axes.set_ylim(count + 0.7, 0.3)
    axes.yaxis.set_major_locator(MaxNLocator(min(8, count + 1), integer=True))
    axes.grid(True, axis="x")
    axes.tick_params(labelleft=labelled)
    if labelled:
        axes.set_ylabel("start")
    style.lighten(axes)


def _legend(figure: Figure, fit: Fit) -> None:
    from matplotlib.lines import Line2D

    grey: dict[str, object] = {"color": style.BLACK, "linestyle": ""}
    handles = [
        Line2D([], [], marker="|", markersize=7, label="start", **grey),  # type: ignore[arg-type]
        Line2D([], [], marker="o", markersize=5, label="end", **grey),  # type: ignore[arg-type]
    ]
    if not all(one.optimum.converged for one in fit.starts.falls):
        handles.append(Line2D([], [], marker="o", markersize=5, markerfacecolor="white", label="not converged", **grey))  # type: ignore[arg-type]
    clusters = sorted({one.cluster for one in fit.starts.falls})[: len(_COLORS)]
    for cluster in clusters if len(clusters) > 1 else ():
        name = "the best fit" if cluster == 0 else f"another fit ({cluster + 1})"
        handles.append(Line2D([], [], marker="s", linestyle="", markersize=5, color=_color(cluster), label=name))
    spot = (_LEFT / style.WIDTH, 0.0)
    figure.legend(handles=handles, loc="lower left", bbox_to_anchor=spot, ncols=6, fontsize=7.5, handletextpad=0.3)
