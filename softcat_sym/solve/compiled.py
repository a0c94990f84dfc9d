"""Integration in time by the C runtime, which knows nothing of Python: the fastest there is."""

from __future__ import annotations

import ctypes as ct
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass

import numpy as np

from softcat_sym.codegen.sites import Sites
from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats
from softcat_sym.solve import c_model
from softcat_sym.solve.c_model import CModel, Run, Status
from softcat_sym.solve.outcome import Outcome
from softcat_sym.solve.progress import Flagged, Progress
from softcat_sym.solve.settings import Settings
from softcat_sym.solve.solution import Solution
from softcat_sym.solve.starting import Start

_LOOK = 0.1  # s between two looks at how far it has got
_STEPS_PER_FRAME = 100_000
_OUTCOMES = {
    c_model.STEP_LIMIT: Outcome.step_limit,
    c_model.STEP_TOO_SMALL: Outcome.no_convergence,
    c_model.NON_FINITE: Outcome.non_finite,
    c_model.SINGULAR: Outcome.no_convergence,
    c_model.NO_CONVERGENCE: Outcome.no_convergence,
}
_POWERS = 3


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
        run = Run(
            parameters=np.ascontiguousarray(p),
            places=self.filament.places,
            state=self.filament.sites.state(start.x, start.z),
            times=np.linspace(0.0, duration, self.frames),
            relative=self.settings.rtol,
            absolute=self.settings.atol,
            # Without inertia only flow limits the steps: where little flows the work would be left to chance.
            work_absolute=0.0 if "v" in self.graph.x_kinds else self.settings.atol,
            kinks=self.kinks,
            most_steps=_STEPS_PER_FRAME * self.frames,
        )
        status = Status()
        answer = self._watched(run, status, scale, progress)
        c_model.refuse(status.code, self.filament.model.message(status.code))
        reached = int(np.count_nonzero(run.times <= status.reached))
        x, z = self.filament.sites.vectors(answer.states[:reached])
        quad = np.zeros((_POWERS, reached))
        quad[: answer.work.shape[1]] = answer.work[:reached].T
        outcome, complaint = Outcome.solved, ""
        if status.code != c_model.SOLVED:
            outcome, complaint = _OUTCOMES[status.code], self._complaint(status, scale)
        return Solution(run.times[:reached], x, z, quad, outcome, complaint, int(status.steps))

    def _watched(self, run: Run, status: Status, scale: float, progress: Progress) -> c_model.Answer:
        """Integrate in a thread, so that Ctrl-C is heard and progress is told meanwhile; a flagged one needs none.

        Raises
        ------
        KeyboardInterrupt
            If the user stops it.
        MemoryError
            If the frames do not fit into memory.
        """

        def tell() -> None:
            reached = status.reached * scale
            progress.update(reached, reached / status.steps if status.steps else None)

        if isinstance(progress, Flagged):
            found = self.filament.model.integrate(run, status, progress.flag)
            tell()
            return found
        stop = ct.c_int(0)
        with ThreadPoolExecutor(1) as pool:
            answer = pool.submit(self.filament.model.integrate, run, status, stop)
            try:
                while not wait([answer], _LOOK).done:
                    tell()
            finally:
                stop.value = 1
        tell()
        return answer.result()

    def _complaint(self, status: Status, scale: float) -> str:
        """Time, worst component and what went wrong."""
        worst = ""
        if status.worst_slot >= 0:
            name, site = self.filament.model.model.slots[status.worst_slot].name, status.worst_site
            worst = f"; worst: {name}[{site}] at X/L = {self.graph.grid.nodes[site]:.4g}"
        return f"stopped after t = {status.reached * scale:.6g} s{worst}; {self.filament.model.message(status.code)}"
