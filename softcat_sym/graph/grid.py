"""The staggered grid along the filament: positions and moments on nodes, stretch and tension on cells."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


class End(Enum):
    """What holds an end node: how it is fixed and whether it carries a moment."""

    SYMMETRY = "symmetry plane: x = 0, theta = 0, no transverse force"
    CLAMPED = "clamped: position and angle given"
    PINNED = "pinned: position given, no moment"

    @property
    def holds_angle(self) -> bool:
        """Whether the tangent is held, so that a moment acts there."""
        return self is not End.PINNED

    @property
    def holds_height(self) -> bool:
        """Whether y is given; x always is."""
        return self is not End.SYMMETRY


@dataclass(frozen=True)
class Grid:
    """Nodes in units of the span, with what holds the first and the last.

    Attributes
    ----------
    nodes : ndarray, shape (cells + 1,)
        X/L, from 0 to 1/2 for half a span, from -1/2 to 1/2 for a whole one.
    first, last : End
        The end conditions.
    """

    nodes: Floats
    first: End
    last: End

    @property
    def cells(self) -> int:
        """Number of cells on this grid."""
        return len(self.nodes) - 1

    @property
    def is_half(self) -> bool:
        """Whether the grid stops at the symmetry plane."""
        return self.first is End.SYMMETRY

    @property
    def cell_length(self) -> Floats:
        """Length of each cell, shape (cells,)."""
        return np.asarray(np.diff(self.nodes), dtype=float)

    @property
    def node_length(self) -> Floats:
        """Length that each node answers for, half of either neighbouring cell, shape (cells + 1,)."""
        half = self.cell_length / 2
        behind: Floats = np.concatenate([half, [0.0]])
        before: Floats = np.concatenate([[0.0], half])
        return behind + before

    @property
    def centres(self) -> Floats:
        """Middle of each cell, shape (cells,)."""
        return np.asarray((self.nodes[1:] + self.nodes[:-1]) / 2, dtype=float)


def half_span(cells: int, support: End) -> Grid:
    """Half a symmetric filament: `cells` equal cells from the symmetry plane X = 0 to the support at X = L/2."""
    return Grid(np.linspace(0.0, 0.5, cells + 1), End.SYMMETRY, support)


def whole_span(cells_per_half: int, left: End, right: End) -> Grid:
    """A whole filament: twice `cells_per_half` equal cells, so that X = 0 is a node."""
    return Grid(np.linspace(-0.5, 0.5, 2 * cells_per_half + 1), left, right)
