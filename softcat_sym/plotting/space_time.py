"""Space-time maps: stretch, and what yields, along the filament against time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import Colormap, LinearSegmentedColormap, LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator
from numpy.typing import NDArray

from softcat_sym.plotting import style
from softcat_sym.plotting.section import slowest_flow, yielding_of
from softcat_sym.plotting.style import (
    PicturedScene,
    Summary,
    Unit,
    constrained,
    head,
    new_figure,
    refused,
    share_unit,
    shown_part,
    significant,
    stress_unit,
    time_unit,
)

_HEIGHT, _LEFT = 4.8, 0.75

_WIDE = 5.0
"""From a largest over a smallest stretch of this on, colours count powers."""

_SHOWN, _FEW = 0.98, 1.5
"""Colours end at this quantile of the stretch, if the largest exceeds it by this factor."""

MAX_FRAMES = 1200
"""Columns of a map; more would be finer than its pixels."""

_MIN_STRAIN = 1e-9
"""Colours span at least this."""

ROWS = 240
"""Of a map, all equally tall: cells at a clamp may be narrower than a pixel, which would show one end only."""

_NINE_TENTHS = 0.9


@dataclass(frozen=True, slots=True)
class Map:
    """One quantity over the filament and the run."""

    values: NDArray[np.float64]  # Shape (time, row): means over :data:`ROWS` equal parts of the filament
    label: str  # With its unit
    norm: Normalize  # From values to colours
    colours: Colormap | str
    beyond: bool = False  # Whether values lie above the last colour


def maps_of(data: xr.Dataset, scene: PicturedScene) -> tuple[Map, Map]:
    """Stretch, and the yielded share of the section; of a law that does not yield, the section's mean stress."""
    stretch = _in_rows(data, _stretch(data))
    low, high = float(stretch.min()), float(stretch.max())
    shown = float(np.quantile(stretch, _SHOWN))
    # A few hinges would leave the rest of the filament in one colour.
    beyond = high - 1 > _FEW * (shown - 1) > 0
    high = shown if beyond else high
    wide = low > 0 and high > _WIDE * low
    if wide:
        first = Map(stretch, "stretch", LogNorm(low, high), "cividis", beyond)
    else:
        # A filament at rest has a range too: otherwise its rounding errors would be painted.
        low, high = min(low - 1, 0.0), max(high - 1, _MIN_STRAIN)
        unit = share_unit(max(high, -low))
        norm = Normalize(float(unit.of(low)), float(unit.of(high)))
        first = Map(unit.of(stretch - 1), f"stretch \N{MINUS SIGN} 1 [{unit.symbol}]", norm, "cividis", beyond)
    if scene.material.yield_stress is not None:
        share = _in_rows(data, yielding_of(data, scene).share)
        return first, Map(share, "yielded share", Normalize(0.0, 1.0), yielded_colours())
    stress = _in_rows(data, np.asarray(data["stress_mean"].values, dtype=np.float64))
    unit = stress_unit(float(np.abs(stress).max()))
    scaled = unit.of(stress)
    top = max(float(scaled.max()), 0.0) or 1.0
    return first, Map(scaled, f"mean stress [{unit.symbol}]", Normalize(min(float(scaled.min()), 0.0), top), "cividis")


def _in_rows(data: xr.Dataset, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Means over equal parts of the filament, shape (time, row), of what is constant in each cell."""
    nodes = np.asarray(data["X_node"].values, dtype=np.float64)
    edges = np.linspace(nodes[0], nodes[-1], ROWS + 1)
    inside = np.minimum(edges[1:], nodes[1:, None]) - np.maximum(edges[:-1], nodes[:-1, None])
    return np.asarray(values @ (np.maximum(inside, 0.0) / np.diff(edges)))


def yielded_colours() -> Colormap:
    """From the colour of what is at rest to that of what has yielded wholly, as in the picture of shapes."""
    return LinearSegmentedColormap.from_list("yielded", [style.FILAMENT, style.ORANGE, style.VERMILLION])


def _stretch(data: xr.Dataset) -> NDArray[np.float64]:
    if "stretch" in data:
        return np.asarray(data["stretch"].values, dtype=np.float64)
    lengths = np.hypot(np.diff(data["x"].values, axis=1), np.diff(data["y"].values, axis=1))
    return np.asarray(lengths / np.diff(data["X_node"].values), dtype=np.float64)


def space_time_figure(data: xr.Dataset, summary: Summary, scene: PicturedScene) -> Figure:
    """Draw stretch and yielded share over X/L and time, with the time at which 0.9 of the final sag is reached."""
    data, summary = shown_part(data, summary)
    with style.styled():
        figure = new_figure(style.WIDTH, _HEIGHT)
        constrained(figure)
        head(figure, "along the filament against time", summary, scene, _LEFT)
        draw_maps(figure.subplots(2, 1, sharex=True), data, summary, scene)
    return figure


def draw_maps(panels: Sequence[Axes], data: xr.Dataset, summary: Summary, scene: PicturedScene) -> None:
    """Draw both maps with their colour bars, and say over the first what the mark is."""
    reached = None if refused(summary) else time_to_nine_tenths(data)
    for axes, shown in zip(panels, maps_of(data, scene), strict=True):
        mesh = draw_map(axes, data, shown, reached)
        draw_bar(axes, mesh, shown)
        axes.set_yticks((-0.5, 0.0, 0.5))
        axes.set_xlabel(f"time [{_clock(data).symbol}]")
        axes.label_outer()
    slowest = 0.0 if scene.material.yield_stress is None else slowest_flow(data, scene)
    texts = (
        "" if reached is None else f"dashed: 90 % of the final sag at {_clock(data).text(reached)}",
        f"where it flows faster than {significant(slowest)}/s" if slowest > 0 else "",
    )
    for axes, text in zip(panels, texts, strict=True):
        axes.set_title(text, loc="left", fontsize=7.5, pad=3)


def draw_map(axes: Axes, data: xr.Dataset, shown: Map, reached: float | None) -> QuadMesh:
    """Draw one map, the midpoint's line and the mark of a time."""
    clock = _clock(data)
    time = np.asarray(data["time"].values, dtype=np.float64)
    every = max(1, -(-time.size // MAX_FRAMES))
    nodes = np.asarray(data["X_node"].values, dtype=np.float64)
    places = np.linspace(nodes[0], nodes[-1], ROWS + 1) / (nodes[-1] - nodes[0])
    mesh = axes.pcolormesh(
        _edges(clock.of(time[::every]), float(clock.of(time[-1]))),
        places,
        shown.values[::every].T,
        norm=shown.norm,
        cmap=shown.colours,
        rasterized=True,
    )
    axes.set_xlim(float(clock.of(time[0])), float(clock.of(time[-1])) if time[-1] > time[0] else None)
    # A margin, so that the frame hides neither clamp.
    margin = (places[-1] - places[0]) / 100
    axes.set_ylim(places[0] - margin, places[-1] + margin)
    axes.axhline(0.5 * (places[0] + places[-1]), color=style.GREY, linewidth=0.6, linestyle=(0, (2, 3)))
    if reached is not None:
        # Seen on light and on dark.
        axes.axvline(float(clock.of(reached)), color="white", linewidth=1.6)
        axes.axvline(float(clock.of(reached)), color=style.BLACK, linewidth=0.8, linestyle="--")
    axes.set_ylabel("X / L")
    return mesh


def draw_bar(axes: Axes, mesh: QuadMesh, shown: Map) -> None:
    """Draw the colour bar of a map beside its axes, with plain numbers."""
    extend = "max" if shown.beyond else "neither"
    bar = axes.figure.colorbar(mesh, ax=axes, label=shown.label, extend=extend, aspect=14, pad=0.02)
    if isinstance(shown.norm, LogNorm):
        # Powers of ten would be set by a parser and in fonts that not every machine has.
        bar.locator = LogLocator(subs=(1.0, 2.0, 5.0), numticks=8)
        bar.formatter = FuncFormatter(lambda value, _: significant(value))
        bar.minorticks_off()
    else:
        bar.locator = MaxNLocator(5, steps=(1, 2, 2.5, 5, 10))


def time_to_nine_tenths(data: xr.Dataset) -> float | None:
    """When the midpoint is first at 0.9 of its final sag [s], between frames; None of one that ends where it began."""
    time = np.asarray(data["time"].values, dtype=np.float64)
    sag = -np.asarray(data["midpoint"].values, dtype=np.float64)
    fallen = (sag - sag[0]) * np.sign(sag[-1] - sag[0])
    aim = _NINE_TENTHS * fallen[-1]
    reached = np.flatnonzero(fallen >= aim)
    if not aim > 0 or not reached.size or reached[0] == 0:
        return None
    k = int(reached[0])
    return float(np.interp(aim, fallen[k - 1 : k + 1], time[k - 1 : k + 1]))


def _clock(data: xr.Dataset) -> Unit:
    return time_unit(float(np.abs(data["time"].values).max()))


def _edges(centres: NDArray[np.float64], end: float) -> NDArray[np.float64]:
    """Edges halfway between frames, the last at the end; of a single frame, half a unit to either side."""
    if centres.size == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    middle = 0.5 * (centres[1:] + centres[:-1])
    return np.concatenate([centres[:1], middle, [end]])
