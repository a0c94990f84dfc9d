"""One member: prepared with what it shares with others of its structure, integrated, judged, observed."""

from __future__ import annotations

import threading
import time
from abc import ABC, abstractmethod
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np

from softcat_sym.batch.lane_pool import Stop
from softcat_sym.batch.members import Choosing, Member, MemberMaker, Row
from softcat_sym.batch.records import Record
from softcat_sym.discretization.assembly import choose_body, choose_grid
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.results.fields import energy_residual, min_energy, node_positions, whole_span_fields
from softcat_sym.results.motion import beyond_noise, has_yielded, midpoint_extremes, regime_of
from softcat_sym.results.verdict import verdict
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import Settings, settings_for
from softcat_sym.solvers.solution import Extremes, Solution
from softcat_sym.solvers.solve import Assembled, Prepared, assembled, prepare

REFUSED, FAILED = "refused", "failed"
"""Outcomes of members without a run: an invalid scene, an error of the program."""

_ERRORS = (SoftcatError, RuntimeError, ArithmeticError, ValueError)
"""Errors that end a member without ending the others."""

_MAX_STRUCTURES = 16
"""Structures whose graphs a study remembers: they are what takes memory."""


class StructureCache:
    """Prepares members for integration; what several of them share is made by the first that needs it."""

    def __init__(self, max_structures: int | None = None) -> None:
        self._structures: dict[tuple[object, ...], Assembled] = {}
        self._max_structures = max_structures
        self._lock = threading.RLock()

    def alone(self) -> AbstractContextManager[object]:
        """While this is held no other thread makes equations, graphs or code here."""
        return self._lock

    def prepare(self, member: Member) -> Prepared:
        """A member with its parameters, start and integrator, as a single run has them."""
        scene, effects, backend = member.scene, member.effects, member.backend
        settings = tolerances(member)
        grid = choose_grid(scene, effects)
        body = choose_body(scene, grid)
        arrays = (grid.nodes, body.profile.nodes, body.profile.cells, body.natural)
        contents = (None if one is None else np.asarray(one, dtype=float).tobytes() for one in arrays)
        place = (*contents, grid.first, grid.last, body.supports, body.weighted)
        with self._lock:
            key = (member.pattern, effects.names, backend, settings.solver, *place)
            shared = self._structures.get(key)
            if shared is None:
                if self._max_structures is not None and len(self._structures) >= self._max_structures:
                    del self._structures[next(iter(self._structures))]
                shared = self._structures[key] = assembled(scene, effects, backend)
            _ = shared.code  # Compiled by the first that asks for it
        return prepare(scene, shared.graph, settings, shared)

    def run(self, member: Member, stop: Stop) -> tuple[Prepared, Solution]:
        """Integrate a member; one that Python integrates by itself, since CasADi keeps Python's lock meanwhile."""
        stop.update(0.0, None)
        prepared = self.prepare(member)
        if member.backend.compiled:
            return prepared, prepared.solve(stop)
        with self._lock:
            return prepared, prepared.solve(stop)


def tolerances(member: Member) -> Settings:
    """Integrator and tolerances as `simulate` has them, without what these do not depend on.

    Absolute tolerances follow the largest sag that is foreseen, which under a load that never falls is the last: to
    foresee it at every output time, as estimates of effects need it, would take longer than many an integration.
    """
    scene = member.scene
    brief = scene.model_copy(update={"run": scene.run.model_copy(update={"frames": 2})})
    return settings_for(brief, member.effects, compiled=member.backend.compiled)


@dataclass(frozen=True)
class MemberRun:
    """A finished run of a member, judged."""

    member: Member
    prepared: Prepared  # How it was integrated
    solution: Solution
    fields: dict[str, Floats]  # Over the whole span, as from :func:`softcat_sym.results.fields.whole_span_fields`
    nodes: Floats  # Their material coordinates [m]
    cells: Floats
    outcome: Outcome
    message: str  # Why, if that was no success
    energy_residual: float

    @property
    def time(self) -> Floats:
        """Output times [s]."""
        return self.solution.time * self.prepared.scale

    @property
    def midpoint(self) -> Floats:
        """Height of midspan [m], shape (frames,)."""
        heights: Floats = self.fields["y"][:, self.fields["y"].shape[1] // 2]
        return heights

    @cached_property
    def extremes(self) -> Extremes:
        """Turning points of midspan."""
        scene = self.member.scene
        return beyond_noise(scene, midpoint_extremes(scene, self.prepared, self.solution))

    @cached_property
    def regime(self) -> str:
        """What the run shows; empty if it is no answer."""
        if not self.outcome.is_success:
            return ""
        yielded = has_yielded(self.prepared, self.solution)
        return regime_of(self.member.scene, self.member.effects, self.fields, self.extremes.height, yielded=yielded)


def judged(member: Member, prepared: Prepared, solution: Solution) -> MemberRun:
    """Judge a run by the frames of its solution."""
    scene = member.scene
    fields = whole_span_fields(scene, prepared, solution)
    nodes, cells = node_positions(prepared.graph, rest_length(scene))
    residual = energy_residual(fields, min_energy(scene))
    audits = prepared.graph.conserves_energy and prepared.integration is not None
    outcome, message = verdict(scene, member.effects, solution, fields, nodes, residual if audits else 0.0)
    return MemberRun(member, prepared, solution, fields, nodes, cells, outcome, message, residual)


class Shared(NamedTuple):
    """What the members of a study share in one process."""

    maker: MemberMaker
    structures: StructureCache


@lru_cache(maxsize=2)
def shared_by(scene: Scene) -> Shared:
    """What members of this scene share in this process; no member depends on its neighbours.

    Where the program chooses the effects, it does so for each member by itself. Where the scene names them, the choice
    is made once, and again for a row of other equations.
    """
    choosing: Choosing = "each" if scene.run.effects == "auto" else "once"
    return Shared(MemberMaker(scene, choosing, neighbours=False), StructureCache(_MAX_STRUCTURES))


@dataclass(frozen=True)
class RowWork(ABC):
    """Runs the member of a row, and records what a study observes of it; it can be sent to another process."""

    scene: Scene  # The common part of the members
    stop: Stop

    @abstractmethod
    def observe(self, member: Member) -> Record:
        """Run the member, and record what is observed."""

    def run(self, member: Member) -> MemberRun:
        """Integrate and judge a member."""
        return judged(member, *shared_by(self.scene).structures.run(member, self.stop))

    def __call__(self, row: Row) -> Record:
        """The row's record, even if its run fails."""
        begun, shared, scene = time.perf_counter(), shared_by(self.scene), None
        try:
            with shared.structures.alone():
                member = shared.maker.member(row)
            scene = member.scene
            record = self.observe(member)
        except SceneError as error:
            record = {"outcome": REFUSED, "message": "; ".join(map(str, error.faults))}
        except _ERRORS as error:
            record = {"outcome": FAILED, "message": " ".join(str(error).split()) or type(error).__name__}
        if scene is None:
            return record
        lengths: dict[str, Any] = {"span": rest_length(scene), "thickness": scene.filament.thickness}
        return {"wall_s": time.perf_counter() - begun, "duration": scene.run.duration, **lengths, **record}
