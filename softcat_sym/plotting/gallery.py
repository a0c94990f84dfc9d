"""The gallery of the bundled scenes, each run once: a picture and a file a scene, one page, one contact sheet."""

from __future__ import annotations

import io
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from rich.text import Text

from softcat_sym import store
from softcat_sym.drawing import Report
from softcat_sym.files import json_bytes
from softcat_sym.plotting import style
from softcat_sym.plotting.run import Shape, shapes_of
from softcat_sym.plotting.section import Magnification, array, largest_sag, telling_frames
from softcat_sym.plotting.style import Fields, axes_in_inches, first_frames, new_figure, png, styled
from softcat_sym.plotting.units import length_unit, nice_floor, significant
from softcat_sym.scene.bundled import bundled_lesson, bundled_text
from softcat_sym.scene.reading import load_scene
from softcat_sym.simulate import identity_of, recalled, without_estimate

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from softcat_sym.results.run import Run
    from softcat_sym.scene.scene import Scene


Row: TypeAlias = dict[str, Any]
"""What ``gallery.json`` holds of one scene."""


def scene_run(name: str, changes: Iterable[str] = ()) -> tuple[Row, Run]:
    """Run a scene of the gallery, or recall it from the store; what is refused has neither regime nor sag."""
    scene = without_estimate(load_scene(name, list(changes)))
    run = recalled(scene)
    midpoint, sound = run.fields["midpoint"], run.outcome.is_success
    row = {
        "name": name,
        "title": scene.title,
        "lesson": bundled_lesson(name),
        "law": scene.material.law,
        "outcome": run.outcome.name,
        "regime": str(run.summary["regime"]) if sound else "",
        "span_m": scene.filament.span,
        "thickness_m": scene.filament.thickness,
        "duration_s": scene.run.duration,
        "sag_final_m": -float(midpoint[-1]) if sound else None,
        "sag_largest_m": -float(midpoint.min()) if sound else None,
        "largest_stretch": float(run.fields["stretch"][-1].max()) if sound else None,
        "wall_s": run.summary["wall_s"]["total"],
        "identity": store.key_of("run", identity_of(scene))[:16],
    }
    return row, run


_WIDTH, _HEIGHT, _TEXT, _FOOT, _SIDE = 3.0, 2.3, 0.50, 0.26, 0.14
"""Size of a tile, and its margins [inch]."""

_DEEPEST = 1.6
"""A run that is drawn without end is shown until it hangs this many spans deep."""


@styled()
def tile(run: Run, row: Row) -> Figure:
    """Draw a scene of the gallery.

    Lengths are equal along both axes, unless the sag is too flat to see: then the picture says by how much it is
    magnified. A bar shows the scale.
    """
    data: Fields = run.fields
    scene, sag = run.scene, row["sag_final_m"]
    reach = max(scene.filament.span, float(np.ptp(array(data, "x"), axis=1).max()))
    deep = np.abs(array(data, "y")).max(axis=1) > _DEEPEST * reach
    if deep.any():
        data = first_frames(data, max(2, int(deep.argmax())))
    frames = telling_frames(data, 4)
    larger = Magnification.of(largest_sag(array(data, "y")[frames]), scene.filament.thickness, scene.filament.span)
    shapes = shapes_of(larger.drawn(data), scene, frames)
    corners = np.concatenate([shape.outline for shape in shapes])
    low, high = corners.min(axis=0), corners.max(axis=0)
    figure, left = new_figure(_WIDTH, _HEIGHT), _SIDE / _WIDTH
    figure.text(left, 1 - 0.07 / _HEIGHT, row["name"], va="top", fontsize=11, fontweight="bold")
    text, colour = f"refused: {row['outcome']}", style.VERMILLION
    if sag is not None:
        depth = length_unit(abs(sag), scene.filament.span).text(abs(sag))
        text, colour = f"{row['regime']} · {'sag' if sag >= 0 else 'rise'} {depth}", style.GREY
    figure.text(left, 1 - 0.29 / _HEIGHT, text, va="top", fontsize=8.5, color=colour)
    room = np.array([_WIDTH - 2 * _SIDE, _HEIGHT - _TEXT - _FOOT])
    axes = axes_in_inches(figure, _SIDE, _FOOT, *room)
    axes.set_axis_off()
    # Equal lengths within the room, centred; three per cent of air around.
    scale = min(room[0] / (high[0] - low[0]), room[1] / (larger.sag * (high[1] - low[1]))) / 1.06
    centre, half = (low + high) / 2, room / np.array([scale, scale * larger.sag]) / 2
    axes.set(xlim=(centre[0] - half[0], centre[0] + half[0]), ylim=(centre[1] - half[1], centre[1] + half[1]))
    for strength, shape in zip(np.linspace(1.0, 0.25, len(shapes)).tolist(), reversed(shapes), strict=True):
        # An earlier shape is paler.
        look: dict[str, Any] = {"zorder": 2 + strength, "alpha": 0.55 * strength if strength < 1 else 1.0}
        axes.fill(*shape.outline.T, facecolor=style.BLUE, edgecolor=style.BLUE, linewidth=0.7, **look)
        colours = {"facecolors": style.VERMILLION, "edgecolors": style.VERMILLION, "linewidths": 0.2}
        axes.add_collection(PolyCollection(list(shape.yielded), **{**look, **colours}), autolim=False)
    _draw_supports(axes, shapes[-1], scene, 0.09 / scale)
    # A bar of a round length, and what is drawn larger.
    length = nice_floor(0.28 * float(room[0]) / scale)
    unit = length_unit(1.001 * length)  # just below a power of ten
    ends, up = [left, left + scale * length / _WIDTH], 0.1 / _HEIGHT
    bar: dict[str, Any] = {"clip_on": False, "solid_capstyle": "butt", "transform": figure.transFigure}
    axes.plot(ends, [up, up], color=style.BLACK, lw=1.2, **bar)
    note = f"{length / unit.size:g} {unit.symbol}" + (f", {larger}" if str(larger) else "")
    figure.text(ends[1] + 0.02, up, note, va="center", fontsize=7.5, color=style.GREY)
    return figure


def _draw_supports(axes: Axes, shape: Shape, scene: Scene, size: float) -> None:
    """What holds the ends: a wall for a clamp, a dot for a pin, nothing for a free end."""
    for place, support in zip((0, -1), scene.ends.supports, strict=True):
        x, y = float(shape.section.x[place]), float(shape.section.y[place])
        if support.carries_moment:
            left = x - size if place == 0 else x
            tall = max(0.11 * float(np.ptp(axes.get_ylim())), 0.65 * float(shape.section.thickness[place]))
            axes.fill_between([left, left + size], y - tall, y + tall, color=style.GREY, lw=0, zorder=5)
        elif not support.is_free:
            axes.plot([x], [y], "o", ms=4.5, mfc="white", mec=style.BLACK, mew=0.9, zorder=6, clip_on=False)


NOTE = (
    "Each run once, at the program's first guess of cells and fibres and without an estimate of its error; "
    "softcat run NAME -o DIR gives the answer to the accuracy that the scene asks for, with the estimate. "
    "Earlier shapes are paler; what yields is orange."
)


def gallery_report(shown: Sequence[tuple[Row, Run]], changes: Sequence[str] = ()) -> Report:
    """Page, contact sheet, table and document, and of each scene its picture and its file."""
    rows = [row for row, _ in shown]
    pictures = {row["name"]: png(tile(run, row)) for row, run in shown}
    texts = {name: load_scene(name, changes).to_toml() if changes else bundled_text(name) for name in pictures}
    captions = {row["name"]: f"{row['name']}: {row['title']}. {row['lesson']}" for row in rows}
    spent = significant(sum(row["wall_s"] for row in rows))
    note = f"{len(shown)} scene{'s' if len(shown) > 1 else ''}, run in {spent} s. {NOTE}"
    contents: dict[str, object] = {
        "gallery.png": contact_sheet(list(pictures.values())),
        "gallery.csv": pd.DataFrame(rows),
        "gallery.json": json_bytes({"note": NOTE, "scenes": rows}, is_ascii=False),
    }
    for name, picture in pictures.items():
        contents |= {f"{name}.png": picture, f"{name}.toml": texts[name]}
    return Report(contents, [Text(note, style="dim")], "The bundled scenes", "gallery.html", captions)


def contact_sheet(pictures: Sequence[bytes], columns: int = 5) -> bytes:
    """Put pictures of one size side by side, row by row."""
    from matplotlib.image import imread, imsave

    tiles: list[NDArray[np.float32]] = [imread(io.BytesIO(content), format="png")[..., :3] for content in pictures]
    columns = min(columns, len(tiles))
    tiles += [np.ones_like(tiles[0])] * (-len(tiles) % columns)
    rows = [np.concatenate(tiles[k : k + columns], axis=1) for k in range(0, len(tiles), columns)]
    content = io.BytesIO()
    imsave(content, np.concatenate(rows), format="png")
    return content.getvalue()
