"""Tables of image trackers, in frames and pixels, converted to the columns that the reader of films accepts.

Comments of a file in pixels state the size of a pixel and the position of the supports::

    # camera.fps = 240
    # camera.pixel = 0.05 mm
    # camera.origin = 640 212      the pixel halfway between the supports, at their level
    # camera.release = 12          frame of the release, 0 by default
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.errors import Fault
from softcat_sym.scene.csv_reader import CsvTable, number_in
from softcat_sym.scene.units import NotAQuantity, shown, to_si

_KEYS = {
    "fps": "camera.fps = 240",
    "pixel": "camera.pixel = 0.05 mm",
    "origin": "camera.origin = 640 212",
    "release": "camera.release = 12",
}
_DLTDV = re.compile(r"pt\d+(?:_cam\d+)?_[XY]", re.IGNORECASE)
_LIKELY = 0.6
"""Smallest likelihood of DeepLabCut at which a point is kept."""


@dataclass(frozen=True)
class Camera:
    """Conversion of frames into seconds and of pixels into metres."""

    fps: float | None = None  # [1/s]
    pixel: float | None = None  # Length of a pixel [m]
    origin: tuple[float, float] = (0.0, 0.0)  # Pixel halfway between the supports, at their level
    release: float = 0.0  # Frame of the release


def comments_in(text: str, table: str) -> Iterator[tuple[str, str, str]]:
    """Yield place, key and value of each comment ``# table.key = value``."""
    line_of = re.compile(rf"#\s*{table}\.(?P<key>\w+)\s*=\s*(?P<value>[^#]*)")
    for number, line in enumerate(text.splitlines(), start=1):
        if match := line_of.match(line.strip()):
            # A spreadsheet ends a short line with the separators of its empty cells.
            yield f"line {number}, {table}.{match['key']}", match["key"], match["value"].strip().rstrip(",;\t ")


def camera_in(text: str) -> tuple[Camera, list[Fault]]:
    """Read the comments about the camera; comments of other programs are ignored."""
    found, faults = dict[str, list[float]](), list[Fault]()
    for where, key, value in comments_in(text, "camera"):
        if key not in _KEYS:
            continue
        found[key] = [_or_nan(part) for part in value.replace(",", " ").split()]
        try:
            if key == "pixel":
                found[key] = [to_si(value, "length", "m")]
            elif key == "fps" and len(found[key]) != 1:
                found[key] = [to_si(value, "frequency", "Hz")]
        except NotAQuantity as error:
            faults.append(Fault(where, str(error), _KEYS[key]))
            continue
        count = 2 if key == "origin" else 1
        wrong = len(found[key]) != count or not np.all(np.isfinite(found[key]))
        if wrong or (key in ("fps", "pixel") and found[key][0] <= 0):
            faults.append(Fault(where, shown(value), _KEYS[key]))
    if faults:
        return Camera(), faults
    single = {key: values[0] for key, values in found.items() if key != "origin"}
    if "origin" not in found:
        return Camera(**single), []  # type: ignore[arg-type]
    return Camera(**single, origin=(found["origin"][0], found["origin"][1])), []


def in_rows(table: CsvTable) -> tuple[CsvTable, str]:
    """Convert a tracker's table to one point a row with a film's column names; return it with the tracker's name."""
    names = [name.strip().lower() for name in table.header]
    if names[0] == "scorer":
        return _deep_lab_cut(table)
    if "position_x" in names and "position_y" in names:
        return _track_mate(table, names)
    if all(_DLTDV.fullmatch(name) for name in names if name) and any(names):
        return _by_pairs(table, ["frame", "x_px", "y_px"], list(range(0, len(names) - 1, 2)), 2), "DLTdv"
    known = {"slice": "frame", "frame": "frame", "frames": "frame"}
    header = [known.get(name, given) for name, given in zip(names, table.header, strict=True)]
    return replace(table, header=header), ""


def _by_pairs(table: CsvTable, header: list[str], places: list[int], width: int, first: int | None = None) -> CsvTable:
    """One row for each point of each frame; frames are counted from 0 where no column names them."""
    rows = []
    for number, (line, cells) in enumerate(table.rows):
        frame = str(number) if first is None else cells[first]
        for place in places:
            point = cells[place : place + width]
            # A point that the tracker did not find gives no row.
            if len(point) == width and all(np.isfinite(_or_nan(cell)) for cell in point):
                rows.append((line, [frame, *point]))
    return replace(table, header=header, rows=rows)


def _or_nan(cell: str) -> float:
    value = number_in(cell)
    return np.nan if value is None else value


def _deep_lab_cut(table: CsvTable) -> tuple[CsvTable, str]:
    """Convert a table with header lines of scorer, (individuals,) body parts and coordinates, then a frame a row."""
    count = next((k for k, (_, cells) in enumerate(table.rows) if cells[0].lower() == "coords"), None)
    if count is None:
        return table, ""
    coordinates = [cell.lower() for cell in table.rows[count][1]]
    frames = replace(table, rows=table.rows[count + 1 :])
    places = [k for k, name in enumerate(coordinates) if name == "x"]
    points = _by_pairs(frames, ["frame", "x_px", "y_px", "likelihood"], places, 3, first=0)
    seen = [(line, cells) for line, cells in points.rows if float(cells[3]) >= _LIKELY]
    dropped = len(points.rows) - len(seen)
    note = f"DeepLabCut: left out {dropped} points with a likelihood below {_LIKELY}" if dropped else "DeepLabCut"
    return replace(points, rows=seen), note


def _track_mate(table: CsvTable, names: list[str]) -> tuple[CsvTable, str]:
    """Convert a table with three more lines of names and units below the header."""
    begun = next((k for k, (_, c) in enumerate(table.rows) if number_in(c[names.index("position_x")]) is not None), 0)
    units: Mapping[str, str] = {}
    if begun:
        below = table.rows[begun - 1][1]
        units = {name: cell.strip("()").lower() for name, cell in zip(names, below, strict=False)}
    length = {"micron": "um", "pixel": "px", "": "px"}.get(units.get("position_x", ""), units.get("position_x", "px"))
    clock = {"sec": "s", "frame": ""}.get(units.get("position_t", ""), units.get("position_t", ""))
    renamed = {"position_x": f"x_{length}", "position_y": f"y_{length}", "frame": "frame"}
    renamed |= {"position_t": f"time_{clock}"} if clock else {}
    header = [renamed.get(name, given) for name, given in zip(names, table.header, strict=True)]
    return replace(table, header=header, rows=table.rows[begun:]), "TrackMate"
