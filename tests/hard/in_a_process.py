"""Cases in a process of their own, ended by its processor time: a case that hangs is a row of the table."""

from __future__ import annotations

import time
from dataclasses import dataclass
from multiprocessing.connection import Connection

import softcat_sym as sc
from softcat_sym.errors import SceneError
from tests.limited_process import LimitedProcess, limit_this_process

from .case import Case
from .cases import CASES
from .invariants import violations

RUN, JUDGE = 60.0, 120.0
"""Seconds of the processor that the run of a case may take, and its judge: limits are runs of their own."""

TOO_LONG = "too long"


@dataclass(frozen=True)
class Seen:
    """What came of a case: its outcome, error, estimate, seconds of the run, and what it breaks."""

    outcome: str
    message: str = ""
    is_success: bool = False
    error: float | None = None
    estimate: float | None = None
    seconds: float = 0.0
    broken: tuple[str, ...] = ()


class CaseWorker:
    """One process that runs cases one after another, and is replaced by a fresh one when a case takes too long."""

    def __init__(self) -> None:
        self._process = LimitedProcess(_serve)

    def see(self, case: Case) -> Seen:
        """Run and judge one case within the limits."""
        answers, died = self._process.ask(case.title, (RUN, JUDGE))
        if len(answers) == 2:
            judged: Seen = answers[1]
            return judged
        if died:
            return Seen("died", died)
        if not answers:
            return Seen(TOO_LONG, f"no answer within {RUN:g} s", seconds=RUN)
        return Seen(TOO_LONG, f"{answers[0].outcome}, but not judged within {JUDGE:g} s", seconds=answers[0].seconds)

    def close(self) -> None:
        """End the process."""
        self._process.close()


def _serve(there: Connection) -> None:
    by_title = {case.title: case for case in CASES}
    there.send("ready")
    while True:
        try:
            case = by_title[there.recv()]
        except EOFError:
            return
        limit_this_process(RUN)
        began = time.process_time()
        try:
            run = sc.simulate(case.scene())
        except SceneError as refusal:
            run, seen = None, Seen("SceneError", str(refusal), seconds=time.process_time() - began)
        else:
            told, found = run.summary, run.summary["error_estimate"]
            seen = Seen(
                run.outcome.name,
                f"{told['message']}; {told['advice']}",
                run.outcome.is_success,
                estimate=found["total"] if found else None,
                seconds=time.process_time() - began,
            )
        limit_this_process(JUDGE)
        there.send(seen)
        there.send(_judged(case, run, seen))
        limit_this_process(0)


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
    return Seen(seen.outcome, seen.message, True, error, seen.estimate, seen.seconds, tuple(broken))
