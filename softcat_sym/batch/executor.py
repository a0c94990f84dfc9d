"""Many runs in any `concurrent.futures.Executor`, threads of this process or a Dask cluster, as they are finished."""

from __future__ import annotations

import logging
import os
import re
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
from softcat_sym.store import version

Item = TypeVar("Item")
Result = TypeVar("Result")
# Dask's own annotations are incomplete.
Client = Any

_AHEAD = 2
"""Tasks submitted for each worker: enough that none waits, and few enough for the memory."""

_ANSWER, _ALONE, _LOOK = 10.0, 60.0, 1.0
"""Seconds in which a scheduler must answer, that a cluster may be without workers, and between two looks at them."""

_IGNORE_CTRL_C = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"
"""What workers of our own begin with: Ctrl-C in a terminal reaches them too, but it is for us to end them."""

_ADDRESS = re.compile(r"(?:tcp|tls|ws|wss)://\S+:\d{1,5}/?")
_GONE = "the scheduler is gone; start it again, then give the same command again"
_DIED = "the workers that ran this member and those beside it died (killed, or out of memory); run it again"


class MembersProgress(Protocol):
    """Listens to running members."""

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of the members done, of how many there are, and of the time left [s]."""
        ...


@dataclass(frozen=True)
class Lost:
    """In place of the result of a member whose workers died."""

    message: str = _DIED


class RunPool:
    """An executor, and how many runs it has at a time; `stop` ends those in threads of this process."""

    lost: tuple[type[BaseException], ...] = (futures.BrokenExecutor,)
    """Errors of a task whose worker died."""
    is_chunked = True
    """Whether tasks cost so much to send that several members go in one."""

    def __init__(self, executor: futures.Executor, name: str, size: int = 1) -> None:
        self.executor, self.name, self.stop = executor, name, Stop()
        self._size = size
        self._running: dict[futures.Future[list[Any]], list[int]] = {}

    def __str__(self) -> str:
        return self.name

    @property
    def size(self) -> int:
        """Number of workers."""
        return self._size

    @property
    def ahead(self) -> int:
        """Number of tasks that are submitted at a time."""
        return _AHEAD * max(1, self.size)

    def expect(self, tasks: int) -> None:
        """Hear how many tasks come next."""

    def check(self) -> None:
        """Raise an error if nothing is left that could finish a task."""

    def map_members(
        self, function: Callable[[Item], Result], members: Iterable[Item], chunk: int = 1
    ) -> Iterator[tuple[int, Result | Lost]]:
        """The place of each member and its result, as they are finished; `chunk` of them go to a worker at a time."""
        waiting, running = enumerate(members), self._running
        chunk = chunk if self.is_chunked else 1
        while True:
            batches = [batch for _ in range(self.ahead - len(running)) if (batch := list(islice(waiting, chunk)))]
            self.expect(len(batches))
            for batch in batches:
                try:
                    future = self.executor.submit(_each, function, [item for _, item in batch])
                except futures.BrokenExecutor as error:
                    raise SoftcatError(f"{self}: {error}; give the same command again") from error
                running[future] = [number for number, _ in batch]
            if not running:
                return
            done = futures.wait(running, _LOOK, futures.FIRST_COMPLETED).done
            if not done:
                self.check()
            for future in done:
                numbers, results = running.pop(future), self._results(future)
                yield from ((number, results[k] if results else Lost()) for k, number in enumerate(numbers))

    def close(self) -> None:
        """Cancel what waits, and end what runs in this process."""
        self.stop.set()
        for future in self._running:
            future.cancel()

    def _results(self, future: futures.Future[list[Result]]) -> list[Result] | None:
        """Results of a task; None if its worker died."""
        try:
            return future.result()
        except self.lost:
            return None
        except futures.CancelledError:
            raise SoftcatError(f"{self}: {_GONE}") from None


def _each(function: Callable[[Item], Result], items: Sequence[Item]) -> list[Result]:
    return [function(item) for item in items]


class ThreadsPool(RunPool):
    """Threads of this process; in lanes, if so many members are to come that these are worth compiling."""

    is_chunked = False

    def __init__(self, size: int, members: int = 0) -> None:
        lanes = LanePool(size) if members >= WORTHWHILE and can_be_compiled() else None
        threads = lanes or futures.ThreadPoolExecutor(size, thread_name_prefix="softcat-member")
        super().__init__(threads, f"embedded, {size} thread{'s' if size > 1 else ''}", size)
        self._lanes = lanes
        if lanes:
            self.stop = lanes.stop

    @property
    def ahead(self) -> int:
        """In lanes every member that others may wait for has a thread."""
        return self._lanes.threads if self._lanes else super().ahead

    def expect(self, tasks: int) -> None:
        """Wait for so many more members before few runs are integrated."""
        if self._lanes:
            self._lanes.expect(tasks)


class ClusterPool(RunPool):
    """A Dask cluster."""

    def __init__(self, client: Client, name: str) -> None:
        from distributed import KilledWorker

        super().__init__(client.get_executor(pure=False, retries=0), name)
        self.lost = (*self.lost, KilledWorker)
        self._client, self._lonely = client, 0.0

    @property
    def size(self) -> int:
        """Threads of all workers."""
        return sum(self._client.nthreads().values())

    def check(self) -> None:
        """Look whether the scheduler and some worker are there."""
        if self._client.status != "running":
            raise SoftcatError(f"{self}: {_GONE}")
        self._lonely = 0.0 if self._client.nthreads() else self._lonely + _LOOK
        if self._lonely > _ALONE:
            raise SoftcatError(f"{self}: no worker is left; start some, then give the same command again")


@dataclass(frozen=True)
class Where:
    """Where members run: by default in as many threads as there are cores."""

    workers: int | None = None  # Number of threads
    scheduler: str | None = None  # Address of a Dask cluster
    local_cluster: int | None = None  # Number of processes of a Dask cluster on this machine
    executor: futures.Executor | None = None  # Any other, which outlives the runs

    def __post_init__(self) -> None:
        """Refuse what cannot be had, before anything is computed."""
        others = [self.scheduler is not None, self.local_cluster is not None, self.executor is not None]
        if sum(others) > 1:
            raise SoftcatError("name a scheduler or a local cluster, not both, and no other executor beside them")
        if self.workers is not None and any(others):
            raise SoftcatError("a number of threads is for runs in this process; workers of a cluster have their own")
        worker_count(self.workers)
        if self.scheduler is not None and not _ADDRESS.fullmatch(self.scheduler):
            found = f"{self.scheduler!r} is no address of a Dask scheduler"
            raise SoftcatError(f"{found}; accepted: tcp://host:port, tls://host:port")
        if self.local_cluster is not None and not _is_count(self.local_cluster):
            found = f"a local cluster of {self.local_cluster!r}"
            raise SoftcatError(f"{found}: give a whole number of worker processes, 1 or more")

    @contextmanager
    def pool(self, members: int = 0) -> Iterator[RunPool]:
        """The pool for so many members; when the context ends, none of them runs any more."""
        with ExitStack() as stack:
            if self.executor is not None:
                pool = RunPool(self.executor, type(self.executor).__name__, worker_count(None))
            elif self.scheduler is not None:
                pool = stack.enter_context(_cluster_at(self.scheduler))
            elif self.local_cluster is not None:
                pool = stack.enter_context(_local_cluster(self.local_cluster))
            else:
                pool = ThreadsPool(worker_count(self.workers), members)
                stack.enter_context(pool.executor)
            stack.callback(pool.close)
            yield pool


def worker_count(workers: int | None) -> int:
    """As many threads as requested, otherwise one for each core that this process may use."""
    if workers is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not _is_count(workers):
        raise SoftcatError(f"workers = {workers!r}: give a whole number of threads, 1 or more, or None for all cores")
    return workers


def _is_count(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 1


@contextmanager
def _cluster_at(address: str) -> Iterator[ClusterPool]:
    """The cluster of a scheduler that runs already."""
    distributed = _distributed()
    try:
        # The class warns of what differs between here and there; what matters is looked at below.
        with _quiet():
            client = distributed.Client(address, timeout=_ANSWER, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        raise SoftcatError(
            f"no Dask scheduler answers at {address!r} within {_ANSWER:g} s ({error}); "
            "start one with `dask scheduler`, and give its address, such as tcp://127.0.0.1:8786"
        ) from None
    with client, _quiet():
        _check_workers(client, address)
        yield ClusterPool(client, f"Dask cluster, {len(client.nthreads())} workers at {address}")


@contextmanager
def _local_cluster(processes: int) -> Iterator[ClusterPool]:
    """A cluster of worker processes on this machine, each with one thread, which ends with the context."""
    distributed = _distributed()
    options = {"n_workers": processes, "threads_per_worker": 1, "processes": True, "preload": [_IGNORE_CTRL_C]}
    options |= {"host": "127.0.0.1", "dashboard_address": None, "silence_logs": logging.CRITICAL}
    with (
        _quiet(),
        distributed.LocalCluster(**options) as local,
        distributed.Client(local, set_as_default=False) as client,
    ):
        yield ClusterPool(client, f"local Dask cluster, {processes} worker process{'es' if processes > 1 else ''}")


def _distributed() -> Any:
    try:
        import distributed
    except ImportError:
        raise SoftcatError(
            "a cluster needs Dask, which is not installed: pip install 'softcat_sym[sweep]'; "
            "without --scheduler and --local-cluster the same runs in threads of this process"
        ) from None
    return distributed


def _check_workers(client: Client, address: str) -> None:
    """Refuse a cluster without workers, or with others than ours."""
    if not client.nthreads():
        raise SoftcatError(f"the Dask scheduler at {address} has no workers; start some with `dask worker {address}`")
    ours = version("softcat_sym")
    try:
        versions = client.run(version, "softcat_sym")
    except ImportError as error:
        raise SoftcatError(f"the workers at {address} cannot import this package: {error}") from None
    other = sorted(set(versions.values()) - {ours})
    if other:
        raise SoftcatError(f"workers at {address} have softcat_sym {', '.join(other)}, and here it is {ours}")


@contextmanager
def _quiet() -> Iterator[None]:
    """Let Dask say nothing of workers that come and go: that is what it is there for."""
    logger = logging.getLogger("distributed")
    before = logger.level
    logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        logger.setLevel(before)


def counted(results: Iterable[Result], members: int, done: int, progress: MembersProgress | None) -> Iterator[Result]:
    """The results, each reported with the time that the rest will take; `done` members were there before."""
    begun, before = time.monotonic(), done
    for result in results:
        done += 1
        if progress is not None:
            left = (time.monotonic() - begun) / (done - before) * (members - done)
            progress.update(done, members, left)
        yield result
