"""A process that answers one question after another, and is ended and replaced when one takes too long.

What hangs inside a library hears no exception: only the end of its process stops it.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, closing
from multiprocessing import get_context
from multiprocessing.connection import Connection
from queue import SimpleQueue
from typing import Any

START = 120.0  # s in which a fresh process imports everything
PATIENCE = 20.0
"""Wall-clock time over processor time: a busy machine shares its processors, a process that sleeps uses none."""

Ask = Callable[[object, Sequence[float]], tuple[list[Any], str]]
"""See :meth:`LimitedProcess.ask`."""


class LimitedProcess:
    """One process, replaced by a fresh one when it hangs or dies."""

    def __init__(self, serve: Callable[[Connection], None]) -> None:
        self._serve = serve
        self._start()

    def _start(self) -> None:
        context = get_context("spawn")
        self._here, there = context.Pipe()
        self._process = context.Process(target=self._serve, args=(there,), daemon=True)
        self._process.start()
        there.close()
        if self._here.poll(START):
            self._here.recv()

    def ask(self, question: object, limits: Sequence[float]) -> tuple[list[Any], str]:
        """Send a question; as many answers as there are limits, in seconds of the processor."""
        answers: list[Any] = []
        try:
            self._here.send(question)
            for limit in limits:
                if not self._here.poll(limit * PATIENCE):
                    break
                answers.append(self._here.recv())
            else:
                return answers, ""
        except (EOFError, OSError):
            self._process.join()
        died = self._process.exitcode
        self.close()
        self._start()
        return answers, "" if died in (None, -signal.SIGPROF) else f"the process died with {died}"

    def close(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.join()
        self._here.close()


def side_by_side(
    serve: Callable[[Connection], None], answered: Callable[[Ask, Any], Any], questions: Iterable[Any]
) -> list[Any]:
    """Answer questions on all processors, in their order; a thread waits until one of the processes is free."""
    waiting = list(questions)
    number = min(os.cpu_count() or 1, len(waiting))
    if not number:
        return []
    with ExitStack() as stack, ThreadPoolExecutor(number) as threads:
        free: SimpleQueue[LimitedProcess] = SimpleQueue()
        for _ in range(number):
            free.put(stack.enter_context(closing(LimitedProcess(serve))))

        def ask(question: object, limits: Sequence[float]) -> tuple[list[Any], str]:
            process = free.get()
            try:
                return process.ask(question, limits)
            finally:
                free.put(process)

        return list(threads.map(lambda question: answered(ask, question), waiting))


def limit_this_process(seconds: float) -> None:
    """End the calling process after so many more seconds of the processor, whatever library is at work; 0: never."""
    signal.setitimer(signal.ITIMER_PROF, seconds)
