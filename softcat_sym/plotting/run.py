"""Pictures of a run for the screen, a journal's column or a page, and all its files."""

from __future__ import annotations

import csv
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
from softcat_sym.plotting.bodies import draw_bodies, draw_nozzle
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
from softcat_sym.plotting.style import WIDTH, Fields, styled
from softcat_sym.plotting.time_axis import STEPS, TimeAxis
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

_SHAPES = 5
"""Drawn at most."""


@dataclass(frozen=True, slots=True)
class Sheet:
    """What every figure of one run shares."""

    data: Fields
    summary: Summary
    scene: Scene
    time: Floats  # Of the frames [s]
    clock: Unit  # In which moments are told
    axis: TimeAxis

    @classmethod
    def of(cls, data: Fields, summary: Summary, scene: Scene) -> Sheet:
        """The sheet of a run, as far as it is drawn."""
        names = (*data, *getattr(data, "coords", ()))  # Of a Dataset the former are without its coordinates
        data, summary = style.shown_part({str(one): data[one] for one in names}, summary)
        times, of = array(data, "time"), _dense(data)
        moving = [array(data, f"{of}{one}") for one in ("time", "midpoint")]
        return cls(data, summary, scene, times, time_unit(float(np.abs(times).max())), TimeAxis.of(*moving))

    def titled_figure(self, what: str, height: float) -> tuple[Figure, SubFigure]:
        """A figure whose axes are placed in inches, since constrained layout would take half as long as the drawing."""
        return style.titled_figure(self.scene, what, self.summary, height=height, is_constrained=False)

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
        left, below, width = 0.8, 0.48, WIDTH
        across, down = between
        tall = below + sum(heights) + down * (len(heights) - 1) + above
        figure, body = self.titled_figure(what, tall)
        gridspec = {"left": left / width, "right": 1 - right / width, "bottom": below / tall, "top": 1 - above / tall}
        gridspec["hspace"] = down * len(heights) / sum(heights)
        gridspec["wspace"] = across * columns / (width - left - right - across * (columns - 1))
        panels = body.subplots(len(heights), columns, squeeze=False, height_ratios=heights, gridspec_kw=gridspec)
        body.align_ylabels(panels[:, 0])
        return figure, body, list(panels.flat)

    def time_axis(self, axes: Axes) -> None:
        """Let time run along the horizontal axis."""
        self.axis.dress(axes, 8)
        axes.grid(True)

    def curves(self, *names: str) -> tuple[Floats, Floats]:
        """Times in the unit of the axis, and fields of the whole filament over them, shape (times, names)."""
        of, turns = _dense(self.data), self.summary.get("extremes") if names == ("midpoint",) else None
        values = np.stack([array(self.data, f"{of}{name}") for name in names], axis=-1)
        at, between = self.axis.between(array(self.data, f"{of}time"), values, np.reshape(turns or [], (-1, 2)))
        return self.axis.unit.of(at), between


def _dense(data: Fields) -> str:
    """What the names of fields at most times begin with."""
    return "dense_" if "dense_time" in data else ""


@styled()
def midpoint_figure(data: Fields, summary: Summary, scene: Scene) -> Figure:
    """Draw the midpoint's height against time."""
    sheet = Sheet.of(data, summary, scene)
    height = array(sheet.data, "midpoint")
    ruler, frames = length_unit(float(np.abs(height).max()), scene.filament.span), telling_frames(sheet.data, _SHAPES)
    time, shown = sheet.curves("midpoint")
    shown = ruler.of(shown[:, 0])
    _, body, (axes,) = sheet.figure("midpoint against time", [3.0])
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    axes.plot(time, shown, color=style.BLUE, label="midpoint")
    ring: dict[str, Any] = {"ms": 5.5, "markerfacecolor": "white", "clip_on": False, "zorder": 3}
    places = sheet.axis.unit.of(sheet.time[frames]), ruler.of(height[frames])
    axes.plot(*places, "o", color=style.VERMILLION, label="shapes drawn", **ring)
    sheet.time_axis(axes)
    low, high = float(shown.min()), float(shown.max())
    if min(abs(low), abs(high)) < high - low:
        low, high = min(low, 0.0), max(high, 0.0)
    room = 0.1 * (high - low) or 1.0
    axes.set(ylim=(low - room, high + room), ylabel=f"midpoint height [{ruler.symbol}]")
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=STEPS))
    if not refused(sheet.summary):
        text = f"final {ruler.text(height[-1])} = {significant(height[-1] / scene.filament.span)} L"
        axes.text(0.985, 0.975, text, transform=axes.transAxes, ha="right", va="top", fontsize=8.5)
    body.legend(loc="upper center", borderaxespad=0.0, ncols=2)
    return body.figure


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


@styled()
def shapes_figure(data: Fields, summary: Summary, scene: Scene, radius: float = 1.0) -> Figure:
    """Draw the filament at a few telling times, one below the other, or side by side if that would be too tall.

    Lengths are equal along both axes. A sag below 2 % of the span is too flat to see: it is then magnified, by a factor
    that the axis label states. So is a `radius` by which the thickness is drawn swollen, for the beads of a thin thread
    to be seen.
    """
    sheet, thickness = Sheet.of(data, summary, scene), style.drawn_radius(radius) * scene.filament.thickness
    drawn = "true thickness" if radius == 1 else f"thickness × {radius:g}"
    if "quaternion" in sheet.data:
        return _spatial_shapes(sheet, radius, drawn)
    frames = telling_frames(sheet.data, _SHAPES)
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
    inch = min((WIDTH - 1.0) / wide, _TALLEST / float(tall.sum()))
    beside = min((WIDTH - 1.0 - 0.15 * (count - 1)) / count / wide, _DEEPEST / (larger.sag * float(np.ptp(y))))
    stacked = inch >= beside
    if not stacked:
        y[:], inch, tall = (y.min(), y.max()), beside, larger.sag * np.ptp(y, keepdims=True)[0]
    heights = np.maximum(inch * tall, _LOW if stacked else 0.0)
    _, body, panels = sheet.figure(
        f"shapes with their {drawn}", heights.tolist(), columns=1 if stacked else count,
        above=0.43 if stacked else 0.73, between=(0.15, 0.24),
    )  # fmt: skip
    for axes, shape, bounds, frame in zip(panels, shapes, y, frames, strict=True):
        # What runs away to a thousand spans would be a line without width.
        if np.ptp(bounds) < 1e3 * wide:
            axes.set_aspect(larger.sag, anchor="S")
        axes.set(xlim=ruler.of(x), ylim=ruler.of(bounds))
        draw_bodies(axes, scene, 4 * margin, (x[0], x[1]), bounds[0], ruler)
        if scene.extrusion.present:
            draw_nozzle(axes, scene, float(sheet.time[frame]), 4 * margin, ruler)
        draw_shape(axes, shape, ruler)
        axes.xaxis.set_major_locator(MaxNLocator(6 if stacked else 2, steps=STEPS))
        if not stacked and inch * wide < _NARROW:
            axes.set_xticks([float(ruler.of(x.mean()))], [significant(float(ruler.of(x.mean())))])
        up = 2 if stacked else int(np.clip(heights[0] / 0.2, 1, 6))  # Numbers stand that far apart
        axes.yaxis.set_major_locator(MaxNLocator(up, steps=STEPS))
        if stacked and np.ptp(bounds) * larger.sag * inch < _LOW:
            axes.set_yticks((0.0,))
        words = shape.label.replace("\n", ", ") if stacked else shape.label
        axes.set_title(words, loc="left", y=1.0, pad=2, fontsize=8.0, linespacing=1.3)
        if stacked and axes is not panels[-1]:
            axes.xaxis.set_visible(False)
            axes.spines["bottom"].set_visible(False)
        axes.tick_params(labelleft=stacked or axes is panels[0])
    scaled = f" ({larger})" if str(larger) else ""
    body.supxlabel(f"x [{ruler.symbol}]{scaled}", fontsize=8.5, y=0.01, va="bottom")
    body.supylabel(f"y [{ruler.symbol}]", fontsize=8.5, x=0.01, ha="left")
    label, colour = f"law “{style.printable(str(scene.material.law))}”: no yield stress", "white"
    if scene.material.yield_stress is not None:
        label, colour = yielded_label(sheet.data, scene), style.VERMILLION
    patches = [Patch(facecolor=colour, label=label)]
    body.legend(handles=patches, loc="upper center", borderaxespad=0.0, fontsize=7.5)
    return body.figure


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


@styled()
def energy_figure(data: Fields, summary: Summary, scene: Scene) -> Figure:
    """Draw the energy budget, and below it the imbalance relative to the largest energy."""
    sheet = Sheet.of(data, summary, scene)
    imbalance, largest = energy_imbalance(sheet.data)
    unit, marker = energy_unit(largest), "o" if sheet.time.size == 1 else None
    terms = [term for term in audit_of(sheet.data) if np.any(sheet.data[term])]
    rows = -(-len(terms) // 6)
    what, above = "energy budget of the whole filament", 0.15 * (1 + rows)
    _, body, (budget, rest) = sheet.figure(what, [2.4, 0.8], above=above, between=(0.15, 0.3))
    time, energies = sheet.curves(*terms) if terms else (sheet.time, np.empty((0, 0)))
    for k, (term, energy) in enumerate(zip(terms, unit.of(energies).T, strict=True)):
        # A colour that comes again has another line.
        colour, line = LINES[k % len(LINES)][0], LINES[(k + k // len(LINES)) % len(LINES)][1]
        budget.plot(time, energy, color=colour, linestyle=line, label=energy_label(term), marker=marker)
    budget.set_ylabel(f"energy [{unit.symbol}]")
    residual = imbalance / largest if largest > 0 else imbalance
    worst = float(np.abs(residual).max())
    share = share_unit(worst)
    rest.plot(sheet.axis.unit.of(sheet.time), share.of(residual), color=style.BLACK, linewidth=1.0, marker=marker)
    room = float(share.of(1.3 * worst)) or 1.0
    rest.set(ylim=(-room, room), ylabel=f"imbalance [{share.symbol}]")
    text = f"largest imbalance {share.text(worst)} of the largest energy"
    rest.set_title(text, loc="right", y=1.0, fontsize=8.0, pad=2)
    for axes, ticks in ((budget, 6), (rest, 3)):
        sheet.time_axis(axes)
        axes.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=0)
        axes.yaxis.set_major_locator(MaxNLocator(ticks, steps=STEPS))
    budget.tick_params(labelbottom=False)
    budget.set_xlabel("")
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


@styled()
def space_time_figure(data: Fields, summary: Summary, scene: Scene) -> Figure:
    """Draw stretch and yielded share over X/L and time, with the time at which 0.9 of the final sag is reached."""
    sheet = Sheet.of(data, summary, scene)
    reached = None if refused(sheet.summary) else time_to_nine_tenths(sheet.data)
    slowest = 0.0 if scene.material.yield_stress is None else slowest_flow(sheet.data, scene)
    texts = (
        "" if reached is None else f"dashed: 90 % of the final sag at {sheet.clock.text(reached)}",
        f"where it flows faster than {significant(slowest)} s⁻¹" if slowest > 0 else "",
    )
    figure, _, panels = sheet.figure("along the filament against time", [1.6, 1.6], above=0.22, right=0.95)
    for axes, shown, text in zip(panels, maps_of(sheet.data, scene), texts, strict=True):
        _draw_map(axes, sheet, shown, reached)
        axes.set_title(text, loc="left", y=1.0, fontsize=7.5, pad=3)
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
def run_report(run: Run, radius: float = 1.0) -> Report:
    """Midpoint, shapes, energy and space-time as pictures, and ``midpoint.csv``."""
    drawn = _figures(radius).items()
    files: dict[str, object] = {
        f"{what}.png": partial(draw, run.fields, run.summary, run.scene) for what, draw in drawn
    }
    return Report(files | {"midpoint.csv": partial(midpoint_csv, run)})


def midpoint_csv(run: Run) -> bytes:
    """The midpoint over time; what is refused says so in every row."""
    table, stream = midpoint_table(run.fields, run.summary), StringIO()
    rows = zip(*table.values(), strict=True)
    plain = ([one if isinstance(one, str) or np.isfinite(one) else "" for one in row] for row in rows)
    csv.writer(stream, lineterminator="\n").writerows([list(table), *plain])
    return stream.getvalue().encode()
