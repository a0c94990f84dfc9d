"""Several varied keys: the sag over each of them, and their pairs, each member marked by its regime."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from softcat_sym.plotting import style
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.plotting.sweep import NONE, drawn_axes, frame, key_of, regimes_of, scatter, shown_members

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.discretization.grid import Floats

_LEFT, _RIGHT, _TOP, _BOTTOM, _GAP, _TALL = 0.75, 0.15, 0.5, 1.05, 0.12, 1.55
_MOST = 5


def pairs_figure(data: xr.Dataset, title: str) -> Figure:
    """Draw a triangle: the sag in the top row, below it each key over those before it; of more keys the first five."""
    drawn = drawn_axes(data)[:_MOST]
    members = shown_members(data)
    regimes, outcomes = regimes_of(data), data.outcome.values.astype(np.str_)
    count = len(drawn)
    wide = (style.WIDTH - _LEFT - _RIGHT - (count - 1) * _GAP) / count
    tall = max(_TALL, 2.6 - 0.4 * count) if count > 2 else 2.4
    height = _TOP + count * tall + (count - 1) * _GAP + _BOTTOM
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        for row in range(count):
            for column in range(row if row else count):
                left, bottom = _LEFT + column * (wide + _GAP), height - _TOP - (row + 1) * tall - row * _GAP
                axes = axes_in_inches(figure, left, bottom, wide, tall)
                values = drawn[row].values if row else data.sag_over_span.values
                _panel(axes, drawn[column].values[members], values[members], regimes[members])
                drawn[column].dress(axes)
                if row:
                    drawn[row].dress(axes, "y")
                # The first panel of a row and the lowest of a column carry their labels.
                _undress(axes, across=row < (count - 1 if column < count - 1 else 0), upwards=column > 0)
                if not row and not column:
                    axes.set_ylabel("largest sag / span")
        frame(figure, title, key_of(regimes, outcomes), _LEFT)
    return figure


def _panel(axes: Axes, x: Floats, y: Floats, regimes: npt.NDArray[np.str_]) -> None:
    """The members; one that is no answer where it has both values."""
    size, nothing = float(np.clip(2500 / max(len(x), 1), 3, 16)), regimes == ""
    axes.scatter(x[nothing], y[nothing], s=size, marker=NONE[0], c=NONE[1], linewidths=0.6, zorder=2)
    scatter(axes, x, y, regimes, size)
    axes.grid(True)
    style.lighten(axes)


def _undress(axes: Axes, *, across: bool, upwards: bool) -> None:
    """Take away the labels of an axis that another panel carries."""
    if across:
        axes.set_xlabel("")
        axes.tick_params(labelbottom=False, which="both")
    if upwards:
        axes.set_ylabel("")
        axes.tick_params(labelleft=False, which="both")
