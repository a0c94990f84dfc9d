"""Shapes of the filament with its true thickness, the yielded zones shaded (the paper's figure 4)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from softcat_sym.plotting import style
from softcat_sym.plotting.section import (
    Floats,
    Layout,
    Section,
    arrange,
    outline,
    place,
    quads_outside,
    section_at,
    slowest_flow,
    telling_frames,
    yielding_of,
)
from softcat_sym.plotting.style import (
    PicturedScene,
    Summary,
    Unit,
    head,
    length_unit,
    new_figure,
    shown_part,
    significant,
    stress_unit,
    time_unit,
)


@dataclass(frozen=True, slots=True)
class Shape:
    """What is drawn of one frame."""

    section: Section  # Centreline, normals, thickness
    outline: Floats  # Closed polygon, shape (vertex, 2) [m]
    yielded: Floats  # Quads of the yielded zones, shape (quad, 4, 2) [m]
    label: str  # Time, sag and yielded share, one per line


def shapes_of(data: xr.Dataset, scene: PicturedScene, frames: list[int]) -> list[Shape]:
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
            length = np.diff(data["X_node"].values)
            share = float(np.average(yields.share[frame], weights=length))
            lines.append("yielded < 0.1 %" if 0 < share < 1e-3 else f"yielded {100 * share:.1f} %")
        quads = quads_outside(section, yields.low[frame], yields.high[frame])
        shapes.append(Shape(section, outline(section), quads, "\n".join(lines)))
    return shapes


def yielded_label(data: xr.Dataset, scene: PicturedScene) -> str:
    """What a colour or hatching for what yields means, with the rate below which nothing is shown."""
    limit, slowest = scene.material.yield_stress or 0.0, slowest_flow(data, scene)
    faster = f", flows faster than {significant(slowest)}/s" if slowest > 0 else ""
    return f"yielded: stress > {stress_unit(limit).text(limit)}{faster}"


def shapes_figure(data: xr.Dataset, summary: Summary, scene: PicturedScene) -> Figure:
    """Draw the filament at a few telling times.

    Lengths are equal along both axes. A sag below 2 % of the span is too flat to see: the vertical scale is then
    stretched, thickness and all, by a factor that the axis label states.
    """
    data, summary = shown_part(data, summary)
    shapes = shapes_of(data, scene, telling_frames(data))
    layout = arrange([shape.outline for shape in shapes], _sag(shapes), scene)
    extent = max(float(np.abs(shape.outline).max()) for shape in shapes)
    ruler = length_unit(extent, scene.filament.span)
    with style.styled():
        figure = new_figure(layout.width, layout.height)
        head(figure, "shapes with their true thickness", summary, scene, layout.left)
        for index, shape in enumerate(shapes):
            axes = place(figure, layout, index)
            _draw(axes, shape, layout, index, ruler)
        _explain(figure, layout, data, scene, ruler)
    return figure


def _sag(shapes: list[Shape]) -> float:
    """Largest departure of a centreline from the straight line between its ends [m]."""

    def departure(section: Section) -> float:
        line = np.linspace(section.y[0], section.y[-1], section.y.size)
        return float(np.abs(section.y - line).max())

    return max(departure(shape.section) for shape in shapes)


def _draw(axes: Axes, shape: Shape, layout: Layout, index: int, ruler: Unit) -> None:
    """One panel: body, yielded zones, outline, label."""
    panel = layout.panels[index]
    # An outline of fixed width would swallow a thin filament: it takes at most a fifth of the drawn thickness.
    drawn = 72.0 * layout.scale * layout.stretch * float(np.median(shape.section.thickness))
    edge = min(0.6, max(0.15, 0.1 * drawn))
    body = ruler.of(shape.outline)
    axes.fill(body[:, 0], body[:, 1], facecolor=style.FILAMENT, edgecolor="none", zorder=2)
    # Anti-aliasing would leave hairlines between neighbouring quads.
    quads = PolyCollection(
        list(ruler.of(shape.yielded)), facecolors=style.VERMILLION, edgecolors="none", antialiaseds=False
    )
    quads.set_zorder(3)
    axes.add_collection(quads, autolim=False)
    axes.fill(body[:, 0], body[:, 1], facecolor="none", edgecolor=style.BLACK, linewidth=edge, zorder=4)
    axes.plot(ruler.of(shape.section.x[[0, -1]]), ruler.of(shape.section.y[[0, -1]]), ":", color=style.GREY, lw=0.6)
    axes.set_xlim(*(float(ruler.of(bound)) for bound in panel.x))
    axes.set_ylim(*(float(ruler.of(bound)) for bound in panel.y))
    axes.xaxis.set_major_locator(MaxNLocator(max(2, min(8, int(panel.width / 0.6)))))
    axes.yaxis.set_major_locator(MaxNLocator(max(1, min(6, int(panel.height / 0.28)))))
    style.lighten(axes)
    axes.tick_params(labelbottom=panel.bottom_labels, labelleft=panel.left_labels)
    if layout.stacked:
        axes.text(1.02, 0.5, shape.label, transform=axes.transAxes, va="center", fontsize=8.0, linespacing=1.3)
    else:
        axes.set_title(shape.label, fontsize=8.0, loc="left", linespacing=1.3)


def _explain(figure: Figure, layout: Layout, data: xr.Dataset, scene: PicturedScene, ruler: Unit) -> None:
    """Shared axis labels and a legend that says what is shaded, or that nothing can be."""
    width, height = layout.width, layout.height
    drawn, scaled = "", ""
    if layout.stretch != 1:
        drawn, scaled = f", drawn × {layout.stretch:g}", f" (vertical scale × {layout.stretch:g}, thickness too)"
    middle = (layout.panels[0].bottom + layout.panels[0].height + layout.panels[-1].bottom) / 2
    figure.text(0.1 / width, middle / height, f"y [{ruler.symbol}]{drawn}", rotation=90, va="center", fontsize=9.0)
    centre = (layout.panels[0].left + layout.panels[-1].left + layout.panels[-1].width) / 2
    figure.text(centre / width, 0.42 / height, f"x [{ruler.symbol}]{scaled}", ha="center", fontsize=9.0)
    if scene.material.yield_stress is None:
        note = f"The law “{style.printable(str(scene.material.law))}” has no yield stress: nothing is shaded."
        figure.text(layout.left / width, 0.14 / height, note, fontsize=8.0, color=style.GREY, parse_math=False)
        return
    figure.legend(
        handles=[
            Patch(facecolor=style.VERMILLION, label=yielded_label(data, scene)),
            Patch(facecolor=style.FILAMENT, edgecolor=style.BLACK, linewidth=0.5, label="not yielded"),
        ],
        loc="lower left",
        bbox_to_anchor=(layout.left / width, 0.05 / height),
        ncols=2,
        borderaxespad=0.0,
    )
