"""Runs in processes of their own that are ended when they take too long: a run that hangs is found, not waited for."""

from __future__ import annotations

import json
import signal
import tempfile
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from multiprocessing.connection import Connection
from typing import Any

from .scene_runs import Answer, answer

_START = 120.0  # s that a fresh process may take to import everything
_PATIENCE = 20.0
"""Wall-clock time over processor time: a busy machine shares its processors, a process that sleeps uses none."""


class Worker:
    """One process that answers scenes one after another, and is replaced by a fresh one when it hangs or dies.

    Parameters
    ----------
    limit : float
        Of one scene, in seconds of the processor.
    """

    def __init__(self, limit: float) -> None:
        self._limit = limit
        self._start()

    def _start(self) -> None:
        context = get_context("spawn")
        self._here, there = context.Pipe()
        self._process = context.Process(target=_serve, args=(there,), daemon=True)
        self._process.start()
        there.close()
        if self._here.poll(_START):
            self._here.recv()

    def answer(self, table: dict[str, Any]) -> Answer:
        """Answer one scene within the limit; else its answer says that there was none."""
        why = f"no answer within {self._limit:g} s"
        try:
            self._here.send((table, self._limit))
            if self._here.poll(self._limit * _PATIENCE):
                found: Answer = self._here.recv()
                return found
        except (EOFError, OSError):
            self._process.join()
            if self._process.exitcode != -signal.SIGPROF:
                why = f"the process died with {self._process.exitcode}"
        self.close()
        self._start()
        return Answer(json.dumps(table), table["material"]["law"], "", broken=(why,), seconds=self._limit)

    def close(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.join()
        self._here.close()


def _serve(there: Connection) -> None:
    import softcat_sym.simulate  # noqa: F401  imported before the clock runs

    there.send("ready")
    with tempfile.TemporaryDirectory() as folder:
        while True:
            try:
                table, limit = there.recv()
            except EOFError:
                return
            # Its signal ends the process, whatever library is at work.
            signal.setitimer(signal.ITIMER_PROF, limit)
            found = answer(table, folder)
            signal.setitimer(signal.ITIMER_PROF, 0)
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
