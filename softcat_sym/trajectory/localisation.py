"""Strain that gathers in one cell: the sign of an answer that the grid, not the physics, decides."""

from __future__ import annotations

import numpy as np

from softcat_sym.graph.grid import Floats

SHARE_OF_ONE_CELL = 0.3
"""A cell that by itself, beyond its neighbours, carries this share of its half's elongation is a localised neck.

Converged runs stay below 0.2 (a thick ink strand at N = 20) and fall with 1/N; a neck that the theory cannot resolve
carries 0.4 or more on every grid from N = 10 up. A thick strand on very few cells (N = 8) comes close to the limit.
"""

_NEGLIGIBLE_ELONGATION = 1e-9


def largest_share_of_one_cell(stretch: Floats, length: Floats) -> float:
    """Share of a half's elongation that one cell carries in excess of its more stretched neighbour.

    Parameters
    ----------
    stretch : ndarray, shape (cells,)
        Stretch over the whole span.
    length : ndarray, shape (cells,)
        Undeformed lengths of the cells.

    Returns
    -------
    float
        Between 0 (smooth) and 1 (all in one cell); 0 where the filament is hardly stretched.
    """
    # A support has no cell behind it: its cell is compared with the one neighbour it has.
    left = np.concatenate([[-np.inf], stretch[:-1]])
    right = np.concatenate([stretch[1:], [-np.inf]])
    excess = np.maximum(stretch - np.maximum(left, right), 0.0) * length
    elongation = np.maximum(stretch - 1.0, 0.0) * length
    middle = len(stretch) // 2
    shares = [
        float(np.max(excess[half])) / float(np.sum(elongation[half]))
        for half in (slice(None, middle), slice(middle, None))
        if float(np.sum(elongation[half])) > _NEGLIGIBLE_ELONGATION * float(np.sum(length))
    ]
    return max(shares, default=0.0)
