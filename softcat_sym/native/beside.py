"""Work in a thread beside other work: a compiler is a process of its own, and need not be waited for at once."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable, Iterator

from softcat_sym.native.process import Processes, kill_on


@contextlib.contextmanager
def beside(work: Callable[[], object]) -> Iterator[None]:
    """Do some work while the block does its own; both are done at its end.

    Parameters
    ----------
    work : callable
        Called in a thread. What it raises is raised at the end of the block; if the block itself raises, every
        process that the work has started is killed, and what it then raises is dropped.
    """
    raised: list[BaseException] = []
    processes = Processes()

    def whole() -> None:
        with kill_on(processes):
            try:
                work()
            except BaseException as error:  # noqa: BLE001 - it is raised where somebody waits for it
                raised.append(error)

    thread = threading.Thread(target=whole, name="softcat beside", daemon=True)
    thread.start()
    try:
        yield
        thread.join()
    except BaseException:
        processes.kill()
        thread.join()
        raise
    if raised:
        raise raised[0]
