"""Files of the gallery: a picture and a file a scene, one page, one contact sheet, a table."""

from __future__ import annotations

import io
import json
import math
from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from softcat_sym.plotting import style
from softcat_sym.plotting.files import csv_bytes, json_bytes, page, write_results
from softcat_sym.plotting.run import Shape, largest_sag, shapes_of
from softcat_sym.plotting.section import telling_frames, vertical_stretch
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.plotting.units import length_unit, nice_floor, significant, time_unit
from softcat_sym.studies.gallery import Exhibit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from softcat_sym.results.trajectory import Trajectory
    from softcat_sym.scene.scene import Scene
    from softcat_sym.studies.gallery import Asked

_WIDTH, _HEIGHT, _TEXT, _FOOT, _SIDE = 3.0, 2.3, 0.50, 0.26, 0.14
"""Size of a tile, and its margins [inch]."""

_DEEPEST = 1.6
"""A run that is drawn without end is shown until it hangs this many spans deep."""


def tile(data: xr.Dataset, scene: Scene, exhibit: Exhibit) -> Figure:
    """Draw a scene of the gallery.

    Lengths are equal along both axes, unless the sag is too flat to see: then the picture says by how much it is
    stretched. A bar tells the scale.
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
        stretch = vertical_stretch(largest_sag(shapes), scene.filament.thickness, scene.filament.span)
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


DOCUMENT = "gallery.json"
_COLUMNS = 5
_UNITS = {
    "span": "span_m",
    "thickness": "thickness_m",
    "duration": "duration_s",
    "sag_final": "sag_final_m",
    "sag_largest": "sag_largest_m",
    "wall": "wall_s",
}
_NAMES = {_UNITS.get(one.name, one.name): one.name for one in fields(Exhibit)}
NOTE = (
    "Each run once, at the program's first guess of cells and fibres and without an estimate of its error; "
    "softcat run NAME -o DIR gives the answer to the accuracy that the scene asks for, with the estimate."
)


def kept_exhibits(directory: str | Path) -> dict[str, Exhibit]:
    """Read what an earlier gallery in this folder has finished, by name."""
    folder, kept = Path(directory), dict[str, Exhibit]()
    try:
        rows = json.loads((folder / DOCUMENT).read_text(encoding="utf-8"))["scenes"]
        for row in rows:
            exhibit = Exhibit(**{_NAMES[key]: value for key, value in row.items()})
            if (folder / f"{exhibit.name}.png").is_file():
                kept[exhibit.name] = exhibit
    except (OSError, ValueError, KeyError, TypeError):
        # No document, or another program's.
        return {}
    return kept


def write_exhibit(asked: Asked, trajectory: Trajectory, done: Mapping[str, Exhibit], directory: str | Path) -> None:
    """Write picture and scene file of the scene that was just run, and the document of all that are finished."""
    contents = {
        f"{asked.name}.png": tile(trajectory.data, trajectory.scene, done[asked.name]),
        f"{asked.name}.toml": asked.text,
        DOCUMENT: _document(done),
    }
    write_results(directory, contents)


def write_gallery(done: Mapping[str, Exhibit], directory: str | Path) -> list[Path]:
    """Write page, contact sheet, table and document over scenes whose pictures are in the folder."""
    folder = Path(directory)
    exhibits = [done[name] for name in sorted(done)]
    pictures = {one.name: (folder / f"{one.name}.png").read_bytes() for one in exhibits}
    texts = {one.name: (folder / f"{one.name}.toml").read_text(encoding="utf-8") for one in exhibits}
    contents = {
        "gallery.html": _page(exhibits, pictures, texts),
        "gallery.png": contact_sheet(list(pictures.values())),
        "gallery.csv": csv_bytes(_NAMES, (asdict(one).values() for one in exhibits)),
        DOCUMENT: _document(done),
    }
    return write_results(folder, contents)


def contact_sheet(pictures: Sequence[bytes], columns: int = _COLUMNS) -> bytes:
    """Put pictures of one size side by side, row by row."""
    from matplotlib.image import imread, imsave

    tiles: list[NDArray[np.float32]] = [imread(io.BytesIO(one), format="png")[..., :3] for one in pictures]
    columns = min(columns, len(tiles))
    height, width, _ = tiles[0].shape
    sheet = np.ones((math.ceil(len(tiles) / columns) * height, columns * width, 3), dtype=np.float32)
    for k, one in enumerate(tiles):
        row, column = divmod(k, columns)
        sheet[row * height : (row + 1) * height, column * width : (column + 1) * width] = one
    content = io.BytesIO()
    imsave(content, sheet, format="png")
    return content.getvalue()


def _document(done: Mapping[str, Exhibit]) -> bytes:
    rows = [{_UNITS.get(key, key): value for key, value in asdict(done[name]).items()} for name in sorted(done)]
    return json_bytes({"note": NOTE, "scenes": rows}, is_ascii=False)


def _page(exhibits: Sequence[Exhibit], pictures: Mapping[str, bytes], texts: Mapping[str, str]) -> bytes:
    spent = significant(sum(one.wall for one in exhibits))
    cards = [(one, _facts(one), b64encode(pictures[one.name]).decode(), texts[one.name]) for one in exhibits]
    subtitle = f"{len(exhibits)} scene{'s' if len(exhibits) > 1 else ''}, run in {spent} s"
    return page("gallery.html", title="softcat scenes", subtitle=subtitle, note=NOTE, cards=cards)


def _facts(one: Exhibit) -> str:
    return f"{one.law} · span {length_unit(one.span).text(one.span)} · {time_unit(one.duration).text(one.duration)}"
