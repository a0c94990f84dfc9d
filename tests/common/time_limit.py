"""What takes more seconds of the processor than it may is ended."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Raise TimeoutError in what takes longer: limits are runs of their own, as C returns to Python now and then."""

    def over(*_: object) -> None:
        raise TimeoutError(f"more than {seconds:g} s of the processor")

    before = signal.signal(signal.SIGPROF, over)
    # Again and again: what is raised in a callback of C is lost.
    signal.setitimer(signal.ITIMER_PROF, seconds, max(0.02, 0.1 * seconds))
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
