"""One varied key: sag, time and stretch over it, each member marked by its regime."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from softcat_sym.plotting import style
from softcat_sym.plotting.style import axes_in_inches, new_figure, time_unit
from softcat_sym.plotting.sweep import NONE, drawn_axes, frame, key_of, regimes_of, scatter, shown_members

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.discretization.grid import Floats
    from softcat_sym.plotting.sweep import DrawnAxis

_LEFT, _RIGHT, _TOP, _SAG, _OTHER, _GAP, _BOTTOM = 0.75, 0.2, 0.5, 2.5, 1.15, 0.14, 1.02


def line_figure(data: xr.Dataset, title: str) -> Figure:
    """Draw largest sag over span, time to 90 % and largest stretch against the one key that varies."""
    axis = drawn_axes(data)[0]
    members = shown_members(data)
    regimes, outcomes = regimes_of(data), data.outcome.values.astype(np.str_)
    clock = time_unit(_largest(data.time_to_90.values))
    rows = (
        ("largest sag / span", data.sag_over_span.values, _SAG),
        (f"time to 90 % [{clock.symbol}]", clock.of(data.time_to_90.values), _OTHER),
        ("largest stretch", data.largest_stretch.values, _OTHER),
    )
    height = _TOP + _SAG + 2 * _OTHER + 2 * _GAP + _BOTTOM
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        bottom = height - _TOP
        for k, (label, values, tall) in enumerate(rows):
            bottom -= tall + (_GAP if k else 0)
            axes = axes_in_inches(figure, _LEFT, bottom, style.WIDTH - _LEFT - _RIGHT, tall)
            _panel(axes, axis, values[members], axis.values[members], regimes[members])
            axes.set_ylabel(label)
            if k < len(rows) - 1:
                axes.set_xlabel("")
                axes.tick_params(labelbottom=False, which="both")
        frame(figure, title, key_of(regimes, outcomes), _LEFT)
    return figure


def _panel(axes: Axes, axis: DrawnAxis, values: Floats, x: Floats, regimes: npt.NDArray[np.str_]) -> None:
    order = np.argsort(x, kind="stable")
    if not axis.words:
        axes.plot(x[order], values[order], color=style.GREY, linewidth=0.7, zorder=2)
    size = float(np.clip(1800 / max(len(x), 1), 5, 20))
    scatter(axes, x, values, regimes, size)
    axis.dress(axes)
    known = values[np.isfinite(values)]
    if len(known):
        low, high = float(np.min(known)), float(np.max(known))
        room = 0.08 * (high - low) or 0.05 * abs(high) or 1.0
        axes.set_ylim(low - room, high + room)
    nothing = regimes == ""
    marker, colour = NONE
    foot = axes.get_xaxis_transform()
    axes.scatter(
        x[nothing],
        np.full(int(nothing.sum()), 0.03),
        s=14,
        marker=marker,
        c=colour,
        linewidths=0.8,
        transform=foot,
        zorder=3,
    )
    axes.grid(True)
    style.lighten(axes)


def _largest(values: Floats) -> float:
    known = values[np.isfinite(values)]
    return float(np.max(known)) if len(known) else 1.0
