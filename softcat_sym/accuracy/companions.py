"""Runs beside the answer that tell how far it may be off: a coarser grid, looser steps, more fibres.

Looser steps and more fibres are tried on the coarser grid, where they cost half: what they change there, they change on
the finer one too, to the accuracy that an estimate needs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.accuracy.resolution import Resolution
from softcat_sym.graph.grid import Floats

Runner = Callable[[Resolution], Floats | None]
"""Midpoint over the run at a resolution, shape (frames,); None where that run has no answer."""

ORDER = 2
"""Of the grid: differences and averages are central."""

LOOSER = 8.0
"""Factor of the tolerance; the error of the time steps grows by five to twenty times with it, so about as much."""

MORE = 1.5
"""Factor of the fibres: fewer than half as many again may be as wrong in the same direction."""

FIBRES = (8, 12, 16, 24, 32, 48, 64, 96)
"""Numbers of fibres that are tried."""

SECTION_ORDER = 2
"""Of the fibres: where a section yields from its surface inwards, the edge lies between two of them."""

_FEWEST_CELLS = 4


@dataclass(frozen=True)
class Differences:
    """Estimated errors of one run, as in :class:`softcat_sym.accuracy.ErrorEstimate`, and what could not be had.

    Attributes
    ----------
    space, time, section : float or None
        Relative to the largest midpoint.
    failed : tuple of str
        Companions that have no answer.
    """

    space: float | None
    time: float | None
    section: float | None
    failed: tuple[str, ...]


def differences(answer: Floats, at: Resolution, run: Runner) -> Differences:
    """Estimate the errors of an answer from its companions.

    Parameters
    ----------
    answer : ndarray, shape (frames,)
        Midpoint at the resolution `at`.
    at : Resolution
        Of the answer.
    run : Runner
        Runs a companion.
    """
    scale = float(np.max(np.abs(answer)))
    coarser = replace(at, cells=max(_FEWEST_CELLS, at.cells // 2))
    beside = run(coarser)
    if beside is None or scale == 0 or coarser.cells == at.cells:
        return Differences(None, None, None, (f"{coarser.cells} cells",))
    failed: list[str] = []

    def change(resolution: Resolution, called: str, share: float) -> float | None:
        found = run(resolution)
        if found is None:
            failed.append(called)
            return None
        return float(np.max(np.abs(found - beside))) / scale / share

    ratio = (at.cells / coarser.cells) ** ORDER
    space = float(np.max(np.abs(answer - beside))) / scale / (ratio - 1)
    looser = replace(coarser, rtol=min(LOOSER * at.rtol, 0.5))
    time = change(looser, f"a tolerance of {looser.rtol:.2g}", looser.rtol / at.rtol - 1)
    section = None
    finer = with_more_fibres(coarser, MORE)
    if finer != coarser:
        more = (finer.fibres or 1) / (coarser.fibres or 1) if finer.order is None else MORE
        section = change(finer, f"{finer.fibres or finer.order} fibres", 1 - more**-SECTION_ORDER)
    return Differences(space, time, section, tuple(failed))


def with_more_fibres(resolution: Resolution, factor: float) -> Resolution:
    """More fibres by about a factor, or a higher order; the same where the section has neither.

    Fibres come in few numbers, so that scenes share what is compiled for them.
    """
    if resolution.order is not None:
        return replace(resolution, order=max(resolution.order + 1, round(factor * resolution.order)))
    if resolution.fibres is not None:
        wanted = factor * resolution.fibres
        return replace(resolution, fibres=next((n for n in FIBRES if n >= wanted), 2 * round(wanted / 2)))
    return resolution
