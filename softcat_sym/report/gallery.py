"""Files of the gallery: a picture and a file a scene, one page, one contact sheet, a table and a document."""

from __future__ import annotations

import base64
import csv
import io
import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields
from html import escape
from importlib import resources
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.files import write_all
from softcat_sym.report.canvas import png
from softcat_sym.report.gallery_tile import tile
from softcat_sym.report.units import length_unit, significant, time_unit
from softcat_sym.study.gallery import Exhibit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from softcat_sym.study.gallery import Asked
    from softcat_sym.trajectory import Trajectory

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
    """Read what an earlier gallery in this folder has finished, by name.

    Parameters
    ----------
    directory : str or pathlib.Path
        Of the gallery; need not exist.

    Returns
    -------
    dict of str to Exhibit
        Those whose picture is still there. What cannot be read is not kept, and is run again.
    """
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
    """Write picture and scene file of the scene that was just run, and the document of all that are finished.

    Parameters
    ----------
    asked : Asked
        The scene.
    trajectory : Trajectory
        Its run.
    done : mapping of str to Exhibit
        All finished so far, by name, this one among them.
    directory : str or pathlib.Path
        Made if missing.

    Raises
    ------
    OSError
        If the directory cannot be made or written; then none of them is.
    """
    contents = {
        f"{asked.name}.png": png(tile(trajectory.data, trajectory.scene, done[asked.name])),
        f"{asked.name}.toml": asked.text.encode(),
        DOCUMENT: _document(done),
    }
    write_all(directory, contents)


def write_gallery(done: Mapping[str, Exhibit], directory: str | Path) -> list[Path]:
    """Write page, contact sheet, table and document over scenes whose pictures are in the folder.

    Parameters
    ----------
    done : mapping of str to Exhibit
        By name; at least one.
    directory : str or pathlib.Path
        Where :func:`write_exhibit` has put the pictures.

    Returns
    -------
    list of pathlib.Path
        ``gallery.html``, ``gallery.png``, ``gallery.csv``, ``gallery.json``.

    Raises
    ------
    OSError
        If a picture cannot be read, or the files cannot be written.
    """
    folder = Path(directory)
    exhibits = [done[name] for name in sorted(done)]
    pictures = {one.name: (folder / f"{one.name}.png").read_bytes() for one in exhibits}
    texts = {one.name: (folder / f"{one.name}.toml").read_text(encoding="utf-8") for one in exhibits}
    contents = {
        "gallery.html": _page(exhibits, pictures, texts),
        "gallery.png": contact_sheet(list(pictures.values())),
        "gallery.csv": _table(exhibits),
        DOCUMENT: _document(done),
    }
    return write_all(folder, contents)


def contact_sheet(pictures: Sequence[bytes], columns: int = _COLUMNS) -> bytes:
    """Put pictures of one size side by side, row by row.

    Parameters
    ----------
    pictures : sequence of bytes
        PNG files, at least one.
    columns : int
        In a row.

    Returns
    -------
    bytes
        A PNG file.
    """
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
    return (json.dumps({"note": NOTE, "scenes": rows}, indent=2, allow_nan=False, ensure_ascii=False) + "\n").encode()


def _table(exhibits: Sequence[Exhibit]) -> bytes:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_NAMES)
    writer.writerows(["" if value is None else value for value in asdict(one).values()] for one in exhibits)
    return text.getvalue().encode()


def _page(exhibits: Sequence[Exhibit], pictures: Mapping[str, bytes], texts: Mapping[str, str]) -> bytes:
    folder = resources.files("softcat_sym.report") / "templates"
    template = Template((folder / "gallery.html").read_text(encoding="utf-8"))
    cards = "\n".join(_card(one, pictures[one.name], texts[one.name]) for one in exhibits)
    spent = significant(sum(one.wall for one in exhibits))
    subtitle = f"{len(exhibits)} scene{'s' if len(exhibits) > 1 else ''}, run in {spent} s"
    return template.substitute(subtitle=escape(subtitle), note=escape(NOTE), cards=cards).encode()


def _card(one: Exhibit, picture: bytes, text: str) -> str:
    data = base64.b64encode(picture).decode()
    ruler, clock = length_unit(one.span), time_unit(one.duration)
    facts = f"{one.law} · span {ruler.text(one.span)} · {clock.text(one.duration)}"
    name = escape(one.name)
    return (
        f'<article id="{name}">\n'
        f'<img src="data:image/png;base64,{data}" alt="{name}: {escape(one.title)}">\n'
        f"<h2>{escape(one.title)}</h2>\n<p>{escape(one.lesson)}</p>\n"
        f'<p class="grey">{escape(facts)}</p>\n<pre>softcat run {name} -o out</pre>\n'
        f"<details><summary>{name}.toml</summary><pre>{escape(text)}</pre></details>\n</article>"
    )
