"""From the estimated errors of a run to the resolution that meets the accuracy asked."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable
from dataclasses import replace

from softcat_sym.accuracy.companions import FIBRES, SECTION_ORDER, Differences
from softcat_sym.accuracy.resolution import Resolution
from softcat_sym.scene import Scene

AIM = 0.8
"""Share of the accuracy that the estimated error is to come down to: extrapolated, it is a little wrong."""

WORTH = 0.9
"""Share of the error that must be left at most, where the accuracy is out of reach, for another run to be worth it."""

MOST_CELLS, MOST_FIBRES, LEAST_RTOL = 1280, 64, 1e-11

MOST_POINTS = 32_000
"""Cells times fibres: what a filament of so many points takes is a matter of minutes, and is not begun unasked."""

_FORETOLD_ORDER = 1.6
"""Of the grid, as an estimated error falls with more cells: one that is far from its order falls more slowly."""

_LEAP = 8.0
"""At most so many times as many cells at once: an error far from its order foretells badly."""

_TIGHTEST = 64.0
"""At most so much tighter at once."""

_STEPS = 0.2
"""The number of steps goes with the tolerance to minus this power, of a method of fifth order."""

_STATES = 6
"""Unknowns of a cell that are no fibre's, counted in fibres: there are two of each."""

_COMPILING = 1000.0
"""Time in which the library for another number of fibres is compiled, a second whatever their number."""


def refined(at: Resolution, found: Differences, scene: Scene, grading: Callable[[int], float]) -> Resolution:
    """What to run next: of all that should be accurate enough, by the order of each error, the cheapest.

    The same resolution where nothing that the program may choose would help.

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
    aim = AIM * scene.run.accuracy
    tried = [
        replace(at, cells=cells, fibres=fibres, rtol=rtol)
        for cells, fibres, rtol in itertools.product(_cells(at, scene), _fibres(at, scene), _tolerances(at, scene))
        if fibres is None or cells == at.cells or cells * fibres <= MOST_POINTS
    ]
    best = min(_foretold(one, at, found) for one in tried)
    if best > WORTH * found.total:
        return at
    enough = [one for one in tried if _foretold(one, at, found) <= max(aim, best / WORTH)]
    now = min(enough, key=lambda one: _cost(one, at))
    return now if now.cells == at.cells else replace(now, grading=grading(now.cells))


def _cells(at: Resolution, scene: Scene) -> Iterable[int]:
    """Numbers of cells to choose from, an eighth of an octave apart."""
    if scene.numerics.cells is not None:
        return (at.cells,)
    eighths = range(1, round(8 * math.log2(_LEAP)) + 1)
    more = {min(MOST_CELLS, math.ceil(at.cells * 2 ** (k / 8))) for k in eighths}
    return (at.cells, *sorted(n for n in more if n > at.cells))


def _fibres(at: Resolution, scene: Scene) -> Iterable[int | None]:
    numerics = scene.numerics
    if at.fibres is None or numerics.fibres is not None or numerics.order is not None:
        return (at.fibres,)
    return (at.fibres, *(n for n in FIBRES if at.fibres < n <= MOST_FIBRES))


def _tolerances(at: Resolution, scene: Scene) -> Iterable[float]:
    if scene.numerics.rtol is not None:
        return (at.rtol,)
    tighter = (at.rtol / 2**k for k in range(1, round(math.log2(_TIGHTEST)) + 1))
    return (at.rtol, *(rtol for rtol in tighter if rtol >= LEAST_RTOL))


def _foretold(one: Resolution, at: Resolution, found: Differences) -> float:
    """Estimated error at a resolution, from that at another."""
    space, time, section = (part or 0.0 for part in (found.space, found.time, found.section))
    coarser, fewer = at.cells / one.cells, (at.fibres or 1) / (one.fibres or 1)
    return float(space * coarser**_FORETOLD_ORDER + time * one.rtol / at.rtol + section * fewer**SECTION_ORDER)


def _cost(one: Resolution, at: Resolution) -> float:
    """Time that a resolution takes, in that of a cell with one fibre."""
    fibres = one.fibres or 0
    steps = float((at.rtol / one.rtol) ** _STEPS)
    compiling = _COMPILING if one.fibres != at.fibres else 0.0
    return float(one.cells * (fibres + _STATES) * steps + compiling)
