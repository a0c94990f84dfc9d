"""A lattice of labels, known only where neighbours differ: coarse squares, bisected along the boundaries."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Node = tuple[int, int]
Label = Callable[[Sequence[Node]], Sequence[str]]

COARSEST = 8
"""Least number of squares along an axis to begin with: what is smaller than such a square may be missed."""


@dataclass(frozen=True, slots=True)
class Square:
    """Lower left node and width, in lattice steps."""

    i: int
    j: int
    width: int

    def corners(self) -> tuple[Node, Node, Node, Node]:
        """Its four nodes."""
        i, j, w = self.i, self.j, self.width
        return (i, j), (i + w, j), (i, j + w), (i + w, j + w)

    def quarters(self) -> tuple[Square, ...]:
        """Four squares of half the width."""
        half = self.width // 2
        return tuple(Square(i, j, half) for i in (self.i, self.i + half) for j in (self.j, self.j + half))


@dataclass(frozen=True)
class RefinedLattice:
    """Labels of a lattice.

    Attributes
    ----------
    cells : int
        Lattice squares along each axis.
    known : dict of (int, int) to str
        Labels that were asked for.
    squares : tuple of Square
        What tiles the plane: one step wide where corners differ, wider elsewhere.
    """

    cells: int
    known: dict[Node, str]
    squares: tuple[Square, ...]

    @property
    def saved(self) -> int:
        """Nodes whose label was never asked for."""
        return (self.cells + 1) ** 2 - len(self.known)

    def labels(self) -> npt.NDArray[np.str_]:
        """The label of every node, shape (cells + 1, cells + 1); in a wide square it is that of its corners."""
        longest = max(map(len, self.known.values()))
        filled = np.zeros((self.cells + 1, self.cells + 1), dtype=f"<U{longest}")
        for square in self.squares:
            if square.width > 1:
                i, j, w = square.i, square.j, square.width
                filled[i : i + w + 1, j : j + w + 1] = self.known[square.corners()[0]]
        for node, label in self.known.items():
            filled[node] = label
        return filled


def coarse_width(cells: int) -> int:
    """Width of the first squares in lattice steps: the largest power of two that leaves `COARSEST` along an axis."""
    width = 1
    while cells % (2 * width) == 0 and cells // (2 * width) >= COARSEST:
        width *= 2
    return width


def refined(cells: int, label: Label) -> RefinedLattice:
    """Label a lattice, looking closely only along the boundaries.

    Every square on whose edge or inside two known labels differ is cut in four, down to one lattice step.

    Parameters
    ----------
    cells : int
        Lattice squares along each axis. Divided by two for as long as that leaves `COARSEST`, it gives the first ones.
    label : callable
        Labels of nodes, asked for many at a time and for each node once.
    """
    width = coarse_width(cells)
    squares = [Square(i, j, width) for i in range(0, cells, width) for j in range(0, cells, width)]
    known: dict[Node, str] = {}
    _ask(squares, known, label)
    while True:
        cut = [square for square in squares if square.width > 1 and _differs(square, known)]
        if not cut:
            return RefinedLattice(cells, known, tuple(squares))
        quarters = [quarter for square in cut for quarter in square.quarters()]
        gone = set(cut)
        squares = [square for square in squares if square not in gone] + quarters
        _ask(quarters, known, label)


def _ask(squares: Sequence[Square], known: dict[Node, str], label: Label) -> None:
    nodes = sorted({node for square in squares for node in square.corners()} - known.keys())
    if nodes:
        known.update(zip(nodes, label(nodes), strict=True))


def _differs(square: Square, known: dict[Node, str]) -> bool:
    """Whether two known nodes of a square differ; a finer neighbour may know nodes on its edges."""
    i, j, w = square.i, square.j, square.width
    nodes = ((i + a, j + b) for a in range(w + 1) for b in range(w + 1))
    return len({known[node] for node in nodes if node in known}) > 1
