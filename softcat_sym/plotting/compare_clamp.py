"""Axial strain next to the clamp, of elements and filaments, against time."""

from __future__ import annotations

from textwrap import fill
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
from softcat_sym.plotting.style import HEADING, axes_in_inches, head, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from softcat_sym.studies.compare import Comparison

_HEIGHT, _BOTTOM, _GAP, _ABOVE = 5.4, 0.9, 0.2, 0.72
_NOTE = (
    "Over the Gauss points of the elements at the clamp ({column} of a thickness long): log |F e_X| of the elements, "
    "log s − θ_s z of the filament in its fibres through the same material points."
)


def clamp_figure(comparison: Comparison) -> Figure:
    """Draw the largest strain above, the mean below."""
    with style.styled():
        figure = new_figure(style.WIDTH, _HEIGHT)
        head(figure, "axial true strain at the clamp", comparison.filament.trajectory.summary, comparison.scene, LEFT)
        legend_top = _HEIGHT - HEADING
        width, height = style.WIDTH - LEFT - RIGHT, (legend_top - _ABOVE - _BOTTOM - _GAP) / 2
        above = axes_in_inches(figure, LEFT, _BOTTOM + height + _GAP, width, height)
        below = axes_in_inches(figure, LEFT, _BOTTOM, width, height)
        time = clock_of(comparison).of(comparison.elements.time)
        for axes, which in ((above, "largest"), (below, "mean")):
            reference = getattr(comparison.clamp_strain, which)
            axes.plot(time, reference, label=elements_name(comparison), **ELEMENTS)
            for row in comparison.filaments:
                axes.plot(time, getattr(row.clamp_strain, which), **line_of(row))
            own = getattr(comparison.filament.clamp_strain, which)
            far = trusted_extent(reference, own, trusted=comparison.filament.trajectory.outcome.is_success) or 1e-3
            low = min(float(np.nanmin([reference, own])), 0.0)
            axes.set_ylim(max(low - 0.05 * far, -far), min(axes.get_ylim()[1], far))
            axes.set_ylabel(f"{which} strain")
        share_time((above, below), comparison)
        legend_row(figure, above, legend_top)
        X, thickness = comparison.elements.X, comparison.scene.filament.thickness
        note = fill(_NOTE.format(column=f"{(X[-1] - X[-3]) / thickness:.2g}"), 108)
        figure.text(LEFT / style.WIDTH, 0.1 / _HEIGHT, note, fontsize=7.5, color=style.GREY, parse_math=False)
    return figure
