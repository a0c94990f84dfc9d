"""Midpoint against time, as a picture and as a table."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from softcat_sym.plotting import style
from softcat_sym.plotting.section import telling_frames
from softcat_sym.plotting.style import (
    PicturedScene,
    Summary,
    Unit,
    constrained,
    head,
    length_unit,
    new_figure,
    refused,
    share_unit,
    shown_part,
    significant,
    time_unit,
)


def midpoint_csv(data: xr.Dataset) -> bytes:
    """Tabulate the midpoint."""
    outcome = data.attrs.get("outcome", "solved")
    head, stamp = ("", "") if outcome == "solved" else (",refused", f",{outcome}")
    pairs = zip(data["time"].values.tolist(), data["midpoint"].values.tolist(), strict=True)
    lines = (f"{time!r},{height!r}{stamp}\n" for time, height in pairs)
    return "".join([f"time_s,midpoint_m{head}\n", *lines]).encode()


_HEIGHT, _LEFT = 4.3, 0.75
_POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"


def midpoint_figure(data: xr.Dataset, summary: Summary, scene: PicturedScene) -> Figure:
    """Draw the midpoint's height against time, with dimensionless scales on the far sides."""
    data, summary = shown_part(data, summary)
    time = np.asarray(data["time"].values, dtype=np.float64)
    midpoint = np.asarray(data["midpoint"].values, dtype=np.float64)
    span = scene.filament.span
    clock = time_unit(float(np.abs(time).max()))
    ruler = length_unit(float(np.abs(midpoint).max()), fallback=span)
    with style.styled():
        figure = new_figure(style.WIDTH, _HEIGHT)
        head(figure, "midpoint against time", summary, scene, _LEFT)
        constrained(figure)
        axes = figure.add_subplot()
        axes.grid(True)
        axes.axhline(0.0, color=style.GREY, linewidth=0.6)
        _curve(axes, clock.of(time), ruler.of(midpoint), telling_frames(data))
        _limits(axes, time, midpoint, clock, ruler)
        axes.set_xlabel(f"time [{clock.symbol}]")
        axes.set_ylabel(f"midpoint height [{ruler.symbol}]")
        _dimensionless(axes, clock, ruler, scene, time, midpoint)
        style.lighten(axes)
        if not refused(summary):
            final = float(midpoint[-1])
            text = f"final {ruler.text(final)} = {significant(final / span)} L"
            axes.text(0.985, 0.975, text, transform=axes.transAxes, ha="right", va="top", fontsize=8.5)
    return figure


def _curve(axes: Axes, time: NDArray[np.float64], midpoint: NDArray[np.float64], frames: list[int]) -> None:
    """The curve, and a ring at each frame that the shape picture shows."""
    axes.plot(time, midpoint, color=style.BLUE, label="midpoint")
    axes.plot(
        time[frames],
        midpoint[frames],
        linestyle="none",
        marker="o",
        markersize=5.5,
        markerfacecolor="white",
        markeredgecolor=style.VERMILLION,
        label="shapes drawn in shapes.png",
        clip_on=False,
        zorder=3,
    )
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 0.0))


def _limits(axes: Axes, time: NDArray[np.float64], midpoint: NDArray[np.float64], clock: Unit, ruler: Unit) -> None:
    """Limits that are never empty: a single frame or a filament at rest still has axes to read."""
    start, end = float(clock.of(time[0])), float(clock.of(time[-1]))
    axes.set_xlim(start, end if end > start else start + max(1.0, abs(start)))
    low, high = (float(ruler.of(bound)) for bound in (midpoint.min(), midpoint.max()))
    low, high = min(low, 0.0), max(high, 0.0)
    room = 0.12 * (high - low) or 1.0
    axes.set_ylim(low - 1.8 * room, high + room)


def _dimensionless(
    axes: Axes,
    clock: Unit,
    ruler: Unit,
    scene: PicturedScene,
    time: NDArray[np.float64],
    midpoint: NDArray[np.float64],
) -> None:
    """The same scales divided by the span and by the paper's unit of time, where the scene has one."""
    span = scene.filament.span
    share = share_unit(float(np.abs(midpoint).max()) / span)
    right = axes.secondary_yaxis("right", functions=_scaling(ruler.size / span / share.size))
    right.set_ylabel(f"midpoint height [{share.symbol} of L]")
    modulus, gravity = scene.material.youngs_modulus, scene.load.gravity
    if modulus is not None and modulus > 0:
        unit, label = span * math.sqrt(scene.filament.density / modulus), "L √(ρ/E)"
    elif gravity > 0:
        unit, label = math.sqrt(span / gravity), "√(L/g)"
    else:
        return
    power = 3 * max(0, math.floor(math.log10(max(1.0, float(np.abs(time).max()) / unit)) / 3))
    thousands = "".join(_POWERS[int(digit)] for digit in str(power))
    top = axes.secondary_xaxis("top", functions=_scaling(clock.size / unit / 10**power))
    top.set_xlabel(f"time in {f'10{thousands} ' if power else ''}{label}")


def _scaling(factor: float) -> tuple[Callable[[ArrayLike], ArrayLike], Callable[[ArrayLike], ArrayLike]]:
    """Multiplication by a factor and its inverse, as a secondary axis wants them."""
    return lambda values: np.asarray(values) * factor, lambda values: np.asarray(values) / factor
