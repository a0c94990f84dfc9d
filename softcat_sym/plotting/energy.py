"""Energy budget of a run and what is missing from it."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from softcat_sym.plotting import style
from softcat_sym.plotting.style import (
    HEADING,
    PicturedScene,
    Summary,
    axes_in_inches,
    energy_unit,
    head,
    new_figure,
    share_unit,
    shown_part,
    time_unit,
)

# Name in the trajectory, label, colour, line style, sign in the balance. Line styles too: colour alone is not enough.
TERMS = (
    ("energy_potential", "potential", style.BLUE, "-", 1.0),
    ("energy_elastic", "elastic", style.GREEN, "-", 1.0),
    ("energy_surface", "surface", style.BLACK, "--", 1.0),
    ("energy_kinetic", "kinetic", style.ORANGE, "--", 1.0),
    ("energy_dissipated", "dissipated", style.VERMILLION, "-", 1.0),
    ("energy_gradient", "gradient", style.SKY, ":", 1.0),
    ("work_external", "external work", style.PURPLE, "-.", -1.0),
)
# Drawn only where it is in force.
OPTIONAL = ("energy_gradient", "energy_surface")
_HEIGHT, _LEFT, _RIGHT, _BOTTOM, _SMALL, _GAP = 4.8, 0.85, 1.35, 0.55, 0.95, 0.32


def energy_imbalance(data: xr.Dataset) -> tuple[NDArray[np.float64], float]:
    """Kinetic + elastic + surface + potential + dissipated + gradient - work, less its first value."""
    values = [np.asarray(data[name].values, dtype=np.float64) for name, *_ in TERMS]
    total = np.sum([sign * value for (*_, sign), value in zip(TERMS, values, strict=True)], axis=0)
    largest = max(float(np.abs(value).max()) for value in values)
    return np.asarray(total - total[0], dtype=np.float64), largest


def energy_figure(data: xr.Dataset, summary: Summary, scene: PicturedScene) -> Figure:
    """Draw the energy budget, and below it the imbalance relative to the largest energy."""
    data, summary = shown_part(data, summary)
    seconds = np.asarray(data["time"].values, dtype=np.float64)
    clock = time_unit(float(np.abs(seconds).max()))
    time = clock.of(seconds)
    end = float(time[-1]) if time[-1] > time[0] else float(time[0]) + 1.0
    imbalance, largest = energy_imbalance(data)
    with style.styled():
        figure = new_figure(style.WIDTH, _HEIGHT)
        head(figure, "energy budget of the whole filament", summary, scene, _LEFT)
        width = style.WIDTH - _LEFT - _RIGHT
        lower = axes_in_inches(figure, _LEFT, _BOTTOM, width, _SMALL)
        bottom = _BOTTOM + _SMALL + _GAP
        upper = axes_in_inches(figure, _LEFT, bottom, width, _HEIGHT - HEADING - bottom)
        _budget(upper, data, time, largest)
        _residual(lower, time, imbalance / largest if largest > 0 else imbalance)
        for axes in (upper, lower):
            axes.set_xlim(float(time[0]), end)
            axes.grid(True)
            style.lighten(axes)
        upper.tick_params(labelbottom=False)
        lower.set_xlabel(f"time [{clock.symbol}]")
        figure.align_ylabels([upper, lower])
    return figure


def _budget(axes: Axes, data: xr.Dataset, time: NDArray[np.float64], largest: float) -> None:
    """The energies; a single frame, having no line, is drawn as points."""
    unit = energy_unit(largest)
    marker = "o" if time.size == 1 else None
    for name, label, colour, line, _ in TERMS:
        if name in OPTIONAL and not np.any(data[name].values):
            continue
        axes.plot(time, unit.of(data[name].values), color=colour, linestyle=line, label=label, marker=marker)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=0)
    axes.set_ylabel(f"energy [{unit.symbol}]")
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), borderaxespad=0.0, handlelength=2.2)


def _residual(axes: Axes, time: NDArray[np.float64], residual: NDArray[np.float64]) -> None:
    """The imbalance on a scale of its own, with its largest value in words."""
    worst = float(np.abs(residual).max())
    unit = share_unit(worst)
    axes.plot(time, unit.of(residual), color=style.BLACK, linewidth=1.0, marker="o" if time.size == 1 else None)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=0)
    room = float(unit.of(1.15 * worst)) or 1.0
    axes.set_ylim(-room, room)
    axes.locator_params(axis="y", nbins=4)
    axes.set_ylabel(f"imbalance /\nlargest [{unit.symbol}]")
    axes.text(1.02, 0.98, f"largest\nimbalance\n{unit.text(worst)}", transform=axes.transAxes, va="top", fontsize=8.0)
