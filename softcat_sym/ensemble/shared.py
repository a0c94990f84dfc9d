"""What members have in common, made once: equations, graph, compiled model."""

from __future__ import annotations

import threading
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from softcat_sym.ensemble.members import Member
from softcat_sym.graph import Graph
from softcat_sym.graph.body import Body
from softcat_sym.graph.choosing import choose_body, choose_grid
from softcat_sym.graph.grid import Grid
from softcat_sym.solve import Prepared, Settings, prepare, settings_for
from softcat_sym.solve.assembled import Assembled, assembled
from softcat_sym.solve.compiled import CompiledFilament
from softcat_sym.solve.external import External

_FIRST_AND_LAST = 2

Key = tuple[object, ...]


class Workshop:
    """Prepares members for integration; what several of them share is made by the first that needs it.

    Parameters
    ----------
    most : int, optional
        How many sorts of filament are remembered: beyond it the one made first is forgotten. All, if not given.
    """

    def __init__(self, most: int | None = None) -> None:
        self._filaments: dict[Key, SharedFilament] = {}
        self._most = most
        self._lock = threading.RLock()

    def alone(self) -> AbstractContextManager[object]:
        """While this is held no other thread makes equations, graphs or code here."""
        return self._lock

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
                if self._most is not None and len(self._filaments) >= self._most:
                    del self._filaments[next(iter(self._filaments))]
                first = assembled(scene, effects)
                shared = self._filaments[key] = SharedFilament(first, first.code(backend, settings))
        return prepare(scene, shared.first.graph, settings, shared.statics, (backend, shared.code))


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
    first : Assembled
        One of them, with the graph of all.
    code : CompiledFilament, External or None
        None if interpreted.
    """

    first: Assembled
    code: CompiledFilament | External | None

    def statics(self) -> Graph:
        """The filament without inertia and viscous stress, for a start that is not straight."""
        return self._statics

    @cached_property
    def _statics(self) -> Graph:
        return self.first.at_rest()


def _key_of(grid: Grid, body: Body) -> Key:
    profile = (_bytes(body.profile.nodes), _bytes(body.profile.cells))
    return _bytes(grid.nodes), grid.first, grid.last, body.supports, body.weighted, profile


def _bytes(values: object) -> bytes | None:
    return None if values is None else np.asarray(values, dtype=float).tobytes()
