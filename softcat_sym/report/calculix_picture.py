"""Midpoints in CalculiX, as a filament and in our elements against time, and their differences below."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.report import style
from softcat_sym.report.canvas import HEADING, axes_in_inches, head, new_figure
from softcat_sym.report.compare_axes import LEFT, RIGHT, legend_row, plain_numbers
from softcat_sym.report.units import length_unit, time_unit

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from softcat_sym.study.calculix import CalculixComparison

_HEIGHT, _BOTTOM, _GAP, _RESIDUAL, _ABOVE, _ROOM = 5.6, 0.55, 0.2, 1.5, 0.72, 1.15

_REFERENCE: dict[str, Any] = {"color": style.BLACK, "linewidth": 2.6, "alpha": 0.45}
_LINES: dict[str, dict[str, Any]] = {
    "filament": {"color": style.BLUE, "linewidth": 1.3},
    "elements": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
}


def calculix_figure(comparison: CalculixComparison) -> Figure:
    """Draw midpoints above, (ours - CalculiX)/max |CalculiX| below.

    Parameters
    ----------
    comparison : CalculixComparison
        As from :func:`softcat_sym.study.calculix.compare_with_calculix`.
    """
    run, span = comparison.calculix, comparison.scene.filament.span
    clock = time_unit(float(run.time[-1]))
    ruler = length_unit(float(np.abs(run.midpoint).max()), span)
    time = clock.of(run.time)
    with style.styled():
        figure = new_figure(style.WIDTH, _HEIGHT)
        head(figure, "midpoint, ours against CalculiX", comparison.trajectory.summary, comparison.scene, LEFT)
        width, bottom = style.WIDTH - LEFT - RIGHT, _BOTTOM + _RESIDUAL + _GAP
        above = axes_in_inches(figure, LEFT, bottom, width, _HEIGHT - HEADING - _ABOVE - bottom)
        below = axes_in_inches(figure, LEFT, _BOTTOM, width, _RESIDUAL)
        name = f"CalculiX {run.mesh.along} × {run.mesh.through}"
        above.plot(time, ruler.of(run.midpoint), label=name, **_REFERENCE)
        below.axhline(0.0, color=style.GREY, linewidth=0.6)
        for row in comparison.rows:
            above.plot(time, ruler.of(row.midpoint), label=row.name, **_LINES[row.name])
            below.plot(time, 100 * row.discrepancy.error, **_LINES[row.name])
        far = 2 * float(ruler.of(np.abs(run.midpoint).max())) or 1.0
        low, high = above.get_ylim()
        above.set_ylim(max(low, -far), min(high, far))
        known = np.nan_to_num([100 * row.discrepancy.largest for row in comparison.rows])
        shown = float(known.max()) or 1.0
        below.set_ylim(-_ROOM * shown, _ROOM * shown)
        above.set_ylabel(f"midpoint height [{ruler.symbol}]")
        below.set_ylabel("(ours − CalculiX)\n/ max |CalculiX| [%]", fontsize=8.0)
        for axes in (above, below):
            axes.set_xlim(0.0, float(time[-1]))
            axes.grid(True)
            style.lighten(axes)
            plain_numbers(axes)
        above.tick_params(labelbottom=False)
        below.set_xlabel(f"time [{clock.symbol}]")
        factor = clock.size / run.elastic_time
        top = above.secondary_xaxis(
            "top", functions=(lambda t: np.asarray(t) * factor, lambda t: np.asarray(t) / factor)
        )
        top.set_xlabel("time in L √(ρ/E)")
        legend_row(figure, above, _HEIGHT - HEADING)
    return figure
