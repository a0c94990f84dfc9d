"""One scene as a small picture: how the filament moves, earlier shapes paler, with its true thickness."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from softcat_sym.report import style
from softcat_sym.report.canvas import axes_in_inches, new_figure
from softcat_sym.report.frames import telling_frames
from softcat_sym.report.layout import vertical_stretch
from softcat_sym.report.section import Floats
from softcat_sym.report.shapes import Shape, shapes_of
from softcat_sym.report.units import length_unit, nice_floor

if TYPE_CHECKING:
    from softcat_sym.scene import Scene
    from softcat_sym.study.gallery import Exhibit

_WIDTH, _HEIGHT, _TEXT, _FOOT, _SIDE = 3.0, 2.3, 0.50, 0.26, 0.14
"""Size of a tile, and its margins [inch]."""

_DEEPEST = 1.6
"""A run that is drawn without end is shown until it hangs this many spans deep."""


def tile(data: xr.Dataset, scene: Scene, exhibit: Exhibit) -> Figure:
    """Draw a scene of the gallery.

    Lengths are equal along both axes, unless the sag is too flat to see: then the picture says by how much it is
    stretched. A bar tells the scale.

    Parameters
    ----------
    data : xarray.Dataset
        Its trajectory.
    scene : Scene
        What was run.
    exhibit : Exhibit
        Its name, and how it ended.

    Returns
    -------
    matplotlib.figure.Figure
        3 by 2.3 inches.
    """
    data = _shown(data, scene.filament.span)
    shapes = shapes_of(data, scene, telling_frames(data, 4))
    low = np.min([one.outline.min(axis=0) for one in shapes], axis=0)
    high = np.max([one.outline.max(axis=0) for one in shapes], axis=0)
    with style.styled():
        figure = new_figure(_WIDTH, _HEIGHT)
        _caption(figure, exhibit)
        room = np.array([_WIDTH - 2 * _SIDE, _HEIGHT - _TEXT - _FOOT])
        axes = axes_in_inches(figure, _SIDE, _FOOT, *room)
        axes.set_axis_off()
        sag = max(float(np.abs(one.section.y - _chord(one)).max()) for one in shapes)
        stretch = vertical_stretch(sag, scene.filament.thickness, scene.filament.span)
        # Equal lengths within the room, centred; three per cent of air around.
        scale = min(room[0] / (high[0] - low[0]), room[1] / (stretch * (high[1] - low[1]))) / 1.06
        centre, half = (low + high) / 2, room / np.array([scale, scale * stretch]) / 2
        axes.set_xlim(centre[0] - half[0], centre[0] + half[0])
        axes.set_ylim(centre[1] - half[1], centre[1] + half[1])
        for strength, shape in zip(np.linspace(0.25, 1.0, len(shapes)), shapes, strict=True):
            _draw(axes, shape, float(strength) if shape is not shapes[-1] else 1.0)
        _hold(axes, shapes[-1], scene, 0.09 / scale)
        _rule(figure, float(high[0] - low[0]), scale, stretch)
    return figure


def _shown(data: xr.Dataset, span: float) -> xr.Dataset:
    """The part of a run that fits a picture."""
    deep = np.abs(data["y"].values).max(axis=1) > _DEEPEST * max(span, float(np.ptp(data["x"].values, axis=1).max()))
    return data.isel(time=slice(0, max(2, int(deep.argmax())))) if deep.any() else data


def _chord(shape: Shape) -> Floats:
    y = shape.section.y
    line: Floats = np.linspace(y[0], y[-1], y.size)
    return line


def _draw(axes: Axes, shape: Shape, strength: float) -> None:
    """A body and its yielded zones; `strength` below one makes an earlier shape paler."""
    body = axes.fill(*shape.outline.T, facecolor=style.BLUE, edgecolor=style.BLUE, linewidth=0.7, zorder=2 + strength)
    quads = PolyCollection(
        list(shape.yielded), facecolors=style.VERMILLION, edgecolors=style.VERMILLION, linewidths=0.2
    )
    quads.set_zorder(2.01 + strength)
    axes.add_collection(quads, autolim=False)
    for one in (*body, quads):
        one.set_alpha(0.55 * strength if strength < 1 else 1.0)


def _hold(axes: Axes, shape: Shape, scene: Scene, size: float) -> None:
    """What holds the ends: a wall for a clamp, a dot for a pin, nothing for a free end."""
    for place, kind in ((0, scene.ends.left), (-1, scene.ends.right)):
        x, y = float(shape.section.x[place]), float(shape.section.y[place])
        if kind == "pinned":
            axes.plot([x], [y], "o", ms=4.5, mfc="white", mec=style.BLACK, mew=0.9, zorder=6, clip_on=False)
        elif kind == "clamped":
            outside = -size if place == 0 else 0.0
            bottom, top = axes.get_ylim()
            tall = max(0.11 * (top - bottom), 0.65 * float(shape.section.thickness[place]))
            axes.fill_between([x + outside, x + outside + size], y - tall, y + tall, color=style.GREY, lw=0, zorder=5)


def _caption(figure: Figure, exhibit: Exhibit) -> None:
    """The scene's name, its regime and sag; a refusal in another colour."""
    figure.text(_SIDE / _WIDTH, 1 - 0.07 / _HEIGHT, exhibit.name, va="top", fontsize=11, fontweight="bold")
    text, colour = f"refused: {exhibit.outcome}", style.VERMILLION
    if exhibit.sag_final is not None:
        sag = abs(exhibit.sag_final)
        word = "sag" if exhibit.sag_final >= 0 else "rise"
        text, colour = f"{exhibit.regime} · {word} {length_unit(sag, exhibit.span).text(sag)}", style.GREY
    figure.text(_SIDE / _WIDTH, 1 - 0.29 / _HEIGHT, text, va="top", fontsize=8.5, color=colour)


def _rule(figure: Figure, width: float, scale: float, stretch: float) -> None:
    """A bar of a round length, and by how much the vertical is stretched."""
    length = nice_floor(0.3 * width)
    left, below = _SIDE / _WIDTH, 0.10 / _HEIGHT
    right = left + scale * length / _WIDTH
    bar = axes_in_inches(figure, 0, 0, _WIDTH, _FOOT)
    bar.set_axis_off()
    bar.set_xlim(0, 1)
    bar.set_ylim(0, _FOOT / _HEIGHT)
    bar.plot([left, right], [below, below], color=style.BLACK, lw=1.2, solid_capstyle="butt")
    unit = length_unit(1.001 * length)  # just below a power of ten
    note = f"{length / unit.size:g} {unit.symbol}" + (f", vertical × {stretch:g}" if stretch != 1 else "")
    bar.text(right + 0.02, below, note, va="center", fontsize=7.5, color=style.GREY)
