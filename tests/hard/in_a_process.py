"""Cases in a process of their own, ended by its processor time: a case that hangs is a row of the table."""

from __future__ import annotations

import signal
import time
from dataclasses import dataclass
from multiprocessing import get_context

import softcat_sym as sc
from softcat_sym.errors import SceneError

from .case import Case
from .cases import CASES
from .invariants import violations

RUN, JUDGE = 60.0, 120.0
"""Seconds of the processor that the run of a case may take, and its judge: limits are runs of their own."""

_START = 120.0  # s in which a fresh process imports everything
_PATIENCE = 20.0
"""Wall-clock time over processor time: a busy machine shares its processors, a process that sleeps uses none."""

TOO_LONG = "too long"


@dataclass(frozen=True)
class Seen:
    """What came of a case: its outcome, error, estimate, seconds of the run, and what it breaks."""

    outcome: str
    complaint: str = ""
    is_success: bool = False
    error: float | None = None
    estimate: float | None = None
    seconds: float = 0.0
    broken: tuple[str, ...] = ()


class CaseWorker:
    """One process that runs cases one after another, and is replaced by a fresh one when a case takes too long."""

    def __init__(self) -> None:
        self._start()

    def _start(self) -> None:
        context = get_context("spawn")
        self._here, there = context.Pipe()
        self._process = context.Process(target=_serve, args=(there,), daemon=True)
        self._process.start()
        there.close()
        if self._here.poll(_START):
            self._here.recv()

    def see(self, case: Case) -> Seen:
        """Run and judge one case within the limits."""
        ran = None
        try:
            self._here.send(case.title)
            if self._here.poll(RUN * _PATIENCE):
                ran = self._here.recv()
                if self._here.poll(JUDGE * _PATIENCE):
                    judged: Seen = self._here.recv()
                    return judged
        except (EOFError, OSError):
            self._process.join()
        died = self._process.exitcode
        self.close()
        self._start()
        if died not in (None, -signal.SIGPROF):
            return Seen("died", f"the process died with {died}")
        if ran is None:
            return Seen(TOO_LONG, f"no answer within {RUN:g} s", seconds=RUN)
        return Seen(TOO_LONG, f"{ran.outcome}, but not judged within {JUDGE:g} s", seconds=ran.seconds)

    def close(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.join()
        self._here.close()


def _serve(there: object) -> None:
    from multiprocessing.connection import Connection

    assert isinstance(there, Connection)
    by_title = {case.title: case for case in CASES}
    there.send("ready")
    while True:
        try:
            case = by_title[there.recv()]
        except EOFError:
            return
        # Its signal ends the process, whatever library is at work.
        signal.setitimer(signal.ITIMER_PROF, RUN)
        began = time.process_time()
        try:
            run = sc.simulate(case.scene())
        except SceneError as refusal:
            run, seen = None, Seen("SceneError", str(refusal), seconds=time.process_time() - began)
        else:
            told, found = run.summary, run.summary["error_estimate"]
            seen = Seen(
                run.outcome.name,
                f"{told['complaint']}; {told['advice']}",
                run.outcome.is_success,
                estimate=found["total"] if found else None,
                seconds=time.process_time() - began,
            )
        signal.setitimer(signal.ITIMER_PROF, JUDGE)
        there.send(seen)
        there.send(_judged(case, run, seen))
        signal.setitimer(signal.ITIMER_PROF, 0)


def _judged(case: Case, run: sc.Trajectory | None, seen: Seen) -> Seen:
    """With the error of a success, and the invariants that it breaks."""
    if run is None or not seen.is_success:
        return seen
    broken = [f"{name} {by}" for name, by in violations(run).items()]
    error = None
    try:
        error = case.judge(run) if case.judge is not None else None
    except (AssertionError, SceneError) as fault:
        broken.append(f"nothing to judge by: {fault}")
    return Seen(seen.outcome, seen.complaint, True, error, seen.estimate, seen.seconds, tuple(broken))
