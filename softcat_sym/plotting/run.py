"""Pictures of a run for the screen, a journal's column or a page, and all its files."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from io import StringIO
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import Colormap, LinearSegmentedColormap, LogNorm, Normalize
from matplotlib.figure import Figure, SubFigure
from matplotlib.image import PcolorImage
from matplotlib.patches import Patch, Polygon
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.axes3d import Axes3D

from softcat_sym import drawing
from softcat_sym.drawing import Report
from softcat_sym.plotting import style
from softcat_sym.plotting.bodies import draw_bodies
from softcat_sym.plotting.section import (
    FilamentOutline,
    Floats,
    Magnification,
    array,
    largest_sag,
    outline,
    quads_outside,
    section_at,
    slowest_flow,
    telling_frames,
    yielding_of,
)
from softcat_sym.plotting.spatial import draw_tube, frame_tube, tube
from softcat_sym.plotting.style import WIDTHS, Fields, styled
from softcat_sym.plotting.time_axis import STEPS, TimeAxis
from softcat_sym.plotting.units import (
    Summary,
    Unit,
    energy_unit,
    length_unit,
    raised,
    share_unit,
    significant,
    stress_unit,
    time_unit,
)
from softcat_sym.results.fields import audit_of, energy_imbalance, energy_label, midpoint_table
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import refused

LINES: Final = (
    (style.BLACK, "-"),
    (style.BLUE, "-"),
    (style.VERMILLION, "--"),
    (style.SKY, "-."),
    (style.ORANGE, ":"),
    (style.GREEN, (0, (6, 1.5, 1, 1.5, 1, 1.5))),
)
"""Colours that the colour-blind tell apart, each with a line style of its own for print in black and white."""

_SHAPES = {style.SCREEN: 5, "column": 4, "page": 4}


@dataclass(frozen=True, slots=True)
class Sheet:
    """What every figure of one run shares."""

    data: Fields
    summary: Summary
    scene: Scene
    name: str  # Of the style: ``screen``, ``column`` or ``page``
    time: Floats  # Of the frames [s]
    clock: Unit  # In which moments are told
    axis: TimeAxis

    @classmethod
    def of(cls, data: Fields, summary: Summary, scene: Scene, name: str = style.SCREEN) -> Sheet:
        """The sheet of a run, as far as it is drawn."""
        names = (*data, *getattr(data, "coords", ()))  # Of a Dataset the former are without its coordinates
        data, summary = style.shown_part({str(one): data[one] for one in names}, summary)
        times, of = array(data, "time"), _dense(data)
        moving = [array(data, f"{of}{one}") for one in ("time", "midpoint")]
        return cls(data, summary, scene, name, times, time_unit(float(np.abs(times).max())), TimeAxis.of(*moving))

    @property
    def on_screen(self) -> bool:
        """Whether there is a heading, and room for what print does without."""
        return self.name == style.SCREEN

    def titled_figure(self, what: str, height: float) -> tuple[Figure, SubFigure]:
        """A figure whose axes are placed in inches, since constrained layout would take half as long as the drawing."""
        layout: dict[str, Any] = {"height": height, "width": WIDTHS[self.name], "is_constrained": False}
        return style.titled_figure(self.scene, what if self.on_screen else "", self.summary, **layout)

    def figure(
        self,
        what: str,
        heights: Sequence[float],
        *,
        columns: int = 1,
        right: float = 0.2,
        above: float = 0.3,
        between: tuple[float, float] = (0.15, 0.25),
    ) -> tuple[Figure, SubFigure, list[Axes]]:
        """A figure with axes of the given heights below each other, or as many side by side; all in inches.

        `above` the axes a legend has its place.
        """
        left, below = (0.8, 0.48) if self.on_screen else (0.65, 0.4)
        across, down = between
        width, tall = WIDTHS[self.name], below + sum(heights) + down * (len(heights) - 1) + above
        figure, body = self.titled_figure(what, tall)
        gridspec = {"left": left / width, "right": 1 - right / width, "bottom": below / tall, "top": 1 - above / tall}
        gridspec["hspace"] = down * len(heights) / sum(heights)
        gridspec["wspace"] = across * columns / (width - left - right - across * (columns - 1))
        panels = body.subplots(len(heights), columns, squeeze=False, height_ratios=heights, gridspec_kw=gridspec)
        body.align_ylabels(panels[:, 0])
        return figure, body, list(panels.flat)

    def time_axis(self, axes: Axes) -> None:
        """Let time run along the horizontal axis."""
        self.axis.dress(axes, 8 if self.on_screen else 5)
        axes.grid(self.on_screen)

    def curves(self, *names: str) -> tuple[Floats, Floats]:
        """Times in the unit of the axis, and fields of the whole filament over them, shape (times, names)."""
        of, turns = _dense(self.data), self.summary.get("extremes") if names == ("midpoint",) else None
        values = np.stack([array(self.data, f"{of}{name}") for name in names], axis=-1)
        at, between = self.axis.between(array(self.data, f"{of}time"), values, np.reshape(turns or [], (-1, 2)))
        return self.axis.unit.of(at), between


def _dense(data: Fields) -> str:
    """What the names of fields at most times begin with."""
    return "dense_" if "dense_time" in data else ""


def midpoint_figure(data: Fields, summary: Summary, scene: Scene, name: str = style.SCREEN) -> Figure:
    """Draw the midpoint's height against time; on the screen with dimensionless scales on the far sides."""
    sheet = Sheet.of(data, summary, scene, name)
    height = array(sheet.data, "midpoint")
    largest = float(np.abs(height).max())
    ruler, frames = length_unit(largest, scene.filament.span), telling_frames(sheet.data, _SHAPES[name])
    time, shown = sheet.curves("midpoint")
    shown = ruler.of(shown[:, 0])
    with styled(name):
        tall, above, right, size = (3.0, 0.75, 0.8, 5.5) if sheet.on_screen else (1.6, 0.25, 0.2, 3.0)
        figure, body, (axes,) = sheet.figure("midpoint against time", [tall], right=right, above=above)
        axes.axhline(0.0, color=style.GREY, linewidth=0.6)
        axes.plot(time, shown, color=style.BLUE, label="midpoint")
        ring: dict[str, Any] = {"ms": size, "markerfacecolor": "white", "clip_on": False, "zorder": 3}
        places = sheet.axis.unit.of(sheet.time[frames]), ruler.of(height[frames])
        axes.plot(*places, "o", color=style.VERMILLION, label="shapes drawn", **ring)
        sheet.time_axis(axes)
        low, high = float(shown.min()), float(shown.max())
        if min(abs(low), abs(high)) < high - low:
            low, high = min(low, 0.0), max(high, 0.0)
        room = 0.1 * (high - low) or 1.0
        axes.set(ylim=(low - room, high + room), ylabel=f"midpoint height [{ruler.symbol}]")
        axes.yaxis.set_major_locator(MaxNLocator(6, steps=STEPS))
        if sheet.on_screen:
            _dimensionless(axes, sheet, ruler, largest)
            if not refused(sheet.summary):
                text = f"final {ruler.text(height[-1])} = {significant(height[-1] / scene.filament.span)} L"
                axes.text(0.985, 0.975, text, transform=axes.transAxes, ha="right", va="top", fontsize=8.5)
        body.legend(loc="upper center", borderaxespad=0.0, ncols=2)
    return figure


def _dimensionless(axes: Axes, sheet: Sheet, ruler: Unit, largest: float) -> None:
    """The same scales divided by the span and by the paper's unit of time, where the scene has one."""
    scene, span = sheet.scene, sheet.scene.filament.span
    share = share_unit(largest / span)
    factor = ruler.size / span / share.size
    right = axes.secondary_yaxis("right", functions=(partial(np.multiply, factor), partial(np.multiply, 1 / factor)))
    right.set_ylabel(f"midpoint height [{share.symbol} of L]")
    right.spines["right"].set_visible(True)
    modulus, gravity = scene.material.youngs_modulus, scene.load.gravity
    if modulus is not None and modulus > 0:
        unit, label = span * math.sqrt(scene.filament.density / modulus), "L √(ρ/E)"
    elif gravity > 0:
        unit, label = math.sqrt(span / gravity), "√(L/g)"
    else:
        return
    power = 3 * max(0, math.floor(math.log10(max(1.0, float(np.abs(sheet.time).max()) / unit)) / 3))
    top = axes.twiny()
    sheet.axis.dress(top, 8, unit * 10**power, f"time in {f'10{raised(power)} ' if power else ''}{label}")
    top.spines["top"].set_visible(True)


@dataclass(frozen=True, slots=True)
class Shape:
    """What is drawn of one frame."""

    section: FilamentOutline  # Centreline, normals, thickness
    outline: Floats  # Closed polygon, shape (vertex, 2) [m]
    yielded: Floats  # Quads of the yielded zones, shape (quad, 4, 2) [m]
    label: str  # Time, sag and yielded share, one per line


def shapes_of(data: Fields, scene: Scene, frames: list[int]) -> list[Shape]:
    """Compute what is drawn of the given frames."""
    yields, times, sags = yielding_of(data, scene), array(data, "time"), -array(data, "midpoint")
    clock, lengths = time_unit(float(np.abs(times).max())), np.diff(array(data, "X_node"))
    shapes = []
    for frame in frames:
        section, sag = section_at(data, frame, [one.holds_angle for one in scene.ends.supports]), float(sags[frame])
        depth = length_unit(abs(sag), scene.filament.span).text(abs(sag))
        lines = [f"t = {clock.text(float(times[frame]))}", f"{'sag' if sag >= 0 else 'rise'} {depth}"]
        if scene.material.yield_stress is not None:
            share = float(np.average(yields.share[frame], weights=lengths))
            lines.append("yielded < 0.1 %" if 0 < share < 1e-3 else f"yielded {100 * share:.1f} %")
        quads = quads_outside(section, yields.low[frame], yields.high[frame])
        shapes.append(Shape(section, outline(section), quads, "\n".join(lines)))
    return shapes


def yielded_label(data: Fields, scene: Scene) -> str:
    """What a colour or hatching for what yields means, with the rate below which nothing is shown."""
    limit, slowest = scene.material.yield_stress or 0.0, slowest_flow(data, scene)
    faster = f", flows faster than {significant(slowest)} s⁻¹" if slowest > 0 else ""
    return f"yielded: stress > {stress_unit(limit).text(limit)}{faster}"


_TALLEST, _DEEPEST = 7.0, 6.0
"""Of all shapes below each other, of shapes side by side [inch]."""

_NARROW, _LOW = 0.5, 0.3
"""Width of a shape beside others, and height of any, below which there is room for one number along its axis [inch]."""


def shapes_figure(
    data: Fields, summary: Summary, scene: Scene, name: str = style.SCREEN, radius: float = 1.0
) -> Figure:
    """Draw the filament at a few telling times, one below the other, or side by side if that would be too tall.

    Lengths are equal along both axes. A sag below 2 % of the span is too flat to see: it is then magnified, by a factor
    that the axis label states. So is a `radius` by which the thickness is drawn swollen, for the beads of a thin thread
    to be seen.
    """
    sheet, thickness = Sheet.of(data, summary, scene, name), style.drawn_radius(radius) * scene.filament.thickness
    drawn = "true thickness" if radius == 1 else f"thickness × {radius:g}"
    if "quaternion" in sheet.data:
        return _spatial_shapes(sheet, radius, drawn)
    frames = telling_frames(sheet.data, _SHAPES[name])
    larger = Magnification.of(largest_sag(array(sheet.data, "y")[frames]), thickness, scene.filament.span)
    shapes = shapes_of(larger.drawn(sheet.data, radius), scene, frames)
    corners = np.array([[shape.outline.min(axis=0), shape.outline.max(axis=0)] for shape in shapes])
    (left, right), margin = corners[:, [0, 1], 0].T, 0.25 * thickness * larger.thickness / larger.sag
    x = np.array([left.min(), right.max()])
    x += np.array([-1, 1]) * (0.02 * float(np.ptp(x)) or thickness)
    y = corners[:, :, 1] + margin * np.array([-1, 1])
    ruler = length_unit(float(np.abs(corners).max()), scene.filament.span)
    # Inches a metre: shapes stand below each other, unless beside each other they are larger.
    wide, tall, count = float(np.ptp(x)), larger.sag * np.ptp(y, axis=1), len(shapes)
    inch = min((WIDTHS[name] - (1.0 if sheet.on_screen else 0.65)) / wide, _TALLEST / float(tall.sum()))
    beside = min((WIDTHS[name] - 1.0 - 0.15 * (count - 1)) / count / wide, _DEEPEST / (larger.sag * float(np.ptp(y))))
    stacked = inch >= beside or not sheet.on_screen
    if not stacked:
        y[:], inch, tall = (y.min(), y.max()), beside, larger.sag * np.ptp(y, keepdims=True)[0]
    heights = np.maximum(inch * tall, _LOW if stacked else 0.0)
    size, lines = (8.0 if sheet.on_screen else 7.0), 1 if stacked else 3
    with styled(name):
        figure, body, panels = sheet.figure(
            f"shapes with their {drawn}", heights.tolist(), columns=1 if stacked else count, above=0.28 + 0.15 * lines,
            right=0.2 if sheet.on_screen else 0.1, between=(0.15, 0.24),
        )  # fmt: skip
        for axes, shape, bounds in zip(panels, shapes, y, strict=True):
            # What runs away to a thousand spans would be a line without width.
            if np.ptp(bounds) < 1e3 * wide:
                axes.set_aspect(larger.sag, anchor="S")
            axes.set(xlim=ruler.of(x), ylim=ruler.of(bounds))
            draw_bodies(axes, scene, 4 * margin, (x[0], x[1]), bounds[0], ruler)
            draw_shape(axes, shape, ruler)
            axes.xaxis.set_major_locator(MaxNLocator(6 if stacked else 2, steps=STEPS))
            if not stacked and inch * wide < _NARROW:
                axes.set_xticks([float(ruler.of(x.mean()))], [significant(float(ruler.of(x.mean())))])
            up = 2 if stacked else int(np.clip(heights[0] / 0.2, 1, 6))  # Numbers stand that far apart
            axes.yaxis.set_major_locator(MaxNLocator(up, steps=STEPS))
            if stacked and np.ptp(bounds) * larger.sag * inch < _LOW:
                axes.set_yticks((0.0,))
            words = ", ".join(shape.label.split("\n")) if stacked else shape.label
            axes.set_title(words, loc="left", y=1.0, pad=2, fontsize=size, linespacing=1.3)
            if stacked and axes is not panels[-1]:
                axes.xaxis.set_visible(False)
                axes.spines["bottom"].set_visible(False)
            axes.tick_params(labelleft=stacked or axes is panels[0])
        scaled = [str(larger)] * bool(str(larger)) + [drawn] * (radius != 1 and not sheet.on_screen)
        across = " ".join([f"x [{ruler.symbol}]", *(f"({one})" for one in scaled)])
        body.supxlabel(across, fontsize=size + 0.5, y=0.01, va="bottom")
        body.supylabel(f"y [{ruler.symbol}]", fontsize=size + 0.5, x=0.01, ha="left")
        label, colour = f"law “{style.printable(str(scene.material.law))}”: no yield stress", "white"
        if scene.material.yield_stress is not None:
            label, colour = yielded_label(sheet.data, scene), style.VERMILLION
        if scene.material.yield_stress is not None or sheet.on_screen:
            patches, small = [Patch(facecolor=colour, label=label)], max(7.0, size - 0.5)
            body.legend(handles=patches, loc="upper center", borderaxespad=0.0, fontsize=small)
    return figure


_PANELS, _PANEL = 4, 2.9
"""Shapes in space at most, and the height of each [inch]."""


def _spatial_shapes(sheet: Sheet, radius: float, drawn: str) -> Figure:
    """Draw the filament in space at a few telling times, lengths equal along all axes.

    The stripe marks one side of the section: where it winds round, the filament is twisted.
    """
    frames = telling_frames(sheet.data, _PANELS)
    tubes = [tube(sheet.data, sheet.scene, frame, radius) for frame in frames]
    corners = np.concatenate([one.reshape(-1, 3) for one in tubes])
    ruler = length_unit(float(np.abs(corners).max()), sheet.scene.filament.span)
    columns = min(len(frames), 2)
    rows = -(-len(frames) // columns)
    with styled(sheet.name):
        figure, body = sheet.titled_figure(f"shapes with their {drawn}; the stripe is one side", _PANEL * rows)
        for number, (frame, shape) in enumerate(zip(frames, tubes, strict=True)):
            row, column = divmod(number, columns)
            place = (column / columns, (rows - 1 - row) / rows, 1 / columns, 0.93 / rows)
            axes: Axes3D = body.add_axes(place, projection="3d")
            draw_tube(axes, ruler.of(shape))
            frame_tube(axes, ruler.of(corners.min(axis=0)), ruler.of(corners.max(axis=0)), ruler.symbol)
            axes.set_title(f"t = {sheet.clock.text(float(sheet.time[frame]))}", fontsize=8, pad=-4)
    return figure


def draw_shape(axes: Axes, shape: Shape, ruler: Unit, ever: Floats | None = None) -> None:
    """Body, zones that have `ever` yielded and those that yield, outline, the line between the ends."""
    body = ruler.of(shape.outline)
    # As artists: limits are set before, and looking for those of each patch takes as long as drawing it.
    inside = Polygon(body, facecolor=style.FILAMENT, edgecolor="none", zorder=2)
    axes.add_artist(inside)
    for colour, quads in ((style.ORANGE, ever), (style.VERMILLION, shape.yielded)):
        if quads is not None and len(quads):
            # Anti-aliasing would leave hairlines between neighbouring quads.
            look: dict[str, Any] = {"edgecolors": "none", "antialiaseds": False, "rasterized": True, "zorder": 3}
            zones = PolyCollection(list(ruler.of(quads)), facecolors=colour, **look)
            axes.add_collection(zones, autolim=False)
            # At a clamp the sections of the first cell cross: what they cover beyond the body is none.
            zones.set_clip_path(inside)
    axes.add_artist(Polygon(body, facecolor="none", edgecolor=style.BLACK, linewidth=0.4, zorder=4))
    axes.plot(ruler.of(shape.section.x[[0, -1]]), ruler.of(shape.section.y[[0, -1]]), ":", color=style.GREY, lw=0.6)


def energy_figure(data: Fields, summary: Summary, scene: Scene, name: str = style.SCREEN) -> Figure:
    """Draw the energy budget, and on the screen below it the imbalance relative to the largest energy."""
    sheet = Sheet.of(data, summary, scene, name)
    imbalance, largest = energy_imbalance(sheet.data)
    unit, marker = energy_unit(largest), "o" if sheet.time.size == 1 else None
    terms = [term for term in audit_of(sheet.data) if np.any(sheet.data[term])]
    rows = -(-len(terms) // (6 if sheet.on_screen else 3))
    with styled(name):
        heights, above = ([2.4, 0.8], 0.15 * (1 + rows)) if sheet.on_screen else ([1.6], 0.55)
        _, body, panels = sheet.figure("energy budget of the whole filament", heights, above=above, between=(0.15, 0.3))
        time, energies = sheet.curves(*terms) if terms else (sheet.time, np.empty((0, 0)))
        for k, (term, energy) in enumerate(zip(terms, unit.of(energies).T, strict=True)):
            # A colour that comes again has another line.
            colour, line = LINES[k % len(LINES)][0], LINES[(k + k // len(LINES)) % len(LINES)][1]
            panels[0].plot(time, energy, color=colour, linestyle=line, label=energy_label(term), marker=marker)
        panels[0].set_ylabel(f"energy [{unit.symbol}]")
        if sheet.on_screen:
            residual = imbalance / largest if largest > 0 else imbalance
            worst = float(np.abs(residual).max())
            share = share_unit(worst)
            look: dict[str, Any] = {"color": style.BLACK, "linewidth": 1.0, "marker": marker}
            panels[1].plot(sheet.axis.unit.of(sheet.time), share.of(residual), **look)
            room = float(share.of(1.3 * worst)) or 1.0
            panels[1].set(ylim=(-room, room), ylabel=f"imbalance [{share.symbol}]")
            text = f"largest imbalance {share.text(worst)} of the largest energy"
            panels[1].set_title(text, loc="right", y=1.0, fontsize=8.0, pad=2)
        for axes, ticks in zip(panels, (6, 3), strict=False):
            sheet.time_axis(axes)
            axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=0)
            axes.yaxis.set_major_locator(MaxNLocator(ticks, steps=STEPS))
        if sheet.on_screen:
            panels[0].tick_params(labelbottom=False)
            panels[0].set_xlabel("")
        if terms:
            across = -(-len(terms) // rows)
            body.legend(loc="upper center", borderaxespad=0.0, ncols=across, handlelength=2.0, columnspacing=1.1)
    return body.figure


ROWS = 240
"""Of a map, all equally tall: cells at a clamp may be narrower than a pixel, which would show one end only."""


@dataclass(frozen=True, slots=True)
class Map:
    """One quantity over the filament and the run."""

    values: Floats  # Shape (time, row): over :data:`ROWS` equal parts of the filament
    label: str  # With its unit
    norm: Normalize  # From values to colours
    colours: Colormap | str = "cividis"
    beyond: bool = False  # Whether values lie above the last colour


def maps_of(data: Fields, scene: Scene) -> tuple[Map, Map]:
    """Stretch, and the yielded share of the section; of a law that does not yield, the section's mean stress."""
    rows = _rows(array(data, "X_node"), array(data, "X_cell"))
    stretch = array(data, "stretch") @ rows
    low, high = float(stretch.min()), float(stretch.max())
    # Colours end at a quantile, where a few hinges would leave the rest of the filament in one of them.
    most = float(np.quantile(stretch, 0.98))
    beyond = high - 1 > 1.5 * (most - 1) > 0
    high = most if beyond else high
    if low > 0 and high > 5.0 * low:
        first = Map(stretch, "stretch", LogNorm(low, high), beyond=beyond)
    else:
        # A filament at rest has a range too: otherwise its rounding errors would be painted.
        low, high = min(low - 1, 0.0), max(high - 1, 1e-9)
        unit = share_unit(max(high, -low))
        norm = Normalize(float(unit.of(low)), float(unit.of(high)))
        first = Map(unit.of(stretch - 1), f"stretch \N{MINUS SIGN} 1 [{unit.symbol}]", norm, beyond=beyond)
    if scene.material.yield_stress is not None:
        # From what is at rest to what has yielded wholly, as in the picture of shapes.
        colours = LinearSegmentedColormap.from_list("yielded", [style.FILAMENT, style.ORANGE, style.VERMILLION])
        return first, Map(yielding_of(data, scene).share @ rows, "yielded share", Normalize(0.0, 1.0), colours)
    stress = array(data, "stress_mean") @ rows
    unit = stress_unit(float(np.abs(stress).max()))
    scaled = unit.of(stress)
    norm = Normalize(min(float(scaled.min()), 0.0), max(float(scaled.max()), 0.0) or 1.0)
    return first, Map(scaled, f"mean stress [{unit.symbol}]", norm)


def _rows(nodes: Floats, cells: Floats) -> Floats:
    """Weights of the cells in :data:`ROWS` equal parts of a filament, linear between the middles of cells."""
    points = np.linspace(nodes[0], nodes[-1], 8 * ROWS + 1)[1::2]
    weights = np.array([np.interp(points, cells, cell) for cell in np.eye(cells.size)])
    return np.asarray(weights.reshape(cells.size, ROWS, -1).mean(axis=2))


def space_time_figure(data: Fields, summary: Summary, scene: Scene, name: str = style.SCREEN) -> Figure:
    """Draw stretch and yielded share over X/L and time, with the time at which 0.9 of the final sag is reached."""
    sheet = Sheet.of(data, summary, scene, name)
    reached = None if refused(sheet.summary) else time_to_nine_tenths(sheet.data)
    slowest = 0.0 if scene.material.yield_stress is None else slowest_flow(sheet.data, scene)
    final, faster = ("final ", "faster than") if sheet.on_screen else ("", ">")
    texts = (
        "" if reached is None else f"dashed: 90 % of the {final}sag at {sheet.clock.text(reached)}",
        f"where it flows {faster} {significant(slowest)} s⁻¹" if slowest > 0 else "",
    )
    heights = {style.SCREEN: [1.6, 1.6], "column": [1.1, 1.1], "page": [1.3]}[name]
    columns, right = (2, 0.85) if name == "page" else (1, 0.95 if sheet.on_screen else 0.8)
    what, layout = "along the filament against time", {"columns": columns, "right": right, "between": (1.1, 0.3)}
    with styled(name):
        figure, _, panels = sheet.figure(what, heights, above=0.22, **layout)  # type: ignore[arg-type]
        for axes, shown, text in zip(panels, maps_of(sheet.data, scene), texts, strict=True):
            _draw_map(axes, sheet, shown, reached)
            axes.set_title(text, loc="left", y=1.0, fontsize=7.5, pad=3)
        if columns == 1:
            panels[0].tick_params(labelbottom=False)
            panels[0].set_xlabel("")
    return figure


def _draw_map(axes: Axes, sheet: Sheet, shown: Map, reached: float | None) -> None:
    """Draw one map, the midpoint's line, the mark of a time, and the colours with plain numbers beside it."""
    axis, nodes = sheet.axis, array(sheet.data, "X_node")
    places = np.linspace(nodes[0], nodes[-1], ROWS + 1) / (nodes[-1] - nodes[0])
    values = axis.columns(sheet.time, shown.values)
    sheet.time_axis(axes)
    axes.grid(False)
    # As an image, for which a colour is looked up once a pixel; a mesh of as many quads takes several times as long.
    # Its columns are as wide as each other whatever the scale.
    edges = np.linspace(*axes.get_xlim(), len(values) + 1)
    image = PcolorImage(axes, edges, places, values.T, norm=shown.norm, cmap=shown.colours)
    axes.add_image(image)
    axes.spines[:].set_visible(True)
    # A margin, so that the frame hides neither clamp.
    margin = (places[-1] - places[0]) / 100
    axes.set(ylim=(places[0] - margin, places[-1] + margin), ylabel="X / L", yticks=(-0.5, 0.0, 0.5))
    axes.axhline(0.5 * (places[0] + places[-1]), color=style.GREY, linewidth=0.6, linestyle=(0, (2, 3)))
    if reached is not None:
        # Seen on light and on dark.
        axes.axvline(float(axis.unit.of(reached)), color="white", linewidth=1.6)
        axes.axvline(float(axis.unit.of(reached)), color=style.BLACK, linewidth=0.8, linestyle="--")
    beside = axes.inset_axes((1.02, 0.0, 0.025, 1.0))
    bar = axes.figure.colorbar(image, cax=beside, label=shown.label, extend="max" if shown.beyond else "neither")
    if isinstance(shown.norm, LogNorm):
        style.plain_log(bar.ax.yaxis, significant)
        bar.minorticks_off()
    else:
        bar.locator = MaxNLocator(5, steps=STEPS)


def time_to_nine_tenths(data: Fields) -> float | None:
    """When the midpoint is first at 0.9 of its final sag [s]; None of one that ends where it began."""
    times, sag = array(data, f"{_dense(data)}time"), -array(data, f"{_dense(data)}midpoint")
    fallen = (sag - sag[0]) * np.sign(sag[-1] - sag[0])
    aim = 0.9 * fallen[-1]
    k = int(np.argmax(fallen >= aim))
    return float(np.interp(aim, fallen[k - 1 : k + 1], times[k - 1 : k + 1])) if aim > 0 and k else None


FIGURES: Final[dict[str, Callable[..., Figure]]] = {
    "midpoint": midpoint_figure,
    "shapes": shapes_figure,
    "energy": energy_figure,
    "space-time": space_time_figure,
}


@drawing.plot.register(Run)
def _of_run(run: Run, what: str = "midpoint", radius: float = 1.0) -> Figure:
    return drawing.figure_by_name(_figures(radius), what, run.fields, run.summary, run.scene)


def _figures(radius: float) -> dict[str, Callable[..., Figure]]:
    """The pictures, shapes drawn as many times as thick."""
    return {**FIGURES, "shapes": partial(shapes_figure, radius=radius)}


@drawing.report.register(Run)
def run_report(run: Run, name: str = style.SCREEN, radius: float = 1.0) -> Report:
    """Midpoint, shapes, energy and space-time as PNG, for print as PDF too, and ``midpoint.csv``."""
    files: dict[str, object] = {}
    for what, draw in _figures(radius).items():
        of = partial(draw, run.fields, run.summary, run.scene, name)
        if name == style.SCREEN:
            files[f"{what}.png"] = of
        else:
            with styled(name):
                files |= style.printed(what, of(), style.PRINT_DPI)
    return Report({**files, "midpoint.csv": partial(midpoint_csv, run)})


def midpoint_csv(run: Run) -> bytes:
    """The midpoint over time; what is refused says so in every row."""
    table, stream = midpoint_table(run.fields, run.summary), StringIO()
    rows = zip(*table.values(), strict=True)
    plain = ([one if isinstance(one, str) or np.isfinite(one) else "" for one in row] for row in rows)
    csv.writer(stream, lineterminator="\n").writerows([list(table), *plain])
    return stream.getvalue().encode()
