"""A sweep as one page with parallel sliders: it needs no server, no network and no other file."""

from __future__ import annotations

import json
import re
from html import escape
from importlib import resources
from typing import TYPE_CHECKING

from softcat_sym.report.sliders_data import packed

if TYPE_CHECKING:
    import xarray as xr

_SCRIPTS = ("sliders_data.js", "sliders_axes.js", "sliders_filament.js", "sliders.js")
"""In the order in which they need one another."""


def sliders_page(dataset: xr.Dataset, title: str) -> str:
    """Write the page of a sweep: an axis for each varied parameter, with a handle, and one for each result.

    Dragging a handle chooses the member that is nearest; its filament, its midpoint and its numbers are shown below.

    Parameters
    ----------
    dataset : xarray.Dataset
        A sweep, with dims ``member``, ``frame`` and, if shapes were kept, ``shape_frame`` and ``shape_node``. Varied
        keys have the attribute ``varied = 1``, and ``scale`` ("lin" or "log"); results are ``regime``, ``outcome``,
        ``message``, ``sag_over_span``, ``time_to_90`` [s], ``largest_stretch``, ``midpoint`` [m], ``x``, ``y`` [m],
        ``stretch``. What is missing is not shown.
    title : str
        Heading; any text.

    Returns
    -------
    str
        HTML. Midpoints and shapes are rounded to 1/65534 of each member's range.

    Raises
    ------
    ValueError
        If there is no member, or nothing was varied.
    """
    folder = resources.files("softcat_sym.report") / "templates"

    def read(name: str) -> str:
        return (folder / name).read_text(encoding="utf-8")

    # In a script element only "<" can end the element; JSON may write it otherwise.
    data = json.dumps(packed(dataset), allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
    parts = {
        "TITLE": escape(" ".join(title.split()) or "Sweep"),
        "STYLE": read("sliders.css"),
        "SCRIPT": "\n".join(read(name) for name in _SCRIPTS),
        "DATA": data,
    }
    # In one pass: a title that looks like a mark stays a title.
    return re.sub("@(TITLE|STYLE|SCRIPT|DATA)@", lambda mark: parts[mark[1]], read("sliders.html"))
