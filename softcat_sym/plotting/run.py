"""Pictures of a run for the screen, a journal's column or a page, and all its files."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import xarray as xr
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection, QuadMesh
from matplotlib.colors import Colormap, LinearSegmentedColormap, LogNorm, Normalize
from matplotlib.figure import Figure, SubFigure
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator
from numpy.typing import NDArray

from softcat_sym.plotting import style
from softcat_sym.plotting.files import columns_csv, write_results
from softcat_sym.plotting.section import (
    Floats,
    Section,
    outline,
    quads_outside,
    section_at,
    slowest_flow,
    telling_frames,
    vertical_stretch,
    yielding_of,
)
from softcat_sym.plotting.style import headed, new_figure, printed, refused, secondary_scale, shown_part, stamp
from softcat_sym.plotting.units import (
    Summary,
    Unit,
    energy_unit,
    length_unit,
    share_unit,
    significant,
    stress_unit,
    time_unit,
)

if TYPE_CHECKING:
    from softcat_sym.results.trajectory import Trajectory
    from softcat_sym.scene.scene import Scene

WIDTHS: Final = {"column": 84.0, "page": 174.0}
"""Widths of a figure for print [mm]: one column, or the whole page."""

DPI: Final = 400
"""Of the PNG files for print, and of what is drawn as pixels within a PDF."""

LINES: Final = (
    (style.BLACK, "-"),
    (style.BLUE, "-"),
    (style.VERMILLION, "--"),
    (style.SKY, "-."),
    (style.ORANGE, ":"),
    (style.GREEN, (0, (6, 1.5, 1, 1.5, 1, 1.5))),
)
"""Colours that the colour-blind tell apart, each with a line style of its own for print in black and white."""

_PRINT: Final[dict[str, Any]] = {
    **dict.fromkeys(("font.size", "axes.labelsize", "axes.titlesize", "legend.fontsize"), 8.0),
    **dict.fromkeys(("xtick.labelsize", "ytick.labelsize"), 8.0),
    **dict.fromkeys(("axes.linewidth", "xtick.major.width", "ytick.major.width", "hatch.linewidth"), 0.5),
    **dict.fromkeys(("xtick.major.size", "ytick.major.size", "axes.labelpad"), 2.5),
    "lines.linewidth": 0.9,
}
_STEPS = (1, 2, 2.5, 5, 10)


@contextmanager
def styled_for(name: str) -> Iterator[None]:
    """Put a style, ``screen``, ``column`` or ``page``, in force for the length of a ``with`` block."""
    settings: Any = {} if name == style.SCREEN else _PRINT
    with style.styled(), rc_context(settings):
        yield


@dataclass(frozen=True, slots=True)
class Sheet:
    """What every figure of one run shares."""

    data: xr.Dataset
    summary: Summary
    scene: Scene
    style: str  # ``screen``, ``column`` or ``page``

    @property
    def on_screen(self) -> bool:
        """Whether there is a heading, and room for what print does without."""
        return self.style == style.SCREEN

    @property
    def width(self) -> float:
        """Of the figure [inch]."""
        return style.WIDTH if self.on_screen else WIDTHS[self.style] / 25.4

    @property
    def time(self) -> Floats:
        """Of the frames [s]."""
        return np.asarray(self.data["time"].values, dtype=np.float64)

    @property
    def clock(self) -> Unit:
        """The unit of time."""
        return time_unit(float(np.abs(self.time).max()))

    def figure(self, what: str, height: float) -> tuple[Figure, Figure | SubFigure]:
        """A figure, laid out by what its axes need, and the part below its heading, if it has one."""
        if self.on_screen:
            return headed(self.scene, what, self.summary, height=height)
        figure = new_figure(self.width, height)
        figure.set_layout_engine("constrained", w_pad=0.06, h_pad=0.04)
        stamp(figure, self.summary)
        return figure, figure

    def time_axis(self, axes: Axes) -> None:
        """Limits that are never empty, few round numbers, and the label."""
        start, end = float(self.clock.of(self.time[0])), float(self.clock.of(self.time[-1]))
        axes.set_xlim(start, end if end > start else start + max(1.0, abs(start)))
        axes.set_xlabel(f"time [{self.clock.symbol}]")
        axes.xaxis.set_major_locator(MaxNLocator(8 if self.on_screen else 6, steps=_STEPS))
        axes.grid(self.on_screen)
        style.lighten(axes)


def sheet_of(data: xr.Dataset, summary: Summary, scene: Scene, name: str) -> Sheet:
    """The sheet of a run, as far as it is drawn."""
    return Sheet(*shown_part(data, summary), scene, name)


_POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
_SHAPES = {style.SCREEN: 5, "column": 4, "page": 4}


def midpoint_figure(data: xr.Dataset, summary: Summary, scene: Scene, name: str = style.SCREEN) -> Figure:
    """Draw the midpoint's height against time; on the screen with dimensionless scales on the far sides."""
    sheet = sheet_of(data, summary, scene, name)
    height = np.asarray(sheet.data["midpoint"].values, dtype=np.float64)
    ruler = length_unit(float(np.abs(height).max()), scene.filament.span)
    time, shown = sheet.clock.of(sheet.time), ruler.of(height)
    with styled_for(name):
        figure, body = sheet.figure("midpoint against time", 3.7 if sheet.on_screen else min(0.62 * sheet.width, 2.6))
        axes = body.subplots()
        axes.axhline(0.0, color=style.GREY, linewidth=0.6)
        axes.plot(time, shown, color=style.BLUE, label="midpoint")
        frames = telling_frames(sheet.data, _SHAPES[name])
        ring: dict[str, Any] = {
            "markersize": 5.5 if sheet.on_screen else 3,
            "markerfacecolor": "white",
            "clip_on": False,
            "zorder": 3,
        }
        axes.plot(time[frames], shown[frames], "o", color=style.VERMILLION, label="shapes drawn", **ring)
        sheet.time_axis(axes)
        low, high = min(float(shown.min()), 0.0), max(float(shown.max()), 0.0)
        room = 0.1 * (high - low) or 1.0
        axes.set_ylim(low - room, high + room)
        axes.yaxis.set_major_locator(MaxNLocator(6, steps=_STEPS))
        axes.set_ylabel(f"midpoint height [{ruler.symbol}]")
        if sheet.on_screen:
            _dimensionless(axes, sheet, ruler, float(np.abs(height).max()))
            if not refused(sheet.summary):
                text = f"final {ruler.text(height[-1])} = {significant(height[-1] / scene.filament.span)} L"
                axes.text(0.985, 0.975, text, transform=axes.transAxes, ha="right", va="top", fontsize=8.5)
        body.legend(loc="outside upper center", ncols=2, borderaxespad=0.0)
    return figure


def _dimensionless(axes: Axes, sheet: Sheet, ruler: Unit, largest: float) -> None:
    """The same scales divided by the span and by the paper's unit of time, where the scene has one."""
    scene, clock = sheet.scene, sheet.clock
    span = scene.filament.span
    share = share_unit(largest / span)
    right = axes.secondary_yaxis("right", functions=secondary_scale(ruler.size / span / share.size))
    right.set_ylabel(f"midpoint height [{share.symbol} of L]")
    modulus, gravity = scene.material.youngs_modulus, scene.load.gravity
    if modulus is not None and modulus > 0:
        unit, label = span * math.sqrt(scene.filament.density / modulus), "L √(ρ/E)"
    elif gravity > 0:
        unit, label = math.sqrt(span / gravity), "√(L/g)"
    else:
        return
    power = 3 * max(0, math.floor(math.log10(max(1.0, float(np.abs(sheet.time).max()) / unit)) / 3))
    thousands = "".join(_POWERS[int(digit)] for digit in str(power))
    top = axes.secondary_xaxis("top", functions=secondary_scale(clock.size / unit / 10**power))
    top.set_xlabel(f"time in {f'10{thousands} ' if power else ''}{label}")


@dataclass(frozen=True, slots=True)
class Shape:
    """What is drawn of one frame."""

    section: Section  # Centreline, normals, thickness
    outline: Floats  # Closed polygon, shape (vertex, 2) [m]
    yielded: Floats  # Quads of the yielded zones, shape (quad, 4, 2) [m]
    label: str  # Time, sag and yielded share, one per line


def shapes_of(data: xr.Dataset, scene: Scene, frames: list[int]) -> list[Shape]:
    """Compute what is drawn of the given frames."""
    limit = scene.material.yield_stress
    yields = yielding_of(data, scene)
    clock = time_unit(float(np.abs(data["time"].values).max()))
    shapes = []
    for frame in frames:
        section = section_at(data, frame, (scene.ends.left == "clamped", scene.ends.right == "clamped"))
        sag = -float(data["midpoint"].values[frame])
        lines = [
            f"t = {clock.text(float(data['time'].values[frame]))}",
            f"{'sag' if sag >= 0 else 'rise'} {length_unit(abs(sag), scene.filament.span).text(abs(sag))}",
        ]
        if limit is not None:
            share = float(np.average(yields.share[frame], weights=np.diff(data["X_node"].values)))
            lines.append("yielded < 0.1 %" if 0 < share < 1e-3 else f"yielded {100 * share:.1f} %")
        quads = quads_outside(section, yields.low[frame], yields.high[frame])
        shapes.append(Shape(section, outline(section), quads, "\n".join(lines)))
    return shapes


def yielded_label(data: xr.Dataset, scene: Scene) -> str:
    """What a colour or hatching for what yields means, with the rate below which nothing is shown."""
    limit, slowest = scene.material.yield_stress or 0.0, slowest_flow(data, scene)
    faster = f", flows faster than {significant(slowest)}/s" if slowest > 0 else ""
    return f"yielded: stress > {stress_unit(limit).text(limit)}{faster}"


def largest_sag(shapes: Sequence[Shape]) -> float:
    """Largest departure of a centreline from the straight line between its ends [m]."""
    y = np.array([shape.section.y for shape in shapes])
    return float(np.abs(y - np.linspace(y[:, 0], y[:, -1], y.shape[1], axis=1)).max())


_TALLEST = 8.0
"""Of a figure [inch]."""

_LOW = 0.28
"""Below this height [inch] the axis of a shape has room for one number."""


def shapes_figure(data: xr.Dataset, summary: Summary, scene: Scene, name: str = style.SCREEN) -> Figure:
    """Draw the filament at a few telling times, one below the other, or side by side if that would be too tall.

    Lengths are equal along both axes. A sag below 2 % of the span is too flat to see: the vertical scale is then
    stretched, thickness and all, by a factor that the axis label states.
    """
    sheet = sheet_of(data, summary, scene, name)
    shapes = shapes_of(sheet.data, scene, telling_frames(sheet.data, _SHAPES[name]))
    stretch = vertical_stretch(largest_sag(shapes), scene.filament.thickness, scene.filament.span)
    corners = np.array([[one.outline.min(axis=0), one.outline.max(axis=0)] for one in shapes])
    low, high = corners[:, 0].min(axis=0), corners[:, 1].max(axis=0)
    pad = 0.02 * float(high[0] - low[0]) or scene.filament.thickness
    x = (float(low[0]) - pad, float(high[0]) + pad)
    margin = 0.25 * scene.filament.thickness
    ranges = [(float(one[0, 1]) - margin, float(one[1, 1]) + margin) for one in corners]
    tall = [stretch * (top - floor) / (x[1] - x[0]) for floor, top in ranges]
    # A run away beside what is at rest would leave that no height at all.
    tall = [max(one, max(tall) / 1e3) for one in tall]
    ruler = length_unit(float(np.abs(corners).max()), scene.filament.span)
    with styled_for(name):
        stacked = sum(tall) * 0.8 * sheet.width < _TALLEST or not sheet.on_screen
        if not stacked:
            ranges = [(float(low[1]) - margin, float(high[1]) + margin)] * len(shapes)
        beside = (sheet.width - 0.9) / len(shapes) * float(high[1] - low[1] + 2 * margin) / (x[1] - x[0])
        if not stacked and beside > 6.0:
            # What is far deeper than it is wide keeps its width on paper.
            spare = (beside / 6.0 - 1) * (x[1] - x[0]) / 2
            x = (x[0] - spare, x[1] + spare)
        height = sheet.width if stacked else min(beside, 6.0) + 1.4
        figure, body = sheet.figure("shapes with their true thickness", height)
        grid: dict[str, Any] = {"height_ratios": tall} if stacked else {}
        count = (len(shapes), 1) if stacked else (1, len(shapes))
        panels = body.subplots(*count, sharex=True, sharey=not stacked, squeeze=False, **grid).ravel().tolist()
        for axes, shape, bounds in zip(panels, shapes, ranges, strict=True):
            axes.set_xlim(*ruler.of(x))
            axes.set_ylim(*ruler.of(bounds))
            _draw_shape(axes, shape, ruler)
            axes.xaxis.set_major_locator(MaxNLocator(6 if stacked else 2, steps=_STEPS))
            axes.yaxis.set_major_locator(MaxNLocator(2 if stacked else 6, steps=_STEPS))
            if stacked and axes is not panels[-1]:
                axes.tick_params(labelbottom=False, bottom=False)
                axes.spines["bottom"].set_visible(False)
            words = ", ".join(shape.label.split("\n")) if stacked else shape.label
            axes.set_title(words, loc="left", pad=2, fontsize=8 if sheet.on_screen else 7, linespacing=1.3)
        scaled = "" if stretch == 1 else f" (vertical scale × {stretch:g}, thickness too)"
        body.supxlabel(f"x [{ruler.symbol}]{scaled}", fontsize=8.5 if sheet.on_screen else 8)
        body.supylabel(f"y [{ruler.symbol}]", fontsize=8.5 if sheet.on_screen else 8)
        label = f"law “{style.printable(str(scene.material.law))}”: no yield stress"
        colour = "white"
        if scene.material.yield_stress is not None:
            label, colour = yielded_label(sheet.data, scene), style.VERMILLION
        if scene.material.yield_stress is not None or sheet.on_screen:
            body.legend(
                handles=[Patch(facecolor=colour, label=label)], loc="outside upper center", borderaxespad=0.0,
                fontsize=7.5 if sheet.on_screen else 7.0,
            )  # fmt: skip
        if stacked:
            _fit_height(figure, body, panels, tall)
        for axes in panels:
            axes.set_aspect(stretch, anchor="S")
    return figure


def _draw_shape(axes: Axes, shape: Shape, ruler: Unit) -> None:
    """Body, yielded zones, outline, the line between the ends."""
    body = ruler.of(shape.outline)
    axes.fill(body[:, 0], body[:, 1], facecolor=style.FILAMENT, edgecolor="none", zorder=2)
    # Anti-aliasing would leave hairlines between neighbouring quads.
    quads = PolyCollection(
        list(ruler.of(shape.yielded)), facecolors=style.VERMILLION, edgecolors="none", antialiaseds=False,
        rasterized=True, zorder=3,
    )  # fmt: skip
    axes.add_collection(quads, autolim=False)
    axes.fill(body[:, 0], body[:, 1], facecolor="none", edgecolor=style.BLACK, linewidth=0.4, zorder=4)
    axes.plot(ruler.of(shape.section.x[[0, -1]]), ruler.of(shape.section.y[[0, -1]]), ":", color=style.GREY, lw=0.6)
    style.lighten(axes)


def _fit_height(figure: Figure, body: Figure | SubFigure, panels: Sequence[Axes], tall: Sequence[float]) -> None:
    """Make a figure as high as its panels need to be `tall` times as high as they are wide, up to the tallest."""
    figure.draw_without_rendering()
    width, height = figure.get_size_inches()
    places = [axes.get_window_extent() for axes in panels]
    around = height - sum(place.height for place in places) / figure.dpi
    scale = min(min(place.width for place in places) / figure.dpi, (_TALLEST - around) / sum(tall))
    drawn = max(scale * sum(tall), _LOW) + 0.03
    if isinstance(body, SubFigure):
        heading = height - body.bbox.height / figure.dpi
        grid = body._subplotspec.get_gridspec()  # type: ignore[attr-defined]
        grid.set_height_ratios([heading, around - heading + drawn])
    figure.set_size_inches(width, around + drawn)
    for axes, share in zip(panels, tall, strict=True):
        if scale * share < _LOW:
            # Room for one number.
            axes.set_yticks((0.0,))


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
_OPTIONAL = ("energy_gradient", "energy_surface")


def energy_imbalance(data: xr.Dataset) -> tuple[NDArray[np.float64], float]:
    """Kinetic + elastic + surface + potential + dissipated + gradient - work, less its first value."""
    values = [np.asarray(data[name].values, dtype=np.float64) for name, *_ in TERMS]
    total = np.sum([sign * value for (*_, sign), value in zip(TERMS, values, strict=True)], axis=0)
    largest = max(float(np.abs(value).max()) for value in values)
    return np.asarray(total - total[0], dtype=np.float64), largest


def energy_figure(data: xr.Dataset, summary: Summary, scene: Scene, name: str = style.SCREEN) -> Figure:
    """Draw the energy budget, and on the screen below it the imbalance relative to the largest energy."""
    sheet = sheet_of(data, summary, scene, name)
    time = sheet.clock.of(sheet.time)
    imbalance, largest = energy_imbalance(sheet.data)
    unit = energy_unit(largest)
    marker = "o" if time.size == 1 else None
    with styled_for(name):
        height = 4.2 if sheet.on_screen else min(0.75 * sheet.width, 2.6)
        figure, body = sheet.figure("energy budget of the whole filament", height)
        panels = body.subplots(2, 1, sharex=True, height_ratios=[3, 1]) if sheet.on_screen else [body.subplots()]
        kept = [t for t in TERMS if np.any(sheet.data[t[0]].values) or (sheet.on_screen and t[0] not in _OPTIONAL)]
        for k, (term, label, colour, line, _) in enumerate(kept):
            look = (colour, line) if sheet.on_screen else LINES[k % len(LINES)]
            energy = unit.of(sheet.data[term].values)
            panels[0].plot(time, energy, color=look[0], linestyle=look[1], label=label, marker=marker)
        panels[0].set_ylabel(f"energy [{unit.symbol}]")
        if sheet.on_screen:
            _residual(panels[1], time, imbalance / largest if largest > 0 else imbalance)
        for axes in panels:
            sheet.time_axis(axes)
            axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=0)
            axes.label_outer()
        panels[0].yaxis.set_major_locator(MaxNLocator(6, steps=_STEPS))
        if kept:
            where: Any = "outside right upper" if sheet.on_screen else "outside upper center"
            body.legend(loc=where, ncols=1 if sheet.on_screen else 3, borderaxespad=0.0, handlelength=2.0)
    return figure


def _residual(axes: Axes, time: Floats, residual: Floats) -> None:
    """The imbalance on a scale of its own, with its largest value in words."""
    worst = float(np.abs(residual).max())
    unit = share_unit(worst)
    axes.plot(time, unit.of(residual), color=style.BLACK, linewidth=1.0, marker="o" if time.size == 1 else None)
    room = float(unit.of(1.3 * worst)) or 1.0
    axes.set_ylim(-room, room)
    axes.locator_params(axis="y", nbins=4)
    axes.set_ylabel(f"imbalance /\nlargest [{unit.symbol}]")
    axes.set_title(f"largest imbalance {unit.text(worst)}", loc="right", fontsize=8.0, pad=2)


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


@dataclass(frozen=True, slots=True)
class Map:
    """One quantity over the filament and the run."""

    values: Floats  # Shape (time, row): means over :data:`ROWS` equal parts of the filament
    label: str  # With its unit
    norm: Normalize  # From values to colours
    colours: Colormap | str
    beyond: bool = False  # Whether values lie above the last colour


def maps_of(data: xr.Dataset, scene: Scene) -> tuple[Map, Map]:
    """Stretch, and the yielded share of the section; of a law that does not yield, the section's mean stress."""
    stretch = _in_rows(data, _stretch(data))
    low, high = float(stretch.min()), float(stretch.max())
    shown = float(np.quantile(stretch, _SHOWN))
    # A few hinges would leave the rest of the filament in one colour.
    beyond = high - 1 > _FEW * (shown - 1) > 0
    high = shown if beyond else high
    if low > 0 and high > _WIDE * low:
        first = Map(stretch, "stretch", LogNorm(low, high), "cividis", beyond)
    else:
        # A filament at rest has a range too: otherwise its rounding errors would be painted.
        low, high = min(low - 1, 0.0), max(high - 1, _MIN_STRAIN)
        unit = share_unit(max(high, -low))
        norm = Normalize(float(unit.of(low)), float(unit.of(high)))
        first = Map(unit.of(stretch - 1), f"stretch \N{MINUS SIGN} 1 [{unit.symbol}]", norm, "cividis", beyond)
    if scene.material.yield_stress is not None:
        share = _in_rows(data, yielding_of(data, scene).share)
        # From what is at rest to what has yielded wholly, as in the picture of shapes.
        colours = LinearSegmentedColormap.from_list("yielded", [style.FILAMENT, style.ORANGE, style.VERMILLION])
        return first, Map(share, "yielded share", Normalize(0.0, 1.0), colours)
    stress = _in_rows(data, np.asarray(data["stress_mean"].values, dtype=np.float64))
    unit = stress_unit(float(np.abs(stress).max()))
    scaled = unit.of(stress)
    norm = Normalize(min(float(scaled.min()), 0.0), max(float(scaled.max()), 0.0) or 1.0)
    return first, Map(scaled, f"mean stress [{unit.symbol}]", norm, "cividis")


def _in_rows(data: xr.Dataset, values: Floats) -> Floats:
    """Means over equal parts of the filament, shape (time, row), of what is constant in each cell."""
    nodes = np.asarray(data["X_node"].values, dtype=np.float64)
    edges = np.linspace(nodes[0], nodes[-1], ROWS + 1)
    inside = np.minimum(edges[1:], nodes[1:, None]) - np.maximum(edges[:-1], nodes[:-1, None])
    return np.asarray(values @ (np.maximum(inside, 0.0) / np.diff(edges)))


def _stretch(data: xr.Dataset) -> Floats:
    if "stretch" in data:
        return np.asarray(data["stretch"].values, dtype=np.float64)
    lengths = np.hypot(np.diff(data["x"].values, axis=1), np.diff(data["y"].values, axis=1))
    return np.asarray(lengths / np.diff(data["X_node"].values), dtype=np.float64)


def space_time_figure(data: xr.Dataset, summary: Summary, scene: Scene, name: str = style.SCREEN) -> Figure:
    """Draw stretch and yielded share over X/L and time, with the time at which 0.9 of the final sag is reached."""
    sheet = sheet_of(data, summary, scene, name)
    reached = None if refused(sheet.summary) else time_to_nine_tenths(sheet.data)
    slowest = 0.0 if scene.material.yield_stress is None else slowest_flow(sheet.data, scene)
    texts = (
        "" if reached is None else f"dashed: 90 % of the final sag at {sheet.clock.text(reached)}",
        f"where it flows faster than {significant(slowest)}/s" if slowest > 0 else "",
    )
    with styled_for(name):
        height = {style.SCREEN: 4.2, "column": 3.2, "page": 1.9}[name]
        figure, body = sheet.figure("along the filament against time", height)
        panels = body.subplots(*((1, 2) if name == "page" else (2, 1)), sharex=True)
        for axes, shown, text in zip(panels, maps_of(sheet.data, scene), texts, strict=True):
            mesh = _draw_map(axes, sheet, shown, reached)
            _draw_bar(axes, mesh, shown)
            axes.set_yticks((-0.5, 0.0, 0.5))
            axes.set_xlabel(f"time [{sheet.clock.symbol}]")
            axes.label_outer()
            axes.set_title(text, loc="left", fontsize=7.5, pad=3)
        panels[0].xaxis.set_major_locator(MaxNLocator(8 if sheet.on_screen else 5, steps=_STEPS))
    return figure


def _draw_map(axes: Axes, sheet: Sheet, shown: Map, reached: float | None) -> QuadMesh:
    """Draw one map, the midpoint's line and the mark of a time."""
    clock, time = sheet.clock, sheet.time
    every = max(1, -(-time.size // MAX_FRAMES))
    nodes = np.asarray(sheet.data["X_node"].values, dtype=np.float64)
    places = np.linspace(nodes[0], nodes[-1], ROWS + 1) / (nodes[-1] - nodes[0])
    edges = _edges(clock.of(time[::every]), float(clock.of(time[-1])))
    values = shown.values[::every].T
    mesh = axes.pcolormesh(edges, places, values, norm=shown.norm, cmap=shown.colours, rasterized=True)
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


def _draw_bar(axes: Axes, mesh: QuadMesh, shown: Map) -> None:
    """Draw the colour bar of a map beside its axes, with plain numbers."""
    extend = "max" if shown.beyond else "neither"
    bar = axes.figure.colorbar(mesh, ax=axes, label=shown.label, extend=extend, aspect=14, pad=0.02)
    if isinstance(shown.norm, LogNorm):
        # Powers of ten would be set by a parser and in fonts that not every machine has.
        bar.locator = LogLocator(subs=(1.0, 2.0, 5.0), numticks=8)
        bar.formatter = FuncFormatter(lambda value, _: significant(value))
        bar.minorticks_off()
    else:
        bar.locator = MaxNLocator(5, steps=_STEPS)


def time_to_nine_tenths(data: xr.Dataset) -> float | None:
    """When the midpoint is first at 0.9 of its final sag [s], between frames; None of one that ends where it began."""
    time = np.asarray(data["time"].values, dtype=np.float64)
    sag = -np.asarray(data["midpoint"].values, dtype=np.float64)
    fallen = (sag - sag[0]) * np.sign(sag[-1] - sag[0])
    aim = 0.9 * fallen[-1]
    reached = np.flatnonzero(fallen >= aim)
    if not aim > 0 or not reached.size or reached[0] == 0:
        return None
    k = int(reached[0])
    return float(np.interp(aim, fallen[k - 1 : k + 1], time[k - 1 : k + 1]))


def _edges(centres: Floats, end: float) -> Floats:
    """Edges halfway between frames, the last at the end; of a single frame, half a unit to either side."""
    if centres.size == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    return np.concatenate([centres[:1], 0.5 * (centres[1:] + centres[:-1]), [end]])


def midpoint_csv(data: xr.Dataset) -> bytes:
    """Tabulate the midpoint."""
    outcome, time = data.attrs.get("outcome", "solved"), data["time"].values
    stamped = {} if outcome == "solved" else {"refused": [outcome] * len(time)}
    return columns_csv({"time_s": time, "midpoint_m": data["midpoint"].values, **stamped})


FIGURES = {
    "midpoint": midpoint_figure,
    "shapes": shapes_figure,
    "energy": energy_figure,
    "space-time": space_time_figure,
}


def write_pictures(
    data: xr.Dataset, summary: Summary, scene: Scene, directory: str | Path, name: str = style.SCREEN
) -> list[Path]:
    """Write midpoint, shapes, energy and space-time as PNG, for print as PDF too, and ``midpoint.csv``."""
    contents: dict[str, object] = {}
    for what, draw in FIGURES.items():
        figure = draw(data, summary, scene, name)
        if name == style.SCREEN:
            contents[f"{what}.png"] = figure
        else:
            with styled_for(name):
                contents |= printed(what, figure, DPI)
    return write_results(directory, {**contents, "midpoint.csv": midpoint_csv(data)})


@dataclass(frozen=True)
class WrittenRun:
    """What a run left behind."""

    files: tuple[Path, ...]  # In the order of interest
    summary: dict[str, Any]  # As in ``summary.json``, with the time that the writing took


def write_run(trajectory: Trajectory, directory: str | Path, name: str = style.SCREEN) -> WrittenRun:
    """Write what ``softcat run`` leaves behind: trajectory, summary, resolved scene, pictures and the midpoint table.

    The summary goes last, so that it can state how long the writing took.
    """
    from softcat_sym.results.files import write_scene, write_summary, write_trajectory

    began = time.perf_counter()
    folder = Path(directory)
    folder.mkdir(parents=True, exist_ok=True)
    pictures = write_pictures(trajectory.data, trajectory.summary, trajectory.scene, folder, name)
    data = write_trajectory(trajectory.data, folder)
    scene = write_scene(trajectory.scene.to_toml(), folder)
    spent = time.perf_counter() - began
    wall = trajectory.summary["wall_s"]
    summary = {**trajectory.summary, "wall_s": {**wall, "write": spent, "total": wall["total"] + spent}}
    return WrittenRun((data, write_summary(summary, folder), scene, *pictures), summary)
