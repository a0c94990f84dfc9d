"""What members have in common, made once: equations, graph, compiled model."""

from __future__ import annotations

import threading
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from softcat_sym.codegen.structure import structure_of
from softcat_sym.ensemble.members import Member
from softcat_sym.equations.filament import FilamentEquations, derive
from softcat_sym.equations.section import SECTIONS
from softcat_sym.graph import Graph, assemble
from softcat_sym.graph.body import Body
from softcat_sym.graph.choosing import choose_body, choose_grid, choose_theory
from softcat_sym.graph.grid import Grid
from softcat_sym.scene import Scene
from softcat_sym.solve import Prepared, Settings, prepare, settings_for
from softcat_sym.solve.compiled import CompiledFilament
from softcat_sym.solve.compiling import compile_filament
from softcat_sym.solve.external import External, compiled_rhs

_FIRST_AND_LAST = 2

Key = tuple[object, ...]


class Workshop:
    """Prepares members for integration; what several of them share is made by the first that needs it."""

    def __init__(self) -> None:
        self._filaments: dict[Key, SharedFilament] = {}
        self._lock = threading.RLock()

    def prepare(self, member: Member) -> Prepared:
        """A member with its parameters, start and integrator, as :func:`softcat_sym.simulate.build` makes it.

        Raises
        ------
        SceneError
            If the scene asks for an integrator or a backend that it cannot have.
        SoftcatError
            If the compiler refuses; with its message.
        """
        scene, effects, backend = member.scene, member.effects, member.backend
        settings = tolerances(member)
        grid = choose_grid(scene, effects)
        body = choose_body(scene, grid)
        with self._lock:
            key = (member.pattern, effects.names, backend, settings.solver, *_key_of(grid, body))
            shared = self._filaments.get(key)
            if shared is None:
                own = backend.compiled and settings.solver == "rosenbrock"
                shared = self._filaments[key] = _share(member, grid, body, own)
        return prepare(scene, shared.graph, settings, shared.statics, (backend, shared.code))


def tolerances(member: Member) -> Settings:
    """Integrator and tolerances as `simulate` has them, without what these do not depend on.

    Absolute tolerances follow the largest sag that is foreseen, which under a load that never falls is the last: to
    foresee it at every output time, as estimates of effects need it, would take longer than many an integration.
    """
    scene = member.scene
    brief = scene.model_copy(update={"run": scene.run.model_copy(update={"frames": _FIRST_AND_LAST})})
    return settings_for(brief, member.effects, compiled=member.backend.compiled)


@dataclass(frozen=True)
class SharedFilament:
    """Filaments that differ in numbers only.

    Attributes
    ----------
    graph : Graph
        On their grid.
    code : CompiledFilament, External or None
        None if interpreted.
    resting : FilamentEquations
        The same at rest.
    scene : Scene
        The first of them.
    body : Body
        Supports, profile, point mass.
    """

    graph: Graph
    code: CompiledFilament | External | None
    resting: FilamentEquations
    scene: Scene
    body: Body

    def statics(self) -> Graph:
        """The filament without inertia and viscous stress, for a start that is not straight."""
        return self._statics

    @cached_property
    def _statics(self) -> Graph:
        theory = choose_theory(self.scene, self.resting)
        return assemble(self.resting, self.graph.grid, self.graph.effects, theory, self.body)


def _share(member: Member, grid: Grid, body: Body, own: bool) -> SharedFilament:
    """What a member has in common; `own` code integrates by itself, other code is the right-hand side for CasADi."""
    scene, effects = member.scene, member.effects
    section, closure = SECTIONS[scene.filament.section], scene.run.closure
    equations, resting = derive(effects.terms(), section, closure), derive(effects.at_rest(), section, closure)
    theory = choose_theory(scene, equations)
    graph = assemble(equations, grid, effects.names, theory, body)
    code: CompiledFilament | External | None = None
    if own:
        code = compile_filament(graph, structure_of(scene, effects, graph, equations, theory, body))
    elif member.backend.compiled:
        code = compiled_rhs(graph)
    return SharedFilament(graph, code, resting, scene, body)


def _key_of(grid: Grid, body: Body) -> Key:
    profile = (_bytes(body.profile.nodes), _bytes(body.profile.cells))
    return _bytes(grid.nodes), grid.first, grid.last, body.supports, body.weighted, profile


def _bytes(values: object) -> bytes | None:
    return None if values is None else np.asarray(values, dtype=float).tobytes()
