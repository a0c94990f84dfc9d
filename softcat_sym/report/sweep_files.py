"""The files beside the store of a sweep: its record, its scene, a picture, and a page with sliders."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.files import write_all
from softcat_sym.report import style
from softcat_sym.report.canvas import png

if TYPE_CHECKING:
    from softcat_sym.study.sweep import Sweep

PICTURE, PAGE = "sweep.png", "sliders.html"


def write_sweep(sweep: Sweep, directory: str | Path) -> list[Path]:
    """Write ``sweep.json``, ``scene.toml``, ``sweep.png`` and, with shapes, ``sliders.html``.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.

    Parameters
    ----------
    sweep : Sweep
        Finished; its store is in `directory` already.
    directory : str or pathlib.Path
        Where the files go.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    contents = {
        "sweep.json": (json.dumps(sweep.summary(), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": sweep.plan.scene.to_toml().encode(),
    }
    picture = sweep_picture(sweep)
    if picture is not None:
        contents[PICTURE] = picture
    if sweep.plan.shapes and sweep.counts.outcomes.get("solved"):
        from softcat_sym.report.sliders import sliders_page

        contents[PAGE] = sliders_page(sweep.data, _title(sweep)).encode()
    return write_all(directory, contents)


def sweep_picture(sweep: Sweep) -> bytes | None:
    """A line over one key, a map over two on a grid, pairs of more; None if no key takes two values."""
    from softcat_sym.report.sweep_axes import drawn_axes
    from softcat_sym.report.sweep_line import line_figure
    from softcat_sym.report.sweep_map import map_figure
    from softcat_sym.report.sweep_pairs import pairs_figure

    data, title = sweep.data, f"{_title(sweep)}: {len(sweep)} filaments"
    axes = drawn_axes(data)
    if not axes:
        return None
    if len(axes) == 1:
        return png(line_figure(data, title))
    whole = all(np.all(np.isfinite(axis.values)) for axis in axes)
    if len(axes) == 2 and sweep.plan.mode == "grid" and len(sweep.plan.axes) == 2 and whole:
        return png(map_figure(data, title))
    return png(pairs_figure(data, title))


def _title(sweep: Sweep) -> str:
    return style.printable(sweep.plan.scene.title, 64) or "Sweep"
