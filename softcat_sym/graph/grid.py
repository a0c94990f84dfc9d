"""The staggered grid along the filament: positions and moments on nodes, stretch and tension on cells."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import SoftcatError

Floats = npt.NDArray[np.float64]


class End(Enum):
    """What holds an end node: how it is fixed and whether it carries a moment."""

    SYMMETRY = "symmetry plane: x = 0, theta = 0, no transverse force"
    CLAMPED = "clamped: position and angle given"
    PINNED = "pinned: position given, no moment"
    FREE = "free: no force, no moment"

    @property
    def holds_angle(self) -> bool:
        """Whether the tangent is held, so that a moment acts there."""
        return self in (End.SYMMETRY, End.CLAMPED)

    @property
    def holds_x(self) -> bool:
        """Whether x is given."""
        return self is not End.FREE

    @property
    def holds_height(self) -> bool:
        """Whether y is given."""
        return self in (End.CLAMPED, End.PINNED)


@dataclass(frozen=True)
class Grid:
    """Nodes in units of the rest length, with what holds the first and the last.

    Attributes
    ----------
    nodes : ndarray, shape (cells + 1,)
        X/L_0, from 0 to 1/2 for half a span, from -1/2 to 1/2 for a whole one.
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


def half_span(cells: int, support: End, grading: float = 1.0, *, middle: bool = False) -> Grid:
    """Half a symmetric filament, from the symmetry plane X = 0 to the support at X = L/2.

    Parameters
    ----------
    cells : int
        How many.
    support : End
        What holds X = L/2.
    grading : float
        Length of the cell at midspan over that of the cell at the support; 1 makes all equal.
    middle : bool
        Whether cells at midspan are as short as those at the support, and those between the longest.

    Raises
    ------
    SoftcatError
        If that is no grid.
    """
    return Grid(_graded(cells, grading, middle=middle), End.SYMMETRY, support)


def whole_span(cells_per_half: int, left: End, right: End, grading: float = 1.0, *, middle: bool = False) -> Grid:
    """A whole filament: the half span and its mirror image, so that X = 0 is a node and neighbours there are equal.

    Parameters
    ----------
    cells_per_half : int
        How many cells on either side of X = 0.
    left, right : End
        What holds X = -L/2 and X = L/2.
    grading : float
        Length of the cells at midspan over that of the cells at the supports; 1 makes all equal.
    middle : bool
        As of :func:`half_span`.

    Raises
    ------
    SoftcatError
        If that is no grid.
    """
    half = _graded(cells_per_half, grading, middle=middle)
    return Grid(np.concatenate([-half[:0:-1], half]), left, right)


def _graded(cells: int, grading: float, *, middle: bool) -> Floats:
    """X/L from 0 to 1/2, shape (cells + 1,), the lengths in geometric progression towards the support.

    Any two neighbours differ by ``grading ** (1/(cells - 1))``, which tends to 1 as cells are added: the nodes lie on a
    smooth map of an equal grid, X_xi = const grading^-xi, so differences that are of second order on equal cells
    remain so. A cell at the distance d from the support is in proportion to d + (L/2)/(grading - 1).
    Towards the middle too, lengths are grading^(-cos^2 (pi xi)) in the place of grading^-xi.
    """
    if cells < 1:
        raise SoftcatError(f"grid of {cells} cells per half span: take 1 or more")
    if not 0 < grading < np.inf:
        raise SoftcatError(f"grading of {grading}: take a positive number, 1 for equal cells")
    if grading == 1:
        return np.linspace(0.0, 0.5, cells + 1)
    if middle:
        lengths = grading ** -(np.cos(np.pi * (np.arange(cells) + 0.5) / cells) ** 2)
    else:
        lengths = grading ** -np.linspace(0.0, 1.0, cells)
    nodes = np.concatenate([[0.0], np.cumsum(lengths)]) / (2 * lengths.sum())
    nodes[-1] = 0.5
    return np.asarray(nodes, dtype=float)
