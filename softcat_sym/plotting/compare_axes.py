"""What the pictures of a comparison share: a line for each theory, time in seconds below and as in the paper above."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.style import Unit, time_unit

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.studies.compare import Comparison, FilamentRow

LEFT, RIGHT = 0.85, 0.3
"""Margins of the pictures [inch]."""

ELEMENTS: dict[str, Any] = {"color": style.BLACK, "linewidth": 2.6, "alpha": 0.45}
"""The line of the elements: wide and pale, so that a filament that agrees is seen on it."""

_LINES: dict[str, dict[str, Any]] = {
    "filament": {"color": style.BLUE, "linewidth": 1.3},
    "published, material closure": {"color": style.ORANGE, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
    "published, printed closure": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": (0, (1.5, 1.2))},
}


def elements_name(comparison: Comparison) -> str:
    """``elements 64 x 4``."""
    mesh = comparison.elements.mesh
    return f"elements {mesh.along} × {mesh.through}"


def line_of(row: FilamentRow) -> dict[str, Any]:
    """How to draw a filament, named for the legend."""
    return {"label": row.name, **_LINES[row.name]}


def plain_numbers(axes: Axes) -> None:
    """Write each number of the vertical axis whole: a common power of ten would stand in the way of what is above."""
    axes.yaxis.set_major_formatter("{x:.3g}")


def trusted_extent(reference: Floats, own: Floats, *, trusted: bool) -> float:
    """How far a picture reaches, in magnitude; whatever runs away beyond leaves it.

    Twice as far as the elements, and as far as the scene's own filament if its answer may be trusted.
    """
    far = 2 * float(np.abs(reference).max())
    return max(far, 1.05 * float(np.nanmax(np.abs(own)))) if trusted else far


def clock_of(comparison: Comparison) -> Unit:
    """The unit of time of the bottom axis."""
    return time_unit(float(comparison.elements.time[-1]))


def share_time(panels: Sequence[Axes], comparison: Comparison) -> None:
    """Give panels below one another one time axis: labelled under the last, in L sqrt(rho/E) above the first."""
    clock = clock_of(comparison)
    end = float(clock.of(comparison.elements.time[-1]))
    for axes in panels:
        axes.set_xlim(0.0, end)
        axes.grid(True)
        style.lighten(axes)
        plain_numbers(axes)
        axes.tick_params(labelbottom=axes is panels[-1])
    panels[-1].set_xlabel(f"time [{clock.symbol}]")
    factor = clock.size / comparison.elements.elastic_time
    top = panels[0].secondary_xaxis(
        "top", functions=(lambda values: np.asarray(values) * factor, lambda values: np.asarray(values) / factor)
    )
    top.set_xlabel("time in L √(ρ/E)")


def legend_row(figure: Figure, axes: Axes, top: float) -> None:
    """One row of names under the heading, where no curve can run."""
    width, height = figure.get_size_inches()
    handles, labels = axes.get_legend_handles_labels()
    place = (LEFT / width, top / height)
    figure.legend(
        handles,
        labels,
        loc="upper left",
        bbox_to_anchor=place,
        ncols=len(labels),
        borderaxespad=0.0,
        columnspacing=1.1,
        handlelength=1.9,
        handletextpad=0.5,
        fontsize=7.5,
    )
