"""A scene's filament with given effects: equations, grid and graph, and whatever else is made of the same parts."""

from __future__ import annotations

from dataclasses import dataclass

from softcat_sym.codegen.structure import Structure, structure_of
from softcat_sym.effects import Effects
from softcat_sym.equations.filament import FilamentEquations, derive
from softcat_sym.equations.section import SECTIONS
from softcat_sym.graph import Graph, assemble
from softcat_sym.graph.body import Body
from softcat_sym.graph.choosing import choose_body, choose_grid, choose_theory
from softcat_sym.graph.discretisation import Discretisation
from softcat_sym.scene import Scene
from softcat_sym.solve.backend import Backend
from softcat_sym.solve.compiled import CompiledFilament
from softcat_sym.solve.compiling import compile_filament
from softcat_sym.solve.external import External, compiled_rhs
from softcat_sym.solve.settings import Settings


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
