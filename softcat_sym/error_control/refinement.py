"""What to run next: of all that should be accurate enough the cheapest, until nothing that may be chosen would help."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.error_control.estimate import (
    FIBRE_NUMBERS,
    SECTION_ORDER,
    Before,
    Differences,
    Judge,
    Resolution,
    Runner,
    differences,
)
from softcat_sym.results.observed import Series
from softcat_sym.scene.scene import Scene

AIM = 0.8
"""Share of the accuracy that the estimated error is to come down to: extrapolated, it is a little wrong."""

WORTH = 0.9
"""Share of the error that must be left at most, where the accuracy is out of reach, for another run to be worth it."""

MAX_CELLS, MAX_FIBRES, MIN_RTOL = 1280, 64, 1e-11

MAX_POINTS = 32_000
"""Cells times fibres: what a filament of so many points takes is a matter of minutes, and is not begun unasked."""

EXPECTED_ORDER = 1.6
"""Of the grid, as an estimated error falls with more cells: one that is far from its order falls more slowly."""

_LEAP, _TIGHTEST = 8, 64
"""At most so many times as many cells, and so much tighter, at once: an error far from its order foretells badly."""

_STEPS = 0.2
"""The number of steps goes with the tolerance to minus this power, of a method of fifth order."""

STATES = 6
"""Unknowns of a cell that are no fibre's, counted in fibres: there are two of each."""

ROUNDS = 4
"""Runs that are tried, the first included."""


def refined(at: Resolution, found: Differences, scene: Scene, grading: Callable[[int], float]) -> Resolution:
    """What to run next: of all that should be accurate enough, by the order of each error, the cheapest.

    The same resolution where nothing that the program may choose would help.
    """
    numerics = scene.numerics
    cells, fibres, tolerances = [at.cells], [at.fibres or 0], [at.rtol]
    if numerics.cells is None:
        # An eighth of an octave apart.
        more = {min(MAX_CELLS, math.ceil(at.cells * 2 ** (k / 8))) for k in range(1, 8 * round(math.log2(_LEAP)) + 1)}
        cells += sorted(n for n in more if n > at.cells)
    if at.fibres is not None and numerics.fibres is None and numerics.order is None:
        fibres += [n for n in FIBRE_NUMBERS if at.fibres < n <= MAX_FIBRES]
    if numerics.rtol is None:
        tighter = (at.rtol / 2**k for k in range(1, round(math.log2(_TIGHTEST)) + 1))
        tolerances += [rtol for rtol in tighter if rtol >= MIN_RTOL]
    n, through, rtol = (axis.ravel() for axis in np.meshgrid(cells, fibres, tolerances, indexing="ij"))
    expected = errors_expected(at, found, n, through, rtol)
    # Time that a resolution takes, in that of a cell with one fibre.
    cost = n * (through + STATES) * (at.rtol / rtol) ** _STEPS
    allowed = (n == at.cells) | (n * through <= MAX_POINTS)
    best = float(np.min(expected[allowed]))
    if best > WORTH * found.total:
        return at
    enough = allowed & (expected <= max(AIM * scene.run.accuracy, best / WORTH))
    now = int(np.argmin(np.where(enough, cost, np.inf)))
    if n[now] == at.cells:
        return replace(at, fibres=int(through[now]) or None, rtol=float(rtol[now]))
    finer = int(n[now])
    return replace(at, cells=finer, grading=grading(finer), fibres=int(through[now]) or None, rtol=float(rtol[now]))


def errors_expected(at: Resolution, found: Differences, cells: Floats, fibres: Floats, rtol: Floats) -> Floats:
    """Error of other resolutions, by the order of each part; no fibres are 0."""
    space, time, section = (part or 0.0 for part in (found.space, found.time, found.section))
    fewer = (at.fibres or 1) / np.maximum(fibres, 1)
    return space * (at.cells / cells) ** EXPECTED_ORDER + time * rtol / at.rtol + section * fewer**SECTION_ORDER


@dataclass(frozen=True)
class Controlled:
    """How the loop ended."""

    resolution: Resolution  # Of the answer
    found: Differences | None  # Its estimated errors; None if the answer itself is not to be trusted
    refinements: tuple[str, ...]  # What was made finer, and why, run by run


def controlled(
    scene: Scene,
    first: Resolution,
    answer: Runner,
    companion: Runner,
    grading: Callable[[int], float],
    judged: Callable[[Series], Judge],
) -> Controlled:
    """Run until the estimated error is below the accuracy asked, or nothing that may be chosen would help."""
    at, refinements, before = first, list[str](), None
    for left in reversed(range(ROUNDS)):
        seen = answer(at)
        if seen is None:
            return Controlled(at, None, tuple(refinements))
        found = differences(seen, at, companion, judged(seen), scene.run.accuracy, before)
        following = refined(at, found, scene, grading)
        if found.total <= scene.run.accuracy or following == at or not left:
            break
        changes = (
            ("cells", at.cells, following.cells),
            ("fibres", at.fibres, following.fibres),
            ("rtol", f"{at.rtol:.2g}", f"{following.rtol:.2g}"),
        )
        finer = ", ".join(f"{old} -> {new} {name}" for name, old, new in changes if old != new)
        refinements.append(f"{finer}: estimated error {found.total:.2g} against {scene.run.accuracy:g}")
        at, before = following, Before(at, found)
    return Controlled(at, found, tuple(refinements))
