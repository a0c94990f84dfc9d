"""A filament without inertia or flow: a sequence of equilibria."""

from __future__ import annotations

import itertools

import casadi as ca
import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import WORK_OF_AGEING, Floats
from softcat_sym.solvers.equilibrium import Equilibrium
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settling import snapped
from softcat_sym.solvers.solution import Progress, Solution

# Gauss points between two frames for the power, which may jump at a frame, where a load or a support changes its rate.
_GAUSS = (0.5 - 0.5 / 3**0.5, 0.5 + 0.5 / 3**0.5)

_MIN_STEP = 1 / 1024  # Over the time from one instant to the next
_GROWTH = 1.5


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
        Called after every frame.
    """
    path = _Path(graph, p, float(times[0]), z0)
    power = ca.Function("power", graph.symbolic.inputs, [graph.symbolic.quad])
    shapes, outcome, message = [z0], Outcome.solved, ""
    # External work: by the load, and by a material that shrinks.
    works = np.array([name in ("load", WORK_OF_AGEING) for name in graph.powers])
    work = [np.zeros(len(works))]
    stopped = False
    try:
        for before, time in itertools.pairwise(times.tolist()):
            instants = [before + share * (time - before) for share in (*_GAUSS, 1.0)]
            passed: list[Floats] = []
            while len(passed) < len(instants) and (z := path.to(instants[len(passed)])) is not None:
                passed.append(z)
            if len(passed) < len(instants):
                outcome = Outcome.no_equilibrium
                message = f"no equilibrium at t = {instants[len(passed)] * scale:.6g} s"
                break
            powers = [power(instant, [], z, p) for instant, z in zip(instants[:-1], passed[:-1], strict=True)]
            done = sum(np.where(works, np.asarray(found, dtype=float).ravel(), 0.0) for found in powers)
            work.append(work[-1] + (time - before) * done / len(_GAUSS))
            shapes.append(path.last)
            progress.update(time * scale, None)
    except KeyboardInterrupt:
        stopped = True
    frames = len(shapes)
    x, z, quad = np.zeros((0, frames)), np.array(shapes).T, np.array(work[:frames]).T
    found = Solution(times[:frames], x, z, quad, outcome, message, frames - 1)
    if stopped:
        raise found.interrupted(scale)
    return found


class _Path:
    """A sequence of equilibria, with smaller steps than requested if a support moves far."""

    def __init__(self, graph: Graph, p: Floats, time: float, z: Floats) -> None:
        self._graph, self._p, self._equilibrium = graph, p, Equilibrium(graph)
        self._known = [(time, z)]
        self._step = np.inf

    @property
    def last(self) -> Floats:
        """The last equilibrium."""
        return self._known[-1][1]

    def to(self, until: float) -> Floats | None:
        """Equilibrium at a later time; None if there is none.

        If even the smallest step fails, the branch has ended: a filament with bending snaps to a lower equilibrium.
        """
        whole = until - self._known[-1][0]
        falls = self._graph.terms.bending and self._graph.conserves_energy
        while (left := until - self._known[-1][0]) > 0:
            step = min(left, self._step)
            at = until if step == left else self._known[-1][0] + step
            further = self._search(at, self._guess(at))
            if further is None and step > _MIN_STEP * whole:
                self._step = step / 2
                continue
            if further is None and falls:
                further = self._search(at, snapped(self._graph, at, np.zeros(0), self._p, self.last))
            if further is None:
                return None
            self._known = [self._known[-1], (at, further)]
            self._step *= _GROWTH
        return self.last

    def _search(self, at: float, guess: Floats) -> Floats | None:
        return self._equilibrium.search(at, np.zeros(0), self._p, [guess])

    def _guess(self, at: float) -> Floats:
        """Initial guess: the last equilibrium, or with reduced steps an extrapolation."""
        last, z = self._known[-1]
        if not np.isfinite(self._step) or len(self._known) < 2:
            return z
        first, before = self._known[0]
        return np.asarray(z + (at - last) / (last - first) * (z - before))
