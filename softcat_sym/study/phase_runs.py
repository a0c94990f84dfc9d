"""The runs behind a phase diagram: each filament through the compiled solver, judged as a single run is judged."""

from __future__ import annotations

import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.ensemble.members import Member, members_of
from softcat_sym.ensemble.progress import MembersProgress
from softcat_sym.ensemble.running import Stop
from softcat_sym.ensemble.shared import Workshop
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, rest_length
from softcat_sym.solve import Outcome, Prepared, Solution
from softcat_sym.study.phase_plane import Place, duration_at, row_of
from softcat_sym.trajectory.energy import energy_residual
from softcat_sym.trajectory.fields import least_energy, node_positions, whole_span_fields
from softcat_sym.trajectory.regime import ARREST_RATE, ARREST_TIME, regime_of
from softcat_sym.trajectory.verdict import verdict

PASSED = 0.5
"""Sag over span beyond which no catenary rests: the one of least stress sags by 0.338 (3.12, exact)."""

CLAMP_REGION = 0.1
"""Share of the span next to each end that is not counted as the span: hinges are much shorter."""

DESCENDING = "descending"

CLAMPS_ONLY = "descending-at-clamps"
"""Mark of a descending filament whose span, `CLAMP_REGION` away from the ends, counts as arrested by itself."""


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
        Threads.
    progress : MembersProgress
        Told how far a batch is.
    """

    def __init__(self, scene: Scene, workers: int, progress: MembersProgress) -> None:
        self._scene, self._workers, self._progress = scene, workers, progress
        self._workshop = Workshop()

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
        rows = [row_of(self._scene, place, time) for place, time in zip(places, watched, strict=True)]
        members = members_of(self._scene, rows, "once")
        # CasADi keeps Python's lock while it integrates: threads would only wait for each other.
        workers = self._workers if all(member.parallel for member in members) else 1
        stop, begun = Stop(), time.monotonic()
        with ThreadPoolExecutor(workers, thread_name_prefix="softcat-phase") as pool:
            try:
                futures = [pool.submit(self._one, *pair, stop) for pair in zip(places, members, strict=True)]
                for done, future in enumerate(as_completed(futures), start=1):
                    future.result()
                    spent = time.monotonic() - begun
                    self._progress.update(done, len(futures), spent / done * (len(futures) - done))
            finally:
                stop.tell()
                pool.shutdown(cancel_futures=True)
        return [future.result() for future in futures]

    def _one(self, place: Place, member: Member, stop: Stop) -> PhaseRun:
        """Run a filament; one that is no answer once more, to the time at which it has fallen past every catenary.

        What descends for ever is drawn out in the end, and then it is no answer: what it did before is one.
        """
        first, sag = self._judged(place, member, stop)
        if first.regime is not None or not np.any(sag > PASSED):
            return first
        frames = member.scene.run.frames
        short = first.duration * float(np.argmax(sag > PASSED)) / (frames - 1)
        run = member.scene.run.model_copy(update={"duration": short})
        second, _ = self._judged(place, replace(member, scene=member.scene.model_copy(update={"run": run})), stop)
        steps = first.steps + second.steps
        if second.regime != DESCENDING:
            return replace(first, runs=2, steps=steps)
        return replace(second, runs=2, steps=steps, drawn_out=first.duration)

    def _judged(self, place: Place, member: Member, stop: Stop) -> tuple[PhaseRun, Floats]:
        """A run, and its sag over the span, shape (frames,)."""
        stop.update(0.0, None)
        scene = member.scene
        prepared = self._workshop.prepare(member)
        solution = prepared.solve(stop)
        fields = whole_span_fields(scene, prepared, solution)
        outcome, complaint = _verdict(member, prepared, solution, fields)
        midpoint = fields["y"][:, fields["y"].shape[1] // 2]
        regime = regime_of(scene, member.effects, fields, midpoint) if outcome.is_success else None
        rate, span_rate = _rates(scene, prepared, fields["plastic_rate"])
        sag = -midpoint / rest_length(scene)
        run = PhaseRun(
            place,
            regime,
            outcome.name,
            complaint,
            scene.run.duration,
            None,
            1,
            float(sag[-1]),
            rate,
            span_rate,
            _strains(fields, 0),
            _strains(fields, fields["stretch"].shape[1] // 2),
            solution.steps,
        )
        return run, sag


def _verdict(member: Member, prepared: Prepared, solution: Solution, fields: dict[str, Floats]) -> tuple[Outcome, str]:
    scene, graph = member.scene, prepared.graph
    nodes = node_positions(graph, rest_length(scene))[0]
    audits = graph.conserves_energy and prepared.integration is not None
    residual = energy_residual(fields, least_energy(scene)) if audits else 0.0
    return verdict(scene, member.effects, solution, fields, nodes, residual)


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
