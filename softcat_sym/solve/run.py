"""One way in for every kind of run: ODE, DAE, or a sequence of equilibria."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softcat_sym.effects.prediction import elastic_sag
from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats
from softcat_sym.graph.parameters import TIME_SCALE, parameter_values
from softcat_sym.scene import Scene
from softcat_sym.solve.equilibrium import Equilibrium, sagging_guesses
from softcat_sym.solve.integrate import Integration
from softcat_sym.solve.march import march
from softcat_sym.solve.outcome import Outcome
from softcat_sym.solve.progress import Progress
from softcat_sym.solve.settings import Settings
from softcat_sym.solve.solution import Solution


@dataclass(frozen=True)
class Prepared:
    """A graph with its integrator built and its parameters filled in; `solve` does nothing but integrate.

    Attributes
    ----------
    graph : Graph
        What is integrated.
    settings : Settings
        How.
    p : ndarray
        Parameters.
    times : ndarray, shape (frames,)
        Output times in units of the time scale.
    scale : float
        The time scale [s].
    """

    graph: Graph
    settings: Settings
    p: Floats
    times: Floats
    scale: float
    start: Floats | None
    integration: Integration | None

    def solve(self, progress: Progress) -> Solution:
        """Integrate."""
        if self.start is None:
            return self._nothing()
        if self.integration is None:
            return march(self.graph, self.start, self.p, self.times, self.scale, progress)
        return self.integration.run(self.start, self.p, float(self.times[-1]), self.scale, progress)

    def _nothing(self) -> Solution:
        frame = np.zeros((3, 1))
        x, z = self.graph.start[:, None], self.graph.straight[:, None]
        text = "at t = 0 s: no static shape was found (a straight string that does not bend has no stiffness)"
        return Solution(self.times[:1], x, z, frame, Outcome.no_equilibrium, text, 0)


def prepare(scene: Scene, graph: Graph, settings: Settings) -> Prepared:
    """Fill in the scene's parameters, find the starting shape and build the integrator."""
    values = parameter_values(scene)
    scale = values[TIME_SCALE]
    p = graph.vector(values)
    times = np.linspace(0.0, scene.run.duration / scale, scene.run.frames)
    start: Floats | None = np.zeros(0)
    if graph.is_dae:
        start = Equilibrium(graph).search(0.0, graph.start, p, sagging_guesses(graph, elastic_sag(scene)))
    flows = bool(graph.x.numel())
    integration = Integration(graph, settings, scene.run.frames) if flows and start is not None else None
    return Prepared(graph, settings, p, times, scale, start, integration)
