"""Boundaries that the runs show, row by row, and how far the formulas are from them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from softcat_sym.graph.grid import Floats
from softcat_sym.study.phase_lines import Kind, PhaseLine
from softcat_sym.study.phase_runs import CLAMPS_ONLY, DESCENDING

NO_YIELD, UNDERDAMPED, OVERDAMPED = "no-yield", "arrested-underdamped", "arrested-overdamped"

_RESTS = frozenset({NO_YIELD, UNDERDAMPED, OVERDAMPED})
_SIDES: dict[str, tuple[frozenset[str], frozenset[str]]] = {
    "first yield": (frozenset({NO_YIELD}), frozenset({UNDERDAMPED, OVERDAMPED, DESCENDING, CLAMPS_ONLY})),
    "overdamping": (frozenset({UNDERDAMPED}), frozenset({OVERDAMPED})),
    "arrest": (_RESTS, frozenset({DESCENDING, CLAMPS_ONLY})),
    "arrest of the span": (_RESTS | {CLAMPS_ONLY}, frozenset({DESCENDING})),
}
_FORMULAS_OF: dict[str, tuple[Kind, ...]] = {
    "first yield": ("first yield",),
    "overdamping": ("overdamping",),
    "arrest": ("arrest",),
    "arrest of the span": ("arrest", "arrest of the span"),
}


@dataclass(frozen=True, slots=True)
class Crossing:
    """Where a row of the lattice goes from one regime to another, between two neighbouring answers.

    Attributes
    ----------
    kind : str
        Which boundary: of first yield, of underdamped arrest, of arrest in every fibre, of arrest but at the clamps.
    other : float
        delta or V of the row.
    G_low, G_high : float
        The neighbours: the boundary is between them.
    """

    kind: str
    other: float
    G_low: float
    G_high: float

    @property
    def G(self) -> float:
        """Their geometric mean."""
        return math.sqrt(self.G_low * self.G_high)


@dataclass(frozen=True)
class Distance:
    """How far one formula is from the runs.

    Attributes
    ----------
    kind : str
        Which boundary of the runs.
    line : PhaseLine
        The formula.
    rows : int
        Rows in which both are there.
    median, least, most : float
        G of the runs over that of the formula, less one.
    """

    kind: str
    line: PhaseLine
    rows: int
    median: float
    least: float
    most: float


def crossings(G: Floats, other: Floats, marks: npt.NDArray[np.str_]) -> tuple[Crossing, ...]:
    """Every crossing of a lattice.

    Parameters
    ----------
    G, other : ndarray, shape (n + 1,)
        Lattice values.
    marks : ndarray of str, shape (n + 1, n + 1)
        Regimes, or what took their place: no boundary is seen beside a run that is no answer.
    """
    found = []
    for kind, (below, above) in _SIDES.items():
        for j, value in enumerate(other):
            steps = [i for i in range(len(G) - 1) if marks[i, j] in below and marks[i + 1, j] in above]
            found += [Crossing(kind, float(value), float(G[i]), float(G[i + 1])) for i in steps]
    return tuple(found)


def distances(lines: Sequence[PhaseLine], seen: Sequence[Crossing]) -> tuple[Distance, ...]:
    """Each formula against the crossings of its kind; a row that crosses several times counts with its first."""
    found = []
    for kind, line in [(kind, line) for kind in _SIDES for line in lines if line.kind in _FORMULAS_OF[kind]]:
        first: dict[float, Crossing] = {}
        for crossing in seen:
            if crossing.kind == kind:
                first.setdefault(crossing.other, crossing)
        off = np.array([one.G / line.at(one.other) - 1 for one in first.values()])
        off = off[np.isfinite(off)]
        if len(off):
            found.append(Distance(kind, line, len(off), *map(float, (np.median(off), np.min(off), np.max(off)))))
    return tuple(found)
