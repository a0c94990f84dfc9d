"""Where the panels of the shape picture go, at one scale for all."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from softcat_sym.report import style
from softcat_sym.report.canvas import HEADING, axes_in_inches
from softcat_sym.report.contract import PicturedScene
from softcat_sym.report.section import Floats
from softcat_sym.report.units import nice_floor

# A sag below this share of the span is exaggerated, until it or the thickness reaches these shares as drawn.
_FLAT = 0.02
_DRAWN_SAG = 0.10
_DRAWN_THICKNESS = 0.12

_LEFT, _RIGHT, _BOTTOM, _GAP, _TALLEST, _LEAST = 0.85, 1.15, 0.85, 0.22, 7.6, 0.42
_ROW_HEIGHT, _ROW_LABELS, _ROW_GAP = 5.2, 0.55, 0.3


@dataclass(frozen=True, slots=True)
class Panel:
    """One panel: place and size [inch], limits [m], which tick labels it carries."""

    left: float
    bottom: float
    width: float
    height: float
    x: tuple[float, float]
    y: tuple[float, float]
    bottom_labels: bool
    left_labels: bool


@dataclass(frozen=True, slots=True)
class Layout:
    """The picture's size [inch], its scale [inch per metre], vertical stretch and panels."""

    width: float
    height: float
    left: float
    scale: float
    stretch: float
    stacked: bool
    panels: tuple[Panel, ...]


def vertical_stretch(sag: float, thickness: float, span: float) -> float:
    """Factor by which the vertical scale is stretched: 1, 2 or 5 times a power of ten.

    Parameters
    ----------
    sag, thickness, span : float
        Largest sag, initial thickness and span [m].

    Returns
    -------
    float
        One when the sag is at least 2 % of the span, or zero: there is nothing to make visible.
    """
    if sag <= 0 or sag >= _FLAT * span:
        return 1.0
    return max(1.0, nice_floor(min(_DRAWN_SAG * span / sag, _DRAWN_THICKNESS * span / thickness)))


def arrange(outlines: list[Floats], sag: float, scene: PicturedScene) -> Layout:
    """Lay the panels out below one another, or side by side if that would be taller than a page.

    Parameters
    ----------
    outlines : list of numpy.ndarray
        Closed polygons, shape (vertex, 2) [m].
    sag : float
        Largest sag [m].
    scene : PicturedScene
        Span and thickness are read.

    Returns
    -------
    Layout
        Panels in the order of the outlines; every one has the same scale.
    """
    thickness = scene.filament.thickness
    stretch = vertical_stretch(sag, thickness, scene.filament.span)
    low = np.min([outline.min(axis=0) for outline in outlines], axis=0)
    high = np.max([outline.max(axis=0) for outline in outlines], axis=0)
    pad = 0.02 * float(high[0] - low[0]) or thickness
    x = (float(low[0]) - pad, float(high[0]) + pad)
    width = style.WIDTH - _LEFT - _RIGHT
    scale = width / (x[1] - x[0])
    vertical = scale * stretch
    ranges = [_padded(outline, 0.25 * thickness, _LEAST / vertical) for outline in outlines]
    heights = [vertical * (y[1] - y[0]) for y in ranges]
    if sum(heights) + _GAP * (len(heights) - 1) > _TALLEST:
        return _row(len(outlines), x, (float(low[1]), float(high[1])))
    panels = []
    top = _BOTTOM + sum(heights) + _GAP * (len(heights) - 1)
    height = top + HEADING
    for index, (y, tall) in enumerate(zip(ranges, heights, strict=True)):
        last = index == len(heights) - 1
        panels.append(Panel(_LEFT, top - tall, width, tall, x, y, bottom_labels=last, left_labels=True))
        top -= tall + _GAP
    return Layout(style.WIDTH, height, _LEFT, scale, stretch, True, tuple(panels))


def place(figure: Figure, layout: Layout, index: int) -> Axes:
    """Add the axes of one panel.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    layout : Layout
        The layout.
    index : int
        Number of the panel.

    Returns
    -------
    matplotlib.axes.Axes
        Axes whose limits are yet to be set, in any unit.
    """
    panel = layout.panels[index]
    return axes_in_inches(figure, panel.left, panel.bottom, panel.width, panel.height)


def _row(count: int, x: tuple[float, float], y: tuple[float, float]) -> Layout:
    """Side by side on one height; never stretched, since what does not fit a page is not flat."""
    pad = 0.03 * (y[1] - y[0])
    y = (y[0] - pad, y[1] + pad)
    room = (style.WIDTH - _LEFT - 0.2 - _ROW_GAP * (count - 1)) / count
    scale = min(_ROW_HEIGHT / (y[1] - y[0]), room / (x[1] - x[0]))
    tall = scale * (y[1] - y[0])
    centre = 0.5 * (x[0] + x[1])
    x = (centre - 0.5 * room / scale, centre + 0.5 * room / scale)
    panels = tuple(
        Panel(_LEFT + index * (room + _ROW_GAP), _BOTTOM, room, tall, x, y, bottom_labels=True, left_labels=index == 0)
        for index in range(count)
    )
    height = _BOTTOM + tall + _ROW_LABELS + HEADING
    return Layout(style.WIDTH, height, _LEFT, scale, 1.0, False, panels)


def _padded(outline: Floats, pad: float, least: float) -> tuple[float, float]:
    """Vertical range of one panel, with room around it and at least ``least`` tall."""
    low, high = float(outline[:, 1].min()) - pad, float(outline[:, 1].max()) + pad
    lacking = 0.5 * max(0.0, least - (high - low))
    return low - lacking, high + lacking
