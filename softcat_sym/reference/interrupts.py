"""Ctrl-C that waits until the state is whole: it is noticed between two calls into C, never in the midst of one."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class Interrupt:
    """Whether SIGINT has come."""

    def __init__(self) -> None:
        self.pending = False

    def note(self, number: int, frame: FrameType | None) -> None:
        """Handle the signal: remember it; when it comes again, do not wait any longer.

        Raises
        ------
        KeyboardInterrupt
            The second time.
        """
        del number, frame
        if self.pending:
            raise KeyboardInterrupt
        self.pending = True


@contextmanager
def deferred() -> Iterator[Interrupt]:
    """Put SIGINT off, unless the program handles it in its own way or this is not its main thread."""
    interrupt = Interrupt()
    ours = threading.current_thread() is threading.main_thread()
    if not ours or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield interrupt
        return
    signal.signal(signal.SIGINT, interrupt.note)
    try:
        yield interrupt
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
