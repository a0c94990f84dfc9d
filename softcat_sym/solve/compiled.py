"""Integration in time by the C runtime, which knows nothing of Python: the fastest there is."""

from __future__ import annotations

import ctypes as ct
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from softcat_sym.codegen.sites import Sites
from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats
from softcat_sym.solve import c_model
from softcat_sym.solve.c_model import Answer, CModel, Run, Status, runtime_sources
from softcat_sym.solve.checkpoint import Checkpoint, checkpoint_of
from softcat_sym.solve.outcome import Outcome
from softcat_sym.solve.progress import Flagged, Progress
from softcat_sym.solve.record import POWERS, Reached, at_start
from softcat_sym.solve.settings import Settings
from softcat_sym.solve.solution import Solution
from softcat_sym.solve.starting import Start

_BESIDE = 1e-9
_LOOK = 0.1  # s between two looks at how far it has got
_MOST_STEPS, _STEPS_PER_FRAME = 1_000_000, 500  # minutes of work: whatever needs more gets nowhere
_OUTCOMES = {
    c_model.STEP_LIMIT: Outcome.step_limit,
    c_model.STEP_TOO_SMALL: Outcome.no_convergence,
    c_model.NON_FINITE: Outcome.non_finite,
    c_model.SINGULAR: Outcome.no_convergence,
    c_model.NO_CONVERGENCE: Outcome.no_convergence,
}


@dataclass(frozen=True)
class CompiledFilament:
    """A compiled model with the geometry of one grid.

    Attributes
    ----------
    model : CModel
        What is integrated.
    sites : Sites
        Where the unknowns of the graph are in it.
    places : ndarray, shape (sites, places)
        Geometry.
    """

    model: CModel
    sites: Sites
    places: Floats


@dataclass(frozen=True)
class _UnderWay:
    """A run that is being integrated.

    Attributes
    ----------
    filament : CompiledFilament
        What it is.
    run : Run
        From where on.
    room : Answer
        Where the frames go.
    known : Reached
        The frames before, the one it begins from included.
    """

    filament: CompiledFilament
    run: Run
    room: Answer
    known: Reached

    def reached(self, time: float) -> Reached:
        """All frames up to a time."""
        new = int(np.count_nonzero(self.run.times <= time))
        known, steps = self.known, self.known.steps + int(self.room.status.steps)
        if new <= 1:
            return replace(known, steps=steps)
        x, z = self.filament.sites.vectors(self.room.states[1:new])
        quad = np.zeros((POWERS, new - 1))
        quad[: self.room.work.shape[1]] = self.room.work[1:new].T
        quad += known.quad[:, -1:]
        return Reached(np.hstack([known.x, x]), np.hstack([known.z, z]), np.hstack([known.quad, quad]), steps)

    def to_go_on_from(self, time: float) -> Reached:
        """The same, but that it does not end on a kink: where f jumps, algebraic unknowns are yet to jump with it."""
        past = self.run.times[self.run.times <= time]
        on_kink = len(past) > 1 and bool(np.any(self.run.kinks == past[-1]))
        return self.reached(past[-2] if on_kink else time)


@dataclass(frozen=True)
class CompiledIntegration:
    """A prepared run of the C model.

    Attributes
    ----------
    graph : Graph
        The same filament, for names.
    settings : Settings
        Tolerances.
    filament : CompiledFilament
        What is integrated.
    frames : int
        Output times, t = 0 included.
    kinks : ndarray
        Times, in units of the time scale, at which a support changes pace.
    """

    graph: Graph
    settings: Settings
    filament: CompiledFilament
    frames: int
    kinks: Floats

    def run(self, start: Start, p: Floats, duration: float, scale: float, progress: Progress) -> Solution:
        """Integrate from a filament at rest; parameters as :meth:`softcat_sym.solve.integrate.Integration.run`."""
        asked = self._asked(start, p, np.linspace(0.0, duration, self.frames), scale)
        checkpoint = checkpoint_of(progress, lambda: self._identity(asked))
        known = checkpoint.before if checkpoint is not None else None
        known = known or at_start(start.x, start.z)
        if known.frames == self.frames:
            return Solution(asked.times, known.x, known.z, known.quad, Outcome.solved, "", known.steps)
        state = self.filament.sites.state(known.x[:, -1], known.z[:, -1])
        run = replace(asked, state=state, times=asked.times[known.frames - 1 :])
        return self._integrated(run, asked.times, known, scale, progress, checkpoint)

    def piece(
        self,
        start: Start,
        p: Floats,
        times: tuple[float, float, float],
        samples: int,
        scale: float,
        progress: Progress,
    ) -> Solution:
        """Integrate a part; parameters as :meth:`softcat_sym.solve.run.Prepared.piece`."""
        begin, first, end = times
        # Where there is nothing before the samples, the first of them lies just behind the start.
        first = max(first, begin + _BESIDE * (end - begin))
        every = np.concatenate([[begin], np.linspace(first, end, samples + 1)])
        run = self._asked(start, p, every, scale)
        return self._integrated(run, every, at_start(start.x, start.z), scale, progress, None)

    def _asked(self, start: Start, p: Floats, times: Floats, scale: float) -> Run:
        return Run(
            parameters=np.ascontiguousarray(p),
            places=self.filament.places,
            state=self.filament.sites.state(start.x, start.z),
            times=times,
            relative=self.settings.rtol,
            absolute=self.settings.absolute(slot.name for slot in self.filament.model.model.slots),
            # Without inertia only flow limits the steps: where little flows the work would be left to chance.
            work_absolute=0.0 if "v" in self.graph.x_kinds else self.settings.atol,
            kinks=self.kinks,
            most_steps=max(_MOST_STEPS, _STEPS_PER_FRAME * len(times)),
            max_step=(self.settings.max_step or 0.0) / scale,
        )

    def _integrated(
        self,
        run: Run,
        times: Floats,
        known: Reached,
        scale: float,
        progress: Progress,
        checkpoint: Checkpoint | None,
    ) -> Solution:
        """Integrate, and put what comes of it behind what is known already."""
        status = Status()
        under_way = _UnderWay(self.filament, run, self.filament.model.room(run, status), known)
        self._watched(under_way, scale, progress, checkpoint)
        c_model.refuse(status.code, self.filament.model.message(status.code))
        found = under_way.reached(status.reached)
        outcome, complaint = Outcome.solved, ""
        if status.code != c_model.SOLVED:
            outcome, complaint = _OUTCOMES[status.code], self._complaint(status, scale)
        return Solution(times[: found.frames], found.x, found.z, found.quad, outcome, complaint, found.steps)

    def _identity(self, run: Run) -> Iterator[bytes]:
        """All that decides the numbers."""
        yield from (text.encode() for text in (self.filament.model.model.text, *runtime_sources().values()))
        yield from (part.tobytes() for part in (run.parameters, run.places, run.state, run.times, run.kinks))
        yield np.array(
            [
                run.relative,
                run.work_absolute,
                run.max_step,
                run.method,
                run.most_steps,
                *np.atleast_1d(run.absolute),
            ]
        ).tobytes()

    def _watched(self, under_way: _UnderWay, scale: float, progress: Progress, checkpoint: Checkpoint | None) -> None:
        """Integrate in a thread, so that Ctrl-C is heard and progress is told meanwhile; a flagged one needs none.

        Raises
        ------
        KeyboardInterrupt
            If the user stops it.
        MemoryError
            If the frames do not fit into memory.
        """
        status, integrate = under_way.room.status, self.filament.model.integrate

        def tell() -> None:
            reached = status.reached * scale
            progress.update(reached, reached / status.steps if status.steps else None)

        if isinstance(progress, Flagged):
            integrate(under_way.run, status, progress.flag, under_way.room)
            tell()
            return
        stop = ct.c_int(0)
        try:
            with ThreadPoolExecutor(1) as pool:
                answer = pool.submit(integrate, under_way.run, status, stop, under_way.room)
                try:
                    # Of the look before: what was written into memory then is there by now.
                    seen = under_way.run.times[0]
                    while not wait([answer], _LOOK).done:
                        tell()
                        if checkpoint is not None:
                            checkpoint.offer(partial(under_way.to_go_on_from, seen))
                            seen = status.reached
                finally:
                    stop.value = 1
        except KeyboardInterrupt:
            if checkpoint is not None:
                checkpoint.leave(partial(under_way.to_go_on_from, status.reached))
            raise
        tell()
        answer.result()
        if checkpoint is not None and status.code == c_model.SOLVED:
            checkpoint.finish(partial(under_way.reached, status.reached))

    def _complaint(self, status: Status, scale: float) -> str:
        """Time, worst component and what went wrong."""
        worst = ""
        if status.worst_slot >= 0:
            name, site = self.filament.model.model.slots[status.worst_slot].name, status.worst_site
            worst = f"; worst: {name}[{site}] at X/L = {self.graph.grid.nodes[site]:.4g}"
        return f"stopped after t = {status.reached * scale:.6g} s{worst}; {self.filament.model.message(status.code)}"
