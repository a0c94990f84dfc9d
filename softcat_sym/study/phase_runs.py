"""The runs behind a phase diagram: each filament through the compiled solver, judged as a single run is judged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.ensemble.members import Member, members_of
from softcat_sym.ensemble.progress import MembersProgress
from softcat_sym.ensemble.running import Stop, side_by_side
from softcat_sym.ensemble.shared import Workshop
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, rest_length
from softcat_sym.solve import Prepared
from softcat_sym.study.blocks import Workplace, blocks_of, run_blocks
from softcat_sym.study.blocks.embedded import Embedded
from softcat_sym.study.blocks.running import Count
from softcat_sym.study.blocks.work import Told
from softcat_sym.study.judged_member import judged, shared_workshop
from softcat_sym.study.phase_plane import Place, duration_at, row_of
from softcat_sym.trajectory.fields import node_positions
from softcat_sym.trajectory.regime import ARREST_RATE, ARREST_TIME

if TYPE_CHECKING:
    from softcat_sym.study.phase_kept import KeptRuns

PASSED = 0.5
"""Sag over span beyond which no catenary rests: the one of least stress sags by 0.338 (3.12, exact)."""

CLAMP_REGION = 0.1
"""Share of the span next to each end that is not counted as the span: hinges are much shorter."""

DESCENDING = "descending"

CLAMPS_ONLY = "descending-at-clamps"
"""Mark of a descending filament whose span, `CLAMP_REGION` away from the ends, counts as arrested by itself."""

Watched = tuple[Place, float]
"""A filament's groups, and how long it is watched [s]."""

_BLOCK = 16
"""Filaments that are run, kept and lost together: some tenths of a second."""


@dataclass(frozen=True)
class LocalStrains:
    """True axial strain at one section: of the centreline, and of its most stretched fibre (2.6, objective form)."""

    centreline: float
    largest: float


@dataclass(frozen=True)
class PhaseRun:
    """One filament.

    Attributes
    ----------
    place : Place
        Its groups.
    regime : str or None
        What the run shows; None if it is no answer.
    outcome : str
        Name of the outcome: of the run that gave the regime, or of the one that failed.
    complaint : str
        Why, of a run that is no answer.
    duration : float
        Of the run that was judged [s].
    drawn_out : float or None
        Duration [s] of the longer run that was no answer, where the judged one ends as its sag passes `PASSED`.
    runs : int
        How many were made: 1 or 2.
    sag : float
        Of the midpoint at the end, over the span.
    rate, span_rate : float
        Largest plastic rate in the last tenth of the run over sigma_Y/eta: of all fibres, and of those further than
        `CLAMP_REGION` from the ends.
    clamp, midspan : LocalStrains
        At the end of the run, in the cell at a clamp and in the one at midspan.
    steps : int
        Of the integrator, of all runs.
    """

    place: Place
    regime: str | None
    outcome: str
    complaint: str
    duration: float
    drawn_out: float | None
    runs: int
    sag: float
    rate: float
    span_rate: float
    clamp: LocalStrains
    midspan: LocalStrains
    steps: int

    @property
    def mark(self) -> str:
        """The regime, or the name of the outcome of a run that has none; `CLAMPS_ONLY` sets a part of one apart."""
        if self.regime == DESCENDING and self.span_rate < ARREST_RATE:
            return CLAMPS_ONLY
        return self.regime if self.regime is not None else self.outcome


class PhaseRunner:
    """Runs filaments that differ in their groups, side by side; equations, graph and C code are made once.

    Parameters
    ----------
    scene : Scene
        What they have in common.
    workers : int
        Threads, where they run in this process.
    progress : MembersProgress
        Told how far a batch is.
    place : Workplace, optional
        Where they run, if not in this process.
    kept : KeptRuns, optional
        Runs that were finished before, and where those finished now are kept.
    """

    def __init__(
        self,
        scene: Scene,
        workers: int,
        progress: MembersProgress,
        place: Workplace | None = None,
        kept: KeptRuns | None = None,
    ) -> None:
        self._scene, self._progress = scene, progress
        self._place, self._kept = place or Embedded(workers), kept
        self._work = PhaseWork(scene)

    def run(self, places: Sequence[Place], durations: Sequence[float] | None = None) -> list[PhaseRun]:
        """Run one filament for each place.

        Parameters
        ----------
        places : sequence of Place
            Their groups.
        durations : sequence of float, optional
            How long each is watched [s]; :func:`duration_at` if not given.

        Raises
        ------
        SceneError
            If a filament cannot be had.
        KeyboardInterrupt
            If the user stops it: no thread goes on.
        """
        watched = durations or [duration_at(self._scene, place) for place in places]
        asked = list(zip(places, watched, strict=True))
        found = {} if self._kept is None else {one: self._kept.runs[one] for one in asked if one in self._kept.runs}
        blocks = blocks_of([one for one in asked if one not in found], _BLOCK)

        def keep(number: int, runs: Sequence[PhaseRun]) -> None:
            finished = dict(zip(blocks[number].items, runs, strict=True))
            found.update(finished)
            if self._kept is not None:
                self._kept.keep(finished)

        told = Count(len(asked), len(found), self._progress)
        run_blocks(self._work, blocks, self._place, told, keep)
        return [found[one] for one in asked]


@dataclass(frozen=True)
class PhaseWork:
    """What is done with places; it can be sent to another process.

    Attributes
    ----------
    scene : Scene
        What the filaments have in common.
    """

    scene: Scene

    def run(self, items: Sequence[Watched], threads: int, told: Told) -> list[PhaseRun]:
        """Run filaments, each for its time, `threads` of them at once.

        Raises
        ------
        SceneError
            If a filament cannot be had.
        """
        members = members_of(self.scene, [row_of(self.scene, *item) for item in items], "once")
        # CasADi keeps Python's lock while it integrates: threads would only wait for each other.
        threads = threads if all(member.parallel for member in members) else 1
        stop, workshop = Stop(), shared_workshop(self.scene.to_toml())
        pairs = [(place, member) for (place, _), member in zip(items, members, strict=True)]
        return side_by_side(lambda pair: _one(*pair, workshop, stop), pairs, threads, stop, lambda _: told(1))

    def lost(self, item: Watched, why: str) -> PhaseRun:
        """The run of a filament that has killed whoever ran it: no answer."""
        place, duration = item
        none = LocalStrains(0.0, 0.0)
        return PhaseRun(place, None, "lost", why, duration, None, 1, 0.0, 0.0, 0.0, none, none, 0)


def _one(place: Place, member: Member, workshop: Workshop, stop: Stop) -> PhaseRun:
    """Run a filament; one that is no answer once more, to the time at which it has fallen past every catenary.

    What descends for ever is drawn out in the end, and then it is no answer: what it did before is one.
    """
    first, sag = _run(place, member, workshop, stop)
    if first.regime is not None or not np.any(sag > PASSED):
        return first
    frames = member.scene.run.frames
    short = first.duration * float(np.argmax(sag > PASSED)) / (frames - 1)
    run = member.scene.run.model_copy(update={"duration": short})
    shorter = replace(member, scene=member.scene.model_copy(update={"run": run}))
    second, _ = _run(place, shorter, workshop, stop)
    steps = first.steps + second.steps
    if second.regime != DESCENDING:
        return replace(first, runs=2, steps=steps)
    return replace(second, runs=2, steps=steps, drawn_out=first.duration)


def _run(place: Place, member: Member, workshop: Workshop, stop: Stop) -> tuple[PhaseRun, Floats]:
    """A run, and its sag over the span, shape (frames,)."""
    scene, one = member.scene, judged(member, workshop, stop)
    rate, span_rate = _rates(scene, one.prepared, one.fields["plastic_rate"])
    sag = -one.midpoint / rest_length(scene)
    run = PhaseRun(
        place,
        one.regime,
        one.outcome.name,
        one.complaint,
        scene.run.duration,
        None,
        1,
        float(sag[-1]),
        rate,
        span_rate,
        _strains(one.fields, 0),
        _strains(one.fields, one.fields["stretch"].shape[1] // 2),
        one.solution.steps,
    )
    return run, sag


def _rates(scene: Scene, prepared: Prepared, rate: Floats) -> tuple[float, float]:
    """Largest plastic rate of the last tenth over sigma_Y/eta: everywhere, and away from the ends."""
    material, span = scene.material, rest_length(scene)
    pace = (material.yield_stress or 0.0) / (material.viscosity or np.inf)
    if not pace:
        return 0.0, 0.0
    last = rate[min(len(rate) - 1, int((1 - ARREST_TIME) * (len(rate) - 1))) :]
    cells = node_positions(prepared.graph, span)[1]
    away = np.abs(cells) < (0.5 - CLAMP_REGION) * span
    return float(np.max(last)) / pace, float(np.max(last[:, away])) / pace


def _strains(fields: dict[str, Floats], cell: int) -> LocalStrains:
    """Strain in the last frame, eps = log s - theta_s z at z of the outer fibres, with the present thickness."""
    stretch, curvature, thickness = (float(fields[name][-1, cell]) for name in ("stretch", "curvature", "thickness"))
    centreline = float(np.log(stretch))
    return LocalStrains(centreline, centreline + abs(curvature) * thickness / 2)
