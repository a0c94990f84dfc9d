"""Assembly, preparation and solution of every kind of run: ODE, DAE, or a sequence of equilibria."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.codegen.c_model import Structure, model_for, signature_of, structure_of
from softcat_sym.discretization.assembly import (
    choose_body,
    choose_grid,
    choose_theory,
    elastic_theory,
    graph_of,
)
from softcat_sym.discretization.graph import Graph, Recorded
from softcat_sym.discretization.parameters import TIME_SCALE, parameter_values
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import Effects
from softcat_sym.estimates.free_vibration import ringing
from softcat_sym.estimates.scaling import instant_modulus, yield_stress_of
from softcat_sym.physics.terms import Formulation, Terms
from softcat_sym.scene.extrusion import releases
from softcat_sym.scene.scene import Scene, loaded_from
from softcat_sym.scene.tables import kinks as temperature_kinks
from softcat_sym.solvers.compiled import CompiledFilament, CompiledIntegration, CompiledNewton, compile_filament
from softcat_sym.solvers.initial_state import starting_state
from softcat_sym.solvers.modal_tail import Conditions
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import Backend, Settings, choose_backend
from softcat_sym.solvers.solution import Interrupted, Progress, Solution, Start, bounds_of

if TYPE_CHECKING:
    from softcat_sym.solvers.interpreted import Integration


@dataclass(frozen=True)
class Assembled:
    """A filament before it is solved."""

    scene: Scene
    effects: Effects  # The physics in force
    structure: Structure  # Equations, unknowns and supports, and everything on which its C text depends
    graph: Graph  # The whole filament
    backend: Backend

    @cached_property
    def code(self) -> CompiledFilament | None:
        """The filament in C, None if interpreted; SoftcatError with the compiler's message if compilation fails."""
        return compile_filament(self.graph, self.structure) if self.backend.compiled else None

    def at_rest(self) -> Graph:
        """The same filament without inertia and viscous stress, for the initial shape if it is not straight."""
        return self._still.graph

    @cached_property
    def _still(self) -> Assembled:
        scene, recorded = self.scene, self.structure.recorded
        still = Formulation(self.effects.at_rest(), scene.filament.section, scene.run.closure)
        # Before any flow, few points suffice for an elastic section in three dimensions.
        theory = elastic_theory(scene) if recorded.theory.is_spatial else choose_theory(scene, still.terms)
        recorded = replace(recorded, formulation=still, theory=theory)
        return _assembled(scene, self.effects, recorded, self.backend)

    def code_at_rest(self, graph: Graph) -> CompiledFilament:
        """Compiled code of the filament at rest."""
        return compile_filament(graph, self._still.structure)


def assembled(scene: Scene, effects: Effects, backend: Backend | None = None) -> Assembled:
    """Assemble the graph of a scene with these effects, for a backend, by default the scene's."""
    return _assembled(scene, effects, _recorded(scene, effects), backend or choose_backend(scene, effects))


def structure_for(scene: Scene, effects: Effects) -> Structure:
    """Everything on which the C text of a scene with these effects depends."""
    return structure_of(effects, _recorded(scene, effects))


def _recorded(scene: Scene, effects: Effects) -> Recorded:
    formulation = Formulation(effects.terms(), scene.filament.section, scene.run.closure)
    grid = choose_grid(scene, effects)
    return Recorded(formulation, grid, choose_theory(scene, formulation.terms), choose_body(scene, grid))


def _assembled(scene: Scene, effects: Effects, recorded: Recorded, backend: Backend) -> Assembled:
    structure = structure_of(effects, recorded)
    found = model_for(structure).signature if backend.compiled else signature_of(structure)
    signature = found or recorded.program.signature
    return Assembled(scene, effects, structure, graph_of(recorded, effects.names, signature), backend)


_INTERPRETED = Backend(False, "as asked")


@dataclass(frozen=True)
class Prepared:
    """A graph with its integrator and its parameters; `solve` only integrates."""

    graph: Graph
    settings: Settings
    p: Floats  # Parameters
    times: Floats  # Output times in units of the time scale, shape (frames,)
    scale: float  # The time scale [s]
    start: Start | None  # Initial state; None if no equilibrium was found
    integration: Integration | CompiledIntegration | None  # None for a sequence of equilibria
    backend: Backend = _INTERPRETED
    code: CompiledFilament | None = None  # Of the whole filament, if it is compiled
    stride: int = 1  # Output times of the integration for each of `times`

    def observe(self, solution: Solution) -> dict[str, Floats]:
        """Fields and energies of a solution, shape (frames, sites)."""
        of = self.graph if self.code is None else self.code
        return of.observe(solution.time, solution.x, solution.z, self.p)

    def solve(self, progress: Progress) -> Solution:
        """Integrate."""
        if self.start is None:
            text = "at t = 0 s: no shape in balance was found (a straight string that does not bend has no stiffness)"
            x, z = self.graph.start[:, None], self.graph.straight[:, None]
            return Solution(
                self.times[:1], x, z, np.zeros((len(self.graph.powers), 1)), Outcome.no_equilibrium, text, 0
            )
        if self.integration is None:
            from softcat_sym.solvers.equilibrium import march

            return march(self.graph, self.start.z, self.p, self.times, self.scale, progress)
        try:
            found = self.integration.run(self.start, self.p, float(self.times[-1]), self.scale, progress)
        except Interrupted as stopped:
            part: Solution = stopped.part()
            raise Interrupted(lambda: part.every(self.stride, self.times)) from None
        return found.every(self.stride, self.times)

    def piece(self, start: Start, begin: float, end: float, samples: int, progress: Progress) -> Solution:
        """Integrate from a state at one time to a later time.

        Parameters
        ----------
        start : Start
            State at the first time.
        begin, end : float
            In units of the time scale.
        samples : int
            Equal intervals between them, at whose ends the solution is stored.
        progress : Progress
            Receiver of the simulated time.
        """
        if self.integration is None:
            raise ValueError("a sequence of equilibria is not integrated")
        times = np.linspace(begin, end, samples + 1)
        return self.integration.piece(start, self.p, times, self.scale, progress)


def prepare(scene: Scene, graph: Graph, settings: Settings, filament: Assembled | None = None) -> Prepared:
    """Fill in the scene's parameters, find the initial shape and build the integrator.

    An initial shape that is not straight is that of the filament at rest. Without `filament` the graph is interpreted.
    """
    values = parameter_values(scene)
    scale = values[TIME_SCALE]
    p = graph.vector(values)
    times = np.linspace(0.0, scene.run.duration / scale, scene.run.frames)
    # A frame at which a support or a furnace changes its rate counts, too, except for the first.
    bends = (*(row[0] for row in (*scene.ends.motion, *scene.ends.right_twist)), *temperature_kinks(scene))
    bends = (*bends, *releases(scene, graph.grid.nodes.tolist()))
    kinks = np.array(sorted({time / scale for time in bends if 0 < time <= scene.run.duration}))
    backend, code, at_rest, newton = _INTERPRETED, None, None, None
    if filament is not None:
        backend, code, at_rest = filament.backend, filament.code, filament.at_rest
        newton = None if code is None else CompiledNewton(graph, code, filament.code_at_rest, settings)
    bounds = bounds_of(scene, graph.terms, graph.grid.nodes)
    start, stride = starting_state(scene, graph, p, at_rest, newton), 1
    integration: Integration | CompiledIntegration | None = None
    if code is not None:
        conditions = conditions_of_tail(scene, graph.terms, settings, scale)
        integration = CompiledIntegration(graph, settings, code, scene.run.frames, kinks, bounds, conditions)
    elif len(graph.start) and start is not None:
        # Imported here, as compiled runs do not need CasADi.
        from softcat_sym.solvers.interpreted import Integration

        stride = 1 if len(kinks) else _stride(scene)
        frames = stride * (scene.run.frames - 1) + 1
        integration = Integration(graph, settings, frames, kinks, bounds)
    return Prepared(graph, settings, p, times, scale, start, integration, backend, code, stride)


def conditions_of_tail(scene: Scene, terms: Terms, settings: Settings, scale: float) -> Conditions | None:
    """When the modes of a filament may carry its ringing to the end; None where they never do."""
    if settings.lasting is None or scene.numerics.tail == "integrate" or terms.changes_in_time:
        return None
    limit, modulus = yield_stress_of(scene), instant_modulus(scene)
    strain = float(limit / modulus) if terms.yields and limit and modulus else math.inf
    begin = loaded_from(scene) / scale
    return Conditions(settings.lasting / scale, begin, scene.run.accuracy, strain)


_PER_PERIOD, _MAX_TIMES = 16.0, 4000


def _stride(scene: Scene) -> int:
    """Output times for each frame that show how the filament may ring, where the steps themselves are not seen."""
    frequency, frames = ringing(scene).frequency, scene.run.frames - 1
    enough = _PER_PERIOD * frequency * scene.run.duration / (2 * math.pi) if math.isfinite(frequency) else 0.0
    return max(1, math.ceil(min(enough, _MAX_TIMES) / frames))
