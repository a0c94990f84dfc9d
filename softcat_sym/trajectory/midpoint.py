"""The height of midspan, straight from a solution."""

from __future__ import annotations

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats
from softcat_sym.solve import Solution


def midpoint_heights(graph: Graph, solution: Solution) -> Floats:
    """Height of X = 0 over the rest length, negative down.

    Parameters
    ----------
    graph : Graph
        What was integrated.
    solution : Solution
        Its states.

    Returns
    -------
    ndarray, shape (frames,)

    Raises
    ------
    SoftcatError
        If no node lies at midspan.
    """
    middle = int(np.argmin(np.abs(graph.grid.nodes)))
    for kinds, places, values in (
        (graph.x_kinds, graph.x_places, solution.x),
        (graph.z_kinds, graph.z_places, solution.z),
    ):
        for kind, place, row in zip(kinds, places, values, strict=True):
            if kind == "y" and place == middle:
                return np.asarray(row, dtype=float)
    raise SoftcatError("the filament has no node at midspan")
