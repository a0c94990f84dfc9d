"""Many runs worked off in blocks, in threads or on a Dask cluster."""

from __future__ import annotations

import importlib.metadata
import logging
import re
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar

from softcat_sym.ensemble.ensemble import MembersProgress, workers_of
from softcat_sym.errors import SoftcatError

Item = TypeVar("Item")
Done = TypeVar("Done")
ItemIn = TypeVar("ItemIn", contravariant=True)
DoneOut = TypeVar("DoneOut", covariant=True)

Told = Callable[[int], None]
"""Told of that many items that are done."""


@dataclass(frozen=True)
class Block(Generic[Item]):
    """Items that are run, kept and lost together."""

    number: int  # Its place among the blocks, from 0
    items: tuple[Item, ...]  # What is run


class Work(Protocol[ItemIn, DoneOut]):
    """What is done with items; it can be sent to another process."""

    def run(self, items: Sequence[ItemIn], threads: int, told: Told) -> Sequence[DoneOut]:
        """Run items, `threads` at a time; a result for each, in their order."""
        ...

    def lost(self, item: ItemIn, why: str) -> DoneOut:
        """The result of an item that has killed whoever ran it."""
        ...


class Workplace(Protocol):
    """Where blocks are run."""

    def run(
        self, work: Work[Item, Done], blocks: Iterable[Block[Item]], told: Told
    ) -> Iterator[tuple[int, Sequence[Done]]]:
        """The number and the results of each block, as they are finished."""
        ...

    def named(self) -> str:
        """What it is, for the record."""
        ...

    def size(self) -> int:
        """How many members it runs at a time."""
        ...


def blocks_of(items: Sequence[Item], size: int) -> list[Block[Item]]:
    """Cut items into blocks of a size; the last may be smaller."""
    starts = range(0, len(items), size)
    return [Block(number, tuple(items[start : start + size])) for number, start in enumerate(starts)]


@dataclass(frozen=True)
class Embedded:
    """Threads of this process."""

    threads: int  # Members at a time

    def run(
        self, work: Work[Item, Done], blocks: Iterable[Block[Item]], told: Told
    ) -> Iterator[tuple[int, Sequence[Done]]]:
        """The number and the results of each block, in order."""
        for block in blocks:
            yield block.number, work.run(block.items, self.threads, told)

    def named(self) -> str:
        """How many threads there are."""
        return f"embedded, {self.threads} thread{'s' if self.threads > 1 else ''}"

    def size(self) -> int:
        """The threads."""
        return self.threads


# Dask's own annotations are incomplete.
Client = Any
Future = Any

_ANSWER = 10.0
"""Seconds in which a scheduler must answer."""

_ALONE = 60.0
"""Seconds that a cluster may be without any worker before the study ends."""

_LOOK = 1.0
"""Seconds between two looks at the workers."""

_AHEAD = 2
"""Blocks sent for each thread of the cluster: enough that none waits, and few enough for the memory."""

_DEAF = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"
"""What workers of our own begin with: Ctrl-C in a terminal reaches them too, but it is for us to end them."""

_ADDRESS = re.compile(r"(?:tcp|tls|ws|wss)://\S+:\d{1,5}/?")

_DIES = "the workers that ran this member and those beside it died (killed, or out of memory); run it again"


class Cluster:
    """A Dask cluster."""

    def __init__(self, client: Client, what: str) -> None:
        self._client, self._what = client, what

    def named(self) -> str:
        """What it is."""
        return self._what

    def size(self) -> int:
        """Threads of all workers."""
        return sum(self._client.nthreads().values())

    def run(
        self, work: Work[Item, Done], blocks: Iterable[Block[Item]], told: Told
    ) -> Iterator[tuple[int, Sequence[Done]]]:
        """The number and the results of each block, as workers finish them; where these die, its members are lost."""
        waiting, sent = iter(blocks), dict[Any, Block[Item]]()
        try:
            self._send(work, waiting, sent)
            while sent:
                future = self._next(list(sent))
                block = sent.pop(future)
                results = _results(future)
                self._send(work, waiting, sent)
                told(len(block.items))
                yield block.number, [work.lost(item, _DIES) for item in block.items] if results is None else results
        finally:
            if sent:
                self._client.cancel(list(sent), force=True)

    def _send(self, work: Work[Item, Done], waiting: Iterator[Block[Item]], sent: dict[Any, Block[Item]]) -> None:
        """Send blocks until there are enough for every thread of the cluster."""
        enough = _AHEAD * max(1, self.size())
        while len(sent) < enough:
            block = next(waiting, None)
            if block is None:
                return
            sent[self._client.submit(_run, work, block.items, pure=False, retries=0)] = block

    def _next(self, futures: Sequence[Future]) -> Future:
        """The next that is finished."""
        from distributed import wait

        lonely = 0.0
        while True:
            try:
                with self._client.as_current():
                    return next(iter(wait(futures, timeout=_LOOK, return_when="FIRST_COMPLETED").done))
            except TimeoutError:
                lonely = 0.0 if self._client.nthreads() else lonely + _LOOK
            if self._client.status != "running":
                raise SoftcatError(
                    f"{self._what}: the scheduler is gone; start it again, then give the same command again"
                )
            if lonely > _ALONE:
                raise SoftcatError(f"{self._what}: no worker is left; start some, then give the same command again")


def _run(work: Work[Item, Done], items: Sequence[Item]) -> Sequence[Done]:
    """What a worker does: one member after the other, as each of its threads has a block of its own."""
    return work.run(items, 1, lambda _: None)


def _results(future: Future) -> Any:
    """The results of a block; None if its workers died."""
    from distributed import KilledWorker

    error = future.exception()
    if isinstance(error, KilledWorker):
        return None
    if isinstance(error, BaseException):
        raise SoftcatError(f"a worker of the cluster failed: {type(error).__name__}: {error}") from error
    return future.result()


@contextmanager
def cluster_at(address: str) -> Iterator[Cluster]:
    """The cluster of a scheduler that runs already."""
    distributed = _distributed()
    if not _ADDRESS.fullmatch(address):
        raise SoftcatError(f"{address!r} is no address of a Dask scheduler; accepted: tcp://host:port, tls://host:port")
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
def own_cluster(processes: int) -> Iterator[Cluster]:
    """A cluster of worker processes on this machine, each with one thread, which ends with the context."""
    distributed = _distributed()
    with (
        _quiet(),
        distributed.LocalCluster(
            n_workers=processes,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            host="127.0.0.1",
            silence_logs=logging.CRITICAL,
            preload=[_DEAF],
        ) as local,
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


def check_workplace(workers: int | None, scheduler: str | None, local_cluster: int | None) -> None:
    """Refuse what cannot be had, before anything is computed."""
    if scheduler is not None and local_cluster is not None:
        raise SoftcatError("name a scheduler or a local cluster, not both")
    if workers is not None and (scheduler is not None or local_cluster is not None):
        raise SoftcatError("a number of threads is for runs in this process; workers of a cluster have their own")
    workers_of(workers)
    if local_cluster is not None and (
        isinstance(local_cluster, bool) or not isinstance(local_cluster, int) or local_cluster < 1
    ):
        raise SoftcatError(f"a local cluster of {local_cluster!r}: give a whole number of worker processes, 1 or more")


@contextmanager
def workplace(
    workers: int | None = None, scheduler: str | None = None, local_cluster: int | None = None
) -> Iterator[Workplace]:
    """The place that is asked for, ready to work; a cluster that was started for it ends with it."""
    check_workplace(workers, scheduler, local_cluster)
    if scheduler is None and local_cluster is None:
        yield Embedded(workers_of(workers))
        return

    with cluster_at(scheduler) if scheduler is not None else own_cluster(local_cluster or 1) as cluster:
        yield cluster


Keep = Callable[[int, Sequence[Done]], object]


class Count:
    """Items done, told on with the time that the others will take."""

    def __init__(self, members: int, done: int, listener: MembersProgress) -> None:
        self._members, self._before, self._done, self._listener = members, done, done, listener
        self._begun = time.monotonic()

    def __call__(self, more: int) -> None:
        """Note that so many more are done."""
        self._done += more
        now = self._done - self._before
        left = (time.monotonic() - self._begun) / now * (self._members - self._done) if now else 0.0
        self._listener.update(self._done, self._members, max(left, 0.0))


def run_blocks(
    work: Work[Item, Done], blocks: Iterable[Block[Item]], place: Workplace, told: Count, keep: Keep[Done]
) -> None:
    """Run blocks, and hand each to `keep` as soon as it is finished."""
    for number, results in place.run(work, blocks, told):
        keep(number, results)
