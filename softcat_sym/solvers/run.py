"""One way in for every kind of run: ODE, DAE, or a sequence of equilibria."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from softcat_sym.codegen.model import Structure, structure_of
from softcat_sym.discretization.assembly import Body, assemble, choose_body, choose_grid, choose_theory
from softcat_sym.discretization.graph import TIME_SCALE, Discretisation, Graph, parameter_values
from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import Effects
from softcat_sym.physics.filament import FilamentEquations, derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.compiled import CompiledFilament, CompiledIntegration, External, compile_filament, compiled_rhs
from softcat_sym.solvers.initial_state import Start, starting_state
from softcat_sym.solvers.interpreted import Integration
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.quasi_static import march
from softcat_sym.solvers.settings import Backend, Settings
from softcat_sym.solvers.solution import Progress, Solution


@dataclass(frozen=True)
class Assembled:
    """A filament before it is solved.

    Attributes
    ----------
    scene, effects
        What was asked, and the physics in force.
    equations, theory, body
        One cell, the unknowns that the grid carries, and the body beyond its equations.
    graph : Graph
        The whole filament.
    """

    scene: Scene
    effects: Effects
    equations: FilamentEquations
    theory: Discretisation
    body: Body
    graph: Graph

    def at_rest(self) -> Graph:
        """The same filament without inertia and viscous stress: where a start that is not straight is sought."""
        scene = self.scene
        still = derive(self.effects.at_rest(), SECTIONS[scene.filament.section], scene.run.closure)
        return assemble(still, self.graph.grid, self.effects.names, choose_theory(scene, still), self.body)

    def structure(self) -> Structure:
        """What its C text depends on."""
        return structure_of(self.scene, self.effects, self.graph, self.equations, self.theory, self.body)

    def code(self, backend: Backend, settings: Settings) -> CompiledFilament | External | None:
        """What is compiled of it: all, integrator included, or its expressions for CVODES and IDAS, or nothing.

        Raises
        ------
        SoftcatError
            If the compiler refuses; with its message.
        """
        if not backend.compiled:
            return None
        if settings.solver == "rosenbrock":
            return compile_filament(self.graph, self.structure())
        return compiled_rhs(self.graph)


def assembled(scene: Scene, effects: Effects) -> Assembled:
    """Equations -> Graph of a scene.

    Parameters
    ----------
    scene : Scene
        What is asked.
    effects : Effects
        From :func:`softcat_sym.effects.choose_effects`.
    """
    equations = derive(effects.terms(), SECTIONS[scene.filament.section], scene.run.closure)
    grid = choose_grid(scene, effects)
    theory, body = choose_theory(scene, equations), choose_body(scene, grid)
    graph = assemble(equations, grid, effects.names, theory, body)
    return Assembled(scene, effects, equations, theory, body, graph)


_INTERPRETED = Backend(False, "as asked")


class Integrates(Protocol):
    """Whatever carries a filament from its start through the output times."""

    def run(self, start: Start, p: Floats, duration: float, scale: float, progress: Progress) -> Solution:
        """Integrate."""
        ...

    def piece(
        self,
        start: Start,
        p: Floats,
        times: tuple[float, float, float],
        samples: int,
        scale: float,
        progress: Progress,
    ) -> Solution:
        """Integrate a part, as :meth:`Prepared.piece`."""
        ...


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
    start : Start or None
        Where the run begins; None if no shape in balance was found.
    integration : Integrates or None
        What integrates; None of a row of equilibria.
    backend : Backend
        Interpreted or compiled.
    """

    graph: Graph
    settings: Settings
    p: Floats
    times: Floats
    scale: float
    start: Start | None
    integration: Integrates | None
    backend: Backend = _INTERPRETED

    def solve(self, progress: Progress) -> Solution:
        """Integrate."""
        if self.start is None:
            return self._nothing()
        if self.integration is None:
            return march(self.graph, self.start.z, self.p, self.times, self.scale, progress)
        return self.integration.run(self.start, self.p, float(self.times[-1]), self.scale, progress)

    def piece(self, start: Start, times: tuple[float, float, float], samples: int, progress: Progress) -> Solution:
        """Integrate from a state at one time to a later one, and on with so many even samples to a third.

        Parameters
        ----------
        start : Start
            State at the first time.
        times : tuple of float
            Begin, begin of the samples, end; in units of the time scale. The first two may be the same.
        samples : int
            Intervals from the second to the third.
        progress : Progress
            Told about simulated time.

        Returns
        -------
        Solution
            The start, and the samples with both ends.

        Raises
        ------
        ValueError
            If this is a row of equilibria.
        """
        if self.integration is None:
            raise ValueError("a row of equilibria is not integrated")
        return self.integration.piece(start, self.p, times, samples, self.scale, progress)

    def _nothing(self) -> Solution:
        frame = np.zeros((3, 1))
        x, z = self.graph.start[:, None], self.graph.straight[:, None]
        text = "at t = 0 s: no shape in balance was found (a straight string that does not bend has no stiffness)"
        return Solution(self.times[:1], x, z, frame, Outcome.no_equilibrium, text, 0)


def prepare(
    scene: Scene,
    graph: Graph,
    settings: Settings,
    statics: Callable[[], Graph] | None = None,
    compiled: tuple[Backend, CompiledFilament | External | None] = (_INTERPRETED, None),
) -> Prepared:
    """Fill in the scene's parameters, find the starting shape and build the integrator.

    Parameters
    ----------
    statics : callable
        The same filament without inertia and viscous stress, for a starting shape that is not straight;
        without it such a run finds none.
    compiled : pair of Backend and CompiledFilament, External or None
        What integrates in place of CasADi, or the right-hand side that CasADi integrates.
    """
    values = parameter_values(scene)
    scale = values[TIME_SCALE]
    p = graph.vector(values)
    times = np.linspace(0.0, scene.run.duration / scale, scene.run.frames)
    start = starting_state(scene, graph, p, statics)
    flows = bool(graph.x.numel())
    # A frame at which a support changes pace is one too, but for the first.
    kinks = np.array(sorted({row[0] / scale for row in scene.ends.motion if 0 < row[0] <= scene.run.duration}))
    backend, code = compiled
    integration: Integrates | None = None
    if isinstance(code, CompiledFilament):
        integration = CompiledIntegration(graph, settings, code, scene.run.frames, kinks)
    elif flows and start is not None:
        integration = Integration(graph, settings, scene.run.frames, kinks[kinks < times[-1]], code)
    return Prepared(graph, settings, p, times, scale, start, integration, backend)
