"""Runs in processes of their own that are ended when they take too long: a run that hangs is found, not waited for."""

from __future__ import annotations

import json
import tempfile
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from multiprocessing.connection import Connection
from typing import Any

from tests.limited_process import LimitedProcess, limit_this_process

from .scene_runs import Answer, answer

_LATE = "no answer within"


def is_late(answer: Answer) -> bool:
    """Whether a scene was ended for the time it took: no exception, no process that died of its own."""
    return not answer.outcome and answer.broken[0].startswith(_LATE)


class Worker:
    """One process that answers scenes one after another.

    Parameters
    ----------
    limit : float
        Of one scene, in seconds of the processor.
    """

    def __init__(self, limit: float) -> None:
        self._limit, self._process = limit, LimitedProcess(_serve)

    def answer(self, table: dict[str, Any]) -> Answer:
        """Answer one scene within the limit; else its answer says that there was none."""
        answers, died = self._process.ask((table, self._limit), (self._limit,))
        if answers:
            found: Answer = answers[0]
            return found
        why = died or f"{_LATE} {self._limit:g} s"
        return Answer(json.dumps(table), table["material"]["law"], "", broken=(why,), seconds=self._limit)

    def close(self) -> None:
        """End the process."""
        self._process.close()


def _serve(there: Connection) -> None:
    import softcat_sym.simulate  # noqa: F401  imported before the clock runs

    there.send("ready")
    with tempfile.TemporaryDirectory() as folder:
        while True:
            try:
                table, limit = there.recv()
            except EOFError:
                return
            limit_this_process(limit)
            found = answer(table, folder)
            limit_this_process(0)
            there.send(found)


@contextmanager
def workers(number: int, limit: float) -> Iterator[ThreadPoolExecutor]:
    """Threads of which each has a process: submit `of_this_thread` to them.

    Parameters
    ----------
    number : int
        Of processes.
    limit : float
        Of one scene, in seconds of the processor.
    """
    made: list[Worker] = []

    def start() -> None:
        _local.worker = Worker(limit)
        made.append(_local.worker)

    try:
        with ThreadPoolExecutor(number, initializer=start) as threads:
            yield threads
    finally:
        for worker in made:
            worker.close()


_local = threading.local()


def of_this_thread(table: dict[str, Any]) -> Answer:
    """Answer a scene by the process of the calling thread."""
    worker: Worker = _local.worker
    return worker.answer(table)
