"""Strain that gathers in one cell: the sign of an answer that the grid, not the physics, decides."""

from __future__ import annotations

import numpy as np

from softcat_sym.graph.grid import Floats

SHARE_OF_ONE_CELL = 0.3
"""A cell that by itself, beyond its neighbours, carries this share of its half's elongation is a localised neck.

Converged runs stay below 0.2 (a thick ink strand at N = 20) and fall with 1/N; a neck that the theory cannot resolve
carries 0.4 or more on every grid from N = 10 up. A thick strand on very few cells (N = 8) comes close to the limit.
"""

DRAWN_OUT = 0.4
"""Strain of a neck, spread over its length, beyond which it is drawn out even where the necking gradient is in force.

Elongation beyond the neighbourhood does not depend on the grid, unlike the stretch of the cell that shows it. In plane
stress the paper's ringing filament stops at 0.18 for G = 0.25 and at 0.33 for G = 0.3, on 40 cells as on 160, where
elements stop too; for G = 0.4 it ruptures on every grid (tests/acceptance/test_necking.py).
"""

_SMOOTH = 0.3
"""Of the neighbours' strain: what a cell much longer than a neck may exceed them by without one."""

_NEGLIGIBLE_ELONGATION = 1e-9
_RUPTURED = 10.0  # strain beyond which only a thread is left: no number is worth telling


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
    excess = np.maximum(stretch - np.maximum(np.maximum(left, right), 1.0), 0.0) * length
    # Where parts are compressed and parts drawn, their sum may vanish: it is no scale.
    elongation = np.abs(stretch - 1.0) * length
    middle = len(stretch) // 2
    shares = [
        float(np.max(excess[half])) / float(np.sum(elongation[half]))
        for half in (slice(None, middle), slice(middle, None))
        if float(np.sum(elongation[half])) > _NEGLIGIBLE_ELONGATION * float(np.sum(length))
    ]
    return max(shares, default=0.0)


def neck_strain(stretch: Floats, length: Floats, neck: float) -> float:
    """Largest strain of any neck beyond its neighbourhood, spread over the length of a neck.

    Parameters
    ----------
    stretch, length : ndarray, shape (cells,)
        Stretch over the whole span and undeformed lengths of the cells.
    neck : float
        Length of a neck, below which the gradient evens out any strain.
    """
    edges = np.concatenate([[0.0], np.cumsum(length)])
    elongation = np.concatenate([[0.0], np.cumsum((stretch - 1) * length)])
    # A cell longer than a neck shows the same elongation over its own length.
    window = np.maximum(length, neck)
    left = np.clip((edges[1:] + edges[:-1] - window) / 2, 0.0, edges[-1] - window)

    def mean(start: Floats) -> Floats:
        inside = (start > -1e-9 * edges[-1]) & (start + window < (1 + 1e-9) * edges[-1])
        gain = np.interp(start + window, edges, elongation) - np.interp(start, edges, elongation)
        return np.where(inside, gain / window, -np.inf)

    beside = np.maximum(mean(left - window), mean(left + window))
    # Over a cell longer than a neck strain also varies smoothly, and by more than a short neck holds.
    smooth = _SMOOTH * (1 - neck / window) * np.maximum(np.where(np.isfinite(beside), beside, 0.0), 0.0)
    excess = mean(left) - beside - smooth
    return float(np.max(np.where(np.isfinite(excess), excess, 0.0) * window / neck))


def neck_that_the_grid_decides(stretch: Floats, length: Floats, neck: float | None) -> str:
    """What is wrong with a neck, or an empty text.

    Parameters
    ----------
    stretch, length : ndarray, shape (cells,)
        Stretch over the whole span and undeformed lengths of the cells.
    neck : float or None
        Length of a neck where the necking gradient is in force, in the unit of `length`: then a hinge narrower than a
        cell is a matter of resolution, and only one that is drawn out is refused.
    """
    edges = np.concatenate([[0.0], np.cumsum(length)])
    cell = int(np.argmax(stretch))
    where = f"X/L = {(edges[cell] + edges[cell + 1]) / 2 / edges[-1] - 0.5:.4g}"
    if neck is not None:
        strain = neck_strain(stretch, length, neck)
        far = f"by {strain:.0%} of its length" if strain < _RUPTURED else f"to more than {_RUPTURED:g} times its length"
        drawn = f"the neck at {where} is drawn out {far} beyond its neighbourhood: near rupture"
        return drawn if strain > DRAWN_OUT else ""
    share = largest_share_of_one_cell(stretch, length)
    gathered = f"the cell at {where} carries {share:.0%} of the elongation of its half beyond its neighbour"
    return gathered if share > SHARE_OF_ONE_CELL else ""
