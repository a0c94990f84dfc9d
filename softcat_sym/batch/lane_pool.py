"""Threads of an ensemble whose integrations meet: runs of one structure that wait at the same time share lanes."""

from __future__ import annotations

import ctypes
import threading
import warnings
from collections import Counter
from collections.abc import Callable, Sequence
from concurrent import futures
from dataclasses import dataclass, field
from typing import ParamSpec, TypeVar

from softcat_sym.errors import SoftcatError
from softcat_sym.solvers.compiled import Answer, CModel, RunInput
from softcat_sym.solvers.lanes import LanesModel, lanes_of
from softcat_sym.solvers.solution import Silence

Arguments = ParamSpec("Arguments")
Result = TypeVar("Result")

WORTHWHILE = 64
"""Members from which on lanes are compiled: a second or two of the processor, for some milliseconds of each member."""

AT_ONCE = 16
"""Runs of one structure that are worth a call: four for each of four lanes, so that few lanes idle at its end."""


@dataclass(frozen=True, eq=False)
class _Waiting:
    """A run that waits for a lane."""

    model: CModel
    run: RunInput
    room: Answer
    done: threading.Event = field(default_factory=threading.Event)
    errors: list[Exception] = field(default_factory=list)

    @property
    def kind(self) -> tuple[int, int, int]:
        """Equal for runs that may share lanes."""
        return id(self.model), len(self.run.state), self.run.method


class Stop(Silence):
    """Ends integrations from outside: as their listener, it raises once it is set. In a pool they share lanes."""

    def __init__(self, pool: LanePool | None = None) -> None:
        self.flag = ctypes.c_int(0)
        self._pool = pool

    def integrate(self, model: CModel, run: RunInput, room: Answer) -> None:
        """Integrate a run, by itself or beside others; the compiled solver looks at the flag."""
        if self._pool is not None:
            self._pool.integrate(model, run, room)
        else:
            model.integrate(run, room.status, self.flag, room)

    def set(self) -> None:
        """Let no integration continue."""
        self.flag.value = 1

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Look whether to stop."""
        if self.flag.value:
            raise KeyboardInterrupt


class LanePool(futures.Executor):
    """Lets so many threads work at a time, and integrates together the runs for which the others wait.

    A thread that asks for an integration waits for it. Once enough wait, or none is left that could still ask, one of
    them integrates for all, while others prepare what comes next. What becomes of a run does not depend on those beside
    it, but for its last digits if so few runs have its structure that they are integrated one by one.
    """

    def __init__(self, workers: int) -> None:
        # A batch for each worker, one that gathers, and one that is being prepared.
        self.threads = (workers + 2) * AT_ONCE
        self._pool = futures.ThreadPoolExecutor(self.threads, thread_name_prefix="softcat-member")
        self.stop = Stop(self)
        self._turns = threading.Semaphore(workers)
        self._lock, self._compiling = threading.Lock(), threading.Lock()
        self._busy = 0  # Members that may still ask
        self._queue: list[_Waiting] = []
        self._lanes: dict[int, LanesModel | None] = {}

    def expect(self, members: int) -> None:
        """Wait for so many more members, each of which has a thread, before few runs are integrated."""
        with self._lock:
            self._busy += members

    def submit(
        self, function: Callable[Arguments, Result], /, *given: Arguments.args, **named: Arguments.kwargs
    ) -> futures.Future[Result]:
        """Run a member that was expected; no more than `threads` at a time."""
        future = self._pool.submit(self._in_turn, function, *given, **named)
        future.add_done_callback(lambda done: self._ended() if done.cancelled() else None)
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End all threads."""
        self._pool.shutdown(wait, cancel_futures=cancel_futures)

    def _in_turn(
        self, function: Callable[Arguments, Result], /, *given: Arguments.args, **named: Arguments.kwargs
    ) -> Result:
        with self._turns:
            try:
                return function(*given, **named)
            finally:
                self._ended()

    def _ended(self) -> None:
        with self._lock:
            self._busy -= 1
        while self._serve():
            pass

    def integrate(self, model: CModel, run: RunInput, room: Answer) -> None:
        """Integrate a run into its room, together with others."""
        request = _Waiting(model, run, room)
        with self._lock:
            self._queue.append(request)
            self._busy -= 1
        while not request.done.is_set() and self._serve():
            pass
        self._turns.release()
        request.done.wait()
        self._turns.acquire()
        if request.errors:
            raise request.errors[0]

    def _serve(self) -> bool:
        """Integrate a batch, if there is one that need not wait for more."""
        with self._lock:
            counts = Counter(request.kind for request in self._queue)
            kind, count = counts.most_common(1)[0] if counts else (None, 0)
            if not count or (count < AT_ONCE and self._busy):
                return False
            batch = [request for request in self._queue if request.kind == kind][:AT_ONCE]
            self._queue = [request for request in self._queue if request not in batch]
        try:
            self._integrate(batch)
        except Exception as error:  # noqa: BLE001 - it is raised in every thread that waits for it
            for request in batch:
                request.errors.append(error)
        with self._lock:
            self._busy += len(batch)
        for request in batch:
            request.done.set()
        return True

    def _integrate(self, batch: Sequence[_Waiting]) -> None:
        lanes = self._lanes_for(batch[0].model, len(batch))
        if lanes is not None:
            lanes.integrate([request.run for request in batch], [request.room for request in batch], self.stop.flag)
            return
        for request in batch:
            request.model.integrate(request.run, request.room.status, self.stop.flag, request.room)

    def _lanes_for(self, model: CModel, count: int) -> LanesModel | None:
        """The lanes of a structure, once so many of it wait that they are worth compiling."""
        with self._compiling:
            if id(model) not in self._lanes and count >= AT_ONCE:
                try:
                    self._lanes[id(model)] = lanes_of(model)
                except SoftcatError as error:
                    warnings.warn(f"filaments are integrated one by one, not in lanes: {error}", stacklevel=2)
                    self._lanes[id(model)] = None
            return self._lanes.get(id(model))
