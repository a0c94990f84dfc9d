"""Many runs in any `concurrent.futures.Executor`, by default threads of this process, as they are finished."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent import futures
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from itertools import islice
from typing import Any, Protocol, TypeVar

from softcat_sym.batch.lane_pool import WORTHWHILE, LanePool, Stop
from softcat_sym.errors import SoftcatError
from softcat_sym.solvers.lanes import can_be_compiled

Item = TypeVar("Item")
Result = TypeVar("Result")

_AHEAD = 2
"""Tasks submitted for each worker: enough that none waits, and few enough for the memory."""


class MembersProgress(Protocol):
    """Listens to running members."""

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of the members done, of how many there are, and of the time left [s]."""
        ...


@dataclass(frozen=True)
class Lost:
    """In place of the result of a member whose workers died."""

    message: str = "the workers that ran this member and those beside it died (killed, or out of memory); run it again"


class RunPool:
    """An executor, and how many runs it has at a time; `stop` ends those in threads of this process."""

    def __init__(self, executor: futures.Executor, name: str, size: int) -> None:
        self.executor, self.name, self.size = executor, name, size
        self._lanes = executor if isinstance(executor, LanePool) else None
        self.stop = self._lanes.stop if self._lanes else Stop()
        self._threads = isinstance(executor, (LanePool, futures.ThreadPoolExecutor))
        self._running: dict[futures.Future[list[Any]], list[int]] = {}

    def __str__(self) -> str:
        return self.name

    def map_members(
        self, function: Callable[[Item], Result], members: Iterable[Item], chunk: int = 1
    ) -> Iterator[tuple[int, Result | Lost]]:
        """The place of each member and its result, as they are finished.

        So many of a `chunk` go in one task, where a task costs much to send: not to threads of this process.
        """
        waiting, running = enumerate(members), self._running
        # In lanes every member that others may wait for has a thread; what other processes wait for is theirs to say.
        ahead = self._lanes.threads if self._lanes else _AHEAD * self.size if self._threads else math.inf
        while True:
            batches = list[list[tuple[int, Item]]]()
            while len(running) + len(batches) < ahead and (
                batch := list(islice(waiting, 1 if self._threads else chunk))
            ):
                batches.append(batch)
            if self._lanes:
                self._lanes.expect(len(batches))
            for batch in batches:
                try:
                    future = self.executor.submit(_each, function, [item for _, item in batch])
                except futures.BrokenExecutor as error:
                    raise SoftcatError(f"{self}: {error}; give the same command again") from error
                running[future] = [number for number, _ in batch]
            if not running:
                return
            for future in futures.wait(running, return_when=futures.FIRST_COMPLETED).done:
                numbers, results = running.pop(future), self._results(future)
                yield from ((number, results[k] if results else Lost()) for k, number in enumerate(numbers))

    def close(self) -> None:
        """Cancel what waits, and end what runs in this process."""
        self.stop.set()
        for future in self._running:
            future.cancel()

    def _results(self, future: futures.Future[list[Any]]) -> list[Any] | None:
        """Results of a task; None if its worker died: what fails in the work itself comes back as a result."""
        try:
            results = future.result()
        except futures.CancelledError:
            raise SoftcatError(f"{self} is gone; start it again, then give the same command again") from None
        except Exception:  # noqa: BLE001 - each executor has its own error for a worker that died
            return None
        failed = next((one.error for one in results if isinstance(one, _Failure)), None)
        if failed is not None:
            raise failed
        return results


@dataclass(frozen=True)
class _Failure:
    """An error of the work, as its result."""

    error: Exception


def _each(function: Callable[[Item], Result], items: Sequence[Item]) -> list[Result | _Failure]:
    results = list[Result | _Failure]()
    for item in items:
        try:
            results.append(function(item))
        except Exception as error:  # noqa: BLE001 - it is raised where the results are wanted
            results.append(_Failure(error))
    return results


@contextmanager
def run_pool(
    workers: int | None = None, executor: futures.Executor | None = None, members: int = 0
) -> Iterator[RunPool]:
    """A pool for so many members: an executor, which outlives it, or so many threads, by default one for each core.

    When the context ends, none of the members runs any more. Many members share the lanes of vectors.
    """
    check_workers(workers, executor)
    size = worker_count(workers)
    with ExitStack() as stack:
        if executor is not None:
            pool = RunPool(executor, type(executor).__name__, size)
        else:
            in_lanes = members >= WORTHWHILE and can_be_compiled()
            threads = LanePool(size) if in_lanes else futures.ThreadPoolExecutor(size, "softcat-member")
            pool = RunPool(stack.enter_context(threads), f"embedded, {size} thread{'s' if size > 1 else ''}", size)
        stack.callback(pool.close)
        yield pool


def check_workers(workers: int | None, executor: futures.Executor | None) -> None:
    """Refuse what cannot be had, before anything is computed."""
    if workers is not None and executor is not None:
        raise SoftcatError("a number of threads is for runs in this process; an executor has workers of its own")
    worker_count(workers)


def worker_count(workers: int | None) -> int:
    """As many threads as requested, otherwise one for each core that this process may use."""
    if workers is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not isinstance(workers, int) or isinstance(workers, bool) or workers < 1:
        raise SoftcatError(f"workers = {workers!r}: give a whole number of threads, 1 or more, or None for all cores")
    return workers


def counted(results: Iterable[Result], members: int, done: int, progress: MembersProgress | None) -> Iterator[Result]:
    """The results, each reported with the time that the rest will take; `done` members were there before."""
    begun, before = time.monotonic(), done
    for result in results:
        done += 1
        if progress is not None:
            left = (time.monotonic() - begun) / (done - before) * (members - done)
            progress.update(done, members, left)
        yield result
