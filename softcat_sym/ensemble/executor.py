"""One executor of many runs: threads of this process, or a Dask cluster; results as they are finished."""

from __future__ import annotations

import ctypes
import importlib.metadata
import logging
import os
import re
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent import futures
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from itertools import islice
from typing import Any, Protocol, TypeVar

from softcat_sym.ensemble.lane_pool import WORTHWHILE, LanePool
from softcat_sym.errors import SoftcatError
from softcat_sym.solvers.compiled import Answer, CModel, RunInput
from softcat_sym.solvers.lanes import can_be_compiled
from softcat_sym.solvers.solution import Silence

Item = TypeVar("Item")
Result = TypeVar("Result")
# Dask's own annotations are incomplete.
Client = Any
Future = Any

_AHEAD = 2
"""Tasks submitted for each thread: enough that none waits, and few enough for the memory."""

_ANSWER, _ALONE, _LOOK = 10.0, 60.0, 1.0
"""Seconds in which a scheduler must answer, that a cluster may be without workers, and between two looks at them."""

_IGNORE_CTRL_C = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"
"""What workers of our own begin with: Ctrl-C in a terminal reaches them too, but it is for us to end them."""

_ADDRESS = re.compile(r"(?:tcp|tls|ws|wss)://\S+:\d{1,5}/?")
_DIED = "the workers that ran this member and those beside it died (killed, or out of memory); run it again"


class MembersProgress(Protocol):
    """Listens to running members."""

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of the members done, of how many there are, and of the time left [s]."""
        ...


class Stop(Silence):
    """Ends integrations from outside: as their listener, it raises once it is set."""

    def __init__(self) -> None:
        self.flag = ctypes.c_int(0)

    def integrate(self, model: CModel, run: RunInput, room: Answer) -> None:
        """Integrate a run by itself; the compiled solver looks at the flag."""
        model.integrate(run, room.status, self.flag, room)

    def set(self) -> None:
        """Let no integration continue."""
        self.flag.value = 1

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Look whether to stop."""
        if self.flag.value:
            raise KeyboardInterrupt


class Meeting(Stop):
    """Ends integrations, too, and lets those that wait at the same time share lanes."""

    def __init__(self, workers: int) -> None:
        super().__init__()
        self.pool = LanePool(workers, self.flag)

    def integrate(self, model: CModel, run: RunInput, room: Answer) -> None:
        """Integrate a run beside others."""
        self.pool.integrate(model, run, room)


@dataclass(frozen=True)
class Lost:
    """In place of the result of a member whose workers died."""

    message: str = _DIED


class Threads:
    """Threads of this process."""

    def __init__(self, size: int, stop: Stop) -> None:
        self.size, self.stop = size, stop
        self._lanes = stop.pool if isinstance(stop, Meeting) else None
        # Every member that others may wait for has a thread.
        self._most = self._lanes.threads if self._lanes else _AHEAD * size
        threads = self._most if self._lanes else size
        self._pool = futures.ThreadPoolExecutor(threads, thread_name_prefix="softcat-member")

    def __str__(self) -> str:
        return f"embedded, {self.size} thread{'s' if self.size > 1 else ''}"

    def map_members(
        self, function: Callable[[Item], Result], members: Iterable[Item], chunk: int = 1
    ) -> Iterator[tuple[int, Result | Lost]]:
        """The place of each member and its result, as they are finished; chunks are for clusters."""
        waiting = enumerate(members)
        running: dict[futures.Future[Result], int] = {}
        while True:
            more = list(islice(waiting, self._most - len(running)))
            if self._lanes:
                self._lanes.expect(len(more))
            for number, member in more:
                running[self._pool.submit(self._run, function, member)] = number
            if not running:
                return
            for future in futures.wait(running, return_when=futures.FIRST_COMPLETED).done:
                yield running.pop(future), future.result()

    def _run(self, function: Callable[[Item], Result], member: Item) -> Result:
        with self._lanes.member() if self._lanes else nullcontext():
            return function(member)

    def close(self) -> None:
        """End what runs, and wait for it."""
        self.stop.set()
        self._pool.shutdown(cancel_futures=True)


class Cluster:
    """A Dask cluster; where its workers die, the members of a chunk are lost."""

    def __init__(self, client: Client, name: str) -> None:
        self.stop = Stop()
        self._client, self._name = client, name
        self._running: dict[Future, list[tuple[int, Any]]] = {}

    def __str__(self) -> str:
        return self._name

    @property
    def size(self) -> int:
        """Threads of all workers."""
        return sum(self._client.nthreads().values())

    def map_members(
        self, function: Callable[[Item], Result], members: Iterable[Item], chunk: int = 1
    ) -> Iterator[tuple[int, Result | Lost]]:
        """The place of each member and its result, as they are finished; `chunk` of them go to a worker at a time."""
        waiting, running = enumerate(members), self._running
        while True:
            while len(running) < _AHEAD * max(1, self.size) and (batch := list(islice(waiting, chunk))):
                items = [item for _, item in batch]
                running[self._client.submit(_each, function, items, pure=False, retries=0)] = batch
            if not running:
                return
            future = self._finished()
            batch = running.pop(future)
            results = _results(future) or [Lost()] * len(batch)
            yield from ((number, result) for (number, _), result in zip(batch, results, strict=True))

    def close(self) -> None:
        """Cancel what runs."""
        if self._running:
            self._client.cancel(list(self._running), force=True)

    def _finished(self) -> Future:
        from distributed import wait

        lonely = 0.0
        while True:
            try:
                with self._client.as_current():
                    return wait(list(self._running), timeout=_LOOK, return_when="FIRST_COMPLETED").done.pop()
            except TimeoutError:
                lonely = 0.0 if self._client.nthreads() else lonely + _LOOK
            if self._client.status != "running":
                raise SoftcatError(f"{self}: the scheduler is gone; start it again, then give the same command again")
            if lonely > _ALONE:
                raise SoftcatError(f"{self}: no worker is left; start some, then give the same command again")


def _each(function: Callable[[Item], Result], items: Sequence[Item]) -> list[Result]:
    return [function(item) for item in items]


def _results(future: Future) -> list[Any] | None:
    """The results of a chunk; None if its workers died."""
    from distributed import KilledWorker

    error = future.exception()
    if isinstance(error, KilledWorker):
        return None
    if isinstance(error, BaseException):
        raise SoftcatError(f"a worker of the cluster failed: {type(error).__name__}: {error}") from error
    results: list[Any] = future.result()
    return results


Executor = Threads | Cluster


@contextmanager
def executor(
    workers: int | None = None, scheduler: str | None = None, local_cluster: int | None = None, members: int = 0
) -> Iterator[Executor]:
    """The executor that is asked for; when the context ends, nothing of it runs any more.

    Threads integrate in lanes where so many members at least are to come that these are worth compiling.
    """
    check_executor(workers, scheduler, local_cluster)
    if scheduler is None and local_cluster is None:
        size = worker_count(workers)
        in_lanes = members >= WORTHWHILE and can_be_compiled()
        threads = Threads(size, Meeting(size) if in_lanes else Stop())
        try:
            yield threads
        finally:
            threads.close()
        return
    with _cluster_at(scheduler) if scheduler is not None else _local_cluster(local_cluster or 1) as cluster:
        try:
            yield cluster
        finally:
            cluster.close()


def check_executor(workers: int | None, scheduler: str | None, local_cluster: int | None) -> None:
    """Refuse what cannot be had, before anything is computed."""
    if scheduler is not None and local_cluster is not None:
        raise SoftcatError("name a scheduler or a local cluster, not both")
    if workers is not None and (scheduler is not None or local_cluster is not None):
        raise SoftcatError("a number of threads is for runs in this process; workers of a cluster have their own")
    worker_count(workers)
    if scheduler is not None and not _ADDRESS.fullmatch(scheduler):
        found = f"{scheduler!r} is no address of a Dask scheduler"
        raise SoftcatError(f"{found}; accepted: tcp://host:port, tls://host:port")
    if local_cluster is not None and not _is_count(local_cluster):
        raise SoftcatError(f"a local cluster of {local_cluster!r}: give a whole number of worker processes, 1 or more")


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
def _cluster_at(address: str) -> Iterator[Cluster]:
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
        yield Cluster(client, f"Dask cluster, {len(client.nthreads())} workers at {address}")


@contextmanager
def _local_cluster(processes: int) -> Iterator[Cluster]:
    """A cluster of worker processes on this machine, each with one thread, which ends with the context."""
    distributed = _distributed()
    options = {"n_workers": processes, "threads_per_worker": 1, "processes": True, "preload": [_IGNORE_CTRL_C]}
    options |= {"host": "127.0.0.1", "dashboard_address": None, "silence_logs": logging.CRITICAL}
    with (
        _quiet(),
        distributed.LocalCluster(**options) as local,
        distributed.Client(local, set_as_default=False) as client,
    ):
        yield Cluster(client, f"local Dask cluster, {processes} worker process{'es' if processes > 1 else ''}")


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
    ours = _version()
    try:
        versions = client.run(_version)
    except ImportError as error:
        raise SoftcatError(f"the workers at {address} cannot import this package: {error}") from None
    other = sorted({str(version) for version in versions.values()} - {ours})
    if other:
        raise SoftcatError(f"workers at {address} have softcat_sym {', '.join(other)}, and here it is {ours}")


def _version() -> str:
    return importlib.metadata.version("softcat_sym")


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
