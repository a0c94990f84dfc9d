"""The design of an experiment: every filament that was tried by its worst relative error, and the best of them."""

from __future__ import annotations

import math
from collections.abc import Callable
from textwrap import fill
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.design.experiment import Experiment
from softcat_sym.design.information import DURATION, FRAME_RATE, SPAN, THICKNESS, Trial
from softcat_sym.plotting import style
from softcat_sym.plotting.style import HEADING, axes_in_inches, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

_LEFT, _RIGHT, _TALL = 0.85, 1.25, 3.4
_LABELS = {
    SPAN: ("span [mm]", 1e3),
    THICKNESS: ("thickness [mm]", 1e3),
    DURATION: ("duration [s]", 1.0),
    FRAME_RATE: ("frames a second", 1.0),
}
_LINE = 0.17


def experiment_figure(experiment: Experiment) -> Figure:
    """Draw the trials over two design variables, those that were open to choice first; colour is the worst error."""
    text = [fill(sentence, 112) for sentence in experiment.text]
    lines = sum(paragraph.count("\n") + 1 for paragraph in text)
    bottom = 0.6 + _LINE * lines
    height = HEADING + _TALL + bottom
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        left = 0.2 / style.WIDTH
        title = "Worst relative standard error of the experiments that were tried"
        figure.text(left, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold")
        below = "a film of the best duration for each filament; crosses: no answer, or not determined"
        figure.text(left, 1 - 0.33 / height, below, va="top", fontsize=8.5, color=style.GREY)
        axes = axes_in_inches(figure, _LEFT, bottom, style.WIDTH - _LEFT - _RIGHT, _TALL)
        _draw(axes, experiment)
        written = "\n".join(text)
        figure.text(left, 0.1 / height, written, va="bottom", fontsize=7.5, linespacing=1.4, parse_math=False)
    return figure


def _draw(axes: Axes, experiment: Experiment) -> None:
    from matplotlib.colors import LogNorm

    across, up = _open_to_choice(experiment.tried)
    places = [tuple(one.values[path] * _LABELS[path][1] for path in (across, up)) for one in experiment.tried]
    pairs = list(zip(places, experiment.tried, strict=True))
    good = [(place, one.worst) for place, one in pairs if math.isfinite(one.worst)]
    bad = [place for place, one in pairs if not math.isfinite(one.worst)]
    worst = [error for _, error in good]
    norm = LogNorm(min(worst), max(max(worst), 1.01 * min(worst)))
    at = np.array([place for place, _ in good])
    drawn = axes.scatter(at[:, 0], at[:, 1], c=worst, norm=norm, cmap="viridis_r", s=36, linewidths=0, clip_on=False)
    if bad:
        lost = np.array(bad)
        axes.plot(lost[:, 0], lost[:, 1], "x", color=style.GREY, markersize=5, clip_on=False)
    x, y = (experiment.best.values[path] * _LABELS[path][1] for path in (across, up))
    axes.plot([x], [y], "o", markersize=11, fillstyle="none", color=style.VERMILLION, clip_on=False)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(0.05)
    for axis in (axes.xaxis, axes.yaxis):
        _plain(axis, lambda value: f"{value:g}")
    axes.set_xlabel(_LABELS[across][0])
    axes.set_ylabel(_LABELS[up][0])
    style.lighten(axes)
    side = axes.inset_axes((1.04, 0.0, 0.03, 1.0))
    bar = axes.figure.colorbar(drawn, cax=side, label="worst relative error")
    _plain(bar.ax.yaxis, lambda value: f"{100 * value:.3g} %")


def _plain(axis: Axis, text: Callable[[float], str]) -> None:
    """Write one, two and five of each decade as plain numbers, without Matplotlib's formulas."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: text(value)))
    axis.set_minor_formatter(NullFormatter())


def _open_to_choice(tried: tuple[Trial, ...]) -> tuple[str, str]:
    """The two design variables to be shown: the first two that vary."""
    order = (SPAN, THICKNESS, DURATION, FRAME_RATE)
    varied = [path for path in order if len({one.values[path] for one in tried}) > 1]
    both = [*varied, *(path for path in order if path not in varied)]
    return both[0], both[1]
