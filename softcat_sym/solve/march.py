"""A filament without inertia or flow: a sequence of equilibria."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import casadi as ca
import numpy as np

from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats
from softcat_sym.solve.equilibrium import Equilibrium
from softcat_sym.solve.outcome import Outcome
from softcat_sym.solve.progress import Progress
from softcat_sym.solve.solution import Solution


def march(graph: Graph, z0: Floats, p: Floats, times: Floats, scale: float, progress: Progress) -> Solution:
    """Equilibrium at each output time, each found from the one before.

    Parameters
    ----------
    graph : Graph
        Without differential states.
    z0 : ndarray, shape (nz,)
        Equilibrium at the first time.
    p : ndarray
        Parameters.
    times : ndarray, shape (frames,)
        In units of the time scale.
    scale : float
        Time scale [s].
    progress : Progress
        Told after every frame.
    """
    equilibrium = Equilibrium(graph)
    empty = np.zeros(0)
    shapes, work = [z0], [0.0]
    for before, time in itertools.pairwise(times):
        middle = float(before + time) / 2
        halfway = equilibrium.search(middle, empty, p, [shapes[-1]])
        z = equilibrium.search(float(time), empty, p, [shapes[-1] if halfway is None else halfway])
        if z is None or halfway is None:
            text = f"no equilibrium at t = {time * scale:.6g} s"
            return _solution(times[: len(shapes)], shapes, work, Outcome.no_equilibrium, text)
        instants = ((float(before), shapes[-1]), (middle, halfway), (float(time), z))
        work.append(work[-1] + _work(graph, instants, p))
        shapes.append(z)
        progress.update(float(time) * scale, None)
    return _solution(times, shapes, work, Outcome.solved, "")


def _work(graph: Graph, instants: Sequence[tuple[float, Floats]], p: Floats) -> float:
    """Work of the changing load from the first to the last of three equilibria, by Simpson's rule."""
    power = ca.Function("power", [graph.t, graph.x, graph.z, graph.p], [graph.quad])
    first, middle, last = (float(np.asarray(power(time, [], z, p)).ravel()[1]) for time, z in instants)
    return (instants[2][0] - instants[0][0]) / 6 * (first + 4 * middle + last)


def _solution(times: Floats, shapes: list[Floats], work: list[float], outcome: Outcome, text: str) -> Solution:
    frames = len(shapes)
    quad = np.vstack([np.zeros(frames), work, np.zeros(frames)])
    return Solution(times, np.zeros((0, frames)), np.array(shapes).T, quad, outcome, text, frames - 1)
