"""A filament without inertia or flow: a sequence of equilibria."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import casadi as ca
import numpy as np

from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats
from softcat_sym.solve.equilibrium import Equilibrium
from softcat_sym.solve.outcome import Outcome
from softcat_sym.solve.progress import Progress
from softcat_sym.solve.solution import Solution

# Instants between two frames at which the power is taken: never at a frame, where a load or a support may change pace.
_GAUSS = (0.5 - 0.5 / 3**0.5, 0.5 + 0.5 / 3**0.5)


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
    equilibrium, power = Equilibrium(graph), _power_of_load(graph)
    empty = np.zeros(0)
    shapes, work = [z0], [0.0]
    for before, time in itertools.pairwise(times):
        instants = [float(before + share * (time - before)) for share in (*_GAUSS, 1.0)]
        passed: list[Floats] = []
        for instant in instants:
            z = equilibrium.search(instant, empty, p, [passed[-1] if passed else shapes[-1]])
            if z is None:
                text = f"no equilibrium at t = {instant * scale:.6g} s"
                return _solution(times[: len(shapes)], shapes, work, Outcome.no_equilibrium, text)
            passed.append(z)
        powers = [power(instant, z, p) for instant, z in zip(instants[:-1], passed[:-1], strict=True)]
        work.append(work[-1] + float(time - before) * sum(powers) / len(powers))
        shapes.append(passed[-1])
        progress.update(float(time) * scale, None)
    return _solution(times, shapes, work, Outcome.solved, "")


def _power_of_load(graph: Graph) -> Callable[[float, Floats, Floats], float]:
    """Power of the changing load and of the moving support, of time, positions and parameters."""
    powers = ca.Function("power", [graph.t, graph.x, graph.z, graph.p], [graph.quad])
    return lambda time, z, p: float(np.asarray(powers(time, [], z, p)).ravel()[1])


def _solution(times: Floats, shapes: list[Floats], work: list[float], outcome: Outcome, text: str) -> Solution:
    frames = len(shapes)
    quad = np.vstack([np.zeros(frames), work, np.zeros(frames)])
    return Solution(times, np.zeros((0, frames)), np.array(shapes).T, quad, outcome, text, frames - 1)
