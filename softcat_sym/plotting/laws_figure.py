"""What every law leaves unexplained of the same films."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.fit_panels import headed, plain
from softcat_sym.plotting.laws_table import residual_std
from softcat_sym.plotting.style import HEADING, axes_in_inches, length_unit, time_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.fitting.fit import Fit
    from softcat_sym.fitting.model_selection import LawComparison, Ranked
    from softcat_sym.plotting.style import Unit

_LEFT, _RIGHT, _BOTTOM, _EACH, _BETWEEN = 0.85, 0.2, 0.55, 1.0, 0.35

_CROWDED = 0.12
"""Where half of the frames lie within this share of the time, the axis is logarithmic."""

_ROOM, _FURTHER = 1.1, 3.0
"""Of the scale over the best law's largest residual; how much larger those of others may make it."""


def laws_figure(found: LawComparison) -> Figure:
    """Draw the residuals [m] of every law over time on one scale, the best law first.

    What leaves the scale is a cross at its edge: a law that is far off would make the others' residuals a line.
    """
    rows = [row for row in found.choice.table if not row.law.failure]
    fits = [found.fits[row.law.name] for row in rows]
    height = HEADING + 0.2 + len(rows) * (_EACH + _BETWEEN) - _BETWEEN + _BOTTOM
    reaches = [_reach(one) for one in fits]
    far = _ROOM * min(max(reaches), _FURTHER * reaches[0])
    ruler = length_unit(far)
    with style.styled():
        figure = headed(found.best, found.sentence, height, _LEFT)
        width = style.WIDTH - _LEFT - _RIGHT
        for k, (row, one) in enumerate(zip(rows, fits, strict=True)):
            foot = _BOTTOM + (len(rows) - 1 - k) * (_EACH + _BETWEEN)
            axes = axes_in_inches(figure, _LEFT, foot, width, _EACH)
            _draw(axes, one, far, ruler)
            _time_axis(axes, one, last=k == len(rows) - 1)
            axes.set_title(_title(row, one, found.choice.criterion), loc="left", fontsize=8.5, pad=3, parse_math=False)
            axes.set_ylabel(f"residual [{ruler.symbol}]", fontsize=8)
    return figure


def _title(row: Ranked, one: Fit, criterion: str) -> str:
    spread = residual_std(one)
    parts = [
        row.law.name,
        f"{criterion} {row.difference:.1f} above the best" if row.difference else f"least {criterion}",
    ]
    return " · ".join([*parts, f"residuals {one.checks.verdict}", f"rms {length_unit(spread).text(spread)}"])


def _reach(one: Fit) -> float:
    """Largest residual [m]."""
    return max(float(np.abs(film.model - film.measured).max()) for film in one.films) or 1e-12


def _draw(axes: Axes, one: Fit, far: float, ruler: Unit) -> None:
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    clock = _clock(one)
    colours = (style.BLUE, style.VERMILLION, style.GREEN, style.ORANGE, style.PURPLE, style.SKY)
    axes.grid(True)
    axes.axhline(0.0, color=style.GREY, linewidth=0.8)
    for k, film in enumerate(one.films):
        colour, left = colours[k % len(colours)], film.model - film.measured
        out = np.abs(left) > far
        time, height = clock.of(film.time), ruler.of(np.clip(left, -far, far))
        axes.plot(time[~out], height[~out], ".", color=colour, markersize=3.5, clip_on=False)
        axes.plot(time[out], height[out], "x", color=colour, markersize=3.5, clip_on=False)
    edge = float(ruler.of(far))
    axes.set_ylim(-edge, edge)
    axes.yaxis.set_major_locator(MaxNLocator(4, symmetric=True))
    axes.yaxis.set_major_formatter(FuncFormatter(plain))
    style.lighten(axes)


def _clock(one: Fit) -> Unit:
    return time_unit(max(float(film.time.max()) for film in one.films))


def _time_axis(axes: Axes, one: Fit, *, last: bool) -> None:
    from matplotlib.ticker import FuncFormatter, NullFormatter

    clock = _clock(one)
    times = clock.of(np.concatenate([film.time for film in one.films]))
    later = times[times > 0]
    end = float(later.max())
    if later.size > 2 and float(np.median(later)) < _CROWDED * end:
        axes.set_xscale("log")
        axes.set_xlim(float(later.min()) / 1.1, end * 1.1)
        axes.xaxis.set_major_formatter(FuncFormatter(plain))
        axes.xaxis.set_minor_formatter(NullFormatter())
    else:
        axes.set_xlim(min(0.0, float(times.min())) - 0.02 * end, 1.02 * end)
    axes.tick_params(labelbottom=last)
    if last:
        axes.set_xlabel(f"time [{clock.symbol}]")
