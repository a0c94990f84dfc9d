"""Midpoint of elements and filaments against time, and their differences below."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.compare_axes import (
    ELEMENTS,
    LEFT,
    RIGHT,
    clock_of,
    elements_name,
    legend_row,
    line_of,
    share_time,
    trusted_extent,
)
from softcat_sym.plotting.style import HEADING, axes_in_inches, head, length_unit, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.studies.compare import Comparison

_HEIGHT, _BOTTOM, _GAP, _RESIDUAL, _ABOVE = 5.6, 0.55, 0.2, 1.5, 0.72
_ROOM = 1.15

# A published theory may run away: beyond this many per cent, and this multiple of the filament's own error, it leaves
# the picture.
_WORST, _TIMES_OWN = 5.0, 3.0


def midpoint_figure(comparison: Comparison) -> Figure:
    """Draw midpoints above, (filament - elements)/max |elements| below."""
    own = comparison.filament.trajectory
    with style.styled():
        figure = new_figure(style.WIDTH, _HEIGHT)
        head(figure, "midpoint, filament against elements", own.summary, comparison.scene, LEFT)
        legend_top = _HEIGHT - HEADING
        width = style.WIDTH - LEFT - RIGHT
        bottom = _BOTTOM + _RESIDUAL + _GAP
        above = axes_in_inches(figure, LEFT, bottom, width, legend_top - _ABOVE - bottom)
        below = axes_in_inches(figure, LEFT, _BOTTOM, width, _RESIDUAL)
        _heights(above, comparison)
        _differences(below, comparison)
        share_time((above, below), comparison)
        legend_row(figure, above, legend_top)
    return figure


def _heights(axes: Axes, comparison: Comparison) -> None:
    elements = comparison.elements
    clock, ruler = (
        clock_of(comparison),
        length_unit(float(np.abs(elements.midpoint).max()), comparison.scene.filament.span),
    )
    time = clock.of(elements.time)
    axes.plot(time, ruler.of(elements.midpoint), label=elements_name(comparison), **ELEMENTS)
    for row in comparison.filaments:
        axes.plot(time, ruler.of(row.midpoint), **line_of(row))
    every = np.concatenate([elements.midpoint, *(row.midpoint for row in comparison.filaments)])
    own = comparison.filament
    far = trusted_extent(elements.midpoint, own.midpoint, trusted=own.trajectory.outcome.is_success)
    far = far or comparison.scene.filament.span
    low, high = (float(np.clip(bound, -far, far)) for bound in (np.nanmin(every), np.nanmax(every)))
    room = (_ROOM - 1) * max(high - low, 0.1 * far)
    axes.set_ylim(float(ruler.of(min(low, 0.0) - room)), float(ruler.of(max(high, 0.0) + room / 2)))
    axes.set_ylabel(f"midpoint height [{ruler.symbol}]")


def _differences(axes: Axes, comparison: Comparison) -> None:
    time = clock_of(comparison).of(comparison.elements.time)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    for row in comparison.filaments:
        axes.plot(time, 100 * row.discrepancy.error, **line_of(row))
    known = np.nan_to_num([100 * row.discrepancy.largest for row in comparison.filaments])
    shown = min(float(known.max()), max(_TIMES_OWN * float(known[0]), _WORST)) or 1.0
    axes.set_ylim(-_ROOM * shown, _ROOM * shown)
    axes.set_ylabel("(filament − elements)\n/ max |elements| [%]", fontsize=8.0)
