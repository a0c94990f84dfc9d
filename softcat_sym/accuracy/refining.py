"""From the estimated errors of a run to the resolution that meets the accuracy asked."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from softcat_sym.accuracy.companions import LOOSER, ORDER, SECTION_ORDER, Differences, with_more_fibres
from softcat_sym.accuracy.resolution import Resolution
from softcat_sym.scene import Scene

SPACE, TIME, SECTION = 0.5, 0.1, 0.25
"""Shares of the accuracy that grid, time steps and section are given when they are refined."""

MOST_CELLS, MOST_FIBRES, LEAST_RTOL = 1280, 64, 1e-11

MOST_POINTS = 32_000
"""Cells times fibres: what a filament of so many points takes is a matter of minutes, and is not begun unasked."""

SLACK = 1.15
"""An error so close above its share is left: the shares leave that much room."""

_LEAP = 8.0
"""At most so many times as many cells at once: an error far from its order foretells badly."""

_LEAST_GAIN = 1.25  # of the number of fibres, which come in pairs


def refined(at: Resolution, found: Differences, scene: Scene, grading: Callable[[int], float]) -> Resolution:
    """What to run next; the same resolution where nothing that the program may choose would help.

    Parameters
    ----------
    at : Resolution
        Of the run that was not accurate enough.
    found : Differences
        Its errors.
    scene : Scene
        What it fixes (``numerics.cells``, ``numerics.fibres``, ``numerics.order``, ``numerics.rtol``) stays.
    grading : callable
        Ratio of the longest cell to the shortest for so many cells: at a hinge no cell may become much shorter than the
        thickness, below which a sheared section has no resistance left to necking.
    """
    accuracy, fixed, now = scene.run.accuracy, scene.numerics, at
    space, time, section = (
        _excess(found.space, SPACE * accuracy),
        _excess(found.time, TIME * accuracy),
        _excess(found.section, SECTION * accuracy),
    )
    if fixed.cells is None and space > SLACK:
        cells = math.ceil(min(_LEAP, space ** (1 / ORDER)) * at.cells)
        now = replace(now, cells=max(at.cells, min(MOST_CELLS, cells)))
    if fixed.rtol is None and time > SLACK:
        now = replace(now, rtol=min(at.rtol, max(LEAST_RTOL, at.rtol / min(LOOSER**2, time))))
    if fixed.fibres is None and fixed.order is None and at.fibres is not None and section > SLACK:
        more = with_more_fibres(now, max(_LEAST_GAIN, min(_LEAP, section ** (1 / SECTION_ORDER)))).fibres
        now = replace(now, fibres=max(at.fibres, min(MOST_FIBRES, more or MOST_FIBRES)))
    if now.fibres is not None:
        now = replace(now, cells=max(at.cells, min(now.cells, MOST_POINTS // now.fibres)))
    return now if now.cells == at.cells else replace(now, grading=grading(now.cells))


def _excess(error: float | None, share: float) -> float:
    """An error over its share of the accuracy; zero where it is not known."""
    return 0.0 if error is None else error / share
