"""Profile likelihoods: threshold, interval, optimum, and what the curvature alone would say."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.fit_panels import headed, parameter_axis
from softcat_sym.plotting.style import HEADING, axes_in_inches

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from softcat_sym.fitting.fit import Fit
    from softcat_sym.fitting.free_parameters import FreeParameter
    from softcat_sym.fitting.inference import Profile

_LEFT, _RIGHT, _BOTTOM = 0.65, 0.2, 0.55
_TALL, _ACROSS, _BETWEEN, _ABOVE = 1.8, 0.35, 0.85, 0.3
_MOST = 3
"""Panels in a row."""

_DENSE = 400
# Thresholds that the axis is high: what happens far above it is nobody's concern.
_HIGH = 2.2


def profiles_figure(fit: Fit) -> Figure:
    """Draw one panel for each parameter."""
    count = len(fit.profiles)
    across = min(count, _MOST)
    rows = math.ceil(count / across)
    height = HEADING + _ABOVE + rows * _TALL + (rows - 1) * _BETWEEN + _BOTTOM + 0.22
    wide = (style.WIDTH - _LEFT - _RIGHT - (across - 1) * _ACROSS) / across
    with style.styled():
        what = "profile likelihood: how much worse the fit becomes with one parameter held, the others fitted anew"
        figure = headed(fit, what, height, _LEFT)
        for k, (one, free) in enumerate(zip(fit.profiles, fit.problem.free, strict=True)):
            row, column = divmod(k, across)
            foot = _BOTTOM + 0.22 + (rows - 1 - row) * (_TALL + _BETWEEN)
            axes = axes_in_inches(figure, _LEFT + column * (wide + _ACROSS), foot, wide, _TALL)
            _draw(axes, one, free, float(fit.information.standard_errors[k]))
            axes.set_title(fit.parameters[free.name].verdict, loc="left", fontsize=8.5, pad=4)
            if column == 0:
                axes.set_ylabel("increase of χ²")
        handles = figure.axes[0].get_legend_handles_labels()
        figure.legend(*handles, loc="lower left", bbox_to_anchor=(_LEFT / style.WIDTH, 0.0), ncols=5, fontsize=7.5)
    return figure


def _draw(axes: Axes, one: Profile, free: FreeParameter, error: float) -> None:
    values = np.array([free.value(q) for q in one.q.tolist()])
    unit = parameter_axis(axes, free, values, free.value(one.optimum))
    dense, curve = smooth(one)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    axes.axhline(one.threshold, label="95 % threshold", color=style.GREEN, linewidth=1.0, linestyle=(0, (6, 2)))
    for side in (one.lower, one.upper):
        if side.crossing is not None:
            at = float(unit.of(free.value(side.crossing)))
            axes.plot([at, at], [0, one.threshold], color=style.GREEN, linewidth=0.9, linestyle=":")
    parabola = ((dense - one.optimum) / error) ** 2 if error > 0 else np.zeros_like(dense)
    shown = np.array([float(unit.of(free.value(q))) for q in dense.tolist()])
    axes.plot(shown, parabola, color=style.GREY, linewidth=1.1, linestyle="--", label="curvature only")
    axes.plot(shown, curve, color=style.BLUE, linewidth=1.4, label="profile")
    axes.plot(unit.of(values), one.increase, "o", color=style.BLUE, markersize=2.8)
    axes.plot(
        [unit.of(free.value(one.optimum))], [0], "o", color=style.VERMILLION, markersize=5, label="best fit", zorder=4
    )
    low = min(0.0, float(one.increase.min()))
    axes.set_ylim(low - 0.1 * one.threshold, _HIGH * one.threshold)
    style.lighten(axes)


def smooth(one: Profile) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A profile between its points: their roots, nearly straight in q on either side, joined by lines, and squared."""
    root = np.sqrt(np.maximum(one.increase, 0.0))
    dense = np.union1d(np.linspace(one.q[0], one.q[-1], _DENSE), one.q)
    inside = np.interp(dense, one.q, root)
    return dense, inside**2
