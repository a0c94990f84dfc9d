"""Members integrated side by side, in threads: the compiled solver works outside Python."""

from __future__ import annotations

import ctypes
import os
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from softcat_sym.ensemble.members import Member
from softcat_sym.ensemble.progress import MembersProgress
from softcat_sym.ensemble.shared import Workshop
from softcat_sym.ensemble.verdict import verdict
from softcat_sym.errors import SoftcatError
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import rest_length
from softcat_sym.solve import Outcome, Silence, Solution
from softcat_sym.trajectory.midpoint import midpoint_heights

Item = TypeVar("Item")
Done = TypeVar("Done")


@dataclass(frozen=True)
class Record:
    """What is kept of a member's run.

    Attributes
    ----------
    midpoint : ndarray, shape (frames,)
        [m]; NaN after the time that was reached.
    outcome : Outcome
        How it ended.
    complaint : str
        Why, if that was no success.
    reached : float
        Last frame [s].
    energy_residual : float
        Between the first and the last frame, relative to the largest energy in them.
    steps : int
        Of the integrator.
    wall : float
        Seconds, waiting for other threads included.
    """

    midpoint: Floats
    outcome: Outcome
    complaint: str
    reached: float
    energy_residual: float
    steps: int
    wall: float


class Stop(Silence):
    """Ends integrations from outside: as their listener, it raises when told to.

    Attributes
    ----------
    flag : ctypes.c_int
        Not zero from then on.
    """

    def __init__(self) -> None:
        self.flag = ctypes.c_int(0)

    def tell(self) -> None:
        """Let no integration go on."""
        self.flag.value = 1

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Look whether to stop.

        Raises
        ------
        KeyboardInterrupt
            If so.
        """
        del simulated_time, step_size
        if self.flag.value:
            raise KeyboardInterrupt


def workers_of(workers: int | None) -> int:
    """As many as asked, otherwise one for each core that this process may use.

    Raises
    ------
    SoftcatError
        If less than one is asked for.
    """
    if workers is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise SoftcatError(f"workers = {workers!r}: give a whole number of threads, 1 or more, or None for all cores")
    return workers


def run_all(members: Sequence[Member], workshop: Workshop, workers: int, progress: MembersProgress) -> list[Record]:
    """Run the members, `workers` at a time.

    Returns
    -------
    list of Record
        In the order of the members.

    Raises
    ------
    KeyboardInterrupt
        If the user stops it: no thread goes on.
    SoftcatError
        If the compiler refuses or memory is short.
    """
    begun, stop = time.monotonic(), Stop()

    def told(done: int) -> None:
        progress.update(done, len(members), (time.monotonic() - begun) / done * (len(members) - done))

    return side_by_side(lambda member: _run(member, workshop, stop), members, workers, stop, told)


def side_by_side(
    work: Callable[[Item], Done], items: Sequence[Item], workers: int, stop: Stop, told: Callable[[int], None]
) -> list[Done]:
    """Work on items in threads.

    Parameters
    ----------
    work : callable
        Its integrations listen to `stop`.
    items : sequence
        What is worked on.
    workers : int
        How many at a time.
    stop : Stop
        Told if this ends before all are done.
    told : callable
        Given the number of items done, after each.

    Returns
    -------
    list
        What `work` returns, in the order of the items.

    Raises
    ------
    KeyboardInterrupt
        If the user stops it: no thread goes on. What `work` raises is raised too.
    """
    with ThreadPoolExecutor(workers, thread_name_prefix="softcat-member") as pool:
        try:
            futures = [pool.submit(work, item) for item in items]
            for done, future in enumerate(as_completed(futures), start=1):
                future.result()
                told(done)
        finally:
            stop.tell()
            pool.shutdown(cancel_futures=True)
    return [future.result() for future in futures]


def _run(member: Member, workshop: Workshop, stop: Stop) -> Record:
    begun = time.perf_counter()
    scene = member.scene
    stop.update(0.0, None)
    prepared = workshop.prepare(member)
    solution = prepared.solve(stop)
    # Without velocities the work against the necking gradient is summed over frames.
    judged = _first_and_last(solution) if prepared.graph.has_velocities else solution
    outcome, complaint, residual = verdict(member, prepared, judged)
    midpoint = np.full(scene.run.frames, np.nan)
    heights = midpoint_heights(prepared.graph, solution) * rest_length(scene)
    midpoint[: len(solution.time)] = heights + 0.0  # no minus zero
    reached = float(solution.time[-1]) * prepared.scale
    wall = time.perf_counter() - begun
    return Record(midpoint, outcome, complaint, reached, residual, solution.steps, wall)


def _first_and_last(solution: Solution) -> Solution:
    ends = [0, -1]
    return replace(
        solution,
        time=solution.time[ends],
        x=solution.x[:, ends],
        z=solution.z[:, ends],
        quad=solution.quad[:, ends],
    )
